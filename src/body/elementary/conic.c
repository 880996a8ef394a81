/* Lines and conics by their parameters, and their parts as exact NURBS. */
#include "body/elementary/elementary.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <batten/standard.h>
#include <float.h>

/* ---- points and feet ---- */

/* The coordinates along x and y of the frame at t; order 1 their derivatives. */
static void flat(const bat_conic *conic, double t, int order, double at[2])
{
    const double a = conic->a, b = conic->b;
    const bool point = order == 0;
    switch (conic->kind) {
    case BAT_LINE:
        at[0] = point ? t : 1;
        at[1] = 0;
        return;
    case BAT_ELLIPSE:
        at[0] = point ? a * bat_cos(t) : -a * bat_sin(t);
        at[1] = point ? b * bat_sin(t) : b * bat_cos(t);
        return;
    case BAT_PARABOLA:
        at[0] = point ? a * t * t : 2 * a * t;
        at[1] = point ? 2 * a * t : 2 * a;
        return;
    case BAT_HYPERBOLA:
        at[0] = point ? a * bat_cosh(t) : a * bat_sinh(t);
        at[1] = point ? b * bat_sinh(t) : b * bat_cosh(t);
        return;
    }
}

static batten_vec3 side_axis(const bat_conic *conic)
{
    return bat_vec3_cross(conic->frame.z, conic->frame.x);
}

void bat_conic_point(const bat_conic *conic, double t, double point[3])
{
    double at[2];
    flat(conic, t, 0, at);
    const batten_vec3 p = bat_vec3_along(
        bat_vec3_along(conic->frame.origin, at[0], conic->frame.x), at[1], side_axis(conic));
    point[0] = p.x;
    point[1] = p.y;
    point[2] = p.z;
}

/* (C(t) - P) . C'(t) for P in the frame: rises through 0 at the foot. */
static double pull(const bat_conic *conic, const double p[2], double t)
{
    double at[2], speed[2];
    flat(conic, t, 0, at);
    flat(conic, t, 1, speed);
    return (at[0] - p[0]) * speed[0] + (at[1] - p[1]) * speed[1];
}

/* The foot of a point with y >= 0 (of an ellipse also x >= 0), by halving: it lies on the same
 * side of the axes, where the pull is not above 0 at t = 0 and not below at `high`. */
static double foot_between(const bat_conic *conic, const double p[2], double high)
{
    double low = 0;
    for (;;) {
        const double middle = low + (high - low) / 2;
        /* The parameter of a point of size 1 is not known better. */
        if (high - low < 0x1p-60 || middle <= low || middle >= high)
            return middle;
        if (pull(conic, p, middle) <= 0)
            low = middle;
        else
            high = middle;
    }
}

/* A parameter whose pull is not below 0. The coordinates are some 1 beside the half axes, or
 * the search ends where they overflow. */
static double bracket(const bat_conic *conic, const double p[2])
{
    double high = 1;
    while (pull(conic, p, high) < 0 && high < 0x1p60)
        high *= 2;
    return high;
}

static double foot_of_ellipse(const bat_conic *conic, const double p[2])
{
    if (conic->a == conic->b)
        return bat_atan2(p[1], p[0]);
    const double quarter[2] = {fabs(p[0]), fabs(p[1])};
    /* On the axes the halving would end next to the foot. */
    double t = quarter[1] == 0 && quarter[0] >= conic->a ? 0
               : quarter[0] == 0 && quarter[1] >= conic->b
                   ? BAT_PI / 2
                   : foot_between(conic, quarter, BAT_PI / 2);
    if (p[0] < 0)
        t = BAT_PI - t;
    return p[1] < 0 ? -t : t;
}

double bat_conic_parameter(const bat_conic *conic, const double point[3])
{
    const batten_vec3 way = bat_vec3_subtract(bat_vec3_of(3, point), conic->frame.origin);
    if (conic->kind == BAT_LINE)
        return bat_vec3_dot(way, conic->frame.x) / bat_vec3_dot(conic->frame.x, conic->frame.x);
    /* Measured by the conic itself, so that squares stay numbers. */
    const double size = conic->kind == BAT_PARABOLA ? conic->a : bat_max(conic->a, conic->b);
    bat_conic unit = *conic;
    unit.a /= size;
    unit.b /= size;
    double p[2] = {bat_vec3_dot(way, conic->frame.x) / size,
                   bat_vec3_dot(way, side_axis(conic)) / size};
    if (conic->kind == BAT_ELLIPSE)
        return foot_of_ellipse(&unit, p);
    if (p[1] == 0 && p[0] <= unit.a)
        return 0;
    const double sign = p[1] < 0 ? -1 : 1;
    p[1] = fabs(p[1]);
    return sign * foot_between(&unit, p, bracket(&unit, p));
}

/* ---- parts ---- */

static batten_status check_conic(const bat_conic *conic, double t0, double t1)
{
    if (!isfinite(t0) || !isfinite(t1))
        return bat_fail(BATTEN_NOT_FINITE, "the parameters of the conic are %g and %g", t0, t1);
    if (!(t0 < t1))
        return bat_fail(BATTEN_COINCIDENT,
                        "the part of the conic from %.17g to %.17g has no length", t0, t1);
    if (conic->kind == BAT_LINE)
        return BATTEN_OK;
    const bool needs_b = conic->kind != BAT_PARABOLA;
    if (!isfinite(conic->a) || (needs_b && !isfinite(conic->b)))
        return bat_fail(BATTEN_NOT_FINITE, "the half axes of the conic are %g and %g", conic->a,
                        conic->b);
    if (!(conic->a > 0) || (needs_b && !(conic->b > 0)))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the half axes of the conic are %g and %g; they must be positive",
                        conic->a, conic->b);
    return BATTEN_OK;
}

static batten_status line_between(double t0, double t1, batten_curve **out)
{
    const double points[4] = {t0, 0, t1, 0}, knots[4] = {t0, t0, t1, t1};
    return batten_curve_create((batten_points){2, 2, points}, 1, NULL, knots, out);
}

static batten_status ellipse_between(const bat_conic *conic, double t0, double t1,
                                     batten_curve **out)
{
    const double around = 2 * BAT_PI;
    double angle = t1 - t0;
    /* t1 = t0 + 2 pi is rounded: that is the whole. */
    if (fabs(angle - around) <= 4 * DBL_EPSILON * (fabs(t0) + fabs(t1) + around))
        angle = around;
    batten_curve *arc = NULL;
    batten_status status = batten_curve_ellipse(conic->a, conic->b, t0, angle, &arc);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(arc, t0, t1, out);
    batten_curve_unref(arc);
    return status;
}

/* The polynomial parametrisation is that of the conic itself. */
static batten_status parabola_between(const bat_conic *conic, double t0, double t1,
                                      batten_curve **out)
{
    const double a = conic->a, knots[6] = {t0, t0, t0, t1, t1, t1};
    const double points[6] = {a * t0 * t0,   2 * a * t0,  a * t0 * t1,
                              a * (t0 + t1), a * t1 * t1, 2 * a * t1};
    return batten_curve_create((batten_points){2, 3, points}, 2, NULL, knots, out);
}

/* Pieces of length 2 h <= 2, so that weights stay below 1.6: between t - h and t + h the
 * tangents meet in C(t) / cosh h, and that is the weight. */
static batten_status hyperbola_between(const bat_conic *conic, double t0, double t1,
                                       batten_curve **out)
{
    enum { PIECES = 712 }; /* cosh(712) is no number any more, on either side */
    if (!(t1 - t0 < 2 * (PIECES - 1)))
        return bat_fail(BATTEN_OVERFLOW, "the hyperbola from %g to %g is too long", t0, t1);
    const int pieces = bat_max_int(1, (int)ceil((t1 - t0) / 2));
    const double h = (t1 - t0) / pieces / 2;
    double *points = bat_array3((size_t)pieces + 1, 7, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    double *weights = points + 4 * (size_t)pieces + 2, *breaks = weights + 2 * pieces + 1;
    for (int i = 0; i <= pieces; i++) {
        breaks[i] = i == pieces ? t1 : t0 + 2 * h * i;
        flat(conic, breaks[i], 0, points + 4 * (size_t)i);
        weights[2 * i] = 1;
        if (i == pieces)
            break;
        double *middle = points + 4 * (size_t)i + 2;
        flat(conic, t0 + h * (2 * i + 1), 0, middle);
        weights[2 * i + 1] = bat_cosh(h);
        middle[0] /= weights[2 * i + 1];
        middle[1] /= weights[2 * i + 1];
    }
    const batten_status status =
        batten_curve_from_bezier(2, (batten_pieces){2, pieces, breaks}, points, weights, out);
    bat_release(points);
    return status;
}

/* From the plane of the conic, with z upward, to where it stands. */
static batten_affine place_of(const bat_conic *conic)
{
    const batten_vec3 x = conic->frame.x, y = side_axis(conic), z = conic->frame.z;
    const batten_vec3 o = conic->frame.origin;
    return (batten_affine){{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}},
                           {o.x, o.y, o.z}};
}

static batten_status to_space(const bat_conic *conic, batten_curve *plane, batten_curve **out)
{
    const batten_affine place = place_of(conic);
    batten_curve *raised = NULL;
    batten_status status = batten_curve_to_dimension(plane, 3, &raised);
    if (status == BATTEN_OK)
        status = batten_curve_transform(raised, &place, out);
    batten_curve_unref(raised);
    return status;
}

batten_status bat_conic_between(const bat_conic *conic, double t0, double t1,
                                batten_curve **out)
{
    assert(conic && out);
    batten_curve *plane = NULL;
    batten_status status = check_conic(conic, t0, t1);
    if (status != BATTEN_OK)
        return status;
    switch (conic->kind) {
    case BAT_LINE:
        status = line_between(t0, t1, &plane);
        break;
    case BAT_ELLIPSE:
        status = ellipse_between(conic, t0, t1, &plane);
        break;
    case BAT_PARABOLA:
        status = parabola_between(conic, t0, t1, &plane);
        break;
    case BAT_HYPERBOLA:
        status = hyperbola_between(conic, t0, t1, &plane);
        break;
    }
    if (status == BATTEN_OK)
        status = to_space(conic, plane, out);
    batten_curve_unref(plane);
    return status;
}

batten_status bat_conic_part(const bat_conic *conic, const double p[3], const double q[3],
                             bool forward, double tolerance, batten_curve **out)
{
    assert(conic && p && q && out);
    const double around = 2 * BAT_PI;
    double from = bat_conic_parameter(conic, p), to = bat_conic_parameter(conic, q);
    if (conic->kind == BAT_ELLIPSE) {
        if (bat_distance(3, p, q) <= tolerance)
            to = forward ? from + around : from - around;
        else if (forward && to <= from)
            to += around;
        else if (!forward && to >= from)
            to -= around;
    }
    if (from <= to)
        return bat_conic_between(conic, from, to, out);
    batten_curve *against = NULL;
    batten_status status = bat_conic_between(conic, to, from, &against);
    if (status == BATTEN_OK)
        status = batten_curve_reverse(against, out);
    batten_curve_unref(against);
    return status;
}
