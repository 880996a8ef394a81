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
    CHECK_MESSAGE("the hull is to displace 16 but has only 16: it sinks");
    loading = (batten_loading){7.2, {2, 0, 3}, false, false};
    CHECK_STATUS(batten_hull_balance(hull, &loading, &start, 1e-9, NULL, &b), BATTEN_NOT_FOUND);
    CHECK_MESSAGE("capsizes");
    /* the righting arm is negative at every heel: 16 steps of 5 degrees across, from 1.1 */
    loading.fixed_trim = true;
    CHECK_STATUS(
        batten_hull_balance(hull, &loading, &(batten_flotation){1, 0.05, 0.02}, 1e-9, NULL, &b),
        BATTEN_NOT_FOUND);
    CHECK_MESSAGE("up to a trim of 2.86 and a heel of 81.2 degrees: the hull capsizes");
    loading.volume = -1;
    CHECK_STATUS(batten_hull_balance(hull, &loading, &start, 1e-9, NULL, &b),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a hull is to displace -1; it must be above 0");
    for (int c = 0; c < 3; c++) {
        loading = (batten_loading){
            7.2, {c == 0 ? NAN : 2, c == 1 ? INFINITY : 0, c == 2 ? NAN : 3}, false, false};
        CHECK_STATUS(batten_hull_balance(hull, &loading, &start, 1e-9, NULL, &b),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("not finite");
    }
    loading = (batten_loading){7.2, {2, 0, 0.5}, false, false};
    CHECK_STATUS(batten_hull_balance(hull, &loading, &start, 0, NULL, &b), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the precision is 0");
    CHECK_STATUS(
        batten_hull_balance(hull, &loading, &(batten_flotation){1, 2, 0}, 1e-9, NULL, &b),
        BATTEN_BAD_ARGUMENT);
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

static batten_vec3 moved(batten_vec3 p, double t, batten_vec3 direction)
{
    return (batten_vec3){p.x + t * direction.x, p.y + t * direction.y, p.z + t * direction.z};
}

static void check_rest(const batten_balance *b, const oblique_box *box, double above)
{
    CHECK_NEAR(b->values.volume, 7.2, 1e-10);
    CHECK_NEAR(b->flotation.draught, box->at.draught, 1e-9);
    CHECK_NEAR(b->flotation.trim, box->at.trim, 1e-9);
    CHECK_NEAR(b->flotation.heel, box->at.heel, 1e-9);
    CHECK_NEAR(b->values.buoyancy.x, box->buoyancy.x, 1e-9);
    CHECK_NEAR(b->values.buoyancy.y, box->buoyancy.y, 1e-9);
    CHECK_NEAR(b->metacentric[0], box->second[2] / 7.2 - above, 1e-8);
    CHECK_NEAR(b->metacentric[1], box->second[0] / 7.2 - above, 1e-8);
}

/* The mass is plumb above the centre of buoyancy, or off it along and across where the hull is
 * held: by 0.03 and 0.02. */
TEST(a_box_comes_to_rest_where_its_closed_form_says_and_what_is_fixed_stays)
{
    static const double turns[][2] = {{0.1, 0.2}, {-0.15, 0.3}, {0.2, -0.1}};
    const double above = 0.1;
    batten_hull *hull = box_hull();
    for (int k = 0; k < 12; k++) {
        const bool heels = !(k & 1), trims = !(k & 2);
        const oblique_box box = box_at(turns[k / 4][0], turns[k / 4][1]);
        const double along = trims ? 0 : 0.03, across = heels ? 0 : 0.02;
        const batten_vec3 plumb = moved(box.buoyancy, above, box.n);
        const batten_loading loading = {
            7.2, moved(moved(plumb, along, box.along), across, box.across), !heels, !trims};
        const batten_flotation start = {0.4, trims ? 0 : box.at.trim, heels ? 0 : box.at.heel};
        batten_balance b;
        CHECK_OK(batten_hull_balance(hull, &loading, &start, 1e-12, NULL, &b));
        check_rest(&b, &box, above);
        CHECK_NEAR(b.trimming, -along, 1e-10);
        CHECK_NEAR(b.heeling, across, 1e-10);
        CHECK(b.stable);
    }
    batten_hull_free(hull);
}

/* Transverse GM is 0.1 below or above 0, longitudinal at first far above. */
TEST(stable_means_that_the_free_angles_are)
{
    static const struct {
        double above; /* the centre of mass above that of buoyancy, over BM */
        bool fixed_heel, fixed_trim, stable;
    } rows[] = {{0.9, false, false, true}, {1.1, false, false, false},
                {1.1, true, false, true},  {1.1, false, true, false},
                {1.1, true, true, true},   {4.5, true, false, false},
                {4.5, true, true, true},   {4.5, false, false, false}};
    const double bm = 4 / (12 * 0.9);
    batten_hull *hull = box_hull();
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const batten_loading loading = {
            7.2, {2, 0, 0.45 + rows[k].above * bm}, rows[k].fixed_heel, rows[k].fixed_trim};
        batten_balance b;
        CHECK_OK(batten_hull_balance(hull, &loading, &(batten_flotation){0.9, 0, 0}, 1e-12,
                                     NULL, &b));
        CHECK_INT(b.stable, rows[k].stable);
        CHECK_NEAR(b.metacentric[0], bm * (1 - rows[k].above), 1e-11);
        CHECK_NEAR(b.metacentric[1], bm * (4 - rows[k].above), 1e-11);
    }
    batten_hull_free(hull);
}

/* Trimmed and heeled, the turns are coupled: up to the smaller eigenvalue of the second moments over the volume the mass
 * may stand above the centre of buoyancy. */
TEST(a_box_that_trims_and_heels_is_stable_up_to_the_smaller_eigenvalue_of_its_waterplane)
{
    static const double turns[][2] = {{0.1, 0.2}, {-0.15, 0.3}, {0.2, -0.1}};
    const double volume = 7.2;
    batten_hull *hull = box_hull();
    for (int k = 0; k < 6; k++) {
        const oblique_box box = box_at(turns[k / 2][0], turns[k / 2][1]);
        const double along = box.second[0] / volume, mixed = box.second[1] / volume,
                     across = box.second[2] / volume;
        const double least = (along + across - hypot(along - across, 2 * mixed)) / 2;
        const double above = least * (1 + (k % 2 ? 1e-6 : -1e-6));
        const batten_vec3 plumb = moved(box.buoyancy, above, box.n);
        const batten_loading loading = {volume, plumb, false, false};
        batten_balance b;
        CHECK_OK(batten_hull_balance(hull, &loading, &box.at, 1e-12, NULL, &b));
        CHECK_INT(b.stable, k % 2 == 0);
        CHECK_NEAR(b.flotation.trim, box.at.trim, 1e-9);
        CHECK_NEAR(b.flotation.heel, box.at.heel, 1e-9);
    }
    batten_hull_free(hull);
}

TEST(a_box_with_hardly_any_load_and_one_with_nearly_all_find_their_draughts)
{
    static const double volumes[] = {1e-6, 0.08, 15.9, 15.999};
    batten_hull *hull = box_hull();
    for (int k = 0; k < 4; k++) {
        const batten_loading loading = {volumes[k], {2, 0, 0}, true, true};
        batten_balance b;
        CHECK_OK(batten_hull_balance(hull, &loading, &(batten_flotation){100, 0, 0}, 1e-12,
                                     NULL, &b));
        CHECK_NEAR(b.flotation.draught, volumes[k] / 8, 1e-12);
    }
    batten_hull_free(hull);
}
