/*
 * Banded linear systems, many right sides at once.
 *
 * A band matrix of n rows keeps, for row i, the columns i - lower .. i + upper in
 * a[i * (lower + upper + 1) + (j - i + lower)]. Right sides and solutions are rows of `width`
 * numbers: b[i * width + k]. No pivoting: for totally positive, diagonally dominant and
 * definite matrices, which are those of spline interpolation and fairing.
 */
#ifndef BAT_BANDED_H
#define BAT_BANDED_H
#include "base/base.h"

/* LU in place. SINGULAR_SYSTEM naming the row when a pivot is 0 or tiny against its row. */
batten_status bat_banded_factor(int n, int lower, int upper, double *a);
/* Solve in place. Cost n (lower + upper) width. */
void bat_banded_solve(int n, int lower, int upper, const double *lu, size_t width, double *b);

/* The same for matrices whose band wraps around: column j of row i is taken modulo n. A
 * factorisation owns memory of its own (the border). */
typedef struct bat_cyclic bat_cyclic;
batten_status bat_cyclic_factor(int n, int lower, int upper, const double *a, bat_cyclic **out);
batten_status bat_cyclic_solve(const bat_cyclic *factor, size_t width, double *b);
void bat_cyclic_free(bat_cyclic *factor);

/* Symmetric positive definite: only the lower half, a[i * (lower + 1) + (j - i + lower)], j <=
 * i; L D Lt in place. */
batten_status bat_symmetric_factor(int n, int lower, double *a);
void bat_symmetric_solve(int n, int lower, const double *ldl, size_t width, double *b);

#endif
