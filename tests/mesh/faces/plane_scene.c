/* Faces in the plane, with any loops, and their meshes. */
#include "mesh/faces/plane_scene.h"

#include <batten/standard.h>

void plane_begin(plane_face *s, double width, double height)
{
    const double u[] = {0, 0, width, width}, v[] = {0, 0, height, height};
    const double points[4][3] = {{0, 0, 0}, {0, height, 0}, {width, 0, 0}, {width, height, 0}};
    const batten_axis axis_u = {1, 2, u, false}, axis_v = {1, 2, v, false};
    s->plane = NULL;
    CHECK_OK(batten_surface_create(3, &axis_u, &axis_v, points[0], NULL, &s->plane));
    bat_builder_begin(&s->builder, 1e-9);
    CHECK_OK(bat_builder_shell(&s->builder, false));
    CHECK_OK(bat_builder_face(&s->builder,
                              &(batten_body_face){.name = "plane", .surface = s->plane}));
}

void plane_add(plane_face *s, const batten_curve *flat, int from, int to, bool reversed)
{
    batten_curve *lifted = NULL;
    int edge = 0;
    CHECK_OK(batten_curve_to_dimension(flat, 3, &lifted));
    CHECK_OK(bat_builder_edge(&s->builder, lifted, from, to, &edge));
    CHECK_OK(bat_builder_use(&s->builder, edge, reversed, flat));
    batten_curve_unref(lifted);
}

void plane_polygon(plane_face *s, int count, const double (*points)[2])
{
    int first = 0;
    CHECK_OK(bat_builder_loop(&s->builder));
    for (int i = 0; i < count; i++) {
        int vertex = 0;
        CHECK_OK(bat_builder_vertex(&s->builder, (double[]){points[i][0], points[i][1], 0},
                                    &vertex));
        first = i ? first : vertex;
    }
    for (int i = 0; i < count; i++) {
        batten_curve *line = NULL;
        CHECK_OK(batten_curve_line(2, points[i], points[(i + 1) % count], &line));
        plane_add(s, line, first + i, first + (i + 1) % count, false);
        batten_curve_unref(line);
    }
}

void plane_circle(plane_face *s, double x, double y, double radius, bool is_hole)
{
    const batten_affine place = batten_affine_translation(x, y, 0);
    batten_curve *circle = NULL, *placed = NULL;
    int vertex = 0;
    CHECK_OK(batten_curve_circle(radius, BATTEN_CIRCLE_SQUARE_9, &circle));
    CHECK_OK(batten_curve_transform(circle, &place, &placed));
    CHECK_OK(bat_builder_loop(&s->builder));
    CHECK_OK(bat_builder_vertex(&s->builder, (double[]){x + radius, y, 0}, &vertex));
    plane_add(s, placed, vertex, vertex, is_hole);
    batten_curve_unref(circle);
    batten_curve_unref(placed);
}

batten_body *plane_end(plane_face *s)
{
    batten_body *body = NULL;
    batten_surface_unref(s->plane);
    s->builder.parts.is_traced = true;
    const batten_status status = bat_builder_finish(&s->builder, false, &body);
    if (test_memory_failed(status, BATTEN_OK)) /* the builder is empty now */
        SKIP("no memory for the body");
    CHECK(status == BATTEN_OK);
    return body;
}

/* Takes the mesh, or gives it to the caller. */
static batten_mesh_facts check_well(batten_mesh *mesh, batten_mesh **out)
{
    batten_mesh_facts facts;
    CHECK_OK(batten_mesh_check(mesh, &facts));
    CHECK_INT(facts.wrong_edges + facts.crowded_edges + facts.loose_vertices, 0);
    CHECK_INT(facts.flat_triangles, 0);
    if (out)
        *out = mesh;
    else
        batten_mesh_unref(mesh);
    return facts;
}

batten_mesh_facts mesh_well(const batten_body *body, const batten_mesh_options *options,
                            batten_mesh_report *report, batten_mesh **out)
{
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_mesh_from_body(body, options, NULL, NULL, report, &mesh));
    return check_well(mesh, out);
}

batten_mesh_facts mesh_surface_well(batten_surface *surface, const batten_mesh_options *options,
                                    batten_mesh_report *report, batten_mesh **out)
{
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_mesh_from_surface(surface, options, NULL, report, &mesh));
    CHECK_INT(report->failed, 0);
    batten_surface_unref(surface);
    return check_well(mesh, out);
}
