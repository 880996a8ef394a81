#ifndef BATTEN_RIBBON_H
#define BATTEN_RIBBON_H
/**
 * @file
 * Ribbons: a boundary curve with the derivatives of a surface across it; and boundary curves
 * put into a loop. What Coons patches, Gregory patches and n-sided fills are made from.
 */
#include <batten/notes.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The four edges of a surface over a rectangle. */
typedef enum batten_edge {
    BATTEN_EDGE_V0, /**< v at its least; runs along u */
    BATTEN_EDGE_U1, /**< u at its greatest; runs along v */
    BATTEN_EDGE_V1,
    BATTEN_EDGE_U0
} batten_edge;

/**
 * A boundary curve C(t) and, as curves over the same domain, the derivatives of the surface
 * across it, towards its inside: the vector that C gains for a unit of the parameter across.
 * Only references: the maker keeps them alive.
 */
typedef struct batten_ribbon {
    const batten_curve *curve;
    const batten_curve *slope;     /**< first derivative across; NULL: none is wanted */
    const batten_curve *curvature; /**< second derivative across, with `slope`; or NULL */
} batten_ribbon;

/**
 * The ribbon of a surface's edge, as its neighbour needs it: slope (and curvature) continue the
 * surface beyond the edge, so that a patch with this ribbon joins it with one tangent plane
 * (and curvature). The curves run in the direction of the edge's parameter, over its domain,
 * and are exact; a rational surface whose derivatives are of too high a degree is met within
 * `tolerance`.
 *
 * @param order  1: slope; 2: and curvature
 * @param[out] curves [order + 1] the curve, slope, curvature; give the references back
 * @param[out] error  how far slope and curvature are from the truth, 0 when exact; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, TOLERANCE_NOT_MET, BAD_DEGREE ...
 */
BATTEN_API batten_status batten_edge_ribbon(const batten_surface *surface, batten_edge edge,
                                            int order, double tolerance, batten_curve **curves,
                                            double *error);

/** One curve's place in a loop. */
typedef struct batten_loop_place {
    int curve;     /**< which of the given ones */
    bool reversed; /**< it runs against the loop */
    double gap;    /**< from its end to the start of the next one */
} batten_loop_place;

/**
 * Put curves given in any order and direction end to end into one closed loop that begins with
 * the first curve, in its direction; each next one is the nearest that is left.
 *
 * A chain whose corners are nearer than `tolerance` is a loop.
 *
 * @param curves [count], 2 or more, open, of one dimension
 * @param[out] places [count]
 * @return BATTEN_OK; NOT_COMPATIBLE naming the corner, both curves and the gap ("corner 2,
 * between curves 4 and 1, is open by 0.12"); COINCIDENT for a curve without length or two that
 * are the same; NOT_FINITE ...
 */
BATTEN_API batten_status batten_curves_loop(int count, const batten_curve *const *curves,
                                            double tolerance, batten_loop_place *places);

#ifdef __cplusplus
}
#endif
#endif
