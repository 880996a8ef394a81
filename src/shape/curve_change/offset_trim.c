/*
 * The parts of an offset that stay, cut out and linked to curves; offset_judge.c decides which.
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
#include "shape/curve_change/offset_judge.h"
#include "spline/curve/curve.h"

#include <batten/nearest.h>
#include <string.h>

enum { HALVINGS = 50 };

/* ---- chaining ---- */

static void link_to(bat_offset_trimming *t, int i, int j)
{
    t->parts[i].next = j;
    t->parts[j].followed = true;
}

/* Parts without a next one are followed by one that begins there and follows no other. */
static void meet_ends(bat_offset_trimming *t)
{
    for (int i = 0; i < t->count; i++)
        for (int j = 0; t->parts[i].next < 0 && j < t->count; j++)
            if (!t->parts[j].followed &&
                bat_distance(2, t->parts[i].end, t->parts[j].start) <= t->near)
                link_to(t, i, j);
}

/* Does the end of part i, or the start, come to `target` when it is moved along its run? Then
 * it is, as long as the run is far enough there. */
static batten_status slide_end(bat_offset_trimming *t, int i, bool end, const double *target,
                               bool *met)
{
    bat_offset_part *p = &t->parts[i];
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
        status = bat_offset_distances(t, 1, point, &far);
    *met = *met && far >= bat_offset_excused(t);
    if (status == BATTEN_OK && *met) {
        *(end ? &p->b : &p->a) = u;
        memcpy(end ? p->end : p->start, point, sizeof point);
    }
    return status;
}

/* From part i to part j, by more or less of one of them. */
static batten_status close_gap(bat_offset_trimming *t, int i, int j)
{
    bool met;
    batten_status status = slide_end(t, i, true, t->parts[j].start, &met);
    if (status == BATTEN_OK && !met)
        status = slide_end(t, j, false, t->parts[i].end, &met);
    if (status == BATTEN_OK && met)
        link_to(t, i, j);
    return status;
}

/* Two sides of a loop narrower than the error of the pieces need not cross: where they run
 * beside each other one of the ends is moved to the other. */
static batten_status close_loops(bat_offset_trimming *t)
{
    const int n = t->count;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i + !t->o->closed < n; i++) {
        const int j = (i + 1) % n;
        if (t->parts[i].next < 0 && !t->parts[j].followed)
            status = close_gap(t, i, j);
    }
    return status;
}

/* Does part j, the next in the list, come next along the curve as well? */
static bool follows(const bat_offset_trimming *t, int i, int j)
{
    const bat_offset_part *p = &t->parts[i], *q = &t->parts[j];
    if (j == 0)
        return t->o->closed;
    return (p->run == q->run && p->b == q->a) || q->run == p->run + 1;
}

/* First along the way they came, then to whatever begins where a part ends. */
static batten_status link_parts(bat_offset_trimming *t)
{
    const int n = t->count;
    for (int i = 0; i < n; i++) {
        const int j = (i + 1) % n;
        if (follows(t, i, j) && bat_distance(2, t->parts[i].end, t->parts[j].start) <= t->near)
            link_to(t, i, j);
    }
    meet_ends(t);
    return close_loops(t);
}

/* A chain that comes back within the tolerance ends in the point in which it begins. */
static batten_status close_chain(const bat_offset_trimming *t, batten_curve **chain)
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
static batten_status make_chain(bat_offset_trimming *t, int first, batten_curve **out)
{
    batten_curve **pieces = bat_array((size_t)t->count, sizeof *pieces);
    if (!pieces)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    bool around = false;
    int count = 0;
    for (int i = first; status == BATTEN_OK && i >= 0;) {
        bat_offset_part *p = &t->parts[i];
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
static batten_status make_chains(bat_offset_trimming *t, batten_curves *out)
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
    bat_offset_trimming t = {.o = o,
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
        status = bat_offset_judge(&t, &crossings);
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
