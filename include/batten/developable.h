#ifndef BATTEN_DEVELOPABLE_H
#define BATTEN_DEVELOPABLE_H
/**
 * @file
 * Developable surfaces between two curves: plates that bend from flat sheet without stretch.
 *
 * A ruling from a point of the first edge to one of the second belongs to a developable surface
 * where the tangents of both edges and the ruling lie in one plane, which then touches the
 * surface all along it. The angle between the normals at its ends is the warp.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_developable_options {
    size_t size;
    bool keep_matching;   /**< points of equal parameter are joined, exactly; only the warp is
                               looked at. Else rulings are found; false */
    double tolerance;     /**< of the edges, model units, > 0 */
    double warp;          /**< largest of a surface called developable, radians; 0.5 degrees */
    bool keep_regression; /**< an edge of regression between the edges is reported, not refused;
                               false */
} batten_developable_options;
BATTEN_API batten_developable_options batten_developable_defaults(void);

/** One ruling of the surface. */
typedef struct batten_ruling {
    double u;    /**< of the surface */
    double s, t; /**< parameters on the first and on the second edge */
    double warp; /**< angle between the normals at its ends, radians; 0 where one end rests */
} batten_ruling;

typedef struct batten_developable {
    batten_surface *surface; /**< v = 0 on the first edge, 1 on the second; u from 0 to 1 */
    int count;
    batten_ruling *rulings; /**< [count] */
    bool cone[2]; /**< the surface begins, or ends, with a cone about the end of one edge */
    double error; /**< of the edges of the surface, measured midway between the rulings; 0 when
                       they are exact */
    double warp;  /**< the largest, between the rulings too, radians */
    double warp_at;       /**< the u where it is */
    bool is_developable;  /**< the warp is within that of the options, and there is no edge of
                               regression between the edges */
    bool has_regression;  /**< rulings that follow each other meet between the edges */
    double regression_at; /**< the u where they do so first */
    double regression_share; /**< of the ruling there, from the first edge */
} batten_developable;

/**
 * The developable surface between two curves.
 *
 * The pairs of points that rulings join form a path from the start of both edges to their ends.
 * Of all such paths on a lattice of equal steps of length that of the least warp is taken by
 * dynamic programming, and its pairs are then moved to where the warp is 0. Where one edge ends
 * before the other, the rest is a cone about its end. Where there is no developable surface,
 * the one of nearly the least warp comes back, and it is said how large that is. One edge may
 * be a point.
 *
 * Edges are exact where rulings join equal shares of both domains, and in cones; else they are
 * followed within the tolerance, by C2 cubics, or by C1 cubics in warped plates, where rulings
 * without warp exist in places only. Closed edges begin with the ruling between their starts.
 *
 * @param first, second in space or plane, smooth, open or closed; they may meet at their ends
 * only
 * @param options NULL for the defaults
 * @param[out] out filled; give it back with batten_developable_release
 * @return BATTEN_OK; BAD_ARGUMENT (options, two points); NOT_COMPATIBLE for edges with corners,
 * that touch, that run against each other, or with an edge of regression between them: with the
 * parameters; SINGULAR_HERE for an edge without tangent; TOLERANCE_NOT_MET
 *
 * Cost: about 40000 evaluations of the warp, and some for each ruling.
 * Source: [PW01] 6; [Aumann91] for the condition.
 */
BATTEN_API batten_status batten_surface_developable(const batten_curve *first,
                                                    const batten_curve *second,
                                                    const batten_developable_options *options,
                                                    batten_developable *out);
BATTEN_API void batten_developable_release(batten_developable *developable);

/**
 * Do the tangent planes at both ends of a line from first(s) to second(t) agree?
 *
 * @param[out] condition det(first'(s), second'(t), second(t) - first(s)): 0 where they do, or
 * where a tangent runs along the line
 * @param[out] warp the angle between the planes, radians, 0 to pi; NaN where one has no plane.
 * pi, with condition 0, where the surface would turn over
 * @return BATTEN_OK, OUT_OF_DOMAIN
 */
BATTEN_API batten_status batten_ruling_condition(const batten_curve *first, double s,
                                                 const batten_curve *second, double t,
                                                 double *condition, double *warp);

#ifdef __cplusplus
}
#endif
#endif
