#ifndef BATTEN_EVEN_SPEED_H
#define BATTEN_EVEN_SPEED_H
/**
 * @file
 * Curves run through at speed one.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_even_speed_report {
    double length;
    double error; /**< 1.2 times the largest distance at equal arc length among 7 samples of
                     each piece; 0 for polylines */
    double speed; /**< the largest | |C'| - 1 | there */
    int pieces;
} batten_even_speed_report;

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
 * @param[out] report may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT, UNSUPPORTED (a function), COINCIDENT (a curve that is a
 * point), TOLERANCE_NOT_MET, TOO_LARGE
 * Cost: linear in the pieces. Source: [PT97] for the inverse, [dBHS87] for the order, 6.
 */
BATTEN_API batten_status batten_curve_even_speed(const batten_curve *curve, double tolerance,
                                                 batten_even_speed_report *report,
                                                 batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
