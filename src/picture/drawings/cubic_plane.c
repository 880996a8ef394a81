/* The map of all cubic spans with the same ends and end tangents, and marks for given ones. */
#include "picture/drawings/cubic_names.h"
#include "picture/sheet/sheet.h"
#include "picture/sheet/size.h"
#include <batten/invariants.h>

#include <stdio.h>

/* ---- the drawing ---- */

static void add_corner(bat_cubic_polygon *p, double x, double y)
{
    if (p->count == BAT_CUBIC_CORNERS)
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

static void add_curve(bat_cubic_polygon *p, double (*f)(double), double from, double to)
{
    for (int i = 0; i <= BAT_CUBIC_STEPS; i++) {
        const double x = from + (to - from) * i / BAT_CUBIC_STEPS;
        add_corner(p, x, f(x));
    }
}

/* The same along the second axis: (f(y), y). */
static void add_curve_up(bat_cubic_polygon *p, double (*f)(double), double from, double to)
{
    for (int i = 0; i <= BAT_CUBIC_STEPS; i++) {
        const double y = from + (to - from) * i / BAT_CUBIC_STEPS;
        add_corner(p, f(y), y);
    }
}

/* Where the parabola has the height y, at the larger x. */
static double parabola_at(double y)
{
    return 0.5 + sqrt(bat_max(0.25 - y / 3, 0));
}

static void mirror(bat_cubic_polygon *p)
{
    for (int i = 0; i < p->count; i++) {
        const double x = p->xy[2 * i];
        p->xy[2 * i] = p->xy[2 * i + 1];
        p->xy[2 * i + 1] = x;
    }
}

static const bat_cubic_polygon *placed(const bat_cubic_drawing *d)
{
    const bat_cubic_polygon *p = &d->shape[0];
    bat_cubic_polygon *to = &d->shape[1];
    to->count = p->count;
    for (int i = 0; i < p->count; i++) {
        to->xy[2 * i] = bat_plot_x(&d->plot, p->xy[2 * i]);
        to->xy[2 * i + 1] = bat_plot_y(&d->plot, p->xy[2 * i + 1]);
    }
    return to;
}

static void fill(const bat_cubic_drawing *d, bat_colour colour)
{
    const bat_cubic_polygon *p = placed(d);
    bat_canvas_fill(d->canvas, colour, 1, (size_t)p->count, p->xy);
}

static void fill_both(const bat_cubic_drawing *d, bat_colour colour)
{
    fill(d, colour);
    mirror(&d->shape[0]);
    fill(d, colour);
}

static void stroke(const bat_cubic_drawing *d, bat_pen pen)
{
    const bat_cubic_polygon *p = placed(d);
    bat_canvas_line(d->canvas, pen, (size_t)p->count, p->xy);
}

static void stroke_both(const bat_cubic_drawing *d, bat_pen pen)
{
    stroke(d, pen);
    mirror(&d->shape[0]);
    stroke(d, pen);
}

/* ---- regions ---- */

static const bat_colour regular = {0.78, 0.91, 0.78}, plain = {0.93, 0.95, 0.93},
                        one = {1.0, 0.95, 0.78}, two = {0.99, 0.84, 0.72},
                        loop = {0.83, 0.86, 0.97};

static void rectangle(bat_cubic_polygon *p, double x0, double y0, double x1, double y1)
{
    p->count = 0;
    add_corner(p, x0, y0);
    add_corner(p, x1, y0);
    add_corner(p, x1, y1);
    add_corner(p, x0, y1);
}

/* Beyond (1, 1): loops, and below the hyperbola two inflections. */
static void fill_first_quadrant(const bat_cubic_drawing *d)
{
    const double far = bat_max(d->high, 3), beyond = hyperbola(far);
    bat_cubic_polygon *p = &d->shape[0];
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
static void fill_other_quadrants(const bat_cubic_drawing *d)
{
    const double far = bat_max(d->high, 3), deep = bat_min(d->low, -1);
    bat_cubic_polygon *p = &d->shape[0];
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

static bat_pen hyperbola_pen(void)
{
    return (bat_pen){bat_cusp_red, 2, BAT_SOLID};
}

static bat_pen parabola_pen(void)
{
    return (bat_pen){return_blue, 1.6, BAT_SOLID};
}

static void draw_lines(const bat_cubic_drawing *d)
{
    const bat_pen axis = {bat_ink, 1, BAT_SOLID}, flat = {bat_ink, 1.3, BAT_SOLID};
    const bat_pen asymptote = {bat_cusp_red, 0.7, BAT_DOTTED};
    const double at[3] = {0, 1, 4.0 / 3};
    const bat_pen pens[3] = {axis, flat, asymptote};
    bat_cubic_polygon *p = &d->shape[0];
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

static void draw_boundaries(const bat_cubic_drawing *d)
{
    const double far = bat_max(d->high, 3), deep = bat_min(d->low, -1);
    const bat_pen faint = {return_blue, 0.8, BAT_DOTTED};
    bat_cubic_polygon *p = &d->shape[0];
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
    stroke(d, (bat_pen){bat_cusp_red, 1, BAT_DASHED});
}

/* ---- marks ---- */

static const bat_colour palette[] = {{0.80, 0.00, 0.45}, {0.00, 0.45, 0.70},
                                     {0.10, 0.10, 0.10}, {0.45, 0.25, 0.05},
                                     {0.35, 0.10, 0.60}, {0.00, 0.40, 0.20}};
enum { COLOURS = sizeof palette / sizeof *palette, MOST_NUMBERS = 60 };

typedef struct {
    int total, outside, without;
} tally;

static void draw_mark(const bat_cubic_drawing *d, bat_colour colour, const batten_cubic *c,
                      int number)
{
    const double x = bat_plot_x(&d->plot, c->lambda), y = bat_plot_y(&d->plot, c->mu);
    const double em = d->canvas->em;
    char text[16];
    bat_canvas_disc(d->canvas, (bat_colour){1, 1, 1}, x, y, 0.36 * em);
    bat_canvas_disc(d->canvas, colour, x, y, 0.27 * em);
    snprintf(text, sizeof text, "%d", number);
    if (number <= MOST_NUMBERS)
        bat_canvas_name(d->canvas, (bat_lettering){colour, 0.75 * em, true}, 1,
                        (const double[2]){x, y}, text);
}

static batten_status draw_marks(const bat_cubic_drawing *d, const batten_object *object,
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
static batten_status draw_curves(const bat_cubic_drawing *d, const batten_model *model,
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

static void draw_plane(const bat_cubic_drawing *d)
{
    bat_plot_grid(d->canvas, &d->plot, "\u03bb = |P0 P1| / |P0 T|",
                  "\u03bc = |P2 P3| / |T P3|");
    bat_canvas_clip(d->canvas, d->plot.frame);
    fill_other_quadrants(d);
    fill_first_quadrant(d);
    draw_lines(d);
    draw_boundaries(d);
    bat_cubic_plane_names(d);
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

static batten_status draw_sheet(bat_cubic_drawing *d, const batten_model *model,
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
    bat_size_take_share(&picture, 1);
    bat_canvas canvas;
    bat_cubic_drawing d = {.plane = &chosen, .canvas = &canvas};
    const double em = bat_size_em(options);
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
