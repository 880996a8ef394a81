#include "exchange/reading.h"

static batten_status write_eighths(const batten_model *model, batten_notes *notes, char **data,
                                   size_t *size)
{
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_OFFSET_TABLE;
    options.eighths = true;
    return batten_write_memory(model, &options, notes, data, size);
}

static const char sharpie[] = "axis,name,stem,1\n"
                              "length,station,0,24.0625\n"
                              "heights,sheer,2-8-6,2-6-1\n"
                              ",chine,1-2-0,x\n"
                              "widths,sheer,0-0-7,1-1-3\n"
                              ",chine,0-0-7,x\n";

TEST(feet_inches_and_eighths_come_back_as_they_were)
{
    batten_model *model = NULL, *back = NULL;
    char *first = NULL, *second = NULL;
    size_t size = 0, again = 0;
    CHECK_OK(read_text(sharpie, BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_OK(write_eighths(model, NULL, &first, &size));
    CHECK_CONTAINS(first, "length,station,0,24.0625\n");
    CHECK_CONTAINS(first, ",\"sheer\",2-8-6,2-6-1\n");
    CHECK_CONTAINS(first, "heights,\"chine\",1-2-0,x\n");
    CHECK_CONTAINS(first, ",\"sheer\",0-0-7,1-1-3\n");
    CHECK_OK(read_bytes(first, size, BATTEN_FORMAT_AUTO, NULL, &back));
    CHECK_OK(write_eighths(back, NULL, &second, &again));
    CHECK_TEXT(second, first);
    batten_release(first);
    batten_release(second);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(rounding_to_eighths_is_said)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(read_text("x_m,z_m,half_breadth_m\n0,1,0.5\n0,2,-1\n", BATTEN_FORMAT_AUTO, NULL,
                       &model));
    CHECK_OK(write_eighths(model, notes, &data, &size));
    /* 1 m = 39.370 inches = 3 feet 3 3/8 inches; 0.5 m = 19.685 inches = 1 foot 7 5/8 or 6/8.
     */
    CHECK_CONTAINS(data, "heights,\"z=1\",3-3-3\n");
    CHECK_CONTAINS(data, "widths,\"z=1\",1-7-5\n");
    CHECK_CONTAINS(data, ",\"z=2\",-3-3-3\n");
    if (!batten_notes_dropped(notes))
        CHECK(has_note(notes, "rounded to eighths of an inch, by 1.53 mm at most"));
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(tables_that_are_not_of_lines_are_refused_in_eighths)
{
    static const struct {
        const char *text, *words;
    } cases[] = {
        {"x_m,z_m,half_breadth_m,line\n0,1,0.5,a\n0,2,1,\"\"\n", "is on no line"},
        {"station_m,x_m,z_m,half_breadth_m\n0,0.5,1,0.5\n", "is at x = 0.5, not at 0"},
        {"x,z,half_breadth\n0,1,0.5\n", "the table has no unit"},
        {"x_m,z_m,half_breadth_m\n0,1,0\n0,1,5\n", "line 'z=1' has two points at station"},
        {"x_m,z_m,half_breadth_m\n1e9,1,0.5\n", "too large for feet"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = NULL;
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(read_text(cases[i].text, BATTEN_FORMAT_AUTO, NULL, &model));
        CHECK_STATUS(write_eighths(model, NULL, &data, &size),
                     i < 4 ? BATTEN_NOT_COMPATIBLE : BATTEN_TOO_LARGE);
        CHECK_MESSAGE(cases[i].words);
        CHECK(data == NULL);
        batten_model_unref(model);
    }
}

TEST(a_published_table_in_eighths_is_written_as_it_stands)
{
    batten_model *model = NULL, *back = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_read_file(test_data("hull_offsets/ChesapeakBaySharpie.csv"), NULL, NULL,
                              NULL, &model));
    CHECK_OK(write_eighths(model, NULL, &data, &size));
    CHECK_CONTAINS(data, "1-4-7");
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
    const batten_offset_table *a = batten_model_object(model, 0)->offset_table;
    const batten_offset_table *b = batten_model_object(back, 0)->offset_table;
    CHECK_INT(batten_offset_table_station_count(a), batten_offset_table_station_count(b));
    for (int i = 0; i < batten_offset_table_station_count(a); i++) {
        const batten_table_station *s = batten_offset_table_station(a, i);
        const batten_table_station *t = batten_offset_table_station(b, i);
        CHECK_INT(s->point_count, t->point_count);
        for (int k = 0; k < s->point_count; k++) {
            CHECK_BITS(s->points[k].y, t->points[k].y);
            CHECK_BITS(s->points[k].z, t->points[k].z);
        }
    }
    batten_release(data);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(whole_lengths_come_out_whole_after_a_change_of_the_unit)
{
    batten_model *model = NULL, *feet = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(read_text("station_in,z_in,half_breadth_in\n24,1.5,2.25\n48.125,1.5,3\n",
                       BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_OK(batten_model_to_unit(model, 0.3048, &feet));
    CHECK_OK(write_eighths(feet, NULL, &data, &size));
    CHECK_CONTAINS(data, "length,station,2-0-0,4-0-1\n");
    CHECK_CONTAINS(data, "0-1-4,0-1-4\n");
    batten_release(data);
    batten_model_unref(feet);
    batten_model_unref(model);
}
