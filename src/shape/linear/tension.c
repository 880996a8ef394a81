/* Splines in tension through points: the tensions a rule asks for, and the chain made of them. */
#include "shape/linear/tension.h"
#include "numeric/banded.h"
#include "shape/linear/end_conditions.h"
#include "shape/points/parametrize.h"
#include "spline/chain/chain.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

batten_chain_tension_options batten_chain_tension_defaults(void)
{
    return (batten_chain_tension_options){.size = sizeof(batten_chain_tension_options),
                                          .parameters = BATTEN_CHORD,
                                          .start = {.kind = BATTEN_END_NATURAL},
                                          .end = {.kind = BATTEN_END_NATURAL},
                                          .slack = 0.01};
}

batten_status bat_tension_check_slopes(const bat_tension *t)
{
    const int d = t->dimension;
    for (int i = t->closed ? 0 : 1; i < t->spans; i++) {
        const int before = i ? i - 1 : t->spans - 1, previous = i ? i - 1 : t->count - 1;
        double left[3], right[3];
        bat_tension_slope(t, before, 1, left);
        bat_tension_slope(t, i, 0, right);
        for (int k = 0; k < d; k++) {
            const double M = fabs(t->moments[i * d + k]),
                         L = fabs(t->moments[previous * d + k]),
                         N = fabs(t->moments[bat_tension_next(t, i) * d + k]);
            const double size = fabs(t->slopes[before * d + k]) + fabs(t->slopes[i * d + k]) +
                                t->b[before] * L + (t->a[before] + t->a[i]) * M + t->b[i] * N;
            if (!(fabs(left[k] - right[k]) <= 32 * DBL_EPSILON * size + DBL_MIN))
                return bat_fail(BATTEN_TOLERANCE_NOT_MET, "the slope jumps by %g at point %d",
                                right[k] - left[k], i + 1);
        }
    }
    return BATTEN_OK;
}

/* ---- from points to a chain ---- */

static batten_status allocate(bat_tension *t)
{
    const size_t d = (size_t)t->dimension, n = (size_t)t->count, m = (size_t)t->spans;
    t->sigma = bat_array(m, sizeof *t->sigma);
    t->slopes = bat_array3(m, d, sizeof *t->slopes);
    t->a = bat_array(m, sizeof *t->a);
    t->b = bat_array(m, sizeof *t->b);
    t->matrix = bat_array3(n, 3, sizeof *t->matrix);
    t->moments = bat_array3(n, d, sizeof *t->moments);
    return t->sigma && t->slopes && t->a && t->b && t->matrix && t->moments
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

void bat_tension_end(bat_tension *t)
{
    bat_release(t->u);
    bat_release(t->sigma);
    bat_release(t->slopes);
    bat_release(t->a);
    bat_release(t->b);
    bat_release(t->matrix);
    bat_release(t->moments);
}

static batten_status fill(bat_tension *t, const batten_chain_tension_options *o)
{
    const int d = t->dimension;
    const double mean = (t->u[t->spans] - t->u[0]) / t->spans;
    for (int i = 0; i < t->spans; i++) {
        const double tension = o->tensions ? o->tensions[i] : o->tension;
        const double h = t->u[i + 1] - t->u[i];
        if (!(tension >= 0 && isfinite(tension)))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the tension of span %d is %g, not 0 or more",
                            i + 1, tension);
        t->sigma[i] = t->rational ? tension : tension / mean;
        for (int k = 0; k < d; k++)
            t->slopes[i * d + k] =
                (t->points[bat_tension_next(t, i) * d + k] - t->points[i * d + k]) / h;
        if (!isfinite(t->sigma[i] * h) ||
            bat_first_not_finite(t->slopes + i * d, (size_t)d) < (size_t)d)
            return bat_fail(BATTEN_OVERFLOW, "tension or slope of span %d are too large",
                            i + 1);
    }
    return BATTEN_OK;
}

batten_status bat_tension_begin(bat_tension *t, const batten_chain_tension_options *o)
{
    const batten_end ends[2] = {o->start, o->end};
    if (!(o->slack > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the slack is %g, not above 0", o->slack);
    batten_status status = bat_parameters_of((batten_points){t->dimension, t->count, t->points},
                                             o->parameters, o->given, o->closed, &t->u);
    if (status == BATTEN_OK && !o->closed)
        status = bat_ends_plain((batten_points){t->dimension, t->count, t->points}, t->u, ends,
                                "splines in tension", &t->ends);
    if (status == BATTEN_OK)
        status = allocate(t);
    return status == BATTEN_OK ? fill(t, o) : status;
}

static void set_span(const bat_tension *t, int i, batten_span *span)
{
    const int d = t->dimension, next = bat_tension_next(t, i);
    const size_t row = (size_t)d * sizeof(double);
    span->kind = BATTEN_SPAN_TENSION;
    span->length = t->u[i + 1] - t->u[i];
    span->tension = t->sigma[i];
    memcpy(span->start, t->points + i * d, row);
    memcpy(span->end, t->points + next * d, row);
    memcpy(span->bend[0], t->moments + i * d, row);
    memcpy(span->bend[1], t->moments + next * d, row);
}

static batten_status make_chain(const bat_tension *t, batten_chain **out)
{
    const int d = t->dimension;
    batten_span *spans = bat_array((size_t)t->spans, sizeof *spans);
    if (!spans)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < t->spans; i++)
        set_span(t, i, &spans[i]);
    const batten_status status =
        batten_chain_create(&(batten_chain_parts){d, t->spans, spans, t->u, t->closed}, 0, out);
    bat_release(spans);
    return status;
}

batten_status batten_chain_tension(batten_points points,
                                   const batten_chain_tension_options *options,
                                   double *parameters, batten_chain **out)
{
    assert(points.at && out);
    batten_chain_tension_options chosen = batten_chain_tension_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_chain_tension_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_chain_tension_options *o = &chosen;
    status = bat_points_check(points.dimension, points.count, points.at, o->closed ? 3 : 2);
    if (status != BATTEN_OK)
        return status;
    bat_tension t = {.dimension = points.dimension,
                     .count = points.count,
                     .spans = o->closed ? points.count : points.count - 1,
                     .closed = o->closed,
                     .points = points.at};
    status = bat_tension_begin(&t, o);
    if (status == BATTEN_OK)
        status = bat_tension_solve(&t);
    if (status == BATTEN_OK && o->rule == BATTEN_TENSION_CONVEX)
        status = bat_tension_convex(&t, o->slack);
    if (status == BATTEN_OK && o->rule == BATTEN_TENSION_MONOTONE)
        status = bat_tension_monotone(&t, o->slack);
    if (status == BATTEN_OK)
        status = bat_tension_check_slopes(&t);
    if (status == BATTEN_OK)
        status = make_chain(&t, out);
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, t.u, (size_t)points.count * sizeof *parameters);
    bat_tension_end(&t);
    return status;
}
