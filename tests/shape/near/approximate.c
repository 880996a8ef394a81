#include <batten/approximate.h>
#include <batten/nearest.h>

#include "shape/published.h"
#include "support/generate.h"
#include "support/test.h"

enum { MOST = 400 };

static batten_curve_least_squares_options given(const double *parameters, int point_count)
{
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = parameters;
    options.point_count = point_count;
    return options;
}

static void grid(int count, double a, double b, double *t)
{
    for (int i = 0; i < count; i++)
        t[i] = i == count - 1 ? b : a + (b - a) * i / (count - 1);
}

static void sample(const batten_curve *curve, int count, const double *t, double *points)
{
    CHECK_OK(batten_curve_evaluate_many(curve, (size_t)count, t, 0, NULL, points));
}

TEST(data_on_a_spline_of_the_same_knots_give_it_back)
{
    test_random random = test_random_begin("least squares");
    const test_wish wish = {
        .rational = TEST_NEVER, .clamped = TEST_ALWAYS, .tame = true, .most_points = 24};
    double t[MOST], q[3 * MOST];
    for (int c = 0; c < test_cases(60); c++) {
        test_wish w = wish;
        w.degree = 1 + c % 7;
        batten_curve *curve = test_curve(&random, &w), *fit = NULL;
        const int d = batten_curve_dimension(curve), n = batten_curve_point_count(curve);
        const batten_interval domain = batten_curve_domain(curve);
        grid(MOST, domain.a, domain.b, t);
        /* Every span is met: half of the data stand at Greville's abscissae. */
        for (int i = 0; i < n; i++)
            t[MOST / 2 + i] = batten_curve_greville(curve, i);
        for (int i = 1; i < MOST; i++)
            for (int k = i; k > 0 && t[k] < t[k - 1]; k--) {
                const double kept = t[k];
                t[k] = t[k - 1];
                t[k - 1] = kept;
            }
        sample(curve, MOST, t, q);
        batten_curve_least_squares_options options = given(t, n);
        options.degree = batten_curve_degree(curve);
        options.knots = BATTEN_KNOTS_GIVEN;
        options.given_knots = batten_curve_knots(curve);
        batten_fit_report report;
        CHECK_OK(batten_curve_least_squares((batten_points){d, MOST, q}, &options, NULL,
                                            &report, &fit));
        CHECK(report.error < 1e-11 * test_curve_size(curve));
        for (int i = 0; i < n * d; i++)
            CHECK_NEAR(batten_curve_points(fit)[i], batten_curve_points(curve)[i],
                       1e-11 * test_curve_size(curve));
        CHECK_NEAR(report.freedom, n, 1e-9 * n);
        batten_curve_unref(fit);
        batten_curve_unref(curve);
    }
}

TEST(residuals_stand_at_right_angles_to_the_basis)
{
    test_random random = test_random_begin("normal equations");
    double t[60], y[60], w[60], at[60];
    grid(60, 0, 3, t);
    for (int i = 0; i < 60; i++) {
        y[i] = test_random_in(&random, -1, 1);
        w[i] = i % 7 == 3 ? 0 : test_random_in(&random, 0.1, 2);
    }
    batten_curve_least_squares_options options = given(t, 9);
    options.weights = w;
    batten_curve *fit = NULL;
    CHECK_OK(batten_curve_least_squares((batten_points){1, 60, y}, &options, NULL, NULL, &fit));
    sample(fit, 60, t, at);
    for (int j = 0; j < 9; j++) {
        double unit[9] = {0}, sum = 0, basis[60];
        batten_curve *b = NULL;
        unit[j] = 1;
        CHECK_OK(batten_curve_create((batten_points){1, 9, unit}, 3, NULL,
                                     batten_curve_knots(fit), &b));
        sample(b, 60, t, basis);
        for (int i = 0; i < 60; i++)
            sum += w[i] * (at[i] - y[i]) * basis[i];
        CHECK_NEAR(sum, 0, 1e-13);
        batten_curve_unref(b);
    }
    batten_curve_unref(fit);
}

TEST(polynomials_of_the_degree_are_reproduced_by_every_choice_of_knots)
{
    double t[50], q[100];
    for (int i = 0; i < 50; i++) {
        t[i] = i * i / 100.0;
        q[2 * i] = 1 + t[i] * (2 - t[i] * (0.1 - 0.003 * t[i]));
        q[2 * i + 1] = t[i] * t[i] / 10 - 2;
    }
    for (int c = 0; c < 6; c++) {
        batten_curve_least_squares_options options = given(t, 12);
        options.degree = 3 + c / 2;
        options.knots = (batten_knot_choice)(c % 2);
        options.hold_start = options.hold_end = c % 2;
        batten_fit_report report;
        batten_curve *fit = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){2, 50, q}, &options, NULL, &report,
                                            &fit));
        CHECK(report.error < 1e-11);
        batten_curve_unref(fit);
    }
}

static double noisy(test_random *random, double x)
{
    return sin(x) + test_random_in(random, -0.05, 0.05);
}

TEST(more_knots_never_fit_worse)
{
    test_random random = test_random_begin("more knots");
    double t[101], y[101], knots[60];
    grid(101, 0, 6, t);
    for (int i = 0; i < 101; i++)
        y[i] = noisy(&random, t[i]);
    double before = HUGE_VAL;
    for (int spans = 1; spans <= 32; spans *= 2) {
        for (int i = 0; i < 4; i++) {
            knots[i] = 0;
            knots[spans + 3 + i] = 6;
        }
        for (int i = 1; i < spans; i++)
            knots[i + 3] = 6.0 * i / spans;
        batten_curve_least_squares_options options = given(t, spans + 3);
        options.knots = BATTEN_KNOTS_GIVEN;
        options.given_knots = knots;
        batten_fit_report report;
        batten_curve *fit = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){1, 101, y}, &options, NULL, &report,
                                            &fit));
        CHECK(report.sum <= before * (1 + 1e-12));
        before = report.sum;
        batten_curve_unref(fit);
    }
}

TEST(as_many_control_points_as_data_interpolate)
{
    test_random random = test_random_begin("interpolating fit");
    for (int c = 0; c < test_cases(40); c++) {
        const int n = 2 + c % 12, d = 1 + c % 3;
        double q[3 * 14], t[14];
        for (int i = 0; i < n; i++) {
            t[i] = i + test_random_in(&random, 0, 0.5);
            for (int k = 0; k < d; k++)
                q[i * d + k] = test_random_in(&random, -1, 1);
        }
        batten_curve_least_squares_options options = given(t, n);
        options.degree = n <= 3 ? n - 1 : 3;
        batten_fit_report report;
        batten_curve *fit = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){d, n, q}, &options, NULL, &report,
                                            &fit));
        CHECK(report.error < 1e-10);
        batten_curve_unref(fit);
    }
}

TEST(held_ends_are_met_to_the_bit)
{
    test_random random = test_random_begin("held ends");
    double q[80];
    for (int i = 0; i < 40; i++) {
        q[2 * i] = i + test_random_in(&random, 0, 0.3);
        q[2 * i + 1] = noisy(&random, i / 6.0);
    }
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    options.hold_start = options.hold_end = true;
    batten_curve *fit = NULL;
    CHECK_OK(batten_curve_least_squares((batten_points){2, 40, q}, &options, NULL, NULL, &fit));
    const double *points = batten_curve_points(fit);
    const int n = batten_curve_point_count(fit);
    for (int k = 0; k < 2; k++) {
        CHECK_BITS(points[k], q[k]);
        CHECK_BITS(points[2 * (n - 1) + k], q[78 + k]);
    }
    batten_curve_unref(fit);
}

TEST(a_periodic_fit_is_as_smooth_at_its_seam_as_elsewhere)
{
    double q[200];
    for (int i = 0; i < 100; i++) {
        const double a = 2 * 3.14159265358979323846 * i / 100;
        q[2 * i] = cos(a);
        q[2 * i + 1] = sin(a);
    }
    for (int n = 4; n <= 16; n++) {
        batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
        options.closed = true;
        options.point_count = n;
        batten_fit_report report;
        batten_curve *fit = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){2, 100, q}, &options, NULL, &report,
                                            &fit));
        CHECK(batten_curve_is_periodic(fit));
        CHECK(report.error < 4 * pow(n, -3.5)); /* O(h^4) */
        CHECK_NEAR(report.freedom, n, 1e-9);
        batten_curve_unref(fit);
    }
}

TEST(correction_of_parameters_brings_the_curve_nearer)
{
    double q[2 * 120], u[120];
    for (int i = 0; i < 120; i++) {
        const double x = i / 119.0;
        q[2 * i] = x * x * (3 - 2 * x);
        q[2 * i + 1] = sin(6 * x) / 3;
    }
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    options.point_count = 7;
    options.parameters = BATTEN_UNIFORM;
    batten_fit_report plain, corrected;
    batten_curve *fit = NULL;
    CHECK_OK(
        batten_curve_least_squares((batten_points){2, 120, q}, &options, NULL, &plain, &fit));
    batten_curve_unref(fit);
    options.corrections = 20;
    fit = NULL;
    CHECK_OK(
        batten_curve_least_squares((batten_points){2, 120, q}, &options, u, &corrected, &fit));
    CHECK(corrected.rms < plain.rms / 2);
    CHECK(corrected.rounds >= 1);
    batten_deviation deviation;
    CHECK_OK(batten_curve_deviation(fit, (batten_points){batten_curve_dimension(fit), 120, q},
                                    NULL, NULL, NULL, &deviation));
    CHECK(deviation.rms <= corrected.rms * (1 + 1e-12));
    for (int i = 1; i < 120; i++)
        CHECK(u[i] >= u[i - 1]);
    batten_curve_unref(fit);
}

TEST(every_correction_of_parameters_lowers_the_sum)
{
    test_random random = test_random_begin("hoschek");
    double q[2 * 80], w[80];
    for (int c = 0; c < test_cases(10); c++) {
        for (int i = 0; i < 80; i++) {
            const double x = i / 79.0;
            q[2 * i] = x + test_random_in(&random, -0.03, 0.03);
            q[2 * i + 1] = sin((3 + c) * x) + test_random_in(&random, -0.03, 0.03);
            w[i] = test_random_in(&random, 0.1, 4);
        }
        batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
        options.point_count = 8;
        options.weights = w;
        double before = HUGE_VAL;
        int rounds = -1;
        for (options.corrections = 0; options.corrections <= 20; options.corrections++) {
            batten_fit_report report;
            batten_curve *fit = NULL;
            CHECK_OK(batten_curve_least_squares((batten_points){2, 80, q}, &options, NULL,
                                                &report, &fit));
            CHECK(report.rounds > rounds ? report.sum < before : report.sum == before);
            before = report.sum;
            rounds = report.rounds;
            batten_curve_unref(fit);
        }
        CHECK(rounds >= 1);
    }
}

TEST(knots_by_curvature_serve_a_steep_front_better)
{
    double t[201], y[201], rms[2];
    grid(201, -1, 1, t);
    for (int i = 0; i < 201; i++)
        y[i] = tanh(30 * t[i]);
    for (int c = 0; c < 2; c++) {
        batten_curve_least_squares_options options = given(t, 20);
        options.knots = (batten_knot_choice)c;
        batten_fit_report report;
        batten_curve *fit = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){1, 201, y}, &options, NULL, &report,
                                            &fit));
        rms[c] = report.rms;
        batten_curve_unref(fit);
    }
    CHECK(rms[1] < rms[0] / 100);
}

TEST(G10_reversed_points_give_the_reversed_fit)
{
    test_random random = test_random_begin("reversed fit");
    double q[100], r[100];
    for (int i = 0; i < 50; i++) {
        q[2 * i] = i;
        q[2 * i + 1] = noisy(&random, i / 8.0);
    }
    for (int i = 0; i < 50; i++)
        for (int k = 0; k < 2; k++)
            r[2 * i + k] = q[2 * (49 - i) + k];
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    options.corrections = 0;
    options.point_count = 4; /* without inner knots, whose rule begins at one end */
    batten_curve *a = NULL, *b = NULL;
    CHECK_OK(batten_curve_least_squares((batten_points){2, 50, q}, &options, NULL, NULL, &a));
    CHECK_OK(batten_curve_least_squares((batten_points){2, 50, r}, &options, NULL, NULL, &b));
    const int n = batten_curve_point_count(a);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 2; k++)
            CHECK_NEAR(batten_curve_points(a)[2 * i + k],
                       batten_curve_points(b)[2 * (n - 1 - i) + k], 1e-11);
    batten_curve_unref(a);
    batten_curve_unref(b);
}

TEST(G9_a_control_point_without_data_is_named_by_least_squares)
{
    const double t[] = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 2, 2.1, 2.2, 3},
                 knots[] = {0, 0, 0, 0, 0.8, 1, 1.5, 1.8, 3, 3, 3, 3};
    double y[10];
    for (int i = 0; i < 10; i++)
        y[i] = 2 * t[i] + 1;
    batten_curve_least_squares_options options = given(t, 8);
    options.knots = BATTEN_KNOTS_GIVEN;
    options.given_knots = knots;
    batten_curve *fit = NULL;
    CHECK_OK(batten_curve_least_squares((batten_points){1, 10, y}, &options, NULL, NULL, &fit));
    batten_curve_unref(fit);
    fit = NULL;
    const double bad[] = {0, 0, 0, 0, 0.6, 0.8, 1, 1.2, 1.5, 3, 3, 3, 3};
    options.point_count = 9;
    options.given_knots = bad;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, 10, y}, &options, NULL, NULL, &fit),
        BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("control point 5 of 9");
    CHECK(fit == NULL);
    options.regularise = true;
    batten_fit_report report;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, 10, y}, &options, NULL, &report, &fit));
    CHECK(report.regularised);
    CHECK(report.error < 1e-4);
    batten_curve_unref(fit);
}

TEST(G1_points_that_coincide_are_data_like_others)
{
    const double q[] = {0, 0, 1, 1, 1, 1, 2, 0, 2, 0, 3, 1};
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    options.point_count = 4;
    batten_curve *fit = NULL;
    CHECK_OK(batten_curve_least_squares((batten_points){2, 6, q}, &options, NULL, NULL, &fit));
    batten_curve_unref(fit);
    fit = NULL;
    const double same[] = {1, 1, 1, 1, 1, 1, 1, 1};
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){2, 4, same}, NULL, NULL, NULL, &fit),
        BATTEN_COINCIDENT);
}

TEST(N1_what_is_not_finite_is_named_by_least_squares)
{
    double q[] = {0, 0, 1, 1, NAN, 1, 2, 0}, w[] = {1, 1, INFINITY, 1};
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    batten_curve *fit = NULL;
    CHECK_STATUS(batten_curve_least_squares((batten_points){2, 4, q}, NULL, NULL, NULL, &fit),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 1 of point 3 is nan");
    q[4] = 1.5;
    options.weights = w;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){2, 4, q}, &options, NULL, NULL, &fit),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("weight of point 3");
    w[2] = -1;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){2, 4, q}, &options, NULL, NULL, &fit),
        BATTEN_BAD_WEIGHT);
    CHECK(fit == NULL);
}

TEST(N2_fits_of_tiny_and_huge_points_are_those_of_plain_ones_scaled)
{
    const double sizes[] = {1e-300, 1e-9, 1, 1e9, 1e140};
    double q[80], expected[40];
    for (int s = 0; s < COUNT(sizes); s++) {
        batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
        options.point_count = 8;
        batten_curve *fit = NULL;
        for (int i = 0; i < 40; i++) {
            q[2 * i] = i / 10.0 * sizes[s];
            q[2 * i + 1] = sin(i / 5.0) * sizes[s];
        }
        CHECK_OK(
            batten_curve_least_squares((batten_points){2, 40, q}, &options, NULL, NULL, &fit));
        for (int i = 0; i < 16; i++) {
            const double value = batten_curve_points(fit)[i] / sizes[s];
            if (s == 0)
                expected[i] = value;
            CHECK_NEAR(value, expected[i], 1e-11);
        }
        batten_curve_unref(fit);
    }
}

TEST(G2_few_points_give_a_lower_degree_or_what_is_missing)
{
    const double q[] = {0, 0, 1, 1, 2, 0};
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    batten_curve *fit = NULL;
    CHECK_STATUS(batten_curve_least_squares((batten_points){2, 1, q}, NULL, NULL, NULL, &fit),
                 BATTEN_TOO_FEW_POINTS);
    for (int n = 2; n <= 3; n++) {
        batten_fit_report report;
        CHECK_OK(
            batten_curve_least_squares((batten_points){2, n, q}, NULL, NULL, &report, &fit));
        CHECK_INT(batten_curve_degree(fit), n - 1);
        CHECK(report.error < 1e-15);
        batten_curve_unref(fit);
        fit = NULL;
    }
    options.point_count = 4;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){2, 3, q}, &options, NULL, NULL, &fit),
        BATTEN_TOO_FEW_POINTS);
    options.point_count = 3;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){2, 3, q}, &options, NULL, NULL, &fit),
        BATTEN_TOO_FEW_POINTS);
    CHECK(fit == NULL);
}

TEST(K9_degrees_beyond_the_limits_are_refused_by_least_squares)
{
    double t[60], y[60];
    grid(60, 0, 1, t);
    for (int i = 0; i < 60; i++)
        y[i] = cos(3 * t[i]);
    for (int degree = 0; degree <= 26; degree++) {
        batten_curve_least_squares_options options = given(t, 28);
        options.degree = degree;
        batten_curve *fit = NULL;
        const batten_status expected =
            degree < 1 || degree > 25 ? BATTEN_BAD_DEGREE : BATTEN_OK;
        batten_fit_report report = {0};
        CHECK_STATUS(batten_curve_least_squares((batten_points){1, 60, y}, &options, NULL,
                                                &report, &fit),
                     expected);
        CHECK(report.error < (degree == 1 ? 1e-2 : 1e-3));
        batten_curve_unref(fit);
    }
}

TEST(parameters_that_fall_or_lie_outside_the_knots_are_named)
{
    double t[] = {0, 1, 0.5, 2, 3};
    const double y[] = {0, 1, 2, 3, 4}, knots[] = {0, 0, 2.5, 2.5};
    batten_curve_least_squares_options options = given(t, 2);
    options.degree = 1;
    batten_curve *fit = NULL;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, 5, y}, &options, NULL, NULL, &fit),
        BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("parameter 3");
    t[2] = 1.5;
    options.knots = BATTEN_KNOTS_GIVEN;
    options.given_knots = knots;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, 5, y}, &options, NULL, NULL, &fit),
        BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("point 5");
}

/* ---- published data ---- */

TEST(fitpack_fits_the_two_steep_fronts_with_the_same_coefficients)
{
    double table[60], t[30], y[30], inner[10], expected[20], sum[1] = {0}, knots[20];
    const int count = published_table("spline_data/dierckx_curfit25.csv", 2, 30, table);
    char *text = published_text("peer_tests/scipy_smoothing.json");
    const char *part = strstr(text, "\"least_squares\"");
    CHECK(part != NULL);
    const int inside = published_array(part, "interior_knots", 0, 10, inner);
    const int n = published_array(part, "c", 0, 20, expected);
    CHECK_INT(published_array(part, "sum_sq", 0, 1, sum), 1);
    for (int i = 0; i < count; i++) {
        t[i] = table[2 * i];
        y[i] = table[2 * i + 1];
    }
    for (int i = 0; i < 4; i++) {
        knots[i] = t[0];
        knots[4 + inside + i] = t[count - 1];
    }
    memcpy(knots + 4, inner, (size_t)inside * sizeof *inner);
    CHECK_INT(n, inside + 4);
    batten_curve_least_squares_options options = given(t, n);
    options.knots = BATTEN_KNOTS_GIVEN;
    options.given_knots = knots;
    batten_fit_report report;
    batten_curve *fit = NULL;
    CHECK_OK(batten_curve_least_squares((batten_points){1, count, y}, &options, NULL, &report,
                                        &fit));
    for (int i = 0; i < n; i++)
        CHECK_NEAR(batten_curve_points(fit)[i], expected[i], 1e-9);
    CHECK_NEAR(report.sum, sum[0], 1e-9);
    batten_curve_unref(fit);
}
