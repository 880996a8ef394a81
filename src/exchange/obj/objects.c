/* The objects of a file whose statements have been read. */
#include "exchange/obj/objects.h"
#include "exchange/meshes/facets.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* ---- points and lines ---- */

static batten_status gather_points(bat_obj_making *m, const bat_obj_element *element)
{
    bat_obj *obj = m->obj;
    const bat_obj_corner *corners = (const bat_obj_corner *)obj->corners.items + element->first;
    bat_obj_vertex *vertices = obj->vertices.items;
    batten_status status = BATTEN_OK;
    if (!bat_obj_check_corners(m, element))
        return BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < element->count; k++) {
        vertices[corners[k].vertex].is_used = true;
        status = bat_list_add(obj->input, &m->places, vertices[corners[k].vertex].point);
    }
    return status == BATTEN_OK ? bat_input_limit(obj->input, element->line, m->places.count,
                                                 obj->input->limits.points, "points")
                               : status;
}

static batten_status make_points(bat_obj_making *m, const bat_obj_part *part, size_t end)
{
    const bat_obj_element *elements = m->obj->elements.items;
    batten_status status = BATTEN_OK;
    m->places.count = 0;
    for (size_t i = part->first; status == BATTEN_OK && i < end; i++)
        if (elements[i].kind == BAT_OBJ_POINT)
            status = gather_points(m, &elements[i]);
    if (status != BATTEN_OK || m->places.count == 0)
        return status;
    return bat_obj_add_object(m, part,
                              (batten_object){.kind = BATTEN_OBJECT_POINTS,
                                              .point_count = (int)m->places.count,
                                              .points = m->places.items},
                              "points");
}

/* A polyline: knots 0, 0, 1, 2 ... */
static batten_status make_line(bat_obj_making *m, const bat_obj_part *part,
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
        status = batten_curve_create((batten_points){3, (int)n, m->places.items}, 1, NULL,
                                     knots, &curve);
    }
    if (status == BATTEN_OK)
        status = bat_obj_add_object(
            m, part, (batten_object){.kind = BATTEN_OBJECT_CURVE, .curve = curve}, "line");
    batten_curve_unref(curve);
    bat_release(knots);
    return status;
}

static batten_status make_shape(bat_obj_making *m, const bat_obj_part *part,
                                const bat_obj_element *element)
{
    const bat_obj_shape *shape = (const bat_obj_shape *)m->obj->shapes.items + element->first;
    if (shape->curve)
        return bat_obj_add_object(
            m, part, (batten_object){.kind = BATTEN_OBJECT_CURVE, .curve = shape->curve},
            "curve");
    return bat_obj_add_object(
        m, part, (batten_object){.kind = BATTEN_OBJECT_SURFACE, .surface = shape->surface},
        "surface");
}

/* ---- parts ---- */

/* Objects come in the order in which the first of their elements stands. */
static batten_status make_part(bat_obj_making *m, const bat_obj_part *part, size_t end)
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
            status = bat_obj_make_mesh(m, part, end);
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
static batten_status make_cloud(bat_obj_making *m)
{
    batten_status status = BATTEN_OK;
    m->places.count = 0;
    for (size_t i = 0; status == BATTEN_OK && i < m->obj->vertices.count; i++)
        if (bat_obj_is_vertex(m->obj, (int64_t)i))
            status = bat_list_add(m->obj->input, &m->places,
                                  bat_obj_vertex_at(m->obj, (int64_t)i)->point);
    if (status != BATTEN_OK || m->places.count == 0)
        return status;
    const bat_obj_part part = {m->obj->object, m->obj->group, 0};
    return bat_obj_add_object(m, &part,
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
        loose += !bat_obj_vertex_at(obj, (int64_t)i)->is_used;
    if (loose)
        batten_notes_remark(input->notes, input->file, 0, "",
                            "%zu of %zu vertices belong to no element; not kept", loose,
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

static void end_making(bat_obj_making *m)
{
    bat_release(m->local);
    bat_release(m->stamp);
    bat_release(m->used.items);
    bat_release(m->triangles.items);
    bat_release(m->normals.items);
    bat_release(m->places.items);
    bat_release(m->cut.items);
    bat_release(m->name);
    bat_release(m->group);
}

static batten_status make_parts(bat_obj_making *m)
{
    const bat_obj *obj = m->obj;
    const bat_obj_part *parts = obj->parts.items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < obj->parts.count; k++)
        status = make_part(m, &parts[k],
                           k + 1 < obj->parts.count ? parts[k + 1].first : obj->elements.count);
    if (status == BATTEN_OK && obj->elements.count == 0 &&
        obj->input->left_out == obj->bad_vertices)
        status = make_cloud(m);
    return status;
}

batten_status bat_obj_finish(bat_obj *obj, batten_model *model)
{
    bat_obj_making m = {.obj = obj,
                        .model = model,
                        .used = {.size = sizeof(int)},
                        .triangles = {.size = 3 * sizeof(int)},
                        .normals = {.size = 9 * sizeof(double)},
                        .places = {.size = 3 * sizeof(double)},
                        .cut = {.size = 3 * sizeof(int)}};
    const size_t vertices = obj->vertices.count;
    batten_status status = bat_input_array(obj->input, vertices, sizeof *m.local, &m.local);
    if (status == BATTEN_OK)
        status = bat_input_array(obj->input, vertices, sizeof *m.stamp, &m.stamp);
    if (status == BATTEN_OK)
        status = make_parts(&m);
    if (status == BATTEN_OK) {
        bat_remark_polygons(obj->input, m.cut_up);
        remark_unused(obj);
    }
    end_making(&m);
    return status;
}
