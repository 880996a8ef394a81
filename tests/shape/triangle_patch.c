#include <batten/triangle_patch.h>

#include "numeric/vector.h"
#include "support/test.h"

enum { METHODS = 3 };
static const batten_triangle_method methods[METHODS] = {
    BATTEN_TRIANGLE_SIDE_VERTEX, BATTEN_TRIANGLE_PARALLELS, BATTEN_TRIANGLE_CORNERS};

/* ---- functions over a triangle of the plane, as graphs ---- */

/* A polynomial of total degree `degree` with coefficients c[a][b] of x^a y^b. */
typedef struct {
    int degree;
    double c[5][5];
} polynomial;

static const double corners[3][2] = {{0.2, 0.1}, {2.1, 0.4}, {0.9, 1.7}};

static double value_of(const polynomial *f, double x, double y, int dx, int dy)
{
    double sum = 0;
    for (int a = dx; a <= f->degree; a++)
        for (int b = dy; a + b <= f->degree; b++) {
            double term = f->c[a][b];
            for (int k = 0; k < dx; k++)
                term *= a - k;
            for (int k = 0; k < dy; k++)
                term *= b - k;
            sum += term * pow(x, a - dx) * pow(y, b - dy);
        }
    return sum;
}

static polynomial random_polynomial(test_random *random, int degree)
{
    polynomial f = {.degree = degree};
    for (int a = 0; a <= degree; a++)
        for (int b = 0; a + b <= degree; b++)
            f.c[a][b] = test_random_in(random, -1, 1);
    return f;
}

/* A curve of degree 4 through what `at` says at five even parameters: of polynomials of degree
 * 4 it is the polynomial. */
typedef void sample(const void *data, int e, double t, double out[3]);
static batten_status curve_of(sample *at, const void *data, int e, batten_curve **out)
{
    /* Bezier points of degree 4 from values at 0, 1/4 ... 1. */
    static const double inverse[5][5] = {{1, 0, 0, 0, 0},
                                         {-13 / 12.0, 4, -3, 4 / 3.0, -1 / 4.0},
                                         {13 / 18.0, -32 / 9.0, 20 / 3.0, -32 / 9.0, 13 / 18.0},
                                         {-1 / 4.0, 4 / 3.0, -3, 4, -13 / 12.0},
                                         {0, 0, 0, 0, 1}};
    static const double knots[10] = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
    double points[15] = {0};
    for (int k = 0; k < 5; k++) {
        double value[3];
        at(data, e, k / 4.0, value);
        for (int i = 0; i < 5; i++)
            for (int c = 0; c < 3; c++)
                points[3 * i + c] += inverse[i][k] * value[c];
    }
    return batten_curve_create(3, 4, 5, points, NULL, knots, out);
}

static void side_point(int e, double t, double out[2])
{
    for (int c = 0; c < 2; c++)
        out[c] = (1 - t) * corners[(e + 1) % 3][c] + t * corners[(e + 2) % 3][c];
}

static void graph_point(const void *data, int e, double t, double out[3])
{
    side_point(e, t, out);
    out[2] = value_of(data, out[0], out[1], 0, 0);
}

/* The derivative towards the opposite corner, as the ribbon of a side wants it. */
static void graph_slope(const void *data, int e, double t, double out[3])
{
    double p[2];
    side_point(e, t, p);
    for (int c = 0; c < 2; c++)
        out[c] = corners[e][c] - p[c];
    out[2] =
        value_of(data, p[0], p[1], 1, 0) * out[0] + value_of(data, p[0], p[1], 0, 1) * out[1];
}

typedef struct {
    batten_curve *curves[3], *slopes[3];
    batten_ribbon ribbons[3];
} frame;

static void frame_make(sample *point, sample *slope, const void *data, frame *out)
{
    *out = (frame){{NULL}, {NULL}, {{NULL, NULL, NULL}}};
    for (int e = 0; e < 3; e++) {
        CHECK_OK(curve_of(point, data, e, &out->curves[e]));
        if (slope)
            CHECK_OK(curve_of(slope, data, e, &out->slopes[e]));
        out->ribbons[e] = (batten_ribbon){out->curves[e], out->slopes[e], NULL};
    }
}

static void frame_free(frame *f)
{
    for (int e = 0; e < 3; e++) {
        batten_curve_unref(f->curves[e]);
        batten_curve_unref(f->slopes[e]);
    }
}

static void polynomial_frame(const polynomial *f, bool smooth, frame *out)
{
    frame_make(graph_point, smooth ? graph_slope : NULL, f, out);
}

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
            CHECK_OK(batten_triangle_patch(data.ribbons, methods[m], 1e-9, 1e-9, &surface));
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

/* ---- curves and ribbons in space that belong to no function ---- */

static void space_point(const void *data, int e, double t, double out[3])
{
    const double *bend = (const double *)data + 3 * e;
    side_point(e, t, out);
    out[2] = 0.3 * out[0] - 0.2 * out[1] * out[1];
    for (int c = 0; c < 3; c++)
        out[c] += t * (1 - t) * bend[c];
}

/* Cross the tangent, leaning with t; at the ends in the plane of both curves. */
static batten_status space_slope(const frame *data, int e, batten_curve **out)
{
    double ends[2][3], a[6], b[6], C[6], points[9];
    static const double knots[6] = {0, 0, 0, 1, 1, 1};
    CHECK_OK(batten_curve_evaluate(data->curves[(e + 2) % 3], 1, 1, a));
    CHECK_OK(batten_curve_evaluate(data->curves[(e + 1) % 3], 0, 1, b));
    for (int end = 0; end < 2; end++) {
        CHECK_OK(batten_curve_evaluate(data->curves[e], end, 1, C));
        for (int c = 0; c < 3; c++)
            ends[end][c] = 0.7 * (end ? b[3 + c] : -a[3 + c]) + 0.4 * C[3 + c];
    }
    for (int c = 0; c < 3; c++) {
        points[c] = ends[0][c];
        points[3 + c] = (ends[0][c] + ends[1][c]) / 2 + (c == 2 ? 0.5 : 0.1);
        points[6 + c] = ends[1][c];
    }
    return batten_curve_create(3, 2, 3, points, NULL, knots, out);
}

static void space_frame(test_random *random, frame *out)
{
    double bend[3][3];
    for (int e = 0; e < 3; e++)
        for (int c = 0; c < 3; c++)
            bend[e][c] = test_random_in(random, -0.4, 0.4);
    frame_make(space_point, NULL, bend, out);
    for (int e = 0; e < 3; e++) {
        CHECK_OK(space_slope(out, e, &out->slopes[e]));
        out->ribbons[e].slope = out->slopes[e];
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
                CHECK_OK(batten_surface_normal(surface, u, v, &n, NULL));
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
            CHECK_OK(batten_surface_normal(surface, 1, 0, &n, NULL));
            batten_surface_unref(surface);
            frame_free(&data);
        }
}

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
            CHECK_OK(batten_surface_normal(surface, 1 - k / 8.0, 1, &n, NULL));
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
        CHECK_OK(batten_surface_to_nurbs(surface, 1e-3, &nurbs, &error));
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
    CHECK_OK(batten_curve_create(3, 1, 2, point, NULL, knots, &curves[0]));
    CHECK_OK(batten_curve_create(3, 1, 2, line, NULL, knots, &curves[1]));
    CHECK_OK(batten_curve_create(3, 1, 3, kink, NULL, kink_knots, &curves[2]));
    CHECK_OK(batten_curve_create(3, 1, 2, side, NULL, knots, &curves[3]));
    CHECK_OK(batten_curve_create(3, 1, 2, other, NULL, knots, &curves[4]));
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
