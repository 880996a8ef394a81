/* The meshes of the faces of one part. */
#include "exchange/meshes/facets.h"
#include "exchange/obj/objects.h"
#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* ---- meshes ---- */

static batten_status use_vertex(bat_obj_making *m, int64_t vertex)
{
    const int index = (int)vertex;
    bat_obj_vertex *vertices = m->obj->vertices.items;
    if (m->stamp[vertex] == m->stamped)
        return BATTEN_OK;
    m->stamp[vertex] = m->stamped;
    vertices[vertex].is_used = true;
    return bat_list_add(m->obj->input, &m->used, &index);
}

static void take_normal(bat_obj_making *m, const bat_obj_corner *corner, double out[3])
{
    const double *all = m->obj->normals.items;
    if (corner->normal == INT64_MIN)
        m->lacks_normals = true;
    else {
        m->has_normals = true;
        memcpy(out, all + 3 * corner->normal, 3 * sizeof *out);
    }
}

static batten_status add_triangle(bat_obj_making *m, const bat_obj_corner *corners,
                                  const int cut[3])
{
    int triangle[3];
    double normals[9] = {0};
    for (int k = 0; k < 3; k++) {
        const bat_obj_corner *corner = &corners[cut[k]];
        triangle[k] = (int)corner->vertex;
        take_normal(m, corner, normals + 3 * k);
    }
    bat_input *input = m->obj->input;
    batten_status status =
        bat_obj_limit(input, 0, m->triangles.count + 1, input->limits.entities, "triangles");
    if (status == BATTEN_OK)
        status = bat_list_add(input, &m->triangles, triangle);
    if (status == BATTEN_OK && m->obj->normals.count)
        status = bat_list_add(input, &m->normals, normals);
    return status;
}

static batten_status add_face(bat_obj_making *m, const bat_obj_element *element)
{
    static const int none[3] = {0, 0, 0};
    const bat_obj_corner *corners =
        (const bat_obj_corner *)m->obj->corners.items + element->first;
    bat_input *input = m->obj->input;
    batten_status status =
        bat_input_limit(input, element->line, element->count, INT_MAX / 4, "corners of a face");
    m->places.count = m->cut.count = 0;
    for (size_t k = 0; status == BATTEN_OK && k < element->count; k++) {
        status = use_vertex(m, corners[k].vertex);
        if (status == BATTEN_OK)
            status = bat_list_add(input, &m->places,
                                  bat_obj_vertex_at(m->obj, corners[k].vertex)->point);
        if (status == BATTEN_OK)
            status = bat_list_add(input, &m->cut, none);
    }
    bool is_odd = false;
    int *cut = m->cut.items;
    if (status == BATTEN_OK)
        bat_polygon_triangles((int)element->count, m->places.items, cut, &is_odd);
    m->odd += is_odd;
    m->cut_up += element->count > 3;
    for (size_t k = 0; status == BATTEN_OK && k + 2 < element->count; k++)
        status = add_triangle(m, corners, cut + 3 * k);
    return status;
}

static int compare_indices(const void *a, const void *b)
{
    const int one = *(const int *)a, other = *(const int *)b;
    return (one > other) - (one < other);
}

/* In the order of the file; false when one has no colour. */
static bool copy_vertices(bat_obj_making *m, double *points, double *colours)
{
    const int *used = m->used.items;
    bool has_colours = true;
    for (size_t i = 0; i < m->used.count; i++) {
        const bat_obj_vertex *vertex = bat_obj_vertex_at(m->obj, used[i]);
        m->local[used[i]] = (int)i;
        memcpy(points + 3 * i, vertex->point, sizeof vertex->point);
        memcpy(colours + 3 * i, vertex->colour, sizeof vertex->colour);
        has_colours = has_colours && vertex->has_colour;
    }
    return has_colours;
}

static void renumber_corners(bat_obj_making *m)
{
    int *corners = m->triangles.items;
    for (size_t i = 0; i < 3 * m->triangles.count; i++)
        corners[i] = m->local[corners[i]];
}

/* The vertices that are used; *points and *colours are [used][3], colours NULL when one has
 * none. */
static batten_status take_vertices(bat_obj_making *m, double **points, double **colours)
{
    const size_t count = m->used.count;
    qsort(m->used.items, count, sizeof(int), compare_indices);
    batten_status status = bat_input_array(m->obj->input, 3 * count, sizeof **points, points);
    if (status == BATTEN_OK)
        status = bat_input_array(m->obj->input, 3 * count, sizeof **colours, colours);
    if (status != BATTEN_OK)
        return status;
    if (!copy_vertices(m, *points, *colours)) {
        bat_release(*colours);
        *colours = NULL;
    }
    renumber_corners(m);
    return BATTEN_OK;
}

/* Normals of the length 1 that every corner has. */
static bool keep_normals(const bat_obj_making *m)
{
    const double *normals = m->normals.items;
    const bat_input *input = m->obj->input;
    if (!m->has_normals)
        return false;
    for (size_t i = 0; !m->lacks_normals && i < 3 * m->normals.count; i++) {
        const double *n = normals + 3 * i;
        const double length = bat_hypot(bat_hypot(n[0], n[1]), n[2]);
        if (length == 0 || fabs(length - 1) < 1e-3)
            continue;
        batten_notes_add(input->notes, input->file, 0, m->name,
                         "the normals are left out: (%g, %g, %g) has not the length 1", n[0],
                         n[1], n[2]);
        return false;
    }
    if (m->lacks_normals)
        batten_notes_add(input->notes, input->file, 0, m->name,
                         "the normals are left out: some corners have none");
    return !m->lacks_normals;
}

static batten_status create_mesh(const bat_obj_making *m, const double *points,
                                 const double *colours, batten_mesh **mesh)
{
    const batten_mesh_parts parts = {.vertex_count = (int)m->used.count,
                                     .points = points,
                                     .colours = colours,
                                     .triangle_count = (int)m->triangles.count,
                                     .corners = m->triangles.items,
                                     .normals = keep_normals(m) ? m->normals.items : NULL};

    return batten_mesh_create(&parts, mesh);
}

static void note_odd(const bat_obj_making *m)
{
    if (m->odd)
        batten_notes_add(m->obj->input->notes, m->obj->input->file, 0, m->name,
                         "faces that cross themselves, or have a bay and more than %d corners: "
                         "%d; their triangles overlap",
                         BAT_POLYGON_MOST, m->odd);
}

static batten_status add_mesh(bat_obj_making *m, const bat_obj_part *part)
{
    double *points = NULL, *colours = NULL;
    batten_mesh *mesh = NULL;
    batten_status status = bat_obj_name_part(m, part, "mesh");
    if (status == BATTEN_OK)
        status = take_vertices(m, &points, &colours);
    if (status == BATTEN_OK)
        status = create_mesh(m, points, colours, &mesh);
    if (status == BATTEN_OK)
        status = bat_obj_add_object(
            m, part, (batten_object){.kind = BATTEN_OBJECT_MESH, .mesh = mesh}, "mesh");
    if (status == BATTEN_OK)
        bat_remark_flat(mesh, m->obj->input->file, m->name, m->obj->input->notes);
    if (status == BATTEN_OK)
        note_odd(m);
    batten_mesh_unref(mesh);
    bat_release(points);
    bat_release(colours);
    return status;
}

batten_status bat_obj_make_mesh(bat_obj_making *m, const bat_obj_part *part, size_t end)
{
    const bat_obj_element *elements = m->obj->elements.items;
    batten_status status = BATTEN_OK;
    m->stamped++;
    m->used.count = m->triangles.count = m->normals.count = 0;
    m->odd = 0;
    m->has_normals = m->lacks_normals = false;
    for (size_t i = part->first; status == BATTEN_OK && i < end; i++)
        if (elements[i].kind == BAT_OBJ_FACE && bat_obj_check_corners(m, &elements[i]))
            status = add_face(m, &elements[i]);
    return status == BATTEN_OK && m->triangles.count ? add_mesh(m, part) : status;
}
