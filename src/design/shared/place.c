/* Where a feature puts what it makes: frames from 'at', 'axis' and 'from', and ends with vectors. */
#include "design/shared/place.h"
#include "numeric/vector.h"

static double length_of(batten_vec3 v)
{
    return bat_hypot(bat_hypot(v.x, v.y), v.z);
}

static batten_vec3 unit(batten_vec3 v)
{
    const double l = length_of(v);
    return (batten_vec3){v.x / l, v.y / l, v.z / l};
}

batten_status bat_check_direction(const char *parameter, batten_vec3 v)
{
    if (length_of(v) > 0)
        return BATTEN_OK;
    return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' is 0 and has no direction", parameter);
}

batten_status bat_frame(const bat_run *run, batten_frame *out)
{
    const batten_vec3 axis = bat_point(run, "axis");
    batten_status status = bat_check_direction("axis", axis);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 z = unit(axis);
    batten_vec3 x = {1, 0, 0};
    if (bat_has(run, "from"))
        x = bat_point(run, "from");
    else if (z.x != 0 || z.y != 0)
        x = bat_vec3_cross((batten_vec3){0, 0, 1}, z);
    status = bat_check_direction("from", x);
    if (status != BATTEN_OK)
        return status;
    /* Parallel to rounding: the sine of the angle between them is a few eps. */
    if (length_of(bat_vec3_cross(unit(x), z)) <= 1e-14)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'from' is parallel to 'axis'");
    *out = (batten_frame){bat_point(run, "at"), x, z};
    return BATTEN_OK;
}

static batten_affine to_frame(const batten_frame *frame)
{
    const batten_vec3 z = unit(frame->z), y = unit(bat_vec3_cross(z, frame->x)),
                      x = bat_vec3_cross(y, z);
    const batten_vec3 o = frame->origin;
    return (batten_affine){{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}},
                           {o.x, o.y, o.z}};
}

batten_status bat_place_curve(bat_run *run, batten_status status, batten_curve *plane)
{
    batten_frame frame;
    batten_curve *lifted = NULL, *placed = NULL;
    if (status == BATTEN_OK)
        status = bat_frame(run, &frame);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(plane, 3, &lifted);
    if (status == BATTEN_OK) {
        const batten_affine map = to_frame(&frame);
        status = batten_curve_transform(lifted, &map, &placed);
    }
    batten_curve_unref(lifted);
    batten_curve_unref(plane);
    return bat_put_curve(run, status, placed);
}

batten_end bat_end(const bat_run *run, const char *own, const char *vector)
{
    const batten_vec3 v = bat_point(run, vector);
    const int kind = bat_has(run, own) ? bat_word(run, own) : bat_word(run, "ends");
    return (batten_end){(batten_end_kind)kind, {v.x, v.y, v.z}};
}
