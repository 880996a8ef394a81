/* How far a face reaches along the axes. */
#ifndef BAT_BODY_EXTENT_H
#define BAT_BODY_EXTENT_H
#include "inspect/extent/surface_extent.h"
#include <batten/body.h>

/* Join the edges of a body, as far as each coordinate goes. Of what cannot be followed here and
 * below, the box of the control points counts as not reached. */
batten_status bat_edges_extent(const batten_body_parts *parts, bat_extent *extent);
/* Join a face of a body that is traced, whose edges are joined already. */
batten_status bat_face_extent(const batten_body_parts *parts, int face, double tolerance,
                              bat_extent *extent);

#endif
