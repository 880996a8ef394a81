#include "spline/chain/chain.h"

#include "support/test.h"

/* The definition, in long double. */
static long double shape(int order, long double z, long double x)
{
    if (z == 0)
        return order == 0   ? (x * x * x - x) / 6
               : order == 1 ? (3 * x * x - 1) / 6
               : order == 2 ? x
                            : 1;
    const long double s = sinhl(z * x) / sinhl(z), c = coshl(z * x) / sinhl(z);
    return order == 0   ? (s - x) / (z * z)
           : order == 1 ? (z * c - 1) / (z * z)
           : order == 2 ? s
                        : z * c;
}

TEST(the_shape_of_a_span_in_tension_is_that_of_the_hyperbolic_functions)
{
    const double tensions[] = {0, 0.3, 0.999999999, 1, 1.000001, 2, 7, 50, 400};
    for (int i = 0; i < COUNT(tensions); i++)
        for (int j = 0; j <= 64; j++) {
            double out[4];
            bat_tension_shape(tensions[i], j / 64.0, 1 - j / 64.0, out);
            for (int k = 0; k < 4; k++) {
                const double wanted = (double)shape(k, tensions[i], j / 64.0);
                /* e^-z (1 - x) has a relative error of z eps */
                CHECK_NEAR(out[k], wanted,
                           (8 + tensions[i]) * DBL_EPSILON * (k == 3 ? fabs(wanted) : 1));
            }
        }
}

TEST(a_small_tension_joins_the_cubic_without_a_step)
{
    for (double z = 1e-160; z < 0.5; z *= 10) {
        double out[4];
        bat_tension_shape(z, 0.25, 0.75, out);
        for (int k = 0; k < 4; k++) /* the difference is of order z^2 */
            CHECK_NEAR(out[k], (double)shape(k, 0, 0.25), z * z + 4 * DBL_EPSILON);
    }
}

static batten_span span(double tension)
{
    return (batten_span){.kind = BATTEN_SPAN_TENSION,
                         .length = 2,
                         .start = {1, -1, 5},
                         .end = {4, 0, 5},
                         .bend = {{3, -7, 0}, {-2, 1, 0}},
                         .tension = tension};
}

TEST(a_span_in_tension_has_its_ends_and_obeys_its_equation)
{
    const double tensions[] = {0, 1e-3, 0.2, 1, 3, 30, 349, 351, 1e4, 1e150, 1e300};
    for (int i = 0; i < COUNT(tensions); i++) {
        const double sigma = tensions[i];
        const batten_span s = span(sigma);
        double a[12], b[12];
        bat_span_tension(3, &s, 0, 3, a);
        bat_span_tension(3, &s, 2, 3, b);
        for (int k = 0; k < 3; k++) {
            CHECK_BITS(a[k], s.start[k]);
            CHECK_BITS(b[k], s.end[k]);
            CHECK_NEAR(a[6 + k], s.bend[0][k], 1e-14);
            CHECK_NEAR(b[6 + k], s.bend[1][k], 1e-14);
            /* P'' - sigma^2 P is linear, so P''' - sigma^2 P' is the same at both ends. */
            if (sigma < 1e100)
                CHECK_NEAR(a[9 + k] - sigma * sigma * a[3 + k],
                           b[9 + k] - sigma * sigma * b[3 + k],
                           1e-13 * (1 + 10 * sigma * sigma));
        }
    }
}

TEST(a_span_of_very_high_tension_is_a_line)
{
    const double tensions[] = {1e3, 1e8, 1e200, 1e307};
    for (int i = 0; i < COUNT(tensions); i++) {
        const batten_span s = span(tensions[i]);
        for (int j = 0; j <= 50; j++) {
            double p[12];
            bat_span_tension(3, &s, 2 * j / 50.0, 2, p);
            CHECK_NEAR(p[0], 1 + 3 * j / 50.0, 4e-6);
            CHECK_NEAR(p[1], -1 + j / 50.0, 8e-6);
            CHECK(isfinite(p[6]));
        }
    }
}

TEST(derivatives_of_a_span_in_tension_are_those_of_its_points)
{
    const double tensions[] = {0, 0.4, 2, 9};
    const double e = 1e-3;
    for (int i = 0; i < COUNT(tensions); i++)
        for (int j = 1; j < 20; j++) {
            const batten_span s = span(tensions[i]);
            double p[12], before[9], after[9];
            bat_span_tension(3, &s, j / 10.0, 3, p);
            bat_span_tension(3, &s, j / 10.0 - e, 2, before);
            bat_span_tension(3, &s, j / 10.0 + e, 2, after);
            for (int k = 0; k < 9; k++) /* the error is e^2 / 6 times two derivatives more */
                CHECK_NEAR((after[k] - before[k]) / (2 * e), p[3 + k], 2e-3);
        }
}
