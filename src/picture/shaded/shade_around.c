/* What stands around a shaded picture: its title and its legend, and the room they take. */
#include "picture/shaded/shade.h"

#include <stdio.h>

/* ---- room ---- */

static double above(const bat_shaded *p)
{
    return *p->options->title ? 4 * p->em : 2 * p->em;
}

/* What title and legend take of the height. */
double bat_shaded_around(const bat_shaded *p)
{
    return above(p) + (bat_has_stripes(p->options->shading) ? 3.5 * p->em : 2 * p->em);
}

/* The part of the picture that title and legend leave to the shape. */
bat_rectangle bat_shaded_stage(const bat_shaded *p)
{
    const batten_draw_options *o = p->options;
    const double em = p->em;
    const double right =
        bat_curvature_of_shading(o->shading) != BAT_CURVATURE_NONE ? 9 * em : 2 * em;
    return (bat_rectangle){2 * em, above(p), bat_max(o->width - 2 * em - right, 8),
                           bat_max(o->height - bat_shaded_around(p), 8)};
}

/* ---- title and legend ---- */

static void write_colours(bat_canvas *canvas, const bat_shaded *p)
{
    enum { STEPS = 128 };
    const double em = p->em, height = 0.5 * canvas->height, wide = 1.2 * em;
    const double x = canvas->width - 7.5 * em, y = 0.5 * (canvas->height - height);
    for (int i = 0; i < STEPS; i++)
        bat_canvas_box(canvas, bat_colour_diverging(1 - 2 * (i + 0.5) / STEPS),
                       (bat_rectangle){x, y + height * i / STEPS, wide, height / STEPS + 1});
    bat_canvas_frame(canvas, (bat_pen){bat_grey, 0.8, BAT_SOLID},
                     (bat_rectangle){x, y, wide, height});
    for (int i = -2; i <= 2; i++) {
        char text[BATTEN_NUMBER_SIZE];
        bat_digits_text(0.5 * i * p->scene.range, 3, text);
        bat_canvas_text(canvas, bat_ink, 0.85 * em, BAT_LEFT, x + wide + 0.5 * em,
                        y + 0.25 * (2 - i) * height, text);
    }
    const char *unit = batten_unit_name(batten_model_unit_metres(p->model));
    char text[64], number[BATTEN_NUMBER_SIZE];
    const bool mean = p->options->shading == BATTEN_SHADING_MEAN;
    snprintf(text, sizeof text, mean ? "H in 1/%s" : "K in 1/%s\u00b2", unit ? unit : "unit");
    bat_canvas_bold(canvas, bat_ink, 0.85 * em, BAT_LEFT, x, y - 3.2 * em, text);
    bat_digits_text(p->greatest, 3, number);
    snprintf(text, sizeof text, "max %s", number);
    bat_canvas_text(canvas, bat_grey, 0.8 * em, BAT_LEFT, x, y - 1.6 * em, text);
    bat_digits_text(p->least, 3, number);
    snprintf(text, sizeof text, "min %s", number);
    bat_canvas_text(canvas, bat_grey, 0.8 * em, BAT_LEFT, x, y + height + 1.6 * em, text);
}

void bat_shaded_write_around(bat_canvas *canvas, const bat_shaded *p)
{
    const double em = p->em, middle = 0.5 * canvas->width;
    bat_canvas_bold(canvas, bat_ink, 1.25 * em, BAT_MIDDLE, middle, 2 * em, p->options->title);
    if (bat_curvature_of_shading(p->options->shading) != BAT_CURVATURE_NONE &&
        p->least <= p->greatest)
        write_colours(canvas, p);
    if (bat_has_stripes(p->options->shading)) {
        char text[BATTEN_NUMBER_SIZE + 80], number[BATTEN_NUMBER_SIZE];
        bat_digits_text(p->options->stripes, 4, number);
        const bool zebra = p->options->shading == BATTEN_SHADING_ZEBRA;
        snprintf(text, sizeof text, "%s: %s stripes over the half turn",
                 zebra ? "zebra" : "isophotes", number);
        bat_canvas_text(canvas, bat_grey, 0.85 * em, BAT_MIDDLE, middle,
                        canvas->height - 1.5 * em, text);
    }
}
