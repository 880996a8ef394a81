/* The plane of points and curves, wherever it lies in space. */
#ifndef BAT_DESIGN_PLANE_H
#define BAT_DESIGN_PLANE_H
#include "base/base.h"
#include <batten/curve.h>

/* The rigid map that takes the plane of points [count][3] to z = 0; false where they do not lie in one plane, but for
 * the rounding of their coordinates, or all in one line. */
bool bat_plane_find(int count, const double *points, batten_affine *to_plane);
/* The points in their plane, [count][2], which may stand in their own room. */
void bat_plane_points(const batten_affine *to_plane, int count, const double *points,
                      double *plane);
/* A curve in space, in its plane. */
batten_status bat_plane_curve(const batten_affine *to_plane, const batten_curve *curve,
                              batten_curve **out);

#endif
