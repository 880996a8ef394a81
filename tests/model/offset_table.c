#include <batten/hull.h>

#include "support/test.h"

/* Three stations of a small boat; the first and the last have points on the centre line. */
static const batten_table_line lines[] = {
    {"keel", false, 0}, {"z=0.5", true, 0.5}, {"never met", false, 0}, {"sheer", false, 0}};
static const batten_table_point stern[] = {
    {0, 0, 0, 0}, {0, 0, 0.25, -1}, {0, 0, 0.5, 1}, {0, 0.75, 1, 3}};
static const batten_table_point middle[] = {{1, 0, 0, 0}, {1, 1, 0.5, 1}, {1, 1.25, 1, 3}};
static const batten_table_point bow[] = {{2.25, 0.25, 1.25, 3}, {2, 0, 0.5, 1}, {2, 0, 0, 0}};
static const batten_table_station stations[] = {
    {"A", 0, 4, stern}, {"B", 1, 3, middle}, {NULL, 2, 3, bow}};

static batten_status boat(batten_offset_table **out)
{
    return batten_offset_table_create(0.5, COUNT(lines), lines, COUNT(stations), stations, out);
}

TEST(a_table_keeps_copies_of_everything)
{
    batten_offset_table *offsets = NULL;
    CHECK_OK(boat(&offsets));
    CHECK_NEAR(batten_offset_table_unit_metres(offsets), 0.5, 0);
    CHECK_INT(batten_offset_table_line_count(offsets), 4);
    CHECK_INT(batten_offset_table_station_count(offsets), 3);
    CHECK_TEXT(batten_offset_table_line(offsets, 1)->name, "z=0.5");
    CHECK(batten_offset_table_line(offsets, 1)->name != lines[1].name);
    CHECK_TEXT(batten_offset_table_station(offsets, 2)->name, "");
    const batten_table_station *station = batten_offset_table_station(offsets, 0);
    CHECK(station->points != stern && station->point_count == 4);
    CHECK_NEAR(station->points[3].y, 0.75, 0);
    const batten_box box = batten_offset_table_box(offsets);
    CHECK(box.low.x == 0 && box.low.y == 0 && box.low.z == 0);
    CHECK(box.high.x == 2.25 && box.high.y == 1.25 && box.high.z == 1.25);
    batten_offset_table *same = batten_offset_table_ref(offsets);
    CHECK(same == offsets);
    batten_offset_table_unref(offsets);
    batten_offset_table_unref(same);
    batten_offset_table_unref(NULL);
}

TEST(N1_offsets_that_are_not_finite_are_refused)
{
    batten_offset_table *out = NULL;
    CHECK_STATUS(batten_offset_table_create(NAN, 0, NULL, 1, stations, &out),
                 BATTEN_NOT_FINITE);
    const batten_table_line line = {"high", true, INFINITY};
    CHECK_STATUS(batten_offset_table_create(1, 1, &line, 1, stations, &out), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("line 1, \"high\", has the height inf");
    for (int k = 0; k < 3; k++) {
        batten_table_point point = {k == 0 ? NAN : 0, k == 1 ? NAN : 0, k == 2 ? NAN : 0, -1};
        const batten_table_station station = {"A", 0, 1, &point};
        CHECK_STATUS(batten_offset_table_create(1, 0, NULL, 1, &station, &out),
                     BATTEN_NOT_FINITE);
        CHECK_MESSAGE("point 1 of station \"A\"");
    }
    const batten_table_station nowhere = {"A", NAN, 4, stern};
    CHECK_STATUS(batten_offset_table_create(1, 4, lines, 1, &nowhere, &out), BATTEN_NOT_FINITE);
    CHECK(out == NULL);
}

TEST(tables_that_make_no_sense_are_refused)
{
    batten_offset_table *out = NULL;
    const batten_table_station twice[] = {{"A", 1, 4, stern}, {"B", 1, 3, middle}};
    const batten_table_station empty = {"A", 1, 0, stern};
    CHECK_STATUS(batten_offset_table_create(-1, 0, NULL, 1, stations, &out),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_offset_table_create(1, -1, lines, 1, stations, &out),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_offset_table_create(1, 0, NULL, 0, stations, &out),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_offset_table_create(1, 4, lines, 2, twice, &out),
                 BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("station 2, \"B\", stands at x = 1, not beyond the one before, at 1");
    CHECK_STATUS(batten_offset_table_create(1, 4, lines, 1, &empty, &out),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_offset_table_create(1, 3, lines, 1, stations, &out),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("point 4 of station \"A\" is on line 4, but there are 3 lines");
    const batten_table_point point = {0, 0, 0, -2};
    const batten_table_station below = {"A", 1, 1, &point};
    CHECK_STATUS(batten_offset_table_create(1, 4, lines, 1, &below, &out), BATTEN_BAD_ARGUMENT);
    CHECK(out == NULL);
}

TEST(selecting_everything_changes_only_what_no_point_is_on)
{
    const batten_offset_table_selection all = batten_offset_table_everything();
    batten_offset_table *offsets = NULL, *same = NULL;
    CHECK_OK(boat(&offsets));
    CHECK_OK(batten_offset_table_select(offsets, &all, &same));
    CHECK_INT(batten_offset_table_station_count(same), 3);
    CHECK_NEAR(batten_offset_table_unit_metres(same), 0.5, 0);
    CHECK_INT(batten_offset_table_line_count(same), 3);
    CHECK_TEXT(batten_offset_table_line(same, 2)->name, "sheer");
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < stations[i].point_count; j++) {
            const batten_table_point *old = &stations[i].points[j];
            const batten_table_point *new = &batten_offset_table_station(same, i)->points[j];
            CHECK(new->x == old->x &&new->y == old->y &&new->z == old->z);
            CHECK_INT(new->line, old->line == 3 ? 2 : old->line);
        }
    batten_offset_table_unref(same);
    batten_offset_table_unref(offsets);
}

TEST(scaling_and_turning_are_exact)
{
    batten_offset_table_selection selection = batten_offset_table_everything();
    selection.scale = 4;
    selection.unit_metres = 0.125;
    selection.upside_down = selection.reverse = true;
    batten_offset_table *offsets = NULL, *turned = NULL;
    CHECK_OK(boat(&offsets));
    CHECK_OK(batten_offset_table_select(offsets, &selection, &turned));
    CHECK_NEAR(batten_offset_table_unit_metres(turned), 0.125, 0);
    CHECK_TEXT(batten_offset_table_station(turned, 2)->name, "A");
    CHECK_NEAR(batten_offset_table_station(turned, 0)->x, -8, 0);
    const batten_table_point *point = &batten_offset_table_station(turned, 0)->points[0];
    CHECK(point->x == -9 && point->y == 1 && point->z == -5);
    CHECK_NEAR(batten_offset_table_line(turned, 1)->z, -2, 0);
    batten_offset_table_unref(turned);
    batten_offset_table_unref(offsets);
}

TEST(stations_and_lines_without_points_are_left_out)
{
    batten_offset_table_selection selection = batten_offset_table_everything();
    selection.x.b = 1;
    selection.y = (batten_interval){0.5, 1};
    batten_offset_table *offsets = NULL, *part = NULL;
    CHECK_OK(boat(&offsets));
    CHECK_OK(batten_offset_table_select(offsets, &selection, &part));
    CHECK_INT(batten_offset_table_station_count(part), 2);
    CHECK_INT(batten_offset_table_station(part, 1)->point_count, 1);
    CHECK_INT(batten_offset_table_line_count(part), 2);
    CHECK_INT(batten_offset_table_station(part, 1)->points[0].line, 0);
    CHECK_TEXT(batten_offset_table_line(part, 0)->name, "z=0.5");
    CHECK_INT(batten_offset_table_station(part, 0)->points[0].line, 1);
    selection.z.a = 100;
    batten_offset_table *nothing = NULL;
    CHECK_STATUS(batten_offset_table_select(offsets, &selection, &nothing), BATTEN_NOT_FOUND);
    CHECK_MESSAGE("none of the 10 points");
    batten_offset_table_unref(part);
    batten_offset_table_unref(offsets);
}

TEST(of_a_run_on_the_centre_line_the_highest_point_stays)
{
    batten_offset_table_selection selection = batten_offset_table_everything();
    selection.trim_centre = true;
    batten_offset_table *offsets = NULL, *trimmed = NULL;
    CHECK_OK(boat(&offsets));
    CHECK_OK(batten_offset_table_select(offsets, &selection, &trimmed));
    CHECK_INT(batten_offset_table_station(trimmed, 0)->point_count, 2);
    CHECK_NEAR(batten_offset_table_station(trimmed, 0)->points[0].z, 0.5, 0);
    CHECK_INT(batten_offset_table_station(trimmed, 1)->point_count, 3);
    CHECK_INT(batten_offset_table_station(trimmed, 2)->point_count, 2);
    CHECK_NEAR(batten_offset_table_station(trimmed, 2)->points[1].z, 0.5, 0);
    batten_offset_table_unref(trimmed);
    batten_offset_table_unref(offsets);
}

TEST(points_on_the_lines_that_are_named_are_kept)
{
    static const char *const names[] = {"sheer", "keel"}, *const wrong[] = {"keel", "chine"};
    static const batten_table_line given[] = {{"keel", false, 0}, {"wl", true, 1}, {"sheer", false, 0}};
    static const batten_table_point row[] = {
        {0, 0, 0, 0}, {0, 1, 1, 1}, {0, 1.5, 1.5, -1}, {0, 2, 2, 2}};
    const batten_table_station one[] = {{"a", 0, 4, row}, {"b", 1, 2, row + 1}};
    batten_offset_table_selection selection = batten_offset_table_everything();
    batten_offset_table *offsets = NULL, *out = NULL;
    CHECK_OK(batten_offset_table_create(0, 3, given, 2, one, &offsets));
    selection.line_count = 2;
    selection.lines = wrong;
    CHECK_STATUS(batten_offset_table_select(offsets, &selection, &out), BATTEN_NOT_FOUND);
    CHECK_MESSAGE("the table has no line 'chine'; its lines are 'keel', 'wl', 'sheer'");
    selection.lines = NULL;
    CHECK_STATUS(batten_offset_table_select(offsets, &selection, &out), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("2 lines are to be kept");
    selection.line_count = -1;
    CHECK_STATUS(batten_offset_table_select(offsets, &selection, &out), BATTEN_BAD_ARGUMENT);
    CHECK(!out);
    selection.line_count = 2;
    selection.lines = names;
    CHECK_OK(batten_offset_table_select(offsets, &selection, &out));
    CHECK_INT(batten_offset_table_line_count(out), 2);
    CHECK_TEXT(batten_offset_table_line(out, 1)->name, "sheer");
    CHECK_INT(batten_offset_table_station_count(out), 1); /* the other has neither */
    const batten_table_station *s = batten_offset_table_station(out, 0);
    CHECK_INT(s->point_count, 2);
    CHECK(s->points[0].y == 0 && s->points[0].line == 0);
    CHECK(s->points[1].y == 2 && s->points[1].line == 1);
    batten_offset_table_unref(offsets);
    batten_offset_table_unref(out);
}

TEST(selections_that_make_no_sense_are_refused)
{
    batten_offset_table *offsets = NULL, *out = NULL;
    CHECK_OK(boat(&offsets));
    batten_offset_table_selection selection = batten_offset_table_everything();
    selection.scale = 0;
    CHECK_STATUS(batten_offset_table_select(offsets, &selection, &out), BATTEN_BAD_ARGUMENT);
    selection.scale = NAN;
    CHECK_STATUS(batten_offset_table_select(offsets, &selection, &out), BATTEN_NOT_FINITE);
    for (int k = 0; k < 3; k++) {
        selection = batten_offset_table_everything();
        *(k == 0   ? &selection.x
          : k == 1 ? &selection.y
                   : &selection.z) = (batten_interval){1, k == 2 ? NAN : 0};
        CHECK_STATUS(batten_offset_table_select(offsets, &selection, &out),
                     BATTEN_BAD_ARGUMENT);
    }
    CHECK(out == NULL);
    batten_offset_table_unref(offsets);
}

TEST(a_table_without_lines_can_be_selected_from)
{
    const batten_table_point loose[] = {{1, 0, 0, -1}, {1, 1, 1, -1}};
    const batten_table_station station = {"A", 1, 2, loose};
    batten_offset_table_selection selection = batten_offset_table_everything();
    selection.z.a = 0.5;
    batten_offset_table *offsets = NULL, *part = NULL;
    CHECK_OK(batten_offset_table_create(0, 0, NULL, 1, &station, &offsets));
    CHECK_OK(batten_offset_table_select(offsets, &selection, &part));
    CHECK_INT(batten_offset_table_station(part, 0)->points[0].line, -1);
    batten_offset_table_unref(part);
    batten_offset_table_unref(offsets);
}
