/* The models that instances place, each once, listed in the order of what they place. */
#include "model/definitions.h"
#include "base/list.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

static batten_status add_definition(bat_definitions *d, const batten_model *model)
{
    if (bat_addresses_find(&d->addresses, model) >= 0)
        return BATTEN_OK;
    batten_status status = BAT_LIST_GROW(d->models, d->count, d->capacity, 1);
    if (status == BATTEN_OK)
        status = bat_addresses_add(&d->addresses, model, d->count);
    if (status == BATTEN_OK)
        d->models[d->count++] = model;
    return status;
}

batten_status bat_definitions_find(const batten_model *model, bat_definitions *d)
{
    batten_status status = add_definition(d, model);
    double objects = 0;
    for (int i = 0; status == BATTEN_OK && i < d->count; i++) {
        const int count = batten_model_count(d->models[i]);
        objects += count;
        for (int k = 0; status == BATTEN_OK && k < count; k++) {
            const batten_object *object = batten_model_object(d->models[i], k);
            if (object->definition)
                status = add_definition(d, object->definition);
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
    bat_addresses_end(&d->addresses);
    bat_release(d->first);
}

int bat_definitions_index(const bat_definitions *d, const batten_model *model)
{
    return bat_addresses_find(&d->addresses, model);
}

typedef struct {
    const batten_object *object;
    int mesh, number;
} object_look;

static int compare_looks(const void *left, const void *right)
{
    const object_look *a = left, *b = right;
    if (a->mesh != b->mesh)
        return a->mesh < b->mesh ? -1 : 1;
    if (a->object->has_colour != b->object->has_colour)
        return a->object->has_colour ? 1 : -1;
    for (int k = 0; a->object->has_colour && k < 3; k++)
        if (a->object->colour[k] != b->object->colour[k])
            return a->object->colour[k] < b->object->colour[k] ? -1 : 1;
    return strcmp(a->object->name, b->object->name);
}

static int compare_numbered(const void *left, const void *right)
{
    const int by_look = compare_looks(left, right);
    return by_look ? by_look
                   : ((const object_look *)left)->number - ((const object_look *)right)->number;
}

/* The first object of each mesh; all objects as they are to be sorted. */
static batten_status find_meshes(const bat_definitions *d, int *mesh, object_look *all)
{
    bat_addresses meshes = {0};
    batten_status status = BATTEN_OK;
    for (int i = 0; i < d->count; i++)
        for (int k = 0; status == BATTEN_OK && k < batten_model_count(d->models[i]); k++) {
            const batten_object *object = batten_model_object(d->models[i], k);
            const int number = d->first[i] + k;
            const int first = object->mesh ? bat_addresses_find(&meshes, object->mesh) : -1;
            mesh[number] = first < 0 ? number : first;
            all[number] = (object_look){object, mesh[number], number};
            if (object->mesh && first < 0)
                status = bat_addresses_add(&meshes, object->mesh, number);
        }
    bat_addresses_end(&meshes);
    return status;
}

batten_status bat_definitions_meshes(const bat_definitions *d, int *mesh, int *look)
{
    const int count = d->first[d->count];
    object_look *all = bat_array((size_t)count, sizeof *all);
    const batten_status status = all ? find_meshes(d, mesh, all) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && count)
        qsort(all, (size_t)count, sizeof *all, compare_numbered);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        look[all[i].number] = i && compare_looks(&all[i - 1], &all[i]) == 0
                                  ? look[all[i - 1].number]
                                  : all[i].number;
    bat_release(all);
    return status;
}

void bat_definitions_rising(const bat_definitions *d, int *order)
{
    const int deepest = batten_model_depth(d->models[0]); /* 32 at most */
    for (int depth = 0, at = 0; depth <= deepest; depth++)
        for (int i = 0; i < d->count; i++)
            if (batten_model_depth(d->models[i]) == depth)
                order[at++] = i;
}

void bat_definitions_names(const bat_definitions *d, const char **names)
{
    for (int i = 0; i < d->count; i++)
        names[i] = batten_model_name(d->models[i]);
    for (int i = 0; i < d->count; i++)
        for (int k = 0; k < batten_model_count(d->models[i]); k++) {
            const batten_object *object = batten_model_object(d->models[i], k);
            if (!object->definition)
                continue;
            const char **name = &names[bat_definitions_index(d, object->definition)];
            *name = **name ? *name : object->name;
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
        bat_definitions_names(d, names);
    }
    for (int i = 0; status == BATTEN_OK && i < d->count; i++)
        status = take(context, order[i], names[order[i]]);
    bat_release(order);
    bat_release(names);
    return status;
}
