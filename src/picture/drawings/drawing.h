/* A line drawing of a model in a frame on a sheet: a picture has one, a comparison several. */
#ifndef BAT_DRAWING_H
#define BAT_DRAWING_H
#include "picture/lines/stroke.h"
#include "picture/sheet/sheet.h"
#include "picture/sheet/view.h"
#include <batten/curvature.h>

/* One object of the model, made ready. */
typedef struct {
    const batten_object *object;
    bat_colour colour;
    bat_strokes lines; /* of a surface: the lines at fixed u, then those at fixed v */
    int tooth_count;
    batten_tooth *teeth; /* at scale 1 */
    double sharpest;     /* largest |curvature| */
} bat_shape;

typedef struct bat_tool bat_tool;

typedef struct {
    const batten_model *model;
    const batten_draw_options *options;
    int shape_count;
    bat_shape *shapes;
    batten_view kind;
    bat_view view;
    double comb_scale;
    double low[2], high[2]; /* what the picture shows, in its plane */
    bat_plot plot;
    double *xy;           /* room for the longest line */
    const bat_tool *tool; /* whose way this is; NULL for other drawings */
} bat_drawing;

/* Everything of the model, in the view and at the scale of its comb that the options ask for.
 * The drawing must be given back in every case. */
batten_status bat_drawing_prepare(bat_drawing *drawing);
void bat_drawing_free(bat_drawing *drawing);
/* What it shows follows its comb scale, when that was changed. */
batten_status bat_drawing_find_range(bat_drawing *drawing);
/* Into its plot, which must have been fitted. */
void bat_drawing_draw(bat_canvas *canvas, const bat_drawing *drawing);

/* ---- tool_path.c ---- */

/* How the tool moves on this layer, and how far in all. */
enum { BAT_TOOL_LAYERS = 3 };
struct bat_tool {
    int count[BAT_TOOL_LAYERS];
    double length[BAT_TOOL_LAYERS];
};
/* BAD_ARGUMENT when nothing is cut, or a curve is on no layer of a tool. */
batten_status bat_tool_measure(const batten_model *tool_path, bat_tool *out);
bat_pen bat_tool_pen(const batten_object *object);
void bat_tool_legend(const bat_tool *tool, const char *unit, bat_legend *legend);
/* Where it goes down, numbered in this order. */
void bat_tool_draw_starts(bat_canvas *canvas, const bat_drawing *drawing);

/* ---- what the parts of a drawing share ---- */

/* Where a point in space is on the sheet. */
void bat_drawing_to_sheet(const bat_drawing *drawing, const double point[3], double xy[2]);

/* This many objects are told apart by colour; more are named where they end. */
enum { BAT_COLOURED = 8 };
static const bat_colour bat_palette[BAT_COLOURED] = {
    {0.09, 0.32, 0.62}, {0.76, 0.26, 0.10}, {0.08, 0.48, 0.30}, {0.48, 0.22, 0.58},
    {0.72, 0.50, 0.04}, {0.05, 0.50, 0.58}, {0.70, 0.16, 0.38}, {0.36, 0.36, 0.36}};

/* Make the shapes of the model: strokes, combs, colours. */
batten_status bat_drawing_gather(bat_drawing *drawing);
/* Choose the view and the scale of the combs, and find the range. */
batten_status bat_drawing_choose_view(bat_drawing *drawing);
/* Room for the longest line on the sheet. */
batten_status bat_drawing_make_room(bat_drawing *drawing);
bool bat_drawing_shows_polygon(const bat_drawing *drawing, const batten_object *object);
bool bat_drawing_shows_points(const bat_drawing *drawing, const batten_object *object);
/* The vertices that a curve was made from, else its control points; in space. */
int bat_drawing_control_count(const batten_object *object);
void bat_drawing_control_point(const batten_object *object, int i, double point[3]);
/* Where a tooth of a comb ends. */
void bat_drawing_comb_tip(const batten_tooth *tooth, double scale, double tip[3]);

#endif
