/* The feature 'collect': the objects of several features as one. */
#include "design/feature.h"

#include <stdio.h>
#include <string.h>

static const batten_parameter parameters[] = {
    {"collect", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "what is put together"},
};

/* The names that are taken: an open hash of them, at most half full. */
typedef struct {
    size_t size; /* a power of two */
    const char **slots;
} name_set;

/* Where the name is, or would be: FNV-1a. */
static size_t slot_of(const name_set *names, const char *name)
{
    uint64_t hash = 14695981039346656037u;
    for (const char *c = name; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 1099511628211u;
    size_t at = (size_t)(hash & (names->size - 1));
    while (names->slots[at] && strcmp(names->slots[at], name) != 0)
        at = (at + 1) & (names->size - 1);
    return at;
}

/* A name that another object has already gets a number. */
static batten_status add_under_new_name(bat_run *run, const batten_object *object,
                                        name_set *names)
{
    batten_object named = *object;
    char name[220];
    named.name = name;
    snprintf(name, sizeof name, "%.200s", object->name);
    for (int i = 2; names->slots[slot_of(names, name)]; i++)
        snprintf(name, sizeof name, "%.200s (%d)", object->name, i);
    const batten_status status = bat_add(run, &named);
    if (status == BATTEN_OK)
        names->slots[slot_of(names, name)] =
            batten_model_object(run->model, batten_model_count(run->model) - 1)->name;
    return status;
}

static batten_status run_collect(bat_run *run)
{
    bat_objects all;
    name_set names = {1, NULL};
    batten_status status = bat_gather(run, "collect", BAT_ALL, &all);
    if (status != BATTEN_OK)
        return status;
    while (names.size < 2 * (size_t)all.count + 1)
        names.size *= 2;
    names.slots = bat_array(names.size, sizeof *names.slots);
    status = names.slots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < all.count; i++)
        status = add_under_new_name(run, all.at[i], &names);
    bat_release(names.slots);
    bat_objects_release(&all);
    return status;
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
