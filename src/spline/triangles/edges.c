/* The edges of triangles, sorted: those that two triangles share stand together. */
#include "spline/triangles/triangles.h"

#include <stdlib.h>

static int compare_edges(const void *a, const void *b)
{
    const bat_triangle_edge *first = a, *second = b;
    if (first->low != second->low)
        return first->low < second->low ? -1 : 1;
    if (first->high != second->high)
        return first->high < second->high ? -1 : 1;
    if (first->triangle != second->triangle)
        return first->triangle < second->triangle ? -1 : 1;
    return first->edge - second->edge;
}

batten_status bat_triangle_edges(int count, const int *corners, bat_triangle_edge **out)
{
    bat_triangle_edge *edges = bat_array3((size_t)count, 3, sizeof *edges);
    if (!edges)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < 3 * count; i++) {
        const int t = i / 3, e = i % 3;
        const int a = corners[3 * t + (e + 1) % 3], b = corners[3 * t + (e + 2) % 3];
        edges[i] = (bat_triangle_edge){bat_min_int(a, b), bat_max_int(a, b), t, e};
    }
    qsort(edges, 3 * (size_t)count, sizeof *edges, compare_edges);
    *out = edges;
    return BATTEN_OK;
}
