/* Loose curves in any order and direction, joined where their ends meet. */
#include "numeric/vector.h"
#include "shape/curve_change/loose_ends.h"
#include "spline/curve/curve.h"

#include <string.h>

typedef struct {
    const batten_curve_row *curves;
    bat_loose_ends ends;
    batten_curves_join_report report;
    int *order, *pieces; /* [count]: as they are handed over */
    bool *used;          /* [count] */
    batten_curve **made; /* [count] */
    int made_count, placed;
} joining;

/* ---- the way along a chain ---- */

static int other_end(int end)
{
    return end ^ 1;
}

/* Back from a curve to the first of its chain; the end at which the chain starts. A closed chain starts with the curve itself. */
static int find_start(const joining *j, int curve)
{
    int start = 2 * curve;
    while (j->ends.partner[start] >= 0) {
        start = other_end(j->ends.partner[start]);
        if (start == 2 * curve)
            break;
    }
    return start;
}

/* Curves as they run from an end on; the order counts from 1 and is negative for a turned one. */
static int follow_chain(joining *j, int start)
{
    int count = 0, end = start;
    do {
        j->order[j->placed + count++] = end % 2 ? -(end / 2 + 1) : end / 2 + 1;
        j->used[end / 2] = true;
        end = j->ends.partner[other_end(end)];
    } while (end >= 0 && end != start);
    return count;
}

/* ---- curves ---- */

/* Where an end goes: halfway to its partner. */
static void find_target(const joining *j, int end, double target[3])
{
    const int partner = j->ends.partner[end];
    for (int k = 0; k < 3; k++)
        target[k] = j->ends.at[end][k] / 2 + j->ends.at[partner][k] / 2;
}

static bool has_gap(const joining *j, int end)
{
    const int partner = j->ends.partner[end];
    return partner >= 0 &&
           memcmp(j->ends.at[end], j->ends.at[partner], sizeof *j->ends.at) != 0;
}

/* The curve as it is, clamped and with both ends where they meet others. */
static batten_status move_ends(const joining *j, int curve, batten_curve **out)
{
    batten_curve *clamped = NULL, *moved = NULL;
    if (!has_gap(j, 2 * curve) && !has_gap(j, 2 * curve + 1)) {
        *out = batten_curve_ref(j->curves->at[curve]);
        return BATTEN_OK;
    }
    batten_status status = batten_curve_clamp(j->curves->at[curve], &clamped);
    if (status == BATTEN_OK)
        status = bat_curve_copy(clamped, &moved);
    batten_curve_unref(clamped);
    for (int side = 0; side < 2 && status == BATTEN_OK; side++) {
        double target[3];
        if (!has_gap(j, 2 * curve + side))
            continue;
        find_target(j, 2 * curve + side, target);
        const size_t d = (size_t)moved->dimension, last = (size_t)moved->count - 1;
        memcpy(moved->points + (side ? last * d : 0), target, d * sizeof *target);
    }
    return status == BATTEN_OK ? bat_curve_finish(moved, out) : status;
}

static batten_status make_piece(const joining *j, int order, batten_curve **out)
{
    batten_curve *moved = NULL;
    batten_status status = move_ends(j, (order > 0 ? order : -order) - 1, &moved);
    if (status != BATTEN_OK || order > 0) {
        *out = moved;
        return status;
    }
    status = batten_curve_reverse(moved, out);
    batten_curve_unref(moved);
    return status;
}

/* Moved ends agree to rounding: midpoints of the same two numbers. */
static batten_status make_chain(joining *j, int count, batten_curve **out)
{
    batten_curve **pieces = bat_array((size_t)count, sizeof *pieces);
    batten_status status = pieces ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        status = make_piece(j, j->order[j->placed + i], &pieces[i]);
    if (status == BATTEN_OK)
        status = bat_curves_chain(count, pieces, 0, out);
    for (int i = 0; pieces && i < count; i++)
        batten_curve_unref(pieces[i]);
    bat_release(pieces);
    return status;
}

/* ---- the whole ---- */

static batten_status make_chains(joining *j)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < j->curves->count && status == BATTEN_OK; i++) {
        if (j->used[i])
            continue;
        const int start = find_start(j, i);
        const int count = follow_chain(j, start);
        status = make_chain(j, count, &j->made[j->made_count]);
        if (status != BATTEN_OK)
            break;
        j->report.closed += j->ends.partner[start] >= 0;
        j->pieces[j->made_count++] = count;
        j->placed += count;
    }
    return status;
}

static void find_gaps(joining *j)
{
    for (int end = 0; end < 2 * j->ends.count; end++) {
        const int partner = j->ends.partner[end];
        j->report.branches += j->ends.several[end] > 1;
        if (partner < end || !has_gap(j, end))
            continue;
        const double gap = bat_distance(3, j->ends.at[end], j->ends.at[partner]);
        j->report.gaps++;
        if (gap <= j->report.gap)
            continue;
        j->report.gap = gap;
        find_target(j, end, j->report.at);
    }
}

static batten_status join_curves(joining *j, double tolerance)
{
    const size_t count = (size_t)j->curves->count;
    j->order = bat_array(count, sizeof *j->order);
    j->pieces = bat_array(count, sizeof *j->pieces);
    j->used = bat_array(count, sizeof *j->used);
    j->made = bat_array(count, sizeof *j->made);
    batten_status status = j->order && j->pieces && j->used && j->made
                               ? bat_loose_ends_link(j->curves, tolerance, &j->ends)
                               : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = make_chains(j);
    if (status == BATTEN_OK)
        find_gaps(j);
    return status;
}

static void give_order(joining *j, int *order, int *pieces)
{
    if (order)
        memcpy(order, j->order, (size_t)j->curves->count * sizeof *order);
    if (pieces)
        memcpy(pieces, j->pieces, (size_t)j->made_count * sizeof *pieces);
}

batten_status batten_curves_join(const batten_curve_row *curves, double tolerance, int *order,
                                 int *pieces, batten_curves_join_report *report,
                                 batten_curves *out)
{
    assert(curves && out);
    if (!(tolerance >= 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g; it must be 0 or more",
                        tolerance);
    if (curves->count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there are no curves to join");
    joining j = {.curves = curves};
    batten_status status = join_curves(&j, tolerance);
    batten_curves made = {j.made_count, j.made};
    if (status == BATTEN_OK) {
        give_order(&j, order, pieces);
        *out = made;
        if (report)
            *report = j.report;
    } else {
        batten_curves_release(&made);
    }
    bat_release(j.order);
    bat_release(j.pieces);
    bat_release(j.used);
    bat_loose_ends_release(&j.ends);
    return status;
}
