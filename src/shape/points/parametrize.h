/* Parameters of points along a curve, from the chords between them or as given. */
#ifndef BAT_PARAMETRIZE_H
#define BAT_PARAMETRIZE_H
#include "base/base.h"
#include <batten/interpolate.h>

/* The steps between the parameters of checked points, 0 where points coincide; [count - 1],
 * closed [count]. */
void bat_steps(batten_points points, batten_parametrization kind, bool closed, double *steps);
/* batten_parametrize for checked points; on failure `parameters` is spoilt. */
batten_status bat_parametrize(batten_points points, batten_parametrization kind, bool closed,
                              double *parameters);
/* The same with steps that are chords to the power alpha, 0 to 1. */
batten_status bat_parametrize_power(batten_points points, double alpha, bool closed,
                                    double *parameters);

/* The parameters of points by a kind or as given, in *out [count], closed [count + 1]; release
 * them, after a failure too. */
batten_status bat_parameters_of(batten_points points, batten_parametrization kind,
                                const double *given, bool closed, double **out);

#endif
