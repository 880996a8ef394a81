/* How cuts bend, as a linear measure of the control points. */
#ifndef BAT_LOFT_BENDING_H
#define BAT_LOFT_BENDING_H
#include "loft/cut.h"
#include "loft/program.h"

/* The measure whose value has the sign of the cut's curvature: the second fundamental form in
 * the direction in which a plane cuts, or what an edge bends by as it is seen, with the normal
 * and Christoffel symbols frozen: the first variation is exact. Returns the value; NAN where
 * the surface is singular, the plane touches it, or the edge is seen end on. */
double bat_loft_bending(const bat_loft_place *place, const bat_loft_cut *cut,
                        bat_loft_measure *out);

#endif
