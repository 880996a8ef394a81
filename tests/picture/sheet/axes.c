/* Axes beside a drawing: three arms with their names, or a grid with the names of two. */
#include "picture/sheet/axes.h"

#include "picture/scenes.h"

enum { WIDE = 400, HIGH = 300, EM = 10 };

static batten_status draw_axes(const bat_view *view, batten_view kind, char **data,
                               size_t *size)
{
    bat_canvas canvas;
    const batten_status status =
        bat_canvas_begin(BATTEN_PICTURE_PDF, WIDE, HIGH, EM, "", &canvas);
    if (status != BATTEN_OK)
        return status;
    const bat_plot plot =
        bat_plot_fit((bat_rectangle){60, 40, 300, 200}, (double[]){0, 0}, (double[]){3, 2});
    bat_axes_draw(&canvas, &plot, view, kind, "mm");
    return bat_canvas_finish(&canvas, data, size);
}

static scene_words words_of(const bat_view *view, batten_view kind)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(draw_axes(view, kind, &data, &size));
    const scene_words words = scene_read_pdf(data, size);
    batten_release(data);
    return words;
}

static const struct {
    batten_view kind;
    double azimuth, elevation;
    bool named[3]; /* an axis that points to the eye has no name */
} views[] = {
    {BATTEN_VIEW_AXONOMETRIC, 0.7, 0.5, {true, true, true}},
    {BATTEN_VIEW_AXONOMETRIC, -2.1, -0.3, {true, true, true}},
    {BATTEN_VIEW_ISOMETRIC, 0, 0, {true, true, true}},
    {BATTEN_VIEW_AXONOMETRIC, 0, 0.05, {false, true, true}},
    {BATTEN_VIEW_AXONOMETRIC, 0, 0.12, {true, true, true}},
    {BATTEN_VIEW_AXONOMETRIC, 1.5707963267948966, 0, {true, false, true}},
    {BATTEN_VIEW_AXONOMETRIC, 0.3, 1.5, {true, true, false}},
};

/* The arms begin 4 em from the left and 3 em above the bottom of the frame; names stand at 3.2 em. */
TEST(each_axis_that_is_not_seen_end_on_has_its_name_at_its_arm)
{
    for (int i = 0; i < COUNT(views); i++) {
        const bat_view view =
            bat_view_make(views[i].kind, views[i].azimuth, views[i].elevation);
        const scene_words words = words_of(&view, views[i].kind);
        int named = 0;
        for (int k = 0; k < 3; k++) {
            const scene_word *w = scene_find(&words, (const char *[]){"x", "y", "z"}[k]);
            CHECK_INT(w != NULL, views[i].named[k]);
            if (!w)
                continue;
            named++;
            CHECK_NEAR((w->left + w->right) / 2, 60 + 4 * EM + 3.2 * EM * view.right[k], 1.5);
            CHECK_NEAR((w->top + w->bottom) / 2, 240 - 3 * EM - 3.2 * EM * view.up[k], 4);
        }
        CHECK_INT(words.count, named);
    }
}

static const struct {
    batten_view kind;
    const char *names[2];
} flats[] = {{BATTEN_VIEW_TOP, {"x", "y"}},
             {BATTEN_VIEW_FRONT, {"y", "z"}},
             {BATTEN_VIEW_SIDE, {"x", "z"}}};

TEST(flat_views_have_a_grid_with_the_names_of_their_axes_and_the_unit)
{
    for (int i = 0; i < COUNT(flats); i++) {
        const bat_view view = bat_view_make(flats[i].kind, 0, 0);
        const scene_words words = words_of(&view, flats[i].kind);
        for (int k = 0; k < 3; k++) {
            const char *name = (const char *[]){"x", "y", "z"}[k];
            const bool wanted =
                strcmp(name, flats[i].names[0]) == 0 || strcmp(name, flats[i].names[1]) == 0;
            CHECK_INT(scene_find(&words, name) != NULL, wanted);
        }
        CHECK(scene_find(&words, "(mm)"));
        CHECK(scene_find(&words, "3") && scene_find(&words, "2"));
    }
}
