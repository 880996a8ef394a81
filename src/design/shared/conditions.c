/* Conditions at the start and the end of sections and rows, from their words and vectors. */
#include "design/shared/conditions.h"

#include <stdio.h>
#include <string.h>

typedef struct {
    const bat_run *run;
    const bat_data *data;
    batten_condition *conditions;
    int count;
} asking;

/* A point or direction in the coordinates of the data. */
static void project(const bat_data *data, const double *given, double out[3])
{
    int k = 0;
    memset(out, 0, 3 * sizeof *out);
    for (int c = 0; c < 3; c++)
        if (data->axis != c)
            out[k++] = given[c];
}

static batten_condition *next_condition(asking *a, batten_condition_kind kind)
{
    batten_condition *condition = &a->conditions[a->count++];
    *condition = (batten_condition){.kind = kind, .index = -1};
    return condition;
}

/* The nearest of the data; a curve has no other place for a point. */
static batten_status find_datum(const asking *a, int number, const double *point, int *out)
{
    const bat_data *data = a->data;
    const size_t d = (size_t)data->dimension;
    double least = HUGE_VAL;
    for (int i = 0; i < data->count; i++) {
        const double *q = data->points + (size_t)i * d;
        const double distance =
            bat_hypot(bat_hypot(q[0] - point[0], q[1] - point[1]), d > 2 ? q[2] - point[2] : 0);
        if (distance < least) {
            least = distance;
            *out = i;
        }
    }
    if (least <= bat_tolerance(a->run))
        return BATTEN_OK;
    return bat_fail(
        BATTEN_BAD_ARGUMENT,
        "point %d of 'pass' is not one of the points: the nearest, point %d, is %g away",
        number + 1, *out + 1, least);
}

static batten_status ask_points(asking *a, const char *parameter, batten_condition_kind kind)
{
    const bat_argument *given = bat_argument_of(a->run, parameter);
    const bool function = a->data->dimension == 1;
    if (given->count > 0 && !function && kind != BATTEN_CONDITION_EQUAL)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' is for functions: add 'as: function'",
                        parameter);
    for (int i = 0; i < given->count; i++) {
        double point[3];
        batten_condition *condition = next_condition(a, kind);
        project(a->data, given->items[i].number, point);
        if (function) {
            condition->parameter = point[0];
            condition->value[0] = point[1];
            continue;
        }
        const batten_status status = find_datum(a, i, point, &condition->index);
        if (status != BATTEN_OK)
            return status;
        memcpy(condition->value, point, sizeof point);
    }
    return BATTEN_OK;
}

static batten_status ask_direction(asking *a, const char *parameter, bool at_end)
{
    if (!bat_has(a->run, parameter))
        return BATTEN_OK;
    double along[3];
    const bool function = a->data->dimension == 1;
    project(a->data, bat_argument_of(a->run, parameter)->items[0].number, along);
    if (bat_yes(a->run, "closed"))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a closed curve has no ends: '%s'", parameter);
    if (function && !(along[0] > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'%s' must go forward along the abscissa of the function", parameter);
    batten_condition *condition =
        next_condition(a, function ? BATTEN_CONDITION_EQUAL : BATTEN_CONDITION_DIRECTION);
    condition->index = at_end ? a->data->count - 1 : 0;
    condition->order = 1;
    memcpy(condition->value, along, sizeof along);
    if (function)
        condition->value[0] = along[1] / along[0];
    return BATTEN_OK;
}

static batten_status ask_places(asking *a)
{
    batten_status status = ask_points(a, "pass", BATTEN_CONDITION_EQUAL);
    if (status == BATTEN_OK)
        status = ask_points(a, "over", BATTEN_CONDITION_AT_LEAST);
    if (status == BATTEN_OK)
        status = ask_points(a, "under", BATTEN_CONDITION_AT_MOST);
    if (status == BATTEN_OK)
        status = ask_direction(a, "start-direction", false);
    if (status == BATTEN_OK)
        status = ask_direction(a, "end-direction", true);
    return status;
}

static batten_status ask_band(const asking *a, batten_curve_least_squares_options *options)
{
    if (!bat_has(a->run, "within"))
        return BATTEN_OK;
    options->band = bat_number(a->run, "within");
    if (!(options->band > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "'within' is %g; it must be above 0",
                        options->band);
    return BATTEN_OK;
}

static batten_status ask_shape(const asking *a, batten_curve_least_squares_options *options)
{
    const bat_argument *shape = bat_argument_of(a->run, "shape");
    for (int i = 0; i < shape->count; i++)
        options->shape |= 1u << shape->items[i].count;
    options->side = (batten_fit_side)bat_word(a->run, "side");
    if (a->data->dimension > 1 && (options->shape || options->side != BATTEN_FIT_BOTH))
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' is for functions: add 'as: function'",
                        options->shape ? "shape" : "side");
    return BATTEN_OK;
}

static batten_status ask_all(asking *a, batten_curve_least_squares_options *options)
{
    batten_status status = ask_places(a);
    if (status == BATTEN_OK)
        status = ask_shape(a, options);
    return status == BATTEN_OK ? ask_band(a, options) : status;
}

batten_status bat_conditions_of(const bat_run *run, const bat_data *data,
                                batten_curve_least_squares_options *options,
                                batten_condition **conditions)
{
    asking a = {.run = run, .data = data};
    const size_t most = (size_t)bat_argument_of(run, "pass")->count +
                        (size_t)bat_argument_of(run, "over")->count +
                        (size_t)bat_argument_of(run, "under")->count + 2;
    a.conditions = bat_array(most, sizeof *a.conditions);
    if (!a.conditions)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = ask_all(&a, options);
    if (status != BATTEN_OK) {
        bat_release(a.conditions);
        return status;
    }
    options->conditions = *conditions = a.conditions;
    options->condition_count = a.count;
    return BATTEN_OK;
}

/* ---- outliers ---- */

/* "3, 8, 12 ...": of points, counted from 1 */
static void list_points(int count, const int *indices, size_t size, char *out)
{
    size_t length = 0;
    for (int i = 0; i < count; i++) {
        if (length + 20 > size) {
            snprintf(out + length, size - length, " ...");
            return;
        }
        length += (size_t)snprintf(out + length, size - length, "%s%d", i > 0 ? ", " : "",
                                   indices[i] + 1);
    }
}

batten_status bat_note_outliers(bat_run *run, const bat_data *data, const double *weights,
                                const bat_made *made)
{
    char numbers[160] = "";
    double distance;
    int count = 0, *outliers = bat_array((size_t)data->count, sizeof *outliers);
    if (!outliers)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_curve_outliers(
        made->curve,
        &(batten_fit_data){{batten_curve_dimension(made->curve), data->count, data->points},
                           made->parameters,
                           weights},
        5, &distance, outliers, &count);
    if (status == BATTEN_OK && count > 0) {
        list_points(count, outliers, sizeof numbers, numbers);
        bat_note(run,
                 "'%s': %d of %d points are outliers, farther than %.4g from the curve, five "
                 "times the median distance: %s",
                 data->name, count, data->count, distance, numbers);
    }
    bat_release(outliers);
    return status;
}
