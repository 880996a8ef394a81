#include "fair/fair_points.h"
#include "fair/fairness.h"
#include "support/test.h"

TEST(moves_are_counted_with_the_largest_first_found_as_the_worst)
{
    const double from[3][2] = {{0, 0}, {1, 1}, {2, 2}}, to[3][2] = {{0, 0}, {1, 4}, {5, 6}};
    bat_fair_tally tally = {0};
    batten_fair_report report = {0};
    for (int i = 0; i < 3; i++)
        CHECK_OK(bat_tally_point(&tally, 2, 7, i, from[i], to[i]));
    bat_tally_finish(&tally, &report);
    CHECK_INT(report.moved_count, 2);
    CHECK_INT(report.move_count, 2);
    CHECK_INT(report.worst_set, 7);
    CHECK_INT(report.worst_index, 2);
    CHECK_NEAR(report.max_move, 5, 1e-15);
    CHECK_NEAR(report.rms_move, sqrt((9 + 25) / 3.0), 1e-15);
    CHECK_NEAR(report.moves[1].to[1], 6, 0);
    batten_fair_report_release(&report);
    bat_tally_end(&tally);
}

TEST(only_isolated_peaks_of_force_are_suspects)
{
    /* two wrong numbers in a parabola with a little noise, and the same noise alone */
    enum { N = 60 };
    test_random random = test_random_begin("suspects");
    double t[N], y[N], within[N];
    for (int i = 0; i < N; i++) {
        t[i] = i;
        y[i] = 0.01 * i * i + 0.001 * test_random_in(&random, -1, 1);
        within[i] = 0.01;
    }
    for (int wrong = 0; wrong < 2; wrong++) {
        if (wrong) {
            y[20] += 0.5;
            y[41] -= 0.3;
        }
        bat_batten batten;
        bat_fair_tally tally = {0};
        batten_fair_report report = {0};
        CHECK_OK(bat_batten_begin(N, t, &batten));
        const bat_ducks ducks = {.width = 1, .centre = y, .within = within};
        CHECK_OK(bat_tally_piece(&tally, &batten, &ducks, wrong, 3, 100, y));
        bat_tally_finish(&tally, &report);
        CHECK_INT(report.suspect_count, wrong ? 2 : 0);
        for (int k = 0; k < report.suspect_count; k++) {
            const int i = k == 0 ? 20 : 41;
            CHECK_INT(report.suspects[k].set, 3);
            CHECK_INT(report.suspects[k].index, 100 + i);
            CHECK_NEAR(report.suspects[k].to[0], 0.01 * i * i, 0.01);
        }
        batten_fair_report_release(&report);
        bat_batten_end(&batten);
    }
}
