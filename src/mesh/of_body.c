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
    batten_status status = bat_meshing_begin(m);
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
    bat_meshing_end(m);
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
