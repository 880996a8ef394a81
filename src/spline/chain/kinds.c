/*
 * The kinds of span that a chain may have, as a table of functions, and the simplest of them,
 * arcs and lines.
 */
#include "spline/chain/chain.h"

/* ---- arcs and lines ---- */

void bat_arc_at(const batten_span *arc, double t, double out[2])
{
    /* The chord of the part up to t: its length, and half the turn from the tangent. */
    const double half = arc->curvature[0] * t / 2;
    const double chord = half == 0 ? t : t * (bat_sin(half) / half);
    double cosine, sine;
    bat_sincos(arc->angle + half, &sine, &cosine);
    out[0] = arc->start[0] + chord * cosine;
    out[1] = arc->start[1] + chord * sine;
}

static void evaluate_arc(int d, const batten_span *span, double t, int order, double *out)
{
    const double k = span->curvature[0], angle = span->angle + k * t;
    assert(d == 2);
    double T[2];
    bat_sincos(angle, &T[1], &T[0]);
    const double N[2] = {-T[1], T[0]};
    bat_arc_at(span, t, out);
    for (int i = 0; i < d; i++) {
        if (order >= 1)
            out[2 + i] = T[i];
        if (order >= 2)
            out[4 + i] = k * N[i];
        if (order >= 3)
            out[6 + i] = -k * k * T[i];
    }
}

/* ---- the table ---- */

/* The one table of kinds, in the order of the enumeration. */
static const bat_span_type types[] = {
    [BATTEN_SPAN_ARC] = {"arc", true, evaluate_arc, NULL},
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
