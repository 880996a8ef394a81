#include "loft/lines/line.h"

#include "loft/patch.h"
#include "spline/spline.h"
#include "support/test.h"

enum { DATA = 9, INNER = 7, COUNT_OF = INNER + BAT_LOFT_SUPPORT };

static double knots[COUNT_OF + BAT_LOFT_SUPPORT], t[DATA];

/* A line over 0 .. 1 with its knots at the data, of length 1, whose bulges are seen from 1e-6 on. */
static bat_loft_line line_of(const double *values, double within)
{
    double inner[INNER];
    for (int k = 0; k < DATA; k++)
        t[k] = k / (DATA - 1.);
    memcpy(inner, t + 1, sizeof inner);
    bat_loft_knots(INNER, inner, knots);
    return (bat_loft_line){.count = COUNT_OF,
                           .knots = knots,
                           .datum_count = DATA,
                           .t = t,
                           .values = values,
                           .within = within,
                           .length = 1,
                           .height = 1e-6};
}

TEST(a_line_through_a_quadratic_is_that_quadratic)
{
    double values[DATA] = {0}, f[COUNT_OF];
    int found;
    bat_loft_line line = line_of(values, 1e-3);
    for (int k = 0; k < DATA; k++)
        values[k] = 3 - 2 * t[k] + 5 * t[k] * t[k];
    CHECK_OK(bat_loft_line_fair(&line, f, &found));
    CHECK_INT(found, 0);
    for (int k = 0; k <= 40; k++) {
        const double u = k / 40.;
        CHECK_NEAR(bat_loft_line_at(&line, f, u, 0), 3 - 2 * u + 5 * u * u, 1e-12);
        CHECK_NEAR(bat_loft_line_at(&line, f, u, 1), -2 + 10 * u, 1e-11);
        CHECK_NEAR(bat_loft_line_at(&line, f, u, 2), 10, 1e-9);
    }
}

TEST(a_line_through_equal_values_has_equal_coefficients)
{
    static const double values[DATA] = {0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1};
    double f[COUNT_OF];
    int found = 7;
    const bat_loft_line line = line_of(values, 1e-3);
    CHECK_OK(bat_loft_line_fair(&line, f, &found));
    CHECK_INT(found, 0);
    for (int i = 0; i < COUNT_OF; i++)
        CHECK(f[i] == 0.1);
}

/* A half wave with an error of 0.004 up and down in turn. */
static void make_rough(double *values)
{
    for (int k = 0; k < DATA; k++)
        values[k] = bat_sin(BAT_PI * k / (DATA - 1.)) + (k % 2 ? 0.004 : -0.004);
}

TEST(a_rough_line_becomes_fair_within_its_bound)
{
    double values[DATA] = {0}, f[COUNT_OF], squares = 0;
    int found;
    make_rough(values);
    const bat_loft_line line = line_of(values, 0.01);
    CHECK_OK(bat_loft_line_fair(&line, f, &found));
    CHECK_INT(found, 0);
    for (int k = 0; k < DATA; k++) {
        const double off = bat_loft_line_at(&line, f, t[k], 0) - values[k];
        CHECK(fabs(off) <= 0.01);
        squares += off * off / DATA;
    }
    CHECK(sqrt(squares) <
          0.0051); /* no more than the error that it takes away, and little else */
    CHECK_NEAR(bat_loft_line_at(&line, f, 0.5, 0), 1, 0.01);
}

TEST(a_line_whose_points_ask_for_an_inflection_has_one)
{
    double values[DATA] = {0}, f[COUNT_OF];
    int found;
    bat_loft_line line = line_of(values, 1e-3);
    for (int k = 0; k < DATA; k++)
        values[k] = bat_sin(2 * BAT_PI * t[k]);
    line.changes = 1;
    CHECK_OK(bat_loft_line_fair(&line, f, &found));
    CHECK_INT(found, 1);
    line.changes = 0; /* the bound leaves no way, and the line is made all the same */
    CHECK_OK(bat_loft_line_fair(&line, f, &found));
    CHECK(found >= 1);
    for (int k = 0; k < DATA; k++)
        CHECK(fabs(bat_loft_line_at(&line, f, t[k], 0) - values[k]) <= 1e-3);
}

TEST(pinned_ends_are_met_exactly_and_one_side_is_kept)
{
    double values[DATA] = {0}, f[COUNT_OF];
    int found;
    make_rough(values);
    values[0] = 0.001;
    values[DATA - 1] = 0;
    for (int pin = 0; pin < 4; pin++) {
        bat_loft_line line = line_of(values, 0.01);
        line.one_side = true;
        line.pinned[0] = pin & 1;
        line.pinned[1] = pin & 2;
        CHECK_OK(bat_loft_line_fair(&line, f, &found));
        CHECK((f[0] == 0.001) == line.pinned[0]);
        CHECK(!line.pinned[1] || f[COUNT_OF - 1] == 0);
        for (int i = 0; i < COUNT_OF; i++)
            CHECK(f[i] >= 0);
        for (int k = 0; k < DATA; k++)
            CHECK(fabs(bat_loft_line_at(&line, f, t[k], 0) - values[k]) <= 0.01);
    }
}

/* Values on the other side, within the bound: what rounding leaves there is taken away at either end too. */
TEST(no_coefficient_of_a_one_sided_line_is_on_the_other_side)
{
    for (int k = 1; k < 10; k++)
        for (int end = 0; end < 2; end++) {
            double values[DATA] = {0}, f[COUNT_OF];
            int found;
            make_rough(values);
            values[end == 0 ? 0 : DATA - 1] = -0.001 * k;
            bat_loft_line line = line_of(values, 0.01);
            line.one_side = true;
            CHECK_OK(bat_loft_line_fair(&line, f, &found));
            for (int i = 0; i < COUNT_OF; i++)
                CHECK(f[i] >= 0);
        }
}

TEST(a_side_that_the_bound_forbids_is_no_line)
{
    static const double values[DATA] = {1, 0.5, 0.2, 0, -0.1, 0, 0.2, 0.5, 1};
    double f[COUNT_OF];
    int found;
    bat_loft_line line = line_of(values, 0.01);
    CHECK_OK(bat_loft_line_fair(&line, f, &found));
    line.one_side = true;
    CHECK_STATUS(bat_loft_line_fair(&line, f, &found), BATTEN_NOT_COMPATIBLE);
}

/* ---- straight runs ---- */

/* A straight line up to 1/2, a cubic after it, each value off by up to 0.002. */
static void make_bent(double *values)
{
    static const double off[DATA] = {2, -1, -2, 1, 2, -2, 1, -1, 2};
    for (int k = 0; k < DATA; k++) {
        const double s = bat_max(0, k / (DATA - 1.) - 0.5);
        values[k] = 0.3 + 0.5 * k / (DATA - 1.) + 8 * s * s * s + 1e-3 * off[k];
    }
}

/* How far the inner coefficients of a run are off the line through the outer ones. */
static double unevenness(const bat_loft_line *line, bat_straight_run run, const double *f)
{
    double most = 0;
    const double from = bat_greville(BAT_LOFT_DEGREE, line->knots, run.first),
                 to = bat_greville(BAT_LOFT_DEGREE, line->knots, run.last);
    for (int i = run.first; i <= run.last; i++) {
        const double s = (bat_greville(BAT_LOFT_DEGREE, line->knots, i) - from) / (to - from);
        most = bat_max(most, fabs(f[i] - (f[run.first] + s * (f[run.last] - f[run.first]))));
    }
    return most;
}

/* Runs at the beginning, inside, at the end, two with a coefficient in common, and two apart: of spans
 * from 0, to 8. */
static const struct {
    int count;
    bat_straight_run runs[2];
} runs_of[] = {
    {1, {{0, 6}}},         {1, {{0, 3}}},
    {1, {{2, 5}}},         {1, {{7, COUNT_OF - 1}}},
    {2, {{0, 3}, {3, 6}}}, {2, {{0, 4}, {6, COUNT_OF - 1}}},
};

TEST(runs_are_straight_to_rounding_and_the_bound_stays)
{
    double values[DATA] = {0}, f[COUNT_OF];
    int found;
    make_bent(values);
    for (int c = 0; c < COUNT(runs_of); c++)
        for (int pin = 0; pin < 4; pin++) {
            bat_loft_line line = line_of(values, 0.2);
            line.pinned[0] = pin & 1;
            line.pinned[1] = pin & 2;
            line.run_count = runs_of[c].count;
            line.runs = runs_of[c].runs;
            CHECK_OK(bat_loft_line_fair(&line, f, &found));
            for (int r = 0; r < line.run_count; r++)
                CHECK(unevenness(&line, line.runs[r], f) < 1e-15);
            for (int k = 0; k < DATA; k++)
                CHECK(fabs(bat_loft_line_at(&line, f, t[k], 0) - values[k]) <= 0.2);
            CHECK((f[0] == values[0]) == line.pinned[0]);
            CHECK((f[COUNT_OF - 1] == values[DATA - 1]) == line.pinned[1]);
        }
}

TEST(a_line_that_bends_only_beyond_its_run_is_found_within_the_errors_of_its_values)
{
    static const bat_straight_run half = {0, 6}; /* the spans from 0 to 1/2 */
    double values[DATA] = {0}, f[COUNT_OF];
    int found;
    make_bent(values);
    bat_loft_line line = line_of(values, 0.005);
    line.run_count = 1;
    line.runs = &half;
    CHECK_OK(bat_loft_line_fair(&line, f, &found));
    CHECK_INT(found, 0);
    for (int k = 0; k < DATA; k++) {
        const double s = bat_max(0, t[k] - 0.5);
        CHECK_NEAR(bat_loft_line_at(&line, f, t[k], 0), 0.3 + 0.5 * t[k] + 8 * s * s * s,
                   0.007);
        if (t[k] < 0.5)
            CHECK_NEAR(bat_loft_line_at(&line, f, t[k], 2), 0, 1e-12);
    }
}

/* With nothing else to choose the least squares of the distances remain. */
TEST(a_line_that_is_one_run_is_the_line_of_least_squares)
{
    static const bat_straight_run whole = {0, COUNT_OF - 1};
    double values[DATA] = {0}, f[COUNT_OF], mean = 0, slope = 0, squares = 0;
    int found;
    make_bent(values);
    for (int k = 0; k < DATA; k++)
        mean += values[k] / DATA;
    for (int k = 0; k < DATA; k++) {
        const double s = k / (DATA - 1.) - 0.5;
        slope += s * values[k];
        squares += s * s;
    }
    bat_loft_line line = line_of(values, 0.6);
    line.run_count = 1;
    line.runs = &whole;
    CHECK_OK(bat_loft_line_fair(&line, f, &found));
    CHECK_INT(found, 0);
    for (int k = 0; k <= 20; k++)
        CHECK_NEAR(bat_loft_line_at(&line, f, k / 20., 0),
                   mean + slope / squares * (k / 20. - 0.5), 1e-12);
}

TEST(a_line_that_is_one_run_between_pinned_ends_is_their_chord_or_none)
{
    static const bat_straight_run whole = {0, COUNT_OF - 1};
    double values[DATA] = {0}, f[COUNT_OF];
    int found;
    make_bent(values);
    double most = 0;
    for (int k = 0; k < DATA; k++)
        most = bat_max(most, fabs(values[0] + (values[DATA - 1] - values[0]) * k / (DATA - 1.) -
                                  values[k]));
    for (int side = 0; side < 2; side++) {
        bat_loft_line line = line_of(values, most * (side ? 1.02 : 0.98));
        line.run_count = 1;
        line.runs = &whole;
        line.pinned[0] = line.pinned[1] = true;
        CHECK_STATUS(bat_loft_line_fair(&line, f, &found),
                     side ? BATTEN_OK : BATTEN_NOT_COMPATIBLE);
    }
    for (int k = 0; k <= 20; k++)
        CHECK_NEAR(bat_loft_line_at(&(bat_loft_line){.count = COUNT_OF, .knots = knots}, f,
                                    k / 20., 0),
                   values[0] + (values[DATA - 1] - values[0]) * k / 20., 1e-14);
}

TEST(each_value_has_its_own_part_of_the_bound)
{
    static const double rooms[DATA] = {1, 0.01, 1, 1, 0.01, 1, 1, 1, 0.5};
    double values[DATA], f[COUNT_OF];
    int found;
    make_rough(values);
    bat_loft_line line = line_of(values, 0.01);
    line.rooms = rooms;
    line.changes = 2;
    CHECK_OK(bat_loft_line_fair(&line, f, &found));
    double largest = 0;
    for (int k = 0; k < DATA; k++) {
        const double off = fabs(bat_loft_line_at(&line, f, t[k], 0) - values[k]);
        CHECK(off <= 0.01 * rooms[k]);
        largest = bat_max(largest, off);
    }
    CHECK(largest > 1e-3); /* where there is room it is taken */
}
