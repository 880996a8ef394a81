/* Faces of bodies across their common edges: boxes, cylinders and rounded edges, in closed form. */
#include "support/bodies.h"
#include "support/test.h"

#include <batten/continuity.h>
#include <batten/standard.h>

static batten_joins joins_of(const batten_body *body)
{
    batten_joins joins = {0, NULL, false};
    CHECK_OK(batten_body_joins(body, NULL, NULL, &joins));
    return joins;
}

TEST(faces_of_a_box_meet_at_right_angles_along_all_twelve_edges)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
    batten_joins joins = joins_of(box);
    CHECK_INT(joins.count, 12);
    for (int i = 0; i < joins.count; i++) {
        const batten_join *join = &joins.at[i];
        CHECK_INT(join->edge, i);
        CHECK(join->shape[0] != join->shape[1]);
        CHECK(join->side[0] == -1 && join->side[1] == -1 && join->part == -1);
        CHECK_NEAR(join->gap.value, 0, 1e-14);
        CHECK_NEAR(join->angle.value, acos(-1) / 2, 1e-12);
        CHECK_INT(join->geometric, 0);
        CHECK_NEAR(join->curvature_difference, 0, 1e-10);
    }
    batten_joins_release(&joins);
    batten_body_unref(box);
}

/* The seam of a sphere is smooth in all orders; its poles have no curve and do not join. */
TEST(the_seam_of_a_sphere_joins_it_with_itself)
{
    const batten_frame world = batten_frame_world();
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_sphere(&world, 2, &surface));
    CHECK_OK(batten_body_from_surface("ball", surface, 1e-6, &body));
    batten_joins joins = joins_of(body);
    CHECK_INT(joins.count, 1);
    CHECK_INT(joins.at[0].shape[0], 0);
    CHECK_INT(joins.at[0].shape[1], 0);
    CHECK_INT(joins.at[0].geometric, 3);
    CHECK_NEAR(joins.at[0].gap.value, 0, 1e-12);
    CHECK_NEAR(joins.at[0].angle.value, 0, 1e-7);
    batten_joins_release(&joins);
    batten_body_unref(body);
    batten_surface_unref(surface);
}

TEST(bounds_below_zero_are_refused)
{
    batten_curve_continuity_options bounds = batten_curve_continuity_defaults();
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 1, 1});
    batten_joins joins = {0, NULL, false};
    bounds.gap = -1;
    CHECK_STATUS(batten_body_joins(box, &bounds, NULL, &joins), BATTEN_BAD_ARGUMENT);
    batten_body_unref(box);
}
