/* Surfaces that keep the tangent planes of their neighbours, also as the splines they become. */
#ifndef BAT_DESIGN_SMOOTH_H
#define BAT_DESIGN_SMOOTH_H
#include "design/feature.h"

/* The edges of what was asked to be smooth, by batten_edge; NULL: nothing is claimed there. */
typedef struct {
    const char *names[4];
    double within, angle; /* of the spline from the surface; radians along the edges */
} bat_smooth_wish;

/* Hand over the NURBS surface near a surface, measured: its normals along the edges are within
 * the angle of those of the surface, and a remark says how near, edge by edge. */
batten_status bat_put_smooth_surface(bat_run *run, batten_status status,
                                     batten_surface *surface, const bat_smooth_wish *wish);

#endif
