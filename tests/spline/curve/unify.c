#include <batten/curve.h>

#include "support/generate.h"

static void check_same_knots(int count, batten_curve *const *curves)
{
    for (int c = 1; c < count; c++) {
        CHECK_INT(batten_curve_degree(curves[c]), batten_curve_degree(curves[0]));
        CHECK_INT(batten_curve_knot_count(curves[c]), batten_curve_knot_count(curves[0]));
        CHECK_INT(batten_curve_is_rational(curves[c]), batten_curve_is_rational(curves[0]));
        CHECK_INT(batten_curve_is_periodic(curves[c]), batten_curve_is_periodic(curves[0]));
        for (int i = 0; i < batten_curve_knot_count(curves[0]); i++)
            CHECK_BITS(batten_curve_knots(curves[c])[i], batten_curve_knots(curves[0])[i]);
    }
}

static void unref_all(int count, batten_curve **curves)
{
    for (int i = 0; i < count; i++)
        batten_curve_unref(curves[i]);
}

enum { MANY = 5 };

static void check_unification(test_random *random, batten_curve **curves)
{
    batten_curve *made[MANY] = {NULL};
    CHECK_OK(batten_curves_unify(MANY, (const batten_curve *const *)curves, made));
    check_same_knots(MANY, made);
    CHECK_BITS(batten_curve_domain(made[0]).a, 0);
    CHECK_BITS(batten_curve_domain(made[0]).b, 1);
    for (int c = 0; c < MANY; c++) {
        const batten_interval domain = batten_curve_domain(curves[c]);
        for (int k = 0; k < 10; k++) {
            const double t = test_random_unit(random);
            const double u = fmin(domain.a + t * (domain.b - domain.a), domain.b);
            CHECK_NEAR(test_curve_distance(curves[c], u, made[c], t, 1), 0, 1e-11);
        }
    }
    unref_all(MANY, made);
}

TEST(K7_unified_curves_share_their_knots_bit_for_bit)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(200); i++) {
        const test_wish wish = {
            .tame = true, .degree = test_random_int(&random, 1, 4), .most_points = 12};
        batten_curve *curves[MANY] = {NULL};
        for (int c = 0; c < MANY; c++)
            curves[c] = i % 2 || c % 2 ? test_periodic_curve(&random, &wish)
                                       : test_curve(&random, &wish);
        check_unification(&random, curves);
        unref_all(MANY, curves);
    }
}

TEST(K7_knots_that_mean_the_same_are_made_the_same)
{
    /* Thirds of three domains: their images in [0, 1] differ in the last bits. */
    const double starts[] = {0, -5, 1e6}, lengths[] = {1, 0.7, 1};
    const double points[] = {0, 1, 0, 2, 5};
    batten_curve *curves[3] = {NULL}, *made[3] = {NULL};
    for (int c = 0; c < 3; c++) {
        double knots[8];
        for (int i = 0; i < 8; i++)
            knots[i] = starts[c] + lengths[c] * (i < 3 ? 0 : i > 4 ? 1 : (i - 2) / 3.0);
        CHECK_OK(
            batten_curve_create((batten_points){1, 5, points}, 2, NULL, knots, &curves[c]));
    }
    CHECK_OK(batten_curves_unify(3, (const batten_curve *const *)curves, made));
    check_same_knots(3, made);
    CHECK_INT(batten_curve_point_count(made[0]), 5);
    CHECK_BITS(batten_curve_knots(made[0])[3], 1 / 3.0); /* the best known of the three */
    unref_all(3, made);
    unref_all(3, curves);
}

TEST(K6_near_knots_of_one_curve_are_never_joined)
{
    const double points[] = {0, 1, 0, 2}, third[] = {0, 0, 1 / 3.0, 0.5, 1, 1};
    double near[] = {0, 0, 1 / 3.0, 1 / 3.0, 1, 1};
    near[3] = nextafter(near[2], 1);
    batten_curve *curves[2] = {NULL}, *made[2] = {NULL};
    CHECK_OK(batten_curve_create((batten_points){1, 4, points}, 1, NULL, near, &curves[0]));
    CHECK_OK(batten_curve_create((batten_points){1, 4, points}, 1, NULL, third, &curves[1]));
    CHECK_OK(batten_curves_unify(2, (const batten_curve *const *)curves, made));
    check_same_knots(2, made);
    CHECK_INT(batten_curve_point_count(made[0]), 5);
    unref_all(2, made);
    unref_all(2, curves);
}

TEST(S5_too_many_common_knots_are_refused_before_the_work)
{
    enum { CURVES = 40, POINTS = 1000 };
    double points[POINTS] = {0}, knots[POINTS + 2];
    batten_curve *curves[CURVES] = {NULL}, *made[CURVES] = {NULL};
    for (int c = 0; c < CURVES; c++) {
        for (int i = 0; i < POINTS; i++)
            knots[i + 1] = i == 0 || i == POINTS - 1 ? i : i + (c + 1) * 0.01;
        knots[0] = 0;
        knots[POINTS + 1] = knots[POINTS];
        CHECK_OK(batten_curve_create((batten_points){1, POINTS, points}, 1, NULL, knots,
                                     &curves[c]));
    }
    CHECK_STATUS(batten_curves_unify(CURVES, (const batten_curve *const *)curves, made),
                 BATTEN_TOO_LARGE);
    CHECK(made[0] == NULL);
    unref_all(CURVES, curves);
}

TEST(nothing_is_unified_to_nothing)
{
    CHECK_OK(batten_curves_unify(0, NULL, NULL));
}
