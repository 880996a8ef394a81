#include "spline/surface/surface.h"

#include "support/surfaces.h"
#include "support/test.h"
#include <batten/standard.h>

enum { N = 13, M = 9, MOST = BATTEN_SURFACE_DERIVATIVES(3) * 3 };

TEST(a_grid_has_the_bits_of_single_points_for_any_number_of_threads)
{
    test_random random = test_random_begin(__func__);
    static double grid[N * M * MOST];
    for (int c = 0; c < test_cases(60); c++) {
        surface_data data;
        surface_data_random(&random, c % 2 ? 3 : 7, &data);
        batten_surface *surface = NULL;
        CHECK_OK(surface_data_create(&data, &surface));
        const int order = c % 4, size = BATTEN_SURFACE_DERIVATIVES(order) * data.dimension;
        double u[N], v[M], one[MOST];
        for (int i = 0; i < N; i++)
            u[i] = random_parameter(&random, surface, BATTEN_U);
        for (int j = 0; j < M; j++)
            v[j] = random_parameter(&random, surface, BATTEN_V);
        batten_job job = BATTEN_JOB;
        job.thread_count = 1 << c % 3;
        CHECK_OK(batten_surface_evaluate_grid(surface, (batten_uv_grid){N, M, u, v}, order,
                                              &job, grid));
        for (int i = 0; i < N; i++)
            for (int j = 0; j < M; j++) {
                CHECK_OK(batten_surface_evaluate(surface, u[i], v[j], order, one));
                for (int k = 0; k < size; k++)
                    CHECK_BITS(grid[(i * M + j) * size + k], one[k]);
            }
        batten_surface_unref(surface);
    }
}

TEST(cubics_two_at_a_time_have_the_bits_of_single_points)
{
    enum { DENSE = 41 };
    test_random random = test_random_begin(__func__);
    double knots[11], points[7 * 7 * 3], u[N], v[DENSE], one[3];
    static double grid[N * DENSE * 3];
    for (int c = 0; c < test_cases(20); c++) {
        random_knots(&random, 3, 7, knots);
        const batten_axis axis = {3, 7, knots, false};
        for (int i = 0; i < 7 * 7 * 3; i++)
            points[i] = test_random_in(&random, -10, 10);
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
        /* Rising parameters, so that spans hold one, an odd or an even number of them. */
        for (int i = 0; i < N; i++)
            u[i] = random_parameter(&random, surface, BATTEN_U);
        for (int j = 0; j < DENSE; j++)
            v[j] = j / (DENSE - 1.0);
        const size_t count = (size_t)test_random_int(&random, 1, DENSE);
        CHECK_OK(batten_surface_evaluate_grid(surface, (batten_uv_grid){N, count, u, v}, 0,
                                              NULL, grid));
        for (size_t i = 0; i < N; i++)
            for (size_t j = 0; j < count; j++) {
                CHECK_OK(batten_surface_evaluate(surface, u[i], v[j], 0, one));
                for (size_t k = 0; k < 3; k++)
                    CHECK_BITS(grid[(i * count + j) * 3 + k], one[k]);
            }
        batten_surface_unref(surface);
    }
}

TEST(many_threads_give_the_bits_of_one)
{
    enum { LARGE = 200 };
    const batten_frame world = batten_frame_world();
    batten_surface *torus = NULL;
    CHECK_OK(batten_surface_torus(&world, 3, 1, &torus));
    double t[LARGE];
    for (int i = 0; i < LARGE; i++)
        t[i] = i / (LARGE - 1.0);
    double *out[3][2], *uv = test_array(2 * LARGE * LARGE, sizeof *uv);
    for (int i = 0; i < LARGE * LARGE; i++) {
        uv[2 * i] = t[i / LARGE];
        uv[2 * i + 1] = t[i % LARGE];
    }
    for (int k = 0; k < 3; k++) {
        batten_job job = BATTEN_JOB;
        job.thread_count = 1 << k;
        for (int n = 0; n < 2; n++)
            out[k][n] = test_array(3 * LARGE * LARGE, sizeof(double));
        CHECK_OK(batten_surface_normal_grid(torus, (batten_uv_grid){LARGE, LARGE, t, t}, &job,
                                            out[k][0], out[k][1]));
        CHECK(memcmp(out[k][0], out[0][0], 3 * LARGE * LARGE * sizeof(double)) == 0);
        CHECK(memcmp(out[k][1], out[0][1], 3 * LARGE * LARGE * sizeof(double)) == 0);
        CHECK_OK(batten_surface_evaluate_many(torus, LARGE * LARGE, uv, 0, &job, out[k][1]));
        CHECK(memcmp(out[k][1], out[0][0], 3 * LARGE * LARGE * sizeof(double)) == 0);
        if (k == 0)
            CHECK_OK(batten_surface_normal_grid(torus, (batten_uv_grid){LARGE, LARGE, t, t},
                                                &job, NULL, out[0][1]));
    }
    batten_surface_unref(torus);
}

TEST(a_grid_of_normals_is_the_single_normals)
{
    test_random random = test_random_begin(__func__);
    const batten_frame world = batten_frame_world();
    for (int c = 0; c < test_cases(40); c++) {
        batten_surface *surface = NULL;
        surface_data data;
        surface_data_random(&random, c % 2 ? 3 : 5, &data);
        data.dimension = 2 + (c > 3);
        if (c % 4 == 1)
            CHECK_OK(batten_surface_cone(&world, 1, 0, 2, &surface));
        else
            CHECK_OK(surface_data_create(&data, &surface));
        const int d = batten_surface_dimension(surface);
        double u[N], v[M], points[N * M * 3], normals[N * M * 3];
        for (int i = 0; i < N; i++)
            u[i] = random_parameter(&random, surface, BATTEN_U);
        for (int j = 0; j < M; j++)
            v[j] = random_parameter(&random, surface, BATTEN_V);
        CHECK_OK(batten_surface_normal_grid(surface, (batten_uv_grid){N, M, u, v}, NULL, points,
                                            normals));
        CHECK_OK(batten_surface_normal_grid(surface, (batten_uv_grid){N, M, u, v}, NULL, points,
                                            NULL));
        for (int i = 0; i < N * M; i++) {
            double one[3] = {0};
            batten_vec3 normal = {0, 0, 0};
            CHECK_OK(batten_surface_evaluate(surface, u[i / M], v[i % M], 0, one));
            const batten_status status =
                batten_surface_normal(surface, u[i / M], v[i % M], NULL, &normal);
            CHECK(status == BATTEN_OK || status == BATTEN_SINGULAR_HERE ||
                  status == BATTEN_OUT_OF_MEMORY);
            for (int k = 0; k < d; k++)
                CHECK_BITS(points[3 * i + k], one[k]);
            if (status == BATTEN_OUT_OF_MEMORY)
                continue;
            CHECK_BITS(normals[3 * i], normal.x);
            CHECK_BITS(normals[3 * i + 1], normal.y);
            CHECK_BITS(normals[3 * i + 2], normal.z);
        }
        batten_surface_unref(surface);
    }
}

TEST(G5_the_grid_of_a_cone_says_0_at_its_apex_and_that_of_a_sphere_its_poles)
{
    const batten_frame world = batten_frame_world();
    batten_surface *cone = NULL, *sphere = NULL;
    const double u[] = {0, 0.3, 0.9, 1}, v[] = {0, 1};
    double normals[24];
    CHECK_OK(batten_surface_cone(&world, 1, 0, 2, &cone));
    CHECK_OK(batten_surface_sphere(&world, 1, &sphere));
    CHECK_OK(
        batten_surface_normal_grid(cone, (batten_uv_grid){4, 2, u, v}, NULL, NULL, normals));
    for (int i = 0; i < 4; i++)
        CHECK(normals[6 * i + 3] == 0 && normals[6 * i + 4] == 0 && normals[6 * i + 5] == 0);
    CHECK_OK(
        batten_surface_normal_grid(sphere, (batten_uv_grid){4, 2, u, v}, NULL, NULL, normals));
    for (int i = 0; i < 4; i++) {
        CHECK_NEAR(normals[6 * i + 2], -1, 1e-12);
        CHECK_NEAR(normals[6 * i + 5], 1, 1e-12);
    }
    batten_surface_unref(cone);
    batten_surface_unref(sphere);
}

TEST(N7_a_grid_with_a_parameter_outside_writes_nothing)
{
    const batten_frame world = batten_frame_world();
    batten_surface *sphere = NULL;
    CHECK_OK(batten_surface_sphere(&world, 1, &sphere));
    double u[] = {0, nextafter(1, 2)}, v[] = {0.5, 1.5}, out[12] = {7};
    CHECK_STATUS(
        batten_surface_evaluate_grid(sphere, (batten_uv_grid){2, 2, u, v}, 0, NULL, out),
        BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("v[1] = 1.5");
    u[0] = NAN;
    CHECK_STATUS(
        batten_surface_evaluate_grid(sphere, (batten_uv_grid){2, 1, u, v}, 0, NULL, out),
        BATTEN_NOT_FINITE);
    CHECK(out[0] == 7);
    CHECK_OK(
        batten_surface_evaluate_grid(sphere, (batten_uv_grid){1, 1, u + 1, v}, 0, NULL, out));
    CHECK_OK(
        batten_surface_evaluate_grid(sphere, (batten_uv_grid){0, 1, NULL, v}, 0, NULL, NULL));
    CHECK_OK(batten_surface_evaluate_grid(sphere, (batten_uv_grid){1, 0, u + 1, NULL}, 0, NULL,
                                          NULL));
    batten_surface_unref(sphere);
}

TEST(N2_an_overflow_in_a_grid_is_a_status)
{
    static const double knots[] = {0, 0, 1, 1};
    const double big = 1.5e308, points[] = {big, 0, 0, big, 0, 0, -big, 0, 0, -big, 0, 0};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL;
    const double t[] = {0.5};
    double out[9];
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    CHECK_STATUS(
        batten_surface_evaluate_grid(surface, (batten_uv_grid){1, 1, t, t}, 1, NULL, out),
        BATTEN_OVERFLOW);
    batten_surface_unref(surface);
    const double twice[] = {1.7e308, 0, 0, 1.7e308, 0, 0, 1.7e308, 0, 0, 1.7e308, 0, 0};
    const double heavy[] = {1, 1.9, 1, 1.9};
    CHECK_OK(batten_surface_create(3, &axis, &axis, twice, heavy, &surface));
    CHECK_STATUS(
        batten_surface_normal_grid(surface, (batten_uv_grid){1, 1, t, t}, NULL, out, NULL),
        BATTEN_OVERFLOW);
    batten_surface_unref(surface);
}
