#include <batten/local.h>
#include <stdlib.h>

#include "support/test.h"

enum { MOST = 64 };

static batten_curve *function_of(int count, const double *x, const double *y,
                                 batten_slope_rule rule, double *slopes)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_slopes(count, x, y, rule, slopes));
    CHECK_OK(batten_curve_from_tangents((batten_points){1, count, y}, x, slopes, NULL, false,
                                        &curve));
    return curve;
}

static double value(const batten_curve *curve, double u, int order)
{
    double out[3];
    CHECK_OK(batten_curve_evaluate(curve, u, order, out));
    return out[order];
}

static void random_data(test_random *random, int count, double *x, double *y, bool rising)
{
    x[0] = test_random_in(random, -1, 1);
    y[0] = test_random_in(random, -1, 1);
    for (int i = 1; i < count; i++) {
        const double step = test_random_in(random, 0.01, 1);
        const int kind = test_random_int(random, 0, 5);
        const double rise = kind == 0 ? 0 : kind == 1 ? 20 : kind == 2 ? 0.01 : 1;
        x[i] = x[i - 1] + step;
        y[i] = y[i - 1] + rise * test_random_in(random, rising ? 0 : -1, 1);
    }
}

/* ---- what each rule is exact for ---- */

TEST(bessel_slopes_are_exact_for_parabolas)
{
    const double x[] = {-1, 0, 0.25, 2, 5};
    double y[5], slopes[5];
    for (int i = 0; i < 5; i++)
        y[i] = x[i] * x[i] - 3 * x[i];
    for (int count = 3; count <= 5; count++) {
        CHECK_OK(batten_slopes(count, x, y, BATTEN_SLOPE_BESSEL, slopes));
        for (int i = 0; i < count; i++)
            CHECK_NEAR(slopes[i], 2 * x[i] - 3, 1e-14 * 8);
    }
}

TEST(two_points_have_the_slope_of_their_chord_and_three_in_line_too)
{
    const double x[] = {0.1, 0.2, 0.7}, y[] = {0.3, 0.6, 2.1};
    for (int r = 0; r <= BATTEN_SLOPE_MAKIMA; r++)
        for (int count = 2; count <= 3; count++) {
            double slopes[3];
            CHECK_OK(batten_slopes(count, x, y, (batten_slope_rule)r, slopes));
            for (int i = 0; i < count; i++)
                CHECK_NEAR(slopes[i], 3, 1e-14);
        }
}

TEST(akima_keeps_straight_runs_in_spite_of_rounding)
{
    double x[12], y[12], slopes[12];
    for (int i = 0; i < 12; i++) {
        x[i] = 0.1 * i;
        y[i] = i < 6 ? 0.7 * i : 0.7 * 6 + 0.2 * (i - 6);
    }
    CHECK_OK(batten_slopes(12, x, y, BATTEN_SLOPE_AKIMA, slopes));
    for (int i = 0; i < 12; i++)
        CHECK_NEAR(slopes[i], i < 6 ? 7 : i > 6 ? 2 : 4.5, 1e-12);
}

/* The step from -1 over 0 to 1: Akima's weights vanish beside the level runs, where the mean of
 * both chords then overshoots; the modified ones keep the runs level. */
TEST(modified_akima_keeps_level_runs_level)
{
    const double x[] = {-3, -2, -1, 0, 1, 2, 3}, y[] = {-1, -1, -1, 0, 1, 1, 1};
    const double modified[] = {0, 0, 0, 1, 0, 0, 0}, plain[] = {0, 0, 0.5, 1, 0.5, 0, 0};
    double slopes[7];
    CHECK_OK(batten_slopes(7, x, y, BATTEN_SLOPE_MAKIMA, slopes));
    for (int i = 0; i < 7; i++)
        CHECK_NEAR(slopes[i], modified[i], 1e-15);
    CHECK_OK(batten_slopes(7, x, y, BATTEN_SLOPE_AKIMA, slopes));
    for (int i = 0; i < 7; i++)
        CHECK_NEAR(slopes[i], plain[i], 1e-15);
}

TEST(modified_akima_weighs_changes_and_means)
{
    test_random random = test_random_begin("makima");
    for (int c = 0; c < test_cases(200); c++) {
        double x[8], y[8], slopes[8], d[11];
        random_data(&random, 8, x, y, false);
        for (int i = 0; i < 7; i++)
            d[i + 2] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
        d[1] = 2 * d[2] - d[3], d[0] = 2 * d[1] - d[2];
        d[9] = 2 * d[8] - d[7], d[10] = 2 * d[9] - d[8];
        CHECK_OK(batten_slopes(8, x, y, BATTEN_SLOPE_MAKIMA, slopes));
        for (int i = 0; i < 8; i++) {
            const double after = fabs(d[i + 3] - d[i + 2]) + fabs(d[i + 3] + d[i + 2]) / 2;
            const double before = fabs(d[i + 1] - d[i]) + fabs(d[i + 1] + d[i]) / 2;
            const double expected =
                after + before == 0 ? 0
                                    : (after * d[i + 1] + before * d[i + 2]) / (after + before);
            CHECK_NEAR(slopes[i], expected, 1e-12 * (1 + fabs(d[i + 1]) + fabs(d[i + 2])));
        }
    }
}

/* ---- monotone rules ---- */

/* The slope of the span at 63 places inside has the sign of the chord. */
static void check_monotone(const double *x, const double *y, const double *slopes, int i)
{
    const double h = x[i + 1] - x[i], d = (y[i + 1] - y[i]) / h;
    const double a = slopes[i], b = slopes[i + 1], middle = 3 * d - a - b;
    const double noise = 1e-12 * (fabs(a) + fabs(b) + fabs(d));
    const double sign = d < 0 ? -1 : 1;
    CHECK(sign * a >= 0 && sign * b >= 0);
    double least = fmin(sign * a, sign * b);
    for (int k = 1; k < 64; k++) {
        const double t = k / 64.0, s = 1 - t;
        least = fmin(least, sign * (a * s * s + 2 * middle * t * s + b * t * t));
    }
    CHECK(least >= -noise);
    if (d == 0)
        CHECK(a == 0 && b == 0);
}

TEST(monotone_rules_make_no_extrema_in_5000_cases)
{
    test_random random = test_random_begin("monotone");
    const batten_slope_rule rules[] = {BATTEN_SLOPE_FRITSCH_CARLSON,
                                       BATTEN_SLOPE_FRITSCH_BUTLAND, BATTEN_SLOPE_STEFFEN};
    for (int c = 0; c < test_cases(5000); c++) {
        const int count = test_random_int(&random, 2, 12);
        double x[12], y[12], slopes[12];
        random_data(&random, count, x, y, c % 2);
        for (int r = 0; r < COUNT(rules); r++) {
            CHECK_OK(batten_slopes(count, x, y, rules[r], slopes));
            for (int i = 0; i + 1 < count; i++)
                check_monotone(x, y, slopes, i);
            for (int i = 1; i + 1 < count; i++)
                if ((y[i + 1] - y[i]) * (y[i] - y[i - 1]) <= 0)
                    CHECK_NEAR(slopes[i], 0, 0);
        }
    }
}

/* The region where a cubic is monotone, as the authors give it. */
TEST(the_monotone_region_of_fritsch_and_carlson_is_that_of_the_derivative)
{
    test_random random = test_random_begin("region");
    for (int c = 0; c < test_cases(5000); c++) {
        const double a = test_random_in(&random, 0, 5), b = test_random_in(&random, 0, 5);
        const double form = a * a + a * b + b * b - 6 * a - 6 * b + 9;
        const bool region = (a <= 3 && b <= 3) || form <= 0;
        /* The derivative a s^2 + 2 (3 - a - b) s t + b t^2 is never negative. */
        const double middle = 3 - a - b;
        const bool monotone = middle >= 0 || middle * middle <= a * b;
        if (fabs(form) > 1e-9 && fabs(fmax(a, b) - 3) > 1e-9 && fabs(middle) > 1e-9)
            CHECK(region == monotone);
    }
}

TEST(g10_reversed_data_have_the_slopes_with_the_other_sign)
{
    test_random random = test_random_begin("reversed slopes");
    for (int c = 0; c < test_cases(500); c++) {
        const int count = test_random_int(&random, 2, 12);
        double x[12], y[12], there[12], back[12], rx[12], ry[12];
        random_data(&random, count, x, y, c % 2);
        for (int i = 0; i < count; i++) {
            rx[i] = -x[count - 1 - i];
            ry[i] = y[count - 1 - i];
        }
        for (int r = 0; r <= BATTEN_SLOPE_MAKIMA; r++) {
            CHECK_OK(batten_slopes(count, x, y, (batten_slope_rule)r, there));
            CHECK_OK(batten_slopes(count, rx, ry, (batten_slope_rule)r, back));
            for (int i = 0; i < count; i++)
                CHECK_NEAR(back[count - 1 - i], -there[i], 1e-11 * (1 + fabs(there[i])));
        }
    }
}

TEST(k3_abscissae_that_do_not_rise_are_named_by_slopes)
{
    const double x[] = {0, 1, 1, 2}, y[] = {0, 1, 2, 3}, bad[] = {0, 1, NAN, 3};
    const double good[] = {0, 1, 2, 3}, near[] = {0, 1e-300, 1, 2}, far[] = {0, 1e300, 1, 2};
    double slopes[4] = {7};
    CHECK_STATUS(batten_slopes(4, x, y, BATTEN_SLOPE_AKIMA, slopes), BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("parameter 3");
    CHECK_STATUS(batten_slopes(4, good, bad, BATTEN_SLOPE_AKIMA, slopes), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_slopes(1, x, y, BATTEN_SLOPE_AKIMA, slopes), BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_slopes(4, good, y, (batten_slope_rule)17, slopes), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_slopes(4, near, far, BATTEN_SLOPE_AKIMA, slopes), BATTEN_OVERFLOW);
    CHECK_MESSAGE("points 1 and 2");
    CHECK_NEAR(slopes[0], 7, 0);
}

/* ---- published data and other programs ---- */

static char *text_of(const char *path)
{
    FILE *file = fopen(test_data(path), "rb");
    CHECK(file != NULL);
    char *text = test_array(1 << 18, 1);
    const size_t got = fread(text, 1, (1 << 18) - 1, file);
    fclose(file);
    text[got] = 0;
    return text;
}

/* The numbers of the list `key` in the object `name` of a JSON text. */
static int list_of(const char *text, const char *name, const char *key, double *out)
{
    char quoted[64];
    snprintf(quoted, sizeof quoted, "\"%s\":", name);
    const char *at = strstr(text, quoted);
    CHECK(at != NULL);
    snprintf(quoted, sizeof quoted, "\"%s\":", key);
    at = strstr(at, quoted);
    CHECK(at != NULL);
    at = strchr(at, '[') + 1;
    int count = 0;
    for (char *end; count < MOST; at = end + strspn(end, " ,\n")) {
        out[count] = strtod(at, &end);
        if (end == at)
            break;
        count++;
    }
    return count;
}

static int csv_of(const char *path, double *x, double *y)
{
    const char *line = text_of(path);
    int count = 0;
    while ((line = strchr(line, '\n')) &&
           sscanf(line + 1, "%lf,%lf", &x[count], &y[count]) == 2) {
        line++;
        count++;
    }
    return count;
}

/* Values at the places of the data set in the text, against those of scipy. The only
 * difference of rules is at a point between two straight runs, where Akima's weights are both
 * 0: both take the mean there. */
static void check_scipy(const char *name, const char *key, batten_slope_rule rule)
{
    char path[64];
    double x[MOST], y[MOST], at[MOST], expected[MOST], slopes[MOST], size = 1;
    snprintf(path, sizeof path, "spline_data/%s.csv", name);
    const int count = csv_of(path, x, y);
    const char *text = text_of("peer_tests/scipy_interpolation.json");
    const int places = list_of(text, name, "x", at);
    CHECK_INT(list_of(text, name, key, expected), places);
    for (int i = 0; i < count; i++)
        size = fmax(size, fabs(y[i]));
    batten_curve *curve = function_of(count, x, y, rule, slopes);
    for (int i = 0; i < places; i++)
        CHECK_NEAR(value(curve, at[i], 0), expected[i], 1e-13 * size);
    batten_curve_unref(curve);
}

TEST(scipys_akima_and_pchip_are_reproduced)
{
    const char *const sets[] = {"akima1970", "akima_uneven2", "rpn14", "titanium12"};
    for (int s = 0; s < COUNT(sets); s++) {
        check_scipy(sets[s], "akima", BATTEN_SLOPE_AKIMA);
        check_scipy(sets[s], "pchip", BATTEN_SLOPE_FRITSCH_BUTLAND);
    }
}

/* GSL's own tests of both have straight data only, where the ends (it takes the slope of the
 * first chord for Steffen's, we his parabola) make no difference. */
TEST(gsls_akima_and_steffen_tests_are_reproduced)
{
    const char *text = text_of("peer_tests/gsl_interpolation.json");
    const char *const names[] = {"akima", "steffen1"};
    const batten_slope_rule rules[] = {BATTEN_SLOPE_AKIMA, BATTEN_SLOPE_STEFFEN};
    for (int s = 0; s < 2; s++) {
        double x[MOST], y[MOST], at[MOST], values[MOST], slopes_at[MOST], slopes[MOST];
        const int count = list_of(text, names[s], "data_x", x);
        CHECK_INT(list_of(text, names[s], "data_y", y), count);
        const int places = list_of(text, names[s], "test_x", at);
        list_of(text, names[s], "test_y", values);
        list_of(text, names[s], "test_dy", slopes_at);
        batten_curve *curve = function_of(count, x, y, rules[s], slopes);
        for (int i = 0; i < places; i++) {
            CHECK_NEAR(value(curve, at[i], 0), values[i], 1e-14);
            CHECK_NEAR(value(curve, at[i], 1), slopes_at[i], 1e-14);
        }
        batten_curve_unref(curve);
    }
}

/* Between the points of Akima's paper the curve never falls below 10, and never falls. */
TEST(akimas_data_do_not_swing_with_local_rules)
{
    double x[MOST], y[MOST], slopes[MOST];
    const char *const sets[] = {"spline_data/akima1970.csv", "spline_data/akima_uneven1.csv",
                                "spline_data/akima_uneven2.csv", "spline_data/rpn14.csv"};
    for (int s = 0; s < COUNT(sets); s++) {
        const int count = csv_of(sets[s], x, y);
        for (int r = BATTEN_SLOPE_AKIMA; r <= BATTEN_SLOPE_STEFFEN; r++) {
            if (s > 0 && r == BATTEN_SLOPE_AKIMA)
                continue; /* promises nothing on uneven data */
            batten_curve *curve = function_of(count, x, y, (batten_slope_rule)r, slopes);
            double before = y[0];
            for (int i = 0; i <= 1000; i++) {
                const double now = value(curve, x[0] + (x[count - 1] - x[0]) * i / 1000, 0);
                CHECK(now >= before - 1e-14 * fabs(before));
                before = now;
            }
            batten_curve_unref(curve);
        }
    }
}
