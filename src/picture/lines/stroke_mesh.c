/* The lines by which a mesh is drawn. */
#include "numeric/vector.h"
#include "picture/lines/stroke.h"

#include <stdlib.h>
#include <string.h>

/* A side of a triangle, from the lower vertex to the higher one. */
typedef struct {
    int from, to, triangle;
} side;

static int by_ends(const void *a, const void *b)
{
    const side *s = a, *t = b;
    if (s->from != t->from)
        return s->from < t->from ? -1 : 1;
    if (s->to != t->to)
        return s->to < t->to ? -1 : 1;
    return (s->triangle > t->triangle) - (s->triangle < t->triangle);
}

static side *sort_sides(const batten_mesh_parts *mesh)
{
    const size_t count = 3 * (size_t)mesh->triangle_count;
    side *sides = bat_array(count, sizeof *sides);
    for (size_t i = 0; sides && i < count; i++) {
        const int a = mesh->corners[i], b = mesh->corners[i - i % 3 + (i + 1) % 3];
        sides[i] = (side){bat_min_int(a, b), bat_max_int(a, b), (int)(i / 3)};
    }
    if (sides)
        qsort(sides, count, sizeof *sides, by_ends);
    return sides;
}

void bat_triangle_normal(const batten_mesh_parts *mesh, int triangle, double n[3])
{
    const int *c = mesh->corners + 3 * (size_t)triangle;
    const double *a = mesh->points + 3 * (size_t)c[0], *b = mesh->points + 3 * (size_t)c[1];
    const double *d = mesh->points + 3 * (size_t)c[2];
    double s[3], t[3];
    for (int k = 0; k < 3; k++) {
        s[k] = b[k] - a[k];
        t[k] = d[k] - a[k];
    }
    bat_cross(s, t, n);
    const double length = sqrt(bat_dot(3, n, n));
    for (int k = 0; k < 3; k++)
        n[k] = length > 0 ? n[k] / length : 0;
}

/* Of a body's mesh the edges of its faces; of others where it ends, and where it turns by more
 * than 30 degrees. */
static bool is_feature(const batten_mesh_parts *mesh, const side *sides, size_t count)
{
    double m[3], n[3];
    if (count != 2)
        return true;
    if (mesh->faces)
        return mesh->faces[sides[0].triangle] != mesh->faces[sides[1].triangle];
    bat_triangle_normal(mesh, sides[0].triangle, m);
    bat_triangle_normal(mesh, sides[1].triangle, n);
    /* Triangles without area have normal 0, and are edges by that. */
    const double cosine = bat_dot(3, m, n);
    return cosine < 0.866;
}

static bool is_outline(const batten_mesh_parts *mesh, const side *sides, size_t count,
                       const bat_mesh_eye *eye)
{
    double sign[2] = {0, 0};
    for (size_t i = 0; i < 2 && count == 2; i++) {
        double n[3];
        const double *p = mesh->points + 3 * (size_t)sides[0].from;
        bat_triangle_normal(mesh, sides[i].triangle, n);
        for (int k = 0; k < 3; k++)
            sign[i] += n[k] * (eye->at[k] - (eye->is_far ? 0 : p[k]));
    }
    return sign[0] * sign[1] < 0;
}

/* The wanted edges, once each; as many as there are sides have room. */
static size_t choose(const batten_mesh_parts *mesh, const side *sides, bat_mesh_lines which,
                     const bat_mesh_eye *eye, int (*ends)[2])
{
    const size_t count = 3 * (size_t)mesh->triangle_count;
    size_t kept = 0;
    for (size_t i = 0, next; i < count; i = next) {
        next = i + 1;
        while (next < count && sides[next].from == sides[i].from &&
               sides[next].to == sides[i].to)
            next++;
        if (sides[i].from == sides[i].to)
            continue;
        /* Outlines along other lines are drawn as these. */
        const bool feature = is_feature(mesh, sides + i, next - i);
        const bool outline =
            which == BAT_MESH_OUTLINE && !feature && is_outline(mesh, sides + i, next - i, eye);
        const bool wanted =
            which == BAT_MESH_ALL || outline || (which != BAT_MESH_OUTLINE && feature);
        if (wanted)
            memcpy(ends[kept++], (int[2]){sides[i].from, sides[i].to}, sizeof *ends);
    }
    return kept;
}

batten_status bat_stroke_mesh(const batten_mesh *mesh, bat_mesh_lines which,
                              const bat_mesh_eye *eye, bat_strokes *lines)
{
    batten_mesh *welded = NULL;
    batten_status status = batten_mesh_weld(mesh, &welded);
    if (status != BATTEN_OK)
        return status;
    const batten_mesh_parts *parts = batten_mesh_view(welded);
    side *sides = sort_sides(parts);
    int(*ends)[2] = bat_array3((size_t)parts->triangle_count, 3, sizeof *ends);
    status = sides && ends ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    size_t count = 0;
    if (status == BATTEN_OK)
        count = choose(parts, sides, which, eye, ends);
    /* What is smooth everywhere would not be seen. */
    if (status == BATTEN_OK && which == BAT_MESH_EDGES_OR_ALL && count == 0)
        count = choose(parts, sides, BAT_MESH_ALL, eye, ends);
    if (status == BATTEN_OK)
        status = bat_chain_edges(parts->vertex_count, parts->points, count,
                                 (const int(*)[2])ends, lines);
    bat_release(ends);
    bat_release(sides);
    batten_mesh_unref(welded);
    return status;
}
