/* Which edges of surfaces run along edges of others: there a hull needs no lid. */
#include "hydrostatics/hull.h"
#include <batten/nearest.h>

/* So many points of an edge are looked at, and so near, as a part of the size, is on it. */
enum { SAMPLES = 17 };
static const double ON_EDGE = 1e-6;

static batten_status edge_of(const batten_surface *surface, batten_direction constant,
                             bool high, batten_curve **out)
{
    const batten_interval domain = batten_surface_domain(surface, constant);
    return batten_surface_isocurve(surface, constant, high ? domain.b : domain.a, out);
}

/* Both ends are met exactly. */
static double sample_parameter(batten_interval domain, int i)
{
    const double t = i / (SAMPLES - 1.);
    return (1 - t) * domain.a + t * domain.b;
}

static batten_status sample_edge(const batten_curve *edge, double points[SAMPLES][3])
{
    const batten_interval domain = batten_curve_domain(edge);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < SAMPLES && status == BATTEN_OK; i++)
        status = batten_curve_evaluate(edge, sample_parameter(domain, i), 0, points[i]);
    return status;
}

/* Let `nearest` be no more than the distances from one edge. */
static batten_status join_distances(const batten_curve *edge, double points[SAMPLES][3],
                                    double nearest[SAMPLES])
{
    double distances[SAMPLES];
    batten_deviation deviation;
    const batten_status status = batten_curve_deviation(
        edge, (batten_points){3, SAMPLES, points[0]}, NULL, NULL, distances, &deviation);
    for (int i = 0; i < SAMPLES && status == BATTEN_OK; i++)
        nearest[i] = bat_min(nearest[i], distances[i]);
    return status;
}

/* Does the edge under a lid run along edges of other surfaces from end to end? */
static batten_status is_joint(const batten_hull *hull, const batten_hull_lid *lid, int count,
                              const batten_surface *const *surfaces, bool *joint)
{
    double points[SAMPLES][3], nearest[SAMPLES];
    batten_curve *own = NULL;
    batten_status status = edge_of(surfaces[lid->surface], lid->direction, lid->high, &own);
    if (status == BATTEN_OK)
        status = sample_edge(own, points);
    batten_curve_unref(own);
    for (int i = 0; i < SAMPLES; i++)
        nearest[i] = INFINITY;
    for (int k = 0; k < 4 * count && status == BATTEN_OK; k++) {
        batten_curve *edge = NULL;
        if (k / 4 == lid->surface)
            continue;
        status = edge_of(surfaces[k / 4], (batten_direction)(k % 4 / 2), k % 2, &edge);
        if (status == BATTEN_OK)
            status = join_distances(edge, points, nearest);
        batten_curve_unref(edge);
    }
    *joint = true;
    for (int i = 0; i < SAMPLES; i++)
        *joint = *joint && nearest[i] <= ON_EDGE * hull->size;
    return status;
}

batten_status bat_hull_find_joints(batten_hull *hull, int count,
                                   const batten_surface *const *surfaces)
{
    int kept = 0;
    for (int k = 0; k < hull->lid_count; k++) {
        bool joint;
        const batten_status status = is_joint(hull, &hull->lids[k], count, surfaces, &joint);
        if (status != BATTEN_OK)
            return status;
        for (int i = 0; i < hull->patch_count; i++)
            if (hull->patches[i].lid == k)
                hull->patches[i].lid = joint ? BAT_JOINT : kept;
        if (!joint)
            hull->lids[kept++] = hull->lids[k];
    }
    hull->lid_count = kept;
    return BATTEN_OK;
}
