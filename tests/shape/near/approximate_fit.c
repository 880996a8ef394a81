#include "support/test.h"

#include <batten/approximate.h>

/* Data at both ends of the parameters alone: what lies between is determined by the slight penalty. */
static batten_status fit_ends(double weight, batten_fit_report *report, batten_curve **out)
{
    static const double t[] = {0, 0.1, 0.2, 0.3, 0.4, 2.6, 2.7, 2.8, 2.9, 3};
    static const double knots[] = {0, 0, 0, 0, 1, 1.2, 1.5, 1.8, 2, 3, 3, 3, 3};
    double y[10], weights[10];
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    for (int i = 0; i < 10; i++) {
        y[i] = t[i] * t[i];
        weights[i] = weight;
    }
    options.point_count = 9;
    options.knots = BATTEN_KNOTS_GIVEN;
    options.given_knots = knots;
    options.parameters = BATTEN_GIVEN;
    options.given = t;
    options.weights = weights;
    options.regularise = true;
    return batten_curve_least_squares((batten_points){1, 10, y}, &options, NULL, report, out);
}

TEST(what_no_datum_determines_does_not_depend_on_the_unit_of_the_weights)
{
    static const double weights[] = {1e-10, 1, 1e10};
    batten_curve *curves[3] = {NULL};
    for (int i = 0; i < 3; i++) {
        batten_fit_report report;
        CHECK_OK(fit_ends(weights[i], &report, &curves[i]));
        CHECK(report.regularised);
        CHECK_NEAR(report.error, 0, 1e-4);
    }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k <= 30; k++) {
            double value = 0, due = 0;
            CHECK_OK(batten_curve_evaluate(curves[i], 0.1 * k, 0, &value));
            CHECK_OK(batten_curve_evaluate(curves[1], 0.1 * k, 0, &due));
            CHECK_NEAR(value, due, 1e-5);
        }
    for (int i = 0; i < 3; i++)
        batten_curve_unref(curves[i]);
}
