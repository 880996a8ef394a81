#ifndef BATTEN_SURFACE_FILLET_H
#define BATTEN_SURFACE_FILLET_H
/**
 * @file
 * Fillets: the surface that a rolling ball leaves between two surfaces.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Why a fillet ends. */
typedef enum batten_fillet_end {
    BATTEN_FILLET_BORDER_1, /**< the ball reaches the border of the first surface, */
    BATTEN_FILLET_BORDER_2, /**< of the second */
    BATTEN_FILLET_LOST,     /**< inside of both the ball finds no further place: the surfaces
                                 become tangent, or bend more than the ball */
    BATTEN_FILLET_CLOSED    /**< it comes back to where it began */
} batten_fillet_end;

typedef struct batten_surface_fillet {
    batten_surface *surface;   /**< u along the spine, v from the first surface to the second */
    batten_curve *contacts[2]; /**< in space, */
    batten_curve *on[2];       /**< and in the parameters of either surface */
    batten_curve *spine;       /**< of the centre of the ball. All over the domain of u */
    double error;              /**< largest measured distance from the true fillet, in planes
                                    across the spine halfway between its stations */
    double least, most;        /**< angles of the arcs, radians */
    int stations;
    batten_fillet_end ends[2]; /**< at the least u and at the greatest */
} batten_surface_fillet;
BATTEN_API void batten_surface_fillet_release(batten_surface_fillet *fillet);

/**
 * A ball of the radius rolls on both surfaces; the arcs between its contacts are the fillet.
 *
 * The centre S1 + r1 n1 = S2 + r2 n2 is found first where the two offsets, sampled, are
 * nearest, then marched along both ways by Newton's method until the ball reaches a border (not
 * across the seam of a closed surface). Sections are exact arcs, rational quadratics at the
 * stations, which are doubled until the spline through them is within the tolerance. The
 * intersection of the surfaces is not needed. When the offsets meet in several curves, only one
 * is followed.
 *
 * @param surfaces two, NURBS, in space
 * @param radii    [2] the radius, with the sign of the side: positive where the normal points
 * @param start    [4] u and v on the first, on the second surface, from where the ball is
 *                 sought; NULL: where the offsets are nearest
 * @param tolerance model units, > 0
 * @return BATTEN_OK; BAD_ARGUMENT, NOT_FINITE, UNSUPPORTED; NOT_FOUND, with the distance of the
 * offsets; SINGULAR_HERE when the ball does not fit into a hollow, with place and radius;
 * TOLERANCE_NOT_MET
 * Source: [PM02] ch. 11; [PT97] 7.3 for the arcs.
 */
BATTEN_API batten_status batten_surfaces_fillet(const batten_surface *const surfaces[2],
                                                const double radii[2], const double *start,
                                                double tolerance, batten_surface_fillet *out);

#ifdef __cplusplus
}
#endif
#endif
