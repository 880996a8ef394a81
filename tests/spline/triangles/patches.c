#include <batten/surface.h>
#include <batten/triangles.h>

#include "support/surfaces.h"
#include "support/test.h"
#include "support/triangles.h"

TEST(three_patches_cover_the_triangle_exactly)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(14); c++) {
        const int n = c < 7 ? c + 1 : test_random_int(&random, 1, 12);
        batten_triangles *triangles = NULL;
        batten_surface *patches[3];
        CHECK_OK(random_triangles(&random, 3, n, 2, c % 2, NULL, &triangles));
        CHECK_OK(batten_triangles_to_patches(triangles, 1, patches));
        for (int i = 0; i < 3; i++) {
            CHECK_INT(batten_surface_degree(patches[i], BATTEN_U), n);
            for (int k = 0; k < 9; k++) {
                const double u = k % 3 / 2.0, v = k / 3 / 2.0;
                double at[3], a[9], b[9];
                at[(i + 1) % 3] = u / 2 - u * v / 6;
                at[(i + 2) % 3] = v / 2 - u * v / 6;
                at[i] = 1 - at[(i + 1) % 3] - at[(i + 2) % 3];
                CHECK_OK(batten_surface_evaluate(patches[i], u, v, 1, a));
                CHECK_OK(batten_triangles_evaluate(triangles, 1, at, 1, b));
                for (int x = 0; x < 3; x++)
                    CHECK_NEAR(a[x], b[x], 1e-13);
                if (k != 4)
                    continue;
                batten_vec3 m, q; /* both sides are seen from the same side */
                CHECK_OK(batten_surface_normal(patches[i], u, v, NULL, &m));
                CHECK_OK(batten_triangles_normal(triangles, 1, at, NULL, &q));
                CHECK_NEAR(m.x * q.x + m.y * q.y + m.z * q.z, 1, 1e-9);
            }
            batten_surface_unref(patches[i]);
        }
        batten_triangles_unref(triangles);
    }
}

TEST(a_patch_with_a_pole_is_the_triangle)
{
    test_random random = test_random_begin(__func__);
    for (int n = 1; n <= 10; n++) {
        batten_triangles *triangles = NULL;
        batten_surface *patch = NULL;
        CHECK_OK(random_triangles(&random, 3, n, 1, n % 2, NULL, &triangles));
        CHECK_OK(batten_triangles_to_pole_patch(triangles, 0, &patch));
        for (int k = 0; k < 16; k++) {
            const double u = k % 4 / 3.0, v = k / 4 / 3.0;
            const double at[3] = {1 - u, u * (1 - v), u * v};
            double a[3], b[3];
            CHECK_OK(batten_surface_evaluate(patch, u, v, 0, a));
            CHECK_OK(batten_triangles_evaluate(triangles, 0, at, 0, b));
            for (int x = 0; x < 3; x++)
                CHECK_NEAR(a[x], b[x], 1e-14);
        }
        batten_triangles_unref(triangles);
        batten_surface_unref(patch);
    }
}

TEST(an_edge_is_the_curve_between_two_corners)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *triangles = NULL;
    CHECK_OK(random_triangles(&random, 3, 5, 1, true, NULL, &triangles));
    for (int e = 0; e < 3; e++) {
        batten_curve *edge = NULL;
        double at[3] = {0}, a[3], b[3];
        at[(e + 1) % 3] = 0.75;
        at[(e + 2) % 3] = 0.25;
        CHECK_OK(batten_triangles_edge(triangles, 0, e, &edge));
        CHECK_OK(batten_curve_evaluate(edge, 0.25, 0, a));
        CHECK_OK(batten_triangles_evaluate(triangles, 0, at, 0, b));
        for (int x = 0; x < 3; x++)
            CHECK_NEAR(a[x], b[x], 1e-14);
        batten_curve_unref(edge);
    }
    batten_triangles_unref(triangles);
}

TEST(a_surface_is_cut_into_triangles_over_its_domain)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(12); c++) {
        surface_data data;
        batten_surface *surface = NULL;
        batten_triangles *triangles = NULL;
        batten_triangulation domain;
        surface_data_random(&random, 4, &data);
        CHECK_OK(surface_data_create(&data, &surface));
        CHECK_OK(batten_triangles_from_surface(surface, &triangles));
        CHECK(batten_triangles_domain(triangles, &domain));
        CHECK_INT(batten_triangles_count(triangles),
                  2 * (batten_surface_spans(surface, BATTEN_U, NULL) - 1) *
                      (batten_surface_spans(surface, BATTEN_V, NULL) - 1));
        for (int t = 0; t < batten_triangles_count(triangles); t++) {
            const double at[3] = {0.5, 0.2, 0.3};
            double uv[2] = {0}, a[3], b[3];
            for (int e = 0; e < 3; e++)
                for (int k = 0; k < 2; k++)
                    uv[k] += at[e] * domain.vertices[2 * domain.corners[3 * t + e] + k];
            CHECK_OK(batten_surface_evaluate(surface, uv[0], uv[1], 0, a));
            CHECK_OK(batten_triangles_evaluate(triangles, t, at, 0, b));
            for (int k = 0; k < data.dimension; k++)
                CHECK_NEAR(a[k], b[k], 1e-11);
        }
        batten_triangles_unref(triangles);
        batten_surface_unref(surface);
    }
}

TEST(K9_surfaces_of_too_high_degrees_are_refused_as_triangles)
{
    double points[14 * 14] = {0}, knots[28] = {0};
    for (int i = 14; i < 28; i++)
        knots[i] = 1;
    const batten_axis axis = {13, 14, knots, false};
    batten_surface *surface = NULL;
    batten_triangles *none = NULL;
    CHECK_OK(batten_surface_create(1, &axis, &axis, points, NULL, &surface));
    CHECK_STATUS(batten_triangles_from_surface(surface, &none), BATTEN_BAD_DEGREE);
    CHECK_MESSAGE("triangles of degree 26");
    CHECK(!none);
    batten_surface_unref(surface);
}

TEST(the_half_at_an_edge_has_that_edge_and_the_slopes_there)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *triangles = NULL;
    CHECK_OK(random_triangles(&random, 3, 4, 2, true, NULL, &triangles));
    for (int e = 0; e < 3; e++) {
        batten_surface *half = NULL;
        CHECK_OK(batten_triangles_half_at_edge(triangles, 1, e, &half));
        for (int k = 0; k < 9; k++) {
            const double u = 0.5 + k % 3 / 4.0, v = k / 3 / 2.0;
            double at[3], a[3], b[3];
            at[e] = 1 - u;
            at[(e + 1) % 3] = u * (1 - v);
            at[(e + 2) % 3] = u * v;
            CHECK_OK(batten_surface_evaluate(half, u, v, 0, a));
            CHECK_OK(batten_triangles_evaluate(triangles, 1, at, 0, b));
            for (int x = 0; x < 3; x++)
                CHECK_NEAR(a[x], b[x], 1e-14);
        }
        batten_surface_unref(half);
    }
    batten_triangles_unref(triangles);
}
