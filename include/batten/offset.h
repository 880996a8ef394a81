#ifndef BATTEN_OFFSET_H
#define BATTEN_OFFSET_H
/**
 * @file
 * Parallel curves and surfaces.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What goes around the outside of a corner. */
typedef enum batten_offset_corner {
    BATTEN_OFFSET_ROUND, /**< an arc about the corner: the true offset */
    BATTEN_OFFSET_MITRE, /**< both sides continue straight until they meet */
    BATTEN_OFFSET_SQUARE /**< both sides continue straight as far as the tangent of the arc in its
                              middle */
} batten_offset_corner;

typedef enum batten_loops {
    BATTEN_LOOPS_REMOVE, /**< only what is as far from the whole curve as asked stays */
    BATTEN_LOOPS_KEEP /**< the offset of every point, with its cusps and loops, in one piece */
} batten_loops;

typedef struct batten_curve_offset_options {
    size_t size;
    double tolerance; /**< model units, > 0: how far from the true offset; 1e-4 */
    batten_offset_corner corners;
    double mitre_limit; /**< a mitre longer than this times the distance becomes SQUARE; 4 */
    batten_loops loops;
    batten_vec3 normal; /**< of a curve in space: the offset goes across this direction and the
                             tangent; (0, 0, 1) */
    int most_pieces;    /**< of one run between corners; more are TOLERANCE_NOT_MET. 100,000 */
} batten_curve_offset_options;
/** The defaults of parallel curves: those beside the fields of batten_curve_offset_options. */
BATTEN_API batten_curve_offset_options batten_curve_offset_defaults(void);

typedef struct batten_curve_offset_report {
    double error;  /**< the largest distance from the true offset at equal parameters: 1.1374
                        times that of 7 samples of each piece, a bound once the error of the
                        pieces varies linearly; 0 when all is lines and arcs */
    int cusps;     /**< places where curvature times distance is 1 */
    int crossings; /**< of the offset with itself, before loops were removed */
    int removed;   /**< parts that were nearer to the curve than asked */
} batten_curve_offset_report;

/**
 * The offset of a curve: P + distance * normal, where the normal points to the left.
 *
 * Lines and arcs give lines and arcs, exactly; all else pieces of degree 5 that have the point,
 * the first and the second derivative of the true offset at their ends. With REMOVE the offset
 * is cut where it crosses itself and wherever it comes too near to the curve, and what is left
 * is joined: none, one or several curves. Pieces keep the parameters of the curve where nothing
 * was cut. An end of an open curve keeps distance too, as if it had a round cap. Loops that
 * come nearer by less than three tolerances may stay, and parts whose ends lie within the
 * tolerance of each other are joined there.
 *
 * @param curve    of 2 or 3 dimensions; periodic curves give clamped closed ones
 * @param distance model units; negative: to the right
 * @param options  NULL for the defaults
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK, also with no curve when nothing is that far inside; BAD_ARGUMENT,
 * NOT_FINITE, UNSUPPORTED (dimension 1), SINGULAR_HERE (curve along `normal`, or a point),
 * TOLERANCE_NOT_MET, TOO_LARGE
 *
 * Cost: for each piece the distance of a few points, log n as long as few spans are that near;
 * n log n for crossings.
 * Source: [TH84], [EK91].
 */
BATTEN_API batten_status batten_curve_offset(const batten_curve *curve, double distance,
                                             const batten_curve_offset_options *options,
                                             batten_curve_offset_report *report,
                                             batten_curves *out);
typedef struct batten_surface_offset_options {
    size_t size;
    double tolerance; /**< model units: how far from the true offset; 0: the true one, of the
                           kind "offset", where it is not a NURBS surface. 1e-4 */
    bool keep;        /**< make it also where it turns over; else that is refused. false */
    int most_points;  /**< of the surface near it; more are TOLERANCE_NOT_MET. 4,000,000 */
} batten_surface_offset_options;
/** The defaults of parallel surfaces: those beside the fields of
 * batten_surface_offset_options. */
BATTEN_API batten_surface_offset_options batten_surface_offset_defaults(void);

typedef struct batten_surface_offset_report {
    bool exact;         /**< a NURBS surface of the knots and weights of the given one */
    double error;       /**< the largest measured distance from the true offset at equal
                             parameters, 0 when exact or of the kind "offset" */
    double least, most; /**< principal curvatures of the given surface, as far as they were
                             found: most >= least, positive where it bends to its normal */
    double factor;      /**< the least 1 - distance * curvature: not above 0 where the offset
                             has a ridge or lies the other way round */
    double at[2];       /**< the parameters of that place */
    batten_interval turned[2]; /**< the box of u and v that holds all places found where the
                               factor is 0 or less; empty, a > b, when there are none */
} batten_surface_offset_report;

/**
 * S + distance * n, with the unit normal n of Su x Sv; at the same parameters.
 *
 * The offset of a plane, sphere, cylinder, cone, torus, pipe or surface turned from lines and
 * arcs is a surface with the same knots and weights; that is tried with each surface, and
 * verified at 9 places of each patch to 1e-12 of its size. All others are met within the
 * tolerance. Derivatives of the offset come from one order more of the surface's, at poles
 * (edges that are points) two, and are exact; very near a pole they lose digits to rounding. A
 * pole whose normals agree stays a pole; the apex of a cone becomes a circle.
 *
 * Where 1 - distance * curvature vanishes the offset has a ridge. Principal curvatures are
 * sampled, at degree + 1 places or more of each span both ways, and the extreme ones refined by
 * a search around them; what lies between samples and not near an extreme of them is not seen.
 * Whether far parts of the offset cross each other is not asked.
 *
 * @param surface  NURBS, in space; knots where normals jump by more than 1e-6 are refused
 * @param distance model units; negative: against the normal
 * @param options  NULL for the defaults
 * @param[out] report  what was reached; may be NULL; filled in also after SINGULAR_HERE for a
 *              turned offset
 * @return BATTEN_OK; BAD_ARGUMENT, NOT_FINITE; UNSUPPORTED (other kinds: make them NURBS first,
 * with the error that this has); NOT_COMPATIBLE (a crease, with its place and angle);
 * SINGULAR_HERE (no normal, with the place; or an offset that turns over, with place, radius
 * and the box of parameters); TOLERANCE_NOT_MET, TOO_LARGE, OVERFLOW
 *
 * Cost: about 30 evaluations for each patch of degree 3; those of batten_surface_to_nurbs.
 * Source: [PM02] ch. 11.
 */
BATTEN_API batten_status batten_surface_offset(const batten_surface *surface, double distance,
                                               const batten_surface_offset_options *options,
                                               batten_surface_offset_report *report,
                                               batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
