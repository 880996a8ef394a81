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

/* ---- beginning and end ---- */

batten_status bat_meshing_begin(bat_meshing *m)
{
    const batten_body_parts *p = m->parts;
    m->edges = bat_array((size_t)p->edge_count, sizeof *m->edges);
    m->use_face = bat_array((size_t)p->use_count, sizeof *m->use_face);
    m->edge_first = bat_array((size_t)p->edge_count + 2, sizeof *m->edge_first);
    m->edge_uses = bat_array((size_t)p->use_count, sizeof *m->edge_uses);
    m->same = bat_array((size_t)p->vertex_count, sizeof *m->same);
    m->touched = bat_array((size_t)p->vertex_count, sizeof *m->touched);
    m->sheets = bat_array((size_t)p->face_count, sizeof *m->sheets);
    m->failed = bat_array((size_t)p->face_count, sizeof *m->failed);
    m->spread = bat_array((size_t)p->face_count, sizeof *m->spread);
    m->done = bat_array((size_t)p->face_count, sizeof *m->done);
    if (!m->edges || !m->use_face || !m->edge_first || !m->edge_uses || !m->sheets ||
        !m->failed || !m->spread || !m->done || !m->same || !m->touched)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < p->face_count; i++) {
        const batten_body_face *face = &p->faces[i];
        bat_sheet_begin(&m->sheets[i], face->surface, p->tolerance);
        for (int k = face->first; k < face->first + face->count; k++)
            for (int j = 0; j < p->loops[k].count; j++)
                m->use_face[p->loops[k].first + j] = i;
    }
    int *next = m->edge_first + 1; /* where the uses of an edge go: its first, at the end */
    for (int i = 0; i < p->use_count; i++)
        if (p->uses[i].edge + 1 < p->edge_count)
            next[p->uses[i].edge + 1]++;
    for (int i = 1; i < p->edge_count; i++)
        next[i] += next[i - 1];
    for (int i = 0; i < p->use_count; i++)
        m->edge_uses[next[p->uses[i].edge]++] = i;
    batten_status status = BATTEN_OK;
    for (int i = 0, index; status == BATTEN_OK && i < p->vertex_count; i++) {
        m->same[i] = i;
        status = bat_meshing_point(m, &p->vertices[3 * (size_t)i], &index);
    }
    return status;
}

void bat_meshing_end(bat_meshing *m)
{
    for (int i = 0; m->edges && i < m->parts->edge_count; i++) {
        bat_release(m->edges[i].t);
        bat_release(m->edges[i].vertex);
    }
    bat_release(m->edges);
    bat_release(m->points);
    bat_release(m->use_face);
    bat_release(m->edge_first);
    bat_release(m->edge_uses);
    bat_release(m->same);
    bat_release(m->touched);
    bat_release(m->sheets);
    bat_release(m->failed);
    bat_release(m->spread);
    bat_release(m->done);
    bat_release(m->across);
    bat_pairs_end(&m->taken);
    bat_release(m->corners);
    bat_release(m->normals);
    bat_release(m->owners);
}
