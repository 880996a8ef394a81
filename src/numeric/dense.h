/*
 * Small dense linear systems, many right sides at once: a[i * columns + j], right sides b[i *
 * width + k].
 */
#ifndef BAT_DENSE_H
#define BAT_DENSE_H
#include "base/base.h"

/* Rows become columns: in [rows][columns][width], out [columns][rows][width], not the same. */
void bat_transpose(int rows, int columns, size_t width, const double *in, double *out);

/* LU in place, pivots chosen against the size of their rows; pivots[n]. SINGULAR_SYSTEM naming
 * the unknown whose pivot is lost in the rounding of the terms that made it, whatever the
 * scales of rows and columns. Cost n^3 / 3. */
batten_status bat_dense_factor(int n, double *a, int *pivots);
/* Solve in place. Cost n^2 width. */
void bat_dense_solve(int n, const double *lu, const int *pivots, size_t width, double *b);

/* Minimise |a x - b| for rows >= columns by Householder reflections; a and b are overwritten,
 * the first `columns` rows of b become x, the norms of the rest are the residuals.
 * SINGULAR_SYSTEM naming the first unknown that depends on those before it; then b is spoilt.
 * Cost 2 rows columns (columns + width). Source: [GVL13] 5.2. */
batten_status bat_dense_least_squares(int rows, int columns, double *a, size_t width,
                                      double *b);

#endif
