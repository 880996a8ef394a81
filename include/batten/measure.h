#ifndef BATTEN_MEASURE_H
#define BATTEN_MEASURE_H
/**
 * @file
 * Lengths, areas, boxes, moments, and division by length.
 */
#include <batten/chain.h>
#include <batten/hull.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The length of a curve.
 *
 * A tolerance below the rounding of the numbers is met as far as they can, see `error`.
 * @param curve  any curve
 * @param tolerance  model units, above 0
 * @param[out] error  an estimate of the error, model units; may be NULL
 * @param[out] length  model units
 * @return BATTEN_OK, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: Gauss-Legendre on each span, halved until both halves agree with the whole.
 */
BATTEN_API batten_status batten_curve_length(const batten_curve *curve, double tolerance,
                                             double *error, double *length);

/**
 * The length over [a, b], as batten_curve_length.
 *
 * @param curve  any curve
 * @param a, b  inside the domain
 * @param tolerance  model units, above 0
 * @param[out] error  an estimate of the error; may be NULL
 * @param[out] length  model units
 * @return BATTEN_OK, OUT_OF_DOMAIN, BAD_ARGUMENT
 *
 * Cost: Gauss-Legendre on each span, halved until both halves agree with the whole.
 */
BATTEN_API batten_status batten_curve_length_between(const batten_curve *curve, double a,
                                                     double b, double tolerance, double *error,
                                                     double *length);
/**
 * Parameters at which the arc length from the start is s[i] (never decreasing, at most
 * `tolerance` outside the length).
 * @param curve  any curve
 * @param count  how many
 * @param s  [count], never decreasing, model units; at most `tolerance` outside the length
 * @param tolerance  model units, above 0
 * @param[out] u [count]
 * @return BATTEN_OK, NOT_FINITE, NOT_INCREASING, OUT_OF_DOMAIN, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: that of batten_curve_length, then for each parameter a search in the table and a few
 * Newton steps, each an integral over a part of a span.
 */
BATTEN_API batten_status batten_curve_at_length(const batten_curve *curve, int count,
                                                const double *s, double tolerance, double *u);
/**
 * The length of a chain: exact where its spans go by arc length, else to 1e-12 of it. Of a
 * function (dimension 1) the length it rises and falls.
 * @param chain  any chain
 * @param[out] error  a bound, model units; may be NULL
 * @param[out] length  model units
 * @return BATTEN_OK, OVERFLOW
 *
 * Cost: linear in the spans; constant for those that go by arc length, an integral for others.
 */
BATTEN_API batten_status batten_chain_length(const batten_chain *chain, double *error,
                                             double *length);
/**
 * The tight axis-parallel box: of the ends and of all places where a coordinate turns back.
 *
 * @param curve  any curve
 * @param[out] out  model units
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in the spans: for each coordinate the roots of its derivative where the control
 * points leave them open.
 */
BATTEN_API batten_status batten_curve_bounds(const batten_curve *curve, batten_box *out);

/**
 * The tight axis-parallel box of a surface: it holds the surface, and each side is at most
 * `error` from a point of it. Bezier patches are halved where they may reach beyond what is
 * known to be reached (branch and bound); in 2 dimensions z is 0.
 *
 * @param tolerance model units, > 0; also for a formula that only a NURBS surface near it tells
 * @param[out] error above the tolerance where 20,000 halvings for a side do not do, as may be
 * where the surface runs level along a curve; may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT; what batten_surface_to_nurbs returns
 * Cost: the Bezier patches of all spans are made; some tens of halvings for each side.
 */
BATTEN_API batten_status batten_surface_bounds(const batten_surface *surface, double tolerance,
                                               double *error, batten_box *out);

/** A box at any angle; its axes are square to each other, of length one, and right-handed. */
typedef struct batten_oriented_box {
    batten_vec3 centre;
    batten_vec3 axes[3]; /**< the first along its longest side; in the plane the third is z */
    double half[3]; /**< half the lengths of the sides, falling; in the plane half[2] is 0 */
} batten_oriented_box;
/**
 * A small box around a curve of 2 or 3 dimensions. It holds the curve exactly: along its axes
 * it is as tight as batten_curve_bounds. The axes come from the convex hull of a polyline that
 * stays within `tolerance` of the curve.
 *
 * In the plane, by rotating calipers, its area exceeds the least one by 2 tolerance (sides)
 * + 4 tolerance^2 at most. In space one axis is taken from the world and from the principal
 * directions of the polyline, the other two by calipers across it, and each axis of the best
 * box in turn again, while its volume falls: small, but not proved to be the least.
 *
 * @param tolerance model units, > 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT; UNSUPPORTED (dimension 1); TOO_LARGE (a million points)
 * Cost: n log n for n points of the polyline.
 * Source: [Toussaint83].
 */
BATTEN_API batten_status batten_curve_oriented_box(const batten_curve *curve, double tolerance,
                                                   batten_oriented_box *out);

/** What a closed plane curve encloses, with the sign of its direction: an area run clockwise is
 * negative, and what is enclosed twice counts twice. */
typedef struct batten_region {
    double area;
    double centroid[2];
    /** Second moments about the centroid: the integrals of x x, x y and y y. */
    double xx, xy, yy;
    double principal[2]; /**< the larger second moment and the smaller one, by size; the moment
                              about an axis is that across it */
    double angle; /**< of the direction of the larger one, radians from x, (-pi/2, pi/2] */
    double error; /**< of each integral, as a share of the integral of the sizes of its terms */
} batten_region;
/**
 * Area and moments by Green's theorem. Polynomial curves are integrated exactly but for
 * rounding, rational ones by halving until `precision` is met.
 *
 * @param curve  plane and closed
 * @param closing_tolerance    model units: ends that are no farther apart are joined by a line
 * @param precision relative, > 0; `error` says what was reached
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; NOT_COMPATIBLE when the curve is not closed or not plane; BAD_ARGUMENT;
 * COINCIDENT when the area is 0 to rounding, as of a curve run there and back;
 * TOLERANCE_NOT_MET
 *
 * Cost: p evaluations for each span of a polynomial curve; more where a rational one is halved.
 */
BATTEN_API batten_status batten_curve_region(const batten_curve *curve,
                                             double closing_tolerance, double precision,
                                             batten_region *out);

/**
 * How often a closed plane curve runs around a point, counterclockwise counted positive: by
 * crossings of a ray with pieces that run one way.
 * @param curve  plane and closed
 * @param point  model units
 * @param closing_tolerance  as batten_curve_region
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; NOT_COMPATIBLE when the curve is not closed or not plane; BAD_ARGUMENT;
 * SINGULAR_HERE when the point is on the curve, to 1e-12 of its size; OUT_OF_MEMORY
 *
 * Cost: linear in the spans: the roots of the derivative to divide it, one distance of the
 * point, one crossing for each piece.
 */
BATTEN_API batten_status batten_curve_winding(const batten_curve *curve, batten_vec2 point,
                                              double closing_tolerance, int *out);
/**
 * By how many full turns the tangent of a plane curve turns from start to end, corners and,
 * when the ends meet within `closing_tolerance`, that in the closing point included: a whole
 * number for a closed curve, 1 or -1 when it does not cross itself.
 *
 * @param curve  plane
 * @param closing_tolerance  model units, 0 or more
 * @param[out] out  in turns
 * @return BATTEN_OK; SINGULAR_HERE at a cusp, where the tangent turns back and neither
 * direction is the right one; NOT_COMPATIBLE for other dimensions; BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: linear in the spans: the roots of both derivatives on each.
 */
BATTEN_API batten_status batten_curve_turning(const batten_curve *curve,
                                              double closing_tolerance, double *out);

/** What batten_surface_area found. */
typedef struct batten_area_measures {
    double area; /**< model units squared */
    /** The sum of the differences: the error of the shorter rule, much above that of the longer,
     * whose value is returned. */
    double error;
} batten_area_measures;

/**
 * The area of a surface of any kind, of 2 or 3 dimensions: what it covers twice counts twice.
 *
 * Each span is measured with rules of Gauss of 5 and of 8 nodes in both directions, and halved
 * in the direction in which they differ more, always that with the largest difference first.
 *
 * @param precision   relative, > 0; the limit of rounding is some 1e-15
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out    measures: filled in also with TOLERANCE_NOT_MET
 * @return BATTEN_OK; BAD_ARGUMENT (precision), UNSUPPORTED (dimension 1), OVERFLOW, CANCELLED;
 * TOLERANCE_NOT_MET after 8192 halvings, as where a surface folds
 * Cost: 169 points for each span and, twice, for each halving; memory 64 bytes for each.
 */
BATTEN_API batten_status batten_surface_area(const batten_surface *surface, double precision,
                                             const batten_job *job, batten_area_measures *out);
/**
 * Parameters that cut a curve into parts of equal length, both ends included.
 * @param curve  any curve
 * @param count parts, 1 or more
 * @param tolerance of the lengths from the start, model units, > 0
 * @param[out] u [count + 1]
 * @return as batten_curve_at_length; BAD_ARGUMENT (count)
 *
 * Cost: as batten_curve_at_length for count + 1 lengths.
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
                                                          double tolerance, double *chord,
                                                          double *u);
/**
 * Parameters of a polyline on a curve no farther from it than `height`, both ends and all
 * distinct knots included. Pieces are halved until their control polygons, which enclose them,
 * lie that near to their chords: a bound, not an estimate.
 * @param curve  any curve
 * @param height model units, > 0
 * @param[out] out  release `out->at` with batten_release
 * @return BATTEN_OK; BAD_ARGUMENT; TOO_LARGE beyond a million parts; OUT_OF_MEMORY
 *
 * Cost: one halving of p + 1 control points for each part.
 */
BATTEN_API batten_status batten_curve_divide_chord(const batten_curve *curve, double height,
                                                   batten_parameters *out);
/**
 * The same for chords that also turn little: between neighbouring parameters all tangents are
 * within `angle` of each other, by a bound: a tangent lies among the legs of the control
 * polygon, and all legs are within half the angle of their chord. At a cusp, where no part is
 * short enough, halving ends at the rounding of the parameter.
 * @param curve  any curve
 * @param height model units, > 0; HUGE_VAL: any
 * @param angle  radians, > 0 and at most pi
 * @param[out] out  release `out->at` with batten_release
 * @return as batten_curve_divide_chord
 *
 * Cost: as batten_curve_divide_chord.
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
 * Each piece is looked at once more by itself: it is INCOMPLETE, with the place, when it is not
 * what it should be.
 *
 * @param curve  any curve
 * @param kind  of the pieces
 * @param direction of MONOTONE; NULL: all coordinates
 * @param[out] out  release `out->at` with batten_release
 * @return BATTEN_OK; BAD_ARGUMENT (direction); NOT_COMPATIBLE (CONVEX, not in the plane);
 * UNSUPPORTED (SPIRAL and CONVEX of dimension 1); SINGULAR_HERE (no direction at a knot);
 * INCOMPLETE; OUT_OF_MEMORY
 *
 * Cost: linear in the spans: the roots of a polynomial on each, twice for SPIRAL and CONVEX.
 */
BATTEN_API batten_status batten_curve_divide_pieces(const batten_curve *curve,
                                                    batten_piece_kind kind,
                                                    const batten_vec3 *direction,
                                                    batten_parameters *out);

/** How short the spans of a surface are in one direction. */
typedef struct batten_least_span {
    double share; /**< the shortest span over the domain */
    double
        length; /**< the least way across a span, on the longest of nine lines; model units */
    double from, to; /**< the span of that length */
    double total;    /**< the sum of such lengths over all spans */
} batten_least_span;
/**
 * The shortest spans: knots that nearly coincide leave slivers, across which derivatives overflow in other programs.
 *
 * @param surface  any surface
 * @param direction  in which the spans are looked at
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; as batten_surface_evaluate; OUT_OF_MEMORY
 *
 * Cost: 27 points for each span.
 */
BATTEN_API batten_status batten_surface_least_span(const batten_surface *surface,
                                                   batten_direction direction,
                                                   batten_least_span *out);

/** A place where the normal of a surface reverses without an edge: there it folds over. */
typedef struct batten_surface_fold {
    bool found;
    double u, v;       /**< parameters beside the fold */
    batten_vec3 point; /**< and the point there */
} batten_surface_fold;
/**
 * Does a surface fold over? Its normal is looked at in places three to a span and direction, 12
 * at least, and on the rims; where neighbours are more than a right angle apart, closely. So a
 * fold at a corner is seen however narrow it is, and along a rim what is longer than the
 * distance of the places. Edges, as along a sharp trailing edge, are no folds, nor is anything
 * beside corners where both derivatives are parallel to a thousandth of a radian. Before, of
 * polynomial splines all spans are left out whose control points prove that the normal keeps to
 * one side; elsewhere what folds and unfolds between places is not seen.
 *
 * @param surface  of dimension 2 or 3
 * @param[out] out  the first fold found
 * @return BATTEN_OK; NOT_COMPATIBLE (dimension); as batten_surface_evaluate; OUT_OF_MEMORY
 *
 * Cost: where the control points prove it a few operations for each, else nine evaluations to
 * order 1 for each patch.
 */
BATTEN_API batten_status batten_surface_find_fold(const batten_surface *surface,
                                                  batten_surface_fold *out);

/* ---- hulls afloat, beside those of hull.h ---- */

/**
 * How high the edge of the deck stands above the water: the least height of those edges along the ship, in the
 * upper half of the hull, that lids close; on both sides of it. Below 0 it is immersed.
 *
 * @param hull  any hull
 * @param flotation  as batten_hull_hydrostatics
 * @param[out] freeboard  model units, plumb to the water, within 1e-12 of the size of the hull
 * @param[out] at  where it is, in the coordinates of the hull; NULL when it is not wanted
 * @return BATTEN_OK; BAD_ARGUMENT; NOT_FOUND when no edge of a deck is known, as of whole hulls
 *
 * Cost: some ten evaluations of each piece of the edges that may be lowest.
 */
BATTEN_API batten_status batten_hull_freeboard(const batten_hull *hull,
                                               const batten_flotation *flotation,
                                               double *freeboard, batten_vec3 *at);

/**
 * A catamaran of one of its hulls, given about y = 0: that hull half the spacing to port, and its image in
 * y = 0. Its lids are those of the one hull, at its place, with the area of both.
 *
 * @param hull  the one hull
 * @param spacing  between the planes y = 0 of both, model units, above 0
 * @param[out] out  release with batten_hull_free
 * @return BATTEN_OK; BAD_ARGUMENT (spacing, hulls that overlap); OUT_OF_MEMORY
 *
 * Cost: linear in the patches of the hull.
 */
BATTEN_API batten_status batten_hull_twin(const batten_hull *hull, double spacing,
                                          batten_hull **out);

#ifdef __cplusplus
}
#endif
#endif
