/* The uses of a loop one after the other, and poles between them. */
#include "body/border.h"
#include "body/trace/parameters.h"
#include "body/trace/trace.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <batten/nearest.h>
#include <stdint.h>
#include <string.h>

/* ---- poles ---- */

/* Where an edge comes to within the tolerance of a pole away from its ends. */
static batten_status cut_at_pole(bat_trace *trace, int edge, const double pole[3])
{
    const batten_curve *curve = trace->builder.parts.edges[edge].curve;
    const batten_interval on = batten_curve_domain(curve);
    const batten_box box = batten_curve_box(curve);
    const double low[] = {box.low.x, box.low.y, box.low.z},
                 high[] = {box.high.x, box.high.y, box.high.z};
    batten_deviation nearest;
    double ends[2][3];
    for (int k = 0; k < 3; k++)
        if (pole[k] < low[k] - trace->tolerance || pole[k] > high[k] + trace->tolerance)
            return BATTEN_OK;
    batten_status status = batten_curve_evaluate(curve, on.a, 0, ends[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(curve, on.b, 0, ends[1]);
    if (status == BATTEN_OK)
        status = batten_curve_deviation(curve,
                                        (batten_points){batten_curve_dimension(curve), 1, pole},
                                        NULL, NULL, NULL, &nearest);
    if (status != BATTEN_OK || nearest.max > trace->tolerance ||
        bat_distance(3, ends[0], pole) <= trace->tolerance ||
        bat_distance(3, ends[1], pole) <= trace->tolerance)
        return status;
    return bat_trace_cut_at(trace, edge, nearest.at[0]);
}

batten_status bat_trace_pole_cuts(bat_trace *trace, const bat_trace_face *face)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 4; k++)
        for (int i = 0; status == BATTEN_OK && face->chart.pole[k] && i < face->loops.use_count;
             i++)
            status = cut_at_pole(trace, face->loops.uses[i].edge, face->chart.pole_at[k]);
    return status;
}

/* The side of the chart on which the point is and which is a pole; -1 for none. */
static int pole_side(const bat_chart *chart, const double uv[2])
{
    for (int k = 0; k < 4; k++) {
        const int fixed = k % 2 ? 0 : 1;
        const double at = k == 1 || k == 2 ? chart->domain[fixed].b : chart->domain[fixed].a;
        if (chart->pole[k] && fabs(uv[fixed] - at) <= chart->near[fixed])
            return k;
    }
    return -1;
}

/*
 * A use along a pole from `from` to where the loop goes on, `to`, which is moved by periods:
 * with the face on its left the loop goes along side 0 with rising u, side 1 with rising v,
 * back on sides 2 and 3.
 */
static batten_status add_pole(bat_trace *trace, bat_trace_face *face, int side, int vertex,
                              const double from[2], double to[2])
{
    const int along = side % 2;
    const double period = face->chart.period[along];
    const int way = side == 0 || side == 1 ? 1 : -1;
    batten_curve *line = NULL;
    int edge;
    if (face->chart.closed[along]) {
        const double turn = way * (to[along] - from[along]) / period;
        /* In (0, 1] of a period; the same meridian is a full turn. */
        const double part = turn - floor(turn);
        to[along] += way * period * ((part > 1e-9 ? 0 : 1) - nearbyint(turn - part));
    }
    if (fabs(to[along] - from[along]) <= 1e-9 * period)
        return BATTEN_OK;
    batten_status status = bat_builder_edge(&trace->builder, NULL, vertex, vertex, &edge);
    trace->report.poles += status == BATTEN_OK;
    if (status == BATTEN_OK)
        status = bat_border_line(from, to, (batten_interval){0, 1}, &line);
    if (status == BATTEN_OK)
        status = bat_trace_add_use(&face->loops, edge, false, true, line);
    return status;
}

/* ---- one after the other ---- */

/* Move a parameter curve by whole periods. */
static batten_status shift_curve(batten_curve **curve, const double by[2])
{
    batten_curve *moved = NULL;
    if (by[0] == 0 && by[1] == 0)
        return BATTEN_OK;
    const batten_affine map = batten_affine_translation(by[0], by[1], 0);
    return bat_curve_replace(batten_curve_transform(*curve, &map, &moved), curve, &moved);
}

/* Move the use to where the loop is, `at`; a pole is put in between where there is one. */
static batten_status follow_on(bat_trace *trace, bat_trace_face *face, bat_trace_use *use,
                               const double at[2])
{
    const bat_chart *chart = &face->chart;
    double start[2], to[2], by[2];
    bat_trace_end_of(use, false, start);
    memcpy(to, start, sizeof to);
    const int side = pole_side(chart, start);
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2; k++)
        if (chart->closed[k])
            to[k] += chart->period[k] * nearbyint((at[k] - to[k]) / chart->period[k]);
    if (side >= 0 && pole_side(chart, at) == side)
        status = add_pole(trace, face, side, bat_trace_vertex(trace, use, false), at, to);
    for (int k = 0; k < 2; k++)
        by[k] = to[k] - start[k];
    return status == BATTEN_OK ? shift_curve(&use->curve, by) : status;
}

static batten_status trace_use(bat_trace *trace, bat_trace_face *face, bat_trace_use *use,
                               const double *at)
{
    const batten_curve *curve = trace->builder.parts.edges[use->edge].curve;
    batten_curve *made = NULL;
    double miss = 0;
    bool kept = false;
    const batten_status status = bat_parameters_of_edge(
        &face->chart, curve, use->curve, use->reversed ? NULL : at, &made, &kept, &miss);
    if (status != BATTEN_OK)
        return status;
    batten_curve_unref(use->curve);
    use->curve = made;
    trace->report.error = bat_max(trace->report.error, miss);
    trace->report.kept += kept;
    trace->report.rebuilt += !kept;
    return BATTEN_OK;
}

/* The gap between two uses in space. */
static batten_status check_gap(const bat_trace_face *face, const double a[2], const double b[2],
                               int edge)
{
    double p[3], q[3];
    batten_status status = bat_chart_evaluate(&face->chart, a, 0, p);
    if (status == BATTEN_OK)
        status = bat_chart_evaluate(&face->chart, b, 0, q);
    if (status == BATTEN_OK && bat_distance(3, p, q) > 2 * face->chart.tolerance)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "its loop has a gap of %g before edge %d, more than twice %g",
                        bat_distance(3, p, q), edge + 1, face->chart.tolerance);
    return status;
}

/* The uses of `given` as a loop of the face. */
static batten_status trace_loop(bat_trace *trace, bat_trace_face *face,
                                const bat_trace_use *given, int count)
{
    double at[2] = {0, 0}, start[2];
    const int first = face->loops.use_count;
    batten_status status = bat_trace_add_loop(&face->loops);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        bat_trace_use use = given[i];
        if (use.curve)
            batten_curve_ref(use.curve);
        status = trace_use(trace, face, &use, i ? at : NULL);
        if (status == BATTEN_OK && i)
            status = follow_on(trace, face, &use, at);
        if (status != BATTEN_OK) {
            batten_curve_unref(use.curve);
            return status;
        }
        bat_trace_end_of(&use, false, start);
        if (i)
            status = check_gap(face, at, start, use.edge);
        bat_trace_end_of(&use, true, at);
        const batten_status added =
            bat_trace_add_use(&face->loops, use.edge, use.reversed, false, use.curve);
        status = status == BATTEN_OK ? added : status;
    }
    if (status != BATTEN_OK)
        return status;
    /* From the last use to the first. */
    const bat_trace_use begin = face->loops.uses[first];
    bat_trace_end_of(&begin, false, start);
    const int side = pole_side(&face->chart, start);
    if (side >= 0 && pole_side(&face->chart, at) == side) {
        double to[2];
        memcpy(to, start, sizeof to);
        return add_pole(trace, face, side, bat_trace_vertex(trace, &begin, false), at, to);
    }
    return check_gap(face, at, start, begin.edge);
}

/* With the tolerance of the chart. On failure all is as it was. */
static batten_status trace_loops(bat_trace *trace, bat_trace_face *face)
{
    const batten_body_trace_report report = trace->report;
    bat_trace_loops given = face->loops;
    batten_status status = BATTEN_OK;
    face->loops = (bat_trace_loops){0};
    for (int i = 0; status == BATTEN_OK && i < given.loop_count; i++)
        status =
            trace_loop(trace, face, given.uses + given.loops[i].first, given.loops[i].count);
    if (status == BATTEN_OK) {
        bat_trace_end_loops(&given);
        return BATTEN_OK;
    }
    bat_trace_end_loops(&face->loops);
    face->loops = given;
    trace->report = report;
    return status;
}

bool bat_trace_loosen(bat_trace *trace, bat_trace_face *face)
{
    const double most = bat_min(5e-3 * trace->size, 1e-2 * face->chart.size);
    if (face->chart.tolerance >= most)
        return false;
    /* What rounding does not allow is not asked for by one power of ten after the other. */
    const double next = bat_max(10 * face->chart.tolerance, 1e-15 * face->chart.size);
    bat_chart_loosen(&face->chart, bat_min(next, most));
    return true;
}

batten_status bat_trace_face_loops(bat_trace *trace, bat_trace_face *face)
{
    batten_status status = trace_loops(trace, face);
    while (status == BATTEN_TOLERANCE_NOT_MET && bat_trace_loosen(trace, face))
        status = trace_loops(trace, face);
    return status;
}
