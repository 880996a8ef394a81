/* A curve of a network is cut to it, turned to run with the others, begun where they begin. */
#include "numeric/vector.h"
#include "shape/network/gordon.h"
#include "spline/curve/curve.h"

#include <string.h>

static batten_status over_unit(batten_curve **curve)
{
    batten_curve *next = NULL;
    const batten_status status = batten_curve_set_domain(*curve, 0, 1, &next);
    if (status == BATTEN_OK)
        bat_curve_take(curve, next);
    return status;
}

static batten_status reverse(bat_network *net, bat_network_curve *c, int count, double *nodes)
{
    batten_curve *next = NULL;
    batten_status status = batten_curve_reverse(c->curve, &next);
    if (status != BATTEN_OK)
        return status;
    bat_curve_take(&c->curve, next);
    for (int i = 0; i < count; i++)
        nodes[i] = 1 - nodes[i];
    net->report.reversed_count++;
    return over_unit(&c->curve);
}

static batten_status ends_of(const batten_curve *curve, double a, double b, double *first,
                             double *last)
{
    const batten_status status = batten_curve_evaluate(curve, a, 0, first);
    return status == BATTEN_OK ? batten_curve_evaluate(curve, b, 0, last) : status;
}

/* A closed curve begins at u; its ends meet halfway. */
static batten_status rotate(bat_network_curve *c, double tolerance, double u)
{
    batten_curve *low = NULL, *high = NULL, *next = NULL;
    double first[3], last[3];
    batten_status status = ends_of(c->curve, 0, 1, first, last);
    if (status == BATTEN_OK)
        status = batten_curve_split(c->curve, u, &low, &high);
    if (status == BATTEN_OK)
        status = batten_curve_join(high, low, tolerance, &next);
    if (status == BATTEN_OK) {
        bat_curve_take(&c->curve, next);
        c->moved += bat_distance(3, first, last) / 2;
        status = over_unit(&c->curve);
    }
    batten_curve_unref(high);
    batten_curve_unref(low);
    return status;
}

/* What is cut off counts by the distance of its ends. */
static batten_status count_cut(bat_network *net, int family, const bat_network_curve *c,
                               double a, double b)
{
    double first[3], last[3];
    const batten_status status = ends_of(c->curve, a, b, first, last);
    if (status != BATTEN_OK)
        return status;
    const double length = bat_distance(3, first, last) / net->scale;
    char name[BAT_NETWORK_LABEL];
    if (!net->options->cut && length > net->gap / net->scale)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "%s extends %g beyond the network",
                        bat_network_label(net, family, c, name), length);
    net->report.cut = bat_max(net->report.cut, length);
    return BATTEN_OK;
}

static batten_status cut_to_network(bat_network *net, int family, bat_network_curve *c,
                                    int count, double *nodes)
{
    const double a = nodes[0], b = nodes[count - 1];
    batten_curve *next = NULL;
    if (a == 0 && b == 1)
        return BATTEN_OK;
    batten_status status = count_cut(net, family, c, 0, a);
    if (status == BATTEN_OK)
        status = count_cut(net, family, c, b, 1);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(c->curve, a, b, &next);
    if (status != BATTEN_OK)
        return status;
    bat_curve_take(&c->curve, next);
    net->report.cut_count++;
    for (int i = 0; i < count; i++)
        nodes[i] = i == count - 1 ? 1 : (nodes[i] - a) / (b - a);
    return over_unit(&c->curve);
}

batten_status bat_network_turn(bat_network *net, int family, bat_network_curve *c, int count,
                               const double *ranked, bool reversed)
{
    const bool closed = net->family[family].closed;
    bat_trace_free(&c->trace);
    c->trace = (bat_trace){0};
    c->at = bat_array((size_t)count + 1, sizeof *c->at);
    if (!c->at)
        return BATTEN_OUT_OF_MEMORY;
    if (c->point)
        return BATTEN_OK;
    memcpy(c->at, ranked, (size_t)count * sizeof *ranked);
    batten_status status = reversed ? reverse(net, c, count, c->at) : BATTEN_OK;
    if (status != BATTEN_OK || !closed)
        return status == BATTEN_OK ? cut_to_network(net, family, c, count, c->at) : status;
    const double first = c->at[0] < 1 ? c->at[0] : 0;
    if (first > 0)
        status = rotate(c, net->gap, first);
    for (int i = 0; i < count; i++) {
        c->at[i] -= first;
        if (c->at[i] < 0 || (c->at[i] >= 1 && i == 0))
            c->at[i] += c->at[i] < 0 ? 1 : -1;
    }
    c->at[count] = 1;
    return status;
}
