/*
 * Linear least squares with a B-spline: the rows for data and smoothing penalties, their
 * solution by Givens rotations, and the residuals and degrees of freedom.
 */
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "shape/near/approximate.h"
#include "spline/spline.h"

#include <string.h>

/* No row is wider than a basis of the highest degree. */
enum { MAX_ROW = BATTEN_MAX_DEGREE + 1 };

/* ---- rows ---- */

static void rows_free(bat_rows_of_fit *rows)
{
    bat_release(rows->first);
    bat_release(rows->values);
    bat_release(rows->start);
    bat_release(rows->order);
    *rows = (bat_rows_of_fit){0};
}

static batten_status rows_make(int count, int width, int unknowns, bat_rows_of_fit *out)
{
    bat_rows_of_fit rows = {count, width, NULL, NULL, NULL, NULL};
    rows.first = bat_array((size_t)count, sizeof *rows.first);
    rows.values = bat_array3((size_t)count, (size_t)width, sizeof *rows.values);
    rows.start = bat_array((size_t)unknowns + 1, sizeof *rows.start);
    rows.order = bat_array((size_t)count, sizeof *rows.order);
    if (rows.first && rows.values && rows.start && rows.order) {
        *out = rows;
        return BATTEN_OK;
    }
    rows_free(&rows);
    return BATTEN_OUT_OF_MEMORY;
}

/* Count the rows of each place, then deal them out. */
static void rows_sort(const bat_givens *qr, bat_rows_of_fit *rows)
{
    const int n = qr->count;
    memset(rows->start, 0, ((size_t)n + 1) * sizeof *rows->start);
    for (int i = 0; i < rows->count; i++)
        rows->start[bat_givens_place(qr, rows->first[i]) + 1]++;
    for (int k = 0; k < n; k++)
        rows->start[k + 1] += rows->start[k];
    for (int i = 0; i < rows->count; i++)
        rows->order[rows->start[bat_givens_place(qr, rows->first[i])]++] = i;
    for (int k = n; k > 0; k--)
        rows->start[k] = rows->start[k - 1];
    rows->start[0] = 0;
}

/* ---- the basis at the data ---- */

int bat_fit_all_count(const bat_fit *fit)
{
    return fit->periodic ? fit->count + fit->degree : fit->count;
}

batten_status bat_fit_all_knots(const bat_fit *fit, double **out)
{
    const size_t n = (size_t)(bat_fit_all_count(fit) + fit->degree + 1);
    double *knots = bat_array(n, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    if (fit->periodic)
        bat_knots_wrap(fit->degree, fit->count, fit->knots, knots);
    else
        memcpy(knots, fit->knots, n * sizeof *knots);
    *out = knots;
    return BATTEN_OK;
}

static batten_status fill_basis(bat_fit *fit, const double *U)
{
    const int p = fit->degree, n = bat_fit_all_count(fit);
    for (int i = 0; i < fit->data_count; i++) {
        const double u = fit->parameters[i];
        if (!(u >= U[p] && u <= U[n]))
            return bat_fail(BATTEN_OUT_OF_DOMAIN,
                            "the parameter of point %d is %g, outside the knots' %g .. %g",
                            i + 1, u, U[p], U[n]);
        const int span = bat_knots_span(p, n, U, u, BATTEN_FROM_RIGHT);
        bat_basis(p, U, span, u, 0, fit->data.values + (size_t)i * (size_t)(p + 1));
        fit->data.first[i] = (span - p) % fit->count;
    }
    return BATTEN_OK;
}

void bat_fit_weigh(bat_fit *fit, const double *weights)
{
    for (int i = 0; i < fit->data_count; i++)
        fit->factors[i] = weights ? sqrt(weights[i]) : 1;
}

batten_status bat_fit_begin(const bat_fit_request *r, bat_fit *out)
{
    bat_fit fit = {.dimension = r->dimension,
                   .degree = r->degree,
                   .count = r->count,
                   .periodic = r->periodic,
                   .data_count = r->data_count,
                   .points = r->points,
                   .parameters = r->parameters};
    const size_t knots = (size_t)r->count + (r->periodic ? 1 : (size_t)r->degree + 1);
    double *U = NULL;
    fit.knots = bat_array(knots, sizeof *fit.knots);
    fit.factors = bat_array((size_t)r->data_count, sizeof *fit.factors);
    fit.right = bat_array((size_t)r->dimension, sizeof *fit.right);
    batten_status status =
        fit.knots && fit.factors && fit.right ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        memcpy(fit.knots, r->knots, knots * sizeof *fit.knots);
        bat_fit_weigh(&fit, r->weights);
        status = bat_fit_all_knots(&fit, &U);
    }
    if (status == BATTEN_OK)
        status = bat_knots_check(fit.degree, bat_fit_all_count(&fit), U, "knot");
    if (status == BATTEN_OK)
        status = rows_make(fit.data_count, fit.degree + 1, fit.count, &fit.data);
    if (status == BATTEN_OK)
        status = fill_basis(&fit, U);
    if (status == BATTEN_OK)
        status = bat_givens_begin(fit.count, fit.degree + 1, fit.periodic,
                                  (size_t)fit.dimension, &fit.qr);
    bat_release(U);
    if (status != BATTEN_OK) {
        bat_fit_end(&fit);
        return status;
    }
    rows_sort(&fit.qr, &fit.data);
    *out = fit;
    return BATTEN_OK;
}

void bat_fit_end(bat_fit *fit)
{
    rows_free(&fit->data);
    rows_free(&fit->penalty);
    bat_givens_end(&fit->qr);
    bat_release(fit->knots);
    bat_release(fit->factors);
    bat_release(fit->right);
    *fit = (bat_fit){0};
}

/* ---- penalties ---- */

static double trace(const bat_rows_of_fit *rows, const double *factors)
{
    double sum = 0;
    for (int i = 0; i < rows->count; i++) {
        const double *row = rows->values + (size_t)i * (size_t)rows->width;
        sum += (factors ? factors[i] * factors[i] : 1) * bat_dot(rows->width, row, row);
    }
    return sum;
}

/* Rows wider than the basis need a wider band. */
static batten_status finish_penalty(bat_fit *fit)
{
    if (fit->penalty.width > fit->qr.width) {
        bat_givens_end(&fit->qr);
        const batten_status status = bat_givens_begin(
            fit->count, fit->penalty.width, fit->periodic, (size_t)fit->dimension, &fit->qr);
        if (status != BATTEN_OK)
            return status;
        rows_sort(&fit->qr, &fit->data);
    }
    rows_sort(&fit->qr, &fit->penalty);
    const double size = trace(&fit->penalty, NULL);
    fit->penalty_scale = size > 0 ? trace(&fit->data, fit->factors) / size : 0;
    return BATTEN_OK;
}

batten_status bat_fit_penalise_differences(bat_fit *fit, int order)
{
    const int count = fit->periodic ? fit->count : bat_max_int(0, fit->count - order);
    rows_free(&fit->penalty);
    const batten_status status = rows_make(count, order + 1, fit->count, &fit->penalty);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < count; i++) {
        double *row = fit->penalty.values + (size_t)i * (size_t)(order + 1);
        fit->penalty.first[i] = i;
        for (int k = 0; k <= order; k++)
            row[k] = (order - k) % 2 ? -bat_binomials[order][k] : bat_binomials[order][k];
    }
    return finish_penalty(fit);
}

/* On one span the square has degree 2 (p - order), so p - order + 1 nodes of Gauss are exact.
 */
static void fill_energy(bat_fit *fit, const double *U, int order)
{
    const int p = fit->degree, nodes = p - order + 1;
    double x[BAT_MAX_GAUSS], w[BAT_MAX_GAUSS], basis[(BATTEN_MAX_DEGREE + 1) * 6];
    int row = 0;
    bat_gauss(nodes, x, w);
    for (int k = p; k < bat_fit_all_count(fit); k++)
        for (int g = 0; U[k] < U[k + 1] && g < nodes; g++, row++) {
            const double half = (U[k + 1] - U[k]) / 2;
            bat_basis(p, U, k, U[k] + half * (1 + x[g]), order, basis);
            fit->penalty.first[row] = (k - p) % fit->count;
            for (int i = 0; i <= p; i++)
                fit->penalty.values[row * (p + 1) + i] =
                    sqrt(half * w[g]) * basis[order * (p + 1) + i];
        }
}

/* Of the rows only their squares matter: R, of which the rows that see nothing but polynomials
 * of degree order - 1 vanish, has half as many as there are nodes. */
static batten_status shrink_energy(bat_fit *fit, int order)
{
    const double nothing = 0;
    const int width = fit->penalty.width, count = fit->count - order;
    bat_rows_of_fit *rows = &fit->penalty;
    bat_givens qr;
    const batten_status status = bat_givens_begin(fit->count, width, false, 1, &qr);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < rows->count; i++)
        bat_givens_add(&qr, rows->first[i], width, rows->values + (size_t)i * (size_t)width, 1,
                       &nothing);
    rows->count = bat_min_int(count, rows->count);
    for (int i = 0; i < rows->count; i++) {
        rows->first[i] = i;
        memcpy(rows->values + (size_t)i * (size_t)width,
               qr.band + (size_t)i * (size_t)(width + 1), (size_t)width * sizeof *rows->values);
    }
    bat_givens_end(&qr);
    return BATTEN_OK;
}

batten_status bat_fit_penalise_energy(bat_fit *fit, int order)
{
    assert(order <= 5 && order <= fit->degree);
    double *U = NULL;
    batten_status status = bat_fit_all_knots(fit, &U);
    if (status != BATTEN_OK)
        return status;
    int spans = 0;
    for (int k = fit->degree; k < bat_fit_all_count(fit); k++)
        spans += U[k] < U[k + 1];
    rows_free(&fit->penalty);
    status = rows_make(spans * (fit->degree - order + 1), fit->degree + 1, fit->count,
                       &fit->penalty);
    if (status == BATTEN_OK) {
        fill_energy(fit, U, order);
        if (!fit->periodic)
            status = shrink_energy(fit, order);
    }
    if (status == BATTEN_OK) {
        status = finish_penalty(fit);
    }
    bat_release(U);
    return status;
}

/* ---- solving ---- */

/* What is known of a row goes to its right side. */
static void set_aside(const bat_fit *fit, int first, int length, double *values, double *right)
{
    const int columns[2] = {0, fit->count - 1};
    for (int e = 0; e < 2; e++) {
        const int k = columns[e] - first;
        if (!fit->fixed[e] || k < 0 || k >= length)
            continue;
        for (int c = 0; c < fit->dimension; c++)
            right[c] -= values[k] * fit->ends[e][c];
        values[k] = 0;
    }
}

static void add_row(bat_fit *fit, const bat_rows_of_fit *rows, int i, double factor,
                    const double *given)
{
    double values[MAX_ROW], *right = fit->right;
    const int width = rows->width;
    const size_t size = (size_t)fit->dimension * sizeof *right;
    memcpy(values, rows->values + (size_t)i * (size_t)width, (size_t)width * sizeof *values);
    if (given)
        memcpy(right, given, size);
    else
        memset(right, 0, size);
    set_aside(fit, rows->first[i], width, values, right);
    bat_givens_add(&fit->qr, rows->first[i], width, values, factor, right);
}

static void add_place(bat_fit *fit, int place, double lambda)
{
    const double one = 1;
    const bat_rows_of_fit *data = &fit->data, *penalty = &fit->penalty;
    if (place == 0 && fit->fixed[0])
        bat_givens_add(&fit->qr, 0, 1, &one, 1, fit->ends[0]);
    for (int k = data->start[place]; k < data->start[place + 1]; k++) {
        const int i = data->order[k];
        if (fit->factors[i] > 0)
            add_row(fit, data, i, fit->factors[i],
                    fit->points + (size_t)i * (size_t)fit->dimension);
    }
    for (int k = 0; lambda > 0 && k < penalty->start[place + 1] - penalty->start[place]; k++)
        add_row(fit, penalty, penalty->order[penalty->start[place] + k], sqrt(lambda), NULL);
    if (place == fit->count - 1 && fit->fixed[1])
        bat_givens_add(&fit->qr, fit->count - 1, 1, &one, 1, fit->ends[1]);
}

batten_status bat_fit_solve(bat_fit *fit, double lambda, double *control, int *unknown)
{
    bat_givens_clear(&fit->qr);
    for (int place = 0; place < fit->count; place++)
        add_place(fit, place, lambda);
    const batten_status status = bat_givens_check(&fit->qr, unknown);
    if (status == BATTEN_OK)
        bat_givens_solve(&fit->qr, control);
    return status;
}

batten_status bat_fit_freedom(const bat_fit *fit, double *out)
{
    bat_inverse_band inverse;
    const batten_status status = bat_inverse_band_make(&fit->qr, &inverse);
    if (status != BATTEN_OK)
        return status;
    double sum = 0;
    for (int i = 0; i < fit->data_count; i++) {
        double values[MAX_ROW];
        const int width = fit->data.width;
        memcpy(values, fit->data.values + (size_t)i * (size_t)width,
               (size_t)width * sizeof *values);
        set_aside(fit, fit->data.first[i], width, values, fit->right);
        if (fit->factors[i] > 0)
            sum += fit->factors[i] * fit->factors[i] *
                   bat_inverse_band_form(&inverse, fit->data.first[i], width, values);
    }
    *out = sum;
    bat_inverse_band_free(&inverse);
    return BATTEN_OK;
}
