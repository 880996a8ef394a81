#include "support/test.h"
#include <batten/fair.h>

enum { N = 40 };

static batten_fair_options circle_rate(double within)
{
    batten_fair_options options = batten_fair_defaults(within);
    options.method = BATTEN_FAIR_CIRCLE_RATE;
    return options;
}

static void on_circle(int count, double *points)
{
    for (int i = 0; i < count; i++) {
        const double a = 0.1 * i + 0.03 * sin(2 * i);
        points[2 * i] = 7 + 5 * cos(a);
        points[2 * i + 1] = -3 + 5 * sin(a);
    }
}

static double rate(const double *p)
{
    const double turn = (p[2] - p[0]) * (p[5] - p[3]) - (p[3] - p[1]) * (p[4] - p[2]);
    return 2 * turn /
           (hypot(p[2] - p[0], p[3] - p[1]) * hypot(p[4] - p[2], p[5] - p[3]) *
            hypot(p[4] - p[0], p[5] - p[1]));
}

/* Of the rates from the lines between their neighbours. */
static double departures(int count, const double *p)
{
    double sum = 0;
    for (int i = 2; i < count - 2; i++) {
        const double before = hypot(p[2 * i] - p[2 * i - 2], p[2 * i + 1] - p[2 * i - 1]),
                     after = hypot(p[2 * i + 2] - p[2 * i], p[2 * i + 3] - p[2 * i + 1]);
        sum +=
            fabs((after * rate(p + 2 * i - 4) + before * rate(p + 2 * i)) / (before + after) -
                 rate(p + 2 * i - 2));
    }
    return sum;
}

TEST(points_of_a_circle_in_any_spacing_and_of_a_line_are_not_moved)
{
    double points[2 * N], moved[2 * N];
    on_circle(N, points);
    const batten_fair_options options = circle_rate(0.1);
    CHECK_OK(
        batten_fair_points((batten_points){2, N, points}, NULL, &options, NULL, NULL, moved));
    CHECK(memcmp(points, moved, sizeof points) == 0);
    for (int i = 0; i < N; i++) {
        points[2 * i] = i;
        points[2 * i + 1] = 3 * i;
    }
    CHECK_OK(
        batten_fair_points((batten_points){2, N, points}, NULL, &options, NULL, NULL, moved));
    CHECK(memcmp(points, moved, sizeof points) == 0);
}

TEST(a_spoiled_point_of_a_circle_is_found_first_and_goes_nearly_home)
{
    double points[2 * N], spoiled[2 * N], moved[2 * N];
    batten_fair_report report = {0};
    on_circle(N, points);
    memcpy(spoiled, points, sizeof points);
    spoiled[40] *= 1.001;
    spoiled[41] *= 1.001;
    batten_fair_options options = circle_rate(0.1);
    options.max_moves = 1;
    CHECK_OK(batten_fair_points((batten_points){2, N, spoiled}, NULL, &options, NULL, &report,
                                moved));
    CHECK_INT(report.move_count, 1);
    CHECK_INT(report.moves[0].index, 20);
    const double before = hypot(spoiled[40] - 7, spoiled[41] + 3) - 5,
                 after = hypot(moved[40] - 7, moved[41] + 3) - 5;
    CHECK(fabs(after) < 0.05 * fabs(before));
    batten_fair_report_release(&report);
}

TEST(rates_of_noisy_points_become_nearly_linear_within_the_bound)
{
    double points[2 * N], moved[2 * N];
    test_random random = test_random_begin("rates");
    on_circle(N, points);
    for (int i = 0; i < 2 * N; i++)
        points[i] += test_random_in(&random, -0.002, 0.002);
    const batten_fair_options options = circle_rate(0.005);
    CHECK_OK(
        batten_fair_points((batten_points){2, N, points}, NULL, &options, NULL, NULL, moved));
    CHECK(departures(N, moved) < 0.2 * departures(N, points));
    for (int i = 0; i < N; i++)
        CHECK(hypot(moved[2 * i] - points[2 * i], moved[2 * i + 1] - points[2 * i + 1]) <=
              0.005);
    CHECK(memcmp(points, moved, 4 * sizeof *points) == 0);
    CHECK(memcmp(points + 2 * N - 4, moved + 2 * N - 4, 4 * sizeof *points) == 0);
}

TEST(equally_spaced_points_of_a_clothoid_hardly_move)
{
    double points[2 * N], moved[2 * N], x = 0, y = 0;
    const double step = 0.02;
    /* Simpson's rule is right to 1e-10 here. */
    for (int i = 0; i < N; i++) {
        points[2 * i] = x;
        points[2 * i + 1] = y;
        for (int k = 0; k < 10; k++) {
            const double s = 0.2 * i + step * k, a = s + step / 2, b = s + step;
            x += step / 6 * (cos(s * s / 8) + 4 * cos(a * a / 8) + cos(b * b / 8));
            y += step / 6 * (sin(s * s / 8) + 4 * sin(a * a / 8) + sin(b * b / 8));
        }
    }
    batten_fair_report report = {0};
    const batten_fair_options options = circle_rate(0.01);
    CHECK_OK(batten_fair_points((batten_points){2, N, points}, NULL, &options, NULL, &report,
                                moved));
    CHECK(report.max_move < 1e-4);
    batten_fair_report_release(&report);
}

TEST(circle_rates_are_of_points_of_the_plane)
{
    const double points[12] = {0, 0, 0, 1, 1, 0, 2, 0, 1, 3, 1, 1}, t[4] = {0, 1, 2, 3};
    double moved[12];
    batten_fair_options options = circle_rate(0.1);
    CHECK_STATUS(
        batten_fair_points((batten_points){3, 4, points}, NULL, &options, NULL, NULL, moved),
        BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("these have 3 coordinates");
    CHECK_STATUS(
        batten_fair_points((batten_points){1, 4, points}, t, &options, NULL, NULL, moved),
        BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("these have 1 coordinate");
    options.method = (batten_fair_method)4;
    CHECK_STATUS(
        batten_fair_points((batten_points){2, 4, points}, NULL, &options, NULL, NULL, moved),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("there is no method 4 of fairing");
}
