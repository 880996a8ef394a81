#include <batten/curve.h>

#include "support/test.h"

TEST(a_bezier_cubic_is_its_polynomial)
{
    /* The example of the notes: x = 4t^3 + 10t^2 - 30t + 2 on [0, 1] in Bernstein form. */
    const double points[] = {2, -8, -44. / 3, -14}, knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 4, points}, 3, NULL, knots, &curve));
    for (int i = 0; i <= 16; i++) {
        const double t = i / 16.0;
        double out[6];
        CHECK_OK(batten_curve_evaluate(curve, t, 5, out));
        CHECK_NEAR(out[0], ((4 * t + 10) * t - 30) * t + 2, 1e-14);
        CHECK_NEAR(out[1], (12 * t + 20) * t - 30, 1e-13);
        CHECK_NEAR(out[2], 24 * t + 20, 1e-13);
        CHECK_NEAR(out[3], 24, 1e-13);
        CHECK_BITS(out[4], 0);
        CHECK_BITS(out[5], 0);
    }
    batten_curve_unref(curve);
}

static batten_curve *small(int degree, const double *points, const double *weights, double a,
                           double b)
{
    double knots[60];
    for (int i = 0; i < 2 * degree + 2; i++)
        knots[i] = i <= degree ? a : b;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, degree + 1, points}, degree, weights, knots,
                                 &curve));
    return curve;
}

TEST(N1_N7_parameters_at_and_beyond_the_ends)
{
    const double points[] = {1, 5}, beyond = 3 + 5 * 4.440892098500626e-16;
    batten_curve *curve = small(1, points, NULL, -2, 3);
    double out = 77;
    CHECK_OK(batten_curve_evaluate(curve, nextafter(3, 4), 0, &out));
    CHECK_BITS(out, 5);
    CHECK_OK(batten_curve_evaluate(curve, nextafter(-2, -4), 0, &out));
    CHECK_BITS(out, 1);
    out = 77;
    CHECK_STATUS(batten_curve_evaluate(curve, beyond, 0, &out), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("outside the domain [-2, 3]");
    CHECK_STATUS(batten_curve_evaluate(curve, NAN, 0, &out), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_evaluate(curve, -INFINITY, 0, &out), BATTEN_NOT_FINITE);
    const double u[] = {0, 1, 3, 9}, bad[] = {0, NAN};
    double many[4];
    CHECK_OK(batten_curve_evaluate_many(curve, 3, u, 0, NULL, many));
    CHECK_BITS(many[2], 5);
    CHECK_STATUS(batten_curve_evaluate_many(curve, 4, u, 0, NULL, many), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("parameter 4 of the batch");
    CHECK_STATUS(batten_curve_evaluate_many(curve, 2, bad, 0, NULL, many), BATTEN_NOT_FINITE);
    CHECK_OK(batten_curve_evaluate_many(curve, 0, NULL, 0, NULL, NULL));
    CHECK_BITS(out, 77);
    batten_curve_unref(curve);
}

TEST(N2_what_is_too_large_is_an_overflow_and_what_is_tiny_is_right)
{
    const double huge[] = {1e300, -1e300}, tiny[] = {1e-300, 3e-300}, weights[] = {1e10, 1e-10};
    const double u[] = {0.5, 0.25};
    double out = 7, many[4];
    batten_curve *curve = small(1, huge, NULL, 0, 1e-100);
    CHECK_STATUS(batten_curve_evaluate(curve, 0, 1, &out), BATTEN_OVERFLOW);
    CHECK_BITS(out, 7);
    batten_curve_unref(curve);
    curve = small(1, huge, weights, 0, 1);
    CHECK_OK(
        batten_curve_evaluate(curve, 0.5, 0, &out)); /* weights are scaled: nothing overflows */
    CHECK_NEAR(out / 1e300, 1, 1e-15);
    batten_curve_unref(curve);
    const double largest[] = {1.7e308, -1.7e308};
    curve = small(1, largest, NULL, 0, 1);
    CHECK_STATUS(batten_curve_evaluate_many(curve, 2, u, 1, NULL, many), BATTEN_OVERFLOW);
    CHECK_MESSAGE("parameter 1 of the batch");
    CHECK_OK(batten_curve_evaluate_many(curve, 2, u, 0, NULL, many));
    CHECK_BITS(many[0], 0);
    batten_curve_unref(curve);
    curve = small(1, tiny, NULL, 0, 1);
    CHECK_OK(batten_curve_evaluate(curve, 0.5, 0, &out));
    CHECK_NEAR(out / 1e-300, 2, 1e-15);
    batten_curve_unref(curve);
}

TEST(N5_denormal_knots_and_weights_are_worked_with)
{
    const double points[] = {1, 3}, weights[] = {5e-324, 5e-324};
    double out[2];
    batten_curve *curve = small(1, points, weights, 0, 1);
    CHECK_OK(batten_curve_evaluate(curve, 0.5, 0, out));
    CHECK_BITS(out[0], 2);
    batten_curve_unref(curve);
    curve = small(1, points, NULL, 0, 1e-320);
    CHECK_OK(batten_curve_evaluate(curve, 5e-321, 0, out));
    CHECK_NEAR(out[0], 2, 0.01);
    CHECK_STATUS(batten_curve_evaluate(curve, 0, 1, out), BATTEN_OVERFLOW);
    const double u[] = {0, 1e-321, 1e-320};
    double many[3];
    CHECK_OK(batten_curve_evaluate_many(curve, 3, u, 0, NULL, many));
    CHECK_BITS(many[2], 3);
    batten_curve_unref(curve);
}

TEST(K10_sides_differ_where_the_curve_has_a_corner)
{
    const double points[] = {0, 1, 0}, knots[] = {0, 0, 1, 2, 2};
    batten_curve *curve = NULL;
    double out[2];
    CHECK_OK(batten_curve_create((batten_points){1, 3, points}, 1, NULL, knots, &curve));
    CHECK_OK(batten_curve_evaluate(curve, 1, 1, out));
    CHECK_BITS(out[1], -1);
    CHECK_OK(batten_curve_evaluate_side(curve, 1, BATTEN_FROM_LEFT, 1, out));
    CHECK_BITS(out[1], 1);
    CHECK_OK(batten_curve_evaluate(curve, 2, 1, out));
    CHECK_BITS(out[1], -1);
    CHECK_OK(batten_curve_evaluate_side(curve, 0, BATTEN_FROM_LEFT, 1, out));
    CHECK_BITS(out[1], 1);
    batten_curve_unref(curve);
}

TEST(K10_orders_above_the_degree)
{
    const double points[] = {0, 1, 4}, weights[] = {1, 2, 1};
    double out[41], u = 0.5, many[41];
    batten_curve *curve = small(2, points, NULL, 0, 1);
    CHECK_OK(batten_curve_evaluate(curve, 0.5, 40, out));
    CHECK_OK(batten_curve_evaluate_many(curve, 1, &u, 40, NULL, many));
    for (int k = 3; k <= 40; k++)
        CHECK_BITS(out[k], 0);
    for (int k = 0; k <= 40; k++)
        CHECK_BITS(out[k], many[k]);
    batten_curve_unref(curve);
    /* 1 / (1 + t) has the derivatives (-1)^k k! / (1 + t)^(k + 1), of any order. */
    const double one_over[] = {1, 0.5}, denominator[] = {1, 2};
    curve = small(1, one_over, denominator, 0, 1);
    CHECK_OK(batten_curve_evaluate(curve, 0.25, 30, out));
    double expected = 1 / 1.25;
    for (int k = 0; k <= 30; k++) {
        CHECK_NEAR(out[k] / expected, 1, 1e-13);
        expected *= -(k + 1) / 1.25;
    }
    CHECK_STATUS(batten_curve_evaluate(curve, 0.25, 40, out), BATTEN_OK);
    batten_curve_unref(curve);
    curve = small(2, points, weights, 0, 1);
    CHECK_OK(batten_curve_evaluate(curve, 0, 2, out));
    CHECK_NEAR(out[1], 2 * 2 * (1 - 0), 1e-15); /* n (w1 / w0) (b1 - b0) */
    batten_curve_unref(curve);
}

TEST(curvature_at_the_start_of_a_rational_bezier_curve_is_that_of_the_notes)
{
    /* kappa(0) = (n - 1) / n (w0 w2 / w1^2) (Delta b0 x Delta b1) / |Delta b0|^3 for n = 2, 3,
     * 4 [V]. */
    const double points[] = {0, 0, 1, 0.5, 1.5, 2, 3, 2.5, 4, 1},
                 weights[] = {1.5, 2, 0.7, 3, 1};
    for (int n = 2; n <= 4; n++) {
        double knots[10], out[6];
        for (int i = 0; i < 2 * n + 2; i++)
            knots[i] = i > n;
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_create((batten_points){2, n + 1, points}, n, weights, knots, &curve));
        CHECK_OK(batten_curve_evaluate(curve, 0, 2, out));
        const double speed = hypot(out[2], out[3]), edge = hypot(1, 0.5);
        const double kappa = (out[2] * out[5] - out[3] * out[4]) / (speed * speed * speed);
        const double expected =
            (n - 1.0) / n * (1.5 * 0.7 / 4) * (1 * 1.5 - 0.5 * 0.5) / (edge * edge * edge);
        CHECK_NEAR(kappa / expected, 1, 1e-13);
        batten_curve_unref(curve);
    }
}

TEST(the_loop_of_the_notes_meets_itself)
{
    const double breaks[] = {-5, 5};
    double c[8], at = -5;
    /* x = 4t^3 + 10t^2 - 30t + 2, y = -30t^2 - 10t + 10 in powers of (t + 5). */
    const double x0 = ((4 * at + 10) * at - 30) * at + 2, x1 = (12 * at + 20) * at - 30,
                 x2 = 12 * at + 10;
    const double coefficients[] = {x0, (-30 * at - 10) * at + 10, x1, -60 * at - 10, x2, -30, 4,
                                   0};
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_from_power(2, (batten_pieces){3, 1, breaks}, coefficients, 0, &curve));
    const double root = sqrt(33) / 2;
    for (int i = -1; i <= 1; i += 2) {
        double p[2];
        CHECK_OK(batten_curve_evaluate(curve, -1 / 6. + i * root, 0, p));
        CHECK_NEAR(p[0], 1978 / 27., 1e-11);
        CHECK_NEAR(p[1], -710 / 3., 1e-11);
    }
    CHECK_OK(batten_curve_to_power(curve, c));
    CHECK_NEAR(c[6], 4, 1e-12);
    batten_curve_unref(curve);
}

/* Uniform cubic segments of the notes, section 4. */
static void uniform(const double *vertices, int n, double u, double *out)
{
    double knots[20];
    for (int i = 0; i < n + 4; i++)
        knots[i] = i - 3;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, n, vertices}, 3, NULL, knots, &curve));
    CHECK_OK(batten_curve_evaluate(curve, u, 2, out));
    batten_curve_unref(curve);
}

TEST(uniform_cubics_behave_as_the_notes_say)
{
    const double general[] = {0, 0, 1, 2, 3, 3, 5, 1}, line[] = {0, 0, 1, 1, 3, 3, 5, 0};
    const double twice[] = {0, 0, 6, 6, 6, 6, 8, 0}, thrice[] = {6, 6, 6, 6, 6, 6, 8, 0};
    double p[6];
    uniform(general, 4, 0, p);
    for (int k = 0; k < 2; k++) {
        CHECK_NEAR(p[k], (general[k] + 4 * general[2 + k] + general[4 + k]) / 6, 1e-15);
        CHECK_NEAR(p[2 + k], (general[4 + k] - general[k]) / 2, 1e-15);
        CHECK_NEAR(p[4 + k], general[k] - 2 * general[2 + k] + general[4 + k], 4e-15);
    }
    uniform(line, 4, 0, p);
    CHECK_NEAR(p[0], p[1], 1e-15);
    CHECK_NEAR(p[2] * p[5] - p[3] * p[4], 0, 1e-14);
    uniform(twice, 4, 0, p);
    CHECK_NEAR(hypot(p[0] - 6, p[1] - 6), hypot(6, 6) / 6, 1e-14);
    CHECK_NEAR(p[2] * p[5] - p[3] * p[4], 0, 1e-13);
    uniform(thrice, 4, 0, p);
    CHECK_NEAR(p[0], 6, 1e-14);
    CHECK_NEAR(hypot(p[2], p[3]) + hypot(p[4], p[5]), 0, 1e-14);
}

TEST(N1_periodic_curves_take_any_number_but_no_other_parameter)
{
    const double points[] = {0, 2, 1}, knots[] = {1, 2, 3, 4};
    const double *const bad = (const double[]){NAN, INFINITY, -INFINITY};
    batten_curve *curve = NULL;
    double out = 7, start;
    CHECK_OK(
        batten_curve_create_periodic((batten_points){1, 3, points}, 2, NULL, knots, &curve));
    for (int i = 0; i < 3; i++)
        CHECK_STATUS(batten_curve_evaluate(curve, bad[i], 0, &out), BATTEN_NOT_FINITE);
    CHECK_BITS(out, 7);
    CHECK_OK(batten_curve_evaluate(curve, 1, 0, &start));
    for (int k = -40; k <= 40; k++) {
        CHECK_OK(batten_curve_evaluate(curve, 1 + 3.0 * k, 0, &out));
        CHECK_BITS(out, start);
    }
    /* Just below the start is just below the end; what rounding carries to the end is the
     * start. */
    CHECK_OK(batten_curve_evaluate(curve, nextafter(1, 0), 0, &out));
    CHECK_NEAR(out, start, 1e-14);
    batten_curve_unref(curve);
}
