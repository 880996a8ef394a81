/*
 * Banded systems without pivoting: LU, LU of cyclic matrices by bordering, and LDL^T of
 * symmetric ones, each for many right sides.
 */
#include "numeric/banded.h"
#include "numeric/dense.h"

#include <float.h>

#define ALWAYS_INLINE static inline __attribute__((always_inline))

/* ---- LU ---- */

static double largest(int count, const double *row)
{
    double size = 0;
    for (int j = 0; j < count; j++)
        size = bat_max(size, fabs(row[j]));
    return size;
}

/* Subtract from row i what its columns left of the diagonal have of the rows above. The size of
 * the terms that the pivot was made of. */
ALWAYS_INLINE double eliminate_row(int n, int lower, int upper, double *a, int i)
{
    const size_t w = (size_t)(lower + upper + 1);
    double *row = a + (size_t)i * w + lower - i; /* row[j] is column j */
    double terms = fabs(row[i]);
    for (int k = bat_max_int(0, i - lower); k < i; k++) {
        const double *above = a + (size_t)k * w + lower - k;
        const int last = bat_min_int(n - 1, k + upper);
        row[k] /= above[k];
        for (int j = k + 1; j <= last; j++)
            row[j] -= row[k] * above[j];
        if (i <= last)
            terms += fabs(row[k] * above[i]);
    }
    return terms;
}

ALWAYS_INLINE batten_status factor(int n, int lower, int upper, double *a)
{
    const size_t w = (size_t)(lower + upper + 1);
    for (int i = 0; i < n; i++) {
        double *row = a + (size_t)i * w;
        const int first = bat_max_int(0, lower - i),
                  last = bat_min_int(lower + upper, n - 1 - i + lower);
        const double size = largest(last - first + 1, row + first);
        const double terms = bat_max(size, eliminate_row(n, lower, upper, a, i));
        const double pivot = row[lower];
        /* Each of the lower + 1 terms of the pivot was rounded twice. */
        if (!(fabs(pivot) > 2 * (lower + 1) * DBL_EPSILON * terms) || !isfinite(pivot))
            return bat_fail(BATTEN_SINGULAR_SYSTEM,
                            "the pivot of row %d of %d is %g in a row of size %g", i + 1, n,
                            pivot, terms);
    }
    return BATTEN_OK;
}

batten_status bat_banded_factor(int n, int lower, int upper, double *a)
{
    if (lower == 1 && upper == 1)
        return factor(n, 1, 1, a);
    if (lower == 2 && upper == 2)
        return factor(n, 2, 2, a);
    return factor(n, lower, upper, a);
}

ALWAYS_INLINE void subtract(size_t width, double factor, const double *from, double *row)
{
    for (size_t k = 0; k < width; k++)
        row[k] -= factor * from[k];
}

ALWAYS_INLINE void solve(int n, int lower, int upper, const double *lu, size_t width, double *b)
{
    const size_t w = (size_t)(lower + upper + 1);
    for (int i = 1; i < n; i++) {
        const double *row = lu + (size_t)i * w + lower - i;
        for (int k = bat_max_int(0, i - lower); k < i; k++)
            subtract(width, row[k], b + (size_t)k * width, b + (size_t)i * width);
    }
    for (int i = n - 1; i >= 0; i--) {
        const double *row = lu + (size_t)i * w + lower - i;
        for (int j = i + 1; j <= bat_min_int(n - 1, i + upper); j++)
            subtract(width, row[j], b + (size_t)j * width, b + (size_t)i * width);
        for (size_t k = 0; k < width; k++)
            b[(size_t)i * width + k] /= row[i];
    }
}

/* The widths of numbers and of points get loops of their own. */
ALWAYS_INLINE void solve_width(int n, int lower, int upper, const double *lu, size_t width,
                               double *b)
{
    if (width == 1)
        solve(n, lower, upper, lu, 1, b);
    else if (width == 3)
        solve(n, lower, upper, lu, 3, b);
    else
        solve(n, lower, upper, lu, width, b);
}

void bat_banded_solve(int n, int lower, int upper, const double *lu, size_t width, double *b)
{
    if (lower == 1 && upper == 1)
        solve_width(n, 1, 1, lu, width, b);
    else if (lower == 2 && upper == 2)
        solve_width(n, 2, 2, lu, width, b);
    else
        solve_width(n, lower, upper, lu, width, b);
}

/* ---- cyclic ---- */

/*
 * The last s = max(lower, upper) rows and columns are a border around a band matrix B that does
 * not wrap:
 *
 *     | B  E | | x |   | b |      Z = B^-1 E,   S = G - F Z
 *     | F  G | | y | = | c |      y = S^-1 (c - F B^-1 b),   x = B^-1 b - Z y
 *
 * When the band meets itself, n < lower + upper + 1, everything is border: m = 0, s = n.
 */
struct bat_cyclic {
    int n, lower, upper;
    int m, s;
    double *band;  /* [m][lower + upper + 1], B factored */
    double *z;     /* [m][s] */
    double *rows;  /* [s][lower + upper + 1]: F and G as given */
    double *schur; /* [s][s], S factored */
    int *pivots;   /* [s] */
};

static int wrapped(int j, int n)
{
    const int rest = j % n;
    return rest < 0 ? rest + n : rest;
}

/* Where B ends the band is cut; what wraps or lies in the last columns goes to E. */
static void split_rows(bat_cyclic *f, const double *a)
{
    const int w = f->lower + f->upper + 1;
    for (int i = 0; i < f->m; i++)
        for (int k = 0; k < w; k++) {
            const int j = i + k - f->lower;
            const double value = a[(size_t)i * (size_t)w + (size_t)k];
            if (j >= 0 && j < f->m)
                f->band[(size_t)i * (size_t)w + (size_t)k] = value;
            else
                f->z[(size_t)i * (size_t)f->s + (size_t)(wrapped(j, f->n) - f->m)] += value;
        }
    for (size_t i = 0; i < (size_t)f->s * (size_t)w; i++)
        f->rows[i] = a[(size_t)f->m * (size_t)w + i];
}

/* c -= F x for the rows of the border. */
static void subtract_border(const bat_cyclic *f, size_t width, const double *x, double *c)
{
    const int w = f->lower + f->upper + 1;
    for (int i = 0; i < f->s; i++)
        for (int k = 0; k < w; k++) {
            const int j = wrapped(f->m + i + k - f->lower, f->n);
            if (j < f->m)
                subtract(width, f->rows[i * w + k], x + (size_t)j * width,
                         c + (size_t)i * width);
        }
}

static batten_status factor_border(bat_cyclic *f)
{
    const int w = f->lower + f->upper + 1;
    for (int i = 0; i < f->s; i++)
        for (int k = 0; k < w; k++) {
            const int j = wrapped(f->m + i + k - f->lower, f->n);
            if (j >= f->m)
                f->schur[i * f->s + j - f->m] += f->rows[i * w + k];
        }
    subtract_border(f, (size_t)f->s, f->z, f->schur);
    return bat_dense_factor(f->s, f->schur, f->pivots);
}

static batten_status allocate(int n, int lower, int upper, bat_cyclic **out)
{
    bat_cyclic *f = bat_array(1, sizeof *f);
    if (!f)
        return BATTEN_OUT_OF_MEMORY;
    const int s = n < lower + upper + 1 ? n : bat_max_int(lower, upper);
    const size_t w = (size_t)(lower + upper + 1), m = (size_t)(n - s);
    f->n = n, f->lower = lower, f->upper = upper, f->m = n - s, f->s = s;
    f->band = bat_array3(m, w, sizeof *f->band);
    f->z = bat_array3(m, (size_t)s, sizeof *f->z);
    f->rows = bat_array3((size_t)s, w, sizeof *f->rows);
    f->schur = bat_array3((size_t)s, (size_t)s, sizeof *f->schur);
    f->pivots = bat_array((size_t)s, sizeof *f->pivots);
    *out = f;
    return f->band && f->z && f->rows && f->schur && f->pivots ? BATTEN_OK
                                                               : BATTEN_OUT_OF_MEMORY;
}

batten_status bat_cyclic_factor(int n, int lower, int upper, const double *a, bat_cyclic **out)
{
    bat_cyclic *f = NULL;
    batten_status status = allocate(n, lower, upper, &f);
    if (status == BATTEN_OK) {
        split_rows(f, a);
        status = bat_banded_factor(f->m, lower, upper, f->band);
    }
    if (status == BATTEN_OK) {
        bat_banded_solve(f->m, lower, upper, f->band, (size_t)f->s, f->z);
        status = factor_border(f);
    }
    if (status == BATTEN_OK)
        *out = f;
    else
        bat_cyclic_free(f);
    return status;
}

batten_status bat_cyclic_solve(const bat_cyclic *f, size_t width, double *b)
{
    double *c = b + (size_t)f->m * width;
    bat_banded_solve(f->m, f->lower, f->upper, f->band, width, b);
    subtract_border(f, width, b, c);
    bat_dense_solve(f->s, f->schur, f->pivots, width, c);
    for (int i = 0; i < f->m; i++)
        for (int k = 0; k < f->s; k++)
            subtract(width, f->z[(size_t)i * (size_t)f->s + (size_t)k], c + (size_t)k * width,
                     b + (size_t)i * width);
    return BATTEN_OK;
}

void bat_cyclic_free(bat_cyclic *f)
{
    if (!f)
        return;
    bat_release(f->band);
    bat_release(f->z);
    bat_release(f->rows);
    bat_release(f->schur);
    bat_release(f->pivots);
    bat_release(f);
}

/* ---- symmetric ---- */

/* Row i of L D, then of L; its pivot stays on the diagonal. */
static void symmetric_row(int lower, double *a, int i)
{
    const size_t w = (size_t)(lower + 1);
    double *row = a + (size_t)i * w + lower - i;
    const int first = bat_max_int(0, i - lower);
    for (int j = first; j < i; j++) {
        const double *above = a + (size_t)j * w + lower - j;
        for (int k = bat_max_int(first, j - lower); k < j; k++)
            row[j] -= row[k] * above[k];
    }
    for (int j = first; j < i; j++) {
        const double scaled = row[j] / a[(size_t)j * w + (size_t)lower];
        row[i] -= row[j] * scaled;
        row[j] = scaled;
    }
}

batten_status bat_symmetric_factor(int n, int lower, double *a)
{
    const size_t w = (size_t)(lower + 1);
    for (int i = 0; i < n; i++) {
        double *pivot = a + (size_t)i * w + lower;
        const double size = fabs(*pivot);
        symmetric_row(lower, a, i);
        /* The terms of a definite matrix's pivot add up to its diagonal element: each is
         * rounded once. */
        if (!(*pivot > (lower + 1) * DBL_EPSILON * size) || !isfinite(*pivot))
            return bat_fail(
                BATTEN_SINGULAR_SYSTEM,
                "row %d of %d of a symmetric matrix leaves the pivot %g of its diagonal %g",
                i + 1, n, *pivot, size);
    }
    return BATTEN_OK;
}

ALWAYS_INLINE void symmetric_solve(int n, int lower, const double *ldl, size_t width, double *b)
{
    const size_t w = (size_t)(lower + 1);
    for (int i = 0; i < n; i++) {
        const double *row = ldl + (size_t)i * w + lower - i;
        for (int k = bat_max_int(0, i - lower); k < i; k++)
            subtract(width, row[k], b + (size_t)k * width, b + (size_t)i * width);
    }
    for (int i = n - 1; i >= 0; i--) {
        const double *row = ldl + (size_t)i * w + lower - i;
        for (size_t k = 0; k < width; k++)
            b[(size_t)i * width + k] /= row[i];
        for (int j = i + 1; j <= bat_min_int(n - 1, i + lower); j++)
            subtract(width, ldl[(size_t)j * w + (size_t)(lower + i - j)], b + (size_t)j * width,
                     b + (size_t)i * width);
    }
}

void bat_symmetric_solve(int n, int lower, const double *ldl, size_t width, double *b)
{
    if (width == 1)
        symmetric_solve(n, lower, ldl, 1, b);
    else if (width == 3)
        symmetric_solve(n, lower, ldl, 3, b);
    else
        symmetric_solve(n, lower, ldl, width, b);
}
