/*
 * Nonlinear least squares with few unknowns: Gauss-Newton steps, damped after Levenberg and
 * Marquardt. Source: [NW06] 10.3.
 */
#include "numeric/gauss_newton.h"
#include "numeric/dense.h"
#include "numeric/vector.h"

#include <float.h>
#include <string.h>

typedef struct {
    int rows, unknowns;
    bat_residuals f;
    void *context;
    double *residuals, *derivatives; /* at x */
    double *scales;                  /* [unknowns] sizes of the columns */
    double *matrix, *right;          /* of a damped step */
    double *trial;                   /* [unknowns] */
} solver;

static batten_status allocate_solver(solver *s)
{
    const size_t n = (size_t)s->unknowns, m = (size_t)s->rows;
    s->residuals = bat_array(m, sizeof(double));
    s->derivatives = bat_array3(m, n, sizeof(double));
    s->scales = bat_array(n, sizeof(double));
    s->matrix = bat_array3(m + n, n, sizeof(double));
    s->right = bat_array(m + n, sizeof(double));
    s->trial = bat_array(n, sizeof(double));
    return s->residuals && s->derivatives && s->scales && s->matrix && s->right && s->trial
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

static void release_solver(solver *s)
{
    bat_release(s->residuals);
    bat_release(s->derivatives);
    bat_release(s->scales);
    bat_release(s->matrix);
    bat_release(s->right);
    bat_release(s->trial);
}

/* The length of a column of derivatives. */
static double influence_of(const solver *s, int k)
{
    double sum = 0;
    for (int i = 0; i < s->rows; i++) {
        const double d = s->derivatives[(size_t)i * (size_t)s->unknowns + (size_t)k];
        sum += d * d;
    }
    return sqrt(sum);
}

static void find_scales(solver *s)
{
    double largest = 0;
    for (int k = 0; k < s->unknowns; k++) {
        s->scales[k] = influence_of(s, k);
        largest = bat_max(largest, s->scales[k]);
    }
    for (int k = 0; k < s->unknowns; k++) /* an unknown without influence stays */
        s->scales[k] = s->scales[k] > 1e-8 * largest ? s->scales[k] : bat_max(largest, 1);
}

/* The step: least |J step + r|^2 + damping^2 |scales step|^2; false when there is none. */
static bool find_step(solver *s, double damping, double *step)
{
    const size_t n = (size_t)s->unknowns, m = (size_t)s->rows;
    memcpy(s->matrix, s->derivatives, m * n * sizeof(double));
    memset(s->matrix + m * n, 0, n * n * sizeof(double));
    memset(s->right + m, 0, n * sizeof(double));
    for (size_t i = 0; i < m; i++)
        s->right[i] = -s->residuals[i];
    for (size_t k = 0; k < n; k++)
        s->matrix[(m + k) * n + k] = damping * s->scales[k];
    if (bat_dense_least_squares(s->rows + s->unknowns, s->unknowns, s->matrix, 1, s->right) !=
        BATTEN_OK)
        return false;
    memcpy(step, s->right, n * sizeof(double));
    return true;
}

/* Damp until the sum of squares falls; false when no step makes it fall. */
static bool improve(solver *s, double *damping, double *x, double *sum)
{
    find_scales(s);
    for (; *damping < 1e8; *damping = bat_max(1e-10, *damping * 10)) {
        if (!find_step(s, *damping, s->trial))
            continue;
        for (int k = 0; k < s->unknowns; k++)
            s->trial[k] += x[k];
        const bool there = s->f(s->context, s->trial, s->residuals, NULL);
        const double now = there ? bat_dot(s->rows, s->residuals, s->residuals) : HUGE_VAL;
        if (now < *sum) {
            *sum = now;
            memcpy(x, s->trial, (size_t)s->unknowns * sizeof *x);
            *damping /= 10;
            return true;
        }
        /* The residuals of the trial overwrote those of x. */
        s->f(s->context, x, s->residuals, s->derivatives);
    }
    return false;
}

batten_status bat_gauss_newton(int rows, int unknowns, bat_residuals f, void *context,
                               int limit, double *x, int *rounds)
{
    solver s = {.rows = rows, .unknowns = unknowns, .f = f, .context = context};
    batten_status status = allocate_solver(&s);
    *rounds = 0;
    if (status == BATTEN_OK && !f(context, x, s.residuals, s.derivatives))
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the first guess is no shape of this kind");
    if (status == BATTEN_OK) {
        double sum = bat_dot(rows, s.residuals, s.residuals), damping = 1e-10;
        while (*rounds < limit && sum > 0) {
            const double before = sum;
            if (!improve(&s, &damping, x, &sum))
                break;
            (*rounds)++;
            /* What falls by less than the rounding of the sum has come to rest. */
            if (before - sum <= 4 * DBL_EPSILON * before)
                break;
            f(context, x, s.residuals, s.derivatives);
        }
    }
    release_solver(&s);
    return status;
}
