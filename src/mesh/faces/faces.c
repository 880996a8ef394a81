/* The faces one after another; those where an edge is in the way again, when it is finer. */
#include "mesh/faces/face.h"

#include <limits.h>
#include <string.h>

/* The sides of its polyline, both ways. */
static batten_status take_edge(bat_meshing *m, const bat_polyline *line)
{
    int index;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i + 1 < line->count; i++) {
        const int a = line->vertex[i], b = line->vertex[i + 1];
        status = bat_pairs_add(&m->taken, a, b, &index);
        if (status == BATTEN_OK)
            status = bat_pairs_add(&m->taken, b, a, &index);
    }
    return status;
}

/* The edges of triangles that no other face may have: the sides of all polylines, both ways,
 * and those across faces. */
static batten_status take_edges(bat_meshing *m)
{
    bat_pairs_end(&m->taken);
    batten_status status = bat_pairs_begin(&m->taken, 2 * (size_t)m->point_count + 64);
    int index;
    for (int e = 0; status == BATTEN_OK && e < m->parts->edge_count; e++)
        status = take_edge(m, &m->edges[e]);
    for (int i = 0; status == BATTEN_OK && i < m->across_count; i++)
        status = bat_pairs_add(&m->taken, m->across[i].ends[0], m->across[i].ends[1], &index);
    return status;
}

static void forget_across(bat_meshing *m, const bool *ask)
{
    int kept = 0;
    for (int i = 0; i < m->across_count; i++)
        if (!ask[m->across[i].face])
            m->across[kept++] = m->across[i];
    m->across_count = kept;
}

static void move_triangle(bat_meshing *m, int from, int to)
{
    memmove(m->corners[to], m->corners[from], sizeof *m->corners);
    memmove(m->normals[to], m->normals[from], sizeof *m->normals);
    m->owners[to] = m->owners[from];
}

/* Without the triangles of the faces that are asked again. */
static void forget(bat_meshing *m, const bool *ask)
{
    int count = 0;
    for (int i = 0; i < m->triangle_count; i++)
        if (!ask[m->owners[i]])
            move_triangle(m, i, count++);
    m->triangle_count = count;
    forget_across(m, ask);
}

/* The faces that are asked. *splits: sides that are to be finer. Of faces whose borders, finer
 * now, cross themselves `again` is set, or they are left out in the last round. */
static batten_status mesh_asked(bat_meshing *m, const bool *ask, bool last, bat_pairs *splits,
                                bool *again)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < m->parts->face_count; i++) {
        const int before = m->triangle_count;
        bool simple = false;
        if (!ask[i] || m->failed[i] || m->parts->faces[i].count == 0)
            continue;
        m->done[i] = (bat_reached){.chord = 0};
        status = bat_mesh_face(m, i, splits, &simple);
        again[i] = status == BATTEN_OK && !simple && !last;
        if (status == BATTEN_OK && !simple && last)
            bat_meshing_give_up(m, i, "its border crosses or touches itself in (u, v)");
        if (status != BATTEN_OK && !bat_meshing_is_final(status)) {
            bat_meshing_give_up(m, i, batten_message());
            m->triangle_count = before;
            m->done[i] = (bat_reached){.chord = 0};
            status = BATTEN_OK;
        }
    }
    return status;
}

/* Over all faces. */
static void sum_up(bat_meshing *m)
{
    batten_mesh_report *r = &m->report;
    r->asked = m->chord;
    for (int i = 0; i < m->parts->face_count; i++) {
        const bat_reached *d = &m->done[i];
        r->chord = bat_max(r->chord, d->chord);
        r->angle = bat_max(r->angle, d->angle);
        r->beyond += d->beyond;
        r->error = bat_max(r->error, d->off);
    }
}

/* Sides are halved: after so many rounds they are a sixtieth of what they were. */
enum { MOST_ROUNDS = 6 };

batten_status bat_meshing_faces(bat_meshing *m)
{
    bat_pairs splits;
    batten_status status = bat_pairs_begin(&splits, 64);
    if (status != BATTEN_OK)
        return status;
    const size_t faces = (size_t)m->parts->face_count;
    bool *ask = bat_array(faces, sizeof *ask), *next = bat_array(faces, sizeof *next);
    if (!ask || !next)
        status = BATTEN_OUT_OF_MEMORY;
    if (ask)
        memset(ask, true, faces);
    bool any = true;
    for (int round = 0; status == BATTEN_OK && any; round++) {
        const bool last = round == MOST_ROUNDS;
        status = take_edges(m);
        if (status == BATTEN_OK)
            status = mesh_asked(m, ask, last, &splits, next);
        any = false;
        if (status != BATTEN_OK || last)
            break;
        status = bat_meshing_apply_splits(m, &splits, next, &any);
        for (size_t i = 0; i < faces; i++) {
            any = any || next[i];
            ask[i] = next[i];
            next[i] = false;
        }
        forget(m, ask);
    }
    if (status == BATTEN_OK)
        sum_up(m);
    bat_release(next);
    bat_release(ask);
    bat_pairs_end(&splits);
    return status;
}
