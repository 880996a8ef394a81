/*
 * The lines between which a graph is lofted: where the table ends; where the graph, which goes on
 * over the whole grid, meets the centre plane beyond the last half-breadth; and above the last one of each
 * station. Each is made fair within what the bound and the grid leave open.
 */
#include "fair/fairness.h"
#include "loft/hull.h"
#include "loft/lines/line.h"

enum { X, Z, SAMPLES = 400, FEWEST = 3 };

/* A place of a line: at t its value is from `least` to `most`. */
typedef struct {
    double t, least, most;
    bool closed; /* there the hull lies on the centre plane */
} opening;

typedef struct {
    const bat_hull_grid *grid;
    const bat_loft *all; /* the graph over the whole grid */
    double within;
    bat_graph_frame *frame;
    int corner[2]; /* the stations between which the foot runs */
    bat_arena *arena;
    int count;
    opening *at; /* [stations + lines] */
} lines;

/* Parts of a spacing of the grid: so far lines stay outside of what is hull; so much room lines need
 * where the table says exactly where they are; and so far beyond a half-breadth within the bound of 0 the
 * hull ends at most. */
static const double margin = 0.02, least_room = 2e-3, most_beyond = 0.1;

/* ---- where the graph meets the centre plane ---- */

/* From a to b, in either order. */
static opening open_between(double a, double b, bool closed)
{
    return (opening){.least = bat_min(a, b), .most = bat_max(a, b), .closed = closed};
}

static double y_at(const lines *e, const double at[2])
{
    const bat_hull_grid *g = e->grid;
    const int last = g->station_count - 1;
    bat_loft_place place;
    bat_loft_place_at(
        &e->all->patch, (at[X] - g->x[0]) / (g->x[last] - g->x[0]),
        bat_graph_fall(e->frame->bend, (at[Z] - g->z[0]) / (g->z[g->line_count - 1] - g->z[0])),
        &place);
    return place.s[0][0][1];
}

/* From a place with hull along an axis to the next, which has none: where y is 0, and as far on
 * both sides as y is within the bound there. What is next to the hull is left to it. */
static opening find_crossing(const lines *e, const double inside[2], int axis, double outside)
{
    const double step = (outside - inside[axis]) / SAMPLES;
    double at[2] = {inside[X], inside[Z]}, y = y_at(e, inside), slope = 0, share = 1;
    for (int k = 1; k <= SAMPLES && y > 0; k++) {
        at[axis] = inside[axis] + k * step;
        const double next = y_at(e, at);
        slope = bat_max(y - next, 0);
        share = next <= 0 ? (k - 1 + y / slope) / SAMPLES : 1;
        y = next;
    }
    /* In parts of the way. */
    const double room = bat_min(e->within / bat_max(slope * SAMPLES, e->within), 1);
    const double near = bat_min(bat_max(share - room, margin), 1 - margin),
                 far = bat_max(bat_min(share + room, 1), near + margin);
    return open_between(inside[axis] + near * SAMPLES * step,
                        inside[axis] + far * SAMPLES * step, true);
}

/* Exactly there and hardly beyond. */
static opening end_at(double value, double inner)
{
    return open_between(value, value + least_room * (value - inner), false);
}

static void add_opening(lines *e, double t, opening found)
{
    found.t = t;
    e->at[e->count++] = found;
}

/* ---- fairing ---- */

static batten_status fair_line(const lines *e, int count, const double *knots, double length,
                               double *out)
{
    const size_t n = (size_t)e->count;
    double *t = bat_arena_array(e->arena, n, 3 * sizeof *t);
    int found;
    if (!t)
        return BATTEN_OUT_OF_MEMORY;
    double *values = t + n, *rooms = values + n;
    for (size_t k = 0; k < n; k++) {
        t[k] = e->at[k].t;
        values[k] = (e->at[k].least + e->at[k].most) / 2;
        rooms[k] = (e->at[k].most - e->at[k].least) / 2;
    }
    bat_loft_line line = {.count = count,
                          .knots = knots,
                          .datum_count = e->count,
                          .t = t,
                          .values = values,
                          .rooms = rooms,
                          .within = 1,
                          .length = length,
                          .height = e->within / 4};
    batten_status status =
        bat_required_inflections(1, e->count, t, values, rooms, &line.changes);
    return status == BATTEN_OK ? bat_loft_line_fair(&line, out, &found) : status;
}

/* The outermost station with hull on a line; -1: none. */
static int last_hull(const lines *e, bool fore, int line)
{
    const int n = e->grid->station_count;
    for (int i = 0; i < n; i++) {
        const int k = fore ? n - 1 - i : i;
        if (bat_hull_grid_says(e->grid, k, line) == BAT_GRID_HULL)
            return k;
    }
    return -1;
}

/* ---- the foot ---- */

static int lowest_hull(const bat_hull_grid *grid, int station)
{
    int l = 0;
    while (l < grid->line_count && bat_hull_grid_says(grid, station, l) != BAT_GRID_HULL)
        l++;
    return l;
}

/* False at a station without hull. */
static bool find_foot_of(const lines *e, int station, opening *out)
{
    const bat_hull_grid *g = e->grid;
    const int l = lowest_hull(g, station);
    if (l == g->line_count)
        return false;
    *out = l == 0 ? end_at(g->z[0], g->z[1])
                  : find_crossing(e, (const double[2]){g->x[station], g->z[l]}, Z, g->z[l - 1]);
    return true;
}

static double middle(const opening *o)
{
    return (o->least + o->most) / 2;
}

/* From amidships to both ends the foot runs until it rises by more than 45 degrees: what is beyond is
 * stem. */
static void find_corners(lines *e, const opening *foot, const bool *is_hull)
{
    const int n = e->grid->station_count;
    for (int fore = 0; fore <= 1; fore++) {
        const int step = fore ? 1 : -1;
        int k = n / 2;
        while (k + step >= 0 && k + step < n && is_hull[k + step] &&
               fabs(middle(foot + k + step) - middle(foot + k)) <=
                   fabs(e->grid->x[k + step] - e->grid->x[k]))
            k += step;
        e->corner[fore] = k;
    }
}

static batten_status fair_foot(lines *e, const opening *foot)
{
    const bat_hull_grid *g = e->grid;
    int closed = 0;
    const double aft = g->x[e->corner[0]], fore = g->x[e->corner[1]];
    e->count = 0;
    for (int k = e->corner[0]; k <= e->corner[1]; k++) {
        add_opening(e, (g->x[k] - aft) / (fore - aft), foot[k]);
        closed += foot[k].closed;
    }
    e->frame->closed_foot = closed == e->count;
    return closed == 0 || e->count < FEWEST
               ? BATTEN_OK
               : fair_line(e, e->frame->u_count, e->frame->u_knots, fore - aft, e->frame->low);
}

static batten_status find_foot(lines *e)
{
    const bat_hull_grid *g = e->grid;
    const size_t n = (size_t)g->station_count;
    opening *foot = bat_arena_array(e->arena, n, sizeof *foot);
    bool *is_hull = bat_arena_array(e->arena, n, sizeof *is_hull);
    if (!foot || !is_hull)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < g->station_count; k++)
        is_hull[k] = find_foot_of(e, k, foot + k);
    find_corners(e, foot, is_hull);
    return fair_foot(e, foot);
}
/* ---- the top ---- */

/* Between the last half-breadth of a station and the next waterline, of which it has none. */
static opening find_top_of(const bat_hull_grid *g, int station)
{
    int l = g->line_count - 1;
    while (l > 1 && bat_hull_grid_says(g, station, l) != BAT_GRID_HULL)
        l--;
    if (l + 1 == g->line_count)
        return end_at(g->z[l], g->z[l - 1]);
    return open_between((1 - margin) * g->z[l] + margin * g->z[l + 1], g->z[l + 1], false);
}

static batten_status find_top(lines *e)
{
    const bat_hull_grid *g = e->grid;
    const double aft = g->x[e->corner[0]], fore = g->x[e->corner[1]];
    bool stairs = false;
    e->count = 0;
    for (int k = e->corner[0]; k <= e->corner[1]; k++) {
        const opening top = find_top_of(g, k);
        stairs = stairs || top.least < g->z[g->line_count - 1];
        add_opening(e, (g->x[k] - aft) / (fore - aft), top);
    }
    return stairs && e->count >= FEWEST
               ? fair_line(e, e->frame->u_count, e->frame->u_knots, fore - aft, e->frame->high)
               : BATTEN_OK;
}

/* ---- the ends ---- */

/* False where the table is silent on it. */
static bool find_end_of(const lines *e, bool fore, int line, opening *out)
{
    const bat_hull_grid *g = e->grid;
    const int k = last_hull(e, fore, line), step = fore ? 1 : -1;
    if (k < 0)
        return false;
    if (k == (fore ? g->station_count - 1 : 0)) {
        *out = end_at(g->x[k], g->x[k - step]);
        return true;
    }
    if (bat_hull_grid_says(g, k + step, line) != BAT_GRID_OUTSIDE)
        return false;
    const double way = g->x[k + step] - g->x[k];
    *out = bat_hull_grid_y(g, k, line) <= e->within
               ? open_between(g->x[k] + margin * most_beyond * way, g->x[k] + most_beyond * way,
                              true)
               : find_crossing(e, (const double[2]){g->x[k], g->z[line]}, X, g->x[k + step]);
    return true;
}

/* Over the height at that end: how many places are closed. */
static int collect_end(lines *e, bool fore, double low, double high)
{
    const bat_hull_grid *g = e->grid;
    const int corner = e->corner[fore];
    int closed = 0;
    e->count = 0;
    if (low > g->z[0])
        add_opening(e, 0, end_at(g->x[corner], g->x[fore ? corner - 1 : corner + 1]));
    for (int l = 0; l < g->line_count; l++) {
        opening found;
        if (g->z[l] < low || !find_end_of(e, fore, l, &found))
            continue;
        closed += found.closed;
        add_opening(e, bat_graph_fall(e->frame->bend, (g->z[l] - low) / (high - low)), found);
    }
    return closed;
}

/* The foot that runs to the last station ends in its plane. */
static batten_status find_end(lines *e, bool fore)
{
    bat_graph_frame *f = e->frame;
    const int at = fore ? f->u_count - 1 : 0;
    const double low = f->low[at], high = f->high[at];
    if (e->corner[fore] == (fore ? e->grid->station_count - 1 : 0))
        return BATTEN_OK;
    const int closed = collect_end(e, fore, low, high);
    if (closed == 0 || e->count < FEWEST)
        return BATTEN_OK;
    f->closed[fore] = closed == e->count;
    return fair_line(e, f->v_count, f->v_knots, high - low, fore ? f->fore : f->aft);
}

batten_status bat_graph_find_lines(const bat_hull_grid *grid, bat_loft *all, double within,
                                   bat_arena *arena, bat_graph_frame *frame)
{
    lines e = {.grid = grid, .all = all, .within = within, .frame = frame, .arena = arena};
    batten_status status = bat_loft_fits(all);
    e.at =
        bat_arena_array(arena, (size_t)(grid->station_count + grid->line_count), sizeof *e.at);
    if (status == BATTEN_OK && !e.at)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_foot(&e);
    if (status == BATTEN_OK)
        status = find_top(&e);
    for (int fore = 0; fore <= 1 && status == BATTEN_OK; fore++)
        status = find_end(&e, fore);
    return status;
}
