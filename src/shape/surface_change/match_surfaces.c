/* Joining a surface to another: its first rows of control points are laid anew. */
#include <batten/continuity.h>
#include <batten/curvature.h>

#include "base/plural.h"
#include "numeric/peaks.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/boundary/edge_fit.h"
#include "shape/surface_change/near_edges.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"

#include <string.h>

enum { SAMPLES = 65 };

/* ---- the surface with its edge at the start of u ---- */

/* Turn the surface so that the edge is at the start of u; doing it in the other order turns it
 * back. */
static batten_status turn_to_edge(batten_edge edge, bool back, batten_surface **surface)
{
    const bool swapped = edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_V1;
    const bool at_end = edge == BATTEN_EDGE_U1 || edge == BATTEN_EDGE_V1;
    batten_surface *made = NULL;
    batten_status status = BATTEN_OK;
    for (int step = 0; step < 2 && status == BATTEN_OK; step++) {
        if (step == (back ? 1 : 0) && swapped)
            status = bat_surface_replace(batten_surface_swap(*surface, &made), surface, &made);
        else if (step == (back ? 0 : 1) && at_end)
            status = bat_surface_replace(batten_surface_reverse(*surface, BATTEN_U, &made),
                                         surface, &made);
    }
    return status;
}

static batten_status take_surface(const batten_surface *first, batten_edge edge, int order,
                                  batten_surface **out)
{
    if (strcmp(batten_surface_kind(first), "nurbs") != 0 || batten_surface_is_rational(first))
        return bat_fail(BATTEN_UNSUPPORTED,
                        "the surface that moves must be a B-spline surface without weights");
    batten_surface *surface = batten_surface_ref(first), *made = NULL;
    batten_status status = turn_to_edge(edge, false, &surface);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = bat_surface_replace(batten_surface_clamp(surface, (batten_direction)k, &made),
                                     &surface, &made);
    if (status == BATTEN_OK && batten_surface_degree(surface, BATTEN_U) < order)
        status =
            bat_fail(BATTEN_BAD_DEGREE,
                     "the degree across the edge is %d; to join with order %d it must be %d",
                     batten_surface_degree(surface, BATTEN_U), order, order);
    if (status == BATTEN_OK && batten_surface_point_count(surface, BATTEN_U) < order + 2)
        status = bat_fail(BATTEN_TOO_FEW_POINTS,
                          "%d row%s of control points across the edge; %d would move and the "
                          "opposite edge must stay",
                          batten_surface_point_count(surface, BATTEN_U),
                          bat_plural(batten_surface_point_count(surface, BATTEN_U)), order + 1);
    if (status == BATTEN_OK)
        *out = batten_surface_ref(surface);
    batten_surface_unref(surface);
    return status;
}

/* ---- common knots along the edge ---- */

typedef struct {
    batten_surface *surface; /* edge at the start of u */
    batten_curve *rows[3];   /* edge, slope, curvature of the other, along v, same knots */
    int order;
    double scale; /* of the derivative across */
} match;

/* The ribbon in the direction of the edge and over its domain. */
static batten_status lay_along(match *m, bool reversed)
{
    const batten_interval domain = batten_surface_domain(m->surface, BATTEN_V);
    batten_curve *made = NULL;
    batten_status status = BATTEN_OK;
    for (int k = 0; k <= m->order && status == BATTEN_OK; k++) {
        if (reversed)
            status =
                bat_curve_replace(batten_curve_reverse(m->rows[k], &made), &m->rows[k], &made);
        if (status == BATTEN_OK)
            status = bat_curve_replace(
                batten_curve_set_domain(m->rows[k], domain.a, domain.b, &made), &m->rows[k],
                &made);
    }
    return status;
}

/* Refine the surface to the degree and the knots of a curve along the edge, which has its own
 * and more; both over [0, 1]. */
static batten_status refine_along(match *m, const batten_curve *common)
{
    batten_surface *made = NULL;
    const int by = batten_curve_degree(common) - batten_surface_degree(m->surface, BATTEN_V);
    batten_status status = BATTEN_OK;
    if (by > 0)
        status = bat_surface_replace(batten_surface_elevate(m->surface, BATTEN_V, by, &made),
                                     &m->surface, &made);
    const double *own = batten_surface_knots(m->surface, BATTEN_V);
    const double *wanted = batten_curve_knots(common);
    const int own_count = batten_surface_knot_count(m->surface, BATTEN_V);
    const int count = batten_curve_point_count(common) + batten_curve_degree(common) + 1;
    double *missing = bat_array((size_t)count, sizeof *missing);
    int added = 0;
    for (int i = 0, j = 0; missing && status == BATTEN_OK && i < count; i++) {
        if (j < own_count && own[j] <= wanted[i])
            j++;
        else
            missing[added++] = wanted[i];
    }
    if (!missing && status == BATTEN_OK)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && added > 0)
        status = bat_surface_replace(
            batten_surface_refine(m->surface, BATTEN_V, added, missing, &made), &m->surface,
            &made);
    bat_release(missing);
    return status;
}

static batten_status make_common(match *m)
{
    batten_curve *edge = NULL, *common[4] = {NULL};
    batten_surface *made = NULL;
    batten_status status = bat_surface_replace(
        batten_surface_set_domain(m->surface, BATTEN_V, 0, 1, &made), &m->surface, &made);
    if (status == BATTEN_OK)
        status = batten_surface_isocurve(m->surface, BATTEN_U,
                                         batten_surface_domain(m->surface, BATTEN_U).a, &edge);
    const batten_curve *given[4] = {edge, m->rows[0], m->rows[1], m->rows[2]};
    if (status == BATTEN_OK)
        status = batten_curves_unify(m->order + 2, given, common);
    if (status == BATTEN_OK)
        status = refine_along(m, common[0]);
    for (int k = 0; k <= m->order && status == BATTEN_OK; k++) {
        batten_curve_unref(m->rows[k]);
        m->rows[k] = batten_curve_ref(common[k + 1]);
    }
    if (status == BATTEN_OK && batten_curve_point_count(m->rows[0]) !=
                                   batten_surface_point_count(m->surface, BATTEN_V))
        status = bat_fail(BATTEN_NOT_COMPATIBLE, "the knots along the edges do not unify");
    for (int k = 0; k < 4; k++)
        batten_curve_unref(common[k]);
    batten_curve_unref(edge);
    return status;
}

/* ---- the rows ---- */

/* How many times longer the surface's derivative across is than the other's, in the mean. */
static batten_status find_scale(match *m)
{
    const double u = batten_surface_domain(m->surface, BATTEN_U).a;
    double own = 0, other = 0;
    for (int i = 0; i < SAMPLES; i++) {
        double values[9], slope[3];
        const double v = i / (SAMPLES - 1.0);
        batten_status status = batten_surface_evaluate(m->surface, u, v, 1, values);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(m->rows[1], v, 0, slope);
        if (status != BATTEN_OK)
            return status;
        own += bat_norm(3, values + 3);
        other += bat_norm(3, slope);
    }
    if (!(other > 0) || !(own > 0))
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the %s surface has no slope across its edge",
                        own > 0 ? "second" : "first");
    m->scale = own / other;
    return BATTEN_OK;
}

/* Lay the first rows; the longest way of a point is returned. */
static double lay_rows(const match *m, const double *U, int p, int columns, double *points)
{
    const double first = p / (U[p + 1] - U[1]);
    const double second = m->order > 1 ? (p - 1) / (U[p + 1] - U[2]) : 0;
    const double next = m->order > 1 ? p / (U[p + 2] - U[2]) : 0;
    double moved = 0;
    for (int j = 0; j < columns; j++) {
        double *row[3], old[3][3];
        for (int i = 0; i <= m->order; i++) {
            row[i] = points + ((size_t)i * (size_t)columns + (size_t)j) * 3;
            memcpy(old[i], row[i], sizeof old[i]);
        }
        for (int x = 0; x < 3; x++) {
            const size_t at = (size_t)j * 3 + (size_t)x;
            row[0][x] = batten_curve_points(m->rows[0])[at];
            if (m->order < 1)
                continue;
            const double slope = m->scale * batten_curve_points(m->rows[1])[at];
            row[1][x] = row[0][x] + slope / first;
            if (m->order < 2)
                continue;
            const double bend = m->scale * m->scale * batten_curve_points(m->rows[2])[at];
            row[2][x] = row[1][x] + (slope + bend / second) / next;
        }
        for (int i = 0; i <= m->order; i++)
            moved = bat_max(moved, bat_distance(3, old[i], row[i]));
    }
    return moved;
}

static batten_status move_rows(match *m, double *moved)
{
    const int p = batten_surface_degree(m->surface, BATTEN_U),
              q = batten_surface_degree(m->surface, BATTEN_V);
    const int n = batten_surface_point_count(m->surface, BATTEN_U),
              columns = batten_surface_point_count(m->surface, BATTEN_V);
    const double *U = batten_surface_knots(m->surface, BATTEN_U);
    const size_t total = (size_t)n * (size_t)columns * 3;
    double *points = bat_array(total, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(points, batten_surface_points(m->surface), total * sizeof *points);
    *moved = lay_rows(m, U, p, columns, points);
    const batten_axis u = {p, n, U, false},
                      v = {q, columns, batten_surface_knots(m->surface, BATTEN_V), false};
    batten_surface *made = NULL;
    const batten_status status = bat_surface_replace(
        batten_surface_create(3, &u, &v, points, NULL, &made), &m->surface, &made);
    bat_release(points);
    return status;
}

/* ---- how well they join ---- */

/* Two edges that were made to meet. */
typedef struct {
    const batten_surface *surfaces[2];
    batten_edge edges[2];
    bool reversed;
} matched_edges;

/* The gap, the angle of the tangent planes, and the largest difference of a principal curvature. */
static batten_status compare_at(void *context, double t, double *values)
{
    const matched_edges *m = context;
    double at[2][2], p[2][3];
    batten_surface_local local[2];
    batten_vec3 n[2];
    batten_status status = BATTEN_OK, normal = BATTEN_OK, curved = BATTEN_OK;
    values[0] = values[1] = values[2] = 0;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        bat_on_edge(m->surfaces[k], m->edges[k], k && m->reversed ? 1 - t : t, at[k]);
        status = batten_surface_evaluate(m->surfaces[k], at[k][0], at[k][1], 0, p[k]);
    }
    if (status != BATTEN_OK)
        return status;
    values[0] = bat_distance(3, p[0], p[1]);
    for (int k = 0; k < 2 && normal == BATTEN_OK; k++)
        normal = batten_surface_normal(m->surfaces[k], at[k][0], at[k][1], NULL, &n[k]);
    if (normal != BATTEN_OK) /* a corner without normal says nothing */
        return normal == BATTEN_SINGULAR_HERE ? BATTEN_OK : normal;
    for (int k = 0; k < 2 && curved == BATTEN_OK; k++)
        curved = batten_surface_local_at(m->surfaces[k], at[k][0], at[k][1], &local[k]);
    const double sine = bat_vec3_norm(bat_vec3_cross(n[0], n[1]));
    const double cosine = bat_vec3_dot(n[0], n[1]);
    values[1] = bat_atan2(sine, fabs(cosine));
    values[2] = NAN;
    if (curved != BATTEN_OK)
        return BATTEN_OK;
    /* With opposite normals the principal curvatures change sign and order. */
    const double k1 = cosine < 0 ? -local[1].kappa2 : local[1].kappa1,
                 k2 = cosine < 0 ? -local[1].kappa1 : local[1].kappa2;
    values[2] = bat_max(fabs(local[0].kappa1 - k1), fabs(local[0].kappa2 - k2));
    return BATTEN_OK;
}

static batten_status measure_match(matched_edges *m, batten_surface_match_report *report)
{
    double largest[3];
    const batten_status status = bat_find_peaks(compare_at, m, SAMPLES, 3, largest);
    if (status != BATTEN_OK)
        return status;
    report->gap = largest[0];
    report->angle = largest[1];
    report->curvature = largest[2];
    return BATTEN_OK;
}

static batten_status finish_match(const match *m, batten_edge first_edge,
                                  const batten_surface *second, batten_edge second_edge,
                                  batten_interval along, batten_surface_match_report *report,
                                  batten_surface **out)
{
    batten_surface *surface = NULL;
    batten_status status =
        batten_surface_set_domain(m->surface, BATTEN_V, along.a, along.b, &surface);
    if (status == BATTEN_OK)
        status = turn_to_edge(first_edge, true, &surface);
    matched_edges edges = {{surface, second}, {first_edge, second_edge}, report->reversed};
    if (status == BATTEN_OK)
        status = measure_match(&edges, report);
    if (status == BATTEN_OK)
        *out = batten_surface_ref(surface);
    batten_surface_unref(surface);
    return status;
}

static double size_of(const batten_surface *surface)
{
    const batten_box box = batten_surface_box(surface);
    return bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
}

static bool is_point(const batten_curve *curve, double size)
{
    const batten_box box = batten_curve_box(curve);
    return !(bat_vec3_norm(bat_vec3_subtract(box.high, box.low)) > BAT_ROUNDING * size);
}

static batten_status check_edges(const match *m, const batten_surface *second)
{
    batten_curve *own = NULL;
    const double u = batten_surface_domain(m->surface, BATTEN_U).a, size = size_of(second);
    const batten_status status = batten_surface_isocurve(m->surface, BATTEN_U, u, &own);
    if (status != BATTEN_OK)
        return status;
    const bool first_is_point = is_point(own, size),
               other_is_point = is_point(m->rows[0], size);
    batten_curve_unref(own);
    return first_is_point || other_is_point
               ? bat_fail(BATTEN_NOT_COMPATIBLE, "the edge of the %s surface is a point",
                          first_is_point ? "first" : "second")
               : BATTEN_OK;
}

/* Do the edges run against each other? The points within tell it of closed ones. */
static batten_status find_reversed(const match *m, bool *reversed)
{
    static const double places[4] = {0, 0.25, 0.75, 1};
    const batten_interval own = batten_surface_domain(m->surface, BATTEN_V),
                          other = batten_curve_domain(m->rows[0]);
    const double u = batten_surface_domain(m->surface, BATTEN_U).a;
    double a[4][3], b[4][3], same = 0, crossed = 0;
    for (int i = 0; i < 4; i++) {
        const double s = places[i];
        batten_status status =
            batten_surface_evaluate(m->surface, u, (1 - s) * own.a + s * own.b, 0, a[i]);
        if (status == BATTEN_OK)
            status =
                batten_curve_evaluate(m->rows[0], (1 - s) * other.a + s * other.b, 0, b[i]);
        if (status != BATTEN_OK)
            return status;
    }
    for (int i = 0; i < 4; i++) {
        same += bat_distance(3, a[i], b[i]);
        crossed += bat_distance(3, a[i], b[3 - i]);
    }
    *reversed = crossed < same;
    return BATTEN_OK;
}

/* The ribbon without weights, each row within the tolerance. */
static batten_status make_polynomial(match *m, double tolerance)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k <= m->order && status == BATTEN_OK; k++) {
        batten_curve *made = NULL;
        const int degree = bat_max_int(5, batten_curve_degree(m->rows[k]));
        if (batten_curve_is_rational(m->rows[k]))
            status = bat_curve_replace(
                batten_curve_approximate(m->rows[k], degree, tolerance, NULL, &made),
                &m->rows[k], &made);
    }
    return status;
}

/* The surface that moves and the ribbon that it takes over, in its direction and over its
 * domain.
 */
static batten_status prepare_match(match *m, const batten_surface *first,
                                   batten_edge first_edge, const batten_surface *second,
                                   batten_edge second_edge, double tolerance, bool *reversed)
{
    batten_status status = take_surface(first, first_edge, m->order, &m->surface);
    if (status == BATTEN_OK)
        status = batten_edge_ribbon(second, second_edge, bat_max_int(m->order, 1), tolerance,
                                    NULL, m->rows);
    if (status == BATTEN_OK)
        status = check_edges(m, second);
    if (status == BATTEN_OK)
        status = make_polynomial(m, tolerance);
    if (status == BATTEN_OK)
        status = find_reversed(m, reversed);
    return status == BATTEN_OK ? lay_along(m, *reversed) : status;
}

batten_status batten_surface_match(batten_surface_edge first, batten_surface_edge second,
                                   int order, double tolerance,
                                   batten_surface_match_report *report, batten_surface **out)
{
    assert(first.surface && second.surface && out);
    if (order < 0 || order > 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the order is %d; it must be 0, 1 or 2", order);
    if (first.surface->dimension != 3 || second.surface->dimension != 3)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the surfaces have the dimensions %d and %d",
                        first.surface->dimension, second.surface->dimension);
    match m = {.order = order, .scale = 1};
    batten_surface_match_report own = {0};
    batten_surface *made = NULL;
    batten_interval along = {0, 1};
    batten_status status = prepare_match(&m, first.surface, first.edge, second.surface,
                                         second.edge, tolerance, &own.reversed);
    if (status == BATTEN_OK) {
        along = batten_surface_domain(m.surface, BATTEN_V);
        status = make_common(&m);
    }
    if (status == BATTEN_OK && order > 0)
        status = find_scale(&m);
    if (status == BATTEN_OK)
        status = move_rows(&m, &own.moved);
    if (status == BATTEN_OK)
        status = finish_match(&m, first.edge, second.surface, second.edge, along, &own, &made);
    if (status == BATTEN_OK &&
        !(own.gap <= bat_max(tolerance, BAT_ROUNDING * size_of(second.surface))))
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET, "the edges are %g apart; %g was wanted",
                          own.gap, tolerance);
    if (status == BATTEN_OK) {
        *out = batten_surface_ref(made);
        if (report)
            *report = own;
    }
    batten_surface_unref(made);
    batten_surface_unref(m.surface);
    for (int k = 0; k < 3; k++)
        batten_curve_unref(m.rows[k]);
    return status;
}
