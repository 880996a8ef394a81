/* Faces with many loops, and loops close together. */
#include "mesh/faces/plane_scene.h"

static const double PI = 3.14159265358979323846;

TEST(an_l_is_four_triangles)
{
    static const double corners[6][2] = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    plane_face s;
    batten_mesh_report report;
    plane_begin(&s, 4, 3);
    plane_polygon(&s, 6, corners);
    batten_body *body = plane_end(&s);
    const batten_mesh_facts f = mesh_well(body, NULL, &report, NULL);
    CHECK_INT(f.rim_edges, 6);
    CHECK_INT(f.edges, 9);
    CHECK_NEAR(f.area, 6, 1e-14);
    batten_body_unref(body);
}

TEST(a_plate_with_200_holes)
{
    static const double corners[4][2] = {{0, 0}, {20, 0}, {20, 10}, {0, 10}};
    plane_face s;
    batten_mesh_report report;
    batten_mesh_options options = batten_mesh_defaults();
    options.chord = 1e-3;
    plane_begin(&s, 20, 10);
    plane_polygon(&s, 4, corners);
    for (int i = 0; i < 200; i++)
        plane_circle(&s, 0.5 + i % 20, 0.5 + i / 20, 0.2 + 0.001 * i, true);
    batten_body *body = plane_end(&s);
    const batten_mesh_facts f = mesh_well(body, &options, &report, NULL);
    double holes = 0, rims = 0;
    for (int i = 0; i < 200; i++) {
        holes += PI * pow(0.2 + 0.001 * i, 2);
        rims += 2 * PI * (0.2 + 0.001 * i);
    }
    CHECK_INT(f.euler, 1 - 200);
    CHECK_INT(f.pieces, 1);
    CHECK(f.area >= 200 - holes);
    CHECK(f.area <= 200 - holes + rims * 1e-3);
    CHECK(report.chord <= 1e-3);
    batten_body_unref(body);
}

TEST(a_thin_ring_gets_as_many_points_as_it_needs)
{
    const double gaps[] = {1e-2, 1e-3, 1e-5};
    for (int i = 0; i < COUNT(gaps); i++) {
        plane_face s;
        batten_mesh_report report;
        batten_mesh_options options = batten_mesh_defaults();
        options.chord = 0.01;
        plane_begin(&s, 2, 2);
        plane_circle(&s, 1, 1, 1, false);
        plane_circle(&s, 1, 1, 1 - gaps[i], true);
        batten_body *body = plane_end(&s);
        const batten_mesh_facts f = mesh_well(body, &options, &report, NULL);
        CHECK_INT(report.failed, 0);
        CHECK_INT(f.euler, 0);
        CHECK_INT(f.pieces, 1);
        CHECK_NEAR(f.area, PI * (1 - pow(1 - gaps[i], 2)), 4 * gaps[i]);
        batten_body_unref(body);
    }
}
