/* Changes that leave the structure: direction, parameters, weights, position. */
#include "spline/surface/change.h"

#include "numeric/vector.h"

#include <string.h>

/* ---- directions ---- */

static void copy_point(const bat_nurbs *from, int at, bat_nurbs *to, int place)
{
    const size_t d = (size_t)from->base.dimension;
    memcpy(to->points + (size_t)place * d, from->points + (size_t)at * d,
           d * sizeof *to->points);
    if (from->weights)
        to->weights[place] = from->weights[at];
}

batten_status batten_surface_reverse(const batten_surface *surface, batten_direction direction,
                                     batten_surface **out)
{
    assert(surface && out);
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    const bat_axis *axis = &nurbs->axes[direction];
    bat_nurbs *made;
    const batten_status status = bat_nurbs_copy(nurbs, false, &made);
    if (status != BATTEN_OK)
        return status;
    bat_knots_reverse(axis->degree, axis->count, axis->knots, made->axes[direction].knots);
    const int n = nurbs->axes[BATTEN_U].count, m = nurbs->axes[BATTEN_V].count;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++)
            copy_point(nurbs, i * m + j, made,
                       direction == BATTEN_U ? (n - 1 - i) * m + j : i * m + m - 1 - j);
    return bat_nurbs_finish(made, out);
}

batten_status bat_nurbs_turn_over(const batten_surface *surface, batten_surface **out)
{
    const batten_interval u = batten_surface_domain(surface, BATTEN_U);
    batten_surface *reversed = NULL;
    batten_status status = batten_surface_reverse(surface, BATTEN_U, &reversed);
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(reversed, BATTEN_U, u.a, u.b, out);
    if (status == BATTEN_BAD_KNOTS) {
        /* Knots that are near one another by the size of 0 would not be so elsewhere. */
        *out = reversed;
        return BATTEN_OK;
    }
    batten_surface_unref(reversed);
    return status;
}

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
            copy_point(nurbs, i * from.count[1] + j, made, j * from.count[0] + i);
    return bat_nurbs_finish(made, out);
}

/* ---- parameters and weights ---- */

batten_status batten_surface_set_domain(const batten_surface *surface,
                                        batten_direction direction, double a, double b,
                                        batten_surface **out)
{
    assert(surface && out);
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    const bat_axis *axis = &nurbs->axes[direction];
    bat_nurbs *made;
    batten_status status = bat_nurbs_copy(nurbs, false, &made);
    if (status != BATTEN_OK)
        return status;
    status = bat_knots_map(axis->degree, axis->count, axis->knots, a, b,
                           made->axes[direction].knots);
    if (status == BATTEN_OK)
        return bat_nurbs_finish(made, out);
    bat_nurbs_free(made);
    return status;
}

batten_status batten_surface_to_rational(const batten_surface *surface, batten_surface **out)
{
    assert(surface && out);
    bat_nurbs *made;
    const batten_status status = bat_nurbs_copy(bat_surface_nurbs(surface), true, &made);
    return status == BATTEN_OK ? bat_nurbs_finish(made, out) : status;
}

/* ---- position ---- */

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

batten_status bat_nurbs_transform(const batten_surface *surface, const batten_affine *map,
                                  batten_surface **out)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    if (bat_first_not_finite(&map->m[0][0], 9) < 9 || bat_first_not_finite(map->t, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE, "the affine map has an element that is no number");
    bat_nurbs *made;
    const batten_status status = bat_nurbs_copy(nurbs, false, &made);
    if (status != BATTEN_OK)
        return status;
    const int d = surface->dimension;
    const size_t total =
        (size_t)nurbs->axes[0].count * (size_t)nurbs->axes[1].count * (size_t)d;
    for (size_t i = 0; i < total; i += (size_t)d) {
        const batten_vec3 moved = batten_affine_apply(*map, bat_vec3_of(d, made->points + i));
        const double xyz[3] = {moved.x, moved.y, moved.z};
        memcpy(made->points + i, xyz, (size_t)d * sizeof *xyz);
    }
    const size_t bad = bat_first_not_finite(made->points, total);
    if (bad == total)
        return bat_nurbs_finish(made, out);
    bat_nurbs_free(made);
    return bat_fail(BATTEN_OVERFLOW, "control point %zu is mapped to where numbers end",
                    bad / (size_t)d);
}
