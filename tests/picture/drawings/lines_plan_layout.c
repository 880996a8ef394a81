/* The sheet of a lines plan is used: the largest usual scale, nothing on top of anything, and the table of offsets. */
#include "picture/drawings/lines_plan.h"
#include "picture/scenes.h"

/* A hull of this length, half-breadth and depth on a sheet of A2, laid out. */
static bat_lines_sheet laid_out(const batten_model *model, const batten_draw_options *options,
                                const double size[3])
{
    bat_lines_sheet s = {.model = model, .options = options};
    memcpy(s.hull.high, size, sizeof s.hull.high);
    const bat_canvas canvas = {.width = 1684, .height = 1191, .em = 0.0102 * 1191};
    CHECK_OK(bat_lines_lay_out(&s, &canvas));
    return s;
}

static bool are_apart(bat_rectangle a, bat_rectangle b)
{
    return a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y ||
           b.y + b.height <= a.y;
}

/* The views with their numbers: 3 letters at the sides and below. */
static bat_rectangle with_numbers(bat_rectangle frame, double em)
{
    return (bat_rectangle){frame.x - 4 * em, frame.y - em, frame.width + 8 * em,
                           frame.height + 3 * em};
}

/* The scales were found by drawing rectangles on paper of 594 x 420 mm: of a boat of 4.8 m, 1:10 takes 480 mm of the
 * width and 1:7.5 would take 640. */
static const struct {
    double size[3], ratio;
} hulls[] = {{{4.8, 1.05, 0.94}, 10}, {{10, 1, 1}, 20},   {{25, 3, 3}, 50},
             {{12, 6, 1}, 30},        {{100, 1, 2}, 200}, {{5.3, 1, 0.9}, 10}};

TEST(the_scale_is_the_largest_usual_one_that_fits_and_nothing_overlaps)
{
    batten_model *model = scene_empty();
    batten_draw_options options = batten_draw_defaults();
    for (int i = 0; i < COUNT(hulls); i++) {
        const bat_lines_sheet s = laid_out(model, &options, hulls[i].size);
        const double em = 0.0102 * 1191;
        CHECK_NEAR(s.ratio, hulls[i].ratio, 1e-9 * hulls[i].ratio);
        for (int k = 0; k < VIEWS; k++) {
            const bat_rectangle view = with_numbers(s.plots[k].frame, em);
            CHECK(view.x >= 2 * em && view.y >= 2 * em &&
                  view.x + view.width <= 1684 - 2 * em &&
                  view.y + view.height <= 1191 - 2 * em);
            CHECK(are_apart(view, s.strip));
            CHECK(s.table.width <= 0 || s.table.height <= 0 || are_apart(view, s.table));
            for (int j = 0; j < k; j++)
                CHECK(are_apart(view, with_numbers(s.plots[j].frame, em)));
        }
    }
    batten_model_unref(model);
}

/* So deep that the body plan stands beside the profile. */
static const double deep[][3] = {{4, 1, 2}, {4, 2, 2}, {2, 1, 1}, {3, 1, 4}, {1, 1, 1}};

TEST(what_is_left_of_the_width_is_shared_evenly)
{
    batten_model *model = scene_empty();
    batten_draw_options options = batten_draw_defaults();
    for (int i = 0; i < COUNT(deep); i++) {
        const bat_lines_sheet s = laid_out(model, &options, deep[i]);
        const bat_rectangle profile = s.plots[PROFILE].frame, body = s.plots[BODY].frame;
        CHECK(body.x > profile.x + profile.width);
        CHECK_NEAR(profile.x, 1684 - (body.x + body.width), 1e-9 * 1684);
        CHECK_NEAR(s.plots[BREADTH].frame.x, profile.x, 0);
        CHECK_NEAR(body.y, profile.y, 0);
    }
    batten_model_unref(model);
}
