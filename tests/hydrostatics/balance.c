/* Hulls at rest. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

static const double DEGREE = 3.14159265358979323846 / 180;

/* Of a box without flare, until its deck or its bottom meets the water. */
TEST(a_box_rights_itself_by_the_wall_sided_formula)
{
    const double draught = 0.9, kg = 0.8, bm = 2 * 2 / (12 * draught);
    const double gm = draught / 2 + bm - kg;
    batten_hull *hull = box_hull();
    for (int degrees = 0; degrees <= 40; degrees += 10) {
        const double phi = degrees * DEGREE, t = tan(phi);
        const batten_loading loading = {8 * draught, {2, 0, kg}, true, false};
        const batten_flotation start = {0.5, 0.01, phi};
        batten_balance b;
        CHECK_OK(batten_hull_balance(hull, &loading, &start, 1e-12, NULL, &b));
        CHECK_NEAR(b.values.volume, 8 * draught, 1e-11);
        CHECK_NEAR(b.flotation.trim, 0, 1e-11);
        CHECK_NEAR(b.heeling, sin(phi) * (gm + bm / 2 * t * t), 1e-11);
    }
    batten_hull_free(hull);
}

TEST(a_box_with_its_mass_off_the_middle_heels_and_trims_towards_it)
{
    batten_hull *hull = box_hull();
    const batten_loading loading = {7.2, {2.1, -0.02, 0.5}, false, false};
    const batten_flotation start = {0.9, 0, 0};
    batten_balance b;
    CHECK_OK(batten_hull_balance(hull, &loading, &start, 1e-12, NULL, &b));
    CHECK(b.stable);
    CHECK(b.flotation.heel > 0 && b.flotation.trim < 0);
    CHECK_NEAR(b.heeling, 0, 1e-11);
    CHECK_NEAR(b.trimming, 0, 1e-11);
    CHECK_NEAR(b.values.volume, 7.2, 1e-11);
    batten_hull_free(hull);
}

TEST(a_box_that_is_not_stable_upright_comes_to_rest_at_its_angle_of_loll)
{
    const double draught = 0.9, bm = 2 * 2 / (12 * draught), kg = draught / 2 + bm + 0.01;
    const double loll = atan(sqrt(2 * 0.01 / bm)); /* where GM + BM / 2 tan^2 is 0 */
    batten_hull *hull = box_hull();
    const batten_loading loading = {8 * draught, {2, 0, kg}, false, false};
    batten_flotation start = {draught, 0, 0};
    batten_balance b;
    CHECK_OK(batten_hull_balance(hull, &loading, &start, 1e-12, NULL, &b));
    CHECK(!b.stable);
    CHECK_NEAR(b.metacentric[0], -0.01, 1e-11);
    start.heel = 0.01;
    CHECK_OK(batten_hull_balance(hull, &loading, &start, 1e-12, NULL, &b));
    CHECK(b.stable);
    CHECK_NEAR(b.flotation.heel, loll, 1e-9);
    batten_hull_free(hull);
}

TEST(what_sinks_or_capsizes_is_said)
{
    batten_hull *hull = box_hull();
    const batten_flotation start = {1, 0, 0.02};
    batten_loading loading = {16, {2, 0, 0.5}, false, false};
    batten_balance b;
    CHECK_STATUS(batten_hull_balance(hull, &loading, &start, 1e-9, NULL, &b),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("has only 16: it sinks");
    loading = (batten_loading){7.2, {2, 0, 3}, false, false};
    CHECK_STATUS(batten_hull_balance(hull, &loading, &start, 1e-9, NULL, &b), BATTEN_NOT_FOUND);
    CHECK_MESSAGE("capsizes");
    loading.volume = -1;
    CHECK_STATUS(batten_hull_balance(hull, &loading, &start, 1e-9, NULL, &b),
                 BATTEN_BAD_ARGUMENT);
    loading = (batten_loading){7.2, {2, NAN, 3}, false, false};
    CHECK_STATUS(batten_hull_balance(hull, &loading, &start, 1e-9, NULL, &b),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("not finite");
    batten_hull_free(hull);
}

/* The righting arm's slope at 0 is the metacentric height, and the volume grows by the
 * waterplane. */
TEST(derivatives_are_those_of_what_they_are_said_to_be)
{
    batten_hull *hull = wigley_hull();
    const batten_loading loading = {2.5, {0, 0, -0.3}, true, true};
    batten_flotation at = {0, 0, 1e-5};
    batten_balance b, upright;
    CHECK_OK(batten_hull_balance(hull, &loading, &at, 1e-13, NULL, &b));
    at.heel = 0;
    CHECK_OK(batten_hull_balance(hull, &loading, &at, 1e-13, NULL, &upright));
    CHECK_NEAR(b.heeling / 1e-5, upright.metacentric[0], 1e-8);
    batten_hydrostatics low, high;
    at = (batten_flotation){-0.1 - 1e-5, 0.02, 0.3};
    CHECK_OK(batten_hull_hydrostatics(hull, &at, 1e-13, NULL, &low));
    at.draught += 2e-5;
    CHECK_OK(batten_hull_hydrostatics(hull, &at, 1e-13, NULL, &high));
    const double rise = 2e-5 * cos(0.02) * cos(0.3);
    CHECK_NEAR((high.volume - low.volume) / rise, (high.waterplane + low.waterplane) / 2, 1e-6);
    batten_hull_free(hull);
}
