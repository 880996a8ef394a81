#include "picture/scenes.h"
#include "picture/sheet/sheet.h"
#include <batten/invariants.h>

static batten_curve *bezier(const double *points)
{
    return scene_curve(2, 3, 4, points);
}

static scene_words words_of(const batten_model *model,
                            const batten_draw_cubic_plane_options *plane)
{
    batten_draw_options options = batten_draw_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_PICTURE_PDF;
    options.width = 1100;
    options.height = 1200;
    CHECK_OK(batten_draw_cubic_plane(model, plane, &options, &data, &size));
    char *copy = test_array(size, 1);
    memcpy(copy, data, size);
    batten_release(data);
    return scene_read_pdf(copy, size);
}

TEST(the_plane_names_its_regions)
{
    const scene_words words = words_of(NULL, NULL);
    CHECK(scene_find(&words, "loop") != NULL);
    CHECK(scene_find(&words, "regular") != NULL);
    CHECK(scene_find(&words, "S-shaped:") != NULL);
    scene_check_words(&words, 1100, 1200);
}

TEST(spans_are_marked_where_they_lie)
{
    /* lambda = 0.5, mu = 2 of T = (0, 1): a mark with the number 1 */
    const double points[8] = {0, 0, 0, 0.5, -1, 1, 1, 1};
    const double parallel[8] = {0, 0, 0, 1, 2, 1, 2, 0},
                 outside[8] = {0, 0, 0, 9, 0.5, 1, 1, 1};
    batten_model *model = scene_empty();
    scene_add_curve(model, "one", bezier(points));
    scene_add_curve(model, "two", bezier(parallel));
    scene_add_curve(model, "three", bezier(outside));
    const scene_words words = words_of(model, NULL);
    CHECK(scene_find(&words, "three") != NULL);
    CHECK(scene_find(&words, "parallel") != NULL);
    CHECK(scene_find(&words, "outside") != NULL);
    batten_model_unref(model);
}

TEST(a_mark_has_the_colour_of_its_curve_at_its_place)
{
    /* in a square picture of lambda, mu from 0 to 1 the mark of (0.5, 0.5) is in its middle */
    const double points[8] = {0, 0, 0, 0.5, 0.5, 1, 1, 1};
    batten_model *model = scene_empty();
    batten_draw_options options = batten_draw_defaults();
    batten_draw_cubic_plane_options plane = batten_draw_cubic_plane_defaults();
    char *data = NULL;
    size_t size = 0;
    int marked = 0;
    scene_add_curve(model, "one", bezier(points));
    plane.low = -0.5;
    plane.high = 1.5;
    plane.glyphs = false;
    CHECK_OK(batten_draw_cubic_plane(model, &plane, &options, &data, &size));
    const scene_image image = scene_decode(data, size);
    for (int y = 0; y < image.height * 8 / 10; y++)
        for (int x = 0; x < image.width; x++)
            marked += scene_pixel(&image, x, y) == 0xCC0073;
    CHECK(marked > 10);
    batten_release(data);
    batten_model_unref(model);
}

TEST(n6_planes_that_cannot_be_shown_are_refused)
{
    const batten_draw_options options = batten_draw_defaults();
    batten_draw_cubic_plane_options plane = batten_draw_cubic_plane_defaults();
    char *data = NULL;
    size_t size = 0;
    plane.high = plane.low;
    CHECK_STATUS(batten_draw_cubic_plane(NULL, &plane, &options, &data, &size),
                 BATTEN_BAD_ARGUMENT);
    plane.high = NAN;
    CHECK_STATUS(batten_draw_cubic_plane(NULL, &plane, &options, &data, &size),
                 BATTEN_NOT_FINITE);
    batten_model *model = scene_empty();
    scene_add_curve(model, "circle", scene_circle(1));
    CHECK_STATUS(batten_draw_cubic_plane(model, NULL, &options, &data, &size),
                 BATTEN_UNSUPPORTED);
    batten_model_unref(model);
}

/* From 0 to 3 the regular cubics fill a square of side 1, those with one inflection two strips of 2, and the
 * hyperbola mu = (4 lambda - 4) / (3 lambda - 4) parts the square of side 2 that is left. */
TEST(regions_have_the_areas_of_their_closed_forms)
{
    const double loop = 7.0 / 3 - 4.0 / 9 * log(6.25);
    const struct {
        uint32_t colour;
        double area;
    } rows[] = {{0xFFF3C7, 4}, {0xFDD7B8, 4 - loop}, {0xD4DCF8, loop}};
    batten_draw_options options = batten_draw_defaults();
    batten_draw_cubic_plane_options plane = batten_draw_cubic_plane_defaults();
    char *data = NULL;
    size_t size = 0;
    plane.low = 0;
    plane.high = 3;
    plane.glyphs = false;
    CHECK_OK(batten_draw_cubic_plane(NULL, &plane, &options, &data, &size));
    const scene_image image = scene_decode(data, size);
    int regular = 0, counts[COUNT(rows)] = {0};
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            const uint32_t colour = scene_pixel(&image, x, y);
            regular += colour == 0xC7E8C7;
            for (int k = 0; k < COUNT(rows); k++)
                counts[k] += colour == rows[k].colour;
        }
    for (int k = 0; k < COUNT(rows); k++) /* lines and words cover a part */
        CHECK_NEAR((double)counts[k] / regular, rows[k].area, 0.15 * rows[k].area);
    batten_release(data);
}

/* The colour of the region of a cubic, by what batten_cubic_look_up says of its segment. */
static uint32_t colour_of(double lambda, double mu)
{
    batten_cubic_place place;
    CHECK_OK(batten_cubic_look_up(lambda, mu, &place));
    switch (place.segment) {
    case BATTEN_CUBIC_LOOP:
        return 0xD4DCF8;
    case BATTEN_CUBIC_TWO_INFLECTIONS:
        return 0xFDD7B8;
    case BATTEN_CUBIC_ONE_INFLECTION:
        return 0xFFF3C7;
    default: /* green where both lengths are between 0 and 1 */
        return lambda > 0 && mu > 0 ? 0xC7E8C7 : 0xEDF2ED;
    }
}

/* All over the plane: pixels of the colour of a region, away from the others, are of its cubics. */
TEST(every_region_has_the_colour_of_its_cubics)
{
    static const double ranges[][2] = {{-2, 3.6}, {-5, 6}, {0.5, 2}, {-0.6, 1.2}};
    static const uint32_t colours[] = {0xC7E8C7, 0xEDF2ED, 0xFFF3C7, 0xFDD7B8, 0xD4DCF8};
    for (int i = 0; i < test_cases(COUNT(ranges)) && i < COUNT(ranges); i++) {
        batten_draw_options options = batten_draw_defaults();
        batten_draw_cubic_plane_options plane = batten_draw_cubic_plane_defaults();
        char *data = NULL;
        size_t size = 0;
        options.width = options.height = 500;
        plane.low = ranges[i][0];
        plane.high = ranges[i][1];
        plane.glyphs = false;
        CHECK_OK(batten_draw_cubic_plane(NULL, &plane, &options, &data, &size));
        const scene_image image = scene_decode(data, size);
        batten_release(data);
        /* Letters of 500 x 0.0165; the frame leaves 5 and 1 of them beside it, 1 and 7.5 above and below. */
        const double em = 0.0165 * 500, low[2] = {plane.low, plane.low},
                     high[2] = {plane.high, plane.high};
        const bat_plot plot =
            bat_plot_fit((bat_rectangle){5 * em, em, 500 - 6 * em, 500 - 9.5 * em}, low, high);
        int seen = 0, wrong = 0;
        for (int y = 0; y < 500; y += 2)
            for (int x = 0; x < 500; x += 2) {
                const double lambda = plot.x0 + (x + 0.5 - plot.frame.x) / plot.scale,
                             mu = plot.y0 +
                                  (plot.frame.y + plot.frame.height - y - 0.5) / plot.scale;
                bool is_fill = false;
                for (int k = 0; k < COUNT(colours); k++)
                    is_fill |= scene_pixel(&image, x, y) == colours[k];
                if (!is_fill || lambda < plane.low || lambda > plane.high || mu < plane.low ||
                    mu > plane.high)
                    continue;
                seen++;
                wrong += scene_pixel(&image, x, y) != colour_of(lambda, mu);
            }
        CHECK(seen > 12000);
        CHECK(wrong < seen / 400); /* beside the boundaries of curved regions */
    }
}
