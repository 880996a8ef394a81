/* Which surfaces are one half of a hull, and which the images of it. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

static batten_status make(int count, batten_surface *const *surfaces, batten_hull **hull)
{
    return batten_hull_create(count, (const batten_surface *const *)surfaces, NULL, hull);
}

static double volume_of(int count, batten_surface *const *surfaces)
{
    const batten_flotation at = {1, 0, 0};
    batten_hydrostatics v;
    batten_hull *hull = NULL;
    CHECK_OK(make(count, surfaces, &hull));
    CHECK_OK(batten_hull_hydrostatics(hull, &at, 1e-12, NULL, &v));
    batten_hull_free(hull);
    return v.volume;
}

TEST(one_half_or_both_displace_the_same)
{
    static const double section[][2] = {{0, 0}, {1, 0}, {1, 2}};
    static const double image[][2] = {{-1, 2}, {-1, 0}, {0, 0}};
    batten_surface *both[2] = {half_prism(0, 4, 3, section), half_prism(0, 4, 3, image)};
    CHECK_NEAR(volume_of(1, both), 8, 1e-12);
    CHECK_NEAR(volume_of(1, both + 1), 8, 1e-12); /* the starboard half alone */
    CHECK_NEAR(volume_of(2, both), 8, 1e-12);
    batten_surface_unref(both[0]);
    batten_surface_unref(both[1]);
}

TEST(surfaces_of_the_other_side_that_are_no_images_are_refused_by_number)
{
    static const double section[][2] = {{0, 0}, {1, 0}, {1, 2}};
    static const double other[][2] = {{-1.1, 2}, {-1, 0}, {0, 0}};
    static const double across[][2] = {{-1, 2}, {0, 0}, {1, 2}};
    batten_surface *parts[3] = {half_prism(0, 4, 3, section), half_prism(0, 4, 3, other),
                                half_prism(0, 4, 3, across)};
    batten_hull *hull = NULL;
    CHECK_STATUS(make(2, parts, &hull), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("surface 2 of the hull, to y = -1.1, is no image");
    CHECK_STATUS(make(1, parts + 2, &hull), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("across the centre plane");
    CHECK(!hull);
    for (int i = 0; i < 3; i++)
        batten_surface_unref(parts[i]);
}

static batten_status make_box(double across, double beyond)
{
    const double own[][2] = {{-across, 0}, {1, 0}, {1, 2}};
    const double image[][2] = {{-1 - beyond, 2}, {-1 - beyond, 0}, {across, 0}};
    batten_surface *both[2] = {half_prism(0, 4, 3, own), half_prism(0, 4, 3, image)};
    batten_hull *hull = NULL;
    const batten_status status = make(2, both, &hull);
    batten_hull_free(hull);
    batten_surface_unref(both[0]);
    batten_surface_unref(both[1]);
    return status;
}

/* Of a size of 4: 1e-4 of it across the plane, 1e-6 off the image. */
TEST(sides_may_cross_the_plane_and_images_be_off_by_a_part_of_the_size)
{
    CHECK_OK(make_box(3.9e-4, 0));
    CHECK_STATUS(make_box(4.1e-4, 0), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE(
        "surface 1 of the hull reaches from y = -0.00041 to 1, across the centre plane");
    CHECK_OK(make_box(0, 3.9e-6));
    CHECK_STATUS(make_box(0, 4.2e-6), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("surface 2 of the hull, to y = -1, is no image of one on the other side");
}
