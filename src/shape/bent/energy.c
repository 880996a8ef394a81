/* Curves of least energy: from points to nodes and back. */
#include "shape/bent/energy.h"
#include "base/plural.h"
#include "numeric/vector.h"
#include "shape/points/parametrize.h"
#include "spline/data_check.h"
#include <batten/bent.h>
#include <batten/curve.h>

#include <string.h>

enum { MOST_PIECES = 16 };

batten_curve_minimum_energy_options batten_curve_minimum_energy_defaults(void)
{
    return (batten_curve_minimum_energy_options){
        .size = sizeof(batten_curve_minimum_energy_options),
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

static batten_status check_energy_options(int d, int count, const double *points,
                                          const batten_curve_minimum_energy_options *options)
{
    if (d < 2 || d > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve of least energy in %d dimension%s", d,
                        bat_plural(d));
    if ((int)options->energy < 0 || options->energy > BATTEN_ENERGY_VARIATION)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown energy %d", (int)options->energy);
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
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d step%s; at least 1 is needed",
                        options->max_steps, bat_plural(options->max_steps));
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
    const batten_curve_minimum_energy_options *options;
    int d, count;
    const double *given;
    double unit;
    double *points;     /* [count][d] */
    double *parameters; /* [count + 1] */
    bat_energy_curve nodes;
} energy_spline;

static void task_end(energy_spline *t)
{
    bat_release(t->points);
    bat_release(t->parameters);
    bat_release(t->nodes.x);
    bat_release(t->nodes.step);
    bat_release(t->nodes.unknown);
    bat_release(t->nodes.frame);
}

static batten_status normalise(energy_spline *t)
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

static batten_status task_begin(energy_spline *t)
{
    bat_energy_curve *nodes = &t->nodes;
    const size_t n = (size_t)t->count, d = (size_t)t->d, pieces = (size_t)t->options->pieces;
    if (n * pieces > (size_t)4000000)
        return bat_fail(BATTEN_TOO_LARGE, "%d point%s with %d piece%s between them", t->count,
                        bat_plural(t->count), t->options->pieces,
                        bat_plural(t->options->pieces));
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

/* ---- where the search begins ---- */

/* A plane spline whose parameter is the arc length, near the curve that is sought: for bending
 * the elastica, which is it, for variation Spiro, which is near it; else Euler spirals. */
static batten_status find_chain(const energy_spline *t, double *parameters, batten_chain **out)
{
    const batten_curve_minimum_energy_options *o = t->options;
    const bool bending = o->energy == BATTEN_ENERGY_BENDING;
    batten_chain_nonlinear_options nonlinear = batten_chain_nonlinear_defaults();
    batten_chain_spiro_options spiro = batten_chain_spiro_defaults();
    const double *const tangents[2] = {o->start_tangent, o->end_tangent};
    batten_nonlinear_end kinds[2];
    double angles[2];
    for (int e = 0; e < 2; e++) {
        angles[e] = tangents[e] ? atan2(tangents[e][1], tangents[e][0]) : 0;
        kinds[e] = tangents[e] ? BATTEN_NONLINEAR_TANGENT
                   : bending   ? BATTEN_NONLINEAR_NATURAL
                               : BATTEN_NONLINEAR_CIRCULAR;
    }
    nonlinear.closed = spiro.closed = o->closed;
    nonlinear.start = kinds[0], nonlinear.end = kinds[1];
    nonlinear.start_value = spiro.start.tangent = angles[0];
    nonlinear.end_value = spiro.end.tangent = angles[1];
    spiro.start.has_tangent = tangents[0], spiro.end.has_tangent = tangents[1];
    nonlinear.family = BATTEN_FAMILY_ELASTICA;
    batten_status status = bending
                               ? batten_chain_nonlinear((batten_points){2, t->count, t->points},
                                                        &nonlinear, NULL, parameters, NULL, out)
                               : batten_chain_spiro((batten_points){2, t->count, t->points},
                                                    &spiro, parameters, NULL, out);
    nonlinear.family = BATTEN_FAMILY_EULER_SPIRAL;
    if (status != BATTEN_OK && status != BATTEN_OUT_OF_MEMORY)
        status = batten_chain_nonlinear((batten_points){2, t->count, t->points}, &nonlinear,
                                        NULL, parameters, NULL, out);
    return status;
}

/* All nodes from the chain or, when it is NULL, the curve; the steps from the parameters. */
static batten_status sample(energy_spline *t, const batten_chain *chain,
                            const batten_curve *curve)
{
    const int pieces = t->options->pieces, d = t->d;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < t->nodes.count && status == BATTEN_OK; i++) {
        const int j = i / pieces, part = i % pieces;
        const double a = t->parameters[j], h = part ? t->parameters[j + 1] - a : 0;
        double *x = t->nodes.x + (size_t)i * 3 * (size_t)d;
        status = chain ? batten_chain_evaluate(chain, a + h * part / pieces, 2, x)
                       : batten_curve_evaluate(curve, a + h * part / pieces, 2, x);
        /* The points are the points. */
        if (part == 0)
            memcpy(x, t->points + (size_t)j * (size_t)d, (size_t)d * sizeof *x);
    }
    for (int j = 0; j < t->nodes.spans; j++)
        t->nodes.step[j] = (t->parameters[j / pieces + 1] - t->parameters[j / pieces]) / pieces;
    return status;
}

/* *found: false when there is no such chain. */
static batten_status start_of_chain(energy_spline *t, bool *found)
{
    batten_chain *chain = NULL;
    double *at = bat_array((size_t)t->count + 1, sizeof *at);
    batten_status status = at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    *found = status == BATTEN_OK && t->d == 2 && t->count > 2;
    if (*found) {
        status = find_chain(t, at, &chain);
        *found = status == BATTEN_OK;
    }
    if (*found) {
        at[t->count - !t->options->closed] = batten_chain_domain(chain).b;
        memcpy(t->parameters, at, ((size_t)t->count + t->options->closed) * sizeof *at);
        status = sample(t, chain, NULL);
    }
    batten_chain_unref(chain);
    bat_release(at);
    return *found || status == BATTEN_OUT_OF_MEMORY ? status : BATTEN_OK;
}

/* A cubic spline by chord lengths. */
static batten_status start_of_cubic(energy_spline *t)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    const bool natural = t->options->energy == BATTEN_ENERGY_BENDING;
    options.parameters = BATTEN_GIVEN;
    options.given = t->parameters;
    options.knots_at_data = true;
    options.closed = t->options->closed;
    options.start.kind = options.end.kind =
        natural ? BATTEN_END_NATURAL : BATTEN_END_NOT_A_KNOT;
    batten_curve *curve = NULL;
    batten_status status = batten_curve_interpolate((batten_points){t->d, t->count, t->points},
                                                    &options, NULL, &curve);
    if (status == BATTEN_OK)
        status = sample(t, NULL, curve);
    batten_curve_unref(curve);
    return status;
}

/* ---- ends ---- */

/* What is given at one end: P' along the tangent, with speed 1 when there is a curvature, which
 * P'' then is across it. */
static void fix_end(energy_spline *t, int end, const double *tangent, const double *curvature)
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
static void number_unknowns(energy_spline *t)
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

static batten_status make_curve(const energy_spline *t, batten_curve **out)
{
    const bat_energy_curve *nodes = &t->nodes;
    const size_t d = (size_t)t->d, spans = (size_t)nodes->spans;
    double *points = bat_array3(spans * 5 + 1, d, sizeof *points);
    double *breaks = bat_array(spans + 1, sizeof *breaks);
    batten_status status = points && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int j = 0; j < nodes->spans && status == BATTEN_OK; j++) {
        bat_energy_bezier(nodes, j, points + (size_t)j * 5 * d);
        breaks[j + 1] = breaks[j] + t->unit * nodes->step[j];
        if ((j + 1) % t->options->pieces == 0)
            t->parameters[(j + 1) / t->options->pieces] = breaks[j + 1];
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
        status = batten_curve_from_bezier(t->d, (batten_pieces){5, nodes->spans, breaks},
                                          points, NULL, out);
    bat_release(points);
    bat_release(breaks);
    return status;
}

/* From units of the mean chord to those of the model. */
static void scale_report(const energy_spline *t, batten_curve_minimum_energy_report *report)
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

/* Make the parameter the arc length, unless so few quintics then have much more energy than
 * `energy`; false when it stays as it was. */
static batten_status go_by_length(energy_spline *t, bat_energy_task what, double energy,
                                  bool *changed)
{
    const bat_energy_curve *nodes = &t->nodes;
    const size_t count = (size_t)nodes->count * 3 * (size_t)nodes->d;
    double *x = bat_array(count, sizeof *x);
    double *step = bat_array((size_t)nodes->spans, sizeof *step);
    batten_status status = x && step ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_curve_minimum_energy_report now = {0};
        bat_energy_end end;
        memcpy(x, nodes->x, count * sizeof *x);
        memcpy(step, nodes->step, (size_t)nodes->spans * sizeof *step);
        what.max_steps = 0;
        *changed = bat_energy_by_length(&t->nodes);
        status = bat_energy_minimise(&what, &t->nodes, &now, &end);
        *changed = *changed && now.before <= 1.05 * energy;
    }
    if (status == BATTEN_OK && !*changed) {
        memcpy(nodes->x, x, count * sizeof *x);
        memcpy(nodes->step, step, (size_t)nodes->spans * sizeof *step);
    }
    bat_release(x);
    bat_release(step);
    return status;
}

/* Search, make the parameter the arc length, and search again, until that lowers the energy no
 * more. */
static batten_status search(energy_spline *t, bat_energy_task *what,
                            batten_curve_minimum_energy_report *report)
{
    enum { ROUNDS = 10 };
    const int most = what->max_steps;
    bool least = false, changed = true;
    for (int round = 0; round < ROUNDS && changed; round++) {
        const batten_curve_minimum_energy_report last = *report;
        bat_energy_end end;
        what->max_steps = most - last.steps;
        batten_status status = bat_energy_minimise(what, &t->nodes, report, &end);
        if (status != BATTEN_OK)
            return status;
        report->steps += last.steps;
        report->before = round > 0 ? last.before : report->before;
        /* Where no step helps any more, so small a rest is that of derivatives that cancel. */
        least = end == BAT_ENERGY_LEAST ||
                (end == BAT_ENERGY_STUCK && report->remaining <= 1e-9 * report->after);
        if (end == BAT_ENERGY_UNDERWAY ||
            (least && round > 0 && last.after - report->after <= 1e-9 * report->after))
            break;
        status = go_by_length(t, *what, report->after, &changed);
        if (status != BATTEN_OK)
            return status;
    }
    return least ? BATTEN_OK
                 : bat_fail(BATTEN_INCOMPLETE,
                            "%d step%s took the energy from %g to %g, and it could fall by %g "
                            "more: give directions at the ends, a tension, or more points",
                            report->steps, bat_plural(report->steps), report->before,
                            report->after, report->remaining);
}

/* From the curve that stands at the nodes. */
static batten_status search_from_here(energy_spline *t,
                                      batten_curve_minimum_energy_report *report)
{
    const batten_curve_minimum_energy_options *o = t->options;
    /* A tension is a force; energies are by the unit or its cube. */
    const double tension = o->energy == BATTEN_ENERGY_BENDING
                               ? t->unit * t->unit
                               : t->unit * t->unit * t->unit * t->unit;
    bat_energy_task what = {o->energy, o->scale_invariant, o->tension * tension, o->max_steps,
                            10 * bat_energy_length(&t->nodes)};
    *report = (batten_curve_minimum_energy_report){0};
    memset(t->nodes.unknown, 0,
           (size_t)t->nodes.count * 3 * (size_t)t->d * sizeof *t->nodes.unknown);
    t->nodes.unknown_count = t->nodes.band = 0;
    if (!o->closed) {
        fix_end(t, 0, o->start_tangent, o->start_curvature);
        fix_end(t, 1, o->end_tangent, o->end_curvature);
    }
    number_unknowns(t);
    return search(t, &what, report);
}

/* From a plane spline of its kind where there is one, and where that leads nowhere from the
 * cubic spline. */
static batten_status find(energy_spline *t, batten_curve_minimum_energy_report *report,
                          batten_curve **out)
{
    bool found = false;
    batten_status status = task_begin(t);
    if (status == BATTEN_OK)
        status = normalise(t);
    if (status == BATTEN_OK)
        status = start_of_chain(t, &found);
    if (status == BATTEN_OK && found)
        status = search_from_here(t, report);
    if (status == BATTEN_OK ? !found : status == BATTEN_INCOMPLETE && found) {
        status = normalise(t);
        if (status == BATTEN_OK)
            status = start_of_cubic(t);
        if (status == BATTEN_OK)
            status = search_from_here(t, report);
    }
    if (status == BATTEN_OK)
        status = make_curve(t, out);
    if (status == BATTEN_OK)
        scale_report(t, report);
    return status;
}

batten_status batten_curve_minimum_energy(batten_points points,
                                          const batten_curve_minimum_energy_options *options,
                                          double *parameters,
                                          batten_curve_minimum_energy_report *report,
                                          batten_curve **out)
{
    assert(points.at && out);
    batten_curve_minimum_energy_options chosen = batten_curve_minimum_energy_defaults();
    batten_status status =
        BAT_TAKE_OPTIONS(batten_curve_minimum_energy_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    energy_spline t = {
        .options = &chosen, .d = points.dimension, .count = points.count, .given = points.at};
    batten_curve_minimum_energy_report found = {0};
    batten_curve *curve = NULL;
    status = check_energy_options(points.dimension, points.count, points.at, t.options);
    if (status == BATTEN_OK)
        status = find(&t, &found, &curve);
    if (status == BATTEN_OK) {
        for (int i = 0; i < points.count && parameters; i++)
            parameters[i] = t.parameters[i];
        if (report)
            *report = found;
        *out = curve;
    }
    task_end(&t);
    return status;
}
