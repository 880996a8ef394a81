#ifndef BATTEN_SURFACE_MATCH_H
#define BATTEN_SURFACE_MATCH_H
/**
 * @file
 * Making one surface join another smoothly along an edge, by moving its control points there.
 */
#include <batten/ribbon.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a match did, and how well the surfaces then join. */
typedef struct batten_surface_match_report {
    double moved;     /**< the longest way of a control point, after refinement */
    double gap;       /**< largest distance of the edges at equal places along them */
    double angle;     /**< largest angle between the tangent planes along the edge, radians */
    double curvature; /**< largest difference of a principal curvature, 1 / length; NaN where
                         one of the surfaces has no curvature on the edge */
    bool reversed;    /**< the edges run against each other */
} batten_surface_match_report;

/** The edges of two surfaces whose ends are nearest to each other, and the larger distance of
 * an end from its partner; of equal ones the first. */
BATTEN_API batten_status batten_surfaces_near_edges(const batten_surface *first,
                                                    const batten_surface *second,
                                                    batten_edge *first_edge,
                                                    batten_edge *second_edge, double *apart);

/**
 * Move the rows of control points of `first` next to an edge, so that the edge becomes the edge
 * of `second` and the surfaces join there.
 *
 * Row 0 becomes the other's edge. With order 1 row 1 is laid so that the derivative across is
 * the other's, times one factor that keeps the mean length it had: one tangent plane, and C1 up
 * to that factor, as Bezier patches are joined. With order 2 row 2 follows in the same way:
 * curvature goes on. The rows behind stay. Along the edge the surface takes over the knots and
 * the degree of the other; it is refined exactly before.
 *
 * @param order      0 (edge), 1 (tangent plane), 2 (curvature)
 * @param tolerance  within which the edge and the derivatives of a rational `second` are met,
 * those of another exactly
 * @param[out] report may be NULL
 * @return BATTEN_OK; UNSUPPORTED when `first` is rational or no NURBS; BAD_DEGREE when its
 * degree across is below `order`; TOO_FEW_POINTS when the moved rows would reach the opposite
 * edge; NOT_COMPATIBLE when an edge is a point, or a surface has no slope across its edge;
 * TOLERANCE_NOT_MET when the edges, measured, are farther apart than that
 * Source: [Farin02] ch. 15 and 16.
 */
BATTEN_API batten_status batten_surface_match(
    const batten_surface *first, batten_edge first_edge, const batten_surface *second,
    batten_edge second_edge, int order, double tolerance, batten_surface_match_report *report,
    batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
