#include "picture/sheet/sheet.h"

#include "picture/scenes.h"

TEST(a_round_step_is_the_smallest_that_gives_few_enough_parts)
{
    static const struct {
        double range, count, step;
    } rows[] = {{10, 10, 1},  {1, 10, 0.1},  {12, 10, 2},    {25, 10, 5},
                {60, 10, 10}, {0.3, 5, 0.1}, {2e-7, 4, 5e-8}};
    for (int i = 0; i < COUNT(rows); i++)
        CHECK_NEAR(bat_round_step(rows[i].range, rows[i].count) / rows[i].step, 1, 1e-12);

    test_random random = test_random_begin("steps");
    for (int i = 0; i < test_cases(1000); i++) {
        const double range = pow(10, test_random_in(&random, -12, 12));
        const double step = bat_round_step(range, 7);
        CHECK(range / step <= 7 * (1 + 1e-8));
        CHECK(range / step > 7 / 2.5 * (1 - 1e-8));
    }
}

TEST(numbers_are_written_with_the_decimals_of_their_step)
{
    static const struct {
        double value;
        int decimals;
        const char *text;
    } rows[] = {{3 * 0.1, 1, "0.3"}, {-0.04, 1, "0"}, {1234.5, -2, "1200"},
                {7, 0, "7"},         {2.5, 2, "2.5"}, {-1.25, 2, "-1.25"}};
    for (int i = 0; i < COUNT(rows); i++) {
        char text[BATTEN_NUMBER_SIZE];
        bat_number_text(rows[i].value, rows[i].decimals, text);
        CHECK_TEXT(text, rows[i].text);
    }
    CHECK_INT(bat_decimals_of_step(0.05), 2);
    CHECK_INT(bat_decimals_of_step(0.1), 1);
    CHECK_INT(bat_decimals_of_step(1), 0);
    CHECK_INT(bat_decimals_of_step(500), -2);
}

TEST(digits_are_kept_and_no_more)
{
    static const struct {
        double value;
        int digits;
        const char *text;
    } rows[] = {{12.3456, 4, "12.35"},
                {0.00123456, 3, "0.00123"},
                {123456, 3, "123000"},
                {-9.996, 3, "-10"},
                {0, 3, "0"}};
    for (int i = 0; i < COUNT(rows); i++) {
        char text[BATTEN_NUMBER_SIZE];
        bat_digits_text(rows[i].value, rows[i].digits, text);
        CHECK_TEXT(text, rows[i].text);
    }
}

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
