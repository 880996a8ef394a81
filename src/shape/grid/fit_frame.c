/* What all fits to grids share: checks, parameters, one direction, and the surface with its
 * report. */
#include "shape/grid/fit_frame.h"
#include "base/plural.h"
#include "numeric/dense.h"
#include "numeric/select.h"
#include "numeric/vector.h"
#include "shape/points/grid_parameters.h"
#include "shape/points/grid_poles.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"

#include <string.h>

batten_surface_fit_grid_options batten_surface_fit_grid_defaults(void)
{
    return (batten_surface_fit_grid_options){.size = sizeof(batten_surface_fit_grid_options),
                                             .degree_u = 3,
                                             .degree_v = 3,
                                             .parameters = BATTEN_CENTRIPETAL,
                                             .hold_rims = true,
                                             .order = 2};
}

static const char names[2] = {'u', 'v'};

/* ---- checks ---- */

static batten_status check_grid(const bat_grid_fit *t)
{
    if (t->count[0] < 2 || t->count[1] < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "the grid has %d x %d points, and needs 2 x 2",
                        t->count[0], t->count[1]);
    const long long total = (long long)t->count[0] * t->count[1];
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "the grid has %lld points; the limit is %d", total,
                        (int)BAT_MAX_POINTS);
    batten_status status = bat_points_check(t->dimension, (int)total, t->points, 4);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        status = bat_weights_check(t->count[k], t->weights[k]);
        if (status == BATTEN_OK && (t->degree[k] < 1 || t->degree[k] > BATTEN_MAX_DEGREE))
            status = bat_fail(BATTEN_BAD_DEGREE, "the degree along %c is %d, not 1 to %d",
                              names[k], t->degree[k], BATTEN_MAX_DEGREE);
    }
    return status;
}

/* Few lines lower a degree; 0 control points are chosen by the caller's share. */
static batten_status settle_size(bat_grid_fit *t, int direction)
{
    const int count = t->count[direction], k = direction;
    if (!t->periodic[k])
        t->degree[k] = bat_min_int(t->degree[k], count - 1);
    const int least = t->periodic[k] ? bat_min_int(t->degree[k] + 1, count) : t->degree[k] + 1;
    if (t->wanted[k] < 0 || (t->wanted[k] > 0 && t->wanted[k] < least))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d control point%s along %c, and degree %d needs %d", t->wanted[k],
                        bat_plural(t->wanted[k]), names[k], t->degree[k], least);
    if (t->wanted[k] > count)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "%d control point%s along %c, and the grid has %d line%s there",
                        t->wanted[k], bat_plural(t->wanted[k]), names[k], count,
                        bat_plural(count));
    if (t->wanted[k] == 0)
        t->wanted[k] = bat_min_int(count, bat_max_int(least, (count + 3) / 4));
    return BATTEN_OK;
}

static batten_status find_parameters(bat_grid_fit *t, int direction)
{
    const batten_surface_fit_grid_options *o = t->options;
    const size_t d = (size_t)t->dimension, row = (size_t)t->count[1] * d;
    const bool u = direction == 0;
    const bat_family family = {u ? "u grid lines" : "v grid lines",
                               t->dimension,
                               t->count[direction],
                               t->count[1 - direction],
                               u ? row : d,
                               u ? d : row,
                               t->periodic[direction],
                               t->points,
                               u ? o->given_u : o->given_v};
    t->parameters[direction] =
        bat_array((size_t)t->count[direction] + 1, sizeof *t->parameters[direction]);
    if (!t->parameters[direction])
        return BATTEN_OUT_OF_MEMORY;
    return bat_family_parametrize(&family, o->parameters, t->parameters[direction],
                                  &t->spread[direction]);
}

batten_status bat_grid_fit_begin(bat_grid_fit *t, const batten_job *job)
{
    const batten_surface_fit_grid_options *o = t->options;
    t->work = (bat_work){job, 0};
    t->degree[0] = o->degree_u;
    t->degree[1] = o->degree_v;
    t->wanted[0] = t->wanted[0] ? t->wanted[0] : o->points_u;
    t->wanted[1] = t->wanted[1] ? t->wanted[1] : o->points_v;
    t->periodic[0] = o->closed_u;
    t->periodic[1] = o->closed_v;
    t->weights[0] = o->weights_u;
    t->weights[1] = o->weights_v;
    batten_status status = check_grid(t);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = settle_size(t, k);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = find_parameters(t, k);
    const uint64_t steps = (uint64_t)bat_max_int(t->count[0], 0) * (uint64_t)t->count[1];
    return status == BATTEN_OK ? bat_work_step(&t->work, steps, 0.2, "grid") : status;
}

/* ---- one direction ---- */

batten_status bat_grid_fit_line(const bat_grid_fit *t, int direction, int width,
                                const double *points, bat_fit *out)
{
    const bat_fit_request request = {.dimension = width,
                                     .degree = t->degree[direction],
                                     .count = t->wanted[direction],
                                     .periodic = t->periodic[direction],
                                     .knots = t->knots[direction],
                                     .data_count = t->count[direction],
                                     .points = points,
                                     .parameters = t->parameters[direction],
                                     .weights = t->weights[direction]};
    return bat_fit_begin(&request, out);
}

/* ---- the report ---- */

batten_status bat_surface_fit_measure(size_t count, double *distances, const double *weights,
                                      batten_surface_fit_report *report)
{
    size_t counted = 0;
    double squares = 0;
    report->error = report->rms = report->most = 0;
    report->worst = 0;
    for (size_t i = 0; i < count; i++) {
        const double distance = distances[i];
        if (weights && !(weights[i] > 0))
            continue;
        if (distance > report->error) {
            report->error = distance;
            report->worst = (int)i;
        }
        squares += distance * distance;
        distances[counted++] = distance;
    }
    if (counted == 0)
        return BATTEN_OK;
    if (!isfinite(squares))
        return bat_fail(BATTEN_OVERFLOW,
                        "distances of up to %g are too large for the sum of their squares",
                        report->error);
    report->rms = sqrt(squares / (double)counted);
    report->most = bat_select(counted, distances, (size_t)ceil(0.95 * (double)counted) - 1);
    return BATTEN_OK;
}

static batten_status measure_fit(const bat_grid_fit *t, const batten_surface *surface,
                                 batten_surface_fit_report *report)
{
    const int d = t->dimension;
    const size_t nu = (size_t)t->count[0], nv = (size_t)t->count[1];
    double *found = bat_array3(nu, nv, (size_t)d * sizeof *found);
    double *weights = bat_array3(nu, nv, sizeof *weights);
    batten_status status = found && weights ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_grid(
            surface, (batten_uv_grid){nu, nv, t->parameters[0], t->parameters[1]}, 0,
            t->work.job, found);
    for (size_t i = 0; status == BATTEN_OK && i < nu * nv; i++) {
        weights[i] = (t->weights[0] ? t->weights[0][i / nv] : 1) *
                     (t->weights[1] ? t->weights[1][i % nv] : 1);
        found[i] = bat_distance(d, found + i * (size_t)d, t->points + i * (size_t)d);
    }
    if (status == BATTEN_OK) {
        status = bat_surface_fit_measure(nu * nv, found, weights, report);
    }
    if (status == BATTEN_OK) {
        const size_t i = (size_t)report->worst;
        report->at[0] = t->parameters[0][i / nv];
        report->at[1] = t->parameters[1][i % nv];
        memcpy(report->where, d == 1 ? report->at : t->points + i * (size_t)d,
               (size_t)bat_max_int(d, 2) * sizeof(double));
        if (d == 1)
            report->where[2] = t->points[i];
    }
    bat_release(weights);
    bat_release(found);
    return status;
}

static batten_status make_surface(const bat_grid_fit *t, batten_surface_fit_report *report,
                                  batten_surface **out)
{
    const batten_axis u = {t->degree[0], t->wanted[0], t->knots[0], t->periodic[0]};
    const batten_axis v = {t->degree[1], t->wanted[1], t->knots[1], t->periodic[1]};
    batten_surface *surface = NULL;
    batten_status status =
        batten_surface_create(t->dimension, &u, &v, t->control, NULL, &surface);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        batten_surface *clamped = NULL;
        if (t->periodic[k])
            continue;
        status = batten_surface_clamp(surface, k ? BATTEN_V : BATTEN_U, &clamped);
        if (status == BATTEN_OK) {
            batten_surface_unref(surface);
            surface = clamped;
        }
    }
    if (status == BATTEN_OK)
        status = measure_fit(t, surface, report);
    if (status == BATTEN_OK)
        *out = surface;
    else
        batten_surface_unref(surface);
    return status;
}

batten_status bat_grid_fit_finish(bat_grid_fit *t, batten_status status, double *u, double *v,
                                  batten_surface_fit_report *report, batten_surface **out)
{
    batten_surface_fit_report found = {.lambda = t->lambda,
                                       .freedom = t->freedom,
                                       .points_u = t->wanted[0],
                                       .points_v = t->wanted[1],
                                       .spread_u = t->spread[0],
                                       .spread_v = t->spread[1]};
    if (status == BATTEN_OK)
        status = make_surface(t, &found, out);
    if (status == BATTEN_OK && report)
        *report = found;
    double *wanted[2] = {u, v};
    for (int k = 0; k < 2; k++) {
        if (status == BATTEN_OK && wanted[k])
            memcpy(wanted[k], t->parameters[k], (size_t)t->count[k] * sizeof **wanted);
        bat_release(t->parameters[k]);
        bat_release(t->knots[k]);
    }
    bat_release(t->control);
    return status;
}
