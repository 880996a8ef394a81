#include "inspect/shapes.h"

#include <batten/standard.h>

static double dot(batten_vec3 a, batten_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

TEST(a_torus_has_the_curvatures_of_its_equation)
{
    const double R = 3, r = 1;
    batten_surface *torus = NULL;
    CHECK_OK(shape_torus(R, r, false, &torus));
    for (int i = 0; i < 60; i++) {
        batten_surface_local at;
        CHECK_OK(
            batten_surface_local_at(torus, (i + 0.3) / 60, ((7 * i) % 60 + 0.5) / 60, &at));
        const double ring = hypot(at.point.x, at.point.y), c = (ring - R) / r;
        CHECK_NEAR(at.gaussian, c / (r * ring), 1e-11);
        CHECK_NEAR(fabs(at.mean), (R + 2 * r * c) / (2 * r * ring), 1e-11);
        CHECK(at.kappa1 >= at.kappa2);
        CHECK_NEAR(at.kappa1 * at.kappa2, at.gaussian, 1e-11);
        CHECK_NEAR(vec3_size(at.direction1), 1, 1e-12);
        CHECK_NEAR(dot(at.direction1, at.direction2), 0, 1e-12);
        CHECK_NEAR(dot(at.direction1, at.normal), 0, 1e-12);
        /* outwards, the curve around the tube bends away from the normal by 1 / r */
        const double sign =
            dot(at.normal, (batten_vec3){at.point.x, at.point.y, 0}) * c > 0 ? -1 : 1;
        CHECK_NEAR(sign < 0 ? at.kappa2 : at.kappa1, sign / r, 1e-10);
        /* and its direction has no part around the axis */
        const batten_vec3 tube = sign < 0 ? at.direction2 : at.direction1;
        CHECK_NEAR(-tube.x * at.point.y + tube.y * at.point.x, 0, 1e-9);
    }
    batten_surface_unref(torus);
}

/* z = c x y with x = 3 u, y = v / 2 + u: at the origin K = -c^2, elsewhere K = -c^2 / w^4 and
 * H = -c^3 x y / w^3, w^2 = 1 + c^2 (x^2 + y^2), whatever the parameters. */
TEST(a_saddle_has_its_curvatures_in_skew_and_stretched_parameters)
{
    const double c = 0.7, knots[] = {0, 0, 0, 2, 2, 2}, line[] = {0, 0, 4, 4};
    const batten_axis along = {2, 3, knots, false}, across = {1, 2, line, false};
    double points[6][3];
    batten_surface *saddle = NULL;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 2; j++) {
            /* Polar forms: u is 0, 1, 2 and u^2 is 0, 0, 4 at the control points. */
            const double u = i, uu = i == 2 ? 4 : 0, v = 4 * j;
            points[2 * i + j][0] = 3 * u;
            points[2 * i + j][1] = v / 2 + u;
            points[2 * i + j][2] = c * 3 * (u * v / 2 + uu);
        }
    CHECK_OK(batten_surface_create(3, &along, &across, points[0], NULL, &saddle));
    for (int i = 0; i <= 20; i++) {
        batten_surface_local at;
        CHECK_OK(batten_surface_local_at(saddle, 0.1 * i, 4 - 0.2 * i, &at));
        const double x = at.point.x, y = at.point.y, w = sqrt(1 + c * c * (x * x + y * y));
        CHECK_NEAR(at.point.z, c * x * y, 1e-13);
        CHECK_NEAR(at.gaussian, -c * c / pow(w, 4), 1e-14);
        CHECK_NEAR(at.mean, -c * c * c * x * y / pow(w, 3), 1e-13);
        CHECK_NEAR(at.kappa1 + at.kappa2, 2 * at.mean, 1e-13);
        CHECK_NEAR(at.kappa1 * at.kappa2, at.gaussian, 1e-13);
        CHECK_NEAR(dot(at.direction1, at.direction2), 0, 1e-12);
    }
    batten_surface_unref(saddle);
}

TEST(a_sphere_is_umbilic_and_a_cylinder_has_no_gaussian_curvature)
{
    batten_surface *sphere = NULL, *plane = NULL;
    batten_surface_local at;
    CHECK_OK(shape_torus(0, 2, true, &sphere));
    for (int i = 1; i < 10; i++) {
        CHECK_OK(batten_surface_local_at(sphere, i / 10.0, (i + 0.5) / 11, &at));
        CHECK_NEAR(at.gaussian, 0.25, 1e-11);
        CHECK_NEAR(fabs(at.mean), 0.5, 1e-11);
        CHECK_NEAR(at.kappa1, at.kappa2, 1e-7);
    }
    batten_surface_unref(sphere);
    /* z = x^2 as a cylinder: curvature 2 at its lowest line, 0 across */
    const double points[18] = {-1, 0, 1, -1, 1, 1, 0, 0, -1, 0, 1, -1, 1, 0, 1, 1, 1, 1};
    const double ku[6] = {0, 0, 0, 1, 1, 1}, kv[4] = {0, 0, 1, 1};
    const batten_axis u = {2, 3, ku, false}, v = {1, 2, kv, false};
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &plane));
    CHECK_OK(batten_surface_local_at(plane, 0.5, 0.3, &at));
    CHECK_NEAR(at.kappa1, 2, 1e-12);
    CHECK_NEAR(at.kappa2, 0, 1e-12);
    CHECK_NEAR(fabs(at.direction1.x), 1, 1e-12);
    batten_surface_unref(plane);
}

TEST(G5_a_pole_has_a_normal_but_no_curvature_from_its_tangents)
{
    batten_surface *sphere = NULL;
    batten_surface_local at;
    double gaussian[2], mean[2];
    const double u[1] = {0.3}, v[2] = {0, 0.5};
    CHECK_OK(shape_torus(0, 2, true, &sphere));
    CHECK_STATUS(batten_surface_local_at(sphere, 0.3, 0, &at), BATTEN_SINGULAR_HERE);
    CHECK_NEAR(fabs(at.normal.z), 1, 1e-12);
    CHECK_NEAR(at.point.z, -2, 1e-15);
    CHECK_OK(batten_surface_curvature_grid(sphere, (batten_uv_grid){1, 2, u, v}, NULL, gaussian,
                                           mean));
    CHECK(isnan(gaussian[0]) && isnan(mean[0]));
    CHECK_NEAR(gaussian[1], 0.25, 1e-12);
    CHECK_OK(
        batten_surface_curvature_grid(sphere, (batten_uv_grid){1, 2, u, v}, NULL, NULL, NULL));
    batten_surface_unref(sphere);
}

TEST(the_grid_has_the_curvatures_of_single_points)
{
    batten_surface *torus = NULL;
    double u[12], v[9], gaussian[108], mean[108];
    for (int i = 0; i < 12; i++)
        u[i] = (i + 0.5) / 12;
    for (int j = 0; j < 9; j++)
        v[j] = (j + 0.25) / 9;
    CHECK_OK(shape_torus(3, 1, false, &torus));
    CHECK_OK(batten_surface_curvature_grid(torus, (batten_uv_grid){12, 9, u, v}, NULL, gaussian,
                                           mean));
    for (int i = 0; i < 12; i++)
        for (int j = 0; j < 9; j++) {
            batten_surface_local at;
            CHECK_OK(batten_surface_local_at(torus, u[i], v[j], &at));
            CHECK_NEAR(gaussian[9 * i + j], at.gaussian, 1e-12);
            CHECK_NEAR(mean[9 * i + j], at.mean, 1e-12);
        }
    batten_surface_unref(torus);
}

TEST(a_surface_in_the_plane_has_no_curvature)
{
    const double points[8] = {0, 0, 0, 1, 1, 0, 1, 1}, knots[4] = {0, 0, 1, 1}, at[1] = {0.5};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *flat = NULL;
    batten_surface_local local;
    CHECK_OK(batten_surface_create(2, &axis, &axis, points, NULL, &flat));
    CHECK_STATUS(batten_surface_local_at(flat, 0.5, 0.5, &local), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(
        batten_surface_curvature_grid(flat, (batten_uv_grid){1, 1, at, at}, NULL, NULL, NULL),
        BATTEN_NOT_COMPATIBLE);
    batten_surface_unref(flat);
}

/* K = -c^2 / (c^2 + v^2)^2 and -1 / (c^2 cosh^4 v), H = 0. */
TEST(catenoid_and_helicoid_are_minimal_with_the_gaussian_curvature_of_their_equations)
{
    const double c = 1.25;
    batten_surface *helicoid = NULL, *catenoid = NULL;
    CHECK_OK(shape_minimal(c, -1, 2, &helicoid));
    CHECK_OK(shape_minimal(c, 0, 0, &catenoid));
    for (int i = 0; i <= 12; i++)
        for (int j = 0; j <= 12; j++) {
            const double u = i / 12.0, v = -1 + j / 4.0, h = c * c + v * v;
            batten_surface_local at;
            CHECK_OK(batten_surface_local_at(helicoid, u, v, &at));
            CHECK_NEAR(at.gaussian, -c * c / (h * h), 1e-10);
            CHECK_NEAR(at.mean, 0, 1e-10);
            CHECK_NEAR(at.kappa1, c / h, 1e-10);
            CHECK_NEAR(at.kappa2, -c / h, 1e-10);
            CHECK_OK(batten_surface_local_at(catenoid, u, j / 12.0, &at));
            const double k = 1 / (c * pow(cosh(j / 12.0), 2));
            CHECK_NEAR(at.gaussian, -k * k, 1e-10);
            CHECK_NEAR(at.mean, 0, 1e-10);
            CHECK_NEAR(at.kappa1, k, 1e-10);
            CHECK_NEAR(at.kappa2, -k, 1e-10);
            /* The principal directions: around the axis and along the meridian. */
            const batten_vec3 around = {-sin(u), cos(u), 0};
            const double turn = fabs(dot(at.direction1, around));
            CHECK(turn < 1e-9 || fabs(turn - 1) < 1e-9);
        }
    batten_surface_unref(helicoid);
    batten_surface_unref(catenoid);
}

/* With h = x^2/a^4 + y^2/b^4 + z^2/c^4: K = 1 / (abc h)^2 and
 * |H| = |x^2 + y^2 + z^2 - a^2 - b^2 - c^2| / (2 (abc)^2 h^(3/2)). */
TEST(an_ellipsoid_has_the_curvatures_of_its_equation)
{
    const batten_frame world = batten_frame_world();
    const double a = 3, b = 2, c = 1, abc = a * b * c;
    batten_surface *ellipsoid = NULL;
    CHECK_OK(batten_surface_ellipsoid(&world, a, b, c, &ellipsoid));
    const batten_interval u = batten_surface_domain(ellipsoid, BATTEN_U),
                          v = batten_surface_domain(ellipsoid, BATTEN_V);
    for (int i = 0; i < 17; i++)
        for (int j = 1; j < 16; j++) {
            batten_surface_local at;
            CHECK_OK(batten_surface_local_at(ellipsoid, u.a + (u.b - u.a) * i / 16,
                                             v.a + (v.b - v.a) * j / 16, &at));
            const batten_vec3 p = at.point;
            const double h =
                p.x * p.x / pow(a, 4) + p.y * p.y / pow(b, 4) + p.z * p.z / pow(c, 4);
            CHECK_NEAR(at.gaussian, 1 / (abc * abc * h * h), 1e-10);
            CHECK_NEAR(fabs(at.mean),
                       fabs(dot(p, p) - a * a - b * b - c * c) / (2 * abc * abc * pow(h, 1.5)),
                       1e-10);
        }
    batten_surface_unref(ellipsoid);
}
