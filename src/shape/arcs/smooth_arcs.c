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
#include "shape/arcs/smooth_step.h"

#include <limits.h>
#include <string.h>

enum {
    AHEAD = 250, /* places that are tried, beyond what any arc reaches */
    MOST_ARCS = 10000
};

/* ---- the search ---- */

/* The place that each range of leans has reached at least. */
static int passed(const bat_arc_search *s)
{
    int least = s->best[0];
    for (int i = 1; i < BAT_SMOOTH_LEANS; i++)
        least = bat_min_int(least, s->best[i]);
    return least;
}

static batten_status ask_at(const bat_arc_search *s, int place)
{
    return bat_work_step(s->task->work, 1, bat_min(1, (double)place / s->count),
                         "arcs that are tangent");
}

/* All that one arc reaches from a state. */
static batten_status go_on(bat_arc_search *s, int index, int end, int *found)
{
    const bat_arc_state a = s->states[index];
    const bat_smooth_row from = bat_smooth_row_at(s, a.place);
    bat_smooth_leg l = bat_smooth_leg_of(&from, a.lean);
    const int least = bat_max_int(a.place, passed(s));
    batten_biarc arc;
    bat_arc_state b = {.parent = index};
    int range = 0;
    for (int i = bat_min_int(end, a.place + AHEAD); i > least && *found < 0; i--) {
        const bat_smooth_row to = bat_smooth_row_at(s, i);
        const bool last = i == end && !s->around;
        if (!bat_smooth_aim(s, &l, &to, &b.lean, &range) ||
            (last ? !bat_smooth_leads_in(s, b.lean, true) : i <= s->best[range]) ||
            !bat_smooth_arc(s, &l, &arc) || !bat_smooth_fits(s, &arc, a.place, i))
            continue;
        b.place = i;
        const batten_status status = bat_smooth_add(s, &b, last ? found : &s->next[range]);
        if (status != BATTEN_OK)
            return status;
        s->best[range] = i;
    }
    return BATTEN_OK;
}

static batten_status take_rows(const bat_arc_search *s, int from, int to, int step)
{
    bat_samples *samples = s->task->samples;
    const batten_status status = bat_samples_reserve(samples, (to - from) / step + 1);
    samples->count = 0;
    for (int i = from + step; i < to && status == BATTEN_OK; i += step) {
        const bat_smooth_row r = bat_smooth_row_at(s, i);
        samples->u[samples->count] = r.u;
        memcpy(samples->rows[samples->count], r.point, sizeof r.point);
        memcpy(samples->rows[samples->count++] + 2, r.direction, sizeof r.direction);
    }
    return status;
}

/* Do both arcs of a biarc bend as the curve? The joint is about where their lengths say. */
static bool both_bend_alike(const bat_arc_search *s, const batten_biarc *biarc,
                            const bat_arc_state *a, const bat_arc_state *b)
{
    const batten_span *arc = biarc->arcs;
    const int end = b->place;
    const double lean = b->lean;
    const bat_smooth_row to = bat_smooth_row_at(s, end);
    for (int i = 0; i < biarc->count; i++)
        if (!bat_smooth_may_bend(s, arc[i].curvature[0]))
            return false;
    if (biarc->count == 1)
        return bat_smooth_bends_alike(s, a->lean, &to, lean, arc[0].length);
    const double share = arc[0].length / (arc[0].length + arc[1].length);
    const bat_smooth_row joint =
        bat_smooth_row_at(s, a->place + (int)((end - a->place) * share));
    const double between = remainder(arc[1].angle - joint.angle, 2 * BAT_PI);
    return bat_smooth_bends_alike(s, a->lean, &joint, between, arc[0].length) &&
           bat_smooth_bends_alike(s, between, &to, lean, arc[1].length);
}

static bat_node leaning_node(const bat_smooth_row *row, double lean)
{
    const double angle = row->angle + lean;
    return (bat_node){{row->node[0], row->node[1]}, {bat_cos(angle), bat_sin(angle)}};
}

/* From a state around to the given one at the end by two arcs: at first with a few looks. */
static batten_status close_by_two(bat_arc_search *s, int index, const bat_arc_state *b,
                                  bat_arcs_part *part, bool *closed)
{
    const bat_arc_state *a = &s->states[index];
    const int end = b->place;
    const bat_smooth_row from = bat_smooth_row_at(s, a->place), to = bat_smooth_row_at(s, end);
    const bat_node start = leaning_node(&from, a->lean), stop = leaning_node(&to, b->lean);
    const bat_band band = {s->middle - s->half, s->middle + s->half, s->middle};
    const bat_arcs_stretch on = {
        &start, &stop, to.angle - from.angle, s->task->least_radius, &band, s->task->samples};
    *closed = end - a->place >= 2 && end - a->place <= 2 * AHEAD;
    for (int looks = 8; looks < 10 * BAT_SMOOTH_LOOKS && *closed; looks *= 25) {
        const int step = bat_max_int(1, (end - a->place) / looks);
        const batten_status status = take_rows(s, a->place, end, step);
        if (status != BATTEN_OK)
            return status;
        *part = (bat_arcs_part){.from = from.u, .to = to.u};
        *closed = bat_arcs_biarc(&on, &part->biarc) && both_bend_alike(s, &part->biarc, a, b);
        if (!*closed)
            break;
        bat_arcs_probe probe;
        bat_arcs_probe_make(&part->biarc, &probe);
        const bat_beside beside = bat_arcs_beside_samples(&probe, s->task->samples);
        *closed = bat_band_share(&band, &beside, s->task->slack) <= s->shrink;
    }
    return BATTEN_OK;
}

/* A row of arcs: its last state, -1 when there is none, and how many arcs it has. */
typedef struct {
    int last, arcs;
    bat_arcs_part closing; /* around, of them the last two */
} arc_row;

/* The first of the states that can be closed by two arcs. */
static batten_status close_one(bat_arc_search *s, const bat_arc_state *end, arc_row *found)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < BAT_SMOOTH_LEANS && found->last < 0 && status == BATTEN_OK; i++) {
        bool closed = false;
        if (s->now[i] >= 0)
            status = close_by_two(s, s->now[i], end, &found->closing, &closed);
        if (closed)
            found->last = s->now[i];
    }
    return status;
}

/* States that all begin at one place: one with a given lean, or one in each range. */
static batten_status begin_states(bat_arc_search *s, int place, const double *lean)
{
    s->state_count = 0;
    const double reach = s->rows[place].reach;
    for (int i = 0; i < BAT_SMOOTH_LEANS; i++) {
        s->best[i] = s->now[i] = -1;
        const bat_arc_state a = {
            place, -1, (i - BAT_SMOOTH_LEANS / 2) * bat_step_of_leans * s->half / reach};
        if (lean || !bat_smooth_leads_in(s, a.lean, false) || fabs(a.lean) >= bat_most_lean)
            continue;
        const batten_status status = bat_smooth_add(s, &a, &s->now[i]);
        if (status != BATTEN_OK)
            return status;
    }
    const bat_arc_state given = {place, -1, lean ? *lean : 0};
    return lean ? bat_smooth_add(s, &given, &s->now[BAT_SMOOTH_LEANS / 2]) : BATTEN_OK;
}

/* One arc more from every state; is any of the new ones left? */
static batten_status go_on_from_all(bat_arc_search *s, int end, int *found, bool *alive)
{
    batten_status status = BATTEN_OK;
    *alive = false;
    for (int i = 0; i < BAT_SMOOTH_LEANS; i++)
        s->next[i] = -1;
    for (int i = 0; i < BAT_SMOOTH_LEANS && *found < 0 && status == BATTEN_OK; i++)
        if (s->now[i] >= 0) {
            status = ask_at(s, s->states[s->now[i]].place);
            if (status == BATTEN_OK)
                status = go_on(s, s->now[i], end, found);
        }
    for (int i = 0; i < BAT_SMOOTH_LEANS; i++)
        *alive = *alive || s->next[i] >= 0;
    memcpy(s->now, s->next, sizeof s->now);
    return status;
}

/* The fewest arcs along all rows from `start`, or around, beginning and ending with a lean;
 * none when as many as `most` are needed. */
static batten_status find_fewest_arcs(bat_arc_search *s, int start, const double *lean,
                                      int most, arc_row *out)
{
    const bat_arc_state end = {start + s->count, -1, lean ? *lean : 0};
    out->last = -1;
    batten_status status = begin_states(s, start, lean);
    for (int n = 0; status == BATTEN_OK; n++) {
        bool alive = false;
        if (lean)
            status = close_one(s, &end, out);
        out->arcs = n + 2;
        if (out->last >= 0 || out->arcs >= most)
            break;
        if (status == BATTEN_OK)
            status = go_on_from_all(s, end.place, &out->last, &alive);
        out->arcs = n + 1;
        if (out->last >= 0 || !alive)
            break;
    }
    return status;
}

/* ---- what was found ---- */

static batten_status put_smooth_arcs(const bat_arc_search *s, int found,
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
        const bat_arc_state *b = &s->states[i], *a = &s->states[b->parent];
        const bat_smooth_row from = bat_smooth_row_at(s, a->place),
                             to = bat_smooth_row_at(s, b->place);
        bat_arcs_part *part = &list->parts[first + count];
        bat_smooth_leg l = bat_smooth_leg_of(&from, a->lean);
        double lean = 0;
        int range = 0;
        *part = (bat_arcs_part){.from = from.u, .to = to.u};
        bat_smooth_aim(s, &l, &to, &lean, &range);
        bat_smooth_arc(s, &l, &part->biarc);
    }
    if (status == BATTEN_OK && s->around)
        status = bat_arcs_list_add(list, closing);
    return status;
}

/* The share of the band that the arcs truly take. */
static batten_status measure_band_share(const bat_arc_search *s, const bat_arcs_list *list,
                                        int first, double *share)
{
    const bat_arcs_smooth *t = s->task;
    const bat_band band = {s->middle - s->half, s->middle + s->half, s->middle};
    *share = 0;
    for (int i = first; i < list->count; i++) {
        batten_interval ranges[2];
        const int count = bat_arcs_ranges(t->path, &list->parts[i], ranges);
        for (int k = 0; k < count; k++) {
            bat_beside beside = {0, 0, 0, 0};
            batten_status status = bat_arcs_take(t->path, ranges[k], 8, 32, t->samples);
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
static int find_starts(const bat_arc_search *s, int room, bat_arc_state *starts, int *arcs)
{
    int farthest = 0, count = 0, others = 0;
    const int from = s->count / 4, to = from + 2 * BAT_SMOOTH_FINE;
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
static batten_status try_starts(bat_arc_search *s, int count, const bat_arc_state *starts,
                                int least, bat_arcs_list *list)
{
    const int first = list->count;
    batten_status status = BATTEN_OK;
    s->start_arcs = INT_MAX;
    for (int i = 0; i < count && status == BATTEN_OK && s->start_arcs > least; i++) {
        arc_row found;
        status = find_fewest_arcs(s, starts[i].place, &starts[i].lean, s->start_arcs, &found);
        if (status != BATTEN_OK || found.last < 0)
            continue;
        s->start = starts[i];
        s->start_arcs = found.arcs;
        list->count = first;
        status = put_smooth_arcs(s, found.last, &found.closing, list);
    }
    return status;
}

/* Around a closed curve: where the first arc begins matters. What was best in a wider band is
 * tried at first. */
static batten_status run_around(bat_arc_search *s, bat_arcs_list *list)
{
    enum { TRIES = 24, WORK = 1200 };
    /* With many arcs one more does not matter, and each try takes long. */
    const int room = bat_max_int(1, bat_min_int(TRIES, WORK / s->task->guide->count));
    bat_arc_state starts[TRIES] = {s->start};
    const int before = s->start_arcs, first = list->count;
    int least = 0;
    arc_row any;
    batten_status status = BATTEN_OK;
    if (before > 0 && before < INT_MAX)
        status = try_starts(s, 1, starts, before, list);
    if (status != BATTEN_OK || (before > 0 && s->start_arcs <= before))
        return status;
    list->count = first;
    status = find_fewest_arcs(s, 0, NULL, INT_MAX, &any);
    if (status != BATTEN_OK)
        return status;
    const int tries = find_starts(s, room, starts, &least);
    return try_starts(s, tries, starts, bat_max_int(least, s->task->enough), list);
}

static batten_status find(bat_arc_search *s, bat_arcs_list *list)
{
    if (s->around)
        return run_around(s, list);
    arc_row found = {.last = -1};
    const batten_status status = find_fewest_arcs(s, 0, NULL, INT_MAX, &found);
    if (status != BATTEN_OK || found.last < 0)
        return status;
    return put_smooth_arcs(s, found.last, &found.closing, list);
}

/* Round by round in a slightly narrower band, until the arcs are within the whole one. */
static batten_status search_with(bat_arc_search *s, double excess, bat_arcs_list *list)
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
    bat_arc_search s = {.task = task,
                        .half = (band->high - band->low) / 2,
                        .middle = band->middle,
                        .held = band->middle != 0 && !task->path->smooth_seam,
                        .around = task->path->smooth_seam};
    const int first = list->count;
    if (task->guide->count > MOST_ARCS)
        return BATTEN_OK;
    batten_status status = bat_smooth_rows(&s);
    if (status == BATTEN_OK)
        status = search_with(&s, 30, list);
    /* A few arcs in a wide band differ more from the curve. */
    if (status == BATTEN_OK && list->count == first)
        status = search_with(&s, HUGE_VAL, list);
    bat_release(s.rows);
    bat_release(s.states);
    return status;
}
