/* Smoothing splines at their limits: a polynomial without roughness, and the interpolant. */
#ifndef BAT_NEAR_SMOOTH_LIMITS_H
#define BAT_NEAR_SMOOTH_LIMITS_H
#include "shape/near/smooth.h"

/* Data that count and parameters that differ; of a ring the last is not the first again. */
int bat_differing(const bat_smoothing *t, double *at);
/* lambda = infinity: a polynomial. */
batten_status bat_smooth_polynomial(bat_smoothing *t);
/* lambda = 0: the natural spline through the means. */
batten_status bat_smooth_interpolant(bat_smoothing *t);

#endif
