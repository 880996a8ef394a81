/* Edges of meshes as polylines that are as long as can be. */
#include "picture/lines/stroke.h"

#include <string.h>

typedef struct {
    const double *points;
    const int (*ends)[2];
    size_t *first;  /* [vertices + 1] into `inside` */
    size_t *inside; /* edges by vertices */
    bool *used;
    int *path; /* [edges + 1] */
    bat_strokes *out;
} chaining;

static size_t degree(const chaining *c, int vertex)
{
    return c->first[vertex + 1] - c->first[vertex];
}

static void sort_by_vertices(chaining *c, int vertex_count, size_t count)
{
    for (size_t i = 0; i < 2 * count; i++)
        c->first[c->ends[i / 2][i % 2] + 1]++;
    for (int v = 0; v < vertex_count; v++)
        c->first[v + 1] += c->first[v];
    /* Filling moves each beginning to its end; shift them back. */
    for (size_t i = 0; i < 2 * count; i++)
        c->inside[c->first[c->ends[i / 2][i % 2]]++] = i / 2;
    memmove(c->first + 1, c->first, (size_t)vertex_count * sizeof *c->first);
    c->first[0] = 0;
}

static batten_status add_path(chaining *c, size_t count)
{
    double *points = bat_array3(count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < count; i++)
        memcpy(points + 3 * i, c->points + 3 * (size_t)c->path[i], 3 * sizeof *points);
    return bat_strokes_add(c->out, (bat_stroke){count, points});
}

/* From a vertex along an edge until no edge leads on, or more than one does. */
static batten_status walk(chaining *c, int vertex, size_t edge)
{
    size_t count = 0;
    c->path[count++] = vertex;
    for (bool goes_on = true; goes_on;) {
        c->used[edge] = true;
        vertex = c->ends[edge][0] == vertex ? c->ends[edge][1] : c->ends[edge][0];
        c->path[count++] = vertex;
        goes_on = false;
        for (size_t i = 0; degree(c, vertex) == 2 && i < 2 && !goes_on; i++) {
            const size_t next = c->inside[c->first[vertex] + i];
            goes_on = !c->used[next];
            edge = goes_on ? next : edge;
        }
    }
    return add_path(c, count);
}

static batten_status walk_all(chaining *c, int vertex_count, size_t count)
{
    batten_status status = BATTEN_OK;
    for (int v = 0; v < vertex_count && status == BATTEN_OK; v++)
        for (size_t i = c->first[v];
             i < c->first[v + 1] && degree(c, v) != 2 && status == BATTEN_OK; i++)
            if (!c->used[c->inside[i]])
                status = walk(c, v, c->inside[i]);
    /* What is left are rings. */
    for (size_t i = 0; i < count && status == BATTEN_OK; i++)
        if (!c->used[i])
            status = walk(c, c->ends[i][0], i);
    return status;
}

batten_status bat_chain_edges(int vertex_count, const double *points, size_t count,
                              const int (*ends)[2], bat_strokes *out)
{
    chaining c = {.points = points, .ends = ends, .out = out};
    c.first = bat_array((size_t)vertex_count + 2, sizeof *c.first);
    c.inside = bat_array3(count, 2, sizeof *c.inside);
    c.used = bat_array(count, sizeof *c.used);
    c.path = bat_array(count + 1, sizeof *c.path);
    batten_status status =
        c.first && c.inside && c.used && c.path ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        sort_by_vertices(&c, vertex_count, count);
        status = walk_all(&c, vertex_count, count);
    }
    bat_release(c.first);
    bat_release(c.inside);
    bat_release(c.used);
    bat_release(c.path);
    return status;
}
