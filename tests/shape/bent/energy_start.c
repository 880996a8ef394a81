/* What is returned as the least is compared with Batten's other curves through the same points. */
#include <batten/bent.h>
#include <batten/fair.h>
#include <batten/interpolate.h>

#include "shape/bent/energy.h"
#include "support/test.h"

static double energy_of(const batten_fairness *f, batten_energy energy)
{
    return energy == BATTEN_ENERGY_BENDING ? f->energy : f->variation;
}

static double chain_energy(const batten_chain *chain, batten_energy energy)
{
    batten_fairness found;
    const batten_points none = {batten_chain_dimension(chain), 0, NULL};
    CHECK_OK(batten_chain_fairness(chain, none, NULL, &found));
    return energy_of(&found, energy);
}

static double curve_energy(const batten_curve *curve, batten_energy energy)
{
    batten_fairness found;
    const batten_points none = {batten_curve_dimension(curve), 0, NULL};
    CHECK_OK(batten_curve_fairness(curve, none, NULL, &found));
    return energy_of(&found, energy);
}

/* Of all plane families, of Spiro's curve and of cubic splines. */
static double least_of_others(batten_points points, batten_energy energy)
{
    double least = HUGE_VAL;
    for (int family = 0; family <= BATTEN_FAMILY_HOBBY + 1; family++) {
        batten_chain *chain = NULL;
        batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
        options.family = (batten_span_family)family;
        const batten_status status =
            family <= BATTEN_FAMILY_HOBBY
                ? batten_chain_nonlinear(points, &options, NULL, NULL, NULL, &chain)
                : batten_chain_spiro(points, NULL, NULL, NULL, &chain);
        if (status == BATTEN_OK)
            least = fmin(least, chain_energy(chain, energy));
        batten_chain_unref(chain);
    }
    for (int parameters = BATTEN_UNIFORM; parameters <= BATTEN_FOLEY; parameters++) {
        batten_curve *curve = NULL;
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        options.parameters = (batten_parametrization)parameters;
        options.knots_at_data = true;
        if (batten_curve_interpolate(points, &options, NULL, &curve) == BATTEN_OK)
            least = fmin(least, curve_energy(curve, energy));
        batten_curve_unref(curve);
    }
    return least;
}

/* Points of a wild polygon in the unit square. */
static int random_polygon(test_random *random, double points[12][2])
{
    const int count = test_random_int(random, 4, 12);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++)
            points[i][k] = test_random_unit(random);
    return count;
}

/* Most of them have their curve. */
static void check_unbeaten(batten_energy energy)
{
    test_random random = test_random_begin("unbeaten");
    const int cases = test_cases(5);
    int found = 0;
    for (int n = cases; n > 0; n--) {
        double points[12][2];
        const batten_points row = {2, random_polygon(&random, points), &points[0][0]};
        batten_curve_minimum_energy_options options = batten_curve_minimum_energy_defaults();
        batten_curve_minimum_energy_report report;
        batten_curve *curve = NULL;
        options.energy = energy;
        batten_status status =
            batten_curve_minimum_energy(row, &options, NULL, &report, &curve);
        if (test_memory_failed(status, BATTEN_OK))
            status = batten_curve_minimum_energy(row, &options, NULL, &report, &curve);
        CHECK(status == BATTEN_OK || status == BATTEN_INCOMPLETE);
        if (status != BATTEN_OK)
            continue;
        found++;
        const double made = curve_energy(curve, energy);
        CHECK(made <= 1.001 * least_of_others(row, energy));
        CHECK_NEAR(report.after, made, 1e-3 * made);
        batten_curve_unref(curve);
    }
    CHECK(2 * found >= cases);
}

TEST(no_other_curve_through_wild_points_bends_less_than_the_least)
{
    check_unbeaten(BATTEN_ENERGY_BENDING);
}

TEST(no_other_curve_through_wild_points_varies_less_than_the_least)
{
    check_unbeaten(BATTEN_ENERGY_VARIATION);
}

TEST(as_many_quintics_are_taken_as_save_energy)
{
    const double points[4][2] = {
        {0.3576, 0.8089}, {0.0425, 0.2306}, {0.3796, 0.4668}, {0.4405, 0.8981}};
    const batten_points row = {2, 4, &points[0][0]};
    batten_curve_minimum_energy_options options = batten_curve_minimum_energy_defaults();
    batten_curve_minimum_energy_report free_report, six;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_minimum_energy(row, &options, NULL, &free_report, &curve));
    batten_curve_unref(curve);
    options.pieces = 6;
    CHECK_OK(batten_curve_minimum_energy(row, &options, NULL, &six, &curve));
    batten_curve_unref(curve);
    CHECK(free_report.after <= 1.001 * six.after);
}

TEST(points_in_a_plane_of_space_have_the_curve_of_the_plane)
{
    const double flat[5][2] = {{0, 0}, {1, 0.6}, {2, 0.1}, {3.5, 0.4}, {4, 1.5}};
    const double x[3] = {0.6, 0.8, 0}, y[3] = {-0.48, 0.36, 0.8};
    double space[5][3];
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            space[i][k] = 7 + flat[i][0] * x[k] + flat[i][1] * y[k];
    for (int kind = 0; kind < 2; kind++) {
        batten_curve_minimum_energy_options options = batten_curve_minimum_energy_defaults();
        batten_curve_minimum_energy_report plane, placed;
        batten_curve *a = NULL, *b = NULL;
        options.energy = (batten_energy)kind;
        CHECK_OK(batten_curve_minimum_energy((batten_points){2, 5, &flat[0][0]}, &options, NULL,
                                             &plane, &a));
        CHECK_OK(batten_curve_minimum_energy((batten_points){3, 5, &space[0][0]}, &options,
                                             NULL, &placed, &b));
        CHECK_NEAR(placed.after, plane.after, 1e-6 * plane.after);
        batten_curve_unref(a);
        batten_curve_unref(b);
    }
}

/* What failed is given back, so that a test may try again. */
static batten_status make_starts(const bat_energy_spline *t, bat_energy_starts *out)
{
    const batten_status status = bat_energy_starts_make(t, out);
    if (status != BATTEN_OK)
        bat_energy_starts_release(out);
    return status;
}

static const struct {
    bool start, end, curved, closed; /* what is given */
    bool chains, curves;             /* which of the others meet it */
} ends[] = {
    {false, false, false, false, true, true},  {true, false, false, false, true, false},
    {false, true, false, false, true, false},  {true, true, false, false, true, false},
    {false, false, true, false, false, false}, {true, false, true, false, false, false},
    {false, false, false, true, true, true},
};

TEST(a_curve_is_a_rival_where_it_meets_the_tangents_and_curvatures_that_are_given)
{
    static const double points[] = {0, 0, 1, 0.7, 2.2, 0.4, 3, -0.5}, along[] = {1, 0.5};
    if (test_cases(10) < 10)
        return; /* without memory some of the curves are left out */
    for (int i = 0; i < COUNT(ends); i++) {
        batten_curve_minimum_energy_options options = batten_curve_minimum_energy_defaults();
        double copy[COUNT(points)];
        memcpy(copy, points, sizeof copy);
        options.energy = BATTEN_ENERGY_BENDING;
        options.closed = ends[i].closed;
        options.start_tangent = ends[i].start ? along : NULL;
        options.end_tangent = ends[i].end ? along : NULL;
        options.end_curvature = ends[i].curved ? along : NULL;
        const bat_energy_spline t = {.options = &options,
                                     .d = 2,
                                     .count = 4,
                                     .given = points,
                                     .unit = 1,
                                     .points = copy};
        bat_energy_starts starts = {0};
        CHECK_OK(make_starts(&t, &starts));
        int found[2] = {0, 0};
        for (int k = 0; k < starts.count; k++) {
            const bat_energy_start *s = &starts.at[k];
            CHECK(s->is_rival == (s->chain ? ends[i].chains : ends[i].curves));
            CHECK(k == 0 || s->energy >= starts.at[k - 1].energy * 0.99);
            found[s->chain != NULL]++;
        }
        CHECK(found[0] > 0 && found[1] > 0);
        bat_energy_starts_release(&starts);
        CHECK_INT(starts.count, 0);
    }
}
