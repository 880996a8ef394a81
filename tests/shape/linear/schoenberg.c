#include <batten/polygon.h>

#include "support/generate.h"
#include "support/test.h"

enum { MANY = 40 };

static batten_curve_schoenberg_options given(const double *parameters, int degree)
{
    batten_curve_schoenberg_options options = batten_curve_schoenberg_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = parameters;
    options.degree = degree;
    return options;
}

static void uneven(test_random *random, int count, double *t)
{
    t[0] = test_random_in(random, -1, 1);
    for (int i = 1; i < count; i++)
        t[i] = t[i - 1] + test_random_in(random, 0.1, 0.5);
}

static double at(const batten_curve *curve, double u)
{
    double value;
    CHECK_OK(batten_curve_evaluate(curve, u, 0, &value));
    return value;
}

/* ---- Schoenberg ---- */

TEST(schoenbergs_spline_keeps_lines_and_ends)
{
    test_random random = test_random_begin("lines");
    double t[MANY], y[MANY];
    for (int degree = 1; degree <= 25; degree++)
        for (int n = 2; n <= MANY; n += 19) {
            uneven(&random, n, t);
            for (int i = 0; i < n; i++)
                y[i] = 3 - 2 * t[i];
            const batten_curve_schoenberg_options options = given(t, degree);
            batten_curve_schoenberg_report report;
            batten_curve *curve = NULL;
            CHECK_OK(batten_curve_schoenberg((batten_points){1, n, y}, &options, NULL, &report,
                                             &curve));
            CHECK(report.error < 1e-13);
            CHECK_INT(batten_curve_degree(curve), degree < n ? degree : n - 1);
            CHECK_BITS(at(curve, t[0]), y[0]);
            CHECK_BITS(at(curve, t[n - 1]), y[n - 1]);
            batten_curve_unref(curve);
        }
}

static int changes_of_sign(int count, const double *values)
{
    int changes = 0;
    double last = 0;
    for (int i = 0; i < count; i++) {
        if (values[i] == 0)
            continue;
        changes += last * values[i] < 0;
        last = values[i];
    }
    return changes;
}

TEST(schoenbergs_spline_crosses_no_line_more_often_than_the_polyline)
{
    test_random random = test_random_begin("crossings");
    double q[2 * MANY], off[MANY], along[1001];
    for (int c = 0; c < test_cases(40); c++) {
        const int n = 5 + c % 30;
        for (int i = 0; i < 2 * n; i++)
            q[i] = test_random_in(&random, -1, 1);
        batten_curve_schoenberg_options options = batten_curve_schoenberg_defaults();
        options.degree = 1 + c % 6;
        options.bernstein = c % 7 == 0;
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_schoenberg((batten_points){2, n, q}, &options, NULL, NULL, &curve));
        const batten_interval domain = batten_curve_domain(curve);
        for (int l = 0; l < 20; l++) {
            const double a = test_random_in(&random, -1, 1), b = test_random_in(&random, -1, 1),
                         d = test_random_in(&random, -0.7, 0.7);
            for (int i = 0; i < n; i++)
                off[i] = a * q[2 * i] + b * q[2 * i + 1] - d;
            for (int i = 0; i <= 1000; i++) {
                double p[2];
                CHECK_OK(batten_curve_evaluate(
                    curve, domain.a + (domain.b - domain.a) * i / 1000, 0, p));
                along[i] = a * p[0] + b * p[1] - d;
            }
            CHECK(changes_of_sign(1001, along) <= changes_of_sign(n, off));
        }
        batten_curve_unref(curve);
    }
}

static batten_status exponential(void *user, double u, int order, double *out)
{
    const double rate = *(const double *)user;
    for (int k = 0; k <= order; k++)
        out[k] = pow(rate, k) * exp(rate * u);
    return BATTEN_OK;
}

TEST(bernsteins_polynomials_of_an_exponential_are_known)
{
    /* B_n exp(r x) = (1 + (exp(r / n) - 1) x)^n. */
    double rate = 2;
    for (int n = 1; n <= 25; n++) {
        double knots[52];
        for (int i = 0; i <= 2 * n + 1; i++)
            knots[i] = i > n;
        batten_curve_schoenberg_report report;
        batten_curve *curve = NULL;
        CHECK_OK(batten_function_schoenberg(1, &(batten_axis){n, n + 1, knots, false},
                                            exponential, &rate, &report, &curve));
        double most = 0;
        for (int i = 0; i <= 8; i++) {
            const double x = i / 8.0, known = pow(1 + expm1(rate / n) * x, n);
            CHECK_NEAR(at(curve, x), known, 1e-14 * known);
            most = fmax(most, known - exp(rate * x));
        }
        CHECK_NEAR(report.error, most, 1e-13);
        batten_curve_unref(curve);
    }
}

TEST(schoenbergs_spline_of_a_convex_function_is_convex)
{
    double rate = -3, knots[30];
    for (int degree = 2; degree <= 5; degree++) {
        const int n = 24;
        for (int i = 0; i <= n + degree; i++) {
            const int j = i <= degree ? 0 : i >= n ? n - degree : i - degree;
            knots[i] = j * j / 100.0;
        }
        batten_curve *curve = NULL;
        batten_curve_schoenberg_report report;
        CHECK_OK(batten_function_schoenberg(1, &(batten_axis){degree, n, knots, false},
                                            exponential, &rate, &report, &curve));
        CHECK(report.error > 0 && report.error < 0.1);
        for (int i = 0; i <= 500; i++) {
            double p[3];
            CHECK_OK(batten_curve_evaluate(curve, knots[n] * i / 500, 2, p));
            CHECK(p[2] > 0 && p[1] < 0);
        }
        batten_curve_unref(curve);
    }
}

/* ---- quasi-interpolants ---- */

TEST(the_uniform_cubic_quasi_interpolant_has_the_known_weights)
{
    test_random random = test_random_begin("weights");
    double t[20], y[20];
    for (int i = 0; i < 20; i++) {
        t[i] = i;
        y[i] = test_random_in(&random, -1, 1);
    }
    const batten_curve_schoenberg_options options = given(t, 3);
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_quasi_interpolate((batten_points){1, 20, y}, &options, NULL, NULL,
                                            &curve));
    const double *c = batten_curve_points(curve);
    CHECK_INT(batten_curve_point_count(curve), 22);
    for (int i = 2; i < 18; i++) /* control point i + 1 stands over datum i */
        CHECK_NEAR(c[i + 1], (-y[i - 1] + 8 * y[i] - y[i + 1]) / 6, 1e-14);
    CHECK_NEAR(c[0], y[0], 1e-15);
    CHECK_NEAR(c[21], y[19], 1e-15);
    batten_curve_unref(curve);
}

TEST(quasi_interpolants_reproduce_polynomials_of_their_degree)
{
    test_random random = test_random_begin("reproduce");
    double t[MANY], y[MANY];
    for (int degree = 1; degree <= 9; degree++)
        for (int n = degree + 1; n <= MANY; n += 7) {
            uneven(&random, n, t);
            const double middle = (t[0] + t[n - 1]) / 2, half = t[n - 1] - middle;
            for (int i = 0; i < n; i++) {
                const double x = (t[i] - middle) / half;
                y[i] = 1 - x + pow(x, degree);
            }
            const batten_curve_schoenberg_options options = given(t, degree);
            batten_curve *curve = NULL;
            CHECK_OK(batten_curve_quasi_interpolate((batten_points){1, n, y}, &options, NULL,
                                                    NULL, &curve));
            for (int i = 0; i <= 50; i++) {
                const double u = t[0] + (t[n - 1] - t[0]) * i / 50, x = (u - middle) / half;
                CHECK_NEAR(at(curve, u), 1 - x + pow(x, degree), 1e-9);
            }
            batten_curve_unref(curve);
        }
}

TEST(quasi_interpolants_have_full_order)
{
    for (int degree = 1; degree <= 6; degree++) {
        double error[2];
        for (int k = 0; k < 2; k++) {
            const int n = 41 << k;
            double t[82], y[82];
            for (int i = 0; i < n; i++) {
                t[i] = 3.0 * i / (n - 1);
                y[i] = sin(2 * t[i]);
            }
            const batten_curve_schoenberg_options options = given(t, degree);
            batten_curve *curve = NULL;
            CHECK_OK(batten_curve_quasi_interpolate((batten_points){1, n, y}, &options, NULL,
                                                    NULL, &curve));
            error[k] = 0;
            for (int i = 0; i <= 1000; i++)
                error[k] = fmax(error[k], fabs(at(curve, 0.003 * i) - sin(0.006 * i)));
            batten_curve_unref(curve);
        }
        CHECK_NEAR(log(error[0] / error[1]) / log(81.0 / 40), degree + 1, 0.3);
    }
}

TEST(a_datum_bears_on_few_control_points)
{
    test_random random = test_random_begin("local");
    double t[MANY], y[MANY];
    for (int degree = 1; degree <= 9; degree++) {
        uneven(&random, MANY, t);
        for (int i = 0; i < MANY; i++)
            y[i] = test_random_in(&random, -1, 1);
        const batten_curve_schoenberg_options options = given(t, degree);
        batten_curve *before = NULL, *after = NULL;
        CHECK_OK(batten_curve_quasi_interpolate((batten_points){1, MANY, y}, &options, NULL,
                                                NULL, &before));
        y[20] += 1;
        CHECK_OK(batten_curve_quasi_interpolate((batten_points){1, MANY, y}, &options, NULL,
                                                NULL, &after));
        for (int i = 0; i < batten_curve_point_count(before); i++)
            if (i < 19 || i > 20 + degree)
                CHECK_BITS(batten_curve_points(after)[i], batten_curve_points(before)[i]);
        CHECK(batten_curve_points(after)[20] != batten_curve_points(before)[20]);
        batten_curve_unref(before);
        batten_curve_unref(after);
    }
}

TEST(closed_operators_go_on_over_the_seam)
{
    for (int how = 0; how < 2; how++)
        for (int degree = 2; degree <= 5; degree++)
            for (int n = 3; n <= 32; n += 29) {
                double q[64], t[33];
                for (int i = 0; i <= n; i++) {
                    const double w = 8 * atan(1) * i / n;
                    t[i] = w;
                    if (i == n)
                        break;
                    q[2 * i] = cos(w);
                    q[2 * i + 1] = sin(w);
                }
                batten_curve_schoenberg_options options = given(t, degree);
                options.closed = true;
                batten_curve_schoenberg_report report;
                batten_curve *curve = NULL;
                CHECK_OK((how == 0 ? batten_curve_schoenberg : batten_curve_quasi_interpolate)(
                    (batten_points){2, n, q}, &options, NULL, &report, &curve));
                CHECK(batten_curve_is_periodic(curve));
                /* A regular polygon gives control points on a circle. */
                const double *c = batten_curve_points(curve);
                for (int i = 1; i < batten_curve_point_count(curve); i++)
                    CHECK_NEAR(hypot(c[2 * i], c[2 * i + 1]), hypot(c[0], c[1]), 1e-12);
                if (n == 32)
                    CHECK(report.error < (how == 0 ? 0.03 : 5 * pow(0.2, degree + 1)));
                batten_curve_unref(curve);
            }
}

TEST(G10_reversed_points_give_the_reversed_operators)
{
    test_random random = test_random_begin("reversed");
    double t[12], q[24], back[12], p[24];
    uneven(&random, 12, t);
    for (int i = 0; i < 24; i++)
        q[i] = test_random_in(&random, -1, 1);
    for (int i = 0; i < 12; i++) {
        back[i] = -t[11 - i];
        p[2 * i] = q[2 * (11 - i)];
        p[2 * i + 1] = q[2 * (11 - i) + 1];
    }
    for (int how = 0; how < 2; how++)
        for (int degree = 1; degree <= 6; degree++) {
            const batten_curve_schoenberg_options one = given(t, degree),
                                                  other = given(back, degree);
            batten_curve *a = NULL, *b = NULL;
            batten_status (*const make)(batten_points, const batten_curve_schoenberg_options *,
                                        double *, batten_curve_schoenberg_report *,
                                        batten_curve **) =
                how == 0 ? batten_curve_schoenberg : batten_curve_quasi_interpolate;
            CHECK_OK(make((batten_points){2, 12, q}, &one, NULL, NULL, &a));
            CHECK_OK(make((batten_points){2, 12, p}, &other, NULL, NULL, &b));
            const int n = batten_curve_point_count(a);
            for (int i = 0; i < n; i++)
                for (int k = 0; k < 2; k++)
                    CHECK_NEAR(batten_curve_points(a)[2 * i + k],
                               batten_curve_points(b)[2 * (n - 1 - i) + k], 1e-12);
            batten_curve_unref(a);
            batten_curve_unref(b);
        }
}

/* ---- de Boor and Fix ---- */

static batten_status of_curve(void *user, double u, int order, double *out)
{
    return batten_curve_evaluate(user, u, order, out);
}

TEST(splines_on_the_knots_are_reproduced_by_de_boor_and_fix)
{
    test_random random = test_random_begin("de boor and fix");
    for (int c = 0; c < test_cases(60); c++) {
        const test_wish wish = {.rational = TEST_NEVER,
                                .clamped = TEST_ALWAYS,
                                .tame = true,
                                .degree = 1 + c % 6,
                                .most_points = 20};
        batten_curve *curve = test_curve(&random, &wish), *same = NULL;
        const int d = batten_curve_dimension(curve), n = batten_curve_point_count(curve);
        batten_curve_schoenberg_report report;
        CHECK_OK(batten_function_de_boor_fix(
            d, &(batten_axis){batten_curve_degree(curve), n, batten_curve_knots(curve), false},
            of_curve, curve, &report, &same));
        const double size = test_curve_size(curve);
        CHECK(report.error < 1e-9 * size);
        for (int i = 0; i < n * d; i++)
            CHECK_NEAR(batten_curve_points(same)[i], batten_curve_points(curve)[i],
                       1e-9 * size);
        batten_curve_unref(same);
        batten_curve_unref(curve);
    }
}

TEST(de_boor_and_fix_meet_an_exponential_with_full_order)
{
    double rate = 1.5, knots[60], error[2];
    for (int degree = 1; degree <= 5; degree++) {
        for (int k = 0; k < 2; k++) {
            const int spans = 10 << k;
            for (int i = 0; i <= spans + 2 * degree; i++)
                knots[i] = (double)(i < degree           ? 0
                                    : i > spans + degree ? spans
                                                         : i - degree) /
                           spans;
            batten_curve_schoenberg_report report;
            batten_curve *curve = NULL;
            CHECK_OK(batten_function_de_boor_fix(
                1, &(batten_axis){degree, spans + degree, knots, false}, exponential, &rate,
                &report, &curve));
            error[k] = report.error;
            batten_curve_unref(curve);
        }
        CHECK_NEAR(log2(error[0] / error[1]), degree + 1, 0.3);
    }
}

/* u^2, known from 0 to 1 alone. */
static batten_status square_of_the_unit(void *user, double u, int order, double *out)
{
    (void)user;
    const double value[3] = {u * u, 2 * u, 2};
    CHECK(u >= 0 && u <= 1);
    for (int k = 0; k <= order; k++)
        out[k] = k < 3 ? value[k] : 0;
    return BATTEN_OK;
}

TEST(functions_are_asked_within_the_domain_alone)
{
    double knots[16];
    for (int degree = 1; degree <= 5; degree++) {
        const int spans = 4, count = spans + degree;
        for (int i = 0; i <= count + degree; i++)
            knots[i] = (double)(i - degree) / spans;
        const batten_axis axis = {degree, count, knots, false};
        batten_curve *curve = NULL;
        CHECK_OK(batten_function_schoenberg(1, &axis, square_of_the_unit, NULL, NULL, &curve));
        batten_curve_unref(curve);
        CHECK_OK(batten_function_de_boor_fix(1, &axis, square_of_the_unit, NULL, NULL, &curve));
        for (int k = 0; degree >= 2 && k <= 8; k++)
            CHECK_NEAR(at(curve, k / 8.0), k / 8.0 * (k / 8.0), 1e-14);
        batten_curve_unref(curve);
    }
}

/* ---- what is refused ---- */

static batten_status fails(void *user, double u, int order, double *out)
{
    (void)user;
    for (int k = 0; k <= order; k++)
        out[k] = u > 0.5 ? NAN : 0;
    return BATTEN_OK;
}

TEST(K9_degrees_and_knots_of_operators_are_checked)
{
    const double y[6] = {0, 1, 2, 1, 0, 3}, knots[8] = {0, 0, 0, 0, 1, 1, 1, 1},
                 falling[8] = {0, 0, 0, 1, 0, 1, 1, 1};
    double rate = 1;
    batten_curve *curve = NULL;
    batten_curve_schoenberg_options options = batten_curve_schoenberg_defaults();
    for (int k = 0; k < 2; k++) {
        options.degree = k * 26;
        CHECK_STATUS(
            batten_curve_schoenberg((batten_points){1, 6, y}, &options, NULL, NULL, &curve),
            BATTEN_BAD_DEGREE);
        options.degree = k * 10;
        CHECK_STATUS(batten_curve_quasi_interpolate((batten_points){1, 6, y}, &options, NULL,
                                                    NULL, &curve),
                     BATTEN_BAD_DEGREE);
        CHECK_STATUS(batten_function_schoenberg(1, &(batten_axis){k * 26, 30, knots, false},
                                                exponential, &rate, NULL, &curve),
                     BATTEN_BAD_DEGREE);
    }
    CHECK_STATUS(batten_function_schoenberg(1, &(batten_axis){3, 3, knots, false}, exponential,
                                            &rate, NULL, &curve),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_function_schoenberg(1, &(batten_axis){3, 4, falling, false},
                                            exponential, &rate, NULL, &curve),
                 BATTEN_BAD_KNOTS);
    CHECK_STATUS(batten_function_de_boor_fix(1, &(batten_axis){3, 4, knots, false}, fails, NULL,
                                             NULL, &curve),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("the function is nan at");
    CHECK_STATUS(batten_function_de_boor_fix(4, &(batten_axis){3, 4, knots, false}, fails, NULL,
                                             NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK(curve == NULL);
}

TEST(G1_data_of_operators_are_checked)
{
    const double q[10] = {0, 0, 1, 1, 1, 1, 2, 3, 4, 4}, t[5] = {0, 1, 1, 2, 3};
    const double bad[4] = {0, NAN, 1, 2};
    batten_curve *curve = NULL;
    batten_curve_schoenberg_options options = batten_curve_schoenberg_defaults();
    CHECK_STATUS(
        batten_curve_schoenberg((batten_points){2, 5, q}, &options, NULL, NULL, &curve),
        BATTEN_COINCIDENT);
    CHECK_STATUS(
        batten_curve_schoenberg((batten_points){2, 1, q}, &options, NULL, NULL, &curve),
        BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_curve_quasi_interpolate((batten_points){2, 2, bad}, &options, NULL,
                                                NULL, &curve),
                 BATTEN_NOT_FINITE);
    options.closed = true;
    CHECK_STATUS(
        batten_curve_quasi_interpolate((batten_points){2, 2, q}, &options, NULL, NULL, &curve),
        BATTEN_TOO_FEW_POINTS);
    options.bernstein = true;
    CHECK_STATUS(
        batten_curve_schoenberg((batten_points){2, 2, q}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(
        batten_curve_quasi_interpolate((batten_points){2, 2, q}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    options = given(t, 3);
    CHECK_STATUS(
        batten_curve_quasi_interpolate((batten_points){2, 5, q}, &options, NULL, NULL, &curve),
        BATTEN_NOT_INCREASING);
    CHECK(curve == NULL);
}
