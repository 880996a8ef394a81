/* The boundary of a patch out of a feature's arguments. */
#ifndef BAT_DESIGN_BOUNDARY_H
#define BAT_DESIGN_BOUNDARY_H
#include "design/feature.h"
#include <batten/coons.h>

/* How boundary curves are shared out among four sides. */
#define BAT_BOUNDARY_SIDES                                                    \
    {                                                                         \
        "sides", BATTEN_VALUE_COUNT, true, false, NULL, NULL,                 \
            "how many curves each side has, the first curve's first; 0: none" \
    }

typedef struct {
    batten_curve *curves[4][3]; /* by batten_edge: curve, slope, curvature */
    batten_ribbon sides[4];
    batten_surface *beside[4]; /* the surface along each side, or NULL; owned */
    int curve_count;           /* how many were given */
    int alone[4];              /* the given curve that makes a side by itself, or -1 */
    bool against[4];           /* the side runs against that curve */
} bat_boundary;

/* The curves of an argument, in space, put into a loop and cut into sides; remarks say which
 * were reversed, and where a side stands still. */
batten_status bat_boundary_take(bat_run *run, const char *parameter, double tolerance,
                                bat_boundary *out);
/* Slopes of the first of the given curves out of the curves of an argument, which run as those do. */
batten_status bat_boundary_slopes(bat_run *run, const char *parameter, int order,
                                  bat_boundary *boundary);
/* Slopes (order 2) and curvatures (order 3) where surfaces of an argument lie along a side; a
 * surface that lies along none is an error. */
batten_status bat_boundary_along(bat_run *run, const char *parameter, int order,
                                 double tolerance, bat_boundary *boundary);
void bat_boundary_release(bat_boundary *boundary);

#endif
