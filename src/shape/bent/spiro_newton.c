/*
 * Newton's method for splines with curvature cubic in arc length. Each point has four
 * equations, which touch the spans beside it, so that the cost is linear.
 *
 * It goes from Euler spirals, which join at all points with curvature alone, to what the points
 * ask for: directly, and where that fails by parts.
 */
#include "base/plural.h"
#include "numeric/givens.h"
#include "numeric/vector.h"
#include "shape/bent/spiro.h"
#include "shape/bent/spiro_equations.h"

#include <string.h>

enum { N = BAT_SPIRO_UNKNOWNS, PER_POINT = 4 };

/* ---- all of them ---- */

/* Every equation at an iterate, in the order in which the matrix wants its rows, given to
 * `take`: it stands at 4 i + 0..3 of point i, and touches unknowns from `first` on. */
typedef void (*take_equation)(bat_spiro_search *s, int at, int first, int length,
                              const bat_spiro_terms *e);

static void visit(bat_spiro_search *s, bat_spiro_iterate *it, take_equation take)
{
    const bat_chord_polygon *p = s->task->chords;
    for (int i = 0; i < p->count; i++) {
        const bool start = !p->closed && i == 0, end = !p->closed && i == p->count - 1;
        const int before = (i + p->spans - 1) % p->spans;
        for (int which = 0; which < (start || end ? 2 : PER_POINT); which++) {
            bat_spiro_terms e = start || end ? bat_spiro_end_equation(s, it, end, which)
                                             : bat_spiro_equation(s, it, i, before, i, which);
            if (start)
                memmove(e.row, e.row + N, N * sizeof *e.row);
            take(s, PER_POINT * i + which, start ? 0 : before * N,
                 start || end ? N : BAT_SPIRO_WIDTH, &e);
        }
    }
}

static void take_value(bat_spiro_search *s, int at, int first, int length,
                       const bat_spiro_terms *e)
{
    (void)first;
    (void)length;
    bat_spiro_iterate *it = &s->next;
    it->values[at] = e->value;
    if (!(fabs(e->value) <= it->worst)) {
        it->worst = fabs(e->value);
        it->worst_at = at / PER_POINT;
    }
}

static void take_row(bat_spiro_search *s, int at, int first, int length,
                     const bat_spiro_terms *e)
{
    const double right = -e->value;
    (void)at;
    bat_givens_add(&s->qr, first, length, e->row, 1, &right);
}

/* The values of the next iterate times the matrix of this one, transposed. */
static void take_product(bat_spiro_search *s, int at, int first, int length,
                         const bat_spiro_terms *e)
{
    const int n = s->qr.count;
    for (int k = 0; k < length; k++)
        s->rest[(first + k) % n] += e->row[k] * s->next.values[at];
}

/* Measure s->next at its c. */
static void evaluate(bat_spiro_search *s)
{
    bat_spiro_iterate *it = &s->next;
    const bat_chord_polygon *p = s->task->chords;
    it->worst = it->size = 0;
    for (int j = 0; j < p->spans; j++) {
        const double *c = it->c + (size_t)j * N;
        bat_spiro_span_at(c, p->length[j], &it->spans[j]);
        it->size = bat_max(it->size, fabs(c[0]) + fabs(c[1]) + fabs(c[2]) + fabs(c[3]));
    }
    visit(s, it, take_value);
}

static bool settled(const bat_spiro_iterate *it)
{
    return it->worst <= 1e-12 * it->size;
}

/* ---- steps ---- */

static void swap(bat_spiro_search *s)
{
    const bat_spiro_iterate kept = s->now;
    s->now = s->next;
    s->next = kept;
}

static batten_status find_step(bat_spiro_search *s)
{
    int unknown = 0;
    bat_givens_clear(&s->qr);
    visit(s, &s->now, take_row);
    const batten_status status = bat_givens_check(&s->qr, &unknown);
    if (status == BATTEN_OK)
        bat_givens_solve(&s->qr, s->step);
    return status;
}

/* The part of the step, at most 1, that turns no span by more than a radian. */
static double longest(const bat_spiro_search *s)
{
    double most = 1;
    for (int j = 0; j < s->task->chords->spans; j++) {
        double turn = 0;
        for (int m = 0; m < N; m++)
            turn += fabs(s->step[(size_t)j * N + (size_t)m]);
        most = bat_max(most, turn);
    }
    return 1 / most;
}

/* How long Newton's step would be at the next iterate, by the matrix of this one. */
static double length_left(bat_spiro_search *s)
{
    const int n = s->qr.count;
    memset(s->rest, 0, (size_t)n * sizeof *s->rest);
    visit(s, &s->now, take_product);
    bat_givens_solve_lower(&s->qr, 1, s->rest);
    bat_givens_solve_upper(&s->qr, 1, s->rest);
    return bat_norm(n, s->rest);
}

/* Shorten the step until what is left is shorter; false when no part of it does. The measure
 * does not depend on how the equations are scaled. */
static bool advance(bat_spiro_search *s)
{
    enum { HALVINGS = 12 };
    const size_t n = (size_t)s->qr.count;
    const double whole = bat_norm(s->qr.count, s->step);
    double part = longest(s);
    for (int k = 0; k < HALVINGS; k++, part /= 2) {
        for (size_t i = 0; i < n; i++)
            s->next.c[i] = s->now.c[i] + part * s->step[i];
        evaluate(s);
        if (settled(&s->next) ||
            (isfinite(s->next.worst) && length_left(s) <= (1 - part / 4) * whole)) {
            swap(s);
            return true;
        }
    }
    return false;
}

/* Newton for s->part from s->now; SINGULAR_SYSTEM when it does not get there. */
static batten_status improve(bat_spiro_search *s)
{
    enum { MOST = 40 };
    const size_t bytes = (size_t)s->task->chords->spans * N * sizeof *s->now.c;
    memcpy(s->next.c, s->now.c, bytes);
    evaluate(s);
    swap(s);
    for (int k = 0; !settled(&s->now); k++) {
        if (k == MOST)
            return BATTEN_SINGULAR_SYSTEM;
        if (s->steps == s->max_steps)
            return bat_fail(BATTEN_INCOMPLETE,
                            "after %d step%s the spline still jumps by %g at point %d",
                            s->steps, bat_plural(s->steps), s->now.worst, s->now.worst_at + 1);
        s->steps++;
        const batten_status status = find_step(s);
        if (status != BATTEN_OK)
            return status;
        if (!advance(s))
            return BATTEN_SINGULAR_SYSTEM;
    }
    return BATTEN_OK;
}

/* The span that turns most, for messages. */
static int widest(const bat_spiro_iterate *it, int spans)
{
    int at = 0;
    double most = 0;
    for (int j = 0; j < spans; j++) {
        const double *c = it->c + (size_t)j * N;
        const double turn = fabs(c[0]) + fabs(c[1]) + fabs(c[2]) + fabs(c[3]);
        if (turn > most) {
            most = turn;
            at = j;
        }
    }
    return at;
}

/* What helps where span j bends too much and Euler spirals join its neighbours, or not even
 * they do. */
static const char *remedy_for(const bat_spiro_task *task, int j, bool spirals)
{
    const int last = task->chords->spans - 1;
    const batten_spiro_end *end = &task->ends[j == last];
    if (!task->chords->closed && (j == 0 || j == last) && !end->has_tangent &&
        !end->has_curvature)
        return "give the curve a curvature of 0 or a direction at that end";
    return spirals ? "Euler spirals pass there, so make both points of curvature alone"
                   : "make one of these points a corner";
}

static batten_status fail_span(const bat_spiro_search *s, bool spirals)
{
    const bat_chord_polygon *p = s->task->chords;
    const int j = widest(&s->now, p->spans);
    const bat_spiro_span *at = &s->now.spans[j];
    return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                    "span %d from point %d to %d bends too much, from %.4g to %.4g degree%s "
                    "against its chord, to be joined so smoothly: %s, or put a point between",
                    j + 1, j + 1, (j + 1) % p->count + 1, at->value[0][0] * 180 / BAT_PI,
                    at->value[1][0] * 180 / BAT_PI,
                    bat_plural_real(at->value[1][0] * 180 / BAT_PI, 4),
                    remedy_for(s->task, j, spirals));
}

/* ---- from Euler spirals to the spline ---- */

/* In parts, which shrink where one fails. `kept`: room for the last that was reached. */
static batten_status walk(bat_spiro_search *s, double *kept)
{
    const size_t bytes = (size_t)s->task->chords->spans * N * sizeof *kept;
    double at = 0, part = 1;
    memcpy(kept, s->now.c, bytes);
    while (at < 1) {
        s->part = bat_min(1, at + part);
        const batten_status status = improve(s);
        if (status != BATTEN_OK && status != BATTEN_SINGULAR_SYSTEM)
            return status;
        if (status == BATTEN_OK) {
            at = s->part;
            memcpy(kept, s->now.c, bytes);
            continue;
        }
        memcpy(s->now.c, kept, bytes);
        if ((part /= 2) < 1e-2)
            return fail_span(s, true);
    }
    return BATTEN_OK;
}

static bool wants_more(const bat_spiro_task *task)
{
    for (int i = 0; i < task->chords->count; i++)
        if (task->kinds[i] == BATTEN_SPIRO_SMOOTH)
            return true;
    return false;
}

static batten_status search_to_end(bat_spiro_search *s, double *kept)
{
    batten_status status = improve(s);
    if (status == BATTEN_SINGULAR_SYSTEM)
        return fail_span(s, false);
    if (status == BATTEN_OK && wants_more(s->task))
        status = walk(s, kept);
    return status;
}

static bool iterate_make(int count, int spans, bat_spiro_iterate *it)
{
    it->values = bat_array3((size_t)count, PER_POINT, sizeof *it->values);
    it->c = bat_array3((size_t)spans, N, sizeof *it->c);
    it->spans = bat_array((size_t)spans, sizeof *it->spans);
    return it->values && it->c && it->spans;
}

static void iterate_free(bat_spiro_iterate *it)
{
    bat_release(it->values);
    bat_release(it->c);
    bat_release(it->spans);
}

static void fill_report(const bat_spiro_search *s, batten_chain_spiro_report *report)
{
    report->steps = s->steps;
    report->error = s->now.worst;
    for (int j = 0; j < s->task->chords->spans; j++)
        for (int e = 0; e < 2; e++)
            report->curvature = bat_max(report->curvature, fabs(s->now.spans[j].value[e][1]));
}

batten_status bat_spiro_solve(const bat_spiro_task *task, int max_steps, double *c,
                              batten_chain_spiro_report *report)
{
    const bat_chord_polygon *p = task->chords;
    const size_t bytes = (size_t)p->spans * N * sizeof *c;
    bat_spiro_search s = {.task = task, .max_steps = max_steps};
    s.step = bat_array3((size_t)p->spans, N, sizeof *s.step);
    s.rest = bat_array3((size_t)p->spans, N, sizeof *s.rest);
    double *kept = bat_array3((size_t)p->spans, N, sizeof *kept);
    const bool room = s.step && s.rest && kept && iterate_make(p->count, p->spans, &s.now) &&
                      iterate_make(p->count, p->spans, &s.next);
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (room)
        status = bat_givens_begin(p->spans * N, bat_min_int(BAT_SPIRO_WIDTH, p->spans * N),
                                  p->closed, 1, &s.qr);
    if (status == BATTEN_OK) {
        memcpy(s.now.c, c, bytes);
        status = search_to_end(&s, kept);
    }
    if (status == BATTEN_OK) {
        memcpy(c, s.now.c, bytes);
        fill_report(&s, report);
    }
    bat_givens_end(&s.qr);
    iterate_free(&s.now);
    iterate_free(&s.next);
    bat_release(s.step);
    bat_release(s.rest);
    bat_release(kept);
    return status;
}
