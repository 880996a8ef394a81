/* A spline in tension on its way: the system of its second derivatives, and the rules that ask
 * for more tension. */
#ifndef BAT_TENSION_H
#define BAT_TENSION_H
#include "numeric/vector.h"
#include "shape/linear/end_conditions.h"
#include <batten/interpolate.h>

typedef struct {
    int dimension, count, spans;
    bool closed;
    const double *points; /* [count][dimension] */
    double *u;            /* [spans + 1] */
    bool rational;        /* Spaeth's rational spans instead of hyperbolic ones */
    double *sigma;        /* [spans]; of rational ones p */
    double *slopes;       /* [spans][dimension] of the chords */
    double *a, *b;        /* [spans] how far a second derivative turns the slope, at its own end
                             and at the other */
    double *matrix;       /* [count][3] */
    double *moments;      /* [count][dimension] second derivatives */
    bat_ends ends;        /* CLAMPED, SECOND, PARABOLIC */
} bat_tension;

/* Parameters, tensions, chords and ends from the options; bat_tension_end is due in any case. */
batten_status bat_tension_begin(bat_tension *t, const batten_chain_tension_options *options);
void bat_tension_end(bat_tension *t);
/* Each row of the system is a handful of sums: slopes that differ by more than their rounding are refused. */
batten_status bat_tension_check_slopes(const bat_tension *t);
/* The second derivatives for the tensions as they are. */
batten_status bat_tension_solve(bat_tension *t);
/* The point at the end of a span. */
static inline int bat_tension_next(const bat_tension *t, int span)
{
    return span + 1 == t->count ? 0 : span + 1;
}
/* The slope at the start (end = 0) or end of a span. */
void bat_tension_slope(const bat_tension *t, int span, int end, double *slope);

/* Raise tensions until the rule is satisfied. */
batten_status bat_tension_convex(bat_tension *t, double slack);
batten_status bat_tension_monotone(bat_tension *t, double slack);
enum { BAT_TENSION_ROUNDS = 100 };

#endif
