/* Which surface lies beside a curve, and its ribbon along it. */
#include "base/base.h"
#include "numeric/rounding.h"
#include "shape/boundary/edge_fit.h"
#include <batten/fill.h>

/* A parameter, or the break that it is but for rounding: no sliver of a span is left. */
static batten_status settle_on_break(const batten_curve *curve, double *at)
{
    const batten_interval domain = batten_curve_domain(curve);
    double *breaks = bat_array((size_t)batten_curve_point_count(curve) + 1, sizeof *breaks);
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    const int count = batten_curve_spans(curve, breaks);
    for (int i = 0; i < count; i++)
        if (fabs(*at - breaks[i]) < BAT_MEANT_SAME * (domain.b - domain.a)) {
            *at = breaks[i];
            break;
        }
    bat_release(breaks);
    return BATTEN_OK;
}

/* The part of the ribbon along the curve. */
static batten_status take_ribbon(const batten_surface *surface, batten_edge edge,
                                 batten_interval part, int order, double tolerance,
                                 batten_curve **curves)
{
    batten_curve *whole[3] = {NULL}, *cut[3] = {NULL};
    batten_status status = batten_edge_ribbon(surface, edge, order, tolerance, NULL, whole);
    if (status == BATTEN_OK)
        status = settle_on_break(whole[0], &part.a);
    if (status == BATTEN_OK)
        status = settle_on_break(whole[0], &part.b);
    for (int k = 0; status == BATTEN_OK && k <= order; k++)
        status = batten_curve_subrange(whole[k], part.a, part.b, &cut[k]);
    for (int k = 0; k <= order; k++) {
        if (status == BATTEN_OK)
            curves[k] = cut[k];
        else
            batten_curve_unref(cut[k]);
        batten_curve_unref(whole[k]);
    }
    return status;
}

batten_status batten_ribbon_beside(const batten_curve *curve, batten_surface_row surfaces,
                                   int order, double tolerance, int *surface,
                                   batten_curve **curves)
{
    assert(order == 1 || order == 2);
    for (int i = 0; i < surfaces.count; i++) {
        batten_edge edge = BATTEN_EDGE_V0;
        double at[2] = {0, 0};
        batten_status status = bat_edge_beside(surfaces.at[i], curve, tolerance, &edge, at);
        if (status == BATTEN_NOT_FOUND)
            continue;
        const batten_interval part = {bat_min(at[0], at[1]), bat_max(at[0], at[1])};
        if (status == BATTEN_OK)
            status = take_ribbon(surfaces.at[i], edge, part, order, tolerance, curves);
        if (status == BATTEN_OK)
            *surface = i;
        return status;
    }
    *surface = -1;
    return BATTEN_OK;
}
