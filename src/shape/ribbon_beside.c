/* Which surface lies beside a curve, and its ribbon along it. */
#include "base/base.h"
#include "shape/ribbon_fit.h"
#include <batten/fill.h>

/* The part of the ribbon along the curve; parts that end within rounding of the edge's ends
 * are taken to end there. */
static batten_status take_ribbon(const batten_surface *surface, batten_edge edge,
                                 batten_interval part, int order, double tolerance,
                                 batten_curve **curves)
{
    batten_curve *whole[3] = {NULL}, *cut[3] = {NULL};
    batten_status status = batten_edge_ribbon(surface, edge, order, tolerance, whole, NULL);
    for (int k = 0; status == BATTEN_OK && k <= order; k++) {
        const batten_interval domain = batten_curve_domain(whole[k]);
        const double near = 1e-9 * (domain.b - domain.a);
        const double a = part.a - domain.a < near ? domain.a : part.a;
        const double b = domain.b - part.b < near ? domain.b : part.b;
        status = batten_curve_subrange(whole[k], a, b, &cut[k]);
    }
    for (int k = 0; k <= order; k++) {
        if (status == BATTEN_OK && whole[k])
            curves[k] = cut[k];
        else
            batten_curve_unref(cut[k]);
        batten_curve_unref(whole[k]);
    }
    return status;
}

batten_status batten_ribbon_beside(const batten_curve *curve, int count,
                                   const batten_surface *const *surfaces, int order,
                                   double tolerance, batten_curve **curves, int *surface)
{
    assert(order == 1 || order == 2);
    for (int i = 0; i < count; i++) {
        batten_edge edge = BATTEN_EDGE_V0;
        double at[2] = {0, 0};
        batten_status status = bat_edge_beside(surfaces[i], curve, tolerance, &edge, at);
        if (status == BATTEN_NOT_FOUND)
            continue;
        const batten_interval part = {bat_min(at[0], at[1]), bat_max(at[0], at[1])};
        if (status == BATTEN_OK)
            status = take_ribbon(surfaces[i], edge, part, order, tolerance, curves);
        if (status == BATTEN_OK)
            *surface = i;
        return status;
    }
    *surface = -1;
    return BATTEN_OK;
}
