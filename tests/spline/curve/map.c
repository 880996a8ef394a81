#include <batten/curve.h>

#include "numeric/vector.h"
#include "support/generate.h"

static const test_wish any = {0};

static batten_curve *any_curve(test_random *random, int i)
{
    return i % 4 ? test_curve(random, &any) : test_periodic_curve(random, &any);
}

static void check_same_bits(const double *a, const double *b, int count)
{
    CHECK((a == NULL) == (b == NULL));
    for (int i = 0; a && i < count; i++)
        CHECK_BITS(a[i], b[i]);
}

static void check_identical(const batten_curve *a, const batten_curve *b)
{
    CHECK_INT(batten_curve_degree(a), batten_curve_degree(b));
    CHECK_INT(batten_curve_point_count(a), batten_curve_point_count(b));
    CHECK_INT(batten_curve_is_periodic(a), batten_curve_is_periodic(b));
    check_same_bits(batten_curve_knots(a), batten_curve_knots(b), batten_curve_knot_count(a));
    check_same_bits(batten_curve_weights(a), batten_curve_weights(b),
                    batten_curve_point_count(a));
    check_same_bits(batten_curve_points(a), batten_curve_points(b),
                    batten_curve_point_count(a) * batten_curve_dimension(a));
}

TEST(reversing_twice_changes_no_bit_and_once_runs_backwards)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(500); i++) {
        batten_curve *curve = any_curve(&random, i), *back = NULL, *again = NULL;
        CHECK_OK(batten_curve_reverse(curve, &back));
        CHECK_OK(batten_curve_reverse(back, &again));
        check_identical(curve, again);
        CHECK_BITS(batten_curve_domain(back).a, -batten_curve_domain(curve).b);
        const double size = test_curve_size(curve),
                     most = 16 * batten_curve_degree(curve) * DBL_EPSILON;
        for (int k = 0; k < 10; k++) {
            const double u = test_parameter(&random, curve);
            CHECK_NEAR(test_curve_distance(curve, u, back, -u, size), 0, most);
        }
        batten_curve_unref(again);
        batten_curve_unref(back);
        batten_curve_unref(curve);
    }
}

TEST(another_domain_keeps_points_and_scales_derivatives)
{
    test_random random = test_random_begin(__func__);
    const test_wish tame = {.tame = true};
    for (int i = 0; i < test_cases(200); i++) {
        batten_curve *curve =
            i % 4 ? test_curve(&random, &tame) : test_periodic_curve(&random, &tame);
        batten_curve *mapped = NULL, *same = NULL;
        const batten_interval domain = batten_curve_domain(curve);
        const int d = batten_curve_dimension(curve), p = batten_curve_degree(curve);
        CHECK_OK(batten_curve_set_domain(curve, -3, 5, &mapped));
        CHECK_BITS(batten_curve_domain(mapped).a, -3);
        CHECK_BITS(batten_curve_domain(mapped).b, 5);
        const double t = test_random_unit(&random), length = domain.b - domain.a;
        double one[6], other[6];
        CHECK_OK(batten_curve_evaluate(curve, fmin(domain.a + t * length, domain.b), 1, one));
        CHECK_OK(batten_curve_evaluate(mapped, -3 + t * 8, 1, other));
        for (int k = 0; k < d; k++) {
            CHECK_NEAR(one[k], other[k], 1e-12 * p);
            CHECK_NEAR(one[d + k] * length, other[d + k] * 8, 1e-10 * p * p * length);
        }
        CHECK_OK(batten_curve_set_domain(curve, domain.a, domain.b, &same));
        check_identical(curve, same);
        batten_curve_unref(same);
        batten_curve_unref(mapped);
        batten_curve_unref(curve);
    }
}

TEST(K6_knots_that_would_fall_together_are_refused)
{
    const double points[] = {0, 1, 2, 3}, knots[] = {0, 0, 1e-14, 1 + 1e-14, 3, 3};
    batten_curve *curve = NULL, *none = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 4, points}, 1, NULL, knots, &curve));
    CHECK_STATUS(batten_curve_set_domain(curve, 1e6, 1e6 + 1, &none), BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("knots 2 and 3");
    CHECK_STATUS(batten_curve_set_domain(curve, 1, 1, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_set_domain(curve, 2, 1, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_set_domain(curve, 2, INFINITY, &none), BATTEN_NOT_FINITE);
    batten_curve_unref(curve);
}

TEST(a_moebius_change_of_the_parameter_keeps_the_shape)
{
    test_random random = test_random_begin(__func__);
    const test_wish tame = {.tame = true, .degree = 3};
    for (int i = 0; i < test_cases(200); i++) {
        batten_curve *curve =
            i % 4 ? test_curve(&random, &tame) : test_periodic_curve(&random, &tame);
        const batten_interval domain = batten_curve_domain(curve);
        const double *knots = batten_curve_knots(curve);
        const double c = test_random_in(&random, -0.5, 0.5) /
                         (knots[batten_curve_knot_count(curve) - 1] + 1);
        const double d = 1 + fabs(knots[0]), a = 2, b = -1;
        batten_curve *mapped = NULL;
        CHECK_OK(batten_curve_moebius(curve, a, b, c, d, &mapped));
        CHECK(batten_curve_is_rational(mapped));
        for (int k = 0; k <= 10; k++) {
            const double u = domain.a + k / 10.0 * (domain.b - domain.a);
            const double v = (a * u + b) / (c * u + d);
            const batten_interval range = batten_curve_domain(mapped);
            CHECK_NEAR(test_curve_distance(curve, fmin(u, domain.b), mapped,
                                           fmin(fmax(v, range.a), range.b), 1),
                       0, 1e-11);
        }
        batten_curve_unref(mapped);
        batten_curve_unref(curve);
    }
}

/* The weights become w_i / ((c u_{i+1} + d) ... (c u_{i+p} + d)), but for a common factor. */
TEST(a_moebius_change_has_the_weights_of_the_notes)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, -1, 6, 0, 7, 2}, w[] = {1, 2, 0.5, 3, 1, 0.7},
                 knots[] = {0, 0, 0, 0, 1, 1.5, 2, 2, 2, 2}, a = 3, b = 1, c = 0.4, d = 0.5;
    batten_curve *curve = NULL, *mapped = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 6, points}, 3, w, knots, &curve));
    CHECK_OK(batten_curve_moebius(curve, a, b, c, d, &mapped));
    double factor = 0;
    for (int i = 0; i < 6; i++) {
        double expected = w[i];
        for (int j = 1; j <= 3; j++)
            expected /= c * knots[i + j] + d;
        factor = i ? factor : batten_curve_weights(mapped)[0] / expected;
        CHECK_NEAR(batten_curve_weights(mapped)[i] / (factor * expected), 1, 1e-14);
    }
    for (int i = 0; i < 10; i++)
        CHECK_NEAR(batten_curve_knots(mapped)[i], (a * knots[i] + b) / (c * knots[i] + d),
                   1e-14);
    batten_curve_unref(mapped);
    batten_curve_unref(curve);
}

/* Weights scaled in common are the same curve. */
TEST(a_common_factor_of_the_weights_changes_no_point)
{
    test_random random = test_random_begin(__func__);
    const test_wish wish = {.rational = TEST_ALWAYS, .tame = true};
    for (int i = 0; i < test_cases(100); i++) {
        batten_curve *curve = test_curve(&random, &wish), *scaled = NULL;
        const int n = batten_curve_point_count(curve);
        double weights[TEST_MOST_POINTS];
        const double factor = pow(10, test_random_in(&random, -100, 100));
        for (int k = 0; k < n; k++)
            weights[k] = factor * batten_curve_weights(curve)[k];
        CHECK_OK(batten_curve_create(
            (batten_points){batten_curve_dimension(curve), n, batten_curve_points(curve)},
            batten_curve_degree(curve), weights, batten_curve_knots(curve), &scaled));
        for (int k = 0; k < 20; k++) {
            const double u = test_parameter(&random, curve);
            CHECK_NEAR(test_curve_distance(curve, u, scaled, u, test_curve_size(curve)), 0,
                       1e-13);
        }
        batten_curve_unref(scaled);
        batten_curve_unref(curve);
    }
}

TEST(a_moebius_change_with_a_pole_is_refused)
{
    const double points[] = {0, 1}, knots[] = {0, 0, 1, 1};
    batten_curve *curve = NULL, *none = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 2, points}, 1, NULL, knots, &curve));
    CHECK_STATUS(batten_curve_moebius(curve, 1, 0, -2, 1, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_moebius(curve, 1, 0, 1, 0, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_moebius(curve, -1, 0, 0, 1, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_moebius(curve, NAN, 0, 0, 1, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_moebius(curve, 1e-300, 0, 0, 1e300, &none), BATTEN_BAD_KNOTS);
    batten_curve_unref(curve);
}

TEST(weights_and_dimensions_are_added_and_dropped_without_changing_a_bit)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(200); i++) {
        batten_curve *curve = any_curve(&random, i), *rational = NULL, *space = NULL,
                     *back = NULL;
        CHECK_OK(batten_curve_to_rational(curve, &rational));
        CHECK(batten_curve_is_rational(rational));
        check_same_bits(batten_curve_points(curve), batten_curve_points(rational),
                        batten_curve_point_count(curve) * batten_curve_dimension(curve));
        CHECK_OK(batten_curve_to_dimension(curve, 3, &space));
        CHECK_OK(batten_curve_to_dimension(space, batten_curve_dimension(curve), &back));
        check_identical(curve, back);
        if (batten_curve_dimension(curve) < 3)
            CHECK_BITS(batten_curve_points(space)[2], 0);
        batten_curve *none = NULL;
        CHECK_STATUS(batten_curve_to_dimension(curve, 4, &none), BATTEN_BAD_ARGUMENT);
        batten_curve_unref(back);
        batten_curve_unref(space);
        batten_curve_unref(rational);
        batten_curve_unref(curve);
    }
}

TEST(a_control_point_is_replaced_with_all_its_copies)
{
    const double points[] = {0, 1, 2, 3}, knots[] = {0, 1, 2, 3, 4}, moved[] = {9},
                 bad[] = {NAN};
    batten_curve *curve = NULL, *edited = NULL;
    CHECK_OK(
        batten_curve_create_periodic((batten_points){1, 4, points}, 3, NULL, knots, &curve));
    CHECK_OK(batten_curve_with_point(curve, 5, moved, &edited));
    const double expected[] = {0, 9, 2, 3, 0, 9, 2};
    check_same_bits(batten_curve_points(edited), expected, 7);
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_with_point(curve, 5, bad, &none), BATTEN_NOT_FINITE);
    batten_curve_unref(edited);
    batten_curve_unref(curve);
}

TEST(an_affine_map_and_evaluation_commute)
{
    test_random random = test_random_begin(__func__);
    const batten_affine map = {{{1, 2, 0}, {-1, 0.5, 0}, {0, 0, 1}}, {3, -4, 0}};
    for (int i = 0; i < test_cases(200); i++) {
        batten_curve *curve = any_curve(&random, i), *mapped = NULL;
        CHECK_OK(batten_curve_transform(curve, &map, &mapped));
        const int d = batten_curve_dimension(curve);
        double p[3] = {0}, q[3] = {0};
        const double u = test_parameter(&random, curve);
        CHECK_OK(batten_curve_evaluate(curve, u, 0, p));
        CHECK_OK(batten_curve_evaluate(mapped, u, 0, q));
        const double most =
            64 * batten_curve_degree(curve) * DBL_EPSILON * (4 + test_curve_size(curve));
        CHECK_NEAR(q[0], p[0] + (d > 1 ? 2 * p[1] : 0) + 3, most);
        if (d > 1)
            CHECK_NEAR(q[1], -p[0] + 0.5 * p[1] - 4, most);
        if (d > 2)
            CHECK_NEAR(q[2], p[2], most);
        batten_curve_unref(mapped);
        batten_curve_unref(curve);
    }
}

TEST(scaling_by_a_power_of_two_is_exact)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(200); i++) {
        batten_curve *curve = any_curve(&random, i), *mapped = NULL;
        const batten_affine map = {{{8, 0, 0}, {0, 8, 0}, {0, 0, 8}}, {0, 0, 0}};
        CHECK_OK(batten_curve_transform(curve, &map, &mapped));
        double p[9], q[9];
        const double u = test_parameter(&random, curve);
        CHECK_OK(batten_curve_evaluate(curve, u, 2, p));
        CHECK_OK(batten_curve_evaluate(mapped, u, 2, q));
        for (int k = 0; k < 3 * batten_curve_dimension(curve); k++)
            CHECK_BITS(q[k] + 0.0, 8 * p[k] + 0.0);
        batten_curve_unref(mapped);
        batten_curve_unref(curve);
    }
}

TEST(N2_a_map_to_where_numbers_end_is_an_overflow)
{
    const double points[] = {1e300, 0}, knots[] = {0, 0, 1, 1};
    const batten_affine map = {{{1e300, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    const batten_affine bad = {{{NAN, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    batten_curve *curve = NULL, *none = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 2, points}, 1, NULL, knots, &curve));
    CHECK_STATUS(batten_curve_transform(curve, &map, &none), BATTEN_OVERFLOW);
    CHECK_STATUS(batten_curve_transform(curve, &bad, &none), BATTEN_NOT_FINITE);
    batten_curve_unref(curve);
}

TEST(maps_refuse_each_coefficient_that_is_no_number)
{
    const double points[] = {0, 1, 3}, knots[] = {0, 0, 0, 1, 1, 1};
    batten_curve *curve = NULL, *none = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 3, points}, 2, NULL, knots, &curve));
    for (int i = 0; i < 4; i++) {
        double m[] = {1, 0, 0.5, 1};
        m[i] = i % 2 ? NAN : INFINITY;
        CHECK_STATUS(batten_curve_moebius(curve, m[0], m[1], m[2], m[3], &none),
                     BATTEN_NOT_FINITE);
    }
    for (int i = 0; i < 12; i++) {
        batten_affine map = batten_affine_identity();
        if (i < 9)
            map.m[i / 3][i % 3] = NAN;
        else
            map.t[i - 9] = -INFINITY;
        CHECK_STATUS(batten_curve_transform(curve, &map, &none), BATTEN_NOT_FINITE);
    }
    CHECK_STATUS(batten_curve_to_dimension(curve, 0, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_to_dimension(curve, 4, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_set_domain(curve, NAN, 1, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_set_domain(curve, 0, INFINITY, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_set_domain(curve, 1, 1, &none), BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
    batten_curve_unref(curve);
}

TEST(a_rational_curve_keeps_its_points_under_a_moebius_map)
{
    const double points[] = {0, 1, 3, 2}, weights[] = {1, 3, 0.5, 2},
                 knots[] = {0, 0, 0, 0.25, 1, 1, 1};
    batten_curve *curve = NULL, *moved = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 4, points}, 2, weights, knots, &curve));
    CHECK_OK(batten_curve_moebius(curve, 2, 1, 0.5, 1, &moved));
    for (int i = 0; i <= 64; i++) {
        const double u = i / 64.0;
        double here, there;
        CHECK_OK(batten_curve_evaluate(curve, u, 0, &here));
        CHECK_OK(batten_curve_evaluate(moved, (2 * u + 1) / (0.5 * u + 1), 0, &there));
        CHECK_NEAR(there, here, 1e-14);
    }
    batten_curve_unref(moved);
    batten_curve_unref(curve);
}

TEST(a_curve_in_a_plane_across_an_axis_is_flattened_with_its_weights_and_period)
{
    const double points[4][3] = {{5, 1, 2}, {5, 3, 2}, {5, 4, 6}, {5, 0, 7}};
    const double weights[4] = {1, 2, 1, 3}, knots[5] = {0, 1, 2, 3, 4};
    batten_curve *curve = NULL, *flat = NULL, *same = NULL;
    int axis = 7;
    CHECK_OK(batten_curve_create_periodic((batten_points){3, 4, &points[0][0]}, 2, weights,
                                          knots, &curve));
    CHECK_OK(batten_curve_flatten(curve, &axis, &flat));
    CHECK_INT(axis, 0);
    CHECK_INT(batten_curve_dimension(flat), 2);
    CHECK(batten_curve_is_periodic(flat) && batten_curve_is_rational(flat));
    const batten_frame frame = batten_frame_across(axis, 5);
    const batten_vec3 y = bat_vec3_cross(frame.z, frame.x);
    for (int i = 0; i <= 8; i++) {
        double p[3], q[2];
        CHECK_OK(batten_curve_evaluate(curve, i / 2.0, 0, p));
        CHECK_OK(batten_curve_evaluate(flat, i / 2.0, 0, q));
        CHECK_NEAR(frame.origin.x + q[0] * frame.x.x + q[1] * y.x, p[0], 1e-14);
        CHECK_NEAR(frame.origin.y + q[0] * frame.x.y + q[1] * y.y, p[1], 1e-14);
        CHECK_NEAR(frame.origin.z + q[0] * frame.x.z + q[1] * y.z, p[2], 1e-14);
    }
    CHECK_OK(batten_curve_flatten(flat, &axis, &same));
    CHECK_INT(axis, -1);
    CHECK(same == flat);
    batten_curve_unref(same);
    batten_curve_unref(flat);
    batten_curve_unref(curve);
}
