/* Arcs of Bezier cubics: how far they are from the circle, and that no piece is too many. */
#include <batten/polygon.h>

#include "support/test.h"

static const double pi = 3.14159265358979323846;

TEST(the_cubic_of_a_right_angle_is_off_by_the_known_number)
{
    batten_curve *curve = NULL;
    double error, largest = 0, least = 1, at[2];
    CHECK_OK(batten_curve_arc_cubic(1, pi / 2, 1, &error, &curve));
    CHECK_NEAR(error, 2.7253e-4, 5e-9);
    for (int i = 0; i <= 10000; i++) {
        CHECK_OK(batten_curve_evaluate(curve, i / 10000.0, 0, at));
        largest = fmax(largest, hypot(at[0], at[1]) - 1);
        least = fmin(least, hypot(at[0], at[1]) - 1);
    }
    CHECK_NEAR(largest, error, 1e-11);
    CHECK(least > -1e-15);
    batten_curve_unref(curve);
}

TEST(arcs_of_cubics_keep_their_tolerance_with_no_piece_too_many)
{
    for (int k = 2; k <= 10; k++) {
        const double tolerance = pow(10, -k);
        batten_curve *curve = NULL;
        double error;
        CHECK_OK(batten_curve_arc_cubic(3, 2 * pi, tolerance, &error, &curve));
        CHECK(error <= tolerance);
        const int pieces = batten_curve_spans(curve, NULL) - 1;
        const double w = 2 * pi / (pieces - 1); /* one piece less would be too far */
        CHECK(pieces == 2 ||
              3 * (sqrt(1 + 4.0 / 27 * pow(sin(w / 4), 6) / pow(cos(w / 4), 2)) - 1) >
                  0.99 * tolerance);
        batten_curve_unref(curve);
    }
}

TEST(N6_arcs_of_cubics_refuse_what_is_none)
{
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_arc_cubic(1, 1, 0, NULL, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc_cubic(1, 7, 1, NULL, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc_cubic(-1, 1, 1, NULL, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc_cubic(1, NAN, 1, NULL, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc_cubic(1, 1, 1e-300, NULL, &curve), BATTEN_TOLERANCE_NOT_MET);
}

/* Radii of a Bezier cubic from (1, 0) to the angle w with legs k, less 1: the extremes. */
static void off_circle(double w, double k, double *least, double *largest)
{
    const double c = cos(w), s = sin(w), points[] = {1, 0, 1, k, c + k * s, s - k * c, c, s};
    batten_curve *curve = NULL;
    *least = 1, *largest = -1;
    CHECK_OK(batten_curve_bezier(2, 3, points, NULL, &curve));
    for (int i = 0; i <= 20000; i++) {
        double at[2];
        CHECK_OK(batten_curve_evaluate(curve, i / 20000.0, 0, at));
        *least = fmin(*least, hypot(at[0], at[1]) - 1);
        *largest = fmax(*largest, hypot(at[0], at[1]) - 1);
    }
    batten_curve_unref(curve);
}

/* The notes have (2 / 27) sin^6(w / 4) / cos^2(w / 4) for legs (4 / 3) tan(w / 4): e + e^2 / 2
 * of the true e, one-sided; the sixth order in w. */
TEST(cubics_near_arcs_are_off_by_the_formula_of_the_notes_in_the_sixth_order)
{
    double before = 0;
    for (double w = pi / 2; w > 0.3; w /= 2) {
        double least, largest, error;
        batten_curve *curve = NULL;
        off_circle(w, 4.0 / 3 * tan(w / 4), &least, &largest);
        const double e = 2.0 / 27 * pow(sin(w / 4), 6) / pow(cos(w / 4), 2);
        CHECK_NEAR(largest + largest * largest / 2, e, 1e-7 * e + 1e-15);
        CHECK(least > -1e-15);
        CHECK_OK(batten_curve_arc_cubic(1, w, 1, &error, &curve));
        CHECK_NEAR(error, largest, 1e-7 * e + 1e-15);
        batten_curve_unref(curve);
        if (before > 0)
            CHECK_NEAR(log2(before / largest), 6, 0.1);
        before = largest;
    }
}

TEST(the_best_legs_for_a_right_angle_leave_the_known_number_on_both_sides)
{
    double least, largest;
    off_circle(pi / 2, 0.5519150244935106, &least, &largest);
    CHECK_NEAR(largest, 1.96076e-4, 5e-10);
    CHECK_NEAR(least, -1.96076e-4, 5e-10);
}

/* Value, slope and second derivative 1 at one place and 0 at the other: three spans each. */
TEST(arcs_of_cubics_refuse_what_is_not_finite)
{
    batten_curve *curve = NULL;
    double error = -1;
    CHECK_STATUS(batten_curve_arc_cubic(INFINITY, 1, 1, &error, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc_cubic(1, -1, 1, &error, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc_cubic(1, 1, INFINITY, &error, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_NEAR(error, -1, 0);
    /* However loose the tolerance, no piece turns by more than pi. */
    CHECK_OK(batten_curve_arc_cubic(1, 2 * pi, 1e9, NULL, &curve));
    CHECK_INT(batten_curve_point_count(curve), 7);
    batten_curve_unref(curve);
}

TEST(every_piece_of_an_arc_of_cubics_lies_within_the_error)
{
    for (int k = 1; k <= 6; k++) {
        const double angle = k == 6 ? 2 * pi : k * 1.1, radius = 0.5 * k;
        batten_curve *curve = NULL;
        double error = -1, largest = 0, at[4];
        CHECK_OK(batten_curve_arc_cubic(radius, angle, pow(10, -k), &error, &curve));
        for (int i = 0; i <= 2000; i++) {
            CHECK_OK(batten_curve_evaluate(curve, i / 2000.0, 1, at));
            const double off = hypot(at[0], at[1]) - radius;
            CHECK(off > -1e-14 && off <= error * (1 + 1e-9) + 1e-15);
            largest = fmax(largest, off);
            /* It turns to the left, at a right angle to the radius but for the error. */
            CHECK(at[0] * at[3] - at[1] * at[2] > 0);
        }
        CHECK_NEAR(largest, error, 1e-3 * error + 1e-15);
        CHECK_NEAR(at[0], radius * cos(angle), 1e-14);
        CHECK_NEAR(at[1], radius * sin(angle), 1e-14);
        batten_curve_unref(curve);
    }
}
