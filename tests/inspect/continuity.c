#include "inspect/shapes.h"
#include <batten/continuity.h>
#include <batten/standard.h>

/* (t, t^2 / 2 + c t^3) for t in [a, b] as a cubic. */
static void graph(double a, double b, double square, double cube, batten_curve **out)
{
    /* in powers of t - a */
    const double powers[4][2] = {{a, square * a * a + cube * a * a * a},
                                 {1, 2 * square * a + 3 * cube * a * a},
                                 {0, square + 3 * cube * a},
                                 {0, cube}};
    const double breaks[2] = {a, b};
    CHECK_OK(
        batten_curve_from_power(2, (batten_pieces){3, 1, breaks}, &powers[0][0], 1e-12, out));
}

static batten_continuity join(const batten_curve *a, const batten_curve *b)
{
    batten_continuity c = {0};
    CHECK_OK(batten_curves_continuity(a, BATTEN_CURVE_END, b, BATTEN_CURVE_START, NULL, &c));
    return c;
}

TEST(a_cubic_cut_in_two_joins_with_all_derivatives)
{
    batten_curve *whole = NULL, *a = NULL, *b = NULL;
    graph(-1, 2, 0.5, 0.25, &whole);
    CHECK_OK(batten_curve_split(whole, 0.5, &a, &b));
    const batten_continuity c = join(a, b);
    CHECK_INT(c.parametric, 3);
    CHECK_INT(c.geometric, 3);
    CHECK_NEAR(c.beta[0], 1, 1e-13);
    CHECK_NEAR(c.beta[1], 0, 1e-12);
    CHECK_NEAR(c.beta[2], 0, 1e-11);
    /* y'' / (1 + y'^2)^1.5 at 0.5 */
    CHECK_NEAR(c.curvature[0], 1.75 / pow(1 + 0.6875 * 0.6875, 1.5), 1e-12);
    batten_curve_unref(b);
    batten_curve_unref(a);
    batten_curve_unref(whole);
}

TEST(a_reparametrised_piece_joins_with_its_betas)
{
    /* The seed: A t^2 + B t + C on [0, 1], and its continuation with t = 1 + 2 s + 3 s^2 + s^3
     * / 2: b1, b2, b3 are the derivatives 2, 6, 3 of t. */
    const double powers[3][2] = {{0, 0}, {1, 2}, {1, -1}}, breaks[2] = {0, 1};
    double more[7][2] = {{0}};
    const double t[4] = {1, 2, 3, 0.5};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++) {
            more[i][k] += powers[1][k] * t[i];
            for (int j = 0; j < 4; j++)
                more[i + j][k] += powers[2][k] * t[i] * t[j];
        }
    batten_curve *a = NULL, *b = NULL;
    CHECK_OK(
        batten_curve_from_power(2, (batten_pieces){2, 1, breaks}, &powers[0][0], 1e-12, &a));
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){6, 1, breaks}, &more[0][0], 1e-12, &b));
    const batten_continuity c = join(a, b);
    CHECK_INT(c.parametric, 0);
    CHECK_INT(c.geometric, 3);
    const double expected[3] = {2, 6, 3};
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(c.beta[k], expected[k], 1e-11);
        CHECK_NEAR(c.residual[k], 0, 1e-10);
    }
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(a_join_misses_what_one_of_its_sides_lacks)
{
    /* y = x^2 / 2 from the left; to the right other graphs. */
    static const struct {
        double shift, square, cube;
        int order;
    } cases[] = {{0, 0.5, 0, 3}, {0, 0.5, 1, 2}, {0, -0.5, 0, 1}, {1e-3, 0.5, 0, -1}};
    batten_curve *a = NULL;
    graph(-1, 0, 0.5, 0, &a);
    for (int i = 0; i < COUNT(cases); i++) {
        batten_curve *b = NULL, *moved = NULL;
        graph(0, 1, cases[i].square, cases[i].cube, &b);
        const batten_affine map = batten_affine_translation(0, cases[i].shift, 0);
        CHECK_OK(batten_curve_transform(b, &map, &moved));
        const batten_continuity c = join(a, moved);
        CHECK_INT(c.parametric, cases[i].order);
        CHECK_INT(c.geometric, cases[i].order);
        CHECK_NEAR(c.gap, cases[i].shift, 1e-15);
        CHECK_NEAR(c.curvature[1], 2 * cases[i].square, 1e-14);
        CHECK_NEAR(c.rate[1], 6 * cases[i].cube, 1e-13);
        batten_curve_unref(moved);
        batten_curve_unref(b);
    }
    batten_curve_unref(a);
}

TEST(G4_at_a_triple_vertex_a_cubic_is_C2_and_not_G1)
{
    /* Uniform cubic with the vertex (3, 0) three times: the curve is straight on both sides of
     * it, and its tangent turns there by the angle of the legs. */
    const double points[14] = {0, 0, 1, 2, 3, 0, 3, 0, 3, 0, 5, 1, 6, 4};
    const double knots[11] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    batten_curve *curve = NULL;
    batten_continuities all = {0, NULL};
    CHECK_OK(batten_curve_create((batten_points){2, 7, points}, 3, NULL, knots, &curve));
    CHECK_OK(batten_curve_continuity(curve, NULL, &all));
    CHECK_INT(all.count, 3);
    const batten_continuity *c = &all.at[1];
    CHECK_NEAR(c->u, 5, 0);
    CHECK(c->singular[0] && c->singular[1]);
    CHECK_INT(c->parametric, 2);
    CHECK_INT(c->geometric, 0);
    CHECK_NEAR(c->angle, atan2(2, 2) + atan2(1, 2), 1e-12);
    CHECK_INT(all.at[0].parametric, 2);
    CHECK_INT(all.at[0].geometric, 2);
    batten_release(all.at);
    batten_curve_unref(curve);
}

TEST(a_tangent_that_turns_back_is_a_cusp)
{
    const double there[4] = {0, 0, 1, 0}, back[4] = {1, 0, 0, 0};
    batten_curve *a = NULL, *b = NULL;
    CHECK_OK(batten_curve_line(2, there, there + 2, &a));
    CHECK_OK(batten_curve_line(2, back, back + 2, &b));
    const batten_continuity c = join(a, b);
    CHECK(c.reversed);
    CHECK_INT(c.geometric, 0);
    CHECK_NEAR(c.beta[0], -1, 1e-15);
    CHECK_NEAR(c.angle, PI, 1e-15);
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(a_circle_is_G3_at_its_knots_and_at_its_seam)
{
    batten_curve *circle = NULL;
    batten_continuities all = {0, NULL};
    CHECK_OK(shape_ellipse(3, 3, 100, 7, &circle));
    CHECK_OK(batten_curve_continuity(circle, NULL, &all));
    CHECK_INT(all.count, 4);
    for (int k = 0; k < all.count; k++) {
        CHECK_INT(all.at[k].geometric, 3);
        CHECK_INT(all.at[k].parametric, 1);
        CHECK_NEAR(all.at[k].curvature[0], 1.0 / 3, 1e-12);
    }
    batten_release(all.at);
    batten_curve_unref(circle);
}

TEST(a_join_looks_the_same_from_the_other_side)
{
    test_random random = test_random_begin("joins reversed");
    for (int n = test_cases(50); n > 0; n--) {
        double points[24];
        for (int i = 0; i < 24; i++)
            points[i] = test_random_in(&random, -1, 1);
        memcpy(points + 12, points + 9, 3 * sizeof *points);
        batten_curve *a = NULL, *b = NULL;
        CHECK_OK(shape_bezier(3, 3, points, &a));
        CHECK_OK(shape_bezier(3, 3, points + 12, &b));
        const batten_continuity c = join(a, b);
        batten_continuity d = {0};
        CHECK_OK(
            batten_curves_continuity(b, BATTEN_CURVE_START, a, BATTEN_CURVE_END, NULL, &d));
        CHECK_NEAR(d.angle, c.angle, 1e-14);
        CHECK_NEAR(d.curvature_difference, c.curvature_difference,
                   1e-13 * (1 + c.curvature_difference));
        CHECK_NEAR(d.rate_difference, c.rate_difference, 1e-12 * (1 + c.rate_difference));
        CHECK_NEAR(d.curvature[0], c.curvature[1], 1e-14 * (1 + fabs(c.curvature[1])));
        batten_curve_unref(b);
        batten_curve_unref(a);
    }
}

TEST(N6_tolerances_of_continuity_must_be_numbers)
{
    batten_curve *circle = NULL;
    batten_curve_continuity_options options = batten_curve_continuity_defaults();
    batten_continuities all = {7, NULL};
    CHECK_OK(shape_ellipse(1, 1, 0, 0, &circle));
    options.angle = NAN;
    CHECK_STATUS(batten_curve_continuity(circle, &options, &all), BATTEN_BAD_ARGUMENT);
    options.angle = -1;
    CHECK_STATUS(batten_curve_continuity(circle, &options, &all), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a tolerance of continuity is -1");
    options.angle = 0.01;
    options.derivative = -3;
    CHECK_STATUS(batten_curve_continuity(circle, &options, &all), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a tolerance of continuity is -3");
    CHECK_INT(all.count, 7);
    batten_curve_unref(circle);
}

/* y = x^2 / 2 up to 0 and y = x^2 / 4 from there: curvatures 1 and 1/2, of which the part that differs is 1/2. */
TEST(a_part_as_large_as_the_tolerance_is_within_it)
{
    const double left[6] = {-1, 0.5, -0.5, 0, 0, 0}, right[6] = {0, 0, 0.5, 0, 1, 0.25};
    static const double tolerances[] = {0.5, 0.4999999, 0};
    batten_curve *a = NULL, *b = NULL;
    CHECK_OK(shape_bezier(2, 2, left, &a));
    CHECK_OK(shape_bezier(2, 2, right, &b));
    for (int i = 0; i < COUNT(tolerances); i++) {
        batten_curve_continuity_options options = batten_curve_continuity_defaults();
        batten_continuity c = {0};
        options.curvature = tolerances[i];
        CHECK_OK(
            batten_curves_continuity(a, BATTEN_CURVE_END, b, BATTEN_CURVE_START, &options, &c));
        CHECK_BITS(c.curvature_part, 0.5);
        CHECK_BITS(c.curvature_difference, 0.5);
        CHECK_INT(c.geometric >= 2, i == 0);
        CHECK(c.geometric >= 1);
    }
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(curves_of_different_dimensions_have_no_continuity)
{
    const double plane[4] = {0, 0, 1, 0}, space[6] = {1, 0, 0, 2, 0, 0};
    batten_curve *a = NULL, *b = NULL;
    batten_continuity c = {.geometric = 7};
    CHECK_OK(batten_curve_line(2, plane, plane + 2, &a));
    CHECK_OK(batten_curve_line(3, space, space + 3, &b));
    CHECK_STATUS(batten_curves_continuity(a, BATTEN_CURVE_END, b, BATTEN_CURVE_START, NULL, &c),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_TEXT(batten_message(), "the curves have 2 and 3 dimensions");
    CHECK_INT(c.geometric, 7);
    batten_curve_unref(b);
    batten_curve_unref(a);
}
