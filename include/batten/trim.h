#ifndef BATTEN_TRIM_H
#define BATTEN_TRIM_H
/**
 * @file
 * Parts of curves: between parameters, over the seam, on one side of a plane.
 */
#include <batten/curve_offset.h>
#include <batten/inspect.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The part from a to b. Where b <= a the curve must be closed, its ends within `tolerance`, and
 * the part goes over the seam; it keeps the parameters of its first half. With a = b it is the
 * whole curve, begun at a.
 * @param tolerance model units, 0 or more; for the ends, which meet halfway
 * @return as batten_curve_subrange; NOT_COMPATIBLE when b <= a and the curve is open;
 * BAD_ARGUMENT (tolerance)
 */
BATTEN_API batten_status batten_curve_trim(const batten_curve *curve, double a, double b,
                                           double tolerance, batten_curve **out);

/**
 * The parts on the side of the plane `normal . x = offset` to which the normal points, in their
 * order along the curve; of a curve in the plane, of a line. What lies in the plane belongs to
 * the part beside it. The parts of a closed curve go over its seam.
 * @param normal of any length but 0; `offset` in its measure
 * @param tolerance as above
 * @param[out] out release with batten_curves_release; no curve when nothing is on that side
 * @return as batten_curve_plane_crossings and batten_curve_trim
 */
BATTEN_API batten_status batten_curve_trim_plane(const batten_curve *curve, batten_vec3 normal,
                                                 double offset, double tolerance,
                                                 batten_curves *out);

#ifdef __cplusplus
}
#endif
#endif
