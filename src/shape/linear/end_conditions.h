/* What holds at the ends of a spline through points, made linear. */
#ifndef BAT_END_CONDITIONS_H
#define BAT_END_CONDITIONS_H
#include "base/base.h"
#include <batten/interpolate.h>

/* What holds at start and end. */
typedef struct {
    batten_end_kind kinds[2];
    double values[2][3]; /* the derivatives that are asked for */
} bat_ends;

/* What holds at both ends of a curve through at least two points: directions and circles become
 * CLAMPED (or BESSEL, where there is no circle), curvatures SECOND, still to be found. */
batten_status bat_ends_resolve(batten_points points, const double *parameters,
                               const batten_end ends[2], bat_ends *out);
/* The same as one of CLAMPED, SECOND and PARABOLIC alone; others are refused in the name of
 * `what`: "splines in tension". */
batten_status bat_ends_plain(batten_points points, const double *parameters,
                             const batten_end ends[2], const char *what, bat_ends *out);

#endif
