/* The matrix of the equations of an interpolation: banded, or banded with the corners of a period. */
#ifndef BAT_LINEAR_LINEAR_MATRIX_H
#define BAT_LINEAR_LINEAR_MATRIX_H
#include "shape/linear/linear_system.h"

batten_status bat_linear_matrix_make(const bat_request *r, bat_operator *op);

#endif
