/* Names and small curves in the regions of the map of cubic spans. */
#ifndef BAT_PICTURE_DRAWINGS_CUBIC_NAMES_H
#define BAT_PICTURE_DRAWINGS_CUBIC_NAMES_H
#include "picture/sheet/sheet.h"

enum { BAT_CUBIC_STEPS = 160, BAT_CUBIC_CORNERS = 2 * BAT_CUBIC_STEPS + 8 };

/* A polygon of the plane, as it grows. */
typedef struct {
    int count;
    double xy[2 * BAT_CUBIC_CORNERS];
} bat_cubic_polygon;

typedef struct {
    const batten_draw_cubic_plane_options *plane;
    bat_canvas *canvas;
    bat_plot plot;
    double low, high;
    bat_cubic_polygon *shape; /* [2]: one in the plane, and one as it is on the sheet */
} bat_cubic_drawing;

static const bat_colour bat_cusp_red = {0.75, 0.1, 0.1}, return_blue = {0.1, 0.25, 0.7};

void bat_cubic_plane_names(const bat_cubic_drawing *d);

#endif
