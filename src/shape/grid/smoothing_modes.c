/*
 * The matrix G of the data and the matrix R of the penalty of one direction, made diagonal in
 * one basis.
 */
#include "shape/grid/smoothing_modes.h"
#include "numeric/eigen.h"
#include "numeric/vector.h"

#include <float.h>

void bat_modes_free(bat_modes *m)
{
    bat_release(m->penalty);
    bat_release(m->basis);
    *m = (bat_modes){0};
}

/* a += sum over rows of factor^2 row^t row. */
static void add_gram(const bat_rows_of_fit *rows, const double *factors, double scale, int n,
                     double *a)
{
    for (int r = 0; r < rows->count; r++) {
        const double *row = rows->values + (size_t)r * (size_t)rows->width;
        const double f = scale * (factors ? factors[r] * factors[r] : 1);
        for (int i = 0; i < rows->width; i++)
            for (int j = 0; j < rows->width; j++)
                a[(size_t)((rows->first[r] + i) % n) * (size_t)n +
                  (size_t)((rows->first[r] + j) % n)] += f * row[i] * row[j];
    }
}

/* L of L L^t in the lower half. */
static batten_status cholesky(int n, double *a)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++) {
            double *row = a + (size_t)i * (size_t)n, *above = a + (size_t)j * (size_t)n;
            const double whole = row[j], rest = whole - bat_dot(j, row, above);
            if (i == j && !(rest > n * DBL_EPSILON * whole))
                return bat_fail(BATTEN_SINGULAR_SYSTEM,
                                "control point %d has no grid line of its own", i + 1);
            row[j] = i == j ? sqrt(rest) : rest / above[j];
        }
    return BATTEN_OK;
}

/* In place, for every row x of b [rows][n]: L^-1 x. */
static void solve_lower(int n, const double *l, int rows, double *b)
{
    for (int r = 0; r < rows; r++)
        for (int i = 0; i < n; i++) {
            double *x = b + (size_t)r * (size_t)n;
            x[i] = (x[i] - bat_dot(i, l + (size_t)i * (size_t)n, x)) / l[i * n + i];
        }
}

/* L^-t x of every row. */
static void solve_upper(int n, const double *l, int rows, double *b)
{
    for (int r = 0; r < rows; r++)
        for (int i = n - 1; i >= 0; i--) {
            double *x = b + (size_t)r * (size_t)n;
            x[i] /= l[i * n + i];
            for (int k = 0; k < i; k++)
                x[k] -= l[i * n + k] * x[i];
        }
}

static void transpose(int n, double *a)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++) {
            const double kept = a[i * n + j];
            a[i * n + j] = a[j * n + i];
            a[j * n + i] = kept;
        }
}

/* G = L L^t; the eigenvectors Q of L^-1 R L^-t give T = Q L^-1. The polynomials that the
 * penalty does not see have the smallest values, which are 0 and come out as rounding. */
static batten_status diagonalise(int n, double *G, double *R, int unseen, bat_modes *m)
{
    const batten_status status = cholesky(n, G);
    if (status != BATTEN_OK)
        return status;
    solve_lower(n, G, n, R);
    transpose(n, R);
    solve_lower(n, G, n, R);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++)
            R[i * n + j] = R[j * n + i] = (R[i * n + j] + R[j * n + i]) / 2;
    bat_eigen_symmetric(n, R, m->penalty, m->basis);
    solve_upper(n, G, n, m->basis);
    for (int i = 0; i < n; i++)
        m->penalty[i] = i < unseen ? 0 : bat_max(m->penalty[i], 0);
    return BATTEN_OK;
}

batten_status bat_modes_make(const bat_fit *fit, int unseen, bat_modes *out)
{
    const int n = fit->count;
    const size_t size = (size_t)n * (size_t)n;
    bat_modes m = {.n = n};
    m.penalty = bat_array((size_t)n, sizeof *m.penalty);
    m.basis = bat_array(size, sizeof *m.basis);
    double *G = bat_array(size, sizeof *G), *R = bat_array(size, sizeof *R);
    batten_status status = m.penalty && m.basis && G && R ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        add_gram(&fit->data, fit->factors, 1, n, G);
        /* Scaled, so that the numbers stay near 1; undone in the values. */
        add_gram(&fit->penalty, NULL, fit->penalty_scale, n, R);
        status = diagonalise(n, G, R, bat_min_int(unseen, n), &m);
    }
    for (int i = 0; status == BATTEN_OK && i < n && fit->penalty_scale > 0; i++)
        m.penalty[i] /= fit->penalty_scale;
    bat_release(R);
    bat_release(G);
    if (status == BATTEN_OK)
        *out = m;
    else
        bat_modes_free(&m);
    return status;
}
