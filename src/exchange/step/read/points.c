/* Points, directions and placements of a STEP file. */
#include "exchange/step/read/geometry.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

/* ---- reading ---- */

#define DEEPEST 64

bat_step_reading bat_step_reading_of(const bat_step_file *file, const bat_step_scale *scale)
{
    return (bat_step_reading){.file = file, .scale = *scale, .dimension = 3};
}

batten_status bat_step_deeper(const bat_step_reading *reading,
                              const bat_step_instance *instance, bat_step_reading *inner)
{
    *inner = *reading;
    if (++inner->depth > DEEPEST)
        return bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                             "it stands on itself, or more than %d deep on others", DEEPEST);
    return BATTEN_OK;
}

batten_status bat_step_blame(const bat_step_file *file, const bat_step_instance *instance,
                             batten_status status)
{
    char sentence[768];
    const char *message = batten_message();
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY || message[0] == '#')
        return status;
    snprintf(sentence, sizeof sentence, "%s", message);
    return bat_step_fail(file, instance, status, "%s", sentence);
}

batten_status bat_step_check_arguments(const bat_step_file *file, const bat_step_record *record,
                                       int count)
{
    size_t at = bat_step_argument(file, record, 0);
    const bat_step_kind kind = bat_step_value_at(file, at).kind;
    if (kind != BAT_STEP_STRING && kind != BAT_STEP_NOTHING)
        return bat_step_fail_kind(file, record, at, "a string");
    for (int k = 0; k < count; k++) {
        if (bat_step_value_at(file, at).kind == BAT_STEP_END)
            return bat_step_fail_kind(file, record, at, "given");
        at = bat_step_next(file, at);
    }
    if (bat_step_value_at(file, at).kind != BAT_STEP_END)
        return bat_step_fail_kind(file, record, at, "one that belongs there");
    return BATTEN_OK;
}

batten_status bat_step_get_record(const bat_step_file *file, const bat_step_record *record,
                                  int k, const char *keyword, const bat_step_record **out)
{
    const bat_step_instance *instance = NULL;
    batten_status status = bat_step_get_reference(file, record, k, &instance);
    if (status != BATTEN_OK)
        return status;
    const bat_step_record *found = bat_step_as(file, instance, keyword);
    if (!found)
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT,
                             "#%llu refers to it as a %s, which it is not",
                             (unsigned long long)record->id, keyword);
    *out = found;
    return BATTEN_OK;
}

/* ---- points ---- */

/* The numbers of a CARTESIAN_POINT or DIRECTION, of which there must be `dimension`. */
static batten_status read_numbers(const bat_step_reading *reading,
                                  const bat_step_instance *instance, const char *keyword,
                                  double numbers[3])
{
    const bat_step_file *file = reading->file;
    const bat_step_record *record = bat_step_as(file, instance, keyword);
    double read[3] = {0, 0, 0};
    if (!record)
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT, "it is not of the type %s",
                             keyword);
    size_t at = bat_step_argument(file, record, 1);
    const bat_step_value list = bat_step_value_at(file, at);
    if (list.kind != BAT_STEP_LIST)
        return bat_step_fail_kind(file, record, at, "a list");
    at = list.first;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < reading->dimension; k++)
        status = bat_step_item_real(file, record, &at, &read[k]);
    if (status == BATTEN_OK && bat_step_value_at(file, at).kind != BAT_STEP_END)
        status = bat_step_fail(file, instance, BATTEN_BAD_FORMAT,
                               "it has more than %d coordinates", reading->dimension);
    if (status == BATTEN_OK)
        memcpy(numbers, read, sizeof read);
    return status;
}

batten_status bat_step_point_in(const bat_step_reading *reading,
                                const bat_step_instance *instance, double point[3])
{
    batten_status status = read_numbers(reading, instance, "CARTESIAN_POINT", point);
    if (status != BATTEN_OK)
        return status;
    const double length = reading->scale.length;
    for (int k = 0; k < 3; k++) {
        point[k] *= length;
        if (!isfinite(point[k]))
            return bat_step_fail(reading->file, instance, BATTEN_OVERFLOW,
                                 "coordinate %d is too large for a double", k + 1);
    }
    return BATTEN_OK;
}

batten_status bat_step_points_in(const bat_step_reading *reading, const bat_step_record *record,
                                 size_t *at, int count, double *points)
{
    const bat_step_instance *instance = NULL;
    const int dimension = reading->dimension;
    double point[3];
    for (int i = 0; i < count; i++) {
        batten_status status = bat_step_item_reference(reading->file, record, at, &instance);
        if (status == BATTEN_OK)
            status = bat_step_point_in(reading, instance, point);
        if (status != BATTEN_OK)
            return status;
        memcpy(points + (size_t)dimension * (size_t)i, point,
               (size_t)dimension * sizeof *points);
    }
    return BATTEN_OK;
}

/* ---- directions and frames ---- */

batten_status bat_step_direction_in(const bat_step_reading *reading,
                                    const bat_step_instance *instance, batten_vec3 *direction)
{
    double d[3];
    batten_status status = read_numbers(reading, instance, "DIRECTION", d);
    if (status != BATTEN_OK)
        return status;
    const double size = bat_max(fabs(d[0]), bat_max(fabs(d[1]), fabs(d[2])));
    if (!(size > 0))
        return bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT, "it has no length");
    /* Measured by its largest, so that squares stay numbers. */
    const bool is_far = size > 1e100 || size < 1e-100;
    batten_vec3 v = {d[0], d[1], d[2]};
    if (is_far)
        v = (batten_vec3){d[0] / size, d[1] / size, d[2] / size};
    /* Of length one to a few roundings it stays as it is, so that what is written reads back.
     */
    const double length = bat_vec3_norm(v);
    *direction = fabs(length - 1) <= 4 * DBL_EPSILON ? v : bat_vec3_scale(v, 1 / length);
    return BATTEN_OK;
}

batten_status bat_step_vector_in(const bat_step_reading *reading,
                                 const bat_step_instance *instance, batten_vec3 *vector)
{
    const bat_step_file *file = reading->file;
    const bat_step_record *record = bat_step_as(file, instance, "VECTOR");
    const bat_step_instance *along = NULL;
    double magnitude = 0;
    batten_vec3 direction;
    if (!record)
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT, "it is not a VECTOR");
    batten_status status = bat_step_get_reference(file, record, 1, &along);
    if (status == BATTEN_OK)
        status = bat_step_get_real(file, record, 2, &magnitude);
    if (status == BATTEN_OK)
        status = bat_step_direction_in(reading, along, &direction);
    if (status != BATTEN_OK)
        return status;
    const double length = magnitude * reading->scale.length;
    if (!(length > 0) || !isfinite(length))
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT,
                             "its magnitude is %g; it must be positive", magnitude);
    *vector = bat_vec3_scale(direction, length);
    return BATTEN_OK;
}

/* The direction of argument k; what stands in *direction stays when that is $. */
static batten_status optional_direction(const bat_step_reading *reading,
                                        const bat_step_record *record, int k,
                                        batten_vec3 *direction)
{
    const bat_step_instance *instance = NULL;
    if (bat_step_is_nothing(reading->file, record, k))
        return BATTEN_OK;
    batten_status status = bat_step_get_reference(reading->file, record, k, &instance);
    return status == BATTEN_OK ? bat_step_direction_in(reading, instance, direction) : status;
}

batten_status bat_step_frame_in(const bat_step_reading *reading,
                                const bat_step_instance *instance, batten_frame *frame)
{
    const bat_step_file *file = reading->file;
    const bool is_plane = reading->dimension == 2;
    const bat_step_record *record =
        bat_step_as(file, instance, is_plane ? "AXIS2_PLACEMENT_2D" : "AXIS2_PLACEMENT_3D");
    const bool is_axis = !record && !is_plane;
    if (is_axis)
        record = bat_step_as(file, instance, "AXIS1_PLACEMENT");
    if (!record)
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT, "it is not a placement in %s",
                             is_plane ? "the plane" : "space");
    const bat_step_instance *location = NULL;
    double point[3] = {0, 0, 0};
    batten_frame made = {.z = {0, 0, 1}}, square;
    batten_vec3 y;
    batten_status status = bat_step_get_reference(file, record, 1, &location);
    if (status == BATTEN_OK)
        status = bat_step_point_in(reading, location, point);
    if (status == BATTEN_OK && !is_plane)
        status = optional_direction(reading, record, 2, &made.z);
    if (status != BATTEN_OK)
        return status;
    made.origin = bat_vec3_of(3, point);
    /* Along x to within a microradian: there the projection of x onto the plane is rounding. */
    made.x = fabs(made.z.x) < 1 - 1e-12 ? (batten_vec3){1, 0, 0} : (batten_vec3){0, 1, 0};
    if (!is_axis)
        status = optional_direction(reading, record, is_plane ? 2 : 3, &made.x);
    if (status == BATTEN_OK)
        status = bat_step_blame(file, instance, bat_frame_square(&made, &square, &y));
    if (status == BATTEN_OK)
        *frame = square;
    return status;
}

/* ---- for other files ---- */

batten_status bat_step_read_point(const bat_step_file *file, const bat_step_instance *instance,
                                  const bat_step_scale *scale, double point[3])
{
    const bat_step_reading reading = bat_step_reading_of(file, scale);
    return bat_step_point_in(&reading, instance, point);
}

batten_status bat_step_read_direction(const bat_step_file *file,
                                      const bat_step_instance *instance, double direction[3])
{
    const bat_step_reading reading = {.file = file, .scale = {1, 1, 0}, .dimension = 3};
    batten_vec3 read;
    batten_status status = bat_step_direction_in(&reading, instance, &read);
    if (status == BATTEN_OK)
        memcpy(direction, (const double[3]){read.x, read.y, read.z}, 3 * sizeof *direction);
    return status;
}

batten_status bat_step_read_placement(const bat_step_file *file,
                                      const bat_step_instance *instance,
                                      const bat_step_scale *scale, batten_frame *frame)
{
    const bat_step_reading reading = bat_step_reading_of(file, scale);
    return bat_step_frame_in(&reading, instance, frame);
}
