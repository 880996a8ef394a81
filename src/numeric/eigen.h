/* Eigenvalues of small symmetric matrices. */
#ifndef BAT_EIGEN_H
#define BAT_EIGEN_H
#include "base/base.h"

/* a [n][n] symmetric, spoilt; values [n] rising; vectors [n][n], row i that of value i, square
 * to each other and of length one. Every value is right to a few units of the last place of the
 * largest. Source: [GVL13] 8.5, Jacobi. */
void bat_eigen_symmetric(int n, double *a, double *values, double *vectors);

#endif
