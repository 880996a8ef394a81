#include "inspect/shapes.h"
#include <batten/measure.h>
#include <batten/standard.h>

TEST(a_circle_is_two_pi_long)
{
    batten_curve *circle = NULL;
    double length, error;
    CHECK_OK(shape_ellipse(1, 1, 5, 5, &circle));
    CHECK_OK(batten_curve_length(circle, 1e-12, &error, &length));
    CHECK_NEAR(length, 2 * PI, 1e-12);
    CHECK(error <= 1e-12);
    CHECK_OK(batten_curve_length_between(circle, 0.125, 0.5, 1e-12, NULL, &length));
    CHECK_NEAR(length, 0.75 * PI, 1e-12);
    CHECK_OK(batten_curve_length_between(circle, NAN, NAN, 1e-12, NULL, &length));
    CHECK_NEAR(length, 2 * PI, 1e-12);
    batten_curve_unref(circle);
}

TEST(all_forms_of_a_circle_are_two_pi_long)
{
    const batten_circle_form forms[] = {BATTEN_CIRCLE_SQUARE_9, BATTEN_CIRCLE_TRIANGLE_7,
                                        BATTEN_CIRCLE_SQUARE_7};
    for (int i = 0; i < COUNT(forms); i++) {
        batten_curve *circle = NULL;
        double length;
        CHECK_OK(batten_curve_circle(1, forms[i], &circle));
        CHECK_OK(batten_curve_length(circle, 1e-12, NULL, &length));
        CHECK_NEAR(length, 2 * PI, 1e-12);
        batten_curve_unref(circle);
    }
}

TEST(parabola_and_ellipse_have_their_known_lengths)
{
    /* y = x^2 on [0, 1]; the perimeter of the ellipse 3 : 1 is 12 E(8/9), by the
     * arithmetic-geometric mean */
    const double parabola[6] = {0, 0, 0.5, 0, 1, 1};
    double a = 3, b = 1, c = sqrt(8), sum = 0, power = 0.5, length;
    for (int n = 0; n < 8; n++) {
        sum += power * c * c;
        c = (a - b) / 2;
        const double mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
        power *= 2;
    }
    batten_curve *curve = NULL;
    CHECK_OK(shape_bezier(2, 2, parabola, &curve));
    CHECK_OK(batten_curve_length(curve, 1e-13, NULL, &length));
    CHECK_NEAR(length, 1.478942857544598, 1e-13);
    batten_curve_unref(curve);
    CHECK_OK(shape_ellipse(3, 1, 0, 0, &curve));
    CHECK_OK(batten_curve_length(curve, 1e-12, NULL, &length));
    CHECK_NEAR(length, 2 * PI * (9 - sum) / a, 1e-11);
    batten_curve_unref(curve);
}

TEST(G4_the_length_over_a_cusp_is_that_of_its_branches)
{
    /* (t^2, t^3) on [-1, 1] in one piece: each branch is (13 sqrt 13 - 8) / 27 long */
    const double powers[4][2] = {{1, -1}, {-2, 3}, {1, -3}, {0, 1}}, breaks[2] = {-1, 1};
    batten_curve *curve = NULL;
    double length, error;
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){3, 1, breaks}, &powers[0][0], 1e-12,
                                     &curve));
    CHECK_OK(batten_curve_length(curve, 1e-12, &error, &length));
    CHECK_NEAR(length, 2 * (13 * sqrt(13) - 8) / 27, 1e-11);
    CHECK(error <= 1e-11);
    batten_curve_unref(curve);
}

TEST(equal_lengths_of_a_circle_are_equal_angles)
{
    batten_curve *circle = NULL;
    double s[9], u[9];
    CHECK_OK(shape_ellipse(2, 2, 0, 0, &circle));
    for (int k = 0; k < 9; k++)
        s[k] = 4 * PI * k / 8;
    CHECK_OK(batten_curve_at_length(circle, 9, s, 1e-10, u));
    for (int k = 0; k < 9; k++) {
        double point[2];
        CHECK_OK(batten_curve_evaluate(circle, u[k], 0, point));
        CHECK_NEAR(point[0], 2 * cos(2 * PI * k / 8), 1e-9);
        CHECK_NEAR(point[1], 2 * sin(2 * PI * k / 8), 1e-9);
    }
    batten_curve_unref(circle);
}

TEST(length_and_its_inverse_agree_on_random_curves)
{
    test_random random = test_random_begin("inverse of length");
    for (int n = test_cases(30); n > 0; n--) {
        const int degree = test_random_int(&random, 1, 7);
        double points[24], whole, part, s, u;
        for (int i = 0; i < 3 * (degree + 1); i++)
            points[i] = test_random_in(&random, -1, 1);
        batten_curve *curve = NULL;
        CHECK_OK(shape_bezier(3, degree, points, &curve));
        CHECK_OK(batten_curve_length(curve, 1e-11, NULL, &whole));
        s = test_random_unit(&random) * whole;
        CHECK_OK(batten_curve_at_length(curve, 1, &s, 1e-10, &u));
        CHECK_OK(batten_curve_length_between(curve, 0, u, 1e-11, NULL, &part));
        CHECK_NEAR(part, s, 1e-10);
        batten_curve_unref(curve);
    }
}

TEST(G3_a_curve_that_is_a_point_has_length_0)
{
    const double points[6] = {7, 7, 7, 7, 7, 7};
    batten_curve *curve = NULL;
    double length, s = 0, u;
    CHECK_OK(shape_bezier(2, 2, points, &curve));
    CHECK_OK(batten_curve_length(curve, 1e-9, NULL, &length));
    CHECK_NEAR(length, 0, 1e-15);
    CHECK_OK(batten_curve_at_length(curve, 1, &s, 1e-9, &u));
    CHECK_NEAR(u, 0, 0);
    batten_curve_unref(curve);
}

TEST(N6_a_tolerance_that_is_not_positive_is_refused_and_a_tiny_one_ends_at_rounding)
{
    batten_curve *circle = NULL;
    double length = 3, error;
    CHECK_OK(shape_ellipse(1, 1, 0, 0, &circle));
    const double bad[] = {0, -1, NAN, HUGE_VAL};
    for (int k = 0; k < COUNT(bad); k++)
        CHECK_STATUS(batten_curve_length(circle, bad[k], NULL, &length), BATTEN_BAD_ARGUMENT);
    CHECK_NEAR(length, 3, 0);
    CHECK_OK(batten_curve_length(circle, 1e-300, &error, &length));
    CHECK_NEAR(length, 2 * PI, 1e-13);
    CHECK(error < 1e-12);
    batten_curve_unref(circle);
}

/* There the two rules differ by the rounding of the coordinates, however short the pieces. */
TEST(far_from_the_origin_a_length_ends_at_the_rounding_of_the_coordinates)
{
    const batten_affine far = batten_affine_translation(4e5, 5e6, 0);
    batten_curve *arc = NULL, *there = NULL;
    double length = 0, error = 0, u = 0;
    CHECK_OK(batten_curve_arc(0.5, 1, &arc));
    CHECK_OK(batten_curve_transform(arc, &far, &there));
    CHECK_OK(batten_curve_length(there, 1e-12, &error, &length));
    CHECK_NEAR(length, 0.5, 1e-8);
    CHECK(fabs(length - 0.5) <= error && error < 1e-7);
    CHECK_OK(batten_curve_at_length(there, 1, (double[]){length / 2}, 1e-12, &u));
    CHECK_NEAR(u, 0.5, 1e-7);
    batten_curve_unref(there);
    batten_curve_unref(arc);
}

TEST(lengths_outside_the_curve_or_out_of_order_are_refused)
{
    batten_curve *circle = NULL;
    const double beyond[2] = {1, 7}, backwards[2] = {1, 0.5}, bad[1] = {NAN};
    double u[2] = {9, 9}, length;
    CHECK_OK(shape_ellipse(1, 1, 0, 0, &circle));
    CHECK_STATUS(batten_curve_at_length(circle, 2, beyond, 1e-9, u), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_at_length(circle, 2, backwards, 1e-9, u), BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("length 2 is ");
    CHECK_STATUS(batten_curve_at_length(circle, 1, bad, 1e-9, u), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("length 1 is ");
    CHECK_STATUS(batten_curve_length_between(circle, 0.7, 0.2, 1e-9, NULL, &length),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_length_between(circle, 0.7, 2, 1e-9, NULL, &length),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_NEAR(u[0], 9, 0);
    const double before[2] = {-1, 0.5}, far[2] = {0.5, 6.4};
    CHECK_STATUS(batten_curve_at_length(circle, 2, before, 1e-9, u), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("length 1 is -1");
    CHECK_STATUS(batten_curve_at_length(circle, 2, far, 1e-9, u), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("length 2 is 6.4, but the curve is 6.28319 long");
    CHECK_NEAR(u[0], 9, 0);
    /* Within the tolerance an end is meant. */
    const double nearly[2] = {-0.9e-3, 2 * acos(-1) + 0.9e-3}, off[1] = {-1.1e-3};
    CHECK_OK(batten_curve_at_length(circle, 2, nearly, 1e-3, u));
    CHECK_BITS(u[0], batten_curve_domain(circle).a);
    CHECK_BITS(u[1], batten_curve_domain(circle).b);
    CHECK_STATUS(batten_curve_at_length(circle, 1, off, 1e-3, u), BATTEN_OUT_OF_DOMAIN);
    batten_curve_unref(circle);
}

/* The helix (5 cos t, 5 sin t, t / 5) by quintics with its value, first and second derivative
 * at 65 places: 5.003998401278721 long per radian. */
TEST(the_helix_of_the_notes_has_its_length_per_radian)
{
    enum { KNOTS = 65 };
    double at[KNOTS], values[KNOTS * 9], length;
    for (int i = 0; i < KNOTS; i++) {
        const double t = at[i] = 2 * PI * i / (KNOTS - 1);
        const double rows[9] = {5 * cos(t),  5 * sin(t),  t / 5, -5 * sin(t), 5 * cos(t), 0.2,
                                -5 * cos(t), -5 * sin(t), 0};
        memcpy(values + 9 * (size_t)i, rows, sizeof rows);
    }
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_hermite(3, KNOTS, 3, at, values, &curve));
    CHECK_INT(batten_curve_degree(curve), 5);
    CHECK_OK(batten_curve_length(curve, 1e-12, NULL, &length));
    CHECK_NEAR(length / (2 * PI), 5.003998401278721, 1e-9);
    for (int i = 1; i <= 6; i++) {
        CHECK_OK(batten_curve_length_between(curve, 0, i, 1e-12, NULL, &length));
        CHECK_NEAR(length / i, 5.0039984, 1.3e-9);
        CHECK_NEAR(length / i, sqrt(25.04), 1e-9);
    }
    batten_curve_unref(curve);
}

/* The indefinite integral of sqrt(q), q = a t^2 + b t + c > 0. */
static double root_integral(double a, double b, double c, double t)
{
    const double root = sqrt((a * t + b) * t + c), slope = 2 * a * t + b;
    return slope * root / (4 * a) +
           (4 * a * c - b * b) / (8 * pow(a, 1.5)) * log(fabs(slope + 2 * sqrt(a) * root));
}

TEST(parabolas_have_the_length_of_the_closed_form_between_chord_and_polygon)
{
    test_random random = test_random_begin("parabolas");
    for (int n = test_cases(300); n > 0; n--) {
        double P[3][2], a = 0, b = 0, c = 0, length;
        for (int i = 0; i < 6; i++)
            (&P[0][0])[i] = test_random_in(&random, -1, 1);
        for (int k = 0; k < 2; k++) { /* P' = 2 (e + t f) */
            const double e = P[1][k] - P[0][k], f = P[2][k] - 2 * P[1][k] + P[0][k];
            a += 4 * f * f;
            b += 8 * e * f;
            c += 4 * e * e;
        }
        if (a < 1e-2 || 4 * a * c - b * b < 1e-4) /* there the closed form cancels */
            continue;
        batten_curve *curve = NULL;
        CHECK_OK(shape_bezier(2, 2, P[0], &curve));
        CHECK_OK(batten_curve_length(curve, 1e-12, NULL, &length));
        CHECK_NEAR(length, root_integral(a, b, c, 1) - root_integral(a, b, c, 0), 1e-10);
        CHECK(length >= hypot(P[2][0] - P[0][0], P[2][1] - P[0][1]));
        CHECK(length <= hypot(P[1][0] - P[0][0], P[1][1] - P[0][1]) +
                            hypot(P[2][0] - P[1][0], P[2][1] - P[1][1]));
        batten_curve_unref(curve);
    }
}

/* Where q is a square the point turns back on a line: the pieces count as they are. */
TEST(a_parabola_that_turns_back_on_a_line_is_as_long_as_both_ways)
{
    const double points[] = {0, 0, 3, 4, 0, 0}; /* to (1.5, 2) and back */
    batten_curve *curve = NULL;
    double length;
    CHECK_OK(shape_bezier(2, 2, points, &curve));
    CHECK_OK(batten_curve_length(curve, 1e-12, NULL, &length));
    CHECK_NEAR(length, 5, 1e-12);
    batten_curve_unref(curve);
}

TEST(a_length_does_not_depend_on_where_the_domain_lies)
{
    static const double from[] = {0, -3, 1000, -5e5};
    const double points[7][2] = {{0, 0}, {1, 2}, {3, 2}, {4, -1}, {6, 0}, {7, 3}, {5, 5}};
    double first = 0;
    for (int i = 0; i < COUNT(from); i++) {
        double knots[11], length, error, part, after;
        for (int k = 0; k < 11; k++)
            knots[k] = from[i] + 0.5 * (k < 4 ? 0 : k > 7 ? 4 : k - 3);
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_create((batten_points){2, 7, &points[0][0]}, 3, NULL, knots, &curve));
        CHECK_OK(batten_curve_length(curve, 1e-7, &error, &length));
        CHECK(error <= 1e-7);
        first = i == 0 ? length : first;
        CHECK_NEAR(length, first, 1e-7);
        CHECK_OK(
            batten_curve_length_between(curve, from[i], from[i] + 0.7, 1e-9, &error, &part));
        CHECK(error <= 1e-9);
        CHECK_OK(
            batten_curve_length_between(curve, from[i] + 0.7, from[i] + 2, 1e-9, NULL, &after));
        CHECK_NEAR(part + after, length, 1e-7);
        batten_curve_unref(curve);
    }
}
