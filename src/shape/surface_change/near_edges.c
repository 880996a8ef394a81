/* The edges at which two surfaces are nearest to each other. */
#include "shape/surface_change/near_edges.h"

#include "numeric/vector.h"
#include "shape/boundary/edge_fit.h"
#include "spline/surface/surface.h"
#include <batten/continuity.h>

void bat_on_edge(const batten_surface *surface, batten_edge edge, double t, double at[2])
{
    const batten_direction along = bat_edge_of(surface, edge).along;
    const batten_interval u = batten_surface_domain(surface, BATTEN_U),
                          v = batten_surface_domain(surface, BATTEN_V);
    const batten_interval range = along == BATTEN_U ? u : v;
    at[along] = t < 1 ? range.a + t * (range.b - range.a) : range.b;
    at[bat_other(along)] = edge == BATTEN_EDGE_V0   ? v.a
                           : edge == BATTEN_EDGE_V1 ? v.b
                           : edge == BATTEN_EDGE_U0 ? u.a
                                                    : u.b;
}

static batten_status edge_point(const batten_surface *surface, batten_edge edge, double t,
                                double out[3])
{
    double at[2];
    bat_on_edge(surface, edge, t, at);
    return batten_surface_evaluate(surface, at[0], at[1], 0, out);
}

static batten_status edge_ends(const batten_surface *surface, batten_edge edge,
                               double ends[2][3])
{
    const batten_status status = edge_point(surface, edge, 0, ends[0]);
    return status == BATTEN_OK ? edge_point(surface, edge, 1, ends[1]) : status;
}

/* How far the ends of two edges are apart, in the better one of the two orders. */
static double ends_apart(double a[2][3], double b[2][3])
{
    return bat_min(bat_max(bat_distance(3, a[0], b[0]), bat_distance(3, a[1], b[1])),
                   bat_max(bat_distance(3, a[0], b[1]), bat_distance(3, a[1], b[0])));
}

batten_status batten_surfaces_near_edges(const batten_surface *first,
                                         const batten_surface *second, batten_edge *first_edge,
                                         batten_edge *second_edge, double *apart)
{
    assert(first && second && first_edge && second_edge);
    if (first->dimension != 3 || second->dimension != 3)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the surfaces have the dimensions %d and %d",
                        first->dimension, second->dimension);
    double best = INFINITY;
    batten_edge nearest[2] = {BATTEN_EDGE_V0, BATTEN_EDGE_V0};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            double a[2][3], b[2][3];
            batten_status status = edge_ends(first, (batten_edge)i, a);
            if (status == BATTEN_OK)
                status = edge_ends(second, (batten_edge)j, b);
            if (status != BATTEN_OK)
                return status;
            const double distance = ends_apart(a, b);
            if (!(distance < best))
                continue;
            best = distance;
            nearest[0] = (batten_edge)i;
            nearest[1] = (batten_edge)j;
        }
    *first_edge = nearest[0];
    *second_edge = nearest[1];
    if (apart)
        *apart = best;
    return BATTEN_OK;
}
