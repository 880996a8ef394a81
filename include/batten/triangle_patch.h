#ifndef BATTEN_TRIANGLE_PATCH_H
#define BATTEN_TRIANGLE_PATCH_H
/**
 * @file
 * Surfaces between three boundary curves, as formulas: transfinite interpolation over a
 * triangle.
 */
#include <batten/ribbon.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_triangle_method {
    /** Nielson: along the lines from each side to its opposite corner. With slopes of cubic
     * precision. Kind "side-vertex". */
    BATTEN_TRIANGLE_SIDE_VERTEX,
    /** Barnhill, Birkhoff and Gordon: along parallels to the sides; half the sum of the three
     * less the plane of the corners, or, with slopes, the mean of the six Boolean sums, whose
     * twists are reconciled by rational terms. Kind "barnhill-birkhoff-gordon". */
    BATTEN_TRIANGLE_PARALLELS,
    /** Charrot and Gregory: Taylor expansions about both sides of each corner, blended. Kind
     * "charrot-gregory". */
    BATTEN_TRIANGLE_CORNERS
} batten_triangle_method;

/**
 * The surface between three curves.
 *
 * It is seen over the unit square: barycentric coordinates (1 - u, u (1 - v), u v), where
 * corner 0 is opposite the first curve and v runs along that curve; u = 0 is a pole. Corners
 * and curves may come in any order: only the labels change, not the surface.
 *
 * Without slopes the surface meets the curves (C0). With one or more it has along each such
 * curve the tangent planes that the curve and its slope span: to meet the other curves'
 * tangents at the corners, the slope T becomes k(t) T + h(t) C', k and h linear. Curves without
 * a slope take the linear blend of their neighbours' tangents. Curvatures of ribbons are not
 * used.
 *
 * Derivatives at corners 1 and 2 (u = 1, v = 0 and 1), where second derivatives have no limit,
 * and within 1e-6 of them in both parameters are those at that distance.
 *
 * @param ribbons   three curves of dimension 3 without kinks
 * @param tolerance  of the corners, in model units; the loop may be open by so much there
 * @param angle_tolerance  in radians: how far a curve may leave the tangent plane of its
 * neighbour's ribbon at a corner
 * @return BATTEN_OK; NOT_COMPATIBLE naming the corner and the gap, or the angle; COINCIDENT;
 * SINGULAR_HERE where slopes are given and a curve has no tangent at a corner, or a ribbon no
 * tangent plane; BAD_ARGUMENT for other dimensions or a curve with a kink
 *
 * Cost: 3 to 6 points of curves each, and some thousand multiplications, for a point with
 * derivatives up to order 3.
 * Source: [BarnhillBirkhoffGordon73], [Nielson79], [CharrotGregory80]. The mean of the sums,
 * and the linear k and h, are ours: so that no order of the sides is preferred, and ribbons of
 * any surface fit.
 */
BATTEN_API batten_status batten_triangle_patch(const batten_ribbon ribbons[3],
                                               batten_triangle_method method, double tolerance,
                                               double angle_tolerance, batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
