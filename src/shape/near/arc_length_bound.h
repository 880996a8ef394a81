/* How far a piece of a curve can be from the quintic that replaces it by arc length. */
#ifndef BAT_ARC_LENGTH_BOUND_H
#define BAT_ARC_LENGTH_BOUND_H
#include <batten/curve.h>

/*
 * A bound of the distance, at equal arc length, between a piece of one span in Bezier form, of
 * arc length h, and the quintic with its point, tangent and curvature at both ends; infinity
 * or a huge number where the piece may stand still.
 *
 * Cost: some 10000 multiplications for a plane cubic; quadratic in the degree.
 */
batten_status bat_arc_length_bound(const batten_curve *piece, double h, double *bound);

#endif
