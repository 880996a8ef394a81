/* What styles, layers and groups share: tables of rows that begin with the instance they are
 * about, and what becomes of a mark that is broken. */
#ifndef BAT_STEP_MARKS_H
#define BAT_STEP_MARKS_H
#include "exchange/step/read/topology.h"

#include <stdlib.h>
#include <string.h>

/* A style, layer, group or such that is broken leaves no shape out: it is noted. */
static inline batten_status bat_step_mark_failed(const bat_step_file *file,
                                                 const bat_step_instance *instance,
                                                 batten_status status)
{
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED)
        return status;
    bat_step_warn(file, instance, "%.300s; without effect", batten_message());
    return BATTEN_OK;
}

static inline int bat_step_compare_indices(uint32_t a, uint32_t b)
{
    return (a > b) - (a < b);
}

static inline void bat_step_sort_rows(bat_list *rows, int (*by)(const void *, const void *))
{
    if (rows->count > 1)
        qsort(rows->items, rows->count, rows->size, by);
}

/* The first of the sorted rows whose leading uint32_t is `key`; NULL when there is none. */
static inline const void *bat_step_first_row(const bat_list *list, uint32_t key)
{
    const char *rows = list->items;
    size_t low = 0, high = list->count;
    uint32_t found;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        memcpy(&found, rows + middle * list->size, sizeof found);
        if (found < key)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == list->count)
        return NULL;
    memcpy(&found, rows + low * list->size, sizeof found);
    return found == key ? rows + low * list->size : NULL;
}

#endif
