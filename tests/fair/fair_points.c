#include "fair/fairness.h"
#include "support/test.h"

enum { N = 40, MANY = 200 };

static void wave(int count, double *t, double *y)
{
    for (int i = 0; i < count; i++) {
        t[i] = 2 * 3.14159265358979 * i / (count - 1);
        y[i] = sin(t[i]);
    }
}

static double energy_of(int count, const double *t, const double *z)
{
    double *moments = test_array((size_t)count, sizeof *moments);
    bat_batten batten;
    CHECK_OK(bat_batten_begin(count, t, &batten));
    const double energy = bat_batten_bend(&batten, 1, z, moments, NULL);
    bat_batten_end(&batten);
    return energy;
}

TEST(one_move_repairs_a_spike_in_smooth_data)
{
    double t[N], y[N], z[N];
    batten_fair_report report = {0};
    wave(N, t, y);
    y[17] += 0.05;
    batten_fair_options options = batten_fair_defaults(0.06);
    options.order = BATTEN_FAIR_WORST_FIRST;
    options.max_moves = 1;
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, &report, z));
    CHECK_INT(report.move_count, 1);
    CHECK_INT(report.moves[0].index, 17);
    CHECK_INT(report.moves[0].set, 0);
    CHECK_NEAR(report.moves[0].from[0], y[17], 0);
    CHECK_NEAR(report.moves[0].to[0], z[17], 0);
    CHECK_NEAR(z[17], sin(t[17]), 1e-4);
    CHECK(report.after.energy < report.before.energy);
    CHECK_INT(report.suspect_count, 1);
    CHECK_INT(report.suspects[0].index, 17);
    CHECK_INT(report.suspects[0].set, 0);
    CHECK_NEAR(report.suspects[0].to[0], sin(t[17]), 1e-4);
    batten_fair_report_release(&report);
}

TEST(worst_first_stops_when_the_curve_is_fair)
{
    double t[N], y[N], z[N];
    batten_fair_report report = {0};
    wave(N, t, y);
    y[17] += 0.05;
    batten_fair_options options = batten_fair_defaults(0.06);
    options.order = BATTEN_FAIR_WORST_FIRST;
    options.stop_when_fair = true;
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, &report, z));
    CHECK(report.before.excess_inflections > 0 && !report.before.fair);
    CHECK(report.after.fair);
    CHECK_INT(report.moved_count, 1);
    batten_fair_report_release(&report);
}

TEST(noise_on_a_cubic_loses_its_jumps_within_the_bound)
{
    test_random random = test_random_begin("cubic");
    double t[MANY], y[MANY], z[MANY];
    for (int i = 0; i < MANY; i++) {
        t[i] = i / (double)(MANY - 1);
        y[i] = t[i] * t[i] * (1.5 - t[i]) + 0.001 * test_random_in(&random, -1, 1);
    }
    batten_fair_report report = {0};
    const batten_fair_options options = batten_fair_defaults(0.003);
    CHECK_OK(batten_fair_points((batten_points){1, MANY, y}, t, &options, NULL, &report, z));
    CHECK(report.after.jumps < report.before.jumps / 100);
    CHECK(report.after.energy < report.before.energy);
    CHECK(report.max_move <= 0.003);
    CHECK_NEAR(fabs(z[report.worst_index] - y[report.worst_index]), report.max_move, 0);
    CHECK_BITS(z[0], y[0]);
    CHECK_BITS(z[MANY - 1], y[MANY - 1]);
    double square = 0;
    for (int i = 0; i < MANY; i++) {
        CHECK(fabs(z[i] - y[i]) <= 0.003);
        square += (z[i] - y[i]) * (z[i] - y[i]);
    }
    CHECK_NEAR(report.rms_move, sqrt(square / MANY), 1e-12);
    CHECK(report.after.excess_inflections <= report.before.excess_inflections);
    batten_fair_report_release(&report);
}

TEST(all_orders_lower_the_energy_and_sweeps_lower_it_most)
{
    test_random random = test_random_begin("orders");
    double t[N], y[N], z[N], energy[3];
    wave(N, t, y);
    for (int i = 0; i < N; i++)
        y[i] += 0.01 * test_random_in(&random, -1, 1);
    for (int order = 0; order < 3; order++) {
        batten_fair_options options = batten_fair_defaults(0.02);
        options.order = (batten_fair_order)order;
        options.relaxation = order == BATTEN_FAIR_WORST_FIRST ? 0.7 : 1;
        CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
        energy[order] = energy_of(N, t, z);
        for (int i = 0; i < N; i++)
            CHECK(fabs(z[i] - y[i]) <= 0.02);
    }
    CHECK(energy[BATTEN_FAIR_SWEEPS] <= energy[BATTEN_FAIR_WORST_FIRST] * (1 + 1e-9));
    CHECK(energy[BATTEN_FAIR_SWEEPS] <= energy[BATTEN_FAIR_ALTERNATE] * (1 + 1e-9));
    CHECK(energy[BATTEN_FAIR_WORST_FIRST] < energy_of(N, t, y));
    CHECK(energy[BATTEN_FAIR_ALTERNATE] < energy_of(N, t, y));
}

TEST(more_sweeps_of_single_ducks_move_nothing)
{
    test_random random = test_random_begin("rest");
    double t[N], y[N], z[N], moments[N], forces[N];
    wave(N, t, y);
    for (int i = 0; i < N; i++)
        y[i] += 0.01 * test_random_in(&random, -1, 1);
    const batten_fair_options options = batten_fair_defaults(0.01);
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
    bat_batten batten;
    CHECK_OK(bat_batten_begin(N, t, &batten));
    for (int i = 1; i < N - 1; i++) {
        bat_batten_bend(&batten, 1, z, moments, forces);
        double to = z[i] - forces[i] / batten.diagonal[i];
        to = fmin(fmax(to, y[i] - 0.01), y[i] + 0.01);
        CHECK_NEAR(to, z[i], 1e-8 * 0.01);
    }
    bat_batten_end(&batten);
}

TEST(a_straight_line_stays_bit_for_bit)
{
    for (int d = 1; d <= 3; d++) {
        double points[3 * N], t[N], z[3 * N];
        for (int i = 0; i < N; i++) {
            t[i] = i;
            for (int k = 0; k < d; k++)
                points[i * d + k] = 0.1 + (k + 1) * t[i] / 3;
        }
        batten_fair_report report = {0};
        const batten_fair_options options = batten_fair_defaults(0.1);
        CHECK_OK(
            batten_fair_points((batten_points){d, N, points}, t, &options, NULL, &report, z));
        CHECK_INT(report.moved_count, 0);
        CHECK_INT(report.suspect_count, 0);
        for (int i = 0; i < d * N; i++)
            CHECK_BITS(z[i], points[i]);
        batten_fair_report_release(&report);
    }
}

/* One look at all of its ducks tells that none wants to move. */
TEST(a_straight_line_costs_one_look_at_its_worst_duck)
{
    double points[N], t[N], z[N];
    batten_job job = BATTEN_JOB;
    batten_fair_options options = batten_fair_defaults(0.1);
    options.order = BATTEN_FAIR_WORST_FIRST;
    job.work_limit = 2 * N;
    for (int i = 0; i < N; i++)
        points[i] = t[i] = i;
    CHECK_OK(batten_fair_points((batten_points){1, N, points}, t, &options, &job, NULL, z));
    points[N / 2] += 1;
    CHECK_STATUS(batten_fair_points((batten_points){1, N, points}, t, &options, &job, NULL, z),
                 BATTEN_INCOMPLETE);
}

TEST(bounds_of_0_leave_the_data_bit_for_bit)
{
    test_random random = test_random_begin("held");
    double t[N], y[N], z[N], within[N] = {0};
    wave(N, t, y);
    for (int i = 0; i < N; i++)
        y[i] += test_random_in(&random, -1, 1);
    batten_fair_options options = batten_fair_defaults(0);
    options.within_each = within;
    for (int order = 0; order < 3; order++) {
        options.order = (batten_fair_order)order;
        CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
        for (int i = 0; i < N; i++)
            CHECK_BITS(z[i], y[i]);
    }
    within[5] = 0.3; /* one free duck among held ones */
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
    for (int i = 0; i < N; i++)
        CHECK((z[i] != y[i]) == (i == 5));
}

TEST(moves_scale_with_the_data)
{
    test_random random = test_random_begin("scale");
    double points[2 * N], large[2 * N], z[2 * N], large_z[2 * N];
    for (int i = 0; i < N; i++) {
        points[2 * i] = cos(0.1 * i) + 0.005 * test_random_in(&random, -1, 1);
        points[2 * i + 1] = sin(0.1 * i) + 0.005 * test_random_in(&random, -1, 1);
        large[2 * i] = 1000 * points[2 * i];
        large[2 * i + 1] = 1000 * points[2 * i + 1];
    }
    const batten_fair_options small = batten_fair_defaults(0.004),
                              big = batten_fair_defaults(4);
    CHECK_OK(batten_fair_points((batten_points){2, N, points}, NULL, &small, NULL, NULL, z));
    CHECK_OK(batten_fair_points((batten_points){2, N, large}, NULL, &big, NULL, NULL, large_z));
    for (int i = 0; i < 2 * N; i++)
        CHECK_NEAR(large_z[i], 1000 * z[i], 1e-6);
}

TEST(points_of_curves_move_at_right_angles_to_their_chord)
{
    test_random random = test_random_begin("normal");
    for (int d = 2; d <= 3; d++) {
        double points[3 * N], z[3 * N];
        for (int i = 0; i < N; i++) {
            const double place[3] = {cos(0.1 * i), sin(0.1 * i), 0.03 * i};
            for (int k = 0; k < d; k++)
                points[i * d + k] = place[k] + 0.01 * test_random_in(&random, -1, 1);
        }
        batten_fair_report report = {0};
        const batten_fair_options options = batten_fair_defaults(0.01);
        CHECK_OK(batten_fair_points((batten_points){d, N, points}, NULL, &options, NULL,
                                    &report, z));
        CHECK(report.after.energy < report.before.energy &&
              report.after.jumps < report.before.jumps);
        CHECK(report.max_move <= 0.01);
        for (int i = 1; i < N - 1; i++) {
            double along = 0;
            for (int k = 0; k < d; k++)
                along += (z[i * d + k] - points[i * d + k]) *
                         (points[(i + 1) * d + k] - points[(i - 1) * d + k]);
            CHECK_NEAR(along, 0, 1e-14);
        }
        batten_fair_report_release(&report);
    }
}

TEST(corners_cut_the_curve_and_stay)
{
    /* two noisy straight legs that meet at a right angle */
    test_random random = test_random_begin("corner");
    double points[2 * 21], z[2 * 21], leg[2 * 11], leg_z[2 * 11];
    for (int i = 0; i <= 20; i++) {
        points[2 * i] = i <= 10 ? i : 10 + 0.01 * test_random_in(&random, -1, 1);
        points[2 * i + 1] = i <= 10 ? 0.01 * test_random_in(&random, -1, 1) : i - 10;
    }
    const int corners[1] = {10};
    batten_fair_report report = {0};
    batten_fair_options options = batten_fair_defaults(0.02);
    CHECK_OK(
        batten_fair_points((batten_points){2, 11, points}, NULL, &options, NULL, NULL, leg_z));
    memcpy(leg, points, sizeof leg);
    options.corners = corners;
    options.corner_count = 1;
    CHECK_OK(
        batten_fair_points((batten_points){2, 21, points}, NULL, &options, NULL, &report, z));
    CHECK_BITS(z[20], points[20]);
    CHECK_BITS(z[21], points[21]);
    for (int i = 1; i < 10;
         i++) /* up to the frame at the corner, the leg is faired as if alone */
        CHECK_NEAR(hypot(z[2 * i] - leg_z[2 * i], z[2 * i + 1] - leg_z[2 * i + 1]), 0, 1e-9);
    CHECK_INT(report.after.excess_inflections, 0);
    batten_fair_report_release(&report);
}

TEST(ends_move_when_they_are_not_held)
{
    double t[N], y[N], z[N];
    wave(N, t, y);
    y[0] += 0.02;
    batten_fair_options options = batten_fair_defaults(0.05);
    options.hold_ends = false;
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
    CHECK(z[0] != y[0] && fabs(z[0] - y[0]) <= 0.05);
    options.within = 10; /* a line fits within the bounds: nothing is bent at all */
    CHECK_OK(batten_fair_points((batten_points){1, N, y}, t, &options, NULL, NULL, z));
    CHECK_NEAR(energy_of(N, t, z), 0, 1e-12);
}

TEST(few_points_are_judged_but_not_moved)
{
    const double t[3] = {0, 1, 2}, y[3] = {0, 1, 0};
    double z[3];
    batten_fair_report report = {0};
    const batten_fair_options options = batten_fair_defaults(1);
    CHECK_OK(batten_fair_points((batten_points){1, 3, y}, t, &options, NULL, &report, z));
    for (int i = 0; i < 3; i++)
        CHECK_BITS(z[i], y[i]);
    CHECK(report.before.energy > 0 && report.after.energy == report.before.energy);
    batten_fair_report_release(&report);
}

TEST(N6_bounds_that_are_not_positive_are_refused)
{
    const double t[5] = {0, 1, 2, 3, 4}, y[5] = {0, 1, 0, 1, 0},
                 bad[4] = {0, -1, NAN, HUGE_VAL};
    double z[5] = {9, 9, 9, 9, 9}, each[5] = {1, 1, -1, 1, 1};
    for (int k = 0; k < 4; k++) {
        const batten_fair_options options = batten_fair_defaults(bad[k]);
        CHECK_STATUS(batten_fair_points((batten_points){1, 5, y}, t, &options, NULL, NULL, z),
                     BATTEN_BAD_ARGUMENT);
    }
    batten_fair_options options = batten_fair_defaults(1);
    options.within_each = each;
    CHECK_STATUS(batten_fair_points((batten_points){1, 5, y}, t, &options, NULL, NULL, z),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("point 3 is -1");
    CHECK_NEAR(z[0], 9, 0);
    /* far below the last place of the numbers there is no room to move */
    const batten_fair_options tiny = batten_fair_defaults(1e-18);
    CHECK_OK(batten_fair_points((batten_points){1, 5, y}, t, &tiny, NULL, NULL, z));
    for (int i = 0; i < 5; i++)
        CHECK_BITS(z[i], y[i]);
}

TEST(bad_points_parameters_and_options_are_refused)
{
    double t[5] = {0, 1, 2, 3, 4}, y[5] = {0, 1, 0, 1, 0}, z[5], nan[5] = {0, NAN, 0, 0, 0};
    const double still[5] = {0, 1, 1, 3, 4}, twice[10] = {0, 0, 1, 1, 1, 1, 2, 2, 3, 3};
    const int corner[1] = {5};
    batten_fair_options options = batten_fair_defaults(1), bad;
    CHECK_STATUS(batten_fair_points((batten_points){4, 5, y}, t, &options, NULL, NULL, z),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_fair_points((batten_points){1, 1, y}, t, &options, NULL, NULL, z),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_fair_points((batten_points){1, 5, nan}, t, &options, NULL, NULL, z),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_fair_points((batten_points){1, 5, y}, nan, &options, NULL, NULL, z),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_fair_points((batten_points){1, 5, y}, still, &options, NULL, NULL, z),
                 BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_fair_points((batten_points){1, 5, y}, NULL, &options, NULL, NULL, z),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(
        batten_fair_points((batten_points){2, 5, twice}, NULL, &options, NULL, NULL, z),
        BATTEN_COINCIDENT);
    bad = options;
    bad.relaxation = 1.5;
    CHECK_STATUS(batten_fair_points((batten_points){1, 5, y}, t, &bad, NULL, NULL, z),
                 BATTEN_BAD_ARGUMENT);
    bad = options;
    bad.order = (batten_fair_order)7;
    CHECK_STATUS(batten_fair_points((batten_points){1, 5, y}, t, &bad, NULL, NULL, z),
                 BATTEN_BAD_ARGUMENT);
    bad = options;
    bad.max_moves = -1;
    CHECK_STATUS(batten_fair_points((batten_points){1, 5, y}, t, &bad, NULL, NULL, z),
                 BATTEN_BAD_ARGUMENT);
    bad = options;
    bad.corners = corner;
    bad.corner_count = 1;
    CHECK_STATUS(batten_fair_points((batten_points){1, 5, y}, t, &bad, NULL, NULL, z),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("corner 1 is point 6");
}

TEST(a_hairpin_of_the_polygon_moves_freely)
{
    /* the neighbours of point 3 coincide: it has no chord */
    const double points[14] = {0, 0, 1, 0.1, 2, 0, 3, 0, 2, 0, 1, 0.3, 0, 0.2};
    double z[14];
    const batten_fair_options options = batten_fair_defaults(0.1);
    CHECK_OK(batten_fair_points((batten_points){2, 7, points}, NULL, &options, NULL, NULL, z));
    for (int i = 0; i < 7; i++)
        CHECK(hypot(z[2 * i] - points[2 * i], z[2 * i + 1] - points[2 * i + 1]) <= 0.1);
}

TEST(a_fair_curve_is_not_moved_where_fairing_stops_at_the_verdict)
{
    static const double points[] = {0, 0, 1, 0.2, 2, 0.32, 3, 0.33, 4, 0.2, 5, 0};
    static const batten_fair_method methods[] = {
        BATTEN_FAIR_SPRINGBACK, BATTEN_FAIR_CIRCLE_RATE, BATTEN_FAIR_KJELLANDER};
    const batten_points given = {2, 6, points};
    double moved[12];
    batten_fair_options options = batten_fair_defaults(0.01);
    options.order = BATTEN_FAIR_WORST_FIRST;
    for (int k = 0; k < 3; k++) {
        options.method = methods[k];
        options.stop_when_fair = false;
        CHECK_OK(batten_fair_points(given, NULL, &options, NULL, NULL, moved));
        CHECK(memcmp(moved, points, sizeof points) != 0);
        options.stop_when_fair = true;
        CHECK_OK(batten_fair_points(given, NULL, &options, NULL, NULL, moved));
        CHECK(memcmp(moved, points, sizeof points) == 0);
    }
}
