/* The net of a fit to scattered data: its knots, its values and rests, and its surface. */
#include "numeric/vector.h"
#include "shape/cloud/scattered.h"
#include "spline/curve/curve.h"
#include "spline/spline.h"

#include <string.h>

enum { WIDE = BAT_SCATTER_WIDE };

batten_status bat_scatter_even(bat_net_axis *axis, int degree, int spans, double side)
{
    const int n = spans + degree;
    double *U = bat_array((size_t)(n + degree + 1), sizeof *U);
    if (!U)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i <= n + degree; i++) {
        const int k = bat_min_int(spans, bat_max_int(0, i - degree));
        U[i] = k == spans ? side : side * k / spans;
    }
    bat_release(axis->knots);
    *axis = (bat_net_axis){degree, n, U};
    return BATTEN_OK;
}

void bat_scatter_basis(const bat_scatter *s, size_t t, int first[2], double *u, double *v)
{
    double *values[2] = {u, v};
    for (int k = 0; k < 2; k++) {
        const bat_net_axis *axis = &s->axis[k];
        const double x = s->uv[2 * t + (size_t)k];
        const int span =
            bat_knots_span(axis->degree, axis->count, axis->knots, x, BATTEN_FROM_RIGHT);
        bat_basis(axis->degree, axis->knots, span, x, 0, values[k]);
        first[k] = span - axis->degree;
    }
}

/* sum += the point of the net with these basis functions. */
static void add_net_point(const bat_scatter *s, const int first[2], const double *u,
                          const double *v, double *sum)
{
    const size_t d = (size_t)s->dimension, nv = (size_t)s->axis[1].count;
    for (int a = 0; a <= s->axis[0].degree; a++)
        for (int b = 0; b <= s->axis[1].degree; b++) {
            const size_t at = (size_t)(first[0] + a) * nv + (size_t)(first[1] + b);
            for (size_t c = 0; c < d; c++)
                sum[c] += u[a] * v[b] * s->control[at * d + c];
        }
}

void bat_scatter_rest(const bat_scatter *s, size_t t, double rest[3])
{
    const size_t d = (size_t)s->dimension;
    double u[WIDE], v[WIDE];
    int first[2];
    bat_scatter_basis(s, t, first, u, v);
    for (size_t c = 0; c < d; c++)
        rest[c] = s->centre[c] - s->values[t * d + c];
    add_net_point(s, first, u, v, rest);
}

void bat_scatter_measure(bat_scatter *s)
{
    s->sum = 0;
    for (size_t t = 0; t < s->count; t++) {
        double rest[3];
        bat_scatter_rest(s, t, rest);
        const double square = bat_dot(s->dimension, rest, rest);
        s->away[t] = sqrt(square);
        s->sum += s->weights[t] * square;
    }
}

batten_status bat_scatter_net(const bat_scatter *s, batten_surface **out)
{
    const batten_axis u = {s->axis[0].degree, s->axis[0].count, s->axis[0].knots, false};
    const batten_axis v = {s->axis[1].degree, s->axis[1].count, s->axis[1].knots, false};
    return batten_surface_create(s->dimension, &u, &v, s->control, NULL, out);
}

batten_status bat_scatter_take(bat_scatter *s, const batten_surface *surface)
{
    bat_net_axis axis[2];
    for (int k = 0; k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        const int knots = batten_surface_knot_count(surface, direction);
        axis[k].degree = batten_surface_degree(surface, direction);
        axis[k].count = batten_surface_point_count(surface, direction);
        axis[k].knots = bat_array((size_t)knots, sizeof *axis[k].knots);
        if (axis[k].knots)
            memcpy(axis[k].knots, batten_surface_knots(surface, direction),
                   (size_t)knots * sizeof *axis[k].knots);
    }
    const size_t size = (size_t)axis[0].count * (size_t)axis[1].count * (size_t)s->dimension;
    double *control = bat_array(size, sizeof *control);
    if (!axis[0].knots || !axis[1].knots || !control) {
        bat_release(axis[0].knots);
        bat_release(axis[1].knots);
        bat_release(control);
        return BATTEN_OUT_OF_MEMORY;
    }
    memcpy(control, batten_surface_points(surface), size * sizeof *control);
    for (int k = 0; k < 2; k++) {
        bat_release(s->axis[k].knots);
        s->axis[k] = axis[k];
    }
    bat_release(s->control);
    s->control = control;
    bat_scatter_measure(s);
    return BATTEN_OK;
}

batten_status bat_scatter_surface(const bat_scatter *s, batten_surface **out)
{
    const size_t d = (size_t)s->dimension;
    const size_t count = (size_t)s->axis[0].count * (size_t)s->axis[1].count;
    double *points = bat_array3(count, d, sizeof *points);
    double *knots[2];
    for (int k = 0; k < 2; k++) {
        const int n = s->axis[k].count + s->axis[k].degree + 1;
        knots[k] = bat_array((size_t)n, sizeof *knots[k]);
        for (int i = 0; knots[k] && i < n; i++)
            knots[k][i] = s->origin[k] + s->length * s->axis[k].knots[i];
    }
    batten_status status = points && knots[0] && knots[1] ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < count * d; i++)
        points[i] = s->control[i] + s->centre[i % d];
    if (status == BATTEN_OK) {
        const batten_axis u = {s->axis[0].degree, s->axis[0].count, knots[0], false};
        const batten_axis v = {s->axis[1].degree, s->axis[1].count, knots[1], false};
        status = batten_surface_create(s->dimension, &u, &v, points, NULL, out);
    }
    bat_release(knots[1]);
    bat_release(knots[0]);
    bat_release(points);
    return status;
}
