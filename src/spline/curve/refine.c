/* Changes of a curve that keep its shape: knots, degree, parts. */
#include "spline/curve/curve.h"

#include <string.h>

static batten_status check_count(double count)
{
    if (count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%.0f control points would be needed; the limit is %d", count,
                        BAT_MAX_POINTS);
    return BATTEN_OK;
}

/* ---- knots ---- */

static batten_status refine_open(const batten_curve *curve, int count, const double *knots,
                                 batten_curve **out)
{
    bat_spline from, made;
    batten_status status = bat_curve_to_spline(curve, &from);
    if (status != BATTEN_OK)
        return status;
    status = bat_spline_insert(&from, count, knots, &made);
    return bat_curve_of_changed(status, curve, &from, &made, out);
}

/* A knot of the curve in another period, whose knots begin at `period`. */
static double copy_of_knot(const batten_curve *curve, const double *period, double knot,
                           double shift)
{
    const int k =
        bat_knots_span(curve->degree, curve->count, curve->knots, knot, BATTEN_FROM_RIGHT);
    return knot == curve->knots[k] ? period[k]
                                   : bat_min(bat_max(knot + shift, period[k]), period[k + 1]);
}

/* The knots of one period for `copies` periods from the first that is unwrapped on. A copy of a
 * knot that stands there is that knot; others stay between their neighbours. */
static void copy_to_periods(const batten_curve *curve, const bat_spline *unwrapped, int copies,
                            int count, const double *knots, double *out)
{
    const int p = curve->degree, m = curve->count - p;
    const double length = curve->knots[p + m] - curve->knots[p];
    for (int c = 0; c < copies; c++)
        for (int i = 0; i < count; i++) {
            const double shift = (c - copies / 2) * length;
            out[c * count + i] = copy_of_knot(curve, unwrapped->knots + c * m, knots[i], shift);
        }
}

static batten_status refine_unwrapped(const batten_curve *curve, const bat_spline *unwrapped,
                                      int copies, int count, const double *knots,
                                      batten_curve **out)
{
    double *all = bat_array3((size_t)copies, (size_t)count, sizeof *all);
    if (!all)
        return BATTEN_OUT_OF_MEMORY;
    copy_to_periods(curve, unwrapped, copies, count, knots, all);
    bat_spline made;
    batten_status status = bat_spline_insert(unwrapped, copies * count, all, &made);
    bat_release(all);
    if (status != BATTEN_OK)
        return status;
    const int p = curve->degree, m = curve->count - p;
    status = bat_curve_wrap(curve, &made, curve->knots[p], m + count, out);
    bat_spline_free(&made);
    return status;
}

static batten_status refine_periodic(const batten_curve *curve, int count, const double *knots,
                                     batten_curve **out)
{
    /* Points of the period bear on p knots beyond it: so many periods are refined on each side.
     */
    const int m = curve->count - curve->degree, more = (curve->degree + m - 1) / m;
    bat_spline unwrapped;
    batten_status status = check_count((2.0 * more + 1) * (m + count));
    if (status == BATTEN_OK)
        status = bat_curve_unwrap(curve, more, &unwrapped);
    if (status != BATTEN_OK)
        return status;
    status = refine_unwrapped(curve, &unwrapped, 2 * more + 1, count, knots, out);
    bat_spline_free(&unwrapped);
    return status;
}

/* What the end of the period is to be, its start is. */
static void seam_first(const batten_curve *curve, int count, double *knots)
{
    const batten_interval domain = batten_curve_domain(curve);
    int at_end = 0;
    while (at_end < count && knots[count - 1 - at_end] == domain.b)
        at_end++;
    memmove(knots + at_end, knots, (size_t)(count - at_end) * sizeof *knots);
    for (int i = 0; i < at_end; i++)
        knots[i] = domain.a;
}

static batten_status refine_checked(const batten_curve *curve, int count, double *knots,
                                    batten_curve **out)
{
    if (curve->periodic)
        seam_first(curve, count, knots);
    const batten_status status = bat_knots_check_insertion(
        curve->degree, curve->count, curve->knots, curve->periodic, count, knots);
    if (status != BATTEN_OK)
        return status;
    return curve->periodic ? refine_periodic(curve, count, knots, out)
                           : refine_open(curve, count, knots, out);
}

batten_status batten_curve_refine(const batten_curve *curve, int count, const double *knots,
                                  batten_curve **out)
{
    assert(curve && count >= 0 && (knots || count == 0) && out);
    batten_status status = check_count((double)curve->count + count);
    if (status == BATTEN_OK)
        status = bat_knots_check_insertion(curve->degree, curve->count, curve->knots,
                                           curve->periodic, count, knots);
    if (status != BATTEN_OK)
        return status;
    double *copy = bat_array((size_t)count, sizeof *copy);
    if (!copy)
        return BATTEN_OUT_OF_MEMORY;
    if (count > 0)
        memcpy(copy, knots, (size_t)count * sizeof *copy);
    status = refine_checked(curve, count, copy, out);
    bat_release(copy);
    return status;
}

batten_status batten_curve_insert_knot(const batten_curve *curve, double u, int times,
                                       batten_curve **out)
{
    assert(curve && out);
    double knots[BATTEN_MAX_DEGREE + 1];
    if (times < 1 || times > curve->degree + 1)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a knot cannot be inserted %d times into degree %d", times,
                        curve->degree);
    const batten_status status = bat_curve_place(curve, BATTEN_FROM_RIGHT, &u);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < times; i++)
        knots[i] = u;
    return refine_checked(curve, times, knots, out);
}

/* ---- degree ---- */

batten_status batten_curve_elevate(const batten_curve *curve, int by, batten_curve **out)
{
    assert(curve && out);
    if (by < 0 || curve->degree + by > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "degree %d cannot be raised by %d; the limit is %d",
                        curve->degree, by, BATTEN_MAX_DEGREE);
    const int p = curve->degree, m = curve->count - p;
    bat_spline from, made;
    batten_status status = check_count(((double)by + 1) * curve->count);
    if (status == BATTEN_OK)
        status = bat_curve_to_spline(curve, &from);
    if (status != BATTEN_OK)
        return status;
    status = bat_spline_elevate(&from, by, &made);
    if (status == BATTEN_OK) {
        const int distinct = batten_curve_spans(curve, NULL) - 1; /* in a period */
        status = curve->periodic
                     ? bat_curve_wrap(curve, &made, curve->knots[p], m + by * distinct, out)
                     : bat_curve_from_spline(curve, &from, 0, &made, out);
        bat_spline_free(&made);
    }
    bat_spline_free(&from);
    return status;
}

/* ---- parts ---- */

/* The spans that [a, b] touches, in the curve's own arrays: a part costs what it holds. */
static batten_curve view_spans(const batten_curve *curve, double a, double b)
{
    const int p = curve->degree;
    const int first = bat_knots_span(p, curve->count, curve->knots, a, BATTEN_FROM_LEFT) - p;
    const int last = bat_knots_span(p, curve->count, curve->knots, b, BATTEN_FROM_RIGHT);
    const size_t before = (size_t)first;
    return (batten_curve){.dimension = curve->dimension,
                          .degree = p,
                          .count = last + 1 - first,
                          .weight_scale = curve->weight_scale,
                          .points = curve->points + before * (size_t)curve->dimension,
                          .weights = curve->weights ? curve->weights + before : NULL,
                          .knots = curve->knots + before};
}

/* Rows of `like` that stay as they are keep their bits; `from` has the same rows, or others. */
static batten_status take_part(const batten_curve *like, const bat_spline *from, double a,
                               double b, batten_curve **out)
{
    bat_spline made;
    const batten_status status = bat_spline_subrange(from, a, b, &made);
    if (status != BATTEN_OK)
        return status;
    const bool same_rows = from->count == like->count;
    const int span =
        bat_knots_span(from->degree, from->count, from->knots, a, BATTEN_FROM_RIGHT);
    const batten_status put =
        bat_curve_from_spline(like, same_rows ? from : NULL, span - from->degree, &made, out);
    bat_spline_free(&made);
    return put;
}

static batten_status subrange(const batten_curve *curve, double a, double b, batten_curve **out)
{
    bat_spline from;
    if (curve->periodic && b > curve->knots[curve->count]) {
        batten_status status = bat_curve_unwrap(curve, 1, &from);
        if (status != BATTEN_OK)
            return status;
        status = take_part(curve, &from, a, b, out);
        bat_spline_free(&from);
        return status;
    }
    const batten_curve view = view_spans(curve, a, b);
    batten_status status = bat_curve_to_spline(&view, &from);
    if (status != BATTEN_OK)
        return status;
    status = take_part(&view, &from, a, b, out);
    bat_spline_free(&from);
    return status;
}

batten_status batten_curve_subrange(const batten_curve *curve, double a, double b,
                                    batten_curve **out)
{
    assert(curve && out);
    const batten_interval domain = batten_curve_domain(curve);
    batten_status status = bat_knots_clip(domain.a, domain.b, &a);
    if (status == BATTEN_OK)
        status = bat_knots_clip(domain.a,
                                curve->periodic ? a + (domain.b - domain.a) : domain.b, &b);
    if (status == BATTEN_OK && a >= b)
        status = bat_fail(BATTEN_OUT_OF_DOMAIN, "the part from %.17g to %.17g is empty", a, b);
    return status == BATTEN_OK ? subrange(curve, a, b, out) : status;
}

batten_status batten_curve_clamp(const batten_curve *curve, batten_curve **out)
{
    assert(curve && out);
    const batten_interval domain = batten_curve_domain(curve);
    return subrange(curve, domain.a, domain.b, out);
}

static batten_status hand_over_parts(const batten_curve *curve, const bat_spline *from,
                                     const bat_spline *first, const bat_spline *second,
                                     batten_curve **left, batten_curve **right)
{
    const int p = from->degree;
    const int span =
        bat_knots_span(p, from->count, from->knots, second->knots[p], BATTEN_FROM_RIGHT);
    batten_curve *low, *high;
    batten_status status = bat_curve_from_spline(curve, from, 0, first, &low);
    if (status != BATTEN_OK)
        return status;
    status = bat_curve_from_spline(curve, from, span - p, second, &high);
    if (status != BATTEN_OK) {
        batten_curve_unref(low);
        return status;
    }
    *left = low;
    *right = high;
    return BATTEN_OK;
}

batten_status batten_curve_split(const batten_curve *curve, double u, batten_curve **left,
                                 batten_curve **right)
{
    assert(curve && left && right);
    const batten_interval domain = batten_curve_domain(curve);
    if (!isfinite(u))
        return bat_fail(BATTEN_NOT_FINITE, "the parameter is %g", u);
    if (u <= domain.a || u >= domain.b)
        return bat_fail(BATTEN_OUT_OF_DOMAIN,
                        "a curve with the domain [%.17g, %.17g] cannot be cut at %.17g",
                        domain.a, domain.b, u);
    bat_spline from, first, second;
    batten_status status = bat_curve_to_spline(curve, &from);
    if (status != BATTEN_OK)
        return status;
    status = bat_spline_split(&from, u, &first, &second);
    if (status == BATTEN_OK) {
        status = hand_over_parts(curve, &from, &first, &second, left, right);
        bat_spline_free(&first);
        bat_spline_free(&second);
    }
    bat_spline_free(&from);
    return status;
}

batten_status batten_curve_to_bezier(const batten_curve *curve, batten_curve **out)
{
    assert(curve && out);
    bat_spline from, made;
    batten_status status = check_count((double)curve->count * curve->degree + 1);
    if (status == BATTEN_OK)
        status = bat_curve_to_spline(curve, &from);
    if (status != BATTEN_OK)
        return status;
    status = bat_spline_to_bezier(&from, &made);
    return bat_curve_of_changed(status, curve, &from, &made, out);
}
