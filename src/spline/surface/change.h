/*
 * Changes of NURBS surfaces along one direction, written once for both: a surface is a spline
 * whose rows hold a whole line of the net across that direction.
 */
#ifndef BAT_SURFACE_CHANGE_H
#define BAT_SURFACE_CHANGE_H
#include "spline/surface/surface.h"

/* The surface as a spline along `direction`. A periodic direction becomes clamped. */
batten_status bat_nurbs_to_spline(const bat_nurbs *nurbs, batten_direction direction,
                                  bat_spline *out);

/* Make a spline from a spline. */
typedef batten_status (*bat_spline_change)(const bat_spline *spline, void *context,
                                           bat_spline *out);
/* The surface changed along `direction`. */
batten_status bat_nurbs_change(const batten_surface *surface, batten_direction direction,
                               bat_spline_change change, void *context, batten_surface **out);

/* A copy with the same knots, points and weights, to be edited before bat_nurbs_finish;
 * `rational` adds weights 1. */
batten_status bat_nurbs_copy(const bat_nurbs *nurbs, bool rational, bat_nurbs **out);
/* One control point and its weight from one surface into another, rational if the other is. */
static inline void bat_nurbs_copy_point(const bat_nurbs *from, int at, bat_nurbs *to, int place)
{
    const size_t d = (size_t)from->base.dimension;
    memcpy(to->points + (size_t)place * d, from->points + (size_t)at * d,
           d * sizeof *to->points);
    if (from->weights)
        to->weights[place] = from->weights[at];
}

#endif
