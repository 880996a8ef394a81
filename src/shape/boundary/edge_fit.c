/* The edge of a surface that has no exact edge curve: a curve fitted to it. */
#include "shape/boundary/edge_fit.h"

#include "numeric/vector.h"
#include "spline/spline.h"

#include <float.h>
#include <string.h>

enum { MOST_PIECES = 4096, CHECKS = 7, MOST_POINTS = 6 };

typedef struct {
    const batten_surface *surface;
    bat_edge_place place;
    int dimension, k;
    int values; /* known at each end of a piece: the value and its derivatives along the edge */
    double tolerance, error;
    int count;
    double *breaks; /* [count + 1] */
    double *points; /* [count * (2 values - 1) + 1][dimension] */
} fit;

bat_edge_place bat_edge_of(const batten_surface *surface, batten_edge edge)
{
    const bool low = edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_U0;
    const batten_direction across =
        edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_V1 ? BATTEN_V : BATTEN_U;
    const batten_interval domain = batten_surface_domain(surface, across);
    return (bat_edge_place){across == BATTEN_U ? BATTEN_V : BATTEN_U, low ? domain.a : domain.b,
                            low ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, low ? -1 : 1};
}

/* The derivative across and, row by row, its derivatives along the edge: out [rows][d]. */
static batten_status true_derivatives(const fit *f, double t, batten_side side, int rows,
                                      double *out)
{
    const bool along_u = f->place.along == BATTEN_U;
    double all[BATTEN_SURFACE_DERIVATIVES(4) * 3];
    const batten_status status = batten_surface_evaluate_side(
        f->surface, along_u ? t : f->place.at, along_u ? f->place.at : t,
        (batten_sides){along_u ? side : f->place.side, along_u ? f->place.side : side},
        f->k + rows - 1, all);
    const double sign = f->k == 1 ? f->place.outward : 1;
    for (int r = 0; status == BATTEN_OK && r < rows; r++) {
        const int place =
            along_u ? BATTEN_SURFACE_DERIVATIVE(r, f->k) : BATTEN_SURFACE_DERIVATIVE(f->k, r);
        for (int x = 0; x < f->dimension; x++)
            out[r * f->dimension + x] = sign * all[place * f->dimension + x];
    }
    return status;
}

/* The Bezier points of one piece, and how far it is from the truth. */
static batten_status make_piece(const fit *f, double a, double b, double *points, double *error)
{
    const int d = f->dimension, degree = 2 * f->values - 1;
    double ends[2][3 * 3];
    batten_status status = true_derivatives(f, a, BATTEN_FROM_RIGHT, f->values, ends[0]);
    if (status == BATTEN_OK)
        status = true_derivatives(f, b, BATTEN_FROM_LEFT, f->values, ends[1]);
    if (status != BATTEN_OK)
        return status;
    double values[2 * 3 * 3];
    for (int k = 0; k < 2; k++)
        memcpy(values + k * f->values * d, ends[k], (size_t)(f->values * d) * sizeof *values);
    bat_hermite_points(d, 2, f->values, (const double[2]){a, b}, values, points);
    *error = 0;
    for (int i = 1; status == BATTEN_OK && i <= CHECKS; i++) {
        const double t = (double)i / (CHECKS + 1);
        double basis[MOST_POINTS], point[3], wanted[3];
        bat_bernstein(degree, t, 1 - t, basis);
        bat_combine(degree, basis, (size_t)d, points, point);
        status = true_derivatives(f, a + t * (b - a), BATTEN_FROM_RIGHT, 1, wanted);
        *error = bat_max(*error, bat_distance(d, point, wanted));
    }
    return status;
}

/* One turn: all pieces made, those that are too far halved. */
static batten_status fit_pieces(fit *f, bool *halved)
{
    const int degree = 2 * f->values - 1;
    double *breaks = bat_array((size_t)f->count * 2 + 1, sizeof *breaks);
    double *points =
        bat_array3((size_t)f->count * (size_t)degree + 1, (size_t)f->dimension, sizeof *points);
    batten_status status = breaks && points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int count = 0;
    f->error = 0;
    *halved = false;
    for (int i = 0; status == BATTEN_OK && i < f->count; i++) {
        const double a = f->breaks[i], b = f->breaks[i + 1];
        double error = 0;
        status = make_piece(f, a, b, points + (size_t)(i * degree * f->dimension), &error);
        breaks[count++] = a;
        f->error = bat_max(f->error, error);
        if (!(error <= f->tolerance)) {
            breaks[count++] = a + (b - a) / 2;
            *halved = true;
        }
    }
    if (status == BATTEN_OK && *halved) {
        breaks[count] = f->breaks[f->count];
        bat_release(f->breaks);
        f->breaks = breaks;
        f->count = count;
        breaks = NULL;
    } else if (status == BATTEN_OK) {
        bat_release(f->points);
        f->points = points;
        points = NULL;
    }
    bat_release(breaks);
    bat_release(points);
    return status;
}

static batten_status halve_until_near(fit *f)
{
    bool halved = true;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && halved) {
        if (f->count > MOST_PIECES)
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "the derivative across the edge is met within %g, not %g, by %d "
                            "pieces",
                            f->error, f->tolerance, f->count);
        status = fit_pieces(f, &halved);
    }
    return status;
}

batten_status bat_edge_fit(const batten_surface *surface, batten_edge edge, int k,
                           double tolerance, batten_curve **out, double *error)
{
    fit f = {.surface = surface,
             .place = bat_edge_of(surface, edge),
             .dimension = batten_surface_dimension(surface),
             .k = k,
             .values = k < 2 ? 3 : 2,
             .tolerance = tolerance};
    f.count = batten_surface_spans(surface, f.place.along, NULL) - 1;
    f.breaks = bat_array((size_t)f.count + 1, sizeof *f.breaks);
    if (!f.breaks)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, f.place.along, f.breaks);
    batten_curve *pieces = NULL;
    batten_status status = halve_until_near(&f);
    if (status == BATTEN_OK)
        status = batten_curve_from_bezier(f.dimension,
                                          (batten_pieces){2 * f.values - 1, f.count, f.breaks},
                                          f.points, NULL, &pieces);
    /* The pieces join as smoothly as the truth, up to the derivatives they share with it. */
    if (status == BATTEN_OK)
        status = batten_curve_remove_knots(
            pieces,
            64 * DBL_EPSILON *
                bat_largest((f.count * (2 * f.values - 1) + 1) * f.dimension, f.points),
            NULL, NULL, out);
    if (status == BATTEN_OK)
        *error = f.error;
    batten_curve_unref(pieces);
    bat_release(f.points);
    bat_release(f.breaks);
    return status;
}
