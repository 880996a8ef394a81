/* Rims of a grid that are one point. */
#ifndef BAT_GRID_POLES_H
#define BAT_GRID_POLES_H
#include "base/base.h"
#include <batten/geometry.h>

/* When all data of a rim, that at the start or end of direction 0 (u) or 1, are one point, so
 * are, but for rounding, all its control points: make them it. */
void bat_keep_pole(batten_grid data, const int control_count[2], double *control, int direction,
                   bool at_start);

#endif
