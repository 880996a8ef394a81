/* Meshes whose coordinates a format keeps with 32 bits. */
#include "exchange/meshes/facets.h"

#include <float.h>
#include <string.h>

/* The mesh as readers of the file will see it, with vertices that rounding puts in one place as
 * one; *changed: there are such, or triangles that lose their area. */
static batten_status round_points(const batten_object *object, double scale, batten_mesh **out,
                                  bool *changed)
{
    const batten_mesh_parts parts = *batten_mesh_view(object->mesh);
    const size_t count = 3 * (size_t)parts.vertex_count;
    batten_mesh *apart = NULL, *before = NULL;
    double *points = bat_array(count, sizeof *points);
    batten_status status = points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    *out = NULL;
    for (size_t i = 0; points && i < count; i++) { /* what overflows is for the writer to say */
        const double x = scale * parts.points[i], most = (double)FLT_MAX;
        points[i] = (double)((float)bat_min(bat_max(x, -most), most) + 0.0f);
    }
    const batten_mesh_parts bare = {.vertex_count = parts.vertex_count,
                                    .points = points,
                                    .triangle_count = parts.triangle_count,
                                    .corners = parts.corners};
    if (status == BATTEN_OK)
        status = batten_mesh_create(&bare, &apart);
    if (status == BATTEN_OK)
        status = batten_mesh_weld(apart, out);
    if (status == BATTEN_OK)
        status = batten_mesh_weld(object->mesh, &before);
    if (status == BATTEN_OK)
        *changed =
            batten_mesh_view(*out)->vertex_count < batten_mesh_view(before)->vertex_count ||
            bat_count_flat(*out) > bat_count_flat(object->mesh);
    batten_mesh_unref(before);
    batten_mesh_unref(apart);
    bat_release(points);
    return status;
}

/* ---- triangles that vanish ---- */

static bool same_place(const batten_mesh_parts *p, int a, int b)
{
    return memcmp(p->points + 3 * (size_t)a, p->points + 3 * (size_t)b, 3 * sizeof(double)) ==
           0;
}

/* Has it two corners in one place, that were in two before? */
static bool vanishes(const batten_mesh_parts *p, const batten_mesh_parts *rounded, size_t t)
{
    const int *before = p->corners + 3 * t, *behind = rounded->corners + 3 * t;
    for (int k = 0; k < 3; k++) {
        const int next = (k + 1) % 3;
        if (behind[k] == behind[next] && !same_place(p, before[k], before[next]))
            return true;
    }
    return false;
}

typedef struct {
    int *corners, *faces;
    double *normals, *colours;
} kept_triangles;

static void release(kept_triangles *kept)
{
    bat_release(kept->corners);
    bat_release(kept->faces);
    bat_release(kept->normals);
    bat_release(kept->colours);
}

/* A copy of the mesh without the triangles that vanish when it is rounded. */
static batten_status without(const batten_mesh *mesh, const batten_mesh_parts *from,
                             const batten_mesh_parts *rounded, batten_mesh **out)
{
    const batten_mesh_parts *p = batten_mesh_view(mesh);
    const size_t count = (size_t)p->triangle_count;
    kept_triangles kept = {bat_array3(count, 3, sizeof(int)), bat_array(count, sizeof(int)),
                           bat_array3(count, 9, sizeof(double)),
                           bat_array3(count, 3, sizeof(double))};
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (kept.corners && kept.faces && kept.normals && kept.colours) {
        size_t to = 0;
        for (size_t t = 0; t < count; t++) {
            if (vanishes(from, rounded, t))
                continue;
            memcpy(kept.corners + 3 * to, p->corners + 3 * t, 3 * sizeof(int));
            if (p->normals)
                memcpy(kept.normals + 9 * to, p->normals + 9 * t, 9 * sizeof(double));
            if (p->triangle_colours)
                memcpy(kept.colours + 3 * to, p->triangle_colours + 3 * t, 3 * sizeof(double));
            kept.faces[to++] = p->faces ? p->faces[t] : 0;
        }
        batten_mesh_parts parts = *p;
        parts.triangle_count = (int)to;
        parts.corners = kept.corners;
        parts.normals = p->normals ? kept.normals : NULL;
        parts.faces = p->faces ? kept.faces : NULL;
        parts.triangle_colours = p->triangle_colours ? kept.colours : NULL;
        status = batten_mesh_create(&parts, out);
    }
    release(&kept);
    return status;
}

/* ---- what it does to the mesh ---- */

static batten_status facts_of(const batten_mesh *mesh, batten_mesh_facts *out)
{
    batten_mesh *welded = NULL;
    batten_status status = batten_mesh_weld(mesh, &welded);
    if (status == BATTEN_OK)
        status = batten_mesh_check(welded, out);
    batten_mesh_unref(welded);
    return status;
}

static batten_status report_rounding(const batten_object *object, const batten_mesh *left,
                                     const batten_mesh *rounded, batten_notes *notes)
{
    const int all = batten_mesh_view(object->mesh)->triangle_count;
    const int gone = all - batten_mesh_view(left)->triangle_count;
    batten_mesh *seen = NULL;
    batten_mesh_facts before = {0}, behind = {0};
    batten_status status = facts_of(object->mesh, &before);
    if (status == BATTEN_OK)
        status =
            without(rounded, batten_mesh_view(object->mesh), batten_mesh_view(rounded), &seen);
    if (status == BATTEN_OK)
        status = facts_of(seen, &behind);
    batten_mesh_unref(seen);
    if (status != BATTEN_OK)
        return status;
    if (gone)
        batten_notes_remark(
            notes, "", 0, object->name,
            "%d of %d triangles are not written: rounded to 32 bits, two of their "
            "corners are one",
            gone, all);
    const int flat = behind.flat_triangles - before.flat_triangles;
    const int crowded = behind.crowded_edges - before.crowded_edges;
    const bool opens = before.is_watertight && behind.rim_edges + behind.wrong_edges > 0;
    if (flat > 0 || crowded > 0 || opens)
        batten_notes_add(
            notes, "", 0, object->name,
            "rounded to 32 bits it has triangles without area, %d more, and edges of "
            "more than two triangles, %d more%s",
            bat_max_int(flat, 0), bat_max_int(crowded, 0),
            opens ? "; the mesh is no longer closed" : "");
    return BATTEN_OK;
}

batten_status bat_rounded_mesh(const batten_object *object, double scale, batten_notes *notes,
                               batten_mesh **out)
{
    batten_mesh *rounded = NULL, *left = NULL;
    bool changed = false;
    batten_status status = round_points(object, scale, &rounded, &changed);
    if (status == BATTEN_OK && changed) {
        status = without(object->mesh, batten_mesh_view(object->mesh),
                         batten_mesh_view(rounded), &left);
        if (status == BATTEN_OK)
            status = report_rounding(object, left, rounded, notes);
    } else if (status == BATTEN_OK) {
        left = batten_mesh_ref(object->mesh);
    }
    batten_mesh_unref(rounded);
    if (status == BATTEN_OK)
        *out = left;
    else
        batten_mesh_unref(left);
    return status;
}
