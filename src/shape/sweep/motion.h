/*
 * Moving frames: what carries a section along. At each v there are three axes X, Y, Z and an
 * origin o, so that the point (x, y, z) of a section comes to o + x X + y Y + z Z; all with
 * their derivatives in v.
 */
#ifndef BAT_MOTION_H
#define BAT_MOTION_H
#include "base/base.h"
#include <batten/sweep.h>

enum { BAT_POSE_ORDER = 3 };
enum { BAT_POSE_X, BAT_POSE_Y, BAT_POSE_Z, BAT_POSE_ORIGIN };

typedef struct {
    double d[BAT_POSE_ORDER + 1][4][3]; /* derivative; X, Y, Z, o; coordinate */
    double share[BAT_POSE_ORDER + 1];   /* of the way, 0 to 1, and its derivatives */
} bat_pose;

typedef struct bat_motion bat_motion;

/* The first member of every motion. Its domain is breaks[0] .. breaks[break_count - 1]. */
struct bat_motion {
    batten_status (*pose)(const bat_motion *motion, double v, batten_side side, bat_pose *out);
    void (*free)(bat_motion *motion);
    int break_count;
    double *breaks;  /* [break_count]; owned */
    int *smoothness; /* [break_count] derivatives that do not jump there; -1: the pose jumps */
    double size;     /* of the coordinates of the origins */
    bool flat;       /* sections have z = 0: it does not matter how Z jumps */
};

void bat_motion_free(bat_motion *motion);

/* Fill `smoothness` at inner breaks by comparing both sides. */
batten_status bat_motion_find_smoothness(bat_motion *motion);

/* Along a spine, with the frames, laws and corners of the options (motion_spine.c).
 * @param flat  sections have z = 0
 * @param[out] report  turn and length are filled in */
batten_status bat_motion_along(const batten_curve *spine,
                               const batten_surface_sweep_options *options, bool flat,
                               bat_motion **out, batten_surface_sweep_report *report);
/* A turn by v radians about the axis and a way of v pitch / 2 pi along it (motion_screw.c). */
batten_status bat_motion_screw(batten_vec3 origin, batten_vec3 axis, double pitch, double angle,
                               bat_motion **out);

#endif
