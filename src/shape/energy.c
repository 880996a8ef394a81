/* Curves of least energy: from points to nodes and back. */
#include "shape/energy.h"
#include "numeric/vector.h"
#include "shape/shape.h"
#include <batten/curve.h>

#include <string.h>

enum { MOST_PIECES = 16 };

batten_energy_options batten_energy_defaults(void)
{
    return (batten_energy_options){.size = sizeof(batten_energy_options),
                                   .energy = BATTEN_ENERGY_VARIATION,
                                   .pieces = 2,
                                   .max_steps = 200};
}

/* ---- what is asked ---- */

static batten_status check_end(const char *name, int d, const double *tangent,
                               const double *curvature)
{
    if (curvature && !tangent)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the curvature at the %s needs a tangent, to which it is square", name);
    const double *const given[2] = {tangent, curvature};
    for (int i = 0; i < 2; i++)
        if (given[i] && bat_first_not_finite(given[i], (size_t)d) < (size_t)d)
            return bat_fail(BATTEN_NOT_FINITE, "the %s at the %s is not finite",
                            i ? "curvature" : "tangent", name);
    if (tangent && bat_norm(d, tangent) == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tangent at the %s has no length", name);
    return BATTEN_OK;
}

static batten_status check(int d, int count, const double *points,
                           const batten_energy_options *options)
{
    if (d < 2 || d > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve of least energy in %d dimensions", d);
    if ((int)options->energy < 0 || options->energy > BATTEN_ENERGY_VARIATION)
        return bat_fail(BATTEN_BAD_ARGUMENT, "energy %d is none", (int)options->energy);
    if (!(options->tension >= 0 && isfinite(options->tension)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tension is %g; it must be 0 or more",
                        options->tension);
    if (options->tension > 0 && options->scale_invariant)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a tension has a unit, which a scale-invariant energy has not");
    if (options->pieces < 1 || options->pieces > MOST_PIECES)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d pieces between points; 1 to %d are possible",
                        options->pieces, MOST_PIECES);
    if (options->max_steps < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d steps; at least 1 is needed",
                        options->max_steps);
    batten_status status = bat_points_check(d, count, points, options->closed ? 3 : 2);
    if (status == BATTEN_OK && !options->closed)
        status = check_end("start", d, options->start_tangent, options->start_curvature);
    if (status == BATTEN_OK && !options->closed)
        status = check_end("end", d, options->end_tangent, options->end_curvature);
    return status;
}

/* ---- nodes ---- */

/* The points in units of their mean chord, from the first one; then all numbers are near 1. */
typedef struct {
    const batten_energy_options *options;
    int d, count;
    const double *given;
    double unit;
    double *points;     /* [count][d] */
    double *parameters; /* [count + 1] */
    bat_energy_curve nodes;
} task;

static void task_end(task *t)
{
    bat_release(t->points);
    bat_release(t->parameters);
    bat_release(t->nodes.x);
    bat_release(t->nodes.step);
    bat_release(t->nodes.unknown);
    bat_release(t->nodes.frame);
}

static batten_status normalise(task *t)
{
    const int d = t->d, n = t->count;
    double *u = t->parameters;
    batten_status status = bat_parametrize(d, n, t->given, BATTEN_CHORD, t->options->closed, u);
    if (status != BATTEN_OK)
        return status;
    const int spans = t->options->closed ? n : n - 1;
    t->unit = u[spans] / spans;
    if (!(t->unit > 0x1p-1000 && t->unit < 0x1p1000))
        return bat_fail(BATTEN_OVERFLOW, "points %g apart leave the numbers", t->unit);
    for (int i = 0; i < n * d; i++)
        t->points[i] = (t->given[i] - t->given[i % d]) / t->unit;
    for (int i = 0; i <= spans; i++)
        u[i] /= t->unit;
    return BATTEN_OK;
}

static batten_status task_begin(task *t)
{
    bat_energy_curve *nodes = &t->nodes;
    const size_t n = (size_t)t->count, d = (size_t)t->d, pieces = (size_t)t->options->pieces;
    if (n * pieces > (size_t)4000000)
        return bat_fail(BATTEN_TOO_LARGE, "%d points with %d pieces between them", t->count,
                        t->options->pieces);
    nodes->d = t->d;
    nodes->closed = t->options->closed;
    nodes->spans = (int)((n - !nodes->closed) * pieces);
    nodes->count = nodes->spans + !nodes->closed;
    t->points = bat_array3(n, d, sizeof *t->points);
    t->parameters = bat_array(n + 1, sizeof *t->parameters);
    nodes->x = bat_array3((size_t)nodes->count, 3 * d, sizeof *nodes->x);
    nodes->unknown = bat_array3((size_t)nodes->count, 3 * d, sizeof *nodes->unknown);
    nodes->step = bat_array((size_t)nodes->spans, sizeof *nodes->step);
    nodes->frame = bat_array3((size_t)nodes->count, d * d, sizeof *nodes->frame);
    return t->points && t->parameters && nodes->x && nodes->unknown && nodes->step &&
                   nodes->frame
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

/* The start: a cubic spline by chord lengths, at all nodes. */
static batten_status start(task *t)
{
    batten_interpolate_options options = batten_interpolate_defaults();
    const bool natural = t->options->energy == BATTEN_ENERGY_BENDING;
    options.parameters = BATTEN_GIVEN;
    options.given = t->parameters;
    options.knots_at_data = true;
    options.periodic = t->options->closed;
    options.start.kind = options.end.kind =
        natural ? BATTEN_END_NATURAL : BATTEN_END_NOT_A_KNOT;
    batten_curve *curve = NULL;
    batten_status status =
        batten_curve_interpolate(t->d, t->count, t->points, &options, NULL, &curve);
    const int pieces = t->options->pieces, d = t->d;
    for (int i = 0; i < t->nodes.count && status == BATTEN_OK; i++) {
        const int j = i / pieces, part = i % pieces;
        const double a = t->parameters[j], h = part ? t->parameters[j + 1] - a : 0;
        double *x = t->nodes.x + (size_t)i * 3 * (size_t)d;
        status = batten_curve_evaluate(curve, a + h * part / pieces, 2, x);
        /* The points are the points. */
        if (part == 0)
            memcpy(x, t->points + (size_t)j * (size_t)d, (size_t)d * sizeof *x);
    }
    for (int j = 0; j < t->nodes.spans; j++)
        t->nodes.step[j] = (t->parameters[j / pieces + 1] - t->parameters[j / pieces]) / pieces;
    batten_curve_unref(curve);
    return status;
}

/* ---- ends ---- */

/* What is given at one end: P' along the tangent, with speed 1 when there is a curvature, which
 * P'' then is across it. */
static void fix_end(task *t, int end, const double *tangent, const double *curvature)
{
    if (!tangent)
        return;
    const int d = t->d, node = end ? t->nodes.count - 1 : 0;
    double *x = t->nodes.x + node * 3 * d;
    int *unknown = t->nodes.unknown + node * 3 * d;
    const double norm = bat_norm(d, tangent);
    double before = 0, along = 0;
    for (int c = 0; c < d; c++) {
        before += x[2 * d + c] * tangent[c] / norm;
        along += curvature ? curvature[c] * tangent[c] / norm : 0;
        x[d + c] = tangent[c] / norm;
    }
    for (int k = 0; k < d; k++) {
        unknown[d + k] = k > 0 || curvature ? -1 : 0;
        if (curvature)
            x[2 * d + k] = (curvature[k] - along * x[d + k]) * t->unit + before * x[d + k];
        unknown[2 * d + k] = curvature ? -1 : 0;
    }
}

/*
 * Number what is unknown. Points move across the tangent only, and only those between the data;
 * the part of P'' along it stays as it was: these would but slide the parameter along the
 * curve. The nodes of a closed curve are taken from both sides of the first in turn, so that
 * neighbours, the last and the first too, keep their numbers near.
 */
static void number_unknowns(task *t)
{
    bat_energy_curve *nodes = &t->nodes;
    const int d = t->d, n = nodes->count;
    for (int place = 0; place < n; place++) {
        const int node = !nodes->closed ? place : place % 2 ? n - (place + 1) / 2 : place / 2;
        for (int i = 0; i < 3 * d; i++) {
            int *u = &nodes->unknown[node * 3 * d + i];
            const bool given =
                i == 0 || i == 2 * d || (i < d && node % t->options->pieces == 0);
            *u = *u < 0 || given ? -1 : nodes->unknown_count++;
        }
    }
    for (int j = 0; j < nodes->spans; j++) {
        int low = nodes->unknown_count, high = -1;
        for (int i = 0; i < 6 * d; i++) {
            const int node = i < 3 * d ? j : (j + 1) % n;
            const int u = nodes->unknown[node * 3 * d + i % (3 * d)];
            if (u >= 0) {
                low = bat_min_int(low, u);
                high = bat_max_int(high, u);
            }
        }
        nodes->band = bat_max_int(nodes->band, high - low);
    }
}

/* ---- the result ---- */

static batten_status make_curve(const task *t, batten_curve **out)
{
    const bat_energy_curve *nodes = &t->nodes;
    const size_t d = (size_t)t->d, spans = (size_t)nodes->spans;
    double *points = bat_array3(spans * 5 + 1, d, sizeof *points);
    double *breaks = bat_array(spans + 1, sizeof *breaks);
    batten_status status = points && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int j = 0; j < nodes->spans && status == BATTEN_OK; j++) {
        const int pieces = t->options->pieces, i = j / pieces, part = j % pieces;
        bat_energy_bezier(nodes, j, points + (size_t)j * 5 * d);
        breaks[j] = t->unit * (t->parameters[i] + nodes->step[j] * part);
        breaks[j + 1] = t->unit * t->parameters[i + 1];
    }
    for (size_t i = 0; i < (spans * 5 + 1) * d && status == BATTEN_OK; i++) {
        points[i] = points[i] * t->unit + t->given[i % d];
    }
    /* The data themselves, not rounded. */
    for (int i = 0; i < t->count && status == BATTEN_OK; i++)
        memcpy(points + (size_t)i * 5 * (size_t)t->options->pieces * d,
               t->given + (size_t)i * d, d * sizeof *points);
    if (status == BATTEN_OK && nodes->closed)
        memcpy(points + spans * 5 * d, t->given, d * sizeof *points);
    if (status == BATTEN_OK)
        status = batten_curve_from_bezier(t->d, 5, nodes->spans, points, NULL, breaks, out);
    bat_release(points);
    bat_release(breaks);
    return status;
}

/* From units of the mean chord to those of the model. */
static void scale_report(const task *t, batten_energy_report *report)
{
    const double unit = t->unit;
    const double power = t->options->scale_invariant                   ? 1
                         : t->options->energy == BATTEN_ENERGY_BENDING ? unit
                                                                       : unit * unit * unit;
    report->before /= power;
    report->after /= power;
    report->remaining /= power;
    report->length *= unit;
}

static batten_status find(task *t, batten_energy_report *report, batten_curve **out)
{
    const batten_energy_options *o = t->options;
    batten_status status = task_begin(t);
    if (status == BATTEN_OK)
        status = normalise(t);
    if (status == BATTEN_OK)
        status = start(t);
    if (status != BATTEN_OK)
        return status;
    if (!o->closed) {
        fix_end(t, 0, o->start_tangent, o->start_curvature);
        fix_end(t, 1, o->end_tangent, o->end_curvature);
    }
    number_unknowns(t);
    /* A tension is a force; energies are by the unit or its cube. */
    const double tension = o->energy == BATTEN_ENERGY_BENDING
                               ? t->unit * t->unit
                               : t->unit * t->unit * t->unit * t->unit;
    const bat_energy_task what = {o->energy, o->scale_invariant, o->tension * tension,
                                  o->max_steps};
    status = bat_energy_minimise(&what, &t->nodes, report);
    if (status == BATTEN_OK)
        status = make_curve(t, out);
    if (status == BATTEN_OK)
        scale_report(t, report);
    return status;
}

batten_status batten_curve_minimum_energy(int dimension, int count, const double *points,
                                          const batten_energy_options *options,
                                          double *parameters, batten_energy_report *report,
                                          batten_curve **out)
{
    assert(points && out);
    const batten_energy_options standard = batten_energy_defaults();
    task t = {.options = options ? options : &standard,
              .d = dimension,
              .count = count,
              .given = points};
    batten_energy_report found = {0};
    batten_curve *curve = NULL;
    batten_status status = check(dimension, count, points, t.options);
    if (status == BATTEN_OK)
        status = find(&t, &found, &curve);
    if (status == BATTEN_OK) {
        for (int i = 0; i < count && parameters; i++)
            parameters[i] = t.unit * t.parameters[i];
        if (report)
            *report = found;
        *out = curve;
    }
    task_end(&t);
    return status;
}
