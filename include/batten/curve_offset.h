#ifndef BATTEN_CURVE_OFFSET_H
#define BATTEN_CURVE_OFFSET_H
/**
 * @file
 * Curves at a distance from a curve.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What goes around the outside of a corner. */
typedef enum batten_offset_corner {
    BATTEN_OFFSET_ROUND, /**< an arc about the corner: the true offset */
    BATTEN_OFFSET_MITRE, /**< both sides go on straight until they meet */
    BATTEN_OFFSET_SQUARE /**< both sides go on straight as far as the tangent of the arc in its
                              middle */
} batten_offset_corner;

typedef enum batten_loops {
    BATTEN_LOOPS_REMOVE, /**< only what is as far from the whole curve as asked stays */
    BATTEN_LOOPS_KEEP /**< the offset of every point, with its cusps and loops, in one piece */
} batten_loops;

typedef struct batten_offset_options {
    size_t size;
    double tolerance; /**< model units, > 0: how far from the true offset; 1e-4 */
    batten_offset_corner corners;
    double mitre_limit; /**< a mitre longer than this times the distance becomes SQUARE; 4 */
    batten_loops loops;
    batten_vec3 normal; /**< of a curve in space: the offset goes across this direction and the
                             tangent; (0, 0, 1) */
    int most_pieces;    /**< of one run between corners; more are TOLERANCE_NOT_MET. 100,000 */
} batten_offset_options;
BATTEN_API batten_offset_options batten_offset_defaults(void);

typedef struct batten_offset_report {
    double error;  /**< 1.2 times the largest distance from the true offset among 7 samples of
                        each piece, at equal parameters; 0 when all is lines and arcs */
    int cusps;     /**< places where curvature times distance is 1 */
    int crossings; /**< of the offset with itself, before loops were removed */
    int removed;   /**< parts that were nearer to the curve than asked */
} batten_offset_report;

/** Some curves, yours to release. */
typedef struct batten_curves {
    int count;
    batten_curve **at;
} batten_curves;
BATTEN_API void batten_curves_release(batten_curves *curves);

/**
 * The offset of a curve: P + distance * normal, where the normal points to the left.
 *
 * Lines and arcs give lines and arcs, exactly; all else pieces of degree 5 that have the point,
 * the first and the second derivative of the true offset at their ends. With REMOVE the offset
 * is cut where it crosses itself and wherever it comes too near to the curve, and what is left
 * is joined: none, one or several curves. Pieces keep the parameters of the curve where nothing
 * was cut. An end of an open curve keeps distance too, as if it had a round cap.
 * Loops that come nearer by less than three tolerances may stay, and parts whose ends lie
 * within the tolerance of each other are joined there.
 *
 * @param curve    of 2 or 3 dimensions; periodic curves give clamped closed ones
 * @param distance model units; negative: to the right
 * @param options  NULL for the defaults
 * @param[out] report may be NULL
 * @return BATTEN_OK, also with no curve when nothing is that far inside; BAD_ARGUMENT,
 * NOT_FINITE, UNSUPPORTED (dimension 1), SINGULAR_HERE (curve along `normal`, or a point),
 * TOLERANCE_NOT_MET, TOO_LARGE
 *
 * Cost: for each piece the distance of a few points, log n as long as few spans are that near;
 * n log n for crossings. Source: [TH84], [EK91].
 */
BATTEN_API batten_status batten_curve_offset(const batten_curve *curve, double distance,
                                             const batten_offset_options *options,
                                             batten_offset_report *report, batten_curves *out);

#ifdef __cplusplus
}
#endif
#endif
