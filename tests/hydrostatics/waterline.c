/* How far waterlines reach. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

TEST(the_waterline_of_a_box_is_as_long_and_wide_as_the_box)
{
    batten_hull *hull = box_hull();
    const batten_flotation at = {0.9, 0, 0};
    batten_interval along, across;
    CHECK_OK(batten_hull_waterline(hull, &at, 1e-9, &along, &across));
    CHECK_NEAR(along.a, 0, 1e-9);
    CHECK_NEAR(along.b, 4, 1e-9);
    CHECK_NEAR(across.a, -1, 1e-9);
    CHECK_NEAR(across.b, 1, 1e-9);
    batten_hull_free(hull);
}

TEST(a_waterline_that_turns_inside_a_patch_is_followed_to_its_farthest_points)
{
    batten_hull *hull = wigley_hull();
    batten_interval along, across;
    const batten_flotation at = {-0.3, 0, 0}, above = {-1, 0, 0};
    CHECK_OK(batten_hull_waterline(hull, &at, 1e-9, &along, &across));
    CHECK_NEAR(along.b - along.a, WIGLEY_LENGTH, 1e-9);
    const double share = 1 - 0.3 * 0.3 / (WIGLEY_DRAUGHT * WIGLEY_DRAUGHT);
    CHECK_NEAR(across.b, WIGLEY_BREADTH / 2. * share, 1e-9);
    CHECK_OK(batten_hull_waterline(hull, &above, 1e-9, &along, &across));
    CHECK_NEAR(along.b - along.a, 0, 0);
    CHECK_STATUS(batten_hull_waterline(hull, &at, 0, &along, &across), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("tolerance");
    batten_hull_free(hull);
}
