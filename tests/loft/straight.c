#include <batten/fair.h>

#include "support/test.h"

#include <math.h>

enum { STATIONS = 8, LINES = 3, PANELS = 2 };

/* A barge: parallel from station 3 to 5, its ends parabolas; every point off by up to a hundredth of
 * a metre. */
typedef struct {
    batten_table_line lines[LINES];
    batten_table_point points[STATIONS][LINES];
    batten_table_station stations[STATIONS];
    batten_offset_table *table;
    batten_surface *panels[PANELS];
} barge;

static double off_middle(double x)
{
    return x < 3 ? 3 - x : x > 5 ? x - 5 : 0;
}

static void make_barge(barge *b)
{
    static const char *const names[LINES] = {"keel", "chine", "deck"};
    *b = (barge){.table = NULL};
    for (int j = 0; j < LINES; j++)
        b->lines[j] = (batten_table_line){names[j], false, 0};
    for (int i = 0; i < STATIONS; i++) {
        const double d = off_middle(i), off = 0.01 * ((i * 5 % 8) / 3.5 - 1);
        for (int j = 0; j < LINES; j++)
            b->points[i][j] =
                (batten_table_point){i, j == 0 ? 0 : 2 + 0.3 * j - 0.03 * j * d * d + off,
                                     0.8 * j + 0.02 * d * d - off, j};
        b->stations[i] = (batten_table_station){"", i, LINES, b->points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, LINES, b->lines, STATIONS, b->stations, &b->table));
}

static void free_barge(barge *b)
{
    for (int k = 0; k < PANELS; k++)
        batten_surface_unref(b->panels[k]);
    batten_offset_table_unref(b->table);
}

static batten_status loft_barge(barge *b, int count, const batten_loft_straight *runs,
                                batten_loft_report *report)
{
    static const char *const chine[] = {"chine"};
    batten_loft_options options = batten_loft_defaults(0.03);
    options.knuckle_count = 1;
    options.knuckles = chine;
    options.straight_count = count;
    options.straight = runs;
    return batten_hull_loft(b->table, &options, NULL, report, b->panels);
}

/* The most that y and z of an edge, at v = 0 or 1, differ from the mean of their neighbours half a
 * station off, where all three are on the run from x = 3 to x = 5. */
static void measure_bends(const batten_surface *panel, double v, double bend[2])
{
    bend[0] = bend[1] = 0;
    for (int k = 0; k <= 8; k++) {
        double p[3][3];
        const double x = 3.5 + k / 8.;
        for (int s = 0; s < 3; s++)
            CHECK_OK(batten_surface_evaluate(panel, (x + (s - 1) / 2.) / (STATIONS - 1), v, 0,
                                             p[s]));
        for (int c = 0; c < 2; c++)
            bend[c] = fmax(bend[c], fabs(p[0][c + 1] - 2 * p[1][c + 1] + p[2][c + 1]));
    }
}

TEST(a_run_is_straight_in_the_views_that_are_asked_for_and_in_no_other)
{
    static const struct {
        const char *line;
        batten_loft_view view;
        int panel;
        double v;
    } cases[] = {
        {"keel", BATTEN_LOFT_IN_PROFILE, 0, 0}, {"profile", BATTEN_LOFT_IN_PROFILE, 0, 0},
        {"chine", BATTEN_LOFT_IN_SPACE, 1, 0},  {"chine", BATTEN_LOFT_IN_SPACE, 0, 1},
        {"chine", BATTEN_LOFT_IN_PLAN, 0, 1},   {"deck", BATTEN_LOFT_IN_PROFILE, 1, 1},
        {"sheer", BATTEN_LOFT_IN_SPACE, 1, 1},
    };
    for (int k = 0; k < test_cases(COUNT(cases)); k++) {
        barge b;
        batten_loft_report report;
        double bend[2];
        make_barge(&b);
        const batten_loft_straight run = {cases[k].line, 3, 5, cases[k].view};
        CHECK_OK(loft_barge(&b, 1, &run, &report));
        CHECK(report.max_move <= 0.03);
        CHECK_INT(report.cuts_in_excess, 0);
        measure_bends(b.panels[cases[k].panel], cases[k].v, bend);
        const bool keel = cases[k].panel == 0 && cases[k].v == 0;
        for (int c = 0; c < 2; c++)
            if (cases[k].view == BATTEN_LOFT_IN_SPACE ||
                (c == 0) == (cases[k].view == BATTEN_LOFT_IN_PLAN) || (keel && c == 0))
                CHECK(bend[c] < 4e-15);
            else
                CHECK(bend[c] > 1e-5);
        batten_loft_report_release(&report);
        free_barge(&b);
    }
}

/* The table's own points lie off a straight line by more than this bound on the ends. */
TEST(a_run_that_the_bound_forbids_is_refused_with_one_that_would_do)
{
    const batten_loft_straight run = {"chine", 0, 3, BATTEN_LOFT_IN_PLAN};
    barge b;
    batten_loft_report report = {0};
    make_barge(&b);
    CHECK_STATUS(loft_barge(&b, 1, &run, &report), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE(
        "the line 'chine' cannot be straight from station 1 (x = 0) to station 4 (x = 3) "
        "in plan within 0.03 of its points; within 0.0");
    /* of a parabola of 0.03 (3 - x)^2 a line over 3 is off by a sixteenth of 0.27 at two of four
     * stations and more than that at none; both views share the bound; offs are added */
    CHECK(report.enough > 0.03 && report.enough < 0.1);
    CHECK(!b.panels[0] && !b.panels[1]);
    free_barge(&b);
}

/* The least bound that is named does, a twentieth less does not. */
TEST(the_bound_that_a_forbidden_run_needs_is_the_least)
{
    const batten_loft_straight run = {"chine", 0, 3, BATTEN_LOFT_IN_PLAN};
    static const char *const chine[] = {"chine"};
    barge b;
    batten_loft_report report = {0};
    batten_loft_options options = batten_loft_defaults(0.03);
    options.knuckle_count = options.straight_count = 1;
    options.knuckles = chine;
    options.straight = &run;
    make_barge(&b);
    CHECK_STATUS(batten_hull_loft(b.table, &options, NULL, &report, b.panels),
                 BATTEN_NOT_COMPATIBLE);
    options.within = 0.95 * report.enough;
    CHECK_STATUS(batten_hull_loft(b.table, &options, NULL, NULL, b.panels),
                 BATTEN_NOT_COMPATIBLE);
    options.within = 1.0001 * report.enough;
    CHECK_OK(batten_hull_loft(b.table, &options, NULL, NULL, b.panels));
    free_barge(&b);
}

/* A digit too many at one station of the parallel middle. */
TEST(the_one_point_that_forbids_a_run_is_named)
{
    const batten_loft_straight run = {"chine", 2, 6, BATTEN_LOFT_IN_PROFILE};
    barge b;
    make_barge(&b);
    batten_offset_table_unref(b.table);
    b.points[4][1].z += 0.2;
    CHECK_OK(batten_offset_table_create(1, LINES, b.lines, STATIONS, b.stations, &b.table));
    CHECK_STATUS(loft_barge(&b, 1, &run, NULL), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE(
        "the line 'chine' cannot be straight from station 3 (x = 2) to station 7 (x = 6) "
        "in profile within 0.03 of its points; within 0.");
    CHECK_MESSAGE(" it can; only its point at station 5 (x = 4) forbids it: is that right?");
    free_barge(&b);
}

TEST(runs_that_are_on_no_line_or_in_one_another_are_refused_by_name)
{
    static const struct {
        int count;
        batten_loft_straight runs[2];
        batten_status status;
        const char *message;
    } cases[] = {
        {1,
         {{"wale", 1, 3, BATTEN_LOFT_IN_SPACE}},
         BATTEN_NOT_FOUND,
         "the line 'wale' bounds no panel from station 2 (x = 1) to station 4 (x = 3)"},
        {1,
         {{NULL, 1, 3, BATTEN_LOFT_IN_SPACE}},
         BATTEN_BAD_ARGUMENT,
         "a straight run has no line"},
        {1,
         {{"chine", 3, 3, BATTEN_LOFT_IN_SPACE}},
         BATTEN_BAD_ARGUMENT,
         "the straight run of the line 'chine' is from station 4 to station 4; they must be two of "
         "1 to 8"},
        {1,
         {{"chine", -1, 3, BATTEN_LOFT_IN_SPACE}},
         BATTEN_BAD_ARGUMENT,
         "is from station 0 to station 4"},
        {1,
         {{"chine", 3, STATIONS, BATTEN_LOFT_IN_SPACE}},
         BATTEN_BAD_ARGUMENT,
         "is from station 4 to station 9"},
        {2,
         {{"chine", 4, 5, BATTEN_LOFT_IN_SPACE}, {"chine", 3, 4, BATTEN_LOFT_IN_PLAN}},
         BATTEN_BAD_ARGUMENT,
         "two straight runs of the line 'chine' are so near"},
        {2,
         {{"chine", 3, 4, BATTEN_LOFT_IN_PLAN}, {"chine", 4, 5, BATTEN_LOFT_IN_PROFILE}},
         BATTEN_OK,
         NULL},
        {2,
         {{"deck", 3, 4, BATTEN_LOFT_IN_SPACE}, {"chine", 4, 5, BATTEN_LOFT_IN_SPACE}},
         BATTEN_OK,
         NULL},
        {2,
         {{"deck", 5, 6, BATTEN_LOFT_IN_SPACE}, {"deck", 3, 4, BATTEN_LOFT_IN_SPACE}},
         BATTEN_OK,
         NULL},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        barge b;
        make_barge(&b);
        CHECK_STATUS(loft_barge(&b, cases[k].count, cases[k].runs, NULL), cases[k].status);
        if (cases[k].message)
            CHECK_MESSAGE(cases[k].message);
        free_barge(&b);
    }
}

TEST(runs_without_a_list_or_on_one_surface_are_refused)
{
    barge b;
    batten_loft_options options = batten_loft_defaults(0.03);
    const batten_loft_straight run = {"chine", 3, 5, BATTEN_LOFT_IN_SPACE};
    make_barge(&b);
    CHECK_STATUS(loft_barge(&b, 2, NULL, NULL), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("2 straight runs are declared; their number must be 0 or above");
    CHECK_STATUS(loft_barge(&b, -1, &run, NULL), BATTEN_BAD_ARGUMENT);
    options.straight_count = 1;
    options.straight = &run;
    CHECK_STATUS(batten_surface_loft(b.table, &options, NULL, NULL, b.panels),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("which batten_hull_loft makes: 1 is declared");
    free_barge(&b);
}

/* Of a bow raked by half a station the knots, which are the sheer's, lie off those of the keel: the
 * run reaches out to the next. */
TEST(a_run_on_a_line_with_its_own_ends_reaches_out_to_knots)
{
    const batten_loft_straight run = {"keel", 2, 4, BATTEN_LOFT_IN_PROFILE};
    barge b;
    make_barge(&b);
    batten_offset_table_unref(b.table);
    b.points[STATIONS - 1][0].x -= 0.5;
    CHECK_OK(batten_offset_table_create(1, LINES, b.lines, STATIONS, b.stations, &b.table));
    CHECK_OK(loft_barge(&b, 1, &run, NULL));
    for (int k = 0; k <= 8; k++) {
        double p[3][3];
        for (int s = 0; s < 3; s++)
            CHECK_OK(batten_surface_evaluate(
                b.panels[0], (2 + k / 8. + s / 2.) / (STATIONS - 1.5), 0, 0, p[s]));
        CHECK(fabs(p[0][2] - 2 * p[1][2] + p[2][2]) < 2e-15);
    }
    free_barge(&b);
}
