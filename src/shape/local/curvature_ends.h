/*
 * One cubic between two points of the plane with given directions and curvatures at both ends:
 * the pair of equations of de Boor, Hollig and Sabin.
 */
#ifndef BAT_DBHS_H
#define BAT_DBHS_H
#include "base/base.h"

/* Lengths of the legs: from the first point to the second control point, and from the third to
 * the last. */
typedef struct {
    double start, end;
} bat_legs;

enum { BAT_DBHS_SOLUTIONS = 3 };

/*
 * All solutions with positive legs: with D the chord,
 *     (T0 x T1) end = T0 x D - 3/2 k0 start^2,   (T0 x T1) start = D x T1 - 3/2 k1 end^2.
 *
 * t0, t1: unit vectors; k0, k1: signed curvatures. legs [BAT_DBHS_SOLUTIONS], those nearest to
 * a third of the chord first. Where a leg is free, as of a straight span, it is that third.
 * Returns their count, 0..3. Cost: the roots of one quartic.
 */
int bat_dbhs(const double *t0, const double *t1, const double *chord, double k0, double k1,
             bat_legs *legs);

#endif
