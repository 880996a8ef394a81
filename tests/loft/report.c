#include "loft/report.h"

#include "support/test.h"

#include <math.h>

enum { STATIONS = 4, LINES = 3 };

/* A prism of keel, chine and sheer, whose keel lies 0.01 too high at the third station. */
static batten_offset_table *make_table(void)
{
    static const batten_table_line lines[] = {
        {"keel", false, 0}, {"chine", false, 0}, {"sheer", false, 0}};
    static const double section[LINES][2] = {{0, 0}, {0.8, 0.2}, {1, 1}};
    batten_table_point points[STATIONS][LINES];
    batten_table_station stations[STATIONS];
    batten_offset_table *table = NULL;
    for (int i = 0; i < STATIONS; i++) {
        for (int j = 0; j < LINES; j++)
            points[i][j] = (batten_table_point){i, section[j][0], section[j][1], j};
        if (i == 2)
            points[i][0].z += 0.01;
        stations[i] = (batten_table_station){"", i, LINES, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, LINES, lines, STATIONS, stations, &table));
    return table;
}

static batten_status make_panels(const batten_offset_table *table,
                                 const batten_loft_options *options, bat_hull_panels *out)
{
    batten_status status = bat_hull_panels_make(table, options, NULL, out);
    if (status == BATTEN_OK)
        status = bat_hull_panels_run(out);
    if (status != BATTEN_OK)
        bat_hull_panels_free(out);
    return status;
}

TEST(a_report_counts_cuts_panels_and_moves_of_what_was_made)
{
    static const char *const chine[] = {"chine"};
    /* Seen from the side and from above: the profile, the chine, the sheer. */
    static const struct {
        batten_loft_family family;
        int panel;
    } cuts[] = {{BATTEN_LOFT_PROFILE, 0}, {BATTEN_LOFT_PROFILE, 0}, {BATTEN_LOFT_KNUCKLE, 1},
                {BATTEN_LOFT_KNUCKLE, 1}, {BATTEN_LOFT_SHEER, 1},   {BATTEN_LOFT_SHEER, 1}};
    batten_offset_table *table = make_table();
    batten_loft_options options = batten_loft_defaults(0.02);
    bat_hull_panels panels;
    batten_loft_report report;
    options.knuckle_count = 1;
    options.knuckles = chine;
    CHECK_OK(make_panels(table, &options, &panels));
    CHECK_OK(bat_loft_fill_report(&panels, table, &report));
    CHECK_INT(report.cut_count, COUNT(cuts));
    for (int k = 0; k < COUNT(cuts); k++) {
        CHECK_INT(report.cuts[k].family, cuts[k].family);
        CHECK_INT(report.cuts[k].panel, cuts[k].panel);
        CHECK_INT(report.cuts[k].found, 0);
    }
    CHECK(report.panel_count == 2 && report.ruled_count == 2 && report.cuts_in_excess == 0);
    double squares = 0, most = 0;
    for (int k = 0; k < report.correction_count; k++) {
        const batten_loft_correction *c = report.corrections + k;
        CHECK_INT(c->index, 0); /* of the keel alone */
        CHECK_NEAR(c->distance, fabs(c->to[2] - c->from[2]), 1e-15);
        squares += c->distance * c->distance;
        most = fmax(most, c->distance);
    }
    CHECK_NEAR(report.rms_move, sqrt(squares / (STATIONS * LINES)), 1e-15);
    CHECK(report.max_move == most && most > 0 && most <= 0.02 && report.worst_index == 0);
    CHECK(report.faired_error <= 1e-13);
    bat_hull_panels_free(&panels);
    batten_loft_report_release(&report);
    CHECK(!report.cuts && !report.corrections && !report.faired);
    batten_offset_table_unref(table);
}

TEST(a_report_adds_up_its_panels_and_names_the_place_of_the_largest_move)
{
    static const char *const chine[] = {"chine"};
    batten_offset_table *table = make_table();
    batten_loft_options options = batten_loft_defaults(0.02);
    bat_hull_panels panels;
    batten_loft_report report;
    options.knuckle_count = 1;
    options.knuckles = chine;
    CHECK_OK(make_panels(table, &options, &panels));
    panels.reached[0] = (bat_loft_reached){.rounds = 3, .excess = 20, .cuts_in_excess = 100};
    panels.reached[1] = (bat_loft_reached){.rounds = 4, .excess = 50, .cuts_in_excess = 600};
    panels.at[0].height = 0.125;
    panels.at[0].trimmed = 9;
    for (int p = 0; p < 2; p++)
        for (int k = 0; k < panels.at[p].datum_count; k++)
            panels.at[p].data[k].move = 0;
    bat_loft_datum *worst = panels.at[1].data + panels.at[1].datum_count - 1;
    worst[0].move = 0.004;
    panels.at[0].data[1].move = 0.003;
    CHECK_OK(bat_loft_fill_report(&panels, table, &report));
    CHECK(report.rounds == 7 && report.excess_inflections == 70);
    CHECK_INT(report.cuts_in_excess, 700);
    CHECK(report.height == 0.125 && report.trimmed_count == 9);
    CHECK(report.max_move == 0.004 && worst->station > 0 && worst->index > 0);
    CHECK_INT(report.worst_station, worst->station);
    CHECK_INT(report.worst_index, worst->index);
    const int count = panels.at[0].datum_count + panels.at[1].datum_count;
    CHECK_NEAR(report.rms_move, 0.005 / sqrt(count), 1e-17);
    bat_hull_panels_free(&panels);
    batten_loft_report_release(&report);
    batten_offset_table_unref(table);
}

/* ---- planks ---- */

/* A boat whose bottom is a plane and whose side has a twisted bow. */
static batten_offset_table *make_plank_boat(void)
{
    enum { PLACES = 9 };
    static const batten_table_line lines[LINES] = {
        {"keel", false, 0}, {"chine", false, 0}, {"sheer", false, 0}};
    batten_table_point points[PLACES][LINES];
    batten_table_station stations[PLACES];
    batten_offset_table *table = NULL;
    for (int i = 0; i < PLACES; i++) {
        const double s = i / 8., bow = s * s * s;
        points[i][0] = (batten_table_point){6 * s, 0, 0, 0};
        points[i][1] = (batten_table_point){6 * s, 1 - 0.9 * bow, 0.1, 1};
        points[i][2] = (batten_table_point){6 * s, 1.2 - 0.3 * bow, 1, 2};
        stations[i] = (batten_table_station){"", 6 * s, LINES, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, LINES, lines, PLACES, stations, &table));
    return table;
}

TEST(warps_of_planks_are_told_with_their_place)
{
    static const char *const chine[] = {"chine"};
    batten_offset_table *table = make_plank_boat();
    batten_loft_options options = batten_loft_defaults(1e-3);
    batten_loft_report report;
    batten_surface *panels[2] = {NULL};
    options.knuckle_count = 1;
    options.knuckles = chine;
    CHECK_OK(batten_hull_loft(table, &options, NULL, &report, panels));
    CHECK_INT(report.warp_count, 2);
    for (int k = 0; k < 2; k++) {
        const batten_loft_warp *w = report.warps + k;
        CHECK_INT(w->panel, k);
        CHECK(w->median <= w->most && w->most <= w->largest);
        for (int side = 0; side < 2; side++)
            CHECK(w->at[side] >= 0 && w->at[side] <= 6);
        CHECK(fabs(w->at[1] - w->at[0]) <= 0.12 * 6 + 1e-12);
    }
    CHECK(report.warps[0].largest > 0.01); /* the twist of the bow's bottom */
    batten_loft_report_release(&report);
    CHECK(!report.warps);
    for (int k = 0; k < 2; k++)
        batten_surface_unref(panels[k]);
    batten_offset_table_unref(table);
}
