/* Normals at the corners of triangles, as each sees them. */
#include "mesh/faces/plane_scene.h"

/* Two planes that meet in a roof: degree 1 across the ridge. */
TEST(a_ridge_is_kept_with_a_normal_for_each_side)
{
    const double points[3][2][3] = {
        {{0, 0, 0}, {0, 4, 0}}, {{1, 0, 1}, {1, 4, 1}}, {{2, 0, 0}, {2, 4, 0}}};
    const double across[] = {0, 0, 0.3, 1, 1}, along[] = {0, 0, 1, 1};
    const batten_axis u = {.degree = 1, .point_count = 3, .knots = across};
    const batten_axis v = {.degree = 1, .point_count = 2, .knots = along};
    batten_surface *roof = NULL;
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    CHECK_OK(batten_surface_create(3, &u, &v, points[0][0], NULL, &roof));
    const batten_mesh_facts f = mesh_surface_well(roof, NULL, &report, &mesh);
    CHECK_NEAR(f.area, 8 * sqrt(2), 1e-13);
    CHECK_INT(batten_mesh_view(mesh)->triangle_count, 4);
    for (int t = 0; t < 4; t++) {
        const batten_mesh_parts *m = batten_mesh_view(mesh);
        double x = 0;
        for (int k = 0; k < 3; k++)
            x += m->points[3 * m->corners[3 * t + k]] / 3;
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(m->normals[9 * t + 3 * k], x < 1 ? -sqrt(0.5) : sqrt(0.5), 1e-15);
    }
    batten_mesh_unref(mesh);
}
