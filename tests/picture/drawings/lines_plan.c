#include "picture/scenes.h"
#include "picture/sheet/canvas.h"
#include <batten/exchange.h>

enum { WIDTH = 1684, HEIGHT = 1191 };

static batten_draw_options sheet(batten_picture_format format)
{
    batten_draw_options options = batten_draw_defaults();
    options.format = format;
    options.width = WIDTH;
    options.height = HEIGHT;
    options.title = "Wigley";
    return options;
}

/* The words on the plan of a Wigley hull. */
static scene_words words_of(batten_surface *surface, const batten_draw_lines_plan_options *plan)
{
    batten_model *model = scene_of(surface);
    const batten_draw_options options = sheet(BATTEN_PICTURE_PDF);
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw_lines_plan(model, plan, &options, NULL, &data, &size));
    batten_model_unref(model);
    char *copy = test_array(size, 1);
    memcpy(copy, data, size);
    batten_release(data);
    return scene_read_pdf(copy, size);
}

TEST(the_sheet_says_what_it_shows)
{
    batten_draw_lines_plan_options plan = scene_plan(10);
    plan.design_waterline = -0.3;
    plan.waterlines = plan.buttocks = 0.4;
    const scene_words words = words_of(scene_wigley(10, 2, 1, 1), &plan);
    static const char *const expected[] = {
        "Wigley", "Profile", "Half-breadth", "Body", "Length", "10", "Beam", "2",
        "Depth",  "DWL",     "-0.3",         "1:20", "CL",     "WL", "B"};
    for (int i = 0; i < COUNT(expected); i++)
        if (!scene_find(&words, expected[i])) {
            fprintf(stderr, "\"%s\" is missing\n", expected[i]);
            CHECK(!"a word is missing");
        }
}

TEST(no_word_is_cut_or_covered_whatever_the_proportions)
{
    static const double hulls[][3] = {{25, 6, 3},         {4, 1.6, 0.6},  {12, 12, 1},
                                      {100, 2, 2},        {2, 2, 6},      {1, 0.1, 3},
                                      {1e-3, 4e-4, 2e-4}, {3e5, 4e4, 2e4}};
    for (int i = 0; i < test_cases(COUNT(hulls)); i++) {
        batten_draw_lines_plan_options plan = scene_plan(hulls[i][0]);
        plan.design_waterline = -0.41 * hulls[i][2];
        const scene_words words =
            words_of(scene_wigley(hulls[i][0], hulls[i][1], hulls[i][2], 1), &plan);
        CHECK(words.count > 20);
        scene_check_words(&words, WIDTH, HEIGHT);
    }
}

TEST(a_long_title_is_written_as_small_as_its_block_wants)
{
    static const char title[] =
        "The lines of a Wigley hull, ten metres by two, drawn for a try";
    batten_model *model = scene_of(scene_wigley(10, 2, 1, 1));
    const batten_draw_lines_plan_options plan = scene_plan(10);
    batten_draw_options options = sheet(BATTEN_PICTURE_PDF);
    char *data = NULL;
    size_t size = 0;
    options.title = title;
    CHECK_OK(batten_draw_lines_plan(model, &plan, &options, NULL, &data, &size));
    char *copy = test_array(size, 1);
    memcpy(copy, data, size);
    batten_release(data);
    const scene_words words = scene_read_pdf(copy, size);
    CHECK(scene_find(&words, "try") != NULL);
    scene_check_words(&words, WIDTH, HEIGHT);
    batten_model_unref(model);
}

TEST(stations_are_aligned_in_profile_and_half_breadth_plan)
{
    batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
    plan.waterlines = plan.buttocks = 2;
    const scene_words words = words_of(scene_wigley(25, 5, 3, 1), &plan);
    const scene_word *profile = scene_find(&words, "Profile");
    const scene_word *breadth = scene_find(&words, "Half-breadth");
    CHECK(profile && breadth && profile->bottom < breadth->top);
    for (int station = 0; station <= 10; station++) {
        char name[16];
        snprintf(name, sizeof name, "%d", station);
        bool aligned = false;
        for (int i = 0; i < words.count; i++)
            for (int k = 0; k < words.count; k++) {
                const scene_word *upper = &words.words[i], *lower = &words.words[k];
                aligned |= strcmp(upper->text, name) == 0 && strcmp(lower->text, name) == 0 &&
                           upper->top > profile->bottom && upper->bottom < breadth->top &&
                           lower->top > breadth->bottom &&
                           fabs(lower->left - upper->left) < 0.01;
            }
        CHECK(aligned);
    }
}

TEST(the_scale_is_true_on_paper)
{
    /* Stations 0 and 10 are 10 m apart: at 1:20 half a metre of paper. */
    batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
    plan.waterlines = plan.buttocks = 0.4;
    const scene_words words = words_of(scene_wigley(10, 2, 1, 1), &plan);
    CHECK(scene_find(&words, "1:20") != NULL);
    const scene_word *breadth = scene_find(&words, "Half-breadth");
    double first = 0, last = 0;
    for (int i = 0; i < words.count; i++) {
        const scene_word *w = &words.words[i];
        if (w->bottom < breadth->top && strcmp(w->text, "0") == 0)
            first = 0.5 * (w->left + w->right);
        if (w->bottom < breadth->top && strcmp(w->text, "10") == 0)
            last = 0.5 * (w->left + w->right);
    }
    CHECK_NEAR(last - first, 0.5 / 0.0254 * 72, 1);
}

TEST(the_same_hull_gives_the_same_bytes_and_no_nan)
{
    batten_model *model = scene_of(scene_wigley(10, 2, 1, 1));
    const batten_draw_lines_plan_options plan = scene_plan(10);
    for (int format = BATTEN_PICTURE_PNG; format <= BATTEN_PICTURE_PDF; format++) {
        const batten_draw_options options = sheet(format);
        char *first = NULL, *second = NULL;
        size_t first_size = 0, second_size = 0;
        CHECK_OK(batten_draw_lines_plan(model, &plan, &options, NULL, &first, &first_size));
        CHECK_OK(batten_draw_lines_plan(model, &plan, &options, NULL, &second, &second_size));
        CHECK_INT(first_size, second_size);
        CHECK(memcmp(first, second, first_size) == 0);
        if (format == BATTEN_PICTURE_SVG) {
            CHECK(strstr(first, "nan") == NULL);
            CHECK(strstr(first, "inf") == NULL);
        }
        batten_release(first);
        batten_release(second);
    }
    batten_model_unref(model);
}

/* How many pixels have the colour of the crosses. */
static int crosses(const batten_model *model, const batten_model *data)
{
    batten_draw_lines_plan_options plan = scene_plan(10);
    plan.data = data;
    const batten_draw_options options = sheet(BATTEN_PICTURE_PNG);
    char *bytes = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw_lines_plan(model, &plan, &options, NULL, &bytes, &size));
    const scene_image image = scene_decode(bytes, size);
    batten_release(bytes);
    int count = 0;
    for (int i = 0; i < image.width * image.height; i++) {
        const uint32_t pixel = image.pixels[i];
        count += scene_red(pixel) - scene_blue(pixel) > 120 && scene_green(pixel) < 160 &&
                 scene_green(pixel) - scene_blue(pixel) > 30;
    }
    return count;
}

TEST(given_points_are_crosses_in_three_views)
{
    batten_model *model = scene_of(scene_wigley(10, 2, 1, 1)), *data = scene_empty();
    const batten_table_line line = {"wl", true, -0.5};
    const batten_table_point at = {2, 0.3, -0.5, 0};
    const batten_table_station station = {"7", 2, 1, &at};
    batten_offset_table *table = NULL;
    CHECK_OK(batten_offset_table_create(1, 1, &line, 1, &station, &table));
    const batten_object offsets = {.name = "table",
                                   .layer = "",
                                   .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                   .offset_table = table};
    CHECK_OK(batten_model_add(data, &offsets));
    const int one = crosses(model, data);
    CHECK(crosses(model, NULL) == 0);
    CHECK(one > 0);

    /* On the other side the same place; far away none. */
    const double points[] = {2, -0.3, -0.5, 900, 900, 900};
    const batten_object given = {.name = "p",
                                 .layer = "",
                                 .kind = BATTEN_OBJECT_POINTS,
                                 .point_count = 2,
                                 .points = points};
    batten_model *other = scene_empty();
    CHECK_OK(batten_model_add(other, &given));
    CHECK_INT(crosses(model, other), one);
    batten_model_unref(other);
    batten_offset_table_unref(table);
    batten_model_unref(data);
    batten_model_unref(model);
}

TEST(S1_a_sheet_without_room_is_refused)
{
    batten_model *model = scene_of(scene_wigley(10, 2, 1, 1));
    const batten_draw_lines_plan_options plan = scene_plan(10);
    static const struct {
        int width, height;
        batten_status status;
    } rows[] = {{0, 0, BATTEN_BAD_ARGUMENT},     {-5, 100, BATTEN_BAD_ARGUMENT},
                {64, 64, BATTEN_BAD_ARGUMENT},   {100000, 100000, BATTEN_TOO_LARGE},
                {2000, 64, BATTEN_BAD_ARGUMENT}, {300, 3000, BATTEN_OK}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_draw_options options = sheet(BATTEN_PICTURE_SVG);
        options.width = rows[i].width;
        options.height = rows[i].height;
        char *data = NULL;
        size_t size = 0;
        CHECK_STATUS(batten_draw_lines_plan(model, &plan, &options, NULL, &data, &size),
                     rows[i].status);
        batten_release(data);
    }
    batten_model_unref(model);
}

TEST(a_model_without_a_hull_has_no_lines)
{
    batten_model *model = scene_empty();
    const batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
    const batten_draw_options options = sheet(BATTEN_PICTURE_PNG);
    char *data = NULL;
    size_t size = 0;
    CHECK_STATUS(batten_draw_lines_plan(model, &plan, &options, NULL, &data, &size),
                 BATTEN_BAD_ARGUMENT);
    CHECK(data == NULL);
    batten_model_unref(model);
}

/* The half-breadth of the Wigley hull 10 x 2 x 1. */
static double breadth_at(double x, double z)
{
    return (1 - 0.04 * x * x) * (1 - z * z);
}

/* How many objects lie on a layer of what was read. */
static int count_on_layer(const batten_model *model, const char *layer)
{
    int count = 0;
    for (int i = 0; i < batten_model_count(model); i++)
        count += strcmp(batten_model_object(model, i)->layer, layer) == 0;
    return count;
}

static void check_profile(const batten_model *model)
{
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (strcmp(object->layer, "buttocks") != 0)
            continue;
        const int d = batten_curve_dimension(object->curve);
        for (int k = 0; k < batten_curve_point_count(object->curve); k++) {
            const double *p = batten_curve_points(object->curve) + d * k;
            CHECK_NEAR(breadth_at(p[0], p[1]), 0.7, 1e-4);
        }
    }
}

TEST(a_plan_in_DXF_has_a_layer_for_each_family_and_the_profile_at_its_place)
{
    static const double at[] = {-0.1}, angle[] = {0.8};
    static const char *const layers[] = {"stations", "buttocks", "waterlines", "diagonals",
                                         "edges",    "grid",     "sheet"};
    batten_draw_lines_plan_options plan = scene_plan(10);
    plan.waterlines = 0.4;
    plan.buttocks = 0.7;
    plan.diagonal_at = at;
    plan.diagonal_angle = angle;
    plan.diagonal_count = 1;
    batten_model *model = scene_of(scene_wigley(10, 2, 1, 1)), *read = NULL;
    const batten_draw_options options = sheet(BATTEN_PICTURE_DXF);
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw_lines_plan(model, &plan, &options, NULL, &data, &size));
    CHECK_CONTAINS(data, "\nTEXT\n  8\ntext\n");
    CHECK_CONTAINS(data, "\nTEXT\n  8\ntable\n");
    CHECK_CONTAINS(data, "\nHalf-breadth plan");
    CHECK_CONTAINS(data, "\nD1 from -0.1, 45.84%%d down\n");
    batten_read_options reading = batten_read_defaults();
    reading.format = BATTEN_FORMAT_DXF;
    /* A model holds no texts. */
    CHECK_STATUS(batten_read_memory(data, size, &reading, NULL, NULL, &read),
                 BATTEN_PARTLY_READ);
    for (int i = 0; i < COUNT(layers); i++)
        CHECK(count_on_layer(read, layers[i]) > 0);
    check_profile(read);
    batten_release(data);
    batten_model_unref(read);
    batten_model_unref(model);
}

TEST(other_pictures_are_not_written_as_DXF)
{
    bat_canvas canvas;
    CHECK_STATUS(bat_canvas_begin(BATTEN_PICTURE_DXF, 200, 200, 8, "t", &canvas),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("only a lines plan");
}
