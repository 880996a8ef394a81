/* Triangles of a body: edges, borders, then faces. */
#include "body/measure/box.h"
#include "mesh/faces/face.h"
#include "mesh/options.h"
#include "numeric/box.h"

#include <float.h>
#include <limits.h>
#include <string.h>

/* ---- options ---- */

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
    batten_status status = bat_body_find_box(body, &box);
    if (status == BATTEN_OK)
        status = bat_mesh_check_options(o);
    if (status != BATTEN_OK)
        return status;
    const double size = bat_box_diagonal(box);
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

/* ---- the whole ---- */

/* Without the vertices that no triangle has. */
static batten_status finish_mesh(bat_meshing *m, batten_mesh **out)
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
    for (int i = 0; i < m->triangle_count; i++) {
        m->owners[i] = bat_meshing_number(m, m->owners[i]);
        for (int k = 0; k < 3; k++)
            m->corners[i][k] = number[m->corners[i][k]];
    }
    bat_release(number);
    static const double nothing[9] = {0};
    static const int none[3] = {0};
    const bool any = m->triangle_count > 0;
    const batten_mesh_parts parts = {.vertex_count = count,
                                     .points = count ? m->points[0] : nothing,
                                     .triangle_count = m->triangle_count,
                                     .corners = any ? m->corners[0] : none,
                                     .normals = any ? m->normals[0] : nothing,
                                     .faces = any ? m->owners : none};
    return batten_mesh_create(&parts, out);
}

static batten_status mesh_traced(const bat_traced *traced, bat_meshing *m, batten_mesh **out)
{
    m->traced = traced;
    m->parts = batten_body_view(traced->body);
    batten_status status = make_lists(m);
    if (status == BATTEN_OK)
        status = bat_meshing_predict(m);
    if (status == BATTEN_OK)
        status = bat_meshing_join(m);
    if (status == BATTEN_OK)
        status = bat_meshing_edges(m);
    if (status == BATTEN_OK)
        status = bat_meshing_settle(m);
    if (status == BATTEN_OK)
        status = bat_meshing_faces(m);
    if (status == BATTEN_OK)
        status = finish_mesh(m, out);
    release_all(m);
    return status;
}

batten_status batten_mesh_from_body(const batten_body *body, const batten_mesh_options *options,
                                    const batten_job *job, batten_notes *notes,
                                    batten_mesh_report *report, batten_mesh **out)
{
    batten_mesh_options chosen = batten_mesh_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_mesh_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    bat_meshing m = {.job = job, .notes = notes, .work = {.job = job}};
    bat_traced traced = {0};
    assert(body && out);
    status = check_options(&chosen, body, &m);
    if (status == BATTEN_OK)
        status = bat_meshing_trace(&m, body, &traced);
    if (status == BATTEN_OK)
        status = mesh_traced(&traced, &m, out);
    if (status == BATTEN_OK && report)
        *report = m.report;
    bat_traced_end(&traced);
    return status;
}
