#include "picture/sheet/sheet.h"

#include "picture/scenes.h"
#include "picture/sheet/pixels.h"

TEST(a_plot_shows_its_range_as_large_as_possible_in_the_middle)
{
    const bat_rectangle frame = {10, 20, 300, 200};
    const bat_plot plot = bat_plot_fit(frame, (double[]){-1, 5}, (double[]){2, 6});
    CHECK_NEAR(plot.scale, 100, 1e-12);
    CHECK_NEAR(bat_plot_x(&plot, -1), 10, 1e-12);
    CHECK_NEAR(bat_plot_x(&plot, 2), 310, 1e-12);
    CHECK_NEAR(bat_plot_y(&plot, 5.5), 120, 1e-12);
    CHECK_NEAR(bat_plot_y(&plot, 6) + 100, bat_plot_y(&plot, 5), 1e-12);
}

TEST(a_point_and_a_line_have_a_plot_too)
{
    const bat_rectangle frame = {0, 0, 100, 100};
    const bat_plot point = bat_plot_fit(frame, (double[]){7, 7}, (double[]){7, 7});
    CHECK_NEAR(bat_plot_x(&point, 7), 50, 1e-12);
    const bat_plot line = bat_plot_fit(frame, (double[]){0, 3}, (double[]){0, 5});
    CHECK_NEAR(line.scale, 50, 1e-12);
    CHECK_NEAR(bat_plot_x(&line, 0), 50, 1e-12);
}

TEST(a_legend_breaks_into_rows_and_has_a_limit)
{
    bat_canvas canvas;
    CHECK_OK(bat_canvas_begin(BATTEN_PICTURE_SVG, 400, 300, 10, "", &canvas));
    bat_legend legend = {0};
    CHECK_NEAR(bat_legend_height(&canvas, &legend, 300), 0, 0);
    for (int i = 0; i < 40; i++)
        bat_legend_add(&legend, i % 4, (bat_pen){bat_ink, 1, BAT_SOLID}, "entry %d", i);
    CHECK_INT(legend.count, BAT_LEGEND_LIMIT);
    CHECK_TEXT(legend.entries[2].text, "entry 2");
    CHECK_NEAR(bat_legend_height(&canvas, &legend, 1e6), 15, 1e-12);
    CHECK_NEAR(bat_legend_height(&canvas, &legend, 1), 15 * BAT_LEGEND_LIMIT, 1e-9);
    bat_legend_draw(&canvas, &legend, 10, 10, 300);
    bat_canvas_end(&canvas);
}

TEST(a_scale_bar_is_as_long_as_it_says)
{
    /* 100 points per metre in 320 points: five pieces of 0.5 m, 250 points. */
    bat_canvas canvas;
    CHECK_OK(bat_canvas_begin(BATTEN_PICTURE_PNG, 400, 100, 20, "", &canvas));
    bat_scale_bar(&canvas, 20, 50, 320, 100, "m");
    if (canvas.status != BATTEN_OK) {
        bat_canvas_end(&canvas);
        return;
    }
    char *data = NULL;
    size_t size = 0;
    if (bat_canvas_finish(&canvas, &data, &size) != BATTEN_OK)
        return;
    const scene_image image = scene_decode(data, size);
    for (int piece = 0; piece < 5; piece++)
        CHECK_INT(scene_red(scene_pixel(&image, 20 + 50 * piece + 25, 54)) > 200, piece % 2);
    CHECK(scene_red(scene_pixel(&image, 266, 54)) < 100);
    CHECK(scene_red(scene_pixel(&image, 274, 54)) > 200);
    batten_release(data);
}

/* Three units across and one up, each 50 pixels, on a sheet of 200 x 100. */
static const bat_plot plot = {.frame = {40, 10, 150, 50}, .scale = 50, .x0 = -1, .y0 = 0};

/* Lines at whole units: 60 pixels, six letters, are the least distance. */
TEST(a_grid_has_a_line_and_a_number_at_each_round_coordinate)
{
    bat_plot half = plot;
    bat_canvas canvas = begin_pixels();
    canvas.em = 5; /* 30 pixels apart: half a unit will do no more than a whole */
    bat_plot_grid(&canvas, &plot, "", "");
    for (int k = 0; k < 3; k++)
        CHECK(has_marks(&canvas, 40 + 50 * k, 30, 2, 1) &&
              !has_marks(&canvas, 44 + 50 * k, 20, 18, 15) &&
              !has_marks(&canvas, 68 + 50 * k, 20, 18, 15));
    for (int k = 0; k <= 3; k++) { /* -1, 0, 1 and 2 below */
        CHECK(has_marks(&canvas, 38 + 50 * k, 62, 4, 5));
        CHECK(k == 3 || !has_marks(&canvas, 55 + 50 * k, 62, 20, 10));
    }
    CHECK(has_marks(&canvas, 33, 7, 5, 6)); /* 1 at the left; 0 would meet -1 below */
    CHECK(!has_marks(&canvas, 20, 20, 17, 30) && !has_marks(&canvas, 0, 72, 200, 28));
    bat_canvas_end(&canvas);
    half.scale = 100; /* a unit is 100 pixels: lines at halves */
    canvas = begin_pixels();
    canvas.em = 5;
    bat_plot_grid(&canvas, &half, "", "");
    CHECK(has_marks(&canvas, 90, 30, 2, 1) && has_marks(&canvas, 140, 30, 2, 1));
    bat_canvas_end(&canvas);
}

TEST(the_names_of_the_axes_stand_below_and_left_of_the_numbers)
{
    bat_canvas canvas = begin_pixels();
    canvas.em = 5;
    bat_plot_grid(&canvas, &plot, "88", "88");
    CHECK(has_marks(&canvas, 110, 66, 10, 8)); /* two letters below the frame, in its middle */
    CHECK(!has_marks(&canvas, 60, 74, 100, 20));
    const double left = 40 - bat_plot_numbers_width(&canvas, &plot) - 6;
    CHECK(has_marks(&canvas, left - 3, 30, 6, 10));
    CHECK(!has_marks(&canvas, 0, 30, left - 4, 10));
    bat_canvas_end(&canvas);
}

TEST(the_numbers_at_the_left_are_as_wide_as_the_widest)
{
    static const struct {
        double scale, y0;
        const char *widest;
    } cases[] = {{50, 0, "0"},      {50, -1, "-1"},  {0.5, 0, "100"},
                 {5000, 0, "0.01"}, {50, 99, "100"}, {50, 1e17, ""},
                 {50, -1e17, ""},   {50, 1e15, ""},  {50, -1e15 - 1, ""}};
    bat_canvas canvas = begin_pixels();
    canvas.em = 5;
    for (int i = 0; i < COUNT(cases); i++) {
        bat_plot of = plot;
        of.scale = cases[i].scale;
        of.y0 = cases[i].y0;
        CHECK_NEAR(bat_plot_numbers_width(&canvas, &of),
                   bat_canvas_text_width(&canvas, 0.85 * 5, cases[i].widest), 1e-9);
    }
    bat_canvas_end(&canvas);
}

/* The sample stands before its text, each in its own way. */
TEST(a_legend_shows_a_sample_of_each_kind)
{
    static const struct {
        bat_sample sample;
        bool at_start, in_middle, above; /* 3 pixels above the middle */
    } kinds[] = {{BAT_SAMPLE_LINE, true, true, false},
                 {BAT_SAMPLE_POLYGON, true, true, false},
                 {BAT_SAMPLE_CROSS, false, true, false},
                 {BAT_SAMPLE_DOT, false, true, false},
                 {BAT_SAMPLE_DISC, false, true, true}};
    for (int i = 0; i < COUNT(kinds); i++) {
        bat_canvas canvas = begin_pixels();
        canvas.em = 20;
        bat_legend legend = {0};
        bat_legend_add(&legend, kinds[i].sample, (bat_pen){{0, 0, 0}, 2, BAT_SOLID}, "88");
        bat_legend_draw(&canvas, &legend, 20, 20, 180);
        CHECK(is_dark(&canvas, 22, 35) == kinds[i].at_start);
        CHECK(is_dark(&canvas, 20 + 22, 35) == kinds[i].in_middle);
        CHECK(is_dark(&canvas, 20 + 22, 31.5) == kinds[i].above);
        /* a polygon has its points at both ends */
        CHECK(is_dark(&canvas, 21, 32.5) == (kinds[i].sample == BAT_SAMPLE_POLYGON));
        CHECK(is_dark(&canvas, 63, 32.5) == (kinds[i].sample == BAT_SAMPLE_POLYGON));
        CHECK(has_marks(&canvas, 77, 28, 18, 14) && !has_marks(&canvas, 68, 28, 7, 14));
        bat_canvas_end(&canvas);
    }
}

TEST(entries_of_a_legend_stand_side_by_side_while_there_is_room)
{
    bat_canvas canvas = begin_pixels();
    bat_legend legend = {0};
    for (int i = 0; i < 2; i++)
        bat_legend_add(&legend, BAT_SAMPLE_LINE, (bat_pen){{0, 0, 0}, 2, BAT_SOLID}, "8");
    const double one = 28 + bat_canvas_text_width(&canvas, 9, "8");
    CHECK_NEAR(bat_legend_height(&canvas, &legend, 2 * one + 20 + 1), 15, 1e-9);
    CHECK_NEAR(bat_legend_height(&canvas, &legend, 2 * one + 20 - 1), 30, 1e-9);
    bat_legend_draw(&canvas, &legend, 10, 10, 2 * one + 21);
    CHECK(is_dark(&canvas, 12, 17) && is_dark(&canvas, 10 + one + 22, 17));
    CHECK(!has_marks(&canvas, 0, 26, 200, 60));
    bat_legend_draw(&canvas, &legend, 10, 50, 2 * one + 19);
    CHECK(is_dark(&canvas, 12, 57) && is_dark(&canvas, 12, 72));
    CHECK(!is_dark(&canvas, 10 + one + 22, 57));
    bat_canvas_end(&canvas);
}
