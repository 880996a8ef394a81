/* Items of representations as objects. */
#include "exchange/step/read/import.h"

#include <string.h>

/* ---- curves, surfaces and points, alone or in a set ---- */

static batten_status add_shape(const bat_step_target *target, const bat_step_instance *item,
                               const bat_step_instance *set, batten_object *object)
{
    const bat_step_instance *from[] = {item, set};
    char name[BAT_STEP_NAME];
    bat_step_dress(target, 2, from, object, name);
    return bat_step_add_object(target, item, object);
}

static batten_status read_curve(const bat_step_target *target, const bat_step_instance *item,
                                const bat_step_instance *set)
{
    batten_curve *curve = NULL;
    batten_status status =
        bat_step_read_curve(&target->import->file, item, &target->scale, &curve);
    if (status != BATTEN_OK)
        return bat_step_leave_item(target, item, status);
    batten_object object = {.kind = BATTEN_OBJECT_CURVE, .curve = curve};
    status = bat_step_spend(&target->import->topology, item,
                            (size_t)batten_curve_point_count(curve));
    if (status == BATTEN_OK)
        status = add_shape(target, item, set, &object);
    batten_curve_unref(curve);
    return status;
}

/* An offset may be so large that nothing is left of the shape. */
static batten_status check_surface(const bat_step_target *target, const bat_step_instance *item,
                                   const batten_surface *surface)
{
    const batten_box box = batten_surface_box(surface);
    if (box.low.x < box.high.x || box.low.y < box.high.y || box.low.z < box.high.z)
        return BATTEN_OK;
    return bat_step_fail(&target->import->file, item, BATTEN_BAD_FORMAT,
                         "all points of the surface are (%g, %g, %g)", box.low.x, box.low.y,
                         box.low.z);
}

static batten_status read_surface(const bat_step_target *target, const bat_step_instance *item,
                                  const bat_step_instance *set)
{
    batten_surface *surface = NULL;
    batten_status status =
        bat_step_read_surface(&target->import->file, item, &target->scale, &surface);
    if (status == BATTEN_OK)
        status = check_surface(target, item, surface);
    if (status != BATTEN_OK) {
        batten_surface_unref(surface);
        return bat_step_leave_item(target, item, status);
    }
    batten_object object = {.kind = BATTEN_OBJECT_SURFACE, .surface = surface};
    status = bat_step_spend(&target->import->topology, item,
                            (size_t)batten_surface_point_count(surface, BATTEN_U) *
                                (size_t)batten_surface_point_count(surface, BATTEN_V));
    if (status == BATTEN_OK)
        status = add_shape(target, item, set, &object);
    batten_surface_unref(surface);
    return status;
}

/* The points that follow one another in a set are one object. */
static batten_status add_points(const bat_step_target *target, const bat_step_instance *first,
                                const bat_step_instance *set, bat_list *points)
{
    const int count = (int)points->count;
    if (count == 0)
        return BATTEN_OK;
    batten_object object = {
        .kind = BATTEN_OBJECT_POINTS, .point_count = count, .points = points->items};
    points->count = 0;
    return count == 1 ? add_shape(target, first, set, &object)
                      : add_shape(target, set, first, &object);
}

static batten_status read_point(const bat_step_target *target, const bat_step_instance *item,
                                bat_list *points)
{
    double point[3];
    batten_status status =
        bat_step_read_point(&target->import->file, item, &target->scale, point);
    if (status != BATTEN_OK)
        return bat_step_leave_item(target, item, status);
    return bat_list_add(target->import->input, points, point);
}

static batten_status read_bare_point(const bat_step_target *target,
                                     const bat_step_instance *item)
{
    bat_list points = {.size = 3 * sizeof(double)};
    batten_status status = read_point(target, item, &points);
    if (status == BATTEN_OK)
        status = add_points(target, item, NULL, &points);
    bat_release(points.items);
    return status;
}

/* ---- edges alone ---- */

static batten_status read_edge(const bat_step_target *target, const bat_step_instance *item,
                               const bat_step_instance *set)
{
    bat_step_topology *topology = &target->import->topology;
    int index = 0;
    bat_step_body_begin(topology, &target->scale);
    batten_status status = bat_step_read_edge(topology, item, &index);
    if (status != BATTEN_OK)
        return bat_step_give_up(target, item, status);
    const batten_curve *curve = topology->builder.parts.edges[index].curve;
    batten_object object = {.kind = BATTEN_OBJECT_CURVE, .curve = curve};
    if (curve)
        status = add_shape(target, item, set, &object);
    bat_builder_end(&topology->builder);
    return status;
}

/* CONNECTED_EDGE_SETs of an EDGE_BASED_WIREFRAME_MODEL. */
static batten_status read_wires(const bat_step_target *target, const bat_step_instance *item)
{
    const bat_step_file *file = &target->import->file;
    const bat_step_record *record = bat_step_first(file, item);
    int sets = 0;
    size_t at = 0;
    batten_status status = bat_step_get_list(file, record, 1, &sets, &at);
    for (int k = 0; status == BATTEN_OK && k < sets; k++) {
        const bat_step_instance *set = NULL, *edge = NULL;
        int count = 0;
        size_t inner = 0;
        status = bat_step_item_reference(file, record, &at, &set);
        const bat_step_record *edges = status == BATTEN_OK ? bat_step_first(file, set) : NULL;
        if (status == BATTEN_OK)
            status = bat_step_get_list(file, edges, 1, &count, &inner);
        for (int i = 0; status == BATTEN_OK && i < count; i++) {
            status = bat_step_item_reference(file, edges, &inner, &edge);
            if (status == BATTEN_OK)
                status = bat_step_spend(&target->import->topology, edge, 1);
            if (status == BATTEN_OK)
                status = read_edge(target, edge, item);
        }
    }
    return status == BATTEN_OK ? status : bat_step_leave_item(target, item, status);
}

/* ---- kinds ---- */

typedef enum { CURVE, SURFACE, POINT, OTHER } family;

static family family_of(const bat_step_file *file, const bat_step_instance *item)
{
    static const char *const curves[] = {"LINE",     "CIRCLE",    "ELLIPSE",
                                         "PARABOLA", "HYPERBOLA", "POLYLINE"};
    char keyword[BAT_STEP_KEYWORD_SIZE];
    bat_step_keyword(file, item, keyword);
    for (size_t k = 0; k < sizeof curves / sizeof curves[0]; k++)
        if (strcmp(keyword, curves[k]) == 0)
            return CURVE;
    if (strcmp(keyword, "CARTESIAN_POINT") == 0)
        return POINT;
    if (strstr(keyword, "ANNOTATION"))
        return OTHER;
    if (strstr(keyword, "SURFACE_CURVE") || strstr(keyword, "CURVE_ON_SURFACE"))
        return CURVE;
    if (strstr(keyword, "SURFACE") || strcmp(keyword, "PLANE") == 0)
        return SURFACE;
    return strstr(keyword, "CURVE") ? CURVE : OTHER;
}

static bool is_any(const bat_step_file *file, const bat_step_instance *item,
                   const char *const *keywords)
{
    for (; *keywords; keywords++)
        if (bat_step_as(file, item, *keywords))
            return true;
    return false;
}

/* Things that have no shape of their own. */
static const char *const shapeless[] = {"AXIS2_PLACEMENT_3D",
                                        "AXIS2_PLACEMENT_2D",
                                        "AXIS1_PLACEMENT",
                                        "PLACEMENT",
                                        "DIRECTION",
                                        "VECTOR",
                                        "CARTESIAN_TRANSFORMATION_OPERATOR_3D",
                                        "DESCRIPTIVE_REPRESENTATION_ITEM",
                                        "MEASURE_REPRESENTATION_ITEM",
                                        "VALUE_REPRESENTATION_ITEM",
                                        NULL};

/* Texts, leaders and such belong to a drawing and not to the shape. */
static bool is_annotation(const bat_step_file *file, const bat_step_instance *item)
{
    static const char *const words[] = {"ANNOTATION", "CALLOUT", "TEXT", "SYMBOL", "PLANAR_"};
    char keyword[BAT_STEP_KEYWORD_SIZE];
    bat_step_keyword(file, item, keyword);
    for (size_t k = 0; k < sizeof words / sizeof words[0]; k++)
        if (strstr(keyword, words[k]))
            return true;
    return false;
}

static batten_status refuse(const bat_step_target *target, const bat_step_instance *item)
{
    if (is_annotation(&target->import->file, item)) {
        target->import->annotations++;
        return BATTEN_OK;
    }
    return bat_step_leave_item(
        target, item,
        bat_step_fail(&target->import->file, item, BATTEN_UNSUPPORTED, "its kind is not read"));
}

static batten_status read_alone(const bat_step_target *target, const bat_step_instance *item,
                                const bat_step_instance *set)
{
    if (bat_step_is_body(&target->import->file, item))
        return bat_step_read_body(target, item);
    switch (family_of(&target->import->file, item)) {
    case CURVE:
        return read_curve(target, item, set);
    case SURFACE:
        return read_surface(target, item, set);
    case POINT:
        return read_bare_point(target, item);
    case OTHER:
        break;
    }
    return is_any(&target->import->file, item, shapeless) ? BATTEN_OK : refuse(target, item);
}

static batten_status read_set(const bat_step_target *target, const bat_step_instance *set)
{
    bat_step_import *import = target->import;
    const bat_step_record *record = bat_step_first(&import->file, set);
    const bat_step_instance *first = NULL;
    bat_list points = {.size = 3 * sizeof(double)};
    int count = 0;
    size_t at = 0;
    batten_status status = bat_step_get_list(&import->file, record, 1, &count, &at);
    if (status != BATTEN_OK)
        return bat_step_leave_item(target, set, status);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_step_instance *item = NULL;
        status = bat_step_item_reference(&import->file, record, &at, &item);
        if (status != BATTEN_OK) {
            status = bat_step_leave_item(target, set, status);
            continue;
        }
        if (family_of(&import->file, item) == POINT) {
            first = points.count ? first : item;
            status = read_point(target, item, &points);
            continue;
        }
        status = add_points(target, first, set, &points);
        if (status == BATTEN_OK)
            status = bat_step_spend(&import->topology, set, 1);
        if (status == BATTEN_OK)
            status = read_alone(target, item, set);
    }
    if (status == BATTEN_OK)
        status = add_points(target, first, set, &points);
    bat_release(points.items);
    return status;
}

batten_status bat_step_read_item(const bat_step_target *target, const bat_step_instance *item)
{
    static const char *const sets[] = {"GEOMETRIC_SET", "GEOMETRIC_CURVE_SET", NULL};
    const bat_step_file *file = &target->import->file;
    if (bat_step_is_body(file, item))
        return bat_step_read_body(target, item);
    if (is_any(file, item, sets))
        return read_set(target, item);
    if (bat_step_as(file, item, "EDGE_BASED_WIREFRAME_MODEL"))
        return read_wires(target, item);
    if (bat_step_as(file, item, "EDGE_CURVE"))
        return read_edge(target, item, NULL);
    if (bat_step_is_tessellated(file, item))
        return bat_step_read_tessellated(target, item);
    return read_alone(target, item, NULL);
}
