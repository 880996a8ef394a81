#ifndef BATTEN_BLEND_H
#define BATTEN_BLEND_H
/**
 * @file
 * Blends and fillets: curves and surfaces put between others.
 *
 * A corner lies between the end of one curve and the start of the next, or inside a curve where
 * its direction jumps by more than 0.01 degrees.
 */
#include <batten/continuity.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a blend begins or ends. */
typedef struct batten_blend_end {
    batten_curve_end end; /**< of the curve that it joins */
    int continuity;       /**< G0 to G3 */
    double bulge; /**< > 0: the speed there, as a part of the standard one; 1. More continues
                       farther along the curve before it turns */
} batten_blend_end;

typedef struct batten_curves_blend_report {
    batten_continuity joins[2]; /**< with the first curve, with the second, as one runs from the
                                     one through the blend into the other */
    double speed[2];            /**< |C'| at both ends, over the domain [0, 1] */
} batten_curves_blend_report;

/**
 * The ends of two curves that are nearest to each other; of several pairs the first of end and
 * start, end and end, start and start, start and end.
 *
 * @param first  any curve
 * @param second  of the same dimension
 * @param[out] ends  the end of the first, the end of the second
 * @return BATTEN_OK; NOT_COMPATIBLE when their dimensions differ
 *
 * Cost: four evaluations.
 */
BATTEN_API batten_status batten_curves_nearest_ends(const batten_curve *first,
                                                    const batten_curve *second,
                                                    batten_curve_end ends[2]);

/**
 * A Bezier curve from an end of the first curve to an end of the second, of the least degree
 * that takes over point, tangent, curvature and its rate as far as asked: G0 and G0 a line, G3
 * and G3 degree 7; domain [0, 1].
 *
 * Its derivatives are those of a curve run through at the constant speed v: v T, v^2 dT/ds, v^3
 * d2T/ds2. The standard v is, for G1, that of the cubic nearest to an arc; for more, that of
 * the cubic whose speed is the same at both ends and in the middle; where the curve joined
 * bends so sharply that v would turn by more than 4 radians it is less. The joins are measured
 * afterwards.
 *
 * @param first, second of the same dimension, 2 or 3
 * @param first_end  which end of the first, with continuity (0..3) and bulge
 * @param second_end  likewise, of the second
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT (continuity, bulge), UNSUPPORTED (functions), NOT_COMPATIBLE,
 * COINCIDENT (the ends are one point), SINGULAR_HERE (an end without speed, where more than G0
 * is asked), TOLERANCE_NOT_MET when a join, measured, is not as asked
 *
 * Cost: constant: two evaluations to order 3, and some to measure the joins.
 * Source: [BD89] for the continuity.
 */
BATTEN_API batten_status batten_curves_blend(
    const batten_curve *first, const batten_blend_end *first_end, const batten_curve *second,
    const batten_blend_end *second_end, batten_curves_blend_report *report, batten_curve **out);
/** One side of a blend. */
typedef struct batten_surface_blend_end {
    size_t size;
    batten_edge edge;
    double from,
        to;         /**< the part of the edge, as shares 0 <= from < to <= 1 of its parameter */
    int continuity; /**< 0: the edge; 1: and tangent planes; 2: and curvatures */
    double bulge;   /**< tension: how far it continues along the surface before it turns, > 0; 1
                         is as far as the edges are apart */
} batten_surface_blend_end;
/** The whole edge, G2, bulge 1. */
BATTEN_API batten_surface_blend_end batten_surfaces_blend_defaults(batten_edge edge);

typedef struct batten_surfaces_blend_report {
    double error;        /**< how far the blend may be from the true one, 0 when exact */
    double gap[2];       /**< largest distance from either edge, */
    double angle[2];     /**< angle of the normals there, radians, */
    double curvature[2]; /**< and difference of the normal curvatures across; infinite where a
                              normal is missing */
    bool reversed;       /**< the second edge runs the other way */
    bool folded;         /**< neighbouring normals of a 33 x 33 grid are more than a right angle
                              apart */
    double fold[2];      /**< where */
} batten_surfaces_blend_report;

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
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT, NOT_FINITE, NOT_COMPATIBLE (dimensions); COINCIDENT (the
 * edges are the same, or both points); SINGULAR_HERE (a surface stands still across its edge);
 * TOLERANCE_NOT_MET, BAD_DEGREE, OVERFLOW
 *
 * Cost: linear in the control points.
 * Source: [Filip89].
 */
BATTEN_API batten_status batten_surfaces_blend(const batten_surface *const surfaces[2],
                                               const batten_surface_blend_end ends[2],
                                               double tolerance,
                                               batten_surfaces_blend_report *report,
                                               batten_surface **out);
/** An arc between two curves. */
typedef struct batten_curves_fillet_report {
    double u[2];        /**< where the first curve is left, and the second one reached */
    batten_vec3 center; /**< of the arc */
    double angle;       /**< by which it turns, radians, above 0 and up to pi */
    double gap;         /**< of the end of the arc from the second curve */
    int found;          /**< arcs of this radius that were found */
    bool complete; /**< these are all: so it is for straight curves. Of others arcs may have
                        been overlooked that hardly touch, and so may a nearer one */
} batten_curves_fillet_report;

/**
 * The arc of a radius that leaves the first curve and goes over into the second, both run
 * forwards, with common tangents; of several the one for which the least length goes from the
 * end of the first and the start of the second. The curves may cross beyond the corner.
 *
 * The arc is an exact rational curve. Its ends follow from the crossings of the offsets of both
 * curves, refined by Newton's method until centre and radius hold to rounding; the joins are
 * measured afterwards.
 *
 * @param first, second of 2 dimensions, or in space in one plane, to `tolerance`
 * @param radius    model units, > 0
 * @param tolerance for the plane, and for the gap where the curves are not quite in it; > 0
 * @param[out] report  what was reached; may be NULL
 * @param[out] arc from first(u[0]) to second(u[1]); its domain begins at u[0]
 * @return BATTEN_OK; BAD_ARGUMENT, UNSUPPORTED (functions); NOT_COMPATIBLE (dimensions, no
 * common plane, straight curves that run along each other); NOT_FOUND when no such arc was
 * found: the radius is too large, or the curves do not come near enough; TOLERANCE_NOT_MET when
 * a join, measured, is not smooth
 * Cost: that of the offsets.
 */
BATTEN_API batten_status batten_curves_fillet(const batten_curve *first,
                                              const batten_curve *second, double radius,
                                              double tolerance,
                                              batten_curves_fillet_report *report,
                                              batten_curve **arc);

/** What became of the corners of a curve. */
typedef struct batten_corners_report {
    int corners; /**< that the curve has, the seam of a closed one among them */
    int cut;     /**< of these */
    double gap;  /**< the largest of batten_curves_fillet_report */
    bool complete;
} batten_corners_report;

/**
 * Round all corners of a curve. What lies between keeps its shape; parameters continue from the
 * start with the speed of the curve. A closed curve that has corners, but none at its seam,
 * begins at its first corner.
 *
 * @param curve  of 2 or 3 dimensions
 * @param radius_count 1, or the number of corners
 * @param radii [radius_count], model units; 0 leaves a corner as it is
 * @param tolerance  model units, above 0, as in batten_curves_fillet
 * @param[out] report  what was reached; may be NULL
 * @return as batten_curves_fillet; BAD_ARGUMENT (radius_count, a radius); NOT_FOUND also when
 * two arcs want the same part of the curve: the message names the corners, counted from 1
 *
 * Cost: linear in the control points; at each corner that of batten_curves_fillet.
 */
BATTEN_API batten_status batten_curve_fillet(const batten_curve *curve, int radius_count,
                                             const double *radii, double tolerance,
                                             batten_corners_report *report, batten_curve **out);

/**
 * Cut off the corner between two curves by a line.
 * @param first, second  of one dimension; the end of the first meets the start of the second
 * @param lengths  before, after the corner: lengths along the curves that are cut off, model
 *              units, above 0
 * @param tolerance  for the gap between the curves, and for the lengths; > 0
 * @param[out] u  as in batten_curves_fillet_report; may be NULL
 * @param[out] line  from first(u[0]) to second(u[1])
 * @return BATTEN_OK; BAD_ARGUMENT; UNSUPPORTED; NOT_COMPATIBLE when the curves do not meet;
 * NOT_FOUND when one is too short; COINCIDENT when the line would be a point
 *
 * Cost: two searches for a length along a curve, each as batten_curve_at_length.
 */
BATTEN_API batten_status batten_curves_chamfer(const batten_curve *first,
                                               const batten_curve *second,
                                               const double lengths[2], double tolerance,
                                               double u[2], batten_curve **line);
/**
 * Cut off all corners of a curve of 2 or 3 dimensions; as batten_curve_fillet.
 *
 * @param curve  of 2 or 3 dimensions
 * @param lengths  before and after each corner, model units, above 0
 * @param tolerance  model units, above 0
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, UNSUPPORTED, NOT_COMPATIBLE, NOT_FOUND,
 * OUT_OF_MEMORY
 *
 * Cost: linear in the control points; at each corner that of batten_curves_chamfer.
 */
BATTEN_API batten_status batten_curve_chamfer(const batten_curve *curve,
                                              const double lengths[2], double tolerance,
                                              batten_corners_report *report,
                                              batten_curve **out);
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
/** Release what a fillet of surfaces holds, and empty it. */
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
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT, NOT_FINITE, UNSUPPORTED; NOT_FOUND, with the distance of the
 * offsets; SINGULAR_HERE when the ball does not fit into a hollow, with place and radius;
 * TOLERANCE_NOT_MET
 *
 * Cost: some thousand evaluations to find the start, then a few steps of Newton's method for
 * each station; stations are doubled until the spline is within the tolerance. Linear in the
 * stations.
 * Source: [PM02] ch. 11; [PT97] 7.3 for the arcs.
 */
BATTEN_API batten_status batten_surfaces_fillet(const batten_surface *const surfaces[2],
                                                const double radii[2], const double *start,
                                                double tolerance, batten_surface_fillet *out);

#ifdef __cplusplus
}
#endif
#endif
