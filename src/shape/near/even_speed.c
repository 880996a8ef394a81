/*
 * Approximate reparametrization by arc length: quintic Hermite pieces that match point, tangent
 * and curvature, halved until a bound of their distance from the curve is within the tolerance.
 */
#include "shape/near/even_speed.h"
#include "base/list.h"
#include "base/plural.h"
#include "inspect/singular.h"
#include "numeric/halving.h"
#include "numeric/vector.h"
#include "shape/near/arc_length_bound.h"
#include "spline/curve/curve.h"
#include "spline/curve/hermite_run.h"

#include <batten/measure.h>
#include <float.h>
#include <string.h>

enum { DEPTH = 50, SAMPLES = 7, MOST_PIECES = 100000 };

/* Tangents and curvatures on both sides of a knot that differ by less are the same but for
 * rounding. */
static const double same_derivative = 1e-9;

/* The curve at u, seen from one side. */
typedef struct {
    double u;
    bat_hermite_place by_length; /* point, tangent, curvature vector */
    bool singular;               /* the curvature is not known */
} curve_place;

typedef struct {
    int dimension;
    double size, tolerance;
    int most; /* pieces */
    batten_curve_even_speed_report report;
    bat_hermite_run run; /* the smooth run in the making */
    int run_count, run_room;
    batten_curve **runs; /* those that are made */
} even_run;

/* ---- the curve by arc length ---- */

/* dC/ds = C' / v; d2C/ds2 is the part of C'' across it, / v^2. Where the curve stands still it
 * has a direction, and its curvature, which may be infinite, counts as 0. */
static batten_status evaluate_at_length(const even_run *t, const batten_curve *curve, double u,
                                        batten_side side, double s, curve_place *out)
{
    const int d = t->dimension;
    double c[3 * 3], x[3];
    batten_curve_local local;
    batten_status status = batten_curve_evaluate_side(curve, u, side, 2, c);
    if (status == BATTEN_OK)
        status = bat_curve_local_at(curve, t->size, u, side, &local);
    if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
        return status;
    *out = (curve_place){.u = u, .by_length.u = s, .singular = status != BATTEN_OK};
    x[0] = local.tangent.x;
    x[1] = local.tangent.y;
    x[2] = local.tangent.z;
    const double v = bat_norm(d, c + d), along = bat_dot(d, c + 2 * d, x);
    for (int k = 0; k < d; k++) {
        out->by_length.q[0][k] = c[k];
        out->by_length.q[1][k] = x[k];
        if (status == BATTEN_OK)
            out->by_length.q[2][k] = (c[2 * d + k] - along * x[k]) / (v * v);
    }
    return BATTEN_OK;
}

static batten_status length(const even_run *t, const batten_curve *piece, double a, double b,
                            double *out)
{
    return batten_curve_length_between(piece, a, b, t->tolerance / 1000, NULL, out);
}

/*
 * A point of the curve at t of the piece is within t h of its start and (1 - t) h of its end. Of
 * the six control points of the quintic the first three are within `leg` of the start, the others
 * of the end; with the share f of the last three, f(t) + f(1 - t) = 1, the distance is at most
 * leg + ((1 - f) t + f (1 - t)) h, and the factor of h is largest in the middle, 1/2.
 */
static double crude_bound(const even_run *t, const curve_place *a, const curve_place *b)
{
    const double h = b->by_length.u - a->by_length.u;
    const double bend = bat_max(bat_norm(t->dimension, a->by_length.q[2]),
                                bat_norm(t->dimension, b->by_length.q[2]));
    return 0.5 * h + (0.4 * h + h * h * bend / 20);
}

/* A bound of the distance between the quintic from a to b and the piece. */
static batten_status bound_error(const even_run *t, const batten_curve *piece,
                                 const curve_place *a, const curve_place *b, double *error)
{
    batten_curve *part = NULL;
    batten_status status = BATTEN_OK;
    *error = INFINITY;
    if (!a->singular && !b->singular)
        status = bat_bezier_part(piece, a->u, b->u, &part);
    if (part && status == BATTEN_OK)
        status = bat_arc_length_bound(part, b->by_length.u - a->by_length.u, error);
    batten_curve_unref(part);
    /* The length is known to a thousandth of the tolerance, and points, sums of three terms or
     * fewer, are rounded on both curves. */
    const double rounding = 2 * 3 * DBL_EPSILON * t->size;
    *error = bat_min(*error, crude_bound(t, a, b)) + t->tolerance / 1000 + rounding;
    return status;
}

/* How far the speed of the quintic from a to b is from 1. */
static batten_status measure_speed(const even_run *t, const curve_place *a,
                                   const curve_place *b, double *speed)
{
    const int d = t->dimension;
    const bat_hermite_place ends[2] = {a->by_length, b->by_length};
    batten_curve *quintic = NULL;
    batten_status status = bat_hermite_curve(d, 2, ends, &quintic);
    for (int i = 1; status == BATTEN_OK && i <= SAMPLES; i++) {
        double q[2 * 3];
        const double s = ends[0].u + (ends[1].u - ends[0].u) * (i / (SAMPLES + 1.0));
        status = batten_curve_evaluate(quintic, s, 1, q);
        if (status == BATTEN_OK)
            *speed = bat_max(*speed, fabs(bat_norm(d, q + d) - 1));
    }
    batten_curve_unref(quintic);
    return status;
}

/* ---- runs ---- */

static batten_status finish_run(even_run *t)
{
    batten_curve *made = NULL;
    batten_status status = bat_hermite_run_finish(&t->run, &made);
    if (status == BATTEN_OK && made)
        status = BAT_LIST_ADD(t->runs, t->run_count, t->run_room, made);
    if (status != BATTEN_OK)
        batten_curve_unref(made);
    return status;
}

/* From `a`, the last place of the run, along one polynomial piece to its end `b`. */
static batten_status follow(even_run *t, const batten_curve *piece, curve_place a,
                            const curve_place *b)
{
    bat_halving h = bat_halving_of(a.u, b->u, DEPTH);
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && h.waiting > 0) {
        curve_place next = *b;
        double step = 0, error = 0;
        if (h.waiting > 1)
            status = length(t, piece, a.u, h.b, &step);
        if (status == BATTEN_OK && h.waiting > 1)
            status = evaluate_at_length(t, piece, h.b, BATTEN_FROM_LEFT, a.by_length.u + step,
                                        &next);
        if (status == BATTEN_OK)
            status = bound_error(t, piece, &a, &next, &error);
        if (status != BATTEN_OK)
            return status;
        if (!(error <= t->tolerance)) {
            if (t->report.pieces >= t->most || !bat_halving_split(&h))
                return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                                "the curve is missed by %g near u = %.17g after %d piece%s",
                                error, a.u, t->report.pieces, bat_plural(t->report.pieces));
            continue;
        }
        status = measure_speed(t, &a, &next, &t->report.speed);
        t->report.error = bat_max(t->report.error, error);
        t->report.pieces++;
        if (status == BATTEN_OK)
            status = bat_hermite_run_add(&t->run, next.by_length.u, next.by_length.q[0]);
        a = next;
        bat_halving_accept(&h);
    }
    return status;
}

/* One polynomial piece; *last, where the one before ended, moves to its end. */
static batten_status add_piece(even_run *t, const batten_curve *bezier, double a, double b,
                               bool first, curve_place *last)
{
    batten_curve *piece = NULL;
    curve_place start, end;
    double whole = 0;
    batten_status status = bat_bezier_part(bezier, a, b, &piece);
    if (status == BATTEN_OK)
        status = length(t, piece, a, b, &whole);
    /* A piece that is a point, or lost in rounding, is skipped. */
    const double s = first ? 0 : last->by_length.u;
    if (status != BATTEN_OK || !(s + whole > s) || whole <= 1e-14 * t->size) {
        batten_curve_unref(piece);
        return status;
    }
    status = evaluate_at_length(t, piece, a, BATTEN_FROM_RIGHT, s, &start);
    if (status == BATTEN_OK &&
        (t->run.count == 0 || !bat_hermite_agrees(t->dimension, 1, last->by_length.q[0],
                                                  start.by_length.q[0], same_derivative))) {
        status = finish_run(t);
        if (status == BATTEN_OK)
            status = bat_hermite_run_add(&t->run, s, start.by_length.q[0]);
    }
    if (status == BATTEN_OK)
        status = evaluate_at_length(t, piece, b, BATTEN_FROM_LEFT, s + whole, &end);
    if (status == BATTEN_OK)
        status = follow(t, piece, start, &end);
    batten_curve_unref(piece);
    if (status == BATTEN_OK)
        *last = end;
    return status;
}

static batten_status add_pieces(even_run *t, const batten_curve *bezier)
{
    const int knots = batten_curve_spans(bezier, NULL);
    double *at = bat_array((size_t)knots, sizeof *at);
    curve_place last = {.by_length.u = 0};
    batten_status status = at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(bezier, at);
    for (int i = 0; status == BATTEN_OK && i + 1 < knots; i++)
        status = add_piece(t, bezier, at[i], at[i + 1], last.by_length.u == 0, &last);
    if (status == BATTEN_OK)
        status = finish_run(t);
    if (status == BATTEN_OK && t->run_count == 0)
        status = bat_fail(BATTEN_COINCIDENT, "the curve is a point: it has no length");
    t->report.length = last.by_length.u;
    bat_release(at);
    return status;
}

/* ---- the whole ---- */

/* A polyline keeps its points; its knots are the lengths up to them. */
static batten_status polyline(const batten_curve *curve, batten_curve_even_speed_report *report,
                              batten_curve **out)
{
    const size_t d = (size_t)curve->dimension;
    double *points = bat_array((size_t)curve->count, d * sizeof *points);
    double *knots = bat_array((size_t)curve->count + 2, sizeof *knots);
    batten_status status = points && knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int n = 0;
    for (int i = 0; status == BATTEN_OK && i < curve->count; i++) {
        const double *p = curve->points + (size_t)i * d;
        const double step =
            n ? bat_distance(curve->dimension, p, points + (size_t)(n - 1) * d) : 0;
        if (n && !(knots[n] + step > knots[n]))
            continue; /* the same point again */
        memcpy(points + (size_t)n * d, p, d * sizeof *p);
        knots[n + 1] = (n ? knots[n] : 0) + step;
        n++;
    }
    if (status == BATTEN_OK && n < 2)
        status = bat_fail(BATTEN_COINCIDENT, "the curve is a point: it has no length");
    if (status == BATTEN_OK) {
        knots[0] = 0;
        knots[n + 1] = knots[n];
        *report = (batten_curve_even_speed_report){.length = knots[n], .pieces = n - 1};
        status = batten_curve_create((batten_points){curve->dimension, n, points}, 1, NULL,
                                     knots, out);
    }
    bat_release(knots);
    bat_release(points);
    return status;
}

static batten_status even(const batten_curve *curve, double tolerance, int most,
                          batten_curve_even_speed_report *report, batten_curve **out)
{
    batten_curve *bezier = NULL;
    batten_status status = batten_curve_to_bezier(curve, &bezier);
    if (status != BATTEN_OK)
        return status;
    even_run t = {.dimension = curve->dimension,
                  .run.dimension = curve->dimension,
                  .size = bat_curve_size(bezier),
                  .tolerance = tolerance,
                  .most = most};
    if (curve->degree == 1 && !curve->weights)
        status = polyline(bezier, &t.report, out);
    else
        status = add_pieces(&t, bezier);
    if (status == BATTEN_OK && t.run_count)
        status = bat_curves_chain(t.run_count, t.runs, tolerance + 1e-12 * t.size, out);
    if (status == BATTEN_OK)
        *report = t.report;
    for (int i = 0; i < t.run_count; i++)
        batten_curve_unref(t.runs[i]);
    bat_release(t.runs);
    bat_hermite_run_release(&t.run);
    batten_curve_unref(bezier);
    return status;
}

batten_status bat_curve_even_speed(const batten_curve *curve, double tolerance, int most,
                                   batten_curve_even_speed_report *report, batten_curve **out)
{
    batten_curve_even_speed_report done;
    if (curve->dimension == 1)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "a function has no arc length; make its graph first");
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    const batten_status status = even(curve, tolerance, most, &done, out);
    if (status == BATTEN_OK && report)
        *report = done;
    return status;
}

batten_status batten_curve_even_speed(const batten_curve *curve, double tolerance,
                                      batten_curve_even_speed_report *report,
                                      batten_curve **out)
{
    assert(curve && out);
    return bat_curve_even_speed(curve, tolerance, MOST_PIECES, report, out);
}
