#include "spline/surface/normal.h"

#include "support/surfaces.h"
#include "support/test.h"
#include <batten/standard.h>

static void check_normal(const batten_surface *surface, double u, double v,
                         batten_vec3 expected, bool limit, double tolerance)
{
    batten_vec3 normal;
    bool is_limit;
    CHECK_OK(batten_surface_normal(surface, u, v, &is_limit, &normal));
    CHECK_NEAR(normal.x, expected.x, tolerance);
    CHECK_NEAR(normal.y, expected.y, tolerance);
    CHECK_NEAR(normal.z, expected.z, tolerance);
    CHECK(is_limit == limit);
}

TEST(the_normal_of_a_sphere_is_its_direction)
{
    const batten_frame world = batten_frame_world();
    batten_surface *sphere = NULL;
    CHECK_OK(batten_surface_sphere(&world, 2, &sphere));
    for (int i = 0; i <= 16; i++)
        for (int j = 1; j < 16; j++) {
            double at[3];
            CHECK_OK(batten_surface_evaluate(sphere, i / 16.0, j / 16.0, 0, at));
            check_normal(sphere, i / 16.0, j / 16.0,
                         (batten_vec3){at[0] / 2, at[1] / 2, at[2] / 2}, false, 1e-13);
        }
    batten_surface_unref(sphere);
}

TEST(G5_at_the_poles_of_a_sphere_the_normal_is_the_limit)
{
    const batten_frame frames[] = {batten_frame_world(),
                                   {{1000, 2000, -3000}, {1, 0, 0}, {0, 0, 1}}};
    for (int k = 0; k < COUNT(frames); k++) {
        batten_surface *sphere = NULL;
        CHECK_OK(batten_surface_sphere(&frames[k], 2, &sphere));
        for (int i = 0; i <= 7; i++) {
            check_normal(sphere, i / 7.0, 0, (batten_vec3){0, 0, -1}, true, 1e-9);
            check_normal(sphere, i / 7.0, 1, (batten_vec3){0, 0, 1}, true, 1e-9);
        }
        batten_surface_unref(sphere);
    }
}

TEST(G5_the_apex_of_a_cone_is_singular)
{
    const batten_frame world = batten_frame_world();
    batten_surface *cone = NULL;
    CHECK_OK(batten_surface_cone(&world, 1, 0, 1, &cone));
    batten_vec3 normal = {7, 7, 7};
    for (int i = 0; i <= 7; i++) {
        CHECK_STATUS(batten_surface_normal(cone, i / 7.0, 1, NULL, &normal),
                     BATTEN_SINGULAR_HERE);
        CHECK(normal.x == 7);
    }
    const double s = sqrt(0.5);
    check_normal(cone, 0, 0.5, (batten_vec3){s, 0, s}, false, 1e-14);
    batten_surface_unref(cone);
}

/* Of corners a, b, c: u along ab, v towards c, where the edge v = 1 lies in c. */
static batten_status three_sided(batten_surface **out)
{
    const batten_vec3 a = {0, 0, 1}, b = {2, 0, 1}, c = {0, 3, 2};
    return batten_surface_bilinear(a, b, c, c, out);
}

TEST(G5_a_three_sided_patch_has_the_normal_of_its_triangle)
{
    batten_surface *surface = NULL;
    CHECK_OK(three_sided(&surface));
    const batten_vec3 plane = {0, -1 / sqrt(10), 3 / sqrt(10)};
    for (int i = 0; i <= 4; i++) {
        check_normal(surface, i / 4.0, 1, plane, true, 1e-9);
        check_normal(surface, i / 4.0, 0.5, plane, false, 1e-14);
    }
    batten_surface_unref(surface);
}

/* x = u^a, y = v^b, z = 0 on [0, 1]^2, of degree 3: the tangents vanish on two edges. */
static batten_status flat(int a, int b, batten_surface **out)
{
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    static const double bezier[4][4] = {
        {0}, {0, 1. / 3, 2. / 3, 1}, {0, 0, 1. / 3, 1}, {0, 0, 0, 1}};
    const batten_axis axis = {3, 4, knots, false};
    double points[48];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            double *point = points + 3 * (4 * i + j);
            point[0] = bezier[a][i];
            point[1] = bezier[b][j];
            point[2] = 0;
        }
    return batten_surface_create(3, &axis, &axis, points, NULL, out);
}

TEST(G5_where_tangents_vanish_the_normal_of_a_plane_is_its_own)
{
    for (int a = 1; a <= 3; a++)
        for (int b = 1; b <= 3; b++) {
            batten_surface *surface = NULL;
            CHECK_OK(flat(a, b, &surface));
            check_normal(surface, 0, 0, (batten_vec3){0, 0, 1}, a + b > 2, 1e-9);
            check_normal(surface, 0, 0.5, (batten_vec3){0, 0, 1}, a > 1, 1e-9);
            check_normal(surface, 0.5, 0.5, (batten_vec3){0, 0, 1}, false, 1e-9);
            batten_surface_unref(surface);
        }
}

TEST(G5_a_fold_has_no_normal)
{
    /* x = (2 u - 1)^2: the surface turns back at u = 1/2. */
    static const double u[] = {0, 0, 0, 1, 1, 1}, v[] = {0, 0, 1, 1};
    const double points[] = {1, 0, 0, 1, 1, 0, -1, 0, 0, -1, 1, 0, 1, 0, 0, 1, 1, 0};
    const batten_axis axes[2] = {{2, 3, u, false}, {1, 2, v, false}};
    batten_surface *surface = NULL;
    batten_vec3 normal;
    CHECK_OK(batten_surface_create(3, &axes[0], &axes[1], points, NULL, &surface));
    CHECK_STATUS(batten_surface_normal(surface, 0.5, 0.25, NULL, &normal),
                 BATTEN_SINGULAR_HERE);
    check_normal(surface, 0.25, 0.25, (batten_vec3){0, 0, -1}, false, 1e-14);
    check_normal(surface, 0.75, 0.25, (batten_vec3){0, 0, 1}, false, 1e-14);
    batten_surface_unref(surface);
}

TEST(G5_a_surface_that_is_a_curve_or_a_point_has_no_normal)
{
    const batten_vec3 a = {1, 2, 3}, b = {2, 3, 5};
    batten_surface *surface = NULL;
    batten_vec3 normal;
    CHECK_OK(batten_surface_bilinear(a, b, a, b, &surface));
    CHECK_STATUS(batten_surface_normal(surface, 0.5, 0.5, NULL, &normal), BATTEN_SINGULAR_HERE);
    batten_surface_unref(surface);
    CHECK_OK(batten_surface_bilinear(a, a, a, a, &surface));
    CHECK_STATUS(batten_surface_normal(surface, 0.5, 0.5, NULL, &normal), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("recognisable");
    batten_surface_unref(surface);
    const batten_vec3 zero = {0, 0, 0};
    CHECK_OK(batten_surface_bilinear(zero, zero, zero, zero, &surface));
    CHECK_STATUS(batten_surface_normal(surface, 0, 0, NULL, &normal), BATTEN_SINGULAR_HERE);
    batten_surface_unref(surface);
}

TEST(N2_the_normal_does_not_depend_on_the_size)
{
    const double sizes[] = {1e-9, 1e9, 1e-150, 1e150};
    for (int i = 0; i < COUNT(sizes); i++) {
        const double s = sizes[i];
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){s, 0, s},
                                         (batten_vec3){0, s, 0}, (batten_vec3){s, s, s},
                                         &surface));
        check_normal(surface, 0.3, 0.3, (batten_vec3){-sqrt(0.5), 0, sqrt(0.5)}, false, 1e-14);
        batten_surface_unref(surface);
    }
}

TEST(the_normal_of_a_plane_surface_is_upright_and_a_function_has_none)
{
    static const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 0, 1, 1, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL;
    batten_vec3 normal;
    CHECK_OK(batten_surface_create(2, &axis, &axis, points, NULL, &surface));
    check_normal(surface, 0.5, 0.5, (batten_vec3){0, 0, 1}, false, 0);
    CHECK_STATUS(batten_surface_normal(surface, 0.5, 2, NULL, &normal), BATTEN_OUT_OF_DOMAIN);
    batten_surface_unref(surface);
    CHECK_OK(batten_surface_create(1, &axis, &axis, points, NULL, &surface));
    CHECK_STATUS(batten_surface_normal(surface, 0.5, 0.5, NULL, &normal), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_normal_grid(surface, (batten_uv_grid){0, 0, NULL, NULL}, NULL,
                                            NULL, NULL),
                 BATTEN_BAD_ARGUMENT);
    batten_surface_unref(surface);
}
