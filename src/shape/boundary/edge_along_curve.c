/* Which edge of a surface runs along a curve. */
#include "numeric/vector.h"
#include "shape/boundary/edge_fit.h"
#include "spline/surface/surface.h"
#include <batten/nearest.h>

enum { PROBES = 17 };

batten_status bat_take_edge(const batten_surface *surface, batten_edge edge, double tolerance,
                            batten_curve **out)
{
    const bat_edge_place place = bat_edge_of(surface, edge);
    double error;
    if (surface->kind != &bat_nurbs_kind)
        return bat_edge_fit(surface, edge, 0, tolerance / 4, out, &error);
    return batten_surface_isocurve(surface, bat_other(place.along), place.at, out);
}

/* Points of the curve, first both ends. */
static batten_status take_points(const batten_curve *curve, double *points)
{
    const batten_interval domain = batten_curve_domain(curve);
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < PROBES; i++) {
        const double t = i == 0 ? 0 : i == 1 ? 1 : (i - 1.0) / (PROBES - 1);
        status = batten_curve_evaluate(curve, (1 - t) * domain.a + t * domain.b, 0,
                                       points + i * batten_curve_dimension(curve));
    }
    return status;
}

/* How far the points are from an edge, or only the ends where these are too far; `at` are the
 * places of the ends. */
static batten_status probe(const batten_curve *edge, const double *points, double tolerance,
                           double *far, double at[2])
{
    batten_deviation found;
    const int d = batten_curve_dimension(edge);
    batten_status status = BATTEN_OK;
    *far = 0;
    for (int e = 0; status == BATTEN_OK && e < 2; e++) {
        status = batten_curve_deviation(
            edge, (batten_points){batten_curve_dimension(edge), 1, points + e * d}, NULL, NULL,
            NULL, &found);
        if (status != BATTEN_OK)
            break;
        at[e] = found.at[0];
        *far = bat_max(*far, found.max);
    }
    if (status != BATTEN_OK || *far > tolerance)
        return status;
    status = batten_curve_deviation(
        edge, (batten_points){batten_curve_dimension(edge), PROBES, points}, NULL, NULL, NULL,
        &found);
    *far = bat_max(*far, found.max);
    return status;
}

batten_status bat_edge_beside(const batten_surface *surface, const batten_curve *curve,
                              double tolerance, batten_edge *edge, double at[2])
{
    double nearest = HUGE_VAL, points[PROBES * 3];
    batten_status status = take_points(curve, points);
    for (int e = 0; status == BATTEN_OK && e < 4; e++) {
        batten_curve *candidate = NULL;
        double far = 0, places[2] = {0, 0};
        status = bat_take_edge(surface, (batten_edge)e, tolerance, &candidate);
        if (status == BATTEN_OK)
            status = probe(candidate, points, tolerance, &far, places);
        if (status == BATTEN_OK && far < nearest && places[0] != places[1]) {
            nearest = far;
            *edge = (batten_edge)e;
            at[0] = places[0];
            at[1] = places[1];
        }
        batten_curve_unref(candidate);
    }
    if (status == BATTEN_OK && !(nearest <= tolerance))
        return bat_fail(BATTEN_NOT_FOUND,
                        "no edge of the surface runs along the curve: the nearest is %g away, "
                        "more than %g",
                        nearest, tolerance);
    return status;
}
