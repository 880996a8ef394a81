#include "loft/line.h"

#include "loft/patch.h"
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
