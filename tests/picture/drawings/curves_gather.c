/* Combs have as many teeth as their outline needs. */
#include "picture/drawings/drawing.h"
#include "picture/scenes.h"

/* Cubics of one span, from a plain bow to one with a sharp bend, and a bow after a long even piece. */
static const double bows[][8] = {{0, 0, 1, 2, 3, 2, 4, 0},
                                 {0, 0, 5, 3, -1, 3, 4, 0},
                                 {0, 0, 4.2, 3, -0.2, 3, 4, 0},
                                 {0, 0, 3.9, 0.1, 4, 0.2, 4, 3}};

/* The largest turn of the outline of a comb between neighbouring tips, radians, where the longest tooth is a tenth of
 * the size 4 and pieces shorter than a pixel of 1,200 are skipped. */
static double largest_turn(const bat_shape *s)
{
    const double stretch = 0.4 / s->sharpest, pixel = 4.0 / 1200;
    double last[3], way[2] = {0, 0}, turn = 0;
    bat_drawing_comb_tip(&s->teeth[0], stretch, last);
    for (int i = 1; i < s->tooth_count; i++) {
        double tip[3];
        bat_drawing_comb_tip(&s->teeth[i], stretch, tip);
        const double x = tip[0] - last[0], y = tip[1] - last[1];
        if (hypot(x, y) < 4 * pixel)
            continue;
        if (way[0] != 0 || way[1] != 0)
            turn = fmax(turn, fabs(atan2(way[0] * y - way[1] * x, way[0] * x + way[1] * y)) *
                                  fmin(hypot(x, y), hypot(way[0], way[1])) / 4);
        way[0] = x, way[1] = y;
        memcpy(last, tip, sizeof last);
    }
    return turn / pixel;
}

/* What a failure has prepared is given back, so that it may be tried again. */
static batten_status prepare(const batten_model *model, const batten_draw_options *options,
                             bat_drawing *out)
{
    *out = (bat_drawing){.model = model, .options = options};
    const batten_status status = bat_drawing_prepare(out);
    if (status != BATTEN_OK)
        bat_drawing_free(out);
    return status;
}

TEST(the_outline_of_a_comb_leaves_its_curve_by_no_pixel)
{
    batten_draw_options options = batten_draw_defaults();
    options.comb = true;
    for (int i = 0; i < test_cases(COUNT(bows)); i++) {
        batten_model *model = scene_empty();
        scene_add_curve(model, "bow", scene_curve(2, 3, 4, bows[i]));
        bat_drawing drawing;
        CHECK_OK(prepare(model, &options, &drawing));
        CHECK(drawing.shapes[0].tooth_count > 160);
        CHECK(largest_turn(&drawing.shapes[0]) < 1);
        bat_drawing_free(&drawing);
        batten_model_unref(model);
    }
}

/* A sharper bend needs more teeth, a plain bow no more than at first. */
TEST(a_sharper_bend_has_more_teeth)
{
    batten_draw_options options = batten_draw_defaults();
    options.comb = true;
    int counts[2] = {0, 0};
    for (int i = 0; i < 2; i++) {
        batten_model *model = scene_empty();
        scene_add_curve(model, "bow", scene_curve(2, 3, 4, bows[2 * i]));
        bat_drawing drawing;
        CHECK_OK(prepare(model, &options, &drawing));
        counts[i] = drawing.shapes[0].tooth_count;
        bat_drawing_free(&drawing);
        batten_model_unref(model);
    }
    CHECK_INT(counts[0], 161);
    CHECK(counts[1] > 2 * counts[0]);
}
