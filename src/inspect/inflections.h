/* Inflections and extrema of a curve whose control points are only known within `uncertainty`:
 * sign changes that such moves may make or undo are not counted. */
#ifndef BAT_INFLECTIONS_H
#define BAT_INFLECTIONS_H
#include "base/base.h"
#include <batten/curvature.h>

batten_status bat_curve_inflections(const batten_curve *curve, double uncertainty,
                                    batten_parameters *out);
batten_status bat_curve_curvature_extrema(const batten_curve *curve, double uncertainty,
                                          batten_parameters *out);

/* Two rising lists as one, what rounding does not tell apart once; the end of the domain is kept
 * as it is. */
batten_status bat_parameters_merge(const batten_parameters *a, const batten_parameters *b,
                                   batten_interval domain, batten_parameters *out);

#endif
