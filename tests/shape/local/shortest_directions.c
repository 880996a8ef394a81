#include "support/test.h"
#include <batten/curvature.h>
#include <batten/local.h>
#include <string.h>

static void random_row(test_random *random, int count, double *points)
{
    for (int i = 0; i < count; i++) {
        points[2 * i] = i + test_random_in(random, -0.3, 0.3);
        points[2 * i + 1] = test_random_in(random, -1, 1);
    }
}

TEST(without_directions_it_is_the_natural_spline)
{
    test_random random = test_random_begin("natural");
    double points[16], at[6], other[6];
    batten_curve *made = NULL, *natural = NULL;
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    random_row(&random, 8, points);
    o.parameters = BATTEN_CHORD;
    o.start.kind = o.end.kind = BATTEN_END_NATURAL;
    CHECK_OK(batten_curve_directed((batten_points){2, 8, points}, NULL, NULL, NULL, &made));
    CHECK_OK(batten_curve_interpolate((batten_points){2, 8, points}, &o, NULL, &natural));
    const batten_interval domain = batten_curve_domain(made);
    for (int i = 0; i <= 50; i++) {
        const double u = domain.a + (domain.b - domain.a) * i / 50;
        CHECK_OK(batten_curve_evaluate(made, u, 2, at));
        CHECK_OK(batten_curve_evaluate(natural, u, 2, other));
        for (int k = 0; k < 6; k++)
            CHECK_NEAR(at[k], other[k], 1e-11);
    }
    batten_curve_unref(made);
    batten_curve_unref(natural);
}

TEST(directions_are_met_and_energy_is_least)
{
    test_random random = test_random_begin("directed");
    for (int n = test_cases(50); n > 0; n--) {
        double points[12], t[6];
        batten_direction_at directions[2] = {{.index = 1, .vector = {1, 0.3}},
                                             {.index = 4, .vector = {2, -1}}};
        batten_curve_directed_options o = batten_curve_directed_defaults();
        batten_curve_directed_report report;
        batten_curve *made = NULL;
        random_row(&random, 6, points);
        o.direction_count = 2;
        o.directions = directions;
        CHECK_OK(batten_curve_directed((batten_points){2, 6, points}, &o, t, &report, &made));
        double values[24], energy = 0;
        for (int i = 0; i < 6; i++) {
            CHECK_OK(batten_curve_evaluate(made, t[i], 1, values + 4 * i));
            CHECK_NEAR(values[4 * i], points[2 * i], 1e-14);
            CHECK_NEAR(values[4 * i + 1], points[2 * i + 1], 1e-14);
        }
        for (int k = 0; k < 2; k++) {
            const double *m = values + 4 * directions[k].index + 2, *v = directions[k].vector;
            CHECK_NEAR(m[0] * v[1] - m[1] * v[0], 0, 1e-13);
            CHECK(m[0] * v[0] + m[1] * v[1] > 0);
        }
        /* any other slopes that keep the directions have more energy */
        for (int variant = 0; variant < 4 && report.clamped == 0; variant++) {
            double moved[24];
            memcpy(moved, values, sizeof moved);
            for (int i = 0; i < 6; i++) {
                const double a = test_random_in(&random, -0.2, 0.2);
                const double b = test_random_in(&random, -0.2, 0.2);
                const bool given = i == 1 || i == 4;
                const double *v = directions[i == 4].vector;
                moved[4 * i + 2] += given ? a * v[0] : a;
                moved[4 * i + 3] += given ? a * v[1] : b;
            }
            energy = 0;
            for (int i = 0; i < 5; i++)
                for (int k = 0; k < 2; k++) {
                    const double h = t[i + 1] - t[i], *p = moved + 4 * i + k;
                    const double c = (p[4] - p[0]) / h, x = p[2] - c, y = p[6] - c;
                    energy += 4 / h * (x * x + x * y + y * y);
                }
            CHECK(energy > report.energy);
        }
        batten_curve_unref(made);
    }
}

TEST(tension_makes_the_second_derivative_jump)
{
    const double points[10] = {0, 0, 1, 1, 2, 0.2, 3, 1, 4, 0}, nu[5] = {0, 3, 0, 10, 0};
    const double given[5] = {0, 1, 2.5, 3, 4.5};
    batten_curve_directed_options o = batten_curve_directed_defaults();
    batten_curve *made = NULL;
    o.tension = nu;
    o.parameters = BATTEN_GIVEN;
    o.given = given;
    CHECK_OK(batten_curve_directed((batten_points){2, 5, points}, &o, NULL, NULL, &made));
    for (int i = 1; i < 4; i++) {
        double left[6], right[6];
        batten_curve_local a, b;
        CHECK_OK(batten_curve_evaluate_side(made, given[i], BATTEN_FROM_LEFT, 2, left));
        CHECK_OK(batten_curve_evaluate_side(made, given[i], BATTEN_FROM_RIGHT, 2, right));
        for (int k = 0; k < 2; k++)
            CHECK_NEAR(right[4 + k] - left[4 + k], nu[i] * left[2 + k], 1e-12);
        CHECK_OK(batten_curve_local_at(made, given[i], BATTEN_FROM_LEFT, &a));
        CHECK_OK(batten_curve_local_at(made, given[i], BATTEN_FROM_RIGHT, &b));
        CHECK_NEAR(a.curvature, b.curvature, 1e-12); /* G2 */
    }
    batten_curve_unref(made);
}

TEST(directions_against_the_points_are_clamped_and_reported)
{
    const double points[6] = {0, 0, 1, 0, 2, 0};
    const batten_direction_at back = {.index = 1, .vector = {-1, 0.1}};
    batten_curve_directed_options o = batten_curve_directed_defaults();
    batten_curve_directed_report report;
    batten_curve *made = NULL;
    double at[4];
    o.direction_count = 1;
    o.directions = &back;
    CHECK_OK(batten_curve_directed((batten_points){2, 3, points}, &o, NULL, &report, &made));
    CHECK_INT(report.clamped, 1);
    CHECK_INT(report.first_clamped, 1);
    CHECK_OK(batten_curve_evaluate(made, 1, 1, at));
    CHECK_NEAR(hypot(at[2], at[3]), 0.1, 1e-14);
    CHECK(at[2] < 0);
    batten_curve_unref(made);
}

TEST(g2_two_points_and_lines_stay_straight)
{
    const double points[6] = {0, 0, 1, 2, 3, 6};
    double at[6];
    batten_curve *made = NULL;
    for (int n = 2; n <= 3; n++) {
        CHECK_OK(batten_curve_directed((batten_points){2, n, points}, NULL, NULL, NULL, &made));
        CHECK_OK(batten_curve_evaluate(made, batten_curve_domain(made).b / 3, 2, at));
        CHECK_NEAR(at[1], 2 * at[0], 1e-14);
        CHECK_NEAR(hypot(at[4], at[5]), 0, 1e-13);
        batten_curve_unref(made);
    }
    CHECK_STATUS(batten_curve_directed((batten_points){2, 1, points}, NULL, NULL, NULL, &made),
                 BATTEN_TOO_FEW_POINTS);
}

TEST(n1_directions_that_are_none_are_refused)
{
    const double points[6] = {0, 0, 1, 2, 3, 6}, nu[3] = {0, -1, 0};
    batten_direction_at at[2] = {{.index = 1, .vector = {0, 0}},
                                 {.index = 1, .vector = {1, 0}}};
    batten_curve_directed_options o = batten_curve_directed_defaults();
    batten_curve *made = NULL;
    o.direction_count = 1;
    o.directions = at;
    CHECK_STATUS(batten_curve_directed((batten_points){2, 3, points}, &o, NULL, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("point 2");
    at[0].vector[1] = NAN;
    CHECK_STATUS(batten_curve_directed((batten_points){2, 3, points}, &o, NULL, NULL, &made),
                 BATTEN_NOT_FINITE);
    at[0].vector[1] = 1;
    o.direction_count = 2;
    CHECK_STATUS(batten_curve_directed((batten_points){2, 3, points}, &o, NULL, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    o.direction_count = 0;
    o.tension = nu;
    CHECK_STATUS(batten_curve_directed((batten_points){2, 3, points}, &o, NULL, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
}

TEST(g1_coincident_points_are_named_by_directed_splines)
{
    const double points[6] = {0, 0, 1, 2, 1, 2};
    batten_curve *made = NULL;
    CHECK_STATUS(batten_curve_directed((batten_points){2, 3, points}, NULL, NULL, NULL, &made),
                 BATTEN_COINCIDENT);
}
