/* Functions over the chord: cubics, and splines in tension. */
#include "shape/bent/two_angle.h"
#include "spline/chain/chain.h"

/* Slope and second derivative of a span in tension z = sigma l are bound by a = l A, b = l B:
 * the slopes above the chord are -a M0 - b M1 and b M0 + a M1. */
typedef struct {
    double A, B;
} stiffness;

static stiffness stiffness_of(double z)
{
    double at_start[4], at_end[4];
    bat_tension_shape(z, 0, 1, at_start);
    bat_tension_shape(z, 1, 0, at_end);
    return (stiffness){at_end[1], -at_start[1]};
}

/* The second derivatives at both ends from the slopes there. */
static void bends(stiffness s, double l, double first, double last, double M[2])
{
    const double scale = 1 / ((s.A - s.B) * (s.A + s.B) * l);
    M[0] = -(s.A * first + s.B * last) * scale;
    M[1] = (s.B * first + s.A * last) * scale;
}

static batten_status tension_curvatures(double alpha, double beta, double l, double tension,
                                        bat_end_curvatures *out)
{
    const stiffness s = stiffness_of(tension);
    const double scale = 1 / ((s.A - s.B) * (s.A + s.B) * l);
    const double c = bat_cos(alpha), e = bat_cos(beta), c3 = c * c * c, e3 = e * e * e;
    double M[2];
    bends(s, l, bat_tan(alpha), bat_tan(beta), M);
    *out = (bat_end_curvatures){
        .k0 = M[0] * c3,
        .k1 = M[1] * e3,
        .k0_alpha = -s.A * scale * c - 3 * M[0] * c * c * bat_sin(alpha),
        .k0_beta = -s.B * scale * c3 / (e * e),
        .k1_alpha = s.B * scale * e3 / (c * c),
        .k1_beta = s.A * scale * e - 3 * M[1] * e * e * bat_sin(beta),
    };
    return BATTEN_OK;
}

static batten_status tension_spans(double alpha, double beta, double l, double tension,
                                   batten_span *out, int *count)
{
    double M[2];
    bends(stiffness_of(tension), l, bat_tan(alpha), bat_tan(beta), M);
    *out = (batten_span){
        .kind = BATTEN_SPAN_TENSION,
        .length = l,
        .end = {l, 0, 0},
        .bend = {{0, M[0], 0}, {0, M[1], 0}},
        .tension = tension / l,
    };
    *count = 1;
    return BATTEN_OK;
}

static batten_status cubic_curvatures(double alpha, double beta, double l, double tension,
                                      bat_end_curvatures *out)
{
    (void)tension;
    return tension_curvatures(alpha, beta, l, 0, out);
}

static batten_status cubic_spans(double alpha, double beta, double l, double tension,
                                 batten_span *out, int *count)
{
    (void)tension;
    return tension_spans(alpha, beta, l, 0, out, count);
}

const bat_span_family bat_family_local_cubic = {
    .name = "a local cubic",
    .limit = BAT_PI / 2,
    .remedy = "an Euler spiral",
    .curvatures = cubic_curvatures,
    .spans = cubic_spans,
};

const bat_span_family bat_family_local_tension = {
    .name = "a local spline in tension",
    .limit = BAT_PI / 2,
    .remedy = "an Euler spiral",
    .curvatures = tension_curvatures,
    .spans = tension_spans,
};

/* ---- as much tension as it takes ---- */

double bat_local_tension_for(double alpha, double beta)
{
    const double first = fabs(bat_tan(alpha)), last = fabs(bat_tan(beta));
    const double low_slope = bat_min(first, last), high_slope = bat_max(first, last);
    if (high_slope <= 2 * low_slope)
        return 0;
    /* A / B grows from 2, for large z as z - 1: so the answer is below ratio + 2. */
    double low = 0, high = BAT_MOST_TENSION;
    if (high_slope < (high - 2) * low_slope)
        high = high_slope / low_slope + 2;
    for (int k = 0; k < 60; k++) {
        const double z = low + (high - low) / 2;
        const stiffness s = stiffness_of(z);
        if (s.A * low_slope >= s.B * high_slope)
            high = z;
        else
            low = z;
    }
    return high;
}
