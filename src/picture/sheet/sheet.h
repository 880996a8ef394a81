/* What stands around a drawing: grid, legend, scale bar. */
#ifndef BAT_SHEET_H
#define BAT_SHEET_H
#include "picture/sheet/canvas.h"
#include "picture/sheet/numbers.h"
#include <batten/text.h>

/* The colours of everything that is not the drawing itself. */
extern const bat_colour bat_ink, bat_grey;

/* ---- a plot: a rectangle of the sheet that shows a piece of the plane ---- */

typedef struct {
    bat_rectangle frame;
    double scale;  /* points per model unit, the same both ways */
    double x0, y0; /* what lies at the lower left corner of the frame */
} bat_plot;

static inline double bat_plot_x(const bat_plot *plot, double x)
{
    return plot->frame.x + (x - plot->x0) * plot->scale;
}

static inline double bat_plot_y(const bat_plot *plot, double y)
{
    return plot->frame.y + plot->frame.height - (y - plot->y0) * plot->scale;
}

/* The plot in `frame` that shows low .. high [2] as large as possible, in the middle. */
bat_plot bat_plot_fit(bat_rectangle frame, const double low[2], const double high[2]);
/* A grid of round numbers, written left and below; names of the axes with the unit: "x (m)". */
void bat_plot_grid(bat_canvas *canvas, const bat_plot *plot, const char *name_x,
                   const char *name_y);
/* How wide the numbers at the left are. */
double bat_plot_numbers_width(bat_canvas *canvas, const bat_plot *plot);

/* ---- legend ---- */

/* The arms of a cross and the radius of a dot, which mark points, in letters. */
#define BAT_CROSS 0.25
#define BAT_DOT 0.1

typedef enum {
    BAT_SAMPLE_LINE,
    BAT_SAMPLE_POLYGON,
    BAT_SAMPLE_CROSS,
    BAT_SAMPLE_DOT,
    BAT_SAMPLE_DISC
} bat_sample;

enum { BAT_LEGEND_LIMIT = 12, BAT_LEGEND_TEXT = 80 };

typedef struct {
    bat_sample sample;
    bat_pen pen;
    char text[BAT_LEGEND_TEXT];
} bat_entry;

typedef struct {
    int count;
    bat_entry entries[BAT_LEGEND_LIMIT];
} bat_legend;

/* Add an entry; the text is cut to its place, and beyond the limit entries are left out. No
 * numbers with a decimal mark through `format`: bat_number_text writes those. */
void bat_legend_add(bat_legend *legend, bat_sample sample, bat_pen pen, const char *format, ...)
    BATTEN_PRINTF(4, 5);
/* Entries from left to right in rows of this width: the height they take. */
double bat_legend_height(bat_canvas *canvas, const bat_legend *legend, double width);
void bat_legend_draw(bat_canvas *canvas, const bat_legend *legend, double x, double y,
                     double width);

/* ---- scale bar ---- */

/* Black and white pieces of a round length, at most `widest` points in all; (x, y) is the upper
 * left corner. */
void bat_scale_bar(bat_canvas *canvas, double x, double y, double widest, double scale,
                   const char *unit);

#endif
