/* The matrix of the equations of an interpolation: banded, or banded with the corners of a period. */
#include "shape/linear/linear_matrix.h"
#include "numeric/banded.h"
#include "shape/linear/linear_system.h"
#include "spline/curve/curve.h"

#include <string.h>

/* ---- the matrix ---- */

/* The columns first .. last in which a row is not zero, and the span it is taken on; spans are
 * asked for in increasing order and `span` begins as p. */
static void row_columns(const bat_request *r, const bat_operator *op, int i, int *span,
                        int *first, int *last)
{
    const int p = op->degree, n = op->count;
    const bat_row row = op->rows[i];
    const int order = bat_min_int(row.order, p);
    const double u = r->parameters[row.index], *U = op->knots;
    while (*span < n - 1 && U[*span + 1] <= u)
        (*span)++;
    *first = *span - p;
    *last = *span;
    if (row.index == 0)
        *last = order;
    else if (row.index == r->count - 1)
        *first = n - 1 - order;
    else if (U[*span] == u && U[*span - 1] < u && order < p)
        (*last)--; /* the newest function begins here, smoothly */
}

static batten_status find_band(const bat_request *r, bat_operator *op)
{
    const int p = op->degree;
    for (int i = 0, span = p, first, last; i < op->count; i++) {
        row_columns(r, op, i, &span, &first, &last);
        if (i < first || i > last) /* Schoenberg and Whitney */
            return bat_fail(
                BATTEN_SINGULAR_SYSTEM,
                "parameter %.17g of equation %d lies outside its knots, %.17g to %.17g",
                r->parameters[op->rows[i].index], i, op->knots[i], op->knots[i + p + 1]);
        op->lower = bat_max_int(op->lower, i - first);
        op->upper = bat_max_int(op->upper, last - i);
    }
    return BATTEN_OK;
}

static void fill_matrix(const bat_request *r, bat_operator *op, double *basis)
{
    const int p = op->degree, w = op->lower + op->upper + 1;
    for (int i = 0, span = p, first, last; i < op->count; i++) {
        const bat_row row = op->rows[i];
        row_columns(r, op, i, &span, &first, &last);
        bat_basis(p, op->knots, span, r->parameters[row.index], row.order, basis);
        const double *values = basis + row.order * (p + 1) + p - span;
        double *a = op->matrix + (size_t)i * (size_t)w + (op->lower - i);
        for (int j = first; j <= last; j++)
            a[j] = values[j];
    }
}

/* Row r of a periodic spline bears on the control values r .. r + p; solved for is the sequence
 * that begins p / 2 later, so that the band has its centre on the diagonal. */
static void fill_periodic(const bat_request *r, bat_operator *op, const double *U,
                          double *basis)
{
    const int p = op->degree, w = op->lower + op->upper + 1;
    for (int i = 0; i < op->count; i++) {
        bat_basis(p, U, p + i, r->parameters[i], 0, basis);
        memcpy(op->matrix + (size_t)i * (size_t)w, basis, (size_t)w * sizeof *basis);
    }
}

static batten_status make_periodic(const bat_request *r, bat_operator *op, double *basis)
{
    const int p = op->degree;
    double *U = bat_array((size_t)op->count + 2 * (size_t)p + 1, sizeof *U);
    if (!U)
        return BATTEN_OUT_OF_MEMORY;
    bat_knots_wrap(p, op->count, op->knots, U);
    fill_periodic(r, op, U, basis);
    bat_release(U);
    return bat_cyclic_factor(op->count, op->lower, op->upper, op->matrix, &op->cyclic);
}

static batten_status make_banded(const bat_request *r, bat_operator *op, double *basis)
{
    const size_t size = (size_t)op->count * (size_t)(op->lower + op->upper + 1);
    op->factor = bat_resize(NULL, size, sizeof *op->factor);
    if (!op->factor)
        return BATTEN_OUT_OF_MEMORY;
    fill_matrix(r, op, basis);
    memcpy(op->factor, op->matrix, size * sizeof *op->factor);
    return bat_banded_factor(op->count, op->lower, op->upper, op->factor);
}

batten_status bat_linear_matrix_make(const bat_request *r, bat_operator *op)
{
    batten_status status = BATTEN_OK;
    if (op->periodic)
        op->lower = op->upper = op->degree / 2;
    else
        status = find_band(r, op);
    if (status != BATTEN_OK)
        return status;
    const size_t wide = (size_t)op->degree + 1;
    double *basis = bat_array(wide * (wide + 1), sizeof *basis);
    op->matrix =
        bat_array3((size_t)op->count, (size_t)(op->lower + op->upper + 1), sizeof *op->matrix);
    if (!basis || !op->matrix)
        status = BATTEN_OUT_OF_MEMORY;
    else
        status = op->periodic ? make_periodic(r, op, basis) : make_banded(r, op, basis);
    bat_release(basis);
    return status;
}
