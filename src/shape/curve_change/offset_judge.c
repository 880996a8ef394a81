/* Which parts of an offset curve are as far from the curve as they should be. */
#include "shape/curve_change/offset_judge.h"
#include "base/list.h"
#include "inspect/nearest/self_crossings.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <batten/nearest.h>
#include <stdlib.h>

enum { POINTS = 5, HALVINGS = 50 };

/* ---- cutting ---- */

static batten_status add_part(bat_offset_trimming *t, int run, double a, double b)
{
    const batten_curve *plan = t->o->runs[run].plan;
    bat_offset_part made = {.run = run, .a = a, .b = b, .next = -1};
    batten_status status = batten_curve_evaluate(plan, a, 0, made.start);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(plan, b, 0, made.end);
    if (status != BATTEN_OK)
        return status;
    return BAT_LIST_ADD(t->parts, t->count, t->room, made);
}

/* ---- judging ---- */

batten_status bat_offset_distances(const bat_offset_trimming *t, int count,
                                   const double *points, double *out)
{
    batten_deviation all;
    return batten_curve_deviation(
        t->o->plan, (batten_points){batten_curve_dimension(t->o->plan), count, points}, NULL,
        NULL, out, &all);
}

/* Between two places, the first judged `good` and the second otherwise: the last good one. */
static batten_status find_change(const bat_offset_trimming *t, int run, batten_interval between,
                                 bool good, double *at)
{
    double a = between.a, b = between.b;
    for (int i = 0; i < HALVINGS; i++) {
        double point[2], distance;
        const double middle = a + (b - a) / 2;
        batten_status status = batten_curve_evaluate(t->o->runs[run].plan, middle, 0, point);
        if (status == BATTEN_OK)
            status = bat_offset_distances(t, 1, point, &distance);
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
static batten_status add_samples(samples *s, int run, batten_interval cuts, int break_count,
                                 const double *breaks)
{
    const double a = cuts.a, b = cuts.b;
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
static batten_status sample_run(const bat_offset_trimming *t, int run, int count,
                                const double *cuts, samples *s)
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
            status = add_samples(s, run, (batten_interval){a, b}, breaks, at);
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
static batten_status sample_all(const bat_offset_trimming *t, const bat_crossings *crossings,
                                samples *s)
{
    const int runs = t->o->count, n = 2 * crossings->count + 2 * runs;
    passage *passages = bat_array((size_t)n, sizeof *passages);
    double *cuts = bat_array((size_t)n, sizeof *cuts);
    batten_status status = passages && cuts ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n; i++) {
        const int end = i - 2 * crossings->count;
        if (end < 0) {
            const bat_crossing *c = &crossings->at[i / 2];
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
static void judge_cuts(const bat_offset_trimming *t, samples *s)
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

static batten_status measure_samples(const bat_offset_trimming *t, samples *s)
{
    const size_t n = (size_t)s->count;
    double *points = bat_array(n, 2 * sizeof *points);
    s->far = bat_array(n, sizeof *s->far);
    batten_status status = points && s->far ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < n; i++)
        status =
            batten_curve_evaluate(t->o->runs[s->at[i].run].plan, s->at[i].u, 0, points + 2 * i);
    if (status == BATTEN_OK && n)
        status = bat_offset_distances(t, s->count, points, s->far);
    if (status == BATTEN_OK)
        judge_cuts(t, s);
    bat_release(points);
    return status;
}

double bat_offset_excused(const bat_offset_trimming *t)
{
    return t->least - 10 * t->o->options.tolerance;
}

/* Stretches that are too near by ten tolerances at most stay: the pieces, which are right to
 * one, need not show where the loop that they belong to crosses itself. A closed way begins
 * behind something good. */
static void forgive(const bat_offset_trimming *t, samples *s)
{
    const int n = s->count;
    const double least = t->least, excuse = bat_offset_excused(t);
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
static batten_status keep_good(bat_offset_trimming *t, const samples *s)
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
                status = find_change(t, first->run,
                                     (batten_interval){s->at[i].u, s->at[i + 1].u}, good, &to);
            if (status == BATTEN_OK && good)
                status = add_part(t, first->run, from, to);
            t->removed += !good;
            from = to;
        }
    }
    return status;
}

batten_status bat_offset_judge(bat_offset_trimming *t, const bat_crossings *crossings)
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
