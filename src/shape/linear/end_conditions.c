/* What is asked at the ends of a curve through points, as plain derivatives. */
#include "shape/linear/end_conditions.h"
#include "numeric/vector.h"
#include "shape/linear/linear_solve.h"

#include <string.h>

/* One end, seen from there: its first points, the first step, and how the curve runs. */
typedef struct {
    int dimension, count;
    const double *a, *b, *c;
    double step;
    double sign; /* 1 at the start; -1 at the end, where the curve runs from b to a */
    const char *name;
} end_view;

/* The derivative along `direction` that is 1 for each unit of the chord. */
static batten_status directed(const end_view *e, const double *direction, double *value)
{
    const double zero[3] = {0, 0, 0};
    const double size = bat_distance(e->dimension, zero, direction);
    if (!(size > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the direction at the %s has no length", e->name);
    const double speed = bat_distance(e->dimension, e->a, e->b) / e->step;
    for (int k = 0; k < e->dimension; k++)
        value[k] = direction[k] / size * speed;
    return BATTEN_OK;
}

/* The tangent at a of the circle through a, b, c, as long as the arc to b is for the step;
 * false when there is no circle. */
static bool circle(const end_view *e, double *value)
{
    const int d = e->dimension;
    double tangent[3] = {0, 0, 0}, chord[3] = {0, 0, 0}, zero[3] = {0, 0, 0};
    if (e->count == 2)
        return false;
    const double ab = bat_distance(d, e->a, e->b), ca = bat_distance(d, e->c, e->a);
    if (!(ab > 0 && ca > 0))
        return false;
    for (int k = 0; k < d; k++) {
        chord[k] = (e->b[k] - e->a[k]) / ab;
        tangent[k] = chord[k] + (e->a[k] - e->c[k]) / ca * (ab / ca);
    }
    const double size = bat_distance(d, zero, tangent);
    if (!(size > 0))
        return false;
    double sum[3] = {0, 0, 0}, difference[3] = {0, 0, 0};
    for (int k = 0; k < d; k++) {
        sum[k] = tangent[k] / size + chord[k];
        difference[k] = tangent[k] / size - chord[k];
    }
    const double angle =
        2 * bat_atan2(bat_distance(d, zero, difference), bat_distance(d, zero, sum));
    const double arc = angle > 0 ? ab * angle / bat_sin(angle) : ab;
    for (int k = 0; k < d; k++)
        value[k] = e->sign * tangent[k] / size * arc / e->step;
    return isfinite(arc);
}

static batten_status resolve_end(const end_view *e, const batten_end *end,
                                 batten_end_kind *kind, double *value)
{
    *kind = end->kind;
    if (end->kind == BATTEN_END_CIRCLE)
        *kind = circle(e, value) ? BATTEN_END_CLAMPED : BATTEN_END_BESSEL;
    const bool has_vector = end->kind == BATTEN_END_CLAMPED ||
                            end->kind == BATTEN_END_DIRECTION ||
                            end->kind == BATTEN_END_SECOND || end->kind == BATTEN_END_CURVATURE;
    if (!has_vector)
        return BATTEN_OK;
    if (bat_first_not_finite(end->vector, (size_t)e->dimension) < (size_t)e->dimension)
        return bat_fail(BATTEN_NOT_FINITE, "the vector at the %s is not finite", e->name);
    if (e->dimension == 1 && end->kind == BATTEN_END_CURVATURE)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curvature at the %s needs a plane or space",
                        e->name);
    memcpy(value, end->vector, (size_t)e->dimension * sizeof *value);
    if (end->kind == BATTEN_END_DIRECTION) {
        *kind = BATTEN_END_CLAMPED;
        return directed(e, end->vector, value);
    }
    if (end->kind == BATTEN_END_CURVATURE)
        *kind = BATTEN_END_SECOND;
    return BATTEN_OK;
}

batten_status bat_ends_resolve(batten_points points, const double *parameters,
                               const batten_end ends[2], bat_ends *out)
{
    const int d = points.dimension, n = points.count;
    const double *P = points.at, *Q = P + (size_t)(n - 1) * (size_t)d, *u = parameters;
    const int third = n > 2 ? 2 * d : d;
    const end_view start = {d, n, P, P + d, P + third, u[1] - u[0], 1, "start"};
    const end_view end = {d, n, Q, Q - d, Q - third, u[n - 1] - u[n - 2], -1, "end"};
    batten_status status = resolve_end(&start, &ends[0], &out->kinds[0], out->values[0]);
    if (status == BATTEN_OK)
        status = resolve_end(&end, &ends[1], &out->kinds[1], out->values[1]);
    return status;
}

/* The slope of Bessel's parabola at an end; of two points that of the line. */
static void bessel(batten_points points, const double *u, int end, double *slope)
{
    const int d = points.dimension, n = points.count;
    const size_t at = (size_t)d, last = (size_t)(n - 1) * at;
    const double *a = end ? points.at + last : points.at, *b = end ? a - at : a + at;
    const double h0 = end ? u[n - 1] - u[n - 2] : u[1] - u[0], sign = end ? -1 : 1;
    if (n > 2) {
        const double h[2] = {h0, end ? u[n - 2] - u[n - 3] : u[2] - u[1]};
        bat_bessel_slope(at, h, (const double *const[]){a, b, end ? b - at : b + at}, slope);
    }
    for (int k = 0; k < d; k++)
        slope[k] = sign * (n > 2 ? slope[k] : (b[k] - a[k]) / h0);
}

batten_status bat_ends_plain(batten_points points, const double *parameters,
                             const batten_end ends[2], const char *what, bat_ends *out)
{
    const batten_status status = bat_ends_resolve(points, parameters, ends, out);
    if (status != BATTEN_OK)
        return status;
    for (int e = 0; e < 2; e++) {
        const batten_end_kind kind = out->kinds[e];
        if (kind == BATTEN_END_BESSEL) {
            bessel(points, parameters, e, out->values[e]);
            out->kinds[e] = BATTEN_END_CLAMPED;
        } else if (kind == BATTEN_END_NATURAL) {
            memset(out->values[e], 0, sizeof out->values[e]);
            out->kinds[e] = BATTEN_END_SECOND;
        } else if (kind != BATTEN_END_CLAMPED && kind != BATTEN_END_SECOND &&
                   kind != BATTEN_END_PARABOLIC)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "%s have no not-a-knot, fair or curvature ends; the %s asks for "
                            "one",
                            what, e ? "end" : "start");
    }
    return BATTEN_OK;
}
