#include "picture/scenes.h"

#include <stdlib.h>

static batten_model *wave(double height)
{
    batten_model *model = scene_empty();
    double points[5][3];
    for (int i = 0; i < 5; i++) {
        points[i][0] = i;
        points[i][1] = i % 2 ? height : 0;
        points[i][2] = 0;
    }
    batten_curve *curve = scene_curve(3, 3, 5, &points[0][0]);
    const batten_object object = {.name = "wave",
                                  .layer = "",
                                  .kind = BATTEN_OBJECT_CURVE,
                                  .curve = curve,
                                  .point_count = 5,
                                  .points = &points[0][0]};
    CHECK_OK(batten_model_add(model, &object));
    batten_curve_unref(curve);
    return model;
}

TEST(panels_have_their_titles_and_lines_on_the_sheet)
{
    batten_model *low = wave(0.5), *high = wave(1);
    const char *const lines[] = {"energy", "length"};
    const batten_panel panels[] = {{"first", low, 2, lines}, {"second", high, 1, lines}};
    batten_draw_options options = batten_draw_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_PICTURE_PDF;
    options.comb = true;
    options.title = "both";
    options.height = 800;
    CHECK_OK(batten_draw_panels(2, panels, &options, &data, &size));
    char *copy = test_array(size, 1);
    memcpy(copy, data, size);
    batten_release(data);
    batten_model_unref(low);
    batten_model_unref(high);
    const scene_words words = scene_read_pdf(copy, size);
    scene_check_words(&words, options.width, 800);
    const char *const wanted[] = {"both", "first", "second", "energy", "length"};
    for (int i = 0; i < COUNT(wanted); i++)
        CHECK(scene_find(&words, wanted[i]) != NULL);
}

/* How wide the coloured ink is between two heights. */
static int ink_width(const scene_image *image, int from, int to)
{
    int left = image->width, right = 0;
    for (int y = from; y < to; y++)
        for (int x = 0; x < image->width; x++) {
            const uint32_t pixel = scene_pixel(image, x, y);
            if (abs(scene_blue(pixel) - scene_red(pixel)) < 60)
                continue;
            left = x < left ? x : left;
            right = x > right ? x : right;
        }
    return right - left;
}

TEST(all_panels_have_the_same_scale)
{
    /* One curve is half as long as the other, and is drawn half as long. */
    batten_model *whole = wave(0.1), *half = scene_empty();
    batten_curve *part = NULL, *curve = NULL;
    CHECK_OK(batten_curve_to_dimension(batten_model_object(whole, 0)->curve, 3, &curve));
    const batten_interval domain = batten_curve_domain(curve);
    CHECK_OK(batten_curve_subrange(curve, domain.a, (domain.a + domain.b) / 2, &part));
    scene_add_curve(half, "half", part);
    batten_curve_unref(curve);
    const batten_panel panels[] = {{"", whole, 0, NULL}, {"", half, 0, NULL}};
    batten_draw_options options = batten_draw_defaults();
    char *data = NULL;
    size_t size = 0;
    options.width = 1000;
    options.height = 260;
    CHECK_OK(batten_draw_panels(2, panels, &options, &data, &size));
    const scene_image image = scene_decode(data, size);
    batten_release(data);
    batten_model_unref(whole);
    batten_model_unref(half);
    /* Long panels stand one below the other. */
    CHECK_NEAR(ink_width(&image, 130, 260) / (double)ink_width(&image, 0, 130), 0.5, 0.02);
}

TEST(the_teeth_of_one_wild_curve_do_not_make_the_others_small)
{
    /* Low waves, and one with a narrow peak whose comb is far the longest. */
    batten_model *low = wave(0.1), *wild = scene_empty();
    static const double peak[] = {0, 0, 0, 2, 0, 0, 2, 0.1, 0, 2, 0, 0, 4, 0, 0};
    scene_add_curve(wild, "wild", scene_curve(3, 3, 5, peak));
    const batten_panel panels[] = {{"", low, 0, NULL},
                                   {"", low, 0, NULL},
                                   {"", low, 0, NULL},
                                   {"", low, 0, NULL},
                                   {"", wild, 0, NULL}};
    batten_draw_options options = batten_draw_defaults();
    int width[2];
    options.comb = true;
    options.width = 1000;
    options.height = 2000;
    for (int k = 0; k < 2; k++) {
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_draw_panels(4 + k, panels, &options, &data, &size));
        const scene_image image = scene_decode(data, size);
        batten_release(data);
        width[k] = ink_width(&image, 0, 2000 / (4 + k));
    }
    CHECK_NEAR(width[1], width[0], 0.03 * width[0]);
    batten_model_unref(low);
    batten_model_unref(wild);
}

/* Waves with their data over 0 .. 4, and one line in five that runs far off to one side: half of 4 more is shown there. */
TEST(a_curve_that_runs_off_does_not_make_the_first_one_small)
{
    batten_model *first = wave(0.1);
    int width[3];
    for (int k = 0; k < 3; k++) {
        const double ends[] = {k == 0 ? 0 : k == 1 ? -100 : 0, 0, 0, k == 2 ? 100 : 4, 0, 0};
        batten_model *other = scene_empty();
        scene_add_curve(other, "line", scene_curve(3, 1, 2, ends));
        const batten_panel panels[] = {{"", first, 0, NULL},
                                       {"", first, 0, NULL},
                                       {"", first, 0, NULL},
                                       {"", first, 0, NULL},
                                       {"", other, 0, NULL}};
        batten_draw_options options = batten_draw_defaults();
        char *data = NULL;
        size_t size = 0;
        options.width = 600;
        options.height = 500;
        CHECK_OK(batten_draw_panels(COUNT(panels), panels, &options, &data, &size));
        const scene_image image = scene_decode(data, size);
        batten_release(data);
        width[k] = ink_width(&image, 0, 100);
        batten_model_unref(other);
    }
    for (int k = 1; k < 3; k++)
        CHECK(width[k] > 0.6 * width[0] && width[k] < 0.9 * width[0]);
    batten_model_unref(first);
}

/* Options that cannot be are refused before anything is drawn. */
TEST(options_of_a_caller_that_knows_other_ones_are_refused)
{
    batten_model *model = wave(1);
    const batten_panel panel = {"", model, 0, NULL};
    batten_draw_options options = batten_draw_defaults();
    char *data = NULL;
    size_t size = 0;
    options.size = 1;
    CHECK_STATUS(batten_draw_panels(1, &panel, &options, &data, &size), BATTEN_BAD_ARGUMENT);
    CHECK(data == NULL);
    batten_model_unref(model);
}

TEST(sixty_four_panels_are_drawn)
{
    if (test_cases(10) < 10)
        SKIP("its allocations are those of fewer panels");
    batten_model *model = wave(1);
    batten_panel panels[64];
    batten_draw_options options = batten_draw_defaults();
    char *data = NULL;
    size_t size = 0;
    options.width = options.height = 300;
    for (int i = 0; i < COUNT(panels); i++)
        panels[i] = (batten_panel){"", model, 0, NULL};
    CHECK_OK(batten_draw_panels(COUNT(panels), panels, &options, &data, &size));
    const scene_image image = scene_decode(data, size);
    CHECK(image.width == 300 && image.height == 300);
    batten_release(data);
    batten_model_unref(model);
}

TEST(panels_that_cannot_be_are_refused)
{
    batten_model *model = wave(1), *empty = scene_empty();
    batten_panel panels[2] = {{"", model, 0, NULL}, {"", empty, 0, NULL}};
    const batten_draw_options options = batten_draw_defaults();
    char *data = NULL;
    size_t size = 0;
    CHECK_STATUS(batten_draw_panels(0, panels, &options, &data, &size), BATTEN_BAD_ARGUMENT);
    CHECK_TEXT(batten_message(), "0 panels; there may be 1 to 64");
    CHECK_STATUS(batten_draw_panels(65, panels, &options, &data, &size), BATTEN_BAD_ARGUMENT);
    CHECK_TEXT(batten_message(), "65 panels; there may be 1 to 64");
    CHECK_STATUS(batten_draw_panels(2, panels, &options, &data, &size), BATTEN_BAD_ARGUMENT);
    CHECK(data == NULL);
    batten_model_unref(model);
    batten_model_unref(empty);
}
