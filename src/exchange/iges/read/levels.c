/* Levels as layers, with the names that properties (406 form 3) give them. */
#include "exchange/iges/read/levels.h"
#include "base/real.h"
#include "exchange/iges/read/references.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    int level;
    size_t place; /* of its property: of several with one level the first counts */
    char *name;
} named_level;

void bat_iges_start_levels(bat_iges_reading *reading)
{
    reading->levels = (bat_list){.size = sizeof(named_level)};
}

void bat_iges_end_levels(bat_iges_reading *reading)
{
    named_level *levels = reading->levels.items;
    for (size_t k = 0; k < reading->levels.count; k++)
        bat_release(levels[k].name);
    bat_release(reading->levels.items);
}

static batten_status copy_text(bat_input *input, bat_span text, char **out)
{
    char *copied = NULL;
    const batten_status status = bat_input_array(input, text.length + 1, 1, &copied);
    if (status != BATTEN_OK)
        return status;
    if (text.length > 0)
        memcpy(copied, text.bytes, text.length);
    *out = copied;
    return BATTEN_OK;
}

/* A property that names the level it is in, or, as some have it, that its number says. */
static batten_status read_level(bat_iges_reading *reading, const bat_iges_entry *entry,
                                size_t place)
{
    named_level made = {.level = entry->level, .place = place};
    bat_iges_item item;
    bool is_string = false;
    batten_status status = bat_iges_open(reading, entry, &item);
    if (status == BATTEN_OK && made.level <= 0)
        status = bat_iges_integer(item.parameters, 2, &made.level);
    if (status == BATTEN_OK) {
        const bat_span text = bat_iges_text(item.parameters, 3, &is_string);
        if (is_string && text.length > 0 && made.level > 0)
            status = copy_text(reading->input, text, &made.name);
    }
    if (status == BATTEN_OK && made.name) {
        status = bat_list_add(reading->input, &reading->levels, &made);
        if (status != BATTEN_OK)
            bat_release(made.name);
    }
    bat_iges_close(&item);
    return bat_iges_is_fault_of_data(status) ? BATTEN_OK : status;
}

static int compare(const void *a, const void *b)
{
    const named_level *p = a, *q = b;
    return p->level != q->level ? (p->level > q->level) - (p->level < q->level)
                                : (p->place > q->place) - (p->place < q->place);
}

batten_status bat_iges_read_levels(bat_iges_reading *reading)
{
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < reading->file.entries.count; k++) {
        const bat_iges_entry *entry = bat_iges_entry_at(reading, k);
        if (entry->type == 406 && entry->form == 3 && !entry->is_broken)
            status = read_level(reading, entry, k);
    }
    if (reading->levels.count > 1)
        qsort(reading->levels.items, reading->levels.count, sizeof(named_level), compare);
    return status;
}

/* NULL when it has none. */
static const char *name_of_level(const bat_iges_reading *reading, int level)
{
    const named_level *levels = reading->levels.items;
    size_t low = 0, high = reading->levels.count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (levels[middle].level < level)
            low = middle + 1;
        else
            high = middle;
    }
    return low < reading->levels.count && levels[low].level == level ? levels[low].name : NULL;
}

/* The first of the levels that a property 406 form 1 lists. */
static batten_status first_level(bat_iges_reading *reading, const bat_iges_entry *of,
                                 int *level)
{
    const int id = -of->level;
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    int count = 1;
    batten_status status = bat_iges_find_type(reading, id, 406, &entry);
    if (status == BATTEN_OK && entry->form != 1)
        status =
            bat_fail(BATTEN_BAD_FORMAT,
                     "it refers to entity D%d as a list of levels, form 1, which is of form %d",
                     id, entry->form);
    if (status != BATTEN_OK)
        return status;
    status = bat_iges_open(reading, entry, &item);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item.parameters, 1, &count);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item.parameters, 2, level);
    bat_iges_close(&item);
    if (status == BATTEN_OK && count > 1)
        bat_iges_count_odd(&reading->many_levels, of, id);
    return bat_iges_fault_in(status, id);
}

batten_status bat_iges_layer(bat_iges_reading *reading, const bat_iges_entry *entry,
                             char **layer)
{
    char number[BAT_INTEGER_SIZE] = "";
    int level = entry->level;
    batten_status status = BATTEN_OK;
    if (level < 0) {
        level = 0;
        status = bat_iges_forgive(first_level(reading, entry, &level), &reading->wrong_levels,
                                  entry, entry->level);
    }
    if (status != BATTEN_OK)
        return status;
    const char *name = level > 0 ? name_of_level(reading, level) : NULL;
    if (level > 0)
        bat_integer_write(level, number);
    if (!name)
        name = number;
    return copy_text(reading->input, (bat_span){name, strlen(name)}, layer);
}
