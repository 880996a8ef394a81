#include <batten/fill.h>

#include "numeric/vector.h"
#include "support/test.h"
#include "support/triangle_frames.h"

enum { METHODS = 3 };
static const batten_triangle_method methods[METHODS] = {
    BATTEN_TRIANGLE_SIDE_VERTEX, BATTEN_TRIANGLE_PARALLELS, BATTEN_TRIANGLE_CORNERS};

TEST(a_ribbon_of_one_side_alone_is_enough)
{
    test_random random = test_random_begin(__func__);
    for (int m = 0; m < METHODS; m++) {
        frame data;
        batten_surface *surface = NULL;
        space_frame(&random, &data);
        data.ribbons[0].slope = data.ribbons[2].slope = NULL;
        CHECK_OK(batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-6, &surface));
        for (int k = 1; k < 8; k++) {
            double T[3];
            batten_vec3 n = {0, 0, 0};
            CHECK_OK(batten_curve_evaluate(data.slopes[1], k / 8.0, 0, T));
            CHECK_OK(batten_surface_normal(surface, 1 - k / 8.0, 1, NULL, &n));
            CHECK_NEAR(n.x * T[0] + n.y * T[1] + n.z * T[2], 0, 1e-10);
        }
        batten_surface_unref(surface);
        frame_free(&data);
    }
}

TEST(a_nurbs_surface_near_it_keeps_to_its_tolerance)
{
    test_random random = test_random_begin(__func__);
    for (int m = 0; m < METHODS; m++) {
        frame data;
        batten_surface *surface = NULL, *nurbs = NULL;
        double error = 0;
        space_frame(&random, &data);
        CHECK_OK(batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-6, &surface));
        CHECK_OK(batten_surface_to_nurbs(surface, 1e-3, &error, &nurbs));
        CHECK(error > 0 && error <= 1e-3);
        for (int i = 0; i <= 20; i++)
            for (int j = 0; j <= 20; j++) {
                double p[3], q[3];
                CHECK_OK(batten_surface_evaluate(surface, i / 20.0, j / 20.0, 0, p));
                CHECK_OK(batten_surface_evaluate(nurbs, i / 20.0, j / 20.0, 0, q));
                CHECK(bat_distance(3, p, q) <= 1.5e-3);
            }
        batten_surface_unref(surface);
        batten_surface_unref(nurbs);
        frame_free(&data);
    }
}

TEST(G9_data_that_bound_no_triangle_are_refused_by_name)
{
    test_random random = test_random_begin(__func__);
    frame data;
    batten_surface *none = NULL;
    batten_curve *moved = NULL, *steep = NULL, *back = NULL;
    const batten_affine away = batten_affine_translation(0.01, 0, 0);
    const batten_affine lift = {{{1, 0, 0}, {0, 1, 0}, {0.9, 0.9, 1}}, {0, 0, 0}};
    const batten_affine turn = batten_affine_scaling(-1, -1, -1);
    space_frame(&random, &data);
    CHECK_OK(batten_curve_transform(data.curves[2], &away, &moved));
    CHECK_OK(batten_curve_transform(data.slopes[1], &lift, &steep));
    CHECK_OK(batten_curve_transform(data.slopes[1], &turn, &back));
    batten_ribbon ribbons[3];
    memcpy(ribbons, data.ribbons, sizeof ribbons);
    ribbons[2].curve = moved;
    CHECK_STATUS(batten_triangle_patch(ribbons, 0, 1e-6, 1e-6, &none), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("is open by 0.01");
    memcpy(ribbons, data.ribbons, sizeof ribbons);
    ribbons[1].slope = steep;
    CHECK_STATUS(batten_triangle_patch(ribbons, 0, 1e-6, 1e-3, &none), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("leaves the tangent plane of the ribbon of curve 2");
    ribbons[1].slope = back;
    CHECK_STATUS(batten_triangle_patch(ribbons, 0, 1e-6, 1e-3, &none), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("fold back");
    ribbons[1].slope = NULL;
    CHECK_STATUS(batten_triangle_patch(ribbons, 0, NAN, 1e-3, &none), BATTEN_BAD_ARGUMENT);
    CHECK(!none);
    batten_curve_unref(moved);
    batten_curve_unref(steep);
    batten_curve_unref(back);
    frame_free(&data);
}

TEST(G1_a_curve_without_length_or_twice_the_same_is_refused)
{
    static const double knots[4] = {0, 0, 1, 1};
    static const double point[6] = {1, 1, 0, 1, 1, 0}, line[6] = {0, 0, 0, 1, 1, 0};
    static const double kink[9] = {0, 0, 0, 1, 0, 0, 1, 1, 0};
    static const double kink_knots[5] = {0, 0, 0.5, 1, 1};
    static const double side[6] = {0, 0, 0, 0, 1, 0}, other[6] = {0, 1, 0, 1, 1, 0};
    batten_curve *curves[5] = {NULL};
    batten_surface *none = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, point}, 1, NULL, knots, &curves[0]));
    CHECK_OK(batten_curve_create((batten_points){3, 2, line}, 1, NULL, knots, &curves[1]));
    CHECK_OK(batten_curve_create((batten_points){3, 3, kink}, 1, NULL, kink_knots, &curves[2]));
    CHECK_OK(batten_curve_create((batten_points){3, 2, side}, 1, NULL, knots, &curves[3]));
    CHECK_OK(batten_curve_create((batten_points){3, 2, other}, 1, NULL, knots, &curves[4]));
    const batten_ribbon dot[3] = {
        {curves[1], NULL, NULL}, {curves[0], NULL, NULL}, {curves[1], NULL, NULL}};
    CHECK_STATUS(batten_triangle_patch(dot, 0, 1e-6, 1e-6, &none), BATTEN_COINCIDENT);
    const batten_ribbon kinked[3] = {
        {curves[3], NULL, NULL}, {curves[2], NULL, NULL}, {curves[4], NULL, NULL}};
    CHECK_STATUS(batten_triangle_patch(kinked, 0, 1e-6, 1e-6, &none), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("curve 2 has a kink");
    CHECK(!none);
    for (int i = 0; i < 5; i++)
        batten_curve_unref(curves[i]);
}

TEST(N2_huge_and_tiny_curves_make_the_same_triangle)
{
    test_random random = test_random_begin(__func__);
    for (int m = 0; m < METHODS; m++)
        for (int tiny = 0; tiny < 2; tiny++) {
            const double scale = tiny ? 0x1p-260 : 0x1p260;
            const batten_affine map = batten_affine_scaling(scale, scale, scale);
            frame data, moved = {{NULL}, {NULL}, {{NULL, NULL, NULL}}};
            batten_surface *surface = NULL, *other = NULL;
            double p[3], q[3];
            space_frame(&random, &data);
            for (int e = 0; e < 3; e++) {
                CHECK_OK(batten_curve_transform(data.curves[e], &map, &moved.curves[e]));
                CHECK_OK(batten_curve_transform(data.slopes[e], &map, &moved.slopes[e]));
                moved.ribbons[e] = (batten_ribbon){moved.curves[e], moved.slopes[e], NULL};
            }
            CHECK_OK(batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-6, &surface));
            CHECK_OK(
                batten_triangle_patch(moved.ribbons, methods[m], 1e-9 * scale, 1e-6, &other));
            CHECK_OK(batten_surface_evaluate(surface, 0.7, 0.4, 0, p));
            CHECK_OK(batten_surface_evaluate(other, 0.7, 0.4, 0, q));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(q[c] / scale, p[c], 1e-13);
            batten_surface_unref(surface);
            batten_surface_unref(other);
            frame_free(&data);
            frame_free(&moved);
        }
}
