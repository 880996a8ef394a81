/* Sets of Bezier triangles: what makes one, what is refused, what moves with a map. */
#include <batten/triangles.h>

#include "support/test.h"
#include "support/triangles.h"

#include <limits.h>

TEST(relabelled_corners_give_the_same_surface)
{
    test_random random = test_random_begin(__func__);
    const int n = 4;
    batten_triangles *triangles = NULL, *turned = NULL;
    double points[15 * 3];
    CHECK_OK(random_triangles(&random, 3, n, 1, false, NULL, &triangles));
    for (int j = 0; j <= n; j++)
        for (int k = 0; j + k <= n; k++) /* corner 0 becomes 1, 1 becomes 2, 2 becomes 0 */
            memcpy(points + 3 * BATTEN_TRIANGLE_POINT(n - j - k, j),
                   batten_triangles_points(triangles) + 3 * BATTEN_TRIANGLE_POINT(j, k),
                   3 * sizeof *points);
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, n, 1, points, NULL, NULL},
                                     &turned));
    for (int i = 0; i < 10; i++) {
        double at[3], a[3], b[3];
        random_place(&random, at);
        const double there[3] = {at[2], at[0], at[1]};
        CHECK_OK(batten_triangles_evaluate(triangles, 0, at, 0, a));
        CHECK_OK(batten_triangles_evaluate(turned, 0, there, 0, b));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(a[k], b[k], 1e-15);
    }
    batten_triangles_unref(triangles);
    batten_triangles_unref(turned);
}

TEST(a_box_holds_the_control_points_and_a_map_moves_the_points)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *triangles = NULL, *moved = NULL;
    CHECK_OK(random_triangles(&random, 3, 4, 2, true, NULL, &triangles));
    const batten_affine map = {{{1, 2, 0}, {0, -1, 3}, {0.5, 0, 1}}, {1, -2, 3}};
    CHECK_OK(batten_triangles_transform(triangles, &map, &moved));
    const batten_box box = batten_triangles_box(moved);
    for (int i = 0; i < 20; i++) {
        double at[3], p[3], q[3];
        random_place(&random, at);
        CHECK_OK(batten_triangles_evaluate(triangles, i % 2, at, 0, p));
        CHECK_OK(batten_triangles_evaluate(moved, i % 2, at, 0, q));
        const batten_vec3 wanted = batten_affine_apply(map, (batten_vec3){p[0], p[1], p[2]});
        CHECK_NEAR(q[0], wanted.x, 1e-14);
        CHECK_NEAR(q[1], wanted.y, 1e-14);
        CHECK_NEAR(q[2], wanted.z, 1e-14);
        CHECK(q[0] >= box.low.x && q[1] >= box.low.y && q[2] >= box.low.z &&
              q[0] <= box.high.x && q[1] <= box.high.y && q[2] <= box.high.z);
    }
    batten_affine wrong = map;
    wrong.m[1][1] = NAN;
    batten_triangles *none = NULL;
    CHECK_STATUS(batten_triangles_transform(triangles, &wrong, &none), BATTEN_NOT_FINITE);
    wrong = batten_affine_scaling(1e308, 1e308, 1e308);
    wrong.t[0] = 1e308;
    wrong.m[0][0] = 1.7e308;
    wrong.m[0][1] = 1.7e308;
    CHECK_STATUS(batten_triangles_transform(triangles, &wrong, &none), BATTEN_OVERFLOW);
    CHECK(!none);
    batten_triangles_unref(triangles);
    batten_triangles_unref(moved);
}

TEST(N1_numbers_that_are_none_are_refused_with_their_place)
{
    double points[18] = {0};
    double weights[6] = {1, 1, 1, 1, 1, 1};
    batten_triangles *none = NULL;
    points[7] = NAN;
    CHECK_STATUS(
        batten_triangles_create(&(batten_triangles_parts){3, 2, 1, points, NULL, NULL}, &none),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 2 of control point 3 of triangle 1");
    points[7] = 0;
    weights[4] = 0;
    CHECK_STATUS(batten_triangles_create(
                     &(batten_triangles_parts){3, 2, 1, points, weights, NULL}, &none),
                 BATTEN_BAD_WEIGHT);
    CHECK_MESSAGE("weight 5 of triangle 1 is 0");
    weights[4] = INFINITY;
    CHECK_STATUS(batten_triangles_create(
                     &(batten_triangles_parts){3, 2, 1, points, weights, NULL}, &none),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(
        batten_triangles_create(&(batten_triangles_parts){3, 26, 1, points, NULL, NULL}, &none),
        BATTEN_BAD_DEGREE);
    CHECK_STATUS(
        batten_triangles_create(&(batten_triangles_parts){3, 0, 1, points, NULL, NULL}, &none),
        BATTEN_BAD_DEGREE);
    CHECK_STATUS(
        batten_triangles_create(&(batten_triangles_parts){4, 2, 1, points, NULL, NULL}, &none),
        BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(
        batten_triangles_create(&(batten_triangles_parts){3, 2, 0, points, NULL, NULL}, &none),
        BATTEN_TOO_FEW_POINTS);
    CHECK(!none);
}

TEST(S5_more_triangles_than_are_allowed_are_refused_before_the_work)
{
    const double points[1] = {0};
    batten_triangles *none = NULL;
    CHECK_STATUS(batten_triangles_create(
                     &(batten_triangles_parts){1, 25, 1 << 30, points, NULL, NULL}, &none),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("1073741824 triangles of degree 25");
    CHECK(!none);
}

TEST(a_domain_without_area_or_order_is_refused_by_triangle)
{
    const double points[6] = {0};
    const double plane[] = {0, 0, 1, 0, 2, 0, 0, 1};
    const int flat[] = {0, 1, 3, 0, 1, 2}, clockwise[] = {0, 1, 3, 0, 3, 1},
              absent[] = {0, 1, 3, 0, 1, 4};
    const batten_triangulation domains[] = {
        {4, plane, flat}, {4, plane, clockwise}, {4, plane, absent}};
    const char *messages[] = {"triangle 2 of the domain, at vertices 1, 2 and 3, has no area",
                              "goes round clockwise", "corner 3 of triangle 2 is vertex 5"};
    batten_triangles *none = NULL;
    for (int i = 0; i < 3; i++) {
        CHECK_STATUS(batten_triangles_create(
                         &(batten_triangles_parts){1, 1, 2, points, NULL, &domains[i]}, &none),
                     i == 0 ? BATTEN_SINGULAR_HERE : BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(messages[i]);
    }
    CHECK(!none);
}

TEST(N2_huge_and_tiny_triangles_are_as_accurate)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *triangles = NULL, *scaled = NULL;
    const double at[3] = {0.25, 0.5, 0.25};
    double p[9], q[9];
    CHECK_OK(random_triangles(&random, 3, 3, 1, true, NULL, &triangles));
    CHECK_OK(batten_triangles_evaluate(triangles, 0, at, 1, p));
    for (int i = 0; i < 2; i++) {
        const double scale = i ? 0x1p-260 : 0x1p260;
        const batten_affine map = batten_affine_scaling(scale, scale, scale);
        CHECK_OK(batten_triangles_transform(triangles, &map, &scaled));
        CHECK_OK(batten_triangles_evaluate(scaled, 0, at, 1, q));
        for (int k = 0; k < 9; k++)
            CHECK_BITS(q[k], p[k] * scale);
        batten_triangles_unref(scaled);
    }
    batten_triangles_unref(triangles);
}

TEST(mirrored_triangles_keep_their_outside_outside)
{
    test_random random = test_random_begin(__func__);
    const batten_affine mirror =
        batten_affine_mirror((batten_vec3){1, 0, 2}, (batten_vec3){1, 2, -1});
    batten_affine linear = mirror;
    memset(linear.t, 0, sizeof linear.t);
    for (int rational = 0; rational < 2; rational++) {
        batten_triangles *triangles = NULL, *image = NULL;
        CHECK_OK(random_triangles(&random, 3, 4, 2, rational, NULL, &triangles));
        CHECK_OK(batten_triangles_transform(triangles, &mirror, &image));
        for (int i = 0; i < 20; i++) {
            double at[3], p[3], q[3];
            batten_vec3 n, m;
            random_place(&random, at);
            const double there[3] = {at[0], at[2], at[1]};
            CHECK_OK(batten_triangles_evaluate(triangles, i % 2, at, 0, p));
            CHECK_OK(batten_triangles_evaluate(image, i % 2, there, 0, q));
            const batten_vec3 wanted =
                batten_affine_apply(mirror, (batten_vec3){p[0], p[1], p[2]});
            CHECK_NEAR(q[0], wanted.x, 1e-13);
            CHECK_NEAR(q[1], wanted.y, 1e-13);
            CHECK_NEAR(q[2], wanted.z, 1e-13);
            CHECK_OK(batten_triangles_normal(triangles, i % 2, at, NULL, &n));
            CHECK_OK(batten_triangles_normal(image, i % 2, there, NULL, &m));
            n = batten_affine_apply(linear, n);
            CHECK_NEAR(m.x, n.x, 1e-9);
            CHECK_NEAR(m.y, n.y, 1e-9);
            CHECK_NEAR(m.z, n.z, 1e-9);
        }
        batten_triangles_unref(image);
        batten_triangles_unref(triangles);
    }
}

TEST(the_domain_of_mirrored_triangles_goes_round_as_before)
{
    const double points[9] = {0, 0, 1, 2, 0, 0, 0, 1, 0}, places[6] = {0, 0, 2, 0, 0, 1};
    const int around[3] = {0, 1, 2};
    const batten_triangulation domain = {3, places, around};
    const batten_affine mirror =
        batten_affine_mirror((batten_vec3){0, 0, 0}, (batten_vec3){0, 1, 0});
    batten_triangles *triangles = NULL, *image = NULL;
    batten_triangulation found;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 1, 1, points, NULL, &domain},
                                     &triangles));
    CHECK_OK(batten_triangles_transform(triangles, &mirror, &image));
    CHECK(batten_triangles_domain(image, &found));
    CHECK_INT(found.corners[1], 2);
    CHECK_NEAR(found.vertices[2], 0, 0); /* of vertex 1, (2, 0) */
    CHECK_NEAR(found.vertices[3], 2, 0);
    batten_triangles_unref(image);
    batten_triangles_unref(triangles);
}

TEST(sizes_of_sets_are_checked_before_their_numbers)
{
    const double points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, plane[6] = {0, 0, 1, 0, 0, 1};
    const int near[3] = {0, 1, 2}, below[3] = {0, -1, 2};
    const batten_triangulation few = {2, plane, near}, many = {INT_MAX, plane, near},
                               low = {3, plane, below};
    const struct {
        batten_triangles_parts parts;
        batten_status status;
        const char *words;
    } bad[] = {{{0, 1, 1, points, NULL, NULL}, BATTEN_BAD_ARGUMENT, "the dimension is 0"},
               {{4, 1, 1, points, NULL, NULL}, BATTEN_BAD_ARGUMENT, "the dimension is 4"},
               {{3, 0, 1, points, NULL, NULL}, BATTEN_BAD_DEGREE, "the degree is 0"},
               {{3, 26, 1, points, NULL, NULL}, BATTEN_BAD_DEGREE, "the degree is 26"},
               {{3, 1, 0, points, NULL, NULL}, BATTEN_TOO_FEW_POINTS, "there are 0 triangles"},
               {{1, 1, 1, points, NULL, &few}, BATTEN_BAD_ARGUMENT, "has 2 vertices"},
               {{1, 1, 1, points, NULL, &many}, BATTEN_BAD_ARGUMENT, "vertices; 3 to"},
               {{1, 1, 1, points, NULL, &low}, BATTEN_BAD_ARGUMENT, "corner 2 of triangle 1"}};
    for (int i = 0; i < COUNT(bad); i++) {
        batten_triangles *triangles = NULL;
        CHECK_STATUS(batten_triangles_create(&bad[i].parts, &triangles), bad[i].status);
        CHECK_MESSAGE(bad[i].words);
        CHECK(!triangles);
    }
    batten_triangles_unref(NULL);
}

TEST(a_set_without_a_domain_says_so)
{
    const double points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    batten_triangles *triangles = NULL;
    batten_triangulation domain = {.vertex_count = 77};
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 1, 1, points, NULL, NULL},
                                     &triangles));
    CHECK(!batten_triangles_domain(triangles, &domain));
    CHECK_INT(domain.vertex_count, 77);
    batten_triangles_unref(triangles);
}
