/* Checks of points and parameters as callers give them, shared by all that takes them. */
#ifndef BAT_DATA_CHECK_H
#define BAT_DATA_CHECK_H
#include "base/base.h"

#include <batten/geometry.h>

/* Points of 1..3 finite coordinates, at least `least` of them. */
batten_status bat_points_check(int dimension, int count, const double *points, int least);
/* Finite and increasing. */
batten_status bat_parameters_check(int count, const double *parameters);
/* The failure of points whose dimension is not `expected`. */
batten_status bat_wrong_dimension(batten_points points, int expected);

#endif
