#include "support/faults.h"
#include "support/test.h"
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/offset.h>
#include <batten/standard.h>

#define PI 3.14159265358979323846

static batten_curve_offset_options options_of(double tolerance, batten_loops loops,
                                              batten_offset_corner corners)
{
    batten_curve_offset_options options = batten_curve_offset_defaults();
    options.tolerance = tolerance;
    options.loops = loops;
    options.corners = corners;
    return options;
}

static void bezier(int dimension, int degree, const double *points, batten_curve **out)
{
    const double breaks[2] = {0, 1};
    CHECK_OK(batten_curve_from_bezier(dimension, (batten_pieces){degree, 1, breaks}, points,
                                      NULL, out));
}

/* The largest | |Q - C| - d | at 400 points of each curve. */
static double distance_error(const batten_curve *curve, const batten_curves *made, double d)
{
    double worst = 0;
    for (int i = 0; i < made->count; i++) {
        const int dimension = batten_curve_dimension(curve);
        const batten_interval domain = batten_curve_domain(made->at[i]);
        double points[401 * 3], far[401];
        batten_deviation all;
        for (int k = 0; k <= 400; k++)
            CHECK_OK(batten_curve_evaluate(made->at[i],
                                           domain.a + (domain.b - domain.a) * (k / 400.0), 0,
                                           points + k * dimension));
        CHECK_OK(batten_curve_deviation(
            curve, (batten_points){batten_curve_dimension(curve), 401, points}, NULL, NULL, far,
            &all));
        for (int k = 0; k <= 400; k++)
            worst = fmax(worst, fabs(far[k] - fabs(d)));
    }
    return worst;
}

TEST(the_offset_of_a_circle_is_a_circle_exactly)
{
    batten_curve *circle = NULL;
    CHECK_OK(batten_curve_circle(5, BATTEN_CIRCLE_SQUARE_9, &circle));
    const double distances[] = {2, -3, 4.999};
    for (int i = 0; i < COUNT(distances); i++) {
        batten_curves made = {0, NULL};
        batten_curve_offset_report report;
        CHECK_EACH_ALLOCATION(batten_curve_offset(circle, distances[i], NULL, &report, &made));
        CHECK_INT(made.count, 1);
        CHECK(report.error == 0);
        CHECK(batten_curve_is_closed(made.at[0], 1e-14));
        CHECK_INT(batten_curve_degree(made.at[0]), 2);
        for (int k = 0; k <= 100; k++) {
            double p[2];
            CHECK_OK(batten_curve_evaluate(made.at[0], k / 100.0, 0, p));
            CHECK_NEAR(hypot(p[0], p[1]), 5 - distances[i], 1e-14);
        }
        batten_curves_release(&made);
    }
    batten_curve_unref(circle);
}

TEST(a_circle_offset_beyond_its_centre_leaves_nothing)
{
    batten_curve *circle = NULL;
    CHECK_OK(batten_curve_circle(5, BATTEN_CIRCLE_TRIANGLE_7, &circle));
    const double distances[] = {5, 5.001, 7, 12};
    for (int i = 0; i < COUNT(distances); i++) {
        batten_curves made = {7, NULL};
        CHECK_EACH_ALLOCATION(batten_curve_offset(circle, distances[i], NULL, NULL, &made));
        CHECK_INT(made.count, 0);
        batten_curves_release(&made);
    }
    /* All of it, in one piece: the reversed circle of radius 2. */
    const batten_curve_offset_options keep =
        options_of(1e-6, BATTEN_LOOPS_KEEP, BATTEN_OFFSET_ROUND);
    batten_curves made = {0, NULL};
    double p[2];
    CHECK_OK(batten_curve_offset(circle, 7, &keep, NULL, &made));
    CHECK_INT(made.count, 1);
    CHECK_OK(batten_curve_evaluate(made.at[0], 0.3, 0, p));
    CHECK_NEAR(hypot(p[0], p[1]), 2, 1e-13);
    batten_curves_release(&made);
    batten_curve_unref(circle);
}

/* y = x^2 for x in [-1.5, 1.5] */
static void parabola(batten_curve **out)
{
    const double points[6] = {-1.5, 2.25, 0, -2.25, 1.5, 2.25};
    bezier(2, 2, points, out);
}

TEST(the_offset_of_a_parabola_has_its_cusps_and_its_corner)
{
    batten_curve *curve = NULL;
    batten_curves made = {0, NULL};
    batten_curve_offset_report report;
    const batten_curve_offset_options keep =
        options_of(1e-7, BATTEN_LOOPS_KEEP, BATTEN_OFFSET_ROUND);
    parabola(&curve);
    CHECK_OK(batten_curve_offset(curve, 1, &keep, &report, &made));
    CHECK_INT(report.cusps, 2);
    CHECK_INT(made.count, 1);
    CHECK(report.error <= 1e-7);
    /* cusps where 1 + 4 x^2 = 2^(2/3) */
    const double x = sqrt((cbrt(4) - 1) / 4), v = sqrt(1 + 4 * x * x);
    CHECK_NEAR(x, 0.3832, 5e-5);
    double p[4];
    CHECK_OK(batten_curve_evaluate(made.at[0], 0.5 + x / 3, 1, p));
    CHECK_NEAR(p[0], x - 2 * x / v, 1e-7);
    CHECK_NEAR(p[1], x * x + 1 / v, 1e-7);
    CHECK(hypot(p[2], p[3]) < 1e-5);
    /* it crosses itself in (0, 5/4), at x = -sqrt(3)/2 and sqrt(3)/2 */
    batten_parameters crossings = {0, NULL};
    CHECK_OK(batten_curve_self_crossings(made.at[0], &crossings));
    CHECK_INT(crossings.count, 2);
    CHECK_NEAR(crossings.at[0], 0.5 - sqrt(3) / 6, 1e-6);
    CHECK_NEAR(crossings.at[1], 0.5 + sqrt(3) / 6, 1e-6);
    batten_release(crossings.at);
    batten_curves_release(&made);

    const batten_curve_offset_options trim =
        options_of(1e-7, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
    CHECK_OK(batten_curve_offset(curve, 1, &trim, &report, &made));
    CHECK_INT(made.count, 1);
    CHECK_INT(report.crossings, 1);
    CHECK(distance_error(curve, &made, 1) <= 3e-7);
    batten_deviation far;
    const double corner[2] = {0, 1.25};
    CHECK_OK(batten_curve_deviation(
        made.at[0], (batten_points){batten_curve_dimension(made.at[0]), 1, corner}, NULL, NULL,
        NULL, &far));
    CHECK_NEAR(far.max, 0, 1e-7);
    batten_curves_release(&made);
    batten_curve_unref(curve);
}

TEST(the_offset_of_an_ellipse_is_shorter_by_two_pi_d)
{
    batten_curve *ellipse = NULL;
    double whole, length;
    CHECK_OK(batten_curve_ellipse(3, 2, 0, 2 * PI, &ellipse));
    CHECK_OK(batten_curve_length(ellipse, 1e-12, NULL, &whole));
    const double distances[] = {0.5, 1.2, -1, -7};
    for (int i = 0; i < COUNT(distances); i++) {
        const batten_curve_offset_options o =
            options_of(1e-9, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
        batten_curves made = {0, NULL};
        CHECK_OK(batten_curve_offset(ellipse, distances[i], &o, NULL, &made));
        CHECK_INT(made.count, 1);
        CHECK(batten_curve_is_closed(made.at[0], 1e-9));
        CHECK_OK(batten_curve_length(made.at[0], 1e-10, NULL, &length));
        CHECK_NEAR(length, whole - 2 * PI * distances[i], 1e-7);
        CHECK(distance_error(ellipse, &made, distances[i]) <= 1e-9);
        batten_curves_release(&made);
    }
    batten_curve_unref(ellipse);
}

TEST(offset_there_and_back_is_the_curve)
{
    test_random random = test_random_begin("offset there and back");
    for (int n = test_cases(20); n > 0; n--) {
        double points[12];
        for (int i = 0; i < 6; i++) {
            points[2 * i] = i + test_random_in(&random, -0.2, 0.2);
            points[2 * i + 1] = test_random_in(&random, -0.5, 0.5);
        }
        const double knots[10] = {0, 0, 0, 0, 0.4, 0.5, 1, 1, 1, 1};
        const double tolerance = n % 2 ? 1e-4 : 1e-7;
        const batten_curve_offset_options o =
            options_of(tolerance, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
        batten_curve *curve = NULL;
        batten_curves there = {0, NULL}, back = {0, NULL};
        CHECK_OK(batten_curve_create((batten_points){2, 6, points}, 3, NULL, knots, &curve));
        const double d = n % 3 ? 0.05 : -0.05;
        CHECK_OK(batten_curve_offset(curve, d, &o, NULL, &there));
        CHECK_INT(there.count, 1);
        CHECK(distance_error(curve, &there, d) <= tolerance);
        CHECK_OK(batten_curve_offset(there.at[0], -d, &o, NULL, &back));
        CHECK_INT(back.count, 1);
        CHECK(distance_error(curve, &back, 0) <= 2 * tolerance);
        batten_curves_release(&back);
        batten_curves_release(&there);
        batten_curve_unref(curve);
    }
}

/* A square with the corners (0, 0) and (4, 4), counter-clockwise. */
static void square(batten_curve **out)
{
    const double points[10] = {0, 0, 4, 0, 4, 4, 0, 4, 0, 0};
    CHECK_OK(batten_curve_polyline((batten_points){2, 5, points}, out));
}

TEST(the_corners_of_a_square_are_round_mitred_or_square)
{
    static const struct {
        batten_offset_corner corners;
        double distance, length;
    } cases[] = {
        {BATTEN_OFFSET_ROUND, -1, 16 + 2 * 3.14159265358979323846},
        {BATTEN_OFFSET_MITRE, -1, 24},
        /* each corner: two ends of tan(pi/8), and a chamfer twice as long */
        {BATTEN_OFFSET_SQUARE, -1, 16 + 4 * 4 * 0.41421356237309504880},
        {BATTEN_OFFSET_ROUND, 1, 8},
        {BATTEN_OFFSET_MITRE, 1.5, 4},
    };
    batten_curve *curve = NULL;
    square(&curve);
    for (int i = 0; i < COUNT(cases); i++) {
        const batten_curve_offset_options o =
            options_of(1e-6, BATTEN_LOOPS_REMOVE, cases[i].corners);
        batten_curves made = {0, NULL};
        double length;
        CHECK_OK(batten_curve_offset(curve, cases[i].distance, &o, NULL, &made));
        CHECK_INT(made.count, 1);
        CHECK(batten_curve_is_closed(made.at[0], 1e-12));
        CHECK_OK(batten_curve_length(made.at[0], 1e-12, NULL, &length));
        CHECK_NEAR(length, cases[i].length, 1e-10);
        batten_curves_release(&made);
    }
    batten_curve_unref(curve);
}

TEST(a_sharp_mitre_beyond_its_limit_becomes_square)
{
    /* 20 degrees between the sides: the mitre would be 5.76 times the distance. */
    const double a = PI / 9, points[6] = {-3, 0, 0, 0, -3 * cos(a), -3 * sin(a)};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){2, 3, points}, &curve));
    const double limits[] = {4, 6};
    const double expected[] = {1, 1 / sin(a / 2)};
    for (int i = 0; i < 2; i++) {
        batten_curve_offset_options o =
            options_of(1e-6, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_MITRE);
        o.mitre_limit = limits[i];
        batten_curves made = {0, NULL};
        CHECK_OK(batten_curve_offset(curve, 1, &o, NULL, &made));
        CHECK_INT(made.count, 1);
        /* how far it goes along the bisector of the corner */
        const double out[2] = {cos(a / 2), sin(a / 2)};
        double most = 0;
        for (int k = 0; k < batten_curve_point_count(made.at[0]); k++) {
            const double *p = batten_curve_points(made.at[0]) + 2 * k;
            most = fmax(most, p[0] * out[0] + p[1] * out[1]);
        }
        CHECK_NEAR(most, expected[i], 1e-12);
        batten_curves_release(&made);
    }
    batten_curve_unref(curve);
}

TEST(an_offset_falls_apart_where_the_curve_is_narrow)
{
    /* A dumb-bell: two squares of side 4 joined by a neck 1 wide. */
    const double p[26] = {0, 0, 4, 0, 4,   1.5, 7,   1.5, 7, 0, 11, 0, 11,
                          4, 7, 4, 7, 2.5, 4,   2.5, 4,   4, 0, 4,  0, 0};
    batten_curve *curve = NULL;
    batten_curves made = {0, NULL};
    double length;
    CHECK_OK(batten_curve_polyline((batten_points){2, 13, p}, &curve));
    const batten_curve_offset_options o =
        options_of(1e-6, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_MITRE);
    CHECK_OK(batten_curve_offset(curve, 0.4, &o, NULL, &made));
    CHECK_INT(made.count, 1);
    batten_curves_release(&made);
    const batten_curve_offset_options round =
        options_of(1e-6, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
    CHECK_OK(batten_curve_offset(curve, 0.75, &round, NULL, &made));
    CHECK_INT(made.count, 2);
    for (int i = 0; i < 2; i++) {
        CHECK(batten_curve_is_closed(made.at[i], 1e-9));
        CHECK_OK(batten_curve_length(made.at[i], 1e-10, NULL, &length));
        /* A square of side 2.5 without the middle unit of one side, and there two arcs about
         * the corners of the neck, which meet half a unit off each. */
        CHECK_NEAR(length, 9 + 2 * 0.75 * asin(0.5 / 0.75), 1e-5);
        CHECK(distance_error(curve, &made, 0.75) <= 3e-6);
    }
    batten_curves_release(&made);
    batten_curve_unref(curve);
}

TEST(an_offset_keeps_its_distance_from_the_end_of_the_curve_and_from_its_other_side)
{
    /* A hook whose end comes back to within 0.5 of its stem; its left offset by 0.8 may not
     * pass there. */
    const double p[8] = {0, 0, 6, 0, 6, 3, 2, 0.5};
    batten_curve *curve = NULL;
    batten_curves made = {0, NULL};
    CHECK_OK(batten_curve_polyline((batten_points){2, 4, p}, &curve));
    const batten_curve_offset_options o =
        options_of(1e-6, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
    for (int side = -1; side <= 1; side += 2) {
        CHECK_OK(batten_curve_offset(curve, 0.8 * side, &o, NULL, &made));
        CHECK(made.count > 0);
        CHECK(distance_error(curve, &made, 0.8) <= 3e-6);
        batten_curves_release(&made);
    }
    batten_curve_unref(curve);
}

TEST(in_space_the_offset_goes_across_the_normal)
{
    /* A turn of a helix about z: its offset is a helix of another radius. */
    const double p[9] = {1, 0, 0, 1, 1, 0.5, 0, 1, 1}, w[3] = {1, sqrt(0.5), 1};
    const double breaks[2] = {0, 1};
    batten_curve *curve = NULL, *tipped = NULL;
    batten_curves made = {0, NULL};
    batten_curve_offset_report report;
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){2, 1, breaks}, p, w, &curve));
    CHECK_OK(batten_curve_offset(curve, -2, NULL, &report, &made));
    CHECK_INT(made.count, 1);
    CHECK(report.error == 0);
    for (int k = 0; k <= 50; k++) {
        double a[3], b[3];
        CHECK_OK(batten_curve_evaluate(curve, k / 50.0, 0, a));
        CHECK_OK(batten_curve_evaluate(made.at[0], k / 50.0, 0, b));
        CHECK_NEAR(hypot(b[0], b[1]), 3, 1e-14);
        CHECK_NEAR(b[2], a[2], 1e-15);
    }
    batten_curves_release(&made);
    /* The same turned about x by 90 degrees, with its axis. */
    const batten_affine map =
        batten_affine_rotation((batten_vec3){0, 0, 0}, (batten_vec3){1, 0, 0}, PI / 2);
    batten_curve_offset_options o = batten_curve_offset_defaults();
    o.normal = (batten_vec3){0, -3, 0};
    CHECK_OK(batten_curve_transform(curve, &map, &tipped));
    CHECK_OK(batten_curve_offset(tipped, -2, &o, &report, &made));
    CHECK_INT(made.count, 1);
    for (int k = 0; k <= 50; k++) {
        double b[3];
        CHECK_OK(batten_curve_evaluate(made.at[0], k / 50.0, 0, b));
        CHECK_NEAR(hypot(b[0], b[2]), 3, 1e-14);
    }
    batten_curves_release(&made);
    batten_curve_unref(tipped);
    batten_curve_unref(curve);
}

TEST(a_spline_with_loops_in_its_offset_keeps_its_distance)
{
    test_random random = test_random_begin("offsets with loops");
    for (int n = test_cases(15); n > 0; n--) {
        double points[24];
        const double knots[13] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
        batten_curve *curve = NULL;
        for (int i = 0; i < 12; i++) {
            const double r = test_random_in(&random, 1.5, 4);
            points[2 * i] = r * cos(PI * i / 6);
            points[2 * i + 1] = r * sin(PI * i / 6);
        }
        CHECK_OK(batten_curve_create_periodic((batten_points){2, 12, points}, 3, NULL, knots,
                                              &curve));
        const batten_curve_offset_options o =
            options_of(1e-5, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
        const double distances[] = {0.3, 0.7, 1, -0.5, -1.5};
        for (int i = 0; i < COUNT(distances); i++) {
            batten_curves made = {0, NULL};
            CHECK_OK(batten_curve_offset(curve, distances[i], &o, NULL, &made));
            CHECK(distance_error(curve, &made, distances[i]) <= 5e-5);
            for (int k = 0; k < made.count; k++)
                CHECK(batten_curve_is_closed(made.at[k], 1e-12));
            CHECK(made.count > 0 || distances[i] >= 0.7);
            batten_curves_release(&made);
        }
        batten_curve_unref(curve);
    }
}

TEST(the_sides_of_a_loop_narrower_than_the_error_of_the_pieces_are_joined)
{
    /* Radii of twelve control points about a centre, and a distance that leaves a swallowtail
     * as wide as rounding at one of them. */
    static const struct {
        double distance, radii[12];
    } rows[] = {
        {1, /* the loop is left by one side only */
         {3.8276363136630946, 1.885375235202052, 2.537192962390663, 1.9067828623849787,
          2.1250371866660247, 2.6115806459585666, 3.876841160896625, 2.522028107430459,
          3.4027144756445886, 3.810310771487031, 2.150969085817305, 3.8645792027565538}},
        {0.7, /* a side comes back just behind the end of a run */
         {3.548040018889945, 3.954995092350791, 1.7618376530905766, 2.9771503076847927,
          2.9443539300615686, 3.3388114727173983, 1.994737614388493, 1.9030241858848451,
          2.376063509578848, 3.9684277399234906, 2.5166452970238344, 2.618201921517894}},
    };
    for (int row = 0; row < COUNT(rows); row++) {
        double points[24];
        const double knots[13] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
        batten_curve *curve = NULL;
        batten_curves made = {0, NULL};
        for (int i = 0; i < 12; i++) {
            points[2 * i] = rows[row].radii[i] * cos(PI * i / 6);
            points[2 * i + 1] = rows[row].radii[i] * sin(PI * i / 6);
        }
        CHECK_OK(batten_curve_create_periodic((batten_points){2, 12, points}, 3, NULL, knots,
                                              &curve));
        const batten_curve_offset_options o =
            options_of(1e-5, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
        CHECK_OK(batten_curve_offset(curve, rows[row].distance, &o, NULL, &made));
        CHECK_INT(made.count, 1);
        CHECK(batten_curve_is_closed(made.at[0], 1e-12));
        CHECK(distance_error(curve, &made, rows[row].distance) <= 5e-5);
        batten_curves_release(&made);
        batten_curve_unref(curve);
    }
}

TEST(what_comes_near_another_part_of_the_curve_is_removed)
{
    /* Long lines that the rest of the curve crosses, or comes near with a corner or an end:
     * without a crossing of the offset with itself. */
    static const struct {
        int count;
        double points[12];
    } rows[] = {
        {5, {0, 0, 4, 3, 4, 0, 0, 3, 0, 0}},
        {4, {0, 0, 4, 3, 4, 0, 0, 3}},
        {5, {0, 0, 40, 0, 60, 20, 7.3, 0.15, -10, 20}},
        {4, {0, 0, 40, 0, 40, 5, 7.3, 0.15}},
        {4, {0, 0, 1, 0, 0, 0, 2, 0.5}}, /* turns back on itself */
    };
    for (int row = 0; row < COUNT(rows); row++) {
        for (int side = -1; side <= 1; side += 2) {
            batten_curve *curve = NULL;
            batten_curves made = {0, NULL};
            const batten_curve_offset_options o =
                options_of(1e-6, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
            CHECK_OK(batten_curve_polyline(
                (batten_points){2, rows[row].count, rows[row].points}, &curve));
            CHECK_OK(batten_curve_offset(curve, 0.1 * side, &o, NULL, &made));
            CHECK(made.count > 0);
            for (int i = 0; i < made.count; i++) {
                double far[2001], points[2 * 2001];
                const batten_interval domain = batten_curve_domain(made.at[i]);
                batten_deviation all;
                for (int k = 0; k <= 2000; k++)
                    CHECK_OK(batten_curve_evaluate(
                        made.at[i], domain.a + (domain.b - domain.a) * (k / 2000.0), 0,
                        points + 2 * k));
                CHECK_OK(batten_curve_deviation(
                    curve, (batten_points){batten_curve_dimension(curve), 2001, points}, NULL,
                    NULL, far, &all));
                for (int k = 0; k <= 2000; k++)
                    CHECK_NEAR(far[k], 0.1, 1e-5);
            }
            batten_curves_release(&made);
            batten_curve_unref(curve);
        }
    }
}

TEST(the_offset_at_distance_zero_is_the_curve)
{
    batten_curve *curve = NULL;
    batten_curves made = {0, NULL};
    parabola(&curve);
    CHECK_OK(batten_curve_offset(curve, 0, NULL, NULL, &made));
    CHECK_INT(made.count, 1);
    CHECK(distance_error(curve, &made, 0) <= 1e-6);
    batten_curves_release(&made);
    batten_curve_unref(curve);
}

TEST(N6_distances_and_tolerances_that_mean_nothing_are_refused)
{
    batten_curve *curve = NULL, *point = NULL, *function = NULL;
    batten_curves made = {7, NULL};
    const double zeros[6] = {0};
    parabola(&curve);
    bezier(1, 2, zeros, &function);
    bezier(2, 2, zeros, &point);
    CHECK_STATUS(batten_curve_offset(curve, NAN, NULL, NULL, &made), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_offset(curve, HUGE_VAL, NULL, NULL, &made), BATTEN_NOT_FINITE);
    batten_curve_offset_options o = options_of(0, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
    CHECK_STATUS(batten_curve_offset(curve, 1, &o, NULL, &made), BATTEN_BAD_ARGUMENT);
    o = options_of(NAN, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
    CHECK_STATUS(batten_curve_offset(curve, 1, &o, NULL, &made), BATTEN_BAD_ARGUMENT);
    o = options_of(1e-3, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_MITRE);
    o.mitre_limit = 0.5;
    CHECK_STATUS(batten_curve_offset(curve, 1, &o, NULL, &made), BATTEN_BAD_ARGUMENT);
    o = options_of(1e-3, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
    o.most_pieces = 0;
    CHECK_STATUS(batten_curve_offset(curve, 1, &o, NULL, &made), BATTEN_BAD_ARGUMENT);
    o = options_of(1e-12, BATTEN_LOOPS_KEEP, BATTEN_OFFSET_ROUND);
    o.most_pieces = 3;
    CHECK_STATUS(batten_curve_offset(curve, 0.1, &o, NULL, &made), BATTEN_TOLERANCE_NOT_MET);
    CHECK_STATUS(batten_curve_offset(function, 1, NULL, NULL, &made), BATTEN_UNSUPPORTED);
    CHECK_STATUS(batten_curve_offset(point, 1, NULL, NULL, &made), BATTEN_SINGULAR_HERE);
    CHECK_INT(made.count, 7);
    batten_curve_unref(point);
    batten_curve_unref(function);
    batten_curve_unref(curve);
}

TEST(G3_an_end_where_the_curve_stands_still_has_its_offset)
{
    /* The first two control points coincide: the curve begins with speed 0 along (1, 1). */
    const double points[8] = {0, 0, 0, 0, 1, 1, 3, 0};
    batten_curve *curve = NULL;
    batten_curves made = {0, NULL};
    const batten_curve_offset_options o =
        options_of(1e-6, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
    bezier(2, 3, points, &curve);
    CHECK_OK(batten_curve_offset(curve, 0.5, &o, NULL, &made));
    CHECK_INT(made.count, 1);
    CHECK(distance_error(curve, &made, 0.5) <= 1e-6);
    double p[2];
    CHECK_OK(batten_curve_evaluate(made.at[0], 0, 0, p));
    CHECK_NEAR(p[0], -0.5 * sqrt(0.5), 1e-15);
    CHECK_NEAR(p[1], 0.5 * sqrt(0.5), 1e-15);
    batten_curves_release(&made);
    batten_curve_unref(curve);
}

TEST(n2_curves_beyond_the_sizes_that_can_be_worked_with_have_no_offset)
{
    static const double sizes[] = {1e200, 1e-200};
    for (int i = 0; i < COUNT(sizes); i++) {
        const double points[6] = {0, 0, sizes[i], sizes[i], 2 * sizes[i], 0};
        batten_curve *curve = NULL;
        batten_curves made;
        bezier(2, 2, points, &curve);
        const batten_curve_offset_options options =
            options_of(sizes[i] * 1e-4, BATTEN_LOOPS_REMOVE, BATTEN_OFFSET_ROUND);
        CHECK_STATUS(batten_curve_offset(curve, sizes[i] / 10, &options, NULL, &made),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("choose another unit");
        batten_curve_unref(curve);
    }
}
