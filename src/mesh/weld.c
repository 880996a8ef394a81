/* Vertices at the same point as one. */
#include "base/base.h"

#include <batten/mesh.h>
#include <stdint.h>
#include <string.h>

typedef struct {
    const batten_mesh_parts *parts;
    size_t mask;
    int *table;  /* vertex + 1, open addresses; 0: empty */
    int *number; /* [vertex_count] of the vertex that it becomes */
    int *first;  /* [made] the vertex that gives point, colour, attributes */
    int made;
} welding;

static size_t place_of(const welding *w, const double *p)
{
    uint64_t mixed = 0;
    for (int k = 0; k < 3; k++) {
        const double x = p[k] + 0.0; /* 0 and -0 are one point */
        uint64_t bits;
        memcpy(&bits, &x, sizeof bits);
        mixed = (mixed ^ bits) * 0x9e3779b97f4a7c15u;
        mixed = (mixed ^ mixed >> 32) * 0xd6e8feb86659fd93u;
    }
    return (size_t)(mixed ^ mixed >> 29) & w->mask;
}

static void number_vertices(welding *w)
{
    for (int v = 0; v < w->parts->vertex_count; v++) {
        const double *p = &w->parts->points[3 * (size_t)v];
        size_t at = place_of(w, p);
        for (; w->table[at]; at = (at + 1) & w->mask) {
            const double *q = &w->parts->points[3 * (size_t)(w->table[at] - 1)];
            if (q[0] == p[0] && q[1] == p[1] && q[2] == p[2])
                break;
        }
        if (w->table[at]) {
            w->number[v] = w->number[w->table[at] - 1];
            continue;
        }
        w->table[at] = v + 1;
        w->first[w->made] = v;
        w->number[v] = w->made++;
    }
}

/* [made][width] of [vertex_count][width]; NULL when memory is exhausted. */
static double *take_firsts(const welding *w, const double *values, size_t width)
{
    double *taken = bat_array3((size_t)w->made, width, sizeof *taken);
    for (int i = 0; taken && i < w->made; i++)
        memcpy(&taken[width * (size_t)i], &values[width * (size_t)w->first[i]],
               width * sizeof *taken);
    return taken;
}

/* The attributes of the first vertex at each point; each with values of its own. */
static batten_status take_attributes(const welding *w, batten_mesh_attribute *made)
{
    for (int k = 0; k < w->parts->attribute_count; k++) {
        const batten_mesh_attribute *source = &w->parts->attributes[k];
        made[k] = (batten_mesh_attribute){source->name, take_firsts(w, source->values, 1)};
        if (!made[k].values)
            return BATTEN_OUT_OF_MEMORY;
    }
    return BATTEN_OK;
}

static batten_status make_welded(const welding *w, batten_mesh **out)
{
    batten_mesh_parts parts = *w->parts;
    const size_t corner_count = 3 * (size_t)parts.triangle_count;
    const size_t attribute_count = (size_t)parts.attribute_count;
    double *points = take_firsts(w, parts.points, 3);
    double *colours = parts.colours ? take_firsts(w, parts.colours, 3) : NULL;
    int *corners = bat_array(corner_count, sizeof *corners);
    batten_mesh_attribute *attributes = bat_array(attribute_count, sizeof *attributes);
    batten_status status = points && corners && attributes && (colours || !parts.colours)
                               ? BATTEN_OK
                               : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = take_attributes(w, attributes);
    if (status == BATTEN_OK) {
        for (size_t i = 0; i < corner_count; i++)
            corners[i] = w->number[parts.corners[i]];
        parts.vertex_count = w->made;
        parts.points = points;
        parts.colours = colours;
        parts.corners = corners;
        parts.attributes = attributes;
        status = batten_mesh_create(&parts, out);
    }
    for (size_t k = 0; attributes && k < attribute_count; k++)
        bat_release((void *)(uintptr_t)attributes[k].values);
    bat_release(attributes);
    bat_release(corners);
    bat_release(colours);
    bat_release(points);
    return status;
}

batten_status batten_mesh_weld(const batten_mesh *mesh, batten_mesh **out)
{
    welding w = {.parts = batten_mesh_view(mesh)};
    const size_t count = (size_t)w.parts->vertex_count;
    size_t size = 4;
    while (size < 2 * count)
        size *= 2;
    w.mask = size - 1;
    w.table = bat_array(size, sizeof *w.table);
    w.number = bat_array(count, sizeof *w.number);
    w.first = bat_array(count, sizeof *w.first);
    batten_status status = w.table && w.number && w.first ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        number_vertices(&w);
        status = make_welded(&w, out);
    }
    bat_release(w.table);
    bat_release(w.number);
    bat_release(w.first);
    return status;
}
