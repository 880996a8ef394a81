/*
 * Loops closed along the cut of a surface.
 *
 * Cut at u = s + whole periods, the covering plane falls into cells. Each use lies in one of
 * them; where a loop goes on into the next it crosses the cut. There it is opened: a use that
 * leaves the cell on the right is followed, with the face on its left, up along the right side
 * to the next crossing, which enters there; one that leaves on the left down along the left
 * side. What lies between two such crossings is a seam: an edge that is used on both sides.
 * Where there is no next crossing, the seam ends at the border of the surface, at a pole or a
 * rim, which is used from side to side. The same with v: there s = -u takes the place of v.
 */
#include "body/trace/relink.h"
#include "body/trace/parameters.h"
#include "numeric/vector.h"

#include <stdlib.h>

/* ---- cells ---- */

/* So many turns around a surface are no loop of a face any more. */
enum { MOST_TURNS = 1000000 };

/* The cell of a use: by the sample that is farthest from the lines; when all are on one, the
 * face on its left decides. */
static batten_status cell_of(const bat_relink *r, const bat_trace_use *use, int *cell)
{
    enum { STEPS = 16 };
    const bat_chart *chart = &r->face->chart;
    const int k = r->k;
    const batten_interval on = batten_curve_domain(use->curve);
    double farthest = chart->near[k] / chart->period[k], along = 0, line = 0;
    bool off = false;
    for (int i = 0; i <= STEPS; i++) {
        double uv[2];
        const batten_status status = batten_curve_evaluate(
            use->curve, i < STEPS ? on.a + (on.b - on.a) * i / STEPS : on.b, 0, uv);
        if (status != BATTEN_OK)
            return status;
        const double x = (uv[k] - r->face->seam[k]) / chart->period[k];
        if (!(fabs(x) < MOST_TURNS))
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "edge %d is %g turns around its surface away from it",
                            use->edge + 1, x);
        if (fabs(x - nearbyint(x)) > farthest) {
            farthest = fabs(x - nearbyint(x));
            *cell = (int)floor(x);
            off = true;
        }
        along += i == 0 ? -uv[1 - k] : i == STEPS ? uv[1 - k] : 0;
        line = nearbyint(x);
    }
    /* Up along a line of u, or back along one of v, the face is below it. */
    if (!off)
        *cell = (int)line - (((along > 0) != use->reversed) == (k == 0));
    return BATTEN_OK;
}

static batten_status find_cells(bat_relink *r)
{
    const bat_trace_loops *loops = &r->face->loops;
    const size_t n = (size_t)loops->use_count;
    r->cells = bat_array(n, sizeof *r->cells);
    r->loop_of = bat_array(n, sizeof *r->loop_of);
    r->leaves = bat_array(n, sizeof *r->leaves);
    r->done = bat_array(n, sizeof *r->done);
    r->crossings = bat_array(n, sizeof *r->crossings);
    r->next = bat_array(n, sizeof *r->next);
    if (!r->cells || !r->loop_of || !r->leaves || !r->done || !r->crossings || !r->next)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (int l = 0; l < loops->loop_count; l++)
        for (int i = 0; status == BATTEN_OK && i < loops->loops[l].count; i++) {
            const int use = loops->loops[l].first + i;
            r->loop_of[use] = l;
            r->leaves[use] = -1;
            status = cell_of(r, &loops->uses[use], &r->cells[use]);
        }
    return status;
}

static int after(const bat_relink *r, int use)
{
    const batten_body_loop *loop = &r->face->loops.loops[r->loop_of[use]];
    return use + 1 < loop->first + loop->count ? use + 1 : loop->first;
}

static int by_height(const void *a, const void *b)
{
    const bat_crossing *x = a, *y = b;
    if (x->s != y->s)
        return x->s < y->s ? -1 : 1;
    return x->use - y->use;
}

static batten_status find_crossings(bat_relink *r)
{
    const bat_trace_loops *loops = &r->face->loops;
    const bat_chart *chart = &r->face->chart;
    const int k = r->k, other = 1 - k;
    for (int i = 0; i < loops->use_count; i++) {
        const int next = after(r, i);
        double uv[2];
        int turns[2], step = r->cells[next] - r->cells[i];
        if (next <= i) {
            bat_trace_winding(r->face, loops, r->loop_of[i], turns);
            step += turns[k];
        }
        if (step == 0)
            continue;
        if (abs(step) > 1)
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "edge %d goes around its surface more than once",
                            loops->uses[i].edge + 1);
        bat_trace_end_of(&loops->uses[i], true, uv);
        double s = k == 0 ? uv[1] : -uv[0];
        if (chart->closed[other]) {
            const double from =
                k == 0 ? r->face->seam[1] : -r->face->seam[0] - chart->period[0];
            s -= chart->period[other] * floor((s - from) / chart->period[other]);
        }
        r->crossings[r->crossing_count++] = (bat_crossing){
            i, next, step > 0, s, bat_trace_vertex(r->trace, &loops->uses[i], true)};
    }
    qsort(r->crossings, (size_t)r->crossing_count, sizeof *r->crossings, by_height);
    return BATTEN_OK;
}

/* Which crossing is the upper end of the seam from each that rises. */
static batten_status match(bat_relink *r)
{
    const int n = r->crossing_count;
    const bool cyclic = r->face->chart.closed[1 - r->k];
    for (int i = 0; i < n; i++)
        r->leaves[r->crossings[i].use] = i;
    for (int i = 0; i < n; i++) {
        const int up = i + 1 < n ? i + 1 : cyclic ? 0 : -1;
        if (up >= 0 && r->crossings[up].rises == r->crossings[i].rises)
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "its loops cross the seam of its surface twice the same way, at "
                            "edges %d and %d",
                            r->face->loops.uses[r->crossings[i].use].edge + 1,
                            r->face->loops.uses[r->crossings[up].use].edge + 1);
        if (r->crossings[i].rises)
            r->next[i] = up;
        else
            r->next[i] = i > 0 ? i - 1 : cyclic ? n - 1 : -1;
    }
    return BATTEN_OK;
}

/* ---- adding ---- */

/* The position along the cut of what was added last. */
static void last_end(const bat_relink *r, double uv[2])
{
    bat_trace_end_of(&r->made.uses[r->made.use_count - 1], true, uv);
}

/* One use, moved to cell 0 and to where the loop is; its ends on the cut are put on it. */
static batten_status add_moved(bat_relink *r, int index, bool enters, bool leaves)
{
    const bat_trace_use *use = &r->face->loops.uses[index];
    const bat_chart *chart = &r->face->chart;
    const int k = r->k;
    const double low = r->face->seam[k], high = low + chart->period[k];
    double by[2], ends[2][2], least[2] = {-HUGE_VAL, -HUGE_VAL}, most[2] = {HUGE_VAL, HUGE_VAL};
    batten_curve *moved = NULL, *made = NULL;
    by[k] = -r->cells[index] * chart->period[k];
    by[1 - k] = r->at[1 - k];
    const batten_affine map = batten_affine_translation(by[0], by[1], 0);
    batten_status status = batten_curve_transform(use->curve, &map, &moved);
    if (status != BATTEN_OK)
        return status;
    bat_trace_use shown = *use;
    shown.curve = moved;
    bat_trace_end_of(&shown, false, ends[0]);
    bat_trace_end_of(&shown, true, ends[1]);
    const bool on_cut[2] = {enters, leaves};
    for (int end = 0; end < 2; end++)
        if (on_cut[end] || fabs(ends[end][k] - low) <= chart->near[k] ||
            fabs(ends[end][k] - high) <= chart->near[k])
            ends[end][k] = ends[end][k] < low + chart->period[k] / 2 ? low : high;
    least[k] = low;
    most[k] = high;
    status = bat_parameters_adjust(moved, least, most, ends[use->reversed],
                                   ends[!use->reversed], &made);
    batten_curve_unref(moved);
    return status == BATTEN_OK
               ? bat_trace_add_use(&r->made, use->edge, use->reversed, use->is_pole, made)
               : status;
}

/* Set how far the next use is moved in the other direction, so that it begins at s. */
static void place_at(bat_relink *r, const double uv[2], int next)
{
    const bat_chart *chart = &r->face->chart;
    const int other = 1 - r->k;
    double start[2];
    bat_trace_end_of(&r->face->loops.uses[next], false, start);
    r->at[other] = chart->closed[other]
                       ? chart->period[other] *
                             nearbyint((uv[other] - start[other]) / chart->period[other])
                       : 0;
}

/* The uses from `first` until the loop crosses the cut: *last. */
static batten_status add_chain(bat_relink *r, int first, int *last)
{
    batten_status status = BATTEN_OK;
    int use = first;
    bool enters = true;
    for (;;) {
        const bool leaves = r->leaves[use] >= 0;
        if (r->made.loops[r->made.loop_count - 1].count) {
            double uv[2];
            last_end(r, uv);
            place_at(r, uv, use);
        }
        r->done[use] = true;
        status = add_moved(r, use, enters, leaves);
        enters = false;
        if (status != BATTEN_OK || leaves)
            break;
        use = after(r, use);
    }
    *last = use;
    return status;
}

/* ---- loops ---- */

static batten_status add_crossing_loop(bat_relink *r, int first, bat_seam *seams)
{
    batten_status status = bat_trace_add_loop(&r->made);
    int use = first;
    r->at[1 - r->k] = 0;
    while (status == BATTEN_OK && !r->done[use]) {
        int last = use;
        status = add_chain(r, use, &last);
        if (status == BATTEN_OK)
            status = bat_relink_follow(r, r->leaves[last], seams, &use);
    }
    if (status == BATTEN_OK && use != first)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "its loops do not close along the seam of its surface");
    return status;
}

/* A loop that stays in its cell. */
static batten_status add_whole_loop(bat_relink *r, int loop)
{
    const batten_body_loop range = r->face->loops.loops[loop];
    batten_status status = bat_trace_add_loop(&r->made);
    r->at[1 - r->k] = 0;
    for (int i = range.first; status == BATTEN_OK && i < range.first + range.count; i++) {
        r->done[i] = true;
        status = add_moved(r, i, false, false);
    }
    return status;
}

static batten_status add_loops(bat_relink *r)
{
    const bat_trace_loops *loops = &r->face->loops;
    bat_seam *seams = bat_array((size_t)r->crossing_count, sizeof *seams);
    batten_status status = seams ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < r->crossing_count; i++)
        if (!r->done[r->crossings[i].next])
            status = add_crossing_loop(r, r->crossings[i].next, seams);
    for (int l = 0; status == BATTEN_OK && l < loops->loop_count; l++)
        if (!r->done[loops->loops[l].first])
            status = add_whole_loop(r, l);
    bat_release(seams);
    return status;
}

static void relink_end(bat_relink *r)
{
    bat_release(r->cells);
    bat_release(r->loop_of);
    bat_release(r->leaves);
    bat_release(r->done);
    bat_release(r->crossings);
    bat_release(r->next);
    bat_trace_end_loops(&r->made);
}

static batten_status relink_direction(bat_trace *trace, bat_trace_face *face, int k)
{
    bat_relink r = {.trace = trace, .face = face, .k = k};
    batten_status status = find_cells(&r);
    if (status == BATTEN_OK)
        status = find_crossings(&r);
    if (status == BATTEN_OK)
        status = match(&r);
    if (status == BATTEN_OK)
        status = add_loops(&r);
    if (status == BATTEN_OK) {
        const bat_trace_loops made = r.made;
        r.made = face->loops;
        face->loops = made;
        face->cut[k] = r.crossing_count > 0;
    }
    relink_end(&r);
    return status;
}

batten_status bat_trace_relink(bat_trace *trace, bat_trace_face *face)
{
    const int k = trace->direction;
    if (face->loops.loop_count == 0 || !face->chart.closed[k])
        return BATTEN_OK;
    batten_status status = bat_trace_cut_surface(face, k);
    if (status == BATTEN_OK)
        status = bat_trace_divide_poles(trace, face, k);
    if (status == BATTEN_OK)
        status = relink_direction(trace, face, k);
    /* Once cut, all lies in one cell, and the other direction sees its ends. */
    if (face->cut[k])
        face->chart.closed[k] = false;
    return status;
}
