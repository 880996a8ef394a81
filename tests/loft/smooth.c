#include "loft/hull.h"

#include "support/waterlines.h"
#include <batten/fair.h>

static const double x[] = {-3.5, -3, -2.5, -2, -1, 0, 1, 2, 2.5, 3, 3.5},
                    z[] = {0, 0.25, 0.5, 0.75, 1};

static double end_of(double height)
{
    return 2.65 + 0.7 * height;
}

/* A double-ender whose ends rake and lie between the stations; rounded to 1 mm. */
static double raked(double at, double height)
{
    const double part = at / end_of(height);
    return bat_max(0, round(1000 * (0.6 + 0.3 * height) * (1 - part * part)) / 1000);
}

TEST(a_hull_whose_ends_lie_between_stations_is_fair_closed_and_within_its_bound)
{
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    const double within = 3e-3;
    batten_offset_table *table = make_waterlines(11, x, 5, z, raked);
    batten_loft_options options = batten_loft_defaults(within);
    batten_loft_report report = {0};
    batten_surface *hull = NULL;
    options.height = 1e-5;
    CHECK_OK(batten_surface_loft(table, &options, NULL, &report, &hull));
    CHECK_INT(report.cuts_in_excess, 0);
    CHECK(report.max_move <= within && report.max_move > 0);
    CHECK_INT(report.trimmed_count, 16);
    for (int k = 0; k <= 20; k++)
        for (int fore = 0; fore <= 1; fore++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(hull, fore, k / 20., 0, p));
            CHECK_NEAR(p[1], 0, 1e-15);
            /* y falls by 0.45 to 0.55 over 1 there. */
            CHECK_NEAR(fore ? p[0] : -p[0], end_of(p[2]), 4 * within);
        }
    batten_loft_report_release(&report);
    batten_surface_unref(hull);
    batten_offset_table_unref(table);
}

static double level(double at, double height)
{
    (void)at;
    return 0.5 + 0.1 * height;
}

TEST(a_grid_without_stairs_is_lofted_by_girths)
{
    batten_offset_table *table = make_waterlines(5, x + 3, 5, z, level);
    bat_loft loft = {0};
    CHECK_OK(bat_hull_smooth(table, 0.01, NULL, &loft));
    CHECK(!loft.is_graph);
    bat_hull_release(&loft);
    batten_offset_table_unref(table);
}

TEST(a_bound_above_the_breadth_is_refused_for_graphs_too)
{
    batten_offset_table *table = make_waterlines(11, x, 5, z, raked);
    bat_loft loft = {0};
    CHECK_STATUS(bat_hull_smooth(table, 1, NULL, &loft), BATTEN_BAD_ARGUMENT);
    batten_offset_table_unref(table);
}

static double raked_but_for_a_zero(double at, double height)
{
    return at == 0 && height == 0.5 ? 0 : raked(at, height);
}

TEST(a_zero_amid_the_hull_of_a_graph_is_refused)
{
    batten_offset_table *table = make_waterlines(11, x, 5, z, raked_but_for_a_zero);
    bat_loft loft = {0};
    CHECK_STATUS(bat_hull_smooth(table, 0.003, NULL, &loft), BATTEN_BAD_ARGUMENT);
    CHECK(strstr(batten_message(), "station 6 (x = 0) says 0 at z = 0.5") != NULL);
    batten_offset_table_unref(table);
}
