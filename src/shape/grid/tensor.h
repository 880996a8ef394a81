/* What the surfaces through a grid share. */
#ifndef BAT_TENSOR_H
#define BAT_TENSOR_H
#include "base/base.h"
#include <batten/grid.h>

/* A grid of finite points, 2 x 2 at least, 3 along a closed direction. */
batten_status bat_grid_check(int dimension, int count_u, int count_v, const double *points,
                             bool closed_u, bool closed_v);

/* The parameters of the lines of a grid, given or found; release both, also after a failure. */
typedef struct {
    double *u, *v;    /* [count], closed [count + 1] */
    double spread[2]; /* as batten_grid_parametrize says */
} bat_grid_parameters;
batten_status bat_grid_parameters_of(batten_grid points, batten_parametrization kind,
                                     const bool closed[2], const double *const given[2],
                                     bat_grid_parameters *out);
void bat_grid_parameters_release(bat_grid_parameters *parameters);

/* Say which line of the grid the last failure is about: "along u, line 3: ...". */
batten_status bat_line_fails(batten_status status, const char *direction, int line);

#endif
