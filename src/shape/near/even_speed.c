/*
 * Approximate reparametrization by arc length: quintic Hermite pieces that match point, tangent
 * and curvature, halved until they are within the tolerance.
 */
#include "shape/near/even_speed.h"
#include "base/plural.h"
#include "inspect/singular.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <batten/measure.h>
#include <string.h>

enum { DEPTH = 50, SAMPLES = 7, MOST_PIECES = 100000 };

/* The curve at u, seen from one side, by its arc length. */
typedef struct {
    double u, s;
    double q[3][3]; /* point, tangent, curvature vector */
} place;

typedef struct {
    int dimension;
    double size, tolerance;
    int most; /* pieces */
    batten_curve_even_speed_report report;
    /* the smooth run in the making */
    int count, room;
    double *s, *values; /* [count], [count][3][dimension] */
    /* those that are made */
    int run_count, run_room;
    batten_curve **runs;
} task;

/* ---- the curve by arc length ---- */

/* dC/ds = C' / v, d2C/ds2 = what of C'' lies across it, / v^2. Where the curve stands still it
 * has a direction, and its curvature, which may be infinite, counts as 0. */
static batten_status evaluate_at_length(const task *t, const batten_curve *curve, double u,
                                        batten_side side, double s, place *out)
{
    const int d = t->dimension;
    double c[3 * 3], x[3];
    batten_curve_local local;
    batten_status status = batten_curve_evaluate_side(curve, u, side, 2, c);
    if (status == BATTEN_OK)
        status = bat_curve_local_at(curve, t->size, u, side, &local);
    if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
        return status;
    *out = (place){.u = u, .s = s};
    x[0] = local.tangent.x;
    x[1] = local.tangent.y;
    x[2] = local.tangent.z;
    const double v = bat_norm(d, c + d), along = bat_dot(d, c + 2 * d, x);
    for (int k = 0; k < d; k++) {
        out->q[0][k] = c[k];
        out->q[1][k] = x[k];
        if (status == BATTEN_OK)
            out->q[2][k] = (c[2 * d + k] - along * x[k]) / (v * v);
    }
    return BATTEN_OK;
}

static batten_status length(const task *t, const batten_curve *piece, double a, double b,
                            double *out)
{
    return batten_curve_length_between(piece, a, b, t->tolerance / 1000, NULL, out);
}

static void copy_derivatives(int d, const place *at, double *values)
{
    for (int m = 0; m < 3; m++)
        memcpy(values + m * d, at->q[m], (size_t)d * sizeof *values);
}

/* How far the quintic from a to b is from the piece, and its speed from one. */
static batten_status measure_quintic(const task *t, const batten_curve *piece, const place *a,
                                     const place *b, double *error, double *speed)
{
    const int d = t->dimension;
    const double ends[2] = {a->s, b->s};
    double values[2 * 3 * 3], s = a->s, u = a->u;
    batten_curve *quintic = NULL;
    copy_derivatives(d, a, values);
    copy_derivatives(d, b, values + 3 * d);
    batten_status status = batten_curve_from_hermite(d, 2, 3, ends, values, &quintic);
    *error = *speed = 0;
    for (int i = 1; status == BATTEN_OK && i <= SAMPLES; i++) {
        const double next = a->u + (b->u - a->u) * (i / (SAMPLES + 1.0));
        double step = 0, p[3], q[2 * 3];
        status = length(t, piece, u, next, &step);
        s = bat_min(s + step, b->s);
        u = next;
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(piece, u, 0, p);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(quintic, s, 1, q);
        if (status == BATTEN_OK) {
            *error = bat_max(*error, 1.2 * bat_distance(d, p, q));
            *speed = bat_max(*speed, fabs(bat_norm(d, q + d) - 1));
        }
    }
    batten_curve_unref(quintic);
    return status;
}

/* ---- runs ---- */

static batten_status add_place(task *t, const place *at)
{
    if (t->count == t->room) {
        const int room = bat_max_int(16, 2 * t->room);
        double *s = bat_resize(t->s, (size_t)room, sizeof *s);
        if (!s)
            return BATTEN_OUT_OF_MEMORY;
        t->s = s;
        double *values =
            bat_resize(t->values, (size_t)room * 3 * (size_t)t->dimension, sizeof *values);
        if (!values)
            return BATTEN_OUT_OF_MEMORY;
        t->values = values;
        t->room = room;
    }
    t->s[t->count] = at->s;
    copy_derivatives(t->dimension, at,
                     t->values + (size_t)(3 * t->count) * (size_t)t->dimension);
    t->count++;
    return BATTEN_OK;
}

static batten_status finish_run(task *t)
{
    if (t->count < 2)
        return BATTEN_OK;
    if (t->run_count == t->run_room) {
        const int room = bat_max_int(16, 2 * t->run_room);
        batten_curve **grown = bat_resize(t->runs, (size_t)room, sizeof *grown);
        if (!grown)
            return BATTEN_OUT_OF_MEMORY;
        t->runs = grown;
        t->run_room = room;
    }
    const batten_status status = batten_curve_from_hermite(t->dimension, t->count, 3, t->s,
                                                           t->values, &t->runs[t->run_count]);
    t->run_count += status == BATTEN_OK;
    t->count = 0;
    return status;
}

/* Do both sides of a knot have one tangent and one curvature? */
static bool goes_on(const task *t, const place *left, const place *right)
{
    for (int m = 1; m < 3; m++) {
        const double size =
            bat_max(bat_norm(t->dimension, left->q[m]), bat_norm(t->dimension, right->q[m]));
        if (bat_distance(t->dimension, left->q[m], right->q[m]) > 1e-9 * size)
            return false;
    }
    return true;
}

/* From `a`, the last place of the run, along one polynomial piece to its end `b`. */
static batten_status follow(task *t, const batten_curve *piece, place a, const place *b)
{
    double ends[DEPTH + 2];
    int waiting = 1;
    ends[0] = b->u;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && waiting > 0) {
        place next = *b;
        double step = 0, error = 0, speed = 0;
        if (waiting > 1)
            status = length(t, piece, a.u, ends[waiting - 1], &step);
        if (status == BATTEN_OK && waiting > 1)
            status = evaluate_at_length(t, piece, ends[waiting - 1], BATTEN_FROM_LEFT,
                                        a.s + step, &next);
        if (status == BATTEN_OK)
            status = measure_quintic(t, piece, &a, &next, &error, &speed);
        if (status != BATTEN_OK)
            return status;
        const double middle = a.u + (next.u - a.u) / 2;
        if (error > t->tolerance) {
            if (waiting > DEPTH || !(middle > a.u && middle < next.u) ||
                t->report.pieces >= t->most)
                return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                                "the curve is missed by %g near u = %.17g after %d piece%s",
                                error, a.u, t->report.pieces, bat_plural(t->report.pieces));
            ends[waiting++] = middle;
            continue;
        }
        t->report.error = bat_max(t->report.error, error);
        t->report.speed = bat_max(t->report.speed, speed);
        t->report.pieces++;
        status = add_place(t, &next);
        a = next;
        waiting--;
    }
    return status;
}

/* One polynomial piece; *last, where the one before ended, moves to its end. */
static batten_status add_piece(task *t, const batten_curve *bezier, double a, double b,
                               bool first, place *last)
{
    batten_curve *piece = NULL;
    place start, end;
    double whole = 0;
    batten_status status = bat_bezier_part(bezier, a, b, &piece);
    if (status == BATTEN_OK)
        status = length(t, piece, a, b, &whole);
    /* What is a point, or lost in rounding, is passed over. */
    const double s = first ? 0 : last->s;
    if (status != BATTEN_OK || !(s + whole > s) || whole <= 1e-14 * t->size) {
        batten_curve_unref(piece);
        return status;
    }
    status = evaluate_at_length(t, piece, a, BATTEN_FROM_RIGHT, s, &start);
    if (status == BATTEN_OK && (t->count == 0 || !goes_on(t, last, &start))) {
        status = finish_run(t);
        if (status == BATTEN_OK)
            status = add_place(t, &start);
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

static batten_status add_pieces(task *t, const batten_curve *bezier)
{
    const int knots = batten_curve_spans(bezier, NULL);
    double *at = bat_array((size_t)knots, sizeof *at);
    place last = {.s = 0};
    batten_status status = at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(bezier, at);
    for (int i = 0; status == BATTEN_OK && i + 1 < knots; i++)
        status = add_piece(t, bezier, at[i], at[i + 1], last.s == 0, &last);
    if (status == BATTEN_OK)
        status = finish_run(t);
    if (status == BATTEN_OK && t->run_count == 0)
        status = bat_fail(BATTEN_COINCIDENT, "the curve is a point: it has no length");
    t->report.length = last.s;
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
    task t = {.dimension = curve->dimension,
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
    bat_release(t.values);
    bat_release(t.s);
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
