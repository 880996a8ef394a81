/* Hobby's splines: curvatures as if the angles were small, and his velocities. */
#include "shape/bent/two_angle.h"

static batten_status curvatures(double alpha, double beta, double l, double tension,
                                bat_end_curvatures *out)
{
    (void)tension;
    *out = (bat_end_curvatures){
        .k0 = -(4 * alpha + 2 * beta) / l,
        .k1 = (2 * alpha + 4 * beta) / l,
        .k0_alpha = -4 / l,
        .k0_beta = -2 / l,
        .k1_alpha = 2 / l,
        .k1_beta = 4 / l,
    };
    return BATTEN_OK;
}

/* The distance of the control point from the end at angle `near`, in chords: a third of the
 * velocity. Angles are those by which the tangents turn away from the chord to one side. For
 * equal ones it is 2 / (3 (1 + cos)), that of the arc. */
static double reach(double near, double far)
{
    const double root2 = sqrt(2), root5 = sqrt(5);
    const double a = root2 * (bat_sin(near) - bat_sin(far) / 16) *
                     (bat_sin(far) - bat_sin(near) / 16) * (bat_cos(near) - bat_cos(far));
    const double below =
        3 * (1 + (root5 - 1) / 2 * bat_cos(near) + (3 - root5) / 2 * bat_cos(far));
    return 2 + a < 4 * below ? (2 + a) / below : 4;
}

static batten_status spans(double alpha, double beta, double l, double tension,
                           batten_span *out, int *count)
{
    (void)tension;
    const double first = reach(alpha, -beta), last = reach(-beta, alpha);
    /* Control points in chords, the last one from the end. */
    const double P[2] = {first * bat_cos(alpha), first * bat_sin(alpha)};
    const double Q[2] = {-last * bat_cos(beta), -last * bat_sin(beta)};
    *out = (batten_span){.kind = BATTEN_SPAN_TENSION, .length = l, .end = {l, 0, 0}};
    for (int k = 0; k < 2; k++) {
        const double end = k == 0;
        out->bend[0][k] = 6 * (end + Q[k] - 2 * P[k]) / l;
        out->bend[1][k] = 6 * (P[k] - 2 * Q[k] - end) / l;
    }
    *count = 1;
    return BATTEN_OK;
}

const bat_span_family bat_family_hobby = {
    .name = "a spline of Hobby",
    .limit = BAT_PI,
    .remedy = "an Euler spiral",
    .curvatures = curvatures,
    .spans = spans,
};
