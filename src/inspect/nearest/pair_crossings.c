/* Where two pieces of curves cross. */
#include "inspect/nearest/pair_crossings.h"
#include "base/list.h"
#include "inspect/nearest/self_crossings.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <string.h>

enum { BUDGET = 4000 };

static void point_of(const bat_crossing_piece *p, int i, double *out)
{
    const double *row = p->rows + 3 * (size_t)i;
    out[0] = row[0] / row[2];
    out[1] = row[1] / row[2];
}

/* Of the angle between two vectors with these lengths; their products may be too small for
 * numbers. */
static double cosine_of(const double *a, double a_length, const double *b, double b_length)
{
    return a[0] / a_length * (b[0] / b_length) + a[1] / a_length * (b[1] / b_length);
}

void bat_crossing_piece_measure(bat_crossing_piece *p)
{
    double first[2], last[2], before[2], here[2];
    point_of(p, 0, first);
    point_of(p, p->degree, last);
    const double chord[2] = {last[0] - first[0], last[1] - first[1]};
    const double length = bat_norm(2, chord);
    memcpy(before, first, sizeof before);
    memcpy(p->low, first, sizeof first);
    memcpy(p->high, first, sizeof first);
    p->cosine = 1;
    for (int i = 1; i <= p->degree; i++, memcpy(before, here, sizeof before)) {
        point_of(p, i, here);
        const double leg[2] = {here[0] - before[0], here[1] - before[1]};
        const double size = bat_norm(2, leg);
        if (size > 0)
            p->cosine =
                bat_min(p->cosine, length > 0 ? cosine_of(leg, size, chord, length) : -1);
        for (int k = 0; k < 2; k++) {
            p->low[k] = bat_min(p->low[k], here[k]);
            p->high[k] = bat_max(p->high[k], here[k]);
        }
    }
}

void bat_crossing_piece_halve(const bat_crossing_piece *p, bat_crossing_piece *left,
                              bat_crossing_piece *right)
{
    const int n = p->degree;
    const double middle = p->a + (p->b - p->a) / 2;
    *right = *p;
    *left = *p;
    double *b = right->rows;
    for (int r = 1; r <= n; r++) {
        for (int i = 0; i <= n - r; i++)
            for (int k = 0; k < 3; k++)
                b[3 * i + k] = (b[3 * i + k] + b[3 * (i + 1) + k]) / 2;
        memcpy(left->rows + 3 * (size_t)r, b, 3 * sizeof *b);
    }
    left->b = right->a = middle;
    bat_crossing_piece_measure(left);
    bat_crossing_piece_measure(right);
}

/* ---- one pair ---- */

bool bat_crossing_pieces_may_meet(const bat_crossing_piece *p, const bat_crossing_piece *q)
{
    return p->low[0] <= q->high[0] && q->low[0] <= p->high[0] && p->low[1] <= q->high[1] &&
           q->low[1] <= p->high[1];
}

static bool is_end(const bat_crossing_search *s, int curve, double u)
{
    return u == batten_curve_domain(s->curves[curve]).b;
}

static bool is_start(const bat_crossing_search *s, int curve, double u)
{
    return u == batten_curve_domain(s->curves[curve]).a;
}

/* Does q begin where p ends, by the order of the chain? */
static bool follows(const bat_crossing_search *s, const bat_crossing_piece *p,
                    const bat_crossing_piece *q)
{
    if (p->curve == q->curve && p->b == q->a)
        return true;
    double end[2], start[2];
    const bool next = q->curve == p->curve + 1 ||
                      (s->closed && p->curve == s->curve_count - 1 && q->curve == 0);
    point_of(p, p->degree, end);
    point_of(q, 0, start);
    return next && bat_distance(2, end, start) <= s->tiny && is_end(s, p->curve, p->b) &&
           is_start(s, q->curve, q->a);
}

/* Do all legs of both run along the way from the start of p to the end of q? Then they cannot
 * meet but at the point they share. */
static bool runs_on(const bat_crossing_piece *p, const bat_crossing_piece *q)
{
    double first[2], last[2], before[2], here[2];
    point_of(p, 0, first);
    point_of(q, q->degree, last);
    const double way[2] = {last[0] - first[0], last[1] - first[1]};
    const bat_crossing_piece *const both[2] = {p, q};
    for (int k = 0; k < 2; k++)
        for (int i = 1; i <= both[k]->degree; i++) {
            point_of(both[k], i - 1, before);
            point_of(both[k], i, here);
            const double leg[2] = {here[0] - before[0], here[1] - before[1]};
            if (bat_dot(2, leg, leg) > 0 && !(bat_dot(2, leg, way) > 0))
                return false;
        }
    return true;
}

static void chord_of(const bat_crossing_piece *p, double *first, double *chord)
{
    double last[2];
    point_of(p, 0, first);
    point_of(p, p->degree, last);
    chord[0] = last[0] - first[0];
    chord[1] = last[1] - first[1];
}

/* Is the angle between the chords wider than all legs may turn from them? Then the pieces cross
 * once at most; s, t: where the chords cross, in parts of them. */
static bool crosses_once(const bat_crossing_piece *p, const bat_crossing_piece *q, double *s,
                         double *t)
{
    double a[2], b[2], x[2], y[2];
    chord_of(p, a, x);
    chord_of(q, b, y);
    const double cross = x[0] * y[1] - x[1] * y[0];
    const double scale = bat_norm(2, x) * bat_norm(2, y);
    if (!(p->cosine > 0.9 && q->cosine > 0.9) || !(scale > 0))
        return false;
    const double sine = sqrt(bat_max(0, 1 - p->cosine * p->cosine)) +
                        sqrt(bat_max(0, 1 - q->cosine * q->cosine));
    /* Chords turn within the cones of both pieces; five hundredths and some thousand roundings
     * are the margin. */
    if (!(fabs(cross) > 1.05 * sine * scale + 1e-12 * scale))
        return false;
    const double d[2] = {b[0] - a[0], b[1] - a[1]};
    *s = (d[0] * y[1] - d[1] * y[0]) / cross;
    *t = (d[0] * x[1] - d[1] * x[0]) / cross;
    return true;
}

/* Newton for C(u) = D(v), kept inside the pieces. True when it settled inside. */
static batten_status refine(const bat_crossing_search *s, const bat_crossing_piece *p,
                            const bat_crossing_piece *q, double *u, double *v, bool *found)
{
    const batten_curve *c = s->curves[p->curve], *d = s->curves[q->curve];
    double most = bat_max(bat_largest(2, p->low), bat_largest(2, p->high));
    *found = false;
    for (int step = 0; step < 30; step++) {
        double x[4], y[4];
        batten_status status = batten_curve_evaluate_side(
            c, *u, *u >= p->b ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 1, x);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate_side(
                d, *v, *v >= q->b ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 1, y);
        if (status != BATTEN_OK)
            return status;
        const double gap[2] = {y[0] - x[0], y[1] - x[1]};
        const double cross = x[2] * y[3] - x[3] * y[2];
        most = bat_max(most, bat_largest(2, x));
        *found = bat_norm(2, gap) <= 32 * DBL_EPSILON * most;
        if (*found || !(fabs(cross) > 0))
            break;
        const double du = (gap[0] * y[3] - gap[1] * y[2]) / cross;
        const double dv = (gap[0] * x[3] - gap[1] * x[2]) / cross;
        const double next_u = bat_min(p->b, bat_max(p->a, *u + du));
        const double next_v = bat_min(q->b, bat_max(q->a, *v + dv));
        if (next_u == *u && next_v == *v)
            break;
        *u = next_u;
        *v = next_v;
    }
    return BATTEN_OK;
}

static batten_status note_crossing(bat_crossings *out, const bat_crossing_piece *p,
                                   const bat_crossing_piece *q, double u, double v)
{
    if (BAT_LIST_GROW(out->at, out->count, out->room, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    const bool in_order = p->curve < q->curve || (p->curve == q->curve && u < v);
    out->at[out->count++] = in_order ? (bat_crossing){{p->curve, q->curve}, {u, v}}
                                     : (bat_crossing){{q->curve, p->curve}, {v, u}};
    return BATTEN_OK;
}

/* The place where two pieces cross once, unless it is the point in which they follow each
 * other. */
static batten_status solve_crossing(const bat_crossing_search *s, const bat_crossing_piece *p,
                                    const bat_crossing_piece *q, double at_p, double at_q,
                                    bat_crossings *out)
{
    if (at_p < -1 || at_p > 2 || at_q < -1 || at_q > 2)
        return BATTEN_OK;
    double u = p->a + (p->b - p->a) * bat_min(1, bat_max(0, at_p));
    double v = q->a + (q->b - q->a) * bat_min(1, bat_max(0, at_q));
    bool found;
    const batten_status status = refine(s, p, q, &u, &v, &found);
    if (status != BATTEN_OK || !found)
        return status;
    /* Neighbours meet in the parameter they share, which Newton finds to nine digits at least.
     */
    const double near_u = 1e-9 * (p->b - p->a), near_v = 1e-9 * (q->b - q->a);
    const bool shared = (follows(s, p, q) && p->b - u <= near_u && v - q->a <= near_v) ||
                        (follows(s, q, p) && q->b - v <= near_v && u - p->a <= near_u);
    return shared ? BATTEN_OK : note_crossing(out, p, q, u, v);
}

static double extent(const bat_crossing_piece *p)
{
    return bat_max(p->high[0] - p->low[0], p->high[1] - p->low[1]);
}

batten_status bat_crossing_pieces(bat_crossing_search *s, const bat_crossing_piece *first,
                                  const bat_crossing_piece *second, bat_crossings *out)
{
    int waiting = 1, depth[2 * BAT_CROSSING_DEPTH + 2] = {0};
    batten_status status = BATTEN_OK;
    bat_crossing_piece *const stack = s->stack;
    stack[0] = *first;
    stack[1] = *second;
    for (int budget = BUDGET; status == BATTEN_OK && waiting > 0 && budget > 0; budget--) {
        const int top = --waiting;
        bat_crossing_piece *p = &stack[2 * top], *q = p + 1;
        double at_p, at_q;
        const bool lost = extent(p) < s->tiny && extent(q) < s->tiny;
        if (lost || !bat_crossing_pieces_may_meet(p, q) ||
            (follows(s, p, q) && runs_on(p, q)) || (follows(s, q, p) && runs_on(q, p)))
            continue;
        if (crosses_once(p, q, &at_p, &at_q)) {
            status = solve_crossing(s, p, q, at_p, at_q, out);
            continue;
        }
        if (depth[top] == 2 * BAT_CROSSING_DEPTH)
            continue;
        /* The larger one in halves, each with a copy of the other. */
        const bool cut_p = extent(p) >= extent(q);
        const bat_crossing_piece cut = cut_p ? *p : *q, other = cut_p ? *q : *p;
        bat_crossing_piece_halve(&cut, cut_p ? p : q, cut_p ? p + 2 : q + 2);
        *(cut_p ? q + 2 : p + 2) = other;
        depth[top + 1] = ++depth[top];
        waiting += 2;
    }
    return status;
}
