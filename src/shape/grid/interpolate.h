/* The options of surfaces through grids. */
#ifndef BAT_INTERPOLATE_GRID_H
#define BAT_INTERPOLATE_GRID_H
#include "base/base.h"
#include <batten/interpolate.h>

#include <batten/grid.h>

/* How many derivatives the rims give. */
static inline int bat_orders_u(const batten_surface_interpolate_options *o)
{
    return bat_max_int(1, o->orders_u);
}

static inline int bat_orders_v(const batten_surface_interpolate_options *o)
{
    return bat_max_int(1, o->orders_v);
}

/* Do they make sense for a grid of this size? */
batten_status bat_grid_options_check(const batten_surface_interpolate_options *options,
                                     int dimension, int count_u, int count_v);

#endif
