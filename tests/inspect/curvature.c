#include "inspect/shapes.h"
#include "inspect/singular.h"
#include <batten/standard.h>

TEST(a_circle_has_the_curvature_of_its_radius_and_no_rate)
{
    batten_curve *circle = NULL;
    CHECK_OK(shape_ellipse(2, 2, 1, -3, &circle));
    for (int k = 0; k <= 1000; k++) {
        batten_curve_local at;
        CHECK_OK(batten_curve_local_at(circle, k / 1000.0,
                                       k % 2 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &at));
        CHECK_NEAR(at.curvature, 0.5, 1e-11);
        CHECK_NEAR(at.curvature_rate, 0, 1e-10);
        CHECK_NEAR(at.point.x + at.normal.x * 2, 1, 1e-12); /* the centre lies to the left */
        CHECK_NEAR(at.point.y + at.normal.y * 2, -3, 1e-12);
        CHECK_NEAR(at.binormal.z, 1, 0);
        CHECK_NEAR(at.torsion, 0, 0);
    }
    batten_curve_unref(circle);
}

TEST(an_ellipse_has_the_curvature_of_its_equation)
{
    batten_curve *ellipse = NULL;
    CHECK_OK(shape_ellipse(3, 1, 0, 0, &ellipse));
    for (int k = 0; k < 100; k++) {
        batten_curve_local at;
        CHECK_OK(batten_curve_local_at(ellipse, (k + 0.5) / 100, BATTEN_FROM_RIGHT, &at));
        const double q = at.point.x * at.point.x / 81 + at.point.y * at.point.y;
        CHECK_NEAR(at.curvature, 1 / (9 * pow(q, 1.5)), 1e-11);
    }
    batten_curve_unref(ellipse);
}

TEST(the_end_of_a_bezier_curve_has_the_curvature_and_torsion_of_its_first_legs)
{
    test_random random = test_random_begin("bezier end");
    for (int n = test_cases(100); n > 0; n--) {
        const int degree = test_random_int(&random, 3, 9);
        double b[30];
        for (int i = 0; i < 3 * (degree + 1); i++)
            b[i] = test_random_in(&random, -1, 1);
        batten_curve *curve = NULL;
        batten_curve_local at;
        CHECK_OK(shape_bezier(3, degree, b, &curve));
        CHECK_OK(batten_curve_local_at(curve, 0, BATTEN_FROM_RIGHT, &at));
        double d[3][3], c[3];
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++)
                d[i][k] = b[3 * (i + 1) + k] - b[3 * i + k];
        for (int k = 0; k < 3; k++)
            c[k] =
                d[0][(k + 1) % 3] * d[1][(k + 2) % 3] - d[0][(k + 2) % 3] * d[1][(k + 1) % 3];
        const double size = sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
        const double leg = sqrt(d[0][0] * d[0][0] + d[0][1] * d[0][1] + d[0][2] * d[0][2]);
        const double det = c[0] * d[2][0] + c[1] * d[2][1] + c[2] * d[2][2], m = degree;
        const double curvature = (m - 1) / m * size / (leg * leg * leg);
        const double torsion = (m - 2) / m * det / (size * size);
        CHECK_NEAR(at.curvature, curvature, 1e-10 * curvature);
        CHECK_NEAR(at.torsion, torsion, 1e-9 * (1 + fabs(torsion)));
        batten_curve_unref(curve);
    }
}

TEST(the_rate_of_curvature_is_its_difference_quotient)
{
    const double points[2][12] = {{0, 0, 1, 2, 3, -1, 4, 1},
                                  {0, 0, 0, 1, 2, 1, 3, -1, 2, 4, 1, 0}};
    for (int d = 2; d <= 3; d++) {
        batten_curve *curve = NULL;
        CHECK_OK(shape_bezier(d, 3, points[d - 2], &curve));
        for (int k = 1; k < 10; k++) {
            batten_curve_local a, b, at;
            const double u = k / 10.0, h = 1e-5;
            CHECK_OK(batten_curve_local_at(curve, u - h, BATTEN_FROM_RIGHT, &a));
            CHECK_OK(batten_curve_local_at(curve, u + h, BATTEN_FROM_RIGHT, &b));
            CHECK_OK(batten_curve_local_at(curve, u, BATTEN_FROM_RIGHT, &at));
            CHECK_NEAR(at.curvature_rate, (b.curvature - a.curvature) / (2 * h * at.speed),
                       1e-6 * (1 + fabs(at.curvature_rate)));
        }
        batten_curve_unref(curve);
    }
}

TEST(G4_a_cusp_is_singular_and_has_the_tangent_of_the_next_derivative)
{
    /* (t^2, t^3) on [-1, 1] with a knot at the cusp: C'' = (2, 0) */
    const double breaks[3] = {-1, 0, 1};
    const double powers[2][4][2] = {{{1, -1}, {-2, 3}, {1, -3}, {0, 1}},
                                    {{0, 0}, {0, 0}, {1, 0}, {0, 1}}};
    batten_curve *curve = NULL;
    batten_curve_local at;
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){3, 2, breaks}, &powers[0][0][0], 1e-12,
                                     &curve));
    CHECK_STATUS(batten_curve_local_at(curve, 0, BATTEN_FROM_RIGHT, &at), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("first derivative vanishes");
    CHECK_NEAR(at.tangent.x, 1, 1e-15);
    CHECK_NEAR(at.curvature, 0, 0);
    CHECK_STATUS(batten_curve_local_at(curve, 0, BATTEN_FROM_LEFT, &at), BATTEN_SINGULAR_HERE);
    CHECK_NEAR(at.tangent.x, -1, 1e-15);
    CHECK_OK(batten_curve_local_at(curve, 0.5, BATTEN_FROM_LEFT, &at));
    batten_curve_unref(curve);
}

TEST(G3_a_curve_that_is_a_point_has_no_tangent)
{
    const double points[6] = {7, 7, 7, 7, 7, 7};
    batten_curve *curve = NULL;
    batten_curve_local at;
    CHECK_OK(shape_bezier(2, 2, points, &curve));
    CHECK_STATUS(batten_curve_local_at(curve, 0.5, BATTEN_FROM_RIGHT, &at),
                 BATTEN_SINGULAR_HERE);
    CHECK_NEAR(vec3_size(at.tangent), 0, 0);
    CHECK_NEAR(at.point.x, 7, 1e-15);
    batten_curve_unref(curve);
}

TEST(a_straight_line_in_space_has_no_normal)
{
    const double points[6] = {0, 0, 0, 1, 2, 3};
    batten_curve *line = NULL;
    batten_curve_local at;
    CHECK_OK(shape_bezier(3, 1, points, &line));
    CHECK_OK(batten_curve_local_at(line, 0.25, BATTEN_FROM_LEFT, &at));
    CHECK_NEAR(at.curvature, 0, 0);
    CHECK_NEAR(vec3_size(at.normal), 0, 0);
    CHECK_NEAR(vec3_size(at.tangent), 1, 1e-15);
    CHECK_STATUS(batten_curve_local_at(line, 2, BATTEN_FROM_LEFT, &at), BATTEN_OUT_OF_DOMAIN);
    batten_curve_unref(line);
}

TEST(the_teeth_of_a_circle_end_on_a_circle)
{
    batten_curve *circle = NULL;
    batten_tooth teeth[4 * 6];
    CHECK_OK(shape_ellipse(2, 2, 0, 0, &circle));
    CHECK_OK(batten_curve_comb(circle, 5, 3, teeth));
    for (int k = 0; k < COUNT(teeth); k++) {
        CHECK_NEAR(teeth[k].u, (k / 6 * 5 + k % 6) / 20.0, 1e-15);
        CHECK_NEAR(vec3_size(teeth[k].foot), 2, 1e-12);
        CHECK_NEAR(vec3_size(teeth[k].tip), 2 + 3 * 0.5, 1e-11);
    }
    CHECK_STATUS(batten_curve_comb(circle, 0, 3, teeth), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_comb(circle, 1, NAN, teeth), BATTEN_NOT_FINITE);
    batten_curve_unref(circle);
}

/* A span from 0 to q with end tangents a T0, b T1 on [0, 1] has the curvatures
 * (6 T0 x q - 2 b T0 x T1) / a^2 and (6 q x T1 - 2 a T0 x T1) / b^2. */
TEST(the_ends_of_a_cubic_have_the_curvatures_of_their_tangents)
{
    test_random random = test_random_begin("ends of cubics");
    for (int n = test_cases(200); n > 0; n--) {
        const double a = test_random_in(&random, 0.2, 3), b = test_random_in(&random, 0.2, 3),
                     alpha = test_random_in(&random, -3, 3),
                     beta = test_random_in(&random, -3, 3);
        const double q[2] = {test_random_in(&random, -1, 1), test_random_in(&random, -1, 1)};
        const double ends[] = {0, 1}, T0[] = {cos(alpha), sin(alpha)},
                     T1[] = {cos(beta), sin(beta)};
        const double values[] = {0, 0, a * T0[0], a * T0[1], q[0], q[1], b * T1[0], b * T1[1]};
        const double turn = T0[0] * T1[1] - T0[1] * T1[0];
        batten_curve *curve = NULL;
        batten_curve_local at;
        CHECK_OK(batten_curve_from_hermite(2, 2, 2, ends, values, &curve));
        CHECK_OK(batten_curve_local_at(curve, 0, BATTEN_FROM_RIGHT, &at));
        CHECK_NEAR(at.curvature * a * a, 6 * (T0[0] * q[1] - T0[1] * q[0]) - 2 * b * turn,
                   1e-12);
        CHECK_OK(batten_curve_local_at(curve, 1, BATTEN_FROM_LEFT, &at));
        CHECK_NEAR(at.curvature * b * b, 6 * (q[0] * T1[1] - q[1] * T1[0]) - 2 * a * turn,
                   1e-12);
        batten_curve_unref(curve);
    }
}

TEST(a_comb_steps_where_curvature_does)
{
    /* Two parabolas that leave the origin along x: y = x^2 / 4 before it, y = x^2 behind it. */
    static const double knots[] = {0, 0, 0, 1, 1, 2, 2, 2};
    static const double points[] = {-2, 1, -1, 0, 0, 0, 1, 0, 2, 4};
    batten_curve *curve = NULL;
    batten_tooth teeth[2 * 3];
    CHECK_OK(batten_curve_create((batten_points){2, 5, points}, 2, NULL, knots, &curve));
    CHECK_OK(batten_curve_comb(curve, 2, 3, teeth));
    CHECK_NEAR(teeth[2].u, 1, 0);
    CHECK_NEAR(teeth[3].u, 1, 0);
    CHECK_NEAR(teeth[2].curvature, 0.5, 1e-15);
    CHECK_NEAR(teeth[3].curvature, 2, 1e-15);
    CHECK_NEAR(teeth[2].tip.y, -1.5, 1e-14);
    CHECK_NEAR(teeth[3].tip.y, -6, 1e-14);
    batten_curve_unref(curve);
}

/* ---- the examples of the notes ---- */

/* Value and three derivatives at t, row by row. */
static void helix(double t, double *v)
{
    const double rows[] = {5 * cos(t),  5 * sin(t),  t / 5, -5 * sin(t), 5 * cos(t),  0.2,
                           -5 * cos(t), -5 * sin(t), 0,     5 * sin(t),  -5 * cos(t), 0};
    memcpy(v, rows, sizeof rows);
}

static void spiral(double t, double *v)
{
    const double s = sin(t / 2), c = cos(t / 2);
    const double rows[] = {
        t * s,         t, 3 + t * c,      s + t / 2 * c,         1, c - t / 2 * s,
        c - t / 4 * s, 0, -s - t / 4 * c, -0.75 * s - t / 8 * c, 0, -0.75 * c + t / 8 * s};
    memcpy(v, rows, sizeof rows);
}

static batten_curve *osculating(void (*f)(double, double *), double a, double b)
{
    enum { COUNT_OF_KNOTS = 65 };
    double at[COUNT_OF_KNOTS], values[COUNT_OF_KNOTS * 12];
    batten_curve *curve = NULL;
    for (int i = 0; i < COUNT_OF_KNOTS; i++) {
        at[i] = a + (b - a) * i / (COUNT_OF_KNOTS - 1);
        f(at[i], values + 12 * (size_t)i);
    }
    CHECK_OK(batten_curve_from_hermite(3, COUNT_OF_KNOTS, 4, at, values, &curve));
    return curve;
}

TEST(the_helix_of_the_notes_has_its_speed_curvature_and_torsion)
{
    batten_curve *curve = osculating(helix, 0, 6);
    for (int k = 0; k <= 300; k++) {
        batten_curve_local at;
        CHECK_OK(batten_curve_local_at(curve, 6 * k / 300.0,
                                       k ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &at));
        CHECK_NEAR(at.speed, 5.003998401278721, 1e-10);
        CHECK_NEAR(at.curvature, 5 / 25.04, 1e-9);
        CHECK_NEAR(at.torsion, 0.2 / 25.04, 1e-8);
        CHECK_NEAR(at.curvature / at.torsion, 25, 3e-5);
    }
    batten_curve_unref(curve);
    curve = osculating(spiral, -6, 6);
    batten_curve_local at;
    CHECK_OK(batten_curve_local_at(curve, 0, BATTEN_FROM_RIGHT, &at));
    CHECK_NEAR(at.curvature, 0.5, 1e-11);
    batten_curve_unref(curve);
}

TEST(the_loop_of_the_notes_crosses_itself_at_its_double_point)
{
    /* x = 4t^3 + 10t^2 - 30t + 2, y = -30t^2 - 10t + 10 in powers of t + 5. */
    const double ends[] = {-5, 5}, coefficients[] = {-98, -690, 170, 290, -50, -30, 4, 0};
    batten_curve *curve = NULL;
    batten_curve_local at;
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){3, 1, ends}, coefficients, 0, &curve));
    for (int side = -1; side <= 1; side += 2) {
        const double t = -1. / 6 + side * sqrt(33) / 2;
        CHECK_OK(batten_curve_local_at(curve, t, BATTEN_FROM_RIGHT, &at));
        CHECK_NEAR(at.point.x, 1978. / 27, 1e-11);
        CHECK_NEAR(at.point.y, -710. / 3, 1e-11);
        const double dx = 12 * t * t + 20 * t - 30, dy = -60 * t - 10, ddx = 24 * t + 20,
                     ddy = -60;
        CHECK_NEAR(at.curvature, (dx * ddy - dy * ddx) / pow(hypot(dx, dy), 3), 1e-14);
    }
    batten_curve_unref(curve);
}

TEST(another_parameter_changes_the_speed_and_not_the_curvature)
{
    const double points[] = {0, 0, 1, 2, 3, 1};
    batten_curve *curve = NULL, *fast = NULL;
    batten_curve_local at, twice;
    CHECK_OK(shape_bezier(2, 2, points, &curve));
    CHECK_OK(batten_curve_set_domain(curve, 0, 0.5, &fast));
    CHECK_OK(batten_curve_local_at(curve, 1, BATTEN_FROM_LEFT, &at));
    CHECK_OK(batten_curve_local_at(fast, 0.5, BATTEN_FROM_LEFT, &twice));
    CHECK_NEAR(twice.speed, 2 * at.speed, 1e-14);
    CHECK_NEAR(twice.curvature, at.curvature, 1e-15);
    batten_curve_unref(fast);
    batten_curve_unref(curve);
}

TEST(curves_from_1e_minus_120_to_1e120_and_those_of_zeros_can_be_worked_with)
{
    static const double good[] = {0, 1e-120, 1, 1e120}, bad[] = {0.99e-120, 1.01e120};
    static const double zero[2] = {0, 0};
    for (int i = 0; i < 6; i++) {
        const double size = i < 4 ? good[i] : bad[i - 4], end[2] = {size / 2, -size};
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_line(2, zero, end, &curve));
        CHECK_NEAR(bat_curve_size(curve), size, 0);
        if (i < 4) {
            CHECK_OK(bat_curve_check_size(curve));
        } else {
            CHECK_STATUS(bat_curve_check_size(curve), BATTEN_BAD_ARGUMENT);
            CHECK_MESSAGE(i == 4
                              ? "the largest coordinate is 9.9e-121; from 1e-120 to 1e+120"
                              : "the largest coordinate is 1.01e+120; from 1e-120 to 1e+120");
        }
        batten_curve_unref(curve);
    }
}
