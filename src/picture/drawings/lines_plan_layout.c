/* The layout of a lines plan: where its three views stand, and at which scale. */
#include "picture/drawings/lines_plan.h"

#include <stdio.h>

/* ---- layout ---- */

/* Room around a view, in em: for the numbers at both sides, the title above, the numbers
 * below. */
static const double beside = 5, above = 3, below = 3;
static const double strip_height = 12;

/* The size of a view in model units. */
static void view_size(const bat_hull *hull, bat_lines_view view, double size[2])
{
    for (int k = 0; k < 2; k++) {
        const int axis = k == 0 ? bat_lines_views[view].right : bat_lines_views[view].up;
        size[k] = hull->high[axis] - hull->low[axis];
    }
    if (view == BODY)
        size[0] *= 2;
    if (view == BREADTH) /* diagonals stand below the centre line */
        size[1] += hull->reach;
}

/* How the views stand: in two columns over the foot; one below the other over the foot; or so with the foot beside
 * the body plan, which is at the bottom. */
typedef enum { COLUMNS, STACKED, COMPACT, ARRANGEMENTS } arrangement;

/* What the foot needs where it stands beside the body plan, in em. */
static const double foot_width = 62;

typedef struct {
    double profile[2], breadth[2], body[2]; /* model units */
    double wide, high;                      /* of all views without their surroundings */
    double columns, rows;
} sizes;

static sizes measure_views(const bat_hull *hull, arrangement how)
{
    sizes m;
    view_size(hull, PROFILE, m.profile);
    view_size(hull, BREADTH, m.breadth);
    view_size(hull, BODY, m.body);
    m.columns = how == COLUMNS ? 2 : 1;
    m.rows = how == COLUMNS ? 2 : 3;
    m.wide = how == COLUMNS ? m.profile[0] + m.body[0] : bat_max(m.profile[0], m.body[0]);
    m.high = m.profile[1] + m.breadth[1] + (how == COLUMNS ? 0 : m.body[1]);
    if (how == COLUMNS) /* the body plan may be the higher one of its row */
        m.high = bat_max(m.profile[1], m.body[1]) + m.breadth[1];
    return m;
}

/* The part of the sheet inside its border that an arrangement has for its views. */
static bat_rectangle room_of(bat_rectangle inside, arrangement how, double em)
{
    if (how != COMPACT)
        inside.height -= strip_height * em;
    return inside;
}

/* How large the three views can be, in points per unit. */
static double largest_scale(const bat_hull *hull, bat_rectangle inside, double em,
                            arrangement how)
{
    const sizes m = measure_views(hull, how);
    const bat_rectangle room = room_of(inside, how, em);
    const double row = (above + below) * em;
    double scale = bat_min((room.width - m.columns * 2 * beside * em) / m.wide,
                           (room.height - m.rows * row) / m.high);
    if (how != COMPACT)
        return scale;
    /* The foot beside the body plan, and at least as high as its strip. */
    scale = bat_min(scale, (room.width - (2 * beside + foot_width) * em) / m.body[0]);
    return bat_min(scale,
                   (room.height - 2 * row - strip_height * em) / (m.profile[1] + m.breadth[1]));
}

/* The next usual drawing scale that is not larger: 1, 1.25, 1.5, 2 ... 7.5 times a power of ten. */
static double usual_ratio(double least)
{
    static const double factors[] = {1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 7.5};
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
    s->plots[view] = (bat_plot){
        .frame = {left, top, size[0] * s->scale, size[1] * s->scale},
        .scale = s->scale,
        .x0 = view == BODY ? -s->hull.high[1] : s->hull.low[bat_lines_views[view].right],
        .y0 = s->hull.low[bat_lines_views[view].up] - (view == BREADTH ? s->hull.reach : 0)};
}

/* Strip and table beside the body plan, or below everything with the table where a corner is free. */
static void place_foot(bat_lines_sheet *s, bat_rectangle inside, double em, arrangement how)
{
    const bat_rectangle body = s->plots[BODY].frame, breadth = s->plots[BREADTH].frame;
    const double high = strip_height * em, bottom = inside.y + inside.height;
    const double right = inside.x + inside.width, after = (beside + 1) * em;
    const double left = body.x + body.width + after;
    s->strip = (bat_rectangle){inside.x, bottom - high, inside.width, high};
    double top = how == COLUMNS ? body.y : breadth.y + breadth.height + (below + 0.5) * em;
    if (how == COMPACT) {
        s->strip.x = left;
        s->strip.width = right - left;
    }
    s->table = (bat_rectangle){left, top, right - left - em, s->strip.y - top};
    if (how == COLUMNS) { /* the corner below the body plan */
        top = bat_max(body.y + body.height + (below + 1) * em, breadth.y - above * em);
        s->table.x = breadth.x + breadth.width + after;
        s->table = (bat_rectangle){s->table.x, top, right - s->table.x - em, s->strip.y - top};
    }
}

static void place_views(bat_lines_sheet *s, bat_rectangle inside, double em, arrangement how)
{
    const sizes m = measure_views(&s->hull, how);
    const bat_rectangle room = room_of(inside, how, em);
    /* What is left over is shared evenly. */
    const double gap_x =
        (room.width - m.wide * s->scale - m.columns * 2 * beside * em) / (m.columns + 1);
    const double gap_y =
        (room.height - m.high * s->scale - m.rows * (above + below) * em) / (m.rows + 1);
    const double first = how == COLUMNS ? bat_max(m.profile[1], m.body[1]) : m.profile[1];
    const double left =
        room.x +
        (how == COLUMNS ? gap_x + beside * em : 0.5 * (room.width - m.profile[0] * s->scale));
    double top = room.y + gap_y + above * em;
    place_view(s, PROFILE, left, top);
    if (how == COLUMNS)
        place_view(s, BODY, left + m.profile[0] * s->scale + 2 * beside * em + gap_x, top);
    top += first * s->scale + (above + below) * em + gap_y;
    place_view(s, BREADTH, left, top);
    top += m.breadth[1] * s->scale + (above + below) * em + gap_y;
    if (how != COLUMNS) /* to the left, for the table beside it */
        place_view(s, BODY, room.x + (beside + 1) * em, top);
    place_foot(s, inside, em, how);
}

batten_status bat_lines_lay_out(bat_lines_sheet *s, const bat_canvas *canvas)
{
    const double em = canvas->em, edge = BAT_LINES_BORDER * em;
    const bat_rectangle inside = {edge, edge, canvas->width - 2 * edge,
                                  canvas->height - 2 * edge};
    arrangement best = COLUMNS;
    double largest = 0;
    for (int how = 0; how < ARRANGEMENTS; how++) {
        const double scale = largest_scale(&s->hull, inside, em, (arrangement)how);
        if (scale > largest) {
            largest = scale;
            best = (arrangement)how;
        }
    }
    const double metres = batten_model_unit_metres(s->model);
    const double points = 72 / 0.0254 * (metres > 0 ? metres : 1); /* per unit at 1 : 1 */
    if (!(largest > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a sheet of %g x %g has no room for three views",
                        canvas->width, canvas->height);
    s->ratio = usual_ratio(points / largest);
    s->scale = points / s->ratio;
    if (!(s->scale > 0))
        return bat_fail(BATTEN_OVERFLOW, "a hull of length %g is too large to draw",
                        s->hull.high[0] - s->hull.low[0]);
    place_views(s, inside, em, best);
    return BATTEN_OK;
}
