#include "loft/net/sheet.h"

#include <string.h>

/* Each point somewhere in the ball of this radius. */
static void shake(test_random *random, double radius, int nodes, double *z)
{
    for (int n = 0; n < nodes; n++) {
        double d[3], length = 2;
        while (length > 1) {
            for (int c = 0; c < 3; c++)
                d[c] = test_random_in(random, -1, 1);
            length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        }
        for (int c = 0; c < 3; c++)
            z[3 * n + c] += radius * d[c];
    }
}

static double rms_of(const double *a, const double *b)
{
    double sum = 0;
    for (int n = 0; n < NODES; n++)
        sum += moved(a, b, n) * moved(a, b, n) / NODES;
    return sqrt(sum);
}

/* The surface passes through the points where they are uniform. */
static void check_surface(const batten_surface *surface, const double *z)
{
    for (int n = 0; n < NODES; n++) {
        double p[3];
        CHECK_OK(
            batten_surface_evaluate(surface, n / NV / (NU - 1.), n % NV / (NV - 1.), 0, p));
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(p[c], z[3 * n + c], 1e-12);
    }
}

TEST(least_change_leaves_no_section_of_a_noisy_sheet_an_inflection_and_runs_twice_for_nothing)
{
    test_random random = test_random_begin("noisy sheet");
    double exact[3 * NODES], given[3 * NODES], faired[3 * NODES], again[3 * NODES];
    const batten_net_fair_options options = uniform(0.03, BATTEN_NET_FAIR_LEAST_CHANGE);
    sheet(NU, NV, exact);
    for (int k = 0; k < test_cases(2); k++) {
        batten_net_fair_report report = {0}, second = {0};
        batten_surface *surface = NULL;
        memcpy(given, exact, sizeof given);
        shake(&random, 0.02, NODES, given);
        CHECK_OK(batten_fair_net(grid_of(given), &options, NULL, &report, faired, &surface));
        CHECK(report.sections_before > report.section_count / 2);
        CHECK_INT(report.sections_after, 0);
        CHECK_INT(report.points.after.excess_inflections, 0);
        CHECK(report.points.after.fair && !report.points.before.fair && report.points.net);
        for (int n = 0; n < NODES; n++)
            CHECK(moved(given, faired, n) <= options.within);
        CHECK(rms_of(faired, exact) < rms_of(given, exact));
        check_surface(surface, faired);
        CHECK_OK(batten_fair_net(grid_of(faired), &options, NULL, &second, again, NULL));
        CHECK_INT(second.points.moved_count, 0);
        for (int c = 0; c < 3 * NODES; c++)
            CHECK_BITS(again[c], faired[c]);
        batten_surface_unref(surface);
        batten_net_fair_report_release(&report);
        batten_net_fair_report_release(&second);
    }
}

/* Once no bound is met, a wider one changes nothing at all. */
TEST(a_wider_bound_never_ends_with_more_energy)
{
    enum { WIDE = 8, HIGH = 7 };
    static const double bounds[] = {0.1, 1, 10, 1000, 1e6};
    test_random random = test_random_begin("wider bounds");
    double given[3 * WIDE * HIGH], faired[3 * WIDE * HIGH], before = HUGE_VAL;
    sheet(WIDE, HIGH, given);
    shake(&random, 0.1, WIDE * HIGH, given);
    for (int k = 0; k < COUNT(bounds); k++) {
        const batten_net_fair_options options = uniform(bounds[k], BATTEN_NET_FAIR_ENERGY);
        batten_net_fair_report report = {0};
        CHECK_OK(batten_fair_net((batten_grid){3, WIDE, HIGH, given}, &options, NULL, &report,
                                 faired, NULL));
        CHECK(report.points.after.energy <= before);
        CHECK(report.points.after.energy < 0.1 * report.points.before.energy);
        CHECK(report.residual <= 1e-3);
        before = report.points.after.energy;
        batten_net_fair_report_release(&report);
    }
}

TEST(the_report_tells_what_moved_and_how_far)
{
    test_random random = test_random_begin("net report");
    double given[3 * NODES], faired[3 * NODES], largest = 0;
    batten_net_fair_report report = {0};
    const batten_net_fair_options options = uniform(0.01, BATTEN_NET_FAIR_ENERGY);
    sheet(NU, NV, given);
    shake(&random, 0.02, NODES, given);
    CHECK_OK(batten_fair_net(grid_of(given), &options, NULL, &report, faired, NULL));
    for (int n = 0; n < NODES; n++)
        largest = fmax(largest, moved(given, faired, n));
    CHECK_NEAR(report.points.max_move, largest, 1e-15);
    CHECK_NEAR(report.points.rms_move, rms_of(given, faired), 1e-14);
    CHECK_NEAR(moved(given, faired, report.points.worst_index * NV + report.points.worst_set),
               largest, 0);
    CHECK_INT(report.points.move_count, NODES);
    for (int k = 0; k < report.points.move_count; k++) {
        const batten_fair_move *m = report.points.moves + k;
        for (int c = 0; c < 3; c++) {
            CHECK_BITS(m->from[c], given[3 * (m->index * NV + m->set) + c]);
            CHECK_BITS(m->to[c], faired[3 * (m->index * NV + m->set) + c]);
        }
    }
    CHECK(report.residual <= 1e-3);
    CHECK(report.points.after.energy < report.points.before.energy);
    CHECK_INT(report.section_count, 2 * NU - 1 + 2 * NV - 1 + 2 * NU);
    CHECK_NEAR(report.height, 7e-6, 1e-6);
    batten_net_fair_report_release(&report);
}

TEST(a_spoiled_point_is_named_and_mended_within_the_bound_of_its_neighbours)
{
    static const batten_net_fair_method methods[] = {BATTEN_NET_FAIR_ENERGY,
                                                     BATTEN_NET_FAIR_LEAST_CHANGE};
    const int n = 7 * NV + 3;
    double exact[3 * NODES], given[3 * NODES], faired[3 * NODES];
    sheet(NU, NV, exact);
    memcpy(given, exact, sizeof given);
    given[3 * n + 2] += 0.4;
    for (int k = 0; k < 2; k++) {
        batten_net_fair_report report = {0};
        batten_net_fair_options options = uniform(0.005, methods[k]);
        CHECK_OK(batten_fair_net(grid_of(given), &options, NULL, &report, faired, NULL));
        CHECK_INT(report.points.suspect_count, 1);
        CHECK_INT(report.points.suspects[0].index, 7);
        CHECK_INT(report.points.suspects[0].set, 3);
        CHECK_NEAR(report.points.suspects[0].to[2], exact[3 * n + 2], 1e-12);
        CHECK(moved(given, faired, n) <= 0.005);
        batten_net_fair_report_release(&report);
        options.mend_blunders = true;
        CHECK_OK(batten_fair_net(grid_of(given), &options, NULL, &report, faired, NULL));
        CHECK(moved(exact, faired, n) <= 0.005);
        CHECK_INT(report.points.after.excess_inflections, 0);
        batten_net_fair_report_release(&report);
    }
}

TEST(points_with_no_bound_stay_bit_for_bit)
{
    test_random random = test_random_begin("held points");
    static const batten_net_fair_method methods[] = {BATTEN_NET_FAIR_ENERGY,
                                                     BATTEN_NET_FAIR_LEAST_CHANGE};
    double given[3 * NODES], faired[3 * NODES], within[NODES];
    sheet(NU, NV, given);
    for (int n = 0; n < NODES; n++)
        within[n] = n % 29 == 3 ? 0 : 0.03;
    for (int n = 0; n < NODES; n++)
        if (within[n] > 0)
            shake(&random, 0.01, 1, given + 3 * n);
    for (int k = 0; k < 2; k++) {
        batten_net_fair_options options = uniform(0, methods[k]);
        int held = 0;
        options.within_each = within;
        CHECK_OK(batten_fair_net(grid_of(given), &options, NULL, NULL, faired, NULL));
        for (int n = 0; n < NODES; n++) {
            CHECK(moved(given, faired, n) <= within[n]);
            held += moved(given, faired, n) == 0;
        }
        CHECK_INT(held, 4);
    }
}

/* On the rim position, normal and the curvature across it, against the surface through the net. */
static void check_rim(const batten_surface *before, const batten_surface *after, int hold)
{
    enum { S, SU, SV, SUU, SUV, SVV, ALL };
    for (int k = 0; k <= 80; k++) {
        const double t = k % 20 / 20.;
        const double u = k / 20 == 0   ? 0
                         : k / 20 == 1 ? 1
                                       : t,
                     v = k / 20 == 2   ? 0
                         : k / 20 == 3 ? 1
                                       : t;
        double a[3 * ALL], b[3 * ALL];
        CHECK_OK(batten_surface_evaluate(before, u, v, 2, a));
        CHECK_OK(batten_surface_evaluate(after, u, v, 2, b));
        const int kept = hold == 1 ? SU : hold == 2 ? SUU : ALL;
        for (int c = 0; c < 3 * kept && k < 80; c++)
            CHECK_NEAR(b[c], a[c], 1e-9);
    }
}

TEST(what_is_held_at_the_rim_stays)
{
    test_random random = test_random_begin("held rims");
    double given[3 * NODES], faired[3 * NODES];
    sheet(NU, NV, given);
    for (int i = 4; i < NU - 4; i++)
        shake(&random, 0.01, 2, given + 3 * (i * NV + 3));
    batten_net_fair_options options = uniform(1e-6, BATTEN_NET_FAIR_ENERGY);
    batten_surface *before = NULL;
    double same[3 * NODES];
    options.hold = 0;
    batten_net_fair_options still = options;
    const double none[NODES] = {0};
    still.within_each = none;
    CHECK_OK(batten_fair_net(grid_of(given), &still, NULL, NULL, same, &before));
    check_surface(before, given);
    for (int hold = 1; hold <= 3; hold++) {
        batten_net_fair_report report = {0};
        batten_surface *after = NULL;
        options = uniform(0.03, BATTEN_NET_FAIR_LEAST_CHANGE);
        options.hold = hold;
        CHECK_OK(batten_fair_net(grid_of(given), &options, NULL, &report, faired, &after));
        CHECK(report.points.after.excess_inflections < report.points.before.excess_inflections);
        CHECK(report.points.moved_count > 0);
        check_rim(before, after, hold);
        batten_net_fair_report_release(&report);
        batten_surface_unref(after);
    }
    batten_surface_unref(before);
}

TEST(nets_that_close_stay_closed_and_round_ones_round)
{
    enum { N = 16, M = 9 };
    test_random random = test_random_begin("closed net");
    double exact[3 * N * M], given[3 * N * M], faired[3 * N * M], out = 0, in = 0;
    batten_surface *surface = NULL;
    batten_net_fair_options options = uniform(0.02, BATTEN_NET_FAIR_ENERGY);
    batten_net_fair_report report = {0};
    options.closed_u = true;
    for (int n = 0; n < N * M; n++) {
        const double angle = 2 * acos(-1) * (n / M) / N;
        exact[3 * n] = cos(angle);
        exact[3 * n + 1] = sin(angle);
        exact[3 * n + 2] = 0.3 * (n % M);
    }
    memcpy(given, exact, sizeof given);
    shake(&random, 0.01, N * M, given);
    CHECK_OK(batten_fair_net((batten_grid){3, N, M, given}, &options, NULL, &report, faired,
                             &surface));
    CHECK(batten_surface_is_periodic(surface, BATTEN_U));
    CHECK(report.residual <= 1e-3);
    for (int n = 0; n < N * M; n++) {
        CHECK(moved(given, faired, n) <= 0.02);
        /* the radius, less what all of it shrank by */
        in += fabs(hypot(given[3 * n], given[3 * n + 1]) - 1);
        out += fabs(hypot(faired[3 * n], faired[3 * n + 1]) -
                    hypot(faired[3 * (n % M)], faired[3 * (n % M) + 1]));
    }
    CHECK(out < in);
    options.closed_u = false;
    options.closed_v = true;
    CHECK_OK(
        batten_fair_net((batten_grid){3, N, M, given}, &options, NULL, NULL, faired, NULL));
    batten_net_fair_report_release(&report);
    batten_surface_unref(surface);
}

TEST(a_symmetric_net_stays_symmetric_by_least_change)
{
    test_random random = test_random_begin("symmetric least change");
    double given[3 * NODES], faired[3 * NODES];
    const batten_net_fair_options options = uniform(0.03, BATTEN_NET_FAIR_LEAST_CHANGE);
    sheet(NU, NV, given);
    for (int n = 0; n < NODES; n++)
        given[3 * n + 2] = 1.2 * (given[3 * n] / 6) * (1 - given[3 * n] / 6);
    shake(&random, 0.02, NODES / 2, given);
    for (int n = 0; n < NODES / 2; n++) {
        const int m = (NU - 1 - n / NV) * NV + n % NV;
        given[3 * m] = 6 - given[3 * n];
        given[3 * m + 1] = given[3 * n + 1];
        given[3 * m + 2] = given[3 * n + 2];
    }
    CHECK_OK(batten_fair_net(grid_of(given), &options, NULL, NULL, faired, NULL));
    for (int n = 0; n < NODES / 2; n++) {
        const int m = (NU - 1 - n / NV) * NV + n % NV;
        CHECK_NEAR(faired[3 * m] + faired[3 * n], 6, 1e-5);
        CHECK_NEAR(faired[3 * m + 1], faired[3 * n + 1], 1e-5);
        CHECK_NEAR(faired[3 * m + 2], faired[3 * n + 2], 1e-5);
    }
}

/* ---- what is refused ---- */

static void check_refused(batten_grid grid, batten_net_fair_options options,
                          batten_status expected, const char *words)
{
    double faired[3 * NODES];
    memset(faired, 1, sizeof faired);
    const double before = faired[0];
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_fair_net(grid, &options, NULL, NULL, faired, &surface), expected);
    CHECK_MESSAGE(words);
    CHECK(!surface);
    CHECK_BITS(faired[0], before);
}

TEST(what_a_net_cannot_be_is_refused_with_its_place_and_number)
{
    static double points[3 * 32 * 32];
    double within[NODES];
    const batten_net_fair_options fine = uniform(0.1, BATTEN_NET_FAIR_ENERGY);
    batten_net_fair_options options = fine;
    sheet(NU, NV, points);
    check_refused((batten_grid){2, NU, NV, points}, fine, BATTEN_BAD_ARGUMENT,
                  "2 coordinates, not 3");
    check_refused((batten_grid){3, 3, NV, points}, fine, BATTEN_TOO_FEW_POINTS, "3 x 8 points");
    check_refused((batten_grid){3, NU, 3, points}, fine, BATTEN_TOO_FEW_POINTS,
                  "12 x 3 points");
    options.within = 0;
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT, "the bound is 0");
    options.within = INFINITY;
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT, "the bound is inf");
    for (int n = 0; n < NODES; n++)
        within[n] = n == 2 * NV + 5 ? -1 : 0.1;
    options = fine;
    options.within_each = within;
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT,
                  "the bound of point 3 of row 6 is -1");
    options = fine;
    options.hold = 2;
    check_refused(grid_of(points), options, BATTEN_UNSUPPORTED, "2 rows are to be held");
    options.hold = 4;
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT, "4 rows are to be held");
    options = fine;
    options.hold = -1;
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT,
                  "-1 rows are to be held at the rim, not 0 to 3");
    options = fine;
    options.method = (batten_net_fair_method)7;
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT, "no method 7");
    options.method = (batten_net_fair_method)-1;
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT, "no method -1");
    options.method = (batten_net_fair_method)(BATTEN_NET_FAIR_LEAST_CHANGE + 1);
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT, "there is no method");
    options = fine;
    options.within = NAN;
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT, "it must be above 0");
    options = fine;
    within[2 * NV + 5] = INFINITY;
    options.within_each = within;
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT,
                  "the bound of point 3 of row 6 is inf; it must be 0 or above");
    options = fine;
    options.parameters = BATTEN_GIVEN;
    check_refused(grid_of(points), options, BATTEN_BAD_ARGUMENT, "cannot be given");
    options = uniform(0.1, BATTEN_NET_FAIR_LEAST_CHANGE);
    options.closed_v = true;
    check_refused(grid_of(points), options, BATTEN_UNSUPPORTED, "the net closes");
    options.closed_u = true;
    check_refused(grid_of(points), options, BATTEN_UNSUPPORTED, "the net closes");
    options.closed_v = false;
    check_refused(grid_of(points), options, BATTEN_UNSUPPORTED, "the net closes");
    options.closed_u = false;
    sheet(32, 32, points);
    check_refused((batten_grid){3, 32, 32, points}, options, BATTEN_UNSUPPORTED,
                  "32 x 32 points");
    points[3 * (NV + 2)] = NAN;
    check_refused(grid_of(points), fine, BATTEN_NOT_FINITE, "");
}

TEST(the_smallest_net_may_hold_its_rim_and_have_bounds_of_nothing)
{
    double points[3 * 16], faired[3 * 16], within[16] = {0};
    batten_net_fair_options options = uniform(0.1, BATTEN_NET_FAIR_ENERGY);
    sheet(4, 4, points);
    options.hold = 1;
    CHECK_OK(
        batten_fair_net((batten_grid){3, 4, 4, points}, &options, NULL, NULL, faired, NULL));
    for (int n = 0; n < 16; n++) {
        const int i = n / 4, j = n % 4;
        if (i == 0 || i == 3 || j == 0 || j == 3)
            CHECK_BITS(moved(points, faired, n), 0);
    }
    options.hold = 0;
    options.within_each = within;
    CHECK_OK(
        batten_fair_net((batten_grid){3, 4, 4, points}, &options, NULL, NULL, faired, NULL));
    for (int n = 0; n < 16; n++)
        CHECK_BITS(moved(points, faired, n), 0);
}
