/* The patch of a hull whose half-breadths are a function of its profile plane. */
#include "base/list.h"
#include "loft/hull.h"
#include "spline/spline.h"

enum { P = BAT_LOFT_DEGREE, K = BAT_LOFT_SUPPORT };

/* Fewer intervals than these are halved: the hull bends between few stations, too. */
enum { FEWEST_U = 14, FEWEST_V = 7 };

/* Waterlines stand closer at the foot, for there a hull bends more; v follows them by as much of
 * a quadratic. */
static const double bend_of_heights = 0.6;

/* ---- the map ---- */

double bat_graph_fall(double bend, double share)
{
    const double a = 1 - bend;
    return 2 * share / (a + sqrt(a * a + 4 * bend * share));
}

/* The coefficient of the share: its blossom. */
static double rise_coefficient(const bat_graph_frame *f, int j)
{
    const double *t = f->v_knots + j + 1;
    return (1 - f->bend) * (t[0] + t[1] + t[2]) / 3 +
           f->bend * (t[0] * t[1] + t[1] * t[2] + t[0] * t[2]) / 3;
}

/* Knots at these places inside (0, 1), halved when they are few. */
static batten_status make_knots(bat_arena *arena, int count, const double *places, int fewest,
                                int *coefficients, double **out)
{
    const bool halve = count < fewest;
    const int inner = halve ? 2 * count + 1 : count;
    double *at = bat_arena_array(arena, (size_t)inner, sizeof *at);
    *out = bat_arena_array(arena, (size_t)inner + 2 * K, sizeof **out);
    if (!at || !*out)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < inner; k++) {
        const double before = k / 2 > 0 ? places[k / 2 - 1] : 0;
        const double after = k / 2 < count ? places[k / 2] : 1;
        at[k] = !halve ? places[k] : k % 2 ? places[k / 2] : (before + after) / 2;
    }
    bat_loft_knots(inner, at, *out);
    *coefficients = inner + K;
    return BATTEN_OK;
}

static batten_status make_v_knots(const bat_hull_grid *grid, bat_arena *arena,
                                  bat_graph_frame *f)
{
    const int lines = grid->line_count;
    double *v = bat_arena_array(arena, (size_t)lines, sizeof *v);
    if (!v)
        return BATTEN_OUT_OF_MEMORY;
    for (int l = 1; l + 1 < lines; l++)
        v[l - 1] = bat_graph_fall(f->bend, (grid->z[l] - grid->z[0]) /
                                               (grid->z[lines - 1] - grid->z[0]));
    return make_knots(arena, lines - 2, v, FEWEST_V, &f->v_count, &f->v_knots);
}

/* At the stations that are not next to an end. */
static batten_status make_u_knots(const bat_hull_grid *grid, bat_arena *arena, double aft,
                                  double fore, bat_graph_frame *f)
{
    const double nearest = 0.01;
    double *u = bat_arena_array(arena, (size_t)grid->station_count, sizeof *u);
    int count = 0;
    if (!u)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < grid->station_count; k++) {
        const double at = (grid->x[k] - aft) / (fore - aft);
        if (at > nearest && at < 1 - nearest)
            u[count++] = at;
    }
    return make_knots(arena, count, u, FEWEST_U, &f->u_count, &f->u_knots);
}

batten_status bat_graph_frame_all(const bat_hull_grid *grid, bat_arena *arena,
                                  bat_graph_frame *out)
{
    const double aft = grid->x[0], fore = grid->x[grid->station_count - 1];
    bat_graph_frame f = {.bend = bend_of_heights};
    batten_status status = make_v_knots(grid, arena, &f);
    if (status == BATTEN_OK)
        status = make_u_knots(grid, arena, aft, fore, &f);
    if (status != BATTEN_OK)
        return status;
    f.aft = bat_arena_array(arena, (size_t)f.v_count, sizeof *f.aft);
    f.fore = bat_arena_array(arena, (size_t)f.v_count, sizeof *f.fore);
    f.low = bat_arena_array(arena, (size_t)f.u_count, sizeof *f.low);
    f.high = bat_arena_array(arena, (size_t)f.u_count, sizeof *f.high);
    if (!f.aft || !f.fore || !f.low || !f.high)
        return BATTEN_OUT_OF_MEMORY;
    for (int j = 0; j < f.v_count; j++) {
        f.aft[j] = aft;
        f.fore[j] = fore;
    }
    for (int i = 0; i < f.u_count; i++) {
        f.low[i] = grid->z[0];
        f.high[i] = grid->z[grid->line_count - 1];
    }
    *out = f;
    return BATTEN_OK;
}

/* x and z of the control points; what closes an end or the foot lies on the centre plane, on which the
 * foot is free to rise and sink. */
static void lay_map(const bat_graph_frame *f, bat_loft *loft)
{
    const bat_loft_patch *patch = &loft->patch;
    for (int i = 0; i < patch->nu; i++) {
        const double u = bat_greville(P, patch->u_knots, i);
        for (int j = 0; j < patch->nv; j++) {
            const size_t at = 3 * ((size_t)i * (size_t)patch->nv + (size_t)j);
            const double share = rise_coefficient(f, j);
            patch->points[at] = (1 - u) * f->aft[j] + u * f->fore[j];
            patch->points[at + 2] = (1 - share) * f->low[i] + share * f->high[i];
            loft->held[at] = true;
            loft->held[at + 2] = j > 0 || !f->closed_foot;
            loft->held[at + 1] = (j == 0 && f->closed_foot) || (i == 0 && f->closed[0]) ||
                                 (i + 1 == patch->nu && f->closed[1]);
        }
    }
}

/* ---- the points ---- */

/* Where the map has x and z; the nearest place within the frame. */
static void locate(const bat_loft_patch *patch, double x, double z, bat_loft_datum *d)
{
    enum { STEPS = 60 };
    const double longest = 0.15;
    bat_loft_place place;
    d->u = d->v = 0.5;
    for (int k = 0; k < STEPS; k++) {
        bat_loft_place_at(patch, d->u, d->v, &place);
        const double *su = place.s[1][0], *sv = place.s[0][1];
        const double dx = x - place.s[0][0][0], dz = z - place.s[0][0][2];
        const double det = su[0] * sv[2] - su[2] * sv[0];
        const double u = (dx * sv[2] - dz * sv[0]) / det, v = (dz * su[0] - dx * su[2]) / det;
        d->u = bat_min(bat_max(d->u + bat_min(bat_max(u, -longest), longest), 0), 1);
        d->v = bat_min(bat_max(d->v + bat_min(bat_max(v, -longest), longest), 0), 1);
    }
}

/* Nearer to the foot or the top than this a point lies on it. */
static const double rounding = 1e-9;

/* Is one of its neighbours along the waterline, or the one below, not of the hull? */
static bool is_outermost(const bat_hull_grid *grid, int k, int l)
{
    return k == 0 || k + 1 == grid->station_count || l == 0 ||
           bat_hull_grid_says(grid, k - 1, l) != BAT_GRID_HULL ||
           bat_hull_grid_says(grid, k + 1, l) != BAT_GRID_HULL ||
           bat_hull_grid_says(grid, k, l - 1) != BAT_GRID_HULL;
}

static batten_status place_data(const bat_hull_grid *grid, double within, bat_loft *loft)
{
    const int lines = grid->line_count;
    loft->data = bat_array3((size_t)grid->station_count, (size_t)lines, sizeof *loft->data);
    if (!loft->data)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < grid->station_count; k++)
        for (int l = 0; l < lines; l++) {
            if (bat_hull_grid_says(grid, k, l) != BAT_GRID_HULL)
                continue;
            bat_loft_datum *d = loft->data + loft->datum_count++;
            *d =
                (bat_loft_datum){.point = {grid->x[k], bat_hull_grid_y(grid, k, l), grid->z[l]},
                                 .within = within,
                                 .in_station = true,
                                 .station = k,
                                 .index = grid->from[k * lines + l]};
            locate(&loft->patch, d->point[0], d->point[2], d);
            d->v = d->v < rounding ? 0 : d->v > 1 - rounding ? 1 : d->v;
            d->on_v_edge = d->v == 0 || d->v == 1 || is_outermost(grid, k, l);
        }
    return BATTEN_OK;
}

batten_status bat_graph_patch(const bat_hull_grid *grid, const bat_graph_frame *f,
                              double within, bat_loft *out)
{
    bat_loft loft = {.within = within, .is_graph = true};
    batten_status status =
        bat_loft_patch_make(f->u_count, f->u_knots, f->v_count, f->v_knots, &loft.patch);
    if (status == BATTEN_OK) {
        loft.held = bat_array3((size_t)f->u_count, (size_t)f->v_count, 3);
        status = loft.held ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK) {
        lay_map(f, &loft);
        status = place_data(grid, within, &loft);
    }
    if (status == BATTEN_OK)
        *out = loft;
    else
        bat_hull_release(&loft);
    return status;
}

/* ---- limits ---- */

static batten_status add_limit(bat_loft *loft, double u, double v)
{
    const bat_loft_limit limit = {u, v, loft->within};
    return BAT_LIST_ADD(loft->limits, loft->limit_count, loft->limit_room, limit);
}

/* Is there hull beside a place of the grid? */
static bool touches_hull(const bat_hull_grid *grid, int k, int l)
{
    return (k > 0 && bat_hull_grid_says(grid, k - 1, l) == BAT_GRID_HULL) ||
           (k + 1 < grid->station_count &&
            bat_hull_grid_says(grid, k + 1, l) == BAT_GRID_HULL) ||
           (l + 1 < grid->line_count && bat_hull_grid_says(grid, k, l + 1) == BAT_GRID_HULL);
}

/* Where the table says that there is no hull the graph is not above the bound. */
batten_status bat_graph_limit_outside(const bat_hull_grid *grid, bat_loft *all)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < grid->station_count; k++)
        for (int l = 0; l < grid->line_count && status == BATTEN_OK; l++) {
            bat_loft_datum d = {0};
            if (bat_hull_grid_says(grid, k, l) != BAT_GRID_OUTSIDE || !touches_hull(grid, k, l))
                continue;
            locate(&all->patch, grid->x[k], grid->z[l], &d);
            status = add_limit(all, d.u, d.v);
        }
    return status;
}
