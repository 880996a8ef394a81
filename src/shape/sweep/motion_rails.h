/* What a motion between rails is made from. */
#ifndef BAT_MOTION_RAILS_H
#define BAT_MOTION_RAILS_H
#include "shape/sweep/motion.h"

typedef struct {
    const batten_curve *rails[2];
    batten_vec3 across; /* rails are matched by their heights along this unit vector; 0: by
                           equal shares of their parameters */
    double height;      /* what y and z are scaled by; 0: as x is */
    double tolerance;   /* rails nearer than that meet */
} bat_rails;

/* The ends of sections, (0, 0, 0) and (1, 0, 0), run along the two rails, of three dimensions; the
 * domain is [0, 1]. */
batten_status bat_motion_between(const bat_rails *rails, bat_motion **out);

#endif
