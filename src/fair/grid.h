/* A table of half-breadths on waterlines as a grid of stations and heights. */
#ifndef BAT_FAIR_GRID_H
#define BAT_FAIR_GRID_H
#include "base/arena.h"
#include <batten/hull.h>

/* What a table says of a place of its grid. */
typedef enum {
    BAT_GRID_SILENT, /* nothing: above the hull, or a gap */
    BAT_GRID_HULL,   /* a half-breadth above 0 */
    BAT_GRID_OUTSIDE /* there is no hull: a half-breadth of 0, or none below the hull */
} bat_grid_says;

typedef struct {
    const batten_offset_table *table;
    bat_arena arena;
    int station_count, line_count;
    double *x; /* [stations] */
    double *z; /* [lines], increasing: from the highest that is below all of the hull */
    double *y; /* [stations][lines]; NAN where there is no point */
    int *from; /* [stations][lines]: which point of its station */
} bat_hull_grid;

/* Release its arena; without points on waterlines alone line_count is 0. */
batten_status bat_hull_grid_make(const batten_offset_table *table, bat_hull_grid *out);

/* Is the hull better described as y(x, z) over stations and waterlines than by girths? Its points
 * are on waterlines alone, its lowest or highest points would make stairs of its profile or
 * sheer, and nearly nowhere it is flatter than such a function can be. */
bool bat_hull_grid_is_graph(const bat_hull_grid *grid);

bat_grid_says bat_hull_grid_says(const bat_hull_grid *grid, int station, int line);

/* BAD_ARGUMENT when a half-breadth of 0 has hull both before and behind it on its waterline; or, on a
 * waterline without hull, both below and above it in its station. */
batten_status bat_hull_grid_check(const bat_hull_grid *grid);

static inline double bat_hull_grid_y(const bat_hull_grid *grid, int station, int line)
{
    return grid->y[station * grid->line_count + line];
}

#endif
