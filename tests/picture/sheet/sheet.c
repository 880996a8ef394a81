#include "picture/sheet/sheet.h"

#include "picture/scenes.h"

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
