/* Curves that would bend less and less by growing, held by a tension. */
#include "shape/bent/energy.h"

#include "support/test.h"

#include <batten/fair.h>
#include <batten/interpolate.h>
#include <batten/measure.h>

/* A quadrilateral that crosses itself. */
static const double crossed[] = {0, 0, 3, 2, 3, 0, 0, 2};
static const batten_points quadrilateral = {2, 4, crossed};

static batten_curve *find(batten_energy energy, double tension, bool closed,
                          batten_curve_minimum_energy_report *report)
{
    batten_curve_minimum_energy_options options = batten_curve_minimum_energy_defaults();
    batten_curve *curve = NULL;
    options.energy = energy;
    options.tension = tension;
    options.closed = closed;
    CHECK_OK(batten_curve_minimum_energy(quadrilateral, &options, NULL, report, &curve));
    return curve;
}

/* Of the closed cubic spline through the points. */
static double spline_bending(void)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    batten_curve *curve = NULL;
    batten_fairness found;
    options.closed = true;
    CHECK_OK(batten_curve_interpolate(quadrilateral, &options, NULL, &curve));
    CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, NULL, &found));
    batten_curve_unref(curve);
    return found.energy;
}

TEST(where_a_closed_curve_would_grow_without_end_a_tension_holds_it_below_its_rivals)
{
    batten_curve_minimum_energy_report report;
    batten_fairness found;
    batten_curve *curve = find(BATTEN_ENERGY_BENDING, 0, true, &report);
    CHECK(report.tension > 0);
    CHECK(report.length < 20);
    CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, NULL, &found));
    CHECK_NEAR(report.after, found.energy, 1e-3 * found.energy);
    CHECK(found.energy <= 1.001 * spline_bending());
    CHECK(report.remaining <= 1.001e-3 * report.after);
    CHECK_INT(found.corners, 0);
    batten_curve_unref(curve);
}

TEST(the_tension_that_is_reported_gives_the_same_curve)
{
    for (int kind = 0; kind < 2; kind++) {
        batten_curve_minimum_energy_report held, under;
        batten_curve_unref(find((batten_energy)kind, 0, true, &held));
        batten_curve_unref(find((batten_energy)kind, held.tension, true, &under));
        CHECK_NEAR(under.tension, 0, 0);
        CHECK_NEAR(under.length, held.length, 0.01 * held.length);
        CHECK_NEAR(under.after - held.tension * under.length, held.after, 0.02 * held.after);
    }
}

TEST(a_curve_that_has_a_least_is_not_held)
{
    static const double arch[] = {0, 0, 1, 0.6, 2, 0.1};
    batten_curve_minimum_energy_options options = batten_curve_minimum_energy_defaults();
    batten_curve_minimum_energy_report report;
    batten_curve *curve = NULL;
    options.energy = BATTEN_ENERGY_BENDING;
    CHECK_OK(batten_curve_minimum_energy((batten_points){2, 3, arch}, &options, NULL, &report,
                                         &curve));
    CHECK_NEAR(report.tension, 0, 0);
    CHECK(report.remaining <= 1e-6 * report.after);
    batten_curve_unref(curve);
}
