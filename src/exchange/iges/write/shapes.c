/* Points, curves and surfaces as IGES entities. */
#include "exchange/iges/write/writing.h"

#include <string.h>

/* Do all points [count][3] have the same z? */
static bool is_level(const double *points, size_t count)
{
    for (size_t i = 1; i < count; i++)
        if (points[3 * i + 2] != points[2])
            return false;
    return true;
}

static void put_coordinate(bat_iges_writing *w, double value)
{
    w->largest = bat_max(w->largest, fabs(value));
    bat_iges_put_real(&w->data, value, ',');
}

/* Points in the plane have the third coordinate 0. */
static void put_points(bat_iges_writing *w, int dimension, const double *points, size_t count)
{
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            if (dimension == 3)
                put_coordinate(w, points[3 * i + (size_t)k]);
            else
                bat_iges_put_real(&w->data, k < 2 ? points[2 * i + (size_t)k] : 0, ',');
}

/* Missing weights are written as ones, and the entity calls itself polynomial. */
static void put_weight(bat_iges_writing *w, const double *weights, size_t i)
{
    bat_iges_put_real(&w->data, weights ? weights[i] : 1, ',');
}

static void put_knots(bat_iges_writing *w, const double *knots, int count)
{
    for (int i = 0; i < count; i++)
        bat_iges_put_real(&w->data, knots[i], ',');
}

static void put_integers(bat_iges_writing *w, const int *values, size_t count)
{
    for (size_t k = 0; k < count; k++)
        bat_iges_put_integer(&w->data, values[k], ',');
}

/* ---- curves ---- */

/* A segment that a line, which has no knots, reads back as. */
static bool is_segment(const batten_curve *curve)
{
    const double *knots = batten_curve_knots(curve);
    return batten_curve_degree(curve) == 1 && batten_curve_point_count(curve) == 2 &&
           !batten_curve_is_rational(curve) && knots[0] == 0 && knots[1] == 0 &&
           !signbit(knots[0]) && !signbit(knots[1]) && knots[2] == 1 && knots[3] == 1;
}

static void put_spline(bat_iges_writing *w, const batten_curve *curve)
{
    const double *points = batten_curve_points(curve), *weights = batten_curve_weights(curve);
    const size_t n = (size_t)batten_curve_point_count(curve);
    const int dimension = batten_curve_dimension(curve);
    const batten_interval domain = batten_curve_domain(curve);
    const bool level = dimension == 2 || is_level(points, n);
    const bool closed = memcmp(points, &points[(size_t)dimension * (n - 1)],
                               (size_t)dimension * sizeof *points) == 0;
    const int head[] = {(int)n - 1, batten_curve_degree(curve), level, closed, weights == NULL,
                        0};
    put_integers(w, head, sizeof head / sizeof head[0]);
    put_knots(w, batten_curve_knots(curve), batten_curve_knot_count(curve));
    for (size_t i = 0; i < n; i++)
        put_weight(w, weights, i);
    put_points(w, dimension, points, n);
    const double tail[] = {domain.a, domain.b, 0, 0, level};
    put_knots(w, tail, sizeof tail / sizeof tail[0]);
}

int bat_iges_put_curve(bat_iges_writing *w, const batten_curve *curve, int name,
                       bat_iges_look look)
{
    look.type = is_segment(curve) ? 110 : 126;
    const int id = bat_iges_begin_entity(w, look.type);
    if (look.type == 110)
        put_points(w, batten_curve_dimension(curve), batten_curve_points(curve), 2);
    else
        put_spline(w, curve);
    bat_iges_put_properties(w, name);
    bat_iges_end_entity(w, &look);
    return id;
}

/* ---- surfaces ---- */

static void put_domain(bat_iges_writing *w, const batten_surface *surface,
                       batten_direction direction)
{
    const batten_interval domain = batten_surface_domain(surface, direction);
    bat_iges_put_real(&w->data, domain.a, ',');
    bat_iges_put_real(&w->data, domain.b, ',');
}

int bat_iges_put_surface(bat_iges_writing *w, const batten_surface *surface, int name,
                         bat_iges_look look)
{
    const double *points = batten_surface_points(surface);
    const double *weights = batten_surface_weights(surface);
    const int count_u = batten_surface_point_count(surface, BATTEN_U);
    const int count_v = batten_surface_point_count(surface, BATTEN_V);
    const int head[] = {count_u - 1,
                        count_v - 1,
                        batten_surface_degree(surface, BATTEN_U),
                        batten_surface_degree(surface, BATTEN_V),
                        batten_surface_is_closed(surface, BATTEN_U, 0),
                        batten_surface_is_closed(surface, BATTEN_V, 0),
                        weights == NULL,
                        0,
                        0};
    look.type = 128;
    const int id = bat_iges_begin_entity(w, look.type);
    put_integers(w, head, sizeof head / sizeof head[0]);
    for (int k = 0; k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        put_knots(w, batten_surface_knots(surface, direction),
                  batten_surface_knot_count(surface, direction));
    }
    for (int j = 0; j < count_v; j++)
        for (int i = 0; i < count_u; i++)
            put_weight(w, weights, (size_t)i * (size_t)count_v + (size_t)j);
    for (int j = 0; j < count_v; j++)
        for (int i = 0; i < count_u; i++)
            put_points(w, 3, &points[3 * ((size_t)i * (size_t)count_v + (size_t)j)], 1);
    put_domain(w, surface, BATTEN_U);
    put_domain(w, surface, BATTEN_V);
    bat_iges_put_properties(w, name);
    bat_iges_end_entity(w, &look);
    return id;
}

/* ---- points ---- */

int bat_iges_put_points(bat_iges_writing *w, const double *points, int count, int name,
                        bat_iges_look look)
{
    look.type = count == 1 ? 116 : 106;
    look.form = count == 1 ? 0 : 2;
    const int id = bat_iges_begin_entity(w, look.type);
    if (count > 1)
        put_integers(w, (int[]){2, count}, 2);
    put_points(w, 3, points, (size_t)count);
    if (count == 1)
        bat_iges_put_integer(&w->data, 0, ',');
    bat_iges_put_properties(w, name);
    bat_iges_end_entity(w, &look);
    return id;
}
