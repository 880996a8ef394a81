/* A curve in the parameters of a surface, as a curve in space. */
#ifndef BAT_LIFT_H
#define BAT_LIFT_H
#include "base/base.h"
#include <batten/surface.h>

/*
 * The curve C near S(B(t)), with the domain and the speed of B: |C(t) - S(B(t))| <= tolerance
 * at samples. Where B is a line u = constant or v = constant of a NURBS surface, C is exact.
 *
 * Elsewhere C is made of cubics with the points and derivatives of S(B) at their ends, halved
 * where they are off.
 * @param parameters a plane curve; within the domain of the surface, but for rounding
 * @param[out] error reached at three places of each span; may be NULL
 * @return as batten_surface_evaluate; TOLERANCE_NOT_MET beyond 20,000 spans;
 * BAD_ARGUMENT (tolerance)
 * Cost: four evaluations of the surface for each span.
 */
batten_status bat_lift(const batten_surface *surface, const batten_curve *parameters,
                       double tolerance, batten_curve **out, double *error);

#endif
