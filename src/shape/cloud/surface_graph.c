/* Graphs of functions, and the plainest base for a cloud. */
#include "spline/surface/surface.h"
#include <batten/scattered.h>

#include <string.h>

/* The values of the function above its Greville abscissae. */
static void list_graph_points(const bat_nurbs *f, double *points)
{
    const int nu = f->axes[0].count, nv = f->axes[1].count;
    for (int i = 0; i < nu; i++)
        for (int j = 0; j < nv; j++) {
            double *p = points + 3 * ((size_t)i * (size_t)nv + (size_t)j);
            p[0] = bat_greville(f->axes[0].degree, f->axes[0].knots, i);
            p[1] = bat_greville(f->axes[1].degree, f->axes[1].knots, j);
            p[2] = f->points[(size_t)i * (size_t)nv + (size_t)j];
        }
}

static batten_status graph_of(const bat_nurbs *f, batten_surface **out)
{
    const int nu = f->axes[0].count, nv = f->axes[1].count;
    double *points = bat_array3((size_t)nu, (size_t)nv, 3 * sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    list_graph_points(f, points);
    const batten_axis u = {f->axes[0].degree, nu, f->axes[0].knots, false};
    const batten_axis v = {f->axes[1].degree, nv, f->axes[1].knots, false};
    const batten_status status = batten_surface_create(3, &u, &v, points, NULL, out);
    bat_release(points);
    return status;
}

batten_status batten_surface_from_function(const batten_surface *function, batten_surface **out)
{
    batten_surface *clamped[2] = {NULL, NULL};
    if (function->kind != &bat_nurbs_kind || function->dimension != 1 ||
        batten_surface_is_rational(function))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "only a polynomial function of u and v has a graph");
    batten_status status = batten_surface_clamp(function, BATTEN_U, &clamped[0]);
    if (status == BATTEN_OK)
        status = batten_surface_clamp(clamped[0], BATTEN_V, &clamped[1]);
    if (status == BATTEN_OK)
        status = graph_of(bat_surface_nurbs(clamped[1]), out);
    batten_surface_unref(clamped[1]);
    batten_surface_unref(clamped[0]);
    return status;
}

batten_status batten_surface_from_corners(const double *corners, batten_surface **out)
{
    const double knots[4] = {0, 0, 1, 1};
    double points[12];
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            memcpy(points + 3 * (2 * i + j), corners + 3 * (i + 2 * j), 3 * sizeof *points);
    const batten_axis axis = {1, 2, knots, false};
    return batten_surface_create(3, &axis, &axis, points, NULL, out);
}
