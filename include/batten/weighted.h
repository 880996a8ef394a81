#ifndef BATTEN_WEIGHTED_H
#define BATTEN_WEIGHTED_H
/**
 * @file
 * Weighted splines and nu-splines through points: cubics with a say in where they are stiff.
 *
 * Among all curves through the points they make the sum over the spans of w times the integral
 * of |P''|^2, plus the sum over the inner points of nu |P'|^2, least. A large w makes a span
 * straighter, a large nu draws the bend into its point.
 */
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Where the weights of the spans come from. */
typedef enum batten_weight_rule {
    BATTEN_WEIGHTS_GIVEN, /**< those given, or 1 */
    BATTEN_WEIGHTS_SLOPE  /**< (1 + slope^2)^-3 of each chord, after Salkauskas: for functions
                               with steep places */
} batten_weight_rule;

typedef struct batten_weighted_options {
    size_t size;
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given;               /**< [count] (closed: [count + 1]) with BATTEN_GIVEN */
    bool closed;                       /**< closes smoothly; the first point is not repeated */
    batten_end start, end; /**< NATURAL; also CLAMPED, DIRECTION, SECOND, PARABOLIC, BESSEL,
                                CIRCLE */
    double nu;             /**< at every point, times the mean step of the parameters, so that
                                no unit matters. 0: none; 10: much */
    const double *nus;     /**< [count] point by point, instead; or NULL. Those of the ends of
                                an open curve say nothing */
    batten_weight_rule rule;
    const double *weights; /**< [spans], above 0; NULL: 1 */
} batten_weighted_options;

/** Chord parameters, natural ends, nu 0, all weights 1: the cubic spline. */
BATTEN_API batten_weighted_options batten_weighted_defaults(void);

/**
 * The weighted nu-spline through points: a cubic for each span, with a common tangent at the
 * points.
 *
 * There w P'' after the point less w P'' before it is nu P'. So equal weights give continuous
 * curvature; unequal ones make it jump. With very large nu everywhere it becomes the polygon,
 * with one large nu a point gets a corner, where P' comes to 0. Negative nu loosen the point
 * and are allowed while there is a least. A closed curve comes back as a periodic one.
 *
 * @param dimension  1..3
 * @param points     [count][dimension], at least two; closed: at least three, each once
 * @param options    NULL for the defaults
 * @param[out] parameters [count], those of the points; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT (weights, ends), NOT_FINITE, TOO_FEW_POINTS, COINCIDENT,
 * NOT_INCREASING, SINGULAR_SYSTEM (nu too negative), OVERFLOW, TOLERANCE_NOT_MET
 *
 * Cost: linear in count. The equations are checked for the slopes found.
 * Source: [Nielson74], [Salkauskas84], [Foley87].
 */
BATTEN_API batten_status batten_curve_weighted(int dimension, int count, const double *points,
                                               const batten_weighted_options *options,
                                               double *parameters, batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
