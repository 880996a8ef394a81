/* Edges across a face that another face has too. */
#include "mesh/faces/plane_scene.h"

/* Two discs on one another share nothing but their rim, however alike their triangles are. */
TEST(two_discs_with_one_rim_are_closed)
{
    plane_face s;
    batten_mesh_report report;
    plane_begin(&s, 2, 2);
    plane_circle(&s, 1, 1, 1, false);
    CHECK_OK(bat_builder_face(
        &s.builder, &(batten_body_face){.name = "back", .surface = s.plane, .reversed = true}));
    CHECK_OK(bat_builder_loop(&s.builder));
    CHECK_OK(bat_builder_use(&s.builder, 0, true, s.builder.parts.uses[0].parameters));
    batten_body *body = plane_end(&s);
    const batten_mesh_facts f = mesh_well(body, NULL, &report, NULL);
    CHECK(f.is_watertight);
    CHECK_INT(f.euler, 2);
    CHECK_NEAR(f.volume, 0, 1e-15);
    batten_body_unref(body);
}
