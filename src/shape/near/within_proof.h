/* How far a curve is from its approximation, proved on the common knots of both. */
#ifndef BAT_NEAR_WITHIN_PROOF_H
#define BAT_NEAR_WITHIN_PROOF_H
#include "shape/near/within.h"

/* A part of the given curve without corners, clamped, and what was taken of it. */
typedef struct {
    batten_curve *curve;
    int break_count, span_count;
    double *breaks; /* [break_count], of the given curve */
    double *common; /* [span_count + 1], with the knots */
    double *bounds; /* [span_count] */
    int *span_of;   /* [data] */
    double *points, *weights, *parameters;
} bat_within_source;

batten_status bat_within_curve_error(bat_within *w, const batten_curve *curve,
                                     const double *parameters, double *distances, double *max);

#endif
