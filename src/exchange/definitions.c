#include "exchange/definitions.h"

#include <limits.h>
#include <stdint.h>

/* Where the model is in the table, or would be. */
static size_t place_of(const bat_definitions *d, const batten_model *model)
{
    const uint64_t mixed = (uint64_t)(uintptr_t)model * 0x9e3779b97f4a7c15u;
    size_t at = (size_t)(mixed >> 20) & (d->capacity - 1);
    while (d->table[at] && d->models[d->table[at] - 1] != model)
        at = (at + 1) & (d->capacity - 1);
    return at;
}

static batten_status grow(bat_definitions *d)
{
    const size_t capacity = d->capacity ? 2 * d->capacity : 16;
    const batten_model **models = bat_resize(d->models, capacity, sizeof *models);
    if (models)
        d->models = models;
    int *table = models ? bat_array(capacity, sizeof *table) : NULL;
    if (!table)
        return BATTEN_OUT_OF_MEMORY;
    bat_release(d->table);
    d->table = table;
    d->capacity = capacity;
    for (int i = 0; i < d->count; i++)
        d->table[place_of(d, d->models[i])] = i + 1;
    return BATTEN_OK;
}

static batten_status add(bat_definitions *d, const batten_model *model)
{
    if (2 * (size_t)(d->count + 1) > d->capacity) {
        batten_status status = grow(d);
        if (status != BATTEN_OK)
            return status;
    }
    const size_t at = place_of(d, model);
    if (!d->table[at]) {
        d->models[d->count] = model;
        d->table[at] = ++d->count;
    }
    return BATTEN_OK;
}

batten_status bat_definitions_find(const batten_model *model, bat_definitions *d)
{
    batten_status status = add(d, model);
    double objects = 0;
    for (int i = 0; status == BATTEN_OK && i < d->count; i++) {
        const int count = batten_model_count(d->models[i]);
        objects += count;
        for (int k = 0; status == BATTEN_OK && k < count; k++) {
            const batten_object *object = batten_model_object(d->models[i], k);
            if (object->definition)
                status = add(d, object->definition);
        }
    }
    if (status == BATTEN_OK && objects > INT_MAX / 4)
        status = bat_fail(BATTEN_TOO_LARGE, "%.0f objects are too many", objects);
    if (status != BATTEN_OK)
        return status;
    d->first = bat_array((size_t)d->count + 1, sizeof *d->first);
    if (!d->first)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < d->count; i++)
        d->first[i + 1] = d->first[i] + batten_model_count(d->models[i]);
    return BATTEN_OK;
}

void bat_definitions_end(bat_definitions *d)
{
    bat_release(d->models);
    bat_release(d->table);
    bat_release(d->first);
}

int bat_definitions_index(const bat_definitions *d, const batten_model *model)
{
    return d->table[place_of(d, model)] - 1;
}

void bat_definitions_rising(const bat_definitions *d, int *order)
{
    const int deepest = batten_model_depth(d->models[0]); /* 32 at most */
    for (int depth = 0, at = 0; depth <= deepest; depth++)
        for (int i = 0; i < d->count; i++)
            if (batten_model_depth(d->models[i]) == depth)
                order[at++] = i;
}

static void find_names(const bat_definitions *d, const char **names)
{
    for (int i = 0; i < d->count; i++)
        for (int k = 0; k < batten_model_count(d->models[i]); k++) {
            const batten_object *object = batten_model_object(d->models[i], k);
            if (!object->definition)
                continue;
            const char **name = &names[bat_definitions_index(d, object->definition)];
            *name = *name ? *name : object->name;
        }
}

batten_status bat_definitions_each(const bat_definitions *d, bat_definition_take *take,
                                   void *context)
{
    int *order = bat_array((size_t)d->count, sizeof *order);
    const char **names = bat_array((size_t)d->count, sizeof *names);
    batten_status status = order && names ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        bat_definitions_rising(d, order);
        find_names(d, names);
    }
    for (int i = 0; status == BATTEN_OK && i < d->count; i++)
        status = take(context, order[i], names[order[i]] ? names[order[i]] : "");
    bat_release(order);
    bat_release(names);
    return status;
}
