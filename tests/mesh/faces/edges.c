/* Edges as polylines, as fine as their faces need. */
#include "mesh/faces/plane_scene.h"

#include <batten/standard.h>

/* A line and an arc that leaves it by less than the chord: their only samples are their ends.
 */
TEST(a_sliver_between_a_line_and_an_arc_is_meshed_at_every_chord)
{
    static const double chords[] = {1, 0.3, 0.1, 0.03, 0.01, 1e-3};
    static const double ends[2][2] = {{1, 0}, {1, 4}}, knots[] = {0, 0, 0, 1, 1, 1};
    static const double arc[3][2] = {{1, 0}, {1.1, 2}, {1, 4}};
    for (int i = 0; i < COUNT(chords); i++) {
        batten_curve *line = NULL, *bow = NULL;
        batten_mesh_options options = batten_mesh_defaults();
        batten_mesh_report report;
        int vertices[2];
        plane_face s;
        options.chord = chords[i];
        plane_begin(&s, 2, 4);
        CHECK_OK(bat_builder_loop(&s.builder));
        for (int k = 0; k < 2; k++)
            CHECK_OK(bat_builder_vertex(&s.builder, (double[]){ends[k][0], ends[k][1], 0},
                                        &vertices[k]));
        CHECK_OK(batten_curve_line(2, ends[0], ends[1], &line));
        CHECK_OK(batten_curve_create((batten_points){2, 3, arc[0]}, 2, NULL, knots, &bow));
        plane_add(&s, bow, vertices[0], vertices[1], false);
        plane_add(&s, line, vertices[0], vertices[1], true);
        batten_curve_unref(line);
        batten_curve_unref(bow);
        batten_body *body = plane_end(&s);
        const batten_mesh_facts f = mesh_well(body, &options, &report, NULL);
        CHECK_INT(report.failed, 0);
        CHECK_NEAR(f.area, 0.4 / 3, bat_min(0.04, 4 * chords[i]));
        batten_body_unref(body);
    }
}

/* A strip between two curves that stand still over the middle of three spans. */
TEST(G5_where_a_border_stands_still_no_triangle_is_flat)
{
    static const double x[7] = {0, 0.3, 1, 1, 1, 1.7, 2};
    static const double across[4] = {0, 0, 1, 1}, along[10] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3};
    double points[2][7][3];
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 7; j++) {
            points[i][j][0] = x[j];
            points[i][j][1] = i;
            points[i][j][2] = x[j] * x[j] / 4;
        }
    const batten_axis u = {.degree = 1, .point_count = 2, .knots = across};
    const batten_axis v = {.degree = 2, .point_count = 7, .knots = along};
    batten_surface *strip = NULL;
    batten_mesh_report report;
    CHECK_OK(batten_surface_create(3, &u, &v, points[0][0], NULL, &strip));
    const batten_mesh_facts f = mesh_surface_well(strip, NULL, &report, NULL);
    CHECK_INT(f.euler, 1);
}
