#include <batten/approximate.h>

#include "numeric/dense.h"
#include "shape/published.h"
#include "support/test.h"

enum { MOST = 200 };

static batten_curve_smooth_options by(batten_smooth_by what, double amount,
                                      const double *parameters)
{
    batten_curve_smooth_options options = batten_curve_smooth_defaults();
    options.by = what;
    options.amount = amount;
    options.parameters = parameters ? BATTEN_GIVEN : BATTEN_CHORD;
    options.given = parameters;
    return options;
}

static void uneven(test_random *random, int count, double *t, double *y, double *w)
{
    for (int i = 0; i < count; i++) {
        t[i] = (i > 0 ? t[i - 1] : -1) + test_random_in(random, 0.05, 0.4);
        y[i] = sin(t[i]) + test_random_in(random, -0.2, 0.2);
        w[i] = test_random_in(random, 0.3, 3);
    }
}

static void at_data(const batten_curve *curve, int count, const double *t, double *values)
{
    CHECK_OK(batten_curve_evaluate_many(curve, (size_t)count, t, 0, NULL, values));
}

/* Reinsch's equations as full matrices: (R + lambda Q^T W^-1 Q) M = Q^T y. */
static void reinsch(int n, const double *t, const double *y, const double *w, double lambda,
                    double *g)
{
    double *q = test_array((size_t)(n * n), 8), *a = test_array((size_t)(n * n), 8), m[MOST];
    int pivots[MOST];
    const int k = n - 2;
    for (int i = 0; i < k; i++) {
        const double h = t[i + 1] - t[i], next = t[i + 2] - t[i + 1];
        q[i * k + i] = 1 / h;
        q[(i + 1) * k + i] = -1 / h - 1 / next;
        q[(i + 2) * k + i] = 1 / next;
        a[i * k + i] = (h + next) / 3;
        if (i + 1 < k)
            a[i * k + i + 1] = a[(i + 1) * k + i] = next / 6;
    }
    for (int i = 0; i < k; i++) {
        m[i] = 0;
        for (int r = 0; r < n; r++)
            m[i] += q[r * k + i] * y[r];
        for (int j = 0; j < k; j++)
            for (int r = 0; r < n; r++)
                a[i * k + j] += lambda * q[r * k + i] * q[r * k + j] / w[r];
    }
    CHECK_OK(bat_dense_factor(k, a, pivots));
    bat_dense_solve(k, a, pivots, 1, m);
    for (int r = 0; r < n; r++) {
        g[r] = y[r];
        for (int i = 0; i < k; i++)
            g[r] -= lambda / w[r] * q[r * k + i] * m[i];
    }
}

TEST(the_cubic_smoothing_spline_is_that_of_reinschs_equations)
{
    test_random random = test_random_begin("reinsch");
    double t[40], y[40], w[40], g[40], values[40];
    for (int c = 0; c < test_cases(30); c++) {
        const int n = 3 + c;
        const double lambda = pow(10, c % 9 - 6);
        uneven(&random, n, t, y, w);
        reinsch(n, t, y, w, lambda, g);
        batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_LAMBDA, lambda, t);
        options.weights = w;
        batten_fit_report report;
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_smooth((batten_points){1, n, y}, &options, NULL, &report, &curve));
        at_data(curve, n, t, values);
        double sum = 0, moment = 0, second[3];
        for (int i = 0; i < n; i++) {
            CHECK_NEAR(values[i], g[i], 1e-9);
            sum += w[i] * (y[i] - values[i]);
            moment += w[i] * (y[i] - values[i]) * t[i];
        }
        CHECK_NEAR(sum, 0, 1e-10 * n);
        CHECK_NEAR(moment, 0, 1e-9 * n);
        CHECK_NEAR(report.p, 1 / (1 + lambda), 1e-15);
        CHECK(report.freedom > 2 - 1e-9 && report.freedom < n + 1e-9);
        for (int e = 0; e < 2; e++) { /* natural at both ends */
            CHECK_OK(batten_curve_evaluate(curve, e ? t[n - 1] : t[0], 2, second));
            CHECK_NEAR(second[2], 0, 1e-7);
        }
        batten_curve_unref(curve);
    }
}

TEST(between_its_limits_smoothing_goes_from_the_interpolant_to_the_line)
{
    test_random random = test_random_begin("smoothing limits");
    double t[30], y[30], w[30], values[30], line[30], freedom = 31;
    uneven(&random, 30, t, y, w);
    batten_curve *curve = NULL;
    batten_fit_report report;
    for (double x = -9; x < 9; x += 1) {
        batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_LAMBDA, pow(10, x), t);
        CHECK_OK(
            batten_curve_smooth((batten_points){1, 30, y}, &options, NULL, &report, &curve));
        CHECK(report.freedom < freedom);
        freedom = report.freedom;
        batten_curve_unref(curve);
    }
    CHECK_NEAR(freedom, 2, 1e-4);
    batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_LAMBDA, 0, t);
    CHECK_OK(batten_curve_smooth((batten_points){1, 30, y}, &options, NULL, &report, &curve));
    CHECK(report.error < 1e-13 && report.freedom == 30 && report.p == 1);
    batten_curve_unref(curve);
    options.amount = HUGE_VAL;
    CHECK_OK(batten_curve_smooth((batten_points){1, 30, y}, &options, NULL, &report, &curve));
    at_data(curve, 30, t, line);
    CHECK_INT(batten_curve_degree(curve), 1);
    CHECK(report.freedom == 2 && report.p == 0);
    batten_curve_unref(curve);
    options.amount = 1e9;
    CHECK_OK(batten_curve_smooth((batten_points){1, 30, y}, &options, NULL, &report, &curve));
    at_data(curve, 30, t, values);
    for (int i = 0; i < 30; i++)
        CHECK_NEAR(values[i], line[i], 1e-7);
    batten_curve_unref(curve);
}

TEST(polynomials_that_a_penalty_does_not_see_stay_as_they_are)
{
    double t[25], y[25];
    for (int c = 0; c < 24; c++) {
        const int m = 1 + c % 4;
        batten_curve_smooth_options options =
            by(BATTEN_SMOOTH_BY_LAMBDA, c / 4 == 5 ? HUGE_VAL : pow(10, 2 * (c / 4) - 4), t);
        options.order = m;
        for (int i = 0; i < 25; i++) {
            t[i] = i / 10.0 + (i % 3) / 50.0;
            y[i] = m == 1   ? 3
                   : m == 2 ? 3 - t[i]
                   : m == 3 ? 3 - t[i] * (1 - t[i])
                            : 3 - t[i] * (1 - t[i] * t[i]);
        }
        batten_fit_report report;
        for (int kind = 0; kind < 2; kind++) {
            batten_curve *curve = NULL;
            options.spans = 15;
            CHECK_OK((kind ? batten_curve_p_spline : batten_curve_smooth)(
                (batten_points){1, 25, y}, &options, NULL, &report, &curve));
            /* The derivative of order 4 of values near 10, at steps of 0.1, is lost below
             * 1e-11; the root of lambda weighs it. */
            CHECK(report.error < 1e-7);
            batten_curve_unref(curve);
        }
    }
}

TEST(p_splines_of_great_lambda_are_polynomials)
{
    test_random random = test_random_begin("p-splines");
    double t[60], y[60], w[60], a[60], b[60];
    uneven(&random, 60, t, y, w);
    for (int m = 1; m <= 4; m++) {
        batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_LAMBDA, 1e9, t);
        options.order = m;
        options.spans = 12;
        batten_curve *curve = NULL, *limit = NULL;
        CHECK_OK(
            batten_curve_p_spline((batten_points){1, 60, y}, &options, NULL, NULL, &curve));
        options.amount = HUGE_VAL;
        CHECK_OK(
            batten_curve_p_spline((batten_points){1, 60, y}, &options, NULL, NULL, &limit));
        at_data(curve, 60, t, a);
        at_data(limit, 60, t, b);
        for (int i = 0; i < 60; i++)
            CHECK_NEAR(a[i], b[i], 1e-5);
        batten_curve_unref(curve);
        batten_curve_unref(limit);
    }
}

TEST(a_target_is_a_length_and_is_met)
{
    test_random random = test_random_begin("smoothing target");
    double q[120], t[60], y[60], w[60];
    uneven(&random, 60, t, y, w);
    for (int i = 0; i < 60; i++) {
        q[2 * i] = t[i];
        q[2 * i + 1] = y[i];
    }
    for (double target = 0.02; target < 0.2; target *= 2)
        for (int kind = 0; kind < 2; kind++) {
            batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_RMS, target, NULL);
            options.spans = 80;
            batten_fit_report report;
            batten_curve *curve = NULL;
            CHECK_OK((kind ? batten_curve_p_spline : batten_curve_smooth)(
                (batten_points){2, 60, q}, &options, NULL, &report, &curve));
            CHECK_NEAR(report.rms, target, 2e-8 * target);
            batten_curve_unref(curve);
        }
    batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_RMS, 100, NULL);
    batten_fit_report report;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_smooth((batten_points){2, 60, q}, &options, NULL, &report, &curve));
    CHECK_INT(batten_curve_degree(curve), 1);
    batten_curve_unref(curve);
    options.amount = 0;
    CHECK_OK(batten_curve_smooth((batten_points){2, 60, q}, &options, NULL, &report, &curve));
    CHECK(report.error < 1e-12);
    batten_curve_unref(curve);
}

static double criterion(const batten_fit_report *report, int count)
{
    return sqrt(count * report->sum) / (count - report->freedom);
}

TEST(validation_finds_its_least_and_the_size_of_the_noise)
{
    test_random random = test_random_begin("validation");
    double t[MOST], y[MOST];
    for (int i = 0; i < MOST; i++) {
        t[i] = i / 20.0;
        y[i] = sin(t[i]); /* uniform noise with a standard deviation of 0.1 */
        y[i] += test_random_in(&random, -0.1 * sqrt(3), 0.1 * sqrt(3));
    }
    for (int kind = 0; kind < 2; kind++) {
        batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_VALIDATION, 0, t);
        batten_fit_report report, other;
        batten_curve *curve = NULL;
        CHECK_OK((kind ? batten_curve_p_spline : batten_curve_smooth)(
            (batten_points){1, MOST, y}, &options, NULL, &report, &curve));
        batten_curve_unref(curve);
        CHECK(report.rms > 0.08 && report.rms < 0.12);
        CHECK(report.freedom > 5 && report.freedom < 20);
        for (int c = -1; c <= 1; c += 2) {
            options.by = BATTEN_SMOOTH_BY_LAMBDA;
            options.amount = report.lambda * (1 + 0.1 * c);
            CHECK_OK((kind ? batten_curve_p_spline : batten_curve_smooth)(
                (batten_points){1, MOST, y}, &options, NULL, &other, &curve));
            CHECK(criterion(&other, MOST) > criterion(&report, MOST));
            batten_curve_unref(curve);
        }
    }
}

TEST(a_ring_is_smoothed_alike_wherever_it_begins)
{
    test_random random = test_random_begin("smoothing ring");
    double q[80], r[80], u[41], values[80], others[80];
    for (int i = 0; i < 40; i++) {
        const double a = 2 * 3.14159265358979323846 * i / 40;
        q[2 * i] = cos(a) + test_random_in(&random, -0.05, 0.05);
        q[2 * i + 1] = sin(a) + test_random_in(&random, -0.05, 0.05);
        u[i] = i;
    }
    u[40] = 40;
    for (int i = 0; i < 80; i++)
        r[i] = q[(i + 26) % 80];
    for (int m = 1; m <= 4; m++)
        for (int kind = 0; kind < 2; kind++) {
            batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_LAMBDA, 2, u);
            options.closed = true;
            options.order = m;
            options.spans = 40;
            batten_curve *a = NULL, *b = NULL;
            batten_fit_report report, other;
            CHECK_OK((kind ? batten_curve_p_spline : batten_curve_smooth)(
                (batten_points){2, 40, q}, &options, NULL, &report, &a));
            CHECK_OK((kind ? batten_curve_p_spline : batten_curve_smooth)(
                (batten_points){2, 40, r}, &options, NULL, &other, &b));
            CHECK(batten_curve_is_periodic(a));
            CHECK_NEAR(report.freedom, other.freedom, 1e-9);
            at_data(a, 40, u, values);
            at_data(b, 40, u, others);
            double sum = 0;
            for (int i = 0; i < 80; i++) {
                CHECK_NEAR(values[(i + 26) % 80], others[i], 1e-10);
                sum += values[i] - q[i];
            }
            CHECK_NEAR(sum, 0, 1e-10);
            batten_curve_unref(a);
            batten_curve_unref(b);
        }
}

TEST(all_rules_and_orders_work_on_rings_and_lines_of_any_number_of_points)
{
    double q[20];
    for (int i = 0; i < 10; i++) {
        q[2 * i] = cos(0.7 * i) * (1 + i % 2);
        q[2 * i + 1] = sin(0.7 * i) + 0.1 * i;
    }
    for (int n = 2; n <= 10; n++)
        for (int c = 0; c < 40; c++) {
            const double amounts[] = {0, 0.01, 1, 1e6, HUGE_VAL};
            batten_curve_smooth_options options =
                by((batten_smooth_by)(c % 5 == 0 ? 0 : 1 + c / 20), amounts[c % 5], NULL);
            options.order = 1 + c / 5 % 4;
            options.closed = n > 2 && c % 2;
            batten_fit_report report;
            batten_curve *curve = NULL;
            CHECK_OK(
                batten_curve_smooth((batten_points){2, n, q}, &options, NULL, &report, &curve));
            CHECK(report.freedom < n + 1e-4 && report.freedom > 0.9);
            CHECK(isfinite(report.error));
            batten_curve_unref(curve);
        }
}

TEST(G1_points_with_one_parameter_count_as_their_mean)
{
    const double t[] = {0, 1, 1, 2, 3, 4}, y[] = {0, 1, 3, 2, 1, 0};
    const double once[] = {0, 1, 2, 3, 4}, mean[] = {0, 2, 2, 1, 0}, w[] = {1, 2, 1, 1, 1};
    for (int c = 0; c < 3; c++) {
        double a[5], b[5];
        batten_curve_smooth_options options =
            by(BATTEN_SMOOTH_BY_LAMBDA, c == 2 ? HUGE_VAL : c, t);
        batten_curve *curve = NULL, *other = NULL;
        CHECK_OK(batten_curve_smooth((batten_points){1, 6, y}, &options, NULL, NULL, &curve));
        options.given = once;
        options.weights = w;
        CHECK_OK(
            batten_curve_smooth((batten_points){1, 5, mean}, &options, NULL, NULL, &other));
        at_data(curve, 5, once, a);
        at_data(other, 5, once, b);
        for (int i = 0; i < 5; i++)
            CHECK_NEAR(a[i], b[i], 1e-12);
        batten_curve_unref(curve);
        batten_curve_unref(other);
    }
}

TEST(N1_amounts_that_are_no_numbers_are_refused_by_smoothing)
{
    const double q[] = {0, 0, 1, 1, 2, 0, 3, 1};
    batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_LAMBDA, NAN, NULL);
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_smooth((batten_points){2, 4, q}, &options, NULL, NULL, &curve),
                 BATTEN_NOT_FINITE);
    options.amount = -1;
    CHECK_STATUS(batten_curve_smooth((batten_points){2, 4, q}, &options, NULL, NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    options.amount = 1;
    options.order = 5;
    CHECK_STATUS(batten_curve_smooth((batten_points){2, 4, q}, &options, NULL, NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("order is 5");
    options.order = 2;
    options.spans = 2;
    CHECK_STATUS(batten_curve_p_spline((batten_points){2, 4, q}, &options, NULL, NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_smooth((batten_points){2, 1, q}, NULL, NULL, NULL, &curve),
                 BATTEN_TOO_FEW_POINTS);
    CHECK(curve == NULL);
}

TEST(N2_smoothing_does_not_depend_on_the_unit)
{
    const double sizes[] = {1e-9, 1, 1e9};
    double q[60], expected[60], values[60], t[30];
    for (int s = 0; s < 3; s++) {
        for (int i = 0; i < 30; i++) {
            q[2 * i] = i * sizes[s];
            q[2 * i + 1] = (sin(i / 4.0) + (i * 7 % 5) / 20.0) * sizes[s];
        }
        batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_RMS, 0.05 * sizes[s], NULL);
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_smooth((batten_points){2, 30, q}, &options, t, NULL, &curve));
        at_data(curve, 30, t, values);
        for (int i = 0; i < 60; i++) {
            if (s == 0)
                expected[i] = values[i] / sizes[0];
            CHECK_NEAR(values[i] / sizes[s], expected[i], 1e-7);
        }
        batten_curve_unref(curve);
    }
}

/* ---- published data ---- */

/* The peer puts knots where residuals are large and penalises jumps of the third derivative; we
 * put one at each datum and penalise the second derivative. So both meet the sum of squares S
 * that is asked for, with different curves; where S is large enough for no inner knots, both
 * are the same cubic. Of all curves with that sum ours bends least. */
TEST(fitpack_and_we_meet_the_same_sum_of_squares)
{
    double table[60], t[30], y[30];
    const int count = published_table("spline_data/dierckx_curfit25.csv", 2, 30, table);
    const char *text = published_text("peer_tests/scipy_smoothing.json");
    for (int i = 0; i < count; i++) {
        t[i] = table[2 * i];
        y[i] = table[2 * i + 1];
    }
    for (int c = 0; c < 4; c++) {
        double s = 0, sum = 0, U[60], C[60];
        published_array(text, "s", c, 1, &s);
        published_array(text, "fp", c, 1, &sum);
        const int knots = published_array(text, "t", c, 60, U);
        CHECK_INT(published_array(text, "c", c, 60, C), knots - 4);
        batten_fit_report report;
        batten_curve *curve = NULL;
        if (knots == 8) {
            batten_curve_least_squares_options cubic = batten_curve_least_squares_defaults();
            cubic.parameters = BATTEN_GIVEN;
            cubic.given = t;
            cubic.point_count = 4;
            CHECK_OK(batten_curve_least_squares((batten_points){1, count, y}, &cubic, NULL,
                                                &report, &curve));
            CHECK_NEAR(report.sum, sum, 1e-9);
            for (int i = 0; i < 4; i++)
                CHECK_NEAR(batten_curve_points(curve)[i], C[i], 1e-9);
        } else if (s > 0) {
            batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_RMS, sqrt(s / count), t);
            CHECK_OK(batten_curve_smooth((batten_points){1, count, y}, &options, NULL, &report,
                                         &curve));
            CHECK_NEAR(report.sum, s, 1e-6 * s);
            CHECK_NEAR(report.sum, sum, 2e-3 * s);
        }
        batten_curve_unref(curve);
    }
}

/* 133 data at 94 times. What is well known of them: about 12 degrees of freedom, and errors of
 * some 22 g. */
TEST(the_motorcycle_has_about_twelve_degrees_of_freedom)
{
    double table[300], t[150], y[150];
    const int count = published_table("spline_data/mcycle.csv", 2, 150, table);
    CHECK_INT(count, 133);
    for (int i = 0; i < count; i++) {
        t[i] = table[2 * i];
        y[i] = table[2 * i + 1];
    }
    for (int kind = 0; kind < 2; kind++) {
        batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_VALIDATION, 0, t);
        batten_fit_report report;
        batten_curve *curve = NULL;
        CHECK_OK((kind ? batten_curve_p_spline : batten_curve_smooth)(
            (batten_points){1, count, y}, &options, NULL, &report, &curve));
        CHECK(report.freedom > 11 && report.freedom < 13.5);
        CHECK(report.rms > 20 && report.rms < 24);
        batten_curve_unref(curve);
    }
}

/* ---- limits of the penalty ---- */

/* Without a weight the smoothing spline of order m passes its data, and its derivatives m to 2 m - 2 vanish at both
 * ends. */
TEST(without_a_penalty_the_spline_interpolates_and_ends_naturally)
{
    static const double t[] = {0, 1, 1.5, 2.5, 3, 4, 4.5, 6}, y[] = {1, 0, 2, -1, 0.5, 3, 1, 2};
    for (int order = 1; order <= 4; order++) {
        batten_curve_smooth_options options = by(BATTEN_SMOOTH_BY_LAMBDA, 0, t);
        batten_curve *curve = NULL;
        double values[COUNT(t)], row[8];
        options.order = order;
        CHECK_OK(
            batten_curve_smooth((batten_points){1, COUNT(t), y}, &options, NULL, NULL, &curve));
        CHECK_INT(batten_curve_degree(curve), 2 * order - 1);
        at_data(curve, COUNT(t), t, values);
        for (int i = 0; i < COUNT(t); i++)
            CHECK_NEAR(values[i], y[i], 1e-9);
        for (int end = 0; end < 2; end++) {
            CHECK_OK(batten_curve_evaluate(curve, end ? 6 : 0, 2 * order - 2, row));
            for (int k = order; k <= 2 * order - 2; k++)
                CHECK_NEAR(row[k], 0, 1e-6);
        }
        batten_curve_unref(curve);
    }
}

/* Two parameters determine a line and no more, whatever the order and the penalty: that through the means. */
TEST(data_of_two_parameters_are_met_by_the_line_through_their_means)
{
    static const double t[] = {0, 0, 2, 2, 2}, y[] = {1, 3, 4, 6, 8};
    static const double amounts[] = {1e-3, 7, HUGE_VAL};
    for (int order = 2; order <= 3; order++)
        for (int i = 0; i < 2 * COUNT(amounts); i++) {
            batten_curve_smooth_options options =
                by(BATTEN_SMOOTH_BY_LAMBDA, amounts[i / 2], t);
            const batten_points points = {1, COUNT(t), y};
            batten_curve *curve = NULL;
            double found[2];
            options.order = order;
            CHECK_OK(i % 2 ? batten_curve_p_spline(points, &options, NULL, NULL, &curve)
                           : batten_curve_smooth(points, &options, NULL, NULL, &curve));
            CHECK_OK(batten_curve_evaluate(curve, 0, 0, &found[0]));
            CHECK_OK(batten_curve_evaluate(curve, 2, 0, &found[1]));
            CHECK_NEAR(found[0], 2, 1e-9);
            CHECK_NEAR(found[1], 6, 1e-9);
            batten_curve_unref(curve);
        }
}
