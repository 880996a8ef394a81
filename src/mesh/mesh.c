/* Meshes as values: checked when they are made, immutable and counted. */
#include "base/base.h"
#include "base/plural.h"

#include <batten/mesh.h>
#include <stdint.h>
#include <string.h>

struct batten_mesh {
    bat_references references;
    batten_mesh_parts parts; /* owns its arrays */
};

/* Casts away the const under which the parts show what they own. */
static void release_array(const void *memory)
{
    bat_release((void *)(uintptr_t)memory);
}

static void release_attributes(const batten_mesh_parts *p)
{
    for (int k = 0; p->attributes && k < p->attribute_count; k++) {
        release_array(p->attributes[k].name);
        release_array(p->attributes[k].values);
    }
    release_array(p->attributes);
}

static void free_mesh(batten_mesh *mesh)
{
    const batten_mesh_parts *p = &mesh->parts;
    release_array(p->points);
    release_array(p->colours);
    release_array(p->corners);
    release_array(p->normals);
    release_array(p->faces);
    release_array(p->triangle_colours);
    release_attributes(p);
    bat_release(mesh);
}

batten_mesh *batten_mesh_ref(const batten_mesh *mesh)
{
    batten_mesh *counted = (batten_mesh *)(uintptr_t)mesh;
    bat_references_add(&counted->references);
    return counted;
}

void batten_mesh_unref(batten_mesh *mesh)
{
    if (mesh && bat_references_drop(&mesh->references))
        free_mesh(mesh);
}

const batten_mesh_parts *batten_mesh_view(const batten_mesh *mesh)
{
    return &mesh->parts;
}

/* ---- making ---- */

static batten_status check_numbers(const double *values, size_t count, const char *what)
{
    const size_t bad = values ? bat_first_not_finite(values, count) : count;
    return bad == count ? BATTEN_OK
                        : bat_fail(BATTEN_NOT_FINITE, "number %zu of the %s is not finite",
                                   bad + 1, what);
}

static batten_status check_parts(const batten_mesh_parts *p)
{
    if (p->vertex_count < 0 || p->triangle_count < 0 || p->attribute_count < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d %s, %d triangle%s, %d attributes",
                        p->vertex_count, bat_one_or_many(p->vertex_count, "vertex", "vertices"),
                        p->triangle_count, bat_plural(p->triangle_count), p->attribute_count);
    const size_t vertices = (size_t)p->vertex_count, triangles = (size_t)p->triangle_count;
    for (size_t i = 0; i < 3 * triangles; i++)
        if (p->corners[i] < 0 || p->corners[i] >= p->vertex_count)
            return bat_fail(BATTEN_BAD_ARGUMENT, "triangle %zu has vertex %d, of %d", i / 3 + 1,
                            p->corners[i] + 1, p->vertex_count);
    batten_status status = check_numbers(p->points, 3 * vertices, "points");
    if (status == BATTEN_OK)
        status = check_numbers(p->colours, 3 * vertices, "colours");
    if (status == BATTEN_OK)
        status = check_numbers(p->normals, 9 * triangles, "normals");
    if (status == BATTEN_OK)
        status = check_numbers(p->triangle_colours, 3 * triangles, "colours of triangles");
    for (int k = 0; status == BATTEN_OK && k < p->attribute_count; k++)
        status = check_numbers(p->attributes[k].values, vertices, "attributes");
    return status;
}

/* A copy of `count` items of `size` bytes; of NULL, NULL. */
static batten_status copy(const void *items, size_t count, size_t size, const void **out)
{
    if (!items)
        return BATTEN_OK;
    void *copied = bat_array(count, size);
    if (!copied)
        return BATTEN_OUT_OF_MEMORY;
    if (count)
        memcpy(copied, items, count * size);
    *out = copied;
    return BATTEN_OK;
}

static batten_status copy_attributes(const batten_mesh_parts *from, batten_mesh_parts *to)
{
    const size_t count = (size_t)from->attribute_count;
    if (count == 0)
        return BATTEN_OK;
    batten_mesh_attribute *made = bat_array(count, sizeof *made);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    to->attributes = made;
    to->attribute_count = from->attribute_count;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < count; k++) {
        const batten_mesh_attribute *source = &from->attributes[k];
        const void *name = NULL, *values = NULL;
        status = copy(source->name, strlen(source->name) + 1, 1, &name);
        if (status == BATTEN_OK)
            status = copy(source->values, (size_t)from->vertex_count, sizeof(double), &values);
        made[k] = (batten_mesh_attribute){name, values};
    }
    return status;
}

/* What each triangle has. */
static batten_status copy_triangles(const batten_mesh_parts *from, batten_mesh_parts *to)
{
    const size_t count = (size_t)from->triangle_count;
    const void *corners = NULL, *normals = NULL, *faces = NULL, *colours = NULL;
    batten_status status = copy(from->corners, 3 * count, sizeof(int), &corners);
    if (status == BATTEN_OK)
        status = copy(from->normals, 9 * count, sizeof(double), &normals);
    if (status == BATTEN_OK)
        status = copy(from->faces, count, sizeof(int), &faces);
    if (status == BATTEN_OK)
        status = copy(from->triangle_colours, 3 * count, sizeof(double), &colours);
    to->triangle_count = from->triangle_count;
    to->corners = corners;
    to->normals = normals;
    to->faces = faces;
    to->triangle_colours = colours;
    return status;
}

static batten_status copy_vertices(const batten_mesh_parts *from, batten_mesh_parts *to)
{
    const size_t count = (size_t)from->vertex_count;
    const void *points = NULL, *colours = NULL;
    batten_status status = copy(from->points, 3 * count, sizeof(double), &points);
    if (status == BATTEN_OK)
        status = copy(from->colours, 3 * count, sizeof(double), &colours);
    to->vertex_count = from->vertex_count;
    to->points = points;
    to->colours = colours;
    return status == BATTEN_OK ? copy_attributes(from, to) : status;
}

batten_status batten_mesh_create(const batten_mesh_parts *parts, batten_mesh **out)
{
    batten_status status = check_parts(parts);
    if (status != BATTEN_OK)
        return status;
    batten_mesh *mesh = bat_array(1, sizeof *mesh);
    if (!mesh)
        return BATTEN_OUT_OF_MEMORY;
    bat_references_begin(&mesh->references);
    status = copy_vertices(parts, &mesh->parts);
    if (status == BATTEN_OK)
        status = copy_triangles(parts, &mesh->parts);
    if (status == BATTEN_OK)
        *out = mesh;
    else
        free_mesh(mesh);
    return status;
}

batten_box batten_mesh_box(const batten_mesh *mesh)
{
    const batten_mesh_parts *p = &mesh->parts;
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int i = 0; i < p->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            const double x = p->points[3 * (size_t)i + (size_t)k];
            low[k] = i ? bat_min(low[k], x) : x;
            high[k] = i ? bat_max(high[k], x) : x;
        }
    return (batten_box){{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}
