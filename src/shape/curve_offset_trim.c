/*
 * What stays of an offset.
 *
 * The distance of the offset from the curve is at most |d|, and falls below it only where the
 * offset crosses itself, the offset on the other side, or the round cap of an end. So runs are
 * cut at their crossings, parts are judged at points inside them, and where the judgement
 * changes within a part the place is found by halving.
 */
#include "inspect/self_crossings.h"
#include "numeric/vector.h"
#include "shape/curve_offset.h"
#include "spline/curve.h"

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
} part;

typedef struct {
    const bat_offset *o;
    double least; /* distance that is far enough */
    double near;  /* ends of parts that meet */
    int removed;
    int count, room;
    part *parts;
} trim;

/* ---- cutting ---- */

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static batten_status add_part(trim *t, int run, double a, double b)
{
    const batten_curve *plan = t->o->runs[run].plan;
    part made = {.run = run, .a = a, .b = b, .next = -1};
    batten_status status = batten_curve_evaluate(plan, a, 0, made.start);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(plan, b, 0, made.end);
    if (status != BATTEN_OK)
        return status;
    if (t->count == t->room) {
        const int room = bat_max_int(16, 2 * t->room);
        part *grown = bat_resize(t->parts, (size_t)room, sizeof *grown);
        if (!grown)
            return BATTEN_OUT_OF_MEMORY;
        t->parts = grown;
        t->room = room;
    }
    t->parts[t->count++] = made;
    return BATTEN_OK;
}

/* ---- judging ---- */

/* How far points of the plane lie from the curve. */
static batten_status distances(const trim *t, int count, const double *points, double *out)
{
    batten_deviation all;
    return batten_curve_deviation(t->o->plan, count, points, NULL, NULL, out, &all);
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

/* Points inside a part at which it is judged: between the ends of the pieces of the run. */
static int points_inside(double a, double b, const double *breaks, int break_count, double *u)
{
    int count = 0;
    double from = a;
    for (int i = 0; i < break_count; i++) {
        if (breaks[i] <= a)
            continue;
        const double to = bat_min(b, breaks[i]);
        for (int k = 0; k < POINTS; k++)
            u[count++] = from + (to - from) * ((k + 0.5) / POINTS);
        from = to;
        if (to == b)
            break;
    }
    return count;
}

/* Stretches that are too near by a few tolerances only stay: what they belong to is a loop too
 * small to see, of which the ends of what is far enough need not meet. */
static void forgive(const trim *t, int count, double *far)
{
    for (int i = 0, from = 0; i < count; i++) {
        if (far[i] >= t->least) {
            from = i + 1;
            continue;
        }
        if (i + 1 < count && far[i + 1] < t->least)
            continue;
        double nearest = far[from];
        for (int k = from; k <= i; k++)
            nearest = bat_min(nearest, far[k]);
        for (int k = from; nearest >= t->least - 3 * t->o->options.tolerance && k <= i; k++)
            far[k] = t->least;
    }
}

/* The good parts of one run between two cuts. */
static batten_status judge(trim *t, int run, int count, const double *u, double *points,
                           double *far, double a, double b)
{
    const batten_curve *plan = t->o->runs[run].plan;
    batten_status status = batten_curve_evaluate_many(plan, (size_t)count, u, 0, NULL, points);
    if (status == BATTEN_OK)
        status = distances(t, count, points, far);
    if (status == BATTEN_OK)
        forgive(t, count, far);
    double from = a;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const bool good = far[i] >= t->least;
        const bool ends = i + 1 == count || (far[i + 1] >= t->least) != good;
        if (!ends)
            continue;
        double to = b;
        if (i + 1 < count)
            status = find_change(t, run, u[i], u[i + 1], good, &to);
        if (status == BATTEN_OK && good)
            status = add_part(t, run, from, to);
        t->removed += !good;
        from = to;
    }
    return status;
}

/* Where a run is cut, its ends included; rising. */
typedef struct {
    int count;
    double *at;
} cuts;

static batten_status judge_run(trim *t, int run, const cuts *c)
{
    const batten_curve *plan = t->o->runs[run].plan;
    const int breaks = batten_curve_spans(plan, NULL);
    const size_t room = (size_t)POINTS * ((size_t)breaks + 1);
    double *at = bat_array((size_t)breaks, sizeof *at);
    double *u = bat_array(room, sizeof *u), *points = bat_array(room, 2 * sizeof *points);
    double *far = bat_array(room, sizeof *far);
    batten_status status = at && u && points && far ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(plan, at);
    for (int i = 0; status == BATTEN_OK && i + 1 < c->count; i++) {
        const double a = c->at[i], b = c->at[i + 1];
        /* What rounding leaves between two cuts at one place is no part. */
        if (b - a <= 1e-12 * (at[breaks - 1] - at[0]))
            continue;
        const int count = points_inside(a, b, at, breaks, u);
        status = judge(t, run, count, u, points, far, a, b);
    }
    bat_release(far);
    bat_release(points);
    bat_release(u);
    bat_release(at);
    return status;
}

/* The ends of a run and its crossings, rising. */
static batten_status judge_all(trim *t, const bat_crossings *crossings)
{
    const bat_offset *o = t->o;
    cuts c = {0};
    double *all = bat_array(2 * (size_t)crossings->count + 2, sizeof *all);
    batten_status status = all ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    c.at = all;
    for (int run = 0; status == BATTEN_OK && run < o->count; run++) {
        const batten_interval domain = batten_curve_domain(o->runs[run].plan);
        c.count = 0;
        c.at[c.count++] = domain.a;
        for (int i = 0; i < crossings->count; i++)
            for (int k = 0; k < 2; k++)
                if (crossings->at[i].curve[k] == run)
                    c.at[c.count++] = crossings->at[i].u[k];
        c.at[c.count++] = domain.b;
        qsort(c.at, (size_t)c.count, sizeof *c.at, by_value);
        status = judge_run(t, run, &c);
    }
    bat_release(all);
    return status;
}

/* ---- chaining ---- */

static void follow(trim *t, int i, int j)
{
    t->parts[i].next = j;
    t->parts[j].followed = true;
}

/* First along the way they came, then to whatever begins where a part ends. */
static void link_parts(trim *t)
{
    const int n = t->count;
    for (int i = 0; i < n; i++) {
        const int j = (i + 1) % n;
        const bool wraps = j == 0;
        const part *p = &t->parts[i], *q = &t->parts[j];
        const bool adjacent = (p->run == q->run && p->b == q->a) || q->run == p->run + 1 ||
                              (wraps && t->o->closed);
        if ((!wraps || t->o->closed) && adjacent &&
            bat_distance(2, p->end, q->start) <= t->near)
            follow(t, i, j);
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; t->parts[i].next < 0 && j < n; j++)
            if (!t->parts[j].followed &&
                bat_distance(2, t->parts[i].end, t->parts[j].start) <= t->near)
                follow(t, i, j);
}

batten_status bat_curves_chain(int count, batten_curve *const *curves, double tolerance,
                               batten_curve **out)
{
    batten_curve **waiting = bat_array((size_t)count, sizeof *waiting);
    if (!waiting)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count; i++)
        waiting[i] = batten_curve_ref(curves[i]);
    for (int left = count; status == BATTEN_OK && left > 1; left = (left + 1) / 2)
        for (int i = 0; status == BATTEN_OK && 2 * i + 1 < left + 1; i++) {
            batten_curve *joined = NULL;
            batten_curve *a = waiting[2 * i], *b = 2 * i + 1 < left ? waiting[2 * i + 1] : NULL;
            if (b)
                status = batten_curve_join(a, b, tolerance, &joined);
            if (status != BATTEN_OK)
                break;
            waiting[2 * i] = NULL;
            if (b) {
                waiting[2 * i + 1] = NULL;
                batten_curve_unref(b);
                batten_curve_unref(a);
            }
            waiting[i] = b ? joined : a;
        }
    if (status == BATTEN_OK) {
        *out = waiting[0];
        waiting[0] = NULL;
    }
    for (int i = 0; i < count; i++)
        batten_curve_unref(waiting[i]);
    bat_release(waiting);
    return status;
}

/* The chain from part `first` on as one curve; its parts are no longer there. */
static batten_status make_chain(trim *t, int first, batten_curve **out)
{
    batten_curve **pieces = bat_array((size_t)t->count, sizeof *pieces);
    if (!pieces)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    int count = 0;
    for (int i = first; status == BATTEN_OK && i >= 0;) {
        part *p = &t->parts[i];
        if (p->run < 0)
            break; /* around a closed chain */
        status = batten_curve_subrange(t->o->runs[p->run].curve, p->a, p->b, &pieces[count]);
        count += status == BATTEN_OK;
        p->run = -1;
        i = p->next;
    }
    if (status == BATTEN_OK)
        status = bat_curves_chain(count, pieces, 2 * t->near, out);
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
    const double tolerance = o->options.tolerance;
    trim t = {.o = o,
              .least = fabs(o->distance) - o->report.error - 1e-10 * o->size,
              .near = tolerance + 1e-12 * o->size};
    batten_status status = plans ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < o->count; i++)
        plans[i] = o->runs[i].plan;
    if (status == BATTEN_OK)
        status = bat_crossings_find(o->count, plans, o->closed, &crossings);
    if (status == BATTEN_OK)
        status = judge_all(&t, &crossings);
    if (status == BATTEN_OK) {
        o->report.crossings = crossings.count;
        o->report.removed = t.removed;
        link_parts(&t);
        status = make_chains(&t, out);
    }
    bat_release(crossings.at);
    bat_release(plans);
    bat_release(t.parts);
    return status;
}
