/* Rational splines in tension: their formula, their smoothness, their limits. */
#include <batten/bent.h>

#include "support/faults.h"

#include <string.h>

enum { MOST = 12 };

static void random_data(test_random *random, int d, int n, double *x, double *points)
{
    for (int i = 0; i <= n; i++)
        x[i] = (i ? x[i - 1] : 0) + test_random_in(random, 0.3, 2);
    for (int i = 0; i < n * d; i++)
        points[i] = test_random_in(random, -2, 2);
}

static batten_chain_tension_options given(const double *x, const double *tensions, int ends)
{
    static const batten_end_kind kinds[] = {BATTEN_END_NATURAL, BATTEN_END_CLAMPED,
                                            BATTEN_END_SECOND, BATTEN_END_PARABOLIC,
                                            BATTEN_END_BESSEL};
    batten_chain_tension_options o = batten_chain_tension_defaults();
    o.parameters = BATTEN_GIVEN;
    o.given = x;
    o.tensions = tensions;
    o.start = (batten_end){kinds[ends % 5], {1, -0.5, 2}};
    o.end = (batten_end){kinds[ends / 5 % 5], {-1, 3, 0.25}};
    return o;
}

static void evaluate(const batten_curve *curve, double u, batten_side side, double *out)
{
    CHECK_OK(batten_curve_evaluate_side(curve, u, side, 2, out));
}

/* u^3 / (1 + p t) */
static double fraction(double p, double t)
{
    return (1 - t) * (1 - t) * (1 - t) / (1 + p * t);
}

/* Within a span: the formula, with A to D from the points and the second derivatives at its ends. */
static void check_span(const batten_curve *curve, double a, double b, double p)
{
    const int d = batten_curve_dimension(curve);
    const double h = b - a, scale = h * h / (2 * (p * p + 3 * p + 3));
    double start[9], end[9], at[9];
    evaluate(curve, a, BATTEN_FROM_RIGHT, start);
    evaluate(curve, b, BATTEN_FROM_LEFT, end);
    for (int i = 1; i < 8; i++) {
        const double t = i / 8.0;
        evaluate(curve, a + t * h, BATTEN_FROM_RIGHT, at);
        for (int k = 0; k < d; k++) {
            const double C = scale * start[2 * d + k], D = scale * end[2 * d + k];
            const double truth = (start[k] - C) * (1 - t) + (end[k] - D) * t +
                                 C * fraction(p, t) + D * fraction(p, 1 - t);
            CHECK_NEAR(at[k], truth, 1e-12 * (1 + fabs(C) + fabs(D)));
        }
    }
}

TEST(every_span_follows_its_formula_and_second_derivatives_do_not_jump)
{
    test_random random = test_random_begin("rational tension");
    for (int c = 0; c < test_cases(40); c++) {
        const int d = 1 + c % 3, n = test_random_int(&random, 3, MOST - 1),
                  spans = n - 1 + c % 2;
        double x[MOST + 1], points[3 * MOST], tensions[MOST], parameters[MOST];
        random_data(&random, d, n, x, points);
        for (int i = 0; i < MOST; i++)
            tensions[i] = i % 4 ? pow(10, test_random_in(&random, -2, 2)) : 0;
        batten_chain_tension_options o = given(x, tensions, c);
        batten_curve *curve = NULL;
        o.closed = c % 2;
        CHECK_OK(batten_curve_rational_tension((batten_points){d, n, points}, &o, parameters,
                                               &curve));
        CHECK_INT(batten_curve_degree(curve), 4);
        CHECK(memcmp(parameters, x, (size_t)n * sizeof *x) == 0);
        for (int i = 0; i < spans; i++) {
            double left[9], right[9];
            const double b = x[i + 1];
            check_span(curve, x[i], b, tensions[i]);
            evaluate(curve, x[i], BATTEN_FROM_RIGHT, right);
            for (int k = 0; k < d; k++)
                CHECK_NEAR(right[k], points[i * d + k], 1e-14);
            if (i == 0 && !o.closed)
                continue;
            evaluate(curve, i ? x[i] : x[spans], BATTEN_FROM_LEFT, left);
            for (int k = 0; k < 3 * d; k++)
                CHECK_NEAR(left[k], right[k], 1e-9 * (1 + fabs(right[k])));
        }
        batten_curve_unref(curve);
    }
}

TEST(without_tension_it_is_the_cubic_spline_and_with_much_the_polygon)
{
    test_random random = test_random_begin("limits");
    double x[9], points[24];
    random_data(&random, 3, 8, x, points);
    batten_chain_tension_options o = given(x, NULL, 0);
    batten_curve_interpolate_options cubic = batten_curve_interpolate_defaults();
    cubic.parameters = BATTEN_GIVEN;
    cubic.given = x;
    cubic.start.kind = cubic.end.kind = BATTEN_END_NATURAL;
    batten_curve *curve = NULL, *spline = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){3, 8, points}, &cubic, NULL, &spline));
    CHECK_EACH_ALLOCATION(
        batten_curve_rational_tension((batten_points){3, 8, points}, &o, NULL, &curve));
    for (int i = 0; i <= 100; i++) {
        double p[9], q[9];
        const double u = x[0] + (x[7] - x[0]) * fmin(i / 100.0, 1 - 1e-15);
        evaluate(curve, u, BATTEN_FROM_RIGHT, p);
        evaluate(spline, u, BATTEN_FROM_RIGHT, q);
        for (int k = 0; k < 9; k++)
            CHECK_NEAR(p[k], q[k], 1e-11);
    }
    batten_curve_unref(spline);
    batten_curve_unref(curve);
    /* The bend of a span is of the size of its turns by p: ten times p, a tenth of the distance. */
    double far[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        o.tension = k ? 1e5 : 1e4;
        curve = NULL;
        CHECK_OK(
            batten_curve_rational_tension((batten_points){3, 8, points}, &o, NULL, &curve));
        for (int i = 0; i < 7; i++) {
            double p[9];
            evaluate(curve, (x[i] + x[i + 1]) / 2, BATTEN_FROM_RIGHT, p);
            for (int c = 0; c < 3; c++)
                far[k] =
                    fmax(far[k], fabs(p[c] - (points[3 * i + c] + points[3 * i + 3 + c]) / 2));
        }
        batten_curve_unref(curve);
    }
    CHECK_NEAR(far[0] / far[1], 10, 0.1);
    CHECK(far[1] < 1e-4);
}

TEST(convex_values_with_enough_tension_give_a_convex_function)
{
    static const double x[] = {0, 1, 2, 3, 4, 5, 6}, y[] = {0, 0, 0, 0.2, 3, 10, 30},
                        tensions[] = {0, 20, 20, 20, 0, 0};
    for (int tight = 0; tight < 2; tight++) {
        const batten_chain_tension_options o = given(x, tight ? tensions : NULL, 0);
        batten_curve *curve = NULL;
        int down = 0;
        CHECK_OK(batten_curve_rational_tension((batten_points){1, 7, y}, &o, NULL, &curve));
        for (int i = 0; i < 600; i++) {
            double at[3];
            evaluate(curve, i / 100.0, BATTEN_FROM_RIGHT, at);
            down += at[2] < -0.05;
        }
        CHECK(tight ? down == 0 : down > 0);
        batten_curve_unref(curve);
    }
}

TEST(maps_of_the_points_map_the_curve)
{
    test_random random = test_random_begin("maps");
    double x[9], points[24], mapped[24], tensions[8];
    random_data(&random, 3, 8, x, points);
    for (int i = 0; i < 8; i++) {
        tensions[i] = test_random_in(&random, 0, 10);
        const double *p = points + 3 * i;
        mapped[3 * i] = 2 * p[0] - p[1] + 5;
        mapped[3 * i + 1] = p[1] + 0.5 * p[2];
        mapped[3 * i + 2] = -p[2];
    }
    const batten_chain_tension_options o = given(x, tensions, 0);
    batten_curve *a = NULL, *b = NULL;
    CHECK_OK(batten_curve_rational_tension((batten_points){3, 8, points}, &o, NULL, &a));
    CHECK_OK(batten_curve_rational_tension((batten_points){3, 8, mapped}, &o, NULL, &b));
    for (int i = 0; i < 50; i++) {
        double p[9], q[9];
        const double u = x[0] + (x[7] - x[0]) * i / 50;
        evaluate(a, u, BATTEN_FROM_RIGHT, p);
        evaluate(b, u, BATTEN_FROM_RIGHT, q);
        CHECK_NEAR(q[0], 2 * p[0] - p[1] + 5, 1e-13);
        CHECK_NEAR(q[1], p[1] + 0.5 * p[2], 1e-13);
        CHECK_NEAR(q[2], -p[2], 1e-13);
    }
    batten_curve_unref(a);
    batten_curve_unref(b);
}

TEST(tensions_that_cannot_be_are_refused)
{
    static const double x[] = {0, 1, 2}, y[] = {0, 1, 0}, negative[] = {1, -1},
                        endless[] = {1, 1e7};
    batten_curve *none = NULL;
    batten_chain_tension_options o = given(x, negative, 0);
    const batten_points three = {1, 3, y};
    CHECK_STATUS(batten_curve_rational_tension(three, &o, NULL, &none), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tension of span 2 is -1");
    o = given(x, endless, 0);
    CHECK_STATUS(batten_curve_rational_tension(three, &o, NULL, &none), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("0 to 1e+06 is possible");
    o = given(x, NULL, 0);
    o.rule = BATTEN_TENSION_CONVEX;
    CHECK_STATUS(batten_curve_rational_tension(three, &o, NULL, &none), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("without a rule");
    o = given(x, NULL, 0);
    CHECK_STATUS(batten_curve_rational_tension((batten_points){1, 1, y}, &o, NULL, &none),
                 BATTEN_TOO_FEW_POINTS);
    CHECK(none == NULL);
}
