/* Points, derivatives and normals of Bezier triangles against their definitions, and what is refused. */
#include <batten/triangles.h>

#include "support/test.h"
#include "support/triangles.h"

static const double vertices[] = {0, 0, 2, 0, 2, 1.5, -0.5, 1};
static const int corners[] = {0, 1, 2, 0, 2, 3};
static const batten_triangulation square = {4, vertices, corners};

TEST(a_triangle_is_the_sum_of_its_points_with_bernstein_polynomials)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        const int degree = c < 25 ? c + 1 : test_random_int(&random, 1, 8);
        const int dimension = test_random_int(&random, 1, 3);
        batten_triangles *triangles = NULL;
        CHECK_OK(random_triangles(&random, dimension, degree, 3, c % 2, NULL, &triangles));
        for (int i = 0; i < 8; i++) {
            double at[3], point[3], defined[3];
            random_place(&random, at);
            CHECK_OK(batten_triangles_evaluate(triangles, i % 3, at, 0, point));
            define_triangle_point(triangles, i % 3, at, defined);
            for (int k = 0; k < dimension; k++)
                CHECK_NEAR(point[k], defined[k], 8 * degree * DBL_EPSILON);
        }
        batten_triangles_unref(triangles);
    }
}

TEST(derivatives_are_those_of_the_polynomial)
{
    batten_triangles *triangles = NULL, *graph = NULL;
    CHECK_OK(example_triangles(2, &square, &triangles));
    CHECK_OK(batten_triangles_from_function(triangles, &graph));
    const double at[3] = {0.5, 0.2, 0.3};
    double table[10], point[3];
    CHECK_OK(batten_triangles_evaluate(triangles, 1, at, 3, table));
    CHECK_OK(batten_triangles_evaluate(graph, 1, at, 0, point));
    const double x = point[0], y = point[1];
    CHECK_NEAR(x, 0.2 * 2 + 0.3 * -0.5, 1e-15);
    CHECK_NEAR(point[2], example_cubic(x, y), 1e-14);
    /* u leads to vertex 2, v to vertex 3 */
    const double fx = 2 * x * y + 2 * y + 1, fy = x * x + 2 * x - 6 * y;
    const double fxx = 2 * y, fxy = 2 * x + 2, fyy = -6, fxxy = 2;
    const double ux = 2, uy = 1.5, vx = -0.5, vy = 1;
    CHECK_NEAR(table[1], fx * ux + fy * uy, 1e-13);
    CHECK_NEAR(table[2], fx * vx + fy * vy, 1e-13);
    CHECK_NEAR(table[3], fxx * ux * ux + 2 * fxy * ux * uy + fyy * uy * uy, 1e-13);
    CHECK_NEAR(table[4], fxx * ux * vx + fxy * (ux * vy + uy * vx) + fyy * uy * vy, 1e-13);
    CHECK_NEAR(table[5], fxx * vx * vx + 2 * fxy * vx * vy + fyy * vy * vy, 1e-13);
    CHECK_NEAR(table[6], 3 * fxxy * ux * ux * uy, 1e-12);
    CHECK_NEAR(table[9], 3 * fxxy * vx * vx * vy, 1e-12);
    batten_triangles_unref(triangles);
    batten_triangles_unref(graph);
}

TEST(rational_derivatives_agree_with_differences_and_vanish_above_the_degree_of_polynomials)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(10); c++) {
        batten_triangles *triangles = NULL;
        const double h = 1e-5, at[3] = {0.3, 0.3, 0.4};
        double table[3 * 6], ahead[3], behind[3];
        CHECK_OK(random_triangles(&random, 3, 4, 1, true, NULL, &triangles));
        CHECK_OK(batten_triangles_evaluate(triangles, 0, at, 2, table));
        const double to[3] = {0.3 - h, 0.3 + h, 0.4}, from[3] = {0.3 + h, 0.3 - h, 0.4};
        CHECK_OK(batten_triangles_evaluate(triangles, 0, to, 0, ahead));
        CHECK_OK(batten_triangles_evaluate(triangles, 0, from, 0, behind));
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR((ahead[k] - behind[k]) / (2 * h), table[3 + k], 1e-7);
            CHECK_NEAR((ahead[k] - 2 * table[k] + behind[k]) / (h * h), table[9 + k], 1e-3);
        }
        batten_triangles_unref(triangles);
        double high[3 * 10];
        CHECK_OK(random_triangles(&random, 3, 2, 1, false, NULL, &triangles));
        CHECK_OK(batten_triangles_evaluate(triangles, 0, at, 3, high));
        for (int k = 18; k < 30; k++)
            CHECK_BITS(high[k], 0.0);
        batten_triangles_unref(triangles);
    }
}

TEST(many_points_have_the_bits_of_one)
{
    test_random random = test_random_begin(__func__);
    enum { MANY = 700 };
    batten_triangles *triangles = NULL;
    int *which = test_array(MANY, sizeof *which);
    double *at = test_array(3 * MANY, sizeof *at);
    double *many = test_array(9 * MANY, sizeof *many);
    CHECK_OK(random_triangles(&random, 3, 5, 4, true, NULL, &triangles));
    for (int i = 0; i < MANY; i++) {
        which[i] = test_random_int(&random, 0, 3);
        random_place(&random, at + 3 * i);
    }
    for (int threads = 1; threads <= 3; threads += 2) {
        batten_job job = BATTEN_JOB;
        job.thread_count = threads;
        CHECK_OK(batten_triangles_evaluate_many(
            triangles, (batten_triangle_places){MANY, which, at}, 1, &job, many));
        for (int i = 0; i < MANY; i += 7) {
            double one[9];
            CHECK_OK(batten_triangles_evaluate(triangles, which[i], at + 3 * i, 1, one));
            for (int k = 0; k < 9; k++)
                CHECK_BITS(many[9 * i + k], one[k]);
        }
    }
    at[3 * 99] += 0.5;
    CHECK_STATUS(batten_triangles_evaluate_many(
                     triangles, (batten_triangle_places){MANY, which, at}, 0, NULL, many),
                 BATTEN_OUT_OF_DOMAIN);
    batten_triangles_unref(triangles);
}

TEST(normals_stand_on_both_derivatives)
{
    const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const double line[] = {0, 0, 0, 1, 0, 0, 2, 0, 0};
    const double at[3] = {0.2, 0.3, 0.5};
    batten_triangles *triangles = NULL;
    batten_vec3 normal = {0};
    bool is_limit = true;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 1, 1, points, NULL, NULL},
                                     &triangles));
    CHECK_OK(batten_triangles_normal(triangles, 0, at, &is_limit, &normal));
    CHECK(normal.x == 0 && normal.y == 0 && normal.z == 1 && !is_limit);
    batten_triangles_unref(triangles);
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 1, 1, line, NULL, NULL},
                                     &triangles));
    CHECK_STATUS(batten_triangles_normal(triangles, 0, at, NULL, &normal),
                 BATTEN_SINGULAR_HERE);
    batten_triangles_unref(triangles);
}

TEST(G5_a_collapsed_row_has_the_normal_of_its_limit)
{
    /* A quadratic whose corner 0 has no derivatives: the first two rows lie in one point; the
     * rest in the plane z = x. */
    const double points[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 1, 0.5, 1, 1, 1, 1};
    const double corner[3] = {1, 0, 0};
    batten_triangles *triangles = NULL;
    batten_vec3 normal = {0};
    bool is_limit = false;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 2, 1, points, NULL, NULL},
                                     &triangles));
    CHECK_OK(batten_triangles_normal(triangles, 0, corner, &is_limit, &normal));
    CHECK(is_limit);
    CHECK_NEAR(normal.x, -sqrt(0.5), 1e-12);
    CHECK_NEAR(normal.y, 0, 1e-12);
    CHECK_NEAR(normal.z, sqrt(0.5), 1e-12);
    batten_triangles_unref(triangles);
}

TEST(places_outside_the_triangle_are_refused_and_rounding_is_not)
{
    const double points[3] = {1, 2, 4};
    const double bad[][3] = {{0.5, 0.5, 0.5}, {-0.1, 0.6, 0.5}, {NAN, 0.5, 0.5}};
    const double near[3] = {-1e-12, 0.5, 0.5};
    batten_triangles *triangles = NULL;
    double value = 7;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){1, 1, 1, points, NULL, NULL},
                                     &triangles));
    for (int i = 0; i < 3; i++)
        CHECK_STATUS(batten_triangles_evaluate(triangles, 0, bad[i], 0, &value),
                     i == 2 ? BATTEN_NOT_FINITE : BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_triangles_evaluate(triangles, 1, near, 0, &value),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_BITS(value, 7.0);
    CHECK_OK(batten_triangles_evaluate(triangles, 0, near, 0, &value));
    CHECK_NEAR(value, 3, 1e-11);
    batten_triangles_unref(triangles);
}

TEST(each_coordinate_of_a_place_is_checked)
{
    const double points[3] = {1, 2, 4}, huge[3] = {1e308, -1e308, 1e308};
    batten_triangles *triangles = NULL, *steep = NULL;
    double table[3] = {7, 7, 7};
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){1, 1, 1, points, NULL, NULL},
                                     &triangles));
    for (int e = 0; e < 3; e++) {
        double at[3] = {0.6, 0.6, 0.6};
        at[e] = -0.2;
        CHECK_STATUS(batten_triangles_evaluate(triangles, 0, at, 0, table),
                     BATTEN_OUT_OF_DOMAIN);
        CHECK_MESSAGE("outside the triangle");
    }
    const double middle[3] = {0.5, 0.25, 0.25};
    CHECK_STATUS(batten_triangles_evaluate(triangles, -1, middle, 0, table),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("triangle 0 does not exist; there are 1");
    CHECK_STATUS(batten_triangles_normal(triangles, 0, middle, NULL, &(batten_vec3){0}),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("dimension 1 have no normal");
    CHECK_BITS(table[0], 7.0);
    CHECK_OK(
        batten_triangles_create(&(batten_triangles_parts){1, 1, 1, huge, NULL, NULL}, &steep));
    CHECK_OK(batten_triangles_evaluate(steep, 0, middle, 0, table));
    CHECK_NEAR(table[0], 5e307, 1e293);
    CHECK_STATUS(batten_triangles_evaluate(steep, 0, middle, 1, table), BATTEN_OVERFLOW);
    CHECK_STATUS(batten_triangles_evaluate_many(
                     steep,
                     (batten_triangle_places){2, (const int[2]){0, 0},
                                              (const double[6]){0.5, 0.25, 0.25, 1, 0, 0}},
                     1, NULL, (double[6]){0}),
                 BATTEN_OVERFLOW);
    batten_triangles_unref(triangles);
    batten_triangles_unref(steep);
}

TEST(a_net_too_large_for_the_stack_is_evaluated_alike)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *triangles = NULL;
    double at[3], point[3], defined[3];
    CHECK_OK(random_triangles(&random, 3, 20, 1, true, NULL, &triangles));
    for (int i = 0; i < 5; i++) {
        random_place(&random, at);
        CHECK_OK(batten_triangles_evaluate(triangles, 0, at, 0, point));
        define_triangle_point(triangles, 0, at, defined);
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(point[k], defined[k], 1e-13);
    }
    batten_triangles_unref(triangles);
}

TEST(a_collapsed_corner_has_the_normal_of_its_limit_whichever_it_is)
{
    /* The plane x, y over a triangle of degree 2 whose both edges at one corner begin with a
     * double point: the first derivatives vanish there, and the normal is that of the plane. */
    for (int corner = 0; corner < 3; corner++) {
        static const double ends[3][2] = {{0, 0}, {3, 0}, {0, 2}};
        double points[6][3] = {{0}};
        for (int j = 0; j <= 2; j++)
            for (int k = 0; j + k <= 2; k++) {
                int share[3] = {2 - j - k, j, k};
                if (share[corner] == 1)
                    for (int e = 0; e < 3; e++)
                        share[e] = e == corner ? 2 : 0;
                for (int e = 0; e < 3; e++)
                    for (int x = 0; x < 2; x++)
                        points[BATTEN_TRIANGLE_POINT(j, k)][x] += share[e] * ends[e][x] / 2;
            }
        batten_triangles *triangles = NULL;
        batten_vec3 normal = {0, 0, 0};
        bool is_limit = false;
        const double at[3] = {corner == 0, corner == 1, corner == 2};
        CHECK_OK(batten_triangles_create(
            &(batten_triangles_parts){3, 2, 1, &points[0][0], NULL, NULL}, &triangles));
        CHECK_OK(batten_triangles_normal(triangles, 0, at, &is_limit, &normal));
        CHECK(is_limit);
        CHECK_NEAR(normal.z, 1, 1e-12);
        batten_triangles_unref(triangles);
    }
}
