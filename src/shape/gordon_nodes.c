/* Where each profile meets each guide; curves that were given twice; poles. */
#include "numeric/vector.h"
#include "shape/gordon.h"
#include <batten/inspect.h>

#include <string.h>

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
                               const bat_network_curve *guide, double *s, double *t)
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
    status = snap(net, profile, s);
    return status == BATTEN_OK ? snap(net, guide, t) : status;
}

static batten_status find_pairs(bat_network *net, bat_network_pairs *pairs)
{
    const int n = net->family[0].count, m = net->family[1].count;
    batten_status status = BATTEN_OK;
    for (int j = 0; status == BATTEN_OK && j < n; j++)
        for (int i = 0; status == BATTEN_OK && i < m; i++)
            status = find_node(net, bat_network_at(net, 0, j), bat_network_at(net, 1, i),
                               &pairs->at[0][j * net->family[1].room + i],
                               &pairs->at[1][j * net->family[1].room + i]);
    return status;
}

/* ---- curves given twice ---- */

/* The parameter of the node of curve k of a family with curve l of the other one, on the curve
 * of family `on`. */
static double pair_at(const bat_network *net, const bat_network_pairs *pairs, int family, int k,
                      int l, int on)
{
    const int j = family == 0 ? k : l, i = family == 0 ? l : k;
    return pairs->at[on][j * net->family[1].room + i];
}

/* Do curves a and b of a family meet all others in the same points? *first is the other one
 * where they do, when not everywhere. */
static batten_status share_nodes(const bat_network *net, const bat_network_pairs *pairs,
                                 int family, int a, int b, int *shared, int *first)
{
    const bat_network_family *across = &net->family[1 - family];
    *shared = 0;
    for (int l = 0; l < across->count; l++) {
        double here[3], there[3];
        const bat_network_curve *c = &across->curves[l];
        batten_status status = batten_curve_evaluate(
            c->curve, pair_at(net, pairs, family, a, l, 1 - family), 0, here);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(
                c->curve, pair_at(net, pairs, family, b, l, 1 - family), 0, there);
        if (status != BATTEN_OK)
            return status;
        if (c->point || bat_distance(3, here, there) > 2 * net->tolerance)
            continue;
        if ((*shared)++ == 0)
            *first = l;
    }
    return BATTEN_OK;
}

static void drop(bat_network *net, bat_network_pairs *pairs, int family, int k)
{
    bat_network_family *f = &net->family[family];
    const int room = net->family[1].room;
    batten_curve_unref(f->curves[k].curve);
    bat_trace_free(&f->curves[k].trace);
    for (int on = 0; on < 2; on++) {
        double *at = pairs->at[on];
        if (family == 0)
            memmove(at + k * room, at + (k + 1) * room,
                    (size_t)((f->count - 1 - k) * room) * sizeof *at);
        else
            for (int j = 0; j < net->family[0].count; j++)
                memmove(at + j * room + k, at + j * room + k + 1,
                        (size_t)(f->count - 1 - k) * sizeof *at);
    }
    f->count--;
    memmove(f->curves + k, f->curves + k + 1, (size_t)(f->count - k) * sizeof *f->curves);
    f->curves[f->count] = (bat_network_curve){0};
    net->report.repeated_count++;
}

/* How far b is from a, from 65 places of it. */
static batten_status apart(const bat_network_curve *a, const bat_network_curve *b,
                           double *distance)
{
    enum { PLACES = 65 };
    double points[3 * PLACES];
    batten_deviation found;
    for (int i = 0; i < PLACES; i++) {
        const batten_status status =
            batten_curve_evaluate(b->curve, i / (PLACES - 1.0), 0, points + 3 * i);
        if (status != BATTEN_OK)
            return status;
    }
    const batten_status status =
        batten_curve_deviation(a->curve, PLACES, points, NULL, NULL, NULL, &found);
    *distance = found.max;
    return status;
}

/* Two curves of a family that meet another one in the same point are one curve, at the seam of
 * closed ones; else the network is none. */
static batten_status drop_repeated(bat_network *net, bat_network_pairs *pairs, int family)
{
    bat_network_family *f = &net->family[family];
    for (int a = 0; a < f->count; a++)
        for (int b = a + 1; b < f->count;) {
            int shared = 0, first = 0;
            double distance = HUGE_VAL;
            batten_status status = share_nodes(net, pairs, family, a, b, &shared, &first);
            if (status == BATTEN_OK && shared > 0 && !f->curves[a].point && !f->curves[b].point)
                status = apart(&f->curves[a], &f->curves[b], &distance);
            if (status != BATTEN_OK)
                return status;
            char names[3][BAT_NETWORK_LABEL];
            const bat_network_curve *met = &net->family[1 - family].curves[first];
            if (shared == 0)
                b++;
            else if (distance <= 2 * net->tolerance && met->closed)
                drop(net, pairs, family, b);
            else
                return bat_fail(BATTEN_COINCIDENT, "%s and %s meet %s in the same point",
                                bat_network_label(net, family, &f->curves[a], names[0]),
                                bat_network_label(net, family, &f->curves[b], names[1]),
                                bat_network_label(net, 1 - family, met, names[2]));
        }
    return BATTEN_OK;
}

/* ---- poles ---- */

static batten_status end_of(const bat_network_curve *c, int end, double *point)
{
    return batten_curve_evaluate(c->curve, end, 0, point);
}

/* Does each curve of a family end in `point`? */
static batten_status all_end_in(const bat_network *net, int family, const double *point,
                                bool *all)
{
    const bat_network_family *f = &net->family[family];
    *all = f->count > 1;
    for (int k = 0; k < f->count && *all; k++) {
        double ends[2][3];
        batten_status status = end_of(&f->curves[k], 0, ends[0]);
        if (status == BATTEN_OK)
            status = end_of(&f->curves[k], 1, ends[1]);
        if (status != BATTEN_OK)
            return status;
        *all = !f->curves[k].point && !f->curves[k].closed &&
               (bat_distance(3, ends[0], point) <= net->tolerance ||
                bat_distance(3, ends[1], point) <= net->tolerance);
    }
    return BATTEN_OK;
}

/* Does a curve of the other family meet the first curve of this one at that end? */
static bool end_is_taken(const bat_network *net, const bat_network_pairs *pairs, int family,
                         int end)
{
    for (int l = 0; l < net->family[1 - family].count; l++)
        if (pair_at(net, pairs, family, 0, l, family) == end)
            return true;
    return false;
}

static batten_status point_curve(const double *point, batten_curve **out)
{
    static const double knots[] = {0, 0, 1, 1};
    const double points[] = {point[0], point[1], point[2], point[0], point[1], point[2]};
    return batten_curve_create(3, 1, 2, points, NULL, knots, out);
}

/* A curve of the other family that is but this point. */
static batten_status add_pole(bat_network *net, bat_network_pairs *pairs, int family,
                              const double *point)
{
    bat_network_family *across = &net->family[1 - family];
    bat_network_curve *pole = &across->curves[across->count];
    const int l = across->count, room = net->family[1].room;
    batten_status status = point_curve(point, &pole->curve);
    if (status != BATTEN_OK)
        return status;
    pole->index = -1;
    pole->point = true;
    across->count++;
    net->report.pole_count++;
    for (int k = 0; k < net->family[family].count; k++) {
        double start[3];
        status = end_of(&net->family[family].curves[k], 0, start);
        if (status != BATTEN_OK)
            return status;
        const int at = family == 0 ? k * room + l : l * room + k;
        pairs->at[family][at] = bat_distance(3, start, point) <= net->tolerance ? 0 : 1;
        pairs->at[1 - family][at] = 0.5;
    }
    return BATTEN_OK;
}

static batten_status find_poles(bat_network *net, bat_network_pairs *pairs, int family)
{
    for (int end = 0; end < 2; end++) {
        double point[3];
        bool all = false;
        batten_status status = end_of(&net->family[family].curves[0], end, point);
        if (status == BATTEN_OK)
            status = all_end_in(net, family, point, &all);
        if (status == BATTEN_OK && all && !end_is_taken(net, pairs, family, end))
            status = add_pole(net, pairs, family, point);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* ---- the whole ---- */

batten_status bat_network_find_nodes(bat_network *net)
{
    const size_t rooms = (size_t)net->family[0].room * (size_t)net->family[1].room;
    bat_network_pairs pairs;
    for (int k = 0; k < 2; k++)
        pairs.at[k] = bat_array(rooms, sizeof(double));
    batten_status status = pairs.at[0] && pairs.at[1] ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_pairs(net, &pairs);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = drop_repeated(net, &pairs, k);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = find_poles(net, &pairs, k);
    if (status == BATTEN_OK)
        status = bat_network_order(net, &pairs);
    for (int k = 0; k < 2; k++)
        bat_release(pairs.at[k]);
    return status;
}
