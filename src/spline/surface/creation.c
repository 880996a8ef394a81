/* A NURBS surface from what a caller gives: sizes, knots, periods are looked at; nurbs.c allocates and frees. */
#include "base/plural.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"

#include <string.h>

static const char *const axis_names[2] = {"u", "v"};

static batten_status check_axis(const batten_axis *axis, const char *name)
{
    const int least = axis->periodic ? 1 : axis->degree + 1;
    if (axis->degree < 1 || axis->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree in %s is %d; it must be in 1..%d", name,
                        axis->degree, BATTEN_MAX_DEGREE);
    if (axis->point_count < least)
        return bat_fail(
            BATTEN_TOO_FEW_POINTS, "%d control point%s in %s for degree %d; %d are needed",
            axis->point_count, bat_plural(axis->point_count), name, axis->degree, least);
    if (axis->point_count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d control points in %s; the limit is %d",
                        axis->point_count, name, BAT_MAX_POINTS);
    return BATTEN_OK;
}

static batten_status check_sizes(int dimension, const batten_axis *u, const batten_axis *v)
{
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    batten_status status = check_axis(u, axis_names[BATTEN_U]);
    if (status == BATTEN_OK)
        status = check_axis(v, axis_names[BATTEN_V]);
    if (status != BATTEN_OK)
        return status;
    const long long total = (long long)u->point_count * v->point_count;
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d x %d are %lld control points; the limit is %d",
                        u->point_count, v->point_count, total, BAT_MAX_POINTS);
    return BATTEN_OK;
}

static batten_status check_period(const batten_axis *axis, const char *name)
{
    const int m = axis->point_count;
    for (int i = 0; i <= m; i++)
        if (!isfinite(axis->knots[i]))
            return bat_fail(BATTEN_NOT_FINITE, "knot %d in %s is %g", i + 1, name,
                            axis->knots[i]);
    if (!(axis->knots[m] > axis->knots[0]))
        return bat_fail(BATTEN_BAD_KNOTS,
                        "the period in %s is empty: knot 1 is %.17g and knot %d is %.17g", name,
                        axis->knots[0], m + 1, axis->knots[m]);
    return BATTEN_OK;
}

static batten_status fill_knots(const batten_axis *given, const char *name, bat_axis *axis)
{
    const int p = given->degree, m = given->point_count;
    char what[32] = "knot in ";
    strcat(what, name);
    if (!given->periodic) {
        memcpy(axis->knots, given->knots, ((size_t)m + (size_t)p + 1) * sizeof *axis->knots);
        return bat_knots_check(p, m, axis->knots, what);
    }
    const batten_status status = check_period(given, name);
    if (status != BATTEN_OK)
        return status;
    bat_knots_wrap(p, m, given->knots, axis->knots);
    return bat_knots_check(p, m + p, axis->knots, what);
}

static void fill_points(bat_nurbs *nurbs, int own_u, int own_v, const double *points,
                        const double *weights)
{
    const size_t d = (size_t)nurbs->base.dimension;
    double *point = nurbs->points, *weight = nurbs->weights;
    for (int i = 0; i < nurbs->axes[BATTEN_U].count; i++)
        for (int j = 0; j < nurbs->axes[BATTEN_V].count; j++, point += d) {
            const size_t from = (size_t)(i % own_u) * (size_t)own_v + (size_t)(j % own_v);
            memcpy(point, points + from * d, d * sizeof *point);
            if (weights)
                *weight++ = weights[from];
        }
}

batten_status batten_surface_create(int dimension, const batten_axis *u, const batten_axis *v,
                                    const double *points, const double *weights,
                                    batten_surface **out)
{
    assert(u && v && u->knots && v->knots && points && out);
    batten_status status = check_sizes(dimension, u, v);
    if (status != BATTEN_OK)
        return status;
    const bat_nurbs_shape shape = {
        .dimension = dimension,
        .degree = {u->degree, v->degree},
        .count = {u->point_count + (u->periodic ? u->degree : 0),
                  v->point_count + (v->periodic ? v->degree : 0)},
        .periodic = {u->periodic, v->periodic},
        .rational = weights != NULL,
    };
    bat_nurbs *nurbs = NULL;
    status = bat_nurbs_make(&shape, &nurbs);
    if (status != BATTEN_OK)
        return status;
    status = fill_knots(u, axis_names[BATTEN_U], &nurbs->axes[BATTEN_U]);
    if (status == BATTEN_OK)
        status = fill_knots(v, axis_names[BATTEN_V], &nurbs->axes[BATTEN_V]);
    if (status != BATTEN_OK) {
        bat_nurbs_free(nurbs);
        return status;
    }
    fill_points(nurbs, u->point_count, v->point_count, points, weights);
    return bat_nurbs_finish(nurbs, out);
}
