/* How far waterlines reach. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

#include <batten/standard.h>

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

/* Whole edges lie in the water: those of the bottom, and those of the deck. */
TEST(the_waterline_of_a_box_at_its_bottom_and_its_deck_is_their_edge)
{
    batten_hull *hull = box_hull();
    for (int k = 0; k < 2; k++) {
        const batten_flotation at = {2 * k, 0, 0};
        batten_interval along, across;
        CHECK_OK(batten_hull_waterline(hull, &at, 1e-9, &along, &across));
        CHECK_NEAR(along.a, 0, 1e-9);
        CHECK_NEAR(along.b, 4, 1e-9);
        CHECK_NEAR(across.a, -1, 1e-9);
        CHECK_NEAR(across.b, 1, 1e-9);
    }
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

static void check_interval(batten_interval found, double middle, double half)
{
    CHECK_NEAR(found.a, middle - half, 2e-9);
    CHECK_NEAR(found.b, middle + half, 2e-9);
}

TEST(the_waterline_of_a_box_that_trims_and_heels_ends_at_its_corners)
{
    static const double turns[][2] = {{0.1, 0.2}, {-0.15, 0.3}, {0.2, -0.1}};
    batten_hull *hull = box_hull();
    for (int k = 0; k < 3; k++) {
        const double trim = turns[k][0], heel = turns[k][1];
        const oblique_box box = box_at(trim, heel);
        batten_interval along, across;
        CHECK_OK(batten_hull_waterline(hull, &box.at, 1e-9, &along, &across));
        check_interval(along, 2 * box.along.x + 0.9 * box.along.z, 2 / cos(trim));
        check_interval(across, 0.9 * box.across.z,
                       1 / cos(heel) + 2 * fabs(tan(trim) * tan(heel)));
    }
    batten_hull_free(hull);
}

/* A circle whose farthest points lie within patches. */
TEST(the_waterline_of_a_sphere_is_a_circle_at_any_trim_and_heel)
{
    batten_frame frame = batten_frame_world();
    frame.origin = (batten_vec3){1, 2, 3};
    const double trim = 0.3, heel = -0.4, size = 2;
    const double n[3] = {sin(trim), cos(trim) * sin(heel), cos(trim) * cos(heel)};
    const batten_flotation at = {3.5, trim, heel};
    const double below = n[2] * 3.5 - (n[0] + 2 * n[1] + 3 * n[2]);
    const double half = sqrt(size * size - below * below);
    batten_surface *ball = NULL;
    batten_hull *hull = NULL;
    batten_interval along, across;
    batten_hull_options options = batten_hull_defaults();
    options.whole = true;
    CHECK_OK(batten_surface_sphere(&frame, size, &ball));
    CHECK_OK(batten_hull_create(1, (const batten_surface *const[]){ball}, &options, &hull));
    CHECK_OK(batten_hull_waterline(hull, &at, 1e-9, &along, &across));
    check_interval(along, cos(trim) - 2 * sin(trim) * sin(heel) - 3 * sin(trim) * cos(heel),
                   half);
    check_interval(across, 2 * cos(heel) - 3 * sin(heel), half);
    batten_hull_free(hull);
    batten_surface_unref(ball);
}

TEST(without_a_tolerance_or_a_flotation_there_is_no_waterline)
{
    batten_hull *hull = box_hull();
    batten_interval along = {7, 8}, across = {9, 10};
    const batten_flotation at = {0.9, 0, 0}, lost = {0.9, 2, 0};
    const double tolerances[] = {0, -1, NAN, INFINITY};
    for (int k = 0; k < 4; k++)
        CHECK_STATUS(batten_hull_waterline(hull, &at, tolerances[k], &along, &across),
                     BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance of a waterline is inf; it must be above 0");
    CHECK_STATUS(batten_hull_waterline(hull, &lost, 1e-9, &along, &across),
                 BATTEN_BAD_ARGUMENT);
    CHECK_NEAR(along.a + along.b + across.a + across.b, 34, 0);
    batten_hull_free(hull);
}

/* y = 2 t - t^2, z = 2 t^2 from x = 0 to 4; the section in u or in v. */
static batten_hull *parabolic_hull(bool transposed)
{
    static const double section[3][2] = {{0, 0}, {1, 0}, {1, 2}}, ends[2] = {0, 4};
    static const double knots[2][6] = {{0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}};
    const batten_axis straight = {1, 2, knots[0], false}, bent = {2, 3, knots[1], false};
    double points[6][3];
    batten_surface *half = NULL;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 3; j++) {
            double *p = points[transposed ? 2 * j + i : 3 * i + j];
            p[0] = ends[i];
            p[1] = section[j][0];
            p[2] = section[j][1];
        }
    CHECK_OK(batten_surface_create(3, transposed ? &bent : &straight,
                                   transposed ? &straight : &bent, points[0], NULL, &half));
    return hull_of(half);
}

/* The water is h - 0.1 x high, and so widest at x = 0. */
TEST(waterlines_of_patches_whose_degrees_differ_end_at_their_sides)
{
    const double trim = atan(0.1);
    static const double heights[] = {0.5, 1.2, 1.9};
    for (int k = 0; k < 6; k++) {
        batten_hull *hull = parabolic_hull(k % 2);
        const double h = heights[k / 2], t = sqrt(h / 2), c = cos(trim), s = sin(trim);
        const batten_flotation at = {h, trim, 0};
        batten_interval along, across;
        CHECK_OK(batten_hull_waterline(hull, &at, 1e-9, &along, &across));
        CHECK_NEAR(along.b, 4 * c - (h - 0.4) * s, 2e-9);
        CHECK_NEAR(along.a, -h * s, 2e-9);
        CHECK_NEAR(across.b, 2 * t - t * t, 2e-9);
        CHECK_NEAR(across.a, -across.b, 2e-9);
        batten_hull_free(hull);
    }
}
