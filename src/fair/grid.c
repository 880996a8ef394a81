/* A table of half-breadths on waterlines as a grid of stations and heights, which says where there is
 * hull, where there is none, and where it is silent. */
#include "fair/grid.h"
#include "base/plural.h"
#include "base/sort.h"
#include "numeric/vector.h"

/* A function y(x, z) is bent through fewer points than these by its own energy alone. */
enum { FEWEST_LINES = 4, FEWEST_STATIONS = 4 };

/* Where more than one chord in twenty is flatter than this, y(x, z) is no description of a hull: its
 * bounds then hold y far tighter than the hull. */
static const double flattest = 6, most_flat = 0.05;

/* ---- making ---- */

static bool lies_on_waterline(const batten_offset_table *table,
                              const batten_table_station *station, int i)
{
    const batten_table_point *p = station->points + i;
    const batten_table_line *line =
        p->line >= 0 ? batten_offset_table_line(table, p->line) : NULL;
    return line && line->is_waterline && p->z == line->z && p->x == station->x && p->y >= 0;
}

static bool all_lie_on_waterlines(const batten_offset_table *table)
{
    for (int k = 0; k < batten_offset_table_station_count(table); k++) {
        const batten_table_station *s = batten_offset_table_station(table, k);
        for (int i = 0; i < s->point_count; i++)
            if (!lies_on_waterline(table, s, i))
                return false;
    }
    return true;
}

static int find_line(const bat_hull_grid *grid, double z)
{
    int l = 0;
    while (l < grid->line_count && grid->z[l] < z)
        l++;
    return l;
}

static bool has_hull(const bat_hull_grid *grid, int line)
{
    for (int k = 0; k < grid->station_count; k++)
        if (bat_hull_grid_y(grid, k, line) > 0)
            return true;
    return false;
}

static void place_points(bat_hull_grid *grid)
{
    for (int i = 0; i < grid->station_count * grid->line_count; i++)
        grid->y[i] = NAN;
    for (int k = 0; k < grid->station_count; k++) {
        const batten_table_station *s = batten_offset_table_station(grid->table, k);
        grid->x[k] = s->x;
        for (int i = 0; i < s->point_count; i++) {
            const int at = k * grid->line_count + find_line(grid, s->points[i].z);
            grid->y[at] = s->points[i].y;
            grid->from[at] = i;
        }
    }
}

/* Lines that have nothing of the hull are left out below, but for the highest of them. */
static void drop_empty_lines(bat_hull_grid *grid)
{
    int empty = 0;
    while (empty < grid->line_count && !has_hull(grid, empty))
        empty++;
    const int first = bat_max_int(empty - 1, 0), left = grid->line_count - first;
    for (int k = 0; k < grid->station_count; k++)
        for (int l = 0; l < left; l++) {
            grid->y[k * left + l] = grid->y[k * grid->line_count + first + l];
            grid->from[k * left + l] = grid->from[k * grid->line_count + first + l];
        }
    memmove(grid->z, grid->z + first, (size_t)left * sizeof *grid->z);
    grid->line_count = left;
}

batten_status bat_hull_grid_make(const batten_offset_table *table, bat_hull_grid *out)
{
    *out = (bat_hull_grid){.table = table,
                           .station_count = batten_offset_table_station_count(table)};
    if (!all_lie_on_waterlines(table))
        return BATTEN_OK;
    const size_t lines = (size_t)batten_offset_table_line_count(table),
                 stations = (size_t)out->station_count;
    out->x = bat_arena_array(&out->arena, stations, sizeof *out->x);
    out->z = bat_arena_array(&out->arena, lines, sizeof *out->z);
    out->y = bat_arena_array(&out->arena, stations * lines, sizeof *out->y);
    out->from = bat_arena_array(&out->arena, stations * lines, sizeof *out->from);
    if (!out->x || !out->z || !out->y || !out->from) {
        bat_arena_free(&out->arena);
        return BATTEN_OUT_OF_MEMORY;
    }
    for (size_t l = 0; l < lines; l++)
        if (batten_offset_table_line(table, (int)l)->is_waterline)
            out->z[out->line_count++] = batten_offset_table_line(table, (int)l)->z;
    bat_sort_doubles((size_t)out->line_count, out->z);
    place_points(out);
    drop_empty_lines(out);
    return BATTEN_OK;
}

/* ---- what it says ---- */

/* The lowest line with hull at a station; line_count: none. */
static int lowest_hull(const bat_hull_grid *grid, int station)
{
    int l = 0;
    while (l < grid->line_count && !(bat_hull_grid_y(grid, station, l) > 0))
        l++;
    return l;
}

bat_grid_says bat_hull_grid_says(const bat_hull_grid *grid, int station, int line)
{
    const double y = bat_hull_grid_y(grid, station, line);
    if (y > 0)
        return BAT_GRID_HULL;
    return y == 0 || line < lowest_hull(grid, station) ? BAT_GRID_OUTSIDE : BAT_GRID_SILENT;
}

/* ---- does it contradict itself? ---- */

static bool has_hull_among(const bat_hull_grid *grid, int line, int first, int end)
{
    for (int k = first; k < end; k++)
        if (bat_hull_grid_y(grid, k, line) > 0)
            return true;
    return false;
}

static bool has_hull_above(const bat_hull_grid *grid, int station, int line)
{
    for (int l = line + 1; l < grid->line_count; l++)
        if (bat_hull_grid_y(grid, station, l) > 0)
            return true;
    return false;
}

/* Between a bulb and the stem above it there is no hull up to the end of the waterline; a waterline
 * without any hull between two with hull is none. */
static bool is_amid_hull(const bat_hull_grid *grid, int k, int l)
{
    const bool behind = has_hull_among(grid, l, 0, k),
               before = has_hull_among(grid, l, k + 1, grid->station_count);
    return behind == before &&
           (behind || (lowest_hull(grid, k) < l && has_hull_above(grid, k, l)));
}

batten_status bat_hull_grid_check(const bat_hull_grid *grid)
{
    int count = 0, station = 0, line = 0;
    for (int k = 0; k < grid->station_count; k++)
        for (int l = 0; l < grid->line_count; l++) {
            if (bat_hull_grid_y(grid, k, l) != 0 || !is_amid_hull(grid, k, l))
                continue;
            if (count++ == 0) {
                station = k;
                line = l;
            }
        }
    if (count == 0)
        return BATTEN_OK;
    return bat_fail(
        BATTEN_BAD_ARGUMENT,
        "%s says 0 at z = %g between points of the hull%s: a half-breadth of 0 says "
        "that there is no hull; give %d half-breadth%s, or leave out what is not "
        "known or not of the hull",
        batten_offset_table_label(grid->table, station).text, grid->z[line],
        count > 1 ? ", the first of such places" : "", count, bat_plural(count));
}

/* ---- is it a graph? ---- */

/* The first line of the hull as girths take it: of zeros at the foot the highest. */
static int lowest_point(const bat_hull_grid *grid, int station)
{
    const int low = lowest_hull(grid, station);
    return low > 0 && bat_hull_grid_y(grid, station, low - 1) == 0 ? low - 1 : low;
}

static int highest_point(const bat_hull_grid *grid, int station)
{
    int l = grid->line_count - 1;
    while (l > 0 && isnan(bat_hull_grid_y(grid, station, l)))
        l--;
    return l;
}

static bool has_stairs(const bat_hull_grid *grid)
{
    int low = -1, high = -1;
    for (int k = 0; k < grid->station_count; k++) {
        if (lowest_hull(grid, k) == grid->line_count)
            continue;
        if (low >= 0 && (low != lowest_point(grid, k) || high != highest_point(grid, k)))
            return true;
        low = lowest_point(grid, k);
        high = highest_point(grid, k);
    }
    return false;
}

static bool is_steep(const bat_hull_grid *grid)
{
    int chords = 0, flat = 0;
    for (int k = 0; k < grid->station_count; k++)
        for (int l = 0; l + 1 < grid->line_count; l++) {
            const double low = bat_hull_grid_y(grid, k, l),
                         high = bat_hull_grid_y(grid, k, l + 1);
            if (!(low > 0) || !(high > 0))
                continue;
            chords++;
            flat += fabs(high - low) > flattest * (grid->z[l + 1] - grid->z[l]);
        }
    return chords > 0 && flat <= most_flat * chords;
}

bool bat_hull_grid_is_graph(const bat_hull_grid *grid)
{
    return grid->line_count >= FEWEST_LINES && grid->station_count >= FEWEST_STATIONS &&
           has_stairs(grid) && is_steep(grid);
}
