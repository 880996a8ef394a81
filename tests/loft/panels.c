#include <batten/fair.h>

#include "support/test.h"

#include <math.h>
#include <string.h>

enum { STATIONS = 6, MOST = 7 };

/* A hull of lines j = 0 .. count - 1 with these names, whose points are y and z at x. */
typedef void place(double x, int line, double yz[2]);

static batten_offset_table *make_table(int count, const char *const *names, place *at)
{
    batten_table_line lines[MOST];
    batten_table_point points[STATIONS][MOST];
    batten_table_station stations[STATIONS];
    batten_offset_table *table = NULL;
    for (int j = 0; j < count; j++)
        lines[j] = (batten_table_line){names[j], false, 0};
    for (int i = 0; i < STATIONS; i++) {
        for (int j = 0; j < count; j++) {
            double yz[2];
            at(i, j, yz);
            points[i][j] = (batten_table_point){i, yz[0], yz[1], j};
        }
        stations[i] = (batten_table_station){"", i, count, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, count, lines, STATIONS, stations, &table));
    return table;
}

static const char *const chine_boat[] = {"keel", "chine", "sheer"};
static const char *const chine[] = {"chine"};

static batten_loft_options with_knuckles(double within, int count, const char *const *names)
{
    batten_loft_options options = batten_loft_defaults(within);
    options.knuckle_count = count;
    options.knuckles = names;
    return options;
}

static void release(int count, batten_surface **surfaces, batten_loft_report *report,
                    batten_offset_table *table)
{
    for (int k = 0; k < count; k++)
        batten_surface_unref(surfaces[k]);
    if (report)
        batten_loft_report_release(report);
    batten_offset_table_unref(table);
}

static void at_prism(double x, int line, double yz[2])
{
    static const double section[][2] = {{0, 0}, {0.8, 0.2}, {1, 1}};
    (void)x;
    memcpy(yz, section[line], 2 * sizeof *yz);
}

TEST(a_prism_with_a_chine_comes_back_to_the_last_digit)
{
    batten_offset_table *table = make_table(3, chine_boat, at_prism);
    const batten_loft_options options = with_knuckles(1e-3, 1, chine);
    batten_loft_report report;
    batten_surface *panels[2] = {NULL};
    CHECK_OK(batten_hull_loft(table, &options, NULL, &report, panels));
    CHECK(report.max_move < 1e-14 && report.rms_move < 1e-14);
    CHECK_INT(report.correction_count, 0);
    CHECK_INT(report.cuts_in_excess, 0);
    CHECK_INT(report.panel_count, 2);
    CHECK_INT(report.ruled_count, 2);
    CHECK_INT(report.trimmed_count, 0);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i <= 10; i++)
            for (int j = 0; j <= 4; j++) {
                double p[3], low[2], high[2];
                const double v = j / 4.;
                at_prism(0, k, low);
                at_prism(0, k + 1, high);
                CHECK_OK(batten_surface_evaluate(panels[k], i / 10., v, 0, p));
                CHECK_NEAR(p[0], i / 10. * (STATIONS - 1), 1e-14);
                CHECK_NEAR(p[1], (1 - v) * low[0] + v * high[0], 1e-15);
                CHECK_NEAR(p[2], (1 - v) * low[1] + v * high[1], 1e-15);
            }
    release(2, panels, &report, table);
}

/* Cylinders of parabolas: the side a plate bent about lines of its frames' direction. */
static void at_cylinder(double x, int line, double yz[2])
{
    const double bend = 0.02 * x * (5 - x);
    yz[0] = line == 0 ? 0 : line == 1 ? 0.5 + bend : 0.9 + bend;
    yz[1] = line == 0 ? 0.1 : line == 1 ? 0.1 + bend : 0.8 + bend;
}

static void check_normals(const batten_surface *panel, double angle)
{
    for (int i = 0; i <= 10; i++) {
        double s[2][12], n[2][3]; /* S, S_u, S_v ... at both ends of a ruling */
        for (int k = 0; k < 2; k++) {
            CHECK_OK(batten_surface_evaluate(panel, i / 10., k, 1, s[k]));
            const double *u = s[k] + 3, *v = s[k] + 6;
            for (int c = 0; c < 3; c++)
                n[k][c] = u[(c + 1) % 3] * v[(c + 2) % 3] - u[(c + 2) % 3] * v[(c + 1) % 3];
        }
        double cross = 0, size = 0;
        for (int c = 0; c < 3; c++) {
            cross += pow(n[0][(c + 1) % 3] * n[1][(c + 2) % 3] -
                             n[0][(c + 2) % 3] * n[1][(c + 1) % 3],
                         2);
            size += n[0][c] * n[0][c];
        }
        CHECK(sqrt(cross) <= angle * size);
    }
}

TEST(a_developable_strake_stays_developable)
{
    batten_offset_table *table = make_table(3, chine_boat, at_cylinder);
    const batten_loft_options options = with_knuckles(1e-3, 1, chine);
    batten_loft_report report;
    batten_surface *panels[2] = {NULL};
    CHECK_OK(batten_hull_loft(table, &options, NULL, &report, panels));
    CHECK(report.max_move < 1e-13);
    CHECK_INT(report.cuts_in_excess, 0);
    check_normals(panels[1], 1e-12);
    release(2, panels, &report, table);
}

/* A flat of 1 : 4 below the chine, above it a side of four points on a curve; rounded to 1 mm. */
static void at_round(double x, int line, double yz[2])
{
    const double w = line <= 1 ? 0 : (line - 1) / 4., narrow = 1 - 0.02 * x * x;
    yz[0] = narrow * (line == 0 ? 0 : 0.8 + 0.3 * w - 0.1 * w * w);
    yz[1] = line == 0 ? 0 : 0.2 + 0.8 * w * w;
    for (int c = 0; c < 2; c++)
        yz[c] = floor(yz[c] * 1000 + 0.5) / 1000;
}

static const char *const round_boat[] = {"keel", "chine", "a", "b", "c", "sheer"};

/* Of the lower panel of degree 1 across and the upper of degree 3: the control points of an edge. */
static void check_common_edge(const batten_surface *below, const batten_surface *above)
{
    const int nu = batten_surface_point_count(below, BATTEN_U),
              nv = batten_surface_point_count(above, BATTEN_V);
    const double *p = batten_surface_points(below), *q = batten_surface_points(above);
    CHECK_INT(batten_surface_degree(below, BATTEN_V), 1);
    CHECK_INT(batten_surface_degree(above, BATTEN_V), 3);
    CHECK_INT(batten_surface_point_count(above, BATTEN_U), nu);
    for (int i = 0; i < nu; i++)
        for (int c = 0; c < 3; c++)
            CHECK(p[3 * (2 * i + 1) + c] == q[3 * i * nv + c]);
}

TEST(a_panel_with_points_keeps_the_bound_and_shares_its_line_bit_for_bit)
{
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    batten_offset_table *table = make_table(6, round_boat, at_round);
    const batten_loft_options options = with_knuckles(2e-3, 1, chine);
    batten_loft_report report;
    batten_surface *panels[2] = {NULL};
    int knuckles = 0;
    CHECK_OK(batten_hull_loft(table, &options, NULL, &report, panels));
    CHECK(report.max_move <= 2e-3 && report.max_move > 0);
    CHECK_INT(report.cuts_in_excess, 0);
    CHECK_INT(report.ruled_count, 1);
    for (int k = 0; k < report.cut_count; k++) {
        knuckles += report.cuts[k].family == BATTEN_LOFT_KNUCKLE && report.cuts[k].panel == 1;
        CHECK(report.cuts[k].panel == 1 || report.cuts[k].family == BATTEN_LOFT_PROFILE);
    }
    CHECK_INT(knuckles, 2);
    check_common_edge(panels[0], panels[1]);
    for (int i = 0; i <= 20; i++)
        for (int j = 0; j <= 20; j++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(panels[1], i / 20., j / 20., 0, p));
            const double w = sqrt(fmax(0, (p[2] - 0.2) / 0.8)), narrow = 1 - 0.02 * p[0] * p[0];
            CHECK_NEAR(p[1], narrow * (0.8 + 0.3 * w - 0.1 * w * w), 6e-3);
        }
    release(2, panels, &report, table);
}

TEST(knuckles_may_be_named_in_any_order)
{
    static const char *const up[] = {"chine", "a"}, *const down[] = {"a", "chine"};
    static const char *const names[] = {"keel", "chine", "a", "sheer"};
    batten_offset_table *table = make_table(4, names, at_round);
    batten_surface *panels[2][3] = {{NULL}};
    for (int k = 0; k < 2; k++) {
        const batten_loft_options options = with_knuckles(2e-3, 2, k ? down : up);
        CHECK_OK(batten_hull_loft(table, &options, NULL, NULL, panels[k]));
    }
    for (int k = 0; k < 3; k++) {
        const size_t count = 6 * (size_t)batten_surface_point_count(panels[0][k], BATTEN_U);
        CHECK(memcmp(batten_surface_points(panels[0][k]), batten_surface_points(panels[1][k]),
                     count * sizeof(double)) == 0);
    }
    release(3, panels[0], NULL, NULL);
    release(3, panels[1], NULL, table);
}
