/* What holds at the ends of a spline through points, made linear. */
#ifndef BAT_END_CONDITIONS_H
#define BAT_END_CONDITIONS_H
#include "base/base.h"
#include <batten/interpolate.h>

/* What holds at start and end of a curve through at least two points, with the derivatives it
 * asks for: directions and circles become CLAMPED (or BESSEL, where there is no circle),
 * curvatures SECOND, still to be found. */
batten_status bat_ends_resolve(int dimension, int count, const double *points,
                               const double *parameters, const batten_end ends[2],
                               batten_end_kind kinds[2], double values[2][3]);
/* The same as one of CLAMPED, SECOND and PARABOLIC alone; others are refused in the name of
 * `what`: "splines in tension". */
batten_status bat_ends_plain(int dimension, int count, const double *points,
                             const double *parameters, const batten_end ends[2],
                             const char *what, batten_end_kind kinds[2], double values[2][3]);

#endif
