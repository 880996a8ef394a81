#ifndef BATTEN_WITHIN_H
#define BATTEN_WITHIN_H
/**
 * @file
 * Curves with few control points that keep within a tolerance of points, or of another curve.
 */
#include <batten/approximate.h>
#include <batten/chain.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How the knots of a curve within a tolerance are found. */
typedef enum batten_within_method {
    BATTEN_WITHIN_FEWEST, /**< by insertion and by removal: whichever leaves fewer; of more than
                               5000 points by insertion alone, where that does */
    BATTEN_WITHIN_INSERT, /**< none at first, then one where a span is too far off */
    BATTEN_WITHIN_REMOVE, /**< one for each datum at first */
    BATTEN_WITHIN_BEZIER  /**< cubics with common tangents, divided where they are too far off:
                               fast, local, about twice the control points; curvature jumps */
} batten_within_method;

typedef struct batten_within_options {
    size_t size;
    double tolerance;                  /**< model units, > 0; must be set */
    batten_within_method method;       /**< BATTEN_WITHIN_FEWEST */
    int degree;                        /**< 3; BEZIER: always 3 */
    batten_parametrization parameters; /**< BATTEN_CHORD: where parameters begin; of curves they
                                            are then moved to the feet of the data */
    const double *given;               /**< [count], never decreasing; closed [count + 1] */
    bool closed;   /**< the first point is also the last, and not repeated */
    double corner; /**< radians: where the row of points turns by more, looked at over 4 times
                        the tolerance, the curve has a corner; 0: nowhere */
    int corner_count;   /**< besides: points that are corners */
    const int *corners; /**< [corner_count], increasing */
} batten_within_options;
BATTEN_API batten_within_options batten_within_defaults(void);

/** Distances at the parameters of the data, so no datum is farther from the curve. */
typedef struct batten_within_report {
    double max, rms;
    int worst;    /**< index of the farthest datum */
    double apart; /**< how far the curve leaves the polygon of the data: the largest distance of
                       4 places of the curve between any two data from their chord */
    int points;   /**< control points; of a periodic curve those of one period */
    int corners;  /**< those inside, and of a closed curve all */
    int fits;     /**< by least squares, that were tried */
} batten_within_report;

/**
 * A B-spline curve with few control points that passes every point within a tolerance.
 *
 * Between corners the curve is a spline with simple knots, fitted by least squares with its
 * parameters moved to the feet of the data. Knots are inserted at the weighted middle of spans
 * that are too far off until all data are within the tolerance; then they go again in groups,
 * those first that matter least, as far as the tolerance allows, each time with a new fit. The
 * distances of the result are measured, not guessed. Corners and ends are met to rounding.
 *
 * @param points [count][dimension]; dimension 1: a function, whose parameters are given
 * @param[out] parameters [count], of the points on the curve: not farther than the tolerance
 *             there. Of a closed curve with corners they begin at a corner. May be NULL
 * @param[out] report may be NULL
 * @param[out] out clamped; periodic when closed without corners, but for BEZIER
 * @return BATTEN_OK; BAD_ARGUMENT (tolerance, corners, a closed function, a function by
 * BEZIER), BAD_DEGREE, NOT_FINITE, TOO_FEW_POINTS (2), COINCIDENT (all), NOT_INCREASING;
 * TOLERANCE_NOT_MET with the best that was reached
 * Cost: 64 log2(count) fits for each way at most, of more than 3000 points fewer, each linear
 * in count; BEZIER count log(count) for rows that divide evenly. Source: [LM88] for removal,
 * [Schneider90] for BEZIER, [Hoschek88] for parameters.
 */
BATTEN_API batten_status batten_curve_within(int dimension, int count, const double *points,
                                             const batten_within_options *options,
                                             double *parameters, batten_within_report *report,
                                             batten_curve **out);

/**
 * A polynomial B-spline of a wanted degree, with few control points, near another curve: of a
 * rational one, one of a high degree, one with many knots.
 *
 * The distance is that at equal parameters, and proved: it is a bound on the control points of
 * the difference, halved until it is close to a value that is taken. A polynomial curve of this
 * degree or a lower one loses knots (batten_curve_remove_knots); others, and periodic ones, are
 * fitted to samples, with knots that come and go as for points. Both ends, and places where the
 * first derivative jumps, are met to rounding; there knots stand `degree` times.
 *
 * @param curve     any; one that closes smoothly gives a periodic one when it has to be fitted
 * @param degree    of the result, 1..25
 * @param tolerance model units, > 0
 * @param[out] error the bound; may be NULL
 * @param[out] out  with the domain of the curve
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE, BAD_DEGREE; TOLERANCE_NOT_MET with what was
 * reached, or when the tolerance is below the rounding of the points
 * Source: [LM88] for the strategy.
 */
BATTEN_API batten_status batten_curve_approximate(const batten_curve *curve, int degree,
                                                  double tolerance, double *error,
                                                  batten_curve **out);
/** The same for a chain, at equal parameters of the chain, so by arc length where it goes so.
 * It is made a curve within a sixteenth of the tolerance first, whose bound, that of
 * batten_chain_to_curve, is sampled and counts in the error. */
BATTEN_API batten_status batten_chain_approximate(const batten_chain *chain, int degree,
                                                  double tolerance, double *error,
                                                  batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
