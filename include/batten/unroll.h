#ifndef BATTEN_UNROLL_H
#define BATTEN_UNROLL_H
/**
 * @file
 * Surfaces of straight lines laid flat: plates to be cut from sheet.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Which lines of the surface are its rulings. */
typedef enum batten_straight {
    BATTEN_STRAIGHT_FIND, /**< those that are straighter */
    BATTEN_STRAIGHT_V,    /**< v runs along the rulings */
    BATTEN_STRAIGHT_U
} batten_straight;

typedef struct batten_unroll_options {
    size_t size;
    batten_straight straight; /**< BATTEN_STRAIGHT_FIND */
    double tolerance; /**< of the flat outline, and of how straight the rulings are; model
                           units, > 0 */
} batten_unroll_options;
BATTEN_API batten_unroll_options batten_unroll_defaults(void);

/** A surface laid flat. The first edge is where the rulings begin; it starts at (0, 0), and the
 * first ruling points along y. */
typedef struct batten_unrolled {
    batten_surface *surface;      /**< NURBS with its rulings along v */
    batten_curve *first, *second; /**< flat edges [2], with the u of the surface; a vertex of a
                                       cone is an edge of length 0 */
    int count;      /**< of rulings known: those between the cubic pieces of the edges */
    double *u;      /**< [count] where they are */
    double *points; /**< [count][2][2] their flat ends, on the first and on the second edge */
    double turn;    /**< of the rulings from first to last, radians, positive to the left */
    double error;   /**< of the flat edges, model units, measured midway between the rulings */
    double bow;     /**< how far a line taken for a ruling is from its chord */

    /* What the sheet suffers: 0 but for rounding when the surface is developable. */
    double length_first[2], length_second[2]; /**< of the edges: in space, flat */
    double area[2];                           /**< in space, flat */
    double strain;       /**< largest relative change of length at a point, in any direction */
    double strain_rms;   /**< its root mean square over the area */
    double strain_at[2]; /**< (u, v) of the largest */
    double diagonal[2];  /**< largest relative change of a diagonal between neighbouring known
                              rulings, and the u where it is */
} batten_unrolled;

/**
 * Lay a ruled surface flat.
 *
 * Each ruling keeps its length; it turns in the plane as fast as it turns in space about the
 * normal of the surface midway along it, and the first edge moves as it moves in the tangent
 * plane there. For developable surfaces this is the isometry; for others the tangent planes at
 * the ends of a ruling differ, and the strain says what that costs. Seen so that the normal
 * S_u x S_v points to the reader or away from him: first edge below for u to the right.
 *
 * Closed surfaces are cut at their seam. Outlines that overlap themselves in the plane are not
 * looked for.
 *
 * @param surface in space or in the plane, any kind: what is no NURBS is converted within the
 * tolerance
 * @param options NULL for the defaults
 * @param[out] out filled; give it back with batten_unrolled_release
 * @return BATTEN_OK; BAD_ARGUMENT (tolerance); NOT_COMPATIBLE where no lines are straight
 * within the tolerance, with the distance and place; SINGULAR_HERE where a ruling has no length
 * within the surface or the surface no tangent plane, with the u; TOLERANCE_NOT_MET
 *
 * Cost: linear in the number of known rulings, which are doubled until the edges are within the
 * tolerance; the integration is of order 8 in their distance, the edges of order 4. Source:
 * [PW01] 6.
 */
BATTEN_API batten_status batten_surface_unroll(const batten_surface *surface,
                                               const batten_unroll_options *options,
                                               batten_unrolled *out);
BATTEN_API void batten_unrolled_release(batten_unrolled *unrolled);

/** Where a point of the surface is in the plane: a mark.
 * @param u, v of `unrolled->surface`
 * @param[out] out [2]; as exact as the edges */
BATTEN_API batten_status batten_unrolled_at(const batten_unrolled *unrolled, double u, double v,
                                            double *out);

#ifdef __cplusplus
}
#endif
#endif
