/* Axes beside a drawing, with round numbers and units. */
#include "picture/sheet/axes.h"

#include <stdio.h>

static void draw_triad(bat_canvas *canvas, const bat_plot *plot, const bat_view *view)
{
    static const char *const names[] = {"x", "y", "z"};
    const bat_rectangle f = plot->frame;
    const double em = canvas->em, x = f.x + 4 * em, y = f.y + f.height - 3 * em;
    for (int k = 0; k < 3; k++) {
        const double right = view->right[k], up = view->up[k];
        bat_canvas_segment(canvas, (bat_pen){bat_grey, 1, BAT_SOLID}, x, y,
                           x + 2.5 * em * right, y - 2.5 * em * up);
        if (bat_hypot(right, up) > 0.1)
            bat_canvas_text(canvas, bat_grey, 0.9 * em, BAT_MIDDLE, x + 3.2 * em * right,
                            y - 3.2 * em * up, names[k]);
    }
}

void bat_axes_draw(bat_canvas *canvas, const bat_plot *plot, const bat_view *view,
                   batten_view kind, const char *unit)
{
    static const char *const axes[][2] = {[BATTEN_VIEW_TOP] = {"x", "y"},
                                          [BATTEN_VIEW_FRONT] = {"y", "z"},
                                          [BATTEN_VIEW_SIDE] = {"x", "z"}};
    if (kind == BATTEN_VIEW_AXONOMETRIC || kind == BATTEN_VIEW_ISOMETRIC) {
        draw_triad(canvas, plot, view);
        return;
    }
    char names[2][32];
    for (int k = 0; k < 2; k++)
        snprintf(names[k], sizeof names[k], "%s (%s)", axes[kind][k], unit);
    bat_plot_grid(canvas, plot, names[0], names[1]);
}
