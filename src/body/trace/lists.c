/* The lists that tracing grows: uses of loops, and cuts of edges; what a use says of its ends.
 */
#include "base/list.h"
#include "body/trace/trace.h"

#include <string.h>

batten_status bat_trace_add_use(bat_trace_loops *loops, int edge, bool reversed, bool is_pole,
                                batten_curve *curve)
{
    const bat_trace_use use = {edge, reversed, is_pole, curve};
    const batten_status status =
        BAT_LIST_ADD(loops->uses, loops->use_count, loops->use_room, use);
    if (status == BATTEN_OK)
        loops->loops[loops->loop_count - 1].count++;
    else
        batten_curve_unref(curve);
    return status;
}

batten_status bat_trace_add_loop(bat_trace_loops *loops)
{
    const batten_body_loop loop = {.first = loops->use_count};
    return BAT_LIST_ADD(loops->loops, loops->loop_count, loops->loop_room, loop);
}

batten_status bat_trace_cut_at(bat_trace *trace, int edge, double t)
{
    const bat_trace_cut cut = {edge, t};
    return BAT_LIST_ADD(trace->cuts, trace->cut_count, trace->cut_room, cut);
}

void bat_trace_end_loops(bat_trace_loops *loops)
{
    for (int i = 0; i < loops->use_count; i++)
        batten_curve_unref(loops->uses[i].curve);
    bat_release(loops->uses);
    bat_release(loops->loops);
    *loops = (bat_trace_loops){0};
}

void bat_trace_turn(bat_trace_loops *loops, int loop)
{
    bat_trace_use *uses = loops->uses + loops->loops[loop].first;
    const int n = loops->loops[loop].count;
    for (int i = 0; i < n / 2; i++) {
        const bat_trace_use swap = uses[i];
        uses[i] = uses[n - 1 - i];
        uses[n - 1 - i] = swap;
    }
    for (int i = 0; i < n; i++)
        uses[i].reversed = !uses[i].reversed;
}

int bat_trace_vertex(const bat_trace *trace, const bat_trace_use *use, bool end)
{
    return trace->builder.parts.edges[use->edge].vertices[use->reversed != end];
}

void bat_trace_end_of(const bat_trace_use *use, bool end, double uv[2])
{
    const int last = batten_curve_point_count(use->curve) - 1;
    memcpy(uv, batten_curve_points(use->curve) + (use->reversed != end ? 2 * last : 0),
           2 * sizeof *uv);
}
