/* The layout of a lines plan: where its three views stand, and at which scale. */
#include "picture/drawings/lines_plan.h"

#include <stdio.h>

/* ---- layout ---- */

/* Room around a view, in em: for the numbers at both sides, the title above, the numbers
 * below. */
static const double beside = 5, above = 3, below = 2.6;
static const double strip_height = 13;

/* The size of a view in model units. */
static void view_size(const bat_hull *hull, bat_lines_view view, double size[2])
{
    for (int k = 0; k < 2; k++) {
        const int axis = k == 0 ? bat_lines_views[view].right : bat_lines_views[view].up;
        size[k] = hull->high[axis] - hull->low[axis];
    }
    if (view == BODY)
        size[0] *= 2;
}

/* How large the three views can be in `room`, in two columns or stacked. */
static double largest_scale(const bat_hull *hull, bat_rectangle room, double em, bool stacked)
{
    double profile[2], breadth[2], body[2];
    view_size(hull, PROFILE, profile);
    view_size(hull, BREADTH, breadth);
    view_size(hull, BODY, body);
    const double columns = stacked ? 1 : 2, rows = stacked ? 3 : 2;
    const double wide = stacked ? bat_max(profile[0], body[0]) : profile[0] + body[0];
    const double high = profile[1] + breadth[1] + (stacked ? body[1] : 0);
    return bat_min((room.width - columns * 2 * beside * em) / wide,
                   (room.height - rows * (above + below) * em) / high);
}

/* The next usual drawing scale that is not larger: 1, 1.5, 2 ... 7.5 times a power of ten. */
static double usual_ratio(double least)
{
    static const double factors[] = {1, 1.5, 2, 2.5, 3, 4, 5, 7.5};
    const double power = bat_pow(10, floor(bat_log10(least)));
    for (size_t i = 0; i < sizeof factors / sizeof factors[0]; i++)
        /* A scale that is reached but for rounding is taken. */
        if (factors[i] * power >= least * (1 - 1e-9))
            return factors[i] * power;
    return 10 * power;
}

static void place_view(bat_lines_sheet *s, bat_lines_view view, double left, double top)
{
    double size[2];
    view_size(&s->hull, view, size);
    s->plots[view] = (bat_plot){.frame = {left, top, size[0] * s->scale, size[1] * s->scale},
                                .scale = s->scale,
                                .x0 = view == BODY ? -s->hull.high[1]
                                                   : s->hull.low[bat_lines_views[view].right],
                                .y0 = s->hull.low[bat_lines_views[view].up]};
}

static void place_views(bat_lines_sheet *s, bat_rectangle room, double em, bool stacked)
{
    double profile[2], breadth[2], body[2];
    view_size(&s->hull, PROFILE, profile);
    view_size(&s->hull, BREADTH, breadth);
    view_size(&s->hull, BODY, body);
    const double columns = stacked ? 1 : 2, rows = stacked ? 3 : 2;
    const double wide = stacked ? bat_max(profile[0], body[0]) : profile[0] + body[0];
    const double high = profile[1] + breadth[1] + (stacked ? body[1] : 0);
    /* What is left over is shared evenly. */
    const double gap_x =
        (room.width - wide * s->scale - columns * 2 * beside * em) / (columns + 1);
    const double gap_y =
        (room.height - high * s->scale - rows * (above + below) * em) / (rows + 1);

    const double centre = room.x + 0.5 * room.width;
    const double left =
        stacked ? centre - 0.5 * profile[0] * s->scale : room.x + gap_x + beside * em;
    double top = room.y + gap_y + above * em;
    place_view(s, PROFILE, left, top);
    if (!stacked)
        place_view(s, BODY, left + profile[0] * s->scale + 2 * beside * em + gap_x, top);
    top += profile[1] * s->scale + (above + below) * em + gap_y;
    place_view(s, BREADTH, left, top);
    top += breadth[1] * s->scale + (above + below) * em + gap_y;
    if (stacked)
        place_view(s, BODY, centre - 0.5 * body[0] * s->scale, top);
}

batten_status bat_lines_lay_out(bat_lines_sheet *s, const bat_canvas *canvas)
{
    const double em = canvas->em, edge = BAT_LINES_BORDER * em;
    const bat_rectangle inside = {edge, edge, canvas->width - 2 * edge,
                                  canvas->height - 2 * edge};
    bat_rectangle room = inside;
    room.height -= strip_height * em;
    s->strip =
        (bat_rectangle){inside.x, inside.y + room.height, inside.width, strip_height * em};

    const double beside_it = largest_scale(&s->hull, room, em, false);
    const double stacked = largest_scale(&s->hull, room, em, true);
    const double largest = bat_max(beside_it, stacked);
    const double metres = batten_model_unit_metres(s->model);
    const double points = 72 / 0.0254 * (metres > 0 ? metres : 1); /* per unit at 1 : 1 */
    if (!(largest > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a sheet of %g x %g has no room for three views",
                        canvas->width, canvas->height);
    s->ratio = usual_ratio(points / largest);
    s->scale = points / s->ratio;
    if (!isfinite(s->ratio) || !(s->scale > 0))
        return bat_fail(BATTEN_OVERFLOW, "a hull of length %g is too large to draw",
                        s->hull.high[0] - s->hull.low[0]);
    place_views(s, room, em, stacked > beside_it);
    return BATTEN_OK;
}
