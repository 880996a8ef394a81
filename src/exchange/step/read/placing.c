/* Placements and transformation operators as affine maps. */
#include "exchange/step/read/import.h"
#include "numeric/vector.h"

#include <float.h>

/* Of length one to a few roundings it stays as it is, so that what is written reads back. */
static batten_vec3 unit(batten_vec3 a)
{
    const double length = bat_vec3_norm(a);
    return !(length > 0) || fabs(length - 1) <= 4 * DBL_EPSILON ? a
                                                                : bat_vec3_scale(a, 1 / length);
}

/* What of `a` is square to the unit vector z, of length one; zero when nothing is. */
static batten_vec3 square(batten_vec3 a, batten_vec3 z)
{
    const double along = bat_vec3_dot(a, z), length = bat_vec3_norm(a);
    if (fabs(along) <= 4 * DBL_EPSILON * length)
        return unit(a);
    const batten_vec3 rest = bat_vec3_along(a, -along, z);
    return bat_vec3_norm(rest) > BAT_WRITTEN * length ? unit(rest) : (batten_vec3){0, 0, 0};
}

static batten_affine columns(batten_vec3 x, batten_vec3 y, batten_vec3 z, batten_vec3 origin,
                             double scale)
{
    return (batten_affine){{{scale * x.x, scale * y.x, scale * z.x},
                            {scale * x.y, scale * y.y, scale * z.y},
                            {scale * x.z, scale * y.z, scale * z.z}},
                           {origin.x, origin.y, origin.z}};
}

/* The direction that argument k refers to; the default when there is none. */
static batten_status read_axis(const bat_step_file *file, const bat_step_record *record, int k,
                               batten_vec3 otherwise, batten_vec3 *axis)
{
    const bat_step_instance *instance = NULL;
    double direction[3];
    *axis = otherwise;
    if (bat_step_is_nothing(file, record, k))
        return BATTEN_OK;
    batten_status status = bat_step_get_reference(file, record, k, &instance);
    if (status == BATTEN_OK)
        status = bat_step_read_direction(file, instance, direction);
    if (status == BATTEN_OK)
        *axis = bat_vec3_of(3, direction);
    return status;
}

/* CARTESIAN_TRANSFORMATION_OPERATOR_3D: x, y, origin, scale, z are its last arguments. */
static batten_status read_operator(const bat_step_file *file, const bat_step_instance *instance,
                                   const bat_step_record *record, const bat_step_scale *scale,
                                   batten_affine *place)
{
    const int count = bat_step_argument_count(file, record);
    const bat_step_instance *origin = NULL;
    batten_vec3 x, y, z;
    double at[3], factor = 1;
    if (count < 6)
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT, "it has %d arguments, needs 6",
                             count);
    batten_status status = read_axis(file, record, count - 1, (batten_vec3){0, 0, 1}, &z);
    if (status == BATTEN_OK)
        status = read_axis(file, record, count - 5, (batten_vec3){1, 0, 0}, &x);
    if (status != BATTEN_OK)
        return status;
    z = unit(z);
    x = square(x, z);
    if (bat_vec3_norm(x) == 0)
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT, "its axes are parallel");
    const batten_vec3 right = bat_vec3_cross(z, x);
    status = read_axis(file, record, count - 4, right, &y);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, record, count - 3, &origin);
    if (status == BATTEN_OK)
        status = bat_step_read_point(file, origin, scale, at);
    if (status == BATTEN_OK && !bat_step_is_nothing(file, record, count - 2))
        status = bat_step_get_real(file, record, count - 2, &factor);
    if (status != BATTEN_OK)
        return status;
    if (!(factor > 0 && isfinite(factor)))
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT, "its scale is %g", factor);
    /* Only the side on which y lies is free: on the other it mirrors. */
    const double side = bat_vec3_dot(y, right) < 0 ? -1 : 1;
    *place = columns(x, bat_vec3_scale(right, side), z, bat_vec3_of(3, at), factor);
    return BATTEN_OK;
}

batten_status bat_step_read_place(const bat_step_file *file, const bat_step_instance *instance,
                                  const bat_step_scale *scale, batten_affine *place)
{
    const bat_step_record *operator=
        bat_step_as(file, instance, "CARTESIAN_TRANSFORMATION_OPERATOR_3D");
    batten_frame frame;
    if (operator)
        return read_operator(file, instance, operator, scale, place);
    batten_status status = bat_step_read_placement(file, instance, scale, &frame);
    /* As the file has them: the frame is square already, which may have cost a rounding. */
    const bat_step_record *placement = bat_step_as(file, instance, "AXIS2_PLACEMENT_3D");
    if (status == BATTEN_OK && placement)
        status = read_axis(file, placement, 2, frame.z, &frame.z);
    if (status == BATTEN_OK && placement)
        status = read_axis(file, placement, 3, frame.x, &frame.x);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 z = unit(frame.z), x = square(frame.x, z);
    if (bat_vec3_norm(x) == 0)
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT, "its axes are parallel");
    *place = columns(x, bat_vec3_cross(z, x), z, frame.origin, 1);
    return BATTEN_OK;
}

batten_affine bat_step_move(const batten_affine *from, const batten_affine *to)
{
    /* The inverse of s R is R transposed / s; s^2 is the square of a column. */
    const double s2 = from->m[0][0] * from->m[0][0] + from->m[1][0] * from->m[1][0] +
                      from->m[2][0] * from->m[2][0];
    const double by = fabs(s2 - 1) <= 16 * DBL_EPSILON ? 1 : 1 / s2;
    batten_affine back;
    for (int i = 0; i < 3; i++) {
        back.t[i] = 0;
        for (int k = 0; k < 3; k++) {
            back.m[i][k] = by * from->m[k][i];
            back.t[i] -= by * from->m[k][i] * from->t[k];
        }
    }
    return batten_affine_compose(back, *to);
}
