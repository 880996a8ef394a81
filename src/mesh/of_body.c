/* Triangles of a body: edges, then borders of faces until none crosses itself, then faces. */
#include "body/box.h"
#include "mesh/face.h"

#include <float.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

batten_status bat_meshing_triangle(bat_meshing *m, const int corners[3],
                                   const double normals[9], int face)
{
    if (m->triangle_count >= m->most)
        return bat_fail(BATTEN_TOO_LARGE, "the body needs more than %d triangles", m->most);
    if (m->triangle_count == m->triangle_room) {
        const int room = bat_max_int(256, 2 * bat_min_int(m->triangle_room, INT_MAX / 2 - 1));
        int(*all_corners)[3] = bat_resize(m->corners, (size_t)room, sizeof *all_corners);
        if (!all_corners)
            return BATTEN_OUT_OF_MEMORY;
        m->corners = all_corners;
        double(*all_normals)[9] = bat_resize(m->normals, (size_t)room, sizeof *all_normals);
        if (!all_normals)
            return BATTEN_OUT_OF_MEMORY;
        m->normals = all_normals;
        int *faces = bat_resize(m->faces, (size_t)room, sizeof *faces);
        if (!faces)
            return BATTEN_OUT_OF_MEMORY;
        m->faces = faces;
        m->triangle_room = room;
    }
    memcpy(m->corners[m->triangle_count], corners, sizeof *m->corners);
    memcpy(m->normals[m->triangle_count], normals, sizeof *m->normals);
    m->faces[m->triangle_count++] = bat_meshing_name(m, face);
    return BATTEN_OK;
}

/* ---- options ---- */

static double size_of(const batten_box box)
{
    return hypot(hypot(box.high.x - box.low.x, box.high.y - box.low.y), box.high.z - box.low.z);
}

static double largest_of(const batten_box box)
{
    const double x = bat_max(fabs(box.low.x), fabs(box.high.x));
    const double y = bat_max(fabs(box.low.y), fabs(box.high.y));
    return bat_max(bat_max(x, y), bat_max(fabs(box.low.z), fabs(box.high.z)));
}

static batten_status check_options(const batten_mesh_options *o, const batten_body *body,
                                   bat_meshing *m)
{
    batten_box box;
    const batten_status status = bat_body_find_box(body, &box);
    if (status != BATTEN_OK)
        return status;
    const double size = size_of(box);
    if (!(o->chord >= 0 && isfinite(o->chord)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the chord is %g; it must not be below 0",
                        o->chord);
    if (!(o->angle > 0 && isfinite(o->angle)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the angle is %g; it must be above 0", o->angle);
    if (!(o->longest >= 0 && isfinite(o->longest)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the longest edge is %g; it must not be below 0",
                        o->longest);
    if (o->most < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d triangles are allowed", o->most);
    m->chord = o->chord > 0 ? o->chord : 1e-3 * size;
    const double least = 8 * DBL_EPSILON * bat_max(size, largest_of(box));
    if (!(m->chord > least))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a chord of %g is in the roundoff of a body of size %g; it must be "
                        "above %g",
                        m->chord, size, least);
    m->fine = 0.85 * m->chord;
    m->angle = o->angle;
    m->longest = o->longest > 0 ? o->longest : HUGE_VAL;
    m->most = o->most;
    return BATTEN_OK;
}

/* ---- lists ---- */

static batten_status make_lists(bat_meshing *m)
{
    const batten_body_parts *p = m->parts;
    m->edges = bat_array((size_t)p->edge_count, sizeof *m->edges);
    m->use_face = bat_array((size_t)p->use_count, sizeof *m->use_face);
    m->edge_first = bat_array((size_t)p->edge_count + 2, sizeof *m->edge_first);
    m->edge_uses = bat_array((size_t)p->use_count, sizeof *m->edge_uses);
    m->sheets = bat_array((size_t)p->face_count, sizeof *m->sheets);
    m->failed = bat_array((size_t)p->face_count, sizeof *m->failed);
    m->spread = bat_array((size_t)p->face_count, sizeof *m->spread);
    if (!m->edges || !m->use_face || !m->edge_first || !m->edge_uses || !m->sheets ||
        !m->failed || !m->spread)
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
    for (int i = 0, index; status == BATTEN_OK && i < p->vertex_count; i++)
        status = bat_meshing_point(m, &p->vertices[3 * (size_t)i], &index);
    return status;
}

static void release_all(bat_meshing *m)
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
    bat_release(m->sheets);
    bat_release(m->failed);
    bat_release(m->spread);
    bat_pairs_end(&m->taken);
    bat_release(m->corners);
    bat_release(m->normals);
    bat_release(m->faces);
}

/* ---- borders ---- */

/* When finer samples alone have not helped for some rounds, corners are spread. */
enum { SPREAD_ROUND = 4, MOST_ROUNDS = 12 };

/* Edges of different curves between the same two vertices must not be one edge of the mesh. */
static batten_status find_twins(const bat_meshing *m, bat_pairs *splits)
{
    bat_pairs seen;
    batten_status status = bat_pairs_begin(&seen, (size_t)m->point_count + 16);
    int *owner = NULL;
    if (status != BATTEN_OK)
        return status;
    size_t count = 0;
    for (int e = 0; e < m->parts->edge_count; e++)
        count += (size_t)bat_max_int(m->edges[e].count, 1);
    owner = bat_array(count, 2 * sizeof *owner);
    if (!owner)
        status = BATTEN_OUT_OF_MEMORY;
    for (int e = 0; status == BATTEN_OK && e < m->parts->edge_count; e++)
        for (int i = 0; status == BATTEN_OK && i + 1 < m->edges[e].count; i++) {
            const int a = m->edges[e].vertex[i], b = m->edges[e].vertex[i + 1];
            const int known = seen.count;
            int index = 0, split;
            status = bat_pairs_add(&seen, bat_min_int(a, b), bat_max_int(a, b), &index);
            if (status != BATTEN_OK)
                break;
            if (index == known) {
                owner[2 * index] = e;
                owner[2 * index + 1] = i;
                continue;
            }
            status = bat_pairs_add(splits, owner[2 * index], owner[2 * index + 1], &split);
            if (status == BATTEN_OK)
                status = bat_pairs_add(splits, e, i, &split);
        }
    bat_release(owner);
    bat_pairs_end(&seen);
    return status;
}

static int compare_splits(const void *a, const void *b)
{
    const int *x = a, *y = b;
    return x[0] != y[0] ? (x[0] > y[0]) - (x[0] < y[0]) : (x[1] < y[1]) - (x[1] > y[1]);
}

/* Last segments first, so that the numbers of the others stay. Their faces are asked again. */
static batten_status apply_splits(bat_meshing *m, bat_pairs *splits, bool *ask, bool *any)
{
    batten_status status = BATTEN_OK;
    qsort(splits->pairs, (size_t)splits->count, sizeof *splits->pairs, compare_splits);
    for (int i = 0; status == BATTEN_OK && i < splits->count; i++) {
        const int edge = splits->pairs[i][0];
        bool split = false;
        status = bat_meshing_split(m, edge, splits->pairs[i][1], &split);
        *any = *any || split;
        for (int k = m->edge_first[edge]; split && k < m->edge_first[edge + 1]; k++)
            ask[m->use_face[m->edge_uses[k]]] = true;
    }
    bat_pairs_clear(splits);
    return status;
}

/* What ends all work, and not that on one face alone. */
static bool is_final(batten_status status)
{
    return status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED ||
           status == BATTEN_INCOMPLETE || status == BATTEN_TOO_LARGE;
}

static void give_up(bat_meshing *m, int face, const char *why)
{
    char entity[64];
    snprintf(entity, sizeof entity, "face %d", bat_meshing_name(m, face));
    const char *name = m->parts->faces[face].name;
    batten_notes_add(m->notes, "", 0, name && name[0] && !m->names ? name : entity,
                     "face %d is left out of the mesh: %s", bat_meshing_name(m, face), why);
    m->failed[face] = true;
    m->report.failed++;
}

static batten_status try_border(bat_meshing *m, int face, bat_pairs *splits, bool *simple)
{
    bat_rim rim;
    bat_sides sides = {0};
    bat_lattice lattice = {0};
    batten_interval box[2];
    *simple = false;
    batten_status status = bat_rim_begin(&rim, m, face, NULL);
    if (status != BATTEN_OK)
        return status;
    if (rim.count >
        (double)m->most + 1000) /* each side is one of a triangle; edges were fewer */
        status = bat_fail(BATTEN_COINCIDENT, "its border crosses or touches itself in (u, v)");
    else
        status = bat_work_step(&m->work, (uint64_t)rim.count, 0.1, "borders of faces");
    bat_rim_box(&rim, box);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        if (!(box[k].b > box[k].a))
            status = bat_fail(BATTEN_COINCIDENT, "its border is a line in (u, v), at %c = %g",
                              k ? 'v' : 'u', box[k].a);
    if (status == BATTEN_OK)
        status = bat_lattice_begin(&lattice, m, &m->sheets[face], box);
    if (status == BATTEN_OK)
        status = bat_rim_triangles(&rim, &lattice, &sides, splits, simple);
    bat_sides_end(&sides);
    bat_lattice_end(&lattice);
    bat_rim_end(&rim);
    return status;
}

/* *any: some face is to be tried again. */
static batten_status try_borders(bat_meshing *m, bat_pairs *splits, int round, bool *ask,
                                 bool *any)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < m->parts->face_count; i++) {
        bool simple = false;
        if (!ask[i] || m->failed[i])
            continue;
        status = try_border(m, i, splits, &simple);
        if (status != BATTEN_OK && !is_final(status)) {
            give_up(m, i, batten_message());
            status = BATTEN_OK;
            simple = true;
        }
        ask[i] = !simple;
        if (!simple && round == MOST_ROUNDS && status == BATTEN_OK)
            give_up(m, i, "its border crosses or touches itself in (u, v)");
        if (!simple && round == SPREAD_ROUND)
            *any = m->spread[i] = true;
    }
    return status;
}

/* Finer samples until the border of no face crosses itself. */
static batten_status settle_borders(bat_meshing *m)
{
    bat_pairs splits;
    batten_status status = bat_pairs_begin(&splits, 64);
    if (status != BATTEN_OK)
        return status;
    bool *ask = bat_array((size_t)m->parts->face_count, sizeof *ask), any = true;
    if (!ask)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; ask && i < m->parts->face_count; i++)
        ask[i] = m->parts->faces[i].count > 0;
    for (int round = 0; status == BATTEN_OK && any; round++) {
        const bool last = round == MOST_ROUNDS;
        any = false;
        status = find_twins(m, &splits);
        if (status == BATTEN_OK)
            status = try_borders(m, &splits, round, ask, &any);
        if (status == BATTEN_OK && !last)
            status = apply_splits(m, &splits, ask, &any);
    }
    bat_release(ask);
    bat_pairs_end(&splits);
    return status;
}

/* ---- the whole ---- */

/* The sides of all polylines, both ways: no edge across a face may be one of them. */
static batten_status take_edges(bat_meshing *m)
{
    batten_status status = bat_pairs_begin(&m->taken, 2 * (size_t)m->point_count + 64);
    for (int e = 0; status == BATTEN_OK && e < m->parts->edge_count; e++)
        for (int i = 0, index; status == BATTEN_OK && i + 1 < m->edges[e].count; i++) {
            const int a = m->edges[e].vertex[i], b = m->edges[e].vertex[i + 1];
            status = bat_pairs_add(&m->taken, a, b, &index);
            if (status == BATTEN_OK)
                status = bat_pairs_add(&m->taken, b, a, &index);
        }
    return status;
}

static batten_status mesh_faces(bat_meshing *m)
{
    bat_pairs splits;
    batten_status status = bat_pairs_begin(&splits, 64);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; status == BATTEN_OK && i < m->parts->face_count; i++) {
        const int before = m->triangle_count;
        bool simple = false;
        if (m->failed[i] || m->parts->faces[i].count == 0)
            continue;
        status = bat_mesh_face(m, i, &splits, &simple);
        if (status == BATTEN_OK && !simple)
            give_up(m, i, "its border crosses or touches itself in (u, v)");
        if (status != BATTEN_OK && !is_final(status)) {
            give_up(m, i, batten_message());
            m->triangle_count = before;
            status = BATTEN_OK;
        }
    }
    bat_pairs_end(&splits);
    return status;
}

/* Without the vertices that no triangle has. */
static batten_status finish(bat_meshing *m, batten_mesh **out)
{
    int *number = bat_array((size_t)m->point_count, sizeof *number);
    if (!number)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < m->triangle_count; i++)
        for (int k = 0; k < 3; k++)
            number[m->corners[i][k]] = 1;
    int count = 0;
    for (int i = 0; i < m->point_count; i++) {
        if (!number[i])
            continue;
        memmove(m->points[count], m->points[i], sizeof *m->points);
        number[i] = count++;
    }
    for (int i = 0; i < m->triangle_count; i++)
        for (int k = 0; k < 3; k++)
            m->corners[i][k] = number[m->corners[i][k]];
    bat_release(number);
    static const double nothing[9] = {0};
    static const int none[3] = {0};
    const bool any = m->triangle_count > 0;
    const batten_mesh_parts parts = {.vertex_count = count,
                                     .points = count ? m->points[0] : nothing,
                                     .triangle_count = m->triangle_count,
                                     .corners = any ? m->corners[0] : none,
                                     .normals = any ? m->normals[0] : nothing,
                                     .faces = any ? m->faces : none};
    return batten_mesh_create(&parts, out);
}

static batten_status mesh_traced(const batten_body *body, bat_meshing *m, batten_mesh **out)
{
    m->parts = batten_body_view(body);
    batten_status status = make_lists(m);
    if (status == BATTEN_OK)
        status = bat_meshing_predict(m);
    if (status == BATTEN_OK)
        status = bat_meshing_edges(m);
    if (status == BATTEN_OK)
        status = settle_borders(m);
    m->edge_points = m->point_count;
    if (status == BATTEN_OK)
        status = take_edges(m);
    if (status == BATTEN_OK)
        status = mesh_faces(m);
    if (status == BATTEN_OK)
        status = finish(m, out);
    release_all(m);
    return status;
}

batten_status batten_mesh_of_body(const batten_body *body, const batten_mesh_options *options,
                                  const batten_job *job, batten_notes *notes,
                                  batten_mesh_report *report, batten_mesh **out)
{
    const batten_mesh_options chosen = options ? *options : batten_mesh_defaults();
    bat_meshing m = {.job = job, .notes = notes, .work = {.job = job}};
    batten_body *traced = NULL;
    int *names = NULL;
    assert(body && out);
    batten_status status = check_options(&chosen, body, &m);
    if (status == BATTEN_OK)
        status = bat_meshing_trace(&m, body, &traced, &names);
    m.names = names;
    if (status == BATTEN_OK)
        status = mesh_traced(traced, &m, out);
    if (status == BATTEN_OK && report)
        *report = m.report;
    batten_body_unref(traced);
    bat_release(names);
    return status;
}
