#include "spline/curve/curve.h"

#include <batten/triangles.h>

#include "support/test.h"
#include "support/triangles.h"

static const double vertices[] = {0, 0, 2, 0, 2, 1.5, -0.5, 1};
static const int corners[] = {0, 1, 2, 0, 2, 3};
static const batten_triangulation square = {4, vertices, corners};

static void check_near(const double *a, const double *b, int d, double tolerance)
{
    for (int k = 0; k < d; k++)
        CHECK_NEAR(a[k], b[k], tolerance);
}

TEST(elevation_moves_nothing)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(20); c++) {
        const int n = test_random_int(&random, 1, 10), by = test_random_int(&random, 0, 15);
        batten_triangles *triangles = NULL, *elevated = NULL;
        CHECK_OK(random_triangles(&random, 3, n, 2, c % 2, NULL, &triangles));
        CHECK_OK(batten_triangles_elevate(triangles, by, &elevated));
        CHECK_INT(batten_triangles_degree(elevated), n + by);
        for (int i = 0; i < 6; i++) {
            double at[3], a[3], b[3];
            random_place(&random, at);
            CHECK_OK(batten_triangles_evaluate(triangles, i % 2, at, 0, a));
            CHECK_OK(batten_triangles_evaluate(elevated, i % 2, at, 0, b));
            check_near(a, b, 3, 1e-13);
        }
        batten_triangles_unref(triangles);
        batten_triangles_unref(elevated);
    }
}

TEST(K9_a_degree_above_25_is_refused)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *triangles = NULL, *none = NULL;
    CHECK_OK(random_triangles(&random, 1, 24, 1, false, NULL, &triangles));
    CHECK_STATUS(batten_triangles_elevate(triangles, 2, &none), BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_triangles_elevate(triangles, -1, &none), BATTEN_BAD_DEGREE);
    CHECK(!none);
    batten_triangles_unref(triangles);
}

/* All parts of a function over a domain have its values. */
static void check_function(const batten_triangles *parts, test_random *random)
{
    batten_triangulation domain;
    CHECK(batten_triangles_domain(parts, &domain));
    for (int t = 0; t < batten_triangles_count(parts); t++) {
        double at[3], value, x = 0, y = 0;
        random_place(random, at);
        for (int e = 0; e < 3; e++) {
            x += at[e] * domain.vertices[2 * domain.corners[3 * t + e]];
            y += at[e] * domain.vertices[2 * domain.corners[3 * t + e] + 1];
        }
        CHECK_OK(batten_triangles_evaluate(parts, t, at, 0, &value));
        CHECK_NEAR(value, example_cubic(x, y), 1e-13);
    }
}

TEST(parts_are_the_same_function_over_a_finer_domain)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *whole = NULL, *split = NULL, *halved = NULL, *again = NULL;
    const double at[3] = {0.5, 0.3, 0.2};
    batten_triangulation domain;
    CHECK_OK(example_triangles(2, &square, &whole));
    CHECK_OK(batten_triangles_split(whole, 1, at, &split));
    CHECK_INT(batten_triangles_count(split), 4);
    check_function(split, &random);
    CHECK_OK(batten_triangles_halve(split, &halved));
    CHECK_INT(batten_triangles_count(halved), 16);
    check_function(halved, &random);
    CHECK_OK(batten_triangles_halve(whole, &again));
    CHECK(batten_triangles_domain(again, &domain));
    CHECK_INT(domain.vertex_count, 9); /* the middle of the shared edge once */
    batten_triangles_unref(whole);
    batten_triangles_unref(split);
    batten_triangles_unref(halved);
    batten_triangles_unref(again);
}

TEST(rational_parts_lie_on_the_whole)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *whole = NULL, *split = NULL, *halved = NULL, *chosen = NULL;
    const double centre[3] = {0.25, 0.25, 0.5}, at[3] = {0.2, 0.3, 0.5};
    CHECK_OK(random_triangles(&random, 3, 6, 1, true, NULL, &whole));
    CHECK_OK(batten_triangles_split(whole, 0, centre, &split));
    CHECK_OK(batten_triangles_halve(whole, &halved));
    double part[3], point[3];
    for (int e = 0; e < 3; e++) {
        double there[3];
        for (int c = 0; c < 3; c++)
            there[c] = at[e] * centre[c] + (c == e ? 0 : at[c]);
        CHECK_OK(batten_triangles_evaluate(split, e, at, 0, part));
        CHECK_OK(batten_triangles_evaluate(whole, 0, there, 0, point));
        check_near(part, point, 3, 1e-14);
        for (int c = 0; c < 3; c++)
            there[c] = at[c] / 2 + (c == e ? 0.5 : 0);
        CHECK_OK(batten_triangles_evaluate(halved, e, at, 0, part));
        CHECK_OK(batten_triangles_evaluate(whole, 0, there, 0, point));
        check_near(part, point, 3, 1e-14);
    }
    const double inner[3] = {(1 - at[0]) / 2, (1 - at[1]) / 2, (1 - at[2]) / 2};
    CHECK_OK(batten_triangles_evaluate(halved, 3, at, 0, part));
    CHECK_OK(batten_triangles_evaluate(whole, 0, inner, 0, point));
    check_near(part, point, 3, 1e-14);
    const int last = 3, absent = 4;
    CHECK_OK(batten_triangles_select(halved, 1, &last, &chosen));
    CHECK_OK(batten_triangles_evaluate(chosen, 0, at, 0, point));
    check_near(part, point, 3, 1e-14);
    batten_triangles *none = NULL;
    CHECK_STATUS(batten_triangles_select(halved, 1, &absent, &none), BATTEN_OUT_OF_DOMAIN);
    batten_triangles_unref(whole);
    batten_triangles_unref(split);
    batten_triangles_unref(halved);
    batten_triangles_unref(chosen);
}

TEST(a_triangle_is_not_cut_at_its_edge)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *whole = NULL, *none = NULL;
    const double edge[3] = {0, 0.5, 0.5};
    CHECK_OK(random_triangles(&random, 3, 2, 1, false, NULL, &whole));
    CHECK_STATUS(batten_triangles_split(whole, 0, edge, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_triangles_from_function(whole, &none), BATTEN_BAD_ARGUMENT);
    CHECK(!none);
    batten_triangles_unref(whole);
}

TEST(S5_halving_beyond_the_limit_is_refused)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *whole = NULL, *finer = NULL;
    batten_status status = BATTEN_OK;
    CHECK_OK(random_triangles(&random, 1, 25, 600, false, NULL, &whole));
    int *which = test_array(20000, sizeof *which);
    CHECK_OK(batten_triangles_select(whole, 20000, which, &finer));
    batten_triangles_unref(whole);
    whole = NULL;
    status = batten_triangles_halve(finer, &whole);
    CHECK_INT(status, BATTEN_TOO_LARGE);
    CHECK(!whole);
    batten_triangles_unref(finer);
}

TEST(two_sets_become_one_of_the_higher_degree)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *first = NULL, *second = NULL, *all = NULL, *plane = NULL;
    const double at[3] = {0.2, 0.3, 0.5};
    double a[3], b[3];
    CHECK_OK(random_triangles(&random, 3, 4, 2, false, NULL, &first));
    CHECK_OK(random_triangles(&random, 3, 2, 1, true, NULL, &second));
    CHECK_OK(batten_triangles_together(first, second, &all));
    CHECK(batten_triangles_count(all) == 3 && batten_triangles_degree(all) == 4);
    CHECK_OK(batten_triangles_evaluate(first, 1, at, 0, a));
    CHECK_OK(batten_triangles_evaluate(all, 1, at, 0, b));
    check_near(a, b, 3, 1e-15);
    CHECK_OK(batten_triangles_evaluate(second, 0, at, 0, a));
    CHECK_OK(batten_triangles_evaluate(all, 2, at, 0, b));
    check_near(a, b, 3, 1e-15);
    batten_triangles *none = NULL;
    CHECK_OK(random_triangles(&random, 2, 2, 1, true, NULL, &plane));
    CHECK_STATUS(batten_triangles_together(first, plane, &none), BATTEN_NOT_COMPATIBLE);
    CHECK(!none);
    batten_triangles_unref(first);
    batten_triangles_unref(second);
    batten_triangles_unref(all);
    batten_triangles_unref(plane);
}

TEST(a_triangle_is_cut_at_a_place_whose_coordinates_have_the_sum_1)
{
    const double points[3] = {1, 2, 4};
    const double bad[][3] = {
        {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}, {0.5, 0.3, 0.3}, {0.5, 0.2, 0.2}};
    batten_triangles *one = NULL, *cut = NULL;
    CHECK_OK(
        batten_triangles_create(&(batten_triangles_parts){1, 1, 1, points, NULL, NULL}, &one));
    for (int i = 0; i < COUNT(bad); i++)
        CHECK_STATUS(batten_triangles_split(one, 0, bad[i], &cut), BATTEN_BAD_ARGUMENT);
    CHECK(!cut);
    batten_triangles_unref(one);
}

TEST(S5_sets_beyond_the_limit_are_refused_by_every_change)
{
    enum { MANY = 29000 }; /* of degree 25, 351 points each, are more than ten millions */
    double *points = test_array((size_t)MANY * 3, sizeof *points);
    int *first = test_array((size_t)BAT_MAX_POINTS / 351 + 2, sizeof *first);
    batten_triangles *many = NULL, *high = NULL, *made = NULL;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){1, 1, MANY, points, NULL, NULL},
                                     &many));
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){1, 25, 1, points, NULL, NULL},
                                     &high));
    CHECK_STATUS(batten_triangles_elevate(many, 24, &made), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("29000 triangles of degree 25");
    CHECK_STATUS(batten_triangles_together(many, high, &made), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("29001 triangles of degree 25");
    CHECK_STATUS(batten_triangles_select(high, BAT_MAX_POINTS / 351 + 1, first, &made),
                 BATTEN_TOO_LARGE);
    CHECK(!made);
    batten_triangles_unref(many);
    batten_triangles_unref(high);
}
