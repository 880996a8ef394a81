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
    BATTEN_TANGENT_BISECTOR  /**< halves the angle between the two chords */
} batten_tangent_rule;

/** How long tangents are, and with them the steps of the parameters. */
typedef enum batten_tangent_length {
    BATTEN_LENGTH_CHORD,  /**< steps = chords, tangents of length 1 */
    BATTEN_LENGTH_MIDDLE, /**< tangents of length 1, and steps such that each span has speed 1
                               in its middle too: so its length is its step by Simpson's rule */
    BATTEN_LENGTH_RULE    /**< steps = chords, and the derivative that the rule gives (BESSEL,
                               AKIMA, PARABOLA; else as CHORD) */
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
