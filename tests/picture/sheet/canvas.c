#include "picture/sheet/canvas.h"

#include "picture/scenes.h"

static const bat_colour ink = {0, 0, 0};

/* One sheet of every kind of mark, in a format. */
static batten_status draw_marks(batten_picture_format format, const char *name, char **data,
                                size_t *size)
{
    bat_canvas canvas;
    batten_status status = bat_canvas_begin(format, 200, 100, 10, name, &canvas);
    if (status != BATTEN_OK)
        return status;
    for (int dash = BAT_SOLID; dash <= BAT_DOTTED; dash++)
        bat_canvas_segment(&canvas, (bat_pen){ink, 1, dash}, 10, 20 + 5 * dash, 190,
                           20 + 5 * dash);
    bat_canvas_disc(&canvas, ink, 20, 60, 4);
    bat_canvas_cross(&canvas, (bat_pen){ink, 1, BAT_SOLID}, 40, 60, 4);
    bat_canvas_fill(&canvas, ink, 0.5, 3, (double[]){60, 55, 70, 55, 65, 65});
    bat_canvas_clip(&canvas, (bat_rectangle){80, 50, 20, 20});
    bat_canvas_box(&canvas, ink, (bat_rectangle){0, 0, 90, 100});
    bat_canvas_unclip(&canvas);
    bat_canvas_text_up(&canvas, ink, 8, 150, 60, name);
    bat_canvas_label(&canvas, ink, 8, BAT_MIDDLE, 60, 85, name);
    return bat_canvas_finish(&canvas, data, size);
}

TEST(S1_sizes_that_cannot_be_are_refused)
{
    static const struct {
        int width, height;
        batten_status status;
    } rows[] = {{0, 100, BATTEN_BAD_ARGUMENT},     {100, -1, BATTEN_BAD_ARGUMENT},
                {63, 64, BATTEN_BAD_ARGUMENT},     {64, 64, BATTEN_OK},
                {16385, 64, BATTEN_TOO_LARGE},     {100000, 100000, BATTEN_TOO_LARGE},
                {64, 2147483647, BATTEN_TOO_LARGE}};
    for (int i = 0; i < COUNT(rows); i++)
        CHECK_STATUS(bat_canvas_check_size(rows[i].width, rows[i].height), rows[i].status);
    bat_canvas canvas;
    CHECK_STATUS(bat_canvas_begin(BATTEN_PICTURE_PNG, 0, 100, 10, "", &canvas),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("0 x 100");
}

TEST(the_same_marks_give_the_same_bytes)
{
    for (int format = BATTEN_PICTURE_PNG; format <= BATTEN_PICTURE_PDF; format++) {
        char *first = NULL, *second = NULL;
        size_t first_size = 0, second_size = 0;
        CHECK_OK(draw_marks(format, "keel", &first, &first_size));
        CHECK_OK(draw_marks(format, "keel", &second, &second_size));
        CHECK_INT(first_size, second_size);
        CHECK(memcmp(first, second, first_size) == 0);
        batten_release(first);
        batten_release(second);
    }
}

TEST(marks_stand_where_they_were_put)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(draw_marks(BATTEN_PICTURE_PNG, "", &data, &size));
    const scene_image image = scene_decode(data, size);
    CHECK_INT(image.width, 200);
    CHECK_INT(image.height, 100);
    CHECK_INT(scene_pixel(&image, 5, 5), 0xffffff);               /* the sheet is white */
    CHECK_INT(scene_pixel(&image, 20, 60), 0);                    /* in the disc */
    CHECK_INT(scene_pixel(&image, 25, 65), 0xffffff);             /* outside */
    CHECK_INT(scene_pixel(&image, 85, 60), 0);                    /* in the clipped box */
    CHECK_INT(scene_pixel(&image, 78, 60), 0xffffff);             /* clipped away */
    CHECK_INT(scene_pixel(&image, 95, 60), 0xffffff);             /* beside the box */
    CHECK_NEAR(scene_red(scene_pixel(&image, 65, 58)), 127.5, 2); /* half opaque */
    batten_release(data);
}

TEST(F4_names_that_are_not_utf8_are_drawn)
{
    static const char *const names[] = {"\xff\xfe",
                                        "caf\xe9",
                                        "cut \xe2\x82",
                                        "\xc0\x80 overlong",
                                        "\xed\xa0\x80 surrogate",
                                        "\x01\x1b control",
                                        "\xf4\x90\x80\x80 beyond",
                                        "\u03ba\u00e9"};
    for (int i = 0; i < COUNT(names); i++)
        for (int format = BATTEN_PICTURE_PNG; format <= BATTEN_PICTURE_PDF; format++) {
            char *data = NULL;
            size_t size = 0;
            CHECK_OK(draw_marks(format, names[i], &data, &size));
            batten_release(data);
        }
}

TEST(a_very_long_name_is_cut)
{
    bat_canvas canvas;
    char *name = test_array(100001, 1);
    memset(name, 'm', 100000);
    CHECK_OK(bat_canvas_begin(BATTEN_PICTURE_PNG, 200, 100, 10, "", &canvas));
    CHECK(bat_canvas_text_width(&canvas, 1, name) < 300);
    bat_canvas_end(&canvas);
}

TEST(labels_never_cover_each_other_or_leave_the_sheet)
{
    bat_canvas canvas;
    CHECK_OK(bat_canvas_begin(BATTEN_PICTURE_PNG, 200, 100, 10, "", &canvas));
    const double width = bat_canvas_text_width(&canvas, 10, "station");
    const bool first = bat_canvas_label(&canvas, ink, 10, BAT_LEFT, 50, 50, "station");
    CHECK(!bat_canvas_label(&canvas, ink, 10, BAT_LEFT, 50 + 0.9 * width, 50, "station") ||
          canvas.status != BATTEN_OK);
    if (canvas.status == BATTEN_OK) {
        CHECK(first);
        CHECK(bat_canvas_label(&canvas, ink, 10, BAT_LEFT, 50 + 1.2 * width, 50, "keel"));
        CHECK(bat_canvas_label(&canvas, ink, 10, BAT_LEFT, 50, 62, "station"));
        CHECK(bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, 60, 85, "taken"));
        CHECK(!bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, 60, 88, "taken") ||
              canvas.status != BATTEN_OK);
        CHECK(!bat_canvas_label(&canvas, ink, 10, BAT_RIGHT, 10, 20, "left of the sheet"));
        CHECK(!bat_canvas_label(&canvas, ink, 10, BAT_LEFT, 190, 20, "right of the sheet"));
        CHECK(!bat_canvas_label(&canvas, ink, 10, BAT_LEFT, 100, 98, "below"));
        CHECK(!bat_canvas_label(&canvas, ink, 10, BAT_LEFT, 100, 2, "above"));
    }
    bat_canvas_end(&canvas);
}

TEST(an_empty_label_covers_nothing)
{
    bat_canvas canvas;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(bat_canvas_begin(BATTEN_PICTURE_PNG, 200, 100, 10, "", &canvas));
    bat_canvas_box(&canvas, ink, (bat_rectangle){0, 0, 200, 100});
    bat_canvas_label(&canvas, ink, 20, BAT_LEFT, 50, 50, "");
    const batten_status status = bat_canvas_finish(&canvas, &data, &size);
    if (!test_memory_failed(status, BATTEN_OK)) {
        CHECK_INT(status, BATTEN_OK);
        const scene_image image = scene_decode(data, size);
        for (int x = 0; x < 200; x++)
            CHECK_INT(scene_pixel(&image, x, 50), 0);
    }
    batten_release(data);
}

TEST(many_labels_find_memory_or_say_so)
{
    bat_canvas canvas;
    CHECK_OK(bat_canvas_begin(BATTEN_PICTURE_SVG, 200, 100, 10, "", &canvas));
    for (int i = 0; i < 400; i++)
        bat_canvas_label(&canvas, ink, 1, BAT_LEFT, 2 + 4 * (i % 40), 2 + 4 * (i / 40), "1");
    char *data = NULL;
    size_t size = 0;
    const batten_status status = bat_canvas_finish(&canvas, &data, &size);
    CHECK(status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY);
    batten_release(data);
}
