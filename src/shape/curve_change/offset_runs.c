/*
 * The offset of a curve piece by piece.
 *
 * With T the unit tangent and k the curvature of the plan, N = (-Ty, Tx) and N' = -k |P'| T. So
 * Q = P + d N has, in the plane,
 *
 *     Q' = (1 - k d) P',   Q'' = (1 - k d) P'' - d k' P',
 *
 * and it turns back where k d = 1. Between those places, knots at which Q'' jumps and corners
 * it is as smooth as the curve; there quintics that have Q, Q', Q'' at both ends follow it with
 * an error that falls with the sixth power of their length.
 */
#include "base/plural.h"
#include "base/sort.h"
#include "inspect/singular.h"
#include "numeric/halving.h"
#include "numeric/vector.h"
#include "shape/curve_change/offset.h"
#include "spline/curve/curve.h"

#include <batten/standard.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 7 };

/* The offset at one parameter, seen from one side. */
typedef struct {
    double u;
    double p[3];    /* the curve */
    double t[2];    /* unit tangent of the plan */
    double factor;  /* 1 - k d */
    double k;       /* curvature */
    double q[3][3]; /* Q, Q', Q'' */
    bool singular;  /* the curve stands still: only p, t and q[0] are known */
} run_place;

/* Without a first derivative the tangent is that of the first derivative there is. */
static batten_status place_singular(const bat_offset *o, double u, batten_side side,
                                    run_place *out)
{
    batten_curve_local local;
    const batten_status status = bat_curve_local_at(o->plan, o->size, u, side, &local);
    if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
        return status;
    if (!(bat_vec3_norm(local.tangent) > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the curve has no direction at u = %.17g", u);
    out->singular = true;
    out->factor = 1;
    out->t[0] = local.tangent.x;
    out->t[1] = local.tangent.y;
    out->q[0][0] -= o->distance * out->t[1];
    out->q[0][1] += o->distance * out->t[0];
    return BATTEN_OK;
}

static batten_status place_at(const bat_offset *o, double u, batten_side side, run_place *out)
{
    const int d = o->full->dimension;
    double c[4 * 3];
    const batten_status status = batten_curve_evaluate_side(o->full, u, side, 3, c);
    if (status != BATTEN_OK)
        return status;
    *out = (run_place){.u = u};
    memcpy(out->p, c, (size_t)d * sizeof *c);
    for (int m = 0; m < 3; m++)
        memcpy(out->q[m], c + m * d, (size_t)d * sizeof *c);
    const double *c1 = c + d, *c2 = c + 2 * d, *c3 = c + 3 * d;
    const double v = bat_norm(2, c1), offset = o->distance;
    if (v <= bat_derivative_roundoff(o->plan, 1, o->size, bat_span_width(o->plan, u, side)))
        return place_singular(o, u, side, out);
    out->t[0] = c1[0] / v;
    out->t[1] = c1[1] / v;
    const double b = c1[0] * c2[1] - c1[1] * c2[0], rate = c1[0] * c3[1] - c1[1] * c3[0];
    out->k = b / (v * v * v);
    out->factor = 1 - out->k * offset;
    const double dk = rate / (v * v * v) - 3 * out->k * bat_dot(2, c1, c2) / (v * v);
    out->q[0][0] -= offset * out->t[1];
    out->q[0][1] += offset * out->t[0];
    for (int k = 0; k < 2; k++) {
        out->q[1][k] = out->factor * c1[k];
        out->q[2][k] = out->factor * c2[k] - offset * dk * c1[k];
    }
    return BATTEN_OK;
}

/* Where the curve stands still Q' is taken from the offset itself, a little inside. */
static batten_status settle_place(const bat_offset *o, run_place *at, double towards)
{
    run_place near;
    const double h = 1e-4 * (towards - at->u);
    if (!at->singular)
        return BATTEN_OK;
    const batten_status status = place_at(o, at->u + h, BATTEN_FROM_RIGHT, &near);
    for (int k = 0; status == BATTEN_OK && k < o->full->dimension; k++) {
        at->q[1][k] = (near.q[0][k] - at->q[0][k]) / h;
        at->q[2][k] = 0;
    }
    return status;
}

/* ---- where runs may begin ---- */

/* Between a and b curvature runs one way: the place at which it passes 1 / distance, by
 * halving. */
static batten_status find_cusp(const bat_offset *o, double a, double b, bool *found, double *at)
{
    run_place left, right, middle;
    batten_status status = place_at(o, a, BATTEN_FROM_RIGHT, &left);
    if (status == BATTEN_OK)
        status = place_at(o, b, BATTEN_FROM_LEFT, &right);
    /* Where the offset stands still to rounding at an end, or all along, it does not turn. */
    const double still = 64 * DBL_EPSILON;
    *found = status == BATTEN_OK && left.factor * right.factor < 0 &&
             fabs(left.factor) > still && fabs(right.factor) > still;
    while (status == BATTEN_OK && *found) {
        const double m = a + (b - a) / 2;
        if (!(m > a && m < b))
            break;
        status = place_at(o, m, BATTEN_FROM_RIGHT, &middle);
        if (middle.factor == 0 || (middle.factor > 0) != (left.factor > 0))
            b = m;
        else
            a = m;
    }
    *at = a;
    return status;
}

/* Knots, extrema of curvature, and between them cusps; rising, each once. */
static batten_status find_breaks(bat_offset *o, int *count, double **out)
{
    batten_parameters extrema = {0, NULL};
    const int knots = batten_curve_spans(o->plan, NULL);
    batten_status status = batten_curve_curvature_extrema(o->plan, &extrema);
    if (status != BATTEN_OK)
        return status;
    int n = knots, all = 0;
    double *at = bat_array(2 * ((size_t)knots + (size_t)extrema.count), sizeof *at);
    if (!at)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_curve_spans(o->plan, at);
        for (int i = 0; i < extrema.count; i++)
            at[n++] = extrema.at[i];
        bat_sort_doubles((size_t)n, at);
        for (int i = 0; i < n; i++)
            if (i == 0 || at[i] > at[all - 1])
                at[all++] = at[i];
    }
    n = all;
    for (int i = 0; status == BATTEN_OK && i + 1 < n; i++) {
        bool found;
        status = find_cusp(o, at[i], at[i + 1], &found, &at[all]);
        if (status == BATTEN_OK && found) {
            o->report.cusps++;
            all++;
        }
    }
    if (status == BATTEN_OK) {
        bat_sort_doubles((size_t)all, at);
        *count = all;
        *out = at;
    } else {
        bat_release(at);
    }
    bat_release(extrema.at);
    return status;
}

/* ---- lines and arcs ---- */

bool bat_plan_is_line(const batten_curve *part)
{
    const int n = part->count;
    const double *first = part->points, *last = part->points + 2 * (n - 1);
    const double chord[2] = {last[0] - first[0], last[1] - first[1]};
    const double length = bat_norm(2, chord);
    const double roundoff = 16 * DBL_EPSILON * bat_largest(2 * n, part->points);
    if (!(length > roundoff))
        return false;
    for (int i = 1; i < n; i++) {
        const double *a = part->points + 2 * (i - 1), *b = a + 2;
        const double leg[2] = {b[0] - a[0], b[1] - a[1]};
        if (fabs(leg[0] * chord[1] - leg[1] * chord[0]) > roundoff * length ||
            bat_dot(2, leg, chord) < -roundoff * length)
            return false;
    }
    return true;
}

/* Is the part of the plan an arc about `centre`? |P - centre|^2 - r^2, times the weights
 * squared, has degree 2 p: it vanishes with 2 p + 1 of its values. */
static batten_status is_arc(const bat_offset *o, const batten_curve *part,
                            const run_place *start, bool *arc, double *centre)
{
    const int samples = 2 * part->degree + 1;
    const batten_interval domain = batten_curve_domain(part);
    /* With a radius of a million times the size the centre has lost six digits: no arc then. */
    *arc = start->k != 0 && !start->singular && fabs(1 / start->k) < 1e6 * o->size;
    if (!*arc)
        return BATTEN_OK;
    const double radius = fabs(1 / start->k);
    const double roundoff = 256 * DBL_EPSILON * (o->size + radius);
    centre[0] = start->p[0] - start->t[1] / start->k;
    centre[1] = start->p[1] + start->t[0] / start->k;
    for (int i = 1; i <= samples && *arc; i++) {
        double point[2];
        const double u = domain.a + (domain.b - domain.a) * ((double)i / samples);
        const batten_status status = batten_curve_evaluate(part, u, 0, point);
        if (status != BATTEN_OK)
            return status;
        *arc = fabs(bat_distance(2, point, centre) - radius) <= roundoff;
    }
    return BATTEN_OK;
}

/* The map that takes a line or an arc to its offset; false when the part is neither. */
static batten_status exact_map(const bat_offset *o, double a, double b, const run_place *start,
                               bool *exact, batten_affine *map)
{
    batten_curve *part = NULL;
    double centre[2] = {0, 0};
    batten_status status = bat_bezier_part(o->plan, a, b, &part);
    if (status != BATTEN_OK)
        return status;
    *exact = bat_plan_is_line(part);
    if (*exact) {
        *map =
            batten_affine_translation(-o->distance * start->t[1], o->distance * start->t[0], 0);
    } else {
        status = is_arc(o, part, start, exact, centre);
        const double f = start->factor;
        *map = batten_affine_scaling(f, f, 1);
        map->t[0] = (1 - f) * centre[0];
        map->t[1] = (1 - f) * centre[1];
    }
    batten_curve_unref(part);
    return status;
}

/* An arc of the radius of the offset leaves nothing but its centre. */
static bool collapses(const bat_offset *o, const run_place *start)
{
    return fabs(start->factor) * fabs(1 / start->k) <= 1e-12 * (o->size + fabs(o->distance));
}

static batten_status add_exact(bat_offset *o, double a, double b, const batten_affine *map)
{
    batten_curve *part = NULL, *moved = NULL;
    batten_status status = bat_bezier_part(o->full, a, b, &part);
    if (status == BATTEN_OK)
        status = batten_curve_transform(part, map, &moved);
    batten_curve_unref(part);
    return bat_offset_add(o, status, moved);
}

/* ---- quintics ---- */

/* A run in the making: the ends of its quintics. */
typedef struct {
    int dimension, count, room;
    double *u, *values; /* [count], [count][3][dimension] */
} strand;

static batten_status strand_add(strand *s, const run_place *at)
{
    if (s->count == s->room) {
        const int room = bat_max_int(16, 2 * s->room);
        const size_t width = 3 * (size_t)s->dimension;
        double *u = bat_resize(s->u, (size_t)room, sizeof *u);
        if (!u)
            return BATTEN_OUT_OF_MEMORY;
        s->u = u;
        double *values = bat_resize(s->values, (size_t)room * width, sizeof *values);
        if (!values)
            return BATTEN_OUT_OF_MEMORY;
        s->values = values;
        s->room = room;
    }
    s->u[s->count] = at->u;
    for (int m = 0; m < 3; m++)
        memcpy(s->values + (size_t)(3 * s->count + m) * (size_t)s->dimension, at->q[m],
               (size_t)s->dimension * sizeof(double));
    s->count++;
    return BATTEN_OK;
}

/* The quintic between two places at the share t of the way. */
static void quintic(int d, const run_place *a, const run_place *b, double t, double *out)
{
    const double h = b->u - a->u, s = 1 - t, s3 = s * s * s, t3 = t * t * t;
    const double first[3] = {s3 * (1 + 3 * t + 6 * t * t), s3 * t * (1 + 3 * t) * h,
                             s3 * t * t / 2 * h * h};
    const double last[3] = {t3 * (1 + 3 * s + 6 * s * s), -t3 * s * (1 + 3 * s) * h,
                            t3 * s * s / 2 * h * h};
    for (int k = 0; k < d; k++) {
        out[k] = 0;
        for (int m = 0; m < 3; m++)
            out[k] += first[m] * a->q[m][k] + last[m] * b->q[m][k];
    }
}

static batten_status quintic_error(const bat_offset *o, const run_place *a, const run_place *b,
                                   double *error)
{
    const int d = o->full->dimension;
    *error = 0;
    for (int i = 1; i <= SAMPLES; i++) {
        run_place at;
        double q[3];
        const double t = i / (SAMPLES + 1.0);
        const batten_status status =
            place_at(o, a->u + (b->u - a->u) * t, BATTEN_FROM_RIGHT, &at);
        if (status != BATTEN_OK)
            return status;
        quintic(d, a, b, t, q);
        *error = bat_max(*error, BAT_QUINTIC_BETWEEN_7 * bat_distance(d, q, at.q[0]));
    }
    return BATTEN_OK;
}

/* From the last place of the strand, which is `a`, to b: halves until the error is met. */
static batten_status follow_part(bat_offset *o, strand *s, run_place a, const run_place *b)
{
    enum { DEPTH = 40 };
    bat_halving h = bat_halving_of(a.u, b->u, DEPTH);
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && h.waiting > 0) {
        run_place next = *b;
        double error = 0;
        if (h.waiting > 1)
            status = place_at(o, h.b, BATTEN_FROM_LEFT, &next);
        if (status == BATTEN_OK)
            status = settle_place(o, &next, a.u);
        if (status == BATTEN_OK)
            status = quintic_error(o, &a, &next, &error);
        if (status != BATTEN_OK)
            return status;
        if (error > o->options.tolerance) {
            if (s->count > o->options.most_pieces || !bat_halving_split(&h))
                return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                                "the offset is missed by %g near u = %.17g after %d piece%s",
                                error, a.u, s->count, bat_plural(s->count));
            continue;
        }
        o->report.error = bat_max(o->report.error, error);
        status = strand_add(s, &next);
        a = next;
        bat_halving_accept(&h);
    }
    return status;
}

static batten_status add_strand(bat_offset *o, strand *s)
{
    batten_curve *curve = NULL;
    if (s->count == 0)
        return BATTEN_OK;
    const batten_status status =
        batten_curve_from_hermite(s->dimension, s->count, 3, s->u, s->values, &curve);
    s->count = 0;
    return bat_offset_add(o, status, curve);
}

/* ---- all ---- */

/* Do two sides of one place go over into each other with equal first and second derivatives? */
static bool goes_on(const bat_offset *o, const run_place *left, const run_place *right)
{
    const int d = o->full->dimension;
    const bool cusp = fabs(left->factor) < 1e-9 || left->factor * right->factor <= 0;
    if (left->singular || right->singular || cusp)
        return false;
    for (int m = 0; m < 3; m++) {
        /* Ten digits of point, tangent and second derivative, which lose some in the divisions. */
        const double size = bat_max(bat_norm(d, left->q[m]), bat_norm(d, right->q[m]));
        if (bat_distance(d, left->q[m], right->q[m]) > 1e-10 * size)
            return false;
    }
    return true;
}

/* What stands between two runs at a corner: an arc outside; inside nothing, or, when all is
 * kept, a straight link. Turns that leave no visible gap are joined as they are. */
static batten_status add_corner(bat_offset *o, const run_place *left, const run_place *right)
{
    const double cross = left->t[0] * right->t[1] - left->t[1] * right->t[0];
    double turn = atan2(cross, bat_dot(2, left->t, right->t));
    /* As close as the cross product of unit tangents tells the sign of half a turn. */
    const double half = BAT_PI - 1e-9;
    if (fabs(turn) > half) /* back the same way: around the tip */
        turn = o->distance > 0 ? -fabs(turn) : fabs(turn);
    if (fabs(turn * o->distance) <= bat_min(o->options.tolerance / 4, 1e-6 * o->size))
        return BATTEN_OK;
    if (turn * o->distance < 0)
        return bat_offset_corner(o, left->p, left->t, turn, left->q[0], right->q[0]);
    if (o->options.loops == BATTEN_LOOPS_REMOVE)
        return BATTEN_OK;
    const int d = o->full->dimension;
    batten_curve *link = NULL;
    const batten_status status = batten_curve_line(d, left->q[0], right->q[0], &link);
    return bat_offset_add(o, status, link);
}

/* The part from `start` to `end`: exact, or more of the strand. */
static batten_status add_part(bat_offset *o, strand *s, run_place *start, const run_place *end)
{
    bool exact;
    batten_affine map;
    batten_status status = exact_map(o, start->u, end->u, start, &exact, &map);
    if (status == BATTEN_OK && exact) {
        status = add_strand(o, s);
        if (status == BATTEN_OK && !(start->k != 0 && collapses(o, start)))
            status = add_exact(o, start->u, end->u, &map);
        return status;
    }
    if (status == BATTEN_OK)
        status = settle_place(o, start, end->u);
    if (status == BATTEN_OK && s->count == 0)
        status = strand_add(s, start);
    return status == BATTEN_OK ? follow_part(o, s, *start, end) : status;
}

static batten_status walk_parts(bat_offset *o, int count, const double *at, strand *s)
{
    run_place start, end, first = {0};
    batten_status status = place_at(o, at[0], BATTEN_FROM_RIGHT, &start);
    first = start;
    for (int i = 0; status == BATTEN_OK && i + 1 < count; i++) {
        status = place_at(o, at[i + 1], BATTEN_FROM_LEFT, &end);
        if (status == BATTEN_OK)
            status = add_part(o, s, &start, &end);
        if (status == BATTEN_OK && i + 2 < count)
            status = place_at(o, at[i + 1], BATTEN_FROM_RIGHT, &start);
        if (status != BATTEN_OK || i + 2 == count || goes_on(o, &end, &start))
            continue;
        status = add_strand(o, s);
        if (status == BATTEN_OK)
            status = add_corner(o, &end, &start);
    }
    if (status == BATTEN_OK)
        status = add_strand(o, s);
    return status == BATTEN_OK && o->closed ? add_corner(o, &end, &first) : status;
}

batten_status bat_offset_runs(bat_offset *o)
{
    int count = 0;
    double *at = NULL;
    strand s = {.dimension = o->full->dimension};
    batten_status status = find_breaks(o, &count, &at);
    if (status == BATTEN_OK)
        status = walk_parts(o, count, at, &s);
    bat_release(s.values);
    bat_release(s.u);
    bat_release(at);
    return status;
}
