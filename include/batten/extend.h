#ifndef BATTEN_EXTEND_H
#define BATTEN_EXTEND_H
/**
 * @file
 * Curves made longer at their ends.
 */
#include <batten/continuity.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a curve goes on beyond its end. */
typedef enum batten_extension {
    BATTEN_EXTEND_LINE,   /**< along its tangent: G1 */
    BATTEN_EXTEND_ARC,    /**< along its circle of curvature, as an exact rational arc: G2 */
    BATTEN_EXTEND_SPIRAL, /**< curvature goes on at its rate by arc length, a clothoid in the
                               plane of the circle of curvature: G3, in space G2 where the curve
                               leaves that plane */
    BATTEN_EXTEND_NATURAL /**< the last polynomial or rational piece evaluated beyond its end:
                             no new join at all; far out it may go anywhere */
} batten_extension;

typedef struct batten_extend_report {
    batten_continuity join; /**< of the given curve with what was added, in the direction away
                                 from the curve */
    double length;          /**< of what was added */
    double error; /**< how far what was added may be from what it should be: 1.2 times the
                       largest among samples of a SPIRAL, else 0 */
} batten_extend_report;

/**
 * Make a curve longer by an arc length.
 *
 * The result has the parameters of the given curve on the old part, which keeps its shape to
 * rounding (verified at every knot and three times between), and goes on with the speed of the
 * end: the new part of its domain is as long as speed asks for. Degrees and rationality are
 * raised where the new part needs it.
 *
 * @param curve     of 2 or 3 dimensions; not periodic
 * @param length    model units, > 0; an ARC may go around once, 2 pi of its radius
 * @param tolerance of a SPIRAL from the clothoid, and of the length of a NATURAL extension;
 * model units, > 0
 * @param[out] report may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT (length, tolerance, more than once around), NOT_FINITE,
 * UNSUPPORTED (a function; make its graph first), NOT_COMPATIBLE (a periodic curve has no end),
 * SINGULAR_HERE (the end has no speed; NATURAL needs none), BAD_WEIGHT (NATURAL meets a place
 * where the weight vanishes), TOLERANCE_NOT_MET
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_extend(const batten_curve *curve, batten_curve_end end,
                                             batten_extension extension, double length,
                                             double tolerance, batten_extend_report *report,
                                             batten_curve **out);
/**
 * The same to a parameter outside the domain, which becomes the new end. A LINE, ARC or SPIRAL
 * is as long as the speed of the end times the way of the parameter.
 * @param u beyond the end named; else OUT_OF_DOMAIN
 */
BATTEN_API batten_status batten_curve_extend_to(const batten_curve *curve, batten_curve_end end,
                                                batten_extension extension, double u,
                                                double tolerance, batten_extend_report *report,
                                                batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
