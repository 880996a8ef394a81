#include <batten/curve.h>

#include "support/generate.h"

static const double square[] = {0, 0, 1, 0, 1, 1, 0, 1};

TEST(K9_degrees_and_counts_at_their_limits)
{
    const double knots[60] = {0};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_create((batten_points){2, 4, square}, 0, NULL, knots, &curve),
                 BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_curve_create((batten_points){2, 4, square}, 26, NULL, knots, &curve),
                 BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_curve_create((batten_points){2, 4, square}, 4, NULL, knots, &curve),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("4 control points for degree 4; 5 are needed");
    CHECK_STATUS(batten_curve_create((batten_points){2, 0, square}, 1, NULL, knots, &curve),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_curve_create((batten_points){4, 2, square}, 1, NULL, knots, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK(curve == NULL);
}

TEST(S1_counts_that_wrap_are_refused)
{
    const double knots[60] = {0};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_create((batten_points){2, -1, square}, 1, NULL, knots, &curve),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(
        batten_curve_create((batten_points){2, 2147483647, square}, 1, NULL, knots, &curve),
        BATTEN_TOO_LARGE);
}

TEST(K8_weights_must_be_positive)
{
    const double knots[] = {0, 0, 1, 2, 3, 3};
    double weights[] = {1, 1, 0, 1};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_create((batten_points){2, 4, square}, 1, weights, knots, &curve),
                 BATTEN_BAD_WEIGHT);
    CHECK_MESSAGE("weight 3 is 0");
    weights[2] = INFINITY;
    CHECK_STATUS(batten_curve_create((batten_points){2, 4, square}, 1, weights, knots, &curve),
                 BATTEN_NOT_FINITE);
}

TEST(N1_coordinates_that_are_no_numbers_are_refused)
{
    const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 1, NAN};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_create((batten_points){2, 2, points}, 1, NULL, knots, &curve),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 2 of control point 2");
}

TEST(a_curve_shows_what_it_was_made_of)
{
    const double knots[] = {0, 0, 0, 1, 2, 2, 2}, weights[] = {1, 2, 3, 4};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 4, square}, 2, weights, knots, &curve));
    CHECK_INT(batten_curve_dimension(curve), 2);
    CHECK_INT(batten_curve_degree(curve), 2);
    CHECK_INT(batten_curve_point_count(curve), 4);
    CHECK_INT(batten_curve_knot_count(curve), 7);
    CHECK(memcmp(batten_curve_points(curve), square, sizeof square) == 0);
    CHECK(memcmp(batten_curve_weights(curve), weights, sizeof weights) == 0);
    CHECK(memcmp(batten_curve_knots(curve), knots, sizeof knots) == 0);
    CHECK(batten_curve_is_rational(curve) && batten_curve_is_clamped(curve));
    CHECK(!batten_curve_is_periodic(curve));
    CHECK(!batten_curve_is_closed(curve, 0.5) && batten_curve_is_closed(curve, 1.01));
    CHECK_BITS(batten_curve_domain(curve).a, 0);
    CHECK_BITS(batten_curve_domain(curve).b, 2);
    const batten_box box = batten_curve_box(curve);
    CHECK(box.low.x == 0 && box.high.x == 1 && box.high.y == 1 && box.high.z == 0);
    CHECK_BITS(batten_curve_greville(curve, 0), 0);
    CHECK_BITS(batten_curve_greville(curve, 1), 0.5);
    CHECK_BITS(batten_curve_greville(curve, 3), 2);
    double spans[5];
    CHECK_INT(batten_curve_spans(curve, spans), 3);
    CHECK(spans[0] == 0 && spans[1] == 1 && spans[2] == 2);
    batten_curve *again = batten_curve_ref(curve);
    CHECK(again == curve);
    batten_curve_unref(again);
    batten_curve_unref(curve);
    batten_curve_unref(NULL);
}

TEST(a_periodic_curve_is_one_smooth_round)
{
    const double knots[] = {0, 0.7, 2, 2.5, 4};
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_create_periodic((batten_points){2, 4, square}, 3, NULL, knots, &curve));
    CHECK(batten_curve_is_periodic(curve) && !batten_curve_is_clamped(curve));
    CHECK_INT(batten_curve_point_count(curve), 7);
    CHECK_BITS(batten_curve_domain(curve).a, 0);
    CHECK_BITS(batten_curve_domain(curve).b, 4);
    CHECK(batten_curve_is_closed(curve, 1e-15));
    double at_start[6], at_end[6], beyond[6];
    CHECK_OK(batten_curve_evaluate(curve, 0, 2, at_start));
    CHECK_OK(batten_curve_evaluate_side(curve, 4, BATTEN_FROM_LEFT, 2, at_end));
    CHECK_OK(batten_curve_evaluate(curve, -8, 2, beyond));
    for (int i = 0; i < 6; i++) {
        CHECK_NEAR(at_start[i], at_end[i], 1e-14);
        CHECK_BITS(at_start[i], beyond[i]);
    }
    batten_curve_unref(curve);
}

TEST(a_period_may_have_fewer_points_than_the_degree_asks)
{
    const double knots[] = {0, 1, 2}, points[] = {1, -1};
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_create_periodic((batten_points){1, 2, points}, 3, NULL, knots, &curve));
    CHECK_INT(batten_curve_point_count(curve), 5);
    /* Uniform cubic: (1 4 1) / 6 of alternating values. */
    double value;
    CHECK_OK(batten_curve_evaluate(curve, 0, 0, &value));
    CHECK_NEAR(fabs(value), 1 / 3., 1e-15);
    batten_curve_unref(curve);
}

TEST(K1_an_empty_period_is_refused)
{
    const double knots[] = {1, 1, 1}, bad[] = {0, NAN, 1}, falling[] = {0, 2, 1};
    batten_curve *curve = NULL;
    CHECK_STATUS(
        batten_curve_create_periodic((batten_points){1, 2, square}, 1, NULL, knots, &curve),
        BATTEN_BAD_KNOTS);
    CHECK_STATUS(
        batten_curve_create_periodic((batten_points){1, 2, square}, 1, NULL, bad, &curve),
        BATTEN_NOT_FINITE);
    CHECK_STATUS(
        batten_curve_create_periodic((batten_points){1, 2, square}, 1, NULL, falling, &curve),
        BATTEN_BAD_KNOTS);
}

TEST(greville_abscissae_are_the_points_of_the_identity)
{
    test_random random = test_random_begin(__func__);
    const test_wish wish = {.tame = true, .dimension = 1, .rational = TEST_NEVER};
    for (int i = 0; i < test_cases(200); i++) {
        batten_curve *curve = test_curve(&random, &wish), *identity = NULL;
        double points[TEST_MOST_POINTS];
        const int n = batten_curve_point_count(curve);
        for (int k = 0; k < n; k++)
            points[k] = batten_curve_greville(curve, k);
        CHECK_OK(batten_curve_create((batten_points){1, n, points}, batten_curve_degree(curve),
                                     NULL, batten_curve_knots(curve), &identity));
        for (int k = 0; k < 10; k++) {
            double value, u = test_parameter(&random, curve);
            CHECK_OK(batten_curve_evaluate(identity, u, 0, &value));
            CHECK_NEAR(value, u, 1e-13);
        }
        batten_curve_unref(identity);
        batten_curve_unref(curve);
    }
}

TEST(a_curve_stays_in_its_box)
{
    test_random random = test_random_begin(__func__);
    const test_wish any = {0};
    for (int i = 0; i < test_cases(300); i++) {
        batten_curve *curve =
            i % 4 ? test_curve(&random, &any) : test_periodic_curve(&random, &any);
        const batten_box box = batten_curve_box(curve);
        const double most =
            8 * batten_curve_degree(curve) * DBL_EPSILON * test_curve_size(curve);
        double p[3] = {0};
        CHECK_OK(batten_curve_evaluate(curve, test_parameter(&random, curve), 0, p));
        CHECK(p[0] >= box.low.x - most && p[0] <= box.high.x + most);
        CHECK(p[1] >= box.low.y - most && p[1] <= box.high.y + most);
        CHECK(p[2] >= box.low.z - most && p[2] <= box.high.z + most);
        batten_curve_unref(curve);
    }
}

TEST(K2_a_curve_of_bad_period_or_knots_is_not_made)
{
    const double knots[] = {0, 0, 1, 2, 2, 2, 3}, period[] = {0, 0, 0, 0, 1};
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_create((batten_points){2, 4, square}, 2, NULL, knots, &none),
                 BATTEN_OK);
    batten_curve_unref(none);
    none = NULL;
    CHECK_STATUS(
        batten_curve_create_periodic((batten_points){1, 4, square}, 2, NULL, period, &none),
        BATTEN_BAD_KNOTS);
    CHECK_STATUS(
        batten_curve_create_periodic((batten_points){1, 0, square}, 2, NULL, period, &none),
        BATTEN_TOO_FEW_POINTS);
    CHECK(none == NULL);
}

TEST(clamped_means_at_both_ends)
{
    const double points[] = {0, 1, 3};
    const double knots[4][6] = {
        {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 2}, {-1, 0, 0, 1, 1, 1}, {-1, 0, 0, 1, 1, 2}};
    for (int i = 0; i < 4; i++) {
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_create((batten_points){1, 3, points}, 2, NULL, knots[i], &curve));
        CHECK(batten_curve_is_clamped(curve) == (i == 0));
        batten_curve_unref(curve);
    }
}
