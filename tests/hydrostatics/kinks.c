/* Corners of the wet area between the nodes of every rule. */
#include "hydrostatics/kinks.h"

#include "hydrostatics/hulls.h"
#include "support/test.h"

static const double DEGREE = 3.14159265358979323846 / 180;
static const double section[][2] = {{0, 0}, {2, 0}, {2, 1}};

static batten_hydrostatics values_of(batten_surface *half, batten_flotation at)
{
    batten_hull *hull = hull_of(half);
    batten_hydrostatics v;
    CHECK_OK(batten_hull_hydrostatics(hull, &at, 1e-10, NULL, &v));
    CHECK_NEAR(v.open[0] + v.open[1], 0, 1e-8);
    batten_hull_free(hull);
    return v;
}

/* Its waterline leaves the bottom and the deck within a patch. */
TEST(a_box_that_lies_obliquely_has_the_values_of_one_that_is_divided)
{
    const batten_flotation at = {0.34, -4.7 * DEGREE, 31 * DEGREE};
    batten_surface *divided = NULL, *half = half_prism(0, 10, 3, section);
    const double knots[] = {0.37, 0.61};
    CHECK_OK(batten_surface_refine(half, BATTEN_U, 2, knots, &divided));
    const batten_hydrostatics a = values_of(half, at), b = values_of(divided, at);
    CHECK_NEAR(a.volume, 25.31592, 1e-5);
    CHECK_NEAR(a.waterplane, 19.3852, 1e-4);
    CHECK_NEAR(a.volume, b.volume, 1e-8);
    CHECK_NEAR(a.waterplane, b.waterplane, 1e-8);
    CHECK_NEAR(a.across, b.across, 1e-7);
    CHECK_NEAR(a.along, b.along, 1e-7);
}

TEST(water_at_a_flat_deck_still_has_its_plane_and_at_a_flat_bottom_too)
{
    for (int top = 0; top < 2; top++) {
        const batten_hydrostatics v =
            values_of(half_prism(0, 10, 3, section), (batten_flotation){top, 0, 0});
        CHECK_NEAR(v.waterplane, 40, 1e-11);
        CHECK_NEAR(v.volume, top ? 40 : 0, 1e-11);
    }
}

/* A flat strip that a plane crosses in its middle has none; the ends of rows and a turn have. */
TEST(kinks_are_where_the_waterline_meets_the_ends_of_rows_and_where_it_turns)
{
    double points[3][3][4];
    double kinks[BAT_MOST_KINKS];
    int count = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) { /* z = (2 u - 1)^2 + (2 v - 1)^2 */
            const double square[3] = {1, -1, 1};
            const double p[4] = {i / 2., j / 2., square[i] + square[j], 1};
            memcpy(points[i][j], p, sizeof p);
        }
    const bat_patch bowl = {BAT_SKIN, {2, 2}, 1, &points[0][0][0]};
    const bat_water low = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 0.36};
    const bat_water high = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 1.64};
    CHECK_OK(bat_find_kinks(&bowl, BATTEN_U, &low, kinks, &count));
    CHECK(count >= 4);
    CHECK_NEAR(kinks[1], 0.2, 1e-8);
    CHECK_NEAR(kinks[count - 2], 0.8, 1e-8);
    CHECK_OK(bat_sharpen_kinks(&bowl, BATTEN_U, &low, kinks, &count));
    CHECK_INT(count, 4); /* 0, the two turns, 1 */
    CHECK_NEAR(kinks[1], 0.2, 1e-15);
    CHECK_NEAR(kinks[2], 0.8, 1e-15);
    CHECK_OK(bat_find_kinks(&bowl, BATTEN_U, &high, kinks, &count));
    CHECK_INT(count, 6); /* 0.1 and 0.9 on both ends of the rows */
    CHECK_NEAR(kinks[1], 0.1, 1e-12);
    CHECK_NEAR(kinks[4], 0.9, 1e-12);
    CHECK_OK(bat_sharpen_kinks(&bowl, BATTEN_U, &high, kinks, &count));
    CHECK_INT(count, 4); /* each found on both ends of the rows */
    CHECK_NEAR(kinks[1], 0.1, 1e-15);
    CHECK_NEAR(kinks[2], 0.9, 1e-15);
    CHECK_NEAR(kinks[0] + kinks[3], 1, 0);
}
