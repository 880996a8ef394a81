/* The uses of a traced face as its loops run in its parameters, where they cross, and what that leaves open. */
#include "body/trace/passages.h"
#include "numeric/vector.h"

#include <string.h>

void bat_passages_release(bat_passages *all)
{
    for (int i = 0; i < all->count; i++)
        batten_curve_unref(all->at[i].curve);
    bat_release(all->at);
    bat_release(all->is_bad);
}

/* ---- the loops as they run ---- */

static batten_status pass(const batten_body_parts *p, int use, bat_passage *out)
{
    const batten_body_use *of = &p->uses[use];
    out->use = use;
    if (of->reversed)
        return batten_curve_reverse(of->parameters, &out->curve);
    out->curve = batten_curve_ref(of->parameters);
    return BATTEN_OK;
}

/* Both parameters from 0 to 1, whatever their units. */
static batten_status bring_to_unit(bat_passages *all)
{
    batten_affine map = batten_affine_identity();
    for (int k = 0; k < 2; k++) {
        map.m[k][k] = 1 / all->size[k];
        map.t[k] = -all->low[k] / all->size[k];
    }
    for (int i = 0; i < all->count; i++) {
        bat_passage *one = &all->at[i];
        batten_curve *moved = NULL;
        batten_status status = batten_curve_transform(one->curve, &map, &moved);
        if (status != BATTEN_OK)
            return status;
        batten_curve_unref(one->curve);
        one->curve = moved;
        status = batten_curve_evaluate(moved, batten_curve_domain(moved).a, 0, one->start);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

batten_status bat_passages_gather(const batten_body_parts *p, int face, bat_passages *all)
{
    const batten_body_face *of = &p->faces[face];
    int uses = 0;
    for (int l = 0; l < of->count; l++)
        uses += p->loops[of->first + l].count;
    *all = (bat_passages){0};
    all->at = bat_array((size_t)uses, sizeof *all->at);
    all->is_bad = bat_array((size_t)of->count, sizeof *all->is_bad);
    if (!all->at || !all->is_bad)
        return BATTEN_OUT_OF_MEMORY;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int l = 0; l < of->count; l++) {
        const batten_body_loop *loop = &p->loops[of->first + l];
        const int first = all->count;
        for (int i = 0; i < loop->count; i++) {
            bat_passage *one = &all->at[all->count];
            one->loop = l;
            const batten_status status = pass(p, loop->first + i, one);
            all->count += one->curve != NULL;
            if (status != BATTEN_OK)
                return status;
            one->next = i + 1 < loop->count ? all->count : first;
            const batten_box box = batten_curve_box(one->curve);
            low[0] = bat_min(low[0], box.low.x);
            low[1] = bat_min(low[1], box.low.y);
            high[0] = bat_max(high[0], box.high.x);
            high[1] = bat_max(high[1], box.high.y);
        }
    }
    for (int k = 0; k < 2; k++) {
        all->low[k] = low[k];
        all->size[k] = high[k] > low[k] ? high[k] - low[k] : 1;
    }
    return bring_to_unit(all);
}

/* ---- where they cross ---- */

/* Where one use ends and the next begins they meet; a crossing there is a miss of tracing. */
static bool is_joint(const bat_passages *all, const bat_crossing *crossing, const double at[2])
{
    const int a = crossing->curve[0], b = crossing->curve[1];
    const double *joint = all->at[a].next == b   ? all->at[b].start
                          : all->at[b].next == a ? all->at[a].start
                                                 : NULL;
    if (joint && bat_distance(2, at, joint) <= BAT_ONE_PLACE)
        return true;
    return all->at[a].next == b && all->at[b].next == a &&
           bat_distance(2, at, all->at[a].start) <= BAT_ONE_PLACE;
}

batten_status bat_passages_cross(const bat_passages *all, bat_crossings *out)
{
    const batten_curve **curves = bat_array((size_t)all->count, sizeof *curves);
    bat_crossings found = {0};
    if (!curves)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < all->count; i++)
        curves[i] = all->at[i].curve;
    batten_status status = bat_crossings_find(all->count, curves, false, &found);
    int kept = 0;
    for (int i = 0; i < found.count && status == BATTEN_OK; i++) {
        double at[2];
        status = batten_curve_evaluate(curves[found.at[i].curve[0]], found.at[i].u[0], 0, at);
        if (status == BATTEN_OK && !is_joint(all, &found.at[i], at))
            found.at[kept++] = found.at[i];
    }
    found.count = kept;
    bat_release(curves);
    if (status == BATTEN_OK)
        *out = found;
    else
        bat_release(found.at);
    return status;
}

/* ---- what crossings leave open ---- */

/* How long the loops are up to each use, by chords of the edges. */
static batten_status set_lengths(const batten_body_parts *p, bat_passages *all)
{
    enum { STEPS = 8 };
    for (int i = 0; i < all->count; i++) {
        bat_passage *one = &all->at[i];
        const batten_curve *curve = p->edges[p->uses[one->use].edge].curve;
        double last[3], here[3];
        for (int k = 0; curve && k <= STEPS; k++, memcpy(last, here, sizeof last)) {
            const batten_interval on = batten_curve_domain(curve);
            const double t = k < STEPS ? on.a + (on.b - on.a) * k / STEPS : on.b;
            const batten_status status = batten_curve_evaluate(curve, t, 0, here);
            if (status != BATTEN_OK)
                return status;
            one->length += k > 0 ? bat_distance(3, last, here) : 0;
        }
        if (one->next > i)
            all->at[one->next].before = one->before + one->length;
    }
    return BATTEN_OK;
}

static double length_of_loop(const bat_passages *all, int of)
{
    int last = of;
    while (all->at[last].next > last)
        last = all->at[last].next;
    return all->at[last].before + all->at[last].length;
}

/* A crossing divides its loop in two; of two loops it is the shorter that is in doubt. */
static double doubtful_length(const bat_passages *all, const bat_crossing *crossing)
{
    double place[2], total[2];
    for (int k = 0; k < 2; k++) {
        const bat_passage *one = &all->at[crossing->curve[k]];
        const batten_interval on = batten_curve_domain(one->curve);
        place[k] = one->before + one->length * (crossing->u[k] - on.a) / (on.b - on.a);
        total[k] = length_of_loop(all, crossing->curve[k]);
    }
    if (all->at[crossing->curve[0]].loop != all->at[crossing->curve[1]].loop)
        return bat_min(total[0], total[1]);
    const double part = fabs(place[1] - place[0]);
    return bat_min(part, total[0] - part);
}

batten_status bat_loops_doubt(const batten_body_parts *parts, int face, double *area)
{
    bat_passages all;
    bat_crossings found = {0};
    *area = 0;
    batten_status status = bat_passages_gather(parts, face, &all);
    if (status == BATTEN_OK)
        status = bat_passages_cross(&all, &found);
    if (status == BATTEN_OK && found.count > 0)
        status = set_lengths(parts, &all);
    for (int i = 0; i < found.count && status == BATTEN_OK; i++) {
        const double length = doubtful_length(&all, &found.at[i]);
        *area += length * length / bat_acos(-1);
    }
    bat_release(found.at);
    bat_passages_release(&all);
    return status;
}
