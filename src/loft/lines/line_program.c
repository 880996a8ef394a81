/* The program of a line: squares, rows, and how it is solved. */
#include "loft/lines/line_program.h"
#include "numeric/banded.h"
#include "numeric/programs/convex_program.h"
#include "numeric/vector.h"
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

/* ---- runs ---- */

/* Where a coefficient stands among those that are free to differ; within a run it is `share` of
 * the way from that one to the next. */
static int place_of(const bat_loft_line *line, int i, double *share)
{
    int gone = 0;
    *share = 0;
    for (int k = 0; k < line->run_count && i > line->runs[k].first; k++) {
        const bat_straight_run *run = line->runs + k;
        if (i < run->last) {
            const double from = bat_greville(P, line->knots, run->first),
                         to = bat_greville(P, line->knots, run->last);
            *share = (bat_greville(P, line->knots, i) - from) / (to - from);
            return run->first - gone;
        }
        gone += run->last - run->first - 1;
    }
    return i - gone;
}

void bat_loft_line_straighten(const bat_loft_line *line, double *f)
{
    for (int k = 0; k < line->run_count; k++)
        for (int i = line->runs[k].first + 1; i < line->runs[k].last; i++) {
            double share;
            place_of(line, i, &share);
            f[i] = (1 - share) * f[line->runs[k].first] + share * f[line->runs[k].last];
        }
}

/* From those that are free to differ, in front, to all: from the last on none is overwritten that
 * is still needed. */
static void spread_out(bat_line_program *f)
{
    if (f->of->pinned[1])
        f->x[f->first + f->unknowns] = f->x[f->of->count - 1];
    for (int i = f->of->count - 1; i >= 0 && f->of->run_count > 0; i--) {
        double share;
        const int place = place_of(f->of, i, &share);
        f->x[i] = share > 0 ? (1 - share) * f->x[place] + share * f->x[place + 1] : f->x[place];
    }
}

/* A measure of four coefficients as one of those that are free to differ, from `first` on. */
typedef struct {
    int first;
    double basis[K];
} measure;

static measure gather_free(const bat_loft_line *line, int first, const double *basis)
{
    double share;
    measure out = {.first = place_of(line, first, &share)};
    for (int k = 0; k < K; k++) {
        const int at = place_of(line, first + k, &share) - out.first;
        out.basis[at] += (1 - share) * basis[k];
        if (share > 0)
            out.basis[at + 1] += share * basis[k];
    }
    return out;
}

/* The value of a pinned one. */
static double pinned(const bat_line_program *f, int place)
{
    return f->x[place < f->first ? 0 : f->of->count - 1];
}

/* ---- squares and rows ---- */

/* Add factor (basis . x - target)^2 / 2; what is pinned moves to the right side. */
static void add_square(bat_line_program *f, int first, const double *basis, double factor,
                       double target)
{
    const measure m = gather_free(f->of, first, basis);
    for (int a = 0; a < K; a++) {
        const int i = m.first + a - f->first;
        if (m.basis[a] != 0 && (i < 0 || i >= f->unknowns))
            target -= m.basis[a] * pinned(f, m.first + a);
    }
    for (int a = 0; a < K; a++) {
        const int i = m.first + a - f->first;
        if (i < 0 || i >= f->unknowns)
            continue;
        f->linear[i] -= factor * target * m.basis[a];
        for (int b = bat_max_int(0, a - i); b <= a; b++)
            f->hessian[i * (P + 1) + P - a + b] += factor * m.basis[a] * m.basis[b];
    }
}

/* Below this share of its terms a norm is their rounding: of f'' within a run. */
static const double least_norm = 1e-10;

static void add_row(bat_line_program *f, int first, const double *basis, double sign,
                    double bound, double price)
{
    const measure m = gather_free(f->of, first, basis);
    double square = 0;
    for (int k = 0; k < K; k++) {
        const int i = m.first + k - f->first;
        if (i >= 0 && i < f->unknowns)
            square += m.basis[k] * m.basis[k];
        else if (m.basis[k] != 0)
            bound -= sign * m.basis[k] * pinned(f, m.first + k);
    }
    const double norm = sqrt(square);
    int end = f->start[f->row_count];
    if (!(norm > least_norm * bat_norm(K, basis))) {
        f->impossible |= price == HUGE_VAL && bound < 0;
        return;
    }
    for (int k = 0; k < K; k++) {
        const int i = m.first + k - f->first;
        if (i < 0 || i >= f->unknowns)
            continue;
        f->column[end] = i;
        f->value[end++] = sign * m.basis[k] / norm;
    }
    f->bounds[f->row_count] = bound / norm;
    f->prices[f->row_count] = price;
    f->start[++f->row_count] = end;
}

/* Of f''', which is constant on a span, of unit size; that of the quadratic is 0 but where runs
 * straighten it. */
static void add_energy(bat_line_program *f)
{
    const double *knots = f->of->knots, scale = f->of->within / f->size;
    double basis[K];
    for (int span = P; span < f->of->count; span++) {
        const double h = knots[span + 1] - knots[span], middle = knots[span] + h / 2;
        const int first = basis_at(f->of, middle, P, basis);
        const double own =
            f->of->run_count > 0 ? bat_loft_line_at(f->of, f->quadratic, middle, P) : 0;
        add_square(f, first, basis, 2 * f->smooth * h * scale * scale, -own / f->of->within);
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
        const double room = line->rooms ? line->rooms[k] : 1, bound = share_of_bound * room;
        add_square(f, first, basis, 2 / (room * room), f->missing[k]);
        add_row(f, first, basis, 1, f->missing[k] + bound, HUGE_VAL);
        add_row(f, first, basis, -1, -f->missing[k] + bound, HUGE_VAL);
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
    *holds = !f->impossible;
    for (int i = 0; i < f->row_count && *holds; i++) {
        double sum = 0;
        for (int k = f->start[i]; k < f->start[i + 1]; k++)
            sum += f->value[k] * x[f->column[k]];
        *holds = sum <= f->bounds[i];
    }
    spread_out(f);
    return BATTEN_OK;
}

batten_status bat_line_solve(bat_line_program *f)
{
    if (f->impossible)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the ends of a straight line leave no way");
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
    if (status == BATTEN_OK)
        spread_out(f);
    return status;
}

void bat_line_build(bat_line_program *f, bool signs)
{
    memset(f->hessian, 0, (size_t)f->of->count * K * sizeof *f->hessian);
    memset(f->linear, 0, (size_t)f->of->count * sizeof *f->linear);
    f->row_count = 0;
    f->impossible = false;
    add_energy(f);
    add_data(f);
    if (f->of->one_side)
        add_side(f);
    if (signs)
        add_signs(f);
}
