#ifndef BATTEN_CUBIC_SPLINE_H
#define BATTEN_CUBIC_SPLINE_H
/**
 * @file
 * Cubic splines whose joins are chosen: tangent lengths corrected so that no span has
 * inflections in excess, cusps or loops; corners and straight runs; given directions; freely
 * chosen spacing.
 */
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- no inflections in excess ---- */

/**
 * How long the derivatives at both ends of a plane cubic span may be.
 *
 * A span turns left by `alpha` from its start tangent to its chord and by `beta` from there to
 * its end tangent (radians; both to the right: both negative). When both have one sign and less
 * than a half circle together, it has no inflection, cusp or loop if and only if |P'(0)| and
 * |P'(1)|, for a parameter from 0 to 1, are at most these limits.
 *
 * @param chord its length, above 0
 * @return BATTEN_OK; NOT_COMPATIBLE when the angles have opposite signs (one inflection is then
 * right) or turn by a half circle or more; NOT_FINITE, BAD_ARGUMENT
 * Source: [SL] III.5.
 */
BATTEN_API batten_status batten_tangent_limits(double chord, double alpha, double beta,
                                               double *start, double *end);

/** What a correction leaves at the joins of the spans that it changes. */
typedef enum batten_correct_joins {
    BATTEN_CORRECT_TANGENT,  /**< directions stay: G1 */
    BATTEN_CORRECT_CURVATURE /**< and lengths nearby are chosen anew, so that curvatures agree
                                  at as many joins as possible: G2; in the plane. Where the
                                  directions bend both sides oppositely there is none */
} batten_correct_joins;

typedef struct batten_correct_options {
    size_t size;
    double within;    /**< lambda and mu come down to this; above 0 and below 1; 0.95 */
    double tolerance; /**< relative: nearer to 1 than this they are left as they are; 1e-9 */
    batten_correct_joins joins; /**< BATTEN_CORRECT_TANGENT */
} batten_correct_options;
BATTEN_API batten_correct_options batten_correct_defaults(void);

typedef struct batten_correct_report {
    int span_count;
    int corrected; /**< spans that had inflections in excess, a cusp or a loop, and have none */
    int incurable; /**< spans that keep them: they turn by a half circle or more, run back along
                        a line, or their tangents do not meet in front of them */
    int first_incurable; /**< index of the first of these, or -1 */
    int rejoined;        /**< joins whose curvatures were brought together again */
    int broken;          /**< joins whose curvatures differ now by more than 1e-6 of the larger,
                              and did not before */
} batten_correct_report;

/**
 * Shorten the end tangents of those spans of a cubic curve that have inflections in excess, a
 * cusp or a loop. Points at the knots and directions there stay; so do the knots.
 *
 * A span with lambda, mu (see cubic.h) above 0 gets both at most `within` when one is above 1;
 * with one above 0 and the other below, where one inflection is right, the positive one. Spans
 * that lie in no plane are left alone.
 *
 * @param curve   polynomial, of degree 3 at most and dimension 2 or 3
 * @param options NULL for the defaults
 * @param[out] changed [spans], 1 where a span was changed; may be NULL
 * @param[out] report  may be NULL
 * @param[out] out     with every knot three times: speeds differ at joins that were corrected.
 *                     A curve without such spans comes back as it is
 * @return BATTEN_OK, UNSUPPORTED (rational, higher degree, curvatures in space), BAD_ARGUMENT,
 * ...
 * Cost: linear; with CURVATURE about 200 quartic equations for each span near a corrected one,
 * and the best choice for all joins together. Source: [SL] III.6; [dBHS87] for curvatures.
 */
BATTEN_API batten_status batten_curve_correct_tangents(const batten_curve *curve,
                                                       const batten_correct_options *options,
                                                       int *changed,
                                                       batten_correct_report *report,
                                                       batten_curve **out);

/* ---- corners and straight runs ---- */

/** How a curve passes into a straight run. */
typedef enum batten_transition {
    BATTEN_TRANSITION_TANGENT,  /**< with its direction */
    BATTEN_TRANSITION_CURVATURE /**< and with curvature 0 */
} batten_transition;

typedef struct batten_cornered_options {
    size_t size;
    batten_parametrization parameters; /**< BATTEN_CHORD; not GIVEN */
    int corner_count;
    const int *corners; /**< rising indices of points where the direction may jump */
    int line_count;
    const int
        *lines; /**< rising indices of points from which the curve is straight to the next */
    batten_transition transition; /**< BATTEN_TRANSITION_TANGENT */
    batten_end_kind ends;         /**< at corners and ends that are free: NOT_A_KNOT, NATURAL,
                                     PARABOLIC,         BESSEL, CIRCLE or FAIR; NATURAL */
} batten_cornered_options;
BATTEN_API batten_cornered_options batten_cornered_defaults(void);

/**
 * A cubic spline through points with corners and straight runs: C2 on each smooth run, whose
 * parts are made one by one.
 *
 * Where two straight runs meet there is a corner. A smooth run between two straight ones begins
 * and ends with their directions. With curvature 0 there it has averaged knots
 * instead of knots at its points, one more for each condition that is added; of `ends` only
 * NATURAL then has a meaning for that run, the others leave its free end as it comes.
 *
 * @param points [count][dimension], dimension 2 or 3, count >= 2
 * @param[out] parameters [count], those of the points; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT (indices outside, not rising), TOO_FEW_POINTS, COINCIDENT,
 * ... Cost: linear. Source: [SL] III.7.
 */
BATTEN_API batten_status batten_curve_cornered(int dimension, int count, const double *points,
                                               const batten_cornered_options *options,
                                               double *parameters, batten_curve **out);

/* ---- given directions ---- */

/** The direction of a curve at one of its data points. */
typedef struct batten_direction_at {
    int index;
    double vector[3]; /**< any length but 0 */
} batten_direction_at;

typedef struct batten_directed_options {
    size_t size;
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given; /**< [count] with BATTEN_GIVEN: a free choice of spacing */
    int direction_count;
    const batten_direction_at *directions; /**< rising indices; their lengths are found */
    const double *tension; /**< nu [count], 0 or more: P'' jumps by nu P' at a point, which
                                stays G2; large: a sharp bend there. NULL for none */
} batten_directed_options;
BATTEN_API batten_directed_options batten_directed_defaults(void);

typedef struct batten_directed_report {
    int clamped;       /**< directions whose best length was not positive: the curve would run
                            through them backwards. They got a tenth of the mean speed there */
    int first_clamped; /**< index of the first such point, or -1 */
    double energy;     /**< sum of the integrals of |P''|^2 and of nu |P'|^2 at the points */
} batten_directed_report;

/**
 * The cubic spline through points with given directions at some of them, that has the least
 * energy: the integral of |P''|^2, and nu |P'|^2 at points with tension.
 *
 * C1 everywhere. At points without direction it is also C2, or with tension G2; at those with
 * a direction only across it. Ends without direction are natural. Whatever positive spacing is
 * given, a curve that is C2 in it is G2: so spacing and tension are all the freedom that G2
 * cubics have.
 *
 * @param points [count][dimension], dimension 1 to 3, count >= 2
 * @param[out] parameters [count]; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT (indices, tension, a direction of length 0), COINCIDENT,
 * NOT_INCREASING, TOO_FEW_POINTS, NOT_FINITE ...
 * Cost: linear; once more for each round of clamping. Source: [SL] III.7, [Nielson74].
 */
BATTEN_API batten_status batten_curve_directed(int dimension, int count, const double *points,
                                               const batten_directed_options *options,
                                               double *parameters,
                                               batten_directed_report *report,
                                               batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
