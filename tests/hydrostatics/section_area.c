/* Wet areas of cross sections, against closed forms. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

#include <batten/standard.h>

static const double PI = 3.14159265358979323846;

static double area_within(const batten_hull *hull, batten_flotation at, double x,
                          double precision)
{
    double area = NAN;
    CHECK_OK(batten_hull_section_area(hull, &at, x, precision, NULL, &area));
    return area;
}

static double area_at(const batten_hull *hull, batten_flotation at, double x)
{
    return area_within(hull, at, x, 1e-10);
}

static const double turns[][2] = {{0, 0}, {0.1, 0.2}, {-0.15, 0.3}, {0.2, -0.1}, {0, -0.25}};

TEST(sections_of_a_box_are_as_wide_as_it_and_as_high_as_the_water)
{
    batten_hull *hull = box_hull();
    for (int k = 0; k < 5; k++)
        for (int i = 0; i <= 8; i++) {
            const oblique_box box = box_at(turns[k][0], turns[k][1]);
            const double x = 0.5 * i, rise = tan(turns[k][0]) / cos(turns[k][1]);
            CHECK_NEAR(area_at(hull, box.at, x), 2 * (0.9 - (x - 2) * rise), 1e-10);
        }
    batten_hull_free(hull);
}

TEST(sections_of_a_box_beyond_its_deck_and_its_ends)
{
    batten_hull *hull = box_hull();
    CHECK_NEAR(area_at(hull, (batten_flotation){9, 0.1, 0.2}, 1.5), 4, 1e-10);
    CHECK_NEAR(area_at(hull, (batten_flotation){-1, 0, 0}, 1.5), 0, 0);
    CHECK_NEAR(area_at(hull, (batten_flotation){1, 0, 0}, 4.001), 0, 0);
    CHECK_NEAR(area_at(hull, (batten_flotation){1, 0, 0}, -0.001), 0, 0);
    /* on its side, with a draught that is that of z = 0 at y = 0: half of it is wet */
    CHECK_NEAR(area_at(hull, (batten_flotation){0, 0, 1.5707963267948966}, 3), 2, 1e-10);
    batten_hull_free(hull);
}

TEST(sections_of_wigleys_hull_are_parabolas)
{
    batten_hull *hull = wigley_hull();
    const double t = WIGLEY_DRAUGHT;
    for (int i = -9; i <= 9; i++)
        for (int k = 0; k <= 4; k++) {
            const double x = 0.5 * i, z = -0.25 * k * t; /* the water */
            const double waist =
                WIGLEY_BREADTH * (1 - 4 * x * x / WIGLEY_LENGTH / WIGLEY_LENGTH);
            const double height = t + z;
            const double wanted =
                waist * (height * height / t - height * height * height / (3 * t * t));
            CHECK_NEAR(area_at(hull, (batten_flotation){z, 0, 0}, x), wanted, 1e-11);
        }
    batten_hull_free(hull);
}

static batten_hull *whole_hull(batten_surface *surface)
{
    batten_hull *hull = NULL;
    batten_hull_options options = batten_hull_defaults();
    options.whole = true;
    CHECK_OK(batten_hull_create(1, (const batten_surface *const[]){surface}, &options, &hull));
    batten_surface_unref(surface);
    return hull;
}

/* A torus around the upright axis, of radii 3 and 1, and all of it under water: the plane x = 0 meets it in two
 * circles, x = 2 touches it from inside, and beyond there is one loop. */
static batten_hull *torus_hull(void)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *torus = NULL;
    CHECK_OK(batten_surface_torus(&frame, 3, 1, &torus));
    return whole_hull(torus);
}

/* By lines across at z = sin(angle); the rule is exact but for rounding, as the integrand is periodic. */
static double torus_section(double x)
{
    enum { STEPS = 400 };
    double sum = 0;
    for (int i = 0; i < STEPS; i++) {
        const double c = cos(2 * PI * i / STEPS);
        sum += (sqrt((3 + c) * (3 + c) - x * x) - sqrt((3 - c) * (3 - c) - x * x)) * c;
    }
    return sum * 2 * PI / STEPS;
}

TEST(sections_of_a_torus_in_two_loops_turn_inside_its_patches)
{
    batten_hull *hull = torus_hull();
    const batten_flotation at = {2, 0.1, 0.2};
    CHECK_NEAR(area_at(hull, at, 0), 2 * PI, 1e-9);
    for (int i = -3; i <= 3; i++)
        CHECK_NEAR(area_at(hull, at, 0.5 * i), torus_section(0.5 * i), 1e-9);
    /* half of it, upright */
    CHECK_NEAR(area_at(hull, (batten_flotation){0, 0, 0}, 1), torus_section(1) / 2, 1e-9);
    batten_hull_free(hull);
}

TEST(sections_of_a_torus_add_up_to_its_volume)
{
    batten_hull *hull = torus_hull();
    const batten_flotation at = {0.3, 0.2, -0.3};
    batten_hydrostatics v;
    double volume = 0;
    enum { STEPS = 60 };
    for (int part = -2; part < 2; part++)
        for (int i = 0; i < STEPS; i++) { /* places that crowd at -4, -2, 0, 2 and 4 */
            const double angle = PI / 2 * (i + 0.5) / STEPS, s = sin(angle);
            volume += area_within(hull, at, 2 * (part + s * s), 1e-7) * 2 * sin(2 * angle) *
                      PI / 2 / STEPS;
        }
    CHECK_OK(batten_hull_hydrostatics(hull, &at, 1e-9, NULL, &v));
    CHECK_NEAR(volume, v.volume, 2e-4 * v.volume);
    batten_hull_free(hull);
}

/* The plane x = 0 runs along lines of the parameters and through both poles. */
TEST(sections_of_a_ball_along_its_parameter_lines_are_segments_of_circles)
{
    static const double places[] = {0, 1e-12, 1e-9, 1e-6, 3e-6, 1e-4, 0.1, 0.9};
    const batten_frame frame = batten_frame_world();
    batten_surface *ball = NULL;
    CHECK_OK(batten_surface_sphere(&frame, 1, &ball));
    batten_hull *hull = whole_hull(ball);
    for (int i = 0; i < COUNT(places); i++)
        for (int k = -3; k <= 3; k++) {
            const double water = 0.25 * k, r = sqrt(1 - places[i] * places[i]);
            const double h = fabs(water) < r ? water : r * (water > 0 ? 1 : -1);
            const double wanted = r * r * (PI - acos(h / r)) + h * sqrt(r * r - h * h);
            for (int side = -1; side <= 1; side += 2)
                CHECK_NEAR(
                    area_within(hull, (batten_flotation){water, 0, 0}, side * places[i], 1e-8),
                    wanted, 1e-7);
        }
    batten_hull_free(hull);
}

TEST(sections_of_a_ball_at_any_trim_and_heel_are_segments_of_circles)
{
    const batten_frame frame = batten_frame_world();
    test_random random = test_random_begin(__func__);
    batten_surface *ball = NULL;
    CHECK_OK(batten_surface_sphere(&frame, 1, &ball));
    batten_hull *hull = whole_hull(ball);
    for (int i = 0; i < test_cases(60); i++) {
        const double x = test_random_in(&random, -0.95, 0.95), r = sqrt(1 - x * x);
        const double trim = test_random_in(&random, -0.6, 0.6);
        const double heel = test_random_in(&random, -1.2, 1.2);
        const double depth = test_random_in(&random, -0.9, 0.9);
        /* of the water in the plane of the section, above the middle of the circle */
        const double n = hypot(cos(trim) * sin(heel), cos(trim) * cos(heel));
        const double h = (depth - sin(trim) * x) / n, low = fmax(-r, fmin(r, h));
        const double wanted = r * r * (PI - acos(low / r)) + low * sqrt(r * r - low * low);
        const batten_flotation at = {depth / (cos(trim) * cos(heel)), trim, heel};
        CHECK_NEAR(area_within(hull, at, x, 1e-8), wanted, 1e-6);
    }
    batten_hull_free(hull);
}

TEST(sections_of_a_box_are_wet_by_hardly_any_water_and_nearly_all)
{
    batten_hull *hull = box_hull();
    for (int i = 1; i < 40; i++) { /* rows crowd at the ends: so do the draughts */
        const double s = sin(PI / 80 * i), draught = 2 * s * s;
        CHECK_NEAR(area_at(hull, (batten_flotation){draught, 0, 0}, 1.3), 2 * draught, 1e-9);
    }
    batten_hull_free(hull);
}

/* Half of an ellipse lies below any line through its middle. */
TEST(sections_of_an_ellipsoid_through_its_middle_are_halves_of_ellipses_at_any_heel)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *egg = NULL;
    CHECK_OK(batten_surface_ellipsoid(&frame, 1, 2, 5, &egg));
    batten_hull *hull = whole_hull(egg);
    for (int k = -4; k <= 4; k++)
        CHECK_NEAR(area_within(hull, (batten_flotation){0, 0.1 * k, 0.3 * k}, 0, 1e-8), 5 * PI,
                   1e-5);
    batten_hull_free(hull);
}

TEST(sections_without_a_place_or_a_precision_are_refused)
{
    batten_hull *hull = box_hull();
    const batten_flotation at = {0.9, 0, 0}, lost = {0.9, 2, 0};
    double area = 7;
    CHECK_STATUS(batten_hull_section_area(hull, &at, NAN, 1e-9, NULL, &area),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the place of a section is not finite");
    CHECK_STATUS(batten_hull_section_area(hull, &at, 1, 0.2, NULL, &area), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the precision of a section is 0.2; it must be 1e-10 to 0.1");
    CHECK_STATUS(batten_hull_section_area(hull, &lost, 1, 1e-9, NULL, &area),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a trim of 114.592");
    CHECK_NEAR(area, 7, 0);
    batten_hull_free(hull);
}
