/* Where each profile meets each guide. */
#include "numeric/vector.h"
#include "shape/gordon.h"

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
    const double near = net->tolerance / 16;
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
    const double near = 2 * net->tolerance;
    const bool far_s = fabs(a->at[0] - b->at[0]) > 0.5, far_t = fabs(a->at[1] - b->at[1]) > 0.5;
    return bat_distance(3, a->point[0], b->point[0]) <= near &&
           bat_distance(3, a->point[1], b->point[1]) <= near &&
           (!far_s || profile->closed || profile->point) &&
           (!far_t || guide->closed || guide->point);
}

/* "a misses b by 0.12": in the caller's unit. */
static batten_status missed(const bat_network *net, const bat_network_curve *profile,
                            const bat_network_curve *guide, const bat_meeting *nearest)
{
    char names[2][BAT_NETWORK_LABEL];
    const double *p = nearest->point[0];
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "%s misses %s by %g near (%g, %g, %g), more than the tolerance %g",
                    bat_network_label(net, 0, profile, names[0]),
                    bat_network_label(net, 1, guide, names[1]), nearest->distance / net->scale,
                    p[0] / net->scale, p[1] / net->scale, p[2] / net->scale,
                    net->options->tolerance);
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
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "%s and %s meet twice, at (%g, %g, %g) and (%g, %g, %g); in a network they "
                    "meet once",
                    names[0], names[1], p[0] / s, p[1] / s, p[2] / s, q[0] / s, q[1] / s,
                    q[2] / s);
}

/* The one place in which two curves meet. */
static batten_status find_node(bat_network *net, const bat_network_curve *profile,
                               const bat_network_curve *guide, double *s, double *t,
                               double *point)
{
    bat_meetings m;
    batten_status status =
        bat_meetings_find(&profile->trace, &guide->trace, net->tolerance, &net->work, &m);
    if (status != BATTEN_OK)
        return status;
    if (m.count == 0)
        return missed(net, profile, guide, &m.nearest);
    bat_meeting best = m.found[0];
    for (int i = 1; i < m.count; i++) {
        if (!are_one(net, profile, guide, &m.found[0], &m.found[i]))
            return meets_twice(net, profile, guide, &m);
        if (m.found[i].distance < best.distance)
            best = m.found[i];
    }
    if (m.more)
        return meets_twice(net, profile, guide, &m);
    if (best.distance / net->scale > net->report.gap) {
        net->report.gap = best.distance / net->scale;
        net->report.gap_profile = profile->index;
        net->report.gap_guide = guide->index;
    }
    *s = best.at[0];
    *t = best.at[1];
    for (int c = 0; c < 3; c++)
        point[c] = (best.point[0][c] + best.point[1][c]) / 2;
    status = snap(net, profile, s);
    return status == BATTEN_OK ? snap(net, guide, t) : status;
}

static batten_status find_pairs(bat_network *net, bat_network_pairs *pairs)
{
    const int n = net->family[0].count, m = net->family[1].count;
    batten_status status = BATTEN_OK;
    for (int j = 0; status == BATTEN_OK && j < n; j++)
        for (int i = 0; status == BATTEN_OK && i < m; i++) {
            const int at = bat_network_pair(net, 0, j, i);
            status = find_node(net, bat_network_at(net, 0, j), bat_network_at(net, 1, i),
                               &pairs->at[0][at], &pairs->at[1][at], pairs->points + 3 * at);
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
    batten_status status =
        pairs.at[0] && pairs.at[1] && pairs.points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_pairs(net, &pairs);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = bat_network_drop_repeated(net, &pairs, k);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = bat_network_find_poles(net, &pairs, k);
    if (status == BATTEN_OK)
        status = bat_network_order(net, &pairs);
    for (int k = 0; k < 2; k++)
        bat_release(pairs.at[k]);
    bat_release(pairs.points);
    return status;
}
