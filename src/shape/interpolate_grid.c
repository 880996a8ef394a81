#include "base/work.h"
#include "shape/shape.h"
#include "spline/curve.h"

#include <float.h>
#include <string.h>

batten_grid_options batten_grid_defaults(void)
{
    return (batten_grid_options){.size = sizeof(batten_grid_options),
                                 .degree_u = 3,
                                 .degree_v = 3,
                                 .parameters = BATTEN_CENTRIPETAL};
}

/* ---- parameters ---- */

static int step_count(const bat_family *g)
{
    return g->periodic ? g->count : g->count - 1;
}

/* The steps of one line as shares of its length; false when it has none. */
static bool line_shares(const bat_family *g, int line, batten_parametrization kind,
                        double *points, double *shares)
{
    const size_t d = (size_t)g->dimension;
    const double *from = g->points + (size_t)line * g->line_step;
    for (size_t i = 0; i < (size_t)g->count; i++)
        memcpy(points + i * d, from + i * g->point_step, d * sizeof *points);
    bat_steps(g->dimension, g->count, points, kind, g->periodic, shares);
    double total = 0;
    for (int i = 0; i < step_count(g); i++)
        total += shares[i];
    for (int i = 0; i < step_count(g) && total != 0; i++)
        shares[i] /= total;
    return total != 0; /* an overflow is found by accumulate */
}

/* From average shares to parameters 0 .. 1. */
static batten_status accumulate(const bat_family *g, int used, double *u)
{
    const int n = step_count(g);
    if (used == 0)
        return bat_fail(BATTEN_COINCIDENT,
                        "all %s coincide: every line across them is a single point", g->name);
    u[0] = 0;
    for (int i = 0; i < n; i++) {
        const double share = u[i + 1] / used;
        if (!isfinite(share))
            return bat_fail(BATTEN_OVERFLOW, "%s %d and %d are too far apart", g->name, i,
                            (i + 1) % g->count);
        /* A millionth of the mean step would leave a crease, not a surface. */
        if (share * n < 1e-6)
            return bat_fail(BATTEN_COINCIDENT,
                            "%s %d and %d coincide: the step is %g of the length", g->name, i,
                            (i + 1) % g->count, share);
        u[i + 1] = u[i] + share;
    }
    u[n] = 1;
    return BATTEN_OK;
}

/* How far the parameters of one line are from u, in steps. */
static double line_spread(const bat_family *g, const double *shares, const double *u)
{
    double at = 0, spread = 0;
    for (int i = 1; i < step_count(g); i++) {
        at += shares[i - 1];
        spread = bat_max(spread, fabs(at - u[i]) / bat_min(u[i] - u[i - 1], u[i + 1] - u[i]));
    }
    return spread;
}

static batten_status average(const bat_family *g, batten_parametrization kind, double *u,
                             double *spread)
{
    const size_t n = (size_t)step_count(g);
    double *points = bat_array3((size_t)g->count, (size_t)g->dimension, sizeof *points);
    double *shares = bat_array(n, sizeof *shares);
    batten_status status = points && shares ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int used = 0;
    for (int line = 0; status == BATTEN_OK && line < g->lines; line++)
        if (line_shares(g, line, kind, points, shares)) {
            used++;
            for (size_t i = 0; i < n; i++)
                u[i + 1] += shares[i];
        }
    if (status == BATTEN_OK)
        status = accumulate(g, used, u);
    for (int line = 0; status == BATTEN_OK && line < g->lines; line++)
        if (line_shares(g, line, kind, points, shares))
            *spread = bat_max(*spread, line_spread(g, shares, u));
    bat_release(shares);
    bat_release(points);
    return status;
}

batten_status bat_family_parametrize(const bat_family *g, batten_parametrization kind,
                                     double *u, double *spread)
{
    if ((int)kind < 0 || kind > BATTEN_GIVEN)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no parametrization %d", (int)kind);
    if (kind != BATTEN_GIVEN)
        return average(g, kind, u, spread);
    if (!g->given)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the parameters of the %s shall be given, and are not", g->name);
    memcpy(u, g->given, ((size_t)g->count + g->periodic) * sizeof *u);
    return bat_parameters_check(g->count + g->periodic, u);
}

/* ---- checks ---- */

static batten_status check_derivatives(const batten_grid_options *o, int d, int count_u,
                                       int count_v)
{
    const struct {
        const double *values;
        size_t count;
        const char *name;
        bool periodic;
    } given[] = {{o->du, 2 * (size_t)count_v * (size_t)d, "du", o->periodic_u},
                 {o->dv, 2 * (size_t)count_u * (size_t)d, "dv", o->periodic_v},
                 {o->twists, 4 * (size_t)d, "twists", o->periodic_u || o->periodic_v}};
    for (int i = 0; i < 3; i++) {
        if (!given[i].values)
            continue;
        if (!o->knots_at_data || given[i].periodic)
            return bat_fail(BATTEN_BAD_ARGUMENT, "`%s` is given, but %s", given[i].name,
                            o->knots_at_data ? "a periodic surface has no rim there"
                                             : "averaged knots leave no freedom for it");
        const size_t bad = bat_first_not_finite(given[i].values, given[i].count);
        if (bad < given[i].count)
            return bat_fail(BATTEN_NOT_FINITE, "number %zu of `%s` is %g", bad, given[i].name,
                            given[i].values[bad]);
    }
    if (o->twists && (!o->du || !o->dv))
        return bat_fail(BATTEN_BAD_ARGUMENT, "`twists` are given, but not both `du` and `dv`");
    return BATTEN_OK;
}

static batten_status check_ends(const batten_grid_options *o)
{
    switch (o->ends) {
    case BATTEN_END_NOT_A_KNOT:
    case BATTEN_END_NATURAL:
    case BATTEN_END_PARABOLIC:
    case BATTEN_END_BESSEL:
    case BATTEN_END_FAIR:
        return BATTEN_OK;
    default:
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "ends of kind %d need vectors: give a surface `du` and `dv`",
                        (int)o->ends);
    }
}

static batten_status check_grid(int d, int count_u, int count_v, const double *points,
                                const batten_grid_options *o)
{
    if (count_u < 2 || count_v < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "the grid has %d x %d points, and needs 2 x 2",
                        count_u, count_v);
    const long long total = (long long)count_u * count_v;
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "the grid has %lld points; the limit is %d", total,
                        (int)BAT_MAX_POINTS);
    batten_status status = bat_points_check(d, (int)total, points, 4);
    if (status == BATTEN_OK)
        status = check_derivatives(o, d, count_u, count_v);
    if (status == BATTEN_OK)
        status = check_ends(o);
    return status;
}

/* ---- one interpolation on its way ---- */

typedef struct {
    int dimension, count_u, count_v;
    const double *points;
    const batten_grid_options *options;
    bat_work work;
    double *u, *v; /* [count + 1] */
    double spread_u, spread_v;
    bat_operator along_u, along_v;
    double *lines;   /* [along_u.count][count_v][d]: control points of the lines along u */
    double *slopes;  /* [2][along_u.count][d]: those of Sv on the rims, when `dv` is given */
    double *control; /* [along_u.count][along_v.count][d] */
} task;

static batten_status find_both_parameters(task *t)
{
    const batten_grid_options *o = t->options;
    const size_t d = (size_t)t->dimension, row = (size_t)t->count_v * d;
    const bat_family u = {"u grid lines", t->dimension, t->count_u, t->count_v, row, d,
                          o->periodic_u,  t->points,    o->given_u};
    const bat_family v = {"v grid lines", t->dimension, t->count_v, t->count_u, d, row,
                          o->periodic_v,  t->points,    o->given_v};
    t->u = bat_array((size_t)t->count_u + 1, sizeof *t->u);
    t->v = bat_array((size_t)t->count_v + 1, sizeof *t->v);
    if (!t->u || !t->v)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = bat_family_parametrize(&u, o->parameters, t->u, &t->spread_u);
    if (status == BATTEN_OK)
        status = bat_family_parametrize(&v, o->parameters, t->v, &t->spread_v);
    return status;
}

static batten_status make_operators(task *t)
{
    const batten_grid_options *o = t->options;
    const batten_end_kind end_u = o->du ? BATTEN_END_CLAMPED : o->ends;
    const batten_end_kind end_v = o->dv ? BATTEN_END_CLAMPED : o->ends;
    const bat_request u = {.degree = o->degree_u,
                           .count = t->count_u,
                           .parameters = t->u,
                           .knots_at_data = o->knots_at_data,
                           .periodic = o->periodic_u,
                           .start = end_u,
                           .end = end_u};
    const bat_request v = {.degree = o->degree_v,
                           .count = t->count_v,
                           .parameters = t->v,
                           .knots_at_data = o->knots_at_data,
                           .periodic = o->periodic_v,
                           .start = end_v,
                           .end = end_v};
    batten_status status = bat_operator_make(&u, &t->along_u);
    if (status == BATTEN_OK)
        status = bat_operator_make(&v, &t->along_v);
    return status;
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
    bat_bessel_slope((size_t)d, h0, h1, P, Q, count > 2 ? row + (ptrdiff_t)c * d : P, slope);
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
    const size_t d = (size_t)t->dimension, row = (size_t)t->count_v * d;
    const double *du = t->options->du;
    t->lines = bat_array3((size_t)t->along_u.count, row, sizeof *t->lines);
    if (!t->lines)
        return BATTEN_OUT_OF_MEMORY;
    return bat_operator_apply(&t->along_u, row, t->points, du, du ? du + row : NULL, NULL,
                              t->lines);
}

/* Sv on the two rims is interpolated along u as the points were; the twists are its end slopes.
 */
static batten_status solve_rims(task *t)
{
    const size_t d = (size_t)t->dimension;
    const batten_grid_options *o = t->options;
    double twists[12];
    if (!o->dv)
        return BATTEN_OK;
    t->slopes = bat_array3(2 * (size_t)t->along_u.count, d, sizeof *t->slopes);
    if (!t->slopes)
        return BATTEN_OUT_OF_MEMORY;
    if (o->twists)
        memcpy(twists, o->twists, 4 * d * sizeof *twists);
    else if (o->du)
        estimate_twists(t, twists);
    batten_status status = BATTEN_OK;
    for (size_t j = 0; status == BATTEN_OK && j < 2; j++)
        status = bat_operator_apply(&t->along_u, d, o->dv + j * (size_t)t->count_u * d,
                                    o->du ? twists + j * d : NULL,
                                    o->du ? twists + (2 + j) * d : NULL, NULL,
                                    t->slopes + j * (size_t)t->along_u.count * d);
    return status;
}

/* [rows][columns][d] to [columns][rows][d]. */
static void transpose(int rows, int columns, size_t d, const double *from, double *to)
{
    for (size_t i = 0; i < (size_t)rows; i++)
        for (size_t j = 0; j < (size_t)columns; j++)
            for (size_t k = 0; k < d; k++)
                to[(j * (size_t)rows + i) * d + k] = from[(i * (size_t)columns + j) * d + k];
}

static batten_status solve_along_v(task *t)
{
    const size_t d = (size_t)t->dimension;
    const int nu = t->along_u.count, nv = t->along_v.count;
    const size_t row = (size_t)nu * d;
    double *data = bat_array3((size_t)t->count_v, row, sizeof *data);
    double *solved = bat_array3((size_t)nv, row, sizeof *solved);
    t->control = bat_array3((size_t)nv, row, sizeof *t->control);
    batten_status status = data && solved && t->control ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        transpose(nu, t->count_v, d, t->lines, data);
        status = bat_operator_apply(&t->along_v, row, data, t->slopes,
                                    t->slopes ? t->slopes + row : NULL, NULL, solved);
    }
    if (status == BATTEN_OK)
        transpose(nv, nu, d, solved, t->control);
    bat_release(solved);
    bat_release(data);
    return status;
}

/* ---- poles ---- */

/* When all data of a rim are one point, so are, but for rounding, all its control points: make
 * them it. */
static void keep_pole(const task *t, bool rim_of_u, bool at_start)
{
    const size_t d = (size_t)t->dimension;
    const size_t cv = (size_t)t->count_v, nv = (size_t)t->along_v.count;
    const size_t data_count = rim_of_u ? cv : (size_t)t->count_u;
    const size_t control_count = rim_of_u ? nv : (size_t)t->along_u.count;
    const size_t data_step = rim_of_u ? d : cv * d, control_step = rim_of_u ? d : nv * d;
    const double *data = t->points;
    double *control = t->control;
    if (!at_start) {
        data += rim_of_u ? (size_t)(t->count_u - 1) * cv * d : (cv - 1) * d;
        control += rim_of_u ? (size_t)(t->along_u.count - 1) * nv * d : (nv - 1) * d;
    }
    for (size_t i = 1; i < data_count; i++)
        for (size_t k = 0; k < d; k++)
            if (data[i * data_step + k] != data[k])
                return;
    for (size_t i = 0; i < control_count; i++)
        memcpy(control + i * control_step, data, d * sizeof *data);
}

/* Given derivatives along a rim make it more than a point. */
static void keep_poles(const task *t)
{
    for (int at_start = 0; at_start < 2; at_start++) {
        if (!t->options->periodic_u && !t->options->dv)
            keep_pole(t, true, at_start);
        if (!t->options->periodic_v && !t->options->du)
            keep_pole(t, false, at_start);
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

/* The largest distance of the surface from a row of data. */
static batten_status row_residual(const task *t, const batten_surface *surface, int i,
                                  double *worst)
{
    const int d = t->dimension;
    for (int j = 0; j < t->count_v; j++) {
        const double *point =
            t->points + ((size_t)i * (size_t)t->count_v + (size_t)j) * (size_t)d;
        double found[3], square = 0;
        const batten_status status =
            batten_surface_evaluate(surface, t->u[i], t->v[j], 0, found);
        if (status != BATTEN_OK)
            return status;
        for (int k = 0; k < d; k++)
            square += (found[k] - point[k]) * (found[k] - point[k]);
        *worst = bat_max(*worst, sqrt(square));
    }
    return BATTEN_OK;
}

static batten_status check_residual(const task *t, const batten_surface *surface,
                                    double *residual)
{
    const size_t d = (size_t)t->dimension;
    double worst = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < t->count_u; i++)
        status = row_residual(t, surface, i, &worst);
    if (status != BATTEN_OK)
        return status;
    *residual = worst;
    const size_t control_count = (size_t)t->along_u.count * (size_t)t->along_v.count;
    const double size = largest(control_count * d, t->control);
    /* Each of the two steps may miss a coordinate by 8 eps, and evaluation by 4 for each
     * degree. */
    const double allowed =
        2 * (16 + 4 * (t->along_u.degree + t->along_v.degree)) * DBL_EPSILON * size;
    if (worst > allowed)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "a data point is missed by %g, more than %g, the rounding of %g", worst,
                        allowed, size);
    return BATTEN_OK;
}

/* One step for each data point. */
static batten_status report(task *t, double fraction)
{
    return bat_work_step(&t->work, (uint64_t)t->count_u * (uint64_t)t->count_v, fraction,
                         "grid");
}

static batten_status find_control(task *t)
{
    batten_status status = find_both_parameters(t);
    if (status == BATTEN_OK)
        status = report(t, 0.3);
    if (status == BATTEN_OK)
        status = make_operators(t);
    if (status == BATTEN_OK)
        status = solve_along_u(t);
    if (status == BATTEN_OK)
        status = report(t, 0.5);
    if (status == BATTEN_OK)
        status = solve_rims(t);
    if (status == BATTEN_OK)
        status = solve_along_v(t);
    if (status == BATTEN_OK)
        status = report(t, 0.7);
    return status;
}

static batten_status solve(task *t, double *residual, batten_surface **out)
{
    batten_status status = find_control(t);
    if (status != BATTEN_OK)
        return status;
    keep_poles(t);
    const bat_operator *u = &t->along_u, *v = &t->along_v;
    const batten_axis axis_u = {u->degree, u->count, u->knots, u->periodic};
    const batten_axis axis_v = {v->degree, v->count, v->knots, v->periodic};
    batten_surface *surface = NULL;
    status = batten_surface_create(t->dimension, &axis_u, &axis_v, t->control, NULL, &surface);
    if (status == BATTEN_OK)
        status = check_residual(t, surface, residual);
    if (status == BATTEN_OK)
        *out = surface;
    else
        batten_surface_unref(surface);
    return status;
}

static void release(task *t)
{
    bat_release(t->control);
    bat_release(t->slopes);
    bat_release(t->lines);
    bat_operator_free(&t->along_v);
    bat_operator_free(&t->along_u);
    bat_release(t->v);
    bat_release(t->u);
}

batten_status batten_surface_interpolate(int dimension, int count_u, int count_v,
                                         const double *points,
                                         const batten_grid_options *options,
                                         const batten_job *job, double *u, double *v,
                                         batten_grid_report *report, batten_surface **out)
{
    const batten_grid_options defaults = batten_grid_defaults();
    task t = {.dimension = dimension,
              .count_u = count_u,
              .count_v = count_v,
              .points = points,
              .options = options ? options : &defaults,
              .work = {job, 0}};
    batten_status status = check_grid(dimension, count_u, count_v, points, t.options);
    double residual = 0;
    if (status == BATTEN_OK)
        status = solve(&t, &residual, out);
    if (status == BATTEN_OK) {
        if (u)
            memcpy(u, t.u, (size_t)count_u * sizeof *u);
        if (v)
            memcpy(v, t.v, (size_t)count_v * sizeof *v);
        if (report)
            *report = (batten_grid_report){residual, t.spread_u, t.spread_v};
    }
    release(&t);
    return status;
}
