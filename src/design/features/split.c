#include "design/feature.h"

#include <stdio.h>

static const batten_parameter parameters[] = {
    {"split", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves and surfaces"},
    {"parameter", BATTEN_VALUE_NUMBER, false, true, NULL, NULL, "where they are cut"},
    {"direction", BATTEN_VALUE_WORD, false, false, "u", "u v", "of surfaces"},
};

static batten_status split_object(bat_run *run, const batten_object *object)
{
    batten_curve *curves[2] = {NULL, NULL};
    batten_surface *surfaces[2] = {NULL, NULL};
    const double at = bat_number(run, "parameter");
    const bool is_curve = object->kind == BATTEN_OBJECT_CURVE;
    batten_status status =
        is_curve ? batten_curve_split(object->curve, at, &curves[0], &curves[1])
                 : batten_surface_split(object->surface,
                                        (batten_direction)bat_word(run, "direction"), at,
                                        &surfaces[0], &surfaces[1]);
    for (int i = 0; i < 2; i++) {
        batten_object half = *object;
        char name[220];
        snprintf(name, sizeof name, "%.200s %d", object->name, i + 1);
        half.name = name;
        status = is_curve ? bat_put_curve_like(run, status, curves[i], &half, false)
                          : bat_put_surface_like(run, status, surfaces[i], &half);
    }
    return status;
}

static batten_status run(bat_run *run)
{
    bat_objects objects;
    batten_status status = bat_gather(run, "split", BAT_CURVES | BAT_SURFACES, &objects);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = split_object(run, objects.at[i]);
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_split = {
    .shown = {"split", "Both parts of what is cut at a parameter",
              "Exact; the parts of 'keel' are named 'keel 1' and 'keel 2' and keep their "
              "parameters.",
              "features:\n"
              "  keel: {line: [[0, 0], [3 m, 0]]}\n"
              "  halves: {split: keel, parameter: 0.5}\n",
              "[PT97]", "batten_curve_split", BAT_PARAMETERS(parameters), false},
    .run = run};
