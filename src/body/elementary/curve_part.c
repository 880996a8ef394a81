/* The part of a curve between two points near it. */
#include "body/elementary/elementary.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/nearest.h>

typedef struct {
    const batten_curve *curve;
    batten_interval domain;
    double start[3], end[3];
    bool closed;
    double tolerance;
} whole;

static batten_status look_at_whole(const batten_curve *curve, double tolerance, whole *out)
{
    *out = (whole){.curve = curve, .tolerance = tolerance};
    out->domain = batten_curve_domain(curve);
    batten_status status = batten_curve_evaluate(curve, out->domain.a, 0, out->start);
    if (status == BATTEN_OK)
        status =
            batten_curve_evaluate_side(curve, out->domain.b, BATTEN_FROM_LEFT, 0, out->end);
    out->closed =
        batten_curve_is_periodic(curve) || bat_distance(3, out->start, out->end) <= tolerance;
    return status;
}

/* The parameter of a point; an end that is near enough is taken first, `begins` says which. */
static batten_status locate(const whole *of, const double point[3], bool begins, double *at,
                            double *miss)
{
    const double to_start = bat_distance(3, point, of->start),
                 to_end = bat_distance(3, point, of->end);
    const bool start = to_start <= of->tolerance, end = to_end <= of->tolerance;
    if (start || end) {
        const bool take_start = start && (begins || !end);
        *at = take_start ? of->domain.a : of->domain.b;
        *miss = take_start ? to_start : to_end;
        return BATTEN_OK;
    }
    batten_deviation foot;
    const batten_status status = batten_curve_deviation(
        of->curve, (batten_points){batten_curve_dimension(of->curve), 1, point}, NULL, NULL,
        NULL, &foot);
    if (status == BATTEN_OK) {
        *at = foot.at[0];
        *miss = foot.max;
    }
    return status;
}

/* From `a` over the seam to `b` <= a. */
static batten_status over_seam(const whole *of, double a, double b, batten_curve **out)
{
    batten_curve *first = NULL, *second = NULL;
    if (batten_curve_is_periodic(of->curve))
        return batten_curve_subrange(of->curve, a, b + (of->domain.b - of->domain.a), out);
    batten_status status = batten_curve_subrange(of->curve, a, of->domain.b, &first);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(of->curve, of->domain.a, b, &second);
    if (status == BATTEN_OK) /* closed within the tolerance; a rounding more is no matter */
        status = batten_curve_join(first, second, of->tolerance * (1 + 1e-9), out);
    batten_curve_unref(first);
    batten_curve_unref(second);
    return status;
}

/* Between parameters; of an open curve it runs on from the lesser, and *turned says that it
 * came second. */
static batten_status between(const whole *of, double a, double b, bool *turned,
                             batten_curve **out)
{
    const batten_interval d = of->domain;
    *turned = false;
    if (a == d.a && b == d.b) {
        *out = batten_curve_ref(of->curve);
        return BATTEN_OK;
    }
    if (of->closed && a == d.b)
        a = d.a;
    if (of->closed && b == d.a)
        b = d.b;
    if (a < b)
        return batten_curve_subrange(of->curve, a, b, out);
    if (of->closed)
        return over_seam(of, a, b, out);
    if (a == b)
        return bat_fail(BATTEN_COINCIDENT,
                        "both ends of the part fall on the parameter %.17g of the curve", a);
    *turned = true;
    if (b == d.a && a == d.b) {
        *out = batten_curve_ref(of->curve);
        return BATTEN_OK;
    }
    return batten_curve_subrange(of->curve, b, a, out);
}

/* From p to q as the curve runs. */
static batten_status take_part_between(const batten_curve *curve, const double p[3],
                                       const double q[3], double tolerance, bool *turned,
                                       batten_curve **out, double *miss)
{
    whole of;
    double a = 0, b = 0, miss_p = 0, miss_q = 0;
    batten_status status = look_at_whole(curve, tolerance, &of);
    if (status == BATTEN_OK)
        status = locate(&of, p, true, &a, &miss_p);
    if (status == BATTEN_OK)
        status = locate(&of, q, false, &b, &miss_q);
    if (status != BATTEN_OK)
        return status;
    if (of.closed && bat_distance(3, p, q) <= tolerance) {
        const bool at_seam =
            a == of.domain.a || a == of.domain.b || b == of.domain.a || b == of.domain.b;
        a = at_seam ? of.domain.a : a;
        b = at_seam ? of.domain.b : a;
    }
    status = between(&of, a, b, turned, out);
    if (status == BATTEN_OK)
        *miss = bat_max(miss_p, miss_q);
    return status;
}

batten_status bat_curve_part(const batten_curve *curve, const double p[3], const double q[3],
                             bool forward, double tolerance, batten_curve **out, double *miss)
{
    assert(curve && p && q && out && miss);
    if (batten_curve_dimension(curve) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve of dimension %d has no points in space",
                        batten_curve_dimension(curve));
    if (bat_first_not_finite(p, 3) < 3 || bat_first_not_finite(q, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE, "the ends (%g, %g, %g) and (%g, %g, %g) of the part",
                        p[0], p[1], p[2], q[0], q[1], q[2]);
    batten_curve *running = NULL;
    double largest = 0;
    bool turned = false;
    batten_status status = take_part_between(curve, forward ? p : q, forward ? q : p, tolerance,
                                             &turned, &running, &largest);
    if (status != BATTEN_OK)
        return status;
    if (turned == forward) /* it runs from q to p */
        status = batten_curve_reverse(running, out);
    else
        *out = batten_curve_ref(running);
    batten_curve_unref(running);
    if (status == BATTEN_OK)
        *miss = largest;
    return status;
}
