#include <batten/fair.h>

#include "support/test.h"

#include <math.h>

enum { STATIONS = 4, LINES = 4 };

/* Keel, bilge, wale and sheer of a prism of four stations, to be spoiled. */
typedef struct {
    batten_table_line lines[LINES];
    batten_table_point points[STATIONS][LINES];
    batten_table_station stations[STATIONS];
} prism;

static void make_prism(prism *p)
{
    static const char *const names[LINES] = {"keel", "bilge", "wale", "sheer"};
    static const double section[LINES][2] = {{0, 0}, {0.6, 0.1}, {0.9, 0.5}, {1, 1}};
    for (int j = 0; j < LINES; j++)
        p->lines[j] = (batten_table_line){names[j], false, 0};
    for (int i = 0; i < STATIONS; i++) {
        for (int j = 0; j < LINES; j++)
            p->points[i][j] = (batten_table_point){i, section[j][0], section[j][1], j};
        p->stations[i] = (batten_table_station){"", i, LINES, p->points[i]};
    }
}

static batten_status loft_prism(const prism *p, int stations, batten_loft_options options)
{
    batten_offset_table *table = NULL;
    batten_surface *panels[3] = {NULL};
    CHECK_OK(batten_offset_table_create(1, LINES, p->lines, stations, p->stations, &table));
    const batten_status status = batten_hull_loft(table, &options, NULL, NULL, panels);
    for (int k = 0; k < 3; k++)
        batten_surface_unref(panels[k]);
    batten_offset_table_unref(table);
    return status;
}

static void swap_lines(prism *p)
{
    p->points[2][1].line = 2;
    p->points[2][2].line = 1;
}

static void drop_line(prism *p)
{
    p->points[2][2].line = -1;
}

static void turn_back(prism *p)
{
    p->points[1][1].x = 2.5;
}

static void bring_near(prism *p)
{
    p->points[1][2].y = 0.5995; /* inside of the bilge, where its neighbours lie outside */
    p->points[1][2].z = 0.1;
}

static const struct {
    const char *knuckles[2];
    int count, stations;
    double within;
    void (*spoil)(prism *p);
    batten_status status;
    const char *message;
} cases[] = {
    {{"bilge", "wale"}, 2, STATIONS, 1e-3, NULL, BATTEN_OK, NULL},
    {{"chine"},
     1,
     STATIONS,
     1e-3,
     NULL,
     BATTEN_NOT_FOUND,
     "the table has no line 'chine'; its lines are 'keel', 'bilge', 'wale', 'sheer'"},
    {{"bilge", "bilge"},
     2,
     STATIONS,
     1e-3,
     NULL,
     BATTEN_BAD_ARGUMENT,
     "the line 'bilge' is declared twice"},
    {{"bilge", "wale"},
     2,
     STATIONS,
     1e-3,
     drop_line,
     BATTEN_NOT_FOUND,
     "the line 'wale' has no point at station 3 (x = 2)"},
    {{"bilge", "wale"},
     2,
     STATIONS,
     1e-3,
     swap_lines,
     BATTEN_BAD_ARGUMENT,
     "the line 'wale' is not above the line 'bilge' at station 3 (x = 2), as it is at the first"},
    {{"keel"},
     1,
     STATIONS,
     1e-3,
     NULL,
     BATTEN_BAD_ARGUMENT,
     "the line 'keel' is the lower edge of the hull at station 1 (x = 0)"},
    {{"sheer"},
     1,
     STATIONS,
     1e-3,
     NULL,
     BATTEN_BAD_ARGUMENT,
     "the line 'sheer' is the upper edge of the hull at station 1 (x = 0)"},
    {{"bilge", "wale"},
     2,
     STATIONS,
     1e-3,
     turn_back,
     BATTEN_NOT_INCREASING,
     "the line 'bilge' does not run forward from station 2 (x = 1) to station 3 (x = 2)"},
    {{"bilge", "wale"},
     2,
     2,
     1e-3,
     NULL,
     BATTEN_TOO_FEW_POINTS,
     "a lofting with knuckles needs at least 3 stations; the table has 2"},
    {{"bilge", "wale"},
     2,
     STATIONS,
     2,
     NULL,
     BATTEN_BAD_ARGUMENT,
     "the bound of the lofting is 2; it must be from"},
    {{"bilge"},
     1,
     STATIONS,
     1e-3,
     NULL,
     BATTEN_UNSUPPORTED,
     "on the line 'wale'; what is smooth has none: declare this line as a knuckle"},
};

TEST(lines_that_cannot_bound_panels_are_refused_by_name_and_place)
{
    for (int k = 0; k < COUNT(cases); k++) {
        prism p;
        batten_loft_options options = batten_loft_defaults(cases[k].within);
        options.knuckle_count = cases[k].count;
        options.knuckles = cases[k].knuckles;
        make_prism(&p);
        if (cases[k].spoil)
            cases[k].spoil(&p);
        CHECK_STATUS(loft_prism(&p, cases[k].stations, options), cases[k].status);
        if (cases[k].message)
            CHECK_MESSAGE(cases[k].message);
    }
}

TEST(lines_that_the_bound_lets_change_places_are_refused)
{
    static const char *const knuckles[] = {"bilge", "wale"};
    prism p;
    batten_loft_options options = batten_loft_defaults(0.4);
    options.knuckle_count = 2;
    options.knuckles = knuckles;
    make_prism(&p);
    bring_near(&p);
    CHECK_STATUS(loft_prism(&p, STATIONS, options), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE(
        "the lines 'bilge' and 'wale' are 0.0005 apart at station 2 (x = 1), and within "
        "0.4 they change places there");
}

TEST(knuckles_without_names_and_of_one_surface_are_refused)
{
    prism p;
    batten_offset_table *table = NULL;
    batten_surface *surface = NULL;
    static const char *const knuckles[] = {"bilge"};
    batten_loft_options options = batten_loft_defaults(1e-3);
    make_prism(&p);
    options.knuckle_count = 1;
    CHECK_STATUS(loft_prism(&p, STATIONS, options), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("1 knuckles are declared");
    options.knuckle_count = -1;
    options.knuckles = knuckles;
    CHECK_STATUS(loft_prism(&p, STATIONS, options), BATTEN_BAD_ARGUMENT);
    CHECK_OK(batten_offset_table_create(1, LINES, p.lines, STATIONS, p.stations, &table));
    options.knuckle_count = 1;
    CHECK_STATUS(batten_surface_loft(table, &options, NULL, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("one surface has no knuckles, and 1 are declared");
    CHECK(!surface);
    batten_offset_table_unref(table);
}

/* An end raked by a fifth: the lines of the bow reach as far as their own last point. */
static void rake(prism *p)
{
    for (int j = 0; j < LINES; j++)
        p->points[STATIONS - 1][j].x += 0.2 * p->points[STATIONS - 1][j].z;
}

TEST(lines_of_a_raked_end_reach_their_own_last_point)
{
    static const char *const knuckles[] = {"bilge", "wale"};
    prism p;
    batten_offset_table *table = NULL;
    batten_surface *panels[3] = {NULL};
    batten_loft_report report;
    batten_loft_options options = batten_loft_defaults(1e-3);
    options.knuckle_count = 2;
    options.knuckles = knuckles;
    make_prism(&p);
    rake(&p);
    CHECK_OK(batten_offset_table_create(1, LINES, p.lines, STATIONS, p.stations, &table));
    CHECK_OK(batten_hull_loft(table, &options, NULL, &report, panels));
    CHECK(report.max_move < 1e-14);
    for (int k = 0; k < 3; k++)
        for (int v = 0; v < 2; v++) {
            double at[3];
            const batten_table_point *end = &p.points[STATIONS - 1][k + v];
            CHECK_OK(batten_surface_evaluate(panels[k], 1, v, 0, at));
            CHECK_NEAR(at[0], end->x, 1e-15);
            CHECK_NEAR(at[1], end->y, 1e-15);
            CHECK_NEAR(at[2], end->z, 1e-15);
        }
    for (int k = 0; k < 3; k++)
        batten_surface_unref(panels[k]);
    batten_loft_report_release(&report);
    batten_offset_table_unref(table);
}

/* The wale beside the bilge at all stations but the first, and farther from it there than the bound: a fair
 * line through it dives below the bilge between the first two. */
static void leave_suddenly(prism *p)
{
    enum { BILGE = 1, WALE = 2 };
    for (int k = 0; k < STATIONS; k++) {
        const batten_table_point *bilge = &p->points[k][BILGE];
        p->points[k][WALE].y = bilge->y + 1e-4;
        p->points[k][WALE].z = bilge->z + (k >= 1 && k <= 3 ? 1e-3 : 0.4);
    }
}

TEST(lines_that_change_places_between_stations_are_refused)
{
    static const char *const knuckles[] = {"bilge", "wale"};
    prism p;
    batten_loft_options options = batten_loft_defaults(2e-4);
    options.knuckle_count = 2;
    options.knuckles = knuckles;
    make_prism(&p);
    leave_suddenly(&p);
    CHECK_STATUS(loft_prism(&p, STATIONS, options), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("they change places there or before the next");
}
