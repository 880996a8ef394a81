#include "inspect/shapes.h"

#include <batten/nearest.h>
#include <batten/standard.h>

static void check_crossings(const batten_curve *curve, int axis, double value, int count,
                            const double *expected)
{
    batten_parameters found = {0};
    CHECK_OK(batten_curve_crossings(curve, axis, value, &found));
    CHECK_INT(found.count, count);
    for (int k = 0; k < count; k++)
        CHECK_NEAR(found.at[k], expected[k], 1e-7);
    batten_release(found.at);
}

TEST(a_circle_crosses_touches_and_misses_lines)
{
    batten_curve *circle = NULL;
    const double both[2] = {0.125, 0.375}, top[1] = {0.25}, ends[2] = {0, 1},
                 axis[3] = {0, 0.5, 1};
    CHECK_OK(shape_ellipse(2, 2, 1, 1, &circle));
    check_crossings(circle, 1, 1 + sqrt(2), 2, both);
    check_crossings(circle, 1, 3, 1, top);  /* touches from below */
    check_crossings(circle, 0, 3, 2, ends); /* touches where it begins and ends */
    check_crossings(circle, 1, 1, 3, axis); /* crosses there */
    check_crossings(circle, 1, 3.1, 0, NULL);
    batten_curve_unref(circle);
}

TEST(a_piece_on_the_value_gives_both_its_ends)
{
    const double points[10] = {0, 0, 1, 1, 2, 1, 3, 1, 4, 5}, knots[7] = {0, 0, 1, 2, 3, 4, 4};
    const double expected[3] = {1, 2, 3};
    batten_curve *polygon = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 5, points}, 1, NULL, knots, &polygon));
    check_crossings(polygon, 1, 1, 3, expected);
    batten_curve_unref(polygon);
}

TEST(every_crossing_of_a_random_curve_is_found)
{
    test_random random = test_random_begin("crossings");
    for (int n = test_cases(60); n > 0; n--) {
        const int degree = test_random_int(&random, 1, 9);
        double points[20], value = test_random_in(&random, -0.5, 0.5);
        batten_curve *curve = NULL;
        batten_parameters found = {0};
        for (int i = 0; i < 2 * (degree + 1); i++)
            points[i] = test_random_in(&random, -1, 1);
        CHECK_OK(shape_bezier(2, degree, points, &curve));
        CHECK_OK(batten_curve_crossings(curve, 1, value, &found));
        int changes = 0;
        double before = 0, at[2];
        for (int k = 0; k <= 2000; k++) {
            CHECK_OK(batten_curve_evaluate(curve, k / 2000.0, 0, at));
            changes += before * (at[1] - value) < 0;
            before = at[1] - value;
        }
        CHECK(found.count >= changes && (found.count - changes) % 2 == 0);
        for (int k = 0; k < found.count; k++) {
            CHECK_OK(batten_curve_evaluate(curve, found.at[k], 0, at));
            CHECK_NEAR(at[1], value, 1e-12);
        }
        batten_release(found.at);
        batten_curve_unref(curve);
    }
}

TEST(a_coordinate_that_is_not_there_is_refused)
{
    batten_curve *circle = NULL;
    batten_parameters found = {0};
    CHECK_OK(shape_ellipse(1, 1, 0, 0, &circle));
    CHECK_STATUS(batten_curve_crossings(circle, 2, 0, &found), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_crossings(circle, -1, 0, &found), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_crossings(circle, 0, NAN, &found), BATTEN_NOT_FINITE);
    batten_curve_unref(circle);
}

/* ---- planes ---- */

static const struct {
    double normal[3], offset;
    int dimension, count; /* of the crossings; -1: refused */
    double at[2];
} planes[] = {
    {{0, 2, 0}, 2, 2, 2, {0, 0.5}},
    {{0, 1, 5}, 1, 2, 2, {0, 0.5}},
    {{3, 4, 0}, 7, 2, 2, {-1, -1}},
    {{-1, 0, 0}, -1, 2, 2, {0.25, 0.75}},
    {{0, 1, 0}, 9, 2, 0, {0}},
    {{0, 0, 1}, 0, 2, -1, {0}},
    {{NAN, 1, 0}, 0, 2, -1, {0}},
    {{1, INFINITY, 0}, 0, 2, -1, {0}},
    {{1, 0, NAN}, 0, 2, -1, {0}},
    {{1, 0, INFINITY}, 0, 3, -1, {0}},
    {{1, 0, 0}, NAN, 2, -1, {0}},
    {{1, 0, 0}, -INFINITY, 3, -1, {0}},
    {{0, 0, 0}, 1, 3, -1, {0}},
    {{0, 0, 4}, 8, 3, 2, {0, 0.25}},
    {{0, 1, 4}, 9, 3, 2, {0, 0.5}},
    {{0, 1e200, 0}, 1e200, 3, 2, {0, 0.5}},
    {{1e200, 0, 1e200}, 3e200, 3, 2, {0.25, 0.75}},
};

/* The circle about (1, 1) of radius 2; in space at z = 2. */
static batten_curve *circle_of(int dimension)
{
    const batten_affine lift = batten_affine_translation(0, 0, 2);
    batten_curve *circle = NULL, *raised = NULL, *moved = NULL;
    CHECK_OK(shape_ellipse(2, 2, 1, 1, &circle));
    if (dimension == 2)
        return circle;
    CHECK_OK(batten_curve_to_dimension(circle, 3, &raised));
    CHECK_OK(batten_curve_transform(raised, &lift, &moved));
    batten_curve_unref(raised);
    batten_curve_unref(circle);
    return moved;
}

/* A level of the circle's own plane is met everywhere: at the ends of its spans. (3, 4) is through the centre. */
TEST(planes_are_crossed_by_their_normal_of_any_length_and_offset)
{
    for (int i = 0; i < COUNT(planes); i++) {
        const double *n = planes[i].normal;
        batten_curve *circle = circle_of(planes[i].dimension);
        batten_parameters found = {-7, NULL};
        CHECK_STATUS(batten_curve_plane_crossings(circle, (batten_vec3){n[0], n[1], n[2]},
                                                  planes[i].offset, &found),
                     planes[i].count < 0 ? BATTEN_BAD_ARGUMENT : BATTEN_OK);
        if (planes[i].count < 0) {
            char words[120];
            snprintf(words, sizeof words, "a plane with the normal (%g, %g, %g) at %g", n[0],
                     n[1], n[2], planes[i].offset);
            CHECK_TEXT(batten_message(), words);
            CHECK_INT(found.count, -7);
        }
        for (int k = 0; k < planes[i].count && planes[i].at[k] >= 0; k++)
            CHECK_NEAR(found.at[k], planes[i].at[k], 1e-12);
        for (int k = 0; k < found.count; k++) {
            double p[3] = {0};
            CHECK_OK(batten_curve_evaluate(circle, found.at[k], 0, p));
            const double size = hypot(n[0], n[1]);
            if (planes[i].dimension == 2)
                CHECK_NEAR((n[0] * p[0] + n[1] * p[1] - planes[i].offset) / size, 0, 1e-14);
        }
        batten_release(found.at);
        batten_curve_unref(circle);
    }
}

TEST(a_function_meets_no_plane)
{
    batten_curve *line = NULL;
    batten_parameters found = {0};
    CHECK_OK(batten_curve_line(1, (double[]){0}, (double[]){1}, &line));
    CHECK_STATUS(batten_curve_plane_crossings(line, (batten_vec3){1, 0, 0}, 0, &found),
                 BATTEN_UNSUPPORTED);
    CHECK_TEXT(batten_message(), "a function meets no plane; make its graph first");
    CHECK_STATUS(batten_curve_crossings(line, 1, 0, &found), BATTEN_BAD_ARGUMENT);
    CHECK_TEXT(batten_message(), "there is no coordinate 2 in 1 dimension");
    CHECK_STATUS(batten_curve_crossings(line, 0, -INFINITY, &found), BATTEN_NOT_FINITE);
    CHECK_TEXT(batten_message(), "the value to cross is -inf");
    batten_curve_unref(line);
}
