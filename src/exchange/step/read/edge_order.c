/* Edges in the order of the file, so that what is written again has them as they were. */
#include "exchange/step/read/topology.h"

#include <stdint.h>
#include <stdlib.h>

typedef struct {
    uint32_t instance;
    int index;
} place;

static int compare(const void *a, const void *b)
{
    const place *x = a, *y = b;
    return x->instance != y->instance
               ? (x->instance > y->instance) - (x->instance < y->instance)
               : (x->index > y->index) - (x->index < y->index);
}

static bool is_sorted(const bat_step_edge *edges, int count)
{
    for (int i = 1; i < count; i++)
        if (edges[i].instance < edges[i - 1].instance)
            return false;
    return true;
}

batten_status bat_step_sort_edges(bat_step_topology *t)
{
    const batten_body_parts *p = &t->builder.parts;
    const bat_step_edge *sources = t->edges.items;
    const int count = p->edge_count;
    if (is_sorted(sources, count))
        return BATTEN_OK;
    place *places = bat_array((size_t)count, sizeof *places);
    batten_body_edge *sorted = bat_array((size_t)count, sizeof *sorted);
    int *numbers = bat_array((size_t)count, sizeof *numbers);
    const batten_status status = places && sorted && numbers ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_body_edge *edges = (batten_body_edge *)(uintptr_t)p->edges;
        batten_body_use *uses = (batten_body_use *)(uintptr_t)p->uses;
        for (int i = 0; i < count; i++)
            places[i] = (place){sources[i].instance, i};
        qsort(places, (size_t)count, sizeof *places, compare);
        for (int i = 0; i < count; i++) {
            sorted[i] = edges[places[i].index];
            numbers[places[i].index] = i;
        }
        for (int i = 0; i < count; i++)
            edges[i] = sorted[i];
        for (int i = 0; i < p->use_count; i++)
            uses[i].edge = numbers[uses[i].edge];
    }
    bat_release(places);
    bat_release(sorted);
    bat_release(numbers);
    return status;
}
