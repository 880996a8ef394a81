/*
 * Coordinate frames in space: the world, planes across an axis, and a given frame made
 * orthonormal.
 */
#include "numeric/vector.h"
#include "spline/curve/curve.h"

batten_frame batten_frame_world(void)
{
    return (batten_frame){{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
}

batten_frame batten_frame_across(int axis, double at)
{
    const bool x = axis == 0, y = axis == 1, z = axis == 2;
    return (batten_frame){{at * x, at * y, at * z}, {!x, x, 0}, {x, -1.0 * y, z}};
}

batten_status bat_frame_square(const batten_frame *frame, batten_frame *square, batten_vec3 *y)
{
    const double x_length = bat_vec3_norm(frame->x), z_length = bat_vec3_norm(frame->z);
    const batten_vec3 o = frame->origin;
    if (!isfinite(x_length) || !isfinite(z_length) || !isfinite(o.x) || !isfinite(o.y) ||
        !isfinite(o.z))
        return bat_fail(BATTEN_NOT_FINITE,
                        "the frame at (%g, %g, %g) has a coordinate that is no number", o.x,
                        o.y, o.z);
    if (x_length == 0 || z_length == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the %s-axis of the frame is zero",
                        x_length == 0 ? "x" : "z");
    const batten_vec3 x = bat_vec3_scale(frame->x, 1 / x_length);
    const batten_vec3 z = bat_vec3_scale(frame->z, 1 / z_length), side = bat_vec3_cross(z, x);
    const double sine = bat_vec3_norm(side);
    /* Below, the direction of the third axis is rounding. */
    if (sine < 1e-12)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the axes of the frame are parallel: the sine between them is %g",
                        sine);
    *y = bat_vec3_scale(side, 1 / sine);
    *square = (batten_frame){o, bat_vec3_cross(*y, z), z};
    return BATTEN_OK;
}
