/* Where two rails are at the same height along a direction, and how they go on from there. */
#ifndef BAT_SWEEP_RAIL_HEIGHTS_H
#define BAT_SWEEP_RAIL_HEIGHTS_H
#include "shape/sweep/motion_rails.h"

typedef struct {
    bat_motion base;
    batten_curve *rails[2];
    batten_vec3 across;
    bool by_planes;
    double heights[2]; /* of the common start and end, by planes */
    double height, tolerance;
} bat_between;

batten_status bat_rail_height(const bat_between *m, int rail, double u, double *height);
/* Point and four derivatives of a rail at the share v of the way. */
batten_status bat_rail_look(const bat_between *m, int rail, double v, batten_side side,
                            double *out);

#endif
