/* The parts of surface extensions. All work at the end of v; the caller turns the surface. */
#ifndef BAT_SURFACE_EXTEND_H
#define BAT_SURFACE_EXTEND_H
#include "spline/surface/surface.h"
#include <batten/extend.h>

/* Straight on until v = end + way; exact. */
batten_status bat_surface_straight_on(const batten_surface *surface, double way,
                                      batten_surface **out);
/* The last patches until v = end + way; exact. BAD_WEIGHT where that is too far. */
batten_status bat_surface_go_on(const batten_surface *surface, double way,
                                batten_surface **out);
/* Along circles, within the tolerance (extend_arc.c). */
batten_status bat_surface_arc_on(const batten_surface *surface, double way, double tolerance,
                                 double *error, batten_surface **out);

#endif
