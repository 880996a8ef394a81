/* A surface on its way across an edge: tangent plane, curvature and its rate square to the edge. */
#ifndef BAT_ACROSS_H
#define BAT_ACROSS_H
#include "base/base.h"
#include <batten/surface.h>

typedef struct {
    batten_vec3 into;      /* a unit vector in the tangent plane, square to the edge */
    batten_vec3 normal;    /* along Su x Sv */
    batten_vec3 curvature; /* of the section square to the edge, 1 / length */
    batten_vec3 rate;      /* of its curvature along the way in, 1 / length^2 */
} bat_across;

/* From the derivatives [BATTEN_SURFACE_DERIVATIVES(3)][dimension] of a surface, the direction of the edge, and a
 * direction to the side on which the surface lies. False where the surface is singular. */
bool bat_across_edge(int dimension, const double *derivatives, batten_vec3 along,
                     batten_vec3 inward, bat_across *out);

#endif
