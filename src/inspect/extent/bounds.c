/* Boxes around points: along the axes of inertia, and turned until they are small. */
#include "inspect/extent/surface_extent.h"
#include "inspect/singular.h"
#include "numeric/box.h"
#include "numeric/eigen.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/measure.h>
#include <batten/nearest.h>

#include <stdlib.h>
#include <string.h>

/* ---- exact extents ---- */

/* Along a unit vector: where that coordinate turns back, and the ends of the domain. */
static batten_status extent(const batten_curve *curve, batten_vec3 axis, double *low,
                            double *high)
{
    const batten_interval domain = batten_curve_domain(curve);
    const double ends[2] = {domain.a, domain.b};
    batten_parameters turns = {0, NULL};
    batten_status status = batten_curve_turns(curve, axis, &turns);
    *low = HUGE_VAL;
    *high = -HUGE_VAL;
    for (int i = -2; status == BATTEN_OK && i < turns.count; i++) {
        double point[3];
        status = batten_curve_evaluate(curve, i < 0 ? ends[i + 2] : turns.at[i], 0, point);
        if (status != BATTEN_OK)
            break;
        const double along = bat_vec3_dot(bat_vec3_of(curve->dimension, point), axis);
        *low = bat_min(*low, along);
        *high = bat_max(*high, along);
    }
    bat_release(turns.at);
    return status;
}

batten_status batten_curve_bounds(const batten_curve *curve, batten_box *out)
{
    double low[3] = {0}, high[3] = {0};
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < curve->dimension; k++)
        status = extent(curve, (batten_vec3){k == 0, k == 1, k == 2}, &low[k], &high[k]);
    if (status == BATTEN_OK)
        *out = (batten_box){{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
    return status;
}

/* ---- surfaces ---- */

batten_status batten_surface_bounds(const batten_surface *surface, double tolerance,
                                    double *slack, batten_box *out)
{
    batten_surface *nurbs = NULL;
    double error = 0;
    if (!(tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g; it must be positive",
                        tolerance);
    bat_extent extent = {bat_box_of_nothing(), bat_box_of_nothing()};
    batten_status status = batten_surface_to_nurbs(surface, tolerance / 4, &error, &nurbs);
    if (status == BATTEN_OK)
        status = bat_surface_extent(nurbs, NULL, tolerance / 2, &extent);
    batten_surface_unref(nurbs);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 by = {error, error, batten_surface_dimension(surface) > 2 ? error : 0};
    *out = (batten_box){bat_vec3_subtract(extent.within.low, by),
                        bat_vec3_add(extent.within.high, by)};
    if (slack)
        *slack = bat_extent_slack(&extent) + error;
    return BATTEN_OK;
}

/* ---- rectangles ---- */

typedef struct {
    double x, y;
} point;

static int by_place(const void *a, const void *b)
{
    const point *p = a, *q = b;
    return p->x != q->x ? (p->x > q->x) - (p->x < q->x) : (p->y > q->y) - (p->y < q->y);
}

/* Twice the area of a triangle, positive when it turns left. */
static double twice_area(point a, point b, point c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* The convex hull, counterclockwise, each corner once; `hull` has room for count + 1. */
static int convex_hull(int count, point *points, point *hull)
{
    int n = 0, all = count;
    qsort(points, (size_t)all, sizeof *points, by_place);
    count = 0;
    for (int i = 0; i < all; i++)
        if (count == 0 || by_place(&points[i], &points[count - 1]) != 0)
            points[count++] = points[i];
    for (int i = 0; i < count; i++) {
        while (n >= 2 && twice_area(hull[n - 2], hull[n - 1], points[i]) <= 0)
            n--;
        hull[n++] = points[i];
    }
    for (int i = count - 2, lower = n + 1; i >= 0; i--) {
        while (n >= lower && twice_area(hull[n - 2], hull[n - 1], points[i]) <= 0)
            n--;
        hull[n++] = points[i];
    }
    return n > 1 ? n - 1 : n; /* the first has come again */
}

/* How far a corner lies along a direction. */
static double along(const point *hull, int n, int i, point direction)
{
    return hull[i % n].x * direction.x + hull[i % n].y * direction.y;
}

/* Go on around the hull while it rises along the direction. */
static int climb(const point *hull, int n, int from, point direction)
{
    while (along(hull, n, from + 1, direction) > along(hull, n, from, direction))
        from++;
    return from;
}

/* A direction of unit length and the sides of the rectangle along it and across. */
typedef struct {
    point direction;
    double side[2];
} rectangle;

/* The rectangle of least area around the hull: one of its sides lies on an edge. */
static rectangle calipers(int n, const point *hull)
{
    rectangle best = {{1, 0}, {0, 0}};
    int right = 0, far = 0, left = 0;
    for (int i = 0; n > 1 && i < n; i++) {
        const point a = hull[i], b = hull[(i + 1) % n];
        const double length = bat_hypot(b.x - a.x, b.y - a.y);
        const point x = {(b.x - a.x) / length, (b.y - a.y) / length}, y = {-x.y, x.x};
        const point back = {-x.x, -x.y};
        right = climb(hull, n, bat_max_int(right, i), x);
        far = climb(hull, n, bat_max_int(far, right), y);
        left = climb(hull, n, bat_max_int(left, far), back);
        const double wide = along(hull, n, right, x) - along(hull, n, left, x);
        const double high = along(hull, n, far, y) - along(hull, n, i, y);
        if (i == 0 || wide * high < best.side[0] * best.side[1])
            best = (rectangle){x, {wide, high}};
    }
    return best;
}

/* ---- boxes at any angle ---- */

/* A polyline near the curve, and room to work. */
typedef struct {
    int count;
    batten_vec3 *points;
    point *flat, *hull; /* [count], [2 count + 1] */
    double size;        /* of all of it */
} cloud;

static void cloud_end(cloud *c)
{
    bat_release(c->hull);
    bat_release(c->flat);
    bat_release(c->points);
}

static batten_status cloud_begin(const batten_curve *curve, double tolerance, cloud *out)
{
    batten_parameters at = {0, NULL};
    cloud c = {0};
    batten_status status = batten_curve_divide_chord(curve, tolerance, &at);
    const size_t n = (size_t)at.count;
    if (status == BATTEN_OK) {
        c.count = at.count;
        c.points = bat_array(n, sizeof *c.points);
        c.flat = bat_array(n, sizeof *c.flat);
        c.hull = bat_array(2 * n + 1, sizeof *c.hull);
        if (!c.points || !c.flat || !c.hull)
            status = BATTEN_OUT_OF_MEMORY;
    }
    for (int i = 0; status == BATTEN_OK && i < at.count; i++) {
        double p[3];
        status = batten_curve_evaluate(curve, at.at[i], 0, p);
        c.points[i] = bat_vec3_of(curve->dimension, p);
        c.size = bat_max(c.size, bat_vec3_norm(bat_vec3_subtract(c.points[i], c.points[0])));
    }
    bat_release(at.at);
    if (status == BATTEN_OK)
        *out = c;
    else
        cloud_end(&c);
    return status;
}

static batten_vec3 unit(batten_vec3 v)
{
    return bat_vec3_scale(v, 1 / bat_vec3_norm(v));
}

/* Two axes across w. */
static void across(batten_vec3 w, batten_vec3 *u, batten_vec3 *v)
{
    const double x = fabs(w.x), y = fabs(w.y), z = fabs(w.z);
    const batten_vec3 other = {x <= y && x <= z, x > y && y <= z,
                               !(x <= y && x <= z) && !(x > y && y <= z)};
    *u = unit(bat_vec3_cross(other, w));
    *v = bat_vec3_cross(w, *u);
}

/* The smallest box with an axis along w: its axes, and what is to be small, its volume, and
 * where that is lost in rounding its surface. */
static double box_along(cloud *c, batten_vec3 w, batten_vec3 axes[3])
{
    batten_vec3 u, v;
    double low = HUGE_VAL, high = -HUGE_VAL;
    across(w, &u, &v);
    for (int i = 0; i < c->count; i++) {
        const batten_vec3 p = bat_vec3_subtract(c->points[i], c->points[0]);
        const double h = bat_vec3_dot(p, w);
        c->flat[i] = (point){bat_vec3_dot(p, u), bat_vec3_dot(p, v)};
        low = bat_min(low, h);
        high = bat_max(high, h);
    }
    const rectangle r = calipers(convex_hull(c->count, c->flat, c->hull), c->hull);
    const double a = r.side[0], b = r.side[1], h = high - low;
    axes[0] = unit(bat_vec3_along(bat_vec3_scale(u, r.direction.x), r.direction.y, v));
    axes[1] = bat_vec3_cross(w, axes[0]);
    axes[2] = w;
    /* Of flat boxes, all of volume 0, the one with the smallest faces. */
    return a * b * h + 1e-9 * c->size * (a * b + b * h + h * a);
}

/* Principal directions of the points. */
static void principal(const cloud *c, double *vectors)
{
    double mean[3] = {0}, a[9] = {0}, values[3];
    for (int i = 0; i < c->count; i++) {
        const batten_vec3 p = bat_vec3_subtract(c->points[i], c->points[0]);
        mean[0] += p.x / c->count;
        mean[1] += p.y / c->count;
        mean[2] += p.z / c->count;
    }
    for (int i = 0; i < c->count; i++) {
        const batten_vec3 p = bat_vec3_subtract(c->points[i], c->points[0]);
        const double q[3] = {p.x - mean[0], p.y - mean[1], p.z - mean[2]};
        for (int k = 0; k < 9; k++)
            a[k] += q[k / 3] * q[k % 3];
    }
    bat_eigen_symmetric(3, a, values, vectors);
}

/* From the best of six directions on, each axis of the box in turn, while it shrinks. */
static void descend(cloud *c, batten_vec3 axes[3])
{
    enum { ROUNDS = 50 };
    double start[18] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, best = HUGE_VAL;
    batten_vec3 tried[3];
    principal(c, start + 9);
    for (int k = 0; k < 6; k++) {
        const double size = box_along(
            c, (batten_vec3){start[3 * k], start[3 * k + 1], start[3 * k + 2]}, tried);
        if (size < best) {
            memcpy(axes, tried, sizeof tried);
            best = size;
        }
    }
    for (int round = 0, idle = 0; round < ROUNDS && idle < 3; round++) {
        const double size = box_along(c, axes[round % 3], tried);
        /* By more than rounding: else rounds would go on for ever. */
        idle++;
        if (size < best * (1 - 1e-12)) {
            memcpy(axes, tried, sizeof tried);
            best = size;
            idle = 0;
        }
    }
}

/* The exact box along the axes, the longest side first; in the plane the third stays. */
static batten_status box_of(const batten_curve *curve, batten_vec3 axes[3],
                            batten_oriented_box *out)
{
    batten_oriented_box box = {{0, 0, 0}, {axes[0], axes[1], axes[2]}, {0}};
    const int d = curve->dimension;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < d; k++) {
        double low, high;
        status = extent(curve, axes[k], &low, &high);
        box.centre = bat_vec3_along(box.centre, low + (high - low) / 2, axes[k]);
        box.half[k] = (high - low) / 2;
    }
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k + 1 < d; k++)
            if (box.half[k] < box.half[k + 1]) { /* turned about the third one */
                const double half = box.half[k];
                const batten_vec3 axis = box.axes[k];
                box.half[k] = box.half[k + 1];
                box.half[k + 1] = half;
                box.axes[k] = box.axes[k + 1];
                box.axes[k + 1] = bat_vec3_scale(axis, -1);
            }
    if (status == BATTEN_OK)
        *out = box;
    return status;
}

batten_status batten_curve_oriented_box(const batten_curve *curve, double tolerance,
                                        batten_oriented_box *out)
{
    batten_vec3 axes[3];
    cloud c;
    if (curve->dimension == 1)
        return bat_fail(BATTEN_UNSUPPORTED, "a function has no oriented box");
    batten_status status = cloud_begin(curve, tolerance, &c);
    if (status != BATTEN_OK)
        return status;
    if (curve->dimension == 2)
        box_along(&c, (batten_vec3){0, 0, 1}, axes);
    else
        descend(&c, axes);
    cloud_end(&c);
    return box_of(curve, axes, out);
}
