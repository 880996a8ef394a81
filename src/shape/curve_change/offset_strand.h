/* Quintics that follow an offset between its breaks. */
#ifndef BAT_CURVE_CHANGE_OFFSET_STRAND_H
#define BAT_CURVE_CHANGE_OFFSET_STRAND_H
#include "shape/curve_change/offset.h"
#include "spline/curve/hermite_run.h"

/* The offset at one parameter, seen from one side. */
typedef struct {
    double u;
    double p[3];    /* the curve */
    double t[2];    /* unit tangent of the plan */
    double factor;  /* 1 - k d */
    double k;       /* curvature */
    double q[3][3]; /* Q, Q', Q'' */
    bool singular;  /* the curve stands still: only p, t and q[0] are known */
} bat_run_place;

batten_status bat_run_place_at(const bat_offset *o, double u, batten_side side,
                               bat_run_place *out);
/* Where the curve stands still Q' is taken from the offset itself, a little inside. */
batten_status bat_run_settle(const bat_offset *o, bat_run_place *at, double towards);
/* From the last place of the run, which is `a`, to b: halves until the error is met. */
batten_status bat_strand_follow(bat_offset *o, bat_hermite_run *s, bat_run_place a,
                                const bat_run_place *b);
batten_status bat_strand_hand_over(bat_offset *o, bat_hermite_run *s);

#endif
