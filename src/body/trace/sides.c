/* Which way loops run, which is the outer one, and what becomes of a face. */
#include "body/border.h"
#include "body/trace/trace.h"
#include "numeric/vector.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- measures of loops ---- */

void bat_trace_winding(const bat_trace_face *face, const bat_trace_loops *loops, int loop,
                       int turns[2])
{
    const bat_trace_use *uses = loops->uses + loops->loops[loop].first;
    double a[2], b[2];
    bat_trace_end_of(&uses[0], false, a);
    bat_trace_end_of(&uses[loops->loops[loop].count - 1], true, b);
    for (int k = 0; k < 2; k++) {
        const double around = nearbyint((b[k] - a[k]) / face->chart.period[k]);
        /* No loop goes around a million times; what is damaged may, and must fit an int. */
        turns[k] = face->chart.closed[k] ? (int)bat_max(-1e6, bat_min(1e6, around)) : 0;
    }
}

/* Twice the area between a use and the origin, as a polygon of samples. */
static batten_status use_area(const bat_trace_use *use, const double origin[2], double *sum)
{
    enum { EACH = 8 };
    const int spans = batten_curve_spans(use->curve, NULL) - 1;
    double *breaks = bat_array((size_t)spans + 1, sizeof *breaks);
    double before[2], here[2], area = 0;
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    batten_curve_spans(use->curve, breaks);
    const int each = batten_curve_degree(use->curve) == 1 ? 1 : EACH;
    for (int i = 0; status == BATTEN_OK && i <= spans * each; i++) {
        const int span = bat_min_int(i / each, spans - 1), part = i - span * each;
        const double a = breaks[span], b = breaks[span + 1];
        status = batten_curve_evaluate(use->curve, part == each ? b : a + (b - a) * part / each,
                                       0, here);
        for (int k = 0; k < 2; k++)
            here[k] -= origin[k];
        if (i)
            area += before[0] * here[1] - before[1] * here[0];
        memcpy(before, here, sizeof before);
    }
    bat_release(breaks);
    *sum += use->reversed ? -area : area;
    return status;
}

/* Of a loop that makes no turn around the surface. */
static batten_status find_loop_area(const bat_trace_loops *loops, int loop, double *area)
{
    const bat_trace_use *uses = loops->uses + loops->loops[loop].first;
    double origin[2], sum = 0;
    batten_status status = BATTEN_OK;
    bat_trace_end_of(&uses[0], false, origin);
    for (int i = 0; status == BATTEN_OK && i < loops->loops[loop].count; i++)
        status = use_area(&uses[i], origin, &sum);
    *area = sum / 2;
    return status;
}

/* ---- the right way around ---- */

/* Add this face's uses to the balance of their edges, `sign` times. */
static void count_uses(const bat_trace *trace, const bat_trace_face *face, int sign)
{
    const batten_body_parts *p = trace->from;
    const batten_body_face *f = &p->faces[face->from];
    for (int l = f->first; l < f->first + f->count; l++)
        for (int i = p->loops[l].first; i < p->loops[l].first + p->loops[l].count; i++)
            trace->balance[p->uses[i].edge] += p->uses[i].reversed ? -sign : sign;
}

/* Each neighbour that uses an edge the other way is for it. */
static int count_votes(const bat_trace *trace, const bat_trace_face *face)
{
    const batten_body_parts *p = trace->from;
    const batten_body_face *f = &p->faces[face->from];
    int votes = 0;
    for (int l = f->first; l < f->first + f->count; l++)
        for (int i = p->loops[l].first; i < p->loops[l].first + p->loops[l].count; i++) {
            const int others = trace->balance[p->uses[i].edge];
            votes += p->uses[i].reversed ? others : -others;
        }
    return votes;
}

/* Do the neighbours say that the loops are right, and so the side is wrong? */
static bool side_is_wrong(const bat_trace *trace, const bat_trace_face *face)
{
    count_uses(trace, face, -1);
    const int votes = count_votes(trace, face);
    count_uses(trace, face, 1);
    return votes > 0;
}

static void turn_all(bat_trace *trace, bat_trace_face *face)
{
    for (int i = 0; i < face->loops.loop_count; i++)
        bat_trace_turn(&face->loops, i);
    if (side_is_wrong(trace, face)) {
        face->reversed = !face->reversed;
        bat_trace_note(trace, face,
                       "its loops run clockwise as seen from its outside; its outside was "
                       "turned, for its neighbours agree with the loops");
    } else {
        bat_trace_note(trace, face,
                       "its loops run clockwise as seen from its outside; they were turned");
    }
}

static int by_number(const void *a, const void *b)
{
    const int x = *(const int *)a, y = *(const int *)b;
    return (x > y) - (x < y);
}

/* Are all edges of the loop seams, gone along once each way? */
static batten_status is_all_seams(const bat_trace *trace, const bat_trace_face *face, int loop,
                                  bool *is)
{
    const batten_body_loop range = face->loops.loops[loop];
    int *edges = bat_array((size_t)range.count, sizeof *edges), sum = 0;
    if (!edges)
        return BATTEN_OUT_OF_MEMORY;
    int count = 0;
    for (int i = range.first; i < range.first + range.count; i++) {
        const bat_trace_use *use = &face->loops.uses[i];
        if (trace->builder.parts.edges[use->edge].curve)
            edges[count++] = use->reversed ? -1 - use->edge : use->edge;
    }
    qsort(edges, (size_t)count, sizeof *edges, by_number);
    /* Those against their edges come first, the last of the edges leading. */
    for (int i = 0; i < count; i++)
        sum += edges[i] < 0;
    *is = count > 0 && 2 * sum == count;
    for (int i = 0; *is && i < sum; i++)
        *is = edges[sum - 1 - i] == -1 - edges[sum + i];
    bat_release(edges);
    return BATTEN_OK;
}

/* Is the loop the border of the whole of a surface without an end, cut open along seams? Which
 * way it runs says nothing then: where all its edges begin and end in one vertex, files may
 * give them in an order that is another way around. Where the two sides of a seam are edges of
 * their own, it shows in the area: a hole so large would leave nothing. */
static batten_status is_cut_open(const bat_trace *trace, const bat_trace_face *face, int loop,
                                 double area, bool *is)
{
    const bat_chart *chart = &face->chart;
    const double all = chart->period[0] * chart->period[1];
    const double little =
        2 * (chart->near[0] * chart->period[1] + chart->near[1] * chart->period[0]);
    *is = chart->complete && fabs(fabs(area) - all) <= little;
    if (*is || !(chart->complete && fabs(area) > all / 2))
        return BATTEN_OK;
    return is_all_seams(trace, face, loop, is);
}

/* Loops that make no turn: the largest is the outer one, and runs counter-clockwise. */
static batten_status right_plain(bat_trace *trace, bat_trace_face *face)
{
    bat_trace_loops *loops = &face->loops;
    double *areas = bat_array((size_t)loops->loop_count, sizeof *areas);
    int outer = 0;
    batten_status status = areas ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < loops->loop_count; i++) {
        status = find_loop_area(loops, i, &areas[i]);
        if (status == BATTEN_OK && fabs(areas[i]) > fabs(areas[outer]))
            outer = i;
    }
    bool any = false;
    for (int i = 0; status == BATTEN_OK && i < loops->loop_count; i++)
        any = any || areas[i] > 0;
    bool open = false;
    if (status == BATTEN_OK && !any)
        status = is_cut_open(trace, face, outer, areas[outer], &open);
    /* All are holes of a surface without an end. */
    const bool is_all = !any && face->chart.complete && !open;
    if (status == BATTEN_OK && open) {
        bat_trace_turn(loops, outer);
        areas[outer] = -areas[outer];
    }
    if (status == BATTEN_OK && !is_all && areas[outer] < 0) {
        turn_all(trace, face);
        for (int i = 0; i < loops->loop_count; i++)
            areas[i] = -areas[i];
    }
    for (int i = 0; status == BATTEN_OK && !is_all && i < loops->loop_count; i++)
        if (i != outer && areas[i] > 0) {
            bat_trace_turn(loops, i);
            bat_trace_note(trace, face, "a hole runs counter-clockwise; it was turned");
        }
    bat_release(areas);
    return status;
}

/* With one loop around in direction k: does its left lie towards a rim, with a pole on the
 * other side? */
static bool leads_to_rim(const bat_trace_face *face, int k, int turns)
{
    const bool *pole = face->chart.pole;
    const int low = k ? 3 : 0, high = k ? 1 : 2; /* the sides across */
    if (face->chart.closed[1 - k])
        return false;
    /* Along u its left is above, along v below. */
    const bool left_is_high = (turns > 0) == (k == 0);
    return left_is_high ? !pole[high] && pole[low] : !pole[low] && pole[high];
}

/* The loops around direction k: of two the lower has to have its left above, and so on. */
static batten_status right_winding(bat_trace *trace, bat_trace_face *face, int k)
{
    bat_trace_loops *loops = &face->loops;
    int around[2] = {-1, -1}, turn[2] = {0, 0}, count = 0;
    for (int i = 0; i < loops->loop_count; i++) {
        int turns[2];
        bat_trace_winding(face, loops, i, turns);
        if (turns[k] == 0)
            continue;
        if (count < 2) {
            around[count] = i;
            turn[count] = turns[k];
        }
        count++;
    }
    if (count == 1 && leads_to_rim(face, k, turn[0]))
        turn_all(trace, face);
    if (count != 2 || face->chart.closed[1 - k])
        return BATTEN_OK;
    double at[2][2];
    for (int i = 0; i < 2; i++)
        bat_trace_end_of(&loops->uses[loops->loops[around[i]].first], false, at[i]);
    const int low = (at[0][1 - k] < at[1][1 - k]) ? 0 : 1;
    const int wanted = k == 0 ? 1 : -1; /* of the lower */
    const bool low_wrong = (turn[low] > 0) != (wanted > 0);
    const bool high_wrong = (turn[1 - low] > 0) == (wanted > 0);
    if (low_wrong && high_wrong) {
        turn_all(trace, face);
    } else if (low_wrong || high_wrong) {
        bat_trace_turn(loops, around[low_wrong ? low : 1 - low]);
        bat_trace_note(trace, face, "its two loops run around it the same way; one was turned");
    }
    return BATTEN_OK;
}

/* Which parameters a loop runs around in. */
static void find_windings(const bat_trace_face *face, bool winds[2])
{
    for (int i = 0; i < face->loops.loop_count; i++) {
        int turns[2];
        bat_trace_winding(face, &face->loops, i, turns);
        for (int k = 0; k < 2; k++)
            winds[k] = winds[k] || turns[k] != 0;
    }
}

batten_status bat_trace_right(bat_trace *trace, bat_trace_face *face)
{
    bool winds[2] = {false, false};
    find_windings(face, winds);
    if (face->loops.loop_count == 0 || (winds[0] && winds[1]))
        return BATTEN_OK;
    if (!winds[0] && !winds[1])
        return right_plain(trace, face);
    return right_winding(trace, face, winds[0] ? 0 : 1);
}

/* ---- what became of it ---- */

static batten_status put_loop(bat_trace *trace, const bat_trace_face *face, int loop)
{
    const batten_body_loop *range = &face->loops.loops[loop];
    batten_status status = bat_builder_loop(&trace->builder);
    for (int i = 0; status == BATTEN_OK && i < range->count; i++) {
        const int k = face->reversed ? range->count - 1 - i : i;
        const bat_trace_use *use = &face->loops.uses[range->first + k];
        status = bat_builder_use(&trace->builder, use->edge, use->reversed != face->reversed,
                                 use->curve);
    }
    return status;
}

/* Is the start of loop `inner` inside loop `outer`? By crossings of a ray with samples. */
static batten_status is_inside(const bat_trace_loops *loops, int inner, int outer, bool *inside)
{
    enum { EACH = 8 };
    const batten_body_loop *range = &loops->loops[outer];
    double q[2], a[2], b[2];
    batten_status status = BATTEN_OK;
    bat_trace_end_of(&loops->uses[loops->loops[inner].first], false, q);
    *inside = false;
    for (int i = 0; status == BATTEN_OK && i < range->count; i++) {
        const batten_curve *curve = loops->uses[range->first + i].curve;
        const batten_interval on = batten_curve_domain(curve);
        const int steps = EACH * (batten_curve_spans(curve, NULL) - 1);
        status = batten_curve_evaluate(curve, on.a, 0, a);
        for (int k = 1; status == BATTEN_OK && k <= steps; k++) {
            status = batten_curve_evaluate(
                curve, k < steps ? on.a + (on.b - on.a) * k / steps : on.b, 0, b);
            if ((a[1] > q[1]) != (b[1] > q[1]) &&
                q[0] < a[0] + (q[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
                *inside = !*inside;
            memcpy(a, b, sizeof a);
        }
    }
    return status;
}

/* The face that has outer loop `outer` (-1: the border of the surface) and the holes in it. */
static batten_status put_face(bat_trace *trace, const bat_trace_face *face, const double *areas,
                              int outer, bool only)
{
    batten_body_face made = trace->from->faces[face->from];
    made.surface = face->chart.surface;
    made.reversed = face->reversed;
    batten_status status = bat_builder_face(&trace->builder, &made);
    if (status == BATTEN_OK && outer >= 0)
        status = put_loop(trace, face, outer);
    if (status == BATTEN_OK && outer < 0) {
        bat_border_count count = {0};
        status = bat_border_loop(&trace->builder, face->chart.surface, face->reversed,
                                 trace->tolerance, &count);
        trace->report.seams += count.seams;
        trace->report.poles += count.poles;
    }
    for (int i = 0; status == BATTEN_OK && i < face->loops.loop_count; i++) {
        bool inside = areas[i] <= 0;
        if (inside && !only)
            status = is_inside(&face->loops, i, outer, &inside);
        if (status == BATTEN_OK && inside)
            status = put_loop(trace, face, i);
    }
    return status;
}

batten_status bat_trace_put(bat_trace *trace, bat_trace_face *face)
{
    const int n = face->loops.loop_count;
    double *areas = bat_array((size_t)n, sizeof *areas);
    int outer = 0;
    batten_status status = areas ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n; i++) {
        status = find_loop_area(&face->loops, i, &areas[i]);
        outer += areas[i] > 0;
    }
    if (status == BATTEN_OK && outer == 0 && n && !face->chart.complete)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET, "its outer loop holds no area");
    if (status == BATTEN_OK && outer == 0)
        status = put_face(trace, face, areas, -1, true);
    for (int i = 0; status == BATTEN_OK && outer && i < n; i++)
        if (areas[i] > 0)
            status = put_face(trace, face, areas, i, outer == 1);
    trace->report.rims += status == BATTEN_OK ? face->rims : 0;
    bat_release(areas);
    return status;
}
