/* Layers, their colours, and which of them are shown. */
#include "exchange/dxf/dxf.h"
#include "exchange/dxf/groups.h"
#include "exchange/reading.h"
#include "exchange/shapes/paths.h"

/* Lines of these colours, and one without, on one layer. */
static batten_model *coloured_lines(int count, const double (*colours)[3])
{
    const double a[3] = {0, 0, 0}, b[3] = {1, 2, 0};
    batten_model *model = NULL;
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &line));
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i <= count; i++) {
        batten_object object = {.name = "line",
                                .layer = "lines",
                                .has_colour = i < count,
                                .kind = BATTEN_OBJECT_CURVE,
                                .curve = line};
        if (i < count)
            memcpy(object.colour, colours[i], sizeof object.colour);
        CHECK_OK(batten_model_add(model, &object));
    }
    batten_curve_unref(line);
    return model;
}

TEST(colours_of_the_palette_come_back_and_others_as_24_bits)
{
    enum { OTHERS = 3 };
    double colours[255 + OTHERS][3] = {
        [255] = {1, 128 / 255.0, 0}, [256] = {0.3, 0.2, 0.1}, [257] = {0, 0, 1 / 255.0}};
    for (int i = 0; i < 255; i++)
        CHECK(bat_dxf_colour(i + 1, colours[i]));
    batten_model *model = coloured_lines(COUNT(colours), (const double(*)[3])colours);
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_DXF;
    batten_model *back = there_and_back(model, &options, NULL);
    for (int i = 0; i < COUNT(colours); i++)
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(batten_model_object(back, i)->colour[k], colours[i][k],
                       i == 256 ? 0.5 / 255 : 1e-15);
    batten_model_unref(back);
    batten_model_unref(model);
}

/* The number 7, which is black or white, is for what has no colour. */
TEST(black_and_white_and_none_come_back)
{
    const double colours[2][3] = {{0, 0, 0}, {1, 1, 1}};
    batten_model *model = coloured_lines(2, colours);
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_DXF;
    batten_model *back = there_and_back(model, &options, NULL);
    for (int i = 0; i < 2; i++) {
        CHECK(batten_model_object(back, i)->has_colour);
        CHECK(memcmp(batten_model_object(back, i)->colour, colours[i], sizeof *colours) == 0);
    }
    CHECK(!batten_model_object(model, 2)->has_colour &&
          !batten_model_object(back, 2)->has_colour);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(only_colours_of_24_bits_need_release_2004)
{
    const double orange[1][3] = {{1, 0.5, 0}}, other[1][3] = {{1, 0.6, 0}};
    batten_model *model = coloured_lines(1, orange);
    double index = 0;
    const char *text = written(model, BATTEN_FORMAT_DXF);
    CHECK(strstr(text, "AC1015") && !strstr(text, "\n420\n"));
    CHECK(strstr(text, "lines\n 70\n0\n 62\n30\n") != NULL);
    /* The second line has no colour, and not that of its layer. */
    const char *second = entity(entity(text, "LINE"), "LINE");
    CHECK_INT(numbers(entity(text, "LINE"), 62, &index, 1), 0);
    CHECK_INT(numbers(second, 62, &index, 1), 1);
    CHECK_NEAR(index, 7, 0);
    batten_model_unref(model);
    model = coloured_lines(1, other);
    text = written(model, BATTEN_FORMAT_DXF);
    CHECK(strstr(text, "AC1018") && strstr(text, "\n420\n16750848\n"));
    batten_model_unref(model);
}

/* The layer of a colour, written so: its row in the table of layers. */
static bool has_layer(const char *text, const char *name, int colour)
{
    char row[80];
    snprintf(row, sizeof row, "\n  2\n%s\n 70\n0\n 62\n%d\n", name, colour);
    return strstr(text, row) != NULL;
}

TEST(layers_of_dxf_have_the_colour_of_most_and_are_off_when_all_is_hidden)
{
    const struct {
        const char *layer;
        int colour;
        bool is_hidden;
    } lines[] = {{"holes", 2, false}, {"holes", 5, false}, {"holes", 5, false},
                 {"off", 3, true},    {"off", 3, true},    {"half", 4, true},
                 {"half", 4, false},  {"0", 1, true}};
    batten_model *model = NULL;
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(2, (double[]){0, 0}, (double[]){1, 0}, &line));
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < COUNT(lines); i++) {
        batten_object object = {.name = "line",
                                .layer = lines[i].layer,
                                .is_hidden = lines[i].is_hidden,
                                .has_colour = true,
                                .kind = BATTEN_OBJECT_CURVE,
                                .curve = line};
        CHECK(bat_dxf_colour(lines[i].colour, object.colour));
        CHECK_OK(batten_model_add(model, &object));
    }
    const char *text = written(model, BATTEN_FORMAT_DXF);
    CHECK(has_layer(text, "holes", 5));
    CHECK(has_layer(text, "off", -3));
    CHECK(has_layer(text, "half", 4));
    CHECK(has_layer(text, "0", -7));
    /* Switching the layer on shows what is on it; only one object is hidden by itself. */
    const char *hidden = strstr(text, "\n 60\n1\n");
    CHECK(hidden && !strstr(hidden + 1, "\n 60\n1\n"));
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_DXF;
    batten_model *back = there_and_back(model, &options, NULL);
    for (int i = 0; i < COUNT(lines); i++) {
        const batten_object *object = batten_model_object(back, i);
        double colour[3];
        CHECK(bat_dxf_colour(lines[i].colour, colour));
        CHECK(object->is_hidden == lines[i].is_hidden);
        CHECK(memcmp(object->colour, colour, sizeof colour) == 0);
    }
    batten_model_unref(back);
    batten_model_unref(model);
    batten_curve_unref(line);
}

/* A layer of lines in these numbered colours, in their order. */
static const char *text_of_colours(int count, const int *numbers)
{
    batten_model *model = NULL;
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(2, (double[]){0, 0}, (double[]){1, 0}, &line));
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < count; i++) {
        batten_object object = {.name = "line",
                                .layer = "holes",
                                .has_colour = true,
                                .kind = BATTEN_OBJECT_CURVE,
                                .curve = line};
        if (numbers[i])
            CHECK(bat_dxf_colour(numbers[i], object.colour));
        CHECK_OK(batten_model_add(model, &object));
    }
    const char *text = written(model, BATTEN_FORMAT_DXF);
    batten_model_unref(model);
    batten_curve_unref(line);
    return text;
}

TEST(of_colours_that_are_equally_frequent_a_layer_has_the_first)
{
    CHECK(has_layer(text_of_colours(2, (int[]){2, 5}), "holes", 2));
    CHECK(has_layer(text_of_colours(2, (int[]){5, 2}), "holes", 5));
    CHECK(has_layer(text_of_colours(4, (int[]){5, 2, 2, 5}), "holes", 5));
    CHECK(has_layer(text_of_colours(4, (int[]){2, 5, 5, 2}), "holes", 2));
    CHECK(has_layer(text_of_colours(3, (int[]){2, 5, 5}), "holes", 5));
}

/* Black has no number of its own: it is 24 bits of 0. */
TEST(black_is_a_colour_of_24_bits_and_needs_release_2004)
{
    const char *text = text_of_colours(1, (int[]){0});
    CHECK(strstr(text, "AC1018") && strstr(text, "\n420\n0\n"));
}
