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
    double *xy; /* room for the longest line */
} bat_drawing;

/* Everything of the model, in the view and at the scale of its comb that the options ask for.
 * The drawing must be given back in every case. */
batten_status bat_drawing_prepare(bat_drawing *drawing);
void bat_drawing_free(bat_drawing *drawing);
/* What it shows follows its comb scale, when that was changed. */
batten_status bat_drawing_find_range(bat_drawing *drawing);
/* Into its plot, which must have been fitted. */
void bat_drawing_draw(bat_canvas *canvas, const bat_drawing *drawing);

#endif
