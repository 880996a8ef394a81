#ifndef BATTEN_APPROXIMATE_H
#define BATTEN_APPROXIMATE_H
/**
 * @file
 * Curves near points: least squares, smoothing, fits within a bound.
 *
 * Points are [count][dimension], dimension 1 to 3; dimension 1 is a function of its parameter.
 * Weights are finite and never negative; 0 leaves a point out. Points may coincide and
 * parameters may repeat: nothing is interpolated.
 */
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a fit reached. Distances are those of the data from the curve at their parameters, in
 * model units; data of weight 0 do not count. */
typedef struct batten_fit_report {
    double max, rms;  /**< largest distance, root of the mean square */
    int worst;        /**< index of the farthest datum */
    double lambda;    /**< the weight of the penalty; 0 without one */
    double freedom;   /**< how many of the data the curve follows: the trace of the matrix that
                           turns data into values of the curve */
    double p;         /**< 1 / (1 + lambda): p of the squares and 1 - p of the penalty */
    int rounds;       /**< of parameter correction, or of reweighting */
    bool regularised; /**< the data do not determine the curve, and a penalty did */
    double sum;       /**< of squares of the distances, times weights */
    int pressing;     /**< inequalities that hold with equality and keep the curve from data */
    int reweightings; /**< rounds of a robust fit */
    double threshold; /**< the distance from which on a robust fit counts data less */
    double gap;       /**< no curve with these knots and parameters, under these conditions,
                           makes what is summed smaller by more than this share; 0 without
                           `robust`, infinite with BATTEN_TUKEY */
} batten_fit_report;

/** Where the knots of a fit stand. */
typedef enum batten_knot_choice {
    BATTEN_KNOTS_BY_DATA,      /**< as many data between any two */
    BATTEN_KNOTS_BY_CURVATURE, /**< close where a first fit bends: equal integrals of the
                                    (p + 1)th root of the derivative of order p + 1 */
    BATTEN_KNOTS_GIVEN
} batten_knot_choice;

/** What a curve near points must meet. */
typedef enum batten_condition_kind {
    BATTEN_CONDITION_EQUAL,     /**< the derivative is `value` */
    BATTEN_CONDITION_DIRECTION, /**< of a curve: it has the direction of `value` */
    BATTEN_CONDITION_AT_LEAST,  /**< of a function: it is `value[0]` or more */
    BATTEN_CONDITION_AT_MOST
} batten_condition_kind;

typedef struct batten_condition {
    batten_condition_kind kind;
    int index;        /**< of the datum at whose parameter it holds; -1: at `parameter` */
    double parameter; /**< inside the domain */
    int order;        /**< of the derivative, 0..4; 0 is the point itself */
    double value[3];
} batten_condition;

/** Shapes of functions, to be combined. They hold everywhere: the coefficients of the
 * derivative have one sign, which for convexity of cubics is all that is needed and else a
 * little more. */
enum { BATTEN_INCREASING = 1, BATTEN_DECREASING = 2, BATTEN_CONVEX = 4, BATTEN_CONCAVE = 8 };

typedef enum batten_fit_side {
    BATTEN_FIT_BOTH,
    BATTEN_FIT_OVER, /**< a function that is nowhere below its data, at their parameters */
    BATTEN_FIT_UNDER
} batten_fit_side;

/** How distances from data count. */
typedef enum batten_robust {
    BATTEN_SQUARES,  /**< by their squares */
    BATTEN_HUBER,    /**< squared up to the threshold, in proportion beyond */
    BATTEN_ABSOLUTE, /**< in proportion: L1 */
    BATTEN_TUKEY     /**< ever less, and all alike beyond the threshold; no convex problem: what
                          is found is near the fit by BATTEN_ABSOLUTE */
} batten_robust;

typedef struct batten_least_squares_options {
    size_t size;
    int degree;                        /**< 3 */
    int point_count;                   /**< control points; periodic: of one period. 0: one for
                                            every four data */
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given;               /**< [count], never decreasing; periodic [count + 1] */
    const double *weights;             /**< [count], or NULL */
    batten_knot_choice knots;
    const double *given_knots; /**< [point_count + degree + 1]; periodic [point_count + 1] */
    bool periodic; /**< the curve closes smoothly; the first point is not repeated */
    bool hold_start, hold_end; /**< the curve begins, ends, in its first, last point */
    int corrections; /**< parameters are moved to the feet of the data and the curve fitted
                          anew at most so often, while rms falls by a thousandth; 0; not for
                          functions */
    bool regularise; /**< where data do not determine the curve, second differences of the
                          control points decide, weighing 1e-10 of the data; else that is an
                          error */
    int condition_count;
    const batten_condition *conditions;
    unsigned shape;       /**< of a function: BATTEN_INCREASING | ...; 0 for any */
    batten_fit_side side; /**< BATTEN_FIT_BOTH */
    double band;          /**< at its parameter no coordinate is farther than this from that of
                               the datum, unless its weight is 0; 0 for no band */
    batten_robust robust; /**< BATTEN_SQUARES */
    double threshold;     /**< of BATTEN_HUBER and BATTEN_TUKEY; 0: 2 and 7 times the median
                               distance of the fit by BATTEN_ABSOLUTE, near the usual 1.345
                             and 4.685     standard deviations of normal errors */
} batten_least_squares_options;

/** Cubic, by chords, knots by data. */
BATTEN_API batten_least_squares_options batten_least_squares_defaults(void);

/**
 * The spline curve with the least sum of squared distances from points.
 *
 * @param points  [count][dimension]
 * @param options NULL for the defaults
 * @param[out] parameters [count], those of the points at last; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK; TOO_FEW_POINTS when there are fewer data than control points;
 * SINGULAR_SYSTEM naming the first control point that has no datum of its own (the condition of
 * Schoenberg and Whitney); BAD_WEIGHT, NOT_FINITE, NOT_INCREASING, OUT_OF_DOMAIN with the
 * index; BAD_KNOTS, BAD_DEGREE, BAD_ARGUMENT
 *
 * Conditions (also `shape`, `side`, `band`) are met to rounding, or the status is
 * NOT_COMPATIBLE and the message names one that cannot hold with the others. Robust fits weigh
 * data anew by their distances, until `gap` is 1e-6 or for at most 50 rounds; `rms` and `sum`
 * are those of all data by their own weights.
 *
 * Solved by Givens' rotations row by row, so as well as the basis allows. Cost: linear in count
 * and point_count; under conditions the normal equations are a program of at most 1000
 * unknowns, whose cube is the cost. Source: [deBoor01] ch. XIV, [PT97] 9.4, [Hoschek88] for
 * correction, [GI83] for conditions, [HW77] for weights.
 */
BATTEN_API batten_status batten_curve_least_squares(
    int dimension, int count, const double *points, const batten_least_squares_options *options,
    double *parameters, batten_fit_report *report, batten_curve **out);

/**
 * The data that are much farther from a curve than most.
 *
 * @param parameters  of the points on the curve, as a fit hands them over
 * @param weights     [count]; points of weight 0 are none, and do not count; or NULL
 * @param times       an outlier is farther than so many times the median distance, the nearest
 *                    data set aside, as many as there are control points but at most half; 5 is
 *                    some 3.4 standard deviations of a function's normal errors. Distances that
 *                    are rounding are never outliers
 * @param[out] distance  from which on; may be NULL
 * @param[out] outliers  [count] their indices, rising
 * @param[out] outlier_count
 */
BATTEN_API batten_status batten_curve_outliers(const batten_curve *curve, int count,
                                               const double *points, const double *parameters,
                                               const double *weights, double times,
                                               double *distance, int *outliers,
                                               int *outlier_count);

/** What decides how smooth a curve becomes. */
typedef enum batten_smooth_by {
    BATTEN_SMOOTH_BY_VALIDATION, /**< generalised cross validation: each datum is foretold by
                                    the others as well as can be; assumes independent errors */
    BATTEN_SMOOTH_BY_LAMBDA,     /**< the penalty weighs `amount` >= 0, infinity allowed */
    BATTEN_SMOOTH_BY_RMS         /**< the smoothest curve whose rms distance (weights counted)
                                      is at most `amount`, model units */
} batten_smooth_by;

typedef struct batten_smooth_options {
    size_t size;
    batten_smooth_by by; /**< BATTEN_SMOOTH_BY_VALIDATION */
    double amount;
    int order;  /**< m, 1..4: of the derivative, of the differences, that is penalised; 2 */
    int spans;  /**< of a P-spline; 40 */
    int degree; /**< of a P-spline; 3 */
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given;               /**< [count], never decreasing; periodic [count + 1] */
    const double *weights;             /**< [count], or NULL */
    bool periodic;
} batten_smooth_options;

BATTEN_API batten_smooth_options batten_smooth_defaults(void);

/**
 * The smoothing spline: least sum of w |s(t) - q|^2 plus lambda times the integral of
 * |s^(m)|^2.
 *
 * Of all curves the best is a natural spline of degree 2 m - 1 with a knot at every parameter;
 * m = 2 is the batten pulled towards its ducks by springs. lambda = 0 gives the interpolating
 * natural spline (through the means of data with one parameter), infinity the polynomial of
 * degree m - 1 by least squares (a point when periodic). `spans` and `degree` are not used.
 *
 * @param[out] parameters [count]; may be NULL
 * @param[out] report lambda, p, freedom and what the fit reached; may be NULL
 * @return as batten_curve_least_squares
 * Cost: linear in count for each lambda that is tried; a given one is one, others some 25.
 * Source: [Reinsch67] for the target, [CW79] for validation, [HdH85] for its trace.
 */
BATTEN_API batten_status batten_curve_smooth(int dimension, int count, const double *points,
                                             const batten_smooth_options *options,
                                             double *parameters, batten_fit_report *report,
                                             batten_curve **out);

/**
 * The P-spline: on `spans` equal spans, least sum of w |s(t) - q|^2 plus lambda times the
 * squares of the differences of order m of the control points.
 *
 * Nearly the smoothing spline for a fraction of its knots, whatever the number of data; lambda
 * = infinity gives the polynomial of degree m - 1. lambda = 0 needs data in all spans. The
 * result is clamped, or periodic. Parameters and errors as for batten_curve_smooth. Source:
 * [EM96].
 */
BATTEN_API batten_status batten_curve_p_spline(int dimension, int count, const double *points,
                                               const batten_smooth_options *options,
                                               double *parameters, batten_fit_report *report,
                                               batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
