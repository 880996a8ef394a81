/* Changes that may move a curve a little: fewer knots, lower degree. */
#include "numeric/vector.h"
#include "spline/curve/curve.h"

batten_status bat_tolerance_check(double tolerance)
{
    if (!(tolerance >= 0 && isfinite(tolerance)))
        return bat_fail(isfinite(tolerance) ? BATTEN_BAD_ARGUMENT : BATTEN_NOT_FINITE,
                        "the tolerance is %g; it must not be negative", tolerance);
    return BATTEN_OK;
}

/*
 * How far a rational curve moves when a row (w x .., w) moves by e: with the new point P' and
 * the old weight w, P - P' = (dA - P' dw) / w, so at most e (1 + |P'|) / w. Points stay within
 * `tolerance` of the old ones.
 */
static double moved_per_row(const batten_curve *curve, double tolerance)
{
    double largest = 0, least = HUGE_VAL;
    for (int i = 0; curve->weights && i < curve->count; i++) {
        largest =
            bat_max(largest, bat_norm(curve->dimension, curve->points + i * curve->dimension));
        least = bat_min(least, curve->weights[i] * curve->weight_scale);
    }
    return curve->weights ? (1 + largest + tolerance) / least : 1;
}

/* What a step on splines is asked for and answers. */
typedef struct {
    double u, tolerance, error;
    int times, removed, degree;
} request;

typedef batten_status (*step)(const bat_spline *spline, size_t group, request *asked,
                              bat_spline *out);

static batten_status remove_one(const bat_spline *spline, size_t group, request *asked,
                                bat_spline *out)
{
    return bat_spline_remove(spline, asked->u, asked->times, group, asked->tolerance,
                             &asked->removed, &asked->error, out);
}

static batten_status remove_all(const bat_spline *spline, size_t group, request *asked,
                                bat_spline *out)
{
    return bat_spline_remove_all(spline, group, asked->tolerance, &asked->removed,
                                 &asked->error, out);
}

static batten_status reduce(const bat_spline *spline, size_t group, request *asked,
                            bat_spline *out)
{
    return bat_spline_reduce(spline, asked->degree, group, asked->tolerance, &asked->error,
                             out);
}

/* Work on the rows of an open curve, with the tolerance as it is there. */
static batten_status apply_open(const batten_curve *curve, step make, request *asked,
                                batten_curve **out)
{
    bat_spline from, made;
    batten_status status = bat_curve_to_spline(curve, &from);
    if (status != BATTEN_OK)
        return status;
    const double factor = moved_per_row(curve, asked->tolerance);
    asked->tolerance /= factor;
    status = make(&from, bat_curve_width(curve), asked, &made);
    asked->error *= factor;
    return bat_curve_of_changed(status, curve, &from, &made, out);
}

static batten_status apply_step(const batten_curve *curve, step make, request *asked,
                                batten_curve **out)
{
    if (!curve->periodic)
        return apply_open(curve, make, asked, out);
    batten_curve *clamped;
    batten_status status = batten_curve_clamp(curve, &clamped);
    if (status != BATTEN_OK)
        return status;
    status = apply_open(clamped, make, asked, out);
    batten_curve_unref(clamped);
    return status;
}

static batten_status removal(const batten_curve *curve, step make, request asked, int *removed,
                             double *error, batten_curve **out)
{
    batten_status status = bat_tolerance_check(asked.tolerance);
    if (status == BATTEN_OK)
        status = apply_step(curve, make, &asked, out);
    if (status == BATTEN_OK && removed)
        *removed = asked.removed;
    if (status == BATTEN_OK && error)
        *error = asked.error;
    return status;
}

batten_status batten_curve_remove_knot(const batten_curve *curve, batten_knot knot,
                                       double tolerance, int *removed, double *error,
                                       batten_curve **out)
{
    assert(curve && out);
    const batten_interval domain = batten_curve_domain(curve);
    if (knot.times < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a knot cannot be removed %d times", knot.times);
    if (!(knot.at > domain.a && knot.at < domain.b) ||
        bat_knots_multiplicity(curve->degree, curve->count, curve->knots, knot.at) == 0)
        return bat_fail(isfinite(knot.at) ? BATTEN_NOT_FOUND : BATTEN_NOT_FINITE,
                        "%.17g is no knot inside the domain [%.17g, %.17g]", knot.at, domain.a,
                        domain.b);
    return removal(curve, remove_one,
                   (request){.u = knot.at, .times = knot.times, .tolerance = tolerance},
                   removed, error, out);
}

batten_status batten_curve_remove_knots(const batten_curve *curve, double tolerance,
                                        int *removed, double *error, batten_curve **out)
{
    assert(curve && out);
    return removal(curve, remove_all, (request){.tolerance = tolerance}, removed, error, out);
}

batten_status batten_curve_reduce(const batten_curve *curve, int degree, double tolerance,
                                  double *error, batten_curve **out)
{
    assert(curve && out);
    if (degree < 1 || degree > curve->degree)
        return bat_fail(BATTEN_BAD_DEGREE, "degree %d cannot be reduced to %d", curve->degree,
                        degree);
    return removal(curve, reduce, (request){.degree = degree, .tolerance = tolerance}, NULL,
                   error, out);
}
