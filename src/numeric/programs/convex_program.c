/*
 * Convex programs in a band, by Mehrotra's predictor and corrector.
 *
 * With slacks s and multipliers z of the rows, and for rows with a price their excess t and its
 * multiplier q = price - z, the conditions are
 *
 *     H x + c + At z = 0,   A x - t + s = b,   s z = 0,   t q = 0,   s, z, t, q >= 0.
 *
 * Newton's step eliminates the rows one by one: (H + At D^-1 A) dx = right side, with
 * D = s / z + t / q, which keeps the band of H.
 */
#include "base/arena.h"
#include "base/sort.h"
#include "numeric/programs/convex_system.h"

#include <float.h>

enum { MOST_ITERATIONS = 80 };

/* Of the way to where a number would become zero, so much is gone: the customary share. */
static const double share_of_step = 0.995;

/* What is aimed at: how far rows may miss their bounds, against them, the gradient be off
 * against its terms, and the gap be open against the objective. Where rounding ends the search
 * before, ten thousand times as much is an answer still. */
static const double row_tolerance = 1e-10, gradient_tolerance = 1e-9, gap_tolerance = 1e-10;
static const double stalled_factor = 1e4;

/* Slacks and multipliers do not fall below: their quotients stay finite. */
static const double least_value = 1e-100;

/* ---- the start ---- */

static batten_status take_memory(bat_convex_system *p, bat_arena *arena)
{
    const size_t n = (size_t)p->n, m = (size_t)p->m, size = sizeof(double);
    double **const of_rows[] = {&p->norm,   &p->bound,  &p->price,  &p->at.s,   &p->at.z,
                                &p->at.t,   &p->at.q,   &p->step.s, &p->step.z, &p->step.t,
                                &p->step.q, &p->missed, &p->middle, &p->right,  &p->best_z};
    double **const of_unknowns[] = {&p->x, &p->dx, &p->unmet, &p->sum, &p->best_x};
    for (size_t i = 0; i < sizeof of_rows / sizeof of_rows[0]; i++)
        *of_rows[i] = bat_arena_array(arena, m, size);
    for (size_t i = 0; i < sizeof of_unknowns / sizeof of_unknowns[0]; i++)
        *of_unknowns[i] = bat_arena_array(arena, n, size);
    p->factor = bat_arena_array(arena, n * ((size_t)p->of->band + 1), size);
    return bat_arena_status(arena);
}

/* The median of those that are not 0, of ascending sizes; 1 where all are. */
static double median_size(int count, const double *sizes)
{
    int zeros = 0;
    while (zeros < count && sizes[zeros] == 0)
        zeros++;
    return zeros < count ? sizes[(zeros + count) / 2] : 1;
}

/* Divide the objective by its mean diagonal and every row by its norm. */
static batten_status scale_program(bat_convex_system *p)
{
    const bat_convex_program *of = p->of;
    for (int i = 0; i < p->n; i++)
        p->unit += of->hessian[(size_t)i * ((size_t)of->band + 1) + (size_t)of->band] / p->n;
    if (!(p->unit > 0) || !isfinite(p->unit))
        return bat_fail(BATTEN_SINGULAR_SYSTEM, "the objective of a convex program is flat");
    for (int i = 0; i < p->m; i++) {
        double square = 0;
        for (int k = of->rows.start[i]; k < of->rows.start[i + 1]; k++)
            square += of->rows.value[k] * of->rows.value[k];
        p->norm[i] = square > 0 ? sqrt(square) : 1;
        p->bound[i] = of->bounds[i] / p->norm[i];
        p->price[i] = of->prices ? of->prices[i] * p->norm[i] / p->unit : HUGE_VAL;
        p->right[i] = fabs(p->bound[i]);
        p->priced += bat_convex_has_price(p, i);
    }
    bat_sort_doubles((size_t)p->m, p->right);
    p->size = median_size(p->m, p->right);
    return BATTEN_OK;
}

/* Slacks of a hundredth of the largest bound, and multipliers of the size of the gradient. */
static void start_cold(bat_convex_system *p)
{
    const double room = 1e-2 * p->size;
    double pull = 1e-3;
    for (int i = 0; i < p->n; i++)
        pull = bat_max(pull, fabs(p->of->linear[i]) / p->unit);
    for (int i = 0; i < p->m; i++) {
        p->at.t[i] = bat_convex_has_price(p, i) ? room : 0;
        p->at.s[i] = bat_max(p->bound[i] + p->at.t[i] - bat_convex_row_times(p, i, p->x), room);
        p->at.z[i] = bat_convex_has_price(p, i) ? bat_min(p->price[i] / 2, pull) : pull;
        p->at.q[i] = bat_convex_has_price(p, i) ? p->price[i] - p->at.z[i] : 0;
    }
}

/*
 * From the solution of a neighbouring program, moved off the faces of its feasible set: s z = t q
 * = 1e-8 at least, of an objective of unit size. Larger numbers cost iterations (1e-4 doubles
 * them), smaller ones are too near the faces to leave them. Source: [YW02].
 */
static void start_warm(bat_convex_system *p, const bat_convex_solution *warm)
{
    const double least = 1e-8;
    memcpy(p->x, warm->x, (size_t)p->n * sizeof *p->x);
    for (int i = 0; i < p->m; i++) {
        const double slack = bat_max(p->bound[i] - bat_convex_row_times(p, i, p->x), 0);
        double z = warm->multipliers[i] * p->norm[i] / p->unit;
        z = bat_max(z, least / bat_max(slack, 1e-3 * sqrt(least)));
        if (bat_convex_has_price(p, i)) /* a millionth below the price: q stays above 0 */
            z = bat_min(z, p->price[i] * (1 - 1e-6));
        p->at.z[i] = z;
        p->at.s[i] = bat_max(slack, least / z);
        p->at.q[i] = bat_convex_has_price(p, i) ? p->price[i] - z : 0;
        p->at.t[i] =
            bat_convex_has_price(p, i) ? bat_min(1e-2 * p->size, least / p->at.q[i]) : 0;
    }
}

/* ---- an iteration ---- */

static double objective(const bat_convex_system *p)
{
    double sum = 0;
    bat_convex_hessian_times(p, p->x, p->sum);
    for (int i = 0; i < p->n; i++)
        sum += p->x[i] * (p->sum[i] / 2 + p->of->linear[i] / p->unit);
    return sum;
}

static void keep_best(bat_convex_system *p)
{
    p->best = p->merit;
    p->best_report = p->report;
    memcpy(p->best_x, p->x, (size_t)p->n * sizeof *p->x);
    memcpy(p->best_z, p->at.z, (size_t)p->m * sizeof *p->at.z);
}

/* What the conditions are missed by. */
static void measure_conditions(bat_convex_system *p)
{
    double largest = 0, violated = 0, terms = DBL_MIN, products = 0;
    const double size = bat_max(p->size, DBL_MIN), worth = fabs(objective(p));
    for (int i = 0; i < p->n; i++)
        p->unmet[i] = 0;
    for (int i = 0; i < p->m; i++) {
        p->missed[i] = bat_convex_row_times(p, i, p->x) - p->at.t[i] + p->at.s[i] - p->bound[i];
        violated = bat_max(violated, fabs(p->missed[i]) / bat_max(size, fabs(p->bound[i])));
        products += p->at.s[i] * p->at.z[i] + p->at.t[i] * p->at.q[i];
        terms = bat_max(terms, p->at.z[i]); /* rows are normed */
        bat_convex_add_row(p, i, p->at.z[i], p->unmet);
    }
    for (int i = 0; i < p->n; i++) {
        const double pull = p->of->linear[i] / p->unit;
        terms = bat_max(terms, fabs(pull));
        p->unmet[i] += p->sum[i] + pull;
        largest = bat_max(largest, fabs(p->unmet[i]));
    }
    p->mean = products / bat_max(1, p->m + p->priced);
    p->report.violated = violated;
    p->report.unmet = largest / terms;
    p->report.gap = products / bat_max(worth, terms * size);
    p->merit =
        bat_max(bat_max(p->report.violated / row_tolerance, p->report.gap / gap_tolerance),
                p->report.unmet / gradient_tolerance);
    if (p->merit < p->best)
        keep_best(p);
}

static double room_of(const double *at, const double *step, int i, double before)
{
    return step[i] < 0 ? bat_min(before, -at[i] / step[i]) : before;
}

/* How far the step may go before a number becomes negative: x, s and t; z and q. */
static void find_lengths(const bat_convex_system *p, double *primal, double *dual)
{
    *primal = *dual = 1;
    for (int i = 0; i < p->m; i++) {
        *primal = room_of(p->at.s, p->step.s, i, *primal);
        *dual = room_of(p->at.z, p->step.z, i, *dual);
        if (bat_convex_has_price(p, i)) {
            *primal = room_of(p->at.t, p->step.t, i, *primal);
            *dual = room_of(p->at.q, p->step.q, i, *dual);
        }
    }
}

/* The mean product that the predictor would leave, against today's. */
static double share_left(const bat_convex_system *p, double primal, double dual)
{
    double sum = 0;
    for (int i = 0; i < p->m; i++) {
        sum += (p->at.s[i] + primal * p->step.s[i]) * (p->at.z[i] + dual * p->step.z[i]);
        if (bat_convex_has_price(p, i))
            sum += (p->at.t[i] + primal * p->step.t[i]) * (p->at.q[i] + dual * p->step.q[i]);
    }
    return p->m > 0 ? sum / (p->m + p->priced) / p->mean : 0;
}

static void advance(double *at, const double *step, int i, double share)
{
    at[i] = bat_max(at[i] + share * step[i], least_value);
}

static void walk(bat_convex_system *p, double primal, double dual)
{
    for (int i = 0; i < p->n; i++)
        p->x[i] += primal * p->dx[i];
    for (int i = 0; i < p->m; i++) {
        advance(p->at.s, p->step.s, i, primal);
        advance(p->at.z, p->step.z, i, dual);
        if (bat_convex_has_price(p, i)) {
            advance(p->at.t, p->step.t, i, primal);
            advance(p->at.q, p->step.q, i, dual);
        }
    }
}

static batten_status iterate(bat_convex_system *p)
{
    double primal, dual;
    const batten_status status = bat_convex_factor(p);
    if (status != BATTEN_OK)
        return status;
    bat_convex_find_step(p, 0, false);
    find_lengths(p, &primal, &dual);
    const double left = share_left(p, primal, dual);
    bat_convex_find_step(p, left * left * left * p->mean, true);
    find_lengths(p, &primal, &dual);
    walk(p, primal < 1 ? share_of_step * primal : 1, dual < 1 ? share_of_step * dual : 1);
    return BATTEN_OK;
}

/* ---- the whole ---- */

/* The rows cannot hold together when they are still missed by more than a thousandth. */
static batten_status say_why_not(const bat_convex_system *p)
{
    if (p->report.violated > 1e-3)
        return bat_fail(
            BATTEN_NOT_COMPATIBLE,
            "%d conditions cannot hold together: the worst misses its bound by %g of it", p->m,
            p->report.violated);
    return bat_fail(
        BATTEN_INCOMPLETE,
        "a convex program of %d unknowns did not reach its minimum in %d iterations: "
        "a gap of %g is left",
        p->n, p->report.iterations, p->report.gap);
}

static void write_solution(const bat_convex_system *p, bat_convex_solution *out)
{
    memcpy(out->x, p->best_x, (size_t)p->n * sizeof *p->best_x);
    for (int i = 0; i < p->m; i++) {
        const double beyond = bat_convex_row_times(p, i, p->best_x) - p->bound[i];
        out->multipliers[i] = p->best_z[i] * p->unit / p->norm[i];
        out->beyond[i] = bat_convex_has_price(p, i) ? bat_max(beyond, 0) * p->norm[i] : 0;
    }
}

/* Rounding has taken over: an answer is there, and the last iteration did not improve it. */
static bool has_stalled(const bat_convex_system *p)
{
    return !isfinite(p->merit) || (p->best <= stalled_factor && p->merit > p->best);
}

static batten_status minimise(bat_convex_system *p, const bat_convex_solution *warm)
{
    batten_status status = scale_program(p);
    if (status != BATTEN_OK)
        return status;
    if (warm)
        start_warm(p, warm);
    else
        start_cold(p);
    measure_conditions(p);
    while (status == BATTEN_OK && p->best > 1 && p->report.iterations < MOST_ITERATIONS &&
           !has_stalled(p)) {
        status = iterate(p);
        p->report.iterations++;
        measure_conditions(p);
    }
    p->best_report.iterations = p->report.iterations;
    p->report = p->best_report;
    if (p->best <= stalled_factor)
        return BATTEN_OK;
    return status == BATTEN_OK || status == BATTEN_SINGULAR_SYSTEM ? say_why_not(p) : status;
}

batten_status bat_convex_program_solve(const bat_convex_program *program,
                                       const bat_convex_solution *warm,
                                       bat_convex_solution *out, bat_convex_report *report)
{
    bat_arena arena = {0};
    bat_convex_system p = {
        .of = program, .n = program->count, .m = program->rows.count, .best = HUGE_VAL};
    batten_status status = take_memory(&p, &arena);
    if (status == BATTEN_OK)
        status = minimise(&p, warm);
    if (status == BATTEN_OK)
        write_solution(&p, out);
    *report = p.report;
    bat_arena_free(&arena);
    return status;
}
