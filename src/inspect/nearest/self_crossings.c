/* Where plane curves cross each other and themselves: pieces halved until chords decide. */
#include "inspect/nearest/self_crossings.h"
#include "base/list.h"
#include "base/plural.h"
#include "inspect/nearest/pair_crossings.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <batten/nearest.h>
#include <stdlib.h>

/* A pair is halved at most this often, and makes at most so many pairs: enough to come from a
 * whole piece to a cusp or a common point at rounding; what runs along itself ends here. */

/* ---- pieces that run one way ---- */

static batten_status add_piece(bat_crossing_search *s, const bat_crossing_piece *p)
{
    if (BAT_LIST_GROW(s->pieces, s->count, s->room, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    s->pieces[s->count++] = *p;
    return BATTEN_OK;
}

/* Halve until no leg turns more than 45 degrees from the chord; at a cusp that never comes to
 * be, and the parts become too short to matter. */
static batten_status add_one_way(bat_crossing_search *s, const bat_crossing_piece *whole)
{
    int waiting = 1, depth[BAT_CROSSING_DEPTH + 2] = {0};
    batten_status status = BATTEN_OK;
    s->stack[0] = *whole;
    while (status == BATTEN_OK && waiting > 0) {
        const int top = --waiting;
        if (s->stack[top].cosine >= 0.7 || depth[top] == BAT_CROSSING_DEPTH / 2) {
            status = add_piece(s, &s->stack[top]);
            continue;
        }
        bat_crossing_piece *const spare = &s->stack[top + 2];
        bat_crossing_piece_halve(&s->stack[top], spare, &s->stack[top + 1]);
        s->stack[top] = s->stack[top + 1];
        s->stack[top + 1] = *spare;
        depth[top + 1] = ++depth[top];
        waiting += 2;
    }
    return status;
}

static batten_status add_curve(bat_crossing_search *s, int index)
{
    batten_curve *bezier = NULL;
    batten_status status = batten_curve_to_bezier(s->curves[index], &bezier);
    if (status != BATTEN_OK)
        return status;
    const int p = bezier->degree;
    for (int k = p; status == BATTEN_OK && k < bezier->count; k += p) {
        bat_crossing_piece one = {
            .curve = index, .degree = p, .a = bezier->knots[k], .b = bezier->knots[k + 1]};
        for (int i = 0; i <= p; i++) {
            const int at = k - p + i;
            const double w = bezier->weights ? bezier->weights[at] * bezier->weight_scale : 1;
            one.rows[3 * i] = w * bezier->points[2 * at];
            one.rows[3 * i + 1] = w * bezier->points[2 * at + 1];
            one.rows[3 * i + 2] = w;
        }
        bat_crossing_piece_measure(&one);
        status = add_one_way(s, &one);
    }
    batten_curve_unref(bezier);
    return status;
}

static int by_left_end(const void *a, const void *b)
{
    const bat_crossing_piece *x = a, *y = b;
    if (x->low[0] != y->low[0])
        return x->low[0] < y->low[0] ? -1 : 1;
    if (x->curve != y->curve)
        return x->curve < y->curve ? -1 : 1;
    return x->a < y->a ? -1 : x->a > y->a;
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
static void merge(const bat_crossing_search *s, bat_crossings *out)
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
    bat_crossing_search s = {.curves = curves, .curve_count = count, .closed = closed};
    bat_crossings found = {0};
    s.stack = bat_array(2 * (2 * BAT_CROSSING_DEPTH + 4), sizeof *s.stack);
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
            if (bat_crossing_pieces_may_meet(&s.pieces[i], &s.pieces[j]))
                status = bat_crossing_pieces(&s, &s.pieces[i], &s.pieces[j], &found);
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
