/* The program of one round of a lofting: unknowns, energy, squares and rows. */
#include "loft/program.h"
#include "base/list.h"
#include "numeric/quadrature.h"
#include "spline/spline.h"

enum { P = BAT_LOFT_DEGREE, K = BAT_LOFT_SUPPORT, NODES = 4, GRAM = 2 * P + 1 };

/* ---- unknowns ---- */

static void number_unknowns(bat_loft_program *p)
{
    const int total = 3 * p->patch->nu * p->patch->nv;
    for (int k = 0; k < total; k++)
        p->unknown[k] = p->held[k] ? -1 : p->count++;
}

/* How far apart the numbers of two unknowns are at most that one place depends on. */
static int widest_band(const bat_loft_program *p)
{
    const int nv = p->patch->nv, total = 3 * p->patch->nu * nv, reach = 3 * (P * nv + P) + 2;
    int band = 0;
    for (int a = 0, b = 0; a < total; a++) {
        b = bat_min_int(total - 1, a + reach);
        while (b > a && p->unknown[b] < 0)
            b--;
        if (p->unknown[a] >= 0)
            band = bat_max_int(band, p->unknown[b] - p->unknown[a]);
    }
    return band;
}

batten_status bat_loft_program_make(const bat_loft_patch *patch, const bool *held, double unit,
                                    bat_loft_program *out)
{
    bat_loft_program p = {.patch = patch, .held = held, .unit = unit};
    p.unknown = bat_array3((size_t)patch->nu, (size_t)patch->nv, 3 * sizeof *p.unknown);
    if (!p.unknown)
        return BATTEN_OUT_OF_MEMORY;
    number_unknowns(&p);
    p.band = widest_band(&p);
    p.hessian = bat_array3((size_t)p.count, (size_t)p.band + 1, sizeof *p.hessian);
    p.linear = bat_array((size_t)p.count, sizeof *p.linear);
    if (!p.hessian || !p.linear) {
        bat_loft_program_free(&p);
        return BATTEN_OUT_OF_MEMORY;
    }
    *out = p;
    return BATTEN_OK;
}

void bat_loft_program_free(bat_loft_program *program)
{
    bat_release(program->unknown);
    bat_release(program->hessian);
    bat_release(program->linear);
    bat_release(program->start);
    bat_release(program->column);
    bat_release(program->value);
    bat_release(program->bounds);
    bat_release(program->prices);
    *program = (bat_loft_program){0};
}

static void add_to_hessian(bat_loft_program *p, int a, int b, double value)
{
    if (a >= b)
        p->hessian[(size_t)a * ((size_t)p->band + 1) + (size_t)(p->band - a + b)] += value;
}

/* ---- energy ---- */

/* gram [order][count][2 p + 1]: the integrals of N_i^(order) N_j^(order), j = i - p .. i + p. */
static void integrate_products(int count, const double *knots, double *gram)
{
    double node[NODES], weight[NODES], basis[(P + 1) * K];
    bat_gauss(NODES, node, weight);
    for (int span = P; span < count; span++) {
        const double a = knots[span], h = knots[span + 1] - a;
        for (int g = 0; g < NODES && h > 0; g++) {
            bat_basis(P, knots, span, a + h * (1 + node[g]) / 2, P, basis);
            for (int order = 0; order <= P; order++)
                for (int i = 0; i < K; i++)
                    for (int j = 0; j < K; j++)
                        gram[((size_t)order * (size_t)count + (size_t)(span - P + i)) * GRAM +
                             (size_t)(P + j - i)] +=
                            h / 2 * weight[g] * basis[order * K + i] * basis[order * K + j];
        }
    }
}

typedef struct {
    int nu, nv;
    double *u, *v; /* as of integrate_products */
} products;

static batten_status products_make(const bat_loft_patch *patch, products *out)
{
    products made = {.nu = patch->nu, .nv = patch->nv};
    made.u = bat_array3((size_t)patch->nu, (P + 1) * GRAM, sizeof *made.u);
    made.v = bat_array3((size_t)patch->nv, (P + 1) * GRAM, sizeof *made.v);
    if (!made.u || !made.v) {
        bat_release(made.u);
        bat_release(made.v);
        return BATTEN_OUT_OF_MEMORY;
    }
    integrate_products(patch->nu, patch->u_knots, made.u);
    integrate_products(patch->nv, patch->v_knots, made.v);
    *out = made;
    return BATTEN_OK;
}

static void products_free(products *p)
{
    bat_release(p->u);
    bat_release(p->v);
}

/* The entry of J3 between N_i N_j and N_(i + di) N_(j + dj). */
static double energy_entry(const products *p, int i, int di, int j, int dj)
{
    double sum = 0;
    for (int a = 0; a <= P; a++)
        sum += (a == 0 || a == P ? 1 : 3) *
               p->u[((size_t)a * (size_t)p->nu + (size_t)i) * GRAM + (size_t)(P + di)] *
               p->v[((size_t)(P - a) * (size_t)p->nv + (size_t)j) * GRAM + (size_t)(P + dj)];
    return sum;
}

/* Calls `visit` for each pair of neighbouring control points with their entry of J3. */
typedef void (*pair_visitor)(void *context, int a, int b, double entry);

static void visit_pairs(const products *p, pair_visitor visit, void *context)
{
    for (int i = 0; i < p->nu; i++)
        for (int j = 0; j < p->nv; j++)
            for (int k = bat_max_int(0, i - P); k < bat_min_int(p->nu, i + K); k++)
                for (int l = bat_max_int(0, j - P); l < bat_min_int(p->nv, j + K); l++)
                    visit(context, i * p->nv + j, k * p->nv + l,
                          energy_entry(p, i, k - i, j, l - j));
}

typedef struct {
    bat_loft_program *program;
    double factor;
} energy_context;

static void add_pair(void *context, int a, int b, double entry)
{
    const energy_context *e = context;
    bat_loft_program *p = e->program;
    for (int c = 0; c < 3; c++) {
        const int row = p->unknown[3 * a + c], column = p->unknown[3 * b + c];
        if (row < 0)
            continue;
        p->linear[row] += e->factor * p->unit * entry * p->patch->points[3 * b + c];
        if (column >= 0)
            add_to_hessian(p, row, column, e->factor * p->unit * p->unit * entry);
    }
}

/* The gradient of factor J3 / 2 belongs to the square of the objective: J3 counts twice. */
batten_status bat_loft_add_energy(bat_loft_program *program, double factor)
{
    products made;
    energy_context context = {program, 2 * factor};
    const batten_status status = products_make(program->patch, &made);
    if (status != BATTEN_OK)
        return status;
    visit_pairs(&made, add_pair, &context);
    products_free(&made);
    return BATTEN_OK;
}

typedef struct {
    const double *points;
    double sum;
} energy_sum;

static void sum_pair(void *context, int a, int b, double entry)
{
    energy_sum *e = context;
    for (int c = 0; c < 3; c++)
        e->sum += entry * e->points[3 * a + c] * e->points[3 * b + c];
}

batten_status bat_loft_energy(const bat_loft_patch *patch, double *out)
{
    products made;
    energy_sum context = {patch->points, 0};
    const batten_status status = products_make(patch, &made);
    if (status != BATTEN_OK)
        return status;
    visit_pairs(&made, sum_pair, &context);
    products_free(&made);
    *out = context.sum;
    return BATTEN_OK;
}

/* A row that moves of so many units do not reach never binds. */
static const double most_distance = 1e6;

/* ---- squares and rows ---- */

enum { MOST_ENTRIES = 3 * K * K };

/* The entries of a measure at a place: unknowns ascending, values in units of the program. */
static int list_entries(const bat_loft_program *p, const bat_loft_place *place,
                        const bat_loft_measure *m, int column[MOST_ENTRIES],
                        double value[MOST_ENTRIES])
{
    int count = 0;
    for (int a = 0; a < K; a++)
        for (int b = 0; b < K; b++) {
            double sum = 0;
            for (int du = 0; du <= 2; du++)
                for (int dv = 0; dv <= 2 - du; dv++)
                    sum += m->weight[du][dv] * place->along_u[du][a] * place->along_v[dv][b];
            const int point = (place->i + a) * p->patch->nv + place->j + b;
            for (int c = 0; c < 3; c++) {
                const int unknown = p->unknown[3 * point + c];
                const double entry = sum * m->vector[c] * p->unit;
                if (unknown < 0 || entry == 0)
                    continue;
                column[count] = unknown;
                value[count++] = entry;
            }
        }
    return count;
}

void bat_loft_add_square(bat_loft_program *program, const bat_loft_place *place,
                         const bat_loft_measure *measure, double factor, double missing)
{
    int column[MOST_ENTRIES];
    double value[MOST_ENTRIES];
    const int count = list_entries(program, place, measure, column, value);
    for (int a = 0; a < count; a++) {
        program->linear[column[a]] -= factor * missing * value[a];
        for (int b = 0; b <= a; b++)
            add_to_hessian(program, column[a], column[b], factor * value[a] * value[b]);
    }
}

/* All or nothing: a row of so many entries, which the caller fills in. */
static batten_status append_row(bat_loft_program *p, int count, double bound, double price)
{
    batten_status status = BAT_LIST_GROW(p->start, p->start_count, p->start_room, 1);
    if (status == BATTEN_OK)
        status = BAT_LIST_GROW(p->bounds, p->bound_count, p->bound_room, 1);
    if (status == BATTEN_OK)
        status = BAT_LIST_GROW(p->prices, p->price_count, p->price_room, 1);
    if (status == BATTEN_OK)
        status = BAT_LIST_GROW(p->column, p->entry_count, p->column_room, count);
    if (status == BATTEN_OK)
        status = BAT_LIST_GROW(p->value, p->entry_count, p->entry_room, count);
    if (status != BATTEN_OK)
        return status;
    p->start[p->start_count++] = p->entry_count;
    p->bounds[p->bound_count++] = bound;
    p->prices[p->price_count++] = price;
    return BATTEN_OK;
}

batten_status bat_loft_add_row(bat_loft_program *program, const bat_loft_place *place,
                               const bat_loft_measure *measure, double bound, double price)
{
    bat_loft_program *p = program;
    int column[MOST_ENTRIES];
    double value[MOST_ENTRIES], square = 0;
    const int count = list_entries(p, place, measure, column, value);
    for (int k = 0; k < count; k++)
        square += value[k] * value[k];
    const double norm = sqrt(square);
    if (!(fabs(bound) < most_distance * norm))
        return BATTEN_OK;
    const batten_status status = append_row(p, count, bound / norm, price);
    for (int k = 0; k < count && status == BATTEN_OK; k++) {
        p->column[p->entry_count] = column[k];
        p->value[p->entry_count++] = value[k] / norm;
    }
    return status;
}

batten_status bat_loft_limit_moves(bat_loft_program *program, double most)
{
    bat_loft_program *p = program;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 * p->count && status == BATTEN_OK; k++) {
        status = append_row(p, 1, most / p->unit, HUGE_VAL);
        if (status == BATTEN_OK) {
            p->column[p->entry_count] = k / 2;
            p->value[p->entry_count++] = k % 2 == 0 ? 1 : -1;
        }
    }
    return status;
}

/* ---- solving ---- */

/* Prices are of an objective whose diagonal is 1 in the mean; and every direction costs a little,
 * so that those of which nothing speaks stay where they are. */
static void finish_objective(bat_loft_program *p)
{
    const size_t w = (size_t)p->band + 1;
    double mean = 0;
    for (int i = 0; i < p->count; i++)
        mean += p->hessian[(size_t)i * w + w - 1] / p->count;
    for (int i = 0; i < p->count; i++)
        /* four digits above the rounding of the sums in a row */
        p->hessian[(size_t)i * w + w - 1] += 1e-12 * mean;
    for (int i = 0; i < p->price_count; i++)
        p->prices[i] *= mean;
}

static void move_points(const bat_loft_program *p, const double *x, double *points)
{
    const int total = 3 * p->patch->nu * p->patch->nv;
    for (int k = 0; k < total; k++)
        if (p->unknown[k] >= 0)
            points[k] += p->unit * x[p->unknown[k]];
}

batten_status bat_loft_program_move(bat_loft_program *program, double *points, double *slack,
                                    bat_convex_report *report)
{
    bat_loft_program *p = program;
    finish_objective(p);
    const size_t m = (size_t)p->bound_count;
    double *values = bat_array((size_t)p->count + 2 * m, sizeof *values);
    batten_status status =
        values ? BAT_LIST_ADD(p->start, p->start_count, p->start_room, p->entry_count)
               : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        const bat_convex_program program_of = {
            p->count,  p->band,  p->hessian, p->linear, {(int)m, p->start, p->column, p->value},
            p->bounds, p->prices};
        bat_convex_solution out = {values, values + p->count, values + (size_t)p->count + m};
        status = bat_convex_program_solve(&program_of, NULL, &out, report);
        if (status == BATTEN_INCOMPLETE) /* next to no room between the bounds */
            status =
                bat_fail(BATTEN_NOT_COMPATIBLE,
                         "the bounds leave so little room that %d iterations do not find it",
                         report->iterations);
        *slack = 0;
        for (size_t i = 0; i < m; i++)
            *slack = bat_max(*slack, out.beyond[i]);
        if (status == BATTEN_OK)
            move_points(p, values, points);
    }
    bat_release(values);
    return status;
}
