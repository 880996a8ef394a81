/* The matrix of the equations of an interpolation: banded, or banded with the corners of a period. */
#include "shape/linear/linear_matrix.h"
#include "numeric/banded.h"
#include "shape/linear/linear_system.h"
#include "spline/curve/curve.h"

#include <string.h>

/* ---- the matrix ---- */

/* The columns first .. last in which a row is not zero, and the span it is taken on. */
typedef struct {
    int span, first, last;
} row_columns;

/* Rows are asked for in increasing order of their spans; `at` begins with the span p. */
static void go_to_row(const bat_request *r, const bat_operator *op, int i, row_columns *at)
{
    const int p = op->degree, n = op->count;
    const bat_row row = op->rows[i];
    const int order = bat_min_int(row.order, p);
    const double u = r->parameters[row.index], *U = op->knots;
    while (at->span < n - 1 && U[at->span + 1] <= u)
        at->span++;
    at->first = at->span - p;
    at->last = at->span;
    if (row.index == 0)
        at->last = order;
    else if (row.index == r->count - 1)
        at->first = n - 1 - order;
    else if (U[at->span] == u && U[at->span - 1] < u && order < p)
        at->last--; /* the newest function begins here, smoothly */
}

static batten_status find_band(const bat_request *r, bat_operator *op)
{
    const int p = op->degree;
    row_columns at = {.span = p};
    for (int i = 0; i < op->count; i++) {
        go_to_row(r, op, i, &at);
        if (i < at.first || i > at.last) /* Schoenberg and Whitney */
            return bat_fail(
                BATTEN_SINGULAR_SYSTEM,
                "parameter %.17g of equation %d lies outside its knots, %.17g to %.17g",
                r->parameters[op->rows[i].index], i + 1, op->knots[i], op->knots[i + p + 1]);
        op->lower = bat_max_int(op->lower, i - at.first);
        op->upper = bat_max_int(op->upper, at.last - i);
    }
    return BATTEN_OK;
}

static void fill_matrix(const bat_request *r, bat_operator *op, double *basis)
{
    const int p = op->degree, w = op->lower + op->upper + 1;
    row_columns at = {.span = p};
    for (int i = 0; i < op->count; i++) {
        const bat_row row = op->rows[i];
        go_to_row(r, op, i, &at);
        bat_basis(p, op->knots, at.span, r->parameters[row.index], row.order, basis);
        const double *values = basis + row.order * (p + 1) + p - at.span;
        double *a = op->matrix + (size_t)i * (size_t)w + (op->lower - i);
        for (int j = at.first; j <= at.last; j++)
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
