/* Meshing step by step, and surfaces whose bounds are known. */
#include "mesh/faces/meshing_scene.h"

#include <batten/standard.h>

bat_meshing meshing_alone(double chord, double angle)
{
    return (bat_meshing){.chord = chord,
                         .fine = chord,
                         .angle = angle,
                         .longest = INFINITY,
                         .most = 10000000,
                         .job = NULL};
}

batten_surface *meshing_quadric(double width, double height, double a, double b, double c)
{
    const double u[] = {0, 0, 0, width, width, width}, v[] = {0, 0, 0, height, height, height};
    const batten_axis along = {2, 3, u, false}, across = {2, 3, v, false};
    double points[9][3];
    batten_surface *surface = NULL;
    for (int i = 0; i < 9; i++) { /* of x^2 the control points are 0, 0, width^2 */
        const double x = width * (i / 3) / 2, y = height * (i % 3) / 2;
        points[i][0] = x;
        points[i][1] = y;
        points[i][2] = (i / 3 == 2) * a * width * width / 2 +
                       (i % 3 == 2) * b * height * height / 2 + c * x * y;
    }
    CHECK_OK(batten_surface_create(3, &along, &across, points[0], NULL, &surface));
    return surface;
}

batten_surface *meshing_roof(double ridge, double height)
{
    const double knots[] = {0, 0, ridge, 1, 1}, across[] = {0, 0, 1, 1};
    const double points[] = {0,     0, 0,      0, 1, 0, ridge, 0, height,
                             ridge, 1, height, 1, 0, 0, 1,     1, 0};
    const batten_axis u = {1, 3, knots, false}, v = {1, 2, across, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &surface));
    return surface;
}

batten_surface *meshing_cylinder(double radius, double height)
{
    const batten_frame world = batten_frame_world();
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_cylinder(&world, radius, height, &surface));
    return surface;
}

bat_lattice meshing_lattice(const batten_surface *surface, const bat_meshing *m,
                            bat_sheet *sheet, const batten_interval *box)
{
    bat_lattice lattice;
    bat_sheet_begin(sheet, surface, 1e-9);
    CHECK_OK(bat_lattice_begin(&lattice, m, sheet, box ? box : sheet->domain));
    return lattice;
}

/* ---- stages ---- */

static batten_status begin_again(staged *s, double chord, double angle)
{
    s->m = meshing_alone(chord, angle);
    s->m.fine = 0.85 * chord;
    s->m.traced = &s->traced;
    s->m.parts = batten_body_view(s->body);
    const batten_status status = bat_meshing_begin(&s->m);
    if (status != BATTEN_OK)
        bat_meshing_end(&s->m);
    return status;
}

staged *stage_begin(batten_body *body, double chord, double angle)
{
    staged *s = test_array(1, sizeof *s);
    s->body = body;
    CHECK_OK(begin_again(s, chord, angle));
    return s;
}

void stage_end(staged *s)
{
    bat_meshing_end(&s->m);
    batten_body_unref(s->body);
}

static void check_same(const batten_mesh_parts *a, const batten_mesh_parts *b)
{
    CHECK_INT(a->vertex_count, b->vertex_count);
    CHECK_INT(a->triangle_count, b->triangle_count);
    CHECK(memcmp(a->points, b->points, sizeof(double[3]) * (size_t)a->vertex_count) == 0);
    CHECK(memcmp(a->corners, b->corners, sizeof(int[3]) * (size_t)a->triangle_count) == 0);
    CHECK(memcmp(a->normals, b->normals, sizeof(double[9]) * (size_t)a->triangle_count) == 0);
    CHECK(memcmp(a->faces, b->faces, sizeof(int) * (size_t)a->triangle_count) == 0);
}

void check_mesh_faults(const batten_body *body, const batten_mesh_options *options)
{
    batten_mesh *whole = NULL;
    test_fail_allocation(0);
    CHECK_OK(batten_mesh_from_body(body, options, NULL, NULL, NULL, &whole));
    const long all = test_allocations();
    for (long at = 1; at <= all; at++) {
        batten_mesh *mesh = NULL;
        test_fail_allocation(at);
        const batten_status status =
            batten_mesh_from_body(body, options, NULL, NULL, NULL, &mesh);
        test_fail_allocation(0);
        CHECK(status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY);
        CHECK((mesh != NULL) == (status == BATTEN_OK));
        if (mesh)
            check_same(batten_mesh_view(mesh), batten_mesh_view(whole));
        batten_mesh_unref(mesh);
    }
    batten_mesh_unref(whole);
}
