/* Colours and levels of what is written. */
#include "exchange/shapes.h"

static const double origin[3] = {0, 0, 0};

static void add_point(batten_model *model, const char *layer, const double *colour)
{
    batten_object object = {.name = "p",
                            .layer = layer,
                            .has_colour = colour != NULL,
                            .kind = BATTEN_OBJECT_POINTS,
                            .point_count = 1,
                            .points = origin};
    for (int k = 0; colour && k < 3; k++)
        object.colour[k] = colour[k];
    CHECK_OK(batten_model_add(model, &object));
}

/* How many entities of a type there are, by the odd records of the directory. */
static int count_type(const char *data, size_t size, int type)
{
    char text[9];
    int count = 0;
    snprintf(text, sizeof text, "%8d", type);
    for (size_t at = 0; at < size; at += 81)
        count += data[at + 72] == 'D' && memcmp(data + at, text, 8) == 0;
    return count / 2;
}

/* Each colour is one entity, however often it is used; black and white have no numbers of their own. */
TEST(colours_are_written_once_and_to_six_decimals_of_percents)
{
    static const double colours[][3] = {
        {0, 0, 0}, {1, 1, 1}, {1, 0.5, 0.25}, {1.0 / 3, 2.0 / 3, 0.1}, {1, 0.5, 0.250000001}};
    batten_model *model = NULL, *back = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < 20; i++)
        add_point(model, "", i % 6 < 5 ? colours[i % 6] : NULL);
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_IGES, &data, &size));
    CHECK_INT(count_type(data, size, 314), 4); /* the last is the third */
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
    for (int i = 0; i < 20; i++) {
        const batten_object *object = batten_model_object(back, i);
        CHECK_INT(object->has_colour, i % 6 < 5);
        for (int k = 0; object->has_colour && k < 3; k++)
            CHECK_NEAR(object->colour[k], colours[i % 6][k], 0.5e-8 + 1e-16);
    }
    batten_model_unref(back);
    batten_model_unref(model);
    batten_release(data);
}

/* More colours than are remembered: each is right, whether it was written before or not. */
TEST(any_number_of_colours_reads_back)
{
    enum { COUNT_OF_COLOURS = 300 };
    batten_model *model = NULL, *back = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < 2 * COUNT_OF_COLOURS; i++)
        add_point(model, "", (const double[]){i / 2 % COUNT_OF_COLOURS / 1000.0, 0.5, 1});
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_IGES, &data, &size));
    CHECK_INT(count_type(data, size, 314), COUNT_OF_COLOURS);
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
    for (int i = 0; i < 2 * COUNT_OF_COLOURS; i++)
        CHECK_NEAR(batten_model_object(back, i)->colour[0], i / 2 / 1000.0, 1e-15);
    batten_model_unref(back);
    batten_model_unref(model);
    batten_release(data);
}

/* A layer that is a number of up to seven digits is that level; others get levels above the highest
 * and a property with their name. */
TEST(layers_are_levels_by_number_or_by_name)
{
    static const char *const layers[] = {"1",   "",         "deck", "9999990", "0", "007",
                                         "12x", "10000000", "deck", "-3",      "x"};
    batten_model *model = NULL, *back = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < COUNT(layers); i++)
        add_point(model, layers[i], NULL);
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_IGES, &data, &size));
    /* Of names: each object has one; of levels: deck, 0, 007, 12x, 10000000, -3, x. */
    CHECK_INT(count_type(data, size, 406), COUNT(layers) + 7);
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
    for (int i = 0; i < COUNT(layers); i++)
        CHECK_TEXT(batten_model_object(back, i)->layer, layers[i]);
    batten_model_unref(back);
    batten_model_unref(model);
    batten_release(data);
}

TEST(what_unit_is_written_is_noted_where_it_is_another)
{
    static const struct {
        double unit;
        const char *note;
        double scale;
    } cases[] = {{0, "the model has no unit; written as mm", 1},
                 {2.5, "IGES has no name for the unit; written in mm", 2500},
                 {0.01, "", 1}};
    for (int i = 0; i < COUNT(cases); i++) {
        const double point[3] = {1, 2, 3};
        batten_write_options options = batten_write_defaults();
        batten_model *model = NULL, *back = NULL;
        batten_notes *notes = NULL;
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_notes_create(5, &notes));
        CHECK_OK(batten_model_create(cases[i].unit, &model));
        CHECK_OK(batten_model_add(model, &(batten_object){.name = "p",
                                                          .kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = 1,
                                                          .points = point}));
        options.format = BATTEN_FORMAT_IGES;
        CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
        if (batten_notes_dropped(notes) == 0 && cases[i].note[0])
            CHECK_TEXT(batten_notes_at(notes, 0)->text, cases[i].note);
        else if (batten_notes_dropped(notes) == 0)
            CHECK_INT(batten_notes_count(notes), 0);
        CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
        for (int k = 0; k < 3; k++)
            CHECK_BITS(batten_model_object(back, 0)->points[k], cases[i].scale * point[k]);
        batten_release(data);
        batten_notes_free(notes);
        batten_model_unref(back);
        batten_model_unref(model);
    }
}
