#include "picture/sheet/canvas.h"

#include "picture/scenes.h"
#include "picture/sheet/pixels.h"

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

/* ---- marks by their pixels ---- */

/* Strokes and gaps in widths of the line, one after another from its start; a fine line has them
 * in points. */
TEST(dashes_have_the_lengths_of_their_kind)
{
    static const struct {
        bat_dash dash;
        double width, lengths[5];
    } kinds[] = {{BAT_SOLID, 2, {180}},
                 {BAT_DASHED, 2, {12, 8, 12, 8}},
                 {BAT_CHAIN, 2, {24, 6, 4, 6, 24}},
                 {BAT_DOTTED, 2, {3, 6, 3, 6}},
                 {BAT_DASHED, 4, {24, 16, 24}}};
    for (int i = 0; i < COUNT(kinds); i++) {
        bat_canvas canvas = begin_pixels();
        const bat_pen pen = {ink, kinds[i].width, kinds[i].dash};
        double x = 10;
        bat_canvas_segment(&canvas, pen, 10, 50, 190, 50);
        for (int k = 0; k < 5 && kinds[i].lengths[k] > 0; x += kinds[i].lengths[k++]) {
            CHECK(is_dark(&canvas, x + 0.5, 50) == (k % 2 == 0));
            CHECK(is_dark(&canvas, x + kinds[i].lengths[k] - 0.5, 50) == (k % 2 == 0));
        }
        CHECK_INT((long long)dark_box(&canvas).height, (long long)kinds[i].width);
        bat_canvas_end(&canvas);
    }
}

/* Only solid lines have round ends, which reach over. */
TEST(lines_end_round_when_they_are_solid)
{
    static const bat_dash dashes[] = {BAT_SOLID, BAT_DASHED};
    for (int i = 0; i < 2; i++) {
        bat_canvas canvas = begin_pixels();
        bat_canvas_segment(&canvas, (bat_pen){ink, 10, dashes[i]}, 50, 50, 80, 50);
        CHECK(is_dark(&canvas, 47.5, 50) == (i == 0));
        CHECK(is_dark(&canvas, 82.5, 50) == (i == 0));
        CHECK(is_dark(&canvas, 51.5, 50) && is_dark(&canvas, 78.5, 50));
        bat_canvas_end(&canvas);
    }
}

TEST(a_cross_has_four_arms_and_a_disc_is_round)
{
    bat_canvas canvas = begin_pixels();
    bat_canvas_cross(&canvas, (bat_pen){ink, 2, BAT_SOLID}, 50, 50, 10);
    for (int k = 0; k < 4; k++) {
        const double dx = k % 2 ? 1 : -1, dy = k / 2 ? 1 : -1;
        CHECK(is_dark(&canvas, 50 + 8 * dx, 50 + 8 * dy));
        CHECK(!is_dark(&canvas, 50 + 8 * dx, 50) && !is_dark(&canvas, 50, 50 + 8 * dy));
        CHECK(!is_dark(&canvas, 50 + 13 * dx, 50 + 13 * dy));
    }
    bat_canvas_end(&canvas);
    canvas = begin_pixels();
    bat_canvas_disc(&canvas, ink, 50, 50, 10);
    const bat_rectangle box = dark_box(&canvas);
    CHECK(box.x == 40 && box.y == 40 && box.width == 20 && box.height == 20);
    for (int k = 0; k < 8; k++)
        CHECK(is_dark(&canvas, 50 + 8.5 * cos(k), 50 + 8.5 * sin(k)) &&
              !is_dark(&canvas, 50 + 11.5 * cos(k), 50 + 11.5 * sin(k)));
    bat_canvas_end(&canvas);
}

TEST(a_frame_is_hollow_and_a_polygon_and_a_box_are_full)
{
    bat_canvas canvas = begin_pixels();
    bat_canvas_frame(&canvas, (bat_pen){ink, 2, BAT_SOLID}, (bat_rectangle){20, 30, 40, 50});
    bat_rectangle box = dark_box(&canvas);
    CHECK(box.x == 19 && box.y == 29 && box.width == 42 && box.height == 52);
    CHECK(!is_dark(&canvas, 40, 50) && is_dark(&canvas, 40, 30) && is_dark(&canvas, 60, 50));
    bat_canvas_end(&canvas);
    canvas = begin_pixels();
    bat_canvas_box(&canvas, ink, (bat_rectangle){20, 30, 40, 50});
    box = dark_box(&canvas);
    CHECK(box.x == 20 && box.y == 30 && box.width == 40 && box.height == 50);
    CHECK(is_dark(&canvas, 40, 50));
    bat_canvas_end(&canvas);
    canvas = begin_pixels();
    bat_canvas_fill(&canvas, ink, 1, 3, (double[]){20, 20, 60, 20, 20, 60});
    CHECK(is_dark(&canvas, 25, 25) && is_dark(&canvas, 35, 35) && !is_dark(&canvas, 55, 55));
    bat_canvas_end(&canvas);
}

static void draw_text(bat_canvas *canvas, bool is_bold, double size, bat_anchor anchor,
                      const char *text)
{
    if (is_bold)
        bat_canvas_bold(canvas, ink, size, anchor, 100, 50, text);
    else
        bat_canvas_text(canvas, ink, size, anchor, 100, 50, text);
}

/* Figures are about 0.72 of their size high, and their middle is where it was asked for. */
TEST(a_text_stands_beside_or_around_its_point_and_its_figures_around_its_height)
{
    for (int is_bold = 0; is_bold < 2; is_bold++)
        for (int anchor = BAT_LEFT; anchor <= BAT_RIGHT; anchor++) {
            bat_canvas canvas = begin_pixels();
            draw_text(&canvas, is_bold, 30, (bat_anchor)anchor, "8008");
            const bat_rectangle box = dark_box(&canvas);
            const double wide = bat_canvas_text_width(&canvas, 30, "8008");
            CHECK_NEAR(box.x + box.width / 2, 100 + (1 - anchor) * wide / 2, is_bold ? 9 : 3);
            CHECK_NEAR(box.y + box.height / 2, 50, 2);
            CHECK_NEAR(box.height, 0.72 * 30, 3);
            bat_canvas_end(&canvas);
        }
}

TEST(the_width_of_a_text_grows_with_its_size_and_its_letters)
{
    bat_canvas canvas = begin_pixels();
    const double one = bat_canvas_text_width(&canvas, 10, "8");
    CHECK(one > 3 && one < 10);
    CHECK_NEAR(bat_canvas_text_width(&canvas, 10, "8888"), 4 * one, 1e-6);
    CHECK_NEAR(bat_canvas_text_width(&canvas, 30, "8888"), 12 * one, 1e-6);
    CHECK_NEAR(bat_canvas_text_width(&canvas, 30, ""), 0, 0);
    bat_canvas_end(&canvas);
}

TEST(a_text_upwards_is_turned_about_its_middle)
{
    bat_canvas canvas = begin_pixels();
    bat_canvas_text_up(&canvas, ink, 30, 100, 50, "8008");
    const bat_rectangle box = dark_box(&canvas);
    CHECK_NEAR(box.x + box.width / 2, 100, 2);
    CHECK_NEAR(box.y + box.height / 2, 50, 3);
    CHECK_NEAR(box.width, 0.72 * 30, 3);
    CHECK(box.height > 50);
    bat_canvas_end(&canvas);
}

/* Two labels at that distance: is there room for the second? */
static bool both_fit(double dx, double dy)
{
    bat_canvas canvas = begin_pixels();
    CHECK(bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, 100, 50, "88"));
    const bool fits = bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, 100 + dx, 50 + dy, "88");
    bat_canvas_end(&canvas);
    return fits;
}

/* A label takes its width, 0.3 of its size on either side, and its size in height. */
TEST(a_label_keeps_free_as_much_as_it_covers)
{
    if (test_cases(1000) < 1000)
        SKIP("labels without memory are another test");
    bat_canvas canvas = begin_pixels();
    const double wide = bat_canvas_text_width(&canvas, 10, "88") + 6;
    bat_canvas_box(&canvas, ink, (bat_rectangle){0, 0, 200, 100});
    CHECK(bat_canvas_label(&canvas, (bat_colour){1, 1, 1}, 10, BAT_MIDDLE, 100, 50, "88"));
    CHECK(is_dark(&canvas, 100, 43) && !is_dark(&canvas, 100, 46) &&
          !is_dark(&canvas, 100, 54));
    CHECK(is_dark(&canvas, 100, 57) && is_dark(&canvas, 100 - wide / 2 - 2, 50));
    CHECK(!is_dark(&canvas, 100 - wide / 2 + 2, 50) &&
          !is_dark(&canvas, 100 + wide / 2 - 2, 50));
    CHECK(is_dark(&canvas, 100 + wide / 2 + 2, 50));
    for (int side = -1; side <= 1; side += 2) {
        CHECK(!both_fit(side * (wide - 0.5), 0) && both_fit(side * (wide + 0.5), 0));
        CHECK(!both_fit(0, side * 9.5) && both_fit(0, side * 10.5));
    }
    const double beside = wide / 2;
    CHECK(!bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, beside - 1, 20, "88"));
    CHECK(bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, beside + 1, 20, "88"));
    CHECK(!bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, 200 - beside + 1, 20, "88"));
    CHECK(bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, 200 - beside - 1, 20, "88"));
    CHECK(!bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, 100, 4, "88"));
    CHECK(bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, 100, 6, "88"));
    CHECK(!bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, 100, 96, "88"));
    CHECK(bat_canvas_label(&canvas, ink, 10, BAT_MIDDLE, 100, 94, "88"));
    bat_canvas_end(&canvas);
}

/* What is no letter of UTF-8 is a question mark for each of its bytes. */
TEST(bytes_that_are_no_letters_are_as_wide_as_question_marks)
{
    static const struct {
        const char *text;
        int marks; /* 0: a letter */
    } cases[] = {{"\xed\xa0\x80", 3},
                 {"\xed\xbf\xbf", 3},
                 {"\xc0\xaf", 2},
                 {"\xff", 1},
                 {"\x01", 1},
                 {"\xc3", 1},
                 {"\xe0\x80\x80", 3},
                 {"\xf4\x90\x80\x80", 4},
                 {"\xf0\x80\x80\x80", 4},
                 {"\x80", 1},
                 {"\xc3\xa9", 0},
                 {"\xe2\x82\xac", 0},
                 {"W", 0},
                 {"\xed\x9f\xbf"
                  "i",
                  0}};
    bat_canvas canvas = begin_pixels();
    const double mark = bat_canvas_text_width(&canvas, 20, "?");
    for (int i = 0; i < COUNT(cases); i++) {
        const double wide = bat_canvas_text_width(&canvas, 20, cases[i].text);
        const int bytes = (int)strlen(cases[i].text);
        if (cases[i].marks)
            CHECK_NEAR(wide, cases[i].marks * mark, 1e-9);
        else
            CHECK(fabs(wide - bytes * mark) > 0.1);
    }
    bat_canvas_end(&canvas);
}
