#include "inspect/shapes.h"
#include <batten/measure.h>
#include <batten/standard.h>

TEST(an_ellipse_has_its_area_and_moments)
{
    batten_curve *flat = NULL, *turned = NULL;
    batten_region r;
    const batten_affine turn =
        batten_affine_rotation((batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1}, 0.5);
    CHECK_OK(shape_ellipse(3, 2, 10, -4, &flat));
    CHECK_OK(batten_curve_region(flat, 1e-12, 1e-12, &r));
    CHECK_NEAR(r.area, 6 * PI, 1e-12);
    CHECK_NEAR(r.centroid[0], 10, 1e-12);
    CHECK_NEAR(r.centroid[1], -4, 1e-12);
    CHECK_NEAR(r.xx, PI * 27 * 2 / 4, 1e-11); /* pi a^3 b / 4 */
    CHECK_NEAR(r.yy, PI * 3 * 8 / 4, 1e-11);
    CHECK_NEAR(r.xy, 0, 1e-11);
    CHECK(r.error <= 1e-12);
    CHECK_OK(batten_curve_transform(flat, &turn, &turned));
    CHECK_OK(batten_curve_region(turned, 1e-12, 1e-12, &r));
    CHECK_NEAR(r.principal[0], PI * 54 / 4, 1e-11);
    CHECK_NEAR(r.principal[1], PI * 24 / 4, 1e-11);
    CHECK_NEAR(r.angle, 0.5, 1e-12);
    batten_curve_unref(turned);
    batten_curve_unref(flat);
}

TEST(areas_of_polygons_are_exact_and_turn_with_the_direction)
{
    /* An L of two rectangles, 3 x 1 and 1 x 2 above its left end. */
    const double l[14] = {0, 0, 3, 0, 3, 1, 1, 1, 1, 3, 0, 3, 0, 0};
    batten_curve *curve = NULL, *back = NULL;
    batten_region r;
    double turns;
    CHECK_OK(batten_curve_polyline((batten_points){2, 7, l}, &curve));
    CHECK_OK(batten_curve_region(curve, 0, 1e-12, &r));
    CHECK_NEAR(r.area, 5, 1e-14);
    CHECK_NEAR(r.centroid[0], (3 * 1.5 + 2 * 0.5) / 5, 1e-14);
    CHECK_NEAR(r.centroid[1], (3 * 0.5 + 2 * 2) / 5, 1e-14);
    /* a rectangle about its centre b h^3 / 12, and its area by the distance squared */
    const double x = 5.5 / 5, y = 5.5 / 5;
    const double xx =
        27 / 12.0 + 3 * (1.5 - x) * (1.5 - x) + 2 / 12.0 + 2 * (0.5 - x) * (0.5 - x);
    const double xy = 3 * (1.5 - x) * (0.5 - y) + 2 * (0.5 - x) * (2 - y);
    CHECK_NEAR(r.xx, xx, 1e-13);
    CHECK_NEAR(r.xy, xy, 1e-13);
    CHECK_OK(batten_curve_turning(curve, 0, &turns));
    CHECK_NEAR(turns, 1, 1e-14);
    CHECK_OK(batten_curve_reverse(curve, &back));
    CHECK_OK(batten_curve_region(back, 0, 1e-12, &r));
    CHECK_NEAR(r.area, -5, 1e-14);
    CHECK_NEAR(r.centroid[0], 1.1, 1e-14);
    CHECK_NEAR(r.xx, -xx, 1e-13);
    CHECK(fabs(r.principal[0]) >= fabs(r.principal[1]));
    CHECK_OK(batten_curve_turning(back, 0, &turns));
    CHECK_NEAR(turns, -1, 1e-14);
    batten_curve_unref(back);
    batten_curve_unref(curve);
}

TEST(the_area_of_a_closed_spline_is_that_of_its_polygon_far_from_the_origin_too)
{
    /* Periodic cubics through a regular 40-gon: the area of a fine polyline agrees to its own
     * error, and moving by 1e6 changes the moments by rounding only. */
    test_random random = test_random_begin("areas");
    for (int n = test_cases(10); n > 0; n--) {
        double points[24], knots[13];
        batten_curve *curve = NULL, *moved = NULL;
        batten_region r, far;
        for (int i = 0; i < 12; i++) {
            const double radius = test_random_in(&random, 1, 3);
            points[2 * i] = radius * cos(PI * i / 6);
            points[2 * i + 1] = radius * sin(PI * i / 6);
        }
        for (int i = 0; i < 13; i++)
            knots[i] = i;
        CHECK_OK(batten_curve_create_periodic((batten_points){2, 12, points}, 3, NULL, knots,
                                              &curve));
        CHECK_OK(batten_curve_region(curve, 1e-12, 1e-12, &r));
        double area = 0, before[2], here[2];
        CHECK_OK(batten_curve_evaluate(curve, 0, 0, before));
        for (int i = 1; i <= 12000; i++) {
            CHECK_OK(batten_curve_evaluate(curve, i / 1000.0, 0, here));
            area += (before[0] * here[1] - before[1] * here[0]) / 2;
            memcpy(before, here, sizeof here);
        }
        CHECK_NEAR(r.area, area, 1e-5);
        const batten_affine away = batten_affine_translation(1e6, -1e6, 0);
        CHECK_OK(batten_curve_transform(curve, &away, &moved));
        CHECK_OK(batten_curve_region(moved, 1e-6, 1e-12, &far));
        CHECK_NEAR(far.area, r.area, 1e-8);
        CHECK_NEAR(far.xx, r.xx, 1e-7);
        CHECK_NEAR(far.centroid[0] - 1e6, r.centroid[0], 1e-8);
        batten_curve_unref(moved);
        batten_curve_unref(curve);
    }
}

TEST(rational_curves_have_the_area_of_a_fine_polyline)
{
    /* Weights within a ratio of 100, and once the same curve far from the origin. */
    test_random random = test_random_begin("rational areas");
    for (int n = test_cases(12); n > 0; n--) {
        const int degree = 1 + n % 6;
        double points[16], weights[8], knots[16], area = 0, first[2], before[2], here[2];
        batten_curve *curve = NULL, *moved = NULL;
        batten_region r, far;
        for (int i = 0; i < 8; i++) {
            const double angle = 2 * PI * i / 7, radius = test_random_in(&random, 1, 2);
            points[2 * i] = i == 7 ? points[0] : radius * cos(angle);
            points[2 * i + 1] = i == 7 ? points[1] : radius * sin(angle);
            weights[i] = pow(10, test_random_in(&random, -1, 1));
        }
        for (int i = 0; i < 8 + degree + 1; i++)
            knots[i] = fmin(8 - degree, fmax(0, i - degree));
        CHECK_OK(
            batten_curve_create((batten_points){2, 8, points}, degree, weights, knots, &curve));
        CHECK_OK(batten_curve_region(curve, 1e-12, 1e-11, &r));
        CHECK(r.error <= 1e-11);
        CHECK_OK(batten_curve_evaluate(curve, 0, 0, first));
        memcpy(before, first, sizeof first);
        for (int i = 1; i <= 8000 * (8 - degree); i++) {
            CHECK_OK(batten_curve_evaluate(curve, i / 8000.0, 0, here));
            area += ((before[0] - first[0]) * (here[1] - first[1]) -
                     (before[1] - first[1]) * (here[0] - first[0])) /
                    2;
            memcpy(before, here, sizeof here);
        }
        CHECK_NEAR(r.area, area, 1e-5);
        const batten_affine away = batten_affine_translation(1e7, 1e7, 0);
        CHECK_OK(batten_curve_transform(curve, &away, &moved));
        CHECK_OK(batten_curve_region(moved, 1e-6, 1e-11, &far));
        CHECK_NEAR(far.area, r.area, 1e-6);
        batten_curve_unref(moved);
        batten_curve_unref(curve);
    }
}

TEST(curves_that_enclose_nothing_are_refused)
{
    const double open[8] = {0, 0, 1, 1, 2, 1, 3, 0}, back[6] = {0, 0, 2, 1, 0, 0};
    batten_curve *curve = NULL, *there = NULL, *space = NULL;
    batten_region r;
    int winding;
    const double at[2] = {0.1, 0.2};
    CHECK_OK(shape_bezier(2, 3, open, &curve));
    CHECK_STATUS(batten_curve_region(curve, 1e-9, 1e-9, &r), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("its ends are 3 apart");
    CHECK_STATUS(batten_curve_winding(curve, (batten_vec2){at[0], at[1]}, 1e-9, &winding),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curve_region(curve, NAN, 1e-9, &r), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_region(curve, 4, 0, &r), BATTEN_BAD_ARGUMENT);
    CHECK_OK(batten_curve_region(curve, 4, 1e-9, &r)); /* closed by a line: clockwise */
    CHECK_NEAR(r.area, -1.5, 1e-14);
    CHECK_OK(batten_curve_polyline((batten_points){2, 3, back}, &there));
    CHECK_STATUS(batten_curve_region(there, 0, 1e-9, &r), BATTEN_COINCIDENT);
    CHECK_OK(batten_curve_to_dimension(curve, 3, &space));
    CHECK_STATUS(batten_curve_region(space, 4, 1e-9, &r), BATTEN_NOT_COMPATIBLE);
    batten_curve_unref(space);
    batten_curve_unref(there);
    batten_curve_unref(curve);
}
