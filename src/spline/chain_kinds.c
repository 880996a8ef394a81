#include "spline/chain.h"

/* The one table of kinds, in the order of the enumeration. */
static const bat_span_type types[] = {
    [BATTEN_SPAN_ARC] = {"arc", true, bat_span_arc, NULL},
    [BATTEN_SPAN_SPIRAL] = {"spiral", true, bat_span_spiral, bat_span_spiral_check},
    [BATTEN_SPAN_TENSION] = {"tension", false, bat_span_tension, bat_span_tension_check},
    [BATTEN_SPAN_ELASTICA] = {"elastica", true, bat_span_elastica, bat_span_elastica_check},
    [BATTEN_SPAN_GEOMETRIC] = {"geometric", true, bat_span_geometric, bat_span_geometric_check},
};

const bat_span_type *bat_span_type_of(batten_span_kind kind)
{
    const size_t i = (size_t)kind;
    return i < sizeof types / sizeof types[0] && types[i].evaluate ? &types[i] : NULL;
}

/* ---- arcs and lines ---- */

/* sin x / x, without loss near 0. */
static double sine_quotient(double x)
{
    return x == 0 ? 1 : sin(x) / x;
}

void bat_span_arc(int d, const batten_span *span, double t, int order, double *out)
{
    const double k = span->curvature[0], turn = k * t;
    /* The chord of the part up to t: its length, and half the turn from the tangent. */
    const double chord = t * sine_quotient(turn / 2);
    const double angle = span->angle + turn;
    const double T[2] = {cos(angle), sin(angle)}, N[2] = {-T[1], T[0]};
    assert(d == 2);
    out[0] = span->start[0] + chord * cos(span->angle + turn / 2);
    out[1] = span->start[1] + chord * sin(span->angle + turn / 2);
    for (int i = 0; i < d; i++) {
        if (order >= 1)
            out[2 + i] = T[i];
        if (order >= 2)
            out[4 + i] = k * N[i];
        if (order >= 3)
            out[6 + i] = -k * k * T[i];
    }
}
