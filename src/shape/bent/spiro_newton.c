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

#include <string.h>

enum { N = BAT_SPIRO_UNKNOWNS, WIDTH = 2 * N, PER_POINT = 4 };

typedef struct {
    double *c;             /* [spans][4] */
    bat_spiro_span *spans; /* at c */
    double *values;        /* [count][4], of the equations at each point */
    double worst;          /* the largest of them */
    int worst_at;          /* its point */
    double size;           /* the largest turning of a span */
} iterate;

typedef struct {
    const bat_spiro_task *task;
    double part; /* 0: Euler spirals; 1: what smooth points ask for */
    bat_givens qr;
    double *step, *rest; /* [spans][4]: Newton's, and what it would be at the next iterate */
    iterate now, next;
    int steps, max_steps;
} spiro_search;

/* ---- equations ---- */

/* value = 0; its derivatives by the unknowns of the span before the point and of that after. */
typedef struct {
    double value, row[WIDTH];
} equation;

/* Add factor times what a span has at an end: of the span before the point (side 0) its end. */
static void add_term(const iterate *it, int span, int side, int order, double factor,
                     equation *out)
{
    const bat_spiro_span *at = &it->spans[span];
    const int end = !side;
    out->value += factor * at->value[end][order];
    for (int m = 0; m < N; m++)
        out->row[side * N + m] += factor * at->by[end][order][m];
}

/* The two conditions of a side that ends freely; a straight span has them of its unknowns. */
static void add_free(const spiro_search *s, const iterate *it, int span, int side, int which,
                     equation *out)
{
    if (s->task->straight[span]) {
        const int m = 2 * side + which;
        out->value = it->c[span * N + m];
        out->row[side * N + m] = 1;
        return;
    }
    const double l = s->task->chords->length[span];
    add_term(it, span, side, 2 + which, which ? l * l * l : l * l, out);
}

static void add_jump(const iterate *it, int before, int after, int order, double factor,
                     equation *out)
{
    add_term(it, before, 0, order, factor, out);
    add_term(it, after, 1, order, -factor, out);
}

/* The third and fourth equation of a point at which curvature continues. Where k'' is the same
 * at both sides and balances a part of the jump of k', the way from k'' = 0 to no jump is a
 * hinge that stiffens. */
static void add_smooth(const iterate *it, int before, int after, double part, double l,
                       int which, equation *out)
{
    if (which == 1) {
        add_jump(it, before, after, 3, l * l * l, out);
        return;
    }
    add_jump(it, before, after, 2, part * l * l, out);
    const double rest = (1 - part) * l * l * l / 2;
    add_term(it, before, 0, 3, rest, out);
    add_term(it, after, 1, 3, rest, out);
}

/* Equation `which` of 0..3 at point i between the two spans. */
static equation equation_at(const spiro_search *s, const iterate *it, int i, int before,
                            int after, int which)
{
    const bat_chord_polygon *p = s->task->chords;
    const batten_spiro_kind kind = s->task->kinds[i];
    const double l = 1 / (1 / p->length[before] + 1 / p->length[after]);
    equation e = {0};
    const bool one_way = kind == BATTEN_SPIRO_LEFT || kind == BATTEN_SPIRO_RIGHT;
    if (kind == BATTEN_SPIRO_CORNER)
        add_free(s, it, which < 2 ? before : after, which >= 2, which % 2, &e);
    else if (one_way && which >= 2)
        add_free(s, it, kind == BATTEN_SPIRO_LEFT ? before : after, kind == BATTEN_SPIRO_RIGHT,
                 which - 2, &e);
    else if (which >= 2)
        add_smooth(it, before, after, kind == BATTEN_SPIRO_SMOOTH ? s->part : 0, l, which - 2,
                   &e);
    else {
        add_jump(it, before, after, which, which ? l : 1, &e);
        e.value -= which ? 0 : p->turn[i];
    }
    return e;
}

/* Equation 0 or 1 at the start (end 0) or the end of an open curve. */
static equation equation_of_end(const spiro_search *s, const iterate *it, int end, int which)
{
    const bat_chord_polygon *p = s->task->chords;
    const batten_spiro_end *given = &s->task->ends[end];
    const int span = end ? p->spans - 1 : 0, side = !end;
    equation e = {0};
    if (which == 0 && given->has_curvature) {
        add_term(it, span, side, 1, p->length[span], &e);
        e.value -= given->curvature * p->length[span];
    } else if (which == 1 && given->has_tangent) {
        add_term(it, span, side, 0, 1, &e);
        e.value -= given->tangent;
    } else {
        add_free(s, it, span, side, which, &e);
    }
    return e;
}

/* ---- all of them ---- */

/* Every equation at an iterate, in the order in which the matrix wants its rows, given to
 * `take`: it stands at 4 i + 0..3 of point i, and touches unknowns from `first` on. */
typedef void (*take_equation)(spiro_search *s, int at, int first, int length,
                              const equation *e);

static void visit(spiro_search *s, iterate *it, take_equation take)
{
    const bat_chord_polygon *p = s->task->chords;
    for (int i = 0; i < p->count; i++) {
        const bool start = !p->closed && i == 0, end = !p->closed && i == p->count - 1;
        const int before = (i + p->spans - 1) % p->spans;
        for (int which = 0; which < (start || end ? 2 : PER_POINT); which++) {
            equation e = start || end ? equation_of_end(s, it, end, which)
                                      : equation_at(s, it, i, before, i, which);
            if (start)
                memmove(e.row, e.row + N, N * sizeof *e.row);
            take(s, PER_POINT * i + which, start ? 0 : before * N, start || end ? N : WIDTH,
                 &e);
        }
    }
}

static void take_value(spiro_search *s, int at, int first, int length, const equation *e)
{
    (void)first;
    (void)length;
    iterate *it = &s->next;
    it->values[at] = e->value;
    if (!(fabs(e->value) <= it->worst)) {
        it->worst = fabs(e->value);
        it->worst_at = at / PER_POINT;
    }
}

static void take_row(spiro_search *s, int at, int first, int length, const equation *e)
{
    const double right = -e->value;
    (void)at;
    bat_givens_add(&s->qr, first, length, e->row, 1, &right);
}

/* The values of the next iterate times the matrix of this one, transposed. */
static void take_product(spiro_search *s, int at, int first, int length, const equation *e)
{
    const int n = s->qr.count;
    for (int k = 0; k < length; k++)
        s->rest[(first + k) % n] += e->row[k] * s->next.values[at];
}

/* Measure s->next at its c. */
static void evaluate(spiro_search *s)
{
    iterate *it = &s->next;
    const bat_chord_polygon *p = s->task->chords;
    it->worst = it->size = 0;
    for (int j = 0; j < p->spans; j++) {
        const double *c = it->c + (size_t)j * N;
        bat_spiro_span_at(c, p->length[j], &it->spans[j]);
        it->size = bat_max(it->size, fabs(c[0]) + fabs(c[1]) + fabs(c[2]) + fabs(c[3]));
    }
    visit(s, it, take_value);
}

static bool settled(const iterate *it)
{
    return it->worst <= 1e-12 * it->size;
}

/* ---- steps ---- */

static void swap(spiro_search *s)
{
    const iterate kept = s->now;
    s->now = s->next;
    s->next = kept;
}

static batten_status find_step(spiro_search *s)
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
static double longest(const spiro_search *s)
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
static double length_left(spiro_search *s)
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
static bool advance(spiro_search *s)
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
static batten_status improve(spiro_search *s)
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
                            s->steps, bat_plural(s->steps), s->now.worst, s->now.worst_at);
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
static int widest(const iterate *it, int spans)
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

static batten_status fail_span(const spiro_search *s, bool spirals)
{
    const bat_chord_polygon *p = s->task->chords;
    const int j = widest(&s->now, p->spans);
    const bat_spiro_span *at = &s->now.spans[j];
    return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                    "span %d from point %d to %d bends too much, from %.4g to %.4g degrees "
                    "against its chord, to be joined so smoothly: %s, or put a point between",
                    j, j, (j + 1) % p->count, at->value[0][0] * 180 / BAT_PI,
                    at->value[1][0] * 180 / BAT_PI, remedy_for(s->task, j, spirals));
}

/* ---- from Euler spirals to the spline ---- */

/* In parts, which shrink where one fails. `kept`: room for the last that was reached. */
static batten_status walk(spiro_search *s, double *kept)
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

static batten_status search_to_end(spiro_search *s, double *kept)
{
    batten_status status = improve(s);
    if (status == BATTEN_SINGULAR_SYSTEM)
        return fail_span(s, false);
    if (status == BATTEN_OK && wants_more(s->task))
        status = walk(s, kept);
    return status;
}

static bool iterate_make(int count, int spans, iterate *it)
{
    it->values = bat_array3((size_t)count, PER_POINT, sizeof *it->values);
    it->c = bat_array3((size_t)spans, N, sizeof *it->c);
    it->spans = bat_array((size_t)spans, sizeof *it->spans);
    return it->values && it->c && it->spans;
}

static void iterate_free(iterate *it)
{
    bat_release(it->values);
    bat_release(it->c);
    bat_release(it->spans);
}

static void fill_report(const spiro_search *s, batten_chain_spiro_report *report)
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
    spiro_search s = {.task = task, .max_steps = max_steps};
    s.step = bat_array3((size_t)p->spans, N, sizeof *s.step);
    s.rest = bat_array3((size_t)p->spans, N, sizeof *s.rest);
    double *kept = bat_array3((size_t)p->spans, N, sizeof *kept);
    const bool room = s.step && s.rest && kept && iterate_make(p->count, p->spans, &s.now) &&
                      iterate_make(p->count, p->spans, &s.next);
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (room)
        status = bat_givens_begin(p->spans * N, bat_min_int(WIDTH, p->spans * N), p->closed, 1,
                                  &s.qr);
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
