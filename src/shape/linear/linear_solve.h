/* The control values that a linear operator of interpolation makes of data. */
#ifndef BAT_LINEAR_SOLVE_H
#define BAT_LINEAR_SOLVE_H
#include "shape/linear/linear_system.h"

/* What an operator is applied to, in rows of `width` numbers. */
typedef struct {
    size_t width;
    const double *data; /* [data_count][width] */
    const double *start,
        *end; /* [width] what the ends CLAMPED and SECOND ask for; NULL: zeros */
    const double *conditions; /* [condition_count][width], or NULL */
} bat_spline_data;

/* Control values [count][width]. The result is checked against the data: TOLERANCE_NOT_MET when
 * a value is missed by more than 8 eps of the largest number. */
batten_status bat_operator_apply(const bat_operator *op, const bat_spline_data *given,
                                 double *control);

/* The slope at the first of three points of their parabola; h: how far they are apart. */
void bat_bessel_slope(size_t width, const double h[2], const double *const points[3],
                      double *slope);

#endif
