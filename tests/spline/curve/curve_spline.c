#include "spline/curve/curve.h"

#include "support/generate.h"

TEST(a_periodic_curve_unwrapped_and_wrapped_is_itself)
{
    test_random random = test_random_begin(__func__);
    const test_wish wish = {.rational = TEST_NEVER};
    for (int i = 0; i < test_cases(200); i++) {
        batten_curve *curve = test_periodic_curve(&random, &wish), *again = NULL;
        const int p = curve->degree, m = curve->count - p;
        bat_spline spline = {0};
        CHECK_OK(bat_curve_unwrap(curve, 2, &spline));
        CHECK_INT(spline.count, 5 * m + p);
        CHECK_BITS(spline.knots[2 * m + p], curve->knots[p]);
        CHECK_OK(bat_curve_wrap(curve, &spline, curve->knots[p], m, &again));
        CHECK_INT(again->count, curve->count);
        const double size = test_curve_size(curve);
        for (int k = 0; k < 10; k++) {
            const double u = test_parameter(&random, curve);
            CHECK_NEAR(test_curve_distance(curve, u, again, u, size), 0, 16 * p * DBL_EPSILON);
        }
        bat_spline_free(&spline);
        batten_curve_unref(again);
        batten_curve_unref(curve);
    }
}

TEST(rational_points_that_do_not_change_keep_their_bits)
{
    test_random random = test_random_begin(__func__);
    const test_wish wish = {.rational = TEST_ALWAYS, .degree = 2};
    for (int i = 0; i < test_cases(200); i++) {
        batten_curve *curve = test_curve(&random, &wish), *again = NULL;
        bat_spline spline = {0};
        CHECK_OK(bat_curve_to_spline(curve, &spline));
        CHECK_OK(bat_curve_from_spline(curve, &spline, 0, &spline, &again));
        CHECK(memcmp(curve->points, again->points,
                     (size_t)(curve->count * curve->dimension) * sizeof(double)) == 0);
        CHECK(memcmp(curve->weights, again->weights, (size_t)curve->count * sizeof(double)) ==
              0);
        bat_spline_free(&spline);
        batten_curve_unref(again);
        batten_curve_unref(curve);
    }
}
