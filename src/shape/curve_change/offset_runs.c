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
#include "base/sort.h"
#include "numeric/vector.h"
#include "shape/curve_change/offset.h"
#include "shape/curve_change/offset_strand.h"
#include "spline/curve/curve.h"

#include <batten/standard.h>
#include <float.h>

enum { SAMPLES = 7 };

/* Without a first derivative the tangent is that of the first derivative there is. */

/* ---- where runs may begin ---- */

/* Between a and b curvature runs one way: the place at which it passes 1 / distance, by
 * halving. */
static batten_status find_cusp(const bat_offset *o, double a, double b, bool *found, double *at)
{
    bat_run_place left, right, middle;
    batten_status status = bat_run_place_at(o, a, BATTEN_FROM_RIGHT, &left);
    if (status == BATTEN_OK)
        status = bat_run_place_at(o, b, BATTEN_FROM_LEFT, &right);
    /* Where the offset stands still to rounding at an end, or all along, it does not turn. */
    const double still = 64 * DBL_EPSILON;
    *found = status == BATTEN_OK && left.factor * right.factor < 0 &&
             fabs(left.factor) > still && fabs(right.factor) > still;
    while (status == BATTEN_OK && *found) {
        const double m = a + (b - a) / 2;
        if (!(m > a && m < b))
            break;
        status = bat_run_place_at(o, m, BATTEN_FROM_RIGHT, &middle);
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
                            const bat_run_place *start, bool *arc, double *centre)
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
static batten_status exact_map(const bat_offset *o, const bat_run_place *start,
                               const bat_run_place *end, bool *exact, batten_affine *map)
{
    batten_curve *part = NULL;
    double centre[2] = {0, 0};
    batten_status status = bat_bezier_part(o->plan, start->u, end->u, &part);
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
static bool collapses(const bat_offset *o, const bat_run_place *start)
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

/* ---- all ---- */

/* Do two sides of one place go over into each other with equal first and second derivatives? */
static bool goes_on(const bat_offset *o, const bat_run_place *left, const bat_run_place *right)
{
    const bool cusp = fabs(left->factor) < 1e-9 || left->factor * right->factor <= 0;
    if (left->singular || right->singular || cusp)
        return false;
    /* Ten digits of point, tangent and second derivative, which lose some in the divisions. */
    return bat_hermite_agrees(o->full->dimension, 0, left->q[0], right->q[0], 1e-10);
}

/* What stands between two runs at a corner: an arc outside; inside nothing, or, when all is
 * kept, a straight link. Turns that leave no visible gap are joined as they are. */
static batten_status add_corner(bat_offset *o, const bat_run_place *left,
                                const bat_run_place *right)
{
    const double cross = left->t[0] * right->t[1] - left->t[1] * right->t[0];
    double turn = bat_atan2(cross, bat_dot(2, left->t, right->t));
    /* As close as the cross product of unit tangents tells the sign of half a turn. */
    const double half = BAT_PI - 1e-9;
    if (fabs(turn) > half) /* back the same way: around the tip */
        turn = o->distance > 0 ? -fabs(turn) : fabs(turn);
    if (fabs(turn * o->distance) <= bat_min(o->options.tolerance / 4, 1e-6 * o->size))
        return BATTEN_OK;
    if (turn * o->distance < 0)
        return bat_offset_corner(
            o, &(bat_offset_gap){left->p, left->t, turn, left->q[0], right->q[0]});
    if (o->options.loops == BATTEN_LOOPS_REMOVE)
        return BATTEN_OK;
    const int d = o->full->dimension;
    batten_curve *link = NULL;
    const batten_status status = batten_curve_line(d, left->q[0], right->q[0], &link);
    return bat_offset_add(o, status, link);
}

/* The part from `start` to `end`: exact, or more of the strand. */
static batten_status add_part(bat_offset *o, bat_hermite_run *s, bat_run_place *start,
                              const bat_run_place *end)
{
    bool exact;
    batten_affine map;
    batten_status status = exact_map(o, start, end, &exact, &map);
    if (status == BATTEN_OK && exact) {
        status = bat_strand_hand_over(o, s);
        if (status == BATTEN_OK && !(start->k != 0 && collapses(o, start)))
            status = add_exact(o, start->u, end->u, &map);
        return status;
    }
    if (status == BATTEN_OK)
        status = bat_run_settle(o, start, end->u);
    if (status == BATTEN_OK && s->count == 0)
        status = bat_hermite_run_add(s, start->u, start->q[0]);
    return status == BATTEN_OK ? bat_strand_follow(o, s, *start, end) : status;
}

static batten_status walk_parts(bat_offset *o, int count, const double *at, bat_hermite_run *s)
{
    bat_run_place start, end, first = {0};
    batten_status status = bat_run_place_at(o, at[0], BATTEN_FROM_RIGHT, &start);
    first = start;
    for (int i = 0; status == BATTEN_OK && i + 1 < count; i++) {
        status = bat_run_place_at(o, at[i + 1], BATTEN_FROM_LEFT, &end);
        if (status == BATTEN_OK)
            status = add_part(o, s, &start, &end);
        if (status == BATTEN_OK && i + 2 < count)
            status = bat_run_place_at(o, at[i + 1], BATTEN_FROM_RIGHT, &start);
        if (status != BATTEN_OK || i + 2 == count || goes_on(o, &end, &start))
            continue;
        status = bat_strand_hand_over(o, s);
        if (status == BATTEN_OK)
            status = add_corner(o, &end, &start);
    }
    if (status == BATTEN_OK)
        status = bat_strand_hand_over(o, s);
    return status == BATTEN_OK && o->closed ? add_corner(o, &end, &first) : status;
}

batten_status bat_offset_runs(bat_offset *o)
{
    int count = 0;
    double *at = NULL;
    bat_hermite_run s = {.dimension = o->full->dimension};
    batten_status status = find_breaks(o, &count, &at);
    if (status == BATTEN_OK)
        status = walk_parts(o, count, at, &s);
    bat_hermite_run_release(&s);
    bat_release(at);
    return status;
}
