#include <batten/interpolate.h>

#include "support/test.h"

enum { MOST = 12 };

static batten_curve *spline_of(int count, const double *x, const double *y,
                               const batten_end *start, const batten_end *end)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    batten_curve *curve = NULL;
    options.parameters = BATTEN_GIVEN;
    options.given = x;
    options.start = *start;
    options.end = *end;
    CHECK_OK(batten_curve_interpolate((batten_points){1, count, y}, &options, NULL, &curve));
    return curve;
}

/* The least second derivative at the points, times `sign`, against the largest. */
static double least_bend(int count, const double *x, const batten_curve *curve, int sign)
{
    double least = HUGE_VAL, size = 0;
    for (int i = 0; i < count; i++) {
        double out[3];
        CHECK_OK(batten_curve_evaluate(curve, x[i], 2, out));
        least = fmin(least, sign * out[2]);
        size = fmax(size, fabs(out[2]));
    }
    return size > 0 ? least / size : 0;
}

static void convex_data(test_random *random, int count, double *x, double *y)
{
    double slope = test_random_in(random, -2, 0);
    x[0] = y[0] = 0;
    for (int i = 1; i < count; i++) {
        const double step = test_random_in(random, 0.5, 1.5);
        slope += test_random_in(random, 0, 1);
        x[i] = x[i - 1] + step;
        y[i] = y[i - 1] + slope * step;
    }
}

/* Kinds of ends with their vectors: curved the right way. */
static batten_end end_of(int kind, double slope, double out)
{
    switch (kind) {
    case 0:
        return (batten_end){.kind = BATTEN_END_NATURAL};
    case 1:
        return (batten_end){.kind = BATTEN_END_SECOND, .vector = {0.5}};
    case 2:
        return (batten_end){.kind = BATTEN_END_CLAMPED, .vector = {slope + out}};
    case 3:
        return (batten_end){.kind = BATTEN_END_BESSEL};
    default:
        return (batten_end){.kind = BATTEN_END_PARABOLIC};
    }
}

TEST(splines_that_are_promised_convex_are_convex)
{
    test_random random = test_random_begin("convexity");
    int promised = 0, swinging = 0;
    const int cases = test_cases(4000);
    for (int c = 0; c < cases; c++) {
        const int n = test_random_int(&random, 2, MOST);
        double x[MOST], y[MOST];
        batten_convexity found;
        convex_data(&random, n, x, y);
        const double first = (y[1] - y[0]) / (x[1] - x[0]);
        const double last = (y[n - 1] - y[n - 2]) / (x[n - 1] - x[n - 2]);
        const batten_end start =
            end_of(test_random_int(&random, 0, 4), first, -test_random_in(&random, 0, 1));
        const batten_end end =
            end_of(test_random_int(&random, 0, 4), last, test_random_in(&random, 0, 1));
        for (int sign = 1; sign >= -1; sign -= 2) {
            double mirrored[MOST];
            batten_end ends[2] = {start, end};
            for (int i = 0; i < n; i++)
                mirrored[i] = sign * y[i];
            for (int e = 0; e < 2; e++)
                ends[e].vector[0] *= sign;
            CHECK_OK(batten_spline_convexity(n, x, mirrored, &ends[0], &ends[1], &found));
            CHECK_INT(found.points, n == 2 ? 1 : sign);
            CHECK(found.promised == (found.at < 0));
            batten_curve *curve = spline_of(n, x, mirrored, &ends[0], &ends[1]);
            const double bend = least_bend(n, x, curve, n == 2 ? 1 : sign);
            if (found.promised)
                CHECK(bend >= -1e-13);
            promised += found.promised;
            swinging += bend < -0.01;
            batten_curve_unref(curve);
        }
    }
    if (cases >= 4000)
        CHECK(promised > 500 && swinging > 500);
}

/* Convex points, whose sudden turn makes the spline swing before it. */
TEST(a_point_that_stands_out_is_named)
{
    const double x[] = {0, 1, 2, 3, 4, 5, 6}, y[] = {0, 0, 0, 0.2, 3, 10, 30};
    const batten_end natural = {.kind = BATTEN_END_NATURAL};
    batten_convexity found;
    CHECK_OK(batten_spline_convexity(7, x, y, NULL, NULL, &found));
    CHECK_INT(found.points, 1);
    CHECK(!found.promised);
    CHECK_INT(found.at, 1);
    batten_curve *curve = spline_of(7, x, y, &natural, &natural);
    CHECK(least_bend(7, x, curve, 1) < -0.01);
    batten_curve_unref(curve);
}

TEST(points_of_a_parabola_are_promised_with_its_slopes_and_wavy_ones_not)
{
    double x[MOST], y[MOST], line[MOST], wave[MOST];
    batten_convexity found;
    for (int i = 0; i < MOST; i++) {
        x[i] = 0.3 * i;
        y[i] = x[i] * x[i];
        line[i] = 0.7 * x[i] + 0.1;
        wave[i] = i % 2;
    }
    const batten_end start = {.kind = BATTEN_END_CLAMPED, .vector = {0}};
    const batten_end end = {.kind = BATTEN_END_CLAMPED, .vector = {2 * x[MOST - 1]}};
    CHECK_OK(batten_spline_convexity(MOST, x, y, &start, &end, &found));
    CHECK(found.points == 1 && found.promised);
    CHECK_OK(batten_spline_convexity(MOST, x, line, NULL, NULL, &found));
    CHECK(found.points == 1 && found.promised);
    CHECK_OK(batten_spline_convexity(MOST, x, wave, NULL, NULL, &found));
    CHECK(found.points == 0 && !found.promised && found.at == -1);
}

TEST(n1_s1_bad_points_and_other_ends_are_refused)
{
    const double x[] = {0, 1, 2}, twice[] = {0, 1, 1}, y[] = {0, NAN, 1}, good[] = {0, 0, 1};
    const batten_end ends[] = {{.kind = BATTEN_END_NOT_A_KNOT}, {.kind = BATTEN_END_FAIR}};
    batten_convexity found = {.at = 7};
    CHECK_STATUS(batten_spline_convexity(3, x, y, NULL, NULL, &found), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_spline_convexity(3, twice, good, NULL, NULL, &found),
                 BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_spline_convexity(1, x, good, NULL, NULL, &found),
                 BATTEN_TOO_FEW_POINTS);
    for (int i = 0; i < COUNT(ends); i++)
        CHECK_STATUS(batten_spline_convexity(3, x, good, &ends[i], NULL, &found),
                     BATTEN_BAD_ARGUMENT);
    CHECK_INT(found.at, 7);
}
