#include <batten/arcs.h>

#include "support/test.h"

static void circle(int count, const double *angles, double r, double *points)
{
    for (int i = 0; i < count; i++) {
        points[2 * i] = 5 + r * cos(angles[i]);
        points[2 * i + 1] = 1 + r * sin(angles[i]);
    }
}

TEST(biarcs_through_points_of_a_circle_are_the_circle)
{
    static const double angles[] = {0, 0.4, 1.5, 1.7, 2.9, 4.4};
    double points[12], parameters[6], at[2];
    circle(6, angles, 3, points);
    for (int closed = 0; closed < 2; closed++) {
        batten_chain_biarcs_options options = batten_chain_biarcs_defaults();
        batten_chain_biarcs_report report;
        batten_chain *chain = NULL, *merged = NULL;
        options.closed = closed;
        CHECK_OK(batten_chain_biarcs((batten_points){2, 6, points}, &options, parameters,
                                     &report, &chain));
        CHECK(report.error < 1e-14);
        CHECK_NEAR(report.least_radius, 3, 1e-13);
        CHECK_NEAR(report.largest_jump, 0, 1e-14);
        const batten_interval domain = batten_chain_domain(chain);
        for (int i = 0; i <= 50; i++) {
            CHECK_OK(
                batten_chain_evaluate(chain, domain.a + (domain.b - domain.a) * i / 50, 0, at));
            CHECK_NEAR(hypot(at[0] - 5, at[1] - 1), 3, 1e-13);
        }
        for (int i = 0; i < 6; i++)
            CHECK_NEAR(parameters[i], 3 * angles[i], 1e-12);
        CHECK_OK(batten_chain_merge_arcs(chain, 0, &merged));
        CHECK_INT(batten_chain_span_count(merged), closed ? 2 : 1);
        batten_chain_unref(merged);
        batten_chain_unref(chain);
    }
}

TEST(biarcs_through_collinear_points_are_the_line)
{
    const double points[] = {0, 0, 1, 0.5, 4, 2, 5, 2.5};
    batten_chain_biarcs_report report;
    batten_chain *chain = NULL, *merged = NULL;
    CHECK_OK(batten_chain_biarcs((batten_points){2, 4, points}, NULL, NULL, &report, &chain));
    CHECK_NEAR(1 / report.least_radius, 0, 1e-15);
    CHECK_OK(batten_chain_merge_arcs(chain, 0, &merged));
    CHECK_INT(batten_chain_span_count(merged), 1);
    CHECK_NEAR(batten_chain_span(merged, 0)->length, hypot(5, 2.5), 1e-14);
    batten_chain_unref(merged);
    batten_chain_unref(chain);
}

TEST(g2_biarcs_through_two_points_are_a_line)
{
    const double points[] = {1, 1, 4, 5};
    batten_chain_biarcs_report report;
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_biarcs((batten_points){2, 2, points}, NULL, NULL, &report, &chain));
    CHECK_INT(report.lines, 1);
    CHECK_INT(report.arcs, 0);
    CHECK_NEAR(batten_chain_domain(chain).b, 5, 1e-15);
    batten_chain_unref(chain);
    CHECK_STATUS(batten_chain_biarcs((batten_points){2, 1, points}, NULL, NULL, NULL, &chain),
                 BATTEN_TOO_FEW_POINTS);
}

TEST(biarcs_through_points_are_smooth_with_every_joint)
{
    test_random random = test_random_begin("biarc chains");
    for (int c = 0; c < test_cases(60); c++) {
        double points[20], directions[20], parameters[10], at[4], next[4];
        const int n = test_random_int(&random, 3, 10);
        for (int i = 0; i < n; i++) {
            points[2 * i] = i + test_random_in(&random, -0.3, 0.3);
            points[2 * i + 1] = test_random_in(&random, -1, 1);
            const double angle = test_random_in(&random, -1, 1);
            directions[2 * i] = cos(angle);
            directions[2 * i + 1] = sin(angle);
        }
        batten_chain_biarcs_options options = batten_chain_biarcs_defaults();
        options.joint = (batten_biarc_joint)(c % 6);
        options.place = 0.4;
        options.closed = c % 3 == 0;
        options.directions = c % 2 ? directions : NULL;
        batten_chain_biarcs_report report;
        batten_chain *chain = NULL;
        CHECK_OK(batten_chain_biarcs((batten_points){2, n, points}, &options, parameters,
                                     &report, &chain));
        CHECK(report.error < 1e-9);
        const int count = batten_chain_span_count(chain);
        CHECK_INT(report.arcs + report.lines, count);
        for (int i = 1; i < count; i++) {
            const double u = batten_chain_breaks(chain)[i];
            CHECK_OK(batten_chain_evaluate_side(chain, u, BATTEN_FROM_LEFT, 1, at));
            CHECK_OK(batten_chain_evaluate_side(chain, u, BATTEN_FROM_RIGHT, 1, next));
            CHECK_NEAR(at[2], next[2], 1e-12);
            CHECK_NEAR(at[3], next[3], 1e-12);
        }
        for (int i = 0; i < n; i++) {
            CHECK_OK(batten_chain_evaluate(chain, parameters[i], 1, at));
            CHECK_NEAR(at[0], points[2 * i], 1e-9);
            CHECK_NEAR(at[1], points[2 * i + 1], 1e-9);
            if (options.directions)
                CHECK_NEAR(at[2], directions[2 * i], 1e-12);
        }
        batten_chain_unref(chain);
    }
}

TEST(g10_reversed_points_give_the_reversed_biarcs)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 3, 6, 0};
    double back[10], at[2], there[2];
    for (int i = 0; i < 5; i++) {
        back[2 * i] = points[8 - 2 * i];
        back[2 * i + 1] = points[9 - 2 * i];
    }
    batten_chain *chain = NULL, *reversed = NULL;
    CHECK_OK(batten_chain_biarcs((batten_points){2, 5, points}, NULL, NULL, NULL, &chain));
    CHECK_OK(batten_chain_biarcs((batten_points){2, 5, back}, NULL, NULL, NULL, &reversed));
    const double length = batten_chain_domain(chain).b;
    CHECK_NEAR(batten_chain_domain(reversed).b, length, 1e-13);
    for (int i = 0; i <= 100; i++) {
        CHECK_OK(batten_chain_evaluate(chain, length * i / 100, 0, at));
        CHECK_OK(batten_chain_evaluate(
            reversed, fmin(length * (100 - i) / 100, batten_chain_domain(reversed).b), 0,
            there));
        CHECK_NEAR(at[0], there[0], 1e-12);
        CHECK_NEAR(at[1], there[1], 1e-12);
    }
    batten_chain_unref(chain);
    batten_chain_unref(reversed);
}

TEST(g1_coincident_points_are_named_by_biarcs)
{
    const double points[] = {0, 0, 1, 1, 1, 1, 2, 0}, back[] = {0, 0, 1, 0, 0, 0, 2, 2};
    const double bad[] = {0, 0, 1, NAN, 2, 2}, zero[] = {1, 0, 0, 0, 1, 0};
    batten_chain *chain = NULL;
    CHECK_STATUS(batten_chain_biarcs((batten_points){2, 4, points}, NULL, NULL, NULL, &chain),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3");
    CHECK_STATUS(batten_chain_biarcs((batten_points){2, 4, back}, NULL, NULL, NULL, &chain),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("point 2");
    CHECK_STATUS(batten_chain_biarcs((batten_points){2, 3, bad}, NULL, NULL, NULL, &chain),
                 BATTEN_NOT_FINITE);
    batten_chain_biarcs_options options = batten_chain_biarcs_defaults();
    options.directions = zero;
    CHECK_STATUS(batten_chain_biarcs((batten_points){2, 3, back}, &options, NULL, NULL, &chain),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("direction 2");
    options = batten_chain_biarcs_defaults();
    options.joint = BATTEN_JOINT_GIVEN;
    options.place = 2;
    CHECK_STATUS(batten_chain_biarcs((batten_points){2, 3, zero}, &options, NULL, NULL, &chain),
                 BATTEN_BAD_ARGUMENT);
    CHECK(!chain);
}
