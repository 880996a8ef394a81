/* Where the runs of an offset enter what is nearer to the curve than the distance. */
#include "base/list.h"
#include "numeric/vector.h"
#include "shape/curve_change/offset.h"
#include "spline/curve/curve.h"

#include <math.h>

/* The half circle about an end of the curve, from the point q of one side to the other side. */
static batten_status add_cap(const bat_offset *o, const double *p, const double *q,
                             bat_offset *rim)
{
    const bat_offset_gap gap = {.p = p, .turn = -copysign(BAT_PI, o->distance), .q = q};
    return bat_offset_corner(rim, &gap);
}

/* Behind the last run, so that caps follow runs end to start: around the end of the curve, the
 * other side, around the start. */
static batten_status make_rim(const bat_offset *o, bat_offset *rim)
{
    const batten_interval domain = batten_curve_domain(o->plan);
    const batten_curve *first = o->runs[0].plan, *last = o->runs[o->count - 1].plan;
    double start[2], end[2], from[2], to[2];
    batten_status status = batten_curve_evaluate(o->plan, domain.a, 0, start);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(o->plan, domain.b, 0, end);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(first, batten_curve_domain(first).a, 0, from);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(last, batten_curve_domain(last).b, 0, to);
    if (status == BATTEN_OK && !o->closed)
        status = add_cap(o, end, to, rim);
    if (status == BATTEN_OK)
        status = bat_offset_runs(rim);
    for (int k = 0; k < 2; k++)
        from[k] = 2 * start[k] - from[k];
    if (status == BATTEN_OK && !o->closed)
        status = add_cap(o, start, from, rim);
    return status;
}

/* Of crossings among runs and rim those of a run with the rim. */
static batten_status take_entries(const bat_offset *o, const bat_crossings *found,
                                  bat_crossings *out)
{
    if (BAT_LIST_GROW(out->at, out->count, out->room, found->count) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < found->count; i++) {
        const bat_crossing *c = &found->at[i];
        const bool first = c->curve[0] < o->count, second = c->curve[1] < o->count;
        const int run = c->curve[!first];
        const double u = c->u[!first];
        if (first != second)
            out->at[out->count++] = (bat_crossing){{run, run}, {u, u}};
    }
    return BATTEN_OK;
}

batten_status bat_offset_entries(const bat_offset *o, bat_crossings *out)
{
    if (o->count == 0 || o->distance == 0)
        return BATTEN_OK; /* nothing is nearer than 0 */
    bat_offset rim = {.full = o->plan,
                      .plan = o->plan,
                      .distance = -o->distance,
                      .options = o->options,
                      .size = o->size,
                      .closed = o->closed};
    rim.options.corners = BATTEN_OFFSET_ROUND;
    bat_crossings found = {0};
    batten_status status = make_rim(o, &rim);
    const int n = o->count + rim.count;
    const batten_curve **plans =
        status == BATTEN_OK ? bat_array((size_t)n, sizeof *plans) : NULL;
    if (status == BATTEN_OK && !plans)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n; i++)
        plans[i] = i < o->count ? o->runs[i].plan : rim.runs[i - o->count].plan;
    if (status == BATTEN_OK)
        status = bat_crossings_find(n, plans, !o->closed, &found);
    if (status == BATTEN_OK)
        status = take_entries(o, &found, out);
    bat_release(found.at);
    bat_release(plans);
    bat_offset_runs_release(&rim);
    return status;
}
