/* Curves of least energy: from points to nodes and back. */
#include "base/plural.h"
#include "numeric/vector.h"
#include "shape/bent/energy.h"
#include "shape/points/parametrize.h"
#include <batten/curve.h>

#include <string.h>

/* ---- points ---- */

static void release_nodes(bat_energy_curve *nodes)
{
    bat_release(nodes->x);
    bat_release(nodes->step);
    bat_release(nodes->unknown);
    bat_release(nodes->frame);
    *nodes = (bat_energy_curve){.d = nodes->d, .closed = nodes->closed};
}

void bat_energy_spline_end(bat_energy_spline *t)
{
    bat_release(t->points);
    bat_release(t->parameters);
    release_nodes(&t->nodes);
}

batten_status bat_energy_spline_begin(bat_energy_spline *t)
{
    const int d = t->d, n = t->count;
    t->nodes.d = d;
    t->nodes.closed = t->options->closed;
    t->points = bat_array3((size_t)n, (size_t)d, sizeof *t->points);
    t->parameters = bat_array((size_t)n + 1, sizeof *t->parameters);
    if (!t->points || !t->parameters)
        return BATTEN_OUT_OF_MEMORY;
    double *u = t->parameters;
    batten_status status =
        bat_parametrize((batten_points){d, n, t->given}, BATTEN_CHORD, t->options->closed, u);
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

/* ---- nodes ---- */

/* The limit of what a search can hold, some gigabytes. */
enum { MOST_QUINTICS = 4000000 };

static batten_status make_nodes(const bat_energy_spline *t, int pieces, bat_energy_curve *nodes)
{
    const size_t n = (size_t)t->count, d = (size_t)t->d;
    if (n * (size_t)pieces > (size_t)MOST_QUINTICS)
        return bat_fail(BATTEN_TOO_LARGE, "%d point%s with %d piece%s between them", t->count,
                        bat_plural(t->count), pieces, bat_plural(pieces));
    *nodes = (bat_energy_curve){.d = t->d, .closed = t->options->closed};
    nodes->spans = (t->count - !nodes->closed) * pieces;
    nodes->count = nodes->spans + !nodes->closed;
    nodes->x = bat_array3((size_t)nodes->count, 3 * d, sizeof *nodes->x);
    nodes->unknown = bat_array3((size_t)nodes->count, 3 * d, sizeof *nodes->unknown);
    nodes->step = bat_array((size_t)nodes->spans, sizeof *nodes->step);
    nodes->frame = bat_array3((size_t)nodes->count, d * d, sizeof *nodes->frame);
    return nodes->x && nodes->unknown && nodes->step && nodes->frame ? BATTEN_OK
                                                                     : BATTEN_OUT_OF_MEMORY;
}

static batten_status evaluate_start(const bat_energy_start *start, double u, double *x)
{
    return start->chain ? batten_chain_evaluate(start->chain, u, 2, x)
                        : batten_curve_evaluate(start->curve, u, 2, x);
}

/* All nodes and steps. */
static batten_status evaluate_nodes(bat_energy_spline *t, const bat_energy_start *start)
{
    const int pieces = t->pieces, d = t->d;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < t->nodes.count && status == BATTEN_OK; i++) {
        const int j = i / pieces, part = i % pieces;
        const double a = t->parameters[j], h = part ? t->parameters[j + 1] - a : 0;
        double *x = t->nodes.x + (size_t)i * 3 * (size_t)d;
        status = evaluate_start(start, a + h * part / pieces, x);
        /* The points are the points. */
        if (part == 0)
            memcpy(x, t->points + (size_t)j * (size_t)d, (size_t)d * sizeof *x);
    }
    for (int j = 0; j < t->nodes.spans; j++)
        t->nodes.step[j] = (t->parameters[j / pieces + 1] - t->parameters[j / pieces]) / pieces;
    return status;
}

/* ---- ends ---- */

/* What is given at one end: P' along the tangent, with speed 1 when there is a curvature, which
 * P'' then is across it. */
static void fix_end(bat_energy_spline *t, int end, const double *tangent,
                    const double *curvature)
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
static void number_unknowns(bat_energy_spline *t)
{
    bat_energy_curve *nodes = &t->nodes;
    const int d = t->d, n = nodes->count;
    for (int place = 0; place < n; place++) {
        const int node = !nodes->closed ? place : place % 2 ? n - (place + 1) / 2 : place / 2;
        for (int i = 0; i < 3 * d; i++) {
            int *u = &nodes->unknown[node * 3 * d + i];
            const bool given = i == 0 || i == 2 * d || (i < d && node % t->pieces == 0);
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

/* Unknowns, with what is given at the ends. */
static void prepare_unknowns(bat_energy_spline *t)
{
    const batten_curve_minimum_energy_options *o = t->options;
    memset(t->nodes.unknown, 0,
           (size_t)t->nodes.count * 3 * (size_t)t->d * sizeof *t->nodes.unknown);
    t->nodes.unknown_count = t->nodes.band = 0;
    if (!o->closed) {
        fix_end(t, 0, o->start_tangent, o->start_curvature);
        fix_end(t, 1, o->end_tangent, o->end_curvature);
    }
    number_unknowns(t);
}

batten_status bat_energy_spline_sample(bat_energy_spline *t, const bat_energy_start *start,
                                       int pieces)
{
    release_nodes(&t->nodes);
    t->pieces = pieces;
    memcpy(t->parameters, start->parameters, ((size_t)t->count + 1) * sizeof *t->parameters);
    batten_status status = make_nodes(t, pieces, &t->nodes);
    if (status == BATTEN_OK)
        status = evaluate_nodes(t, start);
    if (status == BATTEN_OK)
        prepare_unknowns(t);
    return status;
}

/* Point and two derivatives [3][d] in the middle of span j. */
static void middle_of(const bat_energy_curve *nodes, int j, double *x)
{
    const int d = nodes->d;
    const double h = nodes->step[j];
    double b[6 * 3];
    bat_energy_bezier(nodes, j, b);
    for (int c = 0; c < d; c++) {
        double row[6];
        for (int i = 0; i < 6; i++)
            row[i] = b[i * d + c];
        for (int k = 5; k > 2; k--) /* de Casteljau's steps down to three points */
            for (int i = 0; i < k; i++)
                row[i] = (row[i] + row[i + 1]) / 2;
        x[c] = (row[0] + 2 * row[1] + row[2]) / 4;
        x[d + c] = 5 * (row[2] - row[0]) / 2 / h;
        x[2 * d + c] = 20 * (row[2] - 2 * row[1] + row[0]) / (h * h);
    }
}

batten_status bat_energy_spline_halve(bat_energy_spline *t)
{
    const size_t each = 3 * (size_t)t->d;
    bat_energy_curve old = t->nodes;
    t->nodes = (bat_energy_curve){0};
    const batten_status status = make_nodes(t, 2 * t->pieces, &t->nodes);
    for (int i = 0; i < old.count && status == BATTEN_OK; i++)
        memcpy(t->nodes.x + 2 * (size_t)i * each, old.x + (size_t)i * each,
               each * sizeof *old.x);
    for (int j = 0; j < old.spans && status == BATTEN_OK; j++) {
        middle_of(&old, j, t->nodes.x + (2 * (size_t)j + 1) * each);
        t->nodes.step[2 * j] = t->nodes.step[2 * j + 1] = old.step[j] / 2;
    }
    release_nodes(&old);
    if (status != BATTEN_OK)
        return status;
    t->pieces *= 2;
    prepare_unknowns(t);
    return BATTEN_OK;
}

/* ---- the result ---- */

batten_status bat_energy_spline_curve(const bat_energy_spline *t, double *parameters,
                                      batten_curve **out)
{
    const bat_energy_curve *nodes = &t->nodes;
    const size_t d = (size_t)t->d, spans = (size_t)nodes->spans;
    double *points = bat_array3(spans * 5 + 1, d, sizeof *points);
    double *breaks = bat_array(spans + 1, sizeof *breaks);
    batten_status status = points && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    parameters[0] = 0;
    for (int j = 0; j < nodes->spans && status == BATTEN_OK; j++) {
        bat_energy_bezier(nodes, j, points + (size_t)j * 5 * d);
        breaks[j + 1] = breaks[j] + t->unit * nodes->step[j];
        if ((j + 1) % t->pieces == 0)
            parameters[(j + 1) / t->pieces] = breaks[j + 1];
    }
    for (size_t i = 0; i < (spans * 5 + 1) * d && status == BATTEN_OK; i++)
        points[i] = points[i] * t->unit + t->given[i % d];
    /* The data themselves, not rounded. */
    for (int i = 0; i < t->count && status == BATTEN_OK; i++)
        memcpy(points + (size_t)i * 5 * (size_t)t->pieces * d, t->given + (size_t)i * d,
               d * sizeof *points);
    if (status == BATTEN_OK && nodes->closed)
        memcpy(points + spans * 5 * d, t->given, d * sizeof *points);
    if (status == BATTEN_OK)
        status = batten_curve_from_bezier(t->d, (batten_pieces){5, nodes->spans, breaks},
                                          points, NULL, out);
    bat_release(points);
    bat_release(breaks);
    return status;
}
