#include "spline/curve/product.h"

#include "support/generate.h"

/* A spline of this degree over [a, b] with one knot inside, where `at` tells. */
static batten_curve *spline(int dimension, int degree, double a, double b, double at, int seed)
{
    double knots[2 * 8 + 1], points[3 * 9];
    int count = 0;
    for (int i = 0; i <= degree; i++)
        knots[count++] = a;
    knots[count++] = a + at * (b - a);
    for (int i = 0; i <= degree; i++)
        knots[count++] = b;
    for (int i = 0; i < (degree + 2) * dimension; i++)
        points[i] = sin(1.7 * (i + seed)) + 0.3;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){dimension, degree + 2, points}, degree, NULL,
                                 knots, &curve));
    return curve;
}

TEST(a_product_is_the_product_at_every_parameter)
{
    for (int p = 1; p <= 3; p++)
        for (int q = 1; q <= 4; q++) {
            batten_curve *scalar = spline(1, p, 2, 5, 0.3, p),
                         *curve = spline(3, q, 2, 5, q % 2 ? 0.3 : 0.7, q), *product = NULL;
            CHECK_OK(bat_curve_product(scalar, curve, &product));
            CHECK_INT(batten_curve_degree(product), p + q);
            for (int i = 0; i <= 40; i++) {
                const double t = i < 40 ? 2 + 3 * i / 40.0 : 5;
                double f, c[3], both[3];
                CHECK_OK(batten_curve_evaluate(scalar, t, 0, &f));
                CHECK_OK(batten_curve_evaluate(curve, t, 0, c));
                CHECK_OK(batten_curve_evaluate(product, t, 0, both));
                for (int k = 0; k < 3; k++)
                    CHECK_NEAR(both[k], f * c[k], 1e-13);
            }
            batten_curve_unref(scalar);
            batten_curve_unref(curve);
            batten_curve_unref(product);
        }
}

TEST(a_product_of_too_high_a_degree_is_refused)
{
    double points[21], knots[42];
    batten_curve *high = NULL, *scalar = spline(1, 6, 0, 1, 0.5, 1), *product = NULL;
    for (int i = 0; i < 42; i++)
        knots[i] = i < 21 ? 0 : 1;
    for (int i = 0; i < 21; i++)
        points[i] = i;
    CHECK_OK(batten_curve_create((batten_points){1, 21, points}, 20, NULL, knots, &high));
    CHECK_STATUS(bat_curve_product(scalar, high, &product), BATTEN_BAD_DEGREE);
    CHECK_MESSAGE("degrees 6 and 20");
    batten_curve_unref(high);
    batten_curve_unref(scalar);
}

TEST(products_have_the_breaks_of_both_and_take_loose_ends)
{
    /* Loose knots over [0, 3], breaks at 1 and 2, by one with breaks at 1 and 1.5. */
    const double loose[8] = {-1, -0.5, 0, 1, 2, 3, 3.5, 4}, f[5] = {1, -2, 3, 0, 2};
    const double tight[8] = {0, 0, 0, 1, 1.5, 3, 3, 3},
                 at[10] = {0, 1, 2, -1, 1, 1, 0, 3, 2, 2};
    batten_curve *scalar = NULL, *curve = NULL, *product = NULL;
    double breaks[8];
    CHECK_OK(batten_curve_create((batten_points){1, 5, f}, 2, NULL, loose, &scalar));
    CHECK_OK(batten_curve_create((batten_points){2, 5, at}, 2, NULL, tight, &curve));
    CHECK_OK(bat_curve_product(scalar, curve, &product));
    CHECK_INT(batten_curve_spans(product, breaks), 5);
    const double expected[5] = {0, 1, 1.5, 2, 3};
    for (int i = 0; i < 5; i++)
        CHECK_NEAR(breaks[i], expected[i], 0);
    for (int i = 0; i <= 60; i++) {
        double g, c[2], both[2];
        CHECK_OK(batten_curve_evaluate(scalar, i / 20.0, 0, &g));
        CHECK_OK(batten_curve_evaluate(curve, i / 20.0, 0, c));
        CHECK_OK(batten_curve_evaluate(product, i / 20.0, 0, both));
        for (int k = 0; k < 2; k++)
            CHECK_NEAR(both[k], g * c[k], 1e-13);
    }
    batten_curve_unref(scalar);
    batten_curve_unref(curve);
    batten_curve_unref(product);
}

TEST(breaks_apart_by_rounding_are_one)
{
    batten_curve *scalar = spline(1, 2, 0, 1, 0.1 + 0.2, 3),
                 *curve = spline(2, 2, 0, 1, 0.3, 5), *product = NULL;
    CHECK_OK(bat_curve_product(scalar, curve, &product));
    CHECK_INT(batten_curve_spans(product, NULL), 3);
    batten_curve_unref(scalar);
    batten_curve_unref(curve);
    batten_curve_unref(product);
}
