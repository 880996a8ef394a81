/*
 * Joints between the spans of a curve or chain: how far direction, curvature and its rate step
 * there.
 */
#include "fair/fairness.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"

/*
 * The derivative of the curvature vector with respect to arc length, across the tangent; of a
 * function the third derivative. With v = |C'| and the part across C' marked by x:
 * (C'''x - 3 (C' . C'') / v^2 C''x) / v^3.
 */
static void third_across(int d, const double *c, double out[3])
{
    const double v2 = bat_dot(d, c + d, c + d), a = bat_dot(d, c + d, c + 2 * d);
    const double b = bat_dot(d, c + d, c + 3 * d), cube = v2 * sqrt(v2);
    for (int k = 0; k < d; k++) {
        const double second = v2 > 0 ? c[2 * d + k] - a / v2 * c[d + k] : 0;
        const double third = v2 > 0 ? c[3 * d + k] - b / v2 * c[d + k] : 0;
        out[k] = d == 1 ? c[3] : v2 > 0 ? (third - 3 * a / v2 * second) / cube : 0;
    }
}

/* Direction and curvature vector; of a function its first and second derivative. */
static bool bend_across(int d, const double *c, double direction[3], double curvature[3])
{
    const double v2 = d == 1 ? 1 : bat_dot(d, c + d, c + d), v = sqrt(v2);
    const double a = d == 1 ? 0 : bat_dot(d, c + d, c + 2 * d);
    for (int k = 0; k < d && v2 > 0; k++) {
        direction[k] = c[d + k] / v;
        curvature[k] = (c[2 * d + k] - a / v2 * c[d + k]) / v2;
    }
    return v2 > 0;
}

static void add_step(int d, const double *before, const double *after,
                     const bat_joint_scale *scale, batten_fairness *out)
{
    double t[2][3], k[2][3];
    if (!bend_across(d, before, t[0], k[0]) || !bend_across(d, after, t[1], k[1]))
        return;
    const double steepest = d == 1 ? bat_max(fabs(t[0][0]), fabs(t[1][0])) : 1;
    const double bent = bat_max(bat_norm(d, k[0]), bat_norm(d, k[1]));
    const double turn = bat_distance(d, t[0], t[1]), jump = bat_distance(d, k[0], k[1]);
    if (turn > scale->angle * steepest + scale->direction_noise) {
        out->corners++;
        /* From the chord of a unit circle; slopes of functions as they are. */
        out->largest_turn =
            bat_max(out->largest_turn, d == 1 ? turn : 2 * bat_asin(bat_min(1, turn / 2)));
    } else if (jump > scale->curvature * bent + BAT_MEANT_SAME * scale->largest +
                          scale->curvature_noise) {
        out->curvature_jumps++;
        out->largest_jump = bat_max(out->largest_jump, jump / bent);
    }
}

void bat_add_joint(int d, const double *before, const double *after,
                   const bat_joint_scale *scale, batten_fairness *out)
{
    double a[3], b[3];
    third_across(d, before, a);
    third_across(d, after, b);
    for (int k = 0; k < d; k++)
        out->jumps += (b[k] - a[k]) * (b[k] - a[k]);
    add_step(d, before, after, scale, out);
}

void bat_conclude_fairness(batten_fairness *out)
{
    if (out->corners > 0)
        out->energy = HUGE_VAL;
    if (isinf(out->energy))
        out->energy_error = 0;
    if (out->corners > 0 || out->curvature_jumps > 0 || out->unbounded > 0) {
        out->variation = HUGE_VAL;
        out->variation_error = 0;
    }
    out->fair = out->excess_inflections == 0 && out->corners == 0 &&
                out->curvature_jumps == 0 && out->unbounded == 0;
}

batten_fairness_options batten_fairness_defaults(void)
{
    /* Constructions join their spans to some 1e-9; files of other programs to a part of that. */
    return (batten_fairness_options){
        .size = sizeof(batten_fairness_options), .angle = 1e-6, .curvature = 1e-6};
}

batten_status bat_fairness_take_options(const batten_fairness_options *options,
                                        batten_fairness_options *chosen)
{
    *chosen = batten_fairness_defaults();
    const batten_status status = BAT_TAKE_OPTIONS(batten_fairness_options, options, chosen);
    if (status != BATTEN_OK)
        return status;
    if (!(chosen->angle > 0 && chosen->angle < BAT_PI))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the angle of a corner is %g radians, not between 0 and pi",
                        chosen->angle);
    if (!(chosen->curvature > 0 && isfinite(chosen->curvature)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the bound on curvature jumps is %g, not above 0",
                        chosen->curvature);
    if (!(chosen->within >= 0 && isfinite(chosen->within)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "points within %g: the bound is below 0",
                        chosen->within);
    if (!(chosen->error >= 0 && isfinite(chosen->error)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve known within %g: the error is below 0",
                        chosen->error);
    return BATTEN_OK;
}
