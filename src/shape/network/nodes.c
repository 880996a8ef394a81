/* Where each profile meets each guide. */
#include "base/plural.h"
#include "numeric/vector.h"
#include "shape/network/gordon.h"

#include <batten/text.h>

/* A parameter whose point is hardly away from an end of the curve is that end. */
static batten_status snap(const bat_network *net, const bat_network_curve *c, double *at)
{
    double ends[2][3], here[3];
    batten_status status = batten_curve_evaluate(c->curve, 0, 0, ends[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(c->curve, 1, 0, ends[1]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(c->curve, *at, 0, here);
    if (status != BATTEN_OK)
        return status;
    const double near = bat_network_snap(net);
    if (*at < 0.5 ? bat_distance(3, here, ends[0]) <= near
                  : !c->closed && bat_distance(3, here, ends[1]) <= near)
        *at = *at < 0.5 ? 0 : 1;
    else if (c->closed && *at > 0.5 && bat_distance(3, here, ends[1]) <= near)
        *at = 0;
    return BATTEN_OK;
}

/* Two meetings that are one: at the seam of a closed curve, or anywhere on a point. */
static bool are_one(const bat_network *net, const bat_network_curve *profile,
                    const bat_network_curve *guide, const bat_meeting *a, const bat_meeting *b)
{
    const double near = bat_max(2 * net->same, bat_min(2 * net->gap, net->size / 1000));
    const bool far_s = fabs(a->at[0] - b->at[0]) > 0.5, far_t = fabs(a->at[1] - b->at[1]) > 0.5;
    return bat_distance(3, a->point[0], b->point[0]) <= near &&
           bat_distance(3, a->point[1], b->point[1]) <= near &&
           (!far_s || profile->closed || profile->point) &&
           (!far_t || guide->closed || guide->point);
}

/* ---- pairs that miss each other ---- */

/* How many, and the worst of them. */
enum { WORST = 3 };
typedef struct {
    int count;
    struct {
        const bat_network_curve *profile, *guide;
        bat_meeting nearest;
    } worst[WORST];
} misses;

static void note_miss(misses *all, const bat_network_curve *profile,
                      const bat_network_curve *guide, const bat_meeting *nearest)
{
    int i = bat_min_int(all->count++, WORST);
    while (i > 0 && all->worst[i - 1].nearest.distance < nearest->distance) {
        if (i < WORST)
            all->worst[i] = all->worst[i - 1];
        i--;
    }
    if (i < WORST) {
        all->worst[i].profile = profile;
        all->worst[i].guide = guide;
        all->worst[i].nearest = *nearest;
    }
}

/* "a misses b by 0.12 near ..": in the caller's unit. */
static batten_status refuse_misses(const bat_network *net, const misses *all)
{
    enum { LINE = 2 * BAT_NETWORK_LABEL + 100 };
    char text[WORST][LINE] = {"", "", ""};
    const int shown = bat_min_int(all->count, WORST);
    for (int i = 0; i < shown; i++) {
        char names[2][BAT_NETWORK_LABEL];
        const bat_meeting *m = &all->worst[i].nearest;
        const double *p = m->point[0], s = net->scale;
        batten_text_print(text[i], LINE, "%s%s misses %s by %g near (%g, %g, %g)",
                          i > 0 ? "; " : "",
                          bat_network_label(net, 0, all->worst[i].profile, names[0]),
                          bat_network_label(net, 1, all->worst[i].guide, names[1]),
                          m->distance / s, p[0] / s, p[1] / s, p[2] / s);
    }
    const double widest = all->worst[0].nearest.distance;
    char advice[60] = "";
    if (widest < net->size / 100) /* more is no gap, but another curve */
        batten_text_print(advice, sizeof advice, "; a gap of %.2g would join them",
                          1.01 * widest / net->scale);
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "%s%s%s: more than the gap allowed, %g; of %d pairs %d %s apart%s%s",
                    text[0], text[1], text[2], net->gap / net->scale,
                    net->family[0].given * net->family[1].given, all->count,
                    bat_one_or_many(all->count, "is", "are"),
                    all->count > WORST ? ", these are the worst" : "", advice);
}

static batten_status meets_twice(const bat_network *net, const bat_network_curve *profile,
                                 const bat_network_curve *guide, const bat_meetings *m)
{
    char names[2][BAT_NETWORK_LABEL];
    const double *p = m->found[0].point[0], *q = m->found[1].point[0], s = net->scale;
    bat_network_label(net, 0, profile, names[0]);
    bat_network_label(net, 1, guide, names[1]);
    if (m->more)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "%s and %s meet in more than %d places, or run along each other, near "
                        "(%g, %g, %g)",
                        names[0], names[1], (int)BAT_MEETINGS, p[0] / s, p[1] / s, p[2] / s);
    return bat_fail(
        BATTEN_NOT_COMPATIBLE,
        "%s and %s meet twice, at (%g, %g, %g) and (%g, %g, %g), %.3g and %.3g apart "
        "there; in a network they meet once",
        names[0], names[1], p[0] / s, p[1] / s, p[2] / s, q[0] / s, q[1] / s, q[2] / s,
        m->found[0].distance / s, m->found[1].distance / s);
}

/* ---- the pairs ---- */

/* All places where two curves meet as closely as they do anywhere, but for a factor: so what
 * comes within the gap elsewhere, as both sides of a thin edge, is no second meeting. */
static batten_status find_closest(bat_network *net, const bat_network_curve *profile,
                                  const bat_network_curve *guide, bat_meetings *m)
{
    batten_status status =
        bat_meetings_find(&profile->trace, &guide->trace, net->same, &net->work, m);
    if (status == BATTEN_OK && m->count == 0 && m->nearest.distance <= net->gap)
        status = bat_meetings_find(&profile->trace, &guide->trace,
                                   bat_min(net->gap, 4 * m->nearest.distance), &net->work, m);
    return status;
}

static void count_gap(bat_network *net, bat_network_curve *profile, bat_network_curve *guide,
                      double distance)
{
    profile->gap = bat_max(profile->gap, distance);
    guide->gap = bat_max(guide->gap, distance);
    if (distance / net->scale <= net->report.gap)
        return;
    net->report.gap = distance / net->scale;
    net->report.gap_profile = profile->index;
    net->report.gap_guide = guide->index;
}

/* The one place in which two curves meet, or that they miss each other. */
static batten_status find_node(bat_network *net, int j, int i, const bat_network_pairs *pairs,
                               misses *missed)
{
    bat_network_curve *profile = &net->family[0].curves[j], *guide = &net->family[1].curves[i];
    const int at = bat_network_pair(net, 0, j, i);
    bat_meetings m;
    const batten_status status = find_closest(net, profile, guide, &m);
    if (status != BATTEN_OK)
        return status;
    if (m.count == 0) {
        note_miss(missed, profile, guide, &m.nearest);
        return BATTEN_OK;
    }
    bat_meeting best = m.found[0];
    for (int k = 1; k < m.count; k++) {
        if (!are_one(net, profile, guide, &m.found[0], &m.found[k]))
            return meets_twice(net, profile, guide, &m);
        if (m.found[k].distance < best.distance)
            best = m.found[k];
    }
    if (m.more)
        return meets_twice(net, profile, guide, &m);
    count_gap(net, profile, guide, best.distance);
    pairs->distance[at] = best.distance;
    for (int k = 0; k < 2; k++)
        pairs->at[k][at] = best.at[k];
    for (int c = 0; c < 3; c++)
        pairs->points[3 * at + c] = (best.point[0][c] + best.point[1][c]) / 2;
    return BATTEN_OK;
}

static batten_status find_pairs(bat_network *net, const bat_network_pairs *pairs)
{
    misses missed = {0};
    const int n = net->family[0].count, m = net->family[1].count;
    batten_status status = BATTEN_OK;
    for (int j = 0; status == BATTEN_OK && j < n; j++)
        for (int i = 0; status == BATTEN_OK && i < m; i++)
            status = find_node(net, j, i, pairs, &missed);
    return status == BATTEN_OK && missed.count > 0 ? refuse_misses(net, &missed) : status;
}

static batten_status snap_pairs(const bat_network *net, const bat_network_pairs *pairs)
{
    const int n = net->family[0].count, m = net->family[1].count;
    batten_status status = BATTEN_OK;
    for (int j = 0; status == BATTEN_OK && j < n; j++)
        for (int i = 0; status == BATTEN_OK && i < m; i++) {
            const int at = bat_network_pair(net, 0, j, i);
            status = snap(net, bat_network_at(net, 0, j), &pairs->at[0][at]);
            if (status == BATTEN_OK)
                status = snap(net, bat_network_at(net, 1, i), &pairs->at[1][at]);
        }
    return status;
}

/* ---- the whole ---- */

batten_status bat_network_find_nodes(bat_network *net)
{
    const size_t rooms = (size_t)net->family[0].room * (size_t)net->family[1].room;
    bat_network_pairs pairs;
    for (int k = 0; k < 2; k++)
        pairs.at[k] = bat_array(rooms, sizeof(double));
    pairs.points = bat_array3(rooms, 3, sizeof(double));
    pairs.distance = bat_array(rooms, sizeof(double));
    batten_status status = pairs.at[0] && pairs.at[1] && pairs.points && pairs.distance
                               ? BATTEN_OK
                               : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_pairs(net, &pairs);
    if (status == BATTEN_OK)
        status = bat_network_find_closed(net, &pairs);
    if (status == BATTEN_OK)
        status = snap_pairs(net, &pairs);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = bat_network_drop_repeated(net, &pairs, k);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = bat_network_find_poles(net, &pairs, k);
    if (status == BATTEN_OK)
        status = bat_network_order(net, &pairs);
    for (int k = 0; k < 2; k++)
        bat_release(pairs.at[k]);
    bat_release(pairs.points);
    bat_release(pairs.distance);
    return status;
}
