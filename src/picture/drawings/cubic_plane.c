/* The map of all cubic spans with the same ends and end tangents, and marks for given ones. */
#include "picture/sheet/sheet.h"
#include <batten/invariants.h>

#include <stdio.h>

/* ---- the drawing ---- */

enum { STEPS = 160, MOST_CORNERS = 2 * STEPS + 8 };

/* A polygon of the plane, as it grows. */
typedef struct {
    int count;
    double xy[2 * MOST_CORNERS];
} polygon;

typedef struct {
    const batten_draw_cubic_plane_options *plane;
    bat_canvas *canvas;
    bat_plot plot;
    double low, high;
    polygon *shape; /* [2]: one in the plane, and one as it is on the sheet */
} drawing;

static void add_corner(polygon *p, double x, double y)
{
    if (p->count == MOST_CORNERS)
        return;
    p->xy[2 * p->count] = x;
    p->xy[2 * p->count + 1] = y;
    p->count++;
}

/* mu on the hyperbola at lambda, and the other way round: it is symmetric. */
static double hyperbola(double x)
{
    return (4 * x - 4) / (3 * x - 4);
}

static double parabola(double x)
{
    return 3 * x * (1 - x);
}

static void add_curve(polygon *p, double (*f)(double), double from, double to)
{
    for (int i = 0; i <= STEPS; i++) {
        const double x = from + (to - from) * i / STEPS;
        add_corner(p, x, f(x));
    }
}

/* The same along the second axis: (f(y), y). */
static void add_curve_up(polygon *p, double (*f)(double), double from, double to)
{
    for (int i = 0; i <= STEPS; i++) {
        const double y = from + (to - from) * i / STEPS;
        add_corner(p, f(y), y);
    }
}

/* Where the parabola has the height y, at the larger x. */
static double parabola_at(double y)
{
    return 0.5 + sqrt(bat_max(0.25 - y / 3, 0));
}

static void mirror(polygon *p)
{
    for (int i = 0; i < p->count; i++) {
        const double x = p->xy[2 * i];
        p->xy[2 * i] = p->xy[2 * i + 1];
        p->xy[2 * i + 1] = x;
    }
}

static const polygon *placed(const drawing *d)
{
    const polygon *p = &d->shape[0];
    polygon *to = &d->shape[1];
    to->count = p->count;
    for (int i = 0; i < p->count; i++) {
        to->xy[2 * i] = bat_plot_x(&d->plot, p->xy[2 * i]);
        to->xy[2 * i + 1] = bat_plot_y(&d->plot, p->xy[2 * i + 1]);
    }
    return to;
}

static void fill(const drawing *d, bat_colour colour)
{
    const polygon *p = placed(d);
    bat_canvas_fill(d->canvas, colour, 1, (size_t)p->count, p->xy);
}

static void fill_both(const drawing *d, bat_colour colour)
{
    fill(d, colour);
    mirror(&d->shape[0]);
    fill(d, colour);
}

static void stroke(const drawing *d, bat_pen pen)
{
    const polygon *p = placed(d);
    bat_canvas_line(d->canvas, pen, (size_t)p->count, p->xy);
}

static void stroke_both(const drawing *d, bat_pen pen)
{
    stroke(d, pen);
    mirror(&d->shape[0]);
    stroke(d, pen);
}

/* ---- regions ---- */

static const bat_colour regular = {0.78, 0.91, 0.78}, plain = {0.93, 0.95, 0.93},
                        one = {1.0, 0.95, 0.78}, two = {0.99, 0.84, 0.72},
                        loop = {0.83, 0.86, 0.97};

static void rectangle(polygon *p, double x0, double y0, double x1, double y1)
{
    p->count = 0;
    add_corner(p, x0, y0);
    add_corner(p, x1, y0);
    add_corner(p, x1, y1);
    add_corner(p, x0, y1);
}

/* Beyond (1, 1): loops, and below the hyperbola two inflections. */
static void fill_first_quadrant(const drawing *d)
{
    const double far = bat_max(d->high, 3), beyond = hyperbola(far);
    polygon *p = &d->shape[0];
    rectangle(p, 0, 0, 1, 1);
    fill(d, regular);
    rectangle(p, 1, 0, far, 1);
    fill_both(d, one);
    rectangle(p, 1, 1, far, far);
    fill(d, two);
    p->count = 0;
    add_curve(p, hyperbola, beyond, 2);
    add_curve(p, hyperbola, 2, far);
    add_corner(p, far, far);
    fill(d, loop);
}

/* One length negative: below the first axis, then mirrored. */
static void fill_other_quadrants(const drawing *d)
{
    const double far = bat_max(d->high, 3), deep = bat_min(d->low, -1);
    polygon *p = &d->shape[0];
    rectangle(p, deep, deep, 0, 0);
    fill(d, plain);
    rectangle(p, 0, deep, 1, 0);
    fill_both(d, one);
    rectangle(p, 1, deep, far, 0);
    fill_both(d, plain);
    p->count = 0; /* loops: from the hyperbola to the parabola */
    add_curve_up(p, hyperbola, 0, deep);
    add_curve(p, parabola, parabola_at(deep), 1);
    fill_both(d, loop);
    p->count = 0; /* two inflections: from lambda = 1 to the hyperbola */
    add_curve_up(p, hyperbola, 0, deep);
    add_corner(p, 1, deep);
    fill_both(d, two);
}

/* ---- boundaries ---- */

static const bat_colour cusp_red = {0.75, 0.1, 0.1}, return_blue = {0.1, 0.25, 0.7};

static bat_pen hyperbola_pen(void)
{
    return (bat_pen){cusp_red, 2, BAT_SOLID};
}

static bat_pen parabola_pen(void)
{
    return (bat_pen){return_blue, 1.6, BAT_SOLID};
}

static void draw_lines(const drawing *d)
{
    const bat_pen axis = {bat_ink, 1, BAT_SOLID}, flat = {bat_ink, 1.3, BAT_SOLID};
    const bat_pen asymptote = {cusp_red, 0.7, BAT_DOTTED};
    const double at[3] = {0, 1, 4.0 / 3};
    const bat_pen pens[3] = {axis, flat, asymptote};
    polygon *p = &d->shape[0];
    for (int i = 0; i < 3; i++) {
        p->count = 0;
        add_corner(p, at[i], d->low);
        add_corner(p, at[i], d->high);
        stroke_both(d, pens[i]);
    }
    /* R is the rectangle that is safe. */
    rectangle(p, 0, 0, 1, 1);
    add_corner(p, 0, 0);
    stroke(d, (bat_pen){{0.1, 0.45, 0.15}, 2.6, BAT_SOLID});
}

static void draw_boundaries(const drawing *d)
{
    const double far = bat_max(d->high, 3), deep = bat_min(d->low, -1);
    const bat_pen faint = {return_blue, 0.8, BAT_DOTTED};
    polygon *p = &d->shape[0];
    p->count = 0;
    add_curve(p, parabola, 0, 1);
    stroke_both(d, faint);
    p->count = 0; /* where loops end */
    add_curve(p, parabola, 1, parabola_at(deep));
    stroke_both(d, parabola_pen());
    p->count = 0; /* beyond (1, 1) */
    add_curve(p, hyperbola, hyperbola(far), 2);
    add_curve(p, hyperbola, 2, far);
    stroke(d, hyperbola_pen());
    p->count = 0;
    add_curve_up(p, hyperbola, 0, deep);
    stroke_both(d, hyperbola_pen());
    p->count = 0; /* inside R it separates nothing */
    add_curve(p, hyperbola, 0, 1);
    stroke(d, (bat_pen){cusp_red, 1, BAT_DASHED});
}

/* ---- names and small curves ---- */

/* A small cubic of these lengths, its ends and T, centred on a place of the plane; `wide` in
 * units of the plane. */
static void draw_glyph(const drawing *d, double x, double y, double wide, double lambda,
                       double mu)
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

static void draw_names(const drawing *d)
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
    bat_canvas_disc(d->canvas, cusp_red, bat_plot_x(&d->plot, 2), bat_plot_y(&d->plot, 2), 3);
    bat_canvas_text(d->canvas, cusp_red, 0.9 * em, BAT_LEFT, bat_plot_x(&d->plot, 2) + 0.5 * em,
                    bat_plot_y(&d->plot, 2) - 0.8 * em, "H = 0: cusp");
}

/* ---- marks ---- */

static const bat_colour palette[] = {{0.80, 0.00, 0.45}, {0.00, 0.45, 0.70},
                                     {0.10, 0.10, 0.10}, {0.45, 0.25, 0.05},
                                     {0.35, 0.10, 0.60}, {0.00, 0.40, 0.20}};
enum { COLOURS = sizeof palette / sizeof *palette, MOST_NUMBERS = 60 };

typedef struct {
    int total, outside, without;
} tally;

static void draw_mark(const drawing *d, bat_colour colour, const batten_cubic *c, int number)
{
    const double x = bat_plot_x(&d->plot, c->lambda), y = bat_plot_y(&d->plot, c->mu);
    const double em = d->canvas->em;
    char text[16];
    bat_canvas_disc(d->canvas, (bat_colour){1, 1, 1}, x, y, 0.36 * em);
    bat_canvas_disc(d->canvas, colour, x, y, 0.27 * em);
    snprintf(text, sizeof text, "%d", number);
    if (number <= MOST_NUMBERS)
        bat_canvas_label(d->canvas, colour, 0.75 * em, BAT_LEFT, x + 0.5 * em, y - 0.45 * em,
                         text);
}

static batten_status draw_marks(const drawing *d, const batten_object *object,
                                bat_colour colour, tally *t)
{
    batten_cubics cubics = {0, NULL};
    const batten_status status =
        batten_curve_classify(object->curve, d->plane->tolerance, &cubics);
    for (int i = 0; status == BATTEN_OK && i < cubics.count; i++) {
        const batten_cubic *c = &cubics.at[i];
        t->total++;
        if (!c->has_tangents)
            t->without++;
        else if (c->lambda < d->low || c->lambda > d->high || c->mu < d->low || c->mu > d->high)
            t->outside++;
        else
            draw_mark(d, colour, c, i + 1);
    }
    batten_cubics_release(&cubics);
    return status;
}

/* All curves; their names and what could not be shown go into the legend. */
static batten_status draw_curves(const drawing *d, const batten_model *model,
                                 bat_legend *legend)
{
    tally t = {0, 0, 0};
    int curves = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; model && i < batten_model_count(model) && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(model, i);
        const bat_colour colour = palette[curves % COLOURS];
        if (object->kind != BATTEN_OBJECT_CURVE)
            continue;
        if (curves++ < 4)
            bat_legend_add(legend, BAT_SAMPLE_DISC, (bat_pen){colour, 1, BAT_SOLID},
                           "spans of %.48s", object->name);
        status = draw_marks(d, object, colour, &t);
    }
    if (t.outside > 0)
        bat_legend_add(legend, BAT_SAMPLE_CROSS, (bat_pen){bat_grey, 1, BAT_SOLID},
                       "%d of %d spans lie outside the picture", t.outside, t.total);
    if (t.without > 0)
        bat_legend_add(legend, BAT_SAMPLE_CROSS, (bat_pen){bat_grey, 1, BAT_SOLID},
                       "%d of %d spans have no place: straight, twisted, parallel tangents",
                       t.without, t.total);
    return status;
}

static void fill_legend(bat_legend *legend)
{
    bat_legend_add(legend, BAT_SAMPLE_LINE, hyperbola_pen(),
                   "H = 3\u03bb\u03bc - 4\u03bb - 4\u03bc + 4 = 0: cusps");
    bat_legend_add(
        legend, BAT_SAMPLE_LINE, parabola_pen(),
        "\u03bc = 3\u03bb(1 - \u03bb), \u03bb = 3\u03bc(1 - \u03bc): loop to an end");
    bat_legend_add(legend, BAT_SAMPLE_LINE, (bat_pen){bat_ink, 1.3, BAT_SOLID},
                   "\u03bb = 1, \u03bc = 1: an end of curvature 0");
}

/* ---- the whole ---- */

batten_draw_cubic_plane_options batten_draw_cubic_plane_defaults(void)
{
    return (batten_draw_cubic_plane_options){
        .size = sizeof(batten_draw_cubic_plane_options),
        .low = -2,
        .high = 3.6,
        /* Relative: nearer to a boundary a cubic is drawn on it. */
        .tolerance = 1e-9,
        .glyphs = true};
}

static void draw_plane(const drawing *d)
{
    bat_plot_grid(d->canvas, &d->plot, "\u03bb = |P0 P1| / |P0 T|",
                  "\u03bc = |P2 P3| / |T P3|");
    bat_canvas_clip(d->canvas, d->plot.frame);
    fill_other_quadrants(d);
    fill_first_quadrant(d);
    draw_lines(d);
    draw_boundaries(d);
    draw_names(d);
    bat_canvas_unclip(d->canvas);
    bat_canvas_frame(d->canvas, (bat_pen){bat_grey, 0.8, BAT_SOLID}, d->plot.frame);
}

static batten_status check_plane(const batten_draw_cubic_plane_options *plane)
{
    if (!isfinite(plane->low) || !isfinite(plane->high))
        return bat_fail(BATTEN_NOT_FINITE,
                        "the plane is shown from %g to %g, which is not finite", plane->low,
                        plane->high);
    if (!(plane->low < plane->high))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the plane cannot be shown from %g to %g",
                        plane->low, plane->high);
    return BATTEN_OK;
}

static batten_status draw_sheet(drawing *d, const batten_model *model,
                                const batten_draw_options *options)
{
    bat_legend legend = {0};
    const double em = d->canvas->em, top = *options->title ? 3 * em : em;
    const double width = d->canvas->width - 4 * em;
    const double low[2] = {d->low, d->low}, high[2] = {d->high, d->high};
    /* Three rows of legend, the numbers of the axis and its name. */
    const bat_rectangle frame = {5 * em, top, bat_max(d->canvas->width - 6 * em, em),
                                 bat_max(d->canvas->height - top - 8.5 * em, em)};
    d->plot = bat_plot_fit(frame, low, high);
    bat_canvas_bold(d->canvas, bat_ink, 1.25 * em, BAT_MIDDLE, 0.5 * d->canvas->width, 1.6 * em,
                    options->title);
    draw_plane(d);
    fill_legend(&legend);
    const batten_status status = draw_curves(d, model, &legend);
    const double height = bat_legend_height(d->canvas, &legend, width);
    bat_legend_draw(d->canvas, &legend, 2 * em, d->canvas->height - height - 0.5 * em, width);
    return status;
}

batten_status batten_draw_cubic_plane(const batten_model *model,
                                      const batten_draw_cubic_plane_options *plane,
                                      const batten_draw_options *options, char **data,
                                      size_t *size)
{
    batten_draw_options picture = batten_draw_defaults();
    batten_draw_cubic_plane_options chosen = batten_draw_cubic_plane_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_draw_options, options, &picture);
    if (status == BATTEN_OK)
        status = BAT_TAKE_OPTIONS(batten_draw_cubic_plane_options, plane, &chosen);
    options = &picture;
    if (status != BATTEN_OK)
        return status;
    bat_canvas canvas;
    drawing d = {.plane = &chosen, .canvas = &canvas};
    const double em = bat_max(5, 0.0165 * bat_min_int(options->width, options->height));
    status = check_plane(d.plane);
    d.low = d.plane->low;
    d.high = d.plane->high;
    if (status == BATTEN_OK && !(d.shape = bat_array(2, sizeof *d.shape)))
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_canvas_begin(options->format, options->width, options->height, em,
                                  options->title, &canvas);
    if (status == BATTEN_OK) {
        status = draw_sheet(&d, model, options);
        if (status == BATTEN_OK)
            status = bat_canvas_finish(&canvas, data, size);
        else
            bat_canvas_end(&canvas);
    }
    bat_release(d.shape);
    return status;
}
