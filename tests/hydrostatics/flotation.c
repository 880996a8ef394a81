/* Hulls in the water, against closed forms. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

#include <batten/standard.h>

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

static void check_error(double value, double exact, double said, double precision)
{
    CHECK(said > 0 && said <= 100 * precision);
    CHECK(fabs(value - exact) <= said * exact + 1e-13);
}

/* A ball and its segments: the errors that are said are neither 0 nor less than those that were made. */
TEST(what_is_said_of_errors_holds_and_falls_with_the_precision)
{
    const batten_frame frame = batten_frame_world();
    const double pi = 180 * DEGREE;
    batten_surface *ball = NULL;
    batten_hull *hull = NULL;
    batten_hull_options options = batten_hull_defaults();
    options.whole = true;
    CHECK_OK(batten_surface_sphere(&frame, 1, &ball));
    CHECK_OK(batten_hull_create(1, (const batten_surface *const[]){ball}, &options, &hull));
    batten_surface_unref(ball);
    for (int k = -1; k <= 1; k++)
        for (double precision = 1e-3; precision > 1e-9; precision /= 100) {
            const double h = 0.4 * k; /* of the water above the middle */
            batten_hydrostatics v;
            CHECK_OK(batten_hull_hydrostatics(
                hull, &(batten_flotation){h / (cos(0.1) * cos(0.3)), 0.1, 0.3}, precision, NULL,
                &v));
            check_error(v.volume, pi / 3 * (h + 1) * (h + 1) * (2 - h), v.volume_error,
                        precision);
            check_error(v.waterplane, pi * (1 - h * h), v.area_error, precision);
            check_error(v.wetted, 2 * pi * (h + 1), v.wetted_error, precision);
        }
    batten_hull_free(hull);
}

static void check_place(batten_vec3 place, double x, double y, double z)
{
    CHECK_NEAR(place.x, x, 1e-12);
    CHECK_NEAR(place.y, y, 1e-12);
    CHECK_NEAR(place.z, z, 1e-12);
}

static const double turns[][2] = {{0.1, 0.2}, {-0.15, 0.3}, {0.2, -0.1}, {-0.1, -0.25}};

TEST(a_box_that_trims_and_heels_has_its_closed_form)
{
    batten_hull *hull = box_hull();
    for (int k = 0; k < 4; k++) {
        const oblique_box box = box_at(turns[k][0], turns[k][1]);
        batten_hydrostatics v;
        CHECK_OK(batten_hull_hydrostatics(hull, &box.at, 1e-12, NULL, &v));
        CHECK_NEAR(v.volume, 7.2, 1e-12);
        check_place(v.buoyancy, box.buoyancy.x, box.buoyancy.y, box.buoyancy.z);
        CHECK_NEAR(v.waterplane, box.waterplane, 1e-11);
        check_place(v.flotation, 2, 0, 0.9);
        CHECK_NEAR(v.along, box.second[0], 1e-10);
        CHECK_NEAR(v.mixed, box.second[1], 1e-10);
        CHECK_NEAR(v.across, box.second[2], 1e-10);
        CHECK_NEAR(v.wetted, 15.2, 1e-11);
        CHECK_NEAR(v.lids, 3.6, 1e-11); /* both ends */
        CHECK_NEAR(v.open[0], 0, 1e-12);
        CHECK_NEAR(v.open[1], 0, 1e-12);
        CHECK(v.volume_error <= 1e-10 && v.area_error <= 1e-10 && v.wetted_error <= 1e-10);
    }
    batten_hull_free(hull);
}

TEST(all_is_0_above_the_water_and_nothing_is_left_out_below_it)
{
    batten_hull *hull = box_hull();
    batten_hydrostatics v;
    CHECK_OK(batten_hull_hydrostatics(hull, &(batten_flotation){-1, 0, 0}, 1e-9, NULL, &v));
    check_place(v.buoyancy, 0, 0, 0);
    check_place(v.flotation, 0, 0, 0);
    CHECK_NEAR(v.volume + v.waterplane + v.wetted + v.lids, 0, 0);
    CHECK_NEAR(v.volume_error + v.area_error + v.wetted_error, 0, 0);
    CHECK_OK(batten_hull_hydrostatics(hull, &(batten_flotation){9, 0.2, -2}, 1e-9, NULL, &v));
    CHECK_NEAR(v.volume, 0, 0); /* heeled beyond 90 degrees the hull is above its water */
    CHECK_OK(batten_hull_hydrostatics(hull, &(batten_flotation){9, 0.2, 0.4}, 1e-9, NULL, &v));
    CHECK_NEAR(v.volume, 16, 1e-9);
    check_place(v.buoyancy, 2, 0, 1);
    CHECK_NEAR(v.waterplane, 0, 1e-12);
    CHECK_NEAR(v.wetted, 24, 1e-9);
    CHECK_NEAR(v.lids, 16, 1e-9); /* the ends and the deck */
    batten_hull_free(hull);
}

static const struct {
    batten_flotation at;
    double precision;
    const char *message;
} refused[] = {
    {{NAN, 0, 0}, 1e-9, "the draught is not finite"},
    {{INFINITY, 0, 0}, 1e-9, "the draught is not finite"},
    {{0, 0.5 * 3.14159265358979323846, 0},
     1e-9,
     "a trim of 90 and a heel of 0 degrees; they must be below 90 and 180"},
    {{0, -0.1, -3.14159265358979323846}, 1e-9, "a trim of -5.72958 and a heel of -180 degrees"},
    {{0, NAN, 0}, 1e-9, "a trim of nan"},
    {{0, 0, NAN}, 1e-9, "a heel of nan"},
    {{0, 0, 0}, 0.11, "the precision is 0.11; it must be 1e-14 to 0.1"},
    {{0, 0, 0}, 0.9e-14, "the precision is 9e-15"},
    {{0, 0, 0}, NAN, "the precision is nan"},
};

TEST(flotations_and_precisions_out_of_bounds_are_refused_with_their_numbers)
{
    batten_hull *hull = box_hull();
    batten_hydrostatics v = {.volume = 42};
    for (size_t k = 0; k < sizeof refused / sizeof *refused; k++) {
        CHECK_STATUS(
            batten_hull_hydrostatics(hull, &refused[k].at, refused[k].precision, NULL, &v),
            BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(refused[k].message);
    }
    CHECK_NEAR(v.volume, 42, 0);
    const batten_flotation far = {0.9, 1.57, -3.14};
    CHECK_OK(batten_hull_hydrostatics(hull, &far, 0.1, NULL, &v));
    CHECK_OK(batten_hull_hydrostatics(hull, &(batten_flotation){0.9, 0, 0}, 1e-14, NULL, &v));
    CHECK_NEAR(v.volume, 7.2, 1e-13);
    batten_hull_free(hull);
}
