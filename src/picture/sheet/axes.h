/* The axes of space in a drawing. */
#ifndef BAT_AXES_H
#define BAT_AXES_H
#include "picture/sheet/sheet.h"
#include "picture/sheet/view.h"

/* A grid with numbers where the view is along an axis; else the three axes, as seen, in the
 * lower left corner of the plot. */
void bat_axes_draw(bat_canvas *canvas, const bat_plot *plot, const bat_view *view,
                   batten_view kind, const char *unit);

#endif
