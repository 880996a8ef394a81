#include "support/test.h"

#include <batten/approximate.h>
#include <math.h>

/* What fits near points refuse, by name and with the number; what was there stays. */

static const double wave[] = {0, 0, 1, 1, 2, 0, 3, -1, 4, 0, 5, 1};
static const double steps[] = {0, 1, 2, 3, 4, 5};

enum { COUNT_OF_WAVE = 6 };

static char place;
static batten_curve *const left = (void *)&place; /* any address */

/* ---- least squares ---- */

static void refuse_fit(int dimension, const batten_curve_least_squares_options *options,
                       batten_status status, const char *words)
{
    const batten_points points = {dimension, COUNT_OF_WAVE, dimension == 1 ? steps : wave};
    batten_curve *out = left;
    CHECK_STATUS(batten_curve_least_squares(points, options, NULL, NULL, &out), status);
    CHECK_TEXT(batten_message(), words);
    CHECK(out == left);
}

TEST(least_squares_refuse_counts_kinds_and_knots_by_their_numbers)
{
    const double knots[] = {0, 0, 0, 0, 1, NAN, 1, 1, 1};
    const batten_curve_least_squares_options standard = batten_curve_least_squares_defaults();
    batten_curve_least_squares_options o = standard;
    o.corrections = -1;
    refuse_fit(2, &o, BATTEN_BAD_ARGUMENT, "-1 corrections of the parameters of a curve");
    o.corrections = 1;
    o.parameters = BATTEN_GIVEN;
    o.given = steps;
    refuse_fit(1, &o, BATTEN_BAD_ARGUMENT, "1 corrections of the parameters of a function");
    o = standard;
    o.degree = 0;
    refuse_fit(2, &o, BATTEN_BAD_DEGREE, "the degree is 0; it must be in 1..25");
    o = standard;
    o.parameters = (batten_parametrization)(BATTEN_GIVEN + 1);
    char words[60];
    snprintf(words, sizeof words, "unknown parametrization %d", BATTEN_GIVEN + 1);
    refuse_fit(2, &o, BATTEN_BAD_ARGUMENT, words);
    o.parameters = (batten_parametrization)-1;
    refuse_fit(2, &o, BATTEN_BAD_ARGUMENT, "unknown parametrization -1");
    o = standard;
    o.point_count = 5;
    o.knots = BATTEN_KNOTS_GIVEN;
    refuse_fit(2, &o, BATTEN_BAD_ARGUMENT, "the knots must be given, and are missing");
    o.given_knots = knots;
    refuse_fit(2, &o, BATTEN_NOT_FINITE, "knot 6 is nan");
}

TEST(given_parameters_are_there_are_numbers_and_never_fall)
{
    static const struct {
        double given[COUNT_OF_WAVE];
        batten_status status;
        const char *words;
    } rows[] = {
        {{0, 1, NAN, 3, 4, 5}, BATTEN_NOT_FINITE, "parameter 3 is nan"},
        {{0, 1, 2, 3, 4, INFINITY}, BATTEN_NOT_FINITE, "parameter 6 is inf"},
        {{0, 1, 0.5, 3, 4, 5},
         BATTEN_NOT_INCREASING,
         "parameter 3 is 0.5, below parameter 2, which is 1"},
        {{-1e308, 0, 0, 0, 0, 1e308}, BATTEN_OVERFLOW, "the parameters leave the numbers"},
        {{2, 2, 2, 2, 2, 2}, BATTEN_COINCIDENT, "all 6 points have the same parameter"},
    };
    batten_curve_least_squares_options o = batten_curve_least_squares_defaults();
    o.parameters = BATTEN_GIVEN;
    refuse_fit(2, &o, BATTEN_BAD_ARGUMENT, "the parameters must be given, and are missing");
    for (int i = 0; i < COUNT(rows); i++) {
        o.given = rows[i].given;
        refuse_fit(2, &o, rows[i].status, rows[i].words);
    }
}

/* ---- smoothing and curves within a tolerance ---- */

static void refuse_smoothing(const batten_curve_smooth_options *options, batten_status status,
                             const char *words)
{
    const batten_points points = {2, COUNT_OF_WAVE, wave};
    batten_curve *out = left;
    CHECK_STATUS(batten_curve_smooth(points, options, NULL, NULL, &out), status);
    CHECK_TEXT(batten_message(), words);
    CHECK(out == left);
}

TEST(smoothing_refuses_orders_rules_and_weights_by_their_numbers)
{
    const double weights[COUNT_OF_WAVE] = {0};
    const batten_curve_smooth_options standard = batten_curve_smooth_defaults();
    batten_curve_smooth_options o = standard;
    for (int order = 0; order <= 5; order += 5) {
        char words[60];
        snprintf(words, sizeof words, "the order is %d; it must be in 1..4", order);
        o.order = order;
        refuse_smoothing(&o, BATTEN_BAD_ARGUMENT, words);
    }
    o = standard;
    o.by = (batten_smooth_by)-1;
    refuse_smoothing(&o, BATTEN_BAD_ARGUMENT, "unknown rule -1 for smoothing");
    o = standard;
    o.parameters = (batten_parametrization)-1;
    refuse_smoothing(&o, BATTEN_BAD_ARGUMENT, "unknown parametrization -1");
    o = standard;
    o.weights = weights;
    refuse_smoothing(&o, BATTEN_TOO_FEW_POINTS, "all 6 points have the weight 0");
}

TEST(curves_within_a_tolerance_refuse_methods_and_corners)
{
    const batten_points points = {2, COUNT_OF_WAVE, wave};
    const batten_curve_within_options standard = batten_curve_within_defaults();
    batten_curve_within_options o[3] = {standard, standard, standard};
    static const char *const words[] = {"unknown method -1 or parametrization 1",
                                        "corners of -1 radians, and 0 corners",
                                        "corners of 0 radians, and -2 corners"};
    o[0].method = (batten_within_method)-1;
    o[0].parameters = (batten_parametrization)1;
    o[1].corner = -1;
    o[2].corner = 0;
    o[2].corner_count = -2;
    for (int i = 0; i < 3; i++) {
        batten_curve *out = left;
        o[i].tolerance = 0.1;
        CHECK_STATUS(batten_curve_within(points, &o[i], NULL, NULL, &out), BATTEN_BAD_ARGUMENT);
        CHECK_TEXT(batten_message(), words[i]);
        CHECK(out == left);
    }
}

/* ---- primitives ---- */

TEST(primitives_refuse_dimensions_methods_and_points_without_extent)
{
    static const double far[] = {1.7e308, 0,        -1.7e308, 0,        -1.7e308,
                                 1,       -1.7e308, 2,        -1.7e308, 3};
    static const double same[] = {1, 2, 1, 2, 1, 2, 1, 2, 1, 2};
    static const double line_of_five[] = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4};
    batten_fitted_line line = {.from = 7};
    batten_fitted_circle circle = {.radius = 7};
    batten_fitted_ellipse ellipse = {.a = 7};
    batten_span span = {.length = 7};
    CHECK_STATUS(batten_line_fit((batten_points){1, 5, same}, NULL, &line),
                 BATTEN_BAD_ARGUMENT);
    CHECK_TEXT(batten_message(), "the dimension is 1; it must be 2 or 3");
    CHECK_STATUS(batten_line_fit((batten_points){2, 5, same}, NULL, &line), BATTEN_COINCIDENT);
    CHECK_TEXT(batten_message(), "all 5 points coincide");
    CHECK_STATUS(batten_line_fit((batten_points){2, 5, far}, NULL, &line), BATTEN_OVERFLOW);
    CHECK_TEXT(batten_message(), "the points are too far apart");
    CHECK(line.from == 7);
    for (int method = -1; method <= BATTEN_CIRCLE_KASA + 1; method += BATTEN_CIRCLE_KASA + 2) {
        char words[60];
        snprintf(words, sizeof words, "no circle in dimension 2 by method %d", method);
        CHECK_STATUS(batten_circle_fit((batten_points){2, 5, far}, (batten_circle_method)method,
                                       NULL, &circle),
                     BATTEN_BAD_ARGUMENT);
        CHECK_TEXT(batten_message(), words);
    }
    CHECK_STATUS(
        batten_circle_fit((batten_points){1, 5, far}, BATTEN_CIRCLE_KASA, NULL, &circle),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("no circle in dimension 1");
    CHECK(circle.radius == 7);
    CHECK_STATUS(batten_ellipse_fit((batten_points){3, 3, far}, NULL, &ellipse),
                 BATTEN_UNSUPPORTED);
    CHECK_TEXT(batten_message(), "the points have 3 coordinates, 2 are expected");
    CHECK_STATUS(batten_ellipse_fit((batten_points){2, 5, line_of_five}, NULL, &ellipse),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK(ellipse.a == 7);
    CHECK_STATUS(batten_clothoid_fit((batten_points){3, 3, far}, NULL, NULL, NULL, &span),
                 BATTEN_UNSUPPORTED);
    CHECK_TEXT(batten_message(), "the points have 3 coordinates, 2 are expected");
    CHECK(span.length == 7);
}

/* Points of an ellipse and of its axes: those of the long one are nearest to its ends beyond the centres of
 * curvature, the others to points beside the axis: x = a^2 q / (a^2 - b^2). */
TEST(points_on_the_axes_of_an_ellipse_have_their_feet_in_closed_form)
{
    enum { AROUND = 400 };
    double points[2 * AROUND + 4];
    for (int i = 0; i < AROUND; i++) {
        const double t = 2 * acos(-1) * i / AROUND;
        points[2 * i] = 5 * cos(t);
        points[2 * i + 1] = 3 * sin(t);
    }
    for (int k = 0; k < 2; k++) {
        batten_fitted_ellipse e;
        batten_primitive_report report;
        const double far[2] = {5.01, -5.01}, near[2] = {5 - 0.01, -5 + 0.01};
        for (int i = 0; i < 2; i++) {
            points[2 * (AROUND + i)] = k ? near[i] : far[i];
            points[2 * (AROUND + i) + 1] = 0;
        }
        CHECK_OK(batten_ellipse_fit((batten_points){2, AROUND + 2, points}, &report, &e));
        /* Two of 402 points pull by little. */
        CHECK_NEAR(e.a, 5, 1e-3);
        CHECK_NEAR(e.b, 3, 1e-3);
        CHECK_NEAR(report.error, 0.01, 1e-3);
        CHECK(report.worst >= AROUND);
    }
}
