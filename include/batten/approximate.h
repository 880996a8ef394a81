#ifndef BATTEN_APPROXIMATE_H
#define BATTEN_APPROXIMATE_H
/**
 * @file
 * Curves near points: least squares, smoothing, fits within a bound, aerofoil sections.
 *
 * Points are [count][dimension], dimension 1 to 3; dimension 1 is a function of its parameter.
 * Weights are finite and never negative; 0 leaves a point out. Points may coincide and
 * parameters may repeat: nothing is interpolated.
 *
 * All minimise the sum of squared distances at right angles to the shape, after a start that is
 * found without iteration. Points on a shape give it back to rounding.
 */
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a fit reached. Distances are those of the data from the curve at their parameters, in
 * model units; data of weight 0 do not count. */
typedef struct batten_fit_report {
    double error, rms; /**< largest distance, root of the mean square */
    int worst;         /**< index of the farthest datum */
    double lambda;     /**< the weight of the penalty; 0 without one */
    double freedom;    /**< how many of the data the curve follows: the trace of the matrix that
                           turns data into values of the curve */
    double p;          /**< 1 / (1 + lambda): p of the squares and 1 - p of the penalty */
    int rounds;        /**< of parameter correction, or of reweighting */
    bool regularised;  /**< the data do not determine the curve, and a penalty did */
    double sum;        /**< of squares of the distances, times weights */
    int pressing;      /**< inequalities that hold with equality and keep the curve from data */
    int reweightings;  /**< rounds of a robust fit */
    double threshold;  /**< the distance from which on a robust fit counts data less */
    double gap;        /**< no curve with these knots and parameters, under these conditions,
                           makes what is summed smaller by more than this share; 0 without
                           `robust`, infinite with BATTEN_TUKEY */
} batten_fit_report;

/** The data of a fit; borrowed for the call. */
typedef struct batten_fit_data {
    batten_points points;
    const double
        *parameters;       /**< [count], of the points on the curve, as a fit hands them over */
    const double *weights; /**< [count]; points of weight 0 do not count; or NULL */
} batten_fit_data;

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

typedef struct batten_curve_least_squares_options {
    size_t size;
    int degree;                        /**< 3 */
    int point_count;                   /**< control points; periodic: of one period. 0: one for
                                            every four data */
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given;               /**< [count], never decreasing; periodic [count + 1] */
    const double *weights;             /**< [count], or NULL */
    batten_knot_choice knots;
    const double *given_knots; /**< [point_count + degree + 1]; periodic [point_count + 1] */
    bool closed; /**< the curve closes smoothly; the first point is not repeated */
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
                             and 4.685 standard deviations of normal errors */
} batten_curve_least_squares_options;

/** Cubic, by chords, knots by data. */
BATTEN_API batten_curve_least_squares_options batten_curve_least_squares_defaults(void);

/**
 * The spline curve with the least sum of squared distances from points.
 *
 * @param points  [count][dimension]
 * @param options NULL for the defaults
 * @param[out] parameters [count], those of the points at last; may be NULL
 * @param[out] report  what was reached; may be NULL
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
 * unknowns, whose cube is the cost.
 * Source: [deBoor01] ch. XIV, [PT97] 9.4, [Hoschek88] for correction, [GI83] for conditions,
 * [HW77] for weights.
 */
BATTEN_API batten_status batten_curve_least_squares(
    batten_points points, const batten_curve_least_squares_options *options, double *parameters,
    batten_fit_report *report, batten_curve **out);

/**
 * The data that are much farther from a curve than most.
 *
 * @param curve  of the dimension of the data
 * @param data  parameters: of the points on the curve, as a fit hands them over
 *     weights: [count]; points of weight 0 do not count; or NULL
 * @param times  above 0; an outlier is farther than so many times the median distance, the
 *              nearest data set aside, as many as there are control points but at most half; 5
 *              is some 3.4 standard deviations of a function's normal errors. Distances that
 *              are rounding are never outliers
 * @param[out] distance  model units; what lies farther is an outlier; may be NULL
 * @param[out] outliers  [count] their indices, rising
 * @param[out] outlier_count  how many there are
 * @return BATTEN_OK; TOO_FEW_POINTS, NOT_FINITE, BAD_WEIGHT, BAD_ARGUMENT (times), UNSUPPORTED
 * (another dimension), OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: one evaluation for each datum, and n log n to find the median of n distances.
 */
BATTEN_API batten_status batten_curve_outliers(const batten_curve *curve,
                                               const batten_fit_data *data, double times,
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

typedef struct batten_curve_smooth_options {
    size_t size;
    batten_smooth_by by; /**< BATTEN_SMOOTH_BY_VALIDATION */
    double amount;
    int order;  /**< m, 1..4: of the derivative, of the differences, that is penalised; 2 */
    int spans;  /**< of a P-spline; 40 */
    int degree; /**< of a P-spline; 3 */
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given;               /**< [count], never decreasing; periodic [count + 1] */
    const double *weights;             /**< [count], or NULL */
    bool closed;
} batten_curve_smooth_options;

/** By validation, second differences, chords; 40 cubic spans for a P-spline. */
BATTEN_API batten_curve_smooth_options batten_curve_smooth_defaults(void);

/**
 * The smoothing spline: least sum of w |s(t) - q|^2 plus lambda times the integral of
 * |s^(m)|^2.
 *
 * Of all curves the best is a natural spline of degree 2 m - 1 with a knot at every parameter;
 * m = 2 is the batten pulled towards its ducks by springs. lambda = 0 gives the interpolating
 * natural spline (through the means of data with one parameter), infinity the polynomial of
 * degree m - 1 by least squares (a point when periodic). `spans` and `degree` are not used.
 *
 * @param points  [count][dimension]
 * @param options  NULL for the defaults
 * @param[out] parameters [count]; may be NULL
 * @param[out] report lambda, p, freedom and what the fit reached; may be NULL
 * @return as batten_curve_least_squares
 * Cost: linear in count for each lambda that is tried; a given one is one, others some 25.
 * Source: [Reinsch67] for the target, [CW79] for validation, [HdH85] for its trace.
 */
BATTEN_API batten_status batten_curve_smooth(batten_points points,
                                             const batten_curve_smooth_options *options,
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
 *
 * @param points  [count][dimension], in the order of the curve
 * @param options  NULL for the defaults; spans: above the order, default as the struct says
 * @param[out] parameters  [count], those of the points; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT, NOT_INCREASING, BAD_DEGREE,
 * BAD_KNOTS, BAD_WEIGHT, OUT_OF_DOMAIN, BAD_ARGUMENT, NOT_COMPATIBLE, SINGULAR_SYSTEM,
 * TOLERANCE_NOT_MET, TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: as batten_curve_smooth, with spans + degree unknowns instead of one for each datum.
 */
BATTEN_API batten_status batten_curve_p_spline(batten_points points,
                                               const batten_curve_smooth_options *options,
                                               double *parameters, batten_fit_report *report,
                                               batten_curve **out);
/** How the knots of a curve within a tolerance are found. */
typedef enum batten_within_method {
    BATTEN_WITHIN_FEWEST, /**< by insertion and by removal: whichever leaves fewer; of more than
                               5000 points by insertion alone, where that does */
    BATTEN_WITHIN_INSERT, /**< none at first, then one where a span is too far off */
    BATTEN_WITHIN_REMOVE, /**< one for each datum at first */
    BATTEN_WITHIN_BEZIER  /**< cubics with common tangents, divided where they are too far off:
                               fast, local, about twice the control points; curvature jumps */
} batten_within_method;

typedef struct batten_curve_within_options {
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
    int corner_count;      /**< besides: points that are corners */
    const int *corners;    /**< [corner_count], increasing */
    const batten_job *job; /**< progress and cancelling, asked after each fit; NULL for no
                                questions. The fits to come are not known: progress counts those
                                that were made, and never reaches the end before the end */
} batten_curve_within_options;
/** Cubic, by chords, the fewest control points; the tolerance must be set. */
BATTEN_API batten_curve_within_options batten_curve_within_defaults(void);

/** Distances at the parameters of the data, so no datum is farther from the curve. */
typedef struct batten_curve_within_report {
    double error, rms;
    int worst;    /**< index of the farthest datum */
    double apart; /**< how far the curve leaves the polygon of the data: the largest distance of
                       4 places of the curve between any two data from their chord */
    int points;   /**< control points; of a periodic curve those of one period */
    int corners;  /**< those inside, and of a closed curve all */
    int fits;     /**< by least squares, that were tried */
} batten_curve_within_report;

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
 * @param options  NULL for the defaults
 * @param[out] parameters [count], of the points on the curve: not farther than the tolerance
 *             there. Of a closed curve with corners they begin at a corner. May be NULL
 * @param[out] report  what was reached; may be NULL
 * @param[out] out clamped; periodic when closed without corners, but for BEZIER
 * @return BATTEN_OK; BAD_ARGUMENT (tolerance, corners, a closed function, a function by
 * BEZIER), BAD_DEGREE, NOT_FINITE, TOO_FEW_POINTS (2), COINCIDENT (all), NOT_INCREASING;
 * TOLERANCE_NOT_MET with the best that was reached; CANCELLED and INCOMPLETE by the job
 * Cost: 64 log2(count) fits for each way at most, of more than 3000 points fewer, each linear
 * in count; BEZIER count log(count) for rows that divide evenly.
 * Source: [LM88] for removal, [Schneider90] for BEZIER, [Hoschek88] for parameters.
 */
BATTEN_API batten_status batten_curve_within(batten_points points,
                                             const batten_curve_within_options *options,
                                             double *parameters,
                                             batten_curve_within_report *report,
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
 *
 * Cost: where knots are removed, as batten_curve_remove_knots; where samples are fitted, some
 * log2(n) fits for n knots, each linear in the samples, and a bound on the control points after
 * each.
 * Source: [LM88] for the strategy.
 */
BATTEN_API batten_status batten_curve_approximate(const batten_curve *curve, int degree,
                                                  double tolerance, double *error,
                                                  batten_curve **out);
/**
 * The same for a chain, at equal parameters of the chain, so by arc length where it goes so.
 * It is made a curve within a sixteenth of the tolerance first, whose bound, that of
 * batten_chain_to_curve, is sampled and counts in the error.
 *
 * @param chain  any; a closed one that is smooth at its seam gives a periodic curve
 * @param degree  1 to 25
 * @param tolerance  model units, above 0
 * @param[out] error  a bound on the distance, model units; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_DEGREE, BAD_ARGUMENT, TOLERANCE_NOT_MET, OUT_OF_MEMORY
 *
 * Cost: that of batten_chain_to_curve at a sixteenth of the tolerance, then that of
 * batten_curve_approximate.
 */
BATTEN_API batten_status batten_chain_approximate(const batten_chain *chain, int degree,
                                                  double tolerance, double *error,
                                                  batten_curve **out);
typedef struct batten_curve_even_speed_report {
    double length;
    double error; /**< a bound of the distance at equal arc length, from a bound of the sixth
                     derivative on each piece, the error of its length and the rounding of the
                     coordinates; 0 for polylines */
    double speed; /**< the largest | |C'| - 1 | among 7 samples of each piece */
    int pieces;
} batten_curve_even_speed_report;

/**
 * Nearly the same curve with the arc length as its parameter: domain [0, length].
 *
 * Only straight lines are polynomials, or rational, of their arc length. All else is followed
 * by quintics that have the point, the tangent and the curvature of the curve at their ends,
 * halved until none is farther from the curve, at equal arc length, than `tolerance`. Polylines
 * are exact. The result is clamped, C2 but at corners and where curvature jumps, and C0 there.
 *
 * @param curve     of 2 or 3 dimensions
 * @param tolerance model units, > 0
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT, UNSUPPORTED (a function), COINCIDENT (a curve that is a
 * point), TOLERANCE_NOT_MET, TOO_LARGE
 * Cost: linear in the pieces.
 * Source: [PT97] for the inverse, [dBHS87] for the order, 6.
 */
BATTEN_API batten_status batten_curve_even_speed(const batten_curve *curve, double tolerance,
                                                 batten_curve_even_speed_report *report,
                                                 batten_curve **out);
/** How near the points are. */
typedef struct batten_primitive_report {
    double error, rms; /**< largest distance, root of the mean square; model units */
    int worst;         /**< index of the farthest point */
    int rounds;        /**< of refinement */
} batten_primitive_report;

/** A line: its points are point + s * direction. */
typedef struct batten_fitted_line {
    double point[3];     /**< the mean of the data */
    double direction[3]; /**< of length one, from the first datum towards the last */
    double from, to;     /**< s of the outermost feet */
} batten_fitted_line;

/**
 * The line in the plane or in space with the least sum of squared distances (total least
 * squares, by the eigenvectors of the spread).
 * @param points [count][dimension], dimension 2 or 3, count >= 2
 * @param[out] report  what was reached; may be NULL
 * @param[out] line  a point of it, its unit direction, and what it spans
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, TOO_LARGE, NOT_FINITE; COINCIDENT when all
 * points are one; SINGULAR_SYSTEM when they spread alike in several directions; OUT_OF_MEMORY
 *
 * Cost: linear in count; nothing is iterated.
 */
BATTEN_API batten_status batten_line_fit(batten_points points, batten_primitive_report *report,
                                         batten_fitted_line *line);

/** What a circle through points minimises. */
typedef enum batten_circle_method {
    BATTEN_CIRCLE_GEOMETRIC, /**< distances, by Gauss and Newton from Taubin's circle */
    BATTEN_CIRCLE_TAUBIN,    /**< (x^2 + y^2 - r^2)^2 by its mean slope: nearly unbiased */
    BATTEN_CIRCLE_PRATT,     /**< nearly the same; works for lines too */
    BATTEN_CIRCLE_KASA       /**< (x^2 + y^2 - r^2)^2: linear; too small on short arcs */
} batten_circle_method;

/** A circle in the xy-plane of `frame`, about its origin; the data lie from `start` to
 * `start + angle`, radians, as they go from the first to the last. */
typedef struct batten_fitted_circle {
    batten_frame frame;
    double radius;
    double start, angle; /**< angle in (0, 2 pi]: 2 pi when the data go all around */
} batten_fitted_circle;

/**
 * The circle nearest to points of the plane, or in space within the plane nearest to them; the
 * normal is such that the data run counter-clockwise.
 * @param points [count][dimension], dimension 2 or 3, count >= 3
 * @param method  which of them
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE; SINGULAR_SYSTEM when the points
 * lie on a line
 * Cost: linear in count for each round.
 * Source: [Taubin91], [Pratt87].
 */
BATTEN_API batten_status batten_circle_fit(batten_points points, batten_circle_method method,
                                           batten_primitive_report *report,
                                           batten_fitted_circle *circle);

/** An ellipse in the plane: center + a cos(t) axis + b sin(t) (axis turned left), a >= b; the
 * data lie from t = `start` to `start + angle`. */
typedef struct batten_fitted_ellipse {
    double center[2], axis[2];
    double a, b;
    double start, angle; /**< angle in (0, 2 pi], negative when the data run clockwise */
} batten_fitted_ellipse;

/**
 * The ellipse nearest to points of the plane: Fitzgibbon's direct fit, which is always an
 * ellipse, then the distances at right angles.
 * @param points [count][2], count >= 5
 * @param[out] report  what was reached; may be NULL
 * @param[out] ellipse  centre, half axes and angle
 * @return BATTEN_OK, UNSUPPORTED (not in the plane), TOO_FEW_POINTS, TOO_LARGE, NOT_FINITE;
 * SINGULAR_SYSTEM when the points determine no ellipse (on a line, a parabola or a hyperbola);
 * OUT_OF_MEMORY
 *
 * Cost: linear in count for each round of the distances; the direct fit before is one round
 * more.
 * Source: [FPF99] in the stable form of [HF98].
 */
BATTEN_API batten_status batten_ellipse_fit(batten_points points,
                                            batten_primitive_report *report,
                                            batten_fitted_ellipse *ellipse);

/**
 * The clothoid nearest to points of the plane, given in their order along it: curvature linear
 * in arc length. Lines and arcs are clothoids.
 *
 * @param points [count][2], count >= 4, neighbours apart; between neighbours the curve turns by
 *               less than a right angle
 * @param job   progress, cancelling, a limit of steps (256 for each 256 points of a round or part
 *              of them); NULL for none
 * @param[out] lengths [count], arc lengths of the feet from there; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @param[out] span  BATTEN_SPAN_SPIRAL, from the foot of the first to that of the last
 * @return BATTEN_OK, UNSUPPORTED (not in the plane), TOO_FEW_POINTS, TOO_LARGE, NOT_FINITE,
 * COINCIDENT; TOLERANCE_NOT_MET when the first guess is too far off for rounds to converge;
 * CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: linear in count for each round, of which there are 200 at most.
 * Source: the distances at right angles as in [ARW01].
 */
BATTEN_API batten_status batten_clothoid_fit(batten_points points, const batten_job *job,
                                             double *lengths, batten_primitive_report *report,
                                             batten_span *span);
/** How far the points that went are from the polyline through those that stayed, each from the
 * chord that stands for it; model units. */
typedef struct batten_points_thin_report {
    double error, rms; /**< the largest, root of the mean square over all points */
    int worst;         /**< index of the farthest point */
} batten_points_thin_report;

/**
 * The points of a row that are needed so that every other point lies within `tolerance` of the
 * chord between its two kept neighbours.
 *
 * The distance is that of the points from the chords, not of the chords from the row: where a
 * row runs to and fro, a chord may lie farther from it than `tolerance`. A row is split where
 * it is farthest from its chord, so corners stay; the ends stay. Parts that would cost more
 * than 32 log2(count) looks at each point that way are walked with chords as long as the
 * tolerance allows, which keeps the bound.
 *
 * @param points    [count][dimension], dimension 2 or 3; neighbours may coincide
 * @param tolerance model units, 0 or more; with 0 only points that lie on their chords to
 *                  rounding go
 * @param closed    the last point is followed by the first; then any point may go, but two stay
 * @param[out] report  what was reached; may be NULL
 * @param[out] kept [count], indices of those that stay, increasing
 * @param[out] kept_count  how many
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS (none), NOT_FINITE, OVERFLOW
 * (coordinates above 1e150)
 *
 * Cost: count log(count) at most, no recursion.
 * Source: [Ramer72], [DP73].
 */
BATTEN_API batten_status batten_points_thin(batten_points points, double tolerance, bool closed,
                                            batten_points_thin_report *report, int *kept,
                                            int *kept_count);

/* ---- aerofoils ---- */

/** What batten_curve_aerofoil makes of a section. */
typedef struct batten_curve_aerofoil_options {
    size_t size;
    double chord;         /**< of the result, model units; 0: that of the points */
    double trailing_edge; /**< its height as a part of the chord, 0 (closed) to 0.5; below 0: as
                             the points have it */
    double thickness;     /**< the largest, as a part of the chord, up to 1; 0: as it comes */
    double blend;         /**< over what part of the chord a change of the trailing edge fades,
                             above 0 to 1; 1: in proportion to the distance from the nose */
    int panels;           /**< 160; even, 8 to 10000: the curve passes one point more */
} batten_curve_aerofoil_options;

/** The given chord, no change of shape, 160 panels. */
BATTEN_API batten_curve_aerofoil_options batten_curve_aerofoil_defaults(void);

/** What is known about one shape of a section; all but the chord are parts of the chord. */
typedef struct batten_aerofoil_shape {
    double chord;                   /**< from the nose to the middle of the trailing edge, model
                                       units */
    double thickness, thickness_at; /**< the largest across the chord, and where */
    double camber, camber_at;       /**< the largest of the middle line, with its sign */
    double trailing_edge;           /**< upper end above lower end; below 0 where sides cross */
} batten_aerofoil_shape;

/** What was found in the points, and what the delivered curve has, measured on it. */
typedef struct batten_curve_aerofoil_report {
    batten_aerofoil_shape given, made;
    double distance, rms; /**< of the given points, moved by the asked changes alone, from the
                             curve; model units of the result */
    int worst;            /**< index of the given point that is farthest */
    double moved;         /**< the largest distance by which thickness and trailing edge moved a
                             given point; model units of the result */
    double turn;          /**< the angle from the x axis to the given chord, radians */
    int repeated;         /**< points left out because they repeat the one before */
    int base;             /**< points left out because they lie on the base that closes a blunt
                             trailing edge */
    int crossings;        /**< places where the delivered curve crosses itself */
    double crossing;      /**< the first of them, as a part of the chord */
    bool reversed;        /**< the lower side came first */
    bool halves;          /**< both sides ran from the nose, as in Lednicer's files */
    bool closed;     /**< the point of the trailing edge stood at one end alone; now at both */
    bool mirrored;   /**< the nose was on the right */
    bool round_tail; /**< the tail is rounder than the nose: the points may begin there */
} batten_curve_aerofoil_report;

/**
 * An aerofoil section in one form, so that any two make a skin: the nose at the origin, the
 * middle of the trailing edge on the x axis, from the trailing edge over the upper side to the
 * nose (at parameter 1/2) and back below. All results of as many panels have the same knots.
 *
 * The points are taken as Selig's or Lednicer's files have them, in either direction, turned,
 * and with repeated points; where they are closed by the base of a blunt trailing edge, the
 * points on the base are left out, and where only one end is the point of the trailing edge, it becomes
 * the other end too. A cubic spline passes the rest. Its nose is its point
 * farthest from the middle of the trailing edge. Points are placed on it at distances that
 * follow a cosine, dense at nose and tail, and the C2 cubic through them is the result.
 *
 * Thickness is measured and changed across the chord: at each x the middle between both sides
 * stays, and what is added to open the trailing edge fades to 0 at the nose as
 * x exp((1 - x)(1 - 1 / blend)). Changes first bring both ends to the same x.
 *
 * @param points  [count][2], at least 5 that differ, beginning and ending at the trailing edge
 * @param options NULL for the defaults
 * @param[out] report  may be NULL
 * @param[out] out  of dimension 2, degree 3, domain [0, 1]
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, BAD_ARGUMENT (options out of range),
 * NOT_COMPATIBLE (points that do not begin and end at the trailing edge, a thickness below what
 * the trailing edge takes), OUT_OF_MEMORY
 *
 * Cost: linear in points and panels, some 100 evaluations for each.
 * Source: [Drela89] for the nose and the fading of a change of the trailing edge.
 */
BATTEN_API batten_status batten_curve_aerofoil(batten_points points,
                                               const batten_curve_aerofoil_options *options,
                                               batten_curve_aerofoil_report *report,
                                               batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
