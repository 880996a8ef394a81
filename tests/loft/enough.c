#include <batten/fair.h>

#include "support/test.h"

#include <stdlib.h>
#include <string.h>

enum { STATIONS = 4, LINES = 3, POINTS = 9 };

/* A flat bottom, and a side with more zigzags than it has freedom for, within 0.004. */
static batten_offset_table *make_table(void)
{
    static const batten_table_line lines[] = {
        {"keel", false, 0}, {"chine", false, 0}, {"sheer", false, 0}};
    static const double section[POINTS][2] = {{0, 0},        {0.5, 0.1},    {0.6, 0.4},
                                              {0.7, 0.7},    {0.704, 0.71}, {0.696, 0.71},
                                              {0.704, 0.72}, {0.75, 0.85},  {0.8, 1}};
    batten_table_point points[STATIONS][POINTS];
    batten_table_station stations[STATIONS];
    batten_offset_table *table = NULL;
    for (int i = 0; i < STATIONS; i++) {
        for (int j = 0; j < POINTS; j++)
            points[i][j] = (batten_table_point){i, section[j][0], section[j][1],
                                                j < 2             ? j
                                                : j == POINTS - 1 ? 2
                                                                  : -1};
        stations[i] = (batten_table_station){"", i, POINTS, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, LINES, lines, STATIONS, stations, &table));
    return table;
}

TEST(panels_that_cannot_keep_a_bound_are_refused_with_one_that_does)
{
    static const char *const chine[] = {"chine"};
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    batten_offset_table *table = make_table();
    batten_loft_options options = batten_loft_defaults(1e-3);
    batten_loft_report report = {0};
    batten_surface *panels[2] = {NULL};
    options.knuckle_count = 1;
    options.knuckles = chine;
    CHECK_STATUS(batten_hull_loft(table, &options, NULL, &report, panels),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("no smooth panels were found within 0.001 of every point of the table; some "
                  "were within ");
    CHECK(report.enough > 1e-3 && report.enough < 0.02);
    const char *said = strstr(batten_message(), "some were within ");
    const double least = said ? strtod(said + strlen("some were within "), NULL) : 0;
    CHECK(least >= report.enough && least < 1.002 * report.enough);
    options.within = least; /* what is said does */
    CHECK_OK(batten_hull_loft(table, &options, NULL, NULL, panels));
    batten_surface_unref(panels[0]);
    batten_surface_unref(panels[1]);
    batten_offset_table_unref(table);
}
