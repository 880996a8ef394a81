#include "exchange/csv/gather.h"

#include "exchange/reading.h"

TEST(a_station_without_points_is_left_out_with_a_note)
{
    batten_model *model =
        read_noting("x,z,half-breadth\n0,0,\n0,1,-\n1,0,2\n", BATTEN_FORMAT_AUTO,
                    "station x = 0 has no points; left out");
    CHECK_INT(batten_offset_table_station_count(batten_model_object(model, 0)->offset_table),
              1);
    batten_model_unref(model);
}

/* Points in a random order, waterlines by their heights. */
TEST(the_order_in_which_points_of_waterlines_come_does_not_matter)
{
    test_random random = test_random_begin(__func__);
    for (int round = 0; round < test_cases(40); round++) {
        const int lines = test_random_int(&random, 1, 6),
                  stations = test_random_int(&random, 1, 6);
        int order[36];
        char text[3000] = "x,z,half-breadth\n";
        for (int i = 0; i < lines * stations; i++)
            order[i] = i;
        for (int i = lines * stations - 1; i > 0; i--) {
            const int k = test_random_int(&random, 0, i), kept = order[i];
            order[i] = order[k];
            order[k] = kept;
        }
        for (int i = 0; i < lines * stations; i++) {
            const int line = order[i] % lines, station = order[i] / lines;
            snprintf(text + strlen(text), sizeof text - strlen(text), "%d,%d,%d\n", station,
                     10 - line, line);
        }
        batten_model *model = NULL;
        CHECK_OK(read_text(text, BATTEN_FORMAT_AUTO, NULL, &model));
        const batten_offset_table *offsets = batten_model_object(model, 0)->offset_table;
        CHECK_INT(batten_offset_table_station_count(offsets), stations);
        for (int s = 0; s < stations; s++)
            for (int k = 0; k < lines; k++) {
                const batten_table_point *point =
                    &batten_offset_table_station(offsets, s)->points[k];
                CHECK_INT(point->line, k);
                CHECK_BITS(batten_offset_table_line(offsets, k)->z, 10.0 - (lines - 1 - k));
                CHECK_BITS(point->y, (double)(lines - 1 - k));
            }
        batten_model_unref(model);
    }
}
