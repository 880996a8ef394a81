/* Loops of a face that touch at vertices of their own. */
#include "mesh/faces/plane_scene.h"

/* Each loop has a vertex of its own there, as a file says it that cannot share them. */
TEST(loops_that_touch_at_a_vertex_are_meshed)
{
    static const double square[4][2] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    static const double hole[3][2] = {{0, 0}, {1, 2}, {2, 1}};
    for (int i = 0; i < 3; i++) { /* exactly, within the tolerance, beyond */
        const double off = i == 0 ? 0 : i == 1 ? 1e-9 : 1e-7;
        double moved[3][2];
        for (int k = 0; k < 6; k++)
            moved[k / 2][k % 2] = hole[k / 2][k % 2] - off;
        plane_face s;
        batten_mesh_report report;
        plane_begin(&s, 4, 4);
        plane_polygon(&s, 4, square);
        plane_polygon(&s, 3, (const double(*)[2])moved);
        batten_body *body = plane_end(&s);
        const batten_mesh_facts f = mesh_well(body, NULL, &report, NULL);
        CHECK_INT(report.failed, i == 2);
        CHECK_NEAR(f.area, i == 2 ? 0 : 14.5, 1e-7);
        batten_body_unref(body);
    }
}
