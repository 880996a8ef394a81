#include <batten/local.h>

#include "support/test.h"

/* The function by its formula, in t = (u - x0) / h. */
static double formula(double h, double y0, double y1, double m0, double m1, double t)
{
    const double d = (y1 - y0) / h, s = 1 - t;
    if (d == 0)
        return y0;
    return (y0 * s * s + (m0 * y1 + m1 * y0) / d * t * s + y1 * t * t) /
           (s * s + (m0 + m1) / d * t * s + t * t);
}

TEST(the_rational_graph_is_the_formula_and_monotone)
{
    test_random random = test_random_begin("rational");
    for (int c = 0; c < test_cases(500); c++) {
        const int count = test_random_int(&random, 2, 10);
        double x[10] = {1}, y[10] = {2}, slopes[10];
        for (int i = 1; i < count; i++) {
            x[i] = x[i - 1] + test_random_in(&random, 0.1, 1);
            y[i] = y[i - 1] + (c % 4 ? test_random_in(&random, 0, 2) : i % 2);
        }
        CHECK_OK(batten_slopes(count, x, y, BATTEN_SLOPE_FRITSCH_BUTLAND, slopes));
        if (c % 2)
            for (int i = 0; i < count; i++)
                slopes[i] *= test_random_in(&random, 0, 30); /* a cubic would not be monotone */
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_rational_monotone(count, x, y, c % 2 ? slopes : NULL, &curve));
        double last = -HUGE_VAL;
        for (int i = 0; i + 1 < count; i++)
            for (int k = 0; k <= 20; k++) {
                const double h = x[i + 1] - x[i];
                const double u = k == 20 ? x[i + 1] : x[i] + h * k / 20;
                double out[4];
                CHECK_OK(batten_curve_evaluate(curve, u, 1, out));
                CHECK_NEAR(out[0], u, 1e-14 * 10);
                CHECK_NEAR(out[1],
                           formula(h, y[i], y[i + 1], slopes[i], slopes[i + 1], (u - x[i]) / h),
                           1e-13 * 20);
                CHECK(out[1] >= last - 1e-13);
                last = out[1];
                if (k == 0) {
                    CHECK_NEAR(out[2], 1, 1e-11);
                    CHECK_NEAR(out[3], slopes[i], 1e-9 * (1 + slopes[i]));
                }
            }
        batten_curve_unref(curve);
    }
}

TEST(slopes_against_the_chord_are_refused_and_named)
{
    const double x[] = {0, 1, 2}, y[] = {0, 1, 1}, wrong[] = {1, -1, 0}, flat[] = {1, 0, 1};
    const double bad[] = {1, NAN, 0}, good[] = {1, 0, 0};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_rational_monotone(3, x, y, wrong, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("span 1");
    CHECK_STATUS(batten_curve_rational_monotone(3, x, y, flat, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("span 2");
    CHECK_STATUS(batten_curve_rational_monotone(3, x, y, bad, &curve), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_rational_monotone(1, x, y, NULL, &curve), BATTEN_TOO_FEW_POINTS);
    CHECK(curve == NULL);
    CHECK_OK(batten_curve_rational_monotone(3, x, y, good, &curve));
    batten_curve_unref(curve);
}
