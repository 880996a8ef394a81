/* The circular-arc spline: one arc at each point. Between two points its arcs meet at equal
 * chords, on the bisector of the points; curvature steps there and nowhere else. */
#include "shape/arcs/biarc.h"
#include "shape/bent/two_angle.h"

/* With s = (3 alpha + beta) / 4, e = (alpha + 3 beta) / 4 and d = (alpha - beta) / 4:
 * k0 = -4 / l sin s cos d, k1 = 4 / l sin e cos d. */
static batten_status curvatures(double alpha, double beta, double l, double tension,
                                bat_end_curvatures *out)
{
    const double s = (3 * alpha + beta) / 4, e = (alpha + 3 * beta) / 4, d = (alpha - beta) / 4;
    (void)tension;
    *out = (bat_end_curvatures){
        .k0 = -4 / l * bat_sin(s) * bat_cos(d),
        .k1 = 4 / l * bat_sin(e) * bat_cos(d),
        .k0_alpha = -1 / l * (3 * bat_cos(s) * bat_cos(d) - bat_sin(s) * bat_sin(d)),
        .k0_beta = -1 / l * (bat_cos(s) * bat_cos(d) + bat_sin(s) * bat_sin(d)),
        .k1_alpha = 1 / l * (bat_cos(e) * bat_cos(d) - bat_sin(e) * bat_sin(d)),
        .k1_beta = 1 / l * (3 * bat_cos(e) * bat_cos(d) + bat_sin(e) * bat_sin(d)),
    };
    return BATTEN_OK;
}

static batten_status spans(double alpha, double beta, double l, double tension,
                           batten_span *out, int *count)
{
    const bat_arc_chord chord = {.length = l};
    batten_biarc made;
    (void)tension;
    const batten_status status = bat_biarc_make(&chord, alpha, beta, 0.5, &made);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < made.count; i++)
        out[i] = made.arcs[i];
    *count = made.count;
    return BATTEN_OK;
}

/* Up to here no arc turns by more than 300 degrees, which is far beyond any batten. */
const bat_span_family bat_family_arcs = {
    .name = "a circular arc",
    .limit = 5 * BAT_PI / 6,
    .remedy = "an Euler spiral",
    .curvatures = curvatures,
    .spans = spans,
};
