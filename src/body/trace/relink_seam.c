/* Seams: edges along the cut from crossing to crossing, or to the border of the surface. */
#include "body/border.h"
#include "body/trace/relink.h"
#include "spline/curve/curve.h"

/* The isocurve at the cut from parameter a to b > a of the other direction, where that closes
 * also over the end of its domain. */
static batten_status seam_curve(const bat_relink *r, double a, double b, batten_curve **out)
{
    const bat_chart *chart = &r->face->chart;
    const int other = 1 - r->k;
    const batten_interval domain = chart->domain[other];
    const double turns = chart->closed[other]
                             ? floor((a + chart->near[other] - domain.a) / chart->period[other])
                             : 0;
    const double low = bat_max(domain.a, a - turns * chart->period[other]),
                 high = b - turns * chart->period[other];
    batten_curve *line = NULL, *first = NULL, *second = NULL;
    batten_status status = batten_surface_isocurve(chart->surface, r->k ? BATTEN_V : BATTEN_U,
                                                   r->face->seam[r->k], &line);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(line, low, bat_min(high, domain.b), &first);
    if (status == BATTEN_OK && chart->closed[other] && high > domain.b + chart->near[other]) {
        batten_curve *joined = NULL;
        status = batten_curve_subrange(line, domain.a, high - chart->period[other], &second);
        if (status == BATTEN_OK)
            status = batten_curve_join(first, second, 2 * chart->tolerance, &joined);
        status = bat_curve_replace(status, &first, &joined);
    }
    batten_curve_unref(line);
    batten_curve_unref(second);
    if (status == BATTEN_OK)
        *out = first;
    else
        batten_curve_unref(first);
    return status;
}

/* A use of a seam edge, on one side of the cell; it runs with its parameter, from a to b, in
 * the covering plane. */
static batten_status use_seam(bat_relink *r, int edge, double a, double b, bool high,
                              bool reversed)
{
    const int k = r->k;
    const batten_curve *curve = r->trace->builder.parts.edges[edge].curve;
    double from[2], to[2];
    batten_curve *line = NULL;
    from[k] = to[k] = r->face->seam[k] + (high ? r->face->chart.period[k] : 0);
    from[1 - k] = a;
    to[1 - k] = b;
    const batten_status status = bat_border_line(from, to, batten_curve_domain(curve), &line);
    return status == BATTEN_OK ? bat_trace_add_use(&r->made, edge, reversed, false, line)
                               : status;
}

static batten_status add_seam(bat_relink *r, int start_vertex, int end_vertex, bat_seam *made)
{
    const bool forward = made->start < made->end;
    batten_curve *curve = NULL;
    /* Loops that touch on the cut. */
    if (start_vertex == end_vertex &&
        fabs(made->end - made->start) <= r->face->chart.near[1 - r->k]) {
        made->made = true;
        made->edge = -1;
        return BATTEN_OK;
    }
    batten_status status =
        seam_curve(r, bat_min(made->start, made->end), bat_max(made->start, made->end), &curve);
    if (status == BATTEN_OK)
        status =
            bat_builder_edge(&r->trace->builder, curve, forward ? start_vertex : end_vertex,
                             forward ? end_vertex : start_vertex, &made->edge);
    batten_curve_unref(curve);
    made->made = status == BATTEN_OK;
    r->trace->report.seams += made->made;
    return status;
}

/* The border at the end of a seam: from side to side of the cell. */
static batten_status border_edge(bat_relink *r, bool upper, int *vertex, int *edge)
{
    const int k = r->k;
    const bat_chart *chart = &r->face->chart;
    const int side = k == 0 ? (upper ? 2 : 0) : (upper ? 3 : 1);
    const batten_direction fixed = k == 0 ? BATTEN_V : BATTEN_U;
    const batten_interval across = chart->domain[1 - k];
    double uv[2], point[3];
    batten_curve *rim = NULL;
    uv[k] = r->face->seam[k];
    uv[1 - k] = side == 1 || side == 2 ? across.b : across.a;
    batten_status status = bat_chart_evaluate(chart, uv, 0, point);
    if (status == BATTEN_OK)
        status = bat_builder_vertex(&r->trace->builder, point, vertex);
    if (status == BATTEN_OK && !chart->pole[side])
        status = batten_surface_isocurve(chart->surface, fixed, uv[1 - k], &rim);
    if (status == BATTEN_OK)
        status = bat_builder_edge(&r->trace->builder, rim, *vertex, *vertex, edge);
    r->trace->report.poles += status == BATTEN_OK && chart->pole[side];
    r->face->rims += status == BATTEN_OK && !chart->pole[side];
    if (status == BATTEN_OK && !chart->pole[side])
        bat_trace_note(r->trace, r->face,
                       "one loop goes around it; the border of its surface is the other");
    batten_curve_unref(rim);
    return status;
}

static double border_place(const bat_relink *r, bool upper)
{
    const batten_interval domain = r->face->chart.domain[1 - r->k];
    return upper == (r->k == 0) ? domain.b : domain.a;
}

/* Seams are made when they are first used. */
static batten_status make_seam(bat_relink *r, int at, bool rises, double place, bat_seam *made)
{
    const bat_crossing *c = &r->crossings[at];
    const int next = r->next[at];
    const bat_chart *chart = &r->face->chart;
    const int other = 1 - r->k;
    int vertex = 0;
    *made = (bat_seam){.rim = -1, .start = place};
    if (next < 0) {
        const batten_status status = border_edge(r, rises, &vertex, &made->rim);
        if (status != BATTEN_OK)
            return status;
        made->end = border_place(r, rises);
    } else {
        const bat_crossing *d = &r->crossings[next];
        vertex = d->vertex;
        double length = d->s - c->s;
        if (chart->closed[other] && (rises ? length <= 0 : length >= 0))
            length += (rises ? 1 : -1) * chart->period[other];
        made->end = place + (r->k == 0 ? length : -length);
    }
    return add_seam(r, c->vertex, vertex, made);
}

/* Along the seam, from the crossing on or back to it. */
static batten_status walk_seam(bat_relink *r, const bat_seam *s, double shift, bool high,
                               bool back)
{
    const bool forward = (s->end > s->start) != back;
    if (s->edge < 0)
        return BATTEN_OK;
    return use_seam(r, s->edge, bat_min(s->start, s->end) + shift,
                    bat_max(s->start, s->end) + shift, high, !forward);
}

/* From one side of the cell to the other along the border. */
static batten_status walk_rim(bat_relink *r, const bat_seam *s, bool from_high)
{
    const int k = r->k;
    const batten_curve *curve = r->trace->builder.parts.edges[s->rim].curve;
    const double low = r->face->seam[k], top = low + r->face->chart.period[k];
    double from[2], to[2];
    batten_curve *line = NULL;
    from[1 - k] = to[1 - k] = s->end;
    from[k] = curve || !from_high ? low : top;
    to[k] = curve || !from_high ? top : low;
    const batten_interval on = curve ? batten_curve_domain(curve) : (batten_interval){0, 1};
    const batten_status status = bat_border_line(from, to, on, &line);
    return status == BATTEN_OK
               ? bat_trace_add_use(&r->made, s->rim, curve && from_high, !curve, line)
               : status;
}

batten_status bat_relink_follow(bat_relink *r, int at, bat_seam *seams, int *use)
{
    const bat_crossing *c = &r->crossings[at];
    const int other = 1 - r->k, next = r->next[at];
    double uv[2];
    bat_trace_end_of(&r->made.uses[r->made.use_count - 1], true, uv);
    /* A seam belongs to the crossing below it, or to its only one. */
    const bool owns = c->rises || next < 0;
    const int owner = owns ? at : next;
    batten_status status = BATTEN_OK;
    if (!seams[owner].made) {
        double place = uv[other];
        if (!owns) {
            const double length = r->crossings[owner].s - c->s;
            const double period =
                r->face->chart.closed[other] && length >= 0 ? r->face->chart.period[other] : 0;
            place += (r->k == 0 ? 1 : -1) * (length - period);
        }
        status = make_seam(r, owner, r->crossings[owner].rises, place, &seams[owner]);
    }
    if (status != BATTEN_OK)
        return status;
    const bat_seam *s = &seams[owner];
    const double here = owns ? s->start : s->end;
    const double period = r->face->chart.period[other];
    const double shift =
        r->face->chart.closed[other] ? period * nearbyint((uv[other] - here) / period) : 0;
    status = walk_seam(r, s, shift, c->rises, !owns);
    if (status == BATTEN_OK && next < 0) {
        status = walk_rim(r, s, c->rises);
        if (status == BATTEN_OK)
            status = walk_seam(r, s, shift, !c->rises, true);
    }
    *use = r->crossings[next < 0 ? at : next].next;
    return status;
}
