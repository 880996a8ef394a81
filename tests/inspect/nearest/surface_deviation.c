#include "inspect/shapes.h"

#include <batten/nearest.h>
#include <batten/standard.h>

TEST(distances_from_sphere_and_torus_are_those_of_their_radii)
{
    test_random random = test_random_begin("sphere and torus");
    batten_surface *surface = NULL;
    for (int which = 0; which < 2; which++) {
        double points[90], expected[30], distances[30];
        CHECK_OK(shape_torus(which ? 3 : 0, 1, !which, &surface));
        for (int i = 0; i < 30; i++) {
            for (int k = 0; k < 3; k++)
                points[3 * i + k] = test_random_in(&random, -4, 4);
            const double *p = points + 3 * i;
            const double ring = which ? hypot(p[0], p[1]) - 3 : hypot(p[0], p[1]);
            expected[i] = fabs(hypot(ring, p[2]) - 1);
        }
        batten_deviation found;
        CHECK_OK(batten_surface_deviation(surface, (batten_points){3, 30, points}, NULL, NULL,
                                          distances, &found));
        for (int i = 0; i < 30; i++)
            CHECK_NEAR(distances[i], expected[i], 1e-12);
        batten_surface_unref(surface);
    }
}

TEST(I1_no_scan_of_a_surface_finds_a_nearer_point)
{
    test_random random = test_random_begin("surface scan");
    for (int n = test_cases(10); n > 0; n--) {
        const double knots[10] = {0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1};
        const batten_axis axis = {3, 6, knots, false};
        double points[108], q[3], guess[2], at[3];
        batten_surface *surface = NULL;
        batten_deviation found;
        for (int i = 0; i < 36; i++) {
            points[3 * i] = i / 6 + test_random_in(&random, -0.3, 0.3);
            points[3 * i + 1] = i % 6 + test_random_in(&random, -0.3, 0.3);
            points[3 * i + 2] = test_random_in(&random, -1, 1);
        }
        CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
        for (int k = 0; k < 3; k++)
            q[k] = test_random_in(&random, -2, 7);
        for (int k = 0; k < 2; k++)
            guess[k] = test_random_unit(&random);
        CHECK_OK(batten_surface_deviation(surface, (batten_points){3, 1, q},
                                          n % 2 ? guess : NULL, NULL, NULL, &found));
        for (int i = 0; i <= 100; i++)
            for (int j = 0; j <= 100; j++) {
                double square = 0;
                CHECK_OK(batten_surface_evaluate(surface, i / 100.0, j / 100.0, 0, at));
                for (int k = 0; k < 3; k++)
                    square += (at[k] - q[k]) * (at[k] - q[k]);
                CHECK(found.max <= sqrt(square) * (1 + 1e-12));
            }
        batten_surface_unref(surface);
    }
}

TEST(points_of_a_surface_lie_on_it)
{
    batten_surface *torus = NULL;
    batten_deviation found;
    double points[300];
    CHECK_OK(shape_torus(5, 2, false, &torus));
    for (int i = 0; i < 100; i++)
        CHECK_OK(
            batten_surface_evaluate(torus, (i % 10) / 9.0, (i / 10) / 9.0, 0, points + 3 * i));
    CHECK_OK(batten_surface_deviation(torus, (batten_points){3, 100, points}, NULL, NULL, NULL,
                                      &found));
    CHECK_NEAR(found.max, 0, 1e-7); /* a square root of the rounding of squares */
    const double bad[3] = {0, NAN, 0};
    CHECK_STATUS(
        batten_surface_deviation(torus, (batten_points){3, 1, bad}, NULL, NULL, NULL, &found),
        BATTEN_NOT_FINITE);
    batten_surface_unref(torus);
}

TEST(the_foot_on_a_ridge_is_found)
{
    const double u[] = {0, 0, 1, 2, 2}, v[] = {0, 0, 1, 1};
    const double points[] = {-1, 0, -1, -1, 1, -1, 0, 0, 0, 0, 1, 0, 1, 0, -1, 1, 1, -1};
    const batten_axis along = {1, 3, u, false}, across = {1, 2, v, false};
    batten_surface *roof = NULL;
    CHECK_OK(batten_surface_create(3, &along, &across, points, NULL, &roof));
    for (int i = 0; i <= 40; i++) {
        const double above[3] = {(i % 5 - 2) * 0.2, i / 40.0, 1};
        double distance;
        batten_deviation found;
        CHECK_OK(batten_surface_deviation(roof, (batten_points){3, 1, above}, NULL, NULL,
                                          &distance, &found));
        CHECK_NEAR(distance, hypot(above[0], 1), 1e-14);
        CHECK_NEAR(found.at[0], 1, 1e-7);
        CHECK_NEAR(found.at[1], above[1], 1e-7);
    }
    batten_surface_unref(roof);
}

TEST(I1_no_scan_of_a_creased_surface_finds_a_nearer_point)
{
    test_random random = test_random_begin("creased scan");
    for (int n = test_cases(20); n > 0; n--) {
        const double knots[10] = {0, 0, 0, 0.5, 0.5, 0.8, 0.8, 1, 1, 1};
        const batten_axis axis = {2, 7, knots, false};
        double points[147], q[30], distances[10], at[3];
        batten_surface *surface = NULL;
        batten_deviation found;
        for (int i = 0; i < 147; i++) {
            const int place = i % 3 == 0 ? i / 21 : i % 3 == 1 ? i / 3 % 7 : 0;
            points[i] = place + test_random_in(&random, -0.5, 0.5);
        }
        CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
        for (int k = 0; k < 30; k++)
            q[k] = test_random_in(&random, -2, 8);
        CHECK_OK(batten_surface_deviation(surface, (batten_points){3, 10, q}, NULL, NULL,
                                          distances, &found));
        for (int i = 0; i <= 60; i++)
            for (int j = 0; j <= 60; j++) {
                CHECK_OK(batten_surface_evaluate(surface, i / 60.0, j / 60.0, 0, at));
                for (int k = 0; k < 10; k++)
                    CHECK(distances[k] <= hypot(hypot(at[0] - q[3 * k], at[1] - q[3 * k + 1]),
                                                at[2] - q[3 * k + 2]) *
                                              (1 + 1e-12));
            }
        batten_surface_unref(surface);
    }
}

/* Over the rectangle of 2 by 3, beside its sides and beyond its corners. */
static const struct {
    double point[3], distance, uv[2];
} feet[] = {{{1, 1.5, 2}, 2, {0.5, 0.5}}, {{3, 0.75, 0}, 1, {1, 0.25}},
            {{0.5, 7, 3}, 5, {0.25, 1}},  {{-3, -4, 0}, 5, {0, 0}},
            {{2, 3, -0.5}, 0.5, {1, 1}},  {{1.5, -1, 0}, 1, {0.75, 0}},
            {{-4, 1.5, 3}, 5, {0, 0.5}},  {{0.5, 0.75, 0}, 0, {0.25, 0.25}}};

/* Also cut into patches; guesses may be anywhere. */
TEST(feet_on_a_plane_have_their_parameters_and_the_farthest_is_reported)
{
    enum { MANY = COUNT(feet) };
    static const double cuts[] = {0.3, 0.6};
    batten_surface *plane = NULL, *along = NULL, *cut = NULL;
    double points[3 * MANY], start[2 * MANY], squares = 0;
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){2, 0, 0},
                                     (batten_vec3){0, 3, 0}, (batten_vec3){2, 3, 0}, &plane));
    CHECK_OK(batten_surface_refine(plane, BATTEN_U, 2, cuts, &along));
    CHECK_OK(batten_surface_refine(along, BATTEN_V, 1, cuts, &cut));
    for (int i = 0; i < MANY; i++) {
        memcpy(points + 3 * i, feet[i].point, sizeof feet[i].point);
        squares += feet[i].distance * feet[i].distance;
        start[2 * i] = i - 3;
        start[2 * i + 1] = 0.1 * i;
    }
    for (int k = 0; k < 4; k++) {
        double uv[2 * MANY], distances[MANY], again[MANY];
        batten_deviation found, same;
        CHECK_OK(batten_surface_project(k & 1 ? cut : plane, (batten_points){3, MANY, points},
                                        k & 2 ? start : NULL, NULL,
                                        (batten_feet){uv, distances}, &found));
        CHECK_OK(batten_surface_deviation(k & 1 ? cut : plane, (batten_points){3, MANY, points},
                                          k & 2 ? start : NULL, NULL, again, &same));
        for (int i = 0; i < MANY; i++) {
            CHECK_NEAR(distances[i], feet[i].distance, 1e-14);
            CHECK_NEAR(again[i], distances[i], 0);
            CHECK_NEAR(uv[2 * i], feet[i].uv[0], 1e-14);
            CHECK_NEAR(uv[2 * i + 1], feet[i].uv[1], 1e-14);
        }
        CHECK_NEAR(found.max, 5, 1e-14);
        CHECK_NEAR(distances[found.worst], found.max, 0);
        CHECK_NEAR(found.at[0], feet[found.worst].uv[0], 1e-14);
        CHECK_NEAR(found.at[1], feet[found.worst].uv[1], 1e-14);
        CHECK_NEAR(found.rms, sqrt(squares / MANY), 1e-14);
        CHECK_INT(same.worst, found.worst);
        CHECK_NEAR(same.rms, found.rms, 0);
    }
    batten_surface_unref(cut);
    batten_surface_unref(along);
    batten_surface_unref(plane);
}

TEST(points_of_another_dimension_or_none_are_refused)
{
    static const double points[] = {0, 0, 1, 1};
    batten_surface *plane = NULL;
    batten_deviation found = {.worst = 42};
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){2, 0, 0},
                                     (batten_vec3){0, 3, 0}, (batten_vec3){2, 3, 0}, &plane));
    CHECK_STATUS(batten_surface_deviation(plane, (batten_points){2, 2, points}, NULL, NULL,
                                          NULL, &found),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("the points have 2 coordinates, 3 are expected");
    CHECK_STATUS(batten_surface_project(plane, (batten_points){2, 2, points}, NULL, NULL,
                                        (batten_feet){NULL, NULL}, &found),
                 BATTEN_UNSUPPORTED);
    CHECK_STATUS(batten_surface_deviation(plane, (batten_points){3, 0, points}, NULL, NULL,
                                          NULL, &found),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_INT(found.worst, 42);
    batten_surface_unref(plane);
}
