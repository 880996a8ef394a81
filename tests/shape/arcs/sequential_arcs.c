#include <batten/arcs.h>

#include "support/faults.h"
#include "support/test.h"

static const double pi = 3.14159265358979323846;

static const double ducks[] = {0, 0, 1, 0.5, 2, 0.6, 3.2, 0.3, 4, 0.5, 5, 1.4};

/* Each arc begins where, and as, the one before it ends, and all pass their points. */
static void check_arcs(const batten_chain *chain, int count, const double *points,
                       const double *angles, const double *parameters)
{
    CHECK_INT(batten_chain_span_count(chain), count - 1);
    for (int i = 0; i < count; i++) {
        double before[4], after[4];
        CHECK_OK(batten_chain_evaluate_side(chain, parameters[i], BATTEN_FROM_LEFT, 1, before));
        CHECK_OK(batten_chain_evaluate_side(chain, parameters[i], BATTEN_FROM_RIGHT, 1, after));
        for (int k = 0; k < 2; k++) {
            CHECK_NEAR(before[k], points[2 * i + k], 1e-13);
            CHECK_NEAR(after[k], points[2 * i + k], 1e-13);
            CHECK_NEAR(before[2 + k], after[2 + k], 1e-13);
        }
        CHECK_NEAR(after[2], cos(angles[i]), 1e-13);
        CHECK_NEAR(after[3], sin(angles[i]), 1e-13);
    }
}

TEST(arcs_one_after_another_pass_their_points)
{
    static const double starts[] = {NAN, 0, 0.7, -2, 3, 400};
    for (int i = 0; i < COUNT(starts); i++)
        for (int count = 2; count <= 6; count++) {
            double angles[6], parameters[6];
            batten_chain *chain = NULL;
            batten_chain_sequential_arcs_report report;
            CHECK_OK(batten_chain_sequential_arcs((batten_points){2, count, ducks}, starts[i],
                                                  angles, parameters, &report, &chain));
            check_arcs(chain, count, ducks, angles, parameters);
            if (!isnan(starts[i]))
                CHECK_NEAR(remainder(report.start_angle - starts[i], 2 * pi), 0, 1e-13);
            batten_chain_unref(chain);
        }
}

/* Section 8: theta_{i+1} = 2 phi_i - theta_i. */
TEST(a_turn_at_the_start_goes_on_undamped)
{
    double angles[6], turned[6];
    batten_chain *chain = NULL;
    batten_chain_sequential_arcs_report report;
    const double turn = 1e-6;
    CHECK_OK(batten_chain_sequential_arcs((batten_points){2, 6, ducks}, 0.5, angles, NULL,
                                          &report, &chain));
    double curvatures[5], most = 0;
    for (int i = 0; i < 5; i++)
        curvatures[i] = batten_chain_span(chain, i)->curvature[0];
    batten_chain_unref(chain);
    CHECK_OK(batten_chain_sequential_arcs((batten_points){2, 6, ducks}, 0.5 + turn, turned,
                                          NULL, NULL, &chain));
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(remainder(turned[i] - angles[i], 2 * pi), i % 2 == 0 ? turn : -turn, 1e-14);
    for (int i = 0; i < 5; i++)
        most = fmax(most, fabs(batten_chain_span(chain, i)->curvature[0] - curvatures[i]));
    CHECK_NEAR(most / turn, report.sensitivity, 1e-5 * report.sensitivity);
    const int at = report.sensitive_at;
    CHECK_NEAR(fabs(batten_chain_span(chain, at)->curvature[0] - curvatures[at]), most, 0);
    batten_chain_unref(chain);
}

static double sum_of_jumps(const batten_chain *chain)
{
    double sum = 0;
    for (int i = 1; i < batten_chain_span_count(chain); i++) {
        const double jump = batten_chain_span(chain, i)->curvature[0] -
                            batten_chain_span(chain, i - 1)->curvature[0];
        sum += jump * jump;
    }
    return sum;
}

/* On each side of the chord alike: a mirrored row of points has the mirrored start, and none of many others is better. */
TEST(the_best_start_of_mirrored_points_is_mirrored)
{
    test_random random = test_random_begin("sequential arcs");
    for (int c = 0; c < test_cases(40); c++) {
        double points[2][12];
        batten_chain_sequential_arcs_report report[2];
        for (int i = 0; i < 6; i++) {
            points[0][2 * i] = points[1][2 * i] = i + test_random_in(&random, -0.3, 0.3);
            points[0][2 * i + 1] = test_random_in(&random, -0.6, 0.6);
            points[1][2 * i + 1] = -points[0][2 * i + 1];
        }
        double least[2];
        for (int k = 0; k < 2; k++) {
            batten_chain *chain = NULL;
            CHECK_OK(batten_chain_sequential_arcs((batten_points){2, 6, points[k]}, NAN, NULL,
                                                  NULL, &report[k], &chain));
            least[k] = sum_of_jumps(chain);
            batten_chain_unref(chain);
        }
        CHECK_NEAR(least[0], least[1], 1e-9 * least[0]);
        CHECK_NEAR(remainder(report[0].start_angle + report[1].start_angle, 2 * pi), 0, 1e-6);
        for (int i = 0; i < 60; i++) {
            batten_chain *other = NULL;
            batten_chain_sequential_arcs_report of;
            if (batten_chain_sequential_arcs((batten_points){2, 6, points[0]}, 2 * pi * i / 60,
                                             NULL, NULL, &of, &other) != BATTEN_OK)
                continue;
            CHECK(of.long_arcs > report[0].long_arcs ||
                  sum_of_jumps(other) >= least[0] * (1 - 1e-12));
            batten_chain_unref(other);
        }
    }
}

TEST(no_other_start_without_loops_has_smaller_jumps)
{
    static const double flat[] = {0, 0, 1, 0.5, 2, 0.7, 3, 0.1};
    for (int row = 0; row < 2; row++) {
        const double *points = row ? flat : ducks;
        const int count = row ? 4 : 6;
        batten_chain *best = NULL;
        batten_chain_sequential_arcs_report report;
        CHECK_OK(batten_chain_sequential_arcs((batten_points){2, count, points}, NAN, NULL,
                                              NULL, &report, &best));
        CHECK_INT(report.long_arcs, 0);
        const double least = sum_of_jumps(best);
        batten_chain_unref(best);
        for (int i = 0; i < 500; i++) {
            batten_chain *other = NULL;
            const batten_status status = batten_chain_sequential_arcs(
                (batten_points){2, count, points}, 2 * pi * i / 500 + 0.001, NULL, NULL,
                &report, &other);
            if (status != BATTEN_OK) /* one arc a full circle, or no memory */
                continue;
            CHECK(report.long_arcs > 0 || sum_of_jumps(other) >= least * (1 - 1e-12));
            batten_chain_unref(other);
        }
    }
}

TEST(g2_points_of_a_circle_give_it_and_points_of_a_line_the_line)
{
    static const double at[] = {0, 0.3, 1.1, 1.4, 2.6, 3.9, 4.4};
    double ring[14], line[14], angles[7], parameters[7];
    batten_chain *chain = NULL;
    batten_chain_sequential_arcs_report report;
    for (int i = 0; i < 7; i++) {
        ring[2 * i] = 2 * cos(at[i]);
        ring[2 * i + 1] = 2 * sin(at[i]);
        line[2 * i] = at[i];
        line[2 * i + 1] = 1 - at[i] / 2;
    }
    for (int count = 3; count <= 7; count++) {
        CHECK_OK(batten_chain_sequential_arcs((batten_points){2, count, ring}, NAN, angles,
                                              parameters, &report, &chain));
        check_arcs(chain, count, ring, angles, parameters);
        for (int i = 0; i + 1 < count; i++)
            CHECK_NEAR(batten_chain_span(chain, i)->curvature[0], 0.5, 1e-12);
        CHECK_NEAR(report.jump, 0, 1e-12);
        batten_chain_unref(chain);
        CHECK_OK(batten_chain_sequential_arcs((batten_points){2, count, line}, NAN, NULL, NULL,
                                              &report, &chain));
        CHECK_NEAR(report.start_angle, atan2(-0.5, 1), 1e-13);
        CHECK_NEAR(report.jump, 0, 1e-12);
        batten_chain_unref(chain);
    }
}

TEST(n1_g1_bad_data_of_sequential_arcs_are_refused)
{
    double points[] = {0, 0, 1, 0, 2, 1};
    batten_chain *chain = NULL;
    CHECK_STATUS(batten_chain_sequential_arcs((batten_points){2, 1, points}, NAN, NULL, NULL,
                                              NULL, &chain),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_chain_sequential_arcs((batten_points){2, 3, points}, INFINITY, NULL,
                                              NULL, NULL, &chain),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_chain_sequential_arcs((batten_points){2, 3, points}, pi, NULL, NULL,
                                              NULL, &chain),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("from point 1 to point 2");
    points[2] = 0;
    CHECK_STATUS(batten_chain_sequential_arcs((batten_points){2, 3, points}, NAN, NULL, NULL,
                                              NULL, &chain),
                 BATTEN_COINCIDENT);
    points[2] = NAN;
    CHECK_STATUS(batten_chain_sequential_arcs((batten_points){2, 3, points}, NAN, NULL, NULL,
                                              NULL, &chain),
                 BATTEN_NOT_FINITE);
    CHECK(!chain);
}

/* Starts, and what the report says of three points with a right angle between two chords of 2: an arc of
 * angle a from its chord l has the curvature -2 sin(a) / l. */
static const struct {
    double start, jump, sensitivity;
    int sensitive_at, long_arcs;
    double parameters[3];
} reports[] = {
    {0, 1, 1, 0, 0, {0, 2, 2 + 3.14159265358979323846}},
    {0.78539816339744831,
     1.4142135623730951,
     0.70710678118654757,
     0,
     1,
     {0, 2.2214414690791831, 8.8857658763167324}},
    {-0.78539816339744831,
     0,
     0.70710678118654757,
     0,
     0,
     {0, 2.2214414690791831, 4.4428829381583661}},
};

TEST(the_report_of_arcs_one_after_another_has_their_jump_and_what_moves_most)
{
    static const double points[6] = {0, 0, 2, 0, 2, 2};
    for (int i = 0; i < COUNT(reports); i++) {
        double angles[3], parameters[3];
        batten_chain *chain = NULL;
        batten_chain_sequential_arcs_report report;
        CHECK_OK(batten_chain_sequential_arcs((batten_points){2, 3, points}, reports[i].start,
                                              angles, parameters, &report, &chain));
        CHECK_NEAR(report.start_angle, reports[i].start, 1e-15);
        CHECK_NEAR(report.jump, reports[i].jump, 1e-15);
        CHECK_NEAR(report.sensitivity, reports[i].sensitivity, 1e-15);
        CHECK_INT(report.long_arcs, reports[i].long_arcs);
        if (i == 0)
            CHECK_INT(report.sensitive_at, reports[i].sensitive_at);
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(parameters[k], reports[i].parameters[k], 1e-14);
        CHECK_NEAR(angles[1], -reports[i].start, 1e-15);
        batten_chain_unref(chain);
    }
}

TEST(arcs_one_after_another_report_every_lack_of_memory)
{
    batten_chain *chain = NULL;
    double angles[6], parameters[6];
    CHECK_EACH_ALLOCATION(batten_chain_sequential_arcs((batten_points){2, 6, ducks}, NAN,
                                                       angles, parameters, NULL, &chain));
    batten_chain_unref(chain);
}
