#include "inspect/shapes.h"

#include <batten/nearest.h>

TEST(distances_from_a_circle_are_differences_of_radii)
{
    test_random random = test_random_begin("circle");
    batten_curve *circle = NULL;
    CHECK_OK(shape_ellipse(2, 2, 10, -4, &circle));
    double points[100], radii[50], distances[50], square = 0;
    for (int i = 0; i < 50; i++) {
        const double angle = test_random_in(&random, 0, 2 * PI);
        radii[i] = test_random_in(&random, 0, 4.5);
        points[2 * i] = 10 + radii[i] * cos(angle);
        points[2 * i + 1] = -4 + radii[i] * sin(angle);
        square += (radii[i] - 2) * (radii[i] - 2);
    }
    batten_deviation found;
    CHECK_OK(batten_curve_deviation(circle,
                                    (batten_points){batten_curve_dimension(circle), 50, points},
                                    NULL, NULL, distances, &found));
    for (int i = 0; i < 50; i++) {
        CHECK_NEAR(distances[i], fabs(radii[i] - 2), 1e-13);
        CHECK(distances[i] <= found.max);
    }
    CHECK_NEAR(found.rms, sqrt(square / 50), 1e-13);
    CHECK_NEAR(distances[found.worst], found.max, 0);
    batten_curve_unref(circle);
}

TEST(I1_no_scan_finds_a_nearer_point)
{
    test_random random = test_random_begin("nearest");
    for (int n = test_cases(40); n > 0; n--) {
        const int d = test_random_int(&random, 2, 3), degree = test_random_int(&random, 1, 7);
        const int count = degree + 1 + test_random_int(&random, 0, 5);
        double points[60], weights[20], knots[40], q[3], u[1];
        batten_curve *curve = NULL;
        for (int i = 0; i < count; i++) {
            weights[i] = pow(10, test_random_in(&random, -1, 1));
            for (int k = 0; k < d; k++)
                points[i * d + k] = test_random_in(&random, -1, 1);
        }
        for (int i = 0; i < count + degree + 1; i++)
            knots[i] = i <= degree  ? 0
                       : i >= count ? 1
                                    : (i - degree) / (double)(count - degree);
        CHECK_OK(batten_curve_create((batten_points){d, count, points}, degree,
                                     n % 2 ? weights : NULL, knots, &curve));
        for (int k = 0; k < d; k++)
            q[k] = test_random_in(&random, -1.5, 1.5);
        u[0] = test_random_unit(&random);
        batten_deviation found;
        CHECK_OK(batten_curve_deviation(curve,
                                        (batten_points){batten_curve_dimension(curve), 1, q},
                                        n % 3 ? u : NULL, NULL, NULL, &found));
        double at[3];
        const int scans = n % 8 ? 4000 : test_cases(100000);
        CHECK_OK(batten_curve_evaluate(curve, found.at[0], 0, at));
        for (int k = 0; k <= scans; k++) {
            double square = 0;
            CHECK_OK(batten_curve_evaluate(curve, k / (double)scans, 0, at));
            for (int j = 0; j < d; j++)
                square += (at[j] - q[j]) * (at[j] - q[j]);
            CHECK(found.max <= sqrt(square) * (1 + 1e-14));
        }
        batten_curve_unref(curve);
    }
}

TEST(I1_centre_end_and_cusp_have_their_nearest_points)
{
    const double powers[2][4][2] = {{{1, -1}, {-2, 3}, {1, -3}, {0, 1}},
                                    {{0, 0}, {0, 0}, {1, 0}, {0, 1}}};
    const double breaks[3] = {-1, 0, 1}, centre[2] = {0, 0}, left[2] = {-3, 0},
                 right[2] = {5, 1};
    batten_curve *circle = NULL, *cusp = NULL;
    batten_deviation found;
    CHECK_OK(shape_ellipse(2, 2, 0, 0, &circle));
    CHECK_OK(batten_curve_deviation(circle,
                                    (batten_points){batten_curve_dimension(circle), 1, centre},
                                    NULL, NULL, NULL, &found));
    CHECK_NEAR(found.max, 2, 1e-15);
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){3, 2, breaks}, &powers[0][0][0], 1e-12,
                                     &cusp));
    CHECK_OK(batten_curve_deviation(cusp,
                                    (batten_points){batten_curve_dimension(cusp), 1, left},
                                    NULL, NULL, NULL, &found));
    CHECK_NEAR(found.max, 3, 1e-15);
    CHECK_NEAR(found.at[0], 0, 1e-8);
    CHECK_OK(batten_curve_deviation(cusp,
                                    (batten_points){batten_curve_dimension(cusp), 1, right},
                                    NULL, NULL, NULL, &found));
    CHECK_NEAR(found.max, 4, 1e-14);
    CHECK_NEAR(found.at[0], 1, 0);
    batten_curve_unref(cusp);
    batten_curve_unref(circle);
}

TEST(points_that_are_not_finite_or_missing_are_refused)
{
    const double bad[4] = {0, 0, NAN, 1}, good[2] = {1, 1}, guess[1] = {NAN};
    batten_curve *circle = NULL;
    batten_deviation found;
    CHECK_OK(shape_ellipse(1, 1, 0, 0, &circle));
    CHECK_STATUS(batten_curve_deviation(circle,
                                        (batten_points){batten_curve_dimension(circle), 2, bad},
                                        NULL, NULL, NULL, &found),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 2");
    CHECK_STATUS(batten_curve_deviation(circle,
                                        (batten_points){batten_curve_dimension(circle), 0, bad},
                                        NULL, NULL, NULL, &found),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(
        batten_curve_deviation(circle, (batten_points){batten_curve_dimension(circle), 1, good},
                               guess, NULL, NULL, &found),
        BATTEN_NOT_FINITE);
    batten_curve_unref(circle);
}

TEST(of_many_spans_the_nearest_is_found)
{
    test_random random = test_random_begin("many spans");
    for (int spans = 1; spans <= 130; spans += 1 + spans / 3) {
        double points[2 * 140], knots[140], q[40], all[20], one[20];
        batten_curve *curve = NULL;
        batten_deviation found;
        const int count = spans + 3;
        for (int i = 0; i < 2 * count; i++)
            points[i] = test_random_in(&random, -1, 1) + i / 20.0;
        for (int i = 0; i < 40; i++)
            q[i] = test_random_in(&random, -1, 1 + count / 10.0);
        for (int i = 0; i < count + 4; i++)
            knots[i] = fmin(spans, fmax(0, i - 3));
        CHECK_OK(
            batten_curve_create((batten_points){2, count, points}, 3, NULL, knots, &curve));
        CHECK_OK(batten_curve_deviation(curve,
                                        (batten_points){batten_curve_dimension(curve), 20, q},
                                        NULL, NULL, all, &found));
        double least[20];
        for (int k = 0; k < spans; k++) { /* each span by itself */
            batten_curve *part = NULL;
            CHECK_OK(batten_curve_subrange(curve, k, k + 1, &part));
            CHECK_OK(batten_curve_deviation(
                part, (batten_points){batten_curve_dimension(part), 20, q}, NULL, NULL, one,
                &found));
            for (int i = 0; i < 20; i++)
                least[i] = k == 0 ? one[i] : fmin(least[i], one[i]);
            batten_curve_unref(part);
        }
        for (int i = 0; i < 20; i++)
            CHECK_NEAR(all[i], least[i], 1e-12);
        batten_curve_unref(curve);
    }
}

/* Within the least radius of curvature, and on the inner side of a convex curve, the foot of a
 * point on the normal is where the normal begins. */
TEST(points_on_a_normal_within_reach_have_its_foot)
{
    test_random random = test_random_begin("normals");
    batten_curve *ellipse = NULL;
    CHECK_OK(shape_ellipse(3, 2, 5, -1, &ellipse)); /* the least radius is 4 / 3 */
    for (int n = test_cases(300); n > 0; n--) {
        const double u = test_random_in(&random, 0.001, 0.999),
                     d = test_random_in(&random, -4, 1.3);
        batten_curve_local at;
        batten_deviation found;
        CHECK_OK(batten_curve_local_at(ellipse, u, BATTEN_FROM_RIGHT, &at));
        const double q[2] = {at.point.x + d * at.normal.x, at.point.y + d * at.normal.y};
        CHECK_OK(batten_curve_deviation(ellipse,
                                        (batten_points){batten_curve_dimension(ellipse), 1, q},
                                        NULL, NULL, NULL, &found));
        CHECK_NEAR(found.max, fabs(d), 1e-13);
        CHECK_NEAR(found.at[0], u, 1e-9);
    }
    batten_curve_unref(ellipse);
}
