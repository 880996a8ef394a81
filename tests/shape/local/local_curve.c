#include <batten/local.h>

#include "support/test.h"

TEST(a_cubic_is_met_by_its_own_slopes_and_second_derivatives)
{
    /* f = u^3 - 2 u at uneven parameters. */
    const double t[] = {-1, 0, 0.25, 2, 5};
    double y[5], slopes[5], second[5], values[15];
    for (int i = 0; i < 5; i++) {
        y[i] = t[i] * t[i] * t[i] - 2 * t[i];
        slopes[i] = 3 * t[i] * t[i] - 2;
    }
    CHECK_OK(batten_second_derivatives((batten_points){1, 5, y}, t, slopes, false, second));
    for (int i = 0; i < 5; i++) {
        CHECK_NEAR(second[i], 6 * t[i], 1e-12);
        const double row[3] = {y[i], slopes[i], second[i]};
        memcpy(values + 3 * i, row, sizeof row);
    }
    batten_curve *cubic = NULL, *quintic = NULL;
    CHECK_OK(
        batten_curve_from_tangents((batten_points){1, 5, y}, t, slopes, NULL, false, &cubic));
    CHECK_OK(batten_curve_from_hermite(1, 5, 3, t, values, &quintic));
    for (int i = 0; i <= 60; i++) {
        const double u = -1 + 0.1 * i;
        double a, b;
        CHECK_OK(batten_curve_evaluate(cubic, u, 0, &a));
        CHECK_OK(batten_curve_evaluate(quintic, u, 0, &b));
        CHECK_NEAR(a, u * u * u - 2 * u, 1e-13 * 120);
        CHECK_NEAR(b, a, 1e-13 * 120);
    }
    batten_curve_unref(cubic);
    batten_curve_unref(quintic);
}

TEST(second_derivatives_of_a_closed_curve_go_round)
{
    /* Eight points of a circle by the angle: every one is the same but for its turn. */
    double points[16], tangents[16], t[9], second[16];
    for (int i = 0; i < 9; i++)
        t[i] = i * acos(-1) / 4;
    for (int i = 0; i < 8; i++) {
        points[2 * i] = cos(t[i]);
        points[2 * i + 1] = sin(t[i]);
        tangents[2 * i] = -sin(t[i]);
        tangents[2 * i + 1] = cos(t[i]);
    }
    CHECK_OK(
        batten_second_derivatives((batten_points){2, 8, points}, t, tangents, true, second));
    for (int i = 0; i < 8; i++) {
        const double along =
            second[2 * i] * tangents[2 * i] + second[2 * i + 1] * tangents[2 * i + 1];
        CHECK_NEAR(along, 0, 1e-13);
        CHECK_NEAR(hypot(second[2 * i], second[2 * i + 1]), 1, 0.06);
    }
}

TEST(a_periodic_curve_may_have_one_or_two_points)
{
    const double t[] = {0, 1, 3}, points[] = {0, 0, 2, 1}, tangents[] = {1, -1, -1, 1};
    for (int count = 1; count <= 2; count++) {
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_from_tangents((batten_points){2, count, points}, t, tangents,
                                            NULL, true, &curve));
        for (int i = 0; i <= count; i++) {
            double out[4];
            CHECK_OK(batten_curve_evaluate(curve, t[i], 1, out));
            for (int k = 0; k < 2; k++) {
                CHECK_NEAR(out[k], points[2 * (i % count) + k], 1e-15);
                CHECK_NEAR(out[2 + k], tangents[2 * (i % count) + k], 1e-14);
            }
        }
        batten_curve_unref(curve);
    }
}

TEST(n1_bad_tangents_and_parameters_are_refused)
{
    const double t[] = {0, 1, 1}, good[] = {0, 1, 2}, y[] = {0, 1, 0}, bad[] = {0, INFINITY, 0};
    const double steep[] = {1e308, 1e308, 1e308}, wide[] = {0, 1e10, 2e10};
    batten_curve *curve = NULL;
    double second[3];
    CHECK_STATUS(
        batten_curve_from_tangents((batten_points){1, 3, y}, t, y, NULL, false, &curve),
        BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("parameter 3");
    CHECK_STATUS(
        batten_curve_from_tangents((batten_points){1, 3, y}, good, bad, NULL, false, &curve),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("tangent 2");
    CHECK_STATUS(
        batten_curve_from_tangents((batten_points){1, 3, y}, good, y, bad, false, &curve),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("arriving tangent 2");
    CHECK_STATUS(
        batten_curve_from_tangents((batten_points){1, 1, y}, good, y, NULL, false, &curve),
        BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(
        batten_curve_from_tangents((batten_points){1, 3, y}, wide, steep, NULL, false, &curve),
        BATTEN_OVERFLOW);
    CHECK_STATUS(
        batten_second_derivatives((batten_points){1, 3, y}, good, steep, false, second),
        BATTEN_OVERFLOW);
    CHECK_STATUS(batten_second_derivatives((batten_points){1, 3, y}, good, bad, false, second),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_second_derivatives((batten_points){1, 3, y}, t, y, false, second),
                 BATTEN_NOT_INCREASING);
    CHECK(curve == NULL);
}
