/* Tables of frames, which are numbers alone. */
#include "exchange/reading.h"

static const struct {
    const char *text, *note;
} tables[] = {
    {"2\n0.0\n3\n0 0\n1 1\n2 3\n5.0\n2\n0 0.5\n1.5 3\n", ""},
    {"2\r\n0.0\r\n3\r\n0 0 0\r\n1 1 0\r\n2 3 0\r\n5.0\r\n2\r\n0 0.5 0\r\n1.5 3 0\r\n", ""},
    {"2 T 0.96\n 0.0 3 0\n 0 1 2\n 0 1 3\n 5.0 2 0\n 0 1.5\n 0.5 3\n", ""},
    {"2 F 0.96\n 0.0 3 1 2\n 0 1 2\n 0 1 3\n 5.0 2 0\n 0 1.5\n 0.5 3\n", "section 1 has 1 gap"},
};

TEST(frames_of_PIAS_and_sections_of_PDSTRIP_are_tables_of_offsets)
{
    for (int k = 0; k < COUNT(tables); k++) {
        batten_model *model = read_noting(tables[k].text, BATTEN_FORMAT_AUTO, tables[k].note);
        const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
        CHECK_INT(batten_offset_table_station_count(offsets), 2);
        const batten_table_station *first = batten_offset_table_station(offsets, 0),
                                   *second = batten_offset_table_station(offsets, 1);
        CHECK_INT(first->point_count, 3);
        CHECK_INT(second->point_count, 2);
        CHECK_BITS(first->points[1].y, 1);
        CHECK_BITS(first->points[2].z, 3);
        CHECK_BITS(second->points[1].x, 5);
        CHECK_BITS(second->points[1].y, 1.5);
        CHECK_BITS(second->points[1].z, 3);
        batten_model_unref(model);
    }
}

TEST(numbers_that_do_not_come_out_even_as_frames_are_points)
{
    static const char *const rows[] = {"1 2 3\n4 5 6\n7 8 9\n", "1 0 2\n3 4 5\n"};
    for (int k = 0; k < COUNT(rows); k++) {
        batten_model *model = read_noting(rows[k], BATTEN_FORMAT_AUTO, "");
        CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_POINTS);
        batten_model_unref(model);
    }
    check_refused("2\n0.0\n3\n0 0\n1 1\n2 3\n5.0\n2\n0 0.5\n1.5 3\n7\n",
                  BATTEN_FORMAT_OFFSET_TABLE, BATTEN_BAD_FORMAT, "t:1: ");
}
