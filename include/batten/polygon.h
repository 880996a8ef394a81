#ifndef BATTEN_POLYGON_H
#define BATTEN_POLYGON_H
/**
 * @file
 * Curves from control polygons, and operators that turn values straight into control points.
 *
 * Points are [count][dimension], dimension 1 to 3; dimension 1 is a function of its parameter.
 */
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * One Bezier curve on [0, 1].
 * @param dimension  1, 2 or 3
 * @param degree  1..25
 * @param points  [degree + 1][dimension]
 * @param weights  [degree + 1], above 0, or NULL
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_curve_create
 *
 * Cost: linear in the points.
 */
BATTEN_API batten_status batten_curve_bezier(int dimension, int degree, const double *points,
                                             const double *weights, batten_curve **out);
/**
 * The same from its first point and the edges of its polygon: P(t) = start + sum a_i f_i(t),
 * f_i = the sum of the Bernstein polynomials from i on.
 * @param dimension  1, 2 or 3
 * @param degree  1..25
 * @param start  [dimension]
 * @param edges [degree][dimension]
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_DEGREE, BAD_ARGUMENT
 *
 * Cost: linear in the points.
 * Source: [Bezier74].
 */
BATTEN_API batten_status batten_curve_from_edges(int dimension, int degree, const double *start,
                                                 const double *edges, batten_curve **out);
/**
 * The reverse, for a clamped polynomial curve of one span.
 * @param curve  clamped, polynomial, of one span
 * @param[out] start  [dimension]
 * @param[out] edges  [degree][dimension]
 * @return BATTEN_OK, BAD_ARGUMENT
 *
 * Cost: linear in the points.
 */
BATTEN_API batten_status batten_curve_to_edges(const batten_curve *curve, double *start,
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
 * @param degree  1..25
 * @param weights [count], or NULL
 * @param ends  how the first and the last span come about
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_DEGREE, TOO_FEW_POINTS (degree + 1; CLOSED and REPEATED: 2),
 * BAD_ARGUMENT (PHANTOM above degree 3), NOT_FINITE, BAD_WEIGHT, TOO_LARGE
 *
 * Cost: linear in count.
 * Source: [Coons74], [Riesenfeld73].
 */
BATTEN_API batten_status batten_curve_uniform(batten_points points, int degree,
                                              const double *weights, batten_polygon_end ends,
                                              batten_curve **out);

/**
 * An arc in the plane about (0, 0) from angle 0, in (0, 2 pi], as polynomial cubics: as many
 * equal pieces as keep it within `tolerance`; it is nowhere inside the circle.
 * @param radius  model units, above 0
 * @param angle  radians
 * @param tolerance  model units, above 0
 * @param[out] error radius (sqrt(1 + (4/27) sin^6(w/4) / cos^2(w/4)) - 1) for pieces of angle
 * w, which is exact; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, TOLERANCE_NOT_MET, OUT_OF_MEMORY
 *
 * Cost: linear in the pieces, of which there are 100,000 at most.
 */
BATTEN_API batten_status batten_curve_arc_cubic(double radius, double angle, double tolerance,
                                                double *error, batten_curve **out);
/** How far an approximation is from its data at their parameters, in model units. Of a function
 * that is known everywhere, `max` and `rms` are those at 8 places of each span and at the
 * knots. */
typedef struct batten_curve_schoenberg_report {
    double error, rms;
    int worst; /**< index of the farthest datum; -1 without data */
} batten_curve_schoenberg_report;

typedef struct batten_curve_schoenberg_options {
    size_t size;
    int degree;                        /**< 3; lower where there are too few points */
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given;               /**< [count], increasing; periodic [count + 1] */
    bool closed;    /**< the curve closes smoothly; the first point is not repeated */
    bool bernstein; /**< Schoenberg's operator without inner knots: Bernstein's; not periodic */
} batten_curve_schoenberg_options;

/** Cubic, by chords. */
BATTEN_API batten_curve_schoenberg_options batten_curve_schoenberg_defaults(void);

/**
 * Schoenberg's variation diminishing spline of the polyline through points: its control points
 * are those of the polyline at Greville's abscissae, its knots stand at the data.
 *
 * No line or plane meets it more often than the polyline, so it is convex, monotone, positive
 * where that is; it ends in the end points and passes by the others at distances that shrink
 * with the square of the spacing.
 *
 * @param options NULL for the defaults
 * @param[out] parameters [count]; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return as batten_curve_interpolate; BAD_DEGREE outside 1..25
 * Cost: linear in count.
 * Source: [Schoenberg67].
 */
BATTEN_API batten_status batten_curve_schoenberg(batten_points points,
                                                 const batten_curve_schoenberg_options *options,
                                                 double *parameters,
                                                 batten_curve_schoenberg_report *report,
                                                 batten_curve **out);

/**
 * The quasi-interpolant: each control point is the blossom, at its knots, of the polynomials of
 * degree p through the p + 1 data around them (the mean of the two choices that are as near).
 * Its knots stand at the data.
 *
 * Polynomials of degree p are reproduced; smooth data are met within O(h^(p + 1)), not exactly;
 * a point bears on p + 2 control points and no farther. For equal steps and p = 3 the control
 * points are (-q[i - 1] + 8 q[i] - q[i + 1]) / 6.
 *
 * @param options  NULL for the defaults
 * @param[out] parameters  those of the points; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_curve_schoenberg; BAD_DEGREE outside 1..9: higher polynomials through data
 * swing
 * Cost: linear in count, p^3 for each.
 * Source: [LS75].
 */
BATTEN_API batten_status batten_curve_quasi_interpolate(
    batten_points points, const batten_curve_schoenberg_options *options, double *parameters,
    batten_curve_schoenberg_report *report, batten_curve **out);

/** A function or curve that is known everywhere: its point and derivatives up to `order` at u,
 * in out [order + 1][dimension]. */
typedef batten_status (*batten_evaluator)(void *user, double u, int order, double *out);

/**
 * Schoenberg's operator on these clamped knots [point_count + degree + 1]; those without inner
 * ones make it Bernstein's.
 *
 * @param dimension  1, 2 or 3: numbers that the function gives
 * @param axis  degree, and clamped knots [point_count + degree + 1]
 * @param function  asked for values at Greville's abscissas
 * @param user  handed to the function at each call
 * @param[out] report  how far the curve is from the function; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, BAD_DEGREE, BAD_KNOTS, BAD_ARGUMENT,
 * TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: one value for each control point, and samples on each span for the report.
 */
BATTEN_API batten_status batten_function_schoenberg(int dimension, const batten_axis *axis,
                                                    batten_evaluator function, void *user,
                                                    batten_curve_schoenberg_report *report,
                                                    batten_curve **out);

/**
 * The quasi-interpolant of de Boor and Fix on these clamped knots: each control point from the
 * point and the derivatives up to p at one place, Greville's abscissa.
 *
 * Splines on the knots are reproduced; smooth functions are met within O(h^(p + 1)).
 *
 * @param dimension  1, 2 or 3: numbers that the function gives
 * @param axis  degree p, and clamped knots [point_count + degree + 1]
 * @param function  asked for values and derivatives up to p
 * @param user  handed to the function at each call
 * @param[out] report  how far the curve is from the function; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, BAD_DEGREE, BAD_KNOTS, BAD_ARGUMENT,
 * TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: one value with p derivatives and about p^2 multiplications for each control point, and
 * samples on each span for the report.
 * Source: [BF73].
 */
BATTEN_API batten_status batten_function_de_boor_fix(int dimension, const batten_axis *axis,
                                                     batten_evaluator function, void *user,
                                                     batten_curve_schoenberg_report *report,
                                                     batten_curve **out);

/* ---- least largest error ---- */

typedef struct batten_curve_minimax_report {
    double error; /**< the largest; of a function known everywhere, as found by searching */
    double bound; /**< no polynomial of this degree has a smaller one, after de la Vallee
                     Poussin */
    double rms;   /**< over the data, or the places where the function was looked at */
    int exchanges;
    double places[27]; /**< [degree + 2] where the error is `bound` or more, with signs that
                            alternate */
} batten_curve_minimax_report;

/**
 * The polynomial of this degree whose largest distance from values at parameters is least.
 *
 * @param count at least degree + 2
 * @param parameters [count], increasing
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK: `error` exceeds `bound` by rounding, which grows with the degree;
 * BAD_DEGREE outside 0..25, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING; INCOMPLETE when
 * exchanges did not end
 *
 * The curve is a Bezier curve of dimension 1 over the parameters (degree 0: a line that is
 * level). Cost: some degree exchanges of degree^3 + degree count.
 * Source: [Remez34], [Stiefel59] for one point exchanged at a time.
 */
BATTEN_API batten_status batten_curve_minimax(int count, const double *parameters,
                                              const double *values, int degree,
                                              batten_curve_minimax_report *report,
                                              batten_curve **out);

/**
 * The same for a function that is continuous on a < b; `error` exceeds `bound` by no more than
 * a millionth, or the status is INCOMPLETE. Peaks narrower than a 32nd of the distance of the
 * polynomial's extrema may be missed.
 *
 * @param domain  where the function is approximated, a < b
 * @param degree  1 to 25
 * @param function  asked for values; of one dimension
 * @param user  handed to the function at each call
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_DEGREE, BAD_ARGUMENT, SINGULAR_SYSTEM, OUT_OF_MEMORY,
 * INCOMPLETE
 *
 * Cost: 32 (degree + 2) values at first, then for each exchange degree^3 multiplications and
 * some values around each extremum.
 */
BATTEN_API batten_status batten_function_minimax(batten_interval domain, int degree,
                                                 batten_evaluator function, void *user,
                                                 batten_curve_minimax_report *report,
                                                 batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
