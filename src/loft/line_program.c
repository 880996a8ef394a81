/* The program of a line: squares, rows, and how it is solved. */
#include "loft/line_program.h"
#include "numeric/banded.h"
#include "numeric/programs/convex_program.h"
#include "spline/spline.h"

#include <string.h>

enum { P = BAT_LOFT_DEGREE, K = BAT_LOFT_SUPPORT };

/* What a wrong sign costs, of a normed row and an objective of unit size, as in a patch. */
static const double price_of_sign = 30;

static int basis_at(const bat_loft_line *line, double t, int order, double basis[K])
{
    const int span = bat_knots_span(P, line->count, line->knots, t, BATTEN_FROM_RIGHT);
    double all[(P + 1) * K];
    bat_basis(P, line->knots, span, t, order, all);
    memcpy(basis, all + order * K, K * sizeof *basis);
    return span - P;
}

double bat_loft_line_at(const bat_loft_line *line, const double *f, double t, int order)
{
    double basis[K], sum = 0;
    const int first = basis_at(line, t, order, basis);
    for (int k = 0; k < K; k++)
        sum += basis[k] * f[first + k];
    return sum;
}

/* ---- squares and rows ---- */

/* Add factor (basis . x - target)^2 / 2; what is pinned moves to the right side. */
static void add_square(bat_line_program *f, int first, const double *basis, double factor,
                       double target)
{
    for (int a = 0; a < K; a++) {
        const int i = first + a - f->first;
        if (i < 0 || i >= f->unknowns)
            target -= basis[a] * f->x[first + a];
    }
    for (int a = 0; a < K; a++) {
        const int i = first + a - f->first;
        if (i < 0 || i >= f->unknowns)
            continue;
        f->linear[i] -= factor * target * basis[a];
        for (int b = bat_max_int(0, a - i); b <= a; b++)
            f->hessian[i * (P + 1) + P - a + b] += factor * basis[a] * basis[b];
    }
}

static void add_row(bat_line_program *f, int first, const double *basis, double sign,
                    double bound, double price)
{
    double square = 0;
    for (int k = 0; k < K; k++) {
        const int i = first + k - f->first;
        if (i >= 0 && i < f->unknowns)
            square += basis[k] * basis[k];
        else
            bound -= sign * basis[k] * f->x[first + k];
    }
    const double norm = sqrt(square);
    int end = f->start[f->row_count];
    if (!(norm > 0))
        return;
    for (int k = 0; k < K; k++) {
        const int i = first + k - f->first;
        if (i < 0 || i >= f->unknowns)
            continue;
        f->column[end] = i;
        f->value[end++] = sign * basis[k] / norm;
    }
    f->bounds[f->row_count] = bound / norm;
    f->prices[f->row_count] = price;
    f->start[++f->row_count] = end;
}

/* Of f''', which is constant on a span, of unit size. */
static void add_energy(bat_line_program *f)
{
    const double *knots = f->of->knots, scale = f->of->within / f->size;
    double basis[K];
    for (int span = P; span < f->of->count; span++) {
        const double h = knots[span + 1] - knots[span];
        const int first = basis_at(f->of, knots[span] + h / 2, P, basis);
        add_square(f, first, basis, 2 * f->smooth * h * scale * scale, 0);
    }
}

/* A program uses so much of a bound: the rest is for rounding. */
static const double share_of_bound = 0.995;

static void add_data(bat_line_program *f)
{
    const bat_loft_line *line = f->of;
    double basis[K];
    for (int k = 0; k < line->datum_count; k++) {
        const int first = basis_at(line, line->t[k], 0, basis);
        add_square(f, first, basis, 2, f->missing[k]);
        add_row(f, first, basis, 1, f->missing[k] + share_of_bound, HUGE_VAL);
        add_row(f, first, basis, -1, -f->missing[k] + share_of_bound, HUGE_VAL);
    }
}

/* No coefficient is below 0: then no place of the line is. */
static void add_side(bat_line_program *f)
{
    const int last = f->of->count - K;
    for (int i = 0; i < f->of->count; i++) {
        double basis[K] = {0};
        const int first = bat_min_int(i, last);
        basis[i - first] = 1;
        add_row(f, first, basis, -1, f->quadratic[i] / f->of->within, HUGE_VAL);
    }
}

static void add_signs(bat_line_program *f)
{
    double basis[K];
    for (int k = 0; k < f->sample_count; k++) {
        const int first = basis_at(f->of, f->sample[k], 2, basis);
        const double bend =
            bat_loft_line_at(f->of, f->quadratic, f->sample[k], 2) / f->of->within;
        add_row(f, first, basis, -f->signs[k], f->signs[k] * bend, price_of_sign);
    }
}

/* ---- solving ---- */

static double mean_diagonal(const bat_line_program *f)
{
    double sum = 0;
    for (int i = 0; i < f->unknowns; i++)
        sum += f->hessian[i * (P + 1) + P] / f->unknowns;
    return sum;
}

batten_status bat_line_solve_freely(bat_line_program *f, double *factor, bool *holds)
{
    double *x = f->x + f->first;
    memcpy(factor, f->hessian, (size_t)f->unknowns * K * sizeof *factor);
    const batten_status status = bat_symmetric_factor(f->unknowns, P, factor);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < f->unknowns; i++)
        x[i] = -f->linear[i];
    bat_symmetric_solve(f->unknowns, P, factor, 1, x);
    *holds = true;
    for (int i = 0; i < f->row_count && *holds; i++) {
        double sum = 0;
        for (int k = f->start[i]; k < f->start[i + 1]; k++)
            sum += f->value[k] * x[f->column[k]];
        *holds = sum <= f->bounds[i];
    }
    return BATTEN_OK;
}

batten_status bat_line_solve(bat_line_program *f)
{
    double *duals = bat_array((size_t)f->row_count, 2 * sizeof *duals);
    if (!duals)
        return BATTEN_OUT_OF_MEMORY;
    const double mean = mean_diagonal(f);
    for (int i = 0; i < f->row_count; i++)
        f->prices[i] *= mean;
    const bat_convex_program program = {f->unknowns,
                                        P,
                                        f->hessian,
                                        f->linear,
                                        {f->row_count, f->start, f->column, f->value},
                                        f->bounds,
                                        f->prices};
    bat_convex_solution out = {f->x + f->first, duals, duals + f->row_count};
    bat_convex_report report;
    const batten_status status = bat_convex_program_solve(&program, NULL, &out, &report);
    bat_release(duals);
    return status;
}

void bat_line_build(bat_line_program *f, bool signs)
{
    memset(f->hessian, 0, (size_t)f->of->count * K * sizeof *f->hessian);
    memset(f->linear, 0, (size_t)f->of->count * sizeof *f->linear);
    f->row_count = 0;
    add_energy(f);
    add_data(f);
    if (f->of->one_side)
        add_side(f);
    if (signs)
        add_signs(f);
}
