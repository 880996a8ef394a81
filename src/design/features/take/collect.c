/* The feature 'collect': the objects of several features as one. */
#include "design/feature.h"

#include <stdio.h>

static const batten_parameter parameters[] = {
    {"collect", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "what is put together"},
};

/* A name that another object has already gets a number. */
static batten_status add_under_new_name(bat_run *run, const batten_object *object)
{
    batten_object named = *object;
    char name[220];
    named.name = name;
    snprintf(name, sizeof name, "%.200s", object->name);
    for (int i = 2; batten_model_find(run->model, name) >= 0; i++)
        snprintf(name, sizeof name, "%.200s (%d)", object->name, i);
    return bat_add(run, &named);
}

static batten_status run_collect(bat_run *run)
{
    return bat_for_objects(run, "collect", BAT_ALL, add_under_new_name);
}

const bat_feature bat_feature_collect = {
    .shown = {"collect", "The objects of several features as one",
              "Objects with the same name in two of them get a number: 'row (2)'.",
              "features:\n"
              "  low: {points: [[0, 0], [1, 0]]}\n"
              "  high: {points: [[0, 1], [1, 1]]}\n"
              "  all: {collect: [low, high]}\n",
              "", "batten_model_add", BAT_PARAMETERS(parameters), false,
              .also = "group, combine, assemble"},
    .run = run_collect};
