/* Bodies without parameter curves: how far edges may be off their faces. */
#include "mesh/faces/plane_scene.h"

#include <batten/standard.h>

/* A square of side 2 whose edges are at a height over it, in a body that promises 1e-9. */
static batten_body *raised_edges(double height)
{
    const double corners[4][3] = {
        {0, 0, height}, {2, 0, height}, {2, 2, height}, {0, 2, height}};
    plane_face s;
    batten_body *body = NULL;
    int vertices[4], edge;
    plane_begin(&s, 2, 2);
    CHECK_OK(bat_builder_loop(&s.builder));
    for (int i = 0; i < 4; i++)
        CHECK_OK(bat_builder_vertex(&s.builder, corners[i], &vertices[i]));
    for (int i = 0; i < 4; i++) {
        batten_curve *line = NULL;
        CHECK_OK(batten_curve_line(3, corners[i], corners[(i + 1) % 4], &line));
        CHECK_OK(bat_builder_edge(&s.builder, line, vertices[i], vertices[(i + 1) % 4], &edge));
        CHECK_OK(bat_builder_use(&s.builder, edge, false, NULL));
        batten_curve_unref(line);
    }
    batten_surface_unref(s.plane);
    const batten_status status = bat_builder_finish(&s.builder, false, &body);
    if (test_memory_failed(status, BATTEN_OK))
        SKIP("no memory for the body");
    return body;
}

/* Up to 5e-3 of the size of the body they are traced, and up to the chord. */
TEST(edges_off_their_face_are_borne_and_told)
{
    static const struct {
        double height, chord;
        bool borne;
    } cases[] = {
        {0.002, 0.01, true}, {0.002, 0.001, true}, {0.02, 0.03, true}, {0.02, 0.001, false}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_mesh_report report;
        batten_mesh *mesh = NULL;
        batten_mesh_options options = batten_mesh_defaults();
        batten_body *body = raised_edges(cases[i].height);
        options.chord = cases[i].chord;
        CHECK_OK(batten_mesh_from_body(body, &options, NULL, NULL, &report, &mesh));
        CHECK_INT(report.failed, !cases[i].borne);
        if (cases[i].borne) {
            batten_mesh_facts f;
            CHECK_OK(batten_mesh_check(mesh, &f));
            CHECK_NEAR(report.chord, cases[i].height, 1e-6);
            CHECK_NEAR(f.area, 4, 1e-2);
        } else {
            CHECK_INT(batten_mesh_view(mesh)->triangle_count, 0);
        }
        batten_mesh_unref(mesh);
        batten_body_unref(body);
    }
}
