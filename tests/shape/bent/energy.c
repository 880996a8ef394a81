#include <batten/bent.h>

#include "support/test.h"

static const double pi = 3.14159265358979323846;

static batten_curve *find(int d, int count, const double *points,
                          const batten_curve_minimum_energy_options *options,
                          double *parameters, batten_curve_minimum_energy_report *report)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_minimum_energy((batten_points){d, count, points}, options, parameters,
                                         report, &curve));
    return curve;
}

static batten_curve_minimum_energy_options of(batten_energy energy, bool scale_invariant)
{
    batten_curve_minimum_energy_options options = batten_curve_minimum_energy_defaults();
    options.energy = energy;
    options.scale_invariant = scale_invariant;
    return options;
}

static const double arch[] = {0, 0, 1, 0.6, 2, 0.1};

static void wave(int d, int count, double *points)
{
    for (int i = 0; i < count; i++) {
        points[i * d] = i + 0.2 * sin(3.0 * i);
        points[i * d + 1] = 0.5 * sin(0.9 * i);
        if (d == 3)
            points[i * d + 2] = 0.4 * cos(0.7 * i);
    }
}

/* ---- oracles ---- */

TEST(least_bending_through_three_points_comes_down_to_the_elastica)
{
    /* The exact least is that of the mechanical spline; quintics approach it from above. */
    const double excess[] = {2e-7, 2e-9, 1e-10};
    for (int i = 0; i < 3; i++) {
        batten_curve_minimum_energy_options options = of(BATTEN_ENERGY_BENDING, false);
        batten_curve_minimum_energy_report report;
        options.pieces = 1 << i;
        batten_curve_unref(find(2, 3, arch, &options, NULL, &report));
        CHECK(report.after > 1.284473086 && report.after < 1.284473087 + excess[i]);
        /* It begins with the elastica. */
        CHECK(report.before < 1.285);
        CHECK(report.remaining < 2e-12);
    }
}

TEST(points_of_a_circle_give_the_circle_of_least_variation)
{
    const double at[] = {0, 0.5, 1.3, 1.9, 3};
    double points[10], p[2], u[5];
    for (int i = 0; i < 5; i++) {
        points[2 * i] = 3 + 2 * cos(at[i]);
        points[2 * i + 1] = 1 + 2 * sin(at[i]);
    }
    batten_curve_minimum_energy_report report;
    batten_curve *curve = find(2, 5, points, NULL, u, &report);
    /* What is left is how far quintics are from arcs. */
    CHECK(report.after < 1e-10);
    CHECK_NEAR(report.length, 6, 1e-8);
    for (int i = 0; i <= 100; i++) {
        CHECK_OK(batten_curve_evaluate(curve, u[4] * i / 100, 0, p));
        CHECK_NEAR(hypot(p[0] - 3, p[1] - 1), 2, 4e-9);
    }
    batten_curve_unref(curve);
}

TEST(g2_three_points_give_the_arc_of_least_variation_in_space_too)
{
    const double points[] = {1, 0, 0, 0, 0.6, 0.8, -0.6, 0.48, 0.64};
    double u[3], p[3];
    batten_curve_minimum_energy_report report;
    batten_curve *curve = find(3, 3, points, NULL, u, &report);
    CHECK(report.after < 1e-8);
    for (int i = 0; i <= 100; i++) {
        CHECK_OK(batten_curve_evaluate(curve, u[2] * i / 100, 0, p));
        CHECK_NEAR(hypot(p[0], hypot(p[1], p[2])), 1, 3e-7);
        CHECK_NEAR(0.8 * p[1] - 0.6 * p[2], 0, 1e-12);
    }
    batten_curve_unref(curve);
}

TEST(the_closed_curve_through_a_square_of_least_bending_by_length_is_the_circle)
{
    const double square[] = {3, 0, 0, 3, -3, 0, 0, -3};
    batten_curve_minimum_energy_options options = of(BATTEN_ENERGY_BENDING, true);
    batten_curve_minimum_energy_report report;
    options.closed = true;
    batten_curve *curve = find(2, 4, square, &options, NULL, &report);
    CHECK_NEAR(report.after, 4 * pi * pi, 1e-8);
    CHECK_NEAR(report.length, 6 * pi, 1e-6);
    const batten_interval domain = batten_curve_domain(curve);
    double first[6], last[6];
    CHECK_OK(batten_curve_evaluate(curve, domain.a, 2, first));
    CHECK_OK(batten_curve_evaluate(curve, domain.b, 2, last));
    for (int k = 0; k < 6; k++)
        CHECK_NEAR(first[k], last[k], 1e-9);
    batten_curve_unref(curve);
    options.energy = BATTEN_ENERGY_VARIATION;
    options.scale_invariant = false;
    batten_curve_unref(find(2, 4, square, &options, NULL, &report));
    CHECK(report.after < 1e-6);
}

TEST(a_helix_of_least_variation_stays_near_the_helix)
{
    double points[30], u[10], p[3];
    for (int i = 0; i < 10; i++) {
        points[3 * i] = cos(0.7 * i);
        points[3 * i + 1] = sin(0.7 * i);
        points[3 * i + 2] = 0.3 * i;
    }
    batten_curve_minimum_energy_report report;
    batten_curve *curve = find(3, 10, points, NULL, u, &report);
    /* k torsion of the helix with radius 1 and slope c = 0.3 / 0.7; the ends are free. */
    const double c = 0.3 / 0.7, w = 1 + c * c, density = (1 / w) * (c / w);
    CHECK(report.after < density * density * report.length);
    CHECK(report.after > 0.8 * density * density * report.length);
    for (int i = 20; i <= 80; i++) {
        CHECK_OK(batten_curve_evaluate(curve, u[9] * i / 100, 0, p));
        CHECK_NEAR(hypot(p[0], p[1]), 1, 2e-3);
    }
    batten_curve_unref(curve);
}

TEST(the_curve_of_least_variation_is_near_spiro_and_no_worse)
{
    double points[24], u[12];
    wave(2, 12, points);
    for (int closed = 0; closed < 2; closed++) {
        batten_curve_minimum_energy_options options = of(BATTEN_ENERGY_VARIATION, false);
        batten_chain_spiro_options spiro = batten_chain_spiro_defaults();
        options.pieces = 4;
        options.closed = spiro.closed = closed;
        if (closed)
            for (int i = 0; i < 12; i++) {
                points[2 * i] = (2 + 0.2 * sin(2.0 * i)) * cos(pi * i / 6);
                points[2 * i + 1] = (2 + 0.2 * sin(2.0 * i)) * sin(pi * i / 6);
            }
        batten_curve_minimum_energy_report report;
        batten_chain_spiro_report beside;
        batten_chain *chain = NULL;
        CHECK_OK(
            batten_chain_spiro((batten_points){2, 12, points}, &spiro, NULL, &beside, &chain));
        batten_chain_unref(chain);
        batten_curve_unref(find(2, 12, points, &options, u, &report));
        CHECK(report.after < beside.variation);
        CHECK(report.after > 0.9 * beside.variation);
    }
}

/* ---- properties ---- */

TEST(the_parameter_of_a_curve_of_least_energy_is_all_but_its_arc_length)
{
    double points[36], u[12], at[6];
    for (int c = 0; c < 4; c++) {
        const int d = 2 + c % 2;
        const batten_curve_minimum_energy_options options = of((batten_energy)(c / 2), false);
        wave(d, 12, points);
        batten_curve_minimum_energy_report report;
        batten_curve *curve = find(d, 12, points, &options, u, &report);
        CHECK_NEAR(u[11] / report.length, 1, 1e-4);
        for (int i = 0; i <= 100; i++) {
            CHECK_OK(batten_curve_evaluate(curve, u[11] * i / 100, 1, at));
            CHECK_NEAR(hypot(hypot(at[d], at[d + 1]), d == 3 ? at[5] : 0), 1, 0.02);
        }
        batten_curve_unref(curve);
    }
}

TEST(curves_of_least_energy_pass_the_points_and_are_smooth)
{
    double points[36], u[12];
    for (int c = 0; c < 8; c++) {
        const int d = 2 + c % 2;
        const batten_curve_minimum_energy_options options =
            of((batten_energy)(c / 2 % 2), c / 4);
        wave(d, 12, points);
        batten_curve_minimum_energy_report report;
        batten_curve *curve = find(d, 12, points, &options, u, &report);
        CHECK(report.after < report.before);
        for (int i = 0; i < 12; i++) {
            double left[9], right[9];
            CHECK_OK(batten_curve_evaluate_side(curve, u[i], BATTEN_FROM_LEFT, 2, left));
            CHECK_OK(batten_curve_evaluate_side(curve, u[i], BATTEN_FROM_RIGHT, 2, right));
            for (int k = 0; k < 3 * d; k++)
                CHECK_NEAR(left[k], k < d ? points[i * d + k] : right[k], 1e-10);
        }
        batten_curve_unref(curve);
    }
}

TEST(g10_least_energy_follows_reversal_and_scale)
{
    double points[16], changed[16];
    wave(2, 8, points);
    for (int c = 0; c < 4; c++) {
        const batten_curve_minimum_energy_options options = of((batten_energy)(c % 2), c / 2);
        batten_curve_minimum_energy_report report, other;
        batten_curve_unref(find(2, 8, points, &options, NULL, &report));
        for (int i = 0; i < 8; i++)
            for (int k = 0; k < 2; k++)
                changed[2 * i + k] = points[2 * (7 - i) + k];
        batten_curve_unref(find(2, 8, changed, &options, NULL, &other));
        CHECK_NEAR(other.after / report.after, 1, 1e-9);
        for (int i = 0; i < 16; i++)
            changed[i] = 1e5 * points[i] + 7e6;
        batten_curve_unref(find(2, 8, changed, &options, NULL, &other));
        const double by = c / 2 ? 1 : c % 2 ? 1e-15 : 1e-5;
        CHECK_NEAR(other.after / (by * report.after), 1, 1e-7);
    }
}

TEST(tension_makes_a_curve_of_least_bending_shorter)
{
    double before = HUGE_VAL;
    for (double tension = 0; tension < 300; tension = 3 * tension + 1) {
        batten_curve_minimum_energy_options options = of(BATTEN_ENERGY_BENDING, false);
        batten_curve_minimum_energy_report report;
        options.tension = tension;
        batten_curve_unref(find(2, 3, arch, &options, NULL, &report));
        CHECK(report.length < before);
        before = report.length;
    }
    CHECK(before > hypot(1, 0.6) + hypot(1, 0.5));
}

TEST(curves_of_least_energy_have_the_tangents_and_curvatures_given)
{
    const double tangent[] = {0, 2, 1}, curvature[] = {0.3, 0.2, -0.4}, flat[] = {1, 0, 0};
    double points[15], u[5], at[9];
    wave(3, 5, points);
    for (int energy = 0; energy < 2; energy++) {
        batten_curve_minimum_energy_options options = of((batten_energy)energy, false);
        options.start_tangent = tangent;
        options.start_curvature = curvature;
        options.end_tangent = flat;
        batten_curve *curve = find(3, 5, points, &options, u, NULL);
        CHECK_OK(batten_curve_evaluate(curve, 0, 2, at));
        const double speed = hypot(at[3], hypot(at[4], at[5]));
        CHECK_NEAR(at[3], 0, 1e-12);
        CHECK_NEAR(at[4] / speed, 2 / sqrt(5), 1e-12);
        /* The part of P'' across the tangent. */
        const double along = (at[6] * at[3] + at[7] * at[4] + at[8] * at[5]) / (speed * speed);
        for (int k = 0; k < 3; k++)
            CHECK_NEAR((at[6 + k] - along * at[3 + k]) / (speed * speed), curvature[k], 1e-10);
        CHECK_OK(batten_curve_evaluate(curve, u[4], 1, at));
        CHECK_NEAR(hypot(at[4], at[5]), 0, 1e-12);
        CHECK(at[3] > 0);
        batten_curve_unref(curve);
    }
}

/* ---- bad input ---- */

TEST(g2_points_on_a_line_give_the_line_of_least_energy)
{
    const double pair[] = {1, 2, 4, 6}, row[] = {0, 0, 1, 2, 3, 6, 3.5, 7};
    for (int energy = 0; energy < 2; energy++) {
        const batten_curve_minimum_energy_options options = of((batten_energy)energy, false);
        batten_curve_minimum_energy_report report;
        double u[4], p[2];
        batten_curve *curve = find(2, 2, pair, &options, u, &report);
        CHECK_NEAR(report.length, 5, 1e-14);
        batten_curve_unref(curve);
        curve = find(2, 4, row, &options, u, &report);
        CHECK_NEAR(report.after, 0, 1e-20);
        for (int i = 0; i <= 20; i++) {
            CHECK_OK(batten_curve_evaluate(curve, u[3] * i / 20, 0, p));
            CHECK_NEAR(p[1], 2 * p[0], 1e-12);
        }
        batten_curve_unref(curve);
    }
}

TEST(points_on_a_line_that_turn_back_are_refused)
{
    static const double line[] = {0, 0, 1, 2, 3, 6, 2, 4},
                        space[] = {0, 0, 0, 1, 1, 1, 4, 4, 4};
    const batten_curve_minimum_energy_options open = of(BATTEN_ENERGY_BENDING, false);
    batten_curve_minimum_energy_options closed = of(BATTEN_ENERGY_VARIATION, false);
    batten_curve *curve = NULL;
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){2, 4, line}, &open, NULL, NULL, &curve),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("turns back at point 3");
    closed.closed = true;
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){3, 3, space}, &closed, NULL, NULL, &curve),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("all points lie on one line");
    CHECK(!curve);
}

TEST(g1_coincident_points_are_named_by_least_energy)
{
    const double points[] = {0, 0, 1, 1, 1, 1, 2, 0};
    batten_curve *curve = NULL;
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){2, 4, points}, NULL, NULL, NULL, &curve),
        BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3");
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){2, 1, points}, NULL, NULL, NULL, &curve),
        BATTEN_TOO_FEW_POINTS);
    CHECK(!curve);
}

TEST(n1_options_of_least_energy_that_are_not_allowed_are_refused)
{
    const double bad[] = {0, 0, NAN, 1, 2, 0}, none[] = {0, 0};
    batten_curve *curve = NULL;
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){2, 3, bad}, NULL, NULL, NULL, &curve),
        BATTEN_NOT_FINITE);
    batten_curve_minimum_energy_options options = of(BATTEN_ENERGY_BENDING, false);
    options.tension = -1;
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){2, 3, arch}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    options.tension = 1;
    options.scale_invariant = true;
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){2, 3, arch}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    options = of(BATTEN_ENERGY_BENDING, false);
    options.start_tangent = none;
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){2, 3, arch}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("no length");
    options.start_tangent = NULL;
    options.end_curvature = bad;
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){2, 3, arch}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("needs a tangent");
    options = of(BATTEN_ENERGY_BENDING, false);
    options.pieces = -1;
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){2, 3, arch}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    options.pieces = 17;
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){2, 3, arch}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(
        batten_curve_minimum_energy((batten_points){1, 3, arch}, NULL, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK(!curve);
}

TEST(n2_tiny_and_huge_points_have_their_curve_of_least_energy)
{
    for (double size = 1e-50; size < 1e60; size *= 1e50) {
        double points[6];
        for (int i = 0; i < 6; i++)
            points[i] = size * arch[i];
        const batten_curve_minimum_energy_options options = of(BATTEN_ENERGY_BENDING, false);
        batten_curve_minimum_energy_report report;
        batten_curve_unref(find(2, 3, points, &options, NULL, &report));
        CHECK_NEAR(report.after * size, 1.28447309, 3e-8);
    }
}

TEST(g9_a_search_that_ends_too_early_says_so)
{
    static const double zigzag[] = {0, 0, 1, 2, 2, 0, 3, 3, 4, 0};
    batten_curve_minimum_energy_options options = of(BATTEN_ENERGY_VARIATION, false);
    batten_curve *curve = NULL;
    options.max_steps = 1;
    CHECK_STATUS(batten_curve_minimum_energy((batten_points){2, 5, zigzag}, &options, NULL,
                                             NULL, &curve),
                 BATTEN_INCOMPLETE);
    CHECK_MESSAGE("1 step took the energy");
    CHECK(!curve);
}
