#ifndef BATTEN_DIVIDE_H
#define BATTEN_DIVIDE_H
/**
 * @file
 * Where to cut a curve: equal lengths, equal chords, chords that stay near, pieces of one kind.
 */
#include <batten/inspect.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Parameters that cut a curve into parts of equal length, both ends included.
 * @param count parts, 1 or more
 * @param tolerance of the lengths from the start, model units, > 0
 * @param[out] u [count + 1]
 * @return as batten_curve_at_length; BAD_ARGUMENT (count)
 */
BATTEN_API batten_status batten_curve_divide(const batten_curve *curve, int count,
                                             double tolerance, double *u);
/**
 * Parameters that cut a curve such that all chords are equally long, both ends included: what a
 * pair of compasses finds that walks along the curve, each time to the first place that is as
 * far away as it is open.
 * @param count parts, 1 or more; of a closed curve 3 or more
 * @param tolerance of the last chord, which the others leave; model units, > 0
 * @param[out] u [count + 1]
 * @param[out] chord how long they are; may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT; COINCIDENT for a curve that is a point; TOLERANCE_NOT_MET
 * when no opening ends at the end, as may be where the curve turns back beside itself
 * Cost: a few times `count` searches of a span.
 */
BATTEN_API batten_status batten_curve_divide_equal_chords(const batten_curve *curve, int count,
                                                          double tolerance, double *u,
                                                          double *chord);
/**
 * Parameters of a polyline on a curve no farther from it than `height`, both ends and all
 * distinct knots included. Pieces are halved until their control polygons, which enclose them,
 * lie that near to their chords: a bound, not an estimate.
 * @param height model units, > 0
 * @return BATTEN_OK; BAD_ARGUMENT; TOO_LARGE beyond a million parts. Release `out->at`.
 */
BATTEN_API batten_status batten_curve_divide_chord(const batten_curve *curve, double height,
                                                   batten_parameters *out);
/**
 * The same for chords that also turn little: between neighbouring parameters all tangents are
 * within `angle` of each other, by a bound: a tangent lies among the legs of the control
 * polygon, and all legs are within half the angle of their chord. At a cusp, where no part is
 * short enough, halving ends at the rounding of the parameter.
 * @param height model units, > 0; HUGE_VAL: any
 * @param angle  radians, > 0 and at most pi
 * @return as batten_curve_divide_chord
 */
BATTEN_API batten_status batten_curve_divide_turn(const batten_curve *curve, double height,
                                                  double angle, batten_parameters *out);

/** What the pieces of a curve are. */
typedef enum batten_piece_kind {
    BATTEN_PIECES_MONOTONE, /**< each coordinate, or the one along a direction, runs one way */
    BATTEN_PIECES_SPIRAL,   /**< curvature rises or falls and keeps its sign; no corner and no
                                 jump of curvature inside */
    BATTEN_PIECES_CONVEX, /**< in the plane: curvature keeps its sign, the tangent turns by half
                             a turn at most and has no corner: convex with its chord */
    BATTEN_PIECES_SPANS   /**< between knots */
} batten_piece_kind;
/**
 * Parameters that cut a curve into pieces of one kind, both ends included: as few as there can
 * be, but for CONVEX, where half turns are counted from the last cut.
 *
 * Each piece is looked at once more by itself: INCOMPLETE, with the place, when it is not what
 * it should be.
 *
 * @param direction of MONOTONE; NULL: all coordinates
 * @return BATTEN_OK; BAD_ARGUMENT (direction); NOT_COMPATIBLE (CONVEX, not in the plane);
 * UNSUPPORTED (SPIRAL and CONVEX of dimension 1); SINGULAR_HERE (no direction at a knot);
 * INCOMPLETE. Release `out->at`.
 */
BATTEN_API batten_status batten_curve_divide_pieces(const batten_curve *curve,
                                                    batten_piece_kind kind,
                                                    const batten_vec3 *direction,
                                                    batten_parameters *out);

#ifdef __cplusplus
}
#endif
#endif
