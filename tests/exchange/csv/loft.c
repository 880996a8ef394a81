#define _XOPEN_SOURCE 700
#include "exchange/reading.h"

#include <stdlib.h>
#include <strings.h>

static const char table[] = "axis,name,stem,1,transom\n"
                            "length,station,0,24,48\n"
                            "heights,sheer,2-8-6,2-6-1,2-3-5\n"
                            ",chine,x,1-1-0,12.5\n"
                            "\"# stations 24\"\" apart\",,,,\n"
                            "Widths,Chine,x,0-8-3,1-4-7\n"
                            ",sheer,0-0-7,1-1-3,1-11-0\n";

TEST(feet_inches_and_eighths_are_read)
{
    batten_model *model = read_noting(table, BATTEN_FORMAT_AUTO, "");
    const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
    CHECK_BITS(batten_offset_table_unit_metres(offsets), 0.0254);
    CHECK_INT(batten_offset_table_line_count(offsets), 2);
    CHECK_TEXT(batten_offset_table_line(offsets, 0)->name, "chine");
    const batten_table_station *stem = batten_offset_table_station(offsets, 0);
    const batten_table_station *one = batten_offset_table_station(offsets, 1);
    CHECK_TEXT(stem->name, "stem");
    CHECK_INT(stem->point_count, 1);
    CHECK_BITS(stem->points[0].z, 32.75);
    CHECK_BITS(stem->points[0].y, 0.875);
    CHECK_BITS(one->x, 24.0);
    CHECK_BITS(one->points[0].z, 13.0);
    CHECK_BITS(one->points[1].y, 13.375);
    CHECK_BITS(batten_offset_table_station(offsets, 2)->points[0].z, 12.5);
    batten_model_unref(model);
}

TEST(a_table_of_decimals_has_no_unit)
{
    batten_model *model = read_noting("axis,name,0\nlength,x,-1.5\nheight,a,2\nwidth,a,3\n",
                                      BATTEN_FORMAT_AUTO, "");
    CHECK_BITS(batten_offset_table_unit_metres(batten_model_object(model, 0)->offset_table),
               0.0);
    batten_model_unref(model);
}

TEST(a_point_that_is_only_half_given_is_left_out_with_a_note)
{
    batten_model *model =
        read_noting("axis,name,0,1\nlength,x,0,1\nheight,a,2,3\n,b,4,5\nwidth,a,6,x\n",
                    BATTEN_FORMAT_AUTO, "station '1' has a height and no width");
    CHECK_INT(batten_offset_table_line_count(batten_model_object(model, 0)->offset_table), 1);
    batten_model_unref(model);
}

/* A table of one point, and a row that is none. */
static const struct {
    const char *row, *note;
} strange_rows[] = {
    {"diagonals,d1,2\n", "the row 'diagonals, d1' is left out"},
    {"Buttocks,d1,2\n,d2,3\n", "the row 'd2' is left out"},
    {"angle,,90\n", "the row 'angle' is left out"},
};

TEST(rows_that_are_not_known_are_left_out_by_name)
{
    char text[200];
    for (int k = 0; k < COUNT(strange_rows); k++) {
        snprintf(text, sizeof text, "axis,name,0\nlength,x,0\nheight,a,1\nwidth,a,2\n%s",
                 strange_rows[k].row);
        batten_model *model = read_noting(text, BATTEN_FORMAT_AUTO, strange_rows[k].note);
        CHECK_INT(batten_offset_table_station(batten_model_object(model, 0)->offset_table, 0)
                      ->point_count,
                  1);
        batten_model_unref(model);
    }
    batten_model *model =
        read_noting("axis,name,0\nlength,x,0\n,angle,45\nheight,a,1\nwidth,a,2\n",
                    BATTEN_FORMAT_AUTO, "the row 'angle' is left out");
    batten_model_unref(model);
}

TEST(eight_eighths_are_an_inch_with_a_note)
{
    batten_model *model =
        read_noting("axis,name,0\nlength,x,0-0-0\nheight,a,1-0-8\nwidth,a,2\n",
                    BATTEN_FORMAT_AUTO, "'1-0-8' has eight eighths");
    batten_box box;
    CHECK(batten_model_box(model, &box));
    CHECK_BITS(box.high.z, 13);
    batten_model_unref(model);
}

TEST(a_boat_table_without_its_parts_is_refused)
{
    check_refused("axis,name,0\n,x,0\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "t:2: the first column must be length");
    check_refused("axis,name\nlength,x\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "t:1: the first row names no station");
}

TEST(what_is_given_twice_or_not_at_all_is_refused)
{
    check_refused("axis,name,0\nheight,a,1\nwidth,a,1\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "no row of lengths");
    check_refused("axis,name,0\nlength,x,0\n,x,1\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "t:3: the lengths were given before, in line 2");
    check_refused("axis,name,0,1\nlength,x,0,x\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "t:2: column 12: station '1' has no length");
    check_refused("axis,name,0\nlength,x,0\nheight,a,1\n,A,2\n", BATTEN_FORMAT_AUTO,
                  BATTEN_BAD_FORMAT, "t:4: line 'a' was given before, in line 3");
    check_refused("axis,name,a,b\nlength,x,1,1\nheight,a,1,2\nwidth,a,1,2\n",
                  BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "t:3: station 'b' stands at x = 1, where 'a'");
}

TEST(a_station_without_a_name_is_called_by_its_place_and_a_line_needs_one)
{
    batten_model *model =
        read_noting("axis,name,a,,c\nlength,x,0,2.5,5\nheight,k,1,1,1\nwidth,k,1,2,3\n",
                    BATTEN_FORMAT_AUTO, "");
    const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
    CHECK_TEXT(batten_offset_table_station(offsets, 1)->name, "2.5");
    batten_model_unref(model);
    check_refused("axis,name,a\nlength,x,0\nheight,,1\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "t:3: column 8: a line has no name");
}

TEST(feet_that_make_no_sense_are_refused)
{
    const char *const bad[] = {"1-12-0", "1-0-9",        "1-2", "1-2-3-4",
                               "1--2-3", "12345678-0-0", "1-2-"};
    char text[120];
    for (int i = 0; i < COUNT(bad); i++) {
        snprintf(text, sizeof text, "axis,name,0\nlength,x,0\nheight,a,%s\n", bad[i]);
        check_refused(text, BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT, "t:3: column 10: ");
    }
}

/* Numbers from *at on: `count` of them. */
static void next_numbers(const char **at, int count, double *out)
{
    for (int k = 0; k < count; k++) {
        while (!strchr("-.0123456789", **at))
            (*at)++;
        char *end = NULL;
        out[k] = strtod(*at, &end);
        *at = end;
    }
}

/* The other program's file lists "lines": {"name": [[y, z, x], ..]}, with [] where a point is
 * absent. */
static void check_against(const char *csv, const char *json, const char *const *names,
                          int count)
{
    size_t size = 0;
    char *text = load_bytes(test_data(json), &size);
    batten_model *model = NULL;
    CHECK_OK(batten_read_file(test_data(csv), NULL, NULL, NULL, &model));
    const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
    for (int i = 0; i < count; i++) {
        char key[40];
        snprintf(key, sizeof key, "\"%s\": [", names[i]);
        const char *at = strstr(text, key);
        CHECK(at != NULL);
        at += strlen(key);
        for (int s = 0; s < batten_offset_table_station_count(offsets); s++) {
            const batten_table_station *station = batten_offset_table_station(offsets, s);
            double expected[3];
            at = strchr(at, '[') + 1;
            int k = 0;
            while (k < station->point_count &&
                   strcasecmp(batten_offset_table_line(offsets, station->points[k].line)->name,
                              names[i]) != 0)
                k++;
            CHECK_INT(k == station->point_count, *at == ']');
            if (k == station->point_count)
                continue;
            next_numbers(&at, 3, expected);
            CHECK_BITS(station->points[k].y, expected[0]);
            CHECK_BITS(station->points[k].z, expected[1]);
            CHECK_BITS(station->points[k].x, expected[2]);
        }
    }
    batten_model_unref(model);
}

TEST(the_sharpie_and_the_cartopper_have_the_inches_that_others_read)
{
    const char *const sharpie[] = {"coaming", "sheer", "chine", "bottom", "skeg"};
    const char *const cartopper[] = {"gunwale", "chine", "bottom"};
    check_against("hull_offsets/ChesapeakBaySharpie.csv",
                  "hull_offsets/ChesapeakBaySharpie-original.json", sharpie, 5);
    check_against("hull_offsets/Cartopper.csv", "hull_offsets/cartopper.json", cartopper, 3);
}

TEST(the_sport_dory_is_read)
{
    batten_model *model = NULL;
    CHECK_OK(
        batten_read_file(test_data("hull_offsets/SportDory.csv"), NULL, NULL, NULL, &model));
    const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
    CHECK_INT(batten_offset_table_station_count(offsets), 8);
    CHECK_INT(batten_offset_table_line_count(offsets), 6);
    CHECK_TEXT(batten_offset_table_line(offsets, 5)->name, "sheer");
    CHECK_INT(batten_offset_table_station(offsets, 7)->point_count, 3);
    CHECK_BITS(batten_offset_table_station(offsets, 4)->points[0].z, 0.471);
    CHECK_BITS(batten_offset_table_unit_metres(offsets), 0.0);
    batten_model_unref(model);
}
