/* Newton's step of a convex program. */
#include "numeric/programs/convex_system.h"
#include "numeric/banded.h"

#include <float.h>

/* ---- products ---- */

double bat_convex_row_times(const bat_convex_system *p, int i, const double *x)
{
    const bat_sparse_rows *rows = &p->of->rows;
    double sum = 0;
    for (int k = rows->start[i]; k < rows->start[i + 1]; k++)
        sum += rows->value[k] * x[rows->column[k]];
    return sum / p->norm[i];
}

void bat_convex_add_row(const bat_convex_system *p, int i, double factor, double *to)
{
    const bat_sparse_rows *rows = &p->of->rows;
    factor /= p->norm[i];
    for (int k = rows->start[i]; k < rows->start[i + 1]; k++)
        to[rows->column[k]] += factor * rows->value[k];
}

void bat_convex_hessian_times(const bat_convex_system *p, const double *x, double *to)
{
    const int w = p->of->band + 1;
    memset(to, 0, (size_t)p->n * sizeof *to);
    for (int i = 0; i < p->n; i++) {
        const double *row = p->of->hessian + (size_t)i * (size_t)w + w - 1 - i;
        double sum = row[i] * x[i];
        for (int j = bat_max_int(0, i + 1 - w); j < i; j++) {
            sum += row[j] * x[j];
            to[j] += row[j] * x[i] / p->unit;
        }
        to[i] += sum / p->unit;
    }
}

/* ---- the system ---- */

/* The lower half of row . row times a factor, into the band. */
static void add_square(const bat_convex_system *p, int i, double factor)
{
    const bat_sparse_rows *rows = &p->of->rows;
    const size_t w = (size_t)p->of->band + 1;
    factor /= p->norm[i] * p->norm[i];
    for (int a = rows->start[i]; a < rows->start[i + 1]; a++) {
        const int row = rows->column[a];
        double *to = p->factor + (size_t)row * w + w - 1 - (size_t)row;
        const double times = factor * rows->value[a];
        for (int b = rows->start[i]; b <= a; b++)
            to[rows->column[b]] += times * rows->value[b];
    }
}

static void assemble(bat_convex_system *p, double shift)
{
    const size_t w = (size_t)p->of->band + 1, total = (size_t)p->n * w;
    double largest = 0;
    for (size_t k = 0; k < total; k++)
        p->factor[k] = p->of->hessian[k] / p->unit;
    for (int i = 0; i < p->m; i++)
        add_square(p, i, 1 / p->middle[i]);
    for (int i = 0; i < p->n; i++)
        largest = bat_max(largest, p->factor[(size_t)i * w + w - 1]);
    /* 1e-14 of the mean diagonal of H, which is 1, and a place of the largest number. */
    for (int i = 0; i < p->n; i++)
        p->factor[(size_t)i * w + w - 1] += shift * (1e-14 + DBL_EPSILON * largest);
}

batten_status bat_convex_factor(bat_convex_system *p)
{
    batten_status status = BATTEN_SINGULAR_SYSTEM;
    for (int i = 0; i < p->m; i++)
        p->middle[i] = p->at.s[i] / p->at.z[i] +
                       (bat_convex_has_price(p, i) ? p->at.t[i] / p->at.q[i] : 0);
    /* Beyond a hundred million roundings the step would not lead there any more. */
    for (double shift = 1; status == BATTEN_SINGULAR_SYSTEM && shift <= 1e8; shift *= 100) {
        assemble(p, shift);
        status = bat_symmetric_factor(p->n, p->of->band, p->factor);
    }
    return status;
}

void bat_convex_find_step(bat_convex_system *p, double target, bool correct)
{
    bat_convex_rows *d = &p->step;
    const bat_convex_rows *a = &p->at;
    for (int i = 0; i < p->n; i++)
        p->dx[i] = -p->unmet[i];
    for (int i = 0; i < p->m; i++) {
        const double first = a->s[i] * a->z[i] - target + (correct ? d->s[i] * d->z[i] : 0);
        double second = 0, e = first / a->z[i] - p->missed[i];
        if (bat_convex_has_price(p, i)) {
            const double off = p->price[i] - a->z[i] - a->q[i];
            second = a->t[i] * a->q[i] - target + (correct ? d->t[i] * d->q[i] : 0);
            e -= (second + a->t[i] * off) / a->q[i];
        }
        d->s[i] = first;
        d->t[i] = second;
        p->right[i] = e;
        bat_convex_add_row(p, i, e / p->middle[i], p->dx);
    }
    bat_symmetric_solve(p->n, p->of->band, p->factor, 1, p->dx);
    for (int i = 0; i < p->m; i++) {
        d->z[i] = (bat_convex_row_times(p, i, p->dx) - p->right[i]) / p->middle[i];
        d->s[i] = -(d->s[i] + a->s[i] * d->z[i]) / a->z[i];
        if (!bat_convex_has_price(p, i))
            continue;
        d->q[i] = p->price[i] - a->z[i] - a->q[i] - d->z[i];
        d->t[i] = -(d->t[i] + a->t[i] * d->q[i]) / a->q[i];
    }
}
