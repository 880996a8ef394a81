#ifndef BATTEN_BETA_H
#define BATTEN_BETA_H
/**
 * @file
 * Uniform Beta-splines: cubic pieces that join with one tangent and one curvature, and two
 * numbers that shape all joints: beta1 the bias, beta2 the tension.
 *
 * At a joint P' after it is beta1 times P' before it, and P'' after it beta1^2 P'' + beta2 P'
 * before it. With beta1 = 1 and beta2 = 0 they are the uniform cubic B-splines.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What the points are. */
typedef enum batten_beta_use {
    BATTEN_BETA_NEAR,   /**< control points: the curve is drawn to them, and passes the ends */
    BATTEN_BETA_THROUGH /**< the joints: the curve passes all of them */
} batten_beta_use;

/**
 * A Beta-spline near or through points, of one Bezier piece for each step from point to point;
 * point i belongs to the parameter i. At the ends of an open curve there is no curvature; a
 * closed one comes back as a periodic curve.
 *
 * Larger beta2 draws the curve to its polygon; beta1 above 1 makes it leave each joint faster
 * than it comes, so that it leans to the later points, below 1 to the earlier ones: the
 * reversed points with 1 / beta1 and beta2 / beta1^3 give the reversed curve. Through points,
 * values far from 1 and 0 make large swings. For beta1 other than 1 the parameter has jumps of
 * speed at the joints, the shape is smooth.
 *
 * @param points [count][dimension]; open: at least two; closed: at least three, each once
 * @param beta1  above 0
 * @param beta2  0 or more
 * @return BATTEN_OK, BAD_ARGUMENT (the betas), NOT_FINITE, TOO_FEW_POINTS, OVERFLOW,
 * SINGULAR_SYSTEM, TOLERANCE_NOT_MET (a joint that misses its point by more than rounding)
 *
 * Cost: linear in count. Source: [Barsky88].
 */
BATTEN_API batten_status batten_curve_beta(int dimension, int count, const double *points,
                                           batten_beta_use use, double beta1, double beta2,
                                           bool closed, batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
