#include <batten/approximate.h>

#include "shape/published.h"
#include "support/test.h"

enum { MANY = 60 };

static batten_curve_least_squares_options given(const double *parameters, int point_count)
{
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = parameters;
    options.point_count = point_count;
    return options;
}

static batten_condition condition(batten_condition_kind kind, double u, int order, double value)
{
    return (batten_condition){kind, -1, u, order, {value, 0, 0}};
}

static void noisy(const char *name, int count, double *t, double *y)
{
    test_random random = test_random_begin(name);
    for (int i = 0; i < count; i++) {
        t[i] = i / (count - 1.0);
        y[i] = sin(5 * t[i]) + test_random_in(&random, -0.2, 0.2);
    }
}

/* Half the slope of the sum of squares along another curve with the same knots. */
static double slope_along(const batten_curve *fit, const batten_curve *way, int count,
                          const double *t, const double *y, const double *w)
{
    double sum = 0;
    for (int i = 0; i < count; i++) {
        double at, along;
        CHECK_OK(batten_curve_evaluate(fit, t[i], 0, &at));
        CHECK_OK(batten_curve_evaluate(way, t[i], 0, &along));
        sum += (w ? w[i] : 1) * (at - y[i]) * along;
    }
    return sum;
}

/* The curve with the fit's knots and these control values. */
static batten_curve *with_values(const batten_curve *fit, const double *values)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, batten_curve_point_count(fit), values},
                                 batten_curve_degree(fit), NULL, batten_curve_knots(fit),
                                 &curve));
    return curve;
}

TEST(equations_are_met_and_only_they_hold_the_curve_back)
{
    double t[MANY], y[MANY], values[40];
    noisy("equations", MANY, t, y);
    const batten_condition asked[] = {condition(BATTEN_CONDITION_EQUAL, 0.3, 0, 0.5),
                                      condition(BATTEN_CONDITION_EQUAL, 0.55, 1, -2),
                                      condition(BATTEN_CONDITION_EQUAL, 1, 2, 7)};
    for (int degree = 2; degree <= 6; degree++) {
        batten_curve_least_squares_options options = given(t, 14);
        options.degree = degree;
        options.conditions = asked;
        options.condition_count = 3;
        batten_fit_report report;
        batten_curve *fit = NULL;
        double at[3];
        CHECK_OK(batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL,
                                            &report, &fit));
        CHECK_OK(batten_curve_evaluate(fit, 0.3, 0, at));
        CHECK_NEAR(at[0], 0.5, 1e-12);
        CHECK_OK(batten_curve_evaluate(fit, 0.55, 1, at));
        CHECK_NEAR(at[1], -2, 1e-11);
        CHECK_OK(batten_curve_evaluate(fit, 1, 2, at));
        CHECK_NEAR(at[2], 7, 1e-9);
        CHECK_NEAR(report.freedom, 11, 0);
        /* Lagrange: the slopes along all unit vectors are a combination of the three rows. So
         * along a curve for which the three vanish there is no slope: take the fit to other
         * data minus the fit. */
        double other[MANY];
        noisy("others", MANY, t, other);
        batten_curve *second = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){1, MANY, other}, &options, NULL,
                                            NULL, &second));
        for (int i = 0; i < 14; i++)
            values[i] = batten_curve_points(second)[i] - batten_curve_points(fit)[i];
        batten_curve *way = with_values(fit, values);
        CHECK_NEAR(slope_along(fit, way, MANY, t, y, NULL), 0, 1e-11);
        batten_curve_unref(way);
        batten_curve_unref(second);
        batten_curve_unref(fit);
    }
}

TEST(a_point_to_pass_is_a_datum_of_endless_weight)
{
    double t[MANY], y[MANY], w[MANY];
    noisy("weights", MANY, t, y);
    for (int i = 0; i < MANY; i++)
        w[i] = i == 20 ? 1e12 : 1;
    batten_curve_least_squares_options options = given(t, 9);
    const batten_condition pass = {BATTEN_CONDITION_EQUAL, 20, 0, 0, {y[20], 0, 0}};
    batten_curve *heavy = NULL, *fit = NULL;
    options.weights = w;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &heavy));
    options.weights = NULL;
    options.conditions = &pass;
    options.condition_count = 1;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit));
    for (int i = 0; i < 9; i++)
        CHECK_NEAR(batten_curve_points(fit)[i], batten_curve_points(heavy)[i], 1e-9);
    batten_curve_unref(heavy);
    batten_curve_unref(fit);
}

TEST(conditions_that_hold_anyway_change_nothing)
{
    double t[MANY], y[MANY];
    noisy("none", MANY, t, y);
    batten_curve_least_squares_options options = given(t, 10);
    batten_curve *plain = NULL, *fit = NULL;
    batten_fit_report report;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &plain));
    options.band = 10;
    const batten_condition low = condition(BATTEN_CONDITION_AT_LEAST, 0.4, 0, -9);
    options.conditions = &low;
    options.condition_count = 1;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, &report, &fit));
    CHECK_INT(report.pressing, 0);
    CHECK_NEAR(report.freedom, 10, 0);
    for (int i = 0; i < 10; i++)
        CHECK_NEAR(batten_curve_points(fit)[i], batten_curve_points(plain)[i], 1e-11);
    batten_curve_unref(plain);
    batten_curve_unref(fit);
}

TEST(ends_of_curves_have_the_directions_asked_for)
{
    double q[3 * MANY];
    for (int i = 0; i < MANY; i++) {
        const double x = i / (MANY - 1.0);
        q[3 * i] = 4 * x;
        q[3 * i + 1] = sin(4 * x);
        q[3 * i + 2] = x * x;
    }
    const double along[2][3] = {{1, -1, 2}, {0.5, 3, -1}};
    for (int d = 2; d <= 3; d++) {
        double p[3 * MANY];
        for (int i = 0; i < MANY * d; i++)
            p[i] = q[i / d * 3 + i % d];
        batten_condition asked[2];
        for (int e = 0; e < 2; e++) {
            asked[e] =
                (batten_condition){BATTEN_CONDITION_DIRECTION, e * (MANY - 1), 0, 1, {0}};
            memcpy(asked[e].value, along[e], sizeof along[e]);
        }
        batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
        options.point_count = 12;
        options.hold_start = options.hold_end = true;
        options.conditions = asked;
        options.condition_count = 2;
        batten_curve *fit = NULL;
        batten_fit_report report;
        CHECK_OK(batten_curve_least_squares((batten_points){d, MANY, p}, &options, NULL,
                                            &report, &fit));
        CHECK(report.error < 0.3);
        const batten_interval domain = batten_curve_domain(fit);
        for (int e = 0; e < 2; e++) {
            double at[6], dot = 0, size = 0, length = 0;
            CHECK_OK(batten_curve_evaluate(fit, e ? domain.b : domain.a, 1, at));
            for (int k = 0; k < d; k++) {
                CHECK_BITS(at[k], p[e * (MANY - 1) * d + k]);
                dot += at[d + k] * along[e][k];
                size += at[d + k] * at[d + k];
                length += along[e][k] * along[e][k];
            }
            CHECK_NEAR(dot, sqrt(size * length), 1e-11 * sqrt(length));
        }
        batten_curve_unref(fit);
    }
}

/* ---- shapes ---- */

static bool keeps(unsigned shape, const batten_curve *fit)
{
    for (int i = 0; i <= 1000; i++) {
        double at[3];
        CHECK_OK(batten_curve_evaluate(fit, i / 1000.0, 2, at));
        if ((shape & BATTEN_INCREASING && at[1] < -1e-10) ||
            (shape & BATTEN_DECREASING && at[1] > 1e-10) ||
            (shape & BATTEN_CONVEX && at[2] < -1e-8) ||
            (shape & BATTEN_CONCAVE && at[2] > 1e-8))
            return false;
    }
    return true;
}

TEST(functions_of_a_shape_have_it_everywhere_and_no_other_of_that_shape_is_nearer)
{
    static const unsigned shapes[] = {BATTEN_INCREASING,
                                      BATTEN_DECREASING,
                                      BATTEN_CONVEX,
                                      BATTEN_CONCAVE,
                                      BATTEN_INCREASING | BATTEN_CONCAVE,
                                      BATTEN_DECREASING | BATTEN_CONVEX};
    double t[MANY], y[MANY], values[40];
    noisy("shapes", MANY, t, y);
    for (int s = 0; s < COUNT(shapes); s++)
        for (int degree = 1; degree <= 5; degree++) {
            batten_curve_least_squares_options options = given(t, 12);
            options.degree = degree;
            options.shape = shapes[s];
            batten_fit_report report;
            batten_curve *fit = NULL;
            CHECK_OK(batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL,
                                                &report, &fit));
            CHECK(report.pressing > 0);
            CHECK(keeps(shapes[s], fit));
            /* The optimum: no slope downwards towards any of that shape, such as values of an
             * exponential at Greville's abscissae; and none along itself, for shapes are cones.
             */
            for (int k = -2; k <= 2; k++) {
                const double sign = shapes[s] & BATTEN_CONCAVE ? -1 : 1;
                const double rate =
                    shapes[s] & (BATTEN_INCREASING | BATTEN_DECREASING)
                        ? (shapes[s] & BATTEN_INCREASING ? sign : -sign) * (k + 3)
                        : k;
                for (int i = 0; i < 12; i++)
                    values[i] = sign * exp(rate * batten_curve_greville(fit, i)) + k;
                batten_curve *way = with_values(fit, values);
                CHECK(keeps(shapes[s], way) || degree < 3);
                CHECK(slope_along(fit, way, MANY, t, y, NULL) > -1e-9);
                batten_curve_unref(way);
            }
            CHECK_NEAR(slope_along(fit, fit, MANY, t, y, NULL), 0, 1e-10);
            batten_curve_unref(fit);
        }
}

TEST(data_of_a_shape_are_fitted_as_without_it)
{
    double t[MANY], y[MANY];
    for (int i = 0; i < MANY; i++) {
        t[i] = i / (MANY - 1.0);
        y[i] = exp(2 * t[i]);
    }
    batten_curve_least_squares_options options = given(t, 8);
    batten_curve *plain = NULL, *fit = NULL;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &plain));
    options.shape = BATTEN_CONVEX | BATTEN_INCREASING;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit));
    for (int i = 0; i < 8; i++)
        CHECK_NEAR(batten_curve_points(fit)[i], batten_curve_points(plain)[i], 1e-11);
    batten_curve_unref(plain);
    batten_curve_unref(fit);
}

TEST(one_sided_fits_keep_to_their_side_and_turn_over_with_the_data)
{
    double t[MANY], y[MANY], minus[MANY];
    noisy("sides", MANY, t, y);
    for (int i = 0; i < MANY; i++)
        minus[i] = -y[i];
    batten_curve_least_squares_options options = given(t, 10);
    options.side = BATTEN_FIT_OVER;
    batten_curve *over = NULL, *under = NULL;
    batten_fit_report report;
    CHECK_OK(batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, &report,
                                        &over));
    CHECK(report.pressing >= 2);
    options.side = BATTEN_FIT_UNDER;
    CHECK_OK(batten_curve_least_squares((batten_points){1, MANY, minus}, &options, NULL, NULL,
                                        &under));
    for (int i = 0; i < MANY; i++) {
        double at;
        CHECK_OK(batten_curve_evaluate(over, t[i], 0, &at));
        CHECK(at >= y[i] - 1e-12);
    }
    for (int i = 0; i < 10; i++)
        CHECK_NEAR(batten_curve_points(under)[i], -batten_curve_points(over)[i], 1e-10);
    batten_curve_unref(over);
    batten_curve_unref(under);
}

TEST(values_to_stay_over_and_under_are_kept)
{
    double t[MANY], y[MANY];
    noisy("values", MANY, t, y);
    const batten_condition asked[] = {condition(BATTEN_CONDITION_AT_LEAST, 0.77, 0, 0.2),
                                      condition(BATTEN_CONDITION_AT_MOST, 0.31, 0, 0.4),
                                      condition(BATTEN_CONDITION_AT_MOST, 0, 1, -3)};
    batten_curve_least_squares_options options = given(t, 11);
    options.conditions = asked;
    options.condition_count = 3;
    batten_fit_report report;
    batten_curve *fit = NULL;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, &report, &fit));
    CHECK(report.pressing >= 2);
    for (int i = 0; i < 3; i++) {
        double derivatives[2];
        const double sign = asked[i].kind == BATTEN_CONDITION_AT_MOST ? -1 : 1;
        CHECK_OK(batten_curve_evaluate(fit, asked[i].parameter, 1, derivatives));
        CHECK(sign * (derivatives[asked[i].order] - asked[i].value[0]) > -1e-11);
    }
    batten_curve_unref(fit);
}

TEST(a_band_bounds_every_coordinate_and_a_narrow_one_is_interpolation)
{
    double t[12], q[24];
    test_random random = test_random_begin("band");
    for (int i = 0; i < 12; i++) {
        t[i] = i;
        q[2 * i] = i + test_random_in(&random, -0.1, 0.1);
        q[2 * i + 1] = test_random_in(&random, -1, 1);
    }
    batten_curve_least_squares_options options = given(t, 9);
    batten_fit_report plain, report;
    batten_curve *fit = NULL;
    CHECK_OK(
        batten_curve_least_squares((batten_points){2, 12, q}, &options, NULL, &plain, &fit));
    batten_curve_unref(fit);
    options.band = 0.8 * plain.error;
    CHECK_OK(
        batten_curve_least_squares((batten_points){2, 12, q}, &options, NULL, &report, &fit));
    CHECK(report.error <= options.band * sqrt(2) && report.rms >= plain.rms);
    batten_curve_unref(fit);
    options.point_count = 12;
    options.band = 1e-7;
    CHECK_OK(
        batten_curve_least_squares((batten_points){2, 12, q}, &options, NULL, &report, &fit));
    CHECK(report.error < 1e-7);
    batten_curve_unref(fit);
    options.point_count = 5;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){2, 12, q}, &options, NULL, &report, &fit),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("within 1e-07 of point");
}

TEST(a_ring_passes_what_it_shall)
{
    double q[2 * MANY], u[MANY];
    test_random random = test_random_begin("ring");
    for (int i = 0; i < MANY; i++) {
        const double r = 1 + test_random_in(&random, -0.05, 0.05), w = 8 * atan(1) * i / MANY;
        q[2 * i] = r * cos(w);
        q[2 * i + 1] = r * sin(w);
    }
    const batten_condition pass[2] = {{BATTEN_CONDITION_EQUAL, 0, 0, 0, {q[0], q[1], 0}},
                                      {BATTEN_CONDITION_EQUAL, 31, 0, 0, {q[62], q[63], 0}}};
    for (int n = 3; n <= 12; n += 3) {
        batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
        options.closed = true;
        options.point_count = n;
        options.conditions = pass;
        options.condition_count = 2;
        options.corrections = 5;
        batten_curve *fit = NULL;
        double at[2];
        CHECK_OK(
            batten_curve_least_squares((batten_points){2, MANY, q}, &options, u, NULL, &fit));
        for (int k = 0; k < 2; k++) {
            CHECK_OK(batten_curve_evaluate(fit, u[k * 31], 0, at));
            CHECK_NEAR(hypot(at[0] - pass[k].value[0], at[1] - pass[k].value[1]), 0, 1e-12);
        }
        batten_curve_unref(fit);
    }
}

TEST(conditions_determine_what_data_do_not)
{
    const double t[4] = {0, 0.1, 0.2, 1}, y[4] = {0, 1, 2, 5};
    const double knots[9] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    const batten_condition asked[] = {condition(BATTEN_CONDITION_EQUAL, 1, 1, 0),
                                      condition(BATTEN_CONDITION_EQUAL, 1, 2, 3)};
    batten_curve_least_squares_options options = given(t, 5);
    options.knots = BATTEN_KNOTS_GIVEN;
    options.given_knots = knots;
    options.conditions = asked;
    options.condition_count = 2;
    batten_curve *fit = NULL;
    batten_fit_report report;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, 4, y}, &options, NULL, &report, &fit));
    CHECK_NEAR(report.freedom, 3, 0);
    batten_curve_unref(fit);
    fit = NULL;
    options.condition_count = 0;
    options.shape = BATTEN_INCREASING;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, 4, y}, &options, NULL, &report, &fit),
        BATTEN_SINGULAR_SYSTEM);
    options.regularise = true;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, 4, y}, &options, NULL, &report, &fit));
    CHECK(report.regularised);
    batten_curve_unref(fit);
}

TEST(N2_conditions_do_not_depend_on_the_unit)
{
    double t[MANY], y[MANY], scaled[MANY];
    noisy("units", MANY, t, y);
    batten_curve_least_squares_options options = given(t, 10);
    options.shape = BATTEN_CONCAVE;
    options.side = BATTEN_FIT_OVER;
    batten_curve *plain = NULL;
    CHECK_OK(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &plain));
    static const double sizes[] = {1e-300, 1e-9, 1e9, 1e150, 1e300};
    for (int k = 0; k < COUNT(sizes); k++) {
        for (int i = 0; i < MANY; i++)
            scaled[i] = sizes[k] * y[i];
        batten_curve *fit = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){1, MANY, scaled}, &options, NULL,
                                            NULL, &fit));
        for (int i = 0; i < 10; i++)
            CHECK_NEAR(batten_curve_points(fit)[i] / sizes[k], batten_curve_points(plain)[i],
                       1e-10);
        batten_curve_unref(fit);
    }
    batten_curve_unref(plain);
}

/* ---- what is refused ---- */

TEST(G9_conditions_that_cannot_hold_together_are_named)
{
    static const struct {
        batten_condition asked[2];
        unsigned shape;
        const char *says;
    } rows[] = {
        {{{BATTEN_CONDITION_EQUAL, -1, 0.25, 0, {1}},
          {BATTEN_CONDITION_EQUAL, -1, 0.25, 0, {2}}},
         0,
         "condition 2, that the curve must be 2 at 0.25, cannot hold together with the "
         "others: "
         "it is missed by 1"},
        {{{BATTEN_CONDITION_AT_LEAST, -1, 0.25, 0, {3}},
          {BATTEN_CONDITION_AT_MOST, -1, 0.25, 0, {2}}},
         0,
         "at 0.25, cannot hold together"},
        {{{BATTEN_CONDITION_EQUAL, -1, 0, 0, {3}}, {BATTEN_CONDITION_EQUAL, -1, 1, 0, {2}}},
         BATTEN_INCREASING,
         "the shape between"},
        {{{BATTEN_CONDITION_EQUAL, -1, 0.5, 4, {3}}, {BATTEN_CONDITION_EQUAL, -1, 1, 0, {2}}},
         0,
         "condition 1, that derivative 4 must be 3 at 0.5, cannot hold"},
    };
    double t[MANY], y[MANY];
    noisy("refused", MANY, t, y);
    for (int i = 0; i < COUNT(rows); i++) {
        batten_curve_least_squares_options options = given(t, 10);
        options.conditions = rows[i].asked;
        options.condition_count = 2;
        options.shape = rows[i].shape;
        batten_curve *fit = NULL;
        CHECK_STATUS(
            batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit),
            BATTEN_NOT_COMPATIBLE);
        CHECK_MESSAGE(rows[i].says);
        CHECK(fit == NULL);
    }
    batten_curve_least_squares_options options = given(t, 10);
    options.hold_start = options.hold_end = true;
    options.shape = BATTEN_INCREASING; /* sin 5 x ends below where it begins */
    y[0] = 1;
    batten_curve *fit = NULL;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the shape between");
}

TEST(N1_conditions_of_no_sense_are_named)
{
    static const struct {
        batten_condition asked;
        int dimension;
        batten_status status;
        const char *says;
    } rows[] = {
        {{BATTEN_CONDITION_EQUAL, -1, 0.25, 0, {NAN}}, 1, BATTEN_NOT_FINITE, "is nan"},
        {{BATTEN_CONDITION_EQUAL, -1, NAN, 0, {1}}, 1, BATTEN_NOT_FINITE, "is at nan"},
        {{BATTEN_CONDITION_EQUAL, -1, 2, 0, {1}}, 1, BATTEN_OUT_OF_DOMAIN, "outside 0 .. 1"},
        {{BATTEN_CONDITION_EQUAL, 60, 0, 0, {1}}, 1, BATTEN_BAD_ARGUMENT, "point 61 of 60"},
        {{BATTEN_CONDITION_EQUAL, -1, 0, 5, {1}}, 1, BATTEN_BAD_ARGUMENT, "order 5"},
        {{BATTEN_CONDITION_DIRECTION, -1, 0, 1, {1}}, 1, BATTEN_BAD_ARGUMENT, "for a curve"},
        {{BATTEN_CONDITION_AT_LEAST, -1, 0, 0, {1}}, 2, BATTEN_BAD_ARGUMENT, "for a function"},
        {{BATTEN_CONDITION_DIRECTION, -1, 0, 1, {0}}, 2, BATTEN_BAD_ARGUMENT, "length 0"},
        {{BATTEN_CONDITION_DIRECTION, -1, 0, 0, {1}}, 2, BATTEN_BAD_ARGUMENT, "order 0"},
        {{(batten_condition_kind)9, -1, 0, 0, {1}}, 2, BATTEN_BAD_ARGUMENT, "of no kind: 9"},
    };
    double t[MANY], y[2 * MANY];
    noisy("senseless", MANY, t, y);
    noisy("senseless", MANY, t, y + MANY);
    for (int i = 0; i < COUNT(rows); i++) {
        batten_curve_least_squares_options options = given(t, 10);
        options.conditions = &rows[i].asked;
        options.condition_count = 1;
        batten_curve *fit = NULL;
        CHECK_STATUS(batten_curve_least_squares((batten_points){rows[i].dimension, MANY, y},
                                                &options, NULL, NULL, &fit),
                     rows[i].status);
        CHECK_MESSAGE("condition 1");
        CHECK_MESSAGE(rows[i].says);
    }
}

TEST(shapes_sides_and_bands_are_for_open_functions)
{
    double t[MANY + 1], y[2 * MANY];
    noisy("open", MANY, t, y);
    noisy("open", MANY, t, y + MANY);
    t[MANY] = 1.1;
    batten_curve *fit = NULL;
    batten_curve_least_squares_options options = given(t, 10);
    options.shape = BATTEN_CONVEX;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){2, MANY, y}, &options, NULL, NULL, &fit),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("not for a curve");
    options.closed = true;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("not for a closed one");
    options = given(t, 10);
    options.shape = 16;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit),
        BATTEN_BAD_ARGUMENT);
    options.shape = 0;
    options.side = BATTEN_FIT_OVER;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){2, MANY, y}, &options, NULL, NULL, &fit),
        BATTEN_BAD_ARGUMENT);
    options.side = BATTEN_FIT_BOTH;
    options.band = -1;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit),
        BATTEN_BAD_ARGUMENT);
    options.band = NAN;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, MANY, y}, &options, NULL, NULL, &fit),
        BATTEN_NOT_FINITE);
}

TEST(S5_more_unknowns_than_a_program_takes_are_refused)
{
    static double t[1200], y[1200];
    for (int i = 0; i < 1200; i++)
        t[i] = i;
    batten_curve_least_squares_options options = given(t, 1001);
    options.shape = BATTEN_CONVEX;
    batten_curve *fit = NULL;
    CHECK_STATUS(
        batten_curve_least_squares((batten_points){1, 1200, y}, &options, NULL, NULL, &fit),
        BATTEN_TOO_LARGE);
    CHECK_MESSAGE("1001 unknowns");
    static double many[40000], values[40000];
    for (int i = 0; i < 40000; i++)
        many[i] = i;
    options = given(many, 700);
    options.side = BATTEN_FIT_OVER;
    CHECK_STATUS(batten_curve_least_squares((batten_points){1, 40000, values}, &options, NULL,
                                            NULL, &fit),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("40000 conditions on 700 unknowns");
}

/* ---- published data ---- */

TEST(the_moisture_of_dierckx_is_concave_and_near)
{
    double table[40], x[20], y[20], w[20];
    const int count = published_table("spline_data/dierckx_moisture_concave.csv", 2, 20, table);
    CHECK_INT(count, 16);
    for (int i = 0; i < count; i++) {
        x[i] = table[2 * i];
        y[i] = table[2 * i + 1];
        w[i] = i == 0 || i == count - 1 ? 100 : i == 1 ? 9 : 1; /* squares of 10, 3, 1 */
    }
    double before = HUGE_VAL;
    for (int n = 5; n <= 8; n++) {
        batten_curve_least_squares_options options = given(x, n);
        options.weights = w;
        options.shape = BATTEN_CONCAVE;
        batten_fit_report report;
        batten_curve *fit = NULL;
        CHECK_OK(batten_curve_least_squares((batten_points){1, count, y}, &options, NULL,
                                            &report, &fit));
        for (int i = 0; i <= 500; i++) {
            double at[3];
            CHECK_OK(batten_curve_evaluate(fit, x[0] + (x[count - 1] - x[0]) * i / 500, 2, at));
            CHECK(at[2] < 1e-12);
        }
        before = report.sum < before ? report.sum : before;
        batten_curve_unref(fit);
    }
    /* Dierckx' program asks for S = 0.2, 0.04 and 0.0002 one after another. */
    CHECK(before < 0.0002);
}
