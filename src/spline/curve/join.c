/* Two curves end to end. */
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <string.h>

/* The curve clamped, of this degree, and rational when wanted. */
static batten_status prepare(const batten_curve *curve, int degree, bool rational,
                             batten_curve **out)
{
    batten_curve *clamped, *elevated;
    batten_status status = batten_curve_clamp(curve, &clamped);
    if (status != BATTEN_OK)
        return status;
    status = batten_curve_elevate(clamped, degree - curve->degree, &elevated);
    batten_curve_unref(clamped);
    if (status != BATTEN_OK || !rational || elevated->weights) {
        if (status == BATTEN_OK)
            *out = elevated;
        return status;
    }
    status = batten_curve_to_rational(elevated, out);
    batten_curve_unref(elevated);
    return status;
}

static batten_status check_gap(const batten_curve *first, const batten_curve *second,
                               double tolerance)
{
    const int d = first->dimension;
    const double *end = first->points + (first->count - 1) * d;
    const double gap = bat_distance(d, end, second->points);
    if (gap > tolerance)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the end of the first curve and the start of the second are %g apart, "
                        "more than %g",
                        gap, tolerance);
    return BATTEN_OK;
}

/* first, then second, which gives up its first point and is moved and weighted to fit. */
static void fill_joined(const batten_curve *first, const batten_curve *second,
                        batten_curve *made)
{
    const int p = made->degree, n = first->count, m = second->count;
    const size_t d = (size_t)made->dimension;
    memcpy(made->points, first->points, (size_t)n * d * sizeof *made->points);
    memcpy(made->points + (size_t)n * d, second->points + d,
           (size_t)(m - 1) * d * sizeof *made->points);
    double *joint = made->points + (size_t)(n - 1) * d;
    for (size_t k = 0; k < d; k++)
        joint[k] += (second->points[k] - joint[k]) / 2;
    if (made->weights) {
        memcpy(made->weights, first->weights, (size_t)n * sizeof *made->weights);
        const double factor = first->weights[n - 1] / second->weights[0];
        for (int i = 1; i < m; i++)
            made->weights[n - 1 + i] =
                factor == 1 ? second->weights[i] : second->weights[i] * factor;
    }
    memcpy(made->knots, first->knots, (size_t)(n + p) * sizeof *made->knots);
    const double end = first->knots[n], start = second->knots[p];
    for (int i = p + 1; i <= m + p; i++)
        made->knots[n - 1 + i] =
            end == start ? second->knots[i] : end + (second->knots[i] - start);
}

/* Moving may join what was apart. */
static batten_status check_moved(const batten_curve *second, const batten_curve *made)
{
    const int p = made->degree, m = second->count, shift = made->count - m;
    for (int i = p + 1; i <= m + p; i++)
        if (second->knots[i] > second->knots[i - 1] &&
            made->knots[shift + i] <= made->knots[shift + i - 1])
            return bat_fail(
                BATTEN_BAD_KNOTS,
                "knots %.17g and %.17g of the second curve cannot be told apart at %.17g",
                second->knots[i - 1], second->knots[i], made->knots[shift + i]);
    return bat_knots_check(p, made->count, made->knots, "joined knot");
}

static batten_status join_prepared(const batten_curve *first, const batten_curve *second,
                                   double tolerance, batten_curve **out)
{
    const double count = (double)first->count + second->count - 1;
    batten_status status = check_gap(first, second, tolerance);
    if (status == BATTEN_OK && count > BAT_MAX_MADE_POINTS)
        status = bat_fail(BATTEN_TOO_LARGE,
                          "the joined curve would have %.0f control points; the limit is %d",
                          count, BAT_MAX_MADE_POINTS);
    batten_curve *made = NULL;
    if (status == BATTEN_OK)
        status =
            bat_curve_make_like(first, first->degree, first->count + second->count - 1, &made);
    if (status != BATTEN_OK)
        return status;
    fill_joined(first, second, made);
    status = check_moved(second, made);
    if (status == BATTEN_OK)
        return bat_curve_finish(made, out);
    batten_curve_unref(made);
    return status;
}

batten_status batten_curve_join(const batten_curve *first, const batten_curve *second,
                                double tolerance, batten_curve **out)
{
    assert(first && second && out);
    if (!(tolerance >= 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", tolerance);
    if (first->dimension != second->dimension)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the curves have %d and %d dimensions",
                        first->dimension, second->dimension);
    const int degree = bat_max_int(first->degree, second->degree);
    const bool rational = first->weights || second->weights;
    batten_curve *a, *b;
    batten_status status = prepare(first, degree, rational, &a);
    if (status != BATTEN_OK)
        return status;
    status = prepare(second, degree, rational, &b);
    if (status == BATTEN_OK) {
        status = join_prepared(a, b, tolerance, out);
        batten_curve_unref(b);
    }
    batten_curve_unref(a);
    return status;
}

batten_status bat_curves_chain(int count, batten_curve *const *curves, double tolerance,
                               batten_curve **out)
{
    batten_curve **waiting = bat_array((size_t)count, sizeof *waiting);
    if (!waiting)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count; i++)
        waiting[i] = batten_curve_ref(curves[i]);
    for (int left = count; status == BATTEN_OK && left > 1; left = (left + 1) / 2)
        for (int i = 0; status == BATTEN_OK && 2 * i + 1 < left + 1; i++) {
            batten_curve *joined = NULL;
            batten_curve *a = waiting[2 * i], *b = 2 * i + 1 < left ? waiting[2 * i + 1] : NULL;
            if (b)
                status = batten_curve_join(a, b, tolerance, &joined);
            if (status != BATTEN_OK)
                break;
            waiting[2 * i] = NULL;
            if (b) {
                waiting[2 * i + 1] = NULL;
                batten_curve_unref(b);
                batten_curve_unref(a);
            }
            waiting[i] = b ? joined : a;
        }
    if (status == BATTEN_OK) {
        *out = waiting[0];
        waiting[0] = NULL;
    }
    for (int i = 0; i < count; i++)
        batten_curve_unref(waiting[i]);
    bat_release(waiting);
    return status;
}
