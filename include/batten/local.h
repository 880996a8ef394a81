#ifndef BATTEN_LOCAL_H
#define BATTEN_LOCAL_H
/**
 * @file
 * Local interpolation: tangents and slopes from a few neighbours, and the curves made of them.
 * A point that moves changes only a few spans, nothing is solved, and nothing swings.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- tangents of curves ---- */

/** From which neighbours a tangent comes. */
typedef enum batten_tangent_rule {
    BATTEN_TANGENT_CIRCLE,   /**< of the circle through the point and its two neighbours; at an
                                  end of the circle of the first three points */
    BATTEN_TANGENT_BESSEL,   /**< of the parabola through the three, with chord parameters */
    BATTEN_TANGENT_AKIMA,    /**< Akima's slopes of each coordinate over chord parameters: what
                                  is straight in a coordinate stays so; depends on the axes */
    BATTEN_TANGENT_RENNER,   /**< Akima's weights with areas instead of slopes, so that axes do
                                  not matter; three points in line give that line */
    BATTEN_TANGENT_PARABOLA, /**< of the parabola nearest to five points, chord parameters */
    BATTEN_TANGENT_BISECTOR, /**< halves the angle between the two chords */
    BATTEN_TANGENT_GIVEN     /**< `given` in the options */
} batten_tangent_rule;

/** How long tangents are, and with them the steps of the parameters. */
typedef enum batten_tangent_length {
    BATTEN_LENGTH_CHORD,  /**< steps = chords, tangents of length 1 */
    BATTEN_LENGTH_MIDDLE, /**< tangents of length 1, and steps such that each span has speed 1
                               in its middle too: so its length is its step by Simpson's rule */
    BATTEN_LENGTH_RULE    /**< steps = chords, and the derivative that the rule gives (BESSEL,
                               AKIMA, PARABOLA, GIVEN; else as CHORD) */
} batten_tangent_length;

/** What becomes of a point between two straight runs (RENNER). */
typedef enum batten_corner {
    BATTEN_CORNER_ROUND, /**< the tangent is the mean of both chords */
    BATTEN_CORNER_KEEP   /**< each run keeps its own tangent */
} batten_corner;

typedef struct batten_tangent_options {
    size_t size;
    batten_tangent_rule rule;     /**< BATTEN_TANGENT_CIRCLE */
    batten_tangent_length length; /**< BATTEN_LENGTH_CHORD */
    batten_corner corners;        /**< BATTEN_CORNER_ROUND */
    bool closed;                  /**< the first point is not repeated */
    const double *given;          /**< [count][dimension], with BATTEN_TANGENT_GIVEN */
} batten_tangent_options;
BATTEN_API batten_tangent_options batten_tangent_defaults(void);

typedef struct batten_tangent_report {
    int turned_back;       /**< points where the polygon turns back on itself: no direction is
                                defined there, and one at right angles to it was taken */
    int first_turned_back; /**< the first of these, or -1 */
    int corners;           /**< points that keep two tangents */
} batten_tangent_report;

/**
 * Parameters and tangents for points of the plane or of space.
 *
 * @param points  [count][dimension], dimension 2 or 3, neighbours apart; 2 points, closed 3
 * @param options NULL for the defaults
 * @param[out] parameters [count], closed [count + 1]; from 0
 * @param[out] leaving  [count][dimension] derivatives by the parameter, after each point
 * @param[out] arriving [count][dimension] those before it, the same bits except at a kept
 * corner; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT or OVERFLOW naming
 * the points, OUT_OF_MEMORY
 *
 * Two points give their chord. Cost: linear in count. Source: [McConalogue70] (CIRCLE and
 * MIDDLE), [Akima70], [Akima72] (RENNER with CHORD), [Renner82] (RENNER with MIDDLE), [PT97]
 * 9.3.1, [SL] VI.8.
 */
BATTEN_API batten_status batten_tangents(int dimension, int count, const double *points,
                                         const batten_tangent_options *options,
                                         double *parameters, double *leaving, double *arriving,
                                         batten_tangent_report *report);

/**
 * The cubic through points with the given tangents, or slopes: C1; at points whose two tangents
 * differ, C0.
 *
 * @param dimension 1 (then tangents are slopes of a function of the parameter), 2 or 3
 * @param points    [count][dimension], 2 or more; closed: 1 or more, periodic
 * @param parameters [count], closed [count + 1]; increasing
 * @param leaving   [count][dimension]
 * @param arriving  [count][dimension]; NULL: the same as leaving
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, OVERFLOW;
 * TOLERANCE_NOT_MET when the curve misses a point by more than rounding
 * Cost: linear in count.
 */
BATTEN_API batten_status batten_curve_from_tangents(
    int dimension, int count, const double *points, const double *parameters,
    const double *leaving, const double *arriving, bool closed, batten_curve **out);

/**
 * Second derivatives at the points of such a curve, for a quintic through the same: the mean of
 * those of the two cubic spans that meet there, the shorter one counting more; at an end that
 * of its span. Exact where the points and tangents come from a cubic. Together with points and
 * tangents they go to batten_curve_from_hermite.
 *
 * Arguments as for batten_curve_from_tangents. @param[out] second [count][dimension]
 */
BATTEN_API batten_status batten_second_derivatives(int dimension, int count,
                                                   const double *points,
                                                   const double *parameters,
                                                   const double *tangents, bool closed,
                                                   double *second);

/* ---- slopes of functions ---- */

/** From which neighbours a slope comes. d: slopes of the chords. */
typedef enum batten_slope_rule {
    BATTEN_SLOPE_BESSEL, /**< of the parabola through a point and its two neighbours; at an end
                              of the first three. Exact for parabolas */
    BATTEN_SLOPE_AKIMA, /**< d before and after, weighted by how little the slopes change beyond
                             them; two more d's at each end in equal differences. Straight runs
                             of three points stay straight */
    BATTEN_SLOPE_FRITSCH_CARLSON, /**< Bessel's, shortened where the cubic would not be monotone
                                       between two points; 0 at extrema of the data */
    BATTEN_SLOPE_FRITSCH_BUTLAND, /**< weighted harmonic mean of d before and after; 0 at
                                     extrema of the data: monotone, and less round */
    BATTEN_SLOPE_STEFFEN,         /**< Bessel's, no steeper than twice the flatter chord: no
                                       extrema but at points */
    BATTEN_SLOPE_MAKIMA           /**< Akima's, with the mean slope of the two chords beyond
                                       added to each change: level runs of three points stay
                                       level and do not swing beside steps; sloping straight
                                       runs may bend */
} batten_slope_rule;

/**
 * Slopes for a function through (x, y); with batten_curve_from_tangents they make its cubic.
 *
 * The ends of FRITSCH_CARLSON and FRITSCH_BUTLAND have the slope of the parabola through three
 * points, 0 where that has the wrong sign, and no steeper than 3 d where the data turn.
 * FRITSCH_CARLSON shortens both slopes of a span by one factor, and a point takes the smaller
 * one of its two spans: the authors go from left to right, and the result of that depends on
 * the direction.
 *
 * @param x [count] increasing, 2 or more
 * @param[out] slopes [count]
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, OVERFLOW
 * Cost: linear in count. Source: [Akima70], [FC80], [FB84], [Steffen90]; [Ionita19] for MAKIMA.
 */
BATTEN_API batten_status batten_slopes(int count, const double *x, const double *y,
                                       batten_slope_rule rule, double *slopes);

/**
 * The quadratic spline function through points with at most one more knot in each span:
 * monotone where the data are, and convex or concave where they are. C1.
 *
 * Slopes are means of those of the chords, weighted with their lengths; 0 at extrema of the
 * data, and that of the line where three points are in line. Where a straight run ends in an
 * extremum of the data, or in another straight run, no smooth function is both convex and
 * monotone: then a span beside it bends twice.
 *
 * @param[out] slopes [count], may be NULL @param[out] out dimension 1, parameter x
 * @return as batten_slopes. Cost: linear in count. Source: [Schumaker83].
 */
BATTEN_API batten_status batten_curve_schumaker(int count, const double *x, const double *y,
                                                double *slopes, batten_curve **out);

/**
 * The rational quadratic function of Gregory and Delbourgo through points: monotone where the
 * data are, for any slopes of the same sign as the chords, and smoother than a monotone cubic.
 *
 * @param slopes [count]; NULL: those of BATTEN_SLOPE_FRITSCH_BUTLAND
 * @param[out] out its exact graph, dimension 2, a rational cubic whose parameter is x
 * @return as batten_slopes; BAD_ARGUMENT naming the span whose slopes have not the sign of its
 * chord. Cost: linear in count. Source: [GD82].
 */
BATTEN_API batten_status batten_curve_rational_monotone(int count, const double *x,
                                                        const double *y, const double *slopes,
                                                        batten_curve **out);

/* ---- tangents and curvatures both given ---- */

typedef struct batten_curvature_report {
    int several;           /**< spans with two or three solutions */
    int fallen_back;       /**< spans without a solution, which keep the tangents only */
    int first_fallen_back; /**< the first of these, or -1 */
    double off;            /**< largest curvature error at the ends of the other spans, times
                                their chord */
} batten_curvature_report;

/**
 * The plane cubic spline with given directions and curvatures at its points: curvature is
 * continuous, and a smooth curve is met with order 6.
 *
 * A span has up to three solutions; the one whose legs (a third of the end derivatives) are
 * nearest to a third of the chord is taken, which is the one that converges to the curve. A
 * span without solution, as where the curvatures ask for a turn that the tangents deny, gets
 * the legs of BATTEN_LENGTH_MIDDLE.
 *
 * @param points     [count][2], 2 or more, closed 3; neighbours apart
 * @param tangents   [count][2] directions, of any length above 0
 * @param curvatures [count] signed, 1 / length; positive: a left turn
 * @param[out] parameters [count], closed [count + 1]: sums of chords; may be NULL
 * @param[out] solutions  [count - 1], closed [count]: how many each span has, 0..3; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK, NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, BAD_ARGUMENT (a tangent of no
 * length, named), OVERFLOW
 *
 * The curve has triple knots: direction and curvature are continuous, the speed is not.
 * Cost: linear in count. Source: [dBHS87].
 */
BATTEN_API batten_status batten_curve_from_curvatures(int count, const double *points,
                                                      const double *tangents,
                                                      const double *curvatures, bool closed,
                                                      double *parameters, int *solutions,
                                                      batten_curvature_report *report,
                                                      batten_curve **out);

/** Signed curvatures of the circles through each point and its neighbours; at an end that of
 * the first three points. Two points: 0.
 * @param points [count][2] @param[out] curvatures [count] */
BATTEN_API batten_status batten_circle_curvatures(int count, const double *points, bool closed,
                                                  double *curvatures);

#ifdef __cplusplus
}
#endif
#endif
