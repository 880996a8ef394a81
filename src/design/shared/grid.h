/* Grids of points, as the features that make surfaces of them take them from their input. */
#ifndef BAT_DESIGN_GRID_H
#define BAT_DESIGN_GRID_H
#include "design/shared/rows.h"

/* u runs along the rows of the input, v across them. */
typedef struct {
    int count_u, count_v;
    double *points; /* [count_u][count_v][3] */
} bat_grid;

/* The grid of all points objects and tables of an argument, row after row; every row must have
 * as many points as the first. */
batten_status bat_grid_of(const bat_run *run, const char *parameter, bat_grid *out);
void bat_grid_release(bat_grid *grid);

/* What `make` makes of the grid of an argument becomes the feature's surface. */
batten_status bat_grid_surface(bat_run *run, const char *parameter,
                               batten_status (*make)(bat_run *run, const bat_grid *grid,
                                                     batten_surface **out));

#endif
