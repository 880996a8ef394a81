#include "inspect/shapes.h"
#include <batten/measure.h>
#include <batten/standard.h>

/* Each rises or falls: no step of 50 runs against another. */
static void check_runs(const batten_curve *curve, const batten_parameters *at, bool curvature,
                       batten_vec3 along)
{
    for (int i = 0; i + 1 < at->count; i++) {
        double before = 0, most = 0, least = 0, size = 0;
        for (int k = 0; k <= 50; k++) {
            const double u = at->at[i] + (at->at[i + 1] - at->at[i]) * (k / 50.0);
            batten_curve_local local;
            CHECK_OK(batten_curve_local_at(
                curve, u, k == 50 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &local));
            const double value =
                curvature ? local.curvature : along.x * local.point.x + along.y * local.point.y;
            if (k > 0) {
                most = fmax(most, value - before);
                least = fmin(least, value - before);
            }
            size = fmax(size, fabs(value));
            before = value;
        }
        CHECK(most <= 1e-11 * size || least >= -1e-11 * size);
    }
}

static batten_curve *wave(test_random *random, int degree)
{
    double points[24], knots[12 + 6];
    batten_curve *curve = NULL;
    for (int i = 0; i < 24; i++)
        points[i] = test_random_in(random, -1, 1);
    for (int i = 0; i < 12 + degree + 1; i++)
        knots[i] = fmin(12 - degree, fmax(0, i - degree));
    CHECK_OK(batten_curve_create((batten_points){2, 12, points}, degree, NULL, knots, &curve));
    return curve;
}

TEST(monotone_pieces_run_one_way)
{
    test_random random = test_random_begin("monotone");
    for (int n = test_cases(20); n > 0; n--) {
        batten_curve *curve = wave(&random, 3 + n % 3);
        batten_parameters at = {0, NULL};
        const batten_vec3 x = {1, 0, 0}, y = {0, 1, 0}, slanted = {0.3, -2, 0};
        CHECK_OK(batten_curve_divide_pieces(curve, BATTEN_PIECES_MONOTONE, NULL, &at));
        CHECK(at.count > 2 && at.at[0] == 0 &&
              at.at[at.count - 1] == batten_curve_domain(curve).b);
        check_runs(curve, &at, false, x);
        check_runs(curve, &at, false, y);
        batten_release(at.at);
        CHECK_OK(batten_curve_divide_pieces(curve, BATTEN_PIECES_MONOTONE, &slanted, &at));
        check_runs(curve, &at, false, slanted);
        batten_release(at.at);
        batten_curve_unref(curve);
    }
}

TEST(spiral_pieces_have_monotone_curvature)
{
    test_random random = test_random_begin("spirals");
    for (int n = test_cases(20); n > 0; n--) {
        batten_curve *curve = wave(&random, 4 + n % 2);
        batten_parameters at = {0, NULL};
        CHECK_OK(batten_curve_divide_pieces(curve, BATTEN_PIECES_SPIRAL, NULL, &at));
        check_runs(curve, &at, true, (batten_vec3){0, 0, 0});
        batten_release(at.at);
        batten_curve_unref(curve);
    }
}

TEST(an_ellipse_has_four_spirals_and_two_convex_halves)
{
    batten_curve *ellipse = NULL;
    batten_parameters at = {0, NULL};
    CHECK_OK(shape_ellipse(3, 2, 0, 0, &ellipse));
    CHECK_OK(batten_curve_divide_pieces(ellipse, BATTEN_PIECES_SPIRAL, NULL, &at));
    CHECK_INT(at.count, 5);
    for (int i = 0; i < 5; i++)
        CHECK_NEAR(at.at[i], i / 4.0, 1e-12);
    batten_release(at.at);
    CHECK_OK(batten_curve_divide_pieces(ellipse, BATTEN_PIECES_CONVEX, NULL, &at));
    CHECK_INT(at.count, 3);
    CHECK_NEAR(at.at[1], 0.5, 1e-12);
    batten_release(at.at);
    CHECK_OK(batten_curve_divide_pieces(ellipse, BATTEN_PIECES_MONOTONE, NULL, &at));
    CHECK_INT(at.count, 5);
    batten_release(at.at);
    CHECK_OK(batten_curve_divide_pieces(ellipse, BATTEN_PIECES_SPANS, NULL, &at));
    CHECK_INT(at.count, 5);
    batten_release(at.at);
    batten_curve_unref(ellipse);
}

TEST(convex_pieces_turn_by_half_a_turn_at_most)
{
    test_random random = test_random_begin("convex");
    for (int n = test_cases(20); n > 0; n--) {
        batten_curve *curve = wave(&random, 4);
        batten_parameters at = {0, NULL};
        CHECK_OK(batten_curve_divide_pieces(curve, BATTEN_PIECES_CONVEX, NULL, &at));
        for (int i = 0; i + 1 < at.count; i++) {
            batten_curve *part = NULL;
            double turns, convex = 0;
            CHECK_OK(batten_curve_subrange(curve, at.at[i], at.at[i + 1], &part));
            CHECK_OK(batten_curve_turning(part, 0, &turns));
            CHECK(fabs(turns) <= 0.5 + 1e-7);
            for (int k = 0; k <= 40; k++) { /* always to the same side of the chord */
                double p[2], a[2], b[2];
                CHECK_OK(batten_curve_evaluate(part, at.at[i], 0, a));
                CHECK_OK(batten_curve_evaluate(part, at.at[i + 1], 0, b));
                CHECK_OK(batten_curve_evaluate(
                    part, at.at[i] + (at.at[i + 1] - at.at[i]) * (k / 40.0), 0, p));
                const double side =
                    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
                CHECK(side * turns <= 1e-9);
                convex = fmax(convex, fabs(side));
            }
            CHECK(convex > 0);
            batten_curve_unref(part);
        }
        batten_release(at.at);
        batten_curve_unref(curve);
    }
}

TEST(corners_and_jumps_of_curvature_divide_spirals)
{
    /* Two arcs of radii 1 and 2 that meet with one tangent: curvature jumps. */
    const double w[5] = {1, sqrt(0.5), 1, sqrt(0.5), 1};
    const double arcs[10] = {1, 0, 1, 1, 0, 1, -2, 1, -2, -1}, breaks[3] = {0, 1, 2};
    const double corner[6] = {0, 0, 1, 1, 2, 0};
    batten_curve *curve = NULL, *space = NULL;
    batten_parameters at = {0, NULL};
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){2, 2, breaks}, arcs, w, &curve));
    CHECK_OK(batten_curve_divide_pieces(curve, BATTEN_PIECES_SPIRAL, NULL, &at));
    CHECK_INT(at.count, 3);
    CHECK(at.at[1] == 1);
    batten_release(at.at);
    CHECK_OK(batten_curve_to_dimension(curve, 3, &space));
    CHECK_OK(batten_curve_divide_pieces(space, BATTEN_PIECES_SPIRAL, NULL, &at));
    CHECK_INT(at.count, 3);
    batten_release(at.at);
    at = (batten_parameters){7, NULL};
    CHECK_STATUS(batten_curve_divide_pieces(space, BATTEN_PIECES_CONVEX, NULL, &at),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curve_divide_pieces(curve, BATTEN_PIECES_MONOTONE,
                                            &(batten_vec3){0, NAN, 0}, &at),
                 BATTEN_BAD_ARGUMENT);
    CHECK_INT(at.count, 7);
    batten_curve_unref(space);
    batten_curve_unref(curve);
    CHECK_OK(batten_curve_polyline((batten_points){2, 3, corner}, &curve));
    CHECK_OK(batten_curve_divide_pieces(curve, BATTEN_PIECES_SPIRAL, NULL, &at));
    CHECK_INT(at.count, 3);
    batten_release(at.at);
    CHECK_OK(batten_curve_divide_pieces(curve, BATTEN_PIECES_CONVEX, NULL, &at));
    CHECK_INT(at.count, 3);
    batten_release(at.at);
    batten_curve_unref(curve);
}

TEST(functions_and_curves_in_space_have_the_pieces_that_mean_something)
{
    const double values[] = {0, 1, 0, 2}, knots[] = {0, 0, 1, 2, 3, 3};
    const double corners[] = {0, 0, 0, 1, 1, 1, 2, 0, 0};
    batten_curve *function = NULL, *space = NULL;
    batten_parameters at = {0, NULL};
    CHECK_OK(batten_curve_create((batten_points){1, 4, values}, 1, NULL, knots, &function));
    CHECK_STATUS(batten_curve_divide_pieces(function, BATTEN_PIECES_SPIRAL, NULL, &at),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("make its graph");
    CHECK_STATUS(batten_curve_divide_pieces(function, BATTEN_PIECES_CONVEX, NULL, &at),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("make its graph");
    for (int k = 0; k < 2; k++) { /* it rises, falls and rises in three spans */
        CHECK_OK(batten_curve_divide_pieces(
            function, k ? BATTEN_PIECES_MONOTONE : BATTEN_PIECES_SPANS, NULL, &at));
        CHECK_INT(at.count, 4);
        for (int i = 0; i < at.count; i++)
            CHECK_NEAR(at.at[i], i, 1e-12);
        batten_release(at.at);
        at = (batten_parameters){0, NULL};
    }
    CHECK_OK(batten_curve_create((batten_points){3, 3, corners}, 1, NULL,
                                 (double[]){0, 0, 1, 2, 2}, &space));
    CHECK_STATUS(batten_curve_divide_pieces(space, BATTEN_PIECES_CONVEX, NULL, &at),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("this one has 3 dimensions");
    CHECK(at.at == NULL);
    batten_curve_unref(space);
    batten_curve_unref(function);
}
