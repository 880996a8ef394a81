#include "picture/scenes.h"

#include <batten/standard.h>

/* A line from a to b on a layer. */
static void add_line(batten_model *model, const char *layer, const double ends[2][3])
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){3, 2, ends[0]}, &curve));
    const batten_object object = {
        .name = "path", .layer = layer, .kind = BATTEN_OBJECT_CURVE, .curve = curve};
    CHECK_OK(batten_model_add(model, &object));
    batten_curve_unref(curve);
}

static const struct {
    const char *layer;
    double ends[2][3];
} moves[] = {
    {"plunge", {{0, 0, 5}, {0, 0, -1}}},     {"cut", {{0, 0, -1}, {40, 0, -1}}},
    {"travel", {{40, 0, 5}, {40, 30, 5}}},   {"plunge", {{40, 30, 5}, {40, 30, -1}}},
    {"cut", {{40, 30, -1}, {0.75, 30, -1}}},
};

static batten_model *way_of_a_tool(int first, int count)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = first; i < first + count; i++)
        add_line(model, moves[i].layer, moves[i].ends);
    return model;
}

static char *svg_of(const batten_model *model, batten_draw_options options)
{
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_PICTURE_SVG;
    CHECK_OK(batten_draw_tool_path(model, &options, &data, &size));
    char *copy = test_array(size + 1, 1);
    memcpy(copy, data, size);
    batten_release(data);
    return copy;
}

static int occurrences(const char *text, const char *what)
{
    int count = 0;
    for (const char *at = strstr(text, what); at; at = strstr(at + 1, what))
        count++;
    return count;
}

TEST(the_legend_of_a_tool_has_its_lengths_and_starts_are_numbered)
{
    batten_model *model = way_of_a_tool(0, 5);
    batten_draw_options options = batten_draw_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_PICTURE_PDF;
    CHECK_OK(batten_draw_tool_path(model, &options, &data, &size));
    const scene_words words = scene_read_pdf(data, size);
    static const char *const wanted[] = {"cut:",  "79.25", "travel:", "30",
                                         "down:", "12",    "1",       "2"};
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
        CHECK(scene_find(&words, wanted[i]) != NULL);
    /* Where each begins: the first lower left, the second upper right. */
    const scene_word *one = scene_find(&words, "1"), *two = scene_find(&words, "2");
    CHECK(one->left < two->left);
    CHECK(scene_find(&words, "3") == NULL);
    CHECK(scene_find(&words, "path") == NULL);
    batten_release(data);
    batten_model_unref(model);
}

TEST(cuts_are_solid_travel_is_dashed_and_each_has_its_colour)
{
    batten_model *cut = way_of_a_tool(1, 1), *all = way_of_a_tool(0, 5);
    const batten_draw_options options = batten_draw_defaults();
    const char *only = svg_of(cut, options), *every = svg_of(all, options);
    CHECK_INT(occurrences(only, "stroke-dasharray"), 0);
    /* A travel, two plunges, and the legend of both. */
    CHECK_INT(occurrences(every, "stroke-dasharray"), 5);
    CHECK_INT(occurrences(every, "9%, 32%, 62%") + occurrences(every, "9%,32%,62%"), 3);
    CHECK_INT(occurrences(every, "76%, 26%, 10%") + occurrences(every, "76%,26%,10%"), 2);
    CHECK_INT(occurrences(every, "8%, 48%, 30%") + occurrences(every, "8%,48%,30%"), 3);
    batten_model_unref(all);
    batten_model_unref(cut);
}

TEST(a_tool_is_seen_from_above_unless_another_view_is_asked_for)
{
    batten_model *model = way_of_a_tool(0, 5);
    batten_draw_options options = batten_draw_defaults();
    static const struct {
        batten_view view;
        const char *right, *up;
    } rows[] = {{BATTEN_VIEW_AUTO, "x", "y"},
                {BATTEN_VIEW_TOP, "x", "y"},
                {BATTEN_VIEW_SIDE, "x", "z"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char *data = NULL;
        size_t size = 0;
        options.view = rows[i].view;
        options.format = BATTEN_PICTURE_PDF;
        CHECK_OK(batten_draw_tool_path(model, &options, &data, &size));
        const scene_words words = scene_read_pdf(data, size);
        CHECK(scene_find(&words, rows[i].right) != NULL);
        CHECK(scene_find(&words, rows[i].up) != NULL);
        batten_release(data);
    }
    batten_model_unref(model);
}

TEST(what_is_not_the_way_of_a_tool_is_refused)
{
    const batten_draw_options options = batten_draw_defaults();
    batten_model *idle = way_of_a_tool(2, 2), *other = way_of_a_tool(0, 2);
    char *data = NULL;
    size_t size = 0;
    CHECK_STATUS(batten_draw_tool_path(idle, &options, &data, &size), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("cuts nothing");
    add_line(other, "frame", moves[1].ends);
    CHECK_STATUS(batten_draw_tool_path(other, &options, &data, &size), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("object 3, 'path', is not a curve on a layer cut, plunge or travel");
    CHECK_INT(data == NULL, 1);
    batten_model_unref(other);
    batten_model_unref(idle);
}
