/*
 * Where to cut a surface that closes.
 *
 * The place is chosen so that loops cross it as seldom as possible: at its own ends, at a
 * vertex, or in the widest gap that the loops leave. Edges that cross it are cut there.
 */
#include "body/trace/trace.h"

#include <stdlib.h>
#include <string.h>

/* Of an edge around its surface; more is no edge of a face any more. */
enum { MOST_TURNS = 10000 };
enum { EACH = 8, MOST_PLACES = 24 };

/* Places along all uses of the face: how far around, in turns, in the order of the uses. */
typedef struct {
    int count;
    double *turns; /* [count] */
    double *t;     /* [count] */
    int *first;    /* [uses + 1] */
} samples;

/* How often a use goes around, at most. */
static double turns_of(const bat_trace_face *face, int k, const bat_trace_use *use)
{
    const batten_box box = batten_curve_box(use->curve);
    return (k ? box.high.y - box.low.y : box.high.x - box.low.x) / face->chart.period[k];
}

/* In each span; more where a use goes around and around. */
static int each_of(const bat_trace_face *face, int k, const bat_trace_use *use)
{
    return EACH * (1 + (int)bat_min(1000, turns_of(face, k, use)));
}

static void samples_end(samples *s)
{
    bat_release(s->turns);
    bat_release(s->t);
    bat_release(s->first);
}

static batten_status sample_use(const bat_trace_face *face, int k, const bat_trace_use *use,
                                samples *s)
{
    const int spans = batten_curve_spans(use->curve, NULL) - 1, each = each_of(face, k, use);
    double *breaks = bat_array((size_t)spans + 1, sizeof *breaks);
    batten_status status = breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(use->curve, breaks);
    for (int i = 0; status == BATTEN_OK && i <= spans * each; i++) {
        const double a = breaks[i / each], b = i < spans * each ? breaks[i / each + 1] : a;
        double uv[2];
        const double t = a + (b - a) * (i % each) / each;
        status = batten_curve_evaluate(use->curve, t, 0, uv);
        s->t[s->count] = t;
        s->turns[s->count++] = (uv[k] - face->chart.domain[k].a) / face->chart.period[k];
    }
    bat_release(breaks);
    return status;
}

static batten_status samples_begin(const bat_trace_face *face, int k, samples *s)
{
    const bat_trace_loops *loops = &face->loops;
    size_t count = 0;
    *s = (samples){0};
    for (int i = 0; i < loops->use_count; i++) {
        const double turns = turns_of(face, k, &loops->uses[i]);
        if (!(turns < MOST_TURNS))
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "edge %d goes around its surface %g times", loops->uses[i].edge + 1,
                            turns);
        count += (size_t)(batten_curve_spans(loops->uses[i].curve, NULL) - 1) *
                     (size_t)each_of(face, k, &loops->uses[i]) +
                 1;
    }
    s->turns = bat_array(count, sizeof *s->turns);
    s->t = bat_array(count, sizeof *s->t);
    s->first = bat_array((size_t)loops->use_count + 1, sizeof *s->first);
    batten_status status = s->turns && s->t && s->first ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < loops->use_count; i++) {
        s->first[i] = s->count;
        status = sample_use(face, k, &loops->uses[i], s);
    }
    if (status == BATTEN_OK)
        s->first[loops->use_count] = s->count;
    return status;
}

/* ---- crossings ---- */

/* Called for each place where a loop crosses a line, at a whole number of turns from the seam:
 * in a use between samples i and j, or at a vertex: use -1. */
typedef batten_status (*on_crossing)(void *context, int use, int i, int j, double line);

typedef struct {
    const samples *samples;
    double at, near; /* in turns */
    on_crossing call;
    void *context;
    int first;              /* the first sample of the loop that is off the lines, or -1 */
    int before, before_use; /* the last one */
} walk;

static batten_status step_to(walk *w, int use, int i, double turns)
{
    const double here = turns - w->at, then = w->samples->turns[w->before] - w->at;
    const double a = floor(then), b = floor(here);
    if (a == b)
        return BATTEN_OK;
    return w->call(w->context, use == w->before_use ? use : -1, w->before, i,
                   w->at + bat_max(a, b));
}

static batten_status walk_use(walk *w, const bat_trace_loops *loops, int use)
{
    const samples *s = w->samples;
    const int count = s->first[use + 1] - s->first[use];
    batten_status status = BATTEN_OK;
    for (int n = 0; status == BATTEN_OK && n < count; n++) {
        const int i = loops->uses[use].reversed ? s->first[use + 1] - 1 - n : s->first[use] + n;
        const double x = s->turns[i] - w->at;
        if (fabs(x - nearbyint(x)) <= w->near)
            continue;
        if (w->first < 0)
            w->first = i;
        else
            status = step_to(w, use, i, s->turns[i]);
        w->before = i;
        w->before_use = use;
    }
    return status;
}

static batten_status each_crossing(const bat_trace_face *face, int k, const samples *s,
                                   double at, on_crossing call, void *context)
{
    const bat_trace_loops *loops = &face->loops;
    batten_status status = BATTEN_OK;
    for (int l = 0; status == BATTEN_OK && l < loops->loop_count; l++) {
        walk w = {s, at, face->chart.near[k] / face->chart.period[k], call, context, -1, 0, 0};
        const batten_body_loop *loop = &loops->loops[l];
        int turns[2];
        for (int i = 0; status == BATTEN_OK && i < loop->count; i++)
            status = walk_use(&w, loops, loop->first + i);
        bat_trace_winding(face, loops, l, turns);
        if (status == BATTEN_OK && w.first >= 0)
            status = step_to(&w, -1, w.first, s->turns[w.first] + turns[k]);
    }
    return status;
}

/* A crossing costs a seam, and to divide an edge a little more. */
static batten_status count_crossing(void *context, int use, int i, int j, double line)
{
    (void)i, (void)j, (void)line;
    *(int *)context += use < 0 ? 4 : 5;
    return BATTEN_OK;
}

/* ---- the place ---- */

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* The middle of the widest gap that the samples leave around the surface, in turns. */
static batten_status widest_gap(const samples *s, double *middle)
{
    double *parts = bat_array((size_t)s->count, sizeof *parts), widest = 0;
    if (!parts)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < s->count; i++)
        parts[i] = s->turns[i] - floor(s->turns[i]);
    qsort(parts, (size_t)s->count, sizeof *parts, by_size);
    for (int i = 0; i < s->count; i++) {
        const double next = i < s->count - 1 ? parts[i + 1] : parts[0] + 1;
        if (next - parts[i] > widest) {
            widest = next - parts[i];
            *middle = parts[i] + widest / 2;
        }
    }
    *middle -= floor(*middle);
    bat_release(parts);
    return BATTEN_OK;
}

/* The cut with the fewest crossings; of equals the first. */
static batten_status choose(const bat_trace_face *face, int k, const samples *s, double *at)
{
    double places[MOST_PLACES] = {0};
    int count = 2, best = INT32_MAX;
    batten_status status = widest_gap(s, &places[1]);
    for (int i = 0; i < face->loops.use_count && count < MOST_PLACES; i++) {
        const double turns = s->turns[s->first[i]];
        places[count++] = turns - floor(turns);
    }
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        int crossings = 0;
        status = each_crossing(face, k, s, places[i], count_crossing, &crossings);
        if (status == BATTEN_OK && crossings < best) {
            best = crossings;
            *at = places[i];
        }
    }
    return status;
}

/* *place: the parameter of the cut; near a knot of the surface the knot, and *at with it, for
 * knots nearly together are of no use. */
static batten_status to_knot(const bat_chart *chart, int k, double *at, double *place)
{
    const batten_direction along = k ? BATTEN_V : BATTEN_U;
    const int count = batten_surface_spans(chart->surface, along, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(chart->surface, along, knots);
    *place = chart->domain[k].a + *at * chart->period[k];
    for (int i = 0; i < count; i++) {
        const double turns = (knots[i] - chart->domain[k].a) / chart->period[k];
        if (fabs(turns - *at) <= chart->near[k] / chart->period[k]) {
            *at = i < count - 1 ? turns : 0;
            *place = i < count - 1 ? knots[i] : chart->domain[k].a;
        }
    }
    bat_release(knots);
    return BATTEN_OK;
}

/* ---- cutting ---- */

typedef struct {
    bat_trace *trace;
    const bat_trace_face *face;
    const samples *samples;
    int k;
} cutter;

/* Bisection between the two samples, which are on both sides of the line. */
static batten_status cut_between(void *context, int use, int i, int j, double line)
{
    cutter *c = context;
    if (use < 0)
        return BATTEN_OK;
    const bat_trace_use *u = &c->face->loops.uses[use];
    const bat_chart *chart = &c->face->chart;
    /* In the order of the edge, whichever way the loop runs. */
    const int first = bat_min_int(i, j), last = bat_max_int(i, j);
    double low = c->samples->t[first], high = c->samples->t[last];
    const bool rises = c->samples->turns[last] > c->samples->turns[first];
    const double value = chart->domain[c->k].a + line * chart->period[c->k];
    for (int step = 0; step < 200; step++) {
        const double middle = low + (high - low) / 2;
        double uv[2];
        if (!(middle > low && middle < high))
            break;
        const batten_status status = batten_curve_evaluate(u->curve, middle, 0, uv);
        if (status != BATTEN_OK)
            return status;
        if ((uv[c->k] < value) == rises)
            low = middle;
        else
            high = middle;
    }
    return u->is_pole ? BATTEN_OK : bat_trace_cut_at(c->trace, u->edge, high);
}

batten_status bat_trace_choose_seam(bat_trace *trace, bat_trace_face *face)
{
    const int k = trace->direction;
    samples s = {0};
    double at = 0;
    face->seam[k] = face->chart.domain[k].a;
    if (!face->chart.closed[k] || face->loops.loop_count == 0)
        return BATTEN_OK;
    batten_status status = samples_begin(face, k, &s);
    if (status == BATTEN_OK)
        status = choose(face, k, &s, &at);
    if (status == BATTEN_OK)
        status = to_knot(&face->chart, k, &at, &face->seam[k]);
    cutter c = {trace, face, &s, k};
    if (status == BATTEN_OK)
        status = each_crossing(face, k, &s, at, cut_between, &c);
    samples_end(&s);
    return status;
}
