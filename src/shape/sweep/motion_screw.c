/* The motion along a screw: a turn about an axis, and a way along it. */
#include "numeric/vector.h"
#include "shape/sweep/motion.h"

/* About the z-axis of a frame. */
typedef struct {
    bat_motion base;
    batten_vec3 origin, axis; /* unit */
    double rise;              /* along the axis for each radian */
    double angle;
} screw;

/* The turn by v of the vector e, and its derivatives: that of order k is the turn by a quarter
 * more, of what lies across the axis. */
static void turn_axis(const screw *s, batten_vec3 e, double v, int column, bat_pose *out)
{
    const double height = bat_vec3_dot(e, s->axis);
    const batten_vec3 flat = bat_vec3_along(e, -height, s->axis);
    const batten_vec3 side = bat_vec3_cross(s->axis, flat);
    const double c = bat_cos(v), n = bat_sin(v);
    const double cosines[4] = {c, -n, -c, n}, sines[4] = {n, c, -n, -c};
    for (int k = 0; k <= BAT_POSE_ORDER; k++) {
        batten_vec3 at = bat_vec3_along(bat_vec3_scale(flat, cosines[k]), sines[k], side);
        if (k == 0)
            at = bat_vec3_along(at, height, s->axis);
        out->d[k][column][0] = at.x;
        out->d[k][column][1] = at.y;
        out->d[k][column][2] = at.z;
    }
}

static batten_status screw_pose(const bat_motion *motion, double v, batten_side side,
                                bat_pose *out)
{
    const screw *s = (const screw *)(const void *)motion;
    (void)side;
    *out = (bat_pose){.share = {v / s->angle, 1 / s->angle}};
    turn_axis(s, (batten_vec3){1, 0, 0}, v, BAT_POSE_X, out);
    turn_axis(s, (batten_vec3){0, 1, 0}, v, BAT_POSE_Y, out);
    turn_axis(s, (batten_vec3){0, 0, 1}, v, BAT_POSE_Z, out);
    /* o - R o + v rise a, so that the axis stays where it is. */
    bat_pose turned;
    turn_axis(s, s->origin, v, 0, &turned);
    const double start[3] = {s->origin.x, s->origin.y, s->origin.z};
    const double rise[3] = {s->rise * s->axis.x, s->rise * s->axis.y, s->rise * s->axis.z};
    for (int k = 0; k <= BAT_POSE_ORDER; k++)
        for (int c = 0; c < 3; c++)
            out->d[k][BAT_POSE_ORIGIN][c] = (k == 0 ? start[c] + v * rise[c] : 0) +
                                            (k == 1 ? rise[c] : 0) - turned.d[k][0][c];
    return BATTEN_OK;
}

static void screw_free(bat_motion *motion)
{
    bat_release(motion);
}

static batten_status check_screw(batten_vec3 origin, batten_vec3 axis, double pitch,
                                 double angle)
{
    if (!isfinite(bat_vec3_norm(origin)) || !isfinite(bat_vec3_norm(axis)) ||
        !isfinite(pitch) || !isfinite(angle))
        return bat_fail(
            BATTEN_NOT_FINITE,
            "the screw is about (%g, %g, %g) along (%g, %g, %g), pitch %g, angle %g", origin.x,
            origin.y, origin.z, axis.x, axis.y, axis.z, pitch, angle);
    if (bat_vec3_norm(axis) == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the axis has no length");
    if (!(angle > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the angle is %g, not above 0", angle);
    if (angle > 2000 * BAT_PI)
        return bat_fail(BATTEN_TOO_LARGE, "the angle is %g turns; the limit is 1000",
                        angle / (2 * BAT_PI));
    return BATTEN_OK;
}

batten_status bat_motion_screw(batten_vec3 origin, batten_vec3 axis, double pitch, double angle,
                               bat_motion **out)
{
    batten_status status = check_screw(origin, axis, pitch, angle);
    if (status != BATTEN_OK)
        return status;
    screw *s = bat_array(1, sizeof *s);
    double *breaks = bat_array(2, sizeof *breaks);
    int *smoothness = bat_array(2, sizeof *smoothness);
    if (!s || !breaks || !smoothness) {
        bat_release(smoothness);
        bat_release(breaks);
        bat_release(s);
        return BATTEN_OUT_OF_MEMORY;
    }
    *s = (screw){.base = {.pose = screw_pose,
                          .free = screw_free,
                          .break_count = 2,
                          .breaks = breaks,
                          .smoothness = smoothness,
                          .size = bat_vec3_norm(origin) + fabs(pitch) * angle},
                 .origin = origin,
                 .axis = bat_vec3_scale(axis, 1 / bat_vec3_norm(axis)),
                 .rise = pitch / (2 * BAT_PI),
                 .angle = angle};
    breaks[1] = angle;
    *out = &s->base;
    return BATTEN_OK;
}
