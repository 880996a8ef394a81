#include "shape/sections.h"

#include "shape/skin/common_knots.h"
#include "shape/skin/sections.h"

#include <batten/standard.h>

/* The farthest that a line of the surface is from its section, at the same parameters. */
static double measured(int count, batten_curve **sections, const double *v,
                       const batten_surface *surface)
{
    double worst = 0;
    for (int k = 0; k < count; k++)
        for (int i = 0; i <= 500; i++) {
            double given[3], found[3];
            CHECK_OK(batten_curve_evaluate(sections[k], i / 500.0, 0, given));
            CHECK_OK(batten_surface_evaluate(surface, i / 500.0, v[k], 0, found));
            worst = fmax(worst, hypot(hypot(given[0] - found[0], given[1] - found[1]),
                                      given[2] - found[2]));
        }
    return worst;
}

static batten_surface_skin_report check_family(int count, int points, double tolerance,
                                               double length,
                                               void (*at)(double, double, double *))
{
    test_random random = test_random_begin("family");
    batten_curve *sections[64];
    double v[64];
    for (int k = 0; k < count; k++)
        sections[k] = jittered(&random, points, length * k / (count - 1), at);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.tolerance = tolerance;
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    CHECK_OK(
        batten_surface_skin((batten_curve_row){count, (const batten_curve *const *)sections},
                            &options, NULL, v, &report, &surface));
    CHECK(report.error <= tolerance);
    const double worst = measured(count, sections, v, surface);
    CHECK(worst <= report.error * (1 + 1e-9));
    CHECK(report.error < 3 * worst);
    CHECK_INT(batten_surface_spans(surface, BATTEN_U, NULL) - 2, report.knot_count);
    CHECK_INT(report.exact_knot_count, count * (points - 4));
    batten_surface_unref(surface);
    unref_all(count, sections);
    return report;
}

TEST(K7_thirty_profiles_with_twenty_knots_each_share_few)
{
    const int count = test_cases(30) < 30 ? 4 : 30;
    const batten_surface_skin_report loose = check_family(count, 24, 1e-3, 3, airfoil);
    const batten_surface_skin_report fine = check_family(count, 24, 1e-4, 3, airfoil);
    CHECK(loose.knot_count <= 20);
    CHECK(fine.knot_count <= 30);
    CHECK(fine.span_ratio > 0.1);
}

TEST(K7_the_frames_of_a_ship_share_few_knots_at_half_a_millimetre)
{
    const int count = test_cases(41) < 41 ? 4 : 41;
    const batten_surface_skin_report report = check_family(count, 19, 0.5e-3, 1, hull);
    CHECK(report.knot_count <= 30);
}

static batten_status polyline_section(double x, double corner, batten_curve **out)
{
    const double points[] = {x, 0, 0, x, 1, 0.2, x, 1, 2};
    const double knots[] = {0, 0, corner, 1, 1};
    return batten_curve_create((batten_points){3, 3, points}, 1, NULL, knots, out);
}

TEST(corners_stay_where_they_are)
{
    batten_curve *sections[3] = {NULL, NULL, NULL};
    for (int k = 0; k < 3; k++)
        CHECK_OK(polyline_section(k, 0.5, &sections[k]));
    test_random random = test_random_begin("corner");
    batten_curve *smooth = jittered(&random, 20, 0.5, hull), *all[4];
    memcpy(all, sections, sizeof sections);
    all[3] = smooth;
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.tolerance = 1e-3;
    options.degree = 1;
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){4, (const batten_curve *const *)all},
                                 &options, NULL, NULL, &report, &surface));
    CHECK(report.error <= 1e-3 && report.knot_count < report.exact_knot_count);
    CHECK_NEAR(report.normal_jump, acos(0) - atan(0.2), 0.02);
    double out[3];
    CHECK_OK(batten_surface_evaluate(surface, 0.5, 0, 0, out));
    CHECK_NEAR(out[1], 1, 1e-3);
    CHECK_NEAR(out[2], 0.2, 1e-3);
    batten_surface_unref(surface);
    unref_all(4, all);
}

TEST(when_corners_need_as_many_knots_as_the_union_the_skin_is_exact)
{
    batten_curve *sections[3] = {NULL, NULL, NULL};
    for (int k = 0; k < 3; k++)
        CHECK_OK(polyline_section(k, 0.3 + 0.2 * k, &sections[k]));
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.tolerance = 1e-3;
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){3, (const batten_curve *const *)sections},
                                 &options, NULL, NULL, &report, &surface));
    CHECK(report.error < 1e-14 && report.knot_count == 3 && report.exact_knot_count == 3);
    batten_surface_unref(surface);
    unref_all(3, sections);
}

TEST(rational_sections_keep_the_tolerance_too)
{
    batten_curve *sections[4] = {NULL, NULL, NULL, NULL};
    test_random random = test_random_begin("rational");
    for (int k = 0; k < 4; k++) {
        batten_curve *arc = NULL, *space = NULL;
        CHECK_OK(batten_curve_arc(2 + 0.1 * k, 2, &arc));
        CHECK_OK(batten_curve_to_dimension(arc, 3, &space));
        const batten_affine map = batten_affine_translation(100, 0, k);
        CHECK_OK(batten_curve_transform(space, &map, &sections[k]));
        for (int i = 0; i < 6; i++) {
            batten_curve *refined = NULL;
            CHECK_OK(batten_curve_insert_knot(sections[k], test_random_in(&random, 0.05, 0.95),
                                              1, &refined));
            batten_curve_unref(sections[k]);
            sections[k] = refined;
        }
        batten_curve_unref(space);
        batten_curve_unref(arc);
    }
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.tolerance = 1e-4;
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    double v[4];
    CHECK_OK(batten_surface_skin((batten_curve_row){4, (const batten_curve *const *)sections},
                                 &options, NULL, v, &report, &surface));
    CHECK(batten_surface_is_rational(surface));
    CHECK(report.error <= 1e-4 && report.knot_count < 12 && report.exact_knot_count == 25);
    CHECK(measured(4, sections, v, surface) <= report.error * (1 + 1e-9) + 1e-12);
    batten_surface_unref(surface);
    unref_all(4, sections);
}

TEST(N6_tolerances_are_checked)
{
    test_random random = test_random_begin("tolerance");
    batten_curve *sections[2] = {jittered(&random, 10, 0, airfoil),
                                 jittered(&random, 10, 1, airfoil)};
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface *surface = NULL;
    options.tolerance = 1e-15;
    CHECK_STATUS(
        batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)sections},
                            &options, NULL, NULL, NULL, &surface),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance 1e-15 is lost in the rounding of coordinates of 1");
    options.tolerance = -1;
    CHECK_STATUS(
        batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)sections},
                            &options, NULL, NULL, NULL, &surface),
        BATTEN_BAD_ARGUMENT);
    options.tolerance = NAN;
    CHECK_STATUS(
        batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)sections},
                            &options, NULL, NULL, NULL, &surface),
        BATTEN_NOT_FINITE);
    CHECK(surface == NULL);
    /* Larger than the sections: no knots are left. */
    options.tolerance = 100;
    batten_surface_skin_report report;
    CHECK_OK(batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)sections},
                                 &options, NULL, NULL, &report, &surface));
    CHECK_INT(report.knot_count, 0);
    CHECK(report.error > 0 && report.span_ratio == 1);
    batten_surface_unref(surface);
    unref_all(2, sections);
}

/* Two cubic pieces that meet with one tangent but with speeds `ratio` apart, at a place of its
 * own. */
static batten_curve *uneven_section(double x, double place, double ratio)
{
    const double points[] = {
        x, 0, 0,   x, 0.5, 0, x, 0.8, 0.1, x, 1, 0.3, x, 1 + 0.2 * ratio, 0.3 + 0.2 * ratio,
        x, 2, 1.5, x, 2,   2};
    const double knots[] = {0, 0, 0, 0, place, place, place, 1, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 7, points}, 3, NULL, knots, &curve));
    return curve;
}

TEST(speeds_are_made_even_without_moving_a_point)
{
    for (int c = 0; c < 5; c++) {
        batten_curve *uneven = uneven_section(0, 0.3 + 0.1 * c, 0.5 + c * 0.4), *even = NULL;
        CHECK_OK(bat_skin_even_speed(uneven, &even));
        double knots[3], left[6], right[6];
        CHECK_INT(batten_curve_spans(even, knots), 3);
        CHECK(knots[0] == 0 && knots[2] == 1);
        CHECK_OK(batten_curve_evaluate_side(even, knots[1], BATTEN_FROM_LEFT, 1, left));
        CHECK_OK(batten_curve_evaluate_side(even, knots[1], BATTEN_FROM_RIGHT, 1, right));
        for (int k = 0; k < 6; k++)
            CHECK_NEAR(left[k], right[k], 1e-13);
        for (int i = 0; i < 21; i++)
            CHECK_BITS(batten_curve_points(even)[i], batten_curve_points(uneven)[i]);
        batten_curve_unref(even);
        batten_curve_unref(uneven);
    }
}

TEST(sections_of_uneven_speed_make_a_surface_without_a_crease)
{
    batten_curve *sections[6];
    for (int k = 0; k < 6; k++)
        sections[k] = uneven_section(k, 0.3 + 0.07 * k, 0.5 + 0.3 * k);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface_skin_report exact, few;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){6, (const batten_curve *const *)sections},
                                 &options, NULL, NULL, &exact, &surface));
    batten_surface_unref(surface);
    options.tolerance = 2e-3;
    CHECK_OK(batten_surface_skin((batten_curve_row){6, (const batten_curve *const *)sections},
                                 &options, NULL, NULL, &few, &surface));
    CHECK(exact.normal_jump > 0.01 && few.normal_jump == 0);
    CHECK(few.error <= 2e-3);
    batten_surface_unref(surface);
    unref_all(6, sections);
}

static bool stop_at(void *user)
{
    int *questions = user;
    return (*questions)-- == 0;
}

TEST(I8_the_search_for_common_knots_can_be_cancelled)
{
    test_random random = test_random_begin("cancel");
    batten_curve *sections[4];
    for (int k = 0; k < 4; k++)
        sections[k] = jittered(&random, 12, k, airfoil);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.tolerance = 1e-3;
    batten_surface *surface = NULL;
    for (int at = 0; at < 12; at++) {
        int questions = at;
        batten_job job = BATTEN_JOB;
        job.is_cancelled = stop_at;
        job.user = &questions;
        CHECK_STATUS(
            (questions = at,
             batten_surface_skin((batten_curve_row){4, (const batten_curve *const *)sections},
                                 &options, &job, NULL, NULL, &surface)),
            BATTEN_CANCELLED);
    }
    CHECK(surface == NULL);
    unref_all(4, sections);
}

TEST(as_many_knots_as_the_exact_union_are_not_better_than_it)
{
    batten_curve *sections[3] = {NULL, NULL, NULL};
    for (int k = 0; k < 3; k++)
        CHECK_OK(polyline_section(k, 0.5, &sections[k]));
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.tolerance = 1e-3;
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){3, (const batten_curve *const *)sections},
                                 &options, NULL, NULL, &report, &surface));
    CHECK(report.knot_count == 1 && report.error == 0);
    batten_surface_unref(surface);
    unref_all(3, sections);
}

TEST(K7_closed_profiles_share_few_knots_and_stay_periodic)
{
    enum { COUNT_ALL = 20 };
    const int count = test_cases(COUNT_ALL) < COUNT_ALL ? 3 : COUNT_ALL;
    test_random random = test_random_begin("rings");
    batten_curve *rings[COUNT_ALL];
    for (int k = 0; k < count; k++)
        rings[k] = jittered_ring(&random, 32, 3.0 * k / (count - 1));
    const double tolerances[] = {1e-2, 1e-3};
    for (int c = 0; c < COUNT(tolerances); c++) {
        batten_surface_skin_options options = batten_surface_skin_defaults();
        options.tolerance = tolerances[c];
        double v[COUNT_ALL];
        batten_surface_skin_report report;
        batten_surface *surface = NULL;
        CHECK_OK(
            batten_surface_skin((batten_curve_row){count, (const batten_curve *const *)rings},
                                &options, NULL, v, &report, &surface));
        CHECK(batten_surface_is_periodic(surface, BATTEN_U));
        CHECK(report.error <= tolerances[c] && report.knot_count < 40);
        CHECK(report.exact_knot_count == 31 * count && report.span_ratio > 0.05);
        CHECK(measured(count, rings, v, surface) <= report.error * (1 + 1e-9));
        double low[18], high[18]; /* C2 over the seam */
        CHECK_OK(batten_surface_evaluate_side(
            surface, 0, 0.4, (batten_sides){BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT}, 2, low));
        CHECK_OK(batten_surface_evaluate_side(
            surface, 1, 0.4, (batten_sides){BATTEN_FROM_LEFT, BATTEN_FROM_RIGHT}, 2, high));
        for (int i = 0; i < 18; i++)
            CHECK_NEAR(low[i], high[i], 1e-9);
        batten_surface_unref(surface);
    }
    unref_all(count, rings);
}

/* Symmetric sections, and held knots that are not. */
TEST(K7_held_knots_stand_in_the_result_to_the_bit)
{
    const double held[] = {0.123, 0.4, 0.77};
    const double points[] = {0, 0, 0, 1, 2, 0, 2, -1, 0, 3, 2, 0, 4, 0, 0};
    batten_curve *sections[2] = {NULL, NULL}, *common[2] = {NULL, NULL};
    double deviation[2];
    bat_work work = {NULL, 0};
    for (int k = 0; k < 2; k++) {
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        options.parameters = k ? BATTEN_UNIFORM : BATTEN_CHORD;
        CHECK_OK(batten_curve_interpolate((batten_points){3, 5, points}, &options, NULL,
                                          &sections[k]));
    }
    const bat_common_request request = {.tolerance = 1e-2, .held_count = 3, .held = held};
    CHECK_OK(bat_common_knots_held(2, (const batten_curve *const *)sections, &request, &work,
                                   common, deviation));
    const double *U = batten_curve_knots(common[0]);
    for (int i = 0; i < 3; i++) {
        int times = 0;
        for (int k = 0; k < batten_curve_knot_count(common[0]); k++)
            times += U[k] == held[i];
        CHECK_INT(times, 1);
    }
    CHECK(deviation[0] <= 1e-2 && deviation[1] <= 1e-2);
    unref_all(2, common);
    unref_all(2, sections);
}

/* A held knot stays where none is needed, beside those that the shape needs. */
TEST(a_held_knot_stays_beside_free_ones)
{
    static const double held[] = {0.123};
    double points[2][14][3];
    batten_curve *sections[2] = {NULL, NULL}, *common[2] = {NULL, NULL};
    double deviation[2];
    bat_work work = {NULL, 0};
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 14; i++)
            memcpy(points[k][i], (double[]){i, i > 5 ? 2 * sin(1.3 * i + k) : 0, k},
                   sizeof points[k][i]);
        CHECK_OK(batten_curve_interpolate((batten_points){3, 14, points[k][0]}, NULL, NULL,
                                          &sections[k]));
    }
    const bat_common_request request = {.tolerance = 0.5, .held_count = 1, .held = held};
    CHECK_OK(bat_common_knots_held(2, (const batten_curve *const *)sections, &request, &work,
                                   common, deviation));
    double spans[30];
    const int count = batten_curve_spans(common[0], spans);
    int times = 0;
    for (int i = 0; i < count; i++)
        times += spans[i] == held[0];
    CHECK_INT(times, 1);
    CHECK(count > 4 && count < 20);
    unref_all(2, common);
    unref_all(2, sections);
}
