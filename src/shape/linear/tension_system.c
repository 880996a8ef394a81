/* The equations of a spline in tension for its second derivatives, and the slopes these give. */
#include "numeric/banded.h"
#include "shape/linear/tension.h"
#include "spline/chain/chain.h"

#include <string.h>

/* The slope at the start of a span is d - a M - b N, at its end d + b M + a N. */
static void find_coefficients(bat_tension *t)
{
    for (int i = 0; i < t->spans; i++) {
        const double h = t->u[i + 1] - t->u[i], p = t->sigma[i];
        if (t->rational) {
            t->b[i] = h / (2 * (p * p + 3 * p + 3));
            t->a[i] = (2 + p) * t->b[i];
            continue;
        }
        double at_start[4], at_end[4];
        bat_tension_shape(t->sigma[i] * h, 0, 1, at_start);
        bat_tension_shape(t->sigma[i] * h, 1, 0, at_end);
        t->a[i] = h * at_end[1];
        t->b[i] = -h * at_start[1];
    }
}

/* Row of a point between the spans `before` and `after`: their slopes agree. */
static void inner_row(bat_tension *t, int i, int before, int after)
{
    const int d = t->dimension;
    double *row = t->matrix + 3 * (size_t)i, *right = t->moments + (size_t)i * (size_t)d;
    row[0] = t->b[before];
    row[1] = t->a[before] + t->a[after];
    row[2] = t->b[after];
    for (int k = 0; k < d; k++)
        right[k] = t->slopes[(size_t)after * (size_t)d + (size_t)k] -
                   t->slopes[(size_t)before * (size_t)d + (size_t)k];
}

static void end_row(bat_tension *t, int end)
{
    const int d = t->dimension, i = end ? t->count - 1 : 0, span = end ? t->spans - 1 : 0;
    const bool line = t->count == 2 && t->ends.kinds[1 - end] == BATTEN_END_PARABOLIC;
    double *row = t->matrix + 3 * (size_t)i, *right = t->moments + (size_t)i * (size_t)d;
    const double *slope = t->slopes + (size_t)span * (size_t)d;
    const double sign = end ? -1 : 1;
    memset(row, 0, 3 * sizeof *row);
    memset(right, 0, (size_t)d * sizeof *right);
    row[1] = 1;
    if (t->ends.kinds[end] == BATTEN_END_CLAMPED) {
        row[1] = t->a[span];
        row[end ? 0 : 2] = t->b[span];
        for (int k = 0; k < d; k++)
            right[k] = sign * (slope[k] - t->ends.values[end][k]);
    } else if (t->ends.kinds[end] == BATTEN_END_SECOND)
        memcpy(right, t->ends.values[end], (size_t)d * sizeof *right);
    else if (!line) /* which two parabolic ends of one span are */
        row[end ? 0 : 2] = -1;
}

batten_status bat_tension_solve(bat_tension *t)
{
    const size_t d = (size_t)t->dimension, n = (size_t)t->count;
    find_coefficients(t);
    for (int i = t->closed ? 0 : 1; i < t->spans; i++)
        inner_row(t, i, i ? i - 1 : t->spans - 1, i);
    batten_status status = BATTEN_OK;
    if (t->closed) {
        bat_cyclic *factor = NULL;
        status = bat_cyclic_factor(t->count, 1, 1, t->matrix, &factor);
        if (status == BATTEN_OK)
            status = bat_cyclic_solve(factor, d, t->moments);
        bat_cyclic_free(factor);
    } else {
        end_row(t, 0);
        end_row(t, 1);
        status = bat_banded_factor(t->count, 1, 1, t->matrix);
        if (status == BATTEN_OK)
            bat_banded_solve(t->count, 1, 1, t->matrix, d, t->moments);
    }
    const size_t bad = status == BATTEN_OK ? bat_first_not_finite(t->moments, n * d) / d : n;
    if (bad < n)
        return bat_fail(BATTEN_OVERFLOW, "the curve bends too much at point %d for a number",
                        (int)bad + 1);
    return status;
}

void bat_tension_slope(const bat_tension *t, int span, int end, double *slope)
{
    const size_t d = (size_t)t->dimension;
    const double *M = t->moments + (size_t)span * d;
    const double *N = t->moments + (size_t)bat_tension_next(t, span) * d;
    const double a = t->a[span], b = t->b[span];
    for (size_t k = 0; k < d; k++) {
        const double chord = t->slopes[(size_t)span * d + k];
        slope[k] = end ? chord + (b * M[k] + a * N[k]) : chord - (a * M[k] + b * N[k]);
    }
}
