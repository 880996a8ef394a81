#include "support/test.h"
#include <batten/approximate.h>
#include <batten/measure.h>
#include <batten/standard.h>

#define PI 3.14159265358979323846

static void random_curve(test_random *random, int dimension, batten_curve **out)
{
    double points[24], weights[8];
    const double knots[12] = {0, 0, 0, 0, 0.2, 0.2, 0.5, 0.9, 1, 1, 1, 1};
    for (int i = 0; i < 8; i++) {
        for (int k = 0; k < dimension; k++)
            points[i * dimension + k] = (k == 0 ? i : 0) + test_random_in(random, -0.6, 0.6);
        weights[i] = test_random_in(random, 0.6, 1.6);
    }
    CHECK_OK(batten_curve_create((batten_points){dimension, 8, points}, 3,
                                 test_random_int(random, 0, 1) ? weights : NULL, knots, out));
}

TEST(a_circle_at_even_speed_is_where_its_arc_length_says)
{
    batten_curve *circle = NULL, *even = NULL;
    CHECK_OK(batten_curve_circle(2, BATTEN_CIRCLE_SQUARE_9, &circle));
    batten_curve_even_speed_report report;
    CHECK_OK(batten_curve_even_speed(circle, 1e-8, &report, &even));
    CHECK_NEAR(report.length, 4 * PI, 1e-10);
    CHECK(report.error <= 1e-8 && report.error > 0);
    const batten_interval domain = batten_curve_domain(even);
    CHECK(domain.a == 0);
    CHECK_NEAR(domain.b, 4 * PI, 1e-10);
    CHECK_INT(batten_curve_spans(even, NULL), report.pieces + 1);
    for (int i = 0; i <= 500; i++) {
        const double s = domain.b * i / 500;
        double c[4];
        CHECK_OK(batten_curve_evaluate(even, s, 1, c));
        CHECK(hypot(c[0] - 2 * cos(s / 2), c[1] - 2 * sin(s / 2)) <= report.error + 1e-10);
        CHECK_NEAR(hypot(c[2], c[3]), 1, 1e-6);
    }
    batten_curve_unref(even);
    batten_curve_unref(circle);
}

TEST(random_curves_at_even_speed_are_met_at_every_length)
{
    test_random random = test_random_begin("even");
    for (int n = test_cases(12); n > 0; n--) {
        const int dimension = test_random_int(&random, 2, 3);
        batten_curve *given = NULL, *even = NULL;
        batten_curve_even_speed_report report;
        double length, s[101], u[101];
        random_curve(&random, dimension, &given);
        CHECK_OK(batten_curve_even_speed(given, 1e-6, &report, &even));
        CHECK_OK(batten_curve_length(given, 1e-12, NULL, &length));
        CHECK_NEAR(report.length, length, 1e-8);
        for (int i = 0; i <= 100; i++)
            s[i] = fmin(length, batten_curve_domain(even).b) * i / 100;
        CHECK_OK(batten_curve_at_length(given, 101, s, 1e-11, u));
        for (int i = 0; i <= 100; i++) {
            double p[3], q[3], away = 0;
            CHECK_OK(batten_curve_evaluate(given, u[i], 0, p));
            CHECK_OK(batten_curve_evaluate(even, s[i], 0, q));
            for (int k = 0; k < dimension; k++)
                away += (p[k] - q[k]) * (p[k] - q[k]);
            CHECK(sqrt(away) <= report.error + 1e-10);
        }
        batten_curve_unref(even);
        batten_curve_unref(given);
    }
}

TEST(polylines_at_even_speed_are_exact)
{
    const double p[] = {0, 0, 3, 4, 3, 4, 3, 16}, knots[] = {0, 0, 1, 2, 9, 9};
    batten_curve *path = NULL, *even = NULL;
    batten_curve_even_speed_report report;
    CHECK_OK(batten_curve_create((batten_points){2, 4, p}, 1, NULL, knots, &path));
    CHECK_OK(batten_curve_even_speed(path, 1e-6, &report, &even));
    CHECK(report.error == 0 && report.length == 17);
    CHECK_INT(batten_curve_point_count(even), 3);
    double at[2];
    CHECK_OK(batten_curve_evaluate(even, 5, 0, at));
    CHECK(at[0] == 3 && at[1] == 4);
    CHECK_OK(batten_curve_evaluate(even, 11, 0, at));
    CHECK_NEAR(at[1], 10, 1e-15);
    batten_curve_unref(even);
    batten_curve_unref(path);
}

TEST(G4_corners_and_cusps_stay_where_they_are)
{
    /* A cusp in the middle: x = 3 t^2 - 2 t^3 .. of the control points (0,0) (1,1) (0,1) (1,0).
     */
    const double p[] = {0, 0, 1, 1, 0, 1, 1, 0}, breaks[] = {0, 1};
    batten_curve *cusp = NULL, *even = NULL;
    batten_curve_even_speed_report report;
    double length;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, p, NULL, &cusp));
    CHECK_OK(batten_curve_even_speed(cusp, 1e-4, &report, &even));
    CHECK_OK(batten_curve_length(cusp, 1e-10, NULL, &length));
    CHECK_NEAR(report.length, length, 1e-6);
    double at[2];
    CHECK_OK(batten_curve_evaluate(even, length / 2, 0, at));
    CHECK_NEAR(at[0], 0.5, 1e-4);
    CHECK_NEAR(at[1], 0.75, 1e-4);
    batten_curve_unref(even);
    batten_curve_unref(cusp);
}

/* How often the knot at arc length s stands there, to 1e-9. */
static int multiplicity(const batten_curve *curve, double s)
{
    const int count = batten_curve_point_count(curve) + batten_curve_degree(curve) + 1;
    int times = 0;
    for (int i = 0; i < count; i++)
        times += fabs(batten_curve_knots(curve)[i] - s) < 1e-9;
    return times;
}

TEST(quintics_join_with_curvature_but_where_the_curve_has_none_in_common)
{
    /* Two half circles of one radius, of two, and with a corner: knots of degree 5 that stand
     * three times leave two derivatives, and five times the point alone. */
    for (int c = 0; c < 3; c++) {
        const double r = c == 1 ? 2 : 1, x = c == 2 ? 1 : 0;
        const double points[] = {0, 0,  1, 0,  1,     1,  1,         2, 0,
                                 2, -r, 2, -r, 2 - r, -r, 2 - 2 * r, 0, 2 - 2 * r};
        double moved[18];
        memcpy(moved, points, sizeof points);
        moved[10] += 2 * r * x; /* a corner: back to the other side */
        moved[12] += 2 * r * x;
        moved[14] += 2 * r * x;
        const double w = sqrt(0.5), weights[] = {1, w, 1, w, 1, w, 1, w, 1};
        const double breaks[] = {0, 1, 2, 3, 4};
        batten_curve *curve = NULL, *even = NULL;
        CHECK_OK(
            batten_curve_from_bezier(2, (batten_pieces){2, 4, breaks}, moved, weights, &curve));
        CHECK_OK(batten_curve_even_speed(curve, 1e-6, NULL, &even));
        CHECK_INT(multiplicity(even, PI / 2), 3);
        CHECK_INT(multiplicity(even, PI), c == 0 ? 3 : 5);
        CHECK_INT(multiplicity(even, PI + r * PI / 2), 3);
        CHECK_INT(multiplicity(even, 0), 6);
        batten_curve_unref(even);
        batten_curve_unref(curve);
    }
}

TEST(curves_whose_end_stands_still_are_followed_to_it)
{
    /* x = 2 s on a line of speed 3 t^2, and a cubic whose first two points are one: its arc length
     * grows with t^2 there, and with t^3 where three are. */
    for (int same = 2; same <= 3; same++) {
        double p[] = {0, 0, 0, 0, 2, 1, 3, 0};
        const double breaks[] = {0, 1};
        if (same == 3)
            p[4] = p[5] = 0;
        batten_curve *curve = NULL, *even = NULL;
        batten_curve_even_speed_report report;
        double length, s[21], u[21];
        CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, p, NULL, &curve));
        CHECK_OK(batten_curve_even_speed(curve, 1e-5, &report, &even));
        CHECK_OK(batten_curve_length(curve, 1e-12, NULL, &length));
        for (int i = 0; i <= 20; i++)
            s[i] = fmin(length, batten_curve_domain(even).b) * i * i / 400;
        CHECK_OK(batten_curve_at_length(curve, 21, s, 1e-11, u));
        for (int i = 0; i <= 20; i++) {
            double c[2], q[2];
            CHECK_OK(batten_curve_evaluate(curve, u[i], 0, c));
            CHECK_OK(batten_curve_evaluate(even, s[i], 0, q));
            CHECK(hypot(c[0] - q[0], c[1] - q[1]) <= report.error + 1e-7);
        }
        CHECK(report.error <= 1e-5 && report.pieces < 200);
        batten_curve_unref(even);
        batten_curve_unref(curve);
    }
}

TEST(a_tolerance_below_rounding_is_not_met_and_leaves_what_was_there)
{
    batten_curve *circle = NULL, *even = NULL;
    batten_curve_even_speed_report report = {.pieces = 77};
    CHECK_OK(batten_curve_circle(2, BATTEN_CIRCLE_SQUARE_9, &circle));
    CHECK_STATUS(batten_curve_even_speed(circle, 1e-16, &report, &even),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("the curve is missed by");
    CHECK(report.pieces == 77 && !even);
    batten_curve_unref(circle);
}

TEST(N1_N6_G3_what_has_no_length_or_tolerance_is_refused)
{
    const double p[] = {1, 2, 1, 2, 3, 4}, one[] = {0, 1};
    batten_curve *point = NULL, *line = NULL, *function = NULL, *out = NULL;
    CHECK_OK(batten_curve_line(2, p, p + 2, &point));
    CHECK_OK(batten_curve_line(2, p, p + 4, &line));
    CHECK_OK(batten_curve_line(1, one, one + 1, &function));
    CHECK_STATUS(batten_curve_even_speed(point, 1e-6, NULL, &out), BATTEN_COINCIDENT);
    CHECK_STATUS(batten_curve_even_speed(function, 1e-6, NULL, &out), BATTEN_UNSUPPORTED);
    static const double bad[] = {0, -1, NAN, INFINITY};
    for (int i = 0; i < COUNT(bad); i++)
        CHECK_STATUS(batten_curve_even_speed(line, bad[i], NULL, &out), BATTEN_BAD_ARGUMENT);
    batten_curve_unref(function);
    batten_curve_unref(line);
    batten_curve_unref(point);
}
