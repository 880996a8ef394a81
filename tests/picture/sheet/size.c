#include "picture/sheet/size.h"

#include "picture/scenes.h"

static scene_image picture_of(const batten_model *model, bool shaded)
{
    const batten_draw_options options = batten_draw_defaults();
    char *data = NULL;
    size_t size = 0;
    if (shaded)
        CHECK_OK(batten_draw_shaded(model, &options, NULL, &data, &size));
    else
        CHECK_OK(batten_draw(model, &options, &data, &size));
    const scene_image image = scene_decode(data, size);
    batten_release(data);
    return image;
}

/* How many columns and rows the red ink covers, above the legend. */
static void ink_of(const scene_image *image, int ink[2])
{
    int left = image->width, right = 0, top = image->height, bottom = 0;
    for (int y = 20; y < image->height - 60; y++)
        for (int x = 20; x < image->width; x++) {
            const uint32_t pixel = scene_pixel(image, x, y);
            if (scene_red(pixel) < 240 || scene_green(pixel) > 60)
                continue;
            left = x < left ? x : left, right = x > right ? x : right;
            top = y < top ? y : top, bottom = y > bottom ? y : bottom;
        }
    ink[0] = right - left + 1, ink[1] = bottom - top + 1;
}

TEST(a_curve_fills_its_frame_whatever_its_shape)
{
    static const double heights[] = {2, 4, 6, 7};
    for (int i = 0; i < test_cases(COUNT(heights)); i++) {
        const double h = heights[i];
        const double corners[][2] = {{0, 0}, {10, 0}, {10, h}, {0, h}, {0, 0}};
        batten_model *model = scene_empty();
        scene_add_curve(model, "frame", scene_curve(2, 1, 5, corners[0]));
        const scene_image image = picture_of(model, false);
        int ink[2];
        ink_of(&image, ink);
        CHECK(ink[0] > 0.85 * image.width);
        CHECK_NEAR((double)ink[1] / ink[0], h / 10, 0.01);
        /* Title, numbers, names and legend take 110 pixels, the margin 3 in 100 of the width. */
        CHECK(ink[1] > image.height - 110 - 2 * 0.04 * image.width);
        batten_model_unref(model);
    }
}

TEST(a_shaded_shape_fills_its_picture)
{
    batten_model *model = scene_of(scene_cylinder(1, 6));
    const scene_image image = picture_of(model, true);
    int top = image.height, bottom = 0;
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++)
            if (scene_pixel(&image, x, y) != scene_pixel(&image, 0, y)) {
                top = y < top ? y : top;
                bottom = y > bottom ? y : bottom;
            }
    /* Two letters of 13 pixels stay free above and below. */
    CHECK(bottom - top > image.height - 60);
    CHECK(image.height < image.width);
    batten_model_unref(model);
}

TEST(the_height_lies_between_a_quarter_of_the_width_and_all_of_it)
{
    batten_draw_options options = batten_draw_defaults();
    static const struct {
        double range[2];
        int height;
    } rows[] = {
        {{10, 5}, 600}, {{10, 0}, 300}, {{10, 10}, 1100}, {{1, 10}, 1200}, {{0, 1}, 1200}};
    for (int i = 0; i < COUNT(rows); i++)
        CHECK_INT(bat_size_height(&options, 1000, rows[i].range, 100), rows[i].height);
    options.height = 77;
    CHECK_INT(bat_size_height(&options, 1000, rows[0].range, 100), 77);
}

TEST(letters_of_a_low_picture_are_those_of_a_usual_one)
{
    batten_draw_options options = batten_draw_defaults();
    CHECK_NEAR(bat_size_em(&options), 0.0165 * 800, 1e-12);
    options.height = 400;
    CHECK_NEAR(bat_size_em(&options), 0.0165 * 400, 1e-12);
    options.width = options.height = 64;
    CHECK_NEAR(bat_size_em(&options), 5, 0);
}
