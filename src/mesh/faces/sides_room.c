/* The triangles of a face and their sides: their room, and how it grows. */
#include "mesh/faces/sides.h"
#include "mesh/faces/sides_triangles.h"

#include <batten/scattered.h>
#include <string.h>

/* ---- beginning and end ---- */

void bat_sides_end(bat_sides *s)
{
    bat_release(s->at);
    bat_release(s->of);
    bat_release(s->start);
    bat_release(s->triangles);
    bat_release(s->list);
    bat_release(s->waiting);
    *s = (bat_sides){0};
}

batten_status bat_sides_grow_vertices(bat_sides *s, int room)
{
    double(*places)[2] = bat_resize(s->at, (size_t)room, sizeof *places);
    if (!places)
        return BATTEN_OUT_OF_MEMORY;
    s->at = places;
    int *of = bat_resize(s->of, (size_t)room, sizeof *of);
    if (!of)
        return BATTEN_OUT_OF_MEMORY;
    s->of = of;
    int *start = bat_resize(s->start, (size_t)room, sizeof *start);
    if (!start)
        return BATTEN_OUT_OF_MEMORY;
    s->start = start;
    s->vertex_room = room;
    return BATTEN_OK;
}

batten_status bat_sides_grow_triangles(bat_sides *s, int room)
{
    bat_side_triangle *triangles = bat_resize(s->triangles, (size_t)room, sizeof *triangles);
    if (!triangles)
        return BATTEN_OUT_OF_MEMORY;
    s->triangles = triangles;
    s->room = room;
    return BATTEN_OK;
}

batten_status bat_sides_grow_list(bat_sides *s, int room)
{
    if (room <= s->list_room)
        return BATTEN_OK;
    room = bat_max_int(room, room < INT_MAX / 2 ? 2 * s->list_room : room);
    int *list = bat_resize(s->list, (size_t)room, sizeof *list);
    if (!list)
        return BATTEN_OUT_OF_MEMORY;
    s->list = list;
    s->list_room = room;
    return BATTEN_OK;
}

static batten_status take_triangles(bat_sides *s, const batten_plane_triangles *made)
{
    batten_status status = bat_sides_grow_vertices(s, bat_max_int(64, made->vertex_count));
    if (status == BATTEN_OK)
        status = bat_sides_grow_triangles(s, bat_max_int(64, made->count));
    if (status == BATTEN_OK)
        status = bat_sides_grow_list(s, 64);
    if (status != BATTEN_OK)
        return status;
    s->vertex_count = made->vertex_count;
    s->count = made->count;
    memcpy(s->at, made->vertices, (size_t)made->vertex_count * sizeof *s->at);
    for (int t = 0; t < made->count; t++) {
        bat_side_triangle triangle = {.born = 0};
        for (int k = 0; k < 3; k++) {
            triangle.corner[k] = made->corners[3 * t + k];
            triangle.beside[k] = made->beside[3 * t + k];
            s->of[triangle.corner[k]] = t;
        }
        s->triangles[t] = triangle;
    }
    return BATTEN_OK;
}

batten_status bat_sides_begin(bat_sides *s, int count, const double (*points)[2],
                              int *vertex_of)
{
    batten_plane_triangles made = {0};
    batten_triangulate_options options = batten_triangulate_defaults();
    options.sliver = 0;
    *s = (bat_sides){0};
    batten_status status =
        batten_triangulate((batten_points){2, count, points[0]}, &options, &made);
    if (status != BATTEN_OK)
        return status;
    status = take_triangles(s, &made);
    memcpy(vertex_of, made.vertex_of, (size_t)count * sizeof *vertex_of);
    batten_plane_triangles_release(&made);
    if (status != BATTEN_OK)
        bat_sides_end(s);
    return status;
}
