#include "inspect/shapes.h"

#include <batten/nearest.h>

static void check_crossings(const batten_curve *curve, int axis, double value, int count,
                            const double *expected)
{
    batten_parameters found = {0};
    CHECK_OK(batten_curve_crossings(curve, axis, value, &found));
    CHECK_INT(found.count, count);
    for (int k = 0; k < count; k++)
        CHECK_NEAR(found.at[k], expected[k], 1e-7);
    batten_release(found.at);
}

TEST(a_circle_crosses_touches_and_misses_lines)
{
    batten_curve *circle = NULL;
    const double both[2] = {0.125, 0.375}, top[1] = {0.25}, ends[2] = {0, 1},
                 axis[3] = {0, 0.5, 1};
    CHECK_OK(shape_ellipse(2, 2, 1, 1, &circle));
    check_crossings(circle, 1, 1 + sqrt(2), 2, both);
    check_crossings(circle, 1, 3, 1, top);  /* touches from below */
    check_crossings(circle, 0, 3, 2, ends); /* touches where it begins and ends */
    check_crossings(circle, 1, 1, 3, axis); /* crosses there */
    check_crossings(circle, 1, 3.1, 0, NULL);
    batten_curve_unref(circle);
}

TEST(a_piece_on_the_value_gives_both_its_ends)
{
    const double points[10] = {0, 0, 1, 1, 2, 1, 3, 1, 4, 5}, knots[7] = {0, 0, 1, 2, 3, 4, 4};
    const double expected[3] = {1, 2, 3};
    batten_curve *polygon = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 5, points}, 1, NULL, knots, &polygon));
    check_crossings(polygon, 1, 1, 3, expected);
    batten_curve_unref(polygon);
}

TEST(every_crossing_of_a_random_curve_is_found)
{
    test_random random = test_random_begin("crossings");
    for (int n = test_cases(60); n > 0; n--) {
        const int degree = test_random_int(&random, 1, 9);
        double points[20], value = test_random_in(&random, -0.5, 0.5);
        batten_curve *curve = NULL;
        batten_parameters found = {0};
        for (int i = 0; i < 2 * (degree + 1); i++)
            points[i] = test_random_in(&random, -1, 1);
        CHECK_OK(shape_bezier(2, degree, points, &curve));
        CHECK_OK(batten_curve_crossings(curve, 1, value, &found));
        int changes = 0;
        double before = 0, at[2];
        for (int k = 0; k <= 2000; k++) {
            CHECK_OK(batten_curve_evaluate(curve, k / 2000.0, 0, at));
            changes += before * (at[1] - value) < 0;
            before = at[1] - value;
        }
        CHECK(found.count >= changes && (found.count - changes) % 2 == 0);
        for (int k = 0; k < found.count; k++) {
            CHECK_OK(batten_curve_evaluate(curve, found.at[k], 0, at));
            CHECK_NEAR(at[1], value, 1e-12);
        }
        batten_release(found.at);
        batten_curve_unref(curve);
    }
}

TEST(a_coordinate_that_is_not_there_is_refused)
{
    batten_curve *circle = NULL;
    batten_parameters found = {0};
    CHECK_OK(shape_ellipse(1, 1, 0, 0, &circle));
    CHECK_STATUS(batten_curve_crossings(circle, 2, 0, &found), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_crossings(circle, -1, 0, &found), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_crossings(circle, 0, NAN, &found), BATTEN_NOT_FINITE);
    batten_curve_unref(circle);
}
