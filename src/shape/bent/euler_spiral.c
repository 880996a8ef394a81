/* Clothoids: curvature linear in arc length. */
#include "shape/bent/spiral.h"
#include "shape/bent/two_angle.h"

/* k0 = (d - A) c / l and k1 = (d + A) c / l with d = beta - alpha, c the chord by the length.
 */
static batten_status curvatures(double alpha, double beta, double l, double tension,
                                bat_end_curvatures *out)
{
    bat_clothoid s;
    (void)tension;
    const batten_status status = bat_clothoid_solve(alpha, beta, &s);
    if (status != BATTEN_OK)
        return status;
    const double low = beta - alpha - s.A, high = beta - alpha + s.A, c = s.chord;
    *out = (bat_end_curvatures){
        .k0 = low * c / l,
        .k1 = high * c / l,
        .k0_alpha = ((-1 - s.A_alpha) * c + low * s.chord_alpha) / l,
        .k0_beta = ((1 - s.A_beta) * c + low * s.chord_beta) / l,
        .k1_alpha = ((-1 + s.A_alpha) * c + high * s.chord_alpha) / l,
        .k1_beta = ((1 + s.A_beta) * c + high * s.chord_beta) / l,
    };
    return BATTEN_OK;
}

static batten_status spans(double alpha, double beta, double l, double tension,
                           batten_span *out, int *count)
{
    bat_clothoid s;
    (void)tension;
    const batten_status status = bat_clothoid_solve(alpha, beta, &s);
    if (status != BATTEN_OK)
        return status;
    const double length = l / s.chord;
    *out = (batten_span){
        .kind = BATTEN_SPAN_SPIRAL,
        .length = length,
        .angle = alpha,
        .curvature = {(beta - alpha - s.A) / length, 2 * s.A / length / length},
    };
    *count = 1;
    return BATTEN_OK;
}

const bat_span_family bat_family_euler_spiral = {
    .name = "an Euler spiral",
    .limit = 0.98 * BAT_PI,
    .remedy = "biarcs",
    .curvatures = curvatures,
    .spans = spans,
};
