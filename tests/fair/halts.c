#include "fair/fairness.h"

#include "support/test.h"

#include <batten/interpolate.h>

/* ---- corners where the curve stands still ---- */

TEST(a_polygon_of_cubics_that_halt_at_its_corners_is_no_fair_curve)
{
    static const double corners[5][2] = {{0, 0}, {1, 2}, {3, 3}, {5, 0}, {6, 1}};
    double points[13][2], knots[17];
    for (int i = 0; i < 13; i++)
        for (int k = 0; k < 2; k++) /* control points twice at each corner */
            points[i][k] = corners[(i + 1) / 3][k];
    for (int i = 0; i < 17; i++)
        knots[i] = i < 4 ? 0 : i > 12 ? 4 : (i - 1) / 3;
    batten_curve *curve = NULL;
    batten_fairness found;
    CHECK_OK(
        batten_curve_create((batten_points){2, 13, &points[0][0]}, 3, NULL, knots, &curve));
    CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 5, &corners[0][0]}, NULL, &found));
    CHECK_INT(found.corners, 3);
    CHECK_INT(found.halts, 3);
    CHECK_INT(found.cusps, 0);
    CHECK(isinf(found.energy) && isinf(found.variation));
    CHECK(!found.fair);
    /* The sharpest of them: from (2, -3) to (1, 1). */
    CHECK_NEAR(found.largest_turn, atan2(3, 2) + BAT_PI / 4, 1e-12);
    batten_curve_unref(curve);
}

TEST(a_cusp_inside_a_span_is_found)
{
    /* (t^2, t^3) over [-1, 1] */
    static const double knots[] = {-1, -1, -1, -1, 1, 1, 1, 1};
    static const double points[] = {1, -1, -1.0 / 3, 1, -1.0 / 3, -1, 1, 1};
    batten_curve *curve = NULL;
    batten_fairness found;
    CHECK_OK(batten_curve_create((batten_points){2, 4, points}, 3, NULL, knots, &curve));
    CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, NULL, &found));
    CHECK_INT(found.cusps, 1);
    CHECK_INT(found.corners, 1);
    CHECK_NEAR(found.largest_turn, BAT_PI, 1e-6);
    CHECK(isinf(found.energy));
    CHECK(isinf(found.max_curvature));
    CHECK_INT(found.unbounded, 0);
    CHECK(!found.fair);
    batten_curve_unref(curve);
}

/* (t^2, t^4): there and back on one parabola, whose curvature is 2 where it turns. */
TEST(curvature_has_a_bound_where_a_curve_goes_back_the_way_it_came)
{
    static const double knots[] = {-1, -1, -1, -1, -1, 1, 1, 1, 1, 1};
    static const double points[] = {1, 1, 0, -1, -1.0 / 3, 1, 0, -1, 1, 1};
    batten_curve *curve = NULL;
    batten_fairness found;
    CHECK_OK(batten_curve_create((batten_points){2, 5, points}, 4, NULL, knots, &curve));
    CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, NULL, &found));
    CHECK_INT(found.cusps, 1);
    CHECK(found.max_curvature <= 2);
    batten_curve_unref(curve);
}

TEST(cusps_are_found_wherever_they_stand)
{
    /* (s^2, s^3) with s = u - a over [0, 1], turned and moved, where a is no simple number */
    test_random random = test_random_begin("cusps");
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    for (int n = test_cases(200); n > 0; n--) {
        const double a = test_random_in(&random, 0.05, 0.95);
        const double turn = test_random_in(&random, 0, 6), c = cos(turn), s = sin(turn);
        double points[8];
        for (int i = 0; i < 4; i++) { /* blossoms of s^2 and s^3 */
            const double u = -a, v = 1 - a;
            const double f[3] = {i > 0 ? v : u, i > 1 ? v : u, i > 2 ? v : u};
            const double x = (f[0] * f[1] + f[1] * f[2] + f[2] * f[0]) / 3;
            const double y = f[0] * f[1] * f[2];
            points[2 * i] = 3 + c * x - s * y;
            points[2 * i + 1] = 5 + s * x + c * y;
        }
        batten_curve *curve = NULL;
        batten_fairness found;
        CHECK_OK(batten_curve_create((batten_points){2, 4, points}, 3, NULL, knots, &curve));
        CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, NULL, &found));
        CHECK_INT(found.cusps, 1);
        CHECK_INT(found.corners, 1);
        CHECK(!found.fair);
        batten_curve_unref(curve);
    }
}

TEST(curvature_without_bound_where_a_curve_stands_still_is_not_fair)
{
    /* Of Bezier points: at the start k ~ 1 / (12 t); in the middle, and at the end; one that halts with a bounded
     * curvature: (t^2, t^4) over [0, 1] is the parabola. */
    static const struct {
        int degree;
        double points[5][2];
        int unbounded, halts;
        bool infinite;
    } cases[] = {
        {3, {{0, 0}, {0, 0}, {1, 0}, {2, 1}}, 1, 0, true},
        {3, {{0, 0}, {1, 0}, {2, 1}, {2, 1}}, 1, 0, true},
        {4, {{-1, 1}, {0.5, -1}, {0, 1}, {-0.5, -1}, {1, 1}}, 1, 1, false},
        {4, {{0, 0}, {0, 0}, {1.0 / 6, 0}, {0.5, 0}, {1, 1}}, 0, 0, false},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        double knots[10];
        const int p = cases[i].degree;
        for (int k = 0; k < 2 * p + 2; k++)
            knots[k] = k > p;
        batten_curve *curve = NULL;
        batten_fairness found;
        CHECK_OK(batten_curve_create((batten_points){2, p + 1, cases[i].points[0]}, p, NULL,
                                     knots, &curve));
        CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, NULL, &found));
        CHECK_INT(found.unbounded, cases[i].unbounded);
        CHECK_INT(found.halts, cases[i].halts);
        CHECK(!cases[i].infinite || isinf(found.energy));
        CHECK(found.fair == (cases[i].unbounded == 0));
        CHECK(isinf(found.max_curvature) == (cases[i].unbounded > 0));
        if (!cases[i].unbounded) /* of y = x^2 over [0, 1] */
            CHECK_NEAR(found.energy, 1.311826546800169, 1e-8);
        batten_curve_unref(curve);
    }
}

/* Two Bezier pieces of a degree, over [0, 2], and what is found of them. */
static batten_fairness of_two_pieces(int p, const double *points)
{
    batten_curve *curve = NULL;
    batten_fairness found = {0};
    double knots[16];
    for (int k = 0; k < 3 * p + 2; k++)
        knots[k] = (k > p) + (k > 2 * p);
    CHECK_OK(
        batten_curve_create((batten_points){2, 2 * p + 1, points}, p, NULL, knots, &curve));
    CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, NULL, &found));
    batten_curve_unref(curve);
    return found;
}

TEST(what_follows_a_halt_without_bound_is_counted_as_if_it_were_not_there)
{
    /* It halts at 1/2; at 1 the curvature jumps. */
    static const double points[9][2] = {{-1, 1},  {0.5, -1}, {0, 1}, {-0.5, -1}, {1, 1},
                                        {2.5, 3}, {3, 4},    {4, 4}, {5, 4}};
    const batten_fairness found = of_two_pieces(4, points[0]);
    CHECK_INT(found.unbounded, 1);
    CHECK_INT(found.curvature_jumps, 1);
    CHECK(found.curvature_extrema > 0);
}

TEST(both_sides_of_a_halt_at_a_knot_are_examined_and_it_is_counted_once)
{
    /* The left piece ends with a curvature without bound; the right one begins straight, bent
     * without bound as well, and without a halt. */
    static const double points[3][7][2] = {
        {{0, 0}, {1, 0}, {2, 1}, {2, 1}, {2, 1}, {3, 2}, {4, 3}},
        {{0, 0}, {1, 0}, {2, 1}, {2, 1}, {2, 1}, {3, 2}, {4, 4}},
        {{0, 0}, {1, 0}, {2, 1}, {2, 1}, {2.5, 1.5}, {3, 2}, {4, 3}},
    };
    for (int i = 0; i < COUNT(points); i++) {
        const batten_fairness found = of_two_pieces(3, points[i][0]);
        CHECK_INT(found.unbounded, 1);
        CHECK_INT(found.corners, 0);
        CHECK(isinf(found.energy) && isinf(found.max_curvature));
    }
}

TEST(a_straight_line_that_slows_down_has_no_energy_and_no_corner)
{
    /* x = t^3: it stands still at 0 and goes on; far from the origin, where rounding is coarse */
    static const double knots[] = {-1, -1, -1, -1, 1, 1, 1, 1};
    const double far = 12345.678;
    const double points[] = {far - 1, far, far + 1, far, far - 1, far, far + 1, far};
    batten_curve *curve = NULL;
    batten_fairness found;
    CHECK_OK(batten_curve_create((batten_points){2, 4, points}, 3, NULL, knots, &curve));
    CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, NULL, &found));
    CHECK_INT(found.halts, 1);
    CHECK_INT(found.corners, 0);
    CHECK_NEAR(found.energy, 0, 0);
    CHECK_NEAR(found.variation, 0, 0);
    CHECK(found.fair);
    batten_curve_unref(curve);
}

TEST(the_bounds_of_the_verdict_are_those_given)
{
    /* two lines that turn by 0.01 */
    static const double knots[] = {0, 0, 1, 2, 2};
    const double points[] = {-1, 0, 0, 0, cos(0.01), sin(0.01)};
    batten_curve *curve = NULL;
    batten_fairness found;
    batten_fairness_options options = batten_fairness_defaults();
    CHECK_OK(batten_curve_create((batten_points){2, 3, points}, 1, NULL, knots, &curve));
    options.angle = 0.0099;
    CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, &options, &found));
    CHECK(found.corners == 1 && !found.fair);
    CHECK_NEAR(found.largest_turn, 0.01, 1e-12);
    options.angle = 0.0101;
    CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, &options, &found));
    CHECK(found.corners == 0 && found.fair);
    options.angle = 0;
    CHECK_STATUS(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, &options, &found),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("angle");
    options = batten_fairness_defaults();
    options.curvature = NAN;
    CHECK_STATUS(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, &options, &found),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("curvature");
    options = batten_fairness_defaults();
    options.within = -1;
    CHECK_STATUS(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, &options, &found),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("within -1");
    batten_curve_unref(curve);
}

TEST(points_that_may_lie_anywhere_within_a_bound_require_fewer_inflections)
{
    /* a zigzag of 0.1 about a line: seven points, five turns, four changes of side */
    double points[14];
    batten_curve *curve = NULL;
    batten_fairness found;
    batten_fairness_options options = batten_fairness_defaults();
    for (int i = 0; i < 7; i++) {
        points[2 * i] = i;
        points[2 * i + 1] = i % 2 ? 0.1 : -0.1;
    }
    const batten_points data = {2, 7, points};
    CHECK_OK(batten_curve_interpolate(data, NULL, NULL, &curve));
    CHECK_OK(batten_curve_fairness(curve, data, &options, &found));
    CHECK(found.inflections == 4 && found.excess_inflections == 0);
    options.within = 0.11;
    CHECK_OK(batten_curve_fairness(curve, data, &options, &found));
    CHECK(found.inflections == 4 && found.excess_inflections == 4);
    options.within = 0.05;
    CHECK_OK(batten_curve_fairness(curve, data, &options, &found));
    CHECK_INT(found.excess_inflections, 0);
    batten_curve_unref(curve);
}
