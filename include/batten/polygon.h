#ifndef BATTEN_POLYGON_H
#define BATTEN_POLYGON_H
/**
 * @file
 * Curves from their polygons: Bezier's curves, also by the edges of UNISURF, and uniform
 * B-splines with every usual kind of end.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/** One Bezier curve on [0, 1]. @param points [degree + 1][dimension]; weights [degree + 1] or
 * NULL
 */
BATTEN_API batten_status batten_curve_bezier(int dimension, int degree, const double *points,
                                             const double *weights, batten_curve **out);
/** The same from its first point and the edges of its polygon: P(t) = start + sum a_i f_i(t),
 * f_i = the sum of the Bernstein polynomials from i on. @param edges [degree][dimension]
 * Source: [Bezier74]. */
BATTEN_API batten_status batten_curve_from_edges(int dimension, int degree, const double *start,
                                                 const double *edges, batten_curve **out);
/** The reverse, for a clamped polynomial curve of one span.
 * @param[out] start [dimension], edges [degree][dimension] */
BATTEN_API batten_status batten_curve_edges(const batten_curve *curve, double *start,
                                            double *edges);

/** How a uniform B-spline ends. */
typedef enum batten_polygon_end {
    BATTEN_POLYGON_CLAMPED,  /**< at the end vertices, along the end edges: knots p + 1 times */
    BATTEN_POLYGON_FREE,     /**< inside the polygon: uniform knots, count - degree spans */
    BATTEN_POLYGON_PHANTOM,  /**< at the end vertices with curvature 0: uniform knots, each end
                                edge  prolonged by itself, degree 3; lower degrees as CLAMPED */
    BATTEN_POLYGON_REPEATED, /**< at the end vertices, straight there: each end vertex stands
                                  `degree` times, uniform knots */
    BATTEN_POLYGON_CLOSED    /**< closed and periodic; the first vertex is not repeated */
} batten_polygon_end;

/**
 * The uniform B-spline of a polygon; each inner span is one long.
 *
 * @param points [count][dimension]; a vertex that stands twice draws the curve near, one that
 * stands `degree` times is a corner
 * @param weights [count], or NULL
 * @return BATTEN_OK, BAD_DEGREE, TOO_FEW_POINTS (degree + 1; CLOSED and REPEATED: 2),
 * BAD_ARGUMENT (PHANTOM above degree 3), NOT_FINITE, BAD_WEIGHT, TOO_LARGE Source: [Coons74],
 * [Riesenfeld73].
 */
BATTEN_API batten_status batten_curve_uniform(int dimension, int degree, int count,
                                              const double *points, const double *weights,
                                              batten_polygon_end ends, batten_curve **out);

/**
 * An arc in the plane about (0, 0) from angle 0, in (0, 2 pi], as polynomial cubics: as many
 * equal pieces as keep it within `tolerance`; it is nowhere inside the circle.
 * @param[out] error radius (sqrt(1 + (4/27) sin^6(w/4) / cos^2(w/4)) - 1) for pieces of angle
 * w, which is exact; may be NULL
 */
BATTEN_API batten_status batten_curve_arc_cubic(double radius, double angle, double tolerance,
                                                double *error, batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
