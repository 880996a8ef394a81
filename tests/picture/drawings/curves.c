#include "picture/scenes.h"

static batten_draw_options usual(void)
{
    batten_draw_options options = batten_draw_defaults();
    options.height = 800;
    return options;
}

static scene_words words_of(const batten_model *model, batten_draw_options options)
{
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_PICTURE_PDF;
    CHECK_OK(batten_draw(model, &options, &data, &size));
    char *copy = test_array(size, 1);
    memcpy(copy, data, size);
    batten_release(data);
    return scene_read_pdf(copy, size);
}

static scene_image image_of(const batten_model *model, batten_draw_options options)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw(model, &options, &data, &size));
    const scene_image image = scene_decode(data, size);
    batten_release(data);
    return image;
}

typedef struct {
    int left, right, top, bottom;
} extent;

/* Where pixels have the colour red with at most so much green, above the legend. */
static extent red_extent(const scene_image *image, int green)
{
    extent e = {image->width, -1, image->height, -1};
    for (int y = 0; y < image->height * 9 / 10; y++)
        for (int x = 0; x < image->width; x++) {
            const uint32_t pixel = scene_pixel(image, x, y);
            if (scene_red(pixel) < 240 || scene_green(pixel) > green)
                continue;
            e.left = x < e.left ? x : e.left;
            e.right = x > e.right ? x : e.right;
            e.top = y < e.top ? y : e.top;
            e.bottom = y > e.bottom ? y : e.bottom;
        }
    return e;
}

TEST(an_empty_model_is_refused)
{
    batten_model *model = scene_empty();
    const batten_draw_options options = usual();
    char *data = NULL;
    size_t size = 0;
    CHECK_STATUS(batten_draw(model, &options, &data, &size), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("nothing to draw");
    CHECK(data == NULL);
    batten_model_unref(model);
}

TEST(a_circle_is_round_on_paper)
{
    batten_model *model = scene_empty();
    scene_add_curve(model, "circle", scene_circle(3));
    const scene_image image = image_of(model, usual());
    const extent e = red_extent(&image, 60);
    CHECK(e.right - e.left > 500);
    CHECK_NEAR(e.right - e.left, e.bottom - e.top, 1);
    batten_model_unref(model);
}

TEST(the_longest_tooth_is_a_tenth_of_what_is_drawn)
{
    /* All teeth of a circle are equal and stand outside: its diameter grows by a fifth. */
    batten_model *model = scene_empty();
    scene_add_curve(model, "circle", scene_circle(3));
    batten_draw_options options = usual();
    options.comb = true;
    const scene_image image = image_of(model, options);
    const extent curve = red_extent(&image, 60), comb = red_extent(&image, 130);
    CHECK_NEAR((double)(comb.right - comb.left) / (curve.right - curve.left), 1.2, 0.01);
    CHECK_NEAR((double)(comb.bottom - comb.top) / (curve.bottom - curve.top), 1.2, 0.01);
    /* And as long as is asked: 4.5 m^2 times 1/3 1/m is half the radius. */
    options.comb_scale = 4.5;
    const scene_image other = image_of(model, options);
    const extent c = red_extent(&other, 60), t = red_extent(&other, 130);
    CHECK_NEAR((double)(t.right - t.left) / (c.right - c.left), 1.5, 0.01);
    batten_model_unref(model);
}

TEST(the_legend_names_curves_and_their_sharpest_curvature)
{
    batten_model *model = scene_empty();
    scene_add_curve(model, "Rundspant", scene_circle(4));
    batten_draw_options options = usual();
    options.comb = options.control_polygon = true;
    options.title = "Spanten";
    const scene_words words = words_of(model, options);
    static const char *const expected[] = {"Rundspant:", "0.25", "control", "curvature",
                                           "Spanten",    "x",    "y",       "(m)"};
    for (int i = 0; i < COUNT(expected); i++)
        CHECK(scene_find(&words, expected[i]) != NULL);
    scene_check_words(&words, options.width, 800);
    batten_model_unref(model);
}

TEST(the_view_is_the_plane_in_which_all_lies)
{
    static const struct {
        double points[6];
        const char *right, *up;
    } rows[] = {{{0, 0, 5, 2, 1, 5}, "x", "y"},
                {{0, 5, 0, 2, 5, 1}, "x", "z"},
                {{5, 0, 0, 5, 2, 1}, "y", "z"},
                {{0, 0, 0, 2, 1, 1}, "x", "z"}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_model *model = scene_empty();
        scene_add_curve(model, "line", scene_curve(3, 1, 2, rows[i].points));
        const scene_words words = words_of(model, usual());
        CHECK(scene_find(&words, rows[i].right) != NULL);
        CHECK(scene_find(&words, rows[i].up) != NULL);
        /* Only the last one needs all three. */
        CHECK_INT(scene_find(&words, "x") && scene_find(&words, "y") && scene_find(&words, "z"),
                  i == 3);
        batten_model_unref(model);
    }
}

TEST(grid_numbers_are_round_and_do_not_overlap)
{
    static const double places[] = {0, 1e6, -1e-4};
    for (int i = 0; i < COUNT(places); i++) {
        batten_model *model = scene_empty();
        const double points[] = {places[i], places[i], places[i] + 7, places[i] + 4};
        scene_add_curve(model, "line", scene_curve(2, 1, 2, points));
        const scene_words words = words_of(model, usual());
        scene_check_words(&words, 1200, 800);
        CHECK(words.count > 8);
        batten_model_unref(model);
    }
}

TEST(many_curves_are_named_where_they_end)
{
    batten_model *model = scene_empty();
    for (int i = 0; i < 12; i++) {
        char name[24];
        snprintf(name, sizeof name, "frame%d", i);
        const double points[] = {0, i, 10, i + 0.2};
        scene_add_curve(model, name, scene_curve(2, 1, 2, points));
    }
    const scene_words words = words_of(model, usual());
    CHECK(scene_find(&words, "frame0") != NULL);
    CHECK(scene_find(&words, "frame11") != NULL);
    scene_check_words(&words, 1200, 800);
    batten_model_unref(model);
}

/* A square of vertices, and the curve that they shape. */
static batten_model *shaped_curve(bool are_vertices)
{
    static const double points[][3] = {{0, 0, 0}, {0, 4, 0}, {6, 4, 0}, {6, 0, 0}};
    batten_model *model = scene_empty();
    batten_curve *curve = scene_curve(3, 3, 4, points[0]);
    const batten_object object = {.name = "arch",
                                  .layer = "",
                                  .kind = BATTEN_OBJECT_CURVE,
                                  .curve = curve,
                                  .point_count = 4,
                                  .points = points[0],
                                  .points_are_vertices = are_vertices};
    CHECK_OK(batten_model_add(model, &object));
    batten_curve_unref(curve);
    return model;
}

TEST(vertices_are_drawn_as_a_polygon_and_are_not_called_data)
{
    for (int vertices = 0; vertices < 2; vertices++) {
        batten_model *model = shaped_curve(vertices);
        batten_draw_options options = usual();
        options.data_points = true;
        const scene_words words = words_of(model, options);
        CHECK((scene_find(&words, "polygon") != NULL) == (vertices == 1));
        CHECK((scene_find(&words, "data") != NULL) == (vertices == 0));
        batten_model_unref(model);
    }
}

/* How many pixels of an arc with so many data points are nearly black: those of their marks. */
static int mark_ink(int count)
{
    batten_model *model = scene_empty();
    double *points = test_array((size_t)count, 3 * sizeof *points);
    for (int i = 0; i < count; i++) {
        points[3 * i] = 3 * cos(2.0 * i / count);
        points[3 * i + 1] = 3 * sin(2.0 * i / count);
        points[3 * i + 2] = 0;
    }
    batten_curve *curve = scene_circle(3);
    const batten_object object = {.name = "arc",
                                  .layer = "",
                                  .kind = BATTEN_OBJECT_CURVE,
                                  .curve = curve,
                                  .has_colour = true,
                                  .colour = {1, 0, 0},
                                  .point_count = count,
                                  .points = points};
    CHECK_OK(batten_model_add(model, &object));
    batten_curve_unref(curve);
    batten_draw_options options = usual();
    options.data_points = true;
    const scene_image image = image_of(model, options);
    int ink = 0;
    for (int y = 0; y < image.height * 8 / 10; y++)
        for (int x = image.width / 4; x < image.width; x++) {
            const uint32_t pixel = scene_pixel(&image, x, y);
            ink += scene_red(pixel) < 60 && scene_green(pixel) < 60;
        }
    batten_model_unref(model);
    return ink;
}

TEST(points_that_stand_close_are_dots)
{
    const int loose = mark_ink(20), close = mark_ink(200);
    CHECK(loose > 20 * 4);
    CHECK(close > 200);
    CHECK(close < 5 * loose);
}

/* A model with every kind of object. */
static batten_model *everything(void)
{
    batten_model *model = scene_of(scene_wigley(10, 2, 1, 1));
    static const double points[] = {0, 0, 0, 1, 1, 1};
    const batten_object dots = {.name = "dots",
                                .layer = "",
                                .kind = BATTEN_OBJECT_POINTS,
                                .point_count = 2,
                                .points = points};
    CHECK_OK(batten_model_add(model, &dots));
    const batten_table_point at[] = {{2, 0, -0.5, -1}, {2, 1, 0, -1}};
    const batten_table_station station = {"2", 2, 2, at};
    batten_offset_table *table = NULL;
    CHECK_OK(batten_offset_table_create(1, 0, NULL, 1, &station, &table));
    const batten_object offsets = {.name = "table",
                                   .layer = "",
                                   .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                   .offset_table = table};
    CHECK_OK(batten_model_add(model, &offsets));
    batten_offset_table_unref(table);
    const double keel[] = {-5, 0, -1, 0, 0, -1.1, 5, 0, -1};
    batten_curve *curve = scene_curve(3, 2, 3, keel);
    const batten_object made = {.name = "keel",
                                .layer = "",
                                .kind = BATTEN_OBJECT_CURVE,
                                .curve = curve,
                                .point_count = 2,
                                .points = points};
    CHECK_OK(batten_model_add(model, &made));
    batten_curve_unref(curve);
    return model;
}

TEST(every_kind_of_object_is_drawn_the_same_twice_without_nan)
{
    batten_model *model = everything();
    batten_draw_options options = usual();
    options.comb = options.control_polygon = options.data_points = true;
    for (int format = BATTEN_PICTURE_PNG; format <= BATTEN_PICTURE_PDF; format++) {
        options.format = format;
        char *first = NULL, *second = NULL;
        size_t first_size = 0, second_size = 0;
        CHECK_OK(batten_draw(model, &options, &first, &first_size));
        CHECK_OK(batten_draw(model, &options, &second, &second_size));
        CHECK_INT(first_size, second_size);
        CHECK(memcmp(first, second, first_size) == 0);
        if (format == BATTEN_PICTURE_SVG)
            CHECK(strstr(first, "nan") == NULL && strstr(first, "inf") == NULL);
        batten_release(first);
        batten_release(second);
    }
    batten_model_unref(model);
}

TEST(N2_single_points_and_far_coordinates_are_drawn_or_refused)
{
    static const double sizes[] = {0, 1e-300, 1e-9, 1e9, 1e150, 1e300, 1.7e308};
    for (int i = 0; i < COUNT(sizes); i++) {
        batten_model *model = scene_empty();
        const double points[] = {-sizes[i], 0, 0, sizes[i], sizes[i], 0};
        const batten_object object = {.name = "p",
                                      .layer = "",
                                      .kind = BATTEN_OBJECT_POINTS,
                                      .point_count = 2,
                                      .points = points};
        CHECK_OK(batten_model_add(model, &object));
        batten_draw_options options = usual();
        options.format = BATTEN_PICTURE_SVG;
        char *data = NULL;
        size_t size = 0;
        if (sizes[i] < 1e200) {
            CHECK_OK(batten_draw(model, &options, &data, &size));
            CHECK(strstr(data, "nan") == NULL && strstr(data, "inf") == NULL);
            batten_release(data);
        } else {
            const batten_status status = batten_draw(model, &options, &data, &size);
            if (status == BATTEN_OK)
                CHECK(strstr(data, "nan") == NULL && strstr(data, "inf") == NULL);
            CHECK(status == BATTEN_OK || status == BATTEN_OVERFLOW ||
                  status == BATTEN_OUT_OF_MEMORY);
            batten_release(data);
        }
        batten_model_unref(model);
    }
}

TEST(G4_a_curve_with_a_cusp_is_drawn)
{
    /* Three equal control points: the first derivative vanishes. */
    const double points[] = {0, 0, 1, 1, 1, 1, 1, 1, 2, 0};
    batten_model *model = scene_empty();
    scene_add_curve(model, "cusp", scene_curve(2, 3, 5, points));
    batten_draw_options options = usual();
    options.comb = true;
    options.format = BATTEN_PICTURE_SVG;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw(model, &options, &data, &size));
    CHECK(strstr(data, "nan") == NULL);
    batten_release(data);
    batten_model_unref(model);
}

TEST(options_that_make_no_sense_are_refused)
{
    batten_model *model = everything();
    const batten_draw_options base = usual();
    batten_draw_options rows[] = {base, base, base, base, base};
    rows[0].width = 0;
    rows[1].isolines = 0;
    rows[2].isolines = 1 << 30;
    rows[3].azimuth = NAN;
    rows[4].height = 100000;
    static const batten_status expected[] = {BATTEN_BAD_ARGUMENT, BATTEN_BAD_ARGUMENT,
                                             BATTEN_BAD_ARGUMENT, BATTEN_NOT_FINITE,
                                             BATTEN_TOO_LARGE};
    for (int i = 0; i < COUNT(rows); i++) {
        char *data = NULL;
        size_t size = 0;
        CHECK_STATUS(batten_draw(model, &rows[i], &data, &size), expected[i]);
        CHECK(data == NULL);
    }
    batten_model_unref(model);
}

TEST(views_and_combs_that_are_no_numbers_are_refused_each)
{
    batten_model *model = scene_empty();
    scene_add_curve(model, "circle", scene_circle(1));
    const batten_draw_options usual = batten_draw_defaults();
    batten_draw_options rows[] = {usual, usual, usual};
    static const char *const messages[] = {"azimuth inf, elevation 0 and comb scale 0",
                                           "azimuth 0, elevation inf and comb scale 0",
                                           "azimuth 0, elevation 0 and comb scale inf"};
    for (int i = 0; i < COUNT(rows); i++) {
        char *data = NULL, due[80];
        size_t size = 0;
        rows[i].azimuth = i == 0 ? INFINITY : 0;
        rows[i].elevation = i == 1 ? INFINITY : 0;
        rows[i].comb_scale = i == 2 ? INFINITY : 0;
        snprintf(due, sizeof due, "%s must be finite", messages[i]);
        CHECK_STATUS(batten_draw(model, &rows[i], &data, &size), BATTEN_NOT_FINITE);
        CHECK_TEXT(batten_message(), due);
    }
    static const int isolines[] = {0, 1001, -5};
    for (int i = 0; i < COUNT(isolines); i++) {
        char *data = NULL, due[80];
        size_t size = 0;
        batten_draw_options options = usual;
        options.isolines = isolines[i];
        snprintf(due, sizeof due, "%d isolines are asked for; from 1 to 1000 are drawn",
                 isolines[i]);
        CHECK_STATUS(batten_draw(model, &options, &data, &size), BATTEN_BAD_ARGUMENT);
        CHECK_TEXT(batten_message(), due);
    }
    batten_model_unref(model);
}
