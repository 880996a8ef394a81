/* The parts of surface offsets. */
#ifndef BAT_SURFACE_OFFSET_H
#define BAT_SURFACE_OFFSET_H
#include "spline/surface/surface.h"
#include <batten/offset.h>

/* The jets of the unit normal of a NURBS surface from its derivatives up to order 4, at
 * collapsed edges 5 (offset_normal.c). `out` [BATTEN_SURFACE_DERIVATIVES(order)][3]:
 * S + distance n and its derivatives, order <= 3. SINGULAR_HERE without a normal. */
batten_status bat_offset_point(const batten_surface *surface, double distance,
                               const bat_surface_place *at, int order, double *out);

/* The curvatures and the factor of the report (offset_curvature.c). */
batten_status bat_offset_curvatures(const batten_surface *surface, double distance,
                                    batten_surface_offset_report *report);

/* The offset with the knots and weights of the clamped surface, if there is one
 * (offset_exact.c); else *out stays NULL. */
batten_status bat_offset_exact(const batten_surface *surface, double distance,
                               batten_surface **out);

#endif
