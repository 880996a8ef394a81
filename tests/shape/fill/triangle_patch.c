#include <batten/fill.h>

#include "numeric/vector.h"
#include "support/faults.h"
#include "support/test.h"
#include "support/triangle_frames.h"

enum { METHODS = 3 };
static const batten_triangle_method methods[METHODS] = {
    BATTEN_TRIANGLE_SIDE_VERTEX, BATTEN_TRIANGLE_PARALLELS, BATTEN_TRIANGLE_CORNERS};

/* The largest |z - f(x, y)| on a grid. */
static double graph_error(const batten_surface *surface, const polynomial *f)
{
    double worst = 0;
    for (int i = 0; i <= 12; i++)
        for (int j = 0; j <= 12; j++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(surface, i / 12.0, j / 12.0, 0, p));
            worst = fmax(worst, fabs(p[2] - value_of(f, p[0], p[1], 0, 0)));
        }
    return worst;
}

TEST(slopes_give_cubic_precision_and_positions_linear)
{
    test_random random = test_random_begin(__func__);
    for (int m = 0; m < METHODS; m++)
        for (int smooth = 0; smooth < 2; smooth++) {
            const polynomial f = random_polynomial(&random, smooth ? 3 : 1);
            frame data;
            batten_surface *surface = NULL;
            polynomial_frame(&f, smooth, &data);
            CHECK_EACH_ALLOCATION(
                batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-9, &surface));
            CHECK_NEAR(graph_error(surface, &f), 0, 1e-12);
            batten_surface_unref(surface);
            frame_free(&data);
        }
}

TEST(a_function_is_met_on_the_sides_with_its_slopes)
{
    test_random random = test_random_begin(__func__);
    for (int m = 0; m < METHODS; m++)
        for (int smooth = 0; smooth < 2; smooth++) {
            const polynomial f = random_polynomial(&random, 4);
            frame data;
            batten_surface *surface = NULL;
            polynomial_frame(&f, smooth, &data);
            CHECK_OK(batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-9, &surface));
            for (int e = 0; e < 3; e++)
                for (int k = 1; k < 16; k++) {
                    const double t = k / 16.0;
                    const double u = e == 0 ? 1 : t, v = e == 0 ? t : e == 1 ? 1 : 0;
                    double d[9];
                    CHECK_OK(batten_surface_evaluate(surface, u, v, 1, d));
                    const double fx = value_of(&f, d[0], d[1], 1, 0);
                    const double fy = value_of(&f, d[0], d[1], 0, 1);
                    CHECK_NEAR(d[2], value_of(&f, d[0], d[1], 0, 0), 1e-13);
                    if (!smooth)
                        continue;
                    CHECK_NEAR(d[5], fx * d[3] + fy * d[4], 1e-11);
                    CHECK_NEAR(d[8], fx * d[6] + fy * d[7], 1e-11);
                }
            batten_surface_unref(surface);
            frame_free(&data);
        }
}

TEST(curves_in_space_are_met_and_tangent_planes_are_those_of_the_ribbons)
{
    test_random random = test_random_begin(__func__);
    for (int m = 0; m < METHODS; m++) {
        frame data;
        batten_surface *surface = NULL;
        space_frame(&random, &data);
        CHECK_OK(batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-6, &surface));
        for (int e = 0; e < 3; e++)
            for (int k = 1; k < 16; k++) {
                const double t = k / 16.0; /* along the side */
                const double u = e == 0 ? 1 : e == 1 ? 1 - t : t, v = e == 0 ? t : e == 1;
                double p[3], C[6], T[3];
                batten_vec3 n = {0, 0, 0};
                CHECK_OK(batten_surface_evaluate(surface, u, v, 0, p));
                CHECK_OK(batten_curve_evaluate(data.curves[e], t, 1, C));
                CHECK_OK(batten_curve_evaluate(data.slopes[e], t, 0, T));
                for (int c = 0; c < 3; c++)
                    CHECK_NEAR(p[c], C[c], 1e-13);
                CHECK_OK(batten_surface_normal(surface, u, v, NULL, &n));
                CHECK_NEAR((n.x * T[0] + n.y * T[1] + n.z * T[2]) / bat_norm(3, T), 0, 1e-10);
            }
        batten_surface_unref(surface);
        frame_free(&data);
    }
}

TEST(derivatives_agree_with_differences)
{
    test_random random = test_random_begin(__func__);
    for (int m = 0; m < METHODS; m++)
        for (int smooth = 0; smooth < 2; smooth++) {
            frame data;
            batten_surface *surface = NULL;
            space_frame(&random, &data);
            for (int e = 0; e < 3 && !smooth; e++)
                data.ribbons[e].slope = NULL;
            CHECK_OK(batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-6, &surface));
            const double h = 1e-5, u = 0.6, v = 0.3;
            double d[18], a[9], b[9];
            CHECK_OK(batten_surface_evaluate(surface, u, v, 2, d));
            CHECK_OK(batten_surface_evaluate(surface, u + h, v, 1, a));
            CHECK_OK(batten_surface_evaluate(surface, u - h, v, 1, b));
            for (int c = 0; c < 3; c++) {
                CHECK_NEAR((a[c] - b[c]) / (2 * h), d[3 + c], 1e-7);
                CHECK_NEAR((a[3 + c] - b[3 + c]) / (2 * h), d[9 + c], 1e-6);
                CHECK_NEAR((a[6 + c] - b[6 + c]) / (2 * h), d[12 + c], 1e-6);
            }
            CHECK_OK(batten_surface_evaluate(surface, u, v + h, 1, a));
            CHECK_OK(batten_surface_evaluate(surface, u, v - h, 1, b));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR((a[6 + c] - b[6 + c]) / (2 * h), d[15 + c], 1e-6);
            batten_surface_unref(surface);
            frame_free(&data);
        }
}

/* The point of a surface over barycentric coordinates. */
static void at_place(const batten_surface *surface, const double b[3], double out[3])
{
    const double u = 1 - b[0];
    CHECK_OK(batten_surface_evaluate(surface, u, b[2] / u, 0, out));
}

TEST(G10_order_and_direction_of_the_curves_do_not_matter)
{
    test_random random = test_random_begin(__func__);
    for (int m = 0; m < METHODS; m++)
        for (int smooth = 0; smooth < 2; smooth++) {
            frame data;
            batten_surface *surface = NULL, *other = NULL;
            batten_curve *turned = NULL, *slope = NULL;
            const double b[3] = {0.2, 0.5, 0.3};
            double p[3], q[3];
            space_frame(&random, &data);
            for (int e = 0; e < 3 && !smooth; e++)
                data.ribbons[e].slope = NULL;
            CHECK_OK(batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-6, &surface));
            at_place(surface, b, p);
            /* The second curve first: its opposite corner is 0 now. */
            const batten_ribbon shifted[3] = {data.ribbons[1], data.ribbons[2],
                                              data.ribbons[0]};
            CHECK_OK(batten_triangle_patch(shifted, methods[m], 1e-9, 1e-6, &other));
            at_place(other, (const double[3]){b[1], b[2], b[0]}, q);
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(q[c], p[c], 1e-13);
            batten_surface_unref(other);
            /* The first curve turned, the others exchanged: corners 1 and 2 change places. */
            CHECK_OK(batten_curve_reverse(data.curves[0], &turned));
            CHECK_OK(batten_curve_reverse(data.slopes[0], &slope));
            const batten_ribbon mirrored[3] = {
                {turned, smooth ? slope : NULL, NULL}, data.ribbons[1], data.ribbons[2]};
            CHECK_OK(batten_triangle_patch(mirrored, methods[m], 1e-9, 1e-6, &other));
            at_place(other, (const double[3]){b[0], b[2], b[1]}, q);
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(q[c], p[c], 1e-13);
            batten_curve_unref(turned);
            batten_curve_unref(slope);
            batten_surface_unref(surface);
            batten_surface_unref(other);
            frame_free(&data);
        }
}

TEST(affine_images_of_the_data_give_the_affine_image)
{
    test_random random = test_random_begin(__func__);
    const batten_affine map = {{{1, 2, 0}, {0, -1, 0.3}, {0.5, 0, 1}}, {1, -2, 3}};
    batten_affine linear = map;
    memset(linear.t, 0, sizeof linear.t);
    for (int m = 0; m < METHODS; m++) {
        frame data, moved = {{NULL}, {NULL}, {{NULL, NULL, NULL}}};
        batten_surface *surface = NULL, *image = NULL, *other = NULL;
        space_frame(&random, &data);
        for (int e = 0; e < 3; e++) {
            CHECK_OK(batten_curve_transform(data.curves[e], &map, &moved.curves[e]));
            CHECK_OK(batten_curve_transform(data.slopes[e], &linear, &moved.slopes[e]));
            moved.ribbons[e] = (batten_ribbon){moved.curves[e], moved.slopes[e], NULL};
        }
        CHECK_OK(batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-6, &surface));
        CHECK_OK(batten_triangle_patch(moved.ribbons, methods[m], 1e-9, 1e-6, &other));
        CHECK_OK(batten_surface_transform(surface, &map, &image));
        for (int i = 0; i < 9; i++) {
            double p[3], q[3];
            CHECK_OK(batten_surface_evaluate(image, i % 3 / 2.0, i / 3 / 2.0, 0, p));
            CHECK_OK(batten_surface_evaluate(other, i % 3 / 2.0, i / 3 / 2.0, 0, q));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(q[c], p[c], 1e-12);
        }
        batten_surface_unref(surface);
        batten_surface_unref(image);
        batten_surface_unref(other);
        frame_free(&data);
        frame_free(&moved);
    }
}

TEST(G5_everything_is_finite_on_the_closed_triangle)
{
    test_random random = test_random_begin(__func__);
    static const double places[] = {0,    1e-300, 1e-160, 1e-20,    1e-15,     1e-12,
                                    1e-7, 0.5,    1,      1 - 1e-7, 1 - 1e-12, 1 - 1e-15};
    for (int m = 0; m < METHODS; m++)
        for (int smooth = 0; smooth < 2; smooth++) {
            frame data;
            batten_surface *surface = NULL;
            space_frame(&random, &data);
            for (int e = 0; e < 3 && !smooth; e++)
                data.ribbons[e].slope = NULL;
            CHECK_OK(batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-6, &surface));
            for (int i = 0; i < COUNT(places); i++)
                for (int j = 0; j < COUNT(places); j++) {
                    double d[30], near[3];
                    CHECK_OK(batten_surface_evaluate(surface, places[i], places[j], 3, d));
                    for (int k = 0; k < 30; k++)
                        CHECK(fabs(d[k]) < 1e13); /* third ones grow as the square of 1e6 */
                    /* Points do not jump. */
                    const double u = fmin(1 - 2e-9, fmax(2e-9, places[i]));
                    const double v = fmin(1 - 2e-9, fmax(2e-9, places[j]));
                    CHECK_OK(batten_surface_evaluate(surface, u, v, 0, near));
                    for (int c = 0; c < 3; c++)
                        CHECK_NEAR(near[c], d[c], 1e-7);
                }
            batten_vec3 n = {0, 0, 0};
            CHECK_OK(batten_surface_normal(surface, 1, 0, NULL, &n));
            batten_surface_unref(surface);
            frame_free(&data);
        }
}
