/* Interpolants of other programs: scipy and FITPACK, GSL, pySpline. */
#include <batten/interpolate.h>
#include <batten/local.h>
#include <batten/nearest.h>

#include "shape/published.h"
#include "support/json.h"

enum { MOST = 128 };

static double value(const batten_curve *curve, double u, int order)
{
    double out[8];
    CHECK_OK(batten_curve_evaluate(curve, u, order, out));
    return out[order];
}

static batten_curve *spline_of(int degree, bool knots_at_data, batten_end_kind ends, int count,
                               const double *x, const double *y)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    batten_curve *curve = NULL;
    options.degree = degree;
    options.knots_at_data = knots_at_data;
    options.parameters = BATTEN_GIVEN;
    options.given = x;
    options.start.kind = options.end.kind = ends;
    CHECK_OK(batten_curve_interpolate((batten_points){1, count, y}, &options, NULL, &curve));
    return curve;
}

static double largest(int count, const double *values)
{
    double size = 0;
    for (int i = 0; i < count; i++)
        size = fmax(size, fabs(values[i]));
    return size;
}

static int data_of(const char *name, double *x, double *y)
{
    char path[64];
    double table[2 * MOST];
    snprintf(path, sizeof path, "spline_data/%s.csv", name);
    const int count = published_table(path, 2, MOST, table);
    for (int i = 0; i < count; i++)
        x[i] = table[2 * i], y[i] = table[2 * i + 1];
    return count;
}

/* ---- scipy ---- */

static const char *const sets[] = {"akima1970", "akima_uneven2", "rpn14", "titanium12"};

TEST(scipys_cubic_splines_with_three_kinds_of_ends_are_reproduced)
{
    static const char *const keys[] = {"cubic_not_a_knot", "cubic_natural",
                                       "cubic_clamped_zero"};
    const batten_end_kind ends[] = {BATTEN_END_NOT_A_KNOT, BATTEN_END_NATURAL,
                                    BATTEN_END_CLAMPED};
    const char *data = json_key(json_file("peer_tests/scipy_interpolation.json"), "data");
    for (int s = 0; s < COUNT(sets); s++) {
        double x[MOST], y[MOST], at[MOST], expected[MOST];
        const int count = data_of(sets[s], x, y);
        const char *set = json_key(data, sets[s]);
        const int places = json_numbers(json_key(set, "x"), MOST, at);
        for (int k = 0; k < COUNT(keys); k++) {
            CHECK_INT(json_numbers(json_key(set, keys[k]), MOST, expected), places);
            batten_curve *curve = spline_of(3, true, ends[k], count, x, y);
            for (int i = 0; i < places; i++)
                CHECK_NEAR(value(curve, at[i], 0), expected[i],
                           1e-13 * largest(places, expected));
            batten_curve_unref(curve);
        }
    }
}

/* FITPACK leaves out as many knots beside the ends as end conditions are missing: so do we. The
 * coefficients of degree 5 on the uneven sets reach 1e3 times the data, hence the bound. */
TEST(fitpacks_knots_and_coefficients_are_ours)
{
    static const char *const keys[] = {"fitpack_k3_s0", "fitpack_k5_s0"};
    const char *data = json_key(json_file("peer_tests/scipy_interpolation.json"), "data");
    for (int s = 0; s < COUNT(sets); s++)
        for (int k = 0; k < COUNT(keys); k++) {
            double x[MOST], y[MOST], knots[MOST], coefficients[MOST];
            const int count = data_of(sets[s], x, y), degree = 3 + 2 * k;
            const char *spline = json_key(json_key(data, sets[s]), keys[k]);
            const int knot_count = json_numbers(json_key(spline, "t"), MOST, knots);
            CHECK_INT(json_numbers(json_key(spline, "c"), MOST, coefficients), count);
            batten_curve *curve = spline_of(degree, true, BATTEN_END_NOT_A_KNOT, count, x, y);
            CHECK_INT(batten_curve_knot_count(curve), knot_count);
            for (int i = 0; i < knot_count; i++)
                CHECK_BITS(batten_curve_knots(curve)[i], knots[i]);
            for (int i = 0; i < count; i++)
                CHECK_NEAR(batten_curve_points(curve)[i], coefficients[i],
                           1e-12 * largest(count, coefficients));
            batten_curve_unref(curve);
        }
}

/* ---- GSL ---- */

/* The integral of a piecewise cubic, exact by Simpson's rule between knots. */
static double integral(const batten_curve *curve, double a, double b)
{
    double breaks[MOST], sum = 0;
    const int count = batten_curve_spans(curve, breaks);
    for (int i = 0; i + 1 < count; i++) {
        const double low = fmax(a, breaks[i]), high = fmin(b, breaks[i + 1]);
        if (low < high)
            sum += (high - low) / 6 *
                   (value(curve, low, 0) + 4 * value(curve, (low + high) / 2, 0) +
                    value(curve, high, 0));
    }
    return sum;
}

typedef struct {
    int count, places;
    double x[MOST], y[MOST], at[MOST], values[MOST], slopes[MOST], integrals[MOST];
} gsl_case;

static void gsl_read(const char *name, gsl_case *out)
{
    const char *one = json_key(json_file("peer_tests/gsl_interpolation.json"), name);
    out->count = json_numbers(json_key(one, "data_x"), MOST, out->x);
    CHECK_INT(json_numbers(json_key(one, "data_y"), MOST, out->y), out->count);
    out->places = json_numbers(json_key(one, "test_x"), MOST, out->at);
    CHECK_INT(json_numbers(json_key(one, "test_y"), MOST, out->values), out->places);
    CHECK_INT(json_numbers(json_key(one, "test_dy"), MOST, out->slopes), out->places);
    CHECK_INT(json_numbers(json_key(one, "test_iy"), MOST, out->integrals), out->places);
}

static void gsl_check(const gsl_case *c, batten_curve *curve, double tolerance)
{
    for (int i = 0; i < c->places; i++) {
        CHECK_NEAR(value(curve, c->at[i], 0), c->values[i], tolerance);
        CHECK_NEAR(value(curve, c->at[i], 1), c->slopes[i], 20 * tolerance);
        CHECK_NEAR(integral(curve, c->at[0], c->at[i]), c->integrals[i], tolerance);
    }
    batten_curve_unref(curve);
}

/* Its numbers have 15 decimals, those of the slopes as many digits. */
TEST(gsls_natural_cubic_splines_are_reproduced)
{
    static const char *const names[] = {"cspline", "cspline2"};
    for (int c = 0; c < COUNT(names); c++) {
        gsl_case one;
        gsl_read(names[c], &one);
        gsl_check(&one, spline_of(3, true, BATTEN_END_NATURAL, one.count, one.x, one.y), 1e-14);
    }
}

TEST(gsls_periodic_cubic_spline_is_reproduced)
{
    gsl_case one;
    gsl_read("csplinep", &one);
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    batten_curve *curve = NULL;
    options.parameters = BATTEN_GIVEN;
    options.given = one.x;
    options.closed = true;
    CHECK_NEAR(one.y[0], one.y[one.count - 1], 1e-15);
    CHECK_OK(batten_curve_interpolate((batten_points){1, one.count - 1, one.y}, &options, NULL,
                                      &curve));
    gsl_check(&one, curve, 1e-13);
}

TEST(gsls_linear_and_polynomial_interpolants_are_reproduced)
{
    gsl_case one;
    gsl_read("linear", &one);
    batten_curve_catmull_rom_options polygon = batten_curve_catmull_rom_defaults();
    batten_curve *curve = NULL;
    polygon.blend = 1, polygon.local = 0, polygon.given = one.x;
    CHECK_OK(batten_curve_catmull_rom((batten_points){1, one.count, one.y}, &polygon, NULL,
                                      NULL, &curve));
    gsl_check(&one, curve, 1e-15);
    gsl_check(&one, spline_of(1, false, BATTEN_END_NATURAL, one.count, one.x, one.y), 1e-15);
    gsl_read("polynomial", &one);
    gsl_check(&one,
              spline_of(one.count - 1, false, BATTEN_END_NATURAL, one.count, one.x, one.y),
              1e-14);
}

/* ---- pySpline ---- */

/* The feet of three points: the curve has been reversed before, so its parameters are 1 - u,
 * and the last point, at 0.75, lies on it. Newton's method finds them, to 1e-10 or so. */
static void check_feet(const char *expected, int order, const batten_curve *curve)
{
    double points[3][3] = {{0.4, 1.5, 1.5}, {-0.1, 0.5, 1.8}};
    CHECK_OK(batten_curve_evaluate(curve, 1 - 0.75, 0, points[2]));
    for (int i = 0; i < 3; i++) {
        char key[96];
        double wanted[3], foot[3];
        batten_deviation found;
        CHECK_OK(batten_curve_deviation(
            curve, (batten_points){batten_curve_dimension(curve), 1, points[i]}, NULL, NULL,
            NULL, &found));
        CHECK_OK(batten_curve_evaluate(curve, found.at[0], 0, foot));
        snprintf(key, sizeof key,
                 "interpolation test k=%d projection test for point %d solution", order, i);
        CHECK_NEAR(1 - found.at[0], json_number(json_key(expected, key)), 1e-8);
        snprintf(key, sizeof key,
                 "interpolation test k=%d projection test for point %d distance", order, i);
        CHECK_INT(json_numbers(json_key(expected, key), 3, wanted), 3);
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(foot[c] - points[i][c], wanted[c], 1e-7);
    }
}

/* A turn of a helix, 100 points at equal steps. For orders 2 and 4 its knots are those of the
 * polygon and of the not-a-knot cubic. */
TEST(pysplines_interpolants_of_a_helix_are_reproduced)
{
    static const char *const kinds[] = {"curve", "curve derivative", "curve second derivative"};
    const char *expected = json_key(json_file("peer_tests/pyspline_curves.json"), "expected");
    const char *const places[] = {"0.0", "0.5", "0.75", "1.0"};
    for (int order = 2; order <= 4; order++) {
        double points[100][3], t[100];
        for (int i = 0; i < 100; i++) {
            const double angle = 4 * acos(0) * (i / 99.0);
            t[i] = i / 99.0;
            points[i][0] = cos(angle), points[i][1] = sin(angle), points[i][2] = t[i];
        }
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        batten_curve *curve = NULL;
        options.degree = order - 1;
        options.knots_at_data = order == 4;
        options.parameters = BATTEN_GIVEN;
        options.given = t;
        CHECK_OK(batten_curve_interpolate((batten_points){3, 100, points[0]}, &options, NULL,
                                          &curve));
        for (int i = 0; i < COUNT(places); i++)
            for (int k = 0; k < 3; k++) {
                char key[96];
                double wanted[3], out[9];
                snprintf(key, sizeof key, "interpolation test k=%d initial %s evaluated at %s",
                         order, kinds[k], places[i]);
                CHECK_INT(json_numbers(json_key(expected, key), 3, wanted), 3);
                CHECK_OK(batten_curve_evaluate(curve, atof(places[i]), k, out));
                for (int c = 0; c < 3; c++)
                    CHECK_NEAR(out[3 * k + c], wanted[c],
                               k == 0   ? 1e-14
                               : k == 1 ? 1e-11
                                        : 1e-8);
            }
        check_feet(expected, order, curve);
        batten_curve_unref(curve);
    }
}

/* ---- a tool path ---- */

/* Level, a rise, level: what should not swing does not, what must does. */
TEST(a_tool_path_of_four_points_is_monotone_where_it_is_promised)
{
    double x[MOST], y[MOST], slopes[MOST];
    const int count = data_of("toolpath4", x, y);
    CHECK_INT(count, 4);
    for (int r = 0; r <= BATTEN_SLOPE_MAKIMA; r++) {
        batten_curve *curve = NULL;
        double least = 0;
        CHECK_OK(batten_slopes(count, x, y, (batten_slope_rule)r, slopes));
        CHECK_OK(batten_curve_from_tangents((batten_points){1, count, y}, x, slopes, NULL,
                                            false, &curve));
        for (int i = 0; i <= 500; i++)
            least = fmin(least, value(curve, x[0] + (x[3] - x[0]) * i / 500, 1));
        const bool promised = r == BATTEN_SLOPE_FRITSCH_CARLSON ||
                              r == BATTEN_SLOPE_FRITSCH_BUTLAND || r == BATTEN_SLOPE_STEFFEN;
        if (promised)
            CHECK(least >= -1e-16);
        else if (r == BATTEN_SLOPE_BESSEL)
            CHECK(least < -1e-4);
        batten_curve_unref(curve);
    }
    batten_curve *spline = spline_of(3, true, BATTEN_END_NATURAL, count, x, y);
    CHECK(value(spline, x[0] + 0.005, 0) < y[0] - 1e-6);
    batten_curve_unref(spline);
}
