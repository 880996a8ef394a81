/*
 * A row of points interpolated with knots that are more than it needs.
 *
 * The control points c make c.E c least, E the Gram matrix of second derivatives, under the
 * equations A c = b. With M = E + r At A, which is positive definite and has the same least
 * under them, c = M^-1 At (A M^-1 At)^-1 b. M is a narrow band. Rounding is taken out by the
 * same step for what is still missed.
 */
#include "numeric/banded.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "shape/skin/rows_of_points.h"
#include "spline/curve/curve.h"

#include <string.h>

typedef struct {
    int p, count, rows; /* degree, control points, data */
    double *U;          /* [count + p + 1] */
    int *spans;         /* [rows] */
    double *basis;      /* [rows][p + 1] */
    double *band;       /* M [count][p + 1], factored */
    double *reach;      /* M^-1 At, transposed: [rows][count] */
    double *schur;      /* A M^-1 At, lower band of all: [rows][rows] */
} row_system;

static void free_system(row_system *s)
{
    bat_release(s->U);
    bat_release(s->spans);
    bat_release(s->basis);
    bat_release(s->band);
    bat_release(s->reach);
    bat_release(s->schur);
}

static batten_status allocate(row_system *s, bool is_free)
{
    const size_t n = (size_t)s->count, m = (size_t)s->rows, w = (size_t)s->p + 1;
    s->U = bat_array(n + w, sizeof *s->U);
    s->spans = bat_array(m, sizeof *s->spans);
    s->basis = bat_array3(m, w, sizeof *s->basis);
    if (!s->U || !s->spans || !s->basis)
        return BATTEN_OUT_OF_MEMORY;
    if (!is_free)
        return BATTEN_OK;
    s->band = bat_array3(n, w, sizeof *s->band);
    s->reach = bat_array3(m, n, sizeof *s->reach);
    s->schur = bat_array3(m, m, sizeof *s->schur);
    return s->band && s->reach && s->schur ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void add_product(row_system *s, int span, const double *values, double factor)
{
    const int p = s->p;
    for (int j = 0; j <= p; j++)
        for (int k = 0; k <= j; k++)
            s->band[(size_t)(span - p + j) * (size_t)(p + 1) + (size_t)(p - j + k)] +=
                factor * values[j] * values[k];
}

/* The energy, integrated exactly by Gauss; the sum of its diagonal. */
static double add_energy(row_system *s)
{
    const int p = s->p, order = bat_min_int(p, 2), n = bat_max_int(1, p - order + 1);
    double nodes[BATTEN_MAX_DEGREE + 1], weights[BATTEN_MAX_DEGREE + 1];
    double basis[3 * (BATTEN_MAX_DEGREE + 1)], trace = 0;
    bat_gauss(n, nodes, weights);
    for (int span = p; span < s->count; span++) {
        const double a = s->U[span], h = s->U[span + 1] - a;
        for (int i = 0; i < n && h > 0; i++) {
            bat_basis(p, s->U, span, a + h * (1 + nodes[i]) / 2, order, basis);
            add_product(s, span, basis + order * (p + 1), h * weights[i] / 2);
        }
    }
    for (int i = 0; i < s->count; i++)
        trace += s->band[(size_t)i * (size_t)(p + 1) + (size_t)p];
    return trace;
}

static batten_status factor(row_system *s)
{
    const int p = s->p, n = s->count, m = s->rows;
    const size_t w = (size_t)p + 1;
    const double weight = add_energy(s) / m;
    for (int i = 0; i < m; i++)
        add_product(s, s->spans[i], s->basis + (size_t)i * w, weight);
    batten_status status = bat_symmetric_factor(n, p, s->band);
    for (int i = 0; status == BATTEN_OK && i < m; i++) {
        double *column = s->reach + (size_t)i * (size_t)n;
        memcpy(column + s->spans[i] - p, s->basis + (size_t)i * w, w * sizeof *column);
        bat_symmetric_solve(n, p, s->band, 1, column);
    }
    for (int i = 0; status == BATTEN_OK && i < m; i++)
        for (int k = 0; k <= i; k++) { /* row i of the lower half, its diagonal last */
            const double *column = s->reach + (size_t)k * (size_t)n + s->spans[i] - p;
            double sum = 0;
            for (size_t j = 0; j < w; j++)
                sum += s->basis[(size_t)i * w + j] * column[j];
            s->schur[(size_t)i * (size_t)m + (size_t)(m - 1 - i + k)] = sum;
        }
    return status == BATTEN_OK ? bat_symmetric_factor(m, m - 1, s->schur) : status;
}

/* What the points are missed by, into `miss`; the largest. */
static double residual(const row_system *s, int d, const double *points, const double *control,
                       double *miss)
{
    double worst = 0;
    for (int i = 0; i < s->rows; i++)
        for (int c = 0; c < d; c++) {
            double value = points[i * d + c];
            for (int j = 0; j <= s->p; j++)
                value -= s->basis[(size_t)i * (size_t)(s->p + 1) + (size_t)j] *
                         control[(s->spans[i] - s->p + j) * d + c];
            miss[i * d + c] = value;
            worst = bat_max(worst, fabs(value));
        }
    return worst;
}

static batten_status solve_row(const row_system *s, int d, const double *points,
                               double *control)
{
    const size_t m = (size_t)s->rows, n = (size_t)s->count;
    double *miss = bat_array3(m, (size_t)d, sizeof *miss);
    if (!miss)
        return BATTEN_OUT_OF_MEMORY;
    double worst = residual(s, d, points, control, miss);
    for (int step = 0; step < 8 && worst > 0; step++) {
        bat_symmetric_solve(s->rows, s->rows - 1, s->schur, (size_t)d, miss);
        for (size_t i = 0; i < m; i++)
            for (size_t j = 0; j < n; j++)
                for (size_t c = 0; c < (size_t)d; c++)
                    control[j * (size_t)d + c] += s->reach[i * n + j] * miss[i * (size_t)d + c];
        const double left = residual(s, d, points, control, miss);
        if (!(left < worst / 4))
            break;
        worst = left;
    }
    bat_release(miss);
    return BATTEN_OK;
}

/* As many points as control points: the equations alone. Parameter i lies in the support of
 * basis function i, so the band is p to both sides. */
static batten_status interpolate(const row_system *s, int d, const double *points,
                                 double *control)
{
    const int p = s->p, n = s->count;
    double *band = bat_array3((size_t)n, (size_t)(2 * p + 1), sizeof *band);
    if (!band)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= p; j++)
            band[(size_t)i * (size_t)(2 * p + 1) + (size_t)(s->spans[i] + j - i)] =
                s->basis[(size_t)i * (size_t)(p + 1) + (size_t)j];
    memcpy(control, points, (size_t)n * (size_t)d * sizeof *control);
    const batten_status status = bat_banded_factor(n, p, p, band);
    if (status == BATTEN_OK)
        bat_banded_solve(n, p, p, band, (size_t)d, control);
    bat_release(band);
    return status;
}

/* Spans and basis functions of all parameters. */
static void find_basis(row_system *s, const bat_shared_knots *shared, const double *u)
{
    const int p = s->p;
    memcpy(s->U + p + 1, shared->knots, (size_t)shared->count * sizeof *s->U);
    for (int i = 0; i <= p; i++)
        s->U[s->count + i] = 1;
    for (int i = 0; i < s->rows; i++) {
        s->spans[i] = bat_knots_span(p, s->count, s->U, u[i], BATTEN_FROM_RIGHT);
        bat_basis(p, s->U, s->spans[i], u[i], 0, s->basis + (size_t)i * (size_t)(p + 1));
    }
}

batten_status bat_row_through(const bat_shared_knots *shared, int p, int d, int count,
                              const double *u, const double *points, bool *is_free,
                              batten_curve **out)
{
    row_system s = {.p = p, .count = shared->count + p + 1, .rows = count};
    *is_free = count < s.count;
    /* 16 million numbers are 128 megabytes. */
    const double size = (double)count * ((double)count + s.count);
    if (*is_free && size > 16e6)
        return bat_fail(BATTEN_TOO_LARGE,
                        "a row of %d points with %d control points asks for %.3g numbers; the "
                        "limit is 1.6e7",
                        count, s.count, size);
    batten_status status = allocate(&s, *is_free);
    double *control = bat_array3((size_t)s.count, (size_t)d, sizeof *control);
    if (!control)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        find_basis(&s, shared, u);
        status = *is_free ? factor(&s) : interpolate(&s, d, points, control);
    }
    if (status == BATTEN_OK && *is_free)
        status = solve_row(&s, d, points, control);
    if (status == BATTEN_OK)
        status = batten_curve_create((batten_points){d, s.count, control}, p, NULL, s.U, out);
    bat_release(control);
    free_system(&s);
    return status;
}
