/* Hulls in the water, against closed forms. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

static const double DEGREE = 3.14159265358979323846 / 180;

TEST(a_box_floats_as_a_box_at_any_heel)
{
    for (int degrees = 0; degrees <= 40; degrees += 10) {
        batten_hull *hull = box_hull();
        batten_hydrostatics v;
        const double t = tan(degrees * DEGREE), c = cos(degrees * DEGREE);
        /* the water stays between the bottom and the deck up to 41 degrees */
        const batten_flotation at = {0.9, 0, degrees * DEGREE};
        CHECK_OK(batten_hull_hydrostatics(hull, &at, 1e-12, NULL, &v));
        CHECK_NEAR(v.volume, 7.2, 1e-13);
        CHECK_NEAR(v.buoyancy.x, 2, 1e-13);
        CHECK_NEAR(v.buoyancy.y, -t / (3 * 0.9), 1e-13);
        CHECK_NEAR(v.buoyancy.z, 0.45 + t * t / (6 * 0.9), 1e-13);
        CHECK_NEAR(v.waterplane, 8 / c, 1e-12);
        CHECK_NEAR(v.flotation.x, 2, 1e-13);
        CHECK_NEAR(v.flotation.y, 0, 1e-13);
        CHECK_NEAR(v.across, 4 * 8 / (12 * c * c * c), 1e-12);
        CHECK_NEAR(v.along, 64 * 2 / (12 * c), 1e-11);
        CHECK_NEAR(v.mixed, 0, 1e-12);
        CHECK_NEAR(v.wetted, 4 * 2 * (1 + 0.9), 1e-12);
        CHECK_NEAR(v.open[0] + v.open[1], 0, 1e-12);
        batten_hull_free(hull);
    }
}

TEST(a_hull_of_wigley_has_its_closed_form)
{
    batten_hull *hull = wigley_hull();
    batten_hydrostatics v;
    const double l = WIGLEY_LENGTH, b = WIGLEY_BREADTH, t = WIGLEY_DRAUGHT;
    const batten_flotation at = {0, 0, 0};
    CHECK_OK(batten_hull_hydrostatics(hull, &at, 1e-12, NULL, &v));
    CHECK_NEAR(v.volume, l * b * t * 4 / 9, 1e-13);
    CHECK_NEAR(v.buoyancy.z, -t * 3 / 8, 1e-13);
    CHECK_NEAR(v.waterplane, l * b * 2 / 3, 1e-12);
    CHECK_NEAR(v.across, b * b * b * l * 4 / 105, 1e-12);
    CHECK_NEAR(v.along, b * l * l * l / 30, 1e-10);
    CHECK_NEAR(v.lids, 0, 1e-12);
    batten_hull_free(hull);
}
