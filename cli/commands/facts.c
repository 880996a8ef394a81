/* What `batten info` reports of one object: kind, degree, counts, box, closedness. */
#include "commands/facts.h"

#include <batten/model.h>
#include <string.h>

static double tolerance_in(batten_box box)
{
    /* A thousand-millionth of the box: above the rounding of what files hold, below what is made. */
    return 1e-9 *
           (box.high.x - box.low.x + (box.high.y - box.low.y) + (box.high.z - box.low.z));
}

static facts curve_facts(const batten_curve *curve)
{
    const batten_box box = batten_curve_box(curve);
    return (facts){
        .type = "curve",
        .kind = batten_curve_is_periodic(curve) ? "periodic nurbs" : "nurbs",
        .dimension = batten_curve_dimension(curve),
        .directions = 1,
        .degree = {batten_curve_degree(curve)},
        .points = {batten_curve_point_count(curve)},
        .rational = batten_curve_is_rational(curve),
        .closed = {batten_curve_is_closed(curve, tolerance_in(box))},
        .domain = {batten_curve_domain(curve)},
        .controls = true,
        .box = box,
    };
}

static facts surface_facts(const batten_surface *surface)
{
    facts f = {
        .type = "surface",
        .kind = batten_surface_kind(surface),
        .dimension = batten_surface_dimension(surface),
        .directions = 2,
        .box = batten_surface_box(surface),
    };
    for (int d = 0; d < 2; d++) {
        f.domain[d] = batten_surface_domain(surface, (batten_direction)d);
        f.closed[d] =
            batten_surface_is_closed(surface, (batten_direction)d, tolerance_in(f.box));
    }
    if (strcmp(f.kind, "nurbs") == 0) {
        f.controls = true;
        f.rational = batten_surface_is_rational(surface);
        for (int d = 0; d < 2; d++) {
            f.degree[d] = batten_surface_degree(surface, (batten_direction)d);
            f.points[d] = batten_surface_point_count(surface, (batten_direction)d);
        }
    }
    return f;
}

static facts triangles_facts(const batten_triangles *triangles)
{
    return (facts){
        .type = "triangles",
        .kind = "bezier",
        .dimension = batten_triangles_dimension(triangles),
        .degree = {batten_triangles_degree(triangles)},
        .points = {batten_triangles_count(triangles)},
        .rational = batten_triangles_is_rational(triangles),
        .controls = true,
        .box = batten_triangles_box(triangles),
    };
}

static facts body_facts(const batten_body *body)
{
    const batten_body_parts *parts = batten_body_view(body);
    int coloured = 0;
    for (int i = 0; i < parts->face_count; i++)
        coloured += parts->faces[i].has_colour;
    return (facts){
        .has_faces = true,
        .coloured_faces = coloured,
        .type = parts->is_solid ? "solid" : "sheet",
        .kind = "body",
        .dimension = 3,
        .counted = {"face", "edge", "vertex", "shell"},
        .counts = {parts->face_count, parts->edge_count, parts->vertex_count,
                   parts->shell_count},
        .controls = true,
        .box = batten_body_box(body),
    };
}

static facts mesh_facts(const batten_mesh *mesh)
{
    const batten_mesh_parts *parts = batten_mesh_view(mesh);
    batten_mesh_facts found = {0};
    const bool checked = batten_mesh_check(mesh, &found) == BATTEN_OK;
    return (facts){
        .has_faces = true,
        .coloured_faces = parts->triangle_colours ? parts->triangle_count : 0,
        .type = "mesh",
        .kind = "triangles",
        .dimension = 3,
        .counted = {"triangle", "vertex", checked ? "piece" : NULL},
        .counts = {parts->triangle_count, parts->vertex_count, checked ? found.pieces : 0},
        .remark = !checked              ? NULL
                  : found.is_watertight ? "watertight"
                                        : "not watertight",
        .mesh_checked = checked,
        .mesh = found,
        .box = batten_mesh_box(mesh),
    };
}

static void widen(double *low, double *high, double value)
{
    if (value < *low)
        *low = value;
    if (value > *high)
        *high = value;
}

static batten_box points_box(const batten_object *object)
{
    batten_box box = {{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < object->point_count; i++) {
        const double *p = object->points + 3 * i;
        const batten_box here = {{p[0], p[1], p[2]}, {p[0], p[1], p[2]}};
        if (i == 0)
            box = here;
        widen(&box.low.x, &box.high.x, p[0]);
        widen(&box.low.y, &box.high.y, p[1]);
        widen(&box.low.z, &box.high.z, p[2]);
    }
    return box;
}

static facts table_facts(const batten_offset_table *table)
{
    return (facts){.type = "offsets",
                   .kind = "table",
                   .dimension = 3,
                   .points = {batten_offset_table_station_count(table),
                              batten_offset_table_line_count(table)},
                   .box = batten_offset_table_box(table)};
}

static facts points_facts(const batten_object *object)
{
    return (facts){.type = "points",
                   .kind = "row",
                   .dimension = 3,
                   .points = {object->point_count},
                   .box = points_box(object)};
}

static facts facts_without_tolerance(const batten_object *object)
{
    switch (object->kind) {
    case BATTEN_OBJECT_CURVE:
        return curve_facts(object->curve);
    case BATTEN_OBJECT_SURFACE:
        return surface_facts(object->surface);
    case BATTEN_OBJECT_OFFSET_TABLE:
        return table_facts(object->offset_table);
    case BATTEN_OBJECT_TRIANGLES:
        return triangles_facts(object->triangles);
    case BATTEN_OBJECT_BODY:
        return body_facts(object->body);
    case BATTEN_OBJECT_MESH:
        return mesh_facts(object->mesh);
    case BATTEN_OBJECT_POINTS:
    case BATTEN_OBJECT_INSTANCE: /* 'info' tells of what instances place */
        break;
    }
    return points_facts(object);
}

facts facts_of(const batten_object *object)
{
    facts f = facts_without_tolerance(object);
    f.tolerance = tolerance_in(f.box);
    return f;
}
