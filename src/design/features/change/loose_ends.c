/* Curves in any order and direction, as they run end to end. */
#include "design/features/change/loose_ends.h"
#include "numeric/vector.h"

#include <string.h>

typedef struct {
    double ends[2][3];
    bool is_used;
} piece;

typedef struct {
    const bat_objects *all;
    double within;
    piece *pieces; /* [count] */
    bat_loose_report report;
    batten_curve *joined; /* so far */
    double ends[2][3];    /* of it, before gaps are closed */
} joining;

static batten_status find_ends(const batten_curve *curve, double ends[2][3])
{
    const batten_interval domain = batten_curve_domain(curve);
    batten_status status = BATTEN_OK;
    memset(ends, 0, 2 * sizeof *ends);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = batten_curve_evaluate(curve, k ? domain.b : domain.a, 0, ends[k]);
    return status;
}

/* The unused piece that has an end nearest to the point, and which end; -1 when none is near enough. */
static int find_next(joining *j, const double at[3], int *end)
{
    double nearest = j->within;
    int best = -1, near = 0;
    for (int i = 0; i < j->all->count; i++) {
        bool is_near = false;
        for (int k = 0; k < 2 && !j->pieces[i].is_used; k++) {
            const double gap = bat_distance(3, at, j->pieces[i].ends[k]);
            is_near |= gap <= j->within;
            if (gap > nearest || (best >= 0 && gap == nearest))
                continue;
            nearest = gap;
            best = i;
            *end = k;
        }
        near += is_near;
    }
    j->report.branches += near > 1;
    if (best >= 0)
        j->report.gap = bat_max(j->report.gap, nearest);
    return best;
}

static batten_status turn_when(bool is_turned, const batten_curve *curve, batten_curve **out)
{
    if (is_turned)
        return batten_curve_reverse(curve, out);
    *out = batten_curve_ref(curve);
    return BATTEN_OK;
}

/* Put a piece, which meets the joined curve with that end, behind it or before it. */
static batten_status attach(joining *j, int index, int end, bool behind)
{
    batten_curve *turned = NULL, *longer = NULL;
    piece *next = &j->pieces[index];
    batten_status status = turn_when((end == 1) == behind, j->all->at[index]->curve, &turned);
    if (status == BATTEN_OK)
        status = behind ? batten_curve_join(j->joined, turned, j->within, &longer)
                        : batten_curve_join(turned, j->joined, j->within, &longer);
    batten_curve_unref(turned);
    if (status != BATTEN_OK)
        return status;
    batten_curve_unref(j->joined);
    j->joined = longer;
    next->is_used = true;
    memcpy(j->ends[behind], next->ends[1 - end], sizeof j->ends[0]);
    return BATTEN_OK;
}

static bool is_closed(const joining *j)
{
    return bat_distance(3, j->ends[0], j->ends[1]) <= j->within;
}

/* From one piece on as far as there are others, at its end first, then at its start. */
static batten_status join_from(joining *j, int first)
{
    batten_status status = BATTEN_OK;
    j->joined = batten_curve_ref(j->all->at[first]->curve);
    memcpy(j->ends, j->pieces[first].ends, sizeof j->ends);
    j->pieces[first].is_used = true;
    for (int side = 1; side >= 0; side--)
        while (status == BATTEN_OK && !is_closed(j)) {
            int end = 0;
            const int next = find_next(j, j->ends[side], &end);
            if (next < 0)
                break;
            status = attach(j, next, end, side == 1);
        }
    if (status == BATTEN_OK && is_closed(j)) {
        j->report.closed++;
        j->report.gap = bat_max(j->report.gap, bat_distance(3, j->ends[0], j->ends[1]));
    }
    return status;
}

static batten_status join_all(joining *j, batten_curve **made)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < j->all->count; i++)
        status = find_ends(j->all->at[i]->curve, j->pieces[i].ends);
    for (int i = 0; status == BATTEN_OK && i < j->all->count; i++) {
        if (j->pieces[i].is_used)
            continue;
        status = join_from(j, i);
        made[j->report.chains++] = j->joined;
        j->joined = NULL;
    }
    return status;
}

batten_status bat_join_loose(const bat_objects *all, double within, batten_curves *out,
                             bat_loose_report *report)
{
    joining j = {.all = all, .within = within};
    batten_curve **made = bat_array((size_t)all->count, sizeof *made);
    j.pieces = bat_array((size_t)all->count, sizeof *j.pieces);
    batten_status status = made && j.pieces ? join_all(&j, made) : BATTEN_OUT_OF_MEMORY;
    bat_release(j.pieces);
    batten_curves joined = {j.report.chains, made};
    if (status == BATTEN_OK) {
        *out = joined;
        *report = j.report;
    } else {
        batten_curves_release(&joined);
    }
    return status;
}
