/* Double-enders with upright stems: their corners do not fold. */
#include "loft/outline.h"

#include "support/test.h"
#include <batten/fair.h>
#include <batten/measure.h>

enum { STATIONS = 11, POINTS = 9 };

/* The round section of a double-ender 10 long, whose profile rises to its stems; with tumblehome the section goes
 * on beyond its largest breadth. Rounded to 1 mm. */
static batten_table_point point_at(double x, int i, double end)
{
    const double t = x / 5 - 1, breadth = 1.5 * (1 - t * t), angle = end * i / (POINTS - 1);
    const double keel = 0.5 * t * t * t * t, sheer = 1.6 + 0.4 * t * t;
    const double z = keel + (sheer - keel) * (breadth > 0 ? (1 - cos(angle)) / (1 - cos(end))
                                                          : (double)i / (POINTS - 1));
    return (batten_table_point){x, round(1000 * breadth * sin(angle)) / 1000,
                                round(1000 * z) / 1000, -1};
}

static batten_offset_table *make_double_ender(double end)
{
    batten_table_point points[STATIONS][POINTS];
    batten_table_station stations[STATIONS];
    batten_offset_table *table = NULL;
    for (int k = 0; k < STATIONS; k++) {
        for (int i = 0; i < POINTS; i++)
            points[k][i] = point_at(k, i, end);
        stations[k] = (batten_table_station){"", k, POINTS, points[k]};
    }
    CHECK_OK(batten_offset_table_create(1, 0, NULL, STATIONS, stations, &table));
    return table;
}

/* Stem and sternpost rise, and stay on the centre plane. */
static void check_stem(const batten_surface *hull, double u)
{
    double before = -HUGE_VAL;
    for (int k = 0; k <= 400; k++) {
        double p[3];
        CHECK_OK(batten_surface_evaluate(hull, u, k / 400., 0, p));
        CHECK(p[2] > before);
        CHECK_NEAR(p[1], 0, 1e-15);
        before = p[2];
    }
}

static void check_double_ender(double end)
{
    const double within = 3e-3;
    batten_offset_table *table = make_double_ender(end);
    const batten_loft_options options = batten_loft_defaults(within);
    batten_loft_report report = {0};
    batten_surface *hull = NULL;
    batten_surface_fold fold = {.found = true};
    CHECK_OK(batten_surface_loft(table, &options, NULL, &report, &hull));
    CHECK_INT(report.cuts_in_excess, 0);
    CHECK(report.max_move > 0 && report.max_move <= within);
    CHECK_OK(batten_surface_find_fold(hull, &fold));
    CHECK(!fold.found);
    check_stem(hull, 0);
    check_stem(hull, 1);
    batten_loft_report_release(&report);
    batten_surface_unref(hull);
    batten_offset_table_unref(table);
}

TEST(a_round_double_ender_with_upright_stems_is_fair_and_does_not_fold)
{
    if (test_cases(10) >= 10) /* too long to repeat for each allocation */
        check_double_ender(BAT_PI / 2);
}

TEST(one_with_tumblehome_is_fair_and_does_not_fold)
{
    if (test_cases(10) >= 10)
        check_double_ender(0.62 * BAT_PI);
}
