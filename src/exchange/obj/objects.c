/* The objects of a file whose statements have been read. */
#include "exchange/meshes/facets.h"
#include "exchange/obj/obj.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* One mesh, line or row of points while it is made. */
typedef struct {
    bat_obj *obj;
    batten_model *model;
    int *local;                  /* [vertices] index in the mesh, valid where stamp says so */
    size_t *stamp;               /* [vertices] the mesh that it was last used in */
    size_t stamped;              /* meshes so far */
    bat_list used;               /* of int: vertices of the mesh */
    bat_list triangles, normals; /* of int[3]; of double[9] */
    bat_list places, cut;        /* of a polygon; of numbers */
    int odd;
    size_t cut_up; /* faces of more than three corners, in all parts */
    bool has_normals, lacks_normals;
    char *name, *group;
} making;

static const bat_obj_vertex *vertex_at(const bat_obj *obj, int64_t index)
{
    return (const bat_obj_vertex *)obj->vertices.items + index;
}

/* Elements have no indices below 0. */
static bool is_vertex(const bat_obj *obj, int64_t index)
{
    return (uint64_t)index < obj->vertices.count &&
           bat_first_not_finite(vertex_at(obj, index)->point, 3) == 3;
}

static bool is_normal(const bat_obj *obj, int64_t index)
{
    return index == INT64_MIN ||
           ((uint64_t)index < obj->normals.count &&
            bat_first_not_finite((const double *)obj->normals.items + 3 * index, 3) == 3);
}

/* Are all corners there? Else a note, and the element is left out. */
static bool check_corners(const making *m, const bat_obj_element *element)
{
    const bat_obj *obj = m->obj;
    const bat_obj_corner *corners = (const bat_obj_corner *)obj->corners.items + element->first;
    size_t k = 0;
    while (k < element->count && is_vertex(obj, corners[k].vertex) &&
           is_normal(obj, corners[k].normal))
        k++;
    if (k == element->count)
        return true;
    const bool no_vertex = !is_vertex(obj, corners[k].vertex);
    batten_notes_add(obj->input->notes, obj->input->file, element->line, "",
                     "the element is left out: its corner %zu has %s %lld, which there is not",
                     k + 1, no_vertex ? "vertex" : "normal",
                     (long long)(no_vertex ? corners[k].vertex : corners[k].normal) + 1);
    obj->input->left_out++;
    return false;
}

/* ---- names ---- */

static batten_status copy_span(bat_input *input, bat_span span, const char *otherwise,
                               char **out)
{
    if (span.length == 0)
        span = (bat_span){otherwise, strlen(otherwise)};
    bat_release(*out);
    *out = NULL;
    batten_status status = bat_input_array(input, span.length + 1, 1, out);
    if (status == BATTEN_OK)
        bat_word_copy(span, span.length + 1, *out);
    return status;
}

/* The group is the name of the object when both are there. */
static batten_status name_part(making *m, const bat_obj_part *part, const char *otherwise)
{
    bat_input *input = m->obj->input;
    const bool both = part->object.length && part->group.length;
    batten_status status =
        copy_span(input, part->group.length ? part->group : part->object, otherwise, &m->name);
    if (status == BATTEN_OK)
        status = copy_span(input, both ? part->object : (bat_span){"", 0}, "", &m->group);
    return status;
}

static batten_status add_object(making *m, const bat_obj_part *part, batten_object object,
                                const char *otherwise)
{
    batten_status status = name_part(m, part, otherwise);
    object.name = m->name;
    object.group = m->group;
    return status == BATTEN_OK ? batten_model_add(m->model, &object) : status;
}

/* ---- meshes ---- */

static batten_status use_vertex(making *m, int64_t vertex)
{
    const int index = (int)vertex;
    bat_obj_vertex *vertices = m->obj->vertices.items;
    if (m->stamp[vertex] == m->stamped)
        return BATTEN_OK;
    m->stamp[vertex] = m->stamped;
    vertices[vertex].is_used = true;
    return bat_list_add(m->obj->input, &m->used, &index);
}

static batten_status add_triangle(making *m, const bat_obj_corner *corners, const int cut[3])
{
    const double *all = m->obj->normals.items;
    int triangle[3];
    double normals[9] = {0};
    for (int k = 0; k < 3; k++) {
        const bat_obj_corner *corner = &corners[cut[k]];
        triangle[k] = (int)corner->vertex;
        if (corner->normal == INT64_MIN)
            m->lacks_normals = true;
        else {
            m->has_normals = true;
            memcpy(normals + 3 * k, all + 3 * corner->normal, 3 * sizeof *normals);
        }
    }
    bat_input *input = m->obj->input;
    const size_t limit = input->limits.entities;
    batten_status status =
        bat_input_limit(input, 0, m->triangles.count + 1,
                        limit < INT_MAX / 3 ? limit : (size_t)INT_MAX / 3, "triangles");
    if (status == BATTEN_OK)
        status = bat_list_add(input, &m->triangles, triangle);
    if (status == BATTEN_OK && m->obj->normals.count)
        status = bat_list_add(input, &m->normals, normals);
    return status;
}

static batten_status add_face(making *m, const bat_obj_element *element)
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
            status =
                bat_list_add(input, &m->places, vertex_at(m->obj, corners[k].vertex)->point);
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

/* The vertices in the order of the file; *points and *colours are [used][3], colours NULL when
 * one has none. */
static batten_status take_vertices(making *m, double **points, double **colours)
{
    int *used = m->used.items;
    const size_t count = m->used.count;
    bool has_colours = true;
    qsort(used, count, sizeof *used, compare_indices);
    batten_status status = bat_input_array(m->obj->input, 3 * count, sizeof **points, points);
    if (status == BATTEN_OK)
        status = bat_input_array(m->obj->input, 3 * count, sizeof **colours, colours);
    for (size_t i = 0; status == BATTEN_OK && i < count; i++) {
        const bat_obj_vertex *vertex = vertex_at(m->obj, used[i]);
        m->local[used[i]] = (int)i;
        memcpy(*points + 3 * i, vertex->point, sizeof vertex->point);
        memcpy(*colours + 3 * i, vertex->colour, sizeof vertex->colour);
        has_colours = has_colours && vertex->has_colour;
    }
    if (!has_colours) {
        bat_release(*colours);
        *colours = NULL;
    }
    int *corners = m->triangles.items;
    for (size_t i = 0; status == BATTEN_OK && i < 3 * m->triangles.count; i++)
        corners[i] = m->local[corners[i]];
    return status;
}

/* Normals of the length 1 that every corner has. */
static bool keep_normals(const making *m)
{
    const double *normals = m->normals.items;
    const bat_input *input = m->obj->input;
    if (!m->has_normals)
        return false;
    for (size_t i = 0; !m->lacks_normals && i < 3 * m->normals.count; i++) {
        const double *n = normals + 3 * i;
        const double length = hypot(hypot(n[0], n[1]), n[2]);
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

static batten_status add_mesh(making *m, const bat_obj_part *part)
{
    double *points = NULL, *colours = NULL;
    batten_mesh *mesh = NULL;
    batten_status status = name_part(m, part, "mesh");
    if (status == BATTEN_OK)
        status = take_vertices(m, &points, &colours);
    if (status == BATTEN_OK) {
        const batten_mesh_parts parts = {.vertex_count = (int)m->used.count,
                                         .points = points,
                                         .colours = colours,
                                         .triangle_count = (int)m->triangles.count,
                                         .corners = m->triangles.items,
                                         .normals = keep_normals(m) ? m->normals.items : NULL};
        status = batten_mesh_create(&parts, &mesh);
    }
    if (status == BATTEN_OK)
        status = add_object(m, part, (batten_object){.kind = BATTEN_OBJECT_MESH, .mesh = mesh},
                            "mesh");
    if (status == BATTEN_OK)
        bat_remark_flat(mesh, m->obj->input->file, m->name, m->obj->input->notes);
    if (status == BATTEN_OK && m->odd)
        batten_notes_add(m->obj->input->notes, m->obj->input->file, 0, m->name,
                         "faces that cross themselves, or have a bay and more than %d corners: "
                         "%d; their triangles overlap",
                         BAT_POLYGON_MOST, m->odd);
    batten_mesh_unref(mesh);
    bat_release(points);
    bat_release(colours);
    return status;
}

/* All faces of the part as one mesh. */
static batten_status make_mesh(making *m, const bat_obj_part *part, size_t end)
{
    const bat_obj_element *elements = m->obj->elements.items;
    batten_status status = BATTEN_OK;
    m->stamped++;
    m->used.count = m->triangles.count = m->normals.count = 0;
    m->odd = 0;
    m->has_normals = m->lacks_normals = false;
    for (size_t i = part->first; status == BATTEN_OK && i < end; i++)
        if (elements[i].kind == BAT_OBJ_FACE && check_corners(m, &elements[i]))
            status = add_face(m, &elements[i]);
    return status == BATTEN_OK && m->triangles.count ? add_mesh(m, part) : status;
}

/* ---- points and lines ---- */

static batten_status gather_points(making *m, const bat_obj_element *element)
{
    bat_obj *obj = m->obj;
    const bat_obj_corner *corners = (const bat_obj_corner *)obj->corners.items + element->first;
    bat_obj_vertex *vertices = obj->vertices.items;
    batten_status status = BATTEN_OK;
    if (!check_corners(m, element))
        return BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < element->count; k++) {
        vertices[corners[k].vertex].is_used = true;
        status = bat_list_add(obj->input, &m->places, vertices[corners[k].vertex].point);
    }
    return status == BATTEN_OK ? bat_input_limit(obj->input, element->line, m->places.count,
                                                 obj->input->limits.points, "points")
                               : status;
}

static batten_status make_points(making *m, const bat_obj_part *part, size_t end)
{
    const bat_obj_element *elements = m->obj->elements.items;
    batten_status status = BATTEN_OK;
    m->places.count = 0;
    for (size_t i = part->first; status == BATTEN_OK && i < end; i++)
        if (elements[i].kind == BAT_OBJ_POINT)
            status = gather_points(m, &elements[i]);
    if (status != BATTEN_OK || m->places.count == 0)
        return status;
    return add_object(m, part,
                      (batten_object){.kind = BATTEN_OBJECT_POINTS,
                                      .point_count = (int)m->places.count,
                                      .points = m->places.items},
                      "points");
}

/* A polyline: knots 0, 0, 1, 2 ... */
static batten_status make_line(making *m, const bat_obj_part *part,
                               const bat_obj_element *element)
{
    bat_input *input = m->obj->input;
    double *knots = NULL;
    batten_curve *curve = NULL;
    m->places.count = 0;
    batten_status status = gather_points(m, element);
    const size_t n = m->places.count;
    if (status != BATTEN_OK || n == 0)
        return status;
    status = bat_input_array(input, n + 2, sizeof *knots, &knots);
    for (size_t i = 0; status == BATTEN_OK && i < n; i++)
        knots[i + 1] = (double)i;
    if (status == BATTEN_OK) {
        knots[n + 1] = (double)(n - 1);
        status = batten_curve_create(3, 1, (int)n, m->places.items, NULL, knots, &curve);
    }
    if (status == BATTEN_OK)
        status = add_object(
            m, part, (batten_object){.kind = BATTEN_OBJECT_CURVE, .curve = curve}, "line");
    batten_curve_unref(curve);
    bat_release(knots);
    return status;
}

static batten_status make_shape(making *m, const bat_obj_part *part,
                                const bat_obj_element *element)
{
    const bat_obj_shape *shape = (const bat_obj_shape *)m->obj->shapes.items + element->first;
    if (shape->curve)
        return add_object(m, part,
                          (batten_object){.kind = BATTEN_OBJECT_CURVE, .curve = shape->curve},
                          "curve");
    return add_object(m, part,
                      (batten_object){.kind = BATTEN_OBJECT_SURFACE, .surface = shape->surface},
                      "surface");
}

/* ---- parts ---- */

/* Objects come in the order in which the first of their elements stands. */
static batten_status make_part(making *m, const bat_obj_part *part, size_t end)
{
    const bat_obj_element *elements = m->obj->elements.items;
    bool has_mesh = false, has_points = false;
    batten_status status = BATTEN_OK;
    for (size_t i = part->first; status == BATTEN_OK && i < end; i++) {
        const bat_obj_element *element = &elements[i];
        if (element->kind == BAT_OBJ_LINE)
            status = make_line(m, part, element);
        else if (element->kind == BAT_OBJ_SHAPE)
            status = make_shape(m, part, element);
        else if (element->kind == BAT_OBJ_FACE && !has_mesh) {
            has_mesh = true;
            status = make_mesh(m, part, end);
        } else if (element->kind == BAT_OBJ_POINT && !has_points) {
            has_points = true;
            status = make_points(m, part, end);
        }
        if (status == BATTEN_OK && i % 1000 == 999)
            status = bat_input_step(m->obj->input, m->obj->input->size);
    }
    return status;
}

/* A file of vertices alone is a cloud, without those that are left out. */
static batten_status make_cloud(making *m)
{
    batten_status status = BATTEN_OK;
    m->places.count = 0;
    for (size_t i = 0; status == BATTEN_OK && i < m->obj->vertices.count; i++)
        if (is_vertex(m->obj, (int64_t)i))
            status =
                bat_list_add(m->obj->input, &m->places, vertex_at(m->obj, (int64_t)i)->point);
    if (status != BATTEN_OK || m->places.count == 0)
        return status;
    const bat_obj_part part = {m->obj->object, m->obj->group, 0};
    return add_object(m, &part,
                      (batten_object){.kind = BATTEN_OBJECT_POINTS,
                                      .point_count = (int)m->places.count,
                                      .points = m->places.items},
                      "points");
}

static void remark_unused(const bat_obj *obj)
{
    const bat_input *input = obj->input;
    size_t loose = 0;
    for (size_t i = 0; obj->elements.count && i < obj->vertices.count; i++)
        loose += !vertex_at(obj, (int64_t)i)->is_used;
    if (loose)
        batten_notes_remark(input->notes, input->file, 0, "",
                            "%zu of %zu vertices are of no element; not kept", loose,
                            obj->vertices.count);
    if (obj->textures)
        batten_notes_remark(input->notes, input->file, 0, "",
                            "%zu coordinates of textures are not kept", obj->textures);
    if (obj->materials)
        batten_notes_remark(input->notes, input->file, 0, "",
                            "%d statements name materials; these stand in another file, which "
                            "is not read",
                            obj->materials);
}

batten_status bat_obj_finish(bat_obj *obj, batten_model *model)
{
    making m = {.obj = obj,
                .model = model,
                .used = {.size = sizeof(int)},
                .triangles = {.size = 3 * sizeof(int)},
                .normals = {.size = 9 * sizeof(double)},
                .places = {.size = 3 * sizeof(double)},
                .cut = {.size = 3 * sizeof(int)}};
    const bat_obj_part *parts = obj->parts.items;
    const size_t vertices = obj->vertices.count;
    batten_status status = bat_input_array(obj->input, vertices, sizeof *m.local, &m.local);
    if (status == BATTEN_OK)
        status = bat_input_array(obj->input, vertices, sizeof *m.stamp, &m.stamp);
    for (size_t k = 0; status == BATTEN_OK && k < obj->parts.count; k++)
        status = make_part(&m, &parts[k],
                           k + 1 < obj->parts.count ? parts[k + 1].first : obj->elements.count);
    if (status == BATTEN_OK && obj->elements.count == 0 &&
        obj->input->left_out == obj->bad_vertices)
        status = make_cloud(&m);
    if (status == BATTEN_OK) {
        bat_remark_polygons(obj->input, m.cut_up);
        remark_unused(obj);
    }
    bat_release(m.local);
    bat_release(m.stamp);
    bat_release(m.used.items);
    bat_release(m.triangles.items);
    bat_release(m.normals.items);
    bat_release(m.places.items);
    bat_release(m.cut.items);
    bat_release(m.name);
    bat_release(m.group);
    return status;
}
