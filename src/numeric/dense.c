/*
 * Small dense linear systems: LU with scaled partial pivoting, and least squares by Householder
 * reflections. Source: [GVL13] 5.2 for the latter.
 */
#include "numeric/dense.h"

#include <float.h>

#include <string.h>

void bat_transpose(int rows, int columns, size_t width, const double *in, double *out)
{
    const size_t stride = (size_t)rows * width;
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++, in += width)
            memcpy(out + (size_t)j * stride + (size_t)i * width, in, width * sizeof *out);
}

static void swap_rows(size_t width, double *a, double *b)
{
    for (size_t k = 0; k < width; k++) {
        const double kept = a[k];
        a[k] = b[k];
        b[k] = kept;
    }
}

/* Column k of L and U from the columns before it; the row whose pivot is largest against its
 * row as it was given, and the size of the terms that this pivot was summed from. */
static int eliminate_column(int n, int k, double *a, const double *sizes, double *terms)
{
    int best = k;
    double largest = -1;
    for (int i = 0; i < n; i++) {
        double *row = a + (size_t)i * (size_t)n;
        double sum = row[k], size = fabs(sum);
        for (int j = 0; j < bat_min_int(i, k); j++) {
            const double term = row[j] * a[(size_t)j * (size_t)n + (size_t)k];
            sum -= term;
            size += fabs(term);
        }
        row[k] = sum;
        if (i >= k && fabs(sum) / sizes[i] > largest) {
            best = i;
            largest = fabs(sum) / sizes[i];
            *terms = size;
        }
    }
    return best;
}

static batten_status factor(int n, double *a, double *sizes, int *pivots)
{
    for (int k = 0; k < n; k++) {
        double terms = 0;
        const int best = eliminate_column(n, k, a, sizes, &terms);
        const double pivot = a[(size_t)best * (size_t)n + (size_t)k];
        /* Each of at most n terms was rounded once, from factors rounded before. */
        if (!(fabs(pivot) > 2 * n * DBL_EPSILON * terms) || !isfinite(pivot))
            return bat_fail(BATTEN_SINGULAR_SYSTEM,
                            "the pivot of unknown %d of %d is %g, summed from terms of size %g",
                            k + 1, n, pivot, terms);
        pivots[k] = best;
        if (best != k) {
            swap_rows((size_t)n, a + (size_t)k * (size_t)n, a + (size_t)best * (size_t)n);
            swap_rows(1, sizes + k, sizes + best);
        }
        for (int i = k + 1; i < n; i++)
            a[(size_t)i * (size_t)n + (size_t)k] /= pivot;
    }
    return BATTEN_OK;
}

batten_status bat_dense_factor(int n, double *a, int *pivots)
{
    double *sizes = bat_array((size_t)n, sizeof *sizes);
    if (!sizes)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            sizes[i] = bat_max(sizes[i], fabs(a[(size_t)i * (size_t)n + (size_t)j]));
    const batten_status status = factor(n, a, sizes, pivots);
    bat_release(sizes);
    return status;
}

static void subtract(size_t width, double factor, const double *from, double *row)
{
    for (size_t k = 0; k < width; k++)
        row[k] -= factor * from[k];
}

/* x from U x = b, U[i * stride + j]. */
static void solve_upper(int n, int stride, const double *u, size_t width, double *b)
{
    for (int i = n - 1; i >= 0; i--) {
        const double *row = u + (size_t)i * (size_t)stride;
        for (int j = i + 1; j < n; j++)
            subtract(width, row[j], b + (size_t)j * width, b + (size_t)i * width);
        for (size_t k = 0; k < width; k++)
            b[(size_t)i * width + k] /= row[i];
    }
}

void bat_dense_solve(int n, const double *lu, const int *pivots, size_t width, double *b)
{
    for (int i = 0; i < n; i++)
        if (pivots[i] != i)
            swap_rows(width, b + (size_t)i * width, b + (size_t)pivots[i] * width);
    for (int i = 1; i < n; i++)
        for (int j = 0; j < i; j++)
            subtract(width, lu[(size_t)i * (size_t)n + (size_t)j], b + (size_t)j * width,
                     b + (size_t)i * width);
    solve_upper(n, n, lu, width, b);
}

/* column -= v (2 v.column / v.v), both from row `first` on; `vv` is v.v. */
static void reflect(int rows, int first, size_t v_stride, const double *v, double vv,
                    size_t stride, double *column)
{
    double dot = 0;
    for (int i = first; i < rows; i++)
        dot += v[(size_t)i * v_stride] * column[(size_t)i * stride];
    const double factor = 2 * (dot / vv);
    for (int i = first; i < rows; i++)
        column[(size_t)i * stride] -= factor * v[(size_t)i * v_stride];
}

/* The Euclidean norm of column k from row `first` on, whatever its size. */
static double column_norm(int rows, size_t stride, int first, const double *column)
{
    double norm = 0;
    for (int i = first; i < rows; i++)
        norm = bat_hypot(norm, column[(size_t)i * stride]);
    return norm;
}

/* Turn column k into Householder's vector, scaled so that its square `*vv` lies between 1 and
 * 4; the new diagonal element, which is 0 when there is nothing to reflect. */
static double householder(int rows, size_t stride, int k, double *column, double *vv)
{
    double *top = column + (size_t)k * stride;
    const double norm = column_norm(rows, stride, k, column);
    const double diagonal = *top > 0 ? -norm : norm;
    *top -= diagonal;
    *vv = 0;
    for (int i = k; i < rows && norm > 0; i++) {
        column[(size_t)i * stride] /= norm;
        *vv += column[(size_t)i * stride] * column[(size_t)i * stride];
    }
    return diagonal;
}

batten_status bat_dense_least_squares(int rows, int columns, double *a, size_t width, double *b)
{
    assert(rows >= columns);
    const size_t stride = (size_t)columns;
    for (int k = 0; k < columns; k++) {
        double *column = a + k;
        /* Reflections keep the norm, so this is that of the column as it was given. */
        const double whole = column_norm(rows, stride, 0, column);
        double vv;
        const double diagonal = householder(rows, stride, k, column, &vv);
        if (!(fabs(diagonal) > rows * DBL_EPSILON * whole) || !isfinite(diagonal))
            return bat_fail(BATTEN_SINGULAR_SYSTEM,
                            "unknown %d of %d depends on those before it: %g of its %g is left",
                            k + 1, columns, fabs(diagonal), whole);
        for (int j = k + 1; j < columns; j++)
            reflect(rows, k, stride, column, vv, stride, a + j);
        for (size_t j = 0; j < width; j++)
            reflect(rows, k, stride, column, vv, width, b + j);
        column[(size_t)k * stride] = diagonal;
    }
    solve_upper(columns, columns, a, width, b);
    return BATTEN_OK;
}
