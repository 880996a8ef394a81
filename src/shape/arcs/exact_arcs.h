/* Lines and arcs of circles that stand in a NURBS curve as they are. */
#ifndef BAT_EXACT_H
#define BAT_EXACT_H
#include "shape/arcs/biarc.h"
#include "spline/curve/curve.h"

/* A piece as one arc or line, or as two arcs of one circle when it turns far. */
typedef struct {
    int count;
    batten_span arcs[2];
} bat_exact;

/* How near a curve must be to what it is taken for: 1e-12 of its size, and its rounding. */
double bat_exact_tolerance(const batten_curve *curve);
/* A piece of a curve of dimension 2; false when it is neither a line nor an arc. */
bool bat_exact_piece(const batten_curve *curve, const bat_piece *piece, double tolerance,
                     bat_exact *out);
/* One arc of at most a half circle, or line, in the place of two that follow one another. */
bool bat_exact_merge(batten_span *first, const batten_span *next, double tolerance);

#endif
