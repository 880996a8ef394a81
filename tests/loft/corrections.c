#include "loft/report.h"

#include "support/test.h"

#include <string.h>

enum { STATIONS = 5, LINES = 5 };

/* How far half-breadths are inside of 1. */
typedef struct {
    double at[STATIONS][LINES];
} inside;

/* A patch y = 1 over x = 4 u, z = v, and a table of five stations and waterlines around it. */
typedef struct {
    bat_loft panel;
    bat_hull_panels panels;
    bat_loft_datum data[STATIONS * LINES];
    batten_offset_table *table;
    batten_loft_report report;
} fixture;

static void make_wall(bat_loft_patch *patch)
{
    double knots[8];
    bat_loft_knots(0, NULL, knots);
    CHECK_OK(bat_loft_patch_make(4, knots, 4, knots, patch));
    for (int k = 0; k < 16; k++) {
        patch->points[3 * k] = k / 4 * 4 / 3.;
        patch->points[3 * k + 1] = 1;
        patch->points[3 * k + 2] = k % 4 / 3.;
    }
}

static void place_points(fixture *f, const inside *off, double within)
{
    batten_table_line lines[LINES];
    batten_table_point points[STATIONS][LINES];
    batten_table_station stations[STATIONS];
    for (int j = 0; j < LINES; j++)
        lines[j] = (batten_table_line){"", true, j / 4.};
    for (int i = 0; i < STATIONS; i++) {
        for (int j = 0; j < LINES; j++) {
            points[i][j] = (batten_table_point){i, 1 - off->at[i][j], j / 4., j};
            f->data[LINES * i + j] = (bat_loft_datum){.point = {i, 1 - off->at[i][j], j / 4.},
                                                      .within = within,
                                                      .in_station = true,
                                                      .on_u_edge = i == 0 || i == STATIONS - 1,
                                                      .on_v_edge = j == 0 || j == LINES - 1,
                                                      .u = i / 4.,
                                                      .v = j / 4.,
                                                      .station = i,
                                                      .index = j};
        }
        stations[i] = (batten_table_station){"", i, LINES, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, LINES, lines, STATIONS, stations, &f->table));
}

static void correct(fixture *f, const inside *off, double within)
{
    bat_loft_moves moves;
    memset(f, 0, sizeof *f);
    make_wall(&f->panel.patch);
    place_points(f, off, within);
    bat_loft_find_feet(&f->panel.patch, STATIONS * LINES, f->data, &moves);
    f->panel.data = f->data;
    f->panel.datum_count = STATIONS * LINES;
    f->panels = (bat_hull_panels){.count = 1, .at = &f->panel};
    f->report.faired = batten_offset_table_ref(f->table);
    CHECK_OK(bat_loft_correct(&f->panels, f->table, &f->report));
}

static void free_fixture(fixture *f)
{
    bat_loft_patch_free(&f->panel.patch);
    batten_offset_table_unref(f->table);
    batten_loft_report_release(&f->report);
}

TEST(corrections_are_sorted_and_leave_out_points_that_did_not_move)
{
    static const inside off = {{{0}, {0, 0.01}, {0, 0, 0.02}, {0, 0, 0, -0.03}}};
    fixture f;
    correct(&f, &off, 0.1);
    CHECK_INT(f.report.correction_count, 3);
    for (int k = 0; k < 3; k++) {
        const batten_loft_correction *c = f.report.corrections + k;
        CHECK_INT(c->station, 3 - k);
        CHECK_INT(c->index, 3 - k);
        CHECK_NEAR(c->distance, 0.03 - 0.01 * k, 1e-14);
        CHECK_NEAR(c->from[1], k == 0 ? 1.03 : 0.97 + 0.01 * k, 1e-14);
    }
    free_fixture(&f);
}

TEST(a_point_at_its_bound_is_held_there_and_others_are_evened_out)
{
    static const inside off = {{{0}, {0, 0.0999, 0.0999}, {0, 0.097}, {0, 0, 0, 0.05}}};
    fixture f;
    correct(&f, &off, 0.1);
    CHECK_INT(f.report.correction_count, 4);
    CHECK_INT(f.report.corrections[0].reason, BATTEN_LOFT_BOUND);
    CHECK_INT(f.report.corrections[1].reason, BATTEN_LOFT_BOUND);
    CHECK_INT(f.report.corrections[2].reason, BATTEN_LOFT_NOISE);
    CHECK_INT(f.report.corrections[3].reason, BATTEN_LOFT_NOISE);
    CHECK_INT(f.report.corrections[0].station, 1);
    CHECK_INT(f.report.corrections[0].index, 1); /* of equal ones the first of the table */
    CHECK_INT(f.report.corrections[1].index, 2);
    free_fixture(&f);
}

/* In its middle a point 0.09 off, neighbours off to the other side; the median is 0.01. */
static const inside spike = {{{.01, .01, .01, .01, .01},
                              {.01, .01, -.01, .01, .01},
                              {.01, -.01, .09, -.01, .01},
                              {.01, .01, -.01, .01, .01},
                              {.01, .01, .01, .01, .01}}};

TEST(a_point_that_alone_is_far_off_is_suspect)
{
    fixture f;
    correct(&f, &spike, 0.2);
    CHECK_INT(f.report.corrections[0].station, 2);
    CHECK_INT(f.report.corrections[0].index, 2);
    CHECK_INT(f.report.corrections[0].reason, BATTEN_LOFT_SUSPECT);
    for (int k = 1; k < f.report.correction_count; k++)
        CHECK_INT(f.report.corrections[k].reason, BATTEN_LOFT_NOISE);
    free_fixture(&f);
}

TEST(a_point_whose_neighbour_is_off_to_the_same_side_is_not_suspect)
{
    for (int side = 0; side < 4; side++) {
        inside off = spike;
        fixture f;
        off.at[side == 0 ? 1 : side == 1 ? 3 : 2][side == 2 ? 1 : side == 3 ? 3 : 2] = 0.01;
        correct(&f, &off, 0.2);
        CHECK_INT(f.report.corrections[0].reason, BATTEN_LOFT_NOISE);
        free_fixture(&f);
    }
}

TEST(points_of_lines_have_a_share_of_the_bound_in_y_and_in_z)
{
    static const inside off = {{{0}, {0}, {0.07, 0, 0.07}, {0.069}}};
    const double within = 0.1; /* its share is 0.0707 */
    fixture f;
    correct(&f, &off, within);
    f.panels.has_rails = true;
    CHECK(bat_loft_holds(&f.panels, &f.panel, f.data + 2 * LINES));
    CHECK(!bat_loft_holds(&f.panels, &f.panel, f.data + 2 * LINES + 2));
    CHECK(!bat_loft_holds(&f.panels, &f.panel, f.data + 3 * LINES));
    f.panels.has_rails = false;
    CHECK(!bat_loft_holds(&f.panels, &f.panel, f.data + 2 * LINES));
    free_fixture(&f);
}
