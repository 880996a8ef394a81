/*
 * A sheet to draw on: one code for PNG, SVG and PDF.
 *
 * Coordinates are points (pixels in a PNG), x to the right, y down. Nothing here returns a
 * status until the end: what goes wrong is remembered, and bat_canvas_finish reports it.
 */
#ifndef BAT_CANVAS_H
#define BAT_CANVAS_H
#include "base/base.h"
#include "picture/sheet/cover.h"
#include "picture/sheet/dxf.h"
#include <batten/picture.h>
#include <batten/text.h>
#include <cairo.h>

typedef struct {
    double red, green, blue; /* sRGB, 0..1 */
} bat_colour;

typedef struct {
    double x, y, width, height;
} bat_rectangle;

typedef enum { BAT_SOLID, BAT_DASHED, BAT_CHAIN, BAT_DOTTED } bat_dash;

typedef struct {
    bat_colour colour;
    double width;
    bat_dash dash;
} bat_pen;

/* Where the given point lies on a text. */
typedef enum { BAT_LEFT, BAT_MIDDLE, BAT_RIGHT } bat_anchor;

/* How a name is written. */
typedef struct {
    bat_colour colour;
    double size;
    bool leads; /* where there is no room near, it stands farther off, with a leader */
} bat_lettering;

/* A name that waits for its place. */
enum { BAT_NAME_PLACES = 10, BAT_NAME_TEXT = 256 };
typedef struct {
    bat_lettering how;
    int count;
    double at[BAT_NAME_PLACES][2]; /* what it names, the best place first */
    bat_rectangle room;
    char text[BAT_NAME_TEXT];
} bat_name;

typedef struct {
    cairo_t *cairo;
    cairo_surface_t *surface;
    batten_picture_format format;
    double width, height;
    double em; /* the size of ordinary text; everything around a drawing is measured in it */
    batten_text bytes;
    bat_rectangle clip; /* what may be drawn on now: the sheet, or less */
    bool draws_ground;  /* what is drawn may be covered by names: a grid */
    bat_cover cover;    /* where all other lines are */
    bat_name *names;    /* that are put when all is drawn */
    size_t name_count, name_capacity;
    bat_rectangle *taken; /* where labels stand */
    size_t taken_count, taken_capacity;
    bat_dxf_sheet *dxf; /* where lines and texts are written, too; NULL as a rule */
    batten_status status;
} bat_canvas;

/* Between a postage stamp and what cairo's images hold with room for their bytes. */
enum { BAT_LEAST_SIZE = 64, BAT_LARGEST_SIZE = 16384 };
/* From here on lines are on this layer, where there are layers. */
static inline void bat_canvas_layer(bat_canvas *canvas, bat_layer layer)
{
    if (canvas->dxf)
        canvas->dxf->layer = layer;
}

/* BAD_ARGUMENT or TOO_LARGE for sizes that cannot be. */
batten_status bat_canvas_check_size(int width, int height);
/* A white sheet. `em` is the size of its text. */
batten_status bat_canvas_begin(batten_picture_format format, int width, int height, double em,
                               const char *title, bat_canvas *out);
/* More bytes for the file of the canvas: what cairo calls. */
cairo_status_t bat_canvas_append(void *closure, const unsigned char *data, unsigned length);
/* Put the names and hand over the file, or report the first thing that went wrong; the canvas is gone in either
 * case. */
batten_status bat_canvas_finish(bat_canvas *canvas, char **data, size_t *size);
/* Give everything back without a file. */
void bat_canvas_end(bat_canvas *canvas);

void bat_canvas_clip(bat_canvas *canvas, bat_rectangle to);
void bat_canvas_unclip(bat_canvas *canvas);
/* A polyline through xy [count][2]. */
void bat_canvas_line(bat_canvas *canvas, bat_pen pen, size_t count, const double *xy);
void bat_canvas_segment(bat_canvas *canvas, bat_pen pen, double x0, double y0, double x1,
                        double y1);
/* The polygon xy [count][2], filled; `opacity` 0..1. */
void bat_canvas_fill(bat_canvas *canvas, bat_colour colour, double opacity, size_t count,
                     const double *xy);
void bat_canvas_box(bat_canvas *canvas, bat_colour colour, bat_rectangle box);
void bat_canvas_frame(bat_canvas *canvas, bat_pen pen, bat_rectangle box);
void bat_canvas_disc(bat_canvas *canvas, bat_colour colour, double x, double y, double radius);
void bat_canvas_cross(bat_canvas *canvas, bat_pen pen, double x, double y, double radius);

/* How wide a text is at a size. */
double bat_canvas_text_width(bat_canvas *canvas, double size, const char *text);
/* y is the height of the middle of the lower-case letters. */
void bat_canvas_text(bat_canvas *canvas, bat_colour colour, double size, bat_anchor anchor,
                     double x, double y, const char *text);
void bat_canvas_bold(bat_canvas *canvas, bat_colour colour, double size, bat_anchor anchor,
                     double x, double y, const char *text);
/* Turned a quarter to the left, centred on (x, y). */
void bat_canvas_text_up(bat_canvas *canvas, bat_colour colour, double size, double x, double y,
                        const char *text);
/* ---- labels.c ---- */

/* Keep labels and names away from here. */
void bat_canvas_take(bat_canvas *canvas, bat_rectangle place);
/* A text on a white ground, when it lies within the sheet and covers no earlier label; an empty
 * one is nothing. For places beside drawings: lines are not minded. */
bool bat_canvas_label(bat_canvas *canvas, bat_colour colour, double size, bat_anchor anchor,
                      double x, double y, const char *text);
/* The name of what is at one of these places [count][2], the best first: beside it, or as near as it
 * covers neither a line nor a text; within what is clipped to now. It is put when all is drawn, and left out
 * where there is no room. */
void bat_canvas_name(bat_canvas *canvas, bat_lettering how, int count, const double *at,
                     const char *text);
/* Put the names, in their order. */
void bat_canvas_place_names(bat_canvas *canvas);

#endif
