#include "exchange/reading.h"
#include "exchange/shapes/paths.h"

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
        check_round_trip(texts[i], BATTEN_FORMAT_OFFSET_TABLE);
}

TEST(a_plain_table_has_three_columns)
{
    batten_model *model = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(read_text("z\\x [mm],0,10\n0,0,1.5\n5,2,\n", BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_OFFSET_TABLE, &data, &size));
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
    check_not_written("1 2\n3 4\n", BATTEN_FORMAT_OFFSET_TABLE,
                      "the model has no table of offsets");
    check_not_written("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", BATTEN_FORMAT_POINTS,
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
        CHECK(has_note(notes, "left out: the format cannot hold this row of points"));
        CHECK(has_note(notes, "the format has no z"));
        CHECK(has_note(notes, "the format cannot hold this name"));
        CHECK(has_note(notes, "a unit of 2.5 m has no name"));
    }
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(points_have_commas_in_csv_and_read_back_to_the_same_bits)
{
    const double points[] = {1.0 / 3, -0.0, 4.9e-324, 1e300, 2, 3, 0.1, 0.2, 0.3};
    batten_model *model = NULL, *back = NULL;
    const char *path = test_scratch("commas.csv");
    size_t size = 0;
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = "",
                                                          .kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = i ? 3 : 2,
                                                          .points = points}));
    CHECK_OK(batten_write_file(model, path, NULL, NULL));
    CHECK(strncmp(load_bytes(path, &size), "x_mm,y_mm,z_mm\n0.33", 19) == 0);
    CHECK_OK(batten_read_file(path, NULL, NULL, NULL, &back));
    CHECK_INT(batten_model_count(back), 2);
    for (int i = 0; i < 2; i++) {
        const batten_object *object = batten_model_object(back, i);
        CHECK_INT(object->point_count, i ? 3 : 2);
        for (int k = 0; k < 3 * object->point_count; k++)
            CHECK_BITS(object->points[k], points[k]);
    }
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(tables_are_written_as_the_points_of_their_stations)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_FORMAT_POINTS;
    CHECK_OK(read_text("z\\x [mm],0,10\n0,0,1.5\n5,2,\n", BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_OK(batten_notes_create(9, &notes));
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    CHECK_TEXT(data, "x_mm y_mm z_mm\n0 0 0\n0 2 5\n\n10 1.5 0\n");
    if (batten_notes_dropped(notes) == 0) {
        CHECK(has_note(notes, "a row for each of 2 stations"));
        CHECK(!has_note(notes, "left out"));
    }
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(tables_in_another_unit_have_no_debris_and_no_old_names)
{
    batten_model *model = NULL, *other = NULL;
    const struct {
        double metres;
        const char *text;
    } units[] = {
        {0.001, "x_mm,z_mm,half_breadth_mm\n609.6,40.64,53.34\n1219.2,40.64,83.82\n"},
        {0.01, "x_cm,z_cm,half_breadth_cm\n60.96,4.064,5.334\n121.92,4.064,8.382\n"},
        {1, "x_m,z_m,half_breadth_m\n0.6096,0.04064,0.05334\n1.2192,0.04064,0.08382\n"}};
    CHECK_OK(read_text("x_in,z_in,half_breadth_in\n24,1.6,2.1\n48,1.6,3.3\n",
                       BATTEN_FORMAT_AUTO, NULL, &model));
    for (int i = 0; i < COUNT(units); i++) {
        CHECK_OK(batten_model_to_unit(model, units[i].metres, &other));
        CHECK_TEXT(written(other, BATTEN_FORMAT_OFFSET_TABLE), units[i].text);
        const batten_offset_table *table = batten_model_object(other, 0)->offset_table;
        CHECK(strcmp(batten_offset_table_station(table, 0)->name, "24") != 0);
        CHECK(strcmp(batten_offset_table_line(table, 0)->name, "z=1.6") != 0);
        batten_model_unref(other);
    }
    batten_model_unref(model);
}

/* The numbers stay: a table is written in its own unit, and in that of the model when it has
 * none. */
TEST(a_table_names_its_own_unit_before_that_of_the_model)
{
    static const struct {
        double own;
        const char *head;
    } cases[] = {{0.0254, "x_in,z_in,half_breadth_in\n"}, {0, "x_mm,z_mm,half_breadth_mm\n"}};
    const batten_table_point point = {.x = 1, .y = 2, .z = 3, .line = -1};
    const batten_table_station station = {
        .name = "", .x = 1, .point_count = 1, .points = &point};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = NULL;
        batten_offset_table *table = NULL;
        char expected[80];
        CHECK_OK(batten_offset_table_create(cases[i].own, 0, NULL, 1, &station, &table));
        CHECK_OK(batten_model_create(0.001, &model));
        CHECK_OK(batten_model_add(model, &(batten_object){.name = "t",
                                                          .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                                          .offset_table = table}));
        const char *text = written(model, BATTEN_FORMAT_OFFSET_TABLE);
        snprintf(expected, sizeof expected, "%.*s", (int)strcspn(cases[i].head, "\n"),
                 cases[i].head);
        CHECK(strncmp(text, expected, strlen(expected)) == 0);
        CHECK_CONTAINS(text, "\n1,3,2");
        batten_offset_table_unref(table);
        batten_model_unref(model);
    }
}
