#include <batten/local.h>

#include "support/test.h"

static double value(const batten_curve *curve, double u, int order)
{
    double out[3];
    CHECK_OK(batten_curve_evaluate(curve, u, order, out));
    return out[order];
}

static void check_passes(const batten_curve *curve, int count, const double *x, const double *y,
                         const double *slopes)
{
    for (int i = 0; i < count; i++) {
        const double size = fabs(y[i]) + 1;
        CHECK_NEAR(value(curve, x[i], 0), y[i], 1e-13 * size);
        for (int side = 0; side < 2; side++) {
            double out[2];
            CHECK_OK(batten_curve_evaluate_side(
                curve, x[i], side ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 1, out));
            CHECK_NEAR(out[1], slopes[i], 1e-6 * (1 + fabs(slopes[i])));
        }
    }
}

/* Slopes of a quadratic spline are linear between knots: those at the knots tell all. */
static void check_shape(const batten_curve *curve, int count, const double *x, const double *y,
                        bool convex)
{
    double knots[64];
    const int spans = batten_curve_spans(curve, knots) - 1;
    for (int i = 0, k = 0; i <= spans; i++) {
        while (k + 2 < count && knots[i] >= x[k + 1])
            k++;
        const double slope = value(curve, knots[i], 1), rise = y[k + 1] - y[k];
        CHECK(slope * (rise > 0 ? 1 : rise < 0 ? -1 : 0) >= -1e-6);
        if (convex && i > 0)
            CHECK(slope >= value(curve, knots[i - 1], 1) - 1e-6);
    }
}

TEST(schumakers_quadratics_are_monotone_where_the_data_are)
{
    test_random random = test_random_begin("schumaker");
    for (int c = 0; c < test_cases(2000); c++) {
        const int count = test_random_int(&random, 2, 12);
        double x[12] = {0}, y[12] = {0}, slopes[12];
        for (int i = 1; i < count; i++) {
            const int kind = test_random_int(&random, 0, 4);
            x[i] = x[i - 1] + test_random_in(&random, 0.1, 1);
            y[i] = y[i - 1] + (kind == 0 ? 0 : kind * test_random_in(&random, -1, 1));
        }
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_schumaker(count, x, y, slopes, &curve));
        CHECK(batten_curve_spans(curve, NULL) - 1 <= 2 * (count - 1));
        check_passes(curve, count, x, y, slopes);
        check_shape(curve, count, x, y, false);
        batten_curve_unref(curve);
    }
}

TEST(schumakers_quadratics_are_convex_where_the_data_are)
{
    test_random random = test_random_begin("schumaker convex");
    for (int c = 0; c < test_cases(2000); c++) {
        const int count = test_random_int(&random, 3, 12);
        const int line = c % 3 == 0 ? test_random_int(&random, 1, count - 1) : 0;
        double x[12] = {0}, y[12] = {0}, slopes[12];
        double slope = test_random_in(&random, line ? 0.1 : -3, 3);
        for (int i = 1; i < count; i++) {
            const double step = 0.25 * test_random_int(&random, 1, 8);
            if (i != line)
                slope += ldexp(1, test_random_int(&random, -12, 2));
            x[i] = x[i - 1] + step;
            y[i] = y[i - 1] + slope * step;
        }
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_schumaker(count, x, y, slopes, &curve));
        check_passes(curve, count, x, y, slopes);
        check_shape(curve, count, x, y, true);
        batten_curve_unref(curve);
    }
}

TEST(parabolas_with_even_steps_need_no_more_knots)
{
    const double x[] = {0, 1, 2, 3}, y[] = {0, 0.5, 1, 1.5};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_schumaker(4, x, y, NULL, &curve));
    CHECK_INT(batten_curve_spans(curve, NULL), 4);
    for (int i = 0; i <= 30; i++)
        CHECK_NEAR(value(curve, i / 10.0, 0), i / 20.0, 1e-15);
    batten_curve_unref(curve);
    CHECK_OK(batten_curve_schumaker(2, x, y, NULL, &curve));
    CHECK_NEAR(value(curve, 0.5, 0), 0.25, 0);
    batten_curve_unref(curve);
    CHECK_STATUS(batten_curve_schumaker(1, x, y, NULL, &curve), BATTEN_TOO_FEW_POINTS);
}

TEST(k3_abscissae_that_do_not_rise_are_named_by_schumaker)
{
    const double x[] = {0, 2, 1}, y[] = {0, 1, 2};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_schumaker(3, x, y, NULL, &curve), BATTEN_NOT_INCREASING);
    CHECK(curve == NULL);
}
