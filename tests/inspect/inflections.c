#include "inspect/inflections.h"

#include "inspect/shapes.h"

#include <batten/nearest.h>

static void check_parameters(const batten_parameters *found, int count, const double *expected,
                             double tolerance)
{
    CHECK_INT(found->count, count);
    for (int k = 0; k < count; k++)
        CHECK_NEAR(found->at[k], expected[k], tolerance);
}

TEST(an_ellipse_has_its_vertices_and_no_inflection)
{
    batten_curve *ellipse = NULL;
    batten_parameters found = {0};
    const double inside[3] = {0.25, 0.5, 0.75};
    CHECK_OK(shape_ellipse(3, 1, 100, -7, &ellipse));
    CHECK_OK(batten_curve_curvature_extrema(ellipse, &found));
    check_parameters(&found, 3, inside, 1e-9);
    batten_release(found.at);
    CHECK_OK(batten_curve_inflections(ellipse, &found));
    CHECK_INT(found.count, 0);
    batten_release(found.at);
    batten_curve_unref(ellipse);
}

TEST(circles_and_lines_have_neither)
{
    const double line[8] = {0, 0, 1, 2, 3, 6, 4, 8};
    for (int k = 0; k < 2; k++) {
        batten_curve *curve = NULL;
        batten_parameters inflections = {0}, extrema = {0};
        if (k == 0)
            CHECK_OK(shape_ellipse(1e3, 1e3, 1e4, 0.1, &curve));
        else
            CHECK_OK(shape_bezier(2, 3, line, &curve));
        CHECK_OK(batten_curve_inflections(curve, &inflections));
        CHECK_OK(batten_curve_curvature_extrema(curve, &extrema));
        CHECK_INT(inflections.count + extrema.count, 0);
        batten_release(inflections.at);
        batten_release(extrema.at);
        batten_curve_unref(curve);
    }
}

/* Right turn, a side along y, right turn. The middle of the side stands off by what a sum of
 * coordinates leaves, though that is no rounding of the side's own x; then by more. */
TEST(a_side_that_is_straight_but_for_the_rounding_of_its_points_is_not_inflected)
{
    static const double knots[10] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3}, ends[2] = {1, 2};
    static const double off[2] = {1.7763568394002505e-15, 1e-11};
    for (int k = 0; k < 2; k++) {
        const double points[14] = {200, 0, 0, 0, 0, 50, off[k], 75, 0, 100, 0, 150, 200, 150};
        batten_curve *curve = NULL;
        batten_parameters found = {0};
        CHECK_OK(batten_curve_create((batten_points){2, 7, points}, 2, NULL, knots, &curve));
        CHECK_OK(batten_curve_inflections(curve, &found));
        check_parameters(&found, k == 0 ? 0 : 2, ends, 1e-12);
        batten_release(found.at);
        batten_curve_unref(curve);
    }
}

TEST(the_cubic_graph_is_inflected_at_its_centre)
{
    /* y = x^3 - x on [-1, 2]: Bezier ordinates of the cubic, abscissae equally spaced */
    const double powers[4][2] = {{-1, 0}, {1, 2}, {0, -3}, {0, 1}}, breaks[2] = {-1, 2};
    const double centre[1] = {0};
    batten_curve *curve = NULL;
    batten_parameters found = {0};
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){3, 1, breaks}, &powers[0][0], 1e-12,
                                     &curve));
    CHECK_OK(batten_curve_inflections(curve, &found));
    check_parameters(&found, 1, centre, 1e-14);
    batten_release(found.at);
    batten_curve_unref(curve);
}

TEST(an_inflection_at_a_knot_is_found_once)
{
    /* two parabolas, bent to opposite sides, joined with a common tangent: (t, t |t|) */
    const double breaks[3] = {-1, 0, 1}, centre[1] = {0};
    const double powers[2][3][2] = {{{-1, -1}, {1, 2}, {0, -1}}, {{0, 0}, {1, 0}, {0, 1}}};
    batten_curve *curve = NULL;
    batten_parameters found = {0};
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){2, 2, breaks}, &powers[0][0][0], 1e-12,
                                     &curve));
    CHECK_OK(batten_curve_inflections(curve, &found));
    check_parameters(&found, 1, centre, 0);
    batten_release(found.at);
    batten_curve_unref(curve);
}

TEST(the_extreme_of_curvature_of_a_parabola_is_its_vertex)
{
    /* y = x^2 in the plane, and tilted in space */
    const double plane[6] = {-1, 1, 0.5, -2, 2, 4};
    const double space[9] = {-1, 0.6, 0.8, 0.5, -1.2, -1.6, 2, 2.4, 3.2};
    const double vertex[1] = {1.0 / 3};
    for (int d = 2; d <= 3; d++) {
        batten_curve *curve = NULL;
        batten_parameters found = {0};
        CHECK_OK(shape_bezier(d, 2, d == 2 ? plane : space, &curve));
        CHECK_OK(batten_curve_curvature_extrema(curve, &found));
        check_parameters(&found, 1, vertex, 1e-13);
        batten_release(found.at);
        batten_curve_unref(curve);
    }
}

TEST(of_a_function_the_second_derivative_counts)
{
    /* s = u^4 - u^2 / 2 ... on [-1, 1]: s'' = 12 u^2 - 1, s''' = 24 u */
    const double powers[5] = {0.5, -3, 5.5, -4, 1}, breaks[2] = {-1, 1};
    const double inflections[2] = {-sqrt(1.0 / 12), sqrt(1.0 / 12)}, extremum[1] = {0};
    batten_curve *curve = NULL, *rational = NULL;
    batten_parameters found = {0};
    CHECK_OK(batten_curve_from_power(1, (batten_pieces){4, 1, breaks}, powers, 1e-12, &curve));
    CHECK_OK(batten_curve_to_rational(curve, &rational));
    for (int k = 0; k < 2; k++) {
        const batten_curve *which = k == 0 ? curve : rational;
        CHECK_OK(batten_curve_inflections(which, &found));
        check_parameters(&found, 2, inflections, 1e-13);
        batten_release(found.at);
        CHECK_OK(batten_curve_curvature_extrema(which, &found));
        check_parameters(&found, 1, extremum, 1e-13);
        batten_release(found.at);
    }
    batten_curve_unref(rational);
    batten_curve_unref(curve);
}

TEST(inflections_do_not_depend_on_the_form_of_the_curve)
{
    test_random random = test_random_begin("inflections");
    for (int n = test_cases(40); n > 0; n--) {
        const int degree = test_random_int(&random, 3, 8);
        double points[18];
        batten_curve *curve = NULL, *high = NULL, *split = NULL, *rational = NULL;
        batten_parameters a = {0}, b = {0}, c = {0};
        for (int i = 0; i < 2 * (degree + 1); i++)
            points[i] = test_random_in(&random, -1, 1);
        CHECK_OK(shape_bezier(2, degree, points, &curve));
        CHECK_OK(batten_curve_elevate(curve, 2, &high));
        CHECK_OK(batten_curve_insert_knot(high, 0.37, 1, &split));
        CHECK_OK(batten_curve_moebius(curve, 2, 0, 1, 1, &rational)); /* u -> 2 u / (u + 1) */
        CHECK_OK(batten_curve_inflections(curve, &a));
        CHECK_OK(batten_curve_inflections(split, &b));
        CHECK_OK(batten_curve_inflections(rational, &c));
        CHECK_INT(b.count, a.count);
        CHECK_INT(c.count, a.count);
        for (int k = 0; k < a.count; k++) {
            double p[2], q[2];
            CHECK_NEAR(b.at[k], a.at[k], 1e-9);
            CHECK_OK(batten_curve_evaluate(curve, a.at[k], 0, p));
            CHECK_OK(batten_curve_evaluate(rational, c.at[k], 0, q));
            CHECK_NEAR(hypot(p[0] - q[0], p[1] - q[1]), 0, 1e-8);
        }
        batten_release(a.at);
        batten_release(b.at);
        batten_release(c.at);
        batten_curve_unref(rational);
        batten_curve_unref(split);
        batten_curve_unref(high);
        batten_curve_unref(curve);
    }
}

TEST(extrema_are_where_the_rate_changes_sign)
{
    test_random random = test_random_begin("extrema");
    for (int n = test_cases(30); n > 0; n--) {
        const int d = test_random_int(&random, 2, 3);
        double points[12];
        batten_curve *curve = NULL;
        batten_parameters found = {0};
        for (int i = 0; i < 4 * d; i++)
            points[i] = test_random_in(&random, -1, 1);
        CHECK_OK(shape_bezier(d, 3, points, &curve));
        CHECK_OK(batten_curve_curvature_extrema(curve, &found));
        for (int k = 0; k < found.count; k++) {
            const double h = 1e-7, u = found.at[k];
            batten_curve_local before, after;
            if (u < 2 * h || u > 1 - 2 * h)
                continue;
            CHECK_OK(batten_curve_local_at(curve, u - h, BATTEN_FROM_RIGHT, &before));
            CHECK_OK(batten_curve_local_at(curve, u + h, BATTEN_FROM_RIGHT, &after));
            CHECK(before.curvature_rate * after.curvature_rate <= 0);
        }
        batten_release(found.at);
        batten_curve_unref(curve);
    }
}

TEST(a_closed_periodic_curve_counts_its_seam)
{
    /* a periodic cubic through a regular hexagon, stretched: four vertices, one of them at the
     * seam */
    double points[12], knots[7];
    batten_curve *curve = NULL;
    batten_parameters found = {0};
    for (int i = 0; i < 6; i++) {
        points[2 * i] = 2 * cos(PI * i / 3);
        points[2 * i + 1] = sin(PI * i / 3);
    }
    for (int i = 0; i < 7; i++)
        knots[i] = i;
    CHECK_OK(
        batten_curve_create_periodic((batten_points){2, 6, points}, 3, NULL, knots, &curve));
    CHECK_OK(batten_curve_inflections(curve, &found));
    CHECK_INT(found.count, 0);
    batten_release(found.at);
    CHECK_OK(batten_curve_curvature_extrema(curve, &found));
    CHECK_INT(found.count % 2, 0);
    CHECK(found.count >= 4);
    batten_release(found.at);
    batten_curve_unref(curve);
}

TEST(curves_in_space_have_no_inflections)
{
    const double points[9] = {0, 0, 0, 1, 1, 1, 2, 0, 3};
    batten_curve *curve = NULL;
    batten_parameters found = {0};
    CHECK_OK(shape_bezier(3, 2, points, &curve));
    CHECK_STATUS(batten_curve_inflections(curve, &found), BATTEN_NOT_COMPATIBLE);
    batten_curve_unref(curve);
}

/* Value and three derivatives of (cos t, sin t) exp(c t), which bends ever less. */
static void logarithmic(double c, double t, double out[4][2])
{
    double x = exp(c * t) * cos(t), y = exp(c * t) * sin(t);
    for (int k = 0; k < 4; k++) {
        out[k][0] = x;
        out[k][1] = y;
        const double turned = c * x - y; /* times c + i */
        y = c * y + x;
        x = turned;
    }
}

/* The same of the clothoid with curvature k + s. */
static void clothoid(double k, double s, double out[4][2])
{
    const double T[2] = {cos(k * s + s * s / 2), sin(k * s + s * s / 2)}, bend = k + s;
    out[0][0] = out[0][1] = 0;
    for (int i = 0; i < 64; i++) /* the integral of the direction, by Simpson's rule */
        for (int j = 0; j <= 2; j++) {
            const double u = s * (i + j / 2.0) / 64, w = (j == 1 ? 4 : 1) * s / (6 * 64);
            out[0][0] += w * cos(k * u + u * u / 2);
            out[0][1] += w * sin(k * u + u * u / 2);
        }
    out[1][0] = T[0], out[1][1] = T[1];
    out[2][0] = -bend * T[1], out[2][1] = bend * T[0];
    out[3][0] = -T[1] - bend * bend * T[0], out[3][1] = T[0] - bend * bend * T[1];
}

/* As septics with exact third derivatives, so that the rate of curvature is continuous. */
TEST(logarithmic_and_euler_spirals_have_no_vertices)
{
    enum { KNOTS = 17 };
    for (int kind = 0; kind < 2; kind++) {
        double at[KNOTS], values[KNOTS][4][2];
        for (int i = 0; i < KNOTS; i++) {
            at[i] = 3.0 * i / (KNOTS - 1);
            (kind ? clothoid : logarithmic)(kind ? -1 : 0.3, at[i], values[i]);
        }
        batten_curve *curve = NULL;
        batten_parameters found = {0};
        CHECK_OK(batten_curve_from_hermite(2, KNOTS, 4, at, &values[0][0][0], &curve));
        CHECK_OK(batten_curve_curvature_extrema(curve, &found));
        CHECK_INT(found.count, 0);
        batten_release(found.at);
        CHECK_OK(batten_curve_inflections(curve, &found));
        CHECK_INT(found.count, kind);
        if (kind)
            CHECK_NEAR(found.at[0], 1, 1e-6); /* of k = s - 1 */
        batten_release(found.at);
        batten_curve_unref(curve);
    }
}

TEST(turns_are_where_a_curve_is_farthest_along_a_direction_that_is_one)
{
    static const batten_vec3 bad[] = {{0, 0, 0}, {NAN, 1, 0}, {1, INFINITY, 0}, {0, 0, 1}};
    batten_curve *ellipse = NULL;
    batten_parameters at = {0, NULL};
    CHECK_OK(shape_ellipse(3, 2, 0, 0, &ellipse));
    for (int i = 0; i < COUNT(bad); i++) {
        CHECK_STATUS(batten_curve_turns(ellipse, bad[i], &at), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("the direction is (");
        CHECK(at.at == NULL);
    }
    for (int scale = -1; scale <= 1; scale += 2) {
        /* (3 cos t, 2 sin t) is farthest along (c, s) where tan t = 2 s / (3 c). */
        const double c = scale * 1e-3 * cos(0.7), s = scale * 1e-3 * sin(0.7);
        CHECK_OK(batten_curve_turns(ellipse, (batten_vec3){c, s, 0}, &at));
        CHECK_INT(at.count, 2);
        for (int i = 0; i < at.count; i++) {
            double p[4];
            CHECK_OK(batten_curve_evaluate(ellipse, at.at[i], 1, p));
            CHECK_NEAR(p[2] * c + p[3] * s, 0, 1e-13);
            CHECK_NEAR(fabs(p[0] * c + p[1] * s), hypot(3 * c, 2 * s), 1e-15);
        }
        batten_release(at.at);
        at = (batten_parameters){0, NULL};
    }
    batten_curve_unref(ellipse);
}

TEST(two_lists_of_parameters_become_one_that_ends_exactly_at_the_end_of_the_domain)
{
    const double end = 3 - 4 * DBL_EPSILON;
    const batten_parameters a = {3, (double[3]){0, 1, end}}, b = {2, (double[2]){0.5, 3}};
    batten_parameters out = {0, NULL};
    CHECK_OK(bat_parameters_merge(&a, &b, (batten_interval){0, 3}, &out));
    CHECK_INT(out.count, 4);
    CHECK_NEAR(out.at[1], 0.5, 0);
    CHECK_NEAR(out.at[2], 1, 0);
    CHECK_NEAR(out.at[3], 3, 0);
    batten_release(out.at);
}
