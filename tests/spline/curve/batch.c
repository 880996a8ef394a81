#include <batten/curve.h>

#include "support/generate.h"

#include <stdlib.h>

enum { POINTS = 200 };

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void check_batch(test_random *random, const batten_curve *curve, bool sorted, int order)
{
    const int size = (order + 1) * batten_curve_dimension(curve);
    double u[POINTS], out[POINTS * 5 * 3], one[5 * 3];
    for (int i = 0; i < POINTS; i++)
        u[i] = test_parameter(random, curve);
    if (sorted)
        qsort(u, POINTS, sizeof *u, by_value);
    CHECK_OK(batten_curve_evaluate_many(curve, POINTS, u, order, NULL, out));
    for (int i = 0; i < POINTS; i++) {
        CHECK_OK(batten_curve_evaluate(curve, u[i], order, one));
        for (int k = 0; k < size; k++)
            CHECK_BITS(out[i * size + k], one[k]);
    }
}

TEST(a_batch_has_the_bits_of_single_calls)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(400); i++) {
        /* Every second one a cubic, which has loops of its own. */
        const test_wish wish = {.tame = i % 8 != 0, .degree = i % 2 ? 3 : 0};
        batten_curve *curve =
            i % 5 ? test_curve(&random, &wish) : test_periodic_curve(&random, &wish);
        const batten_interval domain = batten_curve_domain(curve);
        const int order = wish.tame ? i % 5 : 0;
        if (domain.b - domain.a < 1e300)
            check_batch(&random, curve, i % 3 == 0, order);
        batten_curve_unref(curve);
    }
}

TEST(N2_batches_of_cubics_report_overflow_and_bad_parameters)
{
    const double points[] = {1.7e308, -1.7e308, 1.7e308, 1}, knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    const double u[] = {0.5, 0.75, 0.25, -1};
    double out[12];
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 4, points}, 3, NULL, knots, &curve));
    CHECK_STATUS(batten_curve_evaluate_many(curve, 3, u, 2, NULL, out), BATTEN_OVERFLOW);
    CHECK_OK(batten_curve_evaluate_many(curve, 3, u, 0, NULL, out));
    CHECK_STATUS(batten_curve_evaluate_many(curve, 4, u, 0, NULL, out), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("parameter 4 of the batch");
    batten_curve_unref(curve);
}

TEST(a_batch_too_small_for_pieces_has_the_same_bits)
{
    test_random random = test_random_begin(__func__);
    const test_wish wish = {.tame = true, .degree = 3, .most_points = 100};
    batten_curve *curve = test_curve(&random, &wish);
    const double u = test_parameter(&random, curve);
    double one[9], batch[9];
    CHECK_OK(batten_curve_evaluate_many(curve, 1, &u, 2, NULL, batch));
    CHECK_OK(batten_curve_evaluate(curve, u, 2, one));
    for (int k = 0; k < 3 * batten_curve_dimension(curve); k++)
        CHECK_BITS(batch[k], one[k]);
    batten_curve_unref(curve);
}

/* Cubics have loops of their own for each dimension, with and without weights; beside a narrow
 * span the derivatives are made another way. */
TEST(cubics_of_every_kind_have_the_bits_of_single_calls)
{
    test_random random = test_random_begin(__func__);
    const double knots[2][9] = {{0, 0, 0, 0, 0.5, 1, 1, 1, 1},
                                {0, 0, 0, 0, 1 - 1e-7, 1, 1, 1, 1}};
    for (int i = 0; i < 12; i++) {
        const int d = i % 3 + 1;
        double points[15], weights[5];
        for (int k = 0; k < 5 * d; k++)
            points[k] = test_random_in(&random, -1, 1);
        for (int k = 0; k < 5; k++)
            weights[k] = test_random_in(&random, 0.5, 2);
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_create((batten_points){d, 5, points}, 3,
                                     i / 3 % 2 ? weights : NULL, knots[i / 6], &curve));
        for (int order = 0; order <= 3; order++)
            check_batch(&random, curve, true, order);
        batten_curve_unref(curve);
    }
}
