/* What drawings are made of: round numbers, plots with their grids, legends. */
#include "picture/sheet/sheet.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const bat_colour bat_ink = {0.13, 0.15, 0.18};
const bat_colour bat_grey = {0.42, 0.45, 0.49};
static const bat_colour pale = {0.86, 0.88, 0.90};

/* ---- plot ---- */

bat_plot bat_plot_fit(bat_rectangle frame, const double low[2], const double high[2])
{
    const double range_x = high[0] - low[0], range_y = high[1] - low[1];
    bat_plot plot = {.frame = frame, .scale = 1};
    /* A single point, or a line along an axis, has no range in one direction or both. */
    const double across = range_x > 0 ? frame.width / range_x : HUGE_VAL;
    const double up = range_y > 0 ? frame.height / range_y : HUGE_VAL;
    const double scale = bat_min(across, up);
    if (isfinite(scale))
        plot.scale = scale;
    plot.x0 = 0.5 * (low[0] + high[0]) - 0.5 * frame.width / plot.scale;
    plot.y0 = 0.5 * (low[1] + high[1]) - 0.5 * frame.height / plot.scale;
    return plot;
}

/* Grid lines stand about this many letters apart, so that their numbers do not meet. */
static double plot_step(const bat_canvas *canvas, const bat_plot *plot)
{
    return bat_round_step(6 * canvas->em / plot->scale, 1);
}

/* The multiples of `step` inside a range: first .. last; none when the numbers have no such
 * digits. */
static void multiples(double from, double range, double step, double *first, double *last)
{
    *first = ceil(from / step - 1e-9);
    *last = floor((from + range) / step + 1e-9);
    /* From there on doubles are a whole number apart: no multiples are left inside a step. */
    if (fabs(*first) > 1e15 || fabs(*last) > 1e15) {
        *first = 0;
        *last = -1;
    }
}

double bat_plot_numbers_width(bat_canvas *canvas, const bat_plot *plot)
{
    const double step = plot_step(canvas, plot);
    double first, last, widest = 0;
    multiples(plot->y0, plot->frame.height / plot->scale, step, &first, &last);
    for (double k = first; k <= last; k++) {
        char text[BATTEN_NUMBER_SIZE];
        bat_number_text(k * step, bat_decimals_of_step(step), text);
        widest = bat_max(widest, bat_canvas_text_width(canvas, 0.85 * canvas->em, text));
    }
    return widest;
}

static void grid_upright(bat_canvas *canvas, const bat_plot *plot, double step)
{
    const bat_rectangle f = plot->frame;
    const double em = canvas->em;
    double first, last;
    multiples(plot->x0, f.width / plot->scale, step, &first, &last);
    for (double k = first; k <= last; k++) {
        const double x = bat_plot_x(plot, k * step);
        char text[BATTEN_NUMBER_SIZE];
        bat_number_text(k * step, bat_decimals_of_step(step), text);
        bat_canvas_segment(canvas, (bat_pen){pale, k == 0 ? 1.2 : 0.6, BAT_SOLID}, x, f.y, x,
                           f.y + f.height);
        bat_canvas_label(canvas, bat_grey, 0.85 * em, BAT_MIDDLE, x, f.y + f.height + 0.8 * em,
                         text);
    }
}

static void grid_level(bat_canvas *canvas, const bat_plot *plot, double step)
{
    const bat_rectangle f = plot->frame;
    const double em = canvas->em;
    double first, last;
    multiples(plot->y0, f.height / plot->scale, step, &first, &last);
    for (double k = first; k <= last; k++) {
        const double y = bat_plot_y(plot, k * step);
        char text[BATTEN_NUMBER_SIZE];
        bat_number_text(k * step, bat_decimals_of_step(step), text);
        bat_canvas_segment(canvas, (bat_pen){pale, k == 0 ? 1.2 : 0.6, BAT_SOLID}, f.x, y,
                           f.x + f.width, y);
        bat_canvas_label(canvas, bat_grey, 0.85 * em, BAT_RIGHT, f.x - 0.4 * em, y, text);
    }
}

void bat_plot_grid(bat_canvas *canvas, const bat_plot *plot, const char *name_x,
                   const char *name_y)
{
    const bat_rectangle f = plot->frame;
    const double em = canvas->em, step = plot_step(canvas, plot);
    canvas->draws_ground = true;
    grid_upright(canvas, plot, step);
    grid_level(canvas, plot, step);
    canvas->draws_ground = false;
    bat_canvas_frame(canvas, (bat_pen){bat_grey, 0.8, BAT_SOLID}, f);
    bat_canvas_text(canvas, bat_grey, 0.85 * em, BAT_MIDDLE, f.x + 0.5 * f.width,
                    f.y + f.height + 2.0 * em, name_x);
    bat_canvas_text_up(canvas, bat_grey, 0.85 * em,
                       f.x - bat_plot_numbers_width(canvas, plot) - 1.2 * em,
                       f.y + 0.5 * f.height, name_y);
}

/* ---- legend ---- */

void bat_legend_add(bat_legend *legend, bat_sample sample, bat_pen pen, const char *format, ...)
{
    if (legend->count == BAT_LEGEND_LIMIT)
        return;
    bat_entry *entry = &legend->entries[legend->count++];
    entry->sample = sample;
    entry->pen = pen;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(entry->text, sizeof entry->text, format, arguments);
    va_end(arguments);
}

static void draw_sample(bat_canvas *canvas, const bat_entry *entry, double x, double y)
{
    const double em = canvas->em;
    if (entry->sample == BAT_SAMPLE_LINE || entry->sample == BAT_SAMPLE_POLYGON)
        bat_canvas_segment(canvas, entry->pen, x, y, x + 2.2 * em, y);
    if (entry->sample == BAT_SAMPLE_POLYGON) {
        bat_canvas_disc(canvas, entry->pen.colour, x, y, 0.2 * em);
        bat_canvas_disc(canvas, entry->pen.colour, x + 2.2 * em, y, 0.2 * em);
    }
    if (entry->sample == BAT_SAMPLE_CROSS)
        bat_canvas_cross(canvas, entry->pen, x + 1.1 * em, y, BAT_CROSS * em);
    if (entry->sample == BAT_SAMPLE_DOT)
        bat_canvas_disc(canvas, entry->pen.colour, x + 1.1 * em, y, BAT_DOT * em);
    if (entry->sample == BAT_SAMPLE_DISC)
        bat_canvas_disc(canvas, entry->pen.colour, x + 1.1 * em, y, 0.25 * em);
}

/* Walk through the entries as they are laid out; draw them when asked. Returns the height. */
static double lay_out(bat_canvas *canvas, const bat_legend *legend, double x, double y,
                      double width, bool draw)
{
    const double em = canvas->em, row = 1.5 * em;
    double at = 0, down = 0.5 * row;
    for (int i = 0; i < legend->count; i++) {
        const bat_entry *entry = &legend->entries[i];
        const double size = 2.8 * em + bat_canvas_text_width(canvas, 0.9 * em, entry->text);
        if (at > 0 && at + size > width) {
            at = 0;
            down += row;
        }
        if (draw) {
            draw_sample(canvas, entry, x + at, y + down);
            bat_canvas_text(canvas, bat_ink, 0.9 * em, BAT_LEFT, x + at + 2.8 * em, y + down,
                            entry->text);
        }
        at += size + 2 * em;
    }
    return legend->count > 0 ? down + 0.5 * row : 0;
}

double bat_legend_height(bat_canvas *canvas, const bat_legend *legend, double width)
{
    return lay_out(canvas, legend, 0, 0, width, false);
}

void bat_legend_draw(bat_canvas *canvas, const bat_legend *legend, double x, double y,
                     double width)
{
    lay_out(canvas, legend, x, y, width, true);
}

/* ---- scale bar ---- */

void bat_scale_bar(bat_canvas *canvas, double x, double y, double widest, double scale,
                   const char *unit)
{
    enum { PIECES = 5 };
    /* The largest round step of which five fit: half of the next larger is still more than
     * it. */
    double step = bat_round_step(widest / scale, PIECES);
    if (step * PIECES * scale > widest)
        step = bat_round_step(0.4 * widest / scale, PIECES);
    const double em = canvas->em, piece = step * scale, height = 0.4 * em;
    for (int i = 0; i <= PIECES; i++) {
        char text[BATTEN_NUMBER_SIZE + 16], number[BATTEN_NUMBER_SIZE];
        bat_number_text(i * step, bat_decimals_of_step(step), number);
        snprintf(text, sizeof text, i < PIECES ? "%s" : "%s %s", number, unit);
        if (i < PIECES && i % 2 == 0)
            bat_canvas_box(canvas, bat_ink, (bat_rectangle){x + i * piece, y, piece, height});
        bat_canvas_label(canvas, bat_ink, 0.85 * em, BAT_MIDDLE, x + i * piece, y + 1.1 * em,
                         text);
    }
    bat_canvas_frame(canvas, (bat_pen){bat_ink, 0.7, BAT_SOLID},
                     (bat_rectangle){x, y, PIECES * piece, height});
}
