/* Surfaces that keep the tangent planes of their neighbours, also as the splines they become. */
#ifndef BAT_DESIGN_SMOOTH_H
#define BAT_DESIGN_SMOOTH_H
#include "design/feature.h"
#include <batten/coons.h>

/* The edges of what was asked to be smooth, by batten_edge; NULL: nothing is claimed there. */
typedef struct {
    const char *names[4];
    double within, angle; /* of the spline from the surface; radians along the edges */
    const batten_surface
        *beside[4]; /* the surface that it is to continue there, or NULL; borrowed */
    bool curvature; /* that is continued too */
    bool gives_way; /* more than the angle is noted, and not refused */
} bat_smooth_wish;

/* Hand over the NURBS surface near a surface, measured: its normals along the edges are within
 * the angle of those of the surface. Notes say edge by edge how far it is from the surfaces beside it,
 * or where none is given from its own formula. */
batten_status bat_put_smooth_surface(bat_run *run, batten_status status,
                                     batten_surface *surface, const bat_smooth_wish *wish);

#endif
