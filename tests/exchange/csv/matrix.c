#include "exchange/reading.h"

TEST(the_corner_says_which_way_a_matrix_stands)
{
    const char *const texts[] = {"x\\z [mm],0,10\n5,1,2\n7,3,4\n",
                                 "z_mm/x_mm,5,7\n0,1,3\n10,2,4\n"};
    for (int i = 0; i < COUNT(texts); i++) {
        batten_model *model = read_noting(texts[i], BATTEN_FORMAT_AUTO, "");
        const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
        const batten_table_station *last = batten_offset_table_station(offsets, 1);
        CHECK_BITS(last->x, 7.0);
        CHECK_BITS(last->points[1].z, 10.0);
        CHECK_BITS(last->points[1].y, 4.0);
        CHECK_BITS(batten_offset_table_unit_metres(offsets), 0.001);
        batten_model_unref(model);
    }
}

TEST(two_columns_or_rows_of_one_station_are_refused)
{
    check_refused("height\\station,0,1,0\n0,1,2,3\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "station x = 0 appears twice in the table, as numbers 1 and 3");
    check_refused("station\\height,0,1\n0,1,2\n0,3,4\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "t:3: station x = 0 appears twice in the table, as numbers 1 and 2");
}

TEST(a_corner_that_makes_no_sense_is_no_matrix)
{
    const char *const corners[] = {"x\\x", "z/height", "x_m\\z_mm", "a\\b", "\\", "xz"};
    char text[64];
    for (int i = 0; i < COUNT(corners); i++) {
        snprintf(text, sizeof text, "%s,0,1\n0,1,2\n", corners[i]);
        check_refused(text, BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT,
                      "no table of offsets");
    }
    check_refused("x\\z,0,b\n0,1,2\n", BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT,
                  "'b' is not");
    check_refused("x\\z,0,1\n0,1,b\n", BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT,
                  "'b' is not");
    check_refused("x\\z,0,1\n0,1\n", BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT,
                  "2 columns");
}
