/* Reads subfigures (308) as definitions, once each, and their instances (408). */
#include "exchange/iges/read/instances.h"
#include "exchange/iges/read/attributes.h"
#include "exchange/iges/read/objects.h"
#include "exchange/iges/read/references.h"

#include <string.h>

/* DEPTH, NAME, N, members: a model of its own. */
batten_status bat_iges_read_definition(bat_iges_item *item)
{
    bat_iges_reading *reading = item->reading;
    int count = 0;
    batten_status status = bat_iges_read_count(item, 3, 4, 1, &count);
    if (status == BATTEN_OK)
        status = batten_model_create(reading->unit_metres, &item->definition);
    if (status == BATTEN_OK)
        status = bat_iges_call(reading->input, item->parameters, 2, item->definition);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_iges_entry *member = NULL;
        int id = 0;
        status = bat_iges_integer(item->parameters, 4 + (size_t)k, &id);
        if (status == BATTEN_OK)
            status = bat_iges_find(reading, id, &member);
        if (status == BATTEN_OK &&
            bat_iges_row_of(reading, member->type)->kind == BAT_IGES_AUXILIARY)
            continue;
        if (status == BATTEN_OK)
            status = bat_iges_add(reading, member, item->definition);
    }
    item->own = 4 + (size_t)count;
    return status;
}

/* The model of a 308, made once. */
static batten_status definition(bat_iges_reading *reading, int id, batten_model **out)
{
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    batten_status status = bat_iges_find_type(reading, id, 308, &entry);
    if (status != BATTEN_OK)
        return status;
    bat_iges_shape *shape = bat_iges_shape_of(reading, entry);
    if (shape->state == BAT_IGES_BUSY)
        return bat_fail(BATTEN_BAD_FORMAT, "subfigure D%d contains itself", id);
    if (shape->state == BAT_IGES_BAD)
        return bat_fail(BATTEN_BAD_FORMAT, "it refers to entity D%d, which cannot be read", id);
    if (shape->state == BAT_IGES_NEW) {
        shape->state = BAT_IGES_BUSY;
        status = bat_iges_decode(reading, entry, &item);
        if (status == BATTEN_OK)
            shape->definition = batten_model_ref(item.definition);
        if (status == BATTEN_OK)
            status = bat_census_read(reading->input, &reading->census, item.row->name);
        bat_iges_close(&item);
        shape->state = status == BATTEN_OK ? BAT_IGES_READ : BAT_IGES_BAD;
    }
    if (status == BATTEN_OK)
        *out = batten_model_ref(shape->definition);
    return status;
}

/* DE, X, Y, Z, S: x' = S x + (X, Y, Z). */
batten_status bat_iges_read_instance(bat_iges_item *item)
{
    int id = 0;
    double move[3], scale = 1;
    batten_status status = bat_iges_integer(item->parameters, 1, &id);
    if (status == BATTEN_OK)
        status = bat_iges_reals(item->parameters, 2, 3, move);
    if (status == BATTEN_OK)
        status = bat_iges_real(item->parameters, 5, &scale);
    if (status != BATTEN_OK)
        return status;
    item->own = 6;
    if (scale == 0)
        scale = 1; /* nothing said */
    item->place = batten_affine_scaling(scale, scale, scale);
    memcpy(item->place.t, move, sizeof move);
    return definition(item->reading, id, &item->definition);
}
