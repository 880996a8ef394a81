/* The rows and squares of the program of fairing by least change. */
#include "fair/least_change.h"
#include "numeric/programs/convex_program.h"
#include "spline/curve/curve.h"

#include <string.h>

enum { P = 3, SUPPORT = BAT_CHANGE_SUPPORT, SIDES = 16 };

/* What a wrong sign costs against the mean of the squares: so much that only bounds withstand. */
static const double price_of_sign = 1e3;
/* A program uses so much of a bound: the rest is for rounding. */
static const double share_of_bound = 1 - 1e-6;
/* Curvature stays so far from the other sign that a move of this part of the largest bound does not bring it there: else what
 * reads the curve would count roundings as inflections. */
static const double margin = 1e-5;
/* Held ducks may leave their places by so much of the largest bound while a program is solved. */
static const double room_of_held = 1e-7;

batten_status bat_change_begin(const bat_fair_piece *piece, bat_least_change *out)
{
    const int n = piece->batten->count, w = piece->ducks.width;
    bat_least_change *c = out;
    *c = (bat_least_change){.piece = piece, .ducks = n, .width = w};
    if (n > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d points between corners are more than %d", n,
                        BAT_MAX_POINTS);
    const int unknowns = n * w, rows_of_duck = w == 1 ? 3 : SIDES + 3;
    c->row_room = rows_of_duck * n;
    c->entry_room = c->row_room * SUPPORT * w;
    c->knots = bat_arena_array(&c->arena, (size_t)n + 6, sizeof *c->knots);
    c->bend = bat_arena_array(&c->arena, (size_t)(3 * n * w), sizeof *c->bend);
    c->moments = bat_arena_array(&c->arena, (size_t)unknowns, sizeof *c->moments);
    c->signs = bat_arena_array(&c->arena, (size_t)n, sizeof *c->signs);
    c->start = bat_arena_array(&c->arena, (size_t)c->row_room + 1, sizeof *c->start);
    c->column = bat_arena_array(&c->arena, (size_t)c->entry_room, sizeof *c->column);
    c->value = bat_arena_array(&c->arena, (size_t)c->entry_room, sizeof *c->value);
    c->bounds = bat_arena_array(&c->arena, (size_t)c->row_room, sizeof *c->bounds);
    c->prices = bat_arena_array(&c->arena, (size_t)c->row_room, sizeof *c->prices);
    c->hessian =
        bat_arena_array(&c->arena, (size_t)(unknowns * SUPPORT * w), sizeof *c->hessian);
    c->linear = bat_arena_array(&c->arena, (size_t)unknowns, sizeof *c->linear);
    c->x = bat_arena_array(&c->arena, (size_t)unknowns, sizeof *c->x);
    const batten_status status = bat_arena_status(&c->arena);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < n + 6; i++)
        c->knots[i] = piece->batten->t[bat_max_int(0, bat_min_int(i - P, n - 1))];
    for (int i = 0; i < n; i++)
        c->unit = bat_max(c->unit, piece->ducks.within[i]);
    return BATTEN_OK;
}

static double times(const bat_least_change *c, const bat_change_row *row, int coordinate)
{
    double sum = 0;
    for (int k = 0; k < SUPPORT; k++)
        sum += row->weight[k] * c->x[(row->first + k) * c->width + coordinate];
    return sum;
}

/* ---- squares and rows ---- */

/* Squares of the moves over their bounds. */
static void add_squares(bat_least_change *c, const double *z)
{
    const bat_ducks *ducks = &c->piece->ducks;
    const int w = c->width, row_size = SUPPORT * w;
    for (int i = 0; i < c->ducks; i++) {
        const bat_change_row row = bat_change_row_at(c, i, 0);
        const double part = ducks->within[i] > 0 ? c->unit / ducks->within[i] : 1;
        const double factor = 2 * part * part;
        for (int k = 0; k < w; k++) {
            const double missing = (z[i * w + k] - ducks->centre[i * w + k]) / c->unit;
            for (int a = 0; a < SUPPORT; a++) {
                const int at = (row.first + a) * w + k;
                c->linear[at] += factor * missing * row.weight[a];
                for (int b = 0; b <= a; b++)
                    c->hessian[at * row_size + row_size - 1 - (a - b) * w] +=
                        factor * row.weight[a] * row.weight[b];
            }
        }
    }
}

/* The product of `direction` [width] with the numbers of two rows: a row of the program, normed. */
static void add_row(bat_least_change *c, const bat_change_row *row, const double *direction,
                    double bound, double price)
{
    int end = c->start[c->row_count];
    double square = 0;
    for (int k = 0; k < SUPPORT; k++)
        for (int j = 0; j < c->width; j++)
            square += row->weight[k] * row->weight[k] * direction[j] * direction[j];
    const double norm = sqrt(square);
    if (!(norm > 0))
        return;
    for (int k = 0; k < SUPPORT; k++)
        for (int j = 0; j < c->width; j++) {
            c->column[end] = (row->first + k) * c->width + j;
            c->value[end++] = row->weight[k] * direction[j] / norm;
        }
    c->bounds[c->row_count] = bound / norm;
    c->prices[c->row_count] = price;
    c->start[++c->row_count] = end;
}

/* Each duck stays in its ball: in the plane in a polygon of 16 sides within. */
static void add_bounds(bat_least_change *c, const double *z)
{
    const bat_ducks *ducks = &c->piece->ducks;
    const int w = c->width, sides = w == 1 ? 2 : SIDES;
    for (int i = 0; i < c->ducks; i++) {
        const bat_change_row row = bat_change_row_at(c, i, 0);
        const bool free = ducks->freedom[i] > 0;
        const double within = free ? share_of_bound * ducks->within[i] / c->unit : room_of_held;
        for (int side = 0; side < sides; side++) {
            const double angle = 2 * BAT_PI * side / sides;
            const double direction[2] = {bat_cos(angle), w == 1 ? 0 : bat_sin(angle)};
            double gone = 0;
            for (int k = 0; k < w; k++)
                gone += direction[k] * (z[i * w + k] - ducks->centre[i * w + k]) / c->unit;
            const double inner = w == 1 ? within : within * bat_cos(BAT_PI / SIDES);
            /* Where a clip has left it on the circle, beyond the polygon, it may stay. */
            add_row(c, &row, direction, bat_max(inner - gone, 0), HUGE_VAL);
        }
    }
}

static void add_signs_of_function(bat_least_change *c)
{
    for (int i = 1; i + 1 < c->ducks; i++) {
        const bat_change_row row = bat_change_row_at(c, i, 2);
        const double direction = -c->signs[i];
        add_row(c, &row, &direction, c->signs[i] * c->moments[i] / c->unit, price_of_sign);
        c->bounds[c->row_count - 1] -= margin;
    }
}

/* sign (a + da) x (b + db) >= 0 to the first order, where da and db are `of_a` and `of_b` times the unknowns. */
static void add_product(bat_least_change *c, const double *a, const bat_change_row *of_a,
                        const double *b, const bat_change_row *of_b, int sign)
{
    int end = c->start[c->row_count];
    double square = 0;
    const double value = sign * (a[0] * b[1] - a[1] * b[0]) / c->unit;
    for (int k = 0; k < SUPPORT; k++) {
        const double p = of_a->weight[k], q = of_b->weight[k];
        const double entry[2] = {-sign * (p * b[1] - q * a[1]), -sign * (q * a[0] - p * b[0])};
        for (int j = 0; j < 2; j++) {
            c->column[end] = (of_a->first + k) * 2 + j;
            c->value[end++] = entry[j];
            square += entry[j] * entry[j];
        }
    }
    const double norm = sqrt(square);
    if (!(norm > 0))
        return;
    for (int k = c->start[c->row_count]; k < end; k++)
        c->value[k] /= norm;
    c->bounds[c->row_count] = value / norm - margin;
    c->prices[c->row_count] = price_of_sign;
    c->start[++c->row_count] = end;
}

/*
 * With the Bezier points h0, h1, h2 of P' on a span, P' x P'' has the Bernstein coefficients h0 x h1, h0 x h2 / 2 and h1 x h2,
 * times 2 over the length of the span. Between ducks of one sign none may have the other; between ducks of different signs the
 * quadratic has one root whatever is in its middle.
 */
static void add_signs_of_curve(bat_least_change *c)
{
    const double *t = c->piece->batten->t;
    const int n = c->ducks;
    for (int i = 0; i + 1 < n; i++) {
        const double *h = c->bend + 6 * i, part = (t[i + 1] - t[i]) / 2;
        const bat_change_row h0 = bat_change_row_on(c, i, false, 1),
                             h2 = bat_change_row_on(c, i, true, 1),
                             bend = bat_change_row_on(c, i, false, 2);
        bat_change_row h1 = h0;
        for (int k = 0; k < SUPPORT; k++)
            h1.weight[k] += part * bend.weight[k];
        if (i > 0)
            add_product(c, h, &h0, h + 2, &h1, c->signs[i]);
        if (c->signs[i] == c->signs[i + 1])
            add_product(c, h, &h0, h + 4, &h2, c->signs[i]);
        if (i + 2 < n)
            add_product(c, h + 2, &h1, h + 4, &h2, c->signs[i + 1]);
    }
}

/* ---- the batten as it is ---- */

void bat_change_bend(bat_least_change *c, const double *z)
{
    const bat_batten *batten = c->piece->batten;
    const int w = c->width;
    bat_batten_bend(batten, w, z, c->moments, NULL);
    for (int i = 0; i + 1 < c->ducks; i++) {
        const double h = batten->t[i + 1] - batten->t[i];
        for (int k = 0; k < w; k++) {
            const double *p = z + i * w + k, *m = c->moments + i * w + k;
            double *bezier = c->bend + 3 * i * w + k;
            bezier[0] = (p[w] - p[0]) / h - h * (2 * m[0] + m[w]) / 6;
            bezier[w] = bezier[0] + h * m[0] / 2;
            bezier[2 * w] = bezier[w] + h * m[w] / 2;
        }
    }
}

void bat_change_turning(const bat_least_change *c, double *turning)
{
    for (int i = 0; i < c->ducks; i++) {
        const double *m = c->moments + i * c->width, *h = c->bend + 3 * i * c->width;
        turning[i] = i == 0 || i == c->ducks - 1 ? 0
                     : c->width == 1             ? m[0]
                                                 : h[0] * m[1] - h[1] * m[0];
    }
}

/* ---- a step ---- */

static void price_signs(bat_least_change *c)
{
    const int unknowns = c->ducks * c->width, row_size = SUPPORT * c->width;
    double mean = 0;
    for (int i = 0; i < unknowns; i++)
        mean += c->hessian[i * row_size + row_size - 1] / unknowns;
    for (int i = 0; i < c->row_count; i++)
        c->prices[i] *= mean;
}

batten_status bat_change_step(bat_least_change *c, double *z, double *length)
{
    const int w = c->width, unknowns = c->ducks * w, row_size = SUPPORT * w;
    memset(c->hessian, 0, (size_t)(unknowns * row_size) * sizeof *c->hessian);
    memset(c->linear, 0, (size_t)unknowns * sizeof *c->linear);
    c->row_count = 0;
    c->start[0] = 0;
    bat_change_bend(c, z);
    add_squares(c, z);
    add_bounds(c, z);
    if (w == 1)
        add_signs_of_function(c);
    else
        add_signs_of_curve(c);
    price_signs(c);
    double *duals = bat_array((size_t)c->row_count, 2 * sizeof *duals);
    if (!duals)
        return BATTEN_OUT_OF_MEMORY;
    const bat_convex_program program = {unknowns,
                                        row_size - 1,
                                        c->hessian,
                                        c->linear,
                                        {c->row_count, c->start, c->column, c->value},
                                        c->bounds,
                                        c->prices};
    bat_convex_solution solution = {c->x, duals, duals + c->row_count};
    bat_convex_report report;
    const batten_status status = bat_convex_program_solve(&program, NULL, &solution, &report);
    bat_release(duals);
    *length = 0;
    for (int i = 0; status == BATTEN_OK && i < c->ducks; i++) {
        const bat_change_row row = bat_change_row_at(c, i, 0);
        for (int k = 0; k < w; k++) {
            const double move = times(c, &row, k);
            *length = bat_max(*length, fabs(move));
            z[i * w + k] += c->unit * move;
        }
    }
    return status;
}
