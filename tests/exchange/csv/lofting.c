/* The loftsman's table: blocks of positions, heights on buttocks, breadths on waterlines. */
#include "exchange/reading.h"

#include <math.h>

static const char table[] = "Stations,Stem,1,2,Post\n"
                            "FORE-AFT POSITION,,,,\n"
                            "Sheer,0-0-0,2-2-2,3-6-3,5-11-0\n"
                            "0-24-0,1-0-0,2-2-2,3-6-3,5-10-0\n"
                            "HEIGHT,,,,\n"
                            "Sheer,5-0-0,5-0-3,4-10-5,5-0-0\n"
                            "Wale,3-6-0,4-7-7,4-6-0,x\n"
                            "0-9-0,x,3-3-6,1-10-7,x\n"
                            "BREADTH,,,,\n"
                            "Sheer,0-0-6,1-6-7,2-3-7,0-0-6\n"
                            "Wale,0-0-6,1-5-7,x,0-0-6\n"
                            "0-24-0,0-0-6,0-4-1,0-10-0,0-0-6\n"
                            "DIAGONAL,,,,\n"
                            "A,1-0-0,1-0-0,1-0-0,1-0-0\n";

/* In the order of the table that is made: stations, and in each from the keel up. */
static const struct {
    int station;
    const char *line;
    double x, y, z;
} points[] = {
    {0, "z=24", 12, 0.75, 24},
    {0, "Wale", 6, 0.75, 42},
    {0, "Sheer", 0, 0.75, 60},
    {1, "z=24", 26.25, 4.125, 24},
    {1, "buttock 0-9-0", 26.25, 9, 39.75},
    {1, "Wale", 26.25, 17.875, 55.875},
    {1, "Sheer", 26.25, 18.875, 60.375},
    {2, "buttock 0-9-0", 42.375, 9, 22.875},
    {2, "z=24", 42.375, 10, 24},
    {2, "Sheer", 42.375, 27.875, 58.625},
    {3, "z=24", 70, 0.75, 24},
    {3, "Sheer", 71, 0.75, 60},
};

TEST(heights_on_buttocks_and_breadths_on_waterlines_make_stations)
{
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(read_text(table, BATTEN_FORMAT_AUTO, notes, &model));
    CHECK_BITS(batten_model_unit_metres(model), 0.0254);
    const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
    CHECK_INT(batten_offset_table_station_count(offsets), 4);
    CHECK_TEXT(batten_offset_table_station(offsets, 3)->name, "Post");
    for (int k = 0, at = 0; k < COUNT(points); k++) {
        const batten_table_station *station =
            batten_offset_table_station(offsets, points[k].station);
        at = k > 0 && points[k].station == points[k - 1].station ? at + 1 : 0;
        CHECK(at < station->point_count);
        const batten_table_point *p = &station->points[at];
        CHECK_TEXT(batten_offset_table_line(offsets, p->line)->name, points[k].line);
        CHECK_NEAR(p->x, points[k].x, 1e-12);
        CHECK_BITS(p->y, points[k].y);
        CHECK_BITS(p->z, points[k].z);
    }
    if (!batten_notes_dropped(notes)) {
        CHECK(has_note(notes, "stations that have a height and no breadth: 1"));
        CHECK(has_note(notes, "stations that have a breadth and no height: 1"));
        CHECK(has_note(notes, "1 row is of diagonals and other blocks left out"));
    }
    batten_notes_free(notes);
    batten_model_unref(model);
}

static const struct {
    const char *text, *words;
} wrong[] = {
    {"Stations,a\nSheer,1\n", "t:2: a title such as HEIGHT or BREADTH must stand before"},
    {"Stations,a\nHEIGHT,\nSheer,1\n", "station 'a' has no position"},
    {"Stations,a,b\nPOSITION,,\nSheer,1,x\n", "station 'b' has no position"},
    {"Stations,a\nPOSITION,\nSheer,q\n", "t:3: column 7: "},
    {"Stations,a\nPOSITION,\nSheer,1,2\n", "t:3: "},
    {"Stations,a,b\nPOSITION,,\nk,1,1\nHEIGHT,,\n2,3,4\n",
     "station x = 1 has a second point on line 'buttock 2'"},
};

TEST(a_loftsman_s_table_that_makes_no_sense_is_refused_with_its_line)
{
    for (int k = 0; k < COUNT(wrong); k++)
        check_refused(wrong[k].text, BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT, wrong[k].words);
}

/* Lengths in decimals have no unit. The titles have many names; 2 is a buttock among heights, a
 * waterline among breadths. */
static const char decimals[] = "Stations,a,b\nLengths,,\nk,0,9\nHeights,,\nk,5,6\n2.5,3,x\n"
                               "Widths,,\nk,4,4.5\n2,3.5,1.5\n";

static const struct {
    int station;
    double x, y, z;
} in_decimals[] = {
    {0, 0, 3.5, 2}, {0, 0, 2.5, 3}, {0, 0, 4, 5}, {1, 9, 1.5, 2}, {1, 9, 4.5, 6}};

TEST(a_loftsman_s_table_in_decimals_has_no_unit)
{
    batten_model *model = read_noting(decimals, BATTEN_FORMAT_AUTO, "");
    const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
    CHECK_BITS(batten_model_unit_metres(model), 0);
    CHECK_INT(batten_offset_table_station(offsets, 0)->point_count, 3);
    CHECK_INT(batten_offset_table_station(offsets, 1)->point_count, 2);
    for (int k = 0; k < COUNT(in_decimals); k++) {
        const int station = in_decimals[k].station;
        const batten_table_point *p =
            &batten_offset_table_station(offsets, station)->points[k - 3 * station];
        CHECK(p->x == in_decimals[k].x && p->y == in_decimals[k].y && p->z == in_decimals[k].z);
    }
    batten_model_unref(model);
}

/* The stem rakes: between its rows of positions its points lie on the line, beyond them at the
 * nearest. */
TEST(points_of_a_raking_stem_lie_between_the_positions_that_are_given)
{
    static const double due[][2] = {{1, 8}, {2, 8}, {3, 6}, {4, 4}, {5, 0}, {6, 0}};
    batten_model *model =
        read_noting("Stations,stem\nPOSITION,\n5,0\n2,8\n4,4\nBREADTH,\n1,1\n2,1\n3,1\n4,1\n"
                    "5,1\n6,1\n",
                    BATTEN_FORMAT_AUTO, "");
    const batten_table_station *stem =
        batten_offset_table_station(batten_model_object(model, 0)->offset_table, 0);
    CHECK_INT(stem->point_count, COUNT(due));
    for (int k = 0; k < COUNT(due); k++) {
        CHECK_BITS(stem->points[k].z, due[k][0]);
        CHECK_NEAR(stem->points[k].x, due[k][1], 1e-15);
    }
    batten_model_unref(model);
}
