/* Curves from their polygons. */
#include <batten/polygon.h>

#include "base/plural.h"
#include "spline/curve/curve.h"

#include <string.h>

batten_status batten_curve_bezier(int dimension, int degree, const double *points,
                                  const double *weights, batten_curve **out)
{
    static const double breaks[2] = {0, 1};
    return batten_curve_from_bezier(dimension, (batten_pieces){degree, 1, breaks}, points,
                                    weights, out);
}

batten_status batten_curve_from_edges(int dimension, int degree, const double *start,
                                      const double *edges, batten_curve **out)
{
    double points[(BATTEN_MAX_DEGREE + 1) * 3];
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", degree,
                        BATTEN_MAX_DEGREE);
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    for (int k = 0; k < dimension; k++)
        points[k] = start[k];
    for (int i = 0; i < degree * dimension; i++)
        points[dimension + i] = points[i] + edges[i];
    return batten_curve_bezier(dimension, degree, points, NULL, out);
}

batten_status batten_curve_to_edges(const batten_curve *curve, double *start, double *edges)
{
    const int p = curve->degree, d = curve->dimension;
    if (curve->weights || curve->count != p + 1 || !batten_curve_is_clamped(curve))
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "the edges of a polygon belong to one polynomial span; this curve has %d "
            "control point%s of degree %d",
            curve->count, bat_plural(curve->count), p);
    memcpy(start, curve->points, (size_t)d * sizeof *start);
    for (int i = 0; i < p * d; i++)
        edges[i] = curve->points[d + i] - curve->points[i];
    return BATTEN_OK;
}

/* ---- uniform B-splines ---- */

static batten_status check_uniform(int dimension, int degree, int count,
                                   batten_polygon_end ends)
{
    const bool few = ends == BATTEN_POLYGON_CLOSED || ends == BATTEN_POLYGON_REPEATED;
    const int least = few ? 2 : ends == BATTEN_POLYGON_PHANTOM ? degree - 1 : degree + 1;
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", degree,
                        BATTEN_MAX_DEGREE);
    if (ends == BATTEN_POLYGON_PHANTOM && degree != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "phantom vertices are for degree 3, not %d",
                        degree);
    if (count < least)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "%d %s; %d are needed", count,
                        bat_one_or_many(count, "vertex", "vertices"), least);
    if (count > BAT_MAX_POINTS - 2 * degree)
        return bat_fail(BATTEN_TOO_LARGE, "%d vertices; the limit is %d", count,
                        BAT_MAX_POINTS - 2 * degree);
    return BATTEN_OK;
}

/* How many vertices are added before the first, and after the last. */
static int added(int degree, batten_polygon_end ends)
{
    return ends == BATTEN_POLYGON_PHANTOM    ? 1
           : ends == BATTEN_POLYGON_REPEATED ? degree - 1
                                             : 0;
}

/* One coordinate or weight of vertex i of the prolonged polygon, i from 0. */
static double prolonged(const double *rows, int count, int width, int more, bool phantom, int i,
                        int k)
{
    const int at = i - more, last = count - 1;
    if (at >= 0 && at <= last)
        return rows[at * width + k];
    const int end = at < 0 ? 0 : last, next = at < 0 ? 1 : last - 1;
    return phantom ? 2 * rows[end * width + k] - rows[next * width + k] : rows[end * width + k];
}

/* Clamped or uniform, with spans of one. */
static void fill_knots(int degree, int count, bool clamped, double *knots)
{
    for (int i = 0; i <= count + degree; i++)
        knots[i] =
            clamped ? bat_min_int(bat_max_int(i - degree, 0), count - degree) : i - degree;
}

static batten_status open_uniform(int dimension, int degree, int count, const double *points,
                                  const double *weights, batten_polygon_end ends,
                                  batten_curve **out)
{
    const int more = added(degree, ends), n = count + 2 * more;
    const bool phantom = ends == BATTEN_POLYGON_PHANTOM;
    batten_curve *curve = NULL;
    const batten_status status = bat_curve_make(dimension, degree, n, weights != NULL, &curve);
    if (status != BATTEN_OK)
        return status;
    fill_knots(degree, n, ends == BATTEN_POLYGON_CLAMPED, curve->knots);
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < dimension; k++)
            curve->points[i * dimension + k] =
                prolonged(points, count, dimension, more, phantom, i, k);
        if (weights)
            curve->weights[i] = prolonged(weights, count, 1, more, false, i, 0);
    }
    return bat_curve_finish(curve, out);
}

static batten_status closed_uniform(int dimension, int degree, int count, const double *points,
                                    const double *weights, batten_curve **out)
{
    double *knots = bat_array((size_t)count + 1, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i <= count; i++)
        knots[i] = i;
    const batten_status status = batten_curve_create_periodic(
        (batten_points){dimension, count, points}, degree, weights, knots, out);
    bat_release(knots);
    return status;
}

batten_status batten_curve_uniform(batten_points points, int degree, const double *weights,
                                   batten_polygon_end ends, batten_curve **out)
{
    assert(points.at && out);
    const batten_status status = check_uniform(points.dimension, degree, points.count, ends);
    if (status != BATTEN_OK)
        return status;
    if (ends == BATTEN_POLYGON_CLOSED)
        return closed_uniform(points.dimension, degree, points.count, points.at, weights, out);
    return open_uniform(points.dimension, degree, points.count, points.at, weights, ends, out);
}

/* ---- arcs as cubics ---- */

/* One-sided: the cubic is outside the circle, and touches it at the ends and in the middle. The
 * square of its distance from the centre is at most r^2 (1 + x). */
static double arc_error(double radius, double w)
{
    const double s = bat_sin(w / 4), c = bat_cos(w / 4);
    const double x = 4.0 / 27 * s * s * s * s * s * s / (c * c);
    return radius * x / (1 + sqrt(1 + x));
}

static void arc_points(double radius, double w, int pieces, double *points)
{
    const double leg = 4.0 / 3 * bat_tan(w / 4) * radius;
    for (int i = 0; i <= pieces; i++) {
        const double c = bat_cos(i * w), s = bat_sin(i * w);
        double *at = points + 6 * i;
        at[0] = radius * c;
        at[1] = radius * s;
        if (i > 0) {
            at[-2] = at[0] + leg * s;
            at[-1] = at[1] - leg * c;
        }
        if (i < pieces) {
            at[2] = at[0] - leg * s;
            at[3] = at[1] + leg * c;
        }
    }
}

batten_status batten_curve_arc_cubic(double radius, double angle, double tolerance,
                                     double *error, batten_curve **out)
{
    enum { MOST = 100000 };
    if (!(radius > 0 && isfinite(radius) && angle > 0 && angle <= 2 * BAT_PI))
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "no arc of radius %g and angle %g: they must be above 0, the angle at most 2 pi",
            radius, angle);
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    int pieces = (int)ceil(angle / BAT_PI);
    while (arc_error(radius, angle / pieces) > tolerance && pieces < MOST)
        pieces += 1 + pieces / 8;
    /* Not more than needed, after the strides. */
    while (pieces > 1 && arc_error(radius, angle / (pieces - 1)) <= tolerance &&
           angle / (pieces - 1) <= BAT_PI)
        pieces--;
    if (arc_error(radius, angle / pieces) > tolerance)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET, "%d cubics come within %g, not %g", pieces,
                        arc_error(radius, angle / pieces), tolerance);
    double *points = bat_array((size_t)pieces * 3 + 1, 2 * sizeof *points);
    double *breaks = bat_array((size_t)pieces + 1, sizeof *breaks);
    batten_status status = points && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i <= pieces && status == BATTEN_OK; i++)
        breaks[i] = (double)i / pieces;
    if (status == BATTEN_OK) {
        arc_points(radius, angle / pieces, pieces, points);
        status =
            batten_curve_from_bezier(2, (batten_pieces){3, pieces, breaks}, points, NULL, out);
    }
    if (status == BATTEN_OK && error)
        *error = arc_error(radius, angle / pieces);
    bat_release(points);
    bat_release(breaks);
    return status;
}
