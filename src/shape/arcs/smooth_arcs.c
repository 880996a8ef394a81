/*
 * The fewest arcs that are tangent to one another, within a band along a curve.
 *
 * Along a curve with the curvature k the deviation of an arc of length h is a cubic whose third
 * derivative is k'. With its zeros at both ends and in the middle it reaches |k'| h^3 / (72
 * sqrt 3), and has the same slope at both ends: so arcs that begin and end on the curve (or in
 * the middle of the band) can be tangent and as long as if they were not. This is the
 * monospline of least deviation, so nothing smooth is longer.
 *
 * An arc from a place of the curve with a lean, the angle from the curve's direction, to
 * another place is determined, and with it the lean there. So the search goes over places and
 * leans: after each number of arcs it keeps for each small range of leans the state that is
 * farthest.
 */
#include "shape/arcs/smooth_arcs.h"
#include "numeric/vector.h"

#include <limits.h>
#include <string.h>

enum {
    FINE = 96,   /* places along each plain arc */
    LEANS = 65,  /* ranges of leans */
    AHEAD = 250, /* places that are tried, beyond what any arc reaches */
    LOOKS = 24,  /* at the curve along an arc */
    MOST_ARCS = 10000
};

/* Steadily going on, a lean is sqrt 3 / 6 * 36 = 10.4 half bands by the length of an arc. The
 * ranges reach to 16 of them. */
static const double step_of_leans = 0.5, most_lean = 1;

typedef struct {
    double u, point[2], direction[2]; /* of the curve */
    double node[2];                   /* in the middle of the band */
    double angle;                     /* of the direction, all turns added */
    double reach;                     /* the length of a plain arc there */
} row;

typedef struct {
    int place, parent;
    double lean;
} arc_state;

typedef struct {
    const bat_arcs_smooth *task;
    double half, middle, shrink;  /* of the band; the share of it that samples may take */
    double excess;                /* by how much arcs may bend otherwise than the curve */
    double least_bend, most_bend; /* the curvatures that arcs may have at all */
    bool held; /* the ends stay on the curve, beside the middle of the band */
    bool around;
    int count; /* of steps between the rows */
    row *rows; /* [count + 1] */
    int state_count, capacity;
    arc_state *states;
    arc_state start; /* that was best, around, and the arcs from there; 0: none yet */
    int start_arcs;
    int best[LEANS], now[LEANS], next[LEANS]; /* place; states, or -1 */
} arc_search;

/* ---- the curve ---- */

/* The row at a place; a closed curve continues. */
static row row_at(const arc_search *s, int place)
{
    const bool again = place > s->count;
    row r = s->rows[again ? place - s->count : place];
    if (again) {
        r.u += s->task->to - s->task->from;
        r.angle += s->rows[s->count].angle - s->rows[0].angle;
    }
    return r;
}

static batten_status make_row(arc_search *s, int i, double u, double reach)
{
    row *r = &s->rows[i];
    double at[4];
    const bool end = i == s->count;
    const batten_status status =
        bat_arcs_direction(s->task->path, u, end ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, at);
    if (status != BATTEN_OK)
        return status;
    const double off = s->held && (i == 0 || end) ? 0 : s->middle;
    *r = (row){.u = u,
               .point = {at[0], at[1]},
               .direction = {at[2], at[3]},
               .node = {at[0] - off * at[3], at[1] + off * at[2]},
               .reach = reach};
    r->angle =
        i == 0 ? atan2(at[3], at[2]) : r[-1].angle + bat_turn(r[-1].direction, r->direction);
    return BATTEN_OK;
}

/* No arc bends much more sharply than the curve does anywhere, and none to a side to which the
 * curve never turns. */
static void find_bends(arc_search *s)
{
    static const double more = 1.4;
    double left = 0, right = 0, turned[2] = {0, 0};
    for (int i = 0; i < s->count; i++) {
        const double turn = s->rows[i + 1].angle - s->rows[i].angle;
        const double k = turn / bat_distance(2, s->rows[i].point, s->rows[i + 1].point);
        turned[turn > 0] += fabs(turn);
        left = isfinite(k) ? bat_max(left, k) : left;
        right = isfinite(k) ? bat_min(right, k) : right;
    }
    /* What turns less than this is rounding. */
    static const double rounding = 1e-9;
    const double most = more * bat_max(left, -right);
    s->most_bend = turned[1] > rounding * turned[0] ? most : rounding * most;
    s->least_bend = turned[0] > rounding * turned[1] ? -most : -rounding * most;
}

/* As fine along each plain arc: so the rows are dense where arcs will be short. */
static batten_status make_rows(arc_search *s)
{
    const bat_arcs_list *guide = s->task->guide;
    s->count = FINE * guide->count;
    s->rows = bat_array((size_t)s->count + 1, sizeof *s->rows);
    if (!s->rows)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (int i = 0; i <= s->count && status == BATTEN_OK; i++) {
        const bat_arcs_part *part = &guide->parts[bat_min_int(i / FINE, guide->count - 1)];
        const double share = (double)(i - FINE * (int)(part - guide->parts)) / FINE;
        const double u =
            i == s->count ? s->task->to : part->from + (part->to - part->from) * share;
        status = make_row(s, i, u, part->biarc.arcs[0].length);
    }
    if (status == BATTEN_OK)
        find_bends(s);
    return status;
}

/* ---- arcs ---- */

static bool may_bend(const arc_search *s, double curvature)
{
    return curvature >= s->least_bend && curvature <= s->most_bend;
}

static batten_status add_state(arc_search *s, const arc_state *from, int *index)
{
    if (s->state_count == s->capacity) {
        const int capacity = bat_max_int(1024, 2 * s->capacity);
        arc_state *states = bat_resize(s->states, (size_t)capacity, sizeof *states);
        if (!states)
            return BATTEN_OUT_OF_MEMORY;
        s->states = states;
        s->capacity = capacity;
    }
    *index = s->state_count++;
    s->states[*index] = *from;
    return BATTEN_OK;
}

/* The range of a lean; -1 beyond the last. */
static int range_of(const arc_search *s, double lean, double reach)
{
    const double at = lean * reach / (step_of_leans * s->half) + LEANS / 2.0;
    return at >= 0 && at < LEANS && fabs(lean) < most_lean ? (int)at : -1;
}

/* By how much an arc bends otherwise than the curve on average: a steady arc not at all, one at
 * an extreme of curvature by less than 20 half bands by the square of its length. Short arcs
 * that bend wildly fit into the band as well, but nobody wants them. */
static bool bends_alike(const arc_search *s, double lean, const row *to, double to_lean,
                        double l)
{
    return fabs(to_lean - lean) * to->reach * to->reach <= s->excess * s->half * l;
}

/* Where an arc goes: the chord to a node, and half its turn. */
typedef struct {
    const row *from;
    double lean, angle, direction[2]; /* with which it begins */
    double length, half;
} leg;

static leg leg_of(const row *from, double lean)
{
    const double angle = from->angle + lean;
    return (leg){
        .from = from, .lean = lean, .angle = angle, .direction = {cos(angle), sin(angle)}};
}

/* On to the node of a row, and the lean with which the arc arrives; false when it turns by more
 * than a half circle, leans too much or bends too much. */
static bool aim(const arc_search *s, leg *l, const row *to, double *lean, int *range)
{
    const double chord[2] = {to->node[0] - l->from->node[0], to->node[1] - l->from->node[1]};
    l->half = bat_turn(l->direction, chord);
    *lean = l->angle + 2 * l->half - to->angle;
    *range = range_of(s, *lean, to->reach);
    l->length = bat_norm(2, chord);
    return l->length > 0 && fabs(l->half) <= BAT_PI / 2 * (1 + 1e-9) && *range >= 0 &&
           bends_alike(s, l->lean, to, *lean, l->length);
}

static bool make_arc(const arc_search *s, const leg *l, batten_biarc *out)
{
    const double least = s->task->least_radius;
    *out = (batten_biarc){.count = 1, .place = 0.5, .turn = {2 * l->half}};
    bat_arc_span(l->from->node, l->length, l->angle + l->half, l->half, &out->arcs[0]);
    const double k = out->arcs[0].curvature[0];
    return may_bend(s, k) && !(least > 0 && fabs(k) * least > 1 + 1e-12);
}

static double beside_middle(const arc_search *s, const bat_arcs_probe *probe, int place)
{
    const row *r = &s->rows[place > s->count ? place - s->count : place];
    return bat_arcs_beside(probe, r->point) - s->middle;
}

/* Rows miss the extremes by a little, so they are held to less, but for those next to an end
 * that lies beside the middle. */
static bool passes(const arc_search *s, double off, int place)
{
    const bool at_end = s->held && (place <= FINE / 4 || place >= s->count - FINE / 4);
    return fabs(off) <= s->half * (at_end ? 1 : s->shrink) + s->task->slack;
}

/* A few looks at the curve along the arc; then all between those next to the extremes. */
static bool fits(const arc_search *s, const batten_biarc *arc, int from, int to)
{
    bat_arcs_probe probe;
    bat_arcs_probe_make(arc, &probe);
    const int step = bat_max_int(1, (to - from) / LOOKS);
    int extreme[2] = {from, from};
    double largest[2] = {0, 0};
    for (int i = from + 1; i < to; i += step) {
        const double off = beside_middle(s, &probe, i);
        if (!passes(s, off, i))
            return false;
        if (fabs(off) > largest[off > 0]) {
            largest[off > 0] = fabs(off);
            extreme[off > 0] = i;
        }
    }
    for (int k = 0; k < 2; k++)
        for (int i = bat_max_int(from, extreme[k] - step) + 1;
             i < bat_min_int(to, extreme[k] + step); i++)
            if (!passes(s, beside_middle(s, &probe, i), i))
                return false;
    return passes(s, beside_middle(s, &probe, to - 1), to - 1);
}

/* At an end that lies on one side of its band the arcs must lead into it. */
static bool leads_in(const arc_search *s, double lean, bool arriving)
{
    return !s->held || (arriving ? -lean : lean) * s->middle >= 0;
}

/* ---- the search ---- */

/* The place that each range of leans has reached at least. */
static int passed(const arc_search *s)
{
    int least = s->best[0];
    for (int i = 1; i < LEANS; i++)
        least = bat_min_int(least, s->best[i]);
    return least;
}

/* All that one arc reaches from a state. */
static batten_status go_on(arc_search *s, int index, int end, int *found)
{
    const arc_state a = s->states[index];
    const row from = row_at(s, a.place);
    leg l = leg_of(&from, a.lean);
    const int least = bat_max_int(a.place, passed(s));
    batten_biarc arc;
    arc_state b = {.parent = index};
    int range = 0;
    for (int i = bat_min_int(end, a.place + AHEAD); i > least && *found < 0; i--) {
        const row to = row_at(s, i);
        const bool last = i == end && !s->around;
        if (!aim(s, &l, &to, &b.lean, &range) ||
            (last ? !leads_in(s, b.lean, true) : i <= s->best[range]) ||
            !make_arc(s, &l, &arc) || !fits(s, &arc, a.place, i))
            continue;
        b.place = i;
        const batten_status status = add_state(s, &b, last ? found : &s->next[range]);
        if (status != BATTEN_OK)
            return status;
        s->best[range] = i;
    }
    return BATTEN_OK;
}

static batten_status take_rows(const arc_search *s, int from, int to, int step)
{
    bat_samples *samples = s->task->samples;
    const batten_status status = bat_samples_reserve(samples, (to - from) / step + 1);
    samples->count = 0;
    for (int i = from + step; i < to && status == BATTEN_OK; i += step) {
        const row r = row_at(s, i);
        samples->u[samples->count] = r.u;
        memcpy(samples->rows[samples->count], r.point, sizeof r.point);
        memcpy(samples->rows[samples->count++] + 2, r.direction, sizeof r.direction);
    }
    return status;
}

/* Do both arcs of a biarc bend as the curve? The joint is about where their lengths say. */
static bool both_bend_alike(const arc_search *s, const batten_biarc *biarc, const arc_state *a,
                            int end, double lean)
{
    const batten_span *arc = biarc->arcs;
    const row to = row_at(s, end);
    for (int i = 0; i < biarc->count; i++)
        if (!may_bend(s, arc[i].curvature[0]))
            return false;
    if (biarc->count == 1)
        return bends_alike(s, a->lean, &to, lean, arc[0].length);
    const double share = arc[0].length / (arc[0].length + arc[1].length);
    const row joint = row_at(s, a->place + (int)((end - a->place) * share));
    const double between = remainder(arc[1].angle - joint.angle, 2 * BAT_PI);
    return bends_alike(s, a->lean, &joint, between, arc[0].length) &&
           bends_alike(s, between, &to, lean, arc[1].length);
}

/* From a state around to the given lean at the end by two arcs: at first with a few looks. */
static batten_status close_by_two(arc_search *s, int index, int end, double lean,
                                  bat_arcs_part *part, bool *closed)
{
    const arc_state *a = &s->states[index];
    const row from = row_at(s, a->place), to = row_at(s, end);
    const double before = from.angle + a->lean, after = to.angle + lean;
    const bat_node start = {{from.node[0], from.node[1]}, {cos(before), sin(before)}};
    const bat_node stop = {{to.node[0], to.node[1]}, {cos(after), sin(after)}};
    const bat_band band = {s->middle - s->half, s->middle + s->half, s->middle};
    *closed = end - a->place >= 2 && end - a->place <= 2 * AHEAD;
    for (int looks = 8; looks < 10 * LOOKS && *closed; looks *= 25) {
        const int step = bat_max_int(1, (end - a->place) / looks);
        const batten_status status = take_rows(s, a->place, end, step);
        if (status != BATTEN_OK)
            return status;
        *part = (bat_arcs_part){.from = from.u, .to = to.u};
        *closed = bat_arcs_biarc(&start, &stop, to.angle - from.angle, s->task->least_radius,
                                 &band, s->task->samples, &part->biarc);
        *closed = *closed && both_bend_alike(s, &part->biarc, a, end, lean);
        if (!*closed)
            break;
        bat_arcs_probe probe;
        bat_arcs_probe_make(&part->biarc, &probe);
        const bat_beside beside = bat_arcs_beside_samples(&probe, s->task->samples);
        *closed = bat_band_share(&band, &beside, s->task->slack) <= s->shrink;
    }
    return BATTEN_OK;
}

/* The first of the states that can be closed by two arcs. */
static batten_status close_one(arc_search *s, int end, double lean, bat_arcs_part *part,
                               int *found)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < LEANS && *found < 0 && status == BATTEN_OK; i++) {
        bool closed = false;
        if (s->now[i] >= 0)
            status = close_by_two(s, s->now[i], end, lean, part, &closed);
        if (closed)
            *found = s->now[i];
    }
    return status;
}

/* States that all begin at one place: one with a given lean, or one in each range. */
static batten_status begin_states(arc_search *s, int place, const double *lean)
{
    s->state_count = 0;
    const double reach = s->rows[place].reach;
    for (int i = 0; i < LEANS; i++) {
        s->best[i] = s->now[i] = -1;
        const arc_state a = {place, -1, (i - LEANS / 2) * step_of_leans * s->half / reach};
        if (lean || !leads_in(s, a.lean, false) || fabs(a.lean) >= most_lean)
            continue;
        const batten_status status = add_state(s, &a, &s->now[i]);
        if (status != BATTEN_OK)
            return status;
    }
    const arc_state given = {place, -1, lean ? *lean : 0};
    return lean ? add_state(s, &given, &s->now[LEANS / 2]) : BATTEN_OK;
}

/* The last state of the fewest arcs from `start` to `end`; around, `closing` are two more.
 * *found is -1 when there are none, or no fewer than `most` arcs. */
static batten_status find_fewest_arcs(arc_search *s, int start, int end, const double *lean,
                                      int most, bat_arcs_part *closing, int *arcs, int *found)
{
    *found = -1;
    batten_status status = begin_states(s, start, lean);
    for (int n = 0; status == BATTEN_OK; n++) {
        bool alive = false;
        if (lean)
            status = close_one(s, end, *lean, closing, found);
        *arcs = n + 2;
        if (*found >= 0 || *arcs >= most)
            break;
        for (int i = 0; i < LEANS; i++)
            s->next[i] = -1;
        for (int i = 0; i < LEANS && *found < 0 && status == BATTEN_OK; i++)
            if (s->now[i] >= 0)
                status = go_on(s, s->now[i], end, found);
        *arcs = n + 1;
        for (int i = 0; i < LEANS; i++)
            alive = alive || s->next[i] >= 0;
        memcpy(s->now, s->next, sizeof s->now);
        if (*found >= 0 || !alive)
            break;
    }
    return status;
}

/* ---- what was found ---- */

static batten_status put_smooth_arcs(const arc_search *s, int found,
                                     const bat_arcs_part *closing, bat_arcs_list *list)
{
    int count = 0;
    for (int i = found; s->states[i].parent >= 0; i = s->states[i].parent)
        count++;
    const int first = list->count;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        status = bat_arcs_list_add(list, closing);
    for (int i = found; count-- > 0 && status == BATTEN_OK; i = s->states[i].parent) {
        const arc_state *b = &s->states[i], *a = &s->states[b->parent];
        const row from = row_at(s, a->place), to = row_at(s, b->place);
        bat_arcs_part *part = &list->parts[first + count];
        leg l = leg_of(&from, a->lean);
        double lean = 0;
        int range = 0;
        *part = (bat_arcs_part){.from = from.u, .to = to.u};
        aim(s, &l, &to, &lean, &range);
        make_arc(s, &l, &part->biarc);
    }
    if (status == BATTEN_OK && s->around)
        status = bat_arcs_list_add(list, closing);
    return status;
}

/* The share of the band that the arcs truly take. */
static batten_status measure_band_share(const arc_search *s, const bat_arcs_list *list,
                                        int first, double *share)
{
    const bat_arcs_smooth *t = s->task;
    const bat_band band = {s->middle - s->half, s->middle + s->half, s->middle};
    *share = 0;
    for (int i = first; i < list->count; i++) {
        double ranges[2][2];
        const int count = bat_arcs_ranges(t->path, &list->parts[i], ranges);
        for (int k = 0; k < count; k++) {
            bat_beside beside = {0, 0, 0, 0};
            batten_status status =
                bat_arcs_take(t->path, ranges[k][0], ranges[k][1], 8, 32, t->samples);
            if (status == BATTEN_OK)
                status = bat_arcs_measure(t->path, &list->parts[i].biarc, t->samples, &beside);
            if (status != BATTEN_OK)
                return status;
            *share = bat_max(*share, bat_band_share(&band, &beside, t->slack));
        }
    }
    return BATTEN_OK;
}

/* Places and leans to begin with, from the states of a run that could begin with any lean:
 * those on the way of its fewest arcs, and others of any lean along a few arcs. The number of
 * its arcs, which none that closes goes below. */
static int find_starts(const arc_search *s, int room, arc_state *starts, int *arcs)
{
    int farthest = 0, count = 0, others = 0;
    const int from = s->count / 4, to = from + 2 * FINE;
    for (int i = 0; i < s->state_count; i++) {
        if (s->states[i].place > s->states[farthest].place)
            farthest = i;
        others += s->states[i].place >= from && s->states[i].place < to;
    }
    *arcs = 0;
    for (int i = s->states[farthest].parent; i >= 0; i = s->states[i].parent, ++*arcs)
        if (count < bat_min_int(room, 12))
            starts[count++] = s->states[i];
    const int step = 1 + others / bat_max_int(1, room - count);
    for (int i = 0; i < s->state_count && count < room; i++)
        if (s->states[i].place >= from && s->states[i].place < to && others++ % step == 0)
            starts[count++] = s->states[i];
    return count;
}

/* Around from each of some starts, until the number of arcs is no more than `least`. */
static batten_status try_starts(arc_search *s, int count, const arc_state *starts, int least,
                                bat_arcs_list *list)
{
    const int first = list->count;
    bat_arcs_part closing;
    batten_status status = BATTEN_OK;
    s->start_arcs = INT_MAX;
    for (int i = 0; i < count && status == BATTEN_OK && s->start_arcs > least; i++) {
        const int place = starts[i].place;
        int found = -1, arcs = 0;
        status = find_fewest_arcs(s, place, place + s->count, &starts[i].lean, s->start_arcs,
                                  &closing, &arcs, &found);
        if (status != BATTEN_OK || found < 0)
            continue;
        s->start = starts[i];
        s->start_arcs = arcs;
        list->count = first;
        status = put_smooth_arcs(s, found, &closing, list);
    }
    return status;
}

/* Around a closed curve: where the first arc begins matters. What was best in a wider band is
 * tried at first. */
static batten_status run_around(arc_search *s, bat_arcs_list *list)
{
    enum { TRIES = 24, WORK = 1200 };
    /* With many arcs one more does not matter, and each try takes long. */
    const int room = bat_max_int(1, bat_min_int(TRIES, WORK / s->task->guide->count));
    arc_state starts[TRIES] = {s->start};
    const int before = s->start_arcs, first = list->count;
    int found = -1, arcs = 0, least = 0;
    batten_status status = BATTEN_OK;
    if (before > 0 && before < INT_MAX)
        status = try_starts(s, 1, starts, before, list);
    if (status != BATTEN_OK || (before > 0 && s->start_arcs <= before))
        return status;
    list->count = first;
    status = find_fewest_arcs(s, 0, s->count, NULL, INT_MAX, NULL, &arcs, &found);
    if (status != BATTEN_OK)
        return status;
    const int tries = find_starts(s, room, starts, &least);
    return try_starts(s, tries, starts, bat_max_int(least, s->task->enough), list);
}

static batten_status find(arc_search *s, bat_arcs_list *list)
{
    if (s->around)
        return run_around(s, list);
    int arcs = 0, found = -1;
    const bat_arcs_part none = {0};
    const batten_status status =
        find_fewest_arcs(s, 0, s->count, NULL, INT_MAX, NULL, &arcs, &found);
    return status == BATTEN_OK && found >= 0 ? put_smooth_arcs(s, found, &none, list) : status;
}

/* Round by round in a slightly narrower band, until the arcs are within the whole one. */
static batten_status search_with(arc_search *s, double excess, bat_arcs_list *list)
{
    enum { ROUNDS = 8 };
    const int first = list->count;
    double share = HUGE_VAL;
    batten_status status = BATTEN_OK;
    s->excess = excess;
    s->shrink = 1;
    s->start_arcs = 0;
    for (int i = 0; i < ROUNDS && status == BATTEN_OK && share > 1; i++) {
        list->count = first;
        status = find(s, list);
        if (status != BATTEN_OK || list->count == first)
            return status;
        status = measure_band_share(s, list, first, &share);
        s->shrink *= 0.9998 - 2 * bat_max(0, share - 1);
    }
    if (share > 1)
        list->count = first;
    return status;
}

batten_status bat_arcs_smooth_run(const bat_arcs_smooth *task, bat_arcs_list *list)
{
    const bat_band *band = &task->band;
    arc_search s = {.task = task,
                    .half = (band->high - band->low) / 2,
                    .middle = band->middle,
                    .held = band->middle != 0 && !task->path->smooth_seam,
                    .around = task->path->smooth_seam};
    const int first = list->count;
    if (task->guide->count > MOST_ARCS)
        return BATTEN_OK;
    batten_status status = make_rows(&s);
    if (status == BATTEN_OK)
        status = search_with(&s, 30, list);
    /* A few arcs in a wide band differ more from the curve. */
    if (status == BATTEN_OK && list->count == first)
        status = search_with(&s, HUGE_VAL, list);
    bat_release(s.rows);
    bat_release(s.states);
    return status;
}
