#ifndef BATTEN_SURFACE_BLEND_H
#define BATTEN_SURFACE_BLEND_H
/**
 * @file
 * Surfaces between the edges of two surfaces.
 */
#include <batten/ribbon.h>

#ifdef __cplusplus
extern "C" {
#endif

/** One side of a blend. */
typedef struct batten_surface_blend_end {
    size_t size;
    batten_edge edge;
    double from,
        to;         /**< the part of the edge, as shares 0 <= from < to <= 1 of its parameter */
    int continuity; /**< 0: the edge; 1: and tangent planes; 2: and curvatures */
    double bulge;   /**< tension: how far it goes on along the surface before it turns, > 0; 1
                         is as far as the edges are apart */
} batten_surface_blend_end;
/** The whole edge, G2, bulge 1. */
BATTEN_API batten_surface_blend_end batten_surface_blend_defaults(batten_edge edge);

typedef struct batten_surface_blend_report {
    double error;        /**< how far the blend may be from the true one, 0 when exact */
    double gap[2];       /**< largest distance from either edge, */
    double angle[2];     /**< angle of the normals there, radians, */
    double curvature[2]; /**< and difference of the normal curvatures across; infinite where a
                              normal is missing */
    bool reversed;       /**< the second edge runs the other way */
    bool folded;         /**< neighbouring normals of a 33 x 33 grid are more than a right angle
                              apart */
    double fold[2];      /**< where */
} batten_surface_blend_report;

/**
 * The surface that goes from an edge of one surface to an edge of another, and goes over into
 * both: u runs along the edges, v from the first to the second, both over [0, 1]. Along v it is
 * the polynomial of least degree with the wanted derivatives at its ends, 1 to 5,
 *   S(u, v) = sum F_i(v) C_i(u) + G_i(v) b_i C_i'(u) + H_i(v) b_i^2 C_i''(u)
 * with ribbons C (batten_edge_ribbon); b brings their speeds to the mean distance of the edges,
 * times the bulge, and is constant along an edge, so that contact is exact.
 *
 * The second edge is taken in that direction in which the two are nearer. Polynomial ribbons,
 * and rational ones with the same weights on both sides, give a NURBS surface that is exact;
 * others one within the tolerance. Contact is measured and reported, and folds are looked for.
 *
 * @param surfaces  two, in space; they may be the same
 * @param tolerance model units, >= 0; of rational ribbons, > 0 where weights differ
 * @param[out] report may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT, NOT_FINITE, NOT_COMPATIBLE (dimensions); COINCIDENT (the
 * edges are the same, or both points); SINGULAR_HERE (a surface stands still across its edge);
 * TOLERANCE_NOT_MET, BAD_DEGREE, OVERFLOW
 *
 * Cost: linear in the control points. Source: [Filip89].
 */
BATTEN_API batten_status batten_surfaces_blend(const batten_surface *const surfaces[2],
                                               const batten_surface_blend_end ends[2],
                                               double tolerance,
                                               batten_surface_blend_report *report,
                                               batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
