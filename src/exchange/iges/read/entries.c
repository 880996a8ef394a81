/* The entries of the directory: their types, how they are found by their ids. */
#include "exchange/iges/read/references.h"

#include <stdio.h>

const bat_iges_row *bat_iges_row_of(const bat_iges_reading *reading, int type)
{
    static const bat_iges_row unknown = {-1, "entity", BAT_IGES_UNKNOWN, 0, 0, NULL, NULL};
    const bat_iges_row *rows = reading->types.rows;
    size_t low = 0, high = reading->types.count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (rows[middle].type == type)
            return &rows[middle];
        if (rows[middle].type < type)
            low = middle + 1;
        else
            high = middle;
    }
    return &unknown;
}

void bat_iges_name_of_type(const bat_iges_reading *reading, int type,
                           char name[BAT_IGES_TYPE_NAME])
{
    const bat_iges_row *row = bat_iges_row_of(reading, type);
    if (row->type == type)
        snprintf(name, BAT_IGES_TYPE_NAME, "%s", row->name);
    else
        snprintf(name, BAT_IGES_TYPE_NAME, "%d, an unknown type", type);
}

const bat_iges_entry *bat_iges_entry_at(const bat_iges_reading *reading, size_t place)
{
    return (const bat_iges_entry *)reading->file.entries.items + place;
}

size_t bat_iges_place_of(const bat_iges_reading *reading, const bat_iges_entry *entry)
{
    return (size_t)(entry - (const bat_iges_entry *)reading->file.entries.items);
}

bat_iges_shape *bat_iges_shape_of(const bat_iges_reading *reading, const bat_iges_entry *entry)
{
    return &reading->shapes[bat_iges_place_of(reading, entry)];
}

batten_status bat_iges_find(const bat_iges_reading *reading, int id, const bat_iges_entry **out)
{
    const bat_iges_entry *entries = reading->file.entries.items;
    size_t low = 0, high = reading->file.entries.count;
    if (id <= 0 || id % 2 == 0)
        return bat_fail(BATTEN_BAD_FORMAT, "%d is not the odd number of an entity", id);
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (entries[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == reading->file.entries.count || entries[low].id != id)
        return bat_fail(BATTEN_BAD_FORMAT, "it refers to entity D%d, which is missing", id);
    if (entries[low].is_broken)
        return bat_fail(BATTEN_BAD_FORMAT, "it refers to entity D%d, which is damaged", id);
    *out = &entries[low];
    return BATTEN_OK;
}

batten_status bat_iges_find_type(const bat_iges_reading *reading, int id, int type,
                                 const bat_iges_entry **out)
{
    const bat_iges_entry *entry = NULL;
    batten_status status = bat_iges_find(reading, id, &entry);
    if (status == BATTEN_OK && entry->type != type)
        status = bat_fail(BATTEN_BAD_FORMAT,
                          "it refers to entity D%d as type %d, which is of type %d", id, type,
                          entry->type);
    if (status == BATTEN_OK)
        *out = entry;
    return status;
}

batten_status bat_iges_count_read(bat_iges_reading *reading, int type)
{
    return bat_census_read(reading->input, &reading->census,
                           bat_iges_row_of(reading, type)->name);
}

batten_status bat_iges_count_left_out(bat_iges_reading *reading, int type)
{
    char name[BAT_IGES_TYPE_NAME];
    bat_iges_name_of_type(reading, type, name);
    return bat_census_leave(reading->input, &reading->census, name);
}
