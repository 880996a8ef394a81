/* The foot of a lines plan: legend, figures and title block. */
#include "picture/drawings/lines_plan.h"

#include <stdio.h>

/* ---- foot of the sheet ---- */

static const char *unit_of(const bat_lines_sheet *s)
{
    const char *unit = batten_unit_name(batten_model_unit_metres(s->model));
    return unit ? unit : "units";
}

/* "every 2.5 m", or how many there are when they stand where they were given. */
static void spacing_text(const bat_lines_sheet *s, bat_family family, char text[static 48])
{
    const bat_cuts *cuts = &s->hull.families[family];
    char number[BATTEN_NUMBER_SIZE];
    bat_digits_text(cuts->spacing, 4, number);
    if (cuts->count == 0)
        snprintf(text, 48, "none");
    else if (cuts->spacing > 0)
        snprintf(text, 48, "every %s %s", number, unit_of(s));
    else
        snprintf(text, 48, "%d", cuts->count);
}

static void length_text(const bat_lines_sheet *s, double length, char text[static 48])
{
    char number[BATTEN_NUMBER_SIZE];
    bat_digits_text(length, 4, number);
    snprintf(text, 48, "%s %s", number, unit_of(s));
}

static void scale_text(const bat_lines_sheet *s, char text[static 48])
{
    char number[BATTEN_NUMBER_SIZE];
    bat_digits_text(s->ratio >= 1 ? s->ratio : 1 / s->ratio, 3, number);
    snprintf(text, 48, s->ratio >= 1 ? "1:%s" : "%s:1", number);
}

/* A name and its value in the title block, in one of two columns. */
static void write_pair(bat_canvas *canvas, bat_rectangle block, int row, int column,
                       const char *name, const char *value)
{
    static const double names_at[] = {0.03, 0.50}, values_at[] = {0.18, 0.69};
    const double em = canvas->em, y = block.y + (4.4 + 1.4 * row) * em;
    bat_canvas_text(canvas, bat_grey, 0.85 * em, BAT_LEFT,
                    block.x + names_at[column] * block.width, y, name);
    bat_canvas_text(canvas, bat_ink, 0.85 * em, BAT_LEFT,
                    block.x + values_at[column] * block.width, y, value);
}

static void write_figures(bat_canvas *canvas, const bat_lines_sheet *s, bat_rectangle block)
{
    const bat_hull *hull = &s->hull;
    char text[48];
    length_text(s, hull->high[0] - hull->low[0], text);
    write_pair(canvas, block, 0, 0, "Length", text);
    length_text(s, 2 * hull->high[1], text);
    write_pair(canvas, block, 1, 0, "Beam", text);
    length_text(s, hull->high[2] - hull->low[2], text);
    write_pair(canvas, block, 2, 0, "Depth", text);
    scale_text(s, text);
    write_pair(canvas, block, 3, 0, "Scale", text);
    spacing_text(s, BAT_STATIONS, text);
    write_pair(canvas, block, 0, 1, "Stations", text);
    spacing_text(s, BAT_WATERLINES, text);
    write_pair(canvas, block, 1, 1, "Waterlines", text);
    spacing_text(s, BAT_BUTTOCKS, text);
    write_pair(canvas, block, 2, 1, "Buttocks", text);
    spacing_text(s, BAT_DIAGONALS, text);
    write_pair(canvas, block, 3, 1, "Diagonals", text);
    write_pair(canvas, block, 4, 0, "Unit", unit_of(s));
}

/* As large as fits, up to `size`. */
static void write_title(bat_canvas *canvas, bat_rectangle block, const char *title)
{
    const double widest = 0.94 * block.width;
    double size = 1.35 * canvas->em;
    /* Bold letters are up to a fifth wider. */
    const double width = 1.2 * bat_canvas_text_width(canvas, size, title);
    if (width > widest)
        size = bat_max(0.5 * canvas->em, size * widest / width);
    bat_canvas_bold(canvas, bat_ink, size, BAT_LEFT, block.x + 0.03 * block.width,
                    block.y + 1.7 * canvas->em, title);
}

static void draw_title_block(bat_canvas *canvas, const bat_lines_sheet *s, bat_rectangle block)
{
    const double em = canvas->em, line = block.y + 3.2 * em;
    const bat_pen pen = {bat_ink, 0.9, BAT_SOLID};
    bat_canvas_box(canvas, (bat_colour){1, 1, 1}, block);
    bat_canvas_frame(canvas, pen, block);
    bat_canvas_segment(canvas, pen, block.x, line, block.x + block.width, line);
    write_title(canvas, block, *s->options->title ? s->options->title : "Lines plan");
    write_figures(canvas, s, block);
}

static void fill_legend(const bat_lines_sheet *s, bat_legend *legend)
{
    static const char *const plurals[] = {"stations", "buttocks", "waterlines", "diagonals"};
    bat_legend_add(legend, BAT_SAMPLE_LINE, bat_lines_edge_pen,
                   s->hull.knuckle_count > 0 ? "edges: sheer, knuckles, keel, stem, stern"
                                             : "edges: sheer, keel, stem, stern");
    for (int f = 0; f < BAT_FAMILIES; f++)
        if (f != BAT_DIAGONALS || s->hull.families[f].count > 0)
            bat_legend_add(legend, BAT_SAMPLE_LINE, bat_lines_curve_pen((bat_family)f, false),
                           "%s", plurals[f]);
    if (!isnan(s->plan->design_waterline))
        bat_legend_add(legend, BAT_SAMPLE_LINE, bat_lines_curve_pen(BAT_WATERLINES, true),
                       "design waterline");
    if (s->plan->data && batten_model_count(s->plan->data) > 0)
        bat_legend_add(legend, BAT_SAMPLE_CROSS, bat_lines_cross_pen, "given points");
}

static void draw_legend(bat_canvas *canvas, const bat_lines_sheet *s, double x, double y,
                        double width)
{
    bat_legend legend = {0};
    fill_legend(s, &legend);
    bat_legend_draw(canvas, &legend, x, y, width);
}

void bat_lines_draw_foot(bat_canvas *canvas, const bat_lines_sheet *s)
{
    const double em = canvas->em;
    const double wide = bat_min(46 * em, 0.55 * s->strip.width);
    const bat_rectangle block = {s->strip.x + s->strip.width - wide, s->strip.y + em, wide,
                                 s->strip.height - em};
    draw_title_block(canvas, s, block);

    const double x = s->strip.x + 2.5 * em, room = block.x - x - 2.5 * em;
    draw_legend(canvas, s, x, block.y + em, room);
    bat_scale_bar(canvas, x, s->strip.y + s->strip.height - 3 * em, bat_min(room, 40 * em),
                  s->scale, unit_of(s));
    bat_canvas_frame(canvas, (bat_pen){bat_ink, 1.2, BAT_SOLID},
                     (bat_rectangle){BAT_LINES_BORDER * em, BAT_LINES_BORDER * em,
                                     canvas->width - 2 * BAT_LINES_BORDER * em,
                                     canvas->height - 2 * BAT_LINES_BORDER * em});
}
