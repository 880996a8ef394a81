/* Which surface lies beside a curve, and its ribbon along it. */
#include "base/base.h"
#include <batten/fill.h>
#include <batten/inspect.h>

enum { LOOKS = 17, EDGES = 4 };

/* The place of an end of the curve on the edge, when it is near. */
static batten_status foot_of(const batten_curve *edge, const double point[3], double tolerance,
                             double *at, bool *near)
{
    batten_deviation deviation;
    const batten_status status =
        batten_curve_deviation(edge, 1, point, NULL, NULL, NULL, &deviation);
    if (status != BATTEN_OK)
        return status;
    *at = deviation.at[0];
    *near = deviation.max <= tolerance;
    return BATTEN_OK;
}

/* Does the whole curve lie on the edge, and from where to where? */
static batten_status lies_on(const batten_curve *curve, const batten_curve *edge,
                             double tolerance, batten_interval *part, bool *found)
{
    const batten_interval domain = batten_curve_domain(curve);
    double points[LOOKS][3], ends[2];
    *found = false;
    for (int k = 0; k < LOOKS; k++) {
        const double t = (double)k / (LOOKS - 1);
        const batten_status status =
            batten_curve_evaluate(curve, (1 - t) * domain.a + t * domain.b, 0, points[k]);
        if (status != BATTEN_OK)
            return status;
    }
    for (int end = 0; end < 2; end++) {
        bool near;
        const batten_status status =
            foot_of(edge, points[end == 0 ? 0 : LOOKS - 1], tolerance, &ends[end], &near);
        if (status != BATTEN_OK || !near)
            return status;
    }
    *part = (batten_interval){bat_min(ends[0], ends[1]), bat_max(ends[0], ends[1])};
    if (!(part->a < part->b))
        return BATTEN_OK;
    batten_deviation deviation;
    const batten_status status =
        batten_curve_deviation(edge, LOOKS, points[0], NULL, NULL, NULL, &deviation);
    *found = status == BATTEN_OK && deviation.max <= tolerance;
    return status;
}

static const struct {
    batten_direction fixed;
    bool high;
} edges[EDGES] = {[BATTEN_EDGE_V0] = {BATTEN_V, false},
                  [BATTEN_EDGE_U1] = {BATTEN_U, true},
                  [BATTEN_EDGE_V1] = {BATTEN_V, true},
                  [BATTEN_EDGE_U0] = {BATTEN_U, false}};

static batten_status looks_at_edge(const batten_curve *curve, const batten_surface *surface,
                                   int edge, double tolerance, batten_interval *part,
                                   bool *found)
{
    const batten_interval across = batten_surface_domain(surface, edges[edge].fixed);
    batten_curve *side = NULL;
    batten_status status = batten_surface_isocurve(
        surface, edges[edge].fixed, edges[edge].high ? across.b : across.a, &side);
    if (status == BATTEN_OK)
        status = lies_on(curve, side, tolerance, part, found);
    batten_curve_unref(side);
    return status;
}

/* The part of the ribbon along the curve; parts that end within rounding of the edge's ends
 * are taken to end there. */
static batten_status take_ribbon(const batten_surface *surface, int edge, batten_interval part,
                                 int order, double tolerance, batten_curve **curves)
{
    batten_curve *whole[3] = {NULL}, *cut[3] = {NULL};
    batten_status status =
        batten_edge_ribbon(surface, (batten_edge)edge, order, tolerance, whole, NULL);
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
    for (int i = 0; i < count; i++)
        for (int edge = 0; edge < EDGES; edge++) {
            batten_interval part = {0, 0};
            bool found = false;
            batten_status status =
                looks_at_edge(curve, surfaces[i], edge, tolerance, &part, &found);
            if (status == BATTEN_OK && found)
                status = take_ribbon(surfaces[i], edge, part, order, tolerance, curves);
            if (status == BATTEN_OK && found)
                *surface = i;
            if (status != BATTEN_OK || found)
                return status;
        }
    *surface = -1;
    return BATTEN_OK;
}
