/* Names and small curves in the regions of the map of cubic spans. */
#include "picture/drawings/cubic_names.h"
#include "picture/sheet/sheet.h"

/* ---- names and small curves ---- */

/* A small cubic of these lengths, its ends and T, centred on a place of the plane; `wide` in
 * units of the plane. */
static void draw_glyph(const bat_cubic_drawing *d, double x, double y, double wide,
                       double lambda, double mu)
{
    static const double start[2] = {-0.5, -0.35}, top[2] = {0, 0.45}, end[2] = {0.5, -0.35};
    double p[4][2], xy[2 * 65];
    const double scale = wide * d->plot.scale;
    const double cx = bat_plot_x(&d->plot, x), cy = bat_plot_y(&d->plot, y);
    for (int k = 0; k < 2; k++) {
        p[0][k] = start[k];
        p[1][k] = start[k] + lambda * (top[k] - start[k]);
        p[2][k] = end[k] + mu * (top[k] - end[k]);
        p[3][k] = end[k];
    }
    for (int i = 0; i <= 64; i++) {
        const double t = i / 64.0, s = 1 - t;
        const double b[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
        double at[2] = {0, 0};
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 2; k++)
                at[k] += b[j] * p[j][k];
        xy[2 * i] = cx + scale * at[0];
        xy[2 * i + 1] = cy - scale * at[1];
    }
    for (int i = 0; i < 4; i += 3) {
        const double *end_of = p[i], *handle = p[i == 0 ? 1 : 2];
        bat_canvas_segment(d->canvas, (bat_pen){bat_grey, 0.7, BAT_SOLID},
                           cx + scale * end_of[0], cy - scale * end_of[1],
                           cx + scale * handle[0], cy - scale * handle[1]);
        bat_canvas_disc(d->canvas, bat_grey, cx + scale * handle[0], cy - scale * handle[1],
                        1.5);
    }
    bat_canvas_line(d->canvas, (bat_pen){bat_ink, 1.6, BAT_SOLID}, 65, xy);
    bat_canvas_disc(d->canvas, bat_ink, cx + scale * start[0], cy - scale * start[1], 2.4);
    bat_canvas_disc(d->canvas, bat_ink, cx + scale * end[0], cy - scale * end[1], 2.4);
}

static const struct {
    double x, y, wide;
    double lambda, mu;
} glyphs[] = {
    {0.5, 0.52, 0.55, 0.8, 0.8},    {2.5, 0.5, 0.45, 1.9, 0.35},  {0.5, 2.5, 0.45, 0.35, 1.9},
    {2.85, 2.7, 0.4, 2.5, 2.5},     {0.5, -1, 0.42, 0.75, -0.75}, {-1, 0.53, 0.42, -0.75, 0.75},
    {2.55, -1, 0.32, 2.0, -1.0},    {-1, 2.55, 0.32, -1.0, 2.0},  {-1, -1.05, 0.42, -0.6, -0.6},
    {1.13, 1.13, 0.18, 1.25, 1.25},
};

typedef struct {
    double x, y;
    double size; /* in em */
    bool up;
    const char *text;
} name;

static const name names[] = {
    {0.5, 0.14, 1.0, false, "R: regular"},
    {2.5, 0.14, 0.9, false, "one inflection"},
    {0.5, 2.14, 0.9, false, "one inflection"},
    {2.85, 2.3, 0.9, false, "loop"},
    {2.65, 1.16, 0.8, false, "two inflections (excess)"},
    {1.16, 2.65, 0.8, true, "two inflections (excess)"},
    {0.5, -1.5, 0.9, false, "S-shaped:"},
    {0.5, -1.65, 0.9, false, "one inflection"},
    {-1, 0.08, 0.9, false, "S-shaped: one inflection"},
    {2.55, -1.48, 0.9, false, "plain, but turning"},
    {2.55, -1.63, 0.9, false, "by more than half a circle"},
    {-1, 2.06, 0.9, false, "plain, but turning"},
    {-1, 1.91, 0.9, false, "by more than half a circle"},
    {-1, -1.48, 0.9, false, "plain, bulging to"},
    {-1, -1.63, 0.9, false, "the far side of T"},
    {1.075, -1.5, 0.7, true, "two inflections"},
    {-1.5, 1.075, 0.7, false, "two inflections"},
    {1.29, -1.65, 0.8, true, "loop"},
    {-1.65, 1.29, 0.8, false, "loop"},
};

void bat_cubic_plane_names(const bat_cubic_drawing *d)
{
    /* The places are made for the usual piece of the plane; in others letters keep their
     * relation to it. */
    const double em = bat_min(d->canvas->em, 0.105 * d->plot.scale);
    for (size_t i = 0; d->plane->glyphs && i < sizeof glyphs / sizeof *glyphs; i++)
        draw_glyph(d, glyphs[i].x, glyphs[i].y, glyphs[i].wide, glyphs[i].lambda, glyphs[i].mu);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const double x = bat_plot_x(&d->plot, names[i].x), y = bat_plot_y(&d->plot, names[i].y);
        if (names[i].up)
            bat_canvas_text_up(d->canvas, bat_ink, em * names[i].size, x, y, names[i].text);
        else
            bat_canvas_text(d->canvas, bat_ink, em * names[i].size, BAT_MIDDLE, x, y,
                            names[i].text);
    }
    bat_canvas_disc(d->canvas, bat_cusp_red, bat_plot_x(&d->plot, 2), bat_plot_y(&d->plot, 2),
                    3);
    bat_canvas_text(d->canvas, bat_cusp_red, 0.9 * em, BAT_LEFT,
                    bat_plot_x(&d->plot, 2) + 0.5 * em, bat_plot_y(&d->plot, 2) - 0.8 * em,
                    "H = 0: cusp");
}
