#include "fair/least_change.h"
#include "support/test.h"
#include <batten/interpolate.h>

enum { N = 24 };

static batten_fair_options least_change(double within)
{
    batten_fair_options options = batten_fair_defaults(within);
    options.method = BATTEN_FAIR_LEAST_CHANGE;
    return options;
}

static double moves_squared(int dimension, int count, const double *from, const double *to)
{
    double sum = 0;
    for (int i = 0; i < count * dimension; i++)
        sum += (to[i] - from[i]) * (to[i] - from[i]);
    return sum;
}

/* A convex parabola with one point pressed in: W-shaped there. */
static void parabola(double *t, double *y)
{
    for (int i = 0; i < N; i++) {
        t[i] = i + 0.3 * sin(i);
        y[i] = 0.01 * t[i] * t[i];
    }
}

TEST(a_dent_in_a_convex_function_is_taken_out_with_less_change_than_by_the_least_energy)
{
    double t[N], y[N], z[N], calm[N];
    batten_fair_report report = {0};
    parabola(t, y);
    y[11] += 0.03;
    batten_fair_options options = least_change(0.05);
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, &report, z));
    CHECK(report.before.excess_inflections >= 2);
    CHECK_INT(report.after.excess_inflections, 0);
    CHECK(report.after.fair);
    CHECK_INT(report.after.inflections, 0);
    options.method = BATTEN_FAIR_SPRINGBACK;
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, calm));
    CHECK(moves_squared(1, N, y, z) < 0.2 * moves_squared(1, N, y, calm));
    CHECK(moves_squared(1, N, y, z) < 0.03 * 0.03);
    for (int i = 0; i < N; i++)
        CHECK(fabs(z[i] - y[i]) <= 0.05);
    CHECK(z[0] == y[0] && z[N - 1] == y[N - 1]);
    batten_fair_report_release(&report);
}

/* Any small change within the bounds that keeps the batten convex makes the sum larger. */
TEST(no_allowed_change_is_smaller)
{
    double t[N], y[N], z[N], tried[N], moments[N];
    bat_batten batten;
    test_random random = test_random_begin("least change");
    parabola(t, y);
    y[11] += 0.03;
    y[5] -= 0.02;
    const batten_fair_options options = least_change(0.05);
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
    CHECK_OK(bat_batten_begin(N, t, &batten));
    for (int k = 0; k < 400; k++) {
        bool convex = true;
        /* towards the given points, and somewhere */
        for (int i = 0; i < N; i++)
            tried[i] = z[i] + (i == 0 || i == N - 1 ? 0
                                                    : 0.05 * (y[i] - z[i]) +
                                                          test_random_in(&random, -1e-4, 1e-4));
        bat_batten_bend(&batten, 1, tried, moments, NULL);
        for (int i = 1; i < N - 1; i++)
            convex &= moments[i] >= -1e-9;
        if (convex)
            CHECK(moves_squared(1, N, y, tried) >= moves_squared(1, N, y, z) * (1 - 1e-6));
    }
    bat_batten_end(&batten);
}

/* Whatever its bound: a duck without freedom is where it was given to the last digit. */
TEST(a_duck_that_is_held_stays_though_it_has_a_bound)
{
    double t[N], y[N], z[N], within[N], frames[N];
    int freedom[N];
    bat_batten batten;
    const batten_fair_options options = least_change(0.05);
    parabola(t, y);
    y[11] += 0.03;
    for (int i = 0; i < N; i++) {
        within[i] = 0.05;
        frames[i] = 1;
        freedom[i] = i > 0 && i < N - 1 && i != 9;
    }
    memcpy(z, y, sizeof z);
    CHECK_OK(bat_batten_begin(N, t, &batten));
    const bat_fair_piece piece = {
        &batten,
        {.width = 1, .centre = y, .within = within, .freedom = freedom, .frames = frames},
        &options,
        NULL};
    CHECK_OK(bat_fair_least_change(&piece, z));
    CHECK(z[0] == y[0] && z[9] == y[9] && z[N - 1] == y[N - 1] && z[11] < y[11]);
    bat_batten_end(&batten);
}

TEST(what_has_no_inflection_in_excess_stays_bit_for_bit)
{
    double t[N], y[N], z[N], again[N];
    parabola(t, y);
    const batten_fair_options options = least_change(0.05);
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
    CHECK(memcmp(y, z, sizeof y) == 0);
    y[11] += 0.03;
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
    CHECK_OK(batten_fair_points((batten_points){1, N, z}, t, &options, NULL, NULL, again));
    CHECK(memcmp(again, z, sizeof z) == 0);
}

/* ---- curves of the plane ---- */

static void noisy_spiral(int count, double noise, double *points)
{
    test_random random = test_random_begin("spiral");
    for (int i = 0; i < count; i++) {
        const double angle = 4.5 * i / (count - 1), radius = 3 + 0.4 * angle;
        const double off = radius + test_random_in(&random, -noise, noise);
        points[2 * i] = off * cos(angle);
        points[2 * i + 1] = off * sin(angle);
    }
}

TEST(a_noisy_spiral_that_turns_through_more_than_half_a_circle_becomes_convex)
{
    enum { COUNT = 60 };
    double points[2 * COUNT], moved[2 * COUNT], calm[2 * COUNT], again[2 * COUNT], t[COUNT];
    batten_fair_report report = {0};
    noisy_spiral(COUNT, 0.02, points);
    const batten_points given = {2, COUNT, points};
    batten_fair_options options = least_change(0.03);
    CHECK_OK(batten_parametrize(given, BATTEN_CHORD, false, t));
    CHECK_OK(batten_fair_points(given, t, &options, NULL, &report, moved));
    CHECK(report.before.excess_inflections >= 4);
    CHECK_INT(report.after.excess_inflections, 0);
    CHECK_INT(report.after.inflections, 0);
    for (int i = 0; i < COUNT; i++)
        CHECK(hypot(moved[2 * i] - points[2 * i], moved[2 * i + 1] - points[2 * i + 1]) <=
              0.03);
    CHECK(memcmp(moved, points, 2 * sizeof *points) == 0);
    CHECK(memcmp(moved + 2 * COUNT - 2, points + 2 * COUNT - 2, 2 * sizeof *points) == 0);
    options.method = BATTEN_FAIR_SPRINGBACK;
    CHECK_OK(batten_fair_points(given, t, &options, NULL, NULL, calm));
    CHECK(moves_squared(2, COUNT, points, moved) < 0.9 * moves_squared(2, COUNT, points, calm));
    options.method = BATTEN_FAIR_LEAST_CHANGE;
    CHECK_OK(
        batten_fair_points((batten_points){2, COUNT, moved}, t, &options, NULL, NULL, again));
    CHECK(memcmp(moved, again, sizeof moved) == 0);
    batten_fair_report_release(&report);
}

/* An S: one inflection is required and stays, the others go. */
TEST(an_inflection_that_points_require_stays)
{
    enum { COUNT = 41 };
    double points[2 * COUNT], moved[2 * COUNT];
    test_random random = test_random_begin("ess");
    batten_fair_report report = {0};
    for (int i = 0; i < COUNT; i++) {
        const double x = 6.28318530717958648 * i / (COUNT - 1);
        points[2 * i] = x;
        points[2 * i + 1] = sin(x) + test_random_in(&random, -0.01, 0.01);
    }
    const batten_fair_options options = least_change(0.015);
    CHECK_OK(batten_fair_points((batten_points){2, COUNT, points}, NULL, &options, NULL,
                                &report, moved));
    CHECK(report.before.excess_inflections >= 2);
    CHECK_INT(report.after.inflections, 1);
    CHECK(report.after.fair);
    CHECK(report.max_move <= 0.015);
    batten_fair_report_release(&report);
}

TEST(moves_of_least_change_turn_and_scale_with_the_points)
{
    enum { COUNT = 60 };
    double points[2 * COUNT], turned[2 * COUNT], moved[2 * COUNT], other[2 * COUNT];
    noisy_spiral(COUNT, 0.02, points);
    for (int i = 0; i < COUNT; i++) {
        turned[2 * i] = 1000 * (0.6 * points[2 * i] - 0.8 * points[2 * i + 1]) + 5000;
        turned[2 * i + 1] = 1000 * (0.8 * points[2 * i] + 0.6 * points[2 * i + 1]) - 700;
    }
    const batten_fair_options options = least_change(0.03), large = least_change(30);
    CHECK_OK(batten_fair_points((batten_points){2, COUNT, points}, NULL, &options, NULL, NULL,
                                moved));
    CHECK_OK(
        batten_fair_points((batten_points){2, COUNT, turned}, NULL, &large, NULL, NULL, other));
    for (int i = 0; i < COUNT; i++) {
        const double *p = moved + 2 * i;
        /* The polygon inside the circle of a bound turns with the axes, so bounds differ by 2 %. */
        CHECK_NEAR(other[2 * i], 1000 * (0.6 * p[0] - 0.8 * p[1]) + 5000, 1.5);
        CHECK_NEAR(other[2 * i + 1], 1000 * (0.8 * p[0] + 0.6 * p[1]) - 700, 1.5);
    }
}

static batten_status begin_change(const bat_fair_piece *piece, bat_least_change *c)
{
    const batten_status status = bat_change_begin(piece, c);
    if (status != BATTEN_OK)
        bat_arena_free(&c->arena);
    return status;
}

TEST(rows_are_the_derivatives_of_the_difference_of_two_battens)
{
    double t[7] = {0, 1, 1.5, 3, 4, 6, 6.5}, z[7], moments[7];
    const batten_fair_options options = least_change(1);
    double centre[7] = {0}, within[7] = {1, 1, 1, 1, 1, 1, 1},
           frames[7] = {1, 1, 1, 1, 1, 1, 1};
    int freedom[7] = {1, 1, 1, 1, 1, 1, 1};
    bat_batten batten;
    bat_least_change c;
    CHECK_OK(bat_batten_begin(7, t, &batten));
    const bat_fair_piece piece = {
        &batten,
        {.width = 1, .centre = centre, .within = within, .freedom = freedom, .frames = frames},
        &options,
        NULL};
    CHECK_OK(begin_change(&piece, &c));
    for (int unknown = 0; unknown < 7; unknown++) {
        for (int i = 0; i < 7; i++) {
            const bat_change_row row = bat_change_row_at(&c, i, 0);
            const int k = unknown - row.first;
            z[i] = k >= 0 && k < BAT_CHANGE_SUPPORT ? row.weight[k] : 0;
        }
        bat_batten_bend(&batten, 1, z, moments, NULL);
        bat_change_bend(&c, z);
        for (int i = 0; i < 7; i++) {
            const bat_change_row slope = bat_change_row_at(&c, i, 1),
                                 bend = bat_change_row_at(&c, i, 2);
            const int k = unknown - bend.first;
            const bool touches = k >= 0 && k < BAT_CHANGE_SUPPORT;
            CHECK_NEAR(touches ? bend.weight[k] : 0, moments[i], 1e-13);
            CHECK_NEAR(touches ? slope.weight[k] : 0, i < 6 ? c.bend[3 * i] : c.bend[17],
                       1e-13);
        }
    }
    bat_arena_free(&c.arena);
    bat_batten_end(&batten);
}

TEST(curves_in_space_have_no_inflections_to_remove)
{
    const double points[12] = {0, 0, 0, 1, 1, 0, 2, 0, 1, 3, 1, 1};
    double moved[12];
    const batten_fair_options options = least_change(0.1);
    CHECK_STATUS(
        batten_fair_points((batten_points){3, 4, points}, NULL, &options, NULL, NULL, moved),
        BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("curves in space have none");
}

/* Between points far apart and bounds so small, every batten turns too often; the program of the signs has no good answer. */
static const struct {
    double point[2], within;
} rigid[] = {{{0.5714, 0.4505}, 0},       {{0.5663, 0.2628}, 9.67e-5},  {{0.1054, 0.6425}, 0},
             {{0.3837, 0.8284}, 4.98e-5}, {{0.04832, 0.4644}, 1.07e-4}, {{0.9114, 0.4985}, 0}};

TEST(a_curve_of_which_bounds_let_no_inflection_be_removed_stays_and_says_so)
{
    enum { COUNT = sizeof rigid / sizeof *rigid };
    double points[2 * COUNT], within[COUNT], moved[2 * COUNT] = {0};
    batten_fair_report report = {0};
    for (int i = 0; i < COUNT; i++) {
        memcpy(points + 2 * i, rigid[i].point, sizeof rigid[i].point);
        within[i] = rigid[i].within;
    }
    batten_fair_options options = least_change(1e-4);
    options.within_each = within;
    CHECK_OK(batten_fair_points((batten_points){2, COUNT, points}, NULL, &options, NULL,
                                &report, moved));
    CHECK(report.before.excess_inflections > 0);
    CHECK_INT(report.after.excess_inflections, report.before.excess_inflections);
    CHECK_INT(report.moved_count, 0);
    CHECK(memcmp(points, moved, sizeof points) == 0);
    batten_fair_report_release(&report);
}

typedef struct {
    int asked, refused; /* at that question; 0: never */
} questions;

static bool is_refused(void *user)
{
    questions *q = user;
    return ++q->asked == q->refused;
}

TEST(each_round_of_the_least_change_asks_whether_to_stop)
{
    enum { COUNT = 30 };
    double points[2 * COUNT], moved[2 * COUNT];
    const batten_points given = {2, COUNT, points};
    questions calm = {0}, all = {0}, last = {0};
    if (test_cases(10) < 10)
        return; /* calls that are tried again ask again */
    batten_job job = {.size = sizeof job, .is_cancelled = is_refused};
    batten_fair_options options = least_change(0.05);
    noisy_spiral(COUNT, 0.02, points);
    job.user = &all;
    CHECK_OK(batten_fair_points(given, NULL, &options, &job, NULL, moved));
    options.method = BATTEN_FAIR_SPRINGBACK;
    job.user = &calm;
    CHECK_OK(batten_fair_points(given, NULL, &options, &job, NULL, moved));
    CHECK(all.asked > calm.asked);
    options.method = BATTEN_FAIR_LEAST_CHANGE;
    last.refused = all.asked;
    job.user = &last;
    CHECK_STATUS(batten_fair_points(given, NULL, &options, &job, NULL, moved),
                 BATTEN_CANCELLED);
}
