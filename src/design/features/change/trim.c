/* The feature 'trim': what is left of curves between two places, or beside a plane. */
#include "design/shared/place.h"

#include <batten/extend.h>
#include <batten/measure.h>
#include <stdio.h>

typedef enum { PLANE_X, PLANE_Y, PLANE_Z } plane;
typedef enum { FRONT, BACK } side;

static const batten_parameter parameters[] = {
    {"trim", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"between", BATTEN_VALUE_NUMBER, true, false, NULL, NULL, "two parameters"},
    {"lengths", BATTEN_VALUE_LENGTH, true, false, NULL, NULL,
     "two lengths along the curve from its start; negative: from its end"},
    {"points", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "two points: the part between the points of the curve nearest to them"},
    {"plane", BATTEN_VALUE_WORD, false, false, NULL, "x y z",
     "what is on one side of the plane with this normal"},
    {"at", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "how far the plane is from the origin"},
    {"normal", BATTEN_VALUE_POINT, false, false, NULL, NULL, "any normal, instead of 'plane'"},
    {"side", BATTEN_VALUE_WORD, false, false, "front", "front back",
     "the side of the plane that is kept; front: to which the normal points"},
};

/* ---- between two places ---- */

static batten_status at_lengths(const bat_run *run, const batten_curve *curve, double u[2])
{
    const bat_item *items = bat_argument_of(run, "lengths")->items;
    const double within = bat_tolerance(run) / 1000;
    double whole;
    batten_status status = batten_curve_length(curve, within, NULL, &whole);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        const double given = items[k].number[0], s = given < 0 ? whole + given : given;
        status = batten_curve_at_length(curve, 1, &s, within, &u[k]);
    }
    return status;
}

static batten_status at_points(const bat_run *run, const batten_curve *curve, double u[2])
{
    const bat_item *items = bat_argument_of(run, "points")->items;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        batten_deviation found;
        status = batten_curve_deviation(
            curve, (batten_points){batten_curve_dimension(curve), 1, items[k].number}, NULL,
            NULL, NULL, &found);
        u[k] = found.at[0];
    }
    return status;
}

static batten_status trim_between(bat_run *run, const batten_object *object, const char *by)
{
    double u[2] = {0, 0};
    batten_curve *part = NULL;
    batten_status status = BATTEN_OK;
    if (*by == 'b')
        for (int k = 0; k < 2; k++)
            u[k] = bat_argument_of(run, by)->items[k].number[0];
    else
        status = (*by == 'l' ? at_lengths : at_points)(run, object->curve, u);
    if (status == BATTEN_OK)
        status = batten_curve_trim(object->curve, u[0], u[1], bat_tolerance(run), &part);
    return bat_put_curve_like(run, status, part, object, false);
}

/* ---- by a plane ---- */

static batten_vec3 normal_of(const bat_run *run)
{
    if (bat_has(run, "normal"))
        return bat_point(run, "normal");
    const int which = bat_word(run, "plane");
    return (batten_vec3){which == PLANE_X, which == PLANE_Y, which == PLANE_Z};
}

static batten_status trim_by_plane(bat_run *run, const batten_object *object)
{
    const batten_vec3 n = normal_of(run);
    const double sign = bat_word(run, "side") == BACK ? -1 : 1;
    const double length = bat_hypot(bat_hypot(n.x, n.y), n.z),
                 d = bat_number(run, "at") * length;
    batten_curves parts = {0, NULL};
    batten_status status = batten_curve_trim_plane(
        object->curve, (batten_vec3){sign * n.x, sign * n.y, sign * n.z}, sign * d,
        bat_tolerance(run), &parts);
    if (status != BATTEN_OK)
        return status;
    if (parts.count == 0)
        bat_note(run, "'%s' has nothing on that side", object->name);
    status = bat_put_curves_like(run, object, &parts);
    batten_curves_release(&parts);
    return status;
}

/* ---- all ---- */

/* The one way that was given: NULL is a plane. */
static batten_status which_way(const bat_run *run, const char **by)
{
    static const char *const ways[] = {"between", "lengths", "points"};
    int given = bat_has(run, "plane") || bat_has(run, "normal");
    *by = NULL;
    for (int k = 0; k < 3; k++) {
        const int count = bat_argument_of(run, ways[k])->count;
        if (count == 0)
            continue;
        if (count != 2)
            return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' must be two, there are %d", ways[k],
                            count);
        *by = ways[k];
        given++;
    }
    if (given != 1)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "one of 'between', 'lengths', 'points' and a plane must be given");
    return BATTEN_OK;
}

static batten_status run_trim(bat_run *run)
{
    bat_objects all;
    const char *by;
    batten_status status = which_way(run, &by);
    if (status == BATTEN_OK && bat_has(run, "normal"))
        status = bat_check_direction("normal", bat_point(run, "normal"));
    if (status == BATTEN_OK)
        status = bat_gather(run, "trim", BAT_CURVES, &all);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < all.count && status == BATTEN_OK; i++)
        status = by ? trim_between(run, all.at[i], by) : trim_by_plane(run, all.at[i]);
    bat_objects_release(&all);
    return status;
}

const bat_feature bat_feature_trim = {
    .shown =
        {"trim", "What is left of curves between two places, or beside a plane",
         "Between two parameters, two lengths along the curve, the points nearest to two given\n"
         "ones, or on one side of a plane, which may leave several parts ('rail 1', 'rail 2');\n"
         "curves of which nothing is left are noted. What is left is exact and keeps its\n"
         "parameters. Only on a closed curve may the first end lie behind the second: the part\n"
         "then crosses the seam. A plane that touches without crossing cuts nothing.",
         "features:\n"
         "  rim: {circle: 1 m}\n"
         "  upper: {trim: rim, plane: y, at: 0.5 m}\n"
         "  quarter: {trim: rim, points: [[0, -1 m], [1 m, 0]]}\n"
         "  line: {line: [[0, 0], [3 m, 0]]}\n"
         "  inner: {trim: line, lengths: [0.2 m, -0.2 m]}\n",
         "[PT97]", "batten_curve_trim", BAT_PARAMETERS(parameters), false,
         .also = "cut a curve, clip"},
    .run = run_trim,
    .cuts = true};
