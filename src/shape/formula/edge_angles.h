/* The angles between the normals of two surfaces over the same domain, along its edges. */
#ifndef BAT_EDGE_ANGLES_H
#define BAT_EDGE_ANGLES_H
#include "spline/surface/surface.h"
#include <batten/coons.h>

/* The largest one inside an interval of the edge's parameter, at 32 places that are denser
 * towards its ends; places where one surface has no normal do not count. */
batten_status bat_edge_angle(const batten_surface *a, const batten_surface *b,
                             batten_edge edge, batten_interval between, double *largest);

#endif
