#include "exchange/reading.h"

/* One number to a millimetre on a sheet of 100 x 50: (x, y) becomes (x, 50 - y). */
static batten_model *read_path(const char *attributes)
{
    char text[1000];
    batten_model *model = NULL;
    snprintf(
        text, sizeof text,
        "<svg width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\">\n<path %s/>\n</svg>\n",
        attributes);
    CHECK_OK(read_text(text, BATTEN_FORMAT_SVG, NULL, &model));
    return model;
}

static void check_same_points(const char *one, const char *other)
{
    batten_model *a = read_path(one), *b = read_path(other);
    CHECK_INT(batten_model_count(a), batten_model_count(b));
    for (int i = 0; i < batten_model_count(a); i++) {
        const batten_curve *p = batten_model_object(a, i)->curve,
                           *q = batten_model_object(b, i)->curve;
        CHECK_INT(batten_curve_degree(p), batten_curve_degree(q));
        CHECK_INT(batten_curve_point_count(p), batten_curve_point_count(q));
        const int d = batten_curve_dimension(p);
        for (int k = 0; k < d * batten_curve_point_count(p); k++)
            CHECK_NEAR(batten_curve_points(p)[k], batten_curve_points(q)[k], 1e-12);
    }
    batten_model_unref(a);
    batten_model_unref(b);
}

TEST(small_letters_count_from_where_the_path_stands)
{
    static const char *const pairs[][2] = {
        {"d=\"m10 5l3 4\"", "d=\"M10 5L13 9\""},
        {"d=\"M10 5h3v4h-2\"", "d=\"M10 5H13V9H11\""},
        {"d=\"M10 5c1 2 3 4 5 6\"", "d=\"M10 5C11 7 13 9 15 11\""},
        {"d=\"M10 5s3 4 5 6\"", "d=\"M10 5S13 9 15 11\""},
        {"d=\"M10 5q3 4 5 6\"", "d=\"M10 5Q13 9 15 11\""},
        {"d=\"M10 5t5 6\"", "d=\"M10 5T15 11\""},
        {"d=\"M10 5a4 4 0 0 1 4 4\"", "d=\"M10 5A4 4 0 0 1 14 9\""},
        {"d=\"M10 5l3 4m1 1l2 0\"", "d=\"M10 5L13 9M14 10L16 10\""},
        {"d=\"M10 5l3 0l0 4zl1 1\"", "d=\"M10 5L13 5L13 9ZL11 6\""},
        {"d=\"M10 5 3 4 6 8\"", "d=\"M10 5L3 4L6 8\""},
        {"d=\"m10 5 3 4 6 8\"", "d=\"M10 5L13 9L19 17\""}};
    for (int i = 0; i < COUNT(pairs); i++)
        check_same_points(pairs[i][0], pairs[i][1]);
}

TEST(smooth_commands_begin_with_the_mirror_of_their_own_kind_alone)
{
    static const char *const pairs[][2] = {
        {"d=\"M0 0C1 2 3 4 5 5S9 1 9 0\"", "d=\"M0 0C1 2 3 4 5 5C7 6 9 1 9 0\""},
        {"d=\"M0 0S3 4 5 5S9 1 9 0\"", "d=\"M0 0C0 0 3 4 5 5C7 6 9 1 9 0\""},
        {"d=\"M0 0Q3 4 5 5T9 0\"", "d=\"M0 0Q3 4 5 5Q7 6 9 0\""},
        {"d=\"M0 0Q3 4 5 5T9 0T12 1\"", "d=\"M0 0Q3 4 5 5Q7 6 9 0Q11 -6 12 1\""},
        {"d=\"M0 0Q3 4 5 5S9 1 9 0\"", "d=\"M0 0Q3 4 5 5C5 5 9 1 9 0\""},
        {"d=\"M0 0C1 2 3 4 5 5T9 0\"", "d=\"M0 0C1 2 3 4 5 5Q5 5 9 0\""},
        {"d=\"M0 0L5 5S9 1 9 0\"", "d=\"M0 0L5 5C5 5 9 1 9 0\""}};
    for (int i = 0; i < COUNT(pairs); i++)
        check_same_points(pairs[i][0], pairs[i][1]);
}

TEST(transforms_are_the_maps_of_the_standard_and_the_last_acts_first)
{
    static const char *const pairs[][2] = {
        {"d=\"M1 2L3 4\" transform=\"translate(5)\"", "d=\"M6 2L8 4\""},
        {"d=\"M1 2L3 4\" transform=\"translate(5,6)\"", "d=\"M6 8L8 10\""},
        {"d=\"M1 2L3 4\" transform=\"scale(2)\"", "d=\"M2 4L6 8\""},
        {"d=\"M1 2L3 4\" transform=\"scale(2 3)\"", "d=\"M2 6L6 12\""},
        {"d=\"M1 2L3 4\" transform=\"matrix(1 2 3 4 5 6)\"", "d=\"M12 16L20 28\""},
        {"d=\"M1 2L3 4\" transform=\"rotate(90)\"", "d=\"M-2 1L-4 3\""},
        {"d=\"M1 2L3 4\" transform=\"rotate(90deg 1 1)\"", "d=\"M0 1L-2 3\""},
        {"d=\"M1 2L3 4\" transform=\"skewX(45)\"", "d=\"M3 2L7 4\""},
        {"d=\"M1 2L3 4\" transform=\"skewY(45)\"", "d=\"M1 3L3 7\""},
        {"d=\"M1 2L3 4\" transform=\"translate(5px) , scale (2)\"", "d=\"M7 4L11 8\""},
        {"d=\"M1 2L3 4\" transform=\"scale(2)translate(5)\"", "d=\"M12 4L16 8\""}};
    for (int i = 0; i < COUNT(pairs); i++)
        check_same_points(pairs[i][0], pairs[i][1]);
}

TEST(colours_are_names_digits_or_parts_of_255_or_of_a_hundred)
{
    static const struct {
        const char *text;
        int rgb[3]; /* of 255; -1: none */
    } cases[] = {{"black", {0, 0, 0}},           {"white", {255, 255, 255}},
                 {"red", {255, 0, 0}},           {"lime", {0, 255, 0}},
                 {"blue", {0, 0, 255}},          {"yellow", {255, 255, 0}},
                 {"cyan", {0, 255, 255}},        {"magenta", {255, 0, 255}},
                 {"green", {0, 128, 0}},         {"grey", {128, 128, 128}},
                 {" #1a2B3c ", {26, 43, 60}},    {"#f80", {255, 136, 0}},
                 {"rgb(1,2,3)", {1, 2, 3}},      {"rgb(100%, 20%, 0%)", {255, 51, 0}},
                 {"rgb(300 -5 7)", {255, 0, 7}}, {"#12345", {-1, 0, 0}},
                 {"#12g", {-1, 0, 0}},           {"rgb(1,2)", {-1, 0, 0}},
                 {"nosuch", {-1, 0, 0}}};
    for (int i = 0; i < COUNT(cases); i++) {
        char attributes[200];
        snprintf(attributes, sizeof attributes, "d=\"M1 2L3 4\" stroke=\"%s\"", cases[i].text);
        batten_model *model = read_path(attributes);
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(object->has_colour, cases[i].rgb[0] >= 0);
        for (int k = 0; k < 3 && object->has_colour; k++)
            CHECK_NEAR(object->colour[k], cases[i].rgb[k] / 255.0, 1e-15);
        batten_model_unref(model);
    }
}

TEST(a_drawing_stands_at_one_of_nine_places_within_or_over_its_sheet)
{
    /* A box of 10 x 10 on a sheet of 100 x 50 mm: scale 5 within, 10 over it. */
    static const char *const places[] = {"Min", "Mid", "Max"};
    for (int k = 0; k < 9; k++)
        for (int covers = 0; covers < 2; covers++) {
            char text[400];
            batten_model *model = NULL;
            const double s = covers ? 10 : 5;
            const double left = (k % 3) / 2.0 * (100 - 10 * s),
                         above = (k / 3) / 2.0 * (50 - 10 * s);
            snprintf(text, sizeof text,
                     "<svg width=\"100mm\" height=\"50mm\" viewBox=\"2 3 10 10\" "
                     "preserveAspectRatio=\"x%sY%s%s\">\n<path d=\"M4 6L5 8\"/>\n</svg>\n",
                     places[k % 3], places[k / 3],
                     covers  ? " slice"
                     : k % 2 ? " meet"
                             : "");
            CHECK_OK(read_text(text, BATTEN_FORMAT_SVG, NULL, &model));
            const double *p = batten_curve_points(batten_model_object(model, 0)->curve);
            const int d = batten_curve_dimension(batten_model_object(model, 0)->curve);
            CHECK_NEAR(p[0], left + 2 * s, 1e-12);
            CHECK_NEAR(p[1], 50 - above - 3 * s, 1e-12);
            CHECK_NEAR(p[d], left + 3 * s, 1e-12);
            CHECK_NEAR(p[d + 1], 50 - above - 5 * s, 1e-12);
            batten_model_unref(model);
        }
}
