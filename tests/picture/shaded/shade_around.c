/* Title and legend of a shaded picture: what they say, where it stands, and the room they take. */
#include "picture/scenes.h"
#include "picture/shaded/shade.h"

#include <stdlib.h>

enum { WIDE = 600, HIGH = 400 };

/* A legend of letters of 10 on a sheet of 600 x 400, in a model of this unit. */
typedef struct {
    batten_draw_options options;
    batten_model *model;
    bat_shaded shaded;
} legend;

static void begin_legend(legend *l, batten_shading shading, double metres)
{
    l->options = batten_draw_defaults();
    l->options.shading = shading;
    l->options.width = WIDE;
    l->options.height = HIGH;
    CHECK_OK(batten_model_create(metres, &l->model));
    l->shaded = (bat_shaded){.options = &l->options,
                             .model = l->model,
                             .scene = {.range = 0.25},
                             .least = -0.2,
                             .greatest = 0.3,
                             .em = 10};
}

static batten_status draw_legend(const legend *l, batten_picture_format format, char **data,
                                 size_t *size)
{
    bat_canvas canvas;
    const batten_status status = bat_canvas_begin(format, WIDE, HIGH, 10, "", &canvas);
    if (status != BATTEN_OK)
        return status;
    bat_shaded_write_around(&canvas, &l->shaded);
    return bat_canvas_finish(&canvas, data, size);
}

static scene_words words_of(const legend *l)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(draw_legend(l, BATTEN_PICTURE_PDF, &data, &size));
    char *copy = test_array(size, 1);
    memcpy(copy, data, size);
    batten_release(data);
    batten_model_unref(l->model);
    return scene_read_pdf(copy, size);
}

/* The word stands once, begins here and has its baseline, a fifth of its height above its bottom, there. */
static void check_word(const scene_words *words, const char *text, double left, double baseline)
{
    int count = 0;
    for (int i = 0; i < words->count; i++) {
        const scene_word *w = &words->words[i];
        if (strcmp(w->text, text) != 0)
            continue;
        count++;
        CHECK_NEAR(w->left, left, 1);
        CHECK_NEAR(w->bottom - 0.2 * (w->bottom - w->top), baseline, 1);
    }
    CHECK_INT(count, 1);
}

TEST(the_legend_of_curvatures_names_range_extremes_and_unit)
{
    static const char *const ticks[] = {"0.25", "0.125", "0", "-0.125", "-0.25"};
    legend l;
    begin_legend(&l, BATTEN_SHADING_GAUSSIAN, 1);
    const scene_words words = words_of(&l);
    /* The bar is 75 from the right, 12 wide, and half as high as the sheet. Numbers are centred. */
    for (int i = 0; i < COUNT(ticks); i++)
        check_word(&words, ticks[i], 525 + 12 + 5, 100 + 50 * i + 3);
    check_word(&words, "K", 525, 100 - 32 + 3);
    CHECK(scene_find(&words, "1/m²") != NULL);
    check_word(&words, "max", 525, 100 - 16 + 3);
    check_word(&words, "min", 525, 300 + 16 + 3);
    CHECK_NEAR(scene_find(&words, "0.3")->top, scene_find(&words, "max")->top, 0.1);
    CHECK_NEAR(scene_find(&words, "-0.2")->top, scene_find(&words, "min")->top, 0.1);
    CHECK_INT(words.count, 5 + 3 + 2 + 2);
}

TEST(the_legend_of_mean_curvature_is_per_length_of_any_unit)
{
    static const struct {
        double metres;
        const char *unit;
    } units[] = {{1, "1/m"}, {0.001, "1/mm"}, {0.37, "1/unit"}};
    for (int i = 0; i < COUNT(units); i++) {
        legend l;
        begin_legend(&l, BATTEN_SHADING_MEAN, units[i].metres);
        const scene_words words = words_of(&l);
        check_word(&words, "H", 525, 100 - 32 + 3);
        CHECK(scene_find(&words, units[i].unit) != NULL);
        CHECK(scene_find(&words, "K") == NULL);
    }
}

TEST(the_bar_of_curvatures_shows_their_colours)
{
    legend l;
    char *data = NULL;
    size_t size = 0;
    begin_legend(&l, BATTEN_SHADING_GAUSSIAN, 1);
    CHECK_OK(draw_legend(&l, BATTEN_PICTURE_PNG, &data, &size));
    batten_model_unref(l.model);
    const scene_image image = scene_decode(data, size);
    batten_release(data);
    for (int y = 102; y < 298; y++) {
        const uint32_t left = scene_pixel(&image, 527, y), right = scene_pixel(&image, 534, y);
        /* Steps of 200 / 128 pixels, of 2/128 of the range. */
        const bat_colour due = bat_colour_diverging(1 - 2 * (y + 0.5 - 100) / 200);
        CHECK(left == right);
        CHECK_NEAR(scene_red(left), 255 * due.red, 8);
        CHECK_NEAR(scene_green(left), 255 * due.green, 8);
        CHECK_NEAR(scene_blue(left), 255 * due.blue, 8);
    }
    static const int outside[][2] = {{523, 200}, {539, 175}, {530, 98}, {530, 303}};
    for (int i = 0; i < COUNT(outside); i++)
        CHECK(scene_pixel(&image, outside[i][0], outside[i][1]) == 0xffffff);
    const uint32_t frame = scene_pixel(&image, 524, 200), top = scene_pixel(&image, 530, 99);
    CHECK(scene_red(frame) < 250 && scene_red(top) < 250);
}

/* Pictures without curvature at any place, and all other shadings, have no bar. */
TEST(without_curvatures_there_is_no_legend_of_them)
{
    for (int i = 0; i < 2; i++) {
        legend l;
        begin_legend(&l, i ? BATTEN_SHADING_MEAN : BATTEN_SHADING_PLAIN, 1);
        l.options.title = "Hull";
        if (i)
            l.shaded.least = HUGE_VAL, l.shaded.greatest = -HUGE_VAL;
        const scene_words words = words_of(&l);
        CHECK_INT(words.count, 1);
        const scene_word *title = scene_find(&words, "Hull");
        CHECK(title != NULL);
        CHECK_NEAR(0.5 * (title->left + title->right), 300, 1);
        CHECK_NEAR(title->bottom - 0.2 * (title->bottom - title->top), 20 + 4, 1.5);
    }
}

TEST(stripes_are_counted_below_the_picture)
{
    static const struct {
        batten_shading shading;
        double stripes;
        const char *name, *count;
    } rows[] = {{BATTEN_SHADING_ZEBRA, 24, "zebra:", "24"},
                {BATTEN_SHADING_ISOPHOTES, 12.5, "isophotes:", "12.5"}};
    for (int i = 0; i < COUNT(rows); i++) {
        legend l;
        begin_legend(&l, rows[i].shading, 1);
        l.options.stripes = rows[i].stripes;
        const scene_words words = words_of(&l);
        CHECK_INT(words.count, 7); /* "zebra: 24 stripes over the half turn" */
        const scene_word *first = scene_find(&words, rows[i].name),
                         *last = scene_find(&words, "turn");
        CHECK(first && last && scene_find(&words, rows[i].count));
        CHECK_NEAR(0.5 * (first->left + last->right), 300, 1);
        CHECK_NEAR(first->bottom - 0.2 * (first->bottom - first->top), HIGH - 15 + 3, 1);
    }
}

/* Sheets of 600 x 400 with letters of 10: the frame of the shape, and what is around it. */
static const struct {
    batten_shading shading;
    const char *title;
    bat_rectangle stage;
    double around;
} rooms[] = {
    {BATTEN_SHADING_PLAIN, "", {20, 20, 560, 360}, 40},
    {BATTEN_SHADING_PLAIN, "t", {20, 40, 560, 340}, 60},
    {BATTEN_SHADING_ISOLINES, "", {20, 20, 560, 360}, 40},
    {BATTEN_SHADING_ZEBRA, "", {20, 20, 560, 345}, 55},
    {BATTEN_SHADING_ISOPHOTES, "t", {20, 40, 560, 325}, 75},
    {BATTEN_SHADING_GAUSSIAN, "", {20, 20, 490, 360}, 40},
    {BATTEN_SHADING_MEAN, "t", {20, 40, 490, 340}, 60},
};

TEST(title_and_legend_leave_the_rest_to_the_shape)
{
    batten_draw_options options = batten_draw_defaults();
    bat_shaded p = {.options = &options, .em = 10};
    for (int i = 0; i < COUNT(rooms); i++) {
        options.width = WIDE;
        options.height = HIGH;
        options.shading = rooms[i].shading;
        options.title = rooms[i].title;
        const bat_rectangle stage = bat_shaded_stage(&p), due = rooms[i].stage;
        CHECK_BITS(stage.x, due.x);
        CHECK_BITS(stage.y, due.y);
        CHECK_BITS(stage.width, due.width);
        CHECK_BITS(stage.height, due.height);
        CHECK_BITS(bat_shaded_around(&p), rooms[i].around);
        options.width = options.height = 30; /* where nothing is left, 8 remain */
        CHECK_BITS(bat_shaded_stage(&p).width, 8);
        CHECK_BITS(bat_shaded_stage(&p).height, 8);
    }
}
