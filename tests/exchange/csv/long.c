#include "exchange/reading.h"

TEST(names_of_lines_and_stations_may_have_columns)
{
    batten_model *model = read_noting("section,station,x,z,y,line\n"
                                      "stem,0,0,1,0,\"chine, low\"\n"
                                      "stem,0,-0.5,2,0,sheer\n"
                                      "midship,5,5,0.5,2,\"chine, low\"\n"
                                      "midship,5,5,1,2.5,\n"
                                      "midship,5,5,2.5,3,sheer\n",
                                      BATTEN_FORMAT_AUTO, "");
    const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
    const batten_table_station *stem = batten_offset_table_station(offsets, 0);
    const batten_table_station *midship = batten_offset_table_station(offsets, 1);
    CHECK_TEXT(stem->name, "stem");
    CHECK_TEXT(midship->name, "midship");
    CHECK_INT(batten_offset_table_line_count(offsets), 2);
    CHECK_TEXT(batten_offset_table_line(offsets, 0)->name, "chine, low");
    CHECK(!batten_offset_table_line(offsets, 0)->is_waterline);
    /* The stem's own points may be off its station. */
    CHECK_BITS(stem->x, 0.0);
    CHECK_BITS(stem->points[1].x, -0.5);
    /* In the order in which they are listed. */
    CHECK_INT(midship->points[0].line, 0);
    CHECK_INT(midship->points[1].line, -1);
    CHECK_INT(midship->points[2].line, 1);
    batten_model_unref(model);
}

TEST(stations_are_sorted_with_a_note)
{
    batten_model *model =
        read_noting("x,z,half-breadth\n2,0,1\n0,0,1\n2,1,2\n0,1,2\n", BATTEN_FORMAT_AUTO,
                    "the stations do not come in the order");
    const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
    CHECK_BITS(batten_offset_table_station(offsets, 0)->x, 0.0);
    CHECK_INT(batten_offset_table_station(offsets, 1)->point_count, 2);
    batten_model_unref(model);
    /* Waterline by waterline is an order, too. */
    batten_model_unref(
        read_noting("x,z,half-breadth\n0,0,1\n2,0,1\n0,1,2\n2,1,2\n", BATTEN_FORMAT_AUTO, ""));
}

TEST(a_point_given_twice_is_refused_with_both_lines)
{
    check_refused("x,z,half-breadth\n0,1,2\n0,0,1\n0,1,2\n", BATTEN_FORMAT_AUTO,
                  BATTEN_BAD_FORMAT,
                  "t:4: station x = 0 has a second point on the same place, at "
                  "height 1; the first is in line 2");
    check_refused("x,z,y,line\n0,1,2,a\n0,2,3,a\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "t:3: station x = 0 has a second point on line 'a'");
    check_refused("x,z,y,section\n0,1,2,a\n0,2,3,b\n", BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "t:3: station 'b' stands at x = 0, where 'a' of line 2 is");
}

TEST(a_flat_bottom_has_two_points_on_one_waterline)
{
    batten_model *model =
        read_noting("x,z,half-breadth\n0,0,0\n0,0,5\n0,1,5\n", BATTEN_FORMAT_AUTO, "");
    const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
    CHECK_INT(batten_offset_table_station(offsets, 0)->point_count, 3);
    CHECK_BITS(batten_offset_table_station(offsets, 0)->points[1].y, 5.0);
    batten_model_unref(model);
}

TEST(columns_that_are_not_known_or_twice_there_are_named)
{
    batten_model_unref(read_noting("x,z,y,draft\n0,0,1,7\n", BATTEN_FORMAT_OFFSET_TABLE,
                                   "column 'draft' is not read"));
    check_refused("x,z,y,height\n0,0,1,7\n", BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT,
                  "t:1: column 7: 'height' repeats 'z'");
    check_refused("x,z,y\n0,,1\n", BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT,
                  "t:2: column 3");
}

TEST(N5_minus_0_and_denormal_numbers_are_kept)
{
    batten_model *model =
        read_noting("x,z,half-breadth\n-0,-0,4.9e-324\n", BATTEN_FORMAT_AUTO, "");
    const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
    const batten_table_point *point = batten_offset_table_station(offsets, 0)->points;
    CHECK_BITS(point->x, -0.0);
    CHECK_BITS(point->z, -0.0);
    CHECK_BITS(point->y, 4.9406564584124654e-324);
    batten_model_unref(model);
}
