#include "support/test.h"
#include <batten/measure.h>
#include <batten/standard.h>

#define PI 3.14159265358979323846

/* The difference of the longest chord and the shortest. */
static double spread(const batten_curve *curve, int count, const double *u)
{
    double least = HUGE_VAL, most = 0, before[3] = {0};
    for (int i = 0; i <= count; i++) {
        double p[3] = {0}, square = 0;
        CHECK_OK(batten_curve_evaluate(curve, u[i], 0, p));
        for (int k = 0; k < 3; k++) {
            square += (p[k] - before[k]) * (p[k] - before[k]);
            before[k] = p[k];
        }
        if (i > 0) {
            least = fmin(least, sqrt(square));
            most = fmax(most, sqrt(square));
        }
    }
    return most - least;
}

TEST(equal_chords_of_a_circle_are_sides_of_polygons)
{
    batten_curve *circle = NULL;
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_TRIANGLE_7, &circle));
    static const int counts[] = {3, 4, 7, 100};
    for (int i = 0; i < COUNT(counts); i++) {
        double u[101], chord;
        CHECK_OK(batten_curve_divide_equal_chords(circle, counts[i], 1e-12, &chord, u));
        CHECK_NEAR(chord, 2 * sin(PI / counts[i]), 1e-12);
        CHECK(spread(circle, counts[i], u) <= 4e-12);
    }
    batten_curve_unref(circle);
}

TEST(equal_chords_of_a_parabola_are_where_algebra_puts_them)
{
    /* y = x^2 from -1 to 1 in two chords: the vertex, by symmetry, sqrt 2 each. */
    const double p[] = {-1, 1, 0, -1, 1, 1}, breaks[] = {0, 1};
    batten_curve *curve = NULL;
    double u[3], chord;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){2, 1, breaks}, p, NULL, &curve));
    CHECK_OK(batten_curve_divide_equal_chords(curve, 2, 1e-12, &chord, u));
    CHECK_NEAR(u[1], 0.5, 1e-12);
    CHECK_NEAR(chord, sqrt(2), 1e-12);
    CHECK_OK(batten_curve_divide_equal_chords(curve, 1, 1e-12, &chord, u));
    CHECK_NEAR(chord, 2, 1e-12);
    batten_curve_unref(curve);
}

TEST(chords_of_random_curves_are_equal)
{
    test_random random = test_random_begin("equal");
    const double knots[12] = {0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5};
    for (int n = test_cases(20); n > 0; n--) {
        double points[24], u[41], chord;
        batten_curve *curve = NULL;
        const int count = test_random_int(&random, 2, 40);
        for (int i = 0; i < 24; i++)
            points[i] = (i % 3 == 0 ? i / 3 : 0) + test_random_in(&random, -0.5, 0.5);
        CHECK_OK(batten_curve_create((batten_points){3, 8, points}, 3, NULL, knots, &curve));
        CHECK_OK(batten_curve_divide_equal_chords(curve, count, 1e-10, &chord, u));
        CHECK(u[0] == 0 && u[count] == 5);
        for (int i = 0; i < count; i++)
            CHECK(u[i] < u[i + 1]);
        CHECK(spread(curve, count, u) <= 1e-9);
        batten_curve_unref(curve);
    }
}

TEST(N6_G3_chords_that_cannot_be_are_refused)
{
    const double p[] = {1, 2, 1, 2, 3, 4};
    batten_curve *point = NULL, *line = NULL, *circle = NULL;
    double u[4], chord;
    CHECK_OK(batten_curve_line(2, p, p + 2, &point));
    CHECK_OK(batten_curve_line(2, p, p + 4, &line));
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &circle));
    CHECK_STATUS(batten_curve_divide_equal_chords(point, 3, 1e-9, &chord, u),
                 BATTEN_COINCIDENT);
    CHECK_STATUS(batten_curve_divide_equal_chords(line, 0, 1e-9, &chord, u),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_divide_equal_chords(line, 3, 0, &chord, u), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_divide_equal_chords(circle, 2, 1e-9, &chord, u),
                 BATTEN_BAD_ARGUMENT);
    CHECK_OK(batten_curve_divide_equal_chords(line, 3, 1e-12, NULL, u));
    CHECK_NEAR(u[1], 1 / 3.0, 1e-12);
    batten_curve_unref(circle);
    batten_curve_unref(line);
    batten_curve_unref(point);
}
