/*
 * Interpolation under inequalities as a quadratic program for control points.
 *
 * Unknown j d + c is coordinate c of control point j. What is asked of the curve over an
 * interval is asked of the Bernstein coefficients there, which are linear in the unknowns.
 */
#include "shape/linear/constrained_rows.h"
#include <batten/interpolate.h>

#include "base/plural.h"
#include "numeric/programs/quadratic_program.h"
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
        return bat_fail(BATTEN_BAD_ARGUMENT, "constraint %d is of the unknown kind %d", i + 1,
                        (int)c->kind);
    if (bat_first_not_finite(c->normal, (size_t)d) < (size_t)d || !isfinite(c->bound) ||
        !isfinite(c->rate))
        return bat_fail(BATTEN_NOT_FINITE, "constraint %d (%s) is not finite", i + 1,
                        name_of(c->kind));
    if (bat_norm(d, c->normal) == 0 && !(d == 1 && c->kind == BATTEN_CONSTRAINT_DIRECTION))
        return bat_fail(BATTEN_BAD_ARGUMENT, "constraint %d (%s) has a normal without length",
                        i + 1, name_of(c->kind));
    const int to = c->to == 0 ? count - 1 : c->to;
    const bool at_point = c->kind == BATTEN_CONSTRAINT_DIRECTION;
    if (c->from < 0 || c->from >= count || to < 0 || to >= count ||
        (is_inequality(c->kind) && c->from >= to))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "constraint %d (%s) goes from point %d to %d; there %s %d point%s",
                        i + 1, name_of(c->kind), c->from + 1, at_point ? c->from + 1 : to + 1,
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
    if (is_inequality(c->kind) && (int)c->kind > degree)
        return bat_fail(BATTEN_BAD_ARGUMENT, "constraint %d (%s) on a curve of degree %d",
                        i + 1, name_of(c->kind), degree);
    return BATTEN_OK;
}

static batten_status check_weights(const double *weights, int count)
{
    for (int i = 0; weights && i < count; i++)
        if (!(weights[i] > 0))
            return bat_fail(isnan(weights[i]) ? BATTEN_NOT_FINITE : BATTEN_BAD_ARGUMENT,
                            "weight %d is %g; it must be above 0", i + 1, weights[i]);
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

static void task_end(bat_constrained_fit *t)
{
    double *const arrays[] = {t->u,     t->knots,        t->hessian, t->linear,      t->x,
                              t->equal, t->equal_values, t->least,   t->least_values};
    for (size_t i = 0; i < sizeof arrays / sizeof arrays[0]; i++)
        bat_release(arrays[i]);
    bat_release(t->equal_of);
    bat_release(t->least_of);
}

static batten_status make_knots(bat_constrained_fit *t)
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

static size_t rows_of_inequality(const bat_constrained_fit *t, const batten_constraint *c)
{
    const batten_curve_constrained_options *o = t->options;
    const int to = c->to == 0 ? t->count - 1 : c->to;
    const int each = o->checks * bat_max_int(1, o->pieces) * (t->degree + 1);
    return (size_t)(to - c->from) * (size_t)each;
}

/* The most rows that the constraints need. */
static void count_rows(const bat_constrained_fit *t, size_t *equal, size_t *least)
{
    *equal = (size_t)t->d * (size_t)t->count;
    *least = 0;
    for (int i = 0; i < t->options->constraint_count; i++) {
        const batten_constraint *c = &t->options->constraints[i];
        const bool along = is_inequality(c->kind);
        *equal += along ? 0 : (size_t)t->d;
        *least += along ? rows_of_inequality(t, c) : c->kind == BATTEN_CONSTRAINT_DIRECTION;
    }
}

static batten_status make_room(bat_constrained_fit *t)
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

/* ---- the solution ---- */

/* Say whose equation or inequality it was. */
static batten_status name_culprit(const bat_constrained_fit *t,
                                  const bat_quadratic_report *report)
{
    const int of = report->refused_inequality >= 0 ? t->least_of[report->refused_inequality]
                                                   : t->equal_of[report->refused_equation];
    if (of < 0)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "a curve of degree %d with %d control point%s cannot pass point %d as "
                        "well: give it a higher degree or more pieces",
                        t->degree, t->control_count, bat_plural(t->control_count), -of);
    const batten_constraint *c = &t->options->constraints[of];
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "constraint %d (%s, from point %d to %d) cannot hold together with the "
                    "points and the other constraints: leave one out, or give the curve more "
                    "pieces or checks",
                    of + 1, name_of(c->kind), c->from + 1,
                    !is_inequality(c->kind) ? c->from + 1
                    : c->to == 0            ? t->count
                                            : c->to + 1);
}

/* By how much the curve misses a point. */
static double miss_at(const bat_constrained_fit *t, int i)
{
    double basis[ROWS], at[3] = {0};
    const int first = bat_constrained_basis(t, t->u[i], 0, basis);
    for (int a = 0; a <= t->degree; a++)
        for (int c = 0; c < t->d; c++)
            at[c] += basis[a] * t->x[(first + a) * t->d + c];
    return bat_distance(t->d, at, t->points + i * t->d);
}

static void measure_constraints(bat_constrained_fit *t, batten_curve_constrained_report *report)
{
    const size_t n = (size_t)t->unknowns;
    for (int i = 0; i < t->count; i++) {
        report->error_max = bat_max(report->error_max, miss_at(t, i));
    }
    /* The form without the weights. */
    memset(t->hessian, 0, n * n * sizeof *t->hessian);
    bat_constrained_energy(t);
    for (size_t i = 0; i < n; i++)
        report->energy += t->x[i] * bat_dot((int)n, t->hessian + i * n, t->x);
}

static batten_status solve(bat_constrained_fit *t, batten_curve_constrained_report *report)
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

static batten_status find(bat_constrained_fit *t, batten_curve_constrained_report *report,
                          batten_curve **out)
{
    const batten_curve_constrained_options *o = t->options;
    batten_status status = bat_parameters_of((batten_points){t->d, t->count, t->points},
                                             o->parameters, o->given, false, &t->u);
    if (status == BATTEN_OK)
        status = make_knots(t);
    if (status == BATTEN_OK)
        status = make_room(t);
    if (status != BATTEN_OK)
        return status;
    bat_constrained_energy(t);
    bat_constrained_points(t);
    status = bat_constrained_add(t);
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
    bat_constrained_fit t = {
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
