#include <batten/approximate.h>

#include "shape/published.h"
#include "support/test.h"

enum { MANY = 120 };

static batten_curve_least_squares_options robust(batten_robust how, const double *parameters,
                                                 int count)
{
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = parameters;
    options.point_count = count;
    options.robust = how;
    return options;
}

/* A cubic with noise of `size`, and every eighth datum far off. */
static void spoilt(double size, double *t, double *y)
{
    test_random random = test_random_begin("spoilt");
    for (int i = 0; i < MANY; i++) {
        t[i] = i / (MANY - 1.0);
        y[i] = t[i] * (1 - t[i]) * (3 * t[i] - 1) + test_random_in(&random, -size, size);
        if (i % 8 == 3)
            y[i] += i % 16 == 3 ? 2 : 5;
    }
}

static double distance_to_cubic(const batten_curve *fit)
{
    double most = 0;
    for (int i = 0; i <= 100; i++) {
        const double t = i / 100.0;
        double at;
        CHECK_OK(batten_curve_evaluate(fit, t, 0, &at));
        const double off = fabs(at - t * (1 - t) * (3 * t - 1));
        most = off > most ? off : most;
    }
    return most;
}

TEST(outliers_do_not_move_a_robust_fit)
{
    double t[MANY], y[MANY], off[4];
    spoilt(0.01, t, y);
    for (int how = 0; how < 4; how++) {
        batten_curve_least_squares_options options = robust((batten_robust)how, t, 7);
        batten_fit_report report;
        batten_curve *fit = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL,
                                            &report, &fit));
        off[how] = distance_to_cubic(fit);
        CHECK(how == 0 ? report.reweightings == 0 : report.reweightings > 0);
        int outliers[MANY], count = 0;
        CHECK_OK(batten_curve_outliers(
            fit, &(batten_fit_data){{batten_curve_dimension(fit), MANY, y}, t, NULL}, 5, NULL,
            outliers, &count));
        if (how > 0) {
            CHECK_INT(count, MANY / 8);
            for (int i = 0; i < count; i++)
                CHECK_INT(outliers[i], 8 * i + 3);
        }
        batten_curve_unref(fit);
    }
    CHECK(off[BATTEN_SQUARES] > 0.3);
    CHECK(off[BATTEN_HUBER] < 0.02 && off[BATTEN_ABSOLUTE] < 0.02 && off[BATTEN_TUKEY] < 0.01);
}

TEST(absolute_distances_reproduce_what_most_data_lie_on)
{
    double t[MANY], y[MANY];
    spoilt(0, t, y);
    batten_curve_least_squares_options options = robust(BATTEN_ABSOLUTE, t, 7);
    batten_fit_report report;
    batten_curve *fit = NULL;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, &report, &fit));
    CHECK(distance_to_cubic(fit) < 1e-5);
    CHECK(report.gap < 1e-5);
    batten_curve_unref(fit);
}

/* The line of least sum of distances passes two of the data: try all pairs. */
static double best_line(int count, const double *t, const double *y)
{
    double best = HUGE_VAL;
    for (int a = 0; a < count; a++)
        for (int b = a + 1; b < count; b++) {
            double sum = 0;
            for (int i = 0; i < count; i++)
                sum += fabs(y[a] + (y[b] - y[a]) * (t[i] - t[a]) / (t[b] - t[a]) - y[i]);
            best = sum < best ? sum : best;
        }
    return best;
}

TEST(the_gap_says_how_much_an_l1_fit_can_be_bettered)
{
    test_random random = test_random_begin("gap");
    double t[20], y[20];
    for (int c = 0; c < test_cases(40); c++) {
        const int n = 3 + c % 18;
        for (int i = 0; i < n; i++) {
            t[i] = i + test_random_in(&random, 0, 0.9);
            y[i] = test_random_in(&random, -1, 1);
        }
        batten_curve_least_squares_options options = robust(BATTEN_ABSOLUTE, t, 2);
        options.degree = 1;
        batten_fit_report report;
        batten_curve *fit = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){1, n, y}, &options, NULL, &report,
                                            &fit));
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double at;
            CHECK_OK(batten_curve_evaluate(fit, t[i], 0, &at));
            sum += fabs(at - y[i]);
        }
        const double best = best_line(n, t, y);
        CHECK(sum >= best * (1 - 1e-12));
        CHECK(sum * (1 - report.gap) <= best * (1 + 1e-12));
        CHECK(report.gap < 0.1);
        batten_curve_unref(fit);
    }
}

TEST(hubers_forces_are_in_balance)
{
    double t[MANY], y[MANY];
    spoilt(0.1, t, y);
    batten_curve_least_squares_options options = robust(BATTEN_HUBER, t, 6);
    options.threshold = 0.07;
    batten_fit_report report;
    batten_curve *fit = NULL;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, &report, &fit));
    CHECK_NEAR(report.threshold, 0.07, 0);
    CHECK(report.gap <= 1e-6);
    double balance[3] = {0}; /* against 1, t, t^2, which are among the curves */
    for (int i = 0; i < MANY; i++) {
        double at;
        CHECK_OK(batten_curve_evaluate(fit, t[i], 0, &at));
        const double force = fmax(-0.07, fmin(0.07, at - y[i]));
        for (int k = 0; k < 3; k++)
            balance[k] += force * pow(t[i], k);
    }
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(balance[k], 0, 2e-3); /* a gap of 1e-6 leaves its root */
    batten_curve_unref(fit);
}

TEST(a_threshold_beyond_all_data_is_least_squares)
{
    double t[MANY], y[MANY];
    spoilt(0.1, t, y);
    batten_curve_least_squares_options options = robust(BATTEN_HUBER, t, 6);
    options.threshold = 100;
    batten_curve *fit = NULL, *plain = NULL;
    batten_fit_report report;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, &report, &fit));
    CHECK_INT(report.reweightings, 1);
    options.robust = BATTEN_SQUARES;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &plain));
    for (int i = 0; i < 6; i++)
        CHECK_BITS(batten_curve_points(fit)[i], batten_curve_points(plain)[i]);
    batten_curve_unref(fit);
    batten_curve_unref(plain);
}

TEST(robust_fits_of_curves_rings_and_conditions)
{
    double q[2 * MANY], t[MANY + 1];
    test_random random = test_random_begin("robust ring");
    for (int i = 0; i < MANY; i++) {
        const double w = 8 * atan(1) * i / MANY, r = i % 20 == 7 ? 1.6 : 1;
        t[i] = i;
        t[i + 1] = i + 1;
        q[2 * i] = r * cos(w) + test_random_in(&random, -0.01, 0.01);
        q[2 * i + 1] = r * sin(w) + test_random_in(&random, -0.01, 0.01);
    }
    for (int c = 0; c < 3; c++) {
        batten_curve_least_squares_options options = robust(BATTEN_TUKEY, t, 10);
        options.closed = c < 2;
        options.corrections = 5 * (c > 0);
        const batten_condition pass = {BATTEN_CONDITION_EQUAL, 60, 0, 0, {q[120], q[121], 0}};
        options.condition_count = c == 1;
        options.conditions = &pass;
        double u[MANY];
        int outliers[MANY], count = 0;
        batten_curve *fit = NULL;
        CHECK_OK(
            batten_curve_least_squares((batten_points){2, MANY, q}, &options, u, NULL, &fit));
        CHECK_OK(batten_curve_outliers(
            fit, &(batten_fit_data){{batten_curve_dimension(fit), MANY, q}, u, NULL}, 8, NULL,
            outliers, &count));
        CHECK_INT(count, MANY / 20);
        for (int i = 0; i < count; i++)
            CHECK_INT(outliers[i], 20 * i + 7);
        batten_curve_unref(fit);
    }
}

TEST(data_on_a_curve_need_no_rounds_and_have_no_outliers)
{
    double t[MANY], y[MANY];
    for (int i = 0; i < MANY; i++) {
        t[i] = i;
        y[i] = 2 * t[i] + 1;
    }
    for (int how = 1; how < 4; how++) {
        batten_curve_least_squares_options options = robust((batten_robust)how, t, 5);
        batten_curve *fit = NULL;
        batten_fit_report report;
        int outliers[MANY], count = -1;
        CHECK_OK(batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL,
                                            &report, &fit));
        CHECK(report.error < 1e-10);
        CHECK_INT(report.reweightings, 0);
        CHECK_OK(batten_curve_outliers(
            fit, &(batten_fit_data){{batten_curve_dimension(fit), MANY, y}, t, NULL}, 5, NULL,
            outliers, &count));
        CHECK_INT(count, 0);
        batten_curve_unref(fit);
    }
}

TEST(N2_robust_fits_do_not_depend_on_the_unit)
{
    double t[MANY], y[MANY], scaled[MANY];
    spoilt(0.1, t, y);
    for (int how = 1; how < 4; how++) {
        batten_curve_least_squares_options options = robust((batten_robust)how, t, 6);
        batten_curve *plain = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL,
                                            &plain));
        for (int k = -1; k < 2; k += 2) {
            const double unit = ldexp(1, 30 * k);
            for (int i = 0; i < MANY; i++)
                scaled[i] = unit * y[i];
            batten_curve *fit = NULL;
            CHECK_OK(batten_curve_least_squares((batten_points){1, MANY, scaled}, &options,
                                                NULL, NULL, &fit));
            for (int i = 0; i < 6; i++)
                CHECK_NEAR(batten_curve_points(fit)[i] / unit, batten_curve_points(plain)[i],
                           1e-12);
            batten_curve_unref(fit);
        }
        batten_curve_unref(plain);
    }
}

TEST(N1_thresholds_that_are_no_lengths_are_refused)
{
    double t[MANY], y[MANY];
    spoilt(0.1, t, y);
    static const double bad[] = {NAN, -1, INFINITY};
    batten_curve *fit = NULL;
    batten_curve_least_squares_options options = robust(BATTEN_HUBER, t, 6);
    for (int i = 0; i < 3; i++) {
        options.threshold = bad[i];
        CHECK_STATUS(
            batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit),
            i == 1 ? BATTEN_BAD_ARGUMENT : BATTEN_NOT_FINITE);
        CHECK_MESSAGE("threshold");
    }
    options.threshold = 0;
    options.robust = (batten_robust)7;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit),
        BATTEN_BAD_ARGUMENT);
    options.robust = BATTEN_SQUARES;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit));
    int outliers[MANY], count = 9;
    CHECK_STATUS(batten_curve_outliers(
                     fit, &(batten_fit_data){{batten_curve_dimension(fit), MANY, y}, t, NULL},
                     0, NULL, outliers, &count),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_outliers(
                     fit, &(batten_fit_data){{batten_curve_dimension(fit), MANY, y}, t, NULL},
                     NAN, NULL, outliers, &count),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_outliers(
                     fit, &(batten_fit_data){{batten_curve_dimension(fit), 0, y}, t, NULL}, 5,
                     NULL, outliers, &count),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_INT(count, 9);
    batten_curve_unref(fit);
}
