#ifndef BATTEN_BLEND_H
#define BATTEN_BLEND_H
/**
 * @file
 * A curve from an end of one curve to an end of another.
 */
#include <batten/continuity.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a blend begins or ends. */
typedef struct batten_blend_end {
    batten_curve_end end; /**< of the curve that it joins */
    int continuity;       /**< G0 to G3 */
    double bulge; /**< > 0: the speed there, as a part of the standard one; 1. More goes on
                       farther along the curve before it turns */
} batten_blend_end;

typedef struct batten_blend_report {
    batten_continuity joins[2]; /**< with the first curve, with the second, as one runs from the
                                     one through the blend into the other */
    double speed[2];            /**< |C'| at both ends, over the domain [0, 1] */
} batten_blend_report;

/**
 * The ends of two curves that are nearest to each other; of several pairs the first of end and
 * start, end and end, start and start, start and end.
 * @return BATTEN_OK; NOT_COMPATIBLE when their dimensions differ
 */
BATTEN_API batten_status batten_curves_nearest_ends(const batten_curve *first,
                                                    const batten_curve *second,
                                                    batten_curve_end ends[2]);

/**
 * A Bezier curve from an end of the first curve to an end of the second, of the least degree
 * that takes over point, tangent, curvature and its rate as far as asked: G0 and G0 a line, G3
 * and G3 degree 7; domain [0, 1].
 *
 * Its derivatives are those of a curve run through at the constant speed v: v T, v^2 dT/ds, v^3
 * d2T/ds2. The standard v is, for G1, that of the cubic nearest to an arc; for more, that of
 * the cubic whose speed is the same at both ends and in the middle; where the curve joined
 * bends so sharply that v would turn by more than 4 radians it
 * is less. The joins are measured afterwards.
 *
 * @param first, second of the same dimension, 2 or 3
 * @param[out] report may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT (continuity, bulge), UNSUPPORTED (functions), NOT_COMPATIBLE,
 * COINCIDENT (the ends are one point), SINGULAR_HERE (an end without speed, where more than G0
 * is asked), TOLERANCE_NOT_MET when a join, measured, is not as asked
 * Source: [BD89] for the continuity.
 */
BATTEN_API batten_status batten_curves_blend(const batten_curve *first,
                                             const batten_blend_end *first_end,
                                             const batten_curve *second,
                                             const batten_blend_end *second_end,
                                             batten_blend_report *report, batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
