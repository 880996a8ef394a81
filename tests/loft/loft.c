#include <batten/fair.h>

#include "support/test.h"

#include <batten/nearest.h>
#include <math.h>
#include <string.h>

enum { STATIONS = 9, LINES = 6 };

/* Wigley's hull: y = b / 2 (1 - (2 x / l)^2)(1 - ((t - z) / t)^2), l = 10, b = 1, t = 0.625;
 * rounded to a grid. */
static double wigley(double x, double z, double grid)
{
    const double fore = x / 5, deep = (0.625 - z) / 0.625;
    const double y = 0.5 * (1 - fore * fore) * (1 - deep * deep);
    return grid > 0 ? floor(y / grid + 0.5) * grid : y;
}

static batten_offset_table *make_wigley(double grid)
{
    batten_table_line lines[LINES];
    batten_table_point points[STATIONS][LINES];
    batten_table_station stations[STATIONS];
    batten_offset_table *table = NULL;
    for (int j = 0; j < LINES; j++)
        lines[j] = (batten_table_line){"", true, 0.625 * j / (LINES - 1)};
    for (int i = 0; i < STATIONS; i++) {
        const double x = -5 + 10. * i / (STATIONS - 1);
        for (int j = 0; j < LINES; j++)
            points[i][j] = (batten_table_point){x, wigley(x, lines[j].z, grid), lines[j].z, j};
        stations[i] = (batten_table_station){"", x, LINES, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, LINES, lines, STATIONS, stations, &table));
    return table;
}

TEST(wigleys_hull_rounded_to_a_millimetre_is_lofted_without_an_inflection)
{
    batten_offset_table *table = make_wigley(1e-3);
    const batten_loft_options options = batten_loft_defaults(0.6e-3);
    batten_loft_report report;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_loft(table, &options, NULL, &report, &surface));
    CHECK_INT(report.cuts_in_excess, 0);
    CHECK(report.max_move <= 0.6e-3);
    CHECK_INT(report.trimmed_count, 0);
    for (int k = 0; k < report.cut_count; k++)
        CHECK_INT(report.cuts[k].found, 0);
    /* Between the points it is nearer to the truth than the rounding of the table. */
    double off = 0;
    for (int i = 1; i < 20; i++)
        for (int j = 1; j < 20; j++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(surface, i / 20., j / 20., 0, p));
            off = fmax(off, fabs(p[1] - wigley(p[0], p[2], 0)));
        }
    CHECK(off < 1e-3);
    batten_loft_report_release(&report);
    batten_surface_unref(surface);
    batten_offset_table_unref(table);
}

TEST(the_moves_of_a_lofting_are_measured_on_the_surface_that_is_returned)
{
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    batten_offset_table *table = make_wigley(5e-3);
    const batten_loft_options options = batten_loft_defaults(3e-3);
    batten_loft_report report;
    batten_surface *surface = NULL;
    double largest = 0, feet[STATIONS * LINES][3], distances[STATIONS * LINES];
    batten_deviation off;
    CHECK_OK(batten_surface_loft(table, &options, NULL, &report, &surface));
    for (int k = 0; k < report.correction_count; k++) {
        const batten_loft_correction *m = report.corrections + k;
        const batten_table_point *p =
            batten_offset_table_station(table, m->station)->points + m->index;
        CHECK(m->from[0] == p->x && m->from[1] == p->y && m->from[2] == p->z);
        CHECK(m->to[0] == p->x && m->to[2] == p->z); /* where station and waterline meet */
        CHECK(m->distance <= fabs(m->to[1] - m->from[1]) + 1e-12);
        CHECK(k == 0 || m->distance <= m[-1].distance);
        largest = fmax(largest, m->distance);
        memcpy(feet[k], m->to, sizeof feet[k]);
    }
    CHECK_NEAR(largest, report.max_move, 1e-12);
    CHECK(report.max_move <= 3e-3);
    CHECK_OK(batten_surface_deviation(surface,
                                      (batten_points){3, report.correction_count, &feet[0][0]},
                                      NULL, NULL, distances, &off));
    CHECK(off.max < 1e-9);
    batten_loft_report_release(&report);
    batten_surface_unref(surface);
    batten_offset_table_unref(table);
}

/* A hull of `count` points at each of five stations, by half-breadths and heights. */
static batten_offset_table *make_prism(int count, const double (*section)[2])
{
    batten_table_point points[5][8];
    batten_table_station stations[5];
    batten_offset_table *table = NULL;
    for (int i = 0; i < 5; i++) {
        for (int j = 0; j < count; j++)
            points[i][j] =
                (batten_table_point){i, section[j][0] * (1 - 0.02 * i * i), section[j][1], -1};
        stations[i] = (batten_table_station){"", i, count, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, 0, NULL, 5, stations, &table));
    return table;
}

TEST(a_hull_with_a_chine_is_refused_and_the_knuckle_named)
{
    static const double section[][2] = {{0, 0}, {0.4, 0.1}, {0.8, 0.2}, {0.9, 0.6}, {1, 1}};
    batten_offset_table *table = make_prism(5, section);
    const batten_loft_options options = batten_loft_defaults(1e-3);
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_loft(table, &options, NULL, NULL, &surface),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("5 of 5 stations have a knuckle: station 1 (x = 0) turns by");
    CHECK_MESSAGE("at point 3; what is smooth has none: give its points a line");
    CHECK(!surface);
    batten_offset_table_unref(table);
}

TEST(stations_from_the_sheer_down_make_the_same_hull)
{
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    static const double up[][2] = {{0, 0}, {0.5, 0.1}, {0.8, 0.4}, {0.9, 0.7}, {1, 1}};
    static const double down[][2] = {{1, 1}, {0.9, 0.7}, {0.8, 0.4}, {0.5, 0.1}, {0, 0}};
    batten_offset_table *tables[] = {make_prism(5, up), make_prism(5, down)};
    const batten_loft_options options = batten_loft_defaults(5e-3);
    batten_loft_report reports[2];
    batten_surface *surfaces[2] = {NULL};
    for (int k = 0; k < 2; k++)
        CHECK_OK(batten_surface_loft(tables[k], &options, NULL, reports + k, surfaces + k));
    CHECK(reports[0].max_move == reports[1].max_move);
    CHECK_INT(reports[0].worst_index, 4 - reports[1].worst_index);
    for (int k = 0; k < 2; k++) {
        batten_loft_report_release(reports + k);
        batten_surface_unref(surfaces[k]);
        batten_offset_table_unref(tables[k]);
    }
}

TEST(points_of_air_below_the_hull_are_left_out_and_counted)
{
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    static const double section[][2] = {{0, -1},    {0, 0},     {0.5, 0.1},
                                        {0.8, 0.4}, {0.9, 0.7}, {1, 1}};
    batten_offset_table *table = make_prism(6, section);
    const batten_loft_options options = batten_loft_defaults(2e-3);
    batten_loft_report report;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_loft(table, &options, NULL, &report, &surface));
    CHECK_INT(report.trimmed_count, 5);
    const batten_box box = batten_surface_box(surface);
    CHECK(box.low.z > -0.01 && box.low.y >= 0);
    batten_loft_report_release(&report);
    batten_surface_unref(surface);
    batten_offset_table_unref(table);
}

TEST(a_bound_that_no_surface_keeps_is_refused_with_one_that_does)
{
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    /* More zigzags than the surface has freedom for, within a hundredth of the girth. */
    static const double section[][2] = {{0, 0},        {0.5, 0.1},    {0.8, 0.4},    {0.9, 0.7},
                                        {0.904, 0.71}, {0.896, 0.71}, {0.904, 0.72}, {1, 1}};
    batten_offset_table *table = make_prism(8, section);
    const batten_loft_options options = batten_loft_defaults(2e-4);
    batten_loft_report report = {0};
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_loft(table, &options, NULL, &report, &surface),
                 BATTEN_NOT_COMPATIBLE);
    CHECK(report.enough > 2e-4 && report.enough < 2e-2);
    CHECK_MESSAGE(
        "no smooth surface was found within 0.0002 of every point of the table; one was");
    CHECK_MESSAGE("held there by point ");
    CHECK(!surface);
    batten_offset_table_unref(table);
}

TEST(a_raked_end_beside_a_plumb_one_is_lofted)
{
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    /* x = 3 u, at the end 3 + rake w^2, y = (1 - u^3) w, z = w^2 */
    static const double rakes[] = {0.001, 0.2};
    for (int r = 0; r < COUNT(rakes); r++) {
        batten_table_point points[4][5];
        batten_table_station stations[4];
        batten_offset_table *table = NULL;
        batten_loft_report report;
        batten_surface *surface = NULL;
        for (int i = 0; i < 4; i++) {
            const double u = i / 3.;
            for (int j = 0; j < 5; j++) {
                const double w = j / 4.;
                points[i][j] = (batten_table_point){i < 3 ? 3 * u : 3 + rakes[r] * w * w,
                                                    (1 - u * u * u) * w, w * w, -1};
            }
            stations[i] = (batten_table_station){"", 3 * u, 5, points[i]};
        }
        CHECK_OK(batten_offset_table_create(1, 0, NULL, 4, stations, &table));
        const batten_loft_options options = batten_loft_defaults(0.02);
        CHECK_OK(batten_surface_loft(table, &options, NULL, &report, &surface));
        CHECK(report.max_move <= 0.02);
        batten_loft_report_release(&report);
        batten_surface_unref(surface);
        batten_offset_table_unref(table);
    }
}

TEST(a_station_beyond_a_raked_end_is_refused_by_name)
{
    batten_table_point points[4][3];
    batten_table_station stations[4];
    batten_offset_table *table = NULL;
    batten_surface *surface = NULL;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 3; j++) /* the stem leans aft of the third station */
            points[i][j] =
                (batten_table_point){i < 3 ? i : 3 - 0.6 * j, 0.2 * j, 0.04 * j * j, -1};
        stations[i] = (batten_table_station){"", i, 3, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, 0, NULL, 4, stations, &table));
    const batten_loft_options options = batten_loft_defaults(0.01);
    CHECK_STATUS(batten_surface_loft(table, &options, NULL, NULL, &surface),
                 BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("station 3 (x = 2) does not lie between");
    CHECK(!surface);
    batten_offset_table_unref(table);
}

TEST(bad_options_and_thin_tables_are_refused_with_their_numbers)
{
    static const double section[][2] = {{0, 0}, {1, 1}};
    batten_offset_table *thin = make_prism(2, section), *good = make_wigley(0);
    batten_surface *surface = NULL;
    batten_loft_options options = batten_loft_defaults(0);
    CHECK_STATUS(batten_surface_loft(good, &options, NULL, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the bound of a lofting is 0");
    options = batten_loft_defaults(2); /* of a half-breadth of 0.5 */
    CHECK_STATUS(batten_surface_loft(good, &options, NULL, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("to 0.5, its largest half-breadth");
    options = batten_loft_defaults(1e-3);
    options.height = -1;
    CHECK_STATUS(batten_surface_loft(good, &options, NULL, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    options = batten_loft_defaults(1e-3);
    CHECK_STATUS(batten_surface_loft(thin, &options, NULL, NULL, &surface),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("3 stations of 3 points; the table has 0");
    CHECK(!surface);
    batten_offset_table_unref(thin);
    batten_offset_table_unref(good);
}

/* A caller that says at the given report of progress that it has enough. */
typedef struct {
    int reports, last;
} watcher;

static void count_report(void *user, double fraction, const char *what)
{
    watcher *w = user;
    CHECK(fraction >= 0 && fraction <= 1);
    CHECK(*what);
    w->reports++;
}

static bool has_enough(void *user)
{
    const watcher *w = user;
    return w->reports >= w->last;
}

TEST(lofting_is_cancelled_from_its_progress_and_leaves_its_outputs_alone)
{
    batten_offset_table *table = make_wigley(1e-3);
    const batten_loft_options options = batten_loft_defaults(0.6e-3);
    for (int last = 0; last < 3; last++) {
        watcher w = {0, last};
        batten_job job = BATTEN_JOB;
        batten_loft_report report = {.cut_count = -7};
        batten_surface *surface = NULL;
        job.progress = count_report;
        job.is_cancelled = has_enough;
        job.user = &w;
        CHECK_STATUS(batten_surface_loft(table, &options, &job, &report, &surface),
                     BATTEN_CANCELLED);
        CHECK(surface == NULL);
        CHECK_INT(report.cut_count, -7);
    }
    batten_offset_table_unref(table);
}
