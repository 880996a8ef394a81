/* The rows of a constrained spline: points, directions, means, and inequalities over intervals. */
#include "shape/linear/constrained_rows.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "spline/spline.h"

#include <batten/interpolate.h>
#include <string.h>

enum { MOST_PARTS = 64, MOST_ORDER = 5, ROWS = BATTEN_MAX_DEGREE + 1 };

/* ---- what is least ---- */

/* Add factor N Nt of basis functions `first`.. to the form of every coordinate. */
static void add_square(bat_constrained_fit *t, int first, const double *basis, double factor)
{
    const size_t n = (size_t)t->unknowns;
    for (int a = 0; a <= t->degree; a++)
        for (int b = 0; b <= t->degree; b++)
            for (int c = 0; c < t->d; c++)
                t->hessian[(size_t)((first + a) * t->d + c) * n +
                           (size_t)((first + b) * t->d + c)] += factor * basis[a] * basis[b];
}

void bat_constrained_energy(bat_constrained_fit *t)
{
    const int p = t->degree, r = t->options->order, nodes = p - r + 1;
    double x[ROWS], w[ROWS], basis[(MOST_ORDER + 1) * ROWS];
    bat_gauss(nodes, x, w);
    for (int k = p; k < t->control_count; k++) {
        const double a = t->knots[k], h = t->knots[k + 1] - a;
        for (int q = 0; q < nodes; q++) {
            bat_basis(p, t->knots, k, a + h * (1 + x[q]) / 2, r, basis);
            add_square(t, k - p, basis + r * (p + 1), w[q] * h / 2);
        }
    }
}

/* ---- rows ---- */

int bat_constrained_basis(const bat_constrained_fit *t, double u, int order, double *out)
{
    const int p = t->degree;
    double basis[2 * ROWS];
    const int k = bat_knots_span(p, t->control_count, t->knots, u, BATTEN_FROM_RIGHT);
    bat_basis(p, t->knots, k, u, order, basis);
    memcpy(out, basis + order * (p + 1), (size_t)(p + 1) * sizeof *out);
    return k - p;
}

/* normal . sum basis[a] P[first + a] */
typedef struct {
    int first;
    const double *basis, *normal;
} linear_form;

static void fill_row(const bat_constrained_fit *t, linear_form of, double *row)
{
    for (int a = 0; a <= t->degree; a++)
        for (int c = 0; c < t->d; c++)
            row[(of.first + a) * t->d + c] = of.normal[c] * of.basis[a];
}

static void add_equal(bat_constrained_fit *t, int of, linear_form form, double value)
{
    fill_row(t, form, t->equal + (size_t)t->equal_count * (size_t)t->unknowns);
    t->equal_of[t->equal_count] = of;
    t->equal_values[t->equal_count++] = value;
}

static void add_least(bat_constrained_fit *t, int of, linear_form form, double value)
{
    fill_row(t, form, t->least + (size_t)t->least_count * (size_t)t->unknowns);
    t->least_of[t->least_count] = of;
    t->least_values[t->least_count++] = value;
}

void bat_constrained_points(bat_constrained_fit *t)
{
    for (int i = 0; i < t->count; i++) {
        double basis[ROWS];
        const double *point = t->points + i * t->d;
        const double weight = t->options->weights ? t->options->weights[i] : HUGE_VAL;
        const int first = bat_constrained_basis(t, t->u[i], 0, basis);
        for (int c = 0; c < t->d && !isfinite(weight); c++) {
            const double axis[3] = {c == 0, c == 1, c == 2};
            add_equal(t, -1 - i, (linear_form){first, basis, axis}, point[c]);
        }
        if (!isfinite(weight))
            continue;
        add_square(t, first, basis, weight);
        for (int a = 0; a <= t->degree; a++)
            for (int c = 0; c < t->d; c++)
                t->linear[(first + a) * t->d + c] += weight * basis[a] * point[c];
    }
}

/* The length of the polygon by the parameter. */
static double mean_speed(const bat_constrained_fit *t)
{
    double length = 0;
    for (int i = 0; i + 1 < t->count; i++)
        length += bat_distance(t->d, t->points + i * t->d, t->points + (i + 1) * t->d);
    return length / (t->u[t->count - 1] - t->u[0]);
}

/* P' is along the vector, and not too slow. */
static void add_direction(bat_constrained_fit *t, int i)
{
    const batten_constraint *c = &t->options->constraints[i];
    double basis[ROWS], across[3] = {0};
    const int first = bat_constrained_basis(t, t->u[c->from], 1, basis), d = t->d;
    if (d == 1) {
        const double one[3] = {1, 0, 0};
        add_equal(t, i, (linear_form){first, basis, one}, c->normal[0]);
        return;
    }
    /* Square to it: in space by the axis that is farthest from it, and by both. */
    const double *v = c->normal;
    int least = 0;
    for (int k = 1; k < d; k++)
        least = fabs(v[k]) < fabs(v[least]) ? k : least;
    const int next = (least + 1) % d, last = (least + 2) % d;
    across[next] = -v[last];
    across[last] = v[next];
    add_equal(t, i, (linear_form){first, basis, across}, 0);
    if (d == 3) {
        const double a[3] = {across[0], across[1], across[2]};
        for (int k = 0; k < 3; k++)
            across[k] = v[(k + 1) % 3] * a[(k + 2) % 3] - v[(k + 2) % 3] * a[(k + 1) % 3];
        add_equal(t, i, (linear_form){first, basis, across}, 0);
    }
    add_least(t, i, (linear_form){first, basis, v}, c->bound * mean_speed(t) * bat_norm(d, v));
}

/* The integral of basis function j is its support by degree + 1. */
static void add_mean(bat_constrained_fit *t, int i)
{
    const batten_constraint *c = &t->options->constraints[i];
    const int p = t->degree;
    double *row = t->equal + (size_t)t->equal_count * (size_t)t->unknowns;
    for (int j = 0; j < t->control_count; j++)
        for (int k = 0; k < t->d; k++)
            row[j * t->d + k] = c->normal[k] * (t->knots[j + p + 1] - t->knots[j]) / (p + 1) /
                                (t->u[t->count - 1] - t->u[0]);
    t->equal_of[t->equal_count] = i;
    t->equal_values[t->equal_count++] = c->bound;
}

/* ---- inequalities over an interval ---- */

/* In place: the Bezier rows [degree + 1][width] of [0, 1] become those of [a, b]. */
static void restrict_rows(int degree, size_t width, double a, double b, double *rows)
{
    for (int r = 1; r <= degree; r++)
        for (int j = degree; j >= r; j--)
            for (size_t c = 0; c < width; c++)
                rows[(size_t)j * width + c] +=
                    (1 - b) * (rows[(size_t)(j - 1) * width + c] - rows[(size_t)j * width + c]);
    const double s = a / b;
    for (int r = 1; r <= degree; r++)
        for (int j = 0; j <= degree - r; j++)
            for (size_t c = 0; c < width; c++)
                rows[(size_t)j * width + c] +=
                    s * (rows[(size_t)(j + 1) * width + c] - rows[(size_t)j * width + c]);
}

/* The Bernstein coefficients of the derivative of an order on [a, b], which lies in one span,
 * as rows [degree - order + 1][degree + 1] of control points `first`... */
static int coefficients(const bat_constrained_fit *t, int order, double a, double b,
                        double *rows)
{
    const int p = t->degree;
    const size_t w = (size_t)p + 1;
    const int k =
        bat_knots_span(p, t->control_count, t->knots, a + (b - a) / 2, BATTEN_FROM_RIGHT);
    const double low = t->knots[k], h = t->knots[k + 1] - low;
    memset(rows, 0, w * w * sizeof *rows);
    for (size_t i = 0; i < w; i++)
        rows[i * w + i] = 1;
    for (int q = 0; q < order; q++)
        bat_rows_derive(p - q, t->knots, k, w, rows);
    bat_piece_from_rows(p - order, t->knots, k, w, rows);
    restrict_rows(p - order, w, bat_max(0, (a - low) / h), bat_min(1, (b - low) / h), rows);
    return k - p;
}

static void add_part(bat_constrained_fit *t, int i, double a, double b, double *rows)
{
    const batten_constraint *c = &t->options->constraints[i];
    const int order = (int)c->kind, m = t->degree - order;
    const int first = coefficients(t, order, a, b, rows);
    for (int j = 0; j <= m; j++) {
        const double u = m == 0 ? a : a + (b - a) * j / m;
        const double rate = order == 0 ? c->rate : 0;
        const linear_form form = {first, rows + j * (t->degree + 1), c->normal};
        add_least(t, i, form, c->bound + rate * u);
    }
}

static void add_inequality(bat_constrained_fit *t, int i, double *rows)
{
    const batten_constraint *c = &t->options->constraints[i];
    const int to = c->to == 0 ? t->count - 1 : c->to;
    const int parts = t->options->checks * bat_max_int(1, t->options->pieces);
    for (int j = c->from; j < to; j++) {
        const double a = t->u[j], h = t->u[j + 1] - a;
        for (int k = 0; k < parts; k++)
            add_part(t, i, a + h * k / parts, a + h * (k + 1) / parts, rows);
    }
}

static void add_constraint(bat_constrained_fit *t, int i, double *rows)
{
    const batten_constraint_kind kind = t->options->constraints[i].kind;
    if (kind == BATTEN_CONSTRAINT_DIRECTION)
        add_direction(t, i);
    else if (kind == BATTEN_CONSTRAINT_MEAN)
        add_mean(t, i);
    else
        add_inequality(t, i, rows);
}

batten_status bat_constrained_add(bat_constrained_fit *t)
{
    double *rows = bat_array3(ROWS, ROWS, sizeof *rows);
    if (!rows)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < t->options->constraint_count; i++)
        add_constraint(t, i, rows);
    bat_release(rows);
    return BATTEN_OK;
}
