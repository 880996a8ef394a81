/* Rims of grids that are single points. */
#include "shape/points/grid_poles.h"

#include <string.h>

/* Where the rim of direction k begins in a net, how many points it has and how far they are
 * apart, in points. */
static size_t rim_of(const int count[2], int k, bool at_start, size_t *points, size_t *step)
{
    const size_t nv = (size_t)count[1];
    *points = (size_t)count[1 - k];
    *step = k == 0 ? 1 : nv;
    if (at_start)
        return 0;
    return k == 0 ? (size_t)(count[0] - 1) * nv : nv - 1;
}

void bat_keep_pole(batten_grid data, const int control_count[2], double *control, int direction,
                   bool at_start)
{
    const int data_count[2] = {data.count_u, data.count_v};
    const size_t d = (size_t)data.dimension;
    size_t points, step;
    const double *pole = data.at + rim_of(data_count, direction, at_start, &points, &step) * d;
    for (size_t i = 1; i < points; i++)
        for (size_t k = 0; k < d; k++)
            if (pole[i * step * d + k] != pole[k])
                return;
    double *rim = control + rim_of(control_count, direction, at_start, &points, &step) * d;
    for (size_t i = 0; i < points; i++)
        memcpy(rim + i * step * d, pole, d * sizeof *rim);
}
