/*
 * Interpolation under inequalities as a quadratic program for control points.
 *
 * Unknown j d + c is coordinate c of control point j. What is asked of the curve over an
 * interval is asked of the Bernstein coefficients there, which are linear in the unknowns.
 */
#include <batten/interpolate.h>

#include "base/plural.h"
#include "numeric/quadratic_program.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "shape/points/parametrize.h"
#include "spline/data_check.h"
#include "spline/spline.h"

#include <string.h>

enum { MOST_UNKNOWNS = 1000, MOST_PARTS = 64, MOST_ORDER = 5, ROWS = BATTEN_MAX_DEGREE + 1 };

batten_curve_constrained_options batten_curve_constrained_defaults(void)
{
    return (batten_curve_constrained_options){.size = sizeof(batten_curve_constrained_options),
                                              .degree = 3,
                                              .pieces = 4,
                                              .order = 2,
                                              .checks = 4,
                                              .parameters = BATTEN_CHORD};
}

/* ---- what is asked ---- */

static const char *name_of(batten_constraint_kind kind)
{
    static const char *const names[] = {"value", "slope", "bend", "direction", "mean"};
    return names[kind];
}

static bool is_inequality(batten_constraint_kind kind)
{
    return kind <= BATTEN_CONSTRAINT_BEND;
}

static batten_status check_constraint(int d, int count, int degree, const batten_constraint *c,
                                      int i)
{
    if ((int)c->kind < 0 || c->kind > BATTEN_CONSTRAINT_MEAN)
        return bat_fail(BATTEN_BAD_ARGUMENT, "constraint %d is of the unknown kind %d", i,
                        (int)c->kind);
    if (bat_first_not_finite(c->normal, (size_t)d) < (size_t)d || !isfinite(c->bound) ||
        !isfinite(c->rate))
        return bat_fail(BATTEN_NOT_FINITE, "constraint %d (%s) is not finite", i,
                        name_of(c->kind));
    if (bat_norm(d, c->normal) == 0 && !(d == 1 && c->kind == BATTEN_CONSTRAINT_DIRECTION))
        return bat_fail(BATTEN_BAD_ARGUMENT, "constraint %d (%s) has a normal without length",
                        i, name_of(c->kind));
    const int to = c->to == 0 ? count - 1 : c->to;
    const bool at_point = c->kind == BATTEN_CONSTRAINT_DIRECTION;
    if (c->from < 0 || c->from >= count || to < 0 || to >= count ||
        (is_inequality(c->kind) && c->from >= to))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "constraint %d (%s) goes from point %d to %d; there %s %d point%s", i,
                        name_of(c->kind), c->from, at_point ? c->from : to,
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
    if (is_inequality(c->kind) && (int)c->kind > degree)
        return bat_fail(BATTEN_BAD_ARGUMENT, "constraint %d (%s) on a curve of degree %d", i,
                        name_of(c->kind), degree);
    return BATTEN_OK;
}

static batten_status check_weights(const double *weights, int count)
{
    for (int i = 0; weights && i < count; i++)
        if (!(weights[i] > 0))
            return bat_fail(isnan(weights[i]) ? BATTEN_NOT_FINITE : BATTEN_BAD_ARGUMENT,
                            "weight %d is %g; it must be above 0", i, weights[i]);
    return BATTEN_OK;
}

static batten_status check_constraints(int d, int count, const double *points,
                                       const batten_curve_constrained_options *o)
{
    if (o->degree < 1 || o->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_ARGUMENT, "degree %d; 1 to %d are possible", o->degree,
                        BATTEN_MAX_DEGREE);
    if (o->order < 1 || o->order > bat_min_int(MOST_ORDER, o->degree))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the derivative of order %d; 1 to %d are possible",
                        o->order, bat_min_int(MOST_ORDER, o->degree));
    if (o->pieces < 0 || o->pieces > MOST_PARTS || o->checks < 1 || o->checks > MOST_PARTS)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d pieces with %d checks; 0 to %d with 1 to %d are possible",
                        o->pieces, o->checks, MOST_PARTS, MOST_PARTS);
    batten_status status = bat_points_check(d, count, points, 2);
    if (status == BATTEN_OK)
        status = check_weights(o->weights, count);
    for (int i = 0; i < o->constraint_count && status == BATTEN_OK; i++)
        status = check_constraint(d, count, o->degree, &o->constraints[i], i);
    return status;
}

/* ---- the spline and its program ---- */

typedef struct {
    const batten_curve_constrained_options *options;
    int d, count, degree;
    const double *points;
    double *u;     /* [count] */
    double *knots; /* [control_count + degree + 1] */
    int control_count, unknowns;
    double *hessian, *linear, *x;
    /* Rows [unknowns] of equations and inequalities, their values, and whose they are: a
     * constraint, or -1 - i of point i. */
    double *equal, *equal_values, *least, *least_values;
    int *equal_of, *least_of;
    int equal_count, least_count;
} constrained_fit;

static void task_end(constrained_fit *t)
{
    double *const arrays[] = {t->u,     t->knots,        t->hessian, t->linear,      t->x,
                              t->equal, t->equal_values, t->least,   t->least_values};
    for (size_t i = 0; i < sizeof arrays / sizeof arrays[0]; i++)
        bat_release(arrays[i]);
    bat_release(t->equal_of);
    bat_release(t->least_of);
}

static batten_status make_knots(constrained_fit *t)
{
    const int pieces = t->options->pieces, n = t->count;
    const int spans = pieces == 0 ? 1 : (n - 1) * pieces;
    double *breaks = bat_array((size_t)spans + 1, sizeof *breaks);
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    for (int j = 0; j < spans && pieces > 0; j++) {
        const double a = t->u[j / pieces], h = t->u[j / pieces + 1] - a;
        breaks[j] = a + h * (j % pieces) / pieces;
    }
    breaks[0] = t->u[0];
    breaks[spans] = t->u[n - 1];
    batten_status status = bat_breaks_check(spans, breaks);
    t->degree = t->options->degree;
    t->control_count = spans + t->degree;
    t->unknowns = t->d * t->control_count;
    if (status == BATTEN_OK && !(t->knots = bat_knots_of_breaks(t->degree, 1, spans, breaks)))
        status = BATTEN_OUT_OF_MEMORY;
    bat_release(breaks);
    return status;
}

/* The most rows that the constraints need. */
static void count_rows(const constrained_fit *t, size_t *equal, size_t *least)
{
    const batten_curve_constrained_options *o = t->options;
    const size_t d = (size_t)t->d;
    const size_t each = (size_t)(o->checks * bat_max_int(1, o->pieces) * (t->degree + 1));
    *equal = d * (size_t)t->count;
    *least = 0;
    for (int i = 0; i < o->constraint_count; i++) {
        const batten_constraint *c = &o->constraints[i];
        const int to = c->to == 0 ? t->count - 1 : c->to;
        if (is_inequality(c->kind))
            *least += (size_t)(to - c->from) * each;
        else
            *equal += d;
        *least += c->kind == BATTEN_CONSTRAINT_DIRECTION;
    }
}

static batten_status make_room(constrained_fit *t)
{
    size_t equal, least;
    const size_t n = (size_t)t->unknowns;
    if (t->unknowns > MOST_UNKNOWNS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d control points of %d coordinates; up to %d numbers are possible: "
                        "take fewer points or pieces",
                        t->control_count, t->d, MOST_UNKNOWNS);
    count_rows(t, &equal, &least);
    t->hessian = bat_array3(n, n, sizeof *t->hessian);
    t->linear = bat_array(n, sizeof *t->linear);
    t->x = bat_array(n, sizeof *t->x);
    t->equal = bat_array3(equal, n, sizeof *t->equal);
    t->least = bat_array3(least, n, sizeof *t->least);
    t->equal_values = bat_array(equal, sizeof *t->equal_values);
    t->least_values = bat_array(least, sizeof *t->least_values);
    t->equal_of = bat_array(equal, sizeof *t->equal_of);
    t->least_of = bat_array(least, sizeof *t->least_of);
    return t->hessian && t->linear && t->x && t->equal && t->least && t->equal_values &&
                   t->least_values && t->equal_of && t->least_of
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

/* ---- what is least ---- */

/* Add factor N Nt of basis functions `first`.. to the form of every coordinate. */
static void add_square(constrained_fit *t, int first, const double *basis, double factor)
{
    const size_t n = (size_t)t->unknowns;
    for (int a = 0; a <= t->degree; a++)
        for (int b = 0; b <= t->degree; b++)
            for (int c = 0; c < t->d; c++)
                t->hessian[(size_t)((first + a) * t->d + c) * n +
                           (size_t)((first + b) * t->d + c)] += factor * basis[a] * basis[b];
}

/* Gauss is exact for the squares of the derivatives. */
static void add_energy(constrained_fit *t)
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

/* Basis functions of the derivative of an order at u; their first index. */
static int basis_at(const constrained_fit *t, double u, int order, double *out)
{
    const int p = t->degree;
    double basis[2 * ROWS];
    const int k = bat_knots_span(p, t->control_count, t->knots, u, BATTEN_FROM_RIGHT);
    bat_basis(p, t->knots, k, u, order, basis);
    memcpy(out, basis + order * (p + 1), (size_t)(p + 1) * sizeof *out);
    return k - p;
}

/* normal . sum basis[a] P[first + a], as a row. */
static void fill_row(const constrained_fit *t, int first, const double *basis,
                     const double *normal, double *row)
{
    for (int a = 0; a <= t->degree; a++)
        for (int c = 0; c < t->d; c++)
            row[(first + a) * t->d + c] = normal[c] * basis[a];
}

static void add_equal(constrained_fit *t, int of, int first, const double *basis,
                      const double *normal, double value)
{
    fill_row(t, first, basis, normal, t->equal + (size_t)t->equal_count * (size_t)t->unknowns);
    t->equal_of[t->equal_count] = of;
    t->equal_values[t->equal_count++] = value;
}

static void add_least(constrained_fit *t, int of, int first, const double *basis,
                      const double *normal, double value)
{
    fill_row(t, first, basis, normal, t->least + (size_t)t->least_count * (size_t)t->unknowns);
    t->least_of[t->least_count] = of;
    t->least_values[t->least_count++] = value;
}

static void add_points(constrained_fit *t)
{
    for (int i = 0; i < t->count; i++) {
        double basis[ROWS];
        const double *point = t->points + i * t->d;
        const double weight = t->options->weights ? t->options->weights[i] : HUGE_VAL;
        const int first = basis_at(t, t->u[i], 0, basis);
        for (int c = 0; c < t->d && !isfinite(weight); c++) {
            const double axis[3] = {c == 0, c == 1, c == 2};
            add_equal(t, -1 - i, first, basis, axis, point[c]);
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
static double mean_speed(const constrained_fit *t)
{
    double length = 0;
    for (int i = 0; i + 1 < t->count; i++)
        length += bat_distance(t->d, t->points + i * t->d, t->points + (i + 1) * t->d);
    return length / (t->u[t->count - 1] - t->u[0]);
}

/* P' is along the vector, and not too slow. */
static void add_direction(constrained_fit *t, int i)
{
    const batten_constraint *c = &t->options->constraints[i];
    double basis[ROWS], across[3] = {0};
    const int first = basis_at(t, t->u[c->from], 1, basis), d = t->d;
    if (d == 1) {
        const double one[3] = {1, 0, 0};
        add_equal(t, i, first, basis, one, c->normal[0]);
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
    add_equal(t, i, first, basis, across, 0);
    if (d == 3) {
        const double a[3] = {across[0], across[1], across[2]};
        for (int k = 0; k < 3; k++)
            across[k] = v[(k + 1) % 3] * a[(k + 2) % 3] - v[(k + 2) % 3] * a[(k + 1) % 3];
        add_equal(t, i, first, basis, across, 0);
    }
    add_least(t, i, first, basis, v, c->bound * mean_speed(t) * bat_norm(d, v));
}

/* The integral of basis function j is its support by degree + 1. */
static void add_mean(constrained_fit *t, int i)
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
static int coefficients(const constrained_fit *t, int order, double a, double b, double *rows)
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

static void add_part(constrained_fit *t, int i, double a, double b, double *rows)
{
    const batten_constraint *c = &t->options->constraints[i];
    const int order = (int)c->kind, m = t->degree - order;
    const int first = coefficients(t, order, a, b, rows);
    for (int j = 0; j <= m; j++) {
        const double u = m == 0 ? a : a + (b - a) * j / m;
        const double rate = order == 0 ? c->rate : 0;
        add_least(t, i, first, rows + j * (t->degree + 1), c->normal, c->bound + rate * u);
    }
}

static void add_inequality(constrained_fit *t, int i, double *rows)
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

static batten_status add_constraints(constrained_fit *t)
{
    double *rows = bat_array3(ROWS, ROWS, sizeof *rows);
    if (!rows)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < t->options->constraint_count; i++) {
        const batten_constraint_kind kind = t->options->constraints[i].kind;
        if (kind == BATTEN_CONSTRAINT_DIRECTION)
            add_direction(t, i);
        else if (kind == BATTEN_CONSTRAINT_MEAN)
            add_mean(t, i);
        else
            add_inequality(t, i, rows);
    }
    bat_release(rows);
    return BATTEN_OK;
}

/* ---- the solution ---- */

/* Say whose equation or inequality it was. */
static batten_status name_culprit(const constrained_fit *t, const bat_quadratic_report *report)
{
    const int of = report->refused_inequality >= 0 ? t->least_of[report->refused_inequality]
                                                   : t->equal_of[report->refused_equation];
    if (of < 0)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "a curve of degree %d with %d control point%s cannot pass point %d as "
                        "well: give it a higher degree or more pieces",
                        t->degree, t->control_count, bat_plural(t->control_count), -1 - of);
    const batten_constraint *c = &t->options->constraints[of];
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "constraint %d (%s, from point %d to %d) cannot hold together with the "
                    "points and the other constraints: leave one out, or give the curve more "
                    "pieces or checks",
                    of, name_of(c->kind), c->from,
                    !is_inequality(c->kind) ? c->from
                    : c->to == 0            ? t->count - 1
                                            : c->to);
}

static void measure_constraints(constrained_fit *t, batten_curve_constrained_report *report)
{
    const size_t n = (size_t)t->unknowns;
    for (int i = 0; i < t->count; i++) {
        double basis[ROWS], at[3] = {0};
        const int first = basis_at(t, t->u[i], 0, basis);
        for (int a = 0; a <= t->degree; a++)
            for (int c = 0; c < t->d; c++)
                at[c] += basis[a] * t->x[(first + a) * t->d + c];
        report->error_max =
            bat_max(report->error_max, bat_distance(t->d, at, t->points + i * t->d));
    }
    /* The form without the weights. */
    memset(t->hessian, 0, n * n * sizeof *t->hessian);
    add_energy(t);
    for (size_t i = 0; i < n; i++)
        report->energy += t->x[i] * bat_dot((int)n, t->hessian + i * n, t->x);
}

static batten_status solve(constrained_fit *t, batten_curve_constrained_report *report)
{
    const bat_quadratic_program program = {
        .count = t->unknowns,
        .hessian = t->hessian,
        .linear = t->linear,
        .equal_count = t->equal_count,
        .equal_rows = t->equal,
        .equal_values = t->equal_values,
        .least_count = t->least_count,
        .least_rows = t->least,
        .least_values = t->least_values,
    };
    bat_quadratic_report reached = {0};
    const batten_status status = bat_quadratic_program_solve(&program, t->x, NULL, &reached);
    if (status == BATTEN_NOT_COMPATIBLE)
        return name_culprit(t, &reached);
    if (status != BATTEN_OK)
        return status;
    report->active = reached.active_count;
    report->redundant = reached.redundant_count;
    measure_constraints(t, report);
    return BATTEN_OK;
}

static batten_status find(constrained_fit *t, batten_curve_constrained_report *report,
                          batten_curve **out)
{
    const batten_curve_constrained_options *o = t->options;
    batten_status status =
        bat_parameters_of(t->d, t->count, t->points, o->parameters, o->given, false, &t->u);
    if (status == BATTEN_OK)
        status = make_knots(t);
    if (status == BATTEN_OK)
        status = make_room(t);
    if (status != BATTEN_OK)
        return status;
    add_energy(t);
    add_points(t);
    status = add_constraints(t);
    if (status == BATTEN_OK)
        status = solve(t, report);
    if (status == BATTEN_OK)
        status = batten_curve_create((batten_points){t->d, t->control_count, t->x}, t->degree,
                                     NULL, t->knots, out);
    return status;
}

batten_status batten_curve_constrained(batten_points points,
                                       const batten_curve_constrained_options *options,
                                       double *parameters,
                                       batten_curve_constrained_report *report,
                                       batten_curve **out)
{
    assert(points.at && out);
    batten_curve_constrained_options chosen = batten_curve_constrained_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_constrained_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    constrained_fit t = {
        .options = &chosen, .d = points.dimension, .count = points.count, .points = points.at};
    batten_curve_constrained_report reached = {0};
    status = check_constraints(points.dimension, points.count, points.at, t.options);
    if (status == BATTEN_OK)
        status = find(&t, &reached, out);
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, t.u, (size_t)points.count * sizeof *parameters);
    if (status == BATTEN_OK && report)
        *report = reached;
    task_end(&t);
    return status;
}
