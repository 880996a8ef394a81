/* Single arcs of a row of tangent ones: how the curve bends, where an arc may end, whether it is in the band. */
#include "shape/arcs/smooth_step.h"
#include "base/list.h"
#include "numeric/vector.h"

/* ---- the curve ---- */

bat_smooth_row bat_smooth_row_at(const bat_arc_search *s, int place)
{
    const bool again = place > s->count;
    bat_smooth_row r = s->rows[again ? place - s->count : place];
    if (again) {
        r.u += s->task->to - s->task->from;
        r.angle += s->rows[s->count].angle - s->rows[0].angle;
    }
    return r;
}

static batten_status make_row(bat_arc_search *s, int i, double u, double reach)
{
    bat_smooth_row *r = &s->rows[i];
    double at[4];
    const bool end = i == s->count;
    const batten_status status =
        bat_arcs_direction(s->task->path, u, end ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, at);
    if (status != BATTEN_OK)
        return status;
    const double off = s->held && (i == 0 || end) ? 0 : s->middle;
    *r = (bat_smooth_row){.u = u,
                          .point = {at[0], at[1]},
                          .direction = {at[2], at[3]},
                          .node = {at[0] - off * at[3], at[1] + off * at[2]},
                          .reach = reach};
    r->angle = i == 0 ? bat_atan2(at[3], at[2])
                      : r[-1].angle + bat_turn(r[-1].direction, r->direction);
    return BATTEN_OK;
}

/* No arc bends much more sharply than the curve does anywhere, and none to a side to which the
 * curve never turns. */
static void find_bends(bat_arc_search *s)
{
    static const double more = 1.4;
    double left = 0, right = 0, turned[2] = {0, 0};
    for (int i = 0; i < s->count; i++) {
        const double turn = s->rows[i + 1].angle - s->rows[i].angle;
        const double k = turn / bat_distance(2, s->rows[i].point, s->rows[i + 1].point);
        turned[turn > 0] += fabs(turn);
        left = isfinite(k) ? bat_max(left, k) : left;
        right = isfinite(k) ? bat_min(right, k) : right;
    }
    /* What turns less than this is rounding. */
    static const double rounding = 1e-9;
    const double most = more * bat_max(left, -right);
    s->most_bend = turned[1] > rounding * turned[0] ? most : rounding * most;
    s->least_bend = turned[0] > rounding * turned[1] ? -most : -rounding * most;
}

batten_status bat_smooth_rows(bat_arc_search *s)
{
    const bat_arcs_list *guide = s->task->guide;
    s->count = BAT_SMOOTH_FINE * guide->count;
    s->rows = bat_array((size_t)s->count + 1, sizeof *s->rows);
    if (!s->rows)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (int i = 0; i <= s->count && status == BATTEN_OK; i++) {
        const bat_arcs_part *part =
            &guide->parts[bat_min_int(i / BAT_SMOOTH_FINE, guide->count - 1)];
        const double share =
            (double)(i - BAT_SMOOTH_FINE * (int)(part - guide->parts)) / BAT_SMOOTH_FINE;
        const double u =
            i == s->count ? s->task->to : part->from + (part->to - part->from) * share;
        status = make_row(s, i, u, part->biarc.arcs[0].length);
    }
    if (status == BATTEN_OK)
        find_bends(s);
    return status;
}

/* ---- arcs ---- */

bool bat_smooth_may_bend(const bat_arc_search *s, double curvature)
{
    return curvature >= s->least_bend && curvature <= s->most_bend;
}

batten_status bat_smooth_add(bat_arc_search *s, const bat_arc_state *from, int *index)
{
    const batten_status status = BAT_LIST_ADD(s->states, s->state_count, s->capacity, *from);
    if (status == BATTEN_OK)
        *index = s->state_count - 1;
    return status;
}

/* The range of a lean; -1 beyond the last. */
static int range_of(const bat_arc_search *s, double lean, double reach)
{
    const double at = lean * reach / (bat_step_of_leans * s->half) + BAT_SMOOTH_LEANS / 2.0;
    return at >= 0 && at < BAT_SMOOTH_LEANS && fabs(lean) < bat_most_lean ? (int)at : -1;
}

bool bat_smooth_bends_alike(const bat_arc_search *s, double lean, const bat_smooth_row *to,
                            double to_lean, double l)
{
    return fabs(to_lean - lean) * to->reach * to->reach <= s->excess * s->half * l;
}

bat_smooth_leg bat_smooth_leg_of(const bat_smooth_row *from, double lean)
{
    const double angle = from->angle + lean;
    return (bat_smooth_leg){.from = from,
                            .lean = lean,
                            .angle = angle,
                            .direction = {bat_cos(angle), bat_sin(angle)}};
}

bool bat_smooth_aim(const bat_arc_search *s, bat_smooth_leg *l, const bat_smooth_row *to,
                    double *lean, int *range)
{
    const double chord[2] = {to->node[0] - l->from->node[0], to->node[1] - l->from->node[1]};
    l->half = bat_turn(l->direction, chord);
    *lean = l->angle + 2 * l->half - to->angle;
    *range = range_of(s, *lean, to->reach);
    l->length = bat_norm(2, chord);
    return l->length > 0 && fabs(l->half) <= BAT_PI / 2 * (1 + 1e-9) && *range >= 0 &&
           bat_smooth_bends_alike(s, l->lean, to, *lean, l->length);
}

bool bat_smooth_arc(const bat_arc_search *s, const bat_smooth_leg *l, batten_biarc *out)
{
    const double least = s->task->least_radius;
    *out = (batten_biarc){.count = 1, .place = 0.5, .turn = {2 * l->half}};
    bat_arc_span(l->from->node, l->length, l->angle + l->half, l->half, &out->arcs[0]);
    const double k = out->arcs[0].curvature[0];
    return bat_smooth_may_bend(s, k) && !(least > 0 && fabs(k) * least > 1 + 1e-12);
}

static double beside_middle(const bat_arc_search *s, const bat_arcs_probe *probe, int place)
{
    const bat_smooth_row *r = &s->rows[place > s->count ? place - s->count : place];
    return bat_arcs_beside(probe, r->point) - s->middle;
}

/* Rows miss the extremes by a little, so they are held to less, but for those next to an end
 * that lies beside the middle. */
static bool passes(const bat_arc_search *s, double off, int place)
{
    const bool at_end =
        s->held && (place <= BAT_SMOOTH_FINE / 4 || place >= s->count - BAT_SMOOTH_FINE / 4);
    return fabs(off) <= s->half * (at_end ? 1 : s->shrink) + s->task->slack;
}

bool bat_smooth_fits(const bat_arc_search *s, const batten_biarc *arc, int from, int to)
{
    bat_arcs_probe probe;
    bat_arcs_probe_make(arc, &probe);
    const int step = bat_max_int(1, (to - from) / BAT_SMOOTH_LOOKS);
    int extreme[2] = {from, from};
    double largest[2] = {0, 0};
    for (int i = from + 1; i < to; i += step) {
        const double off = beside_middle(s, &probe, i);
        if (!passes(s, off, i))
            return false;
        if (fabs(off) > largest[off > 0]) {
            largest[off > 0] = fabs(off);
            extreme[off > 0] = i;
        }
    }
    for (int k = 0; k < 2; k++)
        for (int i = bat_max_int(from, extreme[k] - step) + 1;
             i < bat_min_int(to, extreme[k] + step); i++)
            if (!passes(s, beside_middle(s, &probe, i), i))
                return false;
    return passes(s, beside_middle(s, &probe, to - 1), to - 1);
}

bool bat_smooth_leads_in(const bat_arc_search *s, double lean, bool arriving)
{
    return !s->held || (arriving ? -lean : lean) * s->middle >= 0;
}
