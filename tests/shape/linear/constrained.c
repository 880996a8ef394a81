#include <batten/interpolate.h>

#include "support/test.h"

static batten_curve *find(int d, int count, const double *points,
                          const batten_curve_constrained_options *options, double *parameters,
                          batten_curve_constrained_report *report)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_constrained((batten_points){d, count, points}, options, parameters,
                                      report, &curve));
    return curve;
}

/* The least of normal . derivative at many parameters between two. */
static double least_of(const batten_curve *curve, int order, const double *normal, double a,
                       double b)
{
    enum { STEPS = 1000 };
    const int d = batten_curve_dimension(curve);
    double least = HUGE_VAL, at[9];
    for (int i = 0; i <= STEPS; i++) {
        double sum = 0;
        CHECK_OK(batten_curve_evaluate(curve, a + (b - a) * i / STEPS, order, at));
        for (int c = 0; c < d; c++)
            sum += normal[c] * at[order * d + c];
        least = fmin(least, sum);
    }
    return least;
}

static const double up[3] = {1}, down[3] = {-1};

/* A step, which splines overshoot. */
static const double abscissae[] = {0, 1, 2, 3, 4, 5, 6};
static const double step[] = {0, 0, 0.05, 1, 1.05, 1.1, 1.5};

static batten_curve_constrained_options of_step(int constraint_count,
                                                const batten_constraint *constraints)
{
    batten_curve_constrained_options options = batten_curve_constrained_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = abscissae;
    options.constraint_count = constraint_count;
    options.constraints = constraints;
    return options;
}

/* ---- oracles ---- */

TEST(without_constraints_a_cubic_with_knots_at_the_points_is_the_natural_spline)
{
    batten_curve_constrained_options options = of_step(0, NULL);
    options.degree = 3;
    batten_curve_interpolate_options natural = batten_curve_interpolate_defaults();
    natural.parameters = BATTEN_GIVEN;
    natural.given = abscissae;
    natural.knots_at_data = true;
    natural.start.kind = natural.end.kind = BATTEN_END_NATURAL;
    batten_curve *expected = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){1, 7, step}, &natural, NULL, &expected));
    for (options.pieces = 1; options.pieces <= 4; options.pieces++) {
        batten_curve_constrained_report report;
        batten_curve *curve = find(1, 7, step, &options, NULL, &report);
        for (int i = 0; i <= 60; i++) {
            double at, wanted;
            CHECK_OK(batten_curve_evaluate(curve, i / 10.0, 0, &at));
            CHECK_OK(batten_curve_evaluate(expected, i / 10.0, 0, &wanted));
            CHECK_NEAR(at, wanted, 1e-12);
        }
        CHECK(report.error_max < 1e-14 && report.active == 0 && report.redundant == 0);
        batten_curve_unref(curve);
    }
    batten_curve_unref(expected);
}

TEST(bezier_curves_through_points_come_down_to_the_energy_of_the_natural_spline)
{
    static const double at[] = {0, 1, 2}, values[] = {0, 1, 0};
    /* y'' is a hat of height -3: its square has the integral 2 * 9 / 3. */
    double before = HUGE_VAL;
    for (int degree = 3; degree <= 15; degree += 2) {
        batten_curve_constrained_options options = batten_curve_constrained_defaults();
        options.parameters = BATTEN_GIVEN;
        options.given = at;
        options.pieces = 0;
        options.degree = degree;
        batten_curve_constrained_report report;
        batten_curve *curve = find(1, 3, values, &options, NULL, &report);
        CHECK_INT(batten_curve_point_count(curve), degree + 1);
        CHECK(report.energy > 6 && report.energy < before + 1e-12);
        before = report.energy;
        batten_curve_unref(curve);
    }
    CHECK_NEAR(before, 6, 0.05);
}

TEST(a_cubic_bezier_curve_with_clamped_ends_is_hermites)
{
    static const double at[] = {0, 2}, values[] = {1, 4};
    const batten_constraint ends[] = {{BATTEN_CONSTRAINT_DIRECTION, 0, 0, {0.5}, 0, 0},
                                      {BATTEN_CONSTRAINT_DIRECTION, 1, 0, {-3}, 0, 0}};
    batten_curve_constrained_options options = batten_curve_constrained_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = at;
    options.pieces = 0;
    options.degree = 3;
    options.constraint_count = 2;
    options.constraints = ends;
    batten_curve *curve = find(1, 2, values, &options, NULL, NULL);
    const double expected[] = {1, 1 + 0.5 * 2 / 3, 4 + 3 * 2 / 3.0, 4};
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(batten_curve_points(curve)[i], expected[i], 1e-13);
    batten_curve_unref(curve);
}

TEST(a_floor_lifts_a_beam_as_it_does_in_mechanics)
{
    /* Through (-1, h), (1, h) with slopes -s and s the cubic sags to h - s / 2. A floor at 0
     * that it meets in one point makes it two cubics of least bending through (0, 0): by
     * symmetry each clamped at both ends, with slope 0 there. */
    static const double at[] = {-1, 1}, values[] = {0.3, 0.3};
    const double s = 0.8;
    const batten_constraint constraints[] = {{BATTEN_CONSTRAINT_DIRECTION, 0, 0, {-0.8}, 0, 0},
                                             {BATTEN_CONSTRAINT_DIRECTION, 1, 0, {0.8}, 0, 0},
                                             {BATTEN_CONSTRAINT_VALUE, 0, 0, {1}, 0, 0}};
    batten_curve_constrained_options options = batten_curve_constrained_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = at;
    options.degree = 3;
    options.checks = 16;
    options.constraint_count = 3;
    options.constraints = constraints;
    batten_curve_constrained_report report;
    batten_curve *curve = find(1, 2, values, &options, NULL, &report);
    /* Hermite's cubic on [0, 1] from (0, 0) with slope 0 to (h, s): y'' = (6 h - 2 s) + (6 s -
     * 12 h) x. */
    const double a = 6 * 0.3 - 2 * s, b = 6 * s - 12 * 0.3;
    CHECK_NEAR(report.energy, 2 * (a * a + a * b + b * b / 3), 1e-3);
    CHECK(report.energy >= 2 * (a * a + a * b + b * b / 3) - 1e-12);
    CHECK(report.active > 0);
    double middle;
    CHECK_OK(batten_curve_evaluate(curve, 0, 0, &middle));
    CHECK_NEAR(middle, 0, 1e-3);
    CHECK(least_of(curve, 0, up, -1, 1) >= -1e-14);
    batten_curve_unref(curve);
}

/* ---- inequalities hold everywhere ---- */

TEST(inequalities_hold_at_every_parameter_and_cost_energy)
{
    batten_curve_constrained_report free;
    const batten_curve_constrained_options none = of_step(0, NULL);
    batten_curve *curve = find(1, 7, step, &none, NULL, &free);
    CHECK(least_of(curve, 0, up, 0, 6) < -0.01);
    CHECK(least_of(curve, 1, up, 0, 6) < -0.1);
    batten_curve_unref(curve);
    const batten_constraint all[] = {
        {BATTEN_CONSTRAINT_VALUE, 0, 0, {1}, 0, 0},     /* not below 0 */
        {BATTEN_CONSTRAINT_VALUE, 0, 5, {-1}, -1.1, 0}, /* not above 1.1 */
        {BATTEN_CONSTRAINT_SLOPE, 2, 0, {1}, 0, 0},     /* rising */
        {BATTEN_CONSTRAINT_BEND, 4, 6, {1}, 0, 0},      /* convex */
    };
    double before = free.energy;
    for (int count = 1; count <= 4; count++) {
        const batten_curve_constrained_options options = of_step(count, all);
        batten_curve_constrained_report report;
        curve = find(1, 7, step, &options, NULL, &report);
        CHECK(least_of(curve, 0, up, 0, 6) >= -1e-13);
        if (count > 1)
            CHECK(least_of(curve, 0, down, 0, 5) >= -1.1 - 1e-13);
        if (count > 2)
            CHECK(least_of(curve, 1, up, 2, 6) >= -1e-12);
        if (count > 3)
            CHECK(least_of(curve, 2, up, 4, 6) >= -1e-11);
        CHECK(report.energy >= before - 1e-12);
        CHECK(report.energy > free.energy * 1.01 && report.active > 0);
        CHECK(report.error_max < 1e-13);
        before = report.energy;
        batten_curve_unref(curve);
    }
}

TEST(more_checks_ask_for_less_than_fewer)
{
    const batten_constraint floor = {BATTEN_CONSTRAINT_VALUE, 0, 0, {1}, 0, 0};
    batten_curve_constrained_options options = of_step(1, &floor);
    double before = HUGE_VAL;
    for (options.checks = 1; options.checks <= 16; options.checks *= 2) {
        batten_curve_constrained_report report;
        batten_curve_unref(find(1, 7, step, &options, NULL, &report));
        CHECK(report.energy <= before + 1e-12);
        before = report.energy;
    }
}

TEST(a_function_stays_above_a_slanted_line)
{
    const double values[] = {0, 0, 0, 0.6, 1, 1.3, 1.5};
    const batten_constraint line = {BATTEN_CONSTRAINT_VALUE, 0, 0, {1}, -0.02, 0.005};
    const batten_curve_constrained_options options = of_step(1, &line);
    batten_curve_constrained_report report;
    batten_curve *curve = find(1, 7, values, &options, NULL, &report);
    for (int i = 0; i <= 600; i++) {
        double at;
        CHECK_OK(batten_curve_evaluate(curve, i / 100.0, 0, &at));
        CHECK(at >= -0.02 + 0.005 * i / 100.0 - 1e-13);
    }
    CHECK(report.active > 0);
    batten_curve_unref(curve);
}

TEST(a_plane_curve_stays_within_a_band_and_goes_where_it_is_told)
{
    const double points[] = {0, 0, 1, 0.95, 2, 0.05, 3, 1, 4, 0.2};
    const batten_constraint constraints[] = {
        {BATTEN_CONSTRAINT_VALUE, 0, 0, {0, 1}, 0, 0},
        {BATTEN_CONSTRAINT_VALUE, 0, 0, {0, -1}, -1, 0},
        {BATTEN_CONSTRAINT_SLOPE, 0, 0, {1, 0}, 0, 0},
        {BATTEN_CONSTRAINT_DIRECTION, 2, 0, {2, 0}, 0, 0},
    };
    batten_curve_constrained_options options = batten_curve_constrained_defaults();
    options.constraint_count = 4;
    options.constraints = constraints;
    double u[5], at[4];
    batten_curve_constrained_report report;
    batten_curve *curve = find(2, 5, points, &options, u, &report);
    const double across[] = {0, 1}, against[] = {0, -1}, along[] = {1, 0};
    CHECK(least_of(curve, 0, across, 0, u[4]) >= -1e-13);
    CHECK(least_of(curve, 0, against, 0, u[4]) >= -1 - 1e-13);
    CHECK(least_of(curve, 1, along, 0, u[4]) >= -1e-12);
    CHECK_OK(batten_curve_evaluate(curve, u[2], 1, at));
    CHECK_NEAR(at[3], 0, 1e-12);
    CHECK(at[2] > 0);
    CHECK(report.active > 0);
    batten_curve_unref(curve);
}

TEST(directions_in_space_and_mean_values_are_kept)
{
    const double points[] = {0, 0, 0, 1, 1, 0, 2, 0, 1, 3, 1, 2};
    const batten_constraint constraints[] = {
        {BATTEN_CONSTRAINT_DIRECTION, 1, 0, {1, 2, -2}, 0, 0},
        {BATTEN_CONSTRAINT_DIRECTION, 3, 0, {0, 0, -1}, 0.6, 0},
        {BATTEN_CONSTRAINT_MEAN, 0, 0, {0, 1, 0}, 0.7, 0},
    };
    batten_curve_constrained_options options = batten_curve_constrained_defaults();
    options.constraint_count = 3;
    options.constraints = constraints;
    options.order = 3;
    options.degree = 5;
    double u[4], at[6], sum = 0;
    batten_curve *curve = find(3, 4, points, &options, u, NULL);
    CHECK_OK(batten_curve_evaluate(curve, u[1], 1, at));
    CHECK_NEAR(at[4], 2 * at[3], 1e-11);
    CHECK_NEAR(at[5], -2 * at[3], 1e-11);
    CHECK(at[3] > 0);
    /* Against the points: as slow as is allowed. */
    CHECK_OK(batten_curve_evaluate(curve, u[3], 1, at));
    CHECK_NEAR(at[5], -0.6, 1e-11);
    enum { STEPS = 2000 };
    for (int i = 0; i <= STEPS; i++) {
        CHECK_OK(batten_curve_evaluate(curve, u[3] * i / STEPS, 0, at));
        sum += (i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2) * at[1] / (3.0 * STEPS);
    }
    CHECK_NEAR(sum, 0.7, 1e-9);
    batten_curve_unref(curve);
}

TEST(points_with_weights_are_passed_near)
{
    const double weights[] = {HUGE_VAL, 3, 3, 3, 3, 3, HUGE_VAL};
    batten_curve_constrained_options options = of_step(0, NULL);
    options.weights = weights;
    batten_curve_constrained_report report, through;
    batten_curve *curve = find(1, 7, step, &options, NULL, &report);
    double at;
    CHECK_OK(batten_curve_evaluate(curve, 6, 0, &at));
    CHECK_NEAR(at, 1.5, 1e-14);
    batten_curve_unref(curve);
    options.weights = NULL;
    batten_curve_unref(find(1, 7, step, &options, NULL, &through));
    CHECK(report.error_max > 0.05 && report.error_max < 0.5);
    CHECK(report.energy < through.energy);
}

/* ---- bad input ---- */

TEST(g2_two_points_give_the_constrained_line)
{
    const double pair[] = {1, 2, 4, 6};
    batten_curve *curve = find(2, 2, pair, NULL, NULL, NULL);
    for (int i = 0; i <= 10; i++) {
        double at[2];
        CHECK_OK(batten_curve_evaluate(curve, i / 2.0, 0, at));
        CHECK_NEAR(at[0], 1 + 3 * i / 10.0, 1e-13);
        CHECK_NEAR(at[1], 2 + 4 * i / 10.0, 1e-13);
    }
    batten_curve_unref(curve);
}

TEST(g9_constraints_that_contradict_each_other_are_named)
{
    const batten_constraint ceiling[] = {{BATTEN_CONSTRAINT_VALUE, 0, 0, {1}, -5, 0},
                                         {BATTEN_CONSTRAINT_VALUE, 2, 4, {-1}, -0.5, 0}};
    batten_curve_constrained_options options = of_step(2, ceiling);
    batten_curve *curve = NULL;
    CHECK_STATUS(
        batten_curve_constrained((batten_points){1, 7, step}, &options, NULL, NULL, &curve),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("constraint 2 (value, from point 3 to 5)");
    /* Too few control points for the points. */
    options = of_step(0, NULL);
    options.pieces = 0;
    options.degree = 3;
    CHECK_STATUS(
        batten_curve_constrained((batten_points){1, 7, step}, &options, NULL, NULL, &curve),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("cannot pass point 5");
    const batten_constraint twice[] = {{BATTEN_CONSTRAINT_DIRECTION, 2, 0, {1}, 0, 0},
                                       {BATTEN_CONSTRAINT_DIRECTION, 2, 0, {2}, 0, 0}};
    options = of_step(2, twice);
    CHECK_STATUS(
        batten_curve_constrained((batten_points){1, 7, step}, &options, NULL, NULL, &curve),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("constraint 2 (direction, from point 3");
    options = of_step(0, NULL);
    options.order = 3;
    CHECK_STATUS(
        batten_curve_constrained((batten_points){1, 2, step + 2}, &options, NULL, NULL, &curve),
        BATTEN_SINGULAR_SYSTEM);
    CHECK(!curve);
}

TEST(n1_g1_s1_constrained_curves_refuse_what_they_cannot_use)
{
    batten_curve *curve = NULL;
    const double same[] = {0, 0, 1, 1, 1, 1}, bad[] = {0, NAN, 1, 1};
    CHECK_STATUS(
        batten_curve_constrained((batten_points){2, 3, same}, NULL, NULL, NULL, &curve),
        BATTEN_COINCIDENT);
    CHECK_STATUS(batten_curve_constrained((batten_points){2, 2, bad}, NULL, NULL, NULL, &curve),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_constrained((batten_points){2, 1, bad}, NULL, NULL, NULL, &curve),
                 BATTEN_TOO_FEW_POINTS);
    const batten_constraint wrong[] = {{BATTEN_CONSTRAINT_VALUE, 3, 2, {1}, 0, 0},
                                       {BATTEN_CONSTRAINT_SLOPE, 0, 7, {1}, 0, 0},
                                       {BATTEN_CONSTRAINT_BEND, 0, 0, {0}, 0, 0},
                                       {(batten_constraint_kind)9, 0, 0, {1}, 0, 0}};
    for (int i = 0; i < COUNT(wrong); i++) {
        const batten_curve_constrained_options options = of_step(1, &wrong[i]);
        CHECK_STATUS(
            batten_curve_constrained((batten_points){1, 7, step}, &options, NULL, NULL, &curve),
            BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("constraint 1");
    }
    batten_curve_constrained_options options = of_step(0, NULL);
    options.degree = 26;
    CHECK_STATUS(
        batten_curve_constrained((batten_points){1, 7, step}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    options.degree = 5;
    options.pieces = 64;
    double many[3 * 20];
    for (int i = 0; i < 60; i++)
        many[i] = i;
    options.parameters = BATTEN_CHORD;
    CHECK_STATUS(
        batten_curve_constrained((batten_points){3, 20, many}, &options, NULL, NULL, &curve),
        BATTEN_TOO_LARGE);
    const double weights[] = {1, 0, 1, 1, 1, 1, 1};
    options = of_step(0, NULL);
    options.weights = weights;
    CHECK_STATUS(
        batten_curve_constrained((batten_points){1, 7, step}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("weight 2");
    CHECK(!curve);
}
