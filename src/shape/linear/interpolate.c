/*
 * Interpolation by a B-spline curve with end conditions. The control points solve a linear
 * system; a prescribed end curvature first becomes a second derivative, which iteration finds.
 */
#include "numeric/vector.h"
#include "shape/linear/end_conditions.h"
#include "shape/linear/linear_solve.h"
#include "shape/points/parametrize.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

batten_curve_interpolate_options batten_curve_interpolate_defaults(void)
{
    return (batten_curve_interpolate_options){.size = sizeof(batten_curve_interpolate_options),
                                              .degree = 3,
                                              .parameters = BATTEN_CENTRIPETAL,
                                              .knots_at_data = true};
}

/* ---- one interpolation on its way ---- */

typedef struct {
    int dimension, count;
    const double *points;
    const batten_curve_interpolate_options *options;
    double *parameters; /* [count], periodic [count + 1] */
    bat_request request;
    bat_operator op;
    double start[3], end[3];
    double *conditions; /* [condition_count][dimension] */
    double *control;    /* [op.count][dimension] */
} spline_problem;

static batten_status find_parameters(spline_problem *t)
{
    const batten_curve_interpolate_options *o = t->options;
    return bat_parameters_of((batten_points){t->dimension, t->count, t->points}, o->parameters,
                             o->given, o->closed, &t->parameters);
}

static batten_status find_ends(spline_problem *t)
{
    const batten_end ends[2] = {t->options->start, t->options->end};
    bat_ends found = {.values = {{0}}};
    const batten_status status = bat_ends_resolve(
        (batten_points){t->dimension, t->count, t->points}, t->parameters, ends, &found);
    t->request.start = found.kinds[0];
    t->request.end = found.kinds[1];
    memcpy(t->start, found.values[0], sizeof t->start);
    memcpy(t->end, found.values[1], sizeof t->end);
    return status;
}

static batten_status copy_derivatives(spline_problem *t)
{
    const batten_curve_interpolate_options *o = t->options;
    const size_t d = (size_t)t->dimension;
    for (int i = 0; i < o->derivative_count; i++) {
        if (bat_first_not_finite(o->derivatives[i].value, d) < d)
            return bat_fail(BATTEN_NOT_FINITE, "derivative %d is not finite", i + 1);
        memcpy(t->conditions + (size_t)i * d, o->derivatives[i].value,
               d * sizeof *t->conditions);
    }
    return BATTEN_OK;
}

static batten_status find_conditions(spline_problem *t)
{
    const batten_curve_interpolate_options *o = t->options;
    const size_t d = (size_t)t->dimension;
    if (o->derivative_count < 0 || (o->derivative_count > 0 && !o->derivatives))
        return bat_fail(BATTEN_BAD_ARGUMENT, "there are %d derivatives", o->derivative_count);
    t->conditions = bat_array3((size_t)o->derivative_count, d, sizeof *t->conditions);
    return t->conditions ? copy_derivatives(t) : BATTEN_OUT_OF_MEMORY;
}

static batten_status solve_with_slopes(spline_problem *t)
{
    const bat_spline_data given = {(size_t)t->dimension, t->points, t->start, t->end,
                                   t->conditions};
    return bat_operator_apply(&t->op, &given, t->control);
}

/* ---- curvature at an end ---- */

/* The tangents at the ends, affine in the second derivatives there: base[e] + sum of
 * response[e][f] second[f]. An end whose curvature is not given has no second derivative to
 * vary. */
typedef struct {
    const double *wanted[2]; /* curvature; NULL for such an end */
    double base[2][3], response[2][2];
} end_model;

static void end_tangents(const bat_operator *op, int d, const double *control, double *start,
                         double *end)
{
    const int p = op->degree, n = op->count;
    const double *P = control, *Q = control + (size_t)(n - 2) * (size_t)d, *U = op->knots;
    for (int k = 0; k < d; k++) {
        start[k] = p * (P[d + k] - P[k]) / (U[p + 1] - U[1]);
        end[k] = p * (Q[d + k] - Q[k]) / (U[n + p - 1] - U[n - 1]);
    }
}

static batten_status find_model(spline_problem *t, end_model *model)
{
    const double one = 1, zero = 0;
    double *zeros = bat_array((size_t)t->op.count, sizeof *zeros);
    if (!zeros)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = solve_with_slopes(t);
    end_tangents(&t->op, t->dimension, t->control, model->base[0], model->base[1]);
    for (int f = 0; status == BATTEN_OK && f < 2; f++) {
        const bat_spline_data given = {1, zeros, f == 0 ? &one : &zero, f == 1 ? &one : &zero,
                                       zeros};
        status = bat_operator_apply(&t->op, &given, t->control);
        end_tangents(&t->op, 1, t->control, &model->response[0][f], &model->response[1][f]);
    }
    bat_release(zeros);
    return status;
}

/* Move the second derivative towards the one at right angles to the tangent that gives the
 * wanted curvature at this speed. Returns by how much it was off, against its size. `response`:
 * how much the tangent may change with the second derivatives. */
static double step_second(int d, const double *wanted, const double *tangent, double response,
                          double *second)
{
    const double square = bat_dot(d, tangent, tangent), along = bat_dot(d, wanted, tangent);
    /* The step turns an error by a right angle and lengthens it by r; this damping serves it
     * best. */
    const double r2 = 4 * bat_dot(d, wanted, wanted) * square * response * response;
    const double damping = 1 / (1 + r2);
    double off = 0, size = DBL_MIN;
    for (int k = 0; k < d; k++) {
        const double next = wanted[k] * square - along * tangent[k];
        off = bat_max(off, fabs(next - second[k]));
        size = bat_max(size, fabs(next));
        second[k] += damping * (next - second[k]);
    }
    return off / size;
}

/* One round at both ends; how much is still off. */
static double step_both(int d, const end_model *m, double second[2][3])
{
    double tangent[2][3], off = 0;
    for (int e = 0; e < 2; e++)
        for (int k = 0; k < d; k++)
            tangent[e][k] = m->base[e][k] + m->response[e][0] * second[0][k] +
                            m->response[e][1] * second[1][k];
    for (int e = 0; e < 2; e++)
        if (m->wanted[e])
            off = bat_max(off, step_second(d, m->wanted[e], tangent[e],
                                           fabs(m->response[e][0]) + fabs(m->response[e][1]),
                                           second[e]));
    return off;
}

/* Curvature is not linear: it divides by the square of the speed, which changes with it. The
 * second derivative stands at right angles to the tangent, so damped steps come to rest. */
static batten_status apply_curvatures(spline_problem *t)
{
    const batten_end *ends[2] = {&t->options->start, &t->options->end};
    double *values[2] = {t->start, t->end}, second[2][3] = {{0}}, off = 1;
    end_model model = {0};
    for (int e = 0; e < 2; e++)
        if (ends[e]->kind == BATTEN_END_CURVATURE) {
            model.wanted[e] = ends[e]->vector;
            memset(values[e], 0, 3 * sizeof(double));
        }
    const batten_status status = find_model(t, &model);
    if (status != BATTEN_OK)
        return status;
    /* A round makes some ten roundings; more where the tangent is a small difference, and there
     * the last rounds can turn about the solution: a billionth of the curvature is near enough
     * then. */
    for (int round = 0; off > 32 * DBL_EPSILON && round < 10000; round++)
        off = step_both(t->dimension, &model, second);
    if (!(off <= 1e-9))
        return bat_fail(
            BATTEN_TOLERANCE_NOT_MET,
            "the curvatures at the ends were not reached: they were off by %g of their size",
            off);
    for (int e = 0; e < 2; e++)
        if (model.wanted[e])
            memcpy(values[e], second[e], sizeof second[e]);
    return solve_with_slopes(t);
}

/* ---- the whole ---- */

static batten_status prepare(spline_problem *t)
{
    const batten_curve_interpolate_options *o = t->options;
    batten_status status = find_parameters(t);
    t->request = (bat_request){.degree = o->degree,
                               .count = t->count,
                               .parameters = t->parameters,
                               .knots_at_data = o->knots_at_data,
                               .periodic = o->closed,
                               .condition_count = o->derivative_count,
                               .conditions = o->derivatives};
    if (status == BATTEN_OK && o->knots_at_data && !o->closed)
        status = find_ends(t);
    if (status == BATTEN_OK)
        status = find_conditions(t);
    if (status == BATTEN_OK)
        status = bat_operator_make(&t->request, &t->op);
    return status;
}

static batten_status interpolate(spline_problem *t, batten_curve **curve)
{
    batten_status status = prepare(t);
    if (status != BATTEN_OK)
        return status;
    const bat_operator *op = &t->op;
    t->control = bat_resize(NULL, (size_t)op->count, (size_t)t->dimension * sizeof *t->control);
    if (!t->control)
        return BATTEN_OUT_OF_MEMORY;
    const bool ends = t->options->knots_at_data && !t->options->closed;
    if (ends && (t->options->start.kind == BATTEN_END_CURVATURE ||
                 t->options->end.kind == BATTEN_END_CURVATURE))
        status = apply_curvatures(t);
    else
        status = solve_with_slopes(t);
    if (status != BATTEN_OK)
        return status;
    return op->periodic
               ? batten_curve_create_periodic(
                     (batten_points){t->dimension, op->count, t->control}, op->degree, NULL,
                     op->knots, curve)
               : batten_curve_create((batten_points){t->dimension, op->count, t->control},
                                     op->degree, NULL, op->knots, curve);
}

batten_status batten_curve_interpolate(batten_points points,
                                       const batten_curve_interpolate_options *options,
                                       double *parameters, batten_curve **out)
{
    batten_curve_interpolate_options chosen = batten_curve_interpolate_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_interpolate_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    status = bat_points_check(points.dimension, points.count, points.at, 2);
    if (status != BATTEN_OK)
        return status;
    spline_problem t = {.dimension = points.dimension,
                        .count = points.count,
                        .points = points.at,
                        .options = &chosen};
    batten_curve *curve = NULL;
    status = interpolate(&t, &curve);
    if (status == BATTEN_OK) {
        if (parameters)
            memcpy(parameters, t.parameters, (size_t)points.count * sizeof *parameters);
        *out = curve;
    }
    bat_release(t.control);
    bat_release(t.conditions);
    bat_operator_free(&t.op);
    bat_release(t.parameters);
    return status;
}
