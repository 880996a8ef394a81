#include <batten/invariants.h>
#include <batten/measure.h>
#include <batten/standard.h>

#include "inspect/shapes.h"
#include "support/test.h"

TEST(spec_6_an_ellipse_has_constant_affine_curvature)
{
    batten_curve *ellipse = NULL;
    double length;
    CHECK_OK(batten_curve_ellipse(2, 3, 0, 2, &ellipse));
    for (int i = 0; i <= 20; i++) {
        double k = 0;
        CHECK_OK(batten_curve_affine_curvature(ellipse, i / 20.0, BATTEN_FROM_RIGHT, &k));
        CHECK_NEAR(k, pow(6, -2 / 3.0), 1e-11);
        CHECK_NEAR(k, 0.3028534, 1e-7);
    }
    /* s = (a b)^(1/3) times the angle of the circle */
    CHECK_OK(batten_curve_affine_length(ellipse, 1e-11, NULL, &length));
    CHECK_NEAR(length, 2 * cbrt(6), 1e-10);
    batten_curve_unref(ellipse);
}

TEST(parabolas_have_none_and_hyperbolas_less_affine_curvature)
{
    const double points[6] = {0, 0, 3, 4, 5, -2};
    batten_curve *parabola = NULL, *hyperbola = NULL;
    double k = 1;
    CHECK_OK(shape_bezier(2, 2, points, &parabola));
    CHECK_OK(batten_curve_conic(2, points, points + 2, points + 4, 2, &hyperbola));
    for (int i = 0; i <= 10; i++) {
        CHECK_OK(batten_curve_affine_curvature(parabola, i / 10.0, BATTEN_FROM_RIGHT, &k));
        CHECK_NEAR(k, 0, 1e-15);
        CHECK_OK(batten_curve_affine_curvature(hyperbola, i / 10.0, BATTEN_FROM_RIGHT, &k));
        CHECK(k < -0.01);
    }
    batten_curve_unref(parabola);
    batten_curve_unref(hyperbola);
}

TEST(affine_length_goes_through_inflections)
{
    /* (t, t^3) over [-1, 1]: the integral of |6 t|^(1/3), 2 6^(1/3) 3 / 4 */
    const double points[8] = {-1, -1, -1 / 3.0, 1, 1 / 3.0, -1, 1, 1};
    batten_curve *curve = NULL;
    double length, error;
    CHECK_OK(shape_bezier(2, 3, points, &curve));
    CHECK_OK(batten_curve_affine_length(curve, 1e-12, &error, &length));
    CHECK_NEAR(length, 1.5 * cbrt(6), 1e-11);
    CHECK(error < 1e-11);
    batten_curve_unref(curve);
}

TEST(affine_length_in_space_is_that_of_the_twisted_cubic)
{
    /* (t, t^2 / 2, t^3 / 6) has det 1; z three times as high makes 3^(1/6) times as long */
    const double points[12] = {0, 0, 0, 1 / 3.0, 0, 0, 2 / 3.0, 1 / 6.0, 0, 1, 0.5, 0.5};
    batten_curve *curve = NULL;
    double length;
    CHECK_OK(shape_bezier(3, 3, points, &curve));
    CHECK_OK(batten_curve_affine_length(curve, 1e-12, NULL, &length));
    CHECK_NEAR(length, pow(3, 1 / 6.0), 1e-11);
    batten_curve_unref(curve);
}

TEST(a_plane_of_space_has_the_affine_length_of_the_plane)
{
    const double points[10] = {0, 0, 1, 3, 2, -2, 4, 1, 5, 3};
    batten_curve *flat = NULL, *space = NULL, *turned = NULL;
    double a, b, u[6], v[6];
    CHECK_OK(shape_bezier(2, 4, points, &flat));
    CHECK_OK(batten_curve_to_dimension(flat, 3, &space));
    const batten_affine turn =
        batten_affine_rotation((batten_vec3){1, 2, 3}, (batten_vec3){1, -1, 0.5}, 1.2);
    CHECK_OK(batten_curve_transform(space, &turn, &turned));
    CHECK_OK(batten_curve_affine_length(flat, 1e-11, NULL, &a));
    CHECK_OK(batten_curve_affine_length(turned, 1e-11, NULL, &b));
    CHECK_NEAR(a, b, 1e-10);
    CHECK_OK(batten_curve_divide_affine(flat, 5, 1e-10, u));
    CHECK_OK(batten_curve_divide_affine(turned, 5, 1e-10, v));
    for (int i = 0; i <= 5; i++)
        CHECK_NEAR(u[i], v[i], 1e-8);
    batten_curve_unref(flat);
    batten_curve_unref(space);
    batten_curve_unref(turned);
}

TEST(images_are_divided_at_images)
{
    const double points[14] = {0, 0, 1, 3, 2, -2, 4, 1, 5, 3, 7, -2, 8, 0};
    const double knots[11] = {0, 0, 0, 0, 1, 2, 4, 5, 5, 5, 5};
    const batten_affine map = {{{2, -1, 0}, {0.5, 1, 0}, {0, 0, 1}}, {3, 4, 0}};
    batten_curve *curve = NULL, *image = NULL;
    double u[14], v[14], length, scaled;
    CHECK_OK(batten_curve_create((batten_points){2, 7, points}, 3, NULL, knots, &curve));
    CHECK_OK(batten_curve_transform(curve, &map, &image));
    CHECK_OK(batten_curve_divide_affine(curve, 13, 1e-10, u));
    CHECK_OK(batten_curve_divide_affine(image, 13, 1e-10, v));
    for (int i = 0; i <= 13; i++)
        CHECK_NEAR(u[i], v[i], 1e-8);
    CHECK(u[0] == 0 && u[13] == 5 && u[1] > 0 && u[12] < 5);
    CHECK_OK(batten_curve_affine_length(curve, 1e-10, NULL, &length));
    CHECK_OK(batten_curve_affine_length(image, 1e-10, NULL, &scaled));
    CHECK_NEAR(scaled / length, cbrt(2.5), 1e-9);
    batten_curve_unref(curve);
    batten_curve_unref(image);
}

TEST(parts_of_a_division_have_equal_affine_length)
{
    const double points[10] = {0, 0, 1, 3, 2, -2, 4, 1, 5, 3};
    batten_curve *curve = NULL;
    double u[8], whole;
    CHECK_OK(shape_bezier(2, 4, points, &curve));
    CHECK_OK(batten_curve_divide_affine(curve, 7, 1e-11, u));
    CHECK_OK(batten_curve_affine_length(curve, 1e-11, NULL, &whole));
    for (int i = 0; i < 7; i++) {
        batten_curve *part = NULL;
        double length;
        CHECK_OK(batten_curve_subrange(curve, u[i], u[i + 1], &part));
        CHECK_OK(batten_curve_affine_length(part, 1e-11, NULL, &length));
        CHECK_NEAR(length * 7, whole, 1e-8);
        batten_curve_unref(part);
    }
    batten_curve_unref(curve);
}

TEST(straight_lines_have_no_affine_length)
{
    batten_curve *line = NULL, *function = NULL;
    double length = 1, u[3];
    CHECK_OK(shape_bezier(2, 3, (const double[]){0, 0.1, 1, 1.3, 4, 4.9, 2, 2.5}, &line));
    CHECK_OK(batten_curve_affine_length(line, 1e-4, NULL, &length));
    CHECK_NEAR(length, 0, 1e-4);
    CHECK_STATUS(batten_curve_divide_affine(line, 2, 1e-9, u), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("straight");
    CHECK_STATUS(batten_curve_affine_curvature(line, 0.3, BATTEN_FROM_RIGHT, &length),
                 BATTEN_SINGULAR_HERE);
    CHECK_OK(shape_bezier(1, 1, (const double[]){0, 1}, &function));
    CHECK_STATUS(batten_curve_affine_length(function, 1e-6, NULL, &length),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_affine_length(line, 0, NULL, &length), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_affine_length(line, NAN, NULL, &length), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_divide_affine(line, 0, 1e-9, u), BATTEN_BAD_ARGUMENT);
    for (int i = 0; i < 4; i++) {
        static const double outside[] = {NAN, 0, 1, 1.5};
        CHECK_STATUS(batten_curve_divide_affine(line, 2, outside[i], u), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("is not in (0, 1)");
    }
    batten_curve_unref(line);
    batten_curve_unref(function);
}
