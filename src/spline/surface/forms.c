/* Surfaces from and to other ways of writing them: Bezier, Hermite, powers. */
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"

#include <string.h>

/* One direction of a net of pieces. */
typedef struct {
    int degree, pieces;
    const double *breaks; /* [pieces + 1] */
} piecewise;

static batten_status check_pieces(const piecewise *way, const char *name)
{
    if (way->degree < 1 || way->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree in %s is %d; it must be in 1..%d", name,
                        way->degree, BATTEN_MAX_DEGREE);
    if ((double)way->pieces * way->degree + 1 > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d pieces in %s of degree %d are too many",
                        way->pieces, name, way->degree);
    return bat_breaks_check(way->pieces, way->breaks);
}

static batten_status check_net(int dimension, const piecewise *u, const piecewise *v)
{
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    batten_status status = check_pieces(u, "u");
    if (status == BATTEN_OK)
        status = check_pieces(v, "v");
    const double total =
        ((double)u->pieces * u->degree + 1) * ((double)v->pieces * v->degree + 1);
    if (status == BATTEN_OK && total > BAT_MAX_POINTS)
        status =
            bat_fail(BATTEN_TOO_LARGE, "%.0f control points would be needed; the limit is %d",
                     total, BAT_MAX_POINTS);
    return status;
}

/* Each break `times` times; the number of points that go with such knots is the length of the
 * net. */
static batten_status create_piecewise(int dimension, const piecewise *u, const piecewise *v,
                                      int times_u, int times_v, const double *points,
                                      const double *weights, batten_surface **out)
{
    double *knots_u = bat_knots_of_breaks(u->degree, times_u, u->pieces, u->breaks);
    double *knots_v = bat_knots_of_breaks(v->degree, times_v, v->pieces, v->breaks);
    batten_status status = knots_u && knots_v ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        const batten_axis axis_u = {u->degree, times_u * (u->pieces - 1) + u->degree + 1,
                                    knots_u, false};
        const batten_axis axis_v = {v->degree, times_v * (v->pieces - 1) + v->degree + 1,
                                    knots_v, false};
        status = batten_surface_create(dimension, &axis_u, &axis_v, points, weights, out);
    }
    bat_release(knots_u);
    bat_release(knots_v);
    return status;
}

batten_status batten_surface_from_bezier(int dimension, batten_pieces pieces_u,
                                         batten_pieces pieces_v, const double *points,
                                         const double *weights, batten_surface **out)
{
    assert(pieces_u.breaks && pieces_v.breaks && points && out);
    const piecewise u = {pieces_u.degree, pieces_u.count, pieces_u.breaks},
                    v = {pieces_v.degree, pieces_v.count, pieces_v.breaks};
    const batten_status status = check_net(dimension, &u, &v);
    return status == BATTEN_OK ? create_piecewise(dimension, &u, &v, pieces_u.degree,
                                                  pieces_v.degree, points, weights, out)
                               : status;
}

/* ---- Hermite ---- */

/* [count_u][derivative in u][count_v][derivative in v][d] from [count_u][count_v][S, Su, Sv,
 * Suv][d] */
static void sort_derivatives(int count_u, int count_v, size_t d, const double *values,
                             double *out)
{
    for (int i = 0; i < count_u; i++)
        for (int r = 0; r < 2; r++)
            for (int j = 0; j < count_v; j++)
                for (int s = 0; s < 2; s++, out += d)
                    memcpy(out,
                           values + ((size_t)(i * count_v + j) * 4 + (size_t)(r + 2 * s)) * d,
                           d * sizeof *out);
}

batten_status batten_surface_from_hermite(batten_uv parameters, batten_grid values,
                                          batten_surface **out)
{
    assert(parameters.u && parameters.v && values.at && out);
    const piecewise way_u = {3, values.count_u - 1, parameters.u},
                    way_v = {3, values.count_v - 1, parameters.v};
    batten_status status = check_net(values.dimension, &way_u, &way_v);
    if (status != BATTEN_OK)
        return status;
    const size_t d = (size_t)values.dimension, row = (size_t)values.count_v * 2 * d;
    double *sorted = bat_array3((size_t)values.count_u * 2, row, sizeof *sorted);
    double *lines = bat_array3((size_t)values.count_u * 2, row, sizeof *lines);
    status = sorted && lines ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        sort_derivatives(values.count_u, values.count_v, d, values.at, sorted);
        bat_hermite_points((int)row, values.count_u, 2, parameters.u, sorted, lines);
        for (size_t i = 0; i < (size_t)values.count_u * 2; i++)
            bat_hermite_points(values.dimension, values.count_v, 2, parameters.v,
                               lines + i * row, sorted + i * row);
        status = create_piecewise(values.dimension, &way_u, &way_v, 2, 2, sorted, NULL, out);
    }
    bat_release(sorted);
    bat_release(lines);
    return status;
}

/* ---- powers ---- */

/* The Bezier points [p + 1][q + 1][d] of one piece; `room` of the same size. */
static void cell_to_bezier(const piecewise *u, const piecewise *v, int i, int j, size_t d,
                           const double *c, double *room, double *b)
{
    const size_t row = ((size_t)v->degree + 1) * d;
    bat_power_to_bezier(u->degree, row, u->breaks[i + 1] - u->breaks[i], c, room);
    for (int k = 0; k <= u->degree; k++)
        bat_power_to_bezier(v->degree, d, v->breaks[j + 1] - v->breaks[j],
                            room + (size_t)k * row, b + (size_t)k * row);
}

/* Put the Bezier points of piece (i, j) into the net; where its neighbours have been they must
 * agree. */
static batten_status place_cell(const piecewise *u, const piecewise *v, int i, int j, int d,
                                const double *b, double tolerance, double *points)
{
    const int p = u->degree, q = v->degree, line = v->pieces * q + 1;
    for (int k = 0; k <= p; k++)
        for (int l = 0; l <= q; l++, b += d) {
            double *point =
                points + ((size_t)(i * p + k) * (size_t)line + (size_t)(j * q + l)) * (size_t)d;
            const bool shared = (k == 0 && i > 0) || (l == 0 && j > 0);
            const double gap = shared ? bat_distance(d, point, b) : 0;
            if (!(gap <= tolerance))
                return bat_fail(BATTEN_NOT_COMPATIBLE,
                                "piece (%d, %d) is %g from its neighbour, more than %g", i + 1,
                                j + 1, gap, tolerance);
            memcpy(point, b, (size_t)d * sizeof *point);
        }
    return BATTEN_OK;
}

static batten_status place_cells(const piecewise *u, const piecewise *v, int d,
                                 const double *coefficients, double tolerance, double *room,
                                 double *points)
{
    const size_t size = ((size_t)u->degree + 1) * ((size_t)v->degree + 1) * (size_t)d;
    for (int i = 0; i < u->pieces; i++)
        for (int j = 0; j < v->pieces; j++) {
            const size_t at = (size_t)i * (size_t)v->pieces + (size_t)j;
            cell_to_bezier(u, v, i, j, (size_t)d, coefficients + at * size, room, room + size);
            const batten_status status =
                place_cell(u, v, i, j, d, room + size, tolerance, points);
            if (status != BATTEN_OK)
                return status;
        }
    return BATTEN_OK;
}

batten_status batten_surface_from_power(int dimension, batten_pieces pieces_u,
                                        batten_pieces pieces_v, const double *coefficients,
                                        double tolerance, batten_surface **out)
{
    assert(pieces_u.breaks && pieces_v.breaks && coefficients && out);
    const piecewise u = {pieces_u.degree, pieces_u.count, pieces_u.breaks},
                    v = {pieces_v.degree, pieces_v.count, pieces_v.breaks};
    batten_status status = bat_tolerance_check(tolerance);
    if (status == BATTEN_OK)
        status = check_net(dimension, &u, &v);
    if (status != BATTEN_OK)
        return status;
    const size_t d = (size_t)dimension, lines = (size_t)(pieces_u.count * pieces_u.degree) + 1;
    const size_t size = ((size_t)pieces_u.degree + 1) * ((size_t)pieces_v.degree + 1) * d;
    double *points =
        bat_array3(lines, ((size_t)(pieces_v.count * pieces_v.degree) + 1) * d, sizeof *points);
    double *room = bat_array(2 * size, sizeof *room);
    status = points && room ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = place_cells(&u, &v, dimension, coefficients, tolerance, room, points);
    if (status == BATTEN_OK)
        status = create_piecewise(dimension, &u, &v, pieces_u.degree, pieces_v.degree, points,
                                  NULL, out);
    bat_release(points);
    bat_release(room);
    return status;
}

/* The coefficients of the piece that begins at (a, b): derivatives by factorials. */
static batten_status expand_cell(const bat_nurbs *nurbs, double a, double b,
                                 double *derivatives, double *coefficients)
{
    const int p = nurbs->axes[0].degree, q = nurbs->axes[1].degree, d = nurbs->base.dimension;
    const batten_status status =
        batten_surface_evaluate(&nurbs->base, a, b, p + q, derivatives);
    if (status != BATTEN_OK)
        return status;
    double by_u = 1;
    for (int k = 0; k <= p; by_u *= ++k) {
        double by = by_u;
        for (int l = 0; l <= q; by *= ++l)
            for (int c = 0; c < d; c++)
                *coefficients++ = derivatives[BATTEN_SURFACE_DERIVATIVE(k, l) * d + c] / by;
    }
    return BATTEN_OK;
}

batten_status batten_surface_to_power(const batten_surface *surface, double *coefficients)
{
    assert(surface && coefficients);
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    const bat_axis *u = &nurbs->axes[0], *v = &nurbs->axes[1];
    const int p = u->degree, q = v->degree;
    if (nurbs->weights)
        return bat_fail(BATTEN_UNSUPPORTED, "a rational surface has no form in powers");
    const size_t d = (size_t)surface->dimension, size = (size_t)((p + 1) * (q + 1)) * d;
    double *derivatives =
        bat_array((size_t)BATTEN_SURFACE_DERIVATIVES(p + q) * d, sizeof(double));
    batten_status status = derivatives ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < u->span_count && status == BATTEN_OK; i++)
        for (int j = 0; j < v->span_count && status == BATTEN_OK; j++, coefficients += size)
            status = expand_cell(nurbs, u->breaks[i], v->breaks[j], derivatives, coefficients);
    bat_release(derivatives);
    return status;
}
