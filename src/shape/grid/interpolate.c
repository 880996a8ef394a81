/*
 * Surfaces through grids of points: curves along u through the rows, then along v through their
 * control points.
 */
#include "shape/grid/interpolate.h"
#include "base/work.h"
#include "numeric/dense.h"
#include "shape/linear/linear_solve.h"
#include "shape/points/grid_gaps.h"
#include "shape/points/grid_parameters.h"
#include "shape/points/grid_poles.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

batten_surface_interpolate_options batten_surface_interpolate_defaults(void)
{
    return (batten_surface_interpolate_options){.size =
                                                    sizeof(batten_surface_interpolate_options),
                                                .degree_u = 3,
                                                .degree_v = 3,
                                                .parameters = BATTEN_CENTRIPETAL};
}

/* ---- one interpolation on its way ---- */

typedef struct {
    int dimension, count_u, count_v;
    int width;            /* of data and control points: dimension, with weights one more */
    const double *points; /* [count_u][count_v][d] */
    const double *data;   /* [count_u][count_v][width]: the points, or (w x .., w) */
    double *homogeneous, *filled; /* of these what is ours */
    const batten_surface_interpolate_options *options;
    bat_work work;
    double *u, *v; /* [count + 1] */
    double spread_u, spread_v;
    bat_operator along_u, along_v;
    double *lines;  /* [along_u.count][count_v][width]: control points of the lines along u */
    double *slopes; /* [orders_v][2][along_u.count][d]: those of Sv .. on the rims, when `dv` is
                       given */
    double *control; /* [along_u.count][along_v.count][width], then Cartesian */
    double *weights; /* [along_u.count][along_v.count] or NULL */
    int gap_count;
} task;

/* A copy of the points in which gaps are zeros for now. */
static batten_status begin_gaps(task *t)
{
    const size_t d = (size_t)t->dimension, count = (size_t)t->count_u * (size_t)t->count_v;
    const bool *gaps = t->options->gaps;
    for (size_t i = 0; gaps && i < count; i++)
        t->gap_count += gaps[i];
    if (t->gap_count == 0 || t->dimension < 1 || t->dimension > 3)
        return BATTEN_OK;
    t->filled = bat_array3(count, d, sizeof *t->filled);
    if (!t->filled)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < count; i++)
        if (!gaps[i])
            memcpy(t->filled + i * d, t->points + i * d, d * sizeof *t->filled);
    t->points = t->filled;
    return BATTEN_OK;
}

static batten_status check_grid(task *t)
{
    if (t->count_u < 2 || t->count_v < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "the grid has %d x %d points, and needs 2 x 2",
                        t->count_u, t->count_v);
    const long long total = (long long)t->count_u * t->count_v;
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "the grid has %lld points; the limit is %d", total,
                        (int)BAT_MAX_POINTS);
    batten_status status = begin_gaps(t);
    if (status == BATTEN_OK)
        status = bat_points_check(t->dimension, (int)total, t->points, 4);
    return status == BATTEN_OK
               ? bat_grid_options_check(t->options, t->dimension, t->count_u, t->count_v)
               : status;
}

static batten_status find_both_parameters(task *t)
{
    const batten_surface_interpolate_options *o = t->options;
    const size_t d = (size_t)t->dimension, row = (size_t)t->count_v * d;
    const bat_family u = {"u grid lines", t->dimension, t->count_u, t->count_v, row, d,
                          o->closed_u,    t->points,    o->given_u};
    const bat_family v = {"v grid lines", t->dimension, t->count_v, t->count_u, d, row,
                          o->closed_v,    t->points,    o->given_v};
    bat_release(t->u);
    bat_release(t->v);
    t->u = bat_array((size_t)t->count_u + 1, sizeof *t->u);
    t->v = bat_array((size_t)t->count_v + 1, sizeof *t->v);
    t->spread_u = t->spread_v = 0;
    if (!t->u || !t->v)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = bat_family_parametrize(&u, o->parameters, t->u, &t->spread_u);
    if (status == BATTEN_OK)
        status = bat_family_parametrize(&v, o->parameters, t->v, &t->spread_v);
    return status;
}

/* The derivatives of a rim, in the order in which they are given. */
static void fill_conditions(int orders, int count, batten_derivative *conditions)
{
    for (int order = 1; order <= orders; order++)
        for (int end = 0; end < 2; end++)
            conditions[2 * (order - 1) + end] =
                (batten_derivative){.index = end ? count - 1 : 0, .order = order};
}

static batten_status make_operator(const task *t, bool along_u, bat_operator *out)
{
    const batten_surface_interpolate_options *o = t->options;
    batten_derivative conditions[2 * BATTEN_MAX_DEGREE];
    const bool given = along_u ? o->du != NULL : o->dv != NULL;
    const int orders = along_u ? bat_orders_u(o) : bat_orders_v(o);
    const batten_end_kind ends = given ? BATTEN_END_NOT_A_KNOT : o->ends;
    const bat_request request = {.degree = along_u ? o->degree_u : o->degree_v,
                                 .count = along_u ? t->count_u : t->count_v,
                                 .parameters = along_u ? t->u : t->v,
                                 .knots_at_data = o->knots_at_data,
                                 .periodic = along_u ? o->closed_u : o->closed_v,
                                 .start = ends,
                                 .end = ends,
                                 .condition_count = given ? 2 * orders : 0,
                                 .conditions = conditions};
    fill_conditions(orders, request.count, conditions);
    return bat_operator_make(&request, out);
}

/* Gaps are filled for even parameters, then for those of the filled points. */
static batten_status fill_gaps(task *t)
{
    const batten_surface_interpolate_options *o = t->options;
    bat_gaps gaps = {.dimension = t->dimension,
                     .count = {t->count_u, t->count_v},
                     .periodic = {o->closed_u, o->closed_v},
                     .missing = o->gaps,
                     .points = t->filled};
    batten_status status = BATTEN_OK;
    const bool given = o->parameters == BATTEN_GIVEN;
    for (int round = given ? 1 : 0; status == BATTEN_OK && round < 3; round++) {
        if (round > 0)
            status = find_both_parameters(t);
        if (status == BATTEN_OK) {
            gaps.parameters[0] = round > 0 ? t->u : NULL;
            gaps.parameters[1] = round > 0 ? t->v : NULL;
            status = bat_gaps_fill(&gaps);
        }
        if (given)
            return status;
    }
    return status == BATTEN_OK ? find_both_parameters(t) : status;
}

static batten_status make_operators(task *t)
{
    const batten_status status = make_operator(t, true, &t->along_u);
    return status == BATTEN_OK ? make_operator(t, false, &t->along_v) : status;
}

/* ---- twists that are not given ---- */

/* The slope of Bessel at one end of a row of vectors. */
static void end_slope(int d, int count, const double *row, const double *u, bool at_start,
                      double *slope)
{
    const int last = count - 1, a = at_start ? 0 : last, s = at_start ? 1 : -1;
    const int c = count > 2 ? a + 2 * s : a;
    const double h0 = u[a + s] - u[a], h1 = count > 2 ? u[c] - u[a + s] : h0;
    const double *P = row + (ptrdiff_t)a * d, *Q = row + (ptrdiff_t)(a + s) * d;
    const double *const points[] = {P, Q, count > 2 ? row + (ptrdiff_t)c * d : P};
    bat_bessel_slope((size_t)d, (const double[]){h0, h1}, points, slope);
    if (count == 2) /* the line, not a parabola there and back */
        for (int k = 0; k < d; k++)
            slope[k] = (Q[k] - P[k]) / h0;
}

/* Each corner's twist can be had from Sv along u and from Su along v: their mean, so that u and
 * v may be exchanged. */
static void estimate_twists(const task *t, double *twists)
{
    const int d = t->dimension;
    const double *du = t->options->du, *dv = t->options->dv;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            double along_u[3], along_v[3];
            end_slope(d, t->count_u, dv + (ptrdiff_t)j * t->count_u * d, t->u, i == 0, along_u);
            end_slope(d, t->count_v, du + (ptrdiff_t)i * t->count_v * d, t->v, j == 0, along_v);
            for (int k = 0; k < d; k++)
                twists[(i * 2 + j) * d + k] = (along_u[k] + along_v[k]) / 2;
        }
}

/* ---- the three steps ---- */

static batten_status solve_along_u(task *t)
{
    const size_t row = (size_t)t->count_v * (size_t)t->width;
    t->lines = bat_array3((size_t)t->along_u.count, row, sizeof *t->lines);
    if (!t->lines)
        return BATTEN_OUT_OF_MEMORY;
    const bat_spline_data given = {.width = row, .data = t->data, .conditions = t->options->du};
    return bat_operator_apply(&t->along_u, &given, t->lines);
}

/* The twists that a derivative of the rims has at its ends: [orders_u][2][d] of one order and
 * end of v. */
static void pick_twists(const task *t, const double *twists, size_t which, double *out)
{
    const size_t d = (size_t)t->dimension, across = 2 * (size_t)bat_orders_v(t->options);
    for (size_t k = 0; k < 2 * (size_t)bat_orders_u(t->options); k++)
        memcpy(out + k * d, twists + (k * across + which) * d, d * sizeof *out);
}

/* Sv .. on the two rims is interpolated along u as the points were; the twists are its
 * derivatives at the ends. */
static batten_status solve_rims(task *t)
{
    const size_t d = (size_t)t->dimension;
    const batten_surface_interpolate_options *o = t->options;
    const size_t rims = 2 * (size_t)bat_orders_v(o);
    double estimated[12], ends[6 * BATTEN_MAX_DEGREE];
    const double *twists = o->twists;
    if (!o->dv)
        return BATTEN_OK;
    t->slopes = bat_array3(rims * (size_t)t->along_u.count, d, sizeof *t->slopes);
    if (!t->slopes)
        return BATTEN_OUT_OF_MEMORY;
    if (!twists && o->du) {
        estimate_twists(t, estimated);
        twists = estimated;
    }
    batten_status status = BATTEN_OK;
    for (size_t j = 0; status == BATTEN_OK && j < rims; j++) {
        if (o->du)
            pick_twists(t, twists, j, ends);
        const bat_spline_data given = {.width = d,
                                       .data = o->dv + j * (size_t)t->count_u * d,
                                       .conditions = o->du ? ends : NULL};
        status = bat_operator_apply(&t->along_u, &given,
                                    t->slopes + j * (size_t)t->along_u.count * d);
    }
    return status;
}

static batten_status solve_along_v(task *t)
{
    const size_t d = (size_t)t->width;
    const int nu = t->along_u.count, nv = t->along_v.count;
    const size_t row = (size_t)nu * d;
    double *data = bat_array3((size_t)t->count_v, row, sizeof *data);
    double *solved = bat_array3((size_t)nv, row, sizeof *solved);
    t->control = bat_array3((size_t)nv, row, sizeof *t->control);
    batten_status status = data && solved && t->control ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        bat_transpose(nu, t->count_v, d, t->lines, data);
        const bat_spline_data given = {.width = row, .data = data, .conditions = t->slopes};
        status = bat_operator_apply(&t->along_v, &given, solved);
    }
    if (status == BATTEN_OK)
        bat_transpose(nv, nu, d, solved, t->control);
    bat_release(solved);
    bat_release(data);
    return status;
}

/* ---- weights ---- */

static batten_status make_homogeneous(task *t)
{
    const size_t d = (size_t)t->dimension, count = (size_t)t->count_u * (size_t)t->count_v;
    const double *weights = t->options->weights;
    t->data = t->points;
    t->width = t->dimension;
    if (!weights)
        return BATTEN_OK;
    t->width++;
    t->homogeneous = bat_array3(count, d + 1, sizeof *t->homogeneous);
    if (!t->homogeneous)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < count; i++) {
        double *to = t->homogeneous + i * (d + 1);
        for (size_t k = 0; k < d; k++)
            to[k] = weights[i] * t->points[i * d + k];
        to[d] = weights[i];
    }
    t->data = t->homogeneous;
    return BATTEN_OK;
}

/* Control points and their weights from the homogeneous ones, in place. */
static batten_status divide(task *t)
{
    const size_t d = (size_t)t->dimension, nv = (size_t)t->along_v.count;
    const size_t count = (size_t)t->along_u.count * nv;
    if (!t->options->weights)
        return BATTEN_OK;
    t->weights = bat_array(count, sizeof *t->weights);
    if (!t->weights)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < count; i++) {
        const double w = t->weights[i] = t->control[i * (d + 1) + d];
        if (!(w > 0))
            return bat_fail(BATTEN_BAD_WEIGHT,
                            "the weight of control point (%zu, %zu) comes out as %g; the given "
                            "weights vary too much between neighbours",
                            i / nv + 1, i % nv + 1, w);
        for (size_t k = 0; k < d; k++)
            t->control[i * d + k] = t->control[i * (d + 1) + k] / w;
    }
    return BATTEN_OK;
}

/* ---- poles ---- */

/* Given derivatives along a rim make it more than a point. */
static void keep_poles(const task *t)
{
    const batten_grid data = {t->dimension, t->count_u, t->count_v, t->points};
    const int control[2] = {t->along_u.count, t->along_v.count};
    const batten_surface_interpolate_options *o = t->options;
    for (int at_start = 0; at_start < 2; at_start++) {
        if (!o->closed_u && !o->dv)
            bat_keep_pole(data, control, t->control, 0, at_start);
        if (!o->closed_v && !o->du)
            bat_keep_pole(data, control, t->control, 1, at_start);
    }
}

/* ---- the result ---- */

static double largest(size_t count, const double *values)
{
    double size = 0;
    for (size_t i = 0; i < count; i++)
        size = bat_max(size, fabs(values[i]));
    return size;
}

/* The largest distance of the surface from the data. */
static batten_status find_worst(const task *t, const batten_surface *surface, double *worst)
{
    const size_t d = (size_t)t->dimension, count = (size_t)t->count_u * (size_t)t->count_v;
    const batten_uv_grid places = {(size_t)t->count_u, (size_t)t->count_v, t->u, t->v};
    double *found = bat_array3(count, d, sizeof *found);
    batten_status status = found ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_grid(surface, places, 0, t->work.job, found);
    *worst = 0;
    for (size_t i = 0; i < count && status == BATTEN_OK; i++) {
        double square = 0;
        for (size_t k = i * d; k < (i + 1) * d; k++)
            square += (found[k] - t->points[k]) * (found[k] - t->points[k]);
        *worst = bat_max(*worst, square);
    }
    *worst = sqrt(*worst);
    bat_release(found);
    return status;
}

/* The largest weight in least ones: how much the quotient may multiply rounding. */
static double weight_spread(const task *t, size_t count)
{
    double low = HUGE_VAL, high = 0;
    for (size_t i = 0; i < count; i++) {
        low = bat_min(low, t->weights[i]);
        high = bat_max(high, t->weights[i]);
    }
    return 2 * high / low;
}

static batten_status check_residual(const task *t, const batten_surface *surface,
                                    double *residual)
{
    const size_t d = (size_t)t->dimension;
    double worst = 0;
    const batten_status status = find_worst(t, surface, &worst);
    if (status != BATTEN_OK)
        return status;
    *residual = worst;
    const size_t control_count = (size_t)t->along_u.count * (size_t)t->along_v.count;
    const double size = largest(control_count * d, t->control);
    /* Each of the two steps may miss a coordinate by 8 eps, and evaluation by 4 for each
     * degree. */
    const double spread = t->weights ? weight_spread(t, control_count) : 1;
    const double allowed =
        2 * (16 + 4 * (t->along_u.degree + t->along_v.degree)) * DBL_EPSILON * size * spread;
    if (worst > allowed)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "a data point is missed by %g, more than %g, the rounding of %g", worst,
                        allowed, size);
    return BATTEN_OK;
}

/* One step for each data point. */
static batten_status report_progress(task *t, double fraction)
{
    return bat_work_step(&t->work, (uint64_t)t->count_u * (uint64_t)t->count_v, fraction,
                         "grid");
}

static batten_status find_control(task *t)
{
    batten_status status = t->gap_count > 0 ? fill_gaps(t) : find_both_parameters(t);
    if (status == BATTEN_OK)
        status = report_progress(t, 0.3);
    if (status == BATTEN_OK)
        status = make_homogeneous(t);
    if (status == BATTEN_OK)
        status = make_operators(t);
    if (status == BATTEN_OK)
        status = solve_along_u(t);
    if (status == BATTEN_OK)
        status = report_progress(t, 0.5);
    if (status == BATTEN_OK)
        status = solve_rims(t);
    if (status == BATTEN_OK)
        status = solve_along_v(t);
    if (status == BATTEN_OK)
        status = divide(t);
    if (status == BATTEN_OK)
        status = report_progress(t, 0.7);
    return status;
}

static batten_status solve_directions(task *t, double *residual, batten_surface **out)
{
    batten_status status = find_control(t);
    if (status != BATTEN_OK)
        return status;
    keep_poles(t);
    const bat_operator *u = &t->along_u, *v = &t->along_v;
    const batten_axis axis_u = {u->degree, u->count, u->knots, u->periodic};
    const batten_axis axis_v = {v->degree, v->count, v->knots, v->periodic};
    batten_surface *surface = NULL;
    status =
        batten_surface_create(t->dimension, &axis_u, &axis_v, t->control, t->weights, &surface);
    if (status == BATTEN_OK)
        status = check_residual(t, surface, residual);
    if (status == BATTEN_OK)
        *out = surface;
    else
        batten_surface_unref(surface);
    return status;
}

static void free_task(task *t)
{
    bat_release(t->homogeneous);
    bat_release(t->filled);
    bat_release(t->weights);
    bat_release(t->control);
    bat_release(t->slopes);
    bat_release(t->lines);
    bat_operator_free(&t->along_v);
    bat_operator_free(&t->along_u);
    bat_release(t->v);
    bat_release(t->u);
}

batten_status batten_surface_interpolate(batten_grid points,
                                         const batten_surface_interpolate_options *options,
                                         const batten_job *job, batten_uv_out uv,
                                         batten_surface_interpolate_report *report,
                                         batten_surface **out)
{
    batten_surface_interpolate_options chosen = batten_surface_interpolate_defaults();
    batten_status status =
        BAT_TAKE_OPTIONS(batten_surface_interpolate_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    task t = {.dimension = points.dimension,
              .count_u = points.count_u,
              .count_v = points.count_v,
              .points = points.at,
              .options = &chosen,
              .work = {job, 0}};
    status = check_grid(&t);
    double residual = 0;
    if (status == BATTEN_OK)
        status = solve_directions(&t, &residual, out);
    if (status == BATTEN_OK) {
        if (uv.u)
            memcpy(uv.u, t.u, (size_t)points.count_u * sizeof *uv.u);
        if (uv.v)
            memcpy(uv.v, t.v, (size_t)points.count_v * sizeof *uv.v);
        if (report)
            *report = (batten_surface_interpolate_report){residual, t.spread_u, t.spread_v,
                                                          t.gap_count};
    }
    free_task(&t);
    return status;
}
