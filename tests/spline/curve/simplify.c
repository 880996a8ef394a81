#include <batten/curve.h>

#include "support/generate.h"

static const test_wish any = {0}, tame = {.tame = true};

/* The largest distance of two curves of one domain at many parameters. */
static double distance(test_random *random, const batten_curve *a, const batten_curve *b)
{
    double largest = 0;
    for (int i = 0; i < 50; i++) {
        const double u = test_parameter(random, a);
        largest = fmax(largest, test_curve_distance(a, u, b, u, 1));
    }
    return largest;
}

TEST(a_knot_inserted_and_removed_leaves_the_curve)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(500); i++) {
        batten_curve *curve = test_curve(&random, &tame), *refined = NULL, *back = NULL;
        const batten_interval domain = batten_curve_domain(curve);
        const double u = domain.a + test_random_in(&random, 0.01, 0.99) * (domain.b - domain.a);
        const int p = batten_curve_degree(curve), d = batten_curve_dimension(curve);
        int removed = -1;
        double error = -1;
        CHECK_OK(batten_curve_insert_knot(curve, u, 1, &refined));
        CHECK_OK(batten_curve_remove_knot(refined, (batten_knot){u, 1}, 1e-7, &removed, &error,
                                          &back));
        CHECK_INT(removed, 1);
        CHECK(error >= 0 && error <= 1e-7);
        CHECK_INT(batten_curve_point_count(back), batten_curve_point_count(curve));
        if (p <= 5)
            for (int k = 0; k < batten_curve_point_count(curve) * d; k++)
                CHECK_NEAR(batten_curve_points(back)[k], batten_curve_points(curve)[k], 1e-6);
        CHECK(distance(&random, curve, back) <= error + 1e-14 * p);
        batten_curve_unref(back);
        batten_curve_unref(refined);
        batten_curve_unref(curve);
    }
}

TEST(removal_keeps_its_bound)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(500); i++) {
        batten_curve *curve =
                         i % 5 ? test_curve(&random, &any) : test_periodic_curve(&random, &any),
                     *thin = NULL;
        const double size = test_curve_size(curve),
                     tolerance = size * test_random_in(&random, 0, 0.5);
        int removed = -1;
        double error = -1;
        const batten_status status =
            batten_curve_remove_knots(curve, tolerance, &removed, &error, &thin);
        CHECK(status == BATTEN_OK || status == BATTEN_BAD_WEIGHT ||
              status == BATTEN_OUT_OF_MEMORY);
        if (status == BATTEN_OK) {
            CHECK(error <= tolerance);
            CHECK(distance(&random, curve, thin) <=
                  error + 32 * batten_curve_degree(curve) * DBL_EPSILON * size);
        }
        batten_curve_unref(thin);
        batten_curve_unref(curve);
    }
}

TEST(all_knots_of_a_refined_polynomial_go)
{
    test_random random = test_random_begin(__func__);
    for (int p = 1; p <= 5; p++) {
        const test_wish bezier = {
            .tame = true, .degree = p, .most_points = p + 1, .clamped = TEST_ALWAYS};
        batten_curve *curve = test_curve(&random, &bezier), *refined = NULL, *thin = NULL;
        const batten_interval domain = batten_curve_domain(curve);
        double knots[100];
        for (int i = 0; i < 100; i++)
            knots[i] = domain.a + (i + 1) / 101.0 * (domain.b - domain.a);
        CHECK_OK(batten_curve_refine(curve, 100, knots, &refined));
        int removed;
        CHECK_OK(batten_curve_remove_knots(refined, 1e-6, &removed, NULL, &thin));
        CHECK_INT(removed, 100);
        CHECK(distance(&random, curve, thin) < 1e-6);
        batten_curve_unref(thin);
        batten_curve_unref(refined);
        batten_curve_unref(curve);
    }
}

TEST(a_knot_that_matters_stays)
{
    const double points[] = {0, 0, 1, 1, 2, 0}, knots[] = {0, 0, 1, 2, 2};
    batten_curve *curve = NULL, *same = NULL;
    int removed = -1;
    double error = -1;
    CHECK_OK(batten_curve_create((batten_points){2, 3, points}, 1, NULL, knots, &curve));
    CHECK_OK(
        batten_curve_remove_knot(curve, (batten_knot){1, 1}, 0.5, &removed, &error, &same));
    CHECK_INT(removed, 0);
    CHECK_BITS(error, 0);
    CHECK_INT(batten_curve_point_count(same), 3);
    batten_curve_unref(same);
    CHECK_OK(
        batten_curve_remove_knot(curve, (batten_knot){1, 1}, 1.5, &removed, &error, &same));
    CHECK_INT(removed, 1);
    CHECK_NEAR(error, 1, 1e-15); /* the middle comes down from (1, 1) to (1, 0) */
    batten_curve_unref(same);
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_remove_knot(curve, (batten_knot){0.5, 1}, 1, NULL, NULL, &none),
                 BATTEN_NOT_FOUND);
    CHECK_STATUS(batten_curve_remove_knot(curve, (batten_knot){0, 1}, 1, NULL, NULL, &none),
                 BATTEN_NOT_FOUND);
    CHECK_STATUS(batten_curve_remove_knot(curve, (batten_knot){NAN, 1}, 1, NULL, NULL, &none),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_remove_knot(curve, (batten_knot){1, -1}, 1, NULL, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_remove_knot(curve, (batten_knot){1, 1}, -1, NULL, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_remove_knots(curve, NAN, NULL, NULL, &none), BATTEN_NOT_FINITE);
    batten_curve_unref(curve);
}

TEST(reducing_an_elevated_curve_restores_it)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(300); i++) {
        batten_curve *curve = test_curve(&random, &tame), *clamped = NULL, *elevated = NULL,
                     *back = NULL;
        const int p = batten_curve_degree(curve), d = batten_curve_dimension(curve);
        const int by = test_random_int(&random, 0, 25 - p < 3 ? 25 - p : 3);
        double error = -1;
        CHECK_OK(batten_curve_clamp(curve, &clamped));
        CHECK_OK(batten_curve_elevate(clamped, by, &elevated));
        CHECK_OK(batten_curve_reduce(elevated, p, 1e-9, &error, &back));
        CHECK_INT(batten_curve_degree(back), p);
        CHECK_INT(batten_curve_point_count(back), batten_curve_point_count(clamped));
        for (int k = 0; k < batten_curve_point_count(back) * d; k++)
            CHECK_NEAR(batten_curve_points(back)[k], batten_curve_points(clamped)[k], 1e-9);
        batten_curve_unref(back);
        batten_curve_unref(elevated);
        batten_curve_unref(clamped);
        batten_curve_unref(curve);
    }
}

TEST(a_reduced_curve_keeps_its_ends_and_its_bound)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(300); i++) {
        batten_curve *curve =
                         i % 5 ? test_curve(&random, &any) : test_periodic_curve(&random, &any),
                     *low = NULL;
        const batten_interval domain = batten_curve_domain(curve);
        const int p = batten_curve_degree(curve), q = test_random_int(&random, 1, p);
        const double size = test_curve_size(curve);
        double error = -1;
        const batten_status status = batten_curve_reduce(curve, q, 1e4 * size, &error, &low);
        CHECK(status == BATTEN_OK || status == BATTEN_BAD_WEIGHT ||
              status == BATTEN_OUT_OF_MEMORY || status == BATTEN_TOLERANCE_NOT_MET);
        if (status == BATTEN_OK) {
            CHECK_NEAR(test_curve_distance(curve, domain.a, low, domain.a, size), 0,
                       32 * p * DBL_EPSILON);
            CHECK_NEAR(test_curve_distance(curve, domain.b, low, domain.b, size), 0,
                       32 * p * DBL_EPSILON);
            CHECK(distance(&random, curve, low) <= error + 32 * p * DBL_EPSILON * size);
        }
        batten_curve_unref(low);
        batten_curve_unref(curve);
    }
}

TEST(what_cannot_be_reduced_is_refused_with_the_error)
{
    const double points[] = {0, 0, 1, 4, 2, 0}, knots[] = {0, 0, 0, 1, 1, 1};
    batten_curve *curve = NULL, *none = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 3, points}, 2, NULL, knots, &curve));
    CHECK_STATUS(batten_curve_reduce(curve, 1, 0.1, NULL, &none), BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("reduced to degree 1, it moves by up to 4");
    CHECK_STATUS(batten_curve_reduce(curve, 0, 0.1, NULL, &none), BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_curve_reduce(curve, 3, 0.1, NULL, &none), BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_curve_reduce(curve, 1, -0.1, NULL, &none), BATTEN_BAD_ARGUMENT);
    batten_curve_unref(curve);
}

TEST(what_cannot_be_removed_is_refused)
{
    const double points[] = {0, 1, 3, 2}, knots[] = {0, 0, 0, 0.5, 1, 1, 1},
                 bad[] = {-1, NAN, INFINITY};
    const double absent[] = {0, 1, 0.25, -3, 7};
    batten_curve *curve = NULL, *none = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 4, points}, 2, NULL, knots, &curve));
    for (int i = 0; i < COUNT(absent); i++)
        CHECK_STATUS(
            batten_curve_remove_knot(curve, (batten_knot){absent[i], 1}, 1, NULL, NULL, &none),
            BATTEN_NOT_FOUND);
    CHECK_STATUS(batten_curve_remove_knot(curve, (batten_knot){NAN, 1}, 1, NULL, NULL, &none),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_remove_knot(curve, (batten_knot){0.5, -1}, 1, NULL, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    for (int i = 0; i < COUNT(bad); i++) {
        const batten_status status = i == 0 ? BATTEN_BAD_ARGUMENT : BATTEN_NOT_FINITE;
        CHECK_STATUS(
            batten_curve_remove_knot(curve, (batten_knot){0.5, 1}, bad[i], NULL, NULL, &none),
            status);
        CHECK_STATUS(batten_curve_join(curve, curve, bad[i], &none), BATTEN_BAD_ARGUMENT);
    }
    CHECK(none == NULL);
    batten_curve_unref(curve);
}
