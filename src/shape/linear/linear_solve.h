/* The control values that a linear operator of interpolation makes of data. */
#ifndef BAT_LINEAR_SOLVE_H
#define BAT_LINEAR_SOLVE_H
#include "shape/linear/linear_system.h"

/*
 * Control values [count][width] from data [data_count][width], the values that the ends CLAMPED
 * and SECOND ask for
 * ([width] each; NULL for zeros) and those of the conditions [condition_count][width]. The
 * result is checked against the data: TOLERANCE_NOT_MET when a value is missed by more than 8
 * eps of the largest number.
 */
batten_status bat_operator_apply(const bat_operator *op, size_t width, const double *data,
                                 const double *start, const double *end,
                                 const double *conditions, double *control);

/* The slope at a of the parabola through a, b, c that are h0 and h1 apart. */
void bat_bessel_slope(size_t width, double h0, double h1, const double *a, const double *b,
                      const double *c, double *slope);

#endif
