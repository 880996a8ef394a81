/* Which curves of a network are one curve, and which close. */
#include "numeric/vector.h"
#include "shape/network/gordon.h"
#include <batten/nearest.h>

/* The largest distance of two curves that are one. */
static double closeness_of_same(const bat_network *net, const bat_network_curve *a,
                                const bat_network_curve *b)
{
    return bat_max(net->same, 2 * bat_max(a->gap, b->gap));
}

batten_status bat_network_are_same(const bat_network *net, const bat_network_curve *a,
                                   const bat_network_curve *b, bool *same, double *distance)
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
    const batten_status status = batten_curve_deviation(
        a->curve, (batten_points){batten_curve_dimension(a->curve), PLACES, points}, NULL, NULL,
        NULL, &found);
    *distance = found.max;
    *same = found.max <= closeness_of_same(net, a, b);
    return status;
}

/* Is the place an end of the curve? 0 or 1, or -1. */
static int end_at(const bat_network *net, double (*ends)[3], const double *point, double at)
{
    const int end = at < 0.5 ? 0 : 1;
    const double near = bat_max(
        net->same, bat_min(bat_network_snap(net), bat_distance(3, ends[0], ends[1]) / 4));
    return bat_distance(3, ends[end], point) <= near ? end : -1;
}

/* Do two different curves begin at the two ends of curve k? Then these ends are two. */
static batten_status is_slit(const bat_network *net, const bat_network_pairs *pairs, int family,
                             int k, double (*ends)[3], bool *slit)
{
    const bat_network_family *across = &net->family[1 - family];
    const bat_network_curve *c = &net->family[family].curves[k];
    int met[2] = {-1, -1};
    *slit = false;
    for (int l = 0; l < across->count; l++) {
        const double at = pairs->at[family][bat_network_pair(net, family, k, l)];
        double point[3], distance;
        bool same;
        batten_status status = batten_curve_evaluate(c->curve, at, 0, point);
        if (status != BATTEN_OK)
            return status;
        const int end = across->curves[l].point ? -1 : end_at(net, ends, point, at);
        if (end < 0)
            continue;
        met[end] = l;
        if (met[1 - end] < 0)
            continue;
        status = bat_network_are_same(net, &across->curves[met[0]], &across->curves[met[1]],
                                      &same, &distance);
        *slit = !same;
        if (status != BATTEN_OK || *slit)
            return status;
    }
    return BATTEN_OK;
}

static batten_status decide(bat_network *net, const bat_network_pairs *pairs, int family, int k)
{
    bat_network_curve *c = &net->family[family].curves[k];
    double ends[2][3];
    bool slit = false;
    batten_status status = batten_curve_evaluate(c->curve, 0, 0, ends[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(c->curve, 1, 0, ends[1]);
    if (status != BATTEN_OK)
        return status;
    const double apart = bat_distance(3, ends[0], ends[1]);
    if (apart > net->same)
        status = is_slit(net, pairs, family, k, ends, &slit);
    c->closed = !slit;
    if (status == BATTEN_OK && !slit && apart / net->scale > net->report.seam) {
        net->report.seam = apart / net->scale;
        net->report.seam_is_guide = family == 1;
        net->report.seam_curve = c->index;
    }
    return status;
}

batten_status bat_network_find_closed(bat_network *net, const bat_network_pairs *pairs)
{
    for (int family = 0; family < 2; family++) {
        bat_network_family *f = &net->family[family];
        bool all = true, some = false;
        for (int k = 0; k < f->count; k++) {
            bat_network_curve *c = &f->curves[k];
            const batten_status status = c->closed ? decide(net, pairs, family, k) : BATTEN_OK;
            if (status != BATTEN_OK)
                return status;
            all = all && (c->closed || c->point);
            some = some || c->closed;
        }
        f->closed = all && some; /* a point closes with the others */
    }
    return BATTEN_OK;
}
