#include <batten/arcs.h>

#include "support/faults.h"
#include "support/test.h"

static batten_arcs_options within(double tolerance, batten_arcs_join joined)
{
    batten_arcs_options options = batten_arcs_defaults();
    options.tolerance = tolerance;
    options.joined = joined;
    return options;
}

/* Every point lies as near to the chain as the report says, at its parameter. */
static void check_points(int count, const double *points, const double *parameters,
                         const batten_chain *chain, const batten_arcs_report *report,
                         double tolerance)
{
    CHECK(report->error <= tolerance * (1 + 1e-9) + 1e-13);
    double largest = 0;
    for (int i = 0; i < count; i++) {
        double at[2];
        CHECK_OK(batten_chain_evaluate(chain, parameters[i], 0, at));
        largest = fmax(largest, hypot(at[0] - points[2 * i], at[1] - points[2 * i + 1]));
        CHECK(i == 0 || parameters[i] > parameters[i - 1]);
    }
    CHECK_NEAR(largest, report->error, 1e-6 * tolerance + 1e-12);
}

TEST(arcs_pass_points_of_a_wave_within_the_tolerance)
{
    enum { N = 400 };
    double *points = test_array(N, 2 * sizeof *points), *at = test_array(N, sizeof *at);
    for (int i = 0; i < N; i++) {
        points[2 * i] = 10.0 * i / (N - 1);
        points[2 * i + 1] = sin(points[2 * i]);
    }
    for (int joined = 0; joined < 2; joined++)
        for (int side = 0; side <= BATTEN_ARCS_RIGHT; side++) {
            int before = 0;
            for (int e = 1; e <= 4; e++) {
                batten_arcs_options options = within(pow(10, -e), (batten_arcs_join)joined);
                batten_arcs_report report;
                batten_chain *chain = NULL;
                options.side = (batten_arcs_side)side;
                CHECK_OK(batten_arcs_from_points((batten_points){2, N, points}, &options, at,
                                                 &report, &chain));
                check_points(N, points, at, chain, &report, options.tolerance);
                CHECK(report.arcs + report.lines > before);
                CHECK(side != BATTEN_ARCS_LEFT || report.right < 1e-13);
                CHECK(side != BATTEN_ARCS_RIGHT || report.left < 1e-13);
                before = report.arcs + report.lines;
                batten_chain_unref(chain);
            }
            CHECK(before < 120);
        }
}

TEST(g2_points_on_a_circle_or_line_are_one_arc_or_line)
{
    double circle[2 * 9], line[2 * 9];
    for (int i = 0; i < 9; i++) {
        const double angle = 0.3 * i + 0.01 * i * i;
        circle[2 * i] = 4 * cos(angle);
        circle[2 * i + 1] = 4 * sin(angle);
        line[2 * i] = 3 * angle;
        line[2 * i + 1] = 4 * angle;
    }
    for (int joined = 0; joined < 2; joined++) {
        const batten_arcs_options options = within(1e-6, (batten_arcs_join)joined);
        batten_arcs_report report;
        batten_chain *chain = NULL;
        CHECK_OK(batten_arcs_from_points((batten_points){2, 9, circle}, &options, NULL, &report,
                                         &chain));
        CHECK_INT(report.arcs, 1);
        CHECK_NEAR(report.least_radius, 4, 1e-11);
        batten_chain_unref(chain);
        CHECK_OK(batten_arcs_from_points((batten_points){2, 9, line}, &options, NULL, &report,
                                         &chain));
        CHECK_INT(report.arcs, 0);
        CHECK_INT(report.lines, 1);
        batten_chain_unref(chain);
        CHECK_OK(batten_arcs_from_points((batten_points){2, 2, line}, &options, NULL, &report,
                                         &chain));
        CHECK_INT(report.lines, 1);
        batten_chain_unref(chain);
    }
}

TEST(closed_rows_of_points_have_an_inside)
{
    enum { N = 100 };
    double points[2 * N], at[N];
    for (int i = 0; i < N; i++) {
        const double t = 2 * acos(-1) * i / N;
        points[2 * i] = 2 * cos(t);
        points[2 * i + 1] = -sin(t); /* clockwise */
    }
    for (int joined = 0; joined < 2; joined++) {
        batten_arcs_options options = within(1e-2, (batten_arcs_join)joined);
        batten_arcs_report report;
        batten_chain *chain = NULL;
        options.closed = true;
        options.side = BATTEN_ARCS_INSIDE;
        CHECK_OK(batten_arcs_from_points((batten_points){2, N, points}, &options, at, &report,
                                         &chain));
        CHECK(batten_chain_is_closed(chain));
        CHECK(report.left < 1e-13 && report.right > 1e-3);
        check_points(N, points, at, chain, &report, 1e-2);
        batten_chain_unref(chain);
    }
}

TEST(rough_points_are_passed_by_few_plain_arcs)
{
    enum { N = 300 };
    double *points = test_array(N, 2 * sizeof *points), *at = test_array(N, sizeof *at);
    test_random random = test_random_begin("rough points");
    for (int i = 0; i < N; i++) {
        const double angle = 2.5 * i / (N - 1), r = 5 + test_random_in(&random, -1e-3, 1e-3);
        points[2 * i] = r * cos(angle);
        points[2 * i + 1] = r * sin(angle);
    }
    const batten_arcs_options options = within(2.5e-3, BATTEN_ARCS_PLAIN);
    batten_arcs_report report;
    batten_chain *chain = NULL;
    CHECK_OK(
        batten_arcs_from_points((batten_points){2, N, points}, &options, at, &report, &chain));
    CHECK_INT(report.arcs, 1);
    CHECK(report.error <= 2.5e-3);
    batten_chain_unref(chain);
}

TEST(g1_coincident_points_are_named_by_arcs)
{
    const double same[] = {0, 0, 1, 1, 1, 1, 2, 0}, back[] = {0, 0, 1, 0, 0, 0};
    const double bad[] = {0, 0, INFINITY, 1};
    const batten_arcs_options options = within(0.1, BATTEN_ARCS_PLAIN);
    batten_chain *chain = NULL;
    CHECK_STATUS(
        batten_arcs_from_points((batten_points){2, 4, same}, &options, NULL, NULL, &chain),
        BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3");
    CHECK_STATUS(
        batten_arcs_from_points((batten_points){2, 3, back}, &options, NULL, NULL, &chain),
        BATTEN_SINGULAR_HERE);
    CHECK_STATUS(
        batten_arcs_from_points((batten_points){2, 2, bad}, &options, NULL, NULL, &chain),
        BATTEN_NOT_FINITE);
    CHECK_STATUS(
        batten_arcs_from_points((batten_points){2, 1, same}, &options, NULL, NULL, &chain),
        BATTEN_TOO_FEW_POINTS);
    batten_arcs_options inside = options;
    inside.side = BATTEN_ARCS_INSIDE;
    CHECK_STATUS(
        batten_arcs_from_points((batten_points){2, 2, same}, &inside, NULL, NULL, &chain),
        BATTEN_BAD_ARGUMENT);
    CHECK(!chain);
}

TEST(the_stretch_of_a_closed_row_without_an_arc_ends_at_point_1)
{
    static const double row[] = {0, 0, 1, 1, 2, 1.6, 3, 1.9, 5, 1.5, 6, 0.8, 7, -1};
    batten_arcs_options options = within(0.3, BATTEN_ARCS_PLAIN);
    batten_chain *chain = NULL;
    options.closed = true;
    CHECK_STATUS(
        batten_arcs_from_points((batten_points){2, 7, row}, &options, NULL, NULL, &chain),
        BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("between points 7 and 1 no arcs");
}

/* An ellipse run either way: inside is left of one that runs counter-clockwise. */
TEST(inside_and_outside_follow_the_sense_of_a_closed_row)
{
    enum { N = 60 };
    for (int row = 0; row < 8; row++) {
        const bool clockwise = row & 1, outside = row & 2;
        double points[2 * N], at[N];
        for (int i = 0; i < N; i++) {
            const double t = (clockwise ? -2 : 2) * acos(-1) * i / N;
            points[2 * i] = 7 + 2 * cos(t);
            points[2 * i + 1] = -3 + sin(t);
        }
        batten_arcs_options options =
            within(1e-2, row & 4 ? BATTEN_ARCS_PLAIN : BATTEN_ARCS_BIARCS);
        options.closed = true;
        options.side = outside ? BATTEN_ARCS_OUTSIDE : BATTEN_ARCS_INSIDE;
        batten_arcs_report report;
        batten_chain *chain = NULL;
        CHECK_OK(batten_arcs_from_points((batten_points){2, N, points}, &options, at, &report,
                                         &chain));
        const double on = clockwise == outside ? report.left : report.right;
        const double off = clockwise == outside ? report.right : report.left;
        CHECK(on > 1e-3 && off < 1e-13);
        CHECK_NEAR(report.error, on, 1e-15);
        check_points(N, points, at, chain, &report, 1e-2);
        batten_chain_unref(chain);
    }
}

/* One line past two points beside it: it lies right of one that is to its left. */
TEST(the_report_names_the_point_that_arcs_miss_most)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        double points[2 * 9], at[9];
        for (int i = 0; i < 9; i++) {
            points[2 * i] = i;
            points[2 * i + 1] = i == 3 ? sign * 0.02 : i == 6 ? -sign * 0.01 : 0;
        }
        batten_arcs_options options = within(0.1, BATTEN_ARCS_PLAIN);
        options.spread = false;
        batten_arcs_report report;
        batten_chain *chain = NULL;
        CHECK_OK(batten_arcs_from_points((batten_points){2, 9, points}, &options, at, &report,
                                         &chain));
        CHECK_INT(report.lines, 1);
        CHECK_INT(report.at, 3);
        CHECK_NEAR(report.error, 0.02, 1e-15);
        CHECK_NEAR(report.left, sign > 0 ? 0.01 : 0.02, 1e-15);
        CHECK_NEAR(report.right, sign > 0 ? 0.02 : 0.01, 1e-15);
        for (int i = 0; i < 9; i++)
            CHECK_NEAR(at[i], i, 1e-15);
        batten_chain_unref(chain);
    }
}

TEST(arcs_through_points_report_every_lack_of_memory)
{
    static const double row[] = {0, 0, 1, 0.8, 2, 1, 3, 0.4, 4, -1, 5, -1.5, 6, -1, 7, 1};
    static const double ring[] = {0, 0, 2, -1, 4, -1, 6, 0, 7, 2, 5, 4, 2, 4, 0, 2};
    for (int k = 0; k < 3; k++) {
        batten_arcs_options options =
            within(0.5, k & 1 ? BATTEN_ARCS_PLAIN : BATTEN_ARCS_BIARCS);
        options.closed = k & 2;
        double at[8];
        batten_chain *chain = NULL;
        CHECK_EACH_ALLOCATION(batten_arcs_from_points(
            (batten_points){2, 8, options.closed ? ring : row}, &options, at, NULL, &chain));
        batten_chain_unref(chain);
    }
}
