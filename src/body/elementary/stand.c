/* The square frame of an elementary surface, and how far points reach along it. */
#include "body/elementary/parts.h"
#include "spline/curve/curve.h"

batten_interval bat_stand_range(const bat_stand *stand, int axis)
{
    batten_interval range = {INFINITY, -INFINITY};
    for (int i = 0; i < stand->count; i++) {
        const double at = bat_stand_coordinate(stand, stand->points + 3 * (size_t)i, axis);
        range.a = bat_min(range.a, at);
        range.b = bat_max(range.b, at);
    }
    return range;
}

batten_status bat_elementary_frame(const bat_elementary *elementary, batten_frame *square,
                                   batten_vec3 *y)
{
    batten_frame frame = elementary->frame;
    if (elementary->kind == BAT_EXTRUSION || elementary->kind == BAT_REVOLUTION)
        frame.x = fabs(frame.z.x) <= 0.6 * bat_vec3_norm(frame.z) ? (batten_vec3){1, 0, 0}
                                                                  : (batten_vec3){0, 1, 0};
    return bat_frame_square(&frame, square, y);
}
