/*
 * The clothoid between two points with given directions, by Newton's method on its rate of
 * curvature from a fitted first guess. Source: [BF15].
 */
#include "shape/bent/spiral.h"
#include "numeric/fresnel.h"
#include "numeric/vector.h"
#include "spline/chain/chain.h"
#include <batten/bent.h>

#include <float.h>

/* A fit of the solution over all angles: it is odd in both, and even under their exchange. */
static double first_guess(double alpha, double beta)
{
    static const double c[] = {2.989696028701907,  0.716228953608281, -0.458969738821509,
                               -0.502821153340377, 0.261062141752652, -0.045854475238709};
    const double x = alpha / BAT_PI, y = beta / BAT_PI, xy = x * y, z = x * x + y * y;
    return (alpha + beta) *
           (c[0] + xy * (c[1] + xy * c[2]) + (c[3] + xy * c[4]) * z + c[5] * z * z);
}

static void find_moments(double alpha, double beta, double A, double *x, double *y)
{
    const double theta[BAT_FRESNEL_DEGREE + 1] = {alpha, beta - alpha - A, A};
    bat_fresnel(theta, 3, x, y);
}

/* The partial derivatives of Y0 = 0, solved for those of A, and then those of X0. */
static void differentiate(const double *x, const double *y, bat_clothoid *out)
{
    const double by_A = x[2] - x[1];
    out->A_alpha = -(x[0] - x[1]) / by_A;
    out->A_beta = -x[1] / by_A;
    out->chord = x[0];
    out->chord_alpha = (y[1] - y[0]) - (y[2] - y[1]) * out->A_alpha;
    out->chord_beta = -y[1] - (y[2] - y[1]) * out->A_beta;
}

batten_status bat_clothoid_solve(double alpha, double beta, bat_clothoid *out)
{
    enum { STEPS = 20 };
    double A = first_guess(alpha, beta), x[3], y[3];
    const double rounding = 2 * DBL_EPSILON * (fabs(alpha) + fabs(beta));
    find_moments(alpha, beta, A, x, y);
    out->steps = 0;
    while (fabs(y[0]) > rounding && out->steps < STEPS) {
        const double before = fabs(y[0]);
        A -= y[0] / (x[2] - x[1]);
        find_moments(alpha, beta, A, x, y);
        out->steps++;
        /* Near the end only rounding is left. */
        if (fabs(y[0]) <= 16 * rounding && fabs(y[0]) >= before / 2)
            break;
    }
    if (!(fabs(y[0]) <= 64 * rounding && x[0] > 0))
        return bat_fail(BATTEN_SINGULAR_SYSTEM,
                        "no clothoid was found that leaves and reaches its chord at %g and %g "
                        "radians",
                        alpha, beta);
    out->A = A;
    differentiate(x, y, out);
    return BATTEN_OK;
}

/* ---- public ---- */

/* The largest angle at which both ends may stand to the chord. */
static const double limit = 0.98 * BAT_PI;

static double end_error(const batten_span *span, const double *end, double end_angle)
{
    double at[4];
    bat_span_spiral(2, span, span->length, 1, at);
    const double turn = remainder(bat_atan2(at[3], at[2]) - end_angle, 2 * BAT_PI);
    return bat_max(bat_distance(2, at, end), fabs(turn) * span->length);
}

batten_status batten_spiral_hermite(batten_heading start, batten_heading end, int *steps,
                                    double *error, batten_span *out)
{
    assert(start.point && end.point && out);
    const double q[2] = {end.point[0] - start.point[0], end.point[1] - start.point[1]},
                 l = bat_norm(2, q);
    if (!isfinite(start.angle) || !isfinite(end.angle) ||
        bat_first_not_finite(start.point, 2) < 2 || bat_first_not_finite(end.point, 2) < 2)
        return bat_fail(BATTEN_NOT_FINITE, "a point or a direction is not finite");
    if (l == 0)
        return bat_fail(BATTEN_COINCIDENT, "start and end coincide");
    if (!isfinite(l))
        return bat_fail(BATTEN_OVERFLOW, "start and end are too far apart");
    const double phi = bat_atan2(q[1], q[0]);
    const double alpha = remainder(start.angle - phi, 2 * BAT_PI);
    const double beta = remainder(end.angle - phi, 2 * BAT_PI);
    if (fabs(alpha) > limit && fabs(beta) > limit)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "both directions, %g and %g radians from the chord, lead away from the "
                        "other end; one must stay below %g",
                        alpha, beta, limit);
    bat_clothoid c;
    const batten_status status = bat_clothoid_solve(alpha, beta, &c);
    if (status != BATTEN_OK)
        return status == BATTEN_SINGULAR_SYSTEM ? BATTEN_TOLERANCE_NOT_MET : status;
    const double length = l / c.chord;
    const batten_span span = {
        .kind = BATTEN_SPAN_SPIRAL,
        .length = length,
        .start = {start.point[0], start.point[1]},
        .angle = start.angle,
        .curvature = {(beta - alpha - c.A) / length, 2 * c.A / length / length}};
    const double off = end_error(&span, end.point, end.angle);
    if (!isfinite(length) || bat_first_not_finite(span.curvature, 4) < 4 || !isfinite(off))
        return bat_fail(BATTEN_OVERFLOW, "the curvature is too large for a number");
    if (steps)
        *steps = c.steps;
    if (error)
        *error = off;
    *out = span;
    return BATTEN_OK;
}
