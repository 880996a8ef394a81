/* The last step of tracing a face: loops that close to the bit, in the domain, and near their
 * edges. */
#include "body/trace/parameters.h"
#include "body/trace/trace.h"
#include "numeric/vector.h"
#include "spline/surface/surface.h"

#include <batten/text.h>
#include <string.h>

/* ---- planes ---- */

static void hull_of(const bat_trace_face *face, double low[2], double high[2])
{
    for (int k = 0; k < 2; k++) {
        low[k] = face->chart.domain[k].a;
        high[k] = face->chart.domain[k].b;
    }
    for (int i = 0; i < face->loops.use_count; i++) {
        const batten_box box = batten_curve_box(face->loops.uses[i].curve);
        low[0] = bat_min(low[0], box.low.x);
        low[1] = bat_min(low[1], box.low.y);
        high[0] = bat_max(high[0], box.high.x);
        high[1] = bat_max(high[1], box.high.y);
    }
}

/* Does the hull leave the domain by more than rounding? */
static bool leaves(const bat_chart *chart, const double low[2], const double high[2])
{
    bool any = false;
    for (int k = 0; k < 2; k++) {
        /* Some thousand roundings of a parameter. */
        const double little = 1e-12 * chart->period[k];
        any = any || low[k] < chart->domain[k].a - little ||
              high[k] > chart->domain[k].b + little;
    }
    return any;
}

/* A plane grows to its loops, as far as they can be meant: those that leave it by orders of magnitude have a wrong
 * coordinate, and beside it all else of the face is one point. */
static batten_status check_growth(const bat_chart *chart, const double low[2],
                                  const double high[2])
{
    enum { MOST_WIDTHS = 10000 };
    for (int k = 0; k < 2; k++) {
        const batten_interval domain = chart->domain[k];
        const double most = MOST_WIDTHS * chart->period[k];
        const bool is_low = !(low[k] >= domain.a - most);
        if (is_low || !(high[k] <= domain.b + most))
            return bat_fail(
                BATTEN_OUT_OF_DOMAIN,
                "a loop runs to %c = %g, where its plane has %g to %g: a coordinate of its "
                "curves must be wrong",
                k ? 'v' : 'u', is_low ? low[k] : high[k], domain.a, domain.b);
    }
    return BATTEN_OK;
}

/* The plane over [low, high], with the same parameters. */
static batten_status grow_plane(bat_chart *chart, const double low[2], const double high[2])
{
    const double *p = batten_surface_points(chart->surface);
    double points[12];
    const double u[] = {low[0], low[0], high[0], high[0]},
                 v[] = {low[1], low[1], high[1], high[1]};
    batten_surface *made = NULL;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            const double s = ((i ? high : low)[0] - chart->domain[0].a) / chart->period[0];
            const double t = ((j ? high : low)[1] - chart->domain[1].a) / chart->period[1];
            for (int k = 0; k < 3; k++)
                points[3 * (2 * i + j) + k] =
                    p[k] + s * (p[6 + k] - p[k]) + t * (p[3 + k] - p[k]);
        }
    const batten_axis along = {1, 2, u, false}, across = {1, 2, v, false};
    const batten_status status = batten_surface_create(3, &along, &across, points, NULL, &made);
    if (status != BATTEN_OK)
        return status;
    batten_surface_unref(chart->surface);
    chart->surface = made;
    for (int k = 0; k < 2; k++) {
        chart->domain[k] = (batten_interval){low[k], high[k]};
        chart->period[k] = high[k] - low[k];
    }
    return BATTEN_OK;
}

/* ---- joints ---- */

/* Is the use a straight line at a fixed coordinate k? */
static bool is_fixed(const bat_trace_use *use, int k)
{
    const double *p = batten_curve_points(use->curve);
    return batten_curve_point_count(use->curve) == 2 && p[k] == p[2 + k];
}

/* Where two uses meet: on a line that one of them is, else halfway; inside the domain. */
static void meet(const bat_chart *chart, const bat_trace_use *a, const bat_trace_use *b,
                 double at[2])
{
    double p[2], q[2];
    bat_trace_end_of(a, true, p);
    bat_trace_end_of(b, false, q);
    for (int k = 0; k < 2; k++) {
        at[k] = p[k] == q[k] || is_fixed(a, k) ? p[k]
                : is_fixed(b, k)               ? q[k]
                                               : p[k] + (q[k] - p[k]) / 2;
        at[k] = bat_min(chart->domain[k].b, bat_max(chart->domain[k].a, at[k]));
    }
}

/* Give the use these ends, and look at what it misses then; one that misses is traced again. */
static batten_status settle_use(bat_trace *trace, bat_trace_face *face, bat_trace_use *use,
                                const double start[2], const double end[2])
{
    bat_chart *chart = &face->chart;
    const batten_curve *curve = trace->builder.parts.edges[use->edge].curve;
    const double low[2] = {chart->domain[0].a, chart->domain[1].a},
                 high[2] = {chart->domain[0].b, chart->domain[1].b};
    const double *first = use->reversed ? end : start, *last = use->reversed ? start : end;
    double miss = 0, was[2][2];
    bat_trace_end_of(use, false, was[0]);
    bat_trace_end_of(use, true, was[1]);
    if (bat_parameters_inside(chart, use->curve) && memcmp(was[0], start, sizeof was[0]) == 0 &&
        memcmp(was[1], end, sizeof was[1]) == 0)
        return BATTEN_OK;
    batten_curve *made = NULL;
    batten_status status = bat_parameters_adjust(use->curve, low, high, first, last, &made);
    if (status != BATTEN_OK)
        return status;
    batten_curve_unref(use->curve);
    use->curve = made;
    if (curve)
        status = bat_parameters_miss(chart, curve, use->curve, HUGE_VAL, &miss);
    if (status == BATTEN_OK && miss > chart->tolerance) {
        batten_curve *followed = NULL;
        status = bat_parameters_follow(chart, curve, first, &followed, &miss);
        if (status == BATTEN_OK)
            status = bat_parameters_adjust(followed, low, high, first, last, &made);
        if (status == BATTEN_OK) {
            batten_curve_unref(use->curve);
            use->curve = made;
            status = bat_parameters_miss(chart, curve, use->curve, HUGE_VAL, &miss);
        }
        batten_curve_unref(followed);
    }
    if (status == BATTEN_OK && miss > chart->tolerance)
        status =
            bat_fail(BATTEN_TOLERANCE_NOT_MET,
                     "edge %d is %g off the surface where its loop is closed, more than %g",
                     use->edge + 1, miss, chart->tolerance);
    trace->report.error = bat_max(trace->report.error, miss);
    return status;
}

static batten_status close_loop(bat_trace *trace, bat_trace_face *face,
                                const batten_body_loop *loop)
{
    bat_trace_use *uses = face->loops.uses + loop->first;
    const int n = loop->count;
    double(*at)[2] = bat_array((size_t)n, sizeof *at);
    batten_status status = at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n; i++)
        meet(&face->chart, &uses[i], &uses[(i + 1) % n], at[i]);
    for (int i = 0; status == BATTEN_OK && i < n; i++)
        status = settle_use(trace, face, &uses[i], at[(i + n - 1) % n], at[i]);
    bat_release(at);
    return status;
}

static void note_loose(bat_trace *trace, bat_trace_face *face)
{
    char text[160];
    batten_text_print(
        text, sizeof text,
        "its edges are more than %g off it, or off one another; it was traced to %g",
        trace->tolerance, face->chart.tolerance);
    bat_trace_note(trace, face, text);
    trace->report.loose++;
}

batten_status bat_trace_close(bat_trace *trace, bat_trace_face *face)
{
    double low[2], high[2];
    batten_status status = BATTEN_OK;
    /* All is in one cell now. */
    face->chart.closed[0] = face->chart.closed[1] = false;
    hull_of(face, low, high);
    if (bat_parameters_plane(&face->chart) && leaves(&face->chart, low, high)) {
        status = check_growth(&face->chart, low, high);
        if (status == BATTEN_OK)
            status = grow_plane(&face->chart, low, high);
    }
    for (int i = 0; status == BATTEN_OK && i < face->loops.loop_count; i++) {
        status = close_loop(trace, face, &face->loops.loops[i]);
        while (status == BATTEN_TOLERANCE_NOT_MET && bat_trace_loosen(trace, face))
            status = close_loop(trace, face, &face->loops.loops[i]);
    }
    if (status == BATTEN_OK && face->chart.tolerance > trace->tolerance)
        note_loose(trace, face);
    return status;
}
