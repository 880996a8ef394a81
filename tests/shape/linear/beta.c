#include <batten/interpolate.h>

#include "support/faults.h"
#include "support/test.h"

static batten_curve *spline(int d, int n, const double *points, batten_beta_use use, double b1,
                            double b2, bool closed)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_beta((batten_points){d, n, points}, use, b1, b2, closed, &curve));
    return curve;
}

static const double cage[] = {0, 0, 1, 2, 3, 1, 4, 4, 5, 3, 7, 7};

TEST(a_beta_spline_without_bias_and_tension_is_the_b_spline)
{
    batten_curve *beta = spline(2, 6, cage, BATTEN_BETA_NEAR, 1, 0, true), *b = NULL;
    double
        turned[12]; /* point i bears most on the joint i: the knots before it begin at i - 1 */
    for (int i = 0; i < 6; i++)
        memcpy(turned + 2 * ((i + 1) % 6), cage + 2 * i, 2 * sizeof *cage);
    const double knots[] = {0, 1, 2, 3, 4, 5, 6};
    CHECK_OK(batten_curve_create_periodic((batten_points){2, 6, turned}, 3, NULL, knots, &b));
    for (int i = 0; i < 60; i++) {
        double p[6], q[6];
        CHECK_OK(batten_curve_evaluate(beta, i / 10.0, 2, p));
        CHECK_OK(batten_curve_evaluate(b, i / 10.0, 2, q));
        for (int k = 0; k < 6; k++)
            CHECK_NEAR(p[k], q[k], 1e-13);
    }
    batten_curve_unref(beta);
    batten_curve_unref(b);
}

TEST(joints_of_a_beta_spline_obey_its_law)
{
    const double b1[] = {1, 2, 0.3, 7}, b2[] = {0, 3, 50};
    for (int c = 0; c < COUNT(b1) * COUNT(b2) * 4; c++) {
        const double bias = b1[c % 4], tension = b2[c / 4 % 3];
        const bool closed = c / 12 % 2;
        batten_curve *curve =
            spline(2, 6, cage, (batten_beta_use)(c / 24), bias, tension, closed);
        CHECK(batten_curve_is_periodic(curve) == closed);
        for (int i = closed ? 0 : 1; i < (closed ? 6 : 5); i++) {
            double p[6], q[6];
            CHECK_OK(batten_curve_evaluate_side(curve, i ? i : 6, BATTEN_FROM_LEFT, 2, p));
            CHECK_OK(batten_curve_evaluate_side(curve, i, BATTEN_FROM_RIGHT, 2, q));
            const double size = 1 + fabs(q[2]) + fabs(q[3]) + fabs(q[4]) + fabs(q[5]);
            for (int k = 0; k < 2; k++) {
                CHECK_NEAR(q[k], p[k], 1e-13);
                CHECK_NEAR(q[2 + k], bias * p[2 + k], 1e-12 * size);
                CHECK_NEAR(q[4 + k], bias * bias * p[4 + k] + tension * p[2 + k], 1e-12 * size);
                if (c / 24 == BATTEN_BETA_THROUGH)
                    CHECK_BITS(q[k], cage[2 * i + k]);
            }
        }
        batten_curve_unref(curve);
    }
}

TEST(an_open_beta_spline_begins_and_ends_at_its_points_without_curvature)
{
    for (int use = 0; use < 2; use++) {
        batten_curve *curve = spline(2, 6, cage, (batten_beta_use)use, 1.5, 2, false);
        double p[6];
        for (int end = 0; end < 2; end++) {
            CHECK_OK(batten_curve_evaluate(curve, 5 * end, 2, p));
            CHECK_BITS(p[0], cage[10 * end]);
            CHECK_BITS(p[1], cage[10 * end + 1]);
            CHECK_NEAR(p[2] * p[5] - p[3] * p[4], 0, 1e-11);
        }
        batten_curve_unref(curve);
    }
}

TEST(much_tension_draws_a_beta_spline_to_its_polygon)
{
    batten_curve *curve = spline(2, 6, cage, BATTEN_BETA_NEAR, 1, 1e9, false);
    for (int i = 0; i < 6; i++) {
        double p[2];
        CHECK_OK(batten_curve_evaluate(curve, i, 0, p));
        CHECK_NEAR(p[0], cage[2 * i], 1e-7);
        CHECK_NEAR(p[1], cage[2 * i + 1], 1e-7);
    }
    batten_curve_unref(curve);
}

TEST(g10_reversed_points_give_the_reversed_beta_spline)
{
    double back[12];
    for (int i = 0; i < 6; i++)
        memcpy(back + 2 * i, cage + 2 * (5 - i), 2 * sizeof *back);
    for (int use = 0; use < 2; use++) {
        const double b1 = 1.75, b2 = 4;
        batten_curve *a = spline(2, 6, cage, (batten_beta_use)use, b1, b2, false);
        batten_curve *b =
            spline(2, 6, back, (batten_beta_use)use, 1 / b1, b2 / (b1 * b1 * b1), false);
        for (int i = 0; i <= 50; i++) {
            double p[2], q[2];
            CHECK_OK(batten_curve_evaluate(a, i / 10.0, 0, p));
            CHECK_OK(batten_curve_evaluate(b, 5 - i / 10.0, 0, q));
            CHECK_NEAR(p[0], q[0], 1e-12);
            CHECK_NEAR(p[1], q[1], 1e-12);
        }
        batten_curve_unref(a);
        batten_curve_unref(b);
    }
}

TEST(g2_two_points_of_a_beta_spline_are_a_line)
{
    for (int use = 0; use < 2; use++) {
        batten_curve *line = spline(2, 2, cage, (batten_beta_use)use, 1.2, 3, false);
        for (int i = 0; i <= 10; i++) {
            double p[2];
            CHECK_OK(batten_curve_evaluate(line, i / 10.0, 0, p));
            CHECK_NEAR(p[1], 2 * p[0], 1e-14);
        }
        batten_curve_unref(line);
    }
    batten_curve *none = NULL;
    CHECK_STATUS(
        batten_curve_beta((batten_points){2, 1, cage}, BATTEN_BETA_NEAR, 1, 0, false, &none),
        BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(
        batten_curve_beta((batten_points){2, 2, cage}, BATTEN_BETA_NEAR, 1, 0, true, &none),
        BATTEN_TOO_FEW_POINTS);
    batten_curve_unref(spline(2, 3, cage, BATTEN_BETA_THROUGH, 1, 0, true));
    CHECK(none == NULL);
}

TEST(g1_coincident_points_do_no_harm_to_beta_splines)
{
    const double same[] = {0, 0, 1, 2, 1, 2, 1, 2, 4, 4};
    batten_curve *curve = spline(2, 5, same, BATTEN_BETA_NEAR, 1, 0, false);
    double p[2];
    CHECK_OK(
        batten_curve_evaluate(curve, 2, 0, p)); /* three in one place: the curve is there */
    CHECK_NEAR(p[0], 1, 1e-14);
    CHECK_NEAR(p[1], 2, 1e-14);
    batten_curve_unref(curve);
}

TEST(n1_beta_splines_refuse_what_is_not_finite)
{
    const double bad[] = {0, 0, NAN, 1};
    batten_curve *none = NULL;
    CHECK_STATUS(
        batten_curve_beta((batten_points){2, 2, bad}, BATTEN_BETA_NEAR, 1, 0, false, &none),
        BATTEN_NOT_FINITE);
    const double values[] = {0, -1, NAN, INFINITY, 1e-200, 1e200};
    for (int i = 0; i < COUNT(values); i++)
        CHECK_STATUS(batten_curve_beta((batten_points){2, 6, cage}, BATTEN_BETA_NEAR, values[i],
                                       0, false, &none),
                     BATTEN_BAD_ARGUMENT);
    for (int i = 1; i < 4; i++)
        CHECK_STATUS(batten_curve_beta((batten_points){2, 6, cage}, BATTEN_BETA_NEAR, 1,
                                       values[i], false, &none),
                     BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
}

TEST(beta_splines_report_every_lack_of_memory)
{
    static const double points[] = {0, 0, 1, 2, 3, 1, 4, -1, 6, 0, 7, 2};
    for (int k = 0; k < 4; k++) {
        batten_curve *curve = NULL;
        CHECK_EACH_ALLOCATION(batten_curve_beta(
            (batten_points){2, 6, points}, (batten_beta_use)(k & 1), 1.5, 2, k & 2, &curve));
        batten_curve_unref(curve);
    }
}
