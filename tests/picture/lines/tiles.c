#include "picture/lines/tiles.h"

#include "picture/scenes.h"

static double norm(const double *p)
{
    return sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
}

TEST(tiles_lie_as_close_to_a_sphere_as_asked)
{
    batten_surface *sphere = scene_sphere(5);
    for (double tolerance = 0.1; tolerance > 1e-4; tolerance /= 10) {
        bat_tiles t;
        CHECK_OK(bat_tiles_make(sphere, tolerance, 4, 10000000, BAT_CURVATURE_NONE, NULL, &t));
        for (size_t i = 0; i + 1 < t.count_u; i++)
            for (size_t j = 0; j + 1 < t.count_v; j++) {
                const double *p = t.points + 3 * (i * t.count_v + j);
                const double *q = p + 3 * (t.count_v + 1);
                double middle[3];
                for (int k = 0; k < 3; k++)
                    middle[k] = 0.5 * (p[k] + q[k]);
                /* Both directions add their share to the middle of a cell. */
                CHECK_NEAR(norm(middle), 5, 2.2 * tolerance);
            }
        bat_tiles_free(&t);
    }
    batten_surface_unref(sphere);
}

TEST(tiles_of_a_twisted_patch_of_straight_lines_are_as_close_as_asked)
{
    const double points[] = {0, 0, 0, 0, 8, 6, 8, 0, 6, 8, 8, 0};
    batten_surface *patch = scene_net(1, 2, 1, 2, points);
    bat_tiles t;
    CHECK_OK(bat_tiles_make(patch, 0.01, 4, 100000, BAT_CURVATURE_NONE, NULL, &t));
    for (size_t i = 0; i + 1 < t.count_u; i++)
        for (size_t j = 0; j + 1 < t.count_v; j++) {
            const double *p = t.points + 3 * (i * t.count_v + j);
            const double *q = p + 3 * (t.count_v + 1);
            double s[3];
            CHECK_OK(batten_surface_evaluate(patch, (t.u[i] + t.u[i + 1]) / 2,
                                             (t.v[j] + t.v[j + 1]) / 2, 0, s));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR((p[k] + q[k]) / 2, s[k], 0.01);
        }
    bat_tiles_free(&t);
    batten_surface_unref(patch);
}

TEST(S5_the_number_of_tiles_stays_below_its_limit)
{
    batten_surface *sphere = scene_sphere(5);
    bat_tiles t;
    CHECK_OK(bat_tiles_make(sphere, 1e-9, 4, 2000, BAT_CURVATURE_NONE, NULL, &t));
    CHECK(t.count_u * t.count_v <= 2000);
    CHECK(t.u[0] == batten_surface_domain(sphere, BATTEN_U).a);
    CHECK(t.u[t.count_u - 1] == batten_surface_domain(sphere, BATTEN_U).b);
    bat_tiles_free(&t);
    batten_surface_unref(sphere);
}

TEST(each_span_has_its_least_number_of_tiles)
{
    const double points[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 2, 1, 0};
    batten_surface *flat = scene_net(1, 3, 1, 2, points);
    bat_tiles t;
    CHECK_OK(bat_tiles_make(flat, 0.1, 4, 100000, BAT_CURVATURE_NONE, NULL, &t));
    CHECK_INT(t.count_u, 2 * (4 + 1));
    CHECK_INT(t.count_v, 4 + 1);
    bat_tiles_free(&t);
    batten_surface_unref(flat);
}

TEST(both_sides_of_a_knuckle_keep_their_normals)
{
    /* A roof: the ridge is a knot line. */
    const double points[] = {-1, 0, 0, -1, 1, 0, 0, 0, 1, 0, 1, 1, 1, 0, 0, 1, 1, 0};
    batten_surface *roof = scene_net(1, 3, 1, 2, points);
    bat_tiles t;
    CHECK_OK(bat_tiles_make(roof, 0.1, 4, 100000, BAT_CURVATURE_NONE, NULL, &t));
    for (size_t i = 0; i < t.count_u; i++) {
        const double x = t.points[3 * i * t.count_v], *n = t.normals + 3 * i * t.count_v;
        CHECK_NEAR(fabs(n[0]), sqrt(0.5), 1e-12);
        /* The first five columns are the left side, although the last of them is on the
         * ridge. */
        CHECK((i < 5) == (n[0] * n[2] < 0));
        CHECK((i < 5) == (x < 0));
    }
    bat_tiles_free(&t);
    batten_surface_unref(roof);
}

TEST(curvature_comes_with_the_tiles_when_asked)
{
    batten_surface *torus = scene_torus(3, 1);
    bat_tiles t;
    CHECK_OK(bat_tiles_make(torus, 0.01, 4, 100000, BAT_CURVATURE_GAUSSIAN, NULL, &t));
    for (size_t i = 0; i < t.count_u * t.count_v; i++) {
        const double *p = t.points + 3 * i, from_axis = hypot(p[0], p[1]);
        /* K = cos(a) / (r (R + r cos(a))), and R + r cos(a) is the distance from the axis. */
        CHECK_NEAR(t.curvature[i], (from_axis - 3) / from_axis, 1e-6);
    }
    bat_tiles_free(&t);
    batten_surface_unref(torus);
}
