/*
 * What stays of an offset.
 *
 * The distance of the offset from the curve is at most |d|, and falls below it only where the
 * offset crosses itself, the offset on the other side, or the round cap of an end. So runs are
 * cut at all these crossings, parts are judged at points inside them, and where the judgement
 * changes within a part the place is found by halving.
 */
#include "base/list.h"
#include "inspect/nearest/self_crossings.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/curve_change/offset.h"
#include "spline/curve/curve.h"

#include <batten/nearest.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 5, HALVINGS = 50 };

/* A part of a run; where it begins and ends; and who follows. */
typedef struct {
    int run;
    double a, b;
    double start[2], end[2];
    int next;      /* -1: none */
    bool followed; /* some part has it as the next */
} offset_part;

typedef struct {
    const bat_offset *o;
    double least; /* distance that is far enough */
    double near;  /* ends of parts that meet */
    int removed;
    int count, room;
    offset_part *parts;
} trim;

/* ---- cutting ---- */

static batten_status add_part(trim *t, int run, double a, double b)
{
    const batten_curve *plan = t->o->runs[run].plan;
    offset_part made = {.run = run, .a = a, .b = b, .next = -1};
    batten_status status = batten_curve_evaluate(plan, a, 0, made.start);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(plan, b, 0, made.end);
    if (status != BATTEN_OK)
        return status;
    return BAT_LIST_ADD(t->parts, t->count, t->room, made);
}

/* ---- judging ---- */

/* How far points of the plane lie from the curve. */
static batten_status distances(const trim *t, int count, const double *points, double *out)
{
    batten_deviation all;
    return batten_curve_deviation(
        t->o->plan, (batten_points){batten_curve_dimension(t->o->plan), count, points}, NULL,
        NULL, out, &all);
}

/* Between a, judged `good`, and b, judged otherwise: the last good place. */
static batten_status find_change(const trim *t, int run, double a, double b, bool good,
                                 double *at)
{
    for (int i = 0; i < HALVINGS; i++) {
        double point[2], distance;
        const double middle = a + (b - a) / 2;
        batten_status status = batten_curve_evaluate(t->o->runs[run].plan, middle, 0, point);
        if (status == BATTEN_OK)
            status = distances(t, 1, point, &distance);
        if (status != BATTEN_OK)
            return status;
        if ((distance >= t->least) == good)
            a = middle;
        else
            b = middle;
    }
    *at = good ? a : b;
    return BATTEN_OK;
}

/* Between the cuts a and b of a run at u. */
typedef struct {
    int run;
    double a, b, u;
} sample;

/* All of them, along the way, and how far they lie from the curve. */
typedef struct {
    int count, room;
    sample *at;
    double *far;
} samples;

static batten_status add_sample(samples *s, int run, double a, double b, double u)
{
    return BAT_LIST_ADD(s->at, s->count, s->room, (sample){run, a, b, u});
}

/* Between two cuts of a run, POINTS on each of its pieces, and the cuts themselves. */
static batten_status add_samples(samples *s, int run, double a, double b, int break_count,
                                 const double *breaks)
{
    batten_status status = add_sample(s, run, a, b, a);
    double from = a;
    for (int i = 0; i < break_count && status == BATTEN_OK && from < b; i++) {
        if (breaks[i] <= from)
            continue;
        const double to = bat_min(b, breaks[i]);
        for (int k = 0; k < POINTS && status == BATTEN_OK; k++)
            status = add_sample(s, run, a, b, from + (to - from) * ((k + 0.5) / POINTS));
        from = to;
    }
    return status == BATTEN_OK ? add_sample(s, run, a, b, b) : status;
}

/* A cut, or the break that it means: subranges have no knots that rounding alone parts. */
static double snapped(double cut, int count, const double *breaks)
{
    const double near = BAT_ROUNDING * (breaks[count - 1] - breaks[0]);
    for (int i = 0; i < count; i++)
        if (fabs(cut - breaks[i]) <= near)
            return breaks[i];
    return cut;
}

/* Cuts of a run, its ends included, rise. */
static batten_status sample_run(const trim *t, int run, int count, const double *cuts,
                                samples *s)
{
    const batten_curve *plan = t->o->runs[run].plan;
    const int breaks = batten_curve_spans(plan, NULL);
    double *at = bat_array((size_t)breaks, sizeof *at);
    batten_status status = at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(plan, at);
    for (int i = 0; status == BATTEN_OK && i + 1 < count; i++) {
        const double a = snapped(cuts[i], breaks, at), b = snapped(cuts[i + 1], breaks, at);
        /* What rounding leaves between two cuts at one place is no part. */
        if (b - a > BAT_ROUNDING * (at[breaks - 1] - at[0]))
            status = add_samples(s, run, a, b, breaks, at);
    }
    bat_release(at);
    return status;
}

/* A passage of a run through a crossing. */
typedef struct {
    int run;
    double u;
} passage;

static int by_run(const void *a, const void *b)
{
    const passage *x = a, *y = b;
    return x->run != y->run ? (x->run > y->run) - (x->run < y->run)
                            : (x->u > y->u) - (x->u < y->u);
}

/* Passages in order of runs, the ends of the runs among them: the cuts of all. */
static batten_status sample_all(const trim *t, const bat_crossings *crossings, samples *s)
{
    const int runs = t->o->count, n = 2 * crossings->count + 2 * runs;
    passage *passages = bat_array((size_t)n, sizeof *passages);
    double *cuts = bat_array((size_t)n, sizeof *cuts);
    batten_status status = passages && cuts ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n; i++) {
        const int end = i - 2 * crossings->count;
        const bat_crossing *c = &crossings->at[i / 2];
        if (end < 0) {
            passages[i] = (passage){c->curve[i % 2], c->u[i % 2]};
            continue;
        }
        const batten_interval domain = batten_curve_domain(t->o->runs[end / 2].plan);
        passages[i] = (passage){end / 2, end % 2 ? domain.b : domain.a};
    }
    if (status == BATTEN_OK && n)
        qsort(passages, (size_t)n, sizeof *passages, by_run);
    for (int i = 0, from = 0; status == BATTEN_OK && i < n; i++) {
        cuts[i] = passages[i].u;
        if (i + 1 < n && passages[i + 1].run == passages[i].run)
            continue;
        status = sample_run(t, passages[i].run, i + 1 - from, cuts + from, s);
        from = i + 1;
    }
    bat_release(cuts);
    bat_release(passages);
    return status;
}

/* A cut is judged as the sample beside it, but for two cases: clearly too near beside something
 * good, or good at the end of a run that something good continues. Elsewhere two pieces cross,
 * and there both are only as far from the curve as their errors allow. */
static void judge_cuts(const trim *t, samples *s)
{
    const double clear = t->least - 2 * t->o->options.tolerance;
    const int n = s->count;
    for (int i = 0; i < n; i++) {
        const sample *at = &s->at[i];
        if (at->u != at->a && at->u != at->b)
            continue;
        const int step = at->u == at->a ? 1 : -1;
        const int across = t->o->closed ? (i - 2 * step + n) % n : i - 2 * step;
        const double beside = s->far[i + step], own = s->far[i];
        const bool goes_on = across >= 0 && across < n && s->at[across].run != at->run &&
                             s->far[across] >= t->least;
        if (beside >= t->least ? own >= clear : own < t->least || !goes_on)
            s->far[i] = beside;
    }
}

static batten_status measure_samples(const trim *t, samples *s)
{
    const size_t n = (size_t)s->count;
    double *points = bat_array(n, 2 * sizeof *points);
    s->far = bat_array(n, sizeof *s->far);
    batten_status status = points && s->far ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < n; i++)
        status =
            batten_curve_evaluate(t->o->runs[s->at[i].run].plan, s->at[i].u, 0, points + 2 * i);
    if (status == BATTEN_OK && n)
        status = distances(t, s->count, points, s->far);
    if (status == BATTEN_OK)
        judge_cuts(t, s);
    bat_release(points);
    return status;
}

/* The least distance that is let pass. */
static double excused(const trim *t)
{
    return t->least - 10 * t->o->options.tolerance;
}

/* Stretches that are too near by ten tolerances at most stay: the pieces, which are right to
 * one, need not show where the loop that they belong to crosses itself. A closed way begins
 * behind something good. */
static void forgive(const trim *t, samples *s)
{
    const int n = s->count;
    const double least = t->least, excuse = excused(t);
    int begin = 0;
    while (t->o->closed && begin < n && s->far[begin] < least)
        begin++;
    for (int i = 0, from = 0; i < n; i++) {
        if (s->far[(begin + i) % n] >= least) {
            from = i + 1;
            continue;
        }
        if (i + 1 < n && s->far[(begin + i + 1) % n] < least)
            continue;
        double nearest = least;
        for (int k = from; k <= i; k++)
            nearest = bat_min(nearest, s->far[(begin + k) % n]);
        for (int k = from; nearest >= excuse && k <= i; k++)
            s->far[(begin + k) % n] = least;
    }
}

/* The good parts. */
static batten_status keep_good(trim *t, const samples *s)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < s->count;) {
        const sample *first = &s->at[i];
        double from = first->a;
        bool same = true;
        for (; status == BATTEN_OK && same; i++) {
            const bool good = s->far[i] >= t->least;
            double to = first->b;
            same = i + 1 < s->count && s->at[i + 1].run == first->run &&
                   s->at[i + 1].a == first->a;
            if (same && (s->far[i + 1] >= t->least) == good)
                continue;
            if (same)
                status = find_change(t, first->run, s->at[i].u, s->at[i + 1].u, good, &to);
            if (status == BATTEN_OK && good)
                status = add_part(t, first->run, from, to);
            t->removed += !good;
            from = to;
        }
    }
    return status;
}

static batten_status judge_all(trim *t, const bat_crossings *crossings)
{
    samples s = {0};
    batten_status status = sample_all(t, crossings, &s);
    if (status == BATTEN_OK)
        status = measure_samples(t, &s);
    if (status == BATTEN_OK) {
        forgive(t, &s);
        status = keep_good(t, &s);
    }
    bat_release(s.far);
    bat_release(s.at);
    return status;
}

/* ---- chaining ---- */

static void link_to(trim *t, int i, int j)
{
    t->parts[i].next = j;
    t->parts[j].followed = true;
}

/* Parts without a next one are followed by one that begins there and follows no other. */
static void meet_ends(trim *t)
{
    for (int i = 0; i < t->count; i++)
        for (int j = 0; t->parts[i].next < 0 && j < t->count; j++)
            if (!t->parts[j].followed &&
                bat_distance(2, t->parts[i].end, t->parts[j].start) <= t->near)
                link_to(t, i, j);
}

/* Does the end of part i, or the start, come to `target` when it is moved along its run? Then
 * it is, as long as the run is far enough there. */
static batten_status slide_end(trim *t, int i, bool end, const double *target, bool *met)
{
    offset_part *p = &t->parts[i];
    const batten_curve *plan = t->o->runs[p->run].plan;
    batten_deviation near;
    double point[2], far = 0;
    batten_status status =
        batten_curve_deviation(plan, (batten_points){batten_curve_dimension(plan), 1, target},
                               NULL, NULL, NULL, &near);
    const double u = near.at[0];
    *met = status == BATTEN_OK && near.max <= t->near && (end ? u > p->a : u < p->b);
    if (status == BATTEN_OK && *met)
        status = batten_curve_evaluate(plan, u, 0, point);
    if (status == BATTEN_OK && *met)
        status = distances(t, 1, point, &far);
    *met = *met && far >= excused(t);
    if (status == BATTEN_OK && *met) {
        *(end ? &p->b : &p->a) = u;
        memcpy(end ? p->end : p->start, point, sizeof point);
    }
    return status;
}

/* Two sides of a loop narrower than the error of the pieces need not cross: where they run
 * beside each other one of the ends is moved to the other. */
static batten_status close_loops(trim *t)
{
    const int n = t->count;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i + !t->o->closed < n; i++) {
        const int j = (i + 1) % n;
        bool met;
        if (t->parts[i].next >= 0 || t->parts[j].followed)
            continue;
        status = slide_end(t, i, true, t->parts[j].start, &met);
        if (status == BATTEN_OK && !met)
            status = slide_end(t, j, false, t->parts[i].end, &met);
        if (status == BATTEN_OK && met)
            link_to(t, i, j);
    }
    return status;
}

/* First along the way they came, then to whatever begins where a part ends. */
static batten_status link_parts(trim *t)
{
    const int n = t->count;
    for (int i = 0; i < n; i++) {
        const int j = (i + 1) % n;
        const bool wraps = j == 0;
        const offset_part *p = &t->parts[i], *q = &t->parts[j];
        const bool adjacent = (p->run == q->run && p->b == q->a) || q->run == p->run + 1 ||
                              (wraps && t->o->closed);
        if ((!wraps || t->o->closed) && adjacent &&
            bat_distance(2, p->end, q->start) <= t->near)
            link_to(t, i, j);
    }
    meet_ends(t);
    return close_loops(t);
}

/* A chain that comes back within the tolerance ends in the point in which it begins. */
static batten_status close_chain(const trim *t, batten_curve **chain)
{
    const batten_curve *open = *chain;
    const int d = open->dimension, last = open->count - 1;
    batten_curve *closed = NULL;
    if (bat_distance(d, open->points, open->points + (size_t)last * (size_t)d) > 2 * t->near)
        return BATTEN_OK;
    const batten_status status = batten_curve_with_point(open, last, open->points, &closed);
    if (status == BATTEN_OK) {
        batten_curve_unref(*chain);
        *chain = closed;
    }
    return status;
}

/* The chain from part `first` on as one curve; its parts are no longer there. */
static batten_status make_chain(trim *t, int first, batten_curve **out)
{
    batten_curve **pieces = bat_array((size_t)t->count, sizeof *pieces);
    if (!pieces)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    bool around = false;
    int count = 0;
    for (int i = first; status == BATTEN_OK && i >= 0;) {
        offset_part *p = &t->parts[i];
        around = p->run < 0;
        if (around)
            break;
        status = batten_curve_subrange(t->o->runs[p->run].curve, p->a, p->b, &pieces[count]);
        count += status == BATTEN_OK;
        p->run = -1;
        i = p->next;
    }
    batten_curve *made = NULL;
    if (status == BATTEN_OK)
        status = bat_curves_chain(count, pieces, 2 * t->near, &made);
    if (status == BATTEN_OK && around)
        status = close_chain(t, &made);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_curve_unref(made);
    for (int i = 0; i < count; i++)
        batten_curve_unref(pieces[i]);
    bat_release(pieces);
    return status;
}

/* Chains that begin somewhere, then those that close. */
static batten_status make_chains(trim *t, batten_curves *out)
{
    batten_curves made = {0, bat_array((size_t)t->count, sizeof *made.at)};
    batten_status status = made.at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; status == BATTEN_OK && i < t->count; i++)
            if (t->parts[i].run >= 0 && (pass || !t->parts[i].followed)) {
                status = make_chain(t, i, &made.at[made.count]);
                made.count += status == BATTEN_OK;
            }
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_curves_release(&made);
    return status;
}

batten_status bat_offset_trim(bat_offset *o, batten_curves *out)
{
    const batten_curve **plans = bat_array((size_t)o->count, sizeof *plans);
    bat_crossings crossings = {0};
    /* Distances are found to ten digits of the size, places to rounding. */
    const double tolerance = 4 * o->options.tolerance;
    trim t = {.o = o,
              .least = fabs(o->distance) - o->report.error - 1e-10 * o->size,
              .near = tolerance + BAT_ROUNDING * o->size};
    batten_status status = plans ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < o->count; i++)
        plans[i] = o->runs[i].plan;
    if (status == BATTEN_OK)
        status = bat_crossings_find(o->count, plans, o->closed, &crossings);
    o->report.crossings = crossings.count;
    if (status == BATTEN_OK)
        status = bat_offset_entries(o, &crossings);
    if (status == BATTEN_OK)
        status = judge_all(&t, &crossings);
    if (status == BATTEN_OK) {
        o->report.removed = t.removed;
        status = link_parts(&t);
    }
    if (status == BATTEN_OK)
        status = make_chains(&t, out);
    bat_release(crossings.at);
    bat_release(plans);
    bat_release(t.parts);
    return status;
}
