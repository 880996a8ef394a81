#include "fair/elastic_batten.h"
#include "support/test.h"

enum { N = 30 };

static batten_fair_options kjellander(double within)
{
    batten_fair_options options = batten_fair_defaults(within);
    options.method = BATTEN_FAIR_KJELLANDER;
    return options;
}

static void uneven_wave(double *t, double *y)
{
    for (int i = 0; i < N; i++) {
        t[i] = 0.2 * i + 0.07 * sin(3 * i);
        y[i] = sin(t[i]);
    }
}

static double slope_of(const bat_batten *batten, const double *z, int i)
{
    batten_curve *curve = NULL;
    double at[2];
    CHECK_OK(bat_batten_curve(batten, 1, z, &curve));
    CHECK_OK(batten_curve_evaluate(curve, batten->t[i], 1, at));
    batten_curve_unref(curve);
    return at[1];
}

/* The cubic with the positions and slopes of both neighbours, at the parameter of the point. */
TEST(the_first_move_is_to_the_hermite_cubic_of_the_neighbours)
{
    double t[N], y[N], z[N];
    bat_batten batten;
    batten_fair_report report = {0};
    uneven_wave(t, y);
    y[12] += 0.05;
    batten_fair_options options = kjellander(1);
    options.max_moves = 1;
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, &report, z));
    CHECK_INT(report.move_count, 1);
    const int j = report.moves[0].index;
    CHECK_INT(j, 12);
    CHECK_OK(bat_batten_begin(N, t, &batten));
    const double s = t[j + 1] - t[j - 1], x = (t[j] - t[j - 1]) / s,
                 m0 = slope_of(&batten, y, j - 1), m1 = slope_of(&batten, y, j + 1);
    const double hermite = (1 - x) * (1 - x) * (1 + 2 * x) * y[j - 1] +
                           x * x * (3 - 2 * x) * y[j + 1] +
                           s * (m0 * x * (1 - x) * (1 - x) - m1 * x * x * (1 - x));
    CHECK_NEAR(z[j], hermite, 1e-13);
    bat_batten_end(&batten);
    batten_fair_report_release(&report);
}

TEST(noise_on_a_wave_loses_its_jumps_and_its_inflections_within_the_bound)
{
    double t[N], y[N], z[N];
    batten_fair_report report = {0};
    test_random random = test_random_begin("kjellander");
    uneven_wave(t, y);
    for (int i = 0; i < N; i++)
        y[i] += test_random_in(&random, -0.01, 0.01);
    batten_fair_options options = kjellander(0.02);
    options.max_moves = 100000;
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, &report, z));
    CHECK(report.after.jumps < 0.01 * report.before.jumps);
    CHECK(report.max_move <= 0.02);
    CHECK(z[0] == y[0] && z[N - 1] == y[N - 1]);
    CHECK(!report.before.fair);
    CHECK_INT(report.after.excess_inflections, 0);
    batten_fair_report_release(&report);
}

TEST(a_line_and_held_points_are_not_moved)
{
    double t[N], y[N], z[N];
    uneven_wave(t, y);
    for (int i = 0; i < N; i++)
        y[i] = 3 - 2 * t[i];
    batten_fair_options options = kjellander(0.02);
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
    for (int i = 0; i < N; i++)
        CHECK_NEAR(z[i], y[i], 1e-14);
    uneven_wave(t, y);
    y[12] += 0.05;
    double each[N];
    for (int i = 0; i < N; i++)
        each[i] = i == 20 ? 0.01 : 0;
    options.within_each = each;
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
    for (int i = 0; i < N; i++)
        CHECK(i == 20 ? fabs(z[i] - y[i]) <= 0.01 : z[i] == y[i]);
}

TEST(points_of_space_move_towards_the_smooth_curve)
{
    double points[3 * N], z[3 * N];
    batten_fair_report report = {0};
    for (int i = 0; i < N; i++) {
        const double a = 0.2 * i;
        points[3 * i] = cos(a);
        points[3 * i + 1] = sin(a);
        points[3 * i + 2] = 0.1 * a + (i == 15 ? 0.02 : 0);
    }
    const batten_fair_options options = kjellander(0.05);
    CHECK_OK(
        batten_fair_points((batten_points){3, N, points}, NULL, &options, NULL, &report, z));
    CHECK(report.after.jumps < 0.05 * report.before.jumps);
    CHECK_NEAR(z[47], 0.3, 0.01);
    batten_fair_report_release(&report);
}
