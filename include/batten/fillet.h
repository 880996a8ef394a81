#ifndef BATTEN_FILLET_H
#define BATTEN_FILLET_H
/**
 * @file
 * Corners rounded by arcs and cut by lines.
 *
 * A corner lies between the end of one curve and the start of the next, or inside a curve where
 * its direction jumps by more than 0.01 degrees.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/** An arc between two curves. */
typedef struct batten_fillet_report {
    double u[2];        /**< where the first curve is left, and the second one reached */
    batten_vec3 center; /**< of the arc */
    double angle;       /**< by which it turns, radians, above 0 and up to pi */
    double gap;         /**< of the end of the arc from the second curve */
    int found;          /**< arcs of this radius that were found */
    bool complete; /**< these are all: so it is for straight curves. Of others arcs may have
                        been overlooked that hardly touch, and so may a nearer one */
} batten_fillet_report;

/**
 * The arc of a radius that leaves the first curve and goes over into the second, both run
 * forwards, with common tangents; of several the one for which the least length goes from the
 * end of the first and the start of the second. The curves may cross beyond the corner.
 *
 * The arc is an exact rational curve. Its ends follow from the crossings of the offsets of both
 * curves, refined by Newton's method until centre and radius hold to rounding; the joins are
 * measured afterwards.
 *
 * @param first, second of 2 dimensions, or in space in one plane, to `tolerance`
 * @param radius    model units, > 0
 * @param tolerance for the plane, and for the gap where the curves are not quite in it; > 0
 * @param[out] report may be NULL
 * @param[out] arc from first(u[0]) to second(u[1]); its domain begins at u[0]
 * @return BATTEN_OK; BAD_ARGUMENT, UNSUPPORTED (functions); NOT_COMPATIBLE (dimensions, no
 * common plane, straight curves that run along each other); NOT_FOUND when no such arc was
 * found: the radius is too large, or the curves do not come near enough; TOLERANCE_NOT_MET when
 * a join, measured, is not smooth
 * Cost: that of the offsets.
 */
BATTEN_API batten_status batten_curves_fillet(const batten_curve *first,
                                              const batten_curve *second, double radius,
                                              double tolerance, batten_fillet_report *report,
                                              batten_curve **arc);

/** What became of the corners of a curve. */
typedef struct batten_corners_report {
    int corners; /**< that the curve has, the seam of a closed one among them */
    int cut;     /**< of these */
    double gap;  /**< the largest of batten_fillet_report */
    bool complete;
} batten_corners_report;

/**
 * Round all corners of a curve. What lies between keeps its shape; parameters go on from the
 * start with the speed of the curve. A closed curve that has corners, but none at its seam,
 * begins at its first corner.
 *
 * @param radius_count 1, or the number of corners
 * @param radii [radius_count], model units; 0 leaves a corner as it is
 * @param tolerance as above
 * @param[out] report may be NULL
 * @return as batten_curves_fillet; BAD_ARGUMENT (radius_count, a radius); NOT_FOUND also when
 * two arcs want the same part of the curve: the message names the corners, counted from 1
 */
BATTEN_API batten_status batten_curve_fillet(const batten_curve *curve, int radius_count,
                                             const double *radii, double tolerance,
                                             batten_corners_report *report, batten_curve **out);

/**
 * Cut off the corner between two curves by a line.
 * @param before, behind lengths along the curves that go, model units, > 0
 * @param tolerance for the gap between the curves, and for the lengths; > 0
 * @param[out] u as in batten_fillet_report; may be NULL
 * @param[out] line from first(u[0]) to second(u[1])
 * @return BATTEN_OK; BAD_ARGUMENT; UNSUPPORTED; NOT_COMPATIBLE when the curves do not meet;
 * NOT_FOUND when one is too short; COINCIDENT when the line would be a point
 */
BATTEN_API batten_status batten_curves_chamfer(const batten_curve *first,
                                               const batten_curve *second, double before,
                                               double behind, double tolerance, double u[2],
                                               batten_curve **line);
/** Cut off all corners of a curve of 2 or 3 dimensions; as batten_curve_fillet. */
BATTEN_API batten_status batten_curve_chamfer(const batten_curve *curve, double before,
                                              double behind, double tolerance,
                                              batten_corners_report *report,
                                              batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
