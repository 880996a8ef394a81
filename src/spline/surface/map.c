/* Changes that leave the structure: directions swapped, weights, one point. */
#include "spline/surface/change.h"

#include <string.h>

batten_status batten_surface_swap(const batten_surface *surface, batten_surface **out)
{
    assert(surface && out);
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    const bat_nurbs_shape from = bat_nurbs_shape_of(nurbs);
    const bat_nurbs_shape shape = {from.dimension,
                                   {from.degree[1], from.degree[0]},
                                   {from.count[1], from.count[0]},
                                   {from.periodic[1], from.periodic[0]},
                                   from.rational};
    bat_nurbs *made;
    const batten_status status = bat_nurbs_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < 2; k++)
        memcpy(made->axes[1 - k].knots, nurbs->axes[k].knots,
               ((size_t)from.count[k] + (size_t)from.degree[k] + 1) * sizeof(double));
    for (int i = 0; i < from.count[0]; i++)
        for (int j = 0; j < from.count[1]; j++)
            bat_nurbs_copy_point(nurbs, i * from.count[1] + j, made, j * from.count[0] + i);
    return bat_nurbs_finish(made, out);
}

batten_status batten_surface_to_rational(const batten_surface *surface, batten_surface **out)
{
    assert(surface && out);
    bat_nurbs *made;
    const batten_status status = bat_nurbs_copy(bat_surface_nurbs(surface), true, &made);
    return status == BATTEN_OK ? bat_nurbs_finish(made, out) : status;
}

batten_status batten_surface_with_point(const batten_surface *surface, int i, int j,
                                        const double *point, batten_surface **out)
{
    assert(surface && point && out);
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    const bat_axis *u = &nurbs->axes[BATTEN_U], *v = &nurbs->axes[BATTEN_V];
    assert(i >= 0 && i < u->count && j >= 0 && j < v->count);
    bat_nurbs *made;
    const batten_status status = bat_nurbs_copy(nurbs, false, &made);
    if (status != BATTEN_OK)
        return status;
    /* The wrapped points of a periodic direction repeat: each copy moves. */
    const int period_u = bat_axis_own_count(u), period_v = bat_axis_own_count(v);
    const int d = surface->dimension;
    for (int k = i % period_u; k < u->count; k += period_u)
        for (int l = j % period_v; l < v->count; l += period_v)
            memcpy(made->points + (k * v->count + l) * d, point, (size_t)d * sizeof *point);
    return bat_nurbs_finish(made, out);
}
