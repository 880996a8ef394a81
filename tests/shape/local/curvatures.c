#include <batten/curvature.h>
#include <batten/local.h>

#include "support/test.h"

/* Points of the ellipse (2 cos, sin) with directions and curvatures. */
static void ellipse(int count, double from, double to, double *points, double *tangents,
                    double *curvatures)
{
    for (int i = 0; i < count; i++) {
        const double a = from + (to - from) * i / (count - 1), c = cos(a), s = sin(a);
        points[2 * i] = 2 * c;
        points[2 * i + 1] = s;
        tangents[2 * i] = -2 * s;
        tangents[2 * i + 1] = c;
        curvatures[i] = 2 / pow(4 * s * s + c * c, 1.5);
    }
}

/* How far the curve strays from the ellipse, by its implicit equation. */
static double distance_from_ellipse(const batten_curve *curve)
{
    const batten_interval domain = batten_curve_domain(curve);
    double most = 0;
    for (int i = 0; i <= 2000; i++) {
        double at[2];
        CHECK_OK(
            batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * i / 2000, 0, at));
        const double f = at[0] * at[0] / 4 + at[1] * at[1] - 1;
        most = fmax(most, fabs(f) / hypot(at[0] / 2, 2 * at[1]));
    }
    return most;
}

TEST(smooth_curves_are_met_with_order_six)
{
    double errors[3], points[66], tangents[66], curvatures[33];
    for (int r = 0; r < 3; r++) {
        const int count = (4 << r) + 1;
        ellipse(count, 0.2, 1.7, points, tangents, curvatures);
        batten_curve *curve = NULL;
        batten_curve_from_curvatures_report report;
        CHECK_OK(batten_curve_from_curvatures(
            &(batten_curved_points){{2, count, points}, tangents, curvatures, false}, NULL,
            NULL, &report, &curve));
        CHECK_INT(report.fallen_back, 0);
        CHECK(report.error < 1e-11);
        errors[r] = distance_from_ellipse(curve);
        batten_curve_unref(curve);
    }
    for (int r = 0; r < 2; r++) {
        const double order = log2(errors[r] / errors[r + 1]);
        CHECK_NEAR(order, 6, 0.25);
    }
}

TEST(directions_and_curvatures_are_continuous_open_and_closed)
{
    double points[48], tangents[48], curvatures[24], t[25];
    int solutions[24];
    ellipse(13, 0, 2 * acos(-1), points, tangents, curvatures);
    for (int closed = 0; closed < 2; closed++) {
        batten_curve *curve = NULL;
        batten_curve_from_curvatures_report report;
        CHECK_OK(batten_curve_from_curvatures(
            &(batten_curved_points){{2, 12, points}, tangents, curvatures, closed}, t,
            solutions, &report, &curve));
        CHECK_INT(report.fallen_back, 0);
        CHECK_INT(report.first_fallen_back, -1);
        for (int i = !closed; i < 11 + closed; i++)
            for (int side = 0; side < 2; side++) {
                batten_curve_local local;
                CHECK_OK(batten_curve_local_at(
                    curve, t[i], side ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &local));
                CHECK_NEAR(local.point.x, points[2 * i], 1e-15 * 4);
                CHECK_NEAR(local.curvature, curvatures[i], 1e-12);
                CHECK_NEAR(local.tangent.x * tangents[2 * i + 1],
                           local.tangent.y * tangents[2 * i], 1e-13);
            }
        batten_curve_unref(curve);
    }
}

TEST(a_span_without_solution_falls_back_and_is_named)
{
    const double points[] = {0, 0, 1, 0, 2, 0, 3, 0}, tangents[] = {1, 0, 1, 0, 1, 0, 1, 0};
    const double curvatures[] = {0, 0, 1, 0};
    int solutions[3];
    batten_curve_from_curvatures_report report;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_curvatures(
        &(batten_curved_points){{2, 4, points}, tangents, curvatures, false}, NULL, solutions,
        &report, &curve));
    CHECK_INT(solutions[0], 1);
    CHECK_INT(solutions[1], 0);
    CHECK_INT(solutions[2], 0);
    CHECK_INT(report.fallen_back, 2);
    CHECK_INT(report.first_fallen_back, 1);
    batten_curve_unref(curve);
}

TEST(circle_curvatures_are_those_of_the_circle)
{
    test_random random = test_random_begin("circle curvatures");
    for (int c = 0; c < test_cases(50); c++) {
        const int count = test_random_int(&random, 3, 12);
        double points[24], curvatures[12], angle = 0;
        for (int i = 0; i < count; i++) {
            points[2 * i] = 3 + 2 * cos(angle);
            points[2 * i + 1] = (c % 2 ? 2 : -2) * sin(angle);
            angle += test_random_in(&random, 0.1, 6.2 / count);
        }
        CHECK_OK(batten_circle_curvatures((batten_points){2, count, points}, c % 3 == 0,
                                          curvatures));
        for (int i = 0; i < count; i++)
            CHECK_NEAR(curvatures[i], c % 2 ? 0.5 : -0.5, 1e-12);
    }
    double two[2] = {1, 1};
    const double points[] = {0, 0, 1, 1};
    CHECK_OK(batten_circle_curvatures((batten_points){2, 2, points}, false, two));
    CHECK_NEAR(two[0] + two[1], 0, 0);
    CHECK_STATUS(batten_circle_curvatures((batten_points){2, 2, points}, true, two),
                 BATTEN_TOO_FEW_POINTS);
    const double same[] = {0, 0, 0, 0, 1, 1};
    double three[3];
    CHECK_STATUS(batten_circle_curvatures((batten_points){2, 3, same}, false, three),
                 BATTEN_COINCIDENT);
}

TEST(n1_curvatures_and_tangents_that_cannot_be_are_refused)
{
    const double points[] = {0, 0, 1, 0, 2, 1}, tangents[] = {1, 0, 0, 0, 1, 1};
    const double good[] = {1, 0, 1, 0, 1, 0}, k[] = {0, NAN, 0}, zero[] = {0, 0, 0};
    const double same[] = {0, 0, 0, 0, 2, 1};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_from_curvatures(
                     &(batten_curved_points){{2, 3, points}, tangents, zero, false}, NULL, NULL,
                     NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("tangent at point 2");
    CHECK_STATUS(
        batten_curve_from_curvatures(&(batten_curved_points){{2, 3, points}, good, k, false},
                                     NULL, NULL, NULL, &curve),
        BATTEN_NOT_FINITE);
    CHECK_STATUS(
        batten_curve_from_curvatures(&(batten_curved_points){{2, 3, same}, good, zero, false},
                                     NULL, NULL, NULL, &curve),
        BATTEN_COINCIDENT);
    CHECK_STATUS(
        batten_curve_from_curvatures(&(batten_curved_points){{2, 1, points}, good, zero, false},
                                     NULL, NULL, NULL, &curve),
        BATTEN_TOO_FEW_POINTS);
    CHECK(curve == NULL);
}
