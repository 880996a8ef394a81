/* Where plane curves cross each other and themselves: pieces halved until chords decide. */
#include "inspect/nearest/self_crossings.h"
#include "base/list.h"
#include "base/plural.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <batten/nearest.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

/* A pair is halved at most this often, and makes at most so many pairs: enough to come from a
 * whole piece to a cusp or a common point at rounding; what runs along itself ends here. */
enum { DEPTH = 40, BUDGET = 4000, ROWS = (BATTEN_MAX_DEGREE + 1) * 3 };

/* A part of a curve in homogeneous Bezier rows (w x, w y, w), its box, and the cosine of the
 * widest angle between a leg of its polygon and its chord. */
typedef struct {
    int curve, degree;
    double a, b; /* parameters of its ends */
    double low[2], high[2];
    double cosine;
    double rows[ROWS];
} piece;

/* What the search works on: pieces in the order of their left ends. */
typedef struct {
    int count, room;
    piece *pieces;
    const batten_curve *const *curves;
    int curve_count;
    bool closed;
    double tiny;  /* of parts shorter than this the direction is lost in rounding; ends nearer
                     than this are one point */
    piece *stack; /* [2 * (2 * DEPTH + 2)] pairs that wait */
} search;

static void point_of(const piece *p, int i, double *out)
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

static void measure_piece(piece *p)
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

/* Cut at the middle; `left` and `right` may not be `p`. */
static void halve(const piece *p, piece *left, piece *right)
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
    measure_piece(left);
    measure_piece(right);
}

/* ---- pieces that run one way ---- */

static batten_status add_piece(search *s, const piece *p)
{
    if (BAT_LIST_GROW(s->pieces, s->count, s->room, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    s->pieces[s->count++] = *p;
    return BATTEN_OK;
}

/* Halve until no leg turns more than 45 degrees from the chord; at a cusp that never comes to
 * be, and the parts become too short to matter. */
static batten_status add_one_way(search *s, const piece *whole)
{
    int waiting = 1, depth[DEPTH + 2] = {0};
    batten_status status = BATTEN_OK;
    s->stack[0] = *whole;
    while (status == BATTEN_OK && waiting > 0) {
        const int top = --waiting;
        if (s->stack[top].cosine >= 0.7 || depth[top] == DEPTH / 2) {
            status = add_piece(s, &s->stack[top]);
            continue;
        }
        piece *const spare = &s->stack[top + 2];
        halve(&s->stack[top], spare, &s->stack[top + 1]);
        s->stack[top] = s->stack[top + 1];
        s->stack[top + 1] = *spare;
        depth[top + 1] = ++depth[top];
        waiting += 2;
    }
    return status;
}

static batten_status add_curve(search *s, int index)
{
    batten_curve *bezier = NULL;
    batten_status status = batten_curve_to_bezier(s->curves[index], &bezier);
    if (status != BATTEN_OK)
        return status;
    const int p = bezier->degree;
    for (int k = p; status == BATTEN_OK && k < bezier->count; k += p) {
        piece one = {
            .curve = index, .degree = p, .a = bezier->knots[k], .b = bezier->knots[k + 1]};
        for (int i = 0; i <= p; i++) {
            const int at = k - p + i;
            const double w = bezier->weights ? bezier->weights[at] * bezier->weight_scale : 1;
            one.rows[3 * i] = w * bezier->points[2 * at];
            one.rows[3 * i + 1] = w * bezier->points[2 * at + 1];
            one.rows[3 * i + 2] = w;
        }
        measure_piece(&one);
        status = add_one_way(s, &one);
    }
    batten_curve_unref(bezier);
    return status;
}

static int by_left_end(const void *a, const void *b)
{
    const piece *x = a, *y = b;
    if (x->low[0] != y->low[0])
        return x->low[0] < y->low[0] ? -1 : 1;
    if (x->curve != y->curve)
        return x->curve < y->curve ? -1 : 1;
    return x->a < y->a ? -1 : x->a > y->a;
}

/* ---- one pair ---- */

static bool boxes_meet(const piece *p, const piece *q)
{
    return p->low[0] <= q->high[0] && q->low[0] <= p->high[0] && p->low[1] <= q->high[1] &&
           q->low[1] <= p->high[1];
}

static bool is_end(const search *s, int curve, double u)
{
    return u == batten_curve_domain(s->curves[curve]).b;
}

static bool is_start(const search *s, int curve, double u)
{
    return u == batten_curve_domain(s->curves[curve]).a;
}

/* Does q begin where p ends, by the order of the chain? */
static bool follows(const search *s, const piece *p, const piece *q)
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
static bool runs_on(const piece *p, const piece *q)
{
    double first[2], last[2], before[2], here[2];
    point_of(p, 0, first);
    point_of(q, q->degree, last);
    const double way[2] = {last[0] - first[0], last[1] - first[1]};
    const piece *const both[2] = {p, q};
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

static void chord_of(const piece *p, double *first, double *chord)
{
    double last[2];
    point_of(p, 0, first);
    point_of(p, p->degree, last);
    chord[0] = last[0] - first[0];
    chord[1] = last[1] - first[1];
}

/* Is the angle between the chords wider than all legs may turn from them? Then the pieces cross
 * once at most; s, t: where the chords cross, in parts of them. */
static bool crosses_once(const piece *p, const piece *q, double *s, double *t)
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
static batten_status refine(const search *s, const piece *p, const piece *q, double *u,
                            double *v, bool *found)
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

static batten_status note_crossing(bat_crossings *out, const piece *p, const piece *q, double u,
                                   double v)
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
static batten_status solve_crossing(const search *s, const piece *p, const piece *q,
                                    double at_p, double at_q, bat_crossings *out)
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

static double extent(const piece *p)
{
    return bat_max(p->high[0] - p->low[0], p->high[1] - p->low[1]);
}

static batten_status search_pair(search *s, const piece *first, const piece *second,
                                 bat_crossings *out)
{
    int waiting = 1, depth[2 * DEPTH + 2] = {0};
    batten_status status = BATTEN_OK;
    piece *const stack = s->stack;
    stack[0] = *first;
    stack[1] = *second;
    for (int budget = BUDGET; status == BATTEN_OK && waiting > 0 && budget > 0; budget--) {
        const int top = --waiting;
        piece *p = &stack[2 * top], *q = p + 1;
        double at_p, at_q;
        const bool lost = extent(p) < s->tiny && extent(q) < s->tiny;
        if (lost || !boxes_meet(p, q) || (follows(s, p, q) && runs_on(p, q)) ||
            (follows(s, q, p) && runs_on(q, p)))
            continue;
        if (crosses_once(p, q, &at_p, &at_q)) {
            status = solve_crossing(s, p, q, at_p, at_q, out);
            continue;
        }
        if (depth[top] == 2 * DEPTH)
            continue;
        /* The larger one in halves, each with a copy of the other. */
        const bool cut_p = extent(p) >= extent(q);
        const piece cut = cut_p ? *p : *q, other = cut_p ? *q : *p;
        halve(&cut, cut_p ? p : q, cut_p ? p + 2 : q + 2);
        *(cut_p ? q + 2 : p + 2) = other;
        depth[top + 1] = ++depth[top];
        waiting += 2;
    }
    return status;
}

/* ---- all pairs ---- */

static int by_place(const void *a, const void *b)
{
    const bat_crossing *x = a, *y = b;
    for (int k = 0; k < 2; k++) {
        if (x->curve[k] != y->curve[k])
            return x->curve[k] < y->curve[k] ? -1 : 1;
        if (x->u[k] != y->u[k])
            return x->u[k] < y->u[k] ? -1 : 1;
    }
    return 0;
}

/* A crossing at a point where pieces meet is found with each of them. */
static void merge(const search *s, bat_crossings *out)
{
    int kept = 0;
    if (out->count == 0)
        return;
    qsort(out->at, (size_t)out->count, sizeof *out->at, by_place);
    for (int i = 0; i < out->count; i++) {
        const bat_crossing *c = &out->at[i];
        bool twice = false;
        for (int j = kept; j-- > 0 && !twice && out->at[j].curve[0] == c->curve[0];) {
            const batten_interval a = batten_curve_domain(s->curves[c->curve[0]]);
            const batten_interval b = batten_curve_domain(s->curves[c->curve[1]]);
            /* Found from two pairs of pieces, a crossing differs by what Newton leaves. */
            if (c->u[0] - out->at[j].u[0] > 1e-9 * (a.b - a.a))
                break;
            twice = out->at[j].curve[1] == c->curve[1] &&
                    fabs(c->u[1] - out->at[j].u[1]) <= 1e-9 * (b.b - b.a);
        }
        if (!twice)
            out->at[kept++] = *c;
    }
    out->count = kept;
}

static batten_status find(int count, const batten_curve *const *curves, bool closed,
                          bat_crossings *out)
{
    search s = {.curves = curves, .curve_count = count, .closed = closed};
    bat_crossings found = {0};
    s.stack = bat_array(2 * (2 * DEPTH + 4), sizeof *s.stack);
    batten_status status = s.stack ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++) /* directions are known to 7 digits */
        s.tiny = bat_max(s.tiny, 1e-9 * bat_largest(2 * curves[i]->count, curves[i]->points));
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        status = add_curve(&s, i);
    if (status == BATTEN_OK && s.count)
        qsort(s.pieces, (size_t)s.count, sizeof *s.pieces, by_left_end);
    for (int i = 0; i < s.count && status == BATTEN_OK; i++)
        for (int j = i + 1;
             j < s.count && status == BATTEN_OK && s.pieces[j].low[0] <= s.pieces[i].high[0];
             j++)
            if (boxes_meet(&s.pieces[i], &s.pieces[j]))
                status = search_pair(&s, &s.pieces[i], &s.pieces[j], &found);
    if (status == BATTEN_OK) {
        merge(&s, &found);
        *out = found;
    } else {
        bat_release(found.at);
    }
    bat_release(s.pieces);
    bat_release(s.stack);
    return status;
}

/* The curves in a size that is a power of two away, exactly. */
static batten_status find_scaled(int count, const batten_curve *const *curves, double scale,
                                 bool closed, bat_crossings *out)
{
    const batten_affine map = {.m = {{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}}};
    batten_curve **scaled = bat_array((size_t)count, sizeof *scaled);
    batten_status status = scaled ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int made = 0;
    for (; status == BATTEN_OK && made < count; made += status == BATTEN_OK)
        status = batten_curve_transform(curves[made], &map, &scaled[made]);
    if (status == BATTEN_OK)
        status = find(count, (const batten_curve *const *)scaled, closed, out);
    while (made > 0)
        batten_curve_unref(scaled[--made]);
    bat_release(scaled);
    return status;
}

/* Far from 1 products of coordinates would leave the numbers. */
batten_status bat_crossings_find(int count, const batten_curve *const *curves, bool closed,
                                 bat_crossings *out)
{
    enum { FAR = 200 };
    double largest = 0;
    int exponent;
    for (int i = 0; i < count; i++)
        largest = bat_max(largest, bat_largest(2 * curves[i]->count, curves[i]->points));
    frexp(largest, &exponent);
    if (abs(exponent) <= FAR)
        return find(count, curves, closed, out);
    return find_scaled(count, curves, ldexp(1, bat_min_int(1000, -exponent)), closed, out);
}

batten_status batten_curve_self_crossings(const batten_curve *curve, batten_parameters *out)
{
    if (curve->dimension != 2)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "crossings are those of a plane curve; this one has %d dimension%s",
                        curve->dimension, bat_plural(curve->dimension));
    bat_crossings found = {0};
    batten_curve *clamped = NULL;
    batten_status status = batten_curve_clamp(curve, &clamped);
    double *at = NULL;
    if (status == BATTEN_OK)
        status = bat_crossings_find(1, (const batten_curve *const[]){clamped},
                                    batten_curve_is_closed(clamped, 0), &found);
    if (status == BATTEN_OK && !(at = bat_array(2 * (size_t)found.count, sizeof *at)))
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        for (int i = 0; i < 2 * found.count; i++)
            at[i] = found.at[i / 2].u[i % 2];
        *out = (batten_parameters){2 * found.count, at};
    }
    bat_release(found.at);
    batten_curve_unref(clamped);
    return status;
}
