/* Areas of sections. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

TEST(areas_of_a_hull_of_wigley_are_those_of_its_parabolas)
{
    batten_hull *hull = wigley_hull();
    const batten_flotation at = {0, 0, 0};
    const double x[] = {-5, -4, -1, 0, 2.5, 5, 6};
    double areas[7];
    CHECK_OK(batten_hull_section_areas(hull, &at, 7, x, 1e-12, areas));
    for (int i = 0; i < 6; i++) {
        const double share = 1 - 4 * x[i] * x[i] / (WIGLEY_LENGTH * WIGLEY_LENGTH);
        CHECK_NEAR(areas[i], WIGLEY_BREADTH * share * WIGLEY_DRAUGHT * 2 / 3, 1e-9);
    }
    CHECK_NEAR(areas[6], 0, 0);
    batten_hull_free(hull);
}

TEST(areas_of_a_heeled_box_are_those_of_its_section_and_its_ends_count)
{
    batten_hull *hull = box_hull();
    const batten_flotation at = {0.9, 0, 0.5};
    const double x[] = {0, 1, 4};
    double areas[3];
    CHECK_OK(batten_hull_section_areas(hull, &at, 3, x, 1e-10, areas));
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(areas[i], 1.8, 1e-8);
    batten_hull_free(hull);
}

TEST(a_place_that_is_not_finite_leaves_the_areas_as_they_were)
{
    batten_hull *hull = box_hull();
    const batten_flotation at = {0.9, 0, 0};
    const double x[] = {1, NAN};
    double areas[2] = {-1, -1};
    CHECK_STATUS(batten_hull_section_areas(hull, &at, 2, x, 1e-10, areas), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("place 2");
    CHECK_NEAR(areas[0], -1, 0);
    batten_hull_free(hull);
}
