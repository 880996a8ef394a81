#include "exchange/reading.h"

/* Read, write, read again, write again: the same table, the same bytes. */
static void check_round_trip(const char *text, batten_format format)
{
    batten_model *model = NULL, *back = NULL;
    char *first = NULL, *second = NULL;
    size_t first_size = 0, second_size = 0;
    CHECK_OK(read_text(text, BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_OK(write_bytes(model, format, &first, &first_size));
    CHECK_OK(read_bytes(first, first_size, BATTEN_FORMAT_AUTO, NULL, &back));
    CHECK_OK(write_bytes(back, format, &second, &second_size));
    CHECK_TEXT(second, first);
    CHECK_BITS(batten_model_unit_metres(back), batten_model_unit_metres(model));
    CHECK_INT(batten_model_count(back), batten_model_count(model));
    batten_release(first);
    batten_release(second);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(tables_are_written_so_that_they_read_back)
{
    const char *const texts[] = {
        "x_m,z_m,half_breadth_m\n0,0,0\n0,1,2\n3,1,4\n",
        "x,z,half_breadth\n0,0,0\n0,0,5\n-0,-0,1e-320\n",
        "section,station_ft,x,z,y,line\nstem,0,-0.5,2,0,\"a \"\"b\"\", c\"\nstem,0,0,1,0.1,\n",
        ("axis,name,stem,1\nlength,station,0,24\nheights,sheer,2-8-6,2-6-1\nwidths,sheer,0-0-7,"
         "1-1-3\n"),
    };
    for (int i = 0; i < COUNT(texts); i++)
        check_round_trip(texts[i], BATTEN_FORMAT_OFFSETS);
}

TEST(a_plain_table_has_three_columns)
{
    batten_model *model = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(read_text("z\\x [mm],0,10\n0,0,1.5\n5,2,\n", BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_OFFSETS, &data, &size));
    CHECK_TEXT(data, "x_mm,z_mm,half_breadth_mm\n0,0,0\n0,5,2\n10,0,1.5\n");
    batten_release(data);
    batten_model_unref(model);
}

TEST(points_and_aerofoils_are_written_so_that_they_read_back)
{
    check_round_trip("1 2\n3 4\n\n5 6 \n", BATTEN_FORMAT_POINTS);
    check_round_trip("x_in,y_in,z_in\n0.1,-0,4.9e-324\n1e300,2,3\n", BATTEN_FORMAT_POINTS);
    check_round_trip("\n\xef\xbb\xbf\n1 0.1\n0 0\n1 -0.1\n", BATTEN_FORMAT_AEROFOIL);
    check_round_trip("NACA 0012\n1 0.1\n0 0\n1 -0.1\n", BATTEN_FORMAT_AEROFOIL);
}

static void check_not_written(const char *text, batten_format format, const char *words)
{
    batten_model *model = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(read_text(text, BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_STATUS(write_bytes(model, format, &data, &size), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE(words);
    CHECK(data == NULL);
    batten_model_unref(model);
}

TEST(what_a_format_cannot_hold_is_refused)
{
    check_not_written("1 2\n3 4\n", BATTEN_FORMAT_OFFSETS, "the model has no table of offsets");
    check_not_written("x,z,half_breadth\n1,2,3\n", BATTEN_FORMAT_POINTS,
                      "the model has no points");
    check_not_written("1 2\n3 4\n", BATTEN_FORMAT_AEROFOIL, "no row of 3 points");
    check_not_written("5 5 0\n0 0 0\n5 -1 0\n", BATTEN_FORMAT_AEROFOIL, "begins with counts");
}

TEST(what_is_left_out_is_noted)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_AEROFOIL;
    const double points[] = {1, 0, 0, 0, 0, 1, 1, -0.1, 0};
    CHECK_OK(batten_model_create(2.5, &model));
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = i ? "second" : "12",
                                                          .kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = 3,
                                                          .points = points}));
    CHECK_OK(batten_notes_create(9, &notes));
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    CHECK_TEXT(data, "aerofoil\n1 0\n0 0\n1 -0.1\n");
    batten_release(data);
    data = NULL;
    options.format = BATTEN_FORMAT_POINTS;
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    CHECK_TEXT(data, "1 0 0\n0 0 1\n1 -0.1 0\n\n1 0 0\n0 0 1\n1 -0.1 0\n");
    if (batten_notes_dropped(notes) == 0) {
        CHECK(has_note(notes, "left out: the format cannot hold this"));
        CHECK(has_note(notes, "the format has no z"));
        CHECK(has_note(notes, "the format cannot hold this name"));
        CHECK(has_note(notes, "a unit of 2.5 m has no name"));
    }
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
}
