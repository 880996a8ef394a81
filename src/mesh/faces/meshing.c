/* The lists of the mesh in the making: points, triangles, and edges that are taken. */
#include "mesh/faces/meshing.h"
#include "base/list.h"

#include <string.h>

batten_status bat_meshing_triangle(bat_meshing *m, const int corners[3],
                                   const double normals[9], int face)
{
    if (m->triangle_count >= m->most)
        return bat_fail(BATTEN_TOO_LARGE, "the body needs more than %d triangles", m->most);
    /* Three arrays of one length: where one does not grow, the others have room to spare. */
    int rooms[3] = {m->triangle_room, m->triangle_room, m->triangle_room};
    batten_status status = BAT_LIST_GROW(m->corners, m->triangle_count, rooms[0], 1);
    if (status == BATTEN_OK)
        status = BAT_LIST_GROW(m->normals, m->triangle_count, rooms[1], 1);
    if (status == BATTEN_OK)
        status = BAT_LIST_GROW(m->owners, m->triangle_count, rooms[2], 1);
    if (status != BATTEN_OK)
        return status;
    m->triangle_room = rooms[0];
    memcpy(m->corners[m->triangle_count], corners, sizeof *m->corners);
    memcpy(m->normals[m->triangle_count], normals, sizeof *m->normals);
    m->owners[m->triangle_count++] = face;
    return BATTEN_OK;
}

batten_status bat_meshing_take(bat_meshing *m, int face, int a, int b)
{
    int index;
    const bat_across across = {.face = face, .ends = {a, b}};
    const batten_status status =
        BAT_LIST_ADD(m->across, m->across_count, m->across_room, across);
    if (status != BATTEN_OK)
        return status;
    return bat_pairs_add(&m->taken, a, b, &index);
}

batten_status bat_meshing_point(bat_meshing *m, const double point[3], int *index)
{
    /* An eighth of the numbers of int: there are several triangles to a vertex. */
    if (m->point_count > INT_MAX / 8)
        return bat_fail(BATTEN_TOO_LARGE, "a mesh of %d vertices", m->point_count);
    const batten_status status = BAT_LIST_GROW(m->points, m->point_count, m->point_room, 1);
    if (status != BATTEN_OK)
        return status;
    memcpy(m->points[m->point_count], point, sizeof *m->points);
    *index = m->point_count++;
    return BATTEN_OK;
}
