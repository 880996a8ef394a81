#ifndef BATTEN_QUADRATIC_H
#define BATTEN_QUADRATIC_H
/**
 * @file
 * Quadratic splines through points: parabolas that join with one tangent.
 *
 * Where their knots are decides about them. Knots midway between the data are sound; knots at
 * the data are not: an error of the first slope goes on for ever with changing sign.
 */
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_quadratic_kind {
    BATTEN_QUADRATIC_BETWEEN,   /**< any data, knots midway between them, none in the two end
                                     spans */
    BATTEN_QUADRATIC_MIDPOINTS, /**< the data are the mid-points of the spans between knots, and
                                     both ends */
    BATTEN_QUADRATIC_SEQUENTIAL /**< knots at the data, one parabola after another */
} batten_quadratic_kind;

/** SEQUENTIAL: the one slope that is needed. */
typedef enum batten_quadratic_slope {
    BATTEN_QUADRATIC_BEST, /**< that which makes the sum of the squared jumps of P'' least */
    BATTEN_QUADRATIC_AT_START, /**< P' at the first point is given */
    BATTEN_QUADRATIC_AT_END    /**< P' at the last point is given */
} batten_quadratic_slope;

typedef struct batten_quadratic_options {
    size_t size;
    batten_quadratic_kind kind;        /**< BETWEEN */
    batten_parametrization parameters; /**< BATTEN_CHORD; MIDPOINTS: UNIFORM or GIVEN, else they
                                            are taken as uniform */
    const double *given;               /**< [count] with BATTEN_GIVEN */
    batten_quadratic_slope slope;      /**< BEST */
    double vector[3];                  /**< AT_START, AT_END: P' */
} batten_quadratic_options;

/** Knots midway between the data, chord parameters. */
BATTEN_API batten_quadratic_options batten_quadratic_defaults(void);

/**
 * A quadratic spline through points.
 *
 * MIDPOINTS: the knots k follow from the parameters t, k[0] = t[0], then k[i] = 2 t[i] - k[i -
 * 1]; they must increase and end at the last parameter. With uniform parameters these are 0,
 * 1/2, 3/2, 5/2 ... n. Its values at the knots are a dominant system. All three kinds reproduce
 * parabolas; the error of BETWEEN and MIDPOINTS falls with the third power of the step, that of
 * SEQUENTIAL does so only with the right slope. Two points give a line, three points of BETWEEN
 * or MIDPOINTS the parabola (MIDPOINTS: through the middle one at its mid-parameter).
 *
 * @param points     [count][dimension], at least two; MIDPOINTS: three
 * @param options    NULL for the defaults
 * @param[out] parameters [count], those of the points; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, NOT_INCREASING,
 * NOT_COMPATIBLE (parameters that are no mid-points, with the knot), OVERFLOW,
 * TOLERANCE_NOT_MET (a point is missed by more than rounding)
 *
 * Cost: linear in count. Source: [Marsden74], [deBoor01] ch. VI.
 */
BATTEN_API batten_status batten_curve_quadratic(int dimension, int count, const double *points,
                                                const batten_quadratic_options *options,
                                                double *parameters, batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
