#include "spline/curve/curve.h"

#include <batten/standard.h>

#include "support/generate.h"

TEST(halves_rejoin_to_the_curve)
{
    test_random random = test_random_begin(__func__);
    const test_wish any = {0};
    for (int i = 0; i < test_cases(300); i++) {
        batten_curve *curve =
            i % 4 ? test_curve(&random, &any) : test_periodic_curve(&random, &any);
        batten_curve *left = NULL, *right = NULL, *whole = NULL;
        const batten_interval domain = batten_curve_domain(curve);
        const double u = domain.a + test_random_in(&random, 0.1, 0.9) * (domain.b - domain.a);
        const double size = test_curve_size(curve);
        CHECK_OK(batten_curve_split(curve, u, &left, &right));
        CHECK_OK(batten_curve_join(left, right, 0, &whole));
        CHECK_INT(batten_curve_point_count(whole),
                  batten_curve_point_count(left) + batten_curve_point_count(right) - 1);
        for (int k = 0; k < 20; k++) {
            const double v = test_parameter(&random, curve);
            CHECK_NEAR(test_curve_distance(curve, v, whole, v, size), 0,
                       32 * batten_curve_degree(curve) * DBL_EPSILON);
        }
        batten_curve_unref(whole);
        batten_curve_unref(right);
        batten_curve_unref(left);
        batten_curve_unref(curve);
    }
}

TEST(curves_of_any_degree_and_kind_join)
{
    const double line[] = {0, 0, 1, 0}, line_knots[] = {5, 5, 6, 6};
    const double arc[] = {1, 0, 2, 0, 2, 1}, arc_knots[] = {0, 0, 0, 2, 2, 2},
                 weights[] = {3, 2, 3};
    batten_curve *first = NULL, *second = NULL, *both = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 2, line}, 1, NULL, line_knots, &first));
    CHECK_OK(batten_curve_create((batten_points){2, 3, arc}, 2, weights, arc_knots, &second));
    CHECK_OK(batten_curve_join(first, second, 1e-9, &both));
    CHECK_INT(batten_curve_degree(both), 2);
    CHECK(batten_curve_is_rational(both));
    CHECK_BITS(batten_curve_domain(both).a, 5);
    CHECK_BITS(batten_curve_domain(both).b, 8);
    CHECK_NEAR(test_curve_distance(first, 5.25, both, 5.25, 1), 0, 1e-15);
    CHECK_NEAR(test_curve_distance(second, 0.5, both, 6.5, 1), 0, 1e-15);
    batten_curve_unref(both);
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_join(second, first, 0.5, &none), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("apart, more than 0.5");
    CHECK_STATUS(batten_curve_join(first, second, -1, &none), BATTEN_BAD_ARGUMENT);
    CHECK_OK(batten_curve_to_dimension(second, 3, &both));
    CHECK_STATUS(batten_curve_join(first, both, 1, &none), BATTEN_NOT_COMPATIBLE);
    batten_curve_unref(both);
    batten_curve_unref(second);
    batten_curve_unref(first);
}

TEST(ends_that_nearly_meet_are_joined_halfway)
{
    const double a[] = {0, 1}, b[] = {1.25, 2}, knots[] = {0, 0, 1, 1};
    batten_curve *first = NULL, *second = NULL, *both = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 2, a}, 1, NULL, knots, &first));
    CHECK_OK(batten_curve_create((batten_points){1, 2, b}, 1, NULL, knots, &second));
    CHECK_OK(batten_curve_join(first, second, 0.25, &both));
    CHECK_BITS(batten_curve_points(both)[1], 1.125);
    batten_curve_unref(both);
    batten_curve_unref(second);
    batten_curve_unref(first);
}

TEST(K6_knots_that_fall_together_when_moved_are_refused)
{
    const double a[] = {0, 1}, b[] = {1, 2, 3}, far[] = {1e9, 1e9, 1e9 + 1, 1e9 + 1},
                 fine[] = {0, 0, 1e-9, 1, 1};
    batten_curve *first = NULL, *second = NULL, *none = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 2, a}, 1, NULL, far, &first));
    CHECK_OK(batten_curve_create((batten_points){1, 3, b}, 1, NULL, fine, &second));
    CHECK_STATUS(batten_curve_join(first, second, 0, &none), BATTEN_BAD_KNOTS);
    batten_curve_unref(second);
    batten_curve_unref(first);
}

TEST(rows_of_curves_join_in_order_whatever_their_number)
{
    /* The points (i, i^2), joined by lines. */
    enum { MOST = 9 };
    batten_curve *lines[MOST] = {NULL}, *all = NULL;
    for (int i = 0; i < MOST; i++)
        CHECK_OK(batten_curve_line(2, (const double[]){i, i * i},
                                   (const double[]){i + 1, (i + 1) * (i + 1)}, &lines[i]));
    for (int count = 1; count <= MOST; count++) {
        CHECK_OK(bat_curves_chain(count, lines, 0, &all));
        CHECK_INT(batten_curve_point_count(all), count + 1);
        for (int i = 0; i <= count; i++) {
            CHECK_NEAR(batten_curve_points(all)[2 * i], i, 0);
            CHECK_NEAR(batten_curve_points(all)[2 * i + 1], i * i, 0);
        }
        batten_curve_unref(all);
    }
    all = NULL;
    batten_curve *const gap[3] = {lines[0], lines[1], lines[3]};
    CHECK_STATUS(bat_curves_chain(3, gap, 0.5, &all), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("apart, more than 0.5");
    CHECK(!all);
    for (int i = 0; i < MOST; i++)
        batten_curve_unref(lines[i]);
}
