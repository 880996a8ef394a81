/* A surface cut where its loops are to be closed: begun there. */
#include "body/border.h"
#include "body/trace/trace.h"

#include <string.h>

batten_status bat_trace_cut_surface(bat_trace_face *face, int k)
{
    bat_chart *chart = &face->chart;
    const batten_direction along = k ? BATTEN_V : BATTEN_U;
    const double at = face->seam[k];
    batten_surface *low = NULL, *high = NULL, *made = NULL;
    if (!(at > chart->domain[k].a && at < chart->domain[k].b))
        return BATTEN_OK;
    batten_status status = batten_surface_split(chart->surface, along, at, &low, &high);
    if (status == BATTEN_OK)
        status = batten_surface_join(high, low, along, chart->tolerance, &made);
    if (status == BATTEN_OK) {
        batten_surface_unref(chart->surface);
        chart->surface = made;
        chart->domain[k] = batten_surface_domain(made, along);
        chart->period[k] = chart->domain[k].b - chart->domain[k].a;
        bat_release(chart->seeds);
        chart->seeds = NULL;
    }
    batten_surface_unref(low);
    batten_surface_unref(high);
    return status;
}

/* A use along a pole that crosses the cut becomes two or more, with edges of their own. */
static batten_status divide_pole(bat_trace *trace, const bat_trace_face *face, int k,
                                 const bat_trace_use *use, bat_trace_loops *made)
{
    const double period = face->chart.period[k], near = face->chart.near[k];
    const int vertex = bat_trace_vertex(trace, use, false);
    double from[2], to[2];
    bat_trace_end_of(use, false, from);
    bat_trace_end_of(use, true, to);
    batten_status status = BATTEN_OK;
    bool more = true;
    while (status == BATTEN_OK && more) {
        double next[2] = {to[0], to[1]};
        const double x = (from[k] - face->seam[k]) / period;
        const double line =
            face->seam[k] + period * (to[k] > from[k] ? floor(x + near / period) + 1
                                                      : ceil(x - near / period) - 1);
        more = to[k] > from[k] ? line < to[k] - near : line > to[k] + near;
        if (more)
            next[k] = line;
        batten_curve *straight = NULL;
        int edge;
        status = bat_builder_edge(&trace->builder, NULL, vertex, vertex, &edge);
        if (status == BATTEN_OK)
            status = bat_border_line(from, next, (batten_interval){0, 1}, &straight);
        if (status == BATTEN_OK)
            status = bat_trace_add_use(made, edge, false, true, straight);
        memcpy(from, next, sizeof from);
    }
    return status;
}

batten_status bat_trace_divide_poles(bat_trace *trace, bat_trace_face *face, int k)
{
    bat_trace_loops *loops = &face->loops, made = {0};
    bool any = false;
    for (int i = 0; i < loops->use_count; i++)
        any = any || loops->uses[i].is_pole;
    if (!any)
        return BATTEN_OK;
    batten_status status = BATTEN_OK;
    for (int l = 0; status == BATTEN_OK && l < loops->loop_count; l++) {
        status = bat_trace_add_loop(&made);
        for (int i = 0; status == BATTEN_OK && i < loops->loops[l].count; i++) {
            bat_trace_use *use = &loops->uses[loops->loops[l].first + i];
            if (use->is_pole) {
                status = divide_pole(trace, face, k, use, &made);
                continue;
            }
            batten_curve *curve = use->curve;
            use->curve = NULL;
            status = bat_trace_add_use(&made, use->edge, use->reversed, false, curve);
        }
    }
    bat_trace_end_loops(loops);
    *loops = made;
    return status;
}
