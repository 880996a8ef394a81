#include "inspect/shapes.h"
#include <batten/measure.h>
#include <batten/nearest.h>
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

/* ---- surfaces ---- */

static void check_bounds(const batten_surface *surface, const double low[3],
                         const double high[3])
{
    batten_box box;
    double slack = -1;
    CHECK_OK(batten_surface_bounds(surface, 1e-9, &slack, &box));
    CHECK(slack >= 0 && slack <= 1e-9);
    const double a[3] = {box.low.x, box.low.y, box.low.z};
    const double b[3] = {box.high.x, box.high.y, box.high.z};
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(a[k], low[k], 1.1e-9);
        CHECK_NEAR(b[k], high[k], 1.1e-9);
    }
}

/* A tilted torus: along each axis the large circle reaches R sin of the angle to its axis. */
TEST(the_box_of_a_tilted_torus_is_tight)
{
    const batten_vec3 z = {2.0 / 3, 1.0 / 3, 2.0 / 3}, x = {1.0 / 3, 2.0 / 3, -2.0 / 3};
    const batten_frame frame = {{5, -1, 2}, x, z};
    const double axis[3] = {z.x, z.y, z.z}, centre[3] = {5, -1, 2};
    double low[3], high[3];
    batten_surface *torus = NULL;
    CHECK_OK(batten_surface_torus(&frame, 3, 0.5, &torus));
    for (int k = 0; k < 3; k++) {
        const double reach = 3 * sqrt(1 - axis[k] * axis[k]) + 0.5;
        low[k] = centre[k] - reach;
        high[k] = centre[k] + reach;
    }
    check_bounds(torus, low, high);
    batten_surface_unref(torus);
}

/* z = 4 u (1 - u) v reaches 1 on a border; x and y are u and v. Its control points reach 2. */
TEST(the_box_of_a_hill_ends_at_its_top)
{
    const batten_axis u = {2, 3, (double[]){0, 0, 0, 1, 1, 1}, false};
    const batten_axis v = {1, 2, (double[]){0, 0, 1, 1}, false};
    const double points[6][3] = {{0, 0, 0},   {0, 1, 0}, {0.5, 0, 0},
                                 {0.5, 1, 2}, {1, 0, 0}, {1, 1, 0}};
    batten_surface *hill = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points[0], NULL, &hill));
    check_bounds(hill, (double[]){0, 0, 0}, (double[]){1, 1, 1});
    batten_surface_unref(hill);
}

/* What has many spans, is periodic, or no NURBS: nothing of a fine grid is outside, and each
 * side is near one of its points. */
static void check_by_grid(const batten_surface *surface)
{
    enum { N = 301 };
    double *at[2], *points = test_array((size_t)N * N * 3, sizeof *points);
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, slack = 0;
    double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    batten_box box;
    for (int k = 0; k < 2; k++) {
        const batten_interval d = batten_surface_domain(surface, (batten_direction)k);
        at[k] = test_array(N, sizeof *at[k]);
        for (int i = 0; i < N; i++)
            at[k][i] = i < N - 1 ? d.a + (d.b - d.a) * i / (N - 1) : d.b;
    }
    CHECK_OK(batten_surface_evaluate_grid(surface, (batten_uv_grid){N, N, at[0], at[1]}, 0,
                                          NULL, points));
    for (int i = 0; i < 3 * N * N; i++) {
        low[i % 3] = fmin(low[i % 3], points[i]);
        high[i % 3] = fmax(high[i % 3], points[i]);
    }
    CHECK_OK(batten_surface_bounds(surface, 1e-7, &slack, &box));
    CHECK(slack <= 1e-7);
    const double a[3] = {box.low.x, box.low.y, box.low.z};
    const double b[3] = {box.high.x, box.high.y, box.high.z};
    for (int k = 0; k < 3; k++) {
        CHECK(low[k] >= a[k] - 1e-12 && low[k] <= a[k] + 1e-3);
        CHECK(high[k] <= b[k] + 1e-12 && high[k] >= b[k] - 1e-3);
    }
}

TEST(the_box_of_a_wavy_surface_touches_it)
{
    enum { M = 9, N = 8 };
    double u[M + 4], v[N + 1], points[M * N * 3];
    for (int i = 0; i < M + 4; i++)
        u[i] = i < 4 ? 0 : i > M - 1 ? M - 3 : i - 3;
    for (int i = 0; i < N + 1; i++)
        v[i] = i;
    for (int i = 0; i < M; i++)
        for (int j = 0; j < N; j++) {
            double *p = points + 3 * (i * N + j);
            p[0] = i + 0.2 * sin(3.0 * j);
            p[1] = (3 + cos(2.0 * i)) * cos(2 * 3.14159265358979 * j / N);
            p[2] = (3 + sin(1.3 * i * j)) * sin(2 * 3.14159265358979 * j / N);
        }
    const batten_axis around = {3, N, v, true}, along = {3, M, u, false};
    batten_surface *wavy = NULL;
    CHECK_OK(batten_surface_create(3, &along, &around, points, NULL, &wavy));
    check_by_grid(wavy);
    batten_surface_unref(wavy);
}

TEST(a_box_of_a_surface_needs_a_tolerance)
{
    batten_surface *ball = NULL;
    batten_box box;
    CHECK_OK(batten_surface_sphere(&(batten_frame){{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, 1, &ball));
    CHECK_STATUS(batten_surface_bounds(ball, 0, NULL, &box), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance is 0");
    CHECK_STATUS(batten_surface_bounds(ball, NAN, NULL, &box), BATTEN_BAD_ARGUMENT);
    CHECK_OK(batten_surface_bounds(ball, 1e-300, NULL, &box)); /* as far as numbers tell */
    CHECK_NEAR(box.high.z, 1, 1e-15);
    batten_surface_unref(ball);
}

/* A polyline through the corners of a box that is turned anyhow: no smaller box holds them, and along the axes it is found. */
TEST(the_box_of_the_corners_of_a_box_is_no_smaller_and_no_larger_than_the_upright_one)
{
    static const double sides[][3] = {
        {1, 2, 3}, {3, 2, 1}, {2, 3, 1}, {5, 0.1, 4}, {0.2, 0.3, 7}};
    const double knots[] = {0, 0, 1, 2, 3, 4, 5, 6, 7, 7};
    test_random random = test_random_begin("boxes");
    for (int i = 0; i < test_cases(25); i++) {
        const double *half = sides[i % COUNT(sides)];
        const batten_affine turn = batten_affine_rotation(
            (batten_vec3){1, 2, 3},
            (batten_vec3){i % 3 == 0 ? 1 : test_random_in(&random, -1, 1),
                          i % 3 == 0 ? 0 : test_random_in(&random, -1, 1),
                          i % 3 == 0 ? 0 : test_random_in(&random, -1, 1)},
            i < 3 ? 0 : test_random_in(&random, -3, 3));
        double points[8][3], sorted[3] = {half[0], half[1], half[2]};
        for (int k = 0; k < 8; k++) {
            const batten_vec3 p =
                batten_affine_apply(turn, (batten_vec3){5 + (k & 1 ? half[0] : -half[0]),
                                                        6 + (k & 2 ? half[1] : -half[1]),
                                                        7 + (k & 4 ? half[2] : -half[2])});
            points[k][0] = p.x;
            points[k][1] = p.y;
            points[k][2] = p.z;
        }
        for (int a = 0; a < 2; a++)
            for (int b = 0; b < 2; b++)
                if (sorted[b] < sorted[b + 1]) {
                    const double other = sorted[b];
                    sorted[b] = sorted[b + 1];
                    sorted[b + 1] = other;
                }
        batten_curve *curve = NULL;
        batten_oriented_box box;
        CHECK_OK(batten_curve_create((batten_points){3, 8, points[0]}, 1, NULL, knots, &curve));
        CHECK_OK(batten_curve_oriented_box(curve, 1e-9, &box));
        check_box(curve, &box, 1e-9);
        CHECK(box.half[0] >= box.half[1] && box.half[1] >= box.half[2]);
        const double volume = box.half[0] * box.half[1] * box.half[2];
        const double least = half[0] * half[1] * half[2];
        const batten_box upright = batten_curve_box(curve);
        CHECK(volume >= (1 - 1e-9) * least);
        CHECK(8 * volume <= (1 + 1e-9) * (upright.high.x - upright.low.x) *
                                (upright.high.y - upright.low.y) *
                                (upright.high.z - upright.low.z));
        for (int k = 0; i < 3 && k < 3; k++)
            CHECK_NEAR(box.half[k], sorted[k], 1e-9);
        batten_curve_unref(curve);
    }
}

TEST(boxes_of_surfaces_of_unequal_degrees_touch_them)
{
    static const int degrees[][2] = {{1, 5}, {5, 1}, {2, 4}, {6, 3}, {3, 2}};
    test_random random = test_random_begin("unequal degrees");
    for (int i = 0; i < 2 * COUNT(degrees); i++) {
        const int *p = degrees[i / 2], count = (p[0] + 1) * (p[1] + 1);
        double points[28 * 3], weights[28], knots[2][14];
        for (int k = 0; k < 2; k++)
            for (int j = 0; j < 2 * p[k] + 2; j++)
                knots[k][j] = j > p[k];
        for (int j = 0; j < 3 * count; j++)
            points[j] = test_random_in(&random, -1, 1);
        for (int j = 0; j < count; j++)
            weights[j] = test_random_in(&random, 0.5, 2);
        const batten_axis u = {p[0], p[0] + 1, knots[0], false},
                          v = {p[1], p[1] + 1, knots[1], false};
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_create(3, &u, &v, points, i % 2 ? weights : NULL, &surface));
        check_by_grid(surface);
        batten_surface_unref(surface);
    }
}

/* The least area of a rectangle, in steps of a degree, around what is seen along an axis, times the height. */
static double least_upright(int count, const double *points, int axis)
{
    double least = HUGE_VAL, low[3] = {0}, high[3] = {0};
    for (int degree = 0; degree < 90; degree++) {
        const double c = cos(PI * degree / 180), s = sin(PI * degree / 180);
        for (int i = 0; i < count; i++) {
            const double *p = points + 3 * i;
            const double x = p[(axis + 1) % 3], y = p[(axis + 2) % 3],
                         seen[3] = {c * x + s * y, c * y - s * x, p[axis]};
            for (int k = 0; k < 3; k++) {
                low[k] = i == 0 ? seen[k] : fmin(low[k], seen[k]);
                high[k] = i == 0 ? seen[k] : fmax(high[k], seen[k]);
            }
        }
        least = fmin(least, (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]));
    }
    return least;
}

TEST(no_box_with_an_upright_axis_is_smaller_than_the_oriented_one)
{
    enum { CORNERS = 6 };
    test_random random = test_random_begin("oriented boxes of polygons");
    for (int n = test_cases(60); n > 0; n--) {
        double points[3 * CORNERS];
        batten_curve *curve = NULL;
        batten_oriented_box box;
        for (int i = 0; i < 3 * CORNERS; i++)
            points[i] = test_random_in(&random, -1, 1) * (i % 3 == n % 3 ? 0.2 : 1);
        CHECK_OK(batten_curve_polyline((batten_points){3, CORNERS, points}, &curve));
        CHECK_OK(batten_curve_oriented_box(curve, 1e-6, &box));
        const double volume = 8 * box.half[0] * box.half[1] * box.half[2];
        for (int axis = 0; axis < 3; axis++)
            CHECK(volume <= least_upright(CORNERS, points, axis) * (1 + 1e-6));
        batten_curve_unref(curve);
    }
}
