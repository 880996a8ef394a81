#include "inspect/shapes.h"
#include <batten/measure.h>
#include <batten/standard.h>

TEST(a_box_is_as_tight_as_the_curve)
{
    /* x = 3 t (1 - t)^2 + 3 t^2 (1 - t) + t^3 .. with both extremes of y inside: y' = 0 at
     * (3 +- sqrt(3)) / 6. */
    const double points[8] = {0, 0, 1, 2, 2, -2, 3, 0};
    batten_curve *curve = NULL;
    batten_box box;
    CHECK_OK(shape_bezier(2, 3, points, &curve));
    CHECK_OK(batten_curve_bounds(curve, &box));
    CHECK_NEAR(box.low.x, 0, 0);
    CHECK_NEAR(box.high.x, 3, 0);
    CHECK_NEAR(box.high.y, 1 / sqrt(3), 1e-15); /* 6 t (1 - t) (1 - 2 t) */
    CHECK_NEAR(box.low.y, -1 / sqrt(3), 1e-15);
    CHECK(box.low.z == 0 && box.high.z == 0);
    batten_curve_unref(curve);
    CHECK_OK(shape_ellipse(3, 2, 10, -4, &curve));
    CHECK_OK(batten_curve_bounds(curve, &box));
    CHECK_NEAR(box.low.x, 7, 1e-14);
    CHECK_NEAR(box.high.x, 13, 1e-14);
    CHECK_NEAR(box.low.y, -6, 1e-14);
    CHECK_NEAR(box.high.y, -2, 1e-14);
    batten_curve_unref(curve);
}

/* Is every point of the curve inside, and does each side touch it? */
static void check_box(const batten_curve *curve, const batten_oriented_box *box, double slack)
{
    const int d = batten_curve_dimension(curve);
    const batten_interval domain = batten_curve_domain(curve);
    const double centre[3] = {box->centre.x, box->centre.y, box->centre.z};
    double most[3] = {0};
    for (int i = 0; i <= 2000; i++) {
        double p[3] = {0};
        CHECK_OK(batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * (i / 2000.0),
                                       0, p));
        for (int k = 0; k < d; k++) {
            const double axis[3] = {box->axes[k].x, box->axes[k].y, box->axes[k].z};
            double along = 0;
            for (int j = 0; j < d; j++)
                along += axis[j] * (p[j] - centre[j]);
            CHECK(fabs(along) <= box->half[k] + slack);
            most[k] = fmax(most[k], fabs(along));
        }
    }
    for (int k = 0; k < d; k++)
        CHECK(most[k] >= box->half[k] * (1 - 1e-3));
    for (int k = 0; k + 1 < d; k++)
        CHECK(box->half[k] >= box->half[k + 1]);
}

TEST(the_oriented_box_of_a_turned_ellipse_has_its_axes)
{
    for (int i = 0; i < 8; i++) {
        const double angle = 0.1 + i * 0.37;
        const batten_affine turn =
            batten_affine_rotation((batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1}, angle);
        batten_curve *flat = NULL, *turned = NULL;
        batten_oriented_box box;
        CHECK_OK(shape_ellipse(3, 1, 5, 7, &flat));
        CHECK_OK(batten_curve_transform(flat, &turn, &turned));
        CHECK_OK(batten_curve_oriented_box(turned, 1e-6, &box));
        check_box(turned, &box, 1e-13);
        CHECK(4 * box.half[0] * box.half[1] <= 12 + 2e-6 * 8 + 1e-11);
        CHECK_NEAR(fabs(box.axes[0].x * cos(angle) + box.axes[0].y * sin(angle)), 1, 1e-4);
        CHECK_NEAR(box.centre.x, 5 * cos(angle) - 7 * sin(angle), 1e-3);
        batten_curve_unref(turned);
        batten_curve_unref(flat);
    }
}

TEST(no_other_angle_gives_a_smaller_rectangle)
{
    test_random random = test_random_begin("rectangles");
    for (int n = test_cases(20); n > 0; n--) {
        double points[16];
        batten_curve *curve = NULL;
        batten_oriented_box box;
        const double tolerance = 1e-4;
        for (int i = 0; i < 16; i++)
            points[i] = test_random_in(&random, -1, 1);
        CHECK_OK(shape_bezier(2, 7, points, &curve));
        CHECK_OK(batten_curve_oriented_box(curve, tolerance, &box));
        check_box(curve, &box, 1e-13);
        const double area = 4 * box.half[0] * box.half[1];
        const double slack = 4 * tolerance * (box.half[0] + box.half[1]) + 1e-7;
        for (int k = 0; k < 200; k++) {
            const batten_affine turn = batten_affine_rotation(
                (batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1}, PI * k / 400);
            batten_curve *turned = NULL;
            batten_box around;
            CHECK_OK(batten_curve_transform(curve, &turn, &turned));
            CHECK_OK(batten_curve_bounds(turned, &around));
            CHECK((around.high.x - around.low.x) * (around.high.y - around.low.y) >=
                  area - slack);
            batten_curve_unref(turned);
        }
        batten_curve_unref(curve);
    }
}

TEST(a_curve_in_space_has_a_small_box)
{
    /* A plane ellipse somewhere in space: the box is flat and has its axes. */
    batten_curve *flat = NULL, *raised = NULL, *turned = NULL;
    batten_oriented_box box;
    const batten_affine turn =
        batten_affine_rotation((batten_vec3){1, 2, 3}, (batten_vec3){1, -1, 0.3}, 0.9);
    CHECK_OK(shape_ellipse(3, 1, 5, 7, &flat));
    CHECK_OK(batten_curve_to_dimension(flat, 3, &raised));
    CHECK_OK(batten_curve_transform(raised, &turn, &turned));
    CHECK_OK(batten_curve_oriented_box(turned, 1e-6, &box));
    check_box(turned, &box, 1e-12);
    CHECK_NEAR(box.half[0], 3, 1e-5);
    CHECK_NEAR(box.half[1], 1, 1e-5);
    CHECK_NEAR(box.half[2], 0, 1e-12);
    batten_curve_unref(turned);
    batten_curve_unref(raised);
    batten_curve_unref(flat);
    /* A straight line, of which rounding alone is wide. */
    const double a[3] = {1, 2, 3}, b[3] = {4, 6, 15};
    CHECK_OK(batten_curve_line(3, a, b, &flat));
    CHECK_OK(batten_curve_oriented_box(flat, 1e-3, &box));
    CHECK_NEAR(box.half[0], 6.5, 1e-13);
    CHECK_NEAR(box.half[1], 0, 1e-13);
    CHECK_NEAR(fabs(box.axes[0].z), 12 / 13.0, 1e-13);
    batten_curve_unref(flat);
}

TEST(N6_boxes_of_points_and_of_tolerances_that_mean_nothing)
{
    const double zeros[6] = {1, 1, 1, 1, 1, 1}, line[2] = {0, 1};
    batten_curve *point = NULL, *function = NULL;
    batten_oriented_box box;
    CHECK_OK(shape_bezier(2, 2, zeros, &point));
    CHECK_OK(shape_bezier(1, 1, line, &function));
    CHECK_OK(batten_curve_oriented_box(point, 1e-3, &box));
    CHECK(box.half[0] == 0 && box.half[1] == 0 && box.centre.x == 1);
    CHECK_STATUS(batten_curve_oriented_box(point, 0, &box), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_oriented_box(point, NAN, &box), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_oriented_box(function, 1, &box), BATTEN_UNSUPPORTED);
    batten_parameters turns = {0, NULL};
    CHECK_STATUS(batten_curve_turns(point, (batten_vec3){0, 0, 0}, &turns),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_turns(point, (batten_vec3){NAN, 0, 0}, &turns),
                 BATTEN_BAD_ARGUMENT);
    batten_curve_unref(function);
    batten_curve_unref(point);
}
