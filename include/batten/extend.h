#ifndef BATTEN_EXTEND_H
#define BATTEN_EXTEND_H
/**
 * @file
 * Curves and surfaces made longer, places of surfaces moved, parts of curves, loose curves joined.
 */
#include <batten/continuity.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a curve continues beyond its end. */
typedef enum batten_extension {
    BATTEN_EXTEND_LINE,   /**< along its tangent: G1 */
    BATTEN_EXTEND_ARC,    /**< along its circle of curvature, as an exact rational arc: G2 */
    BATTEN_EXTEND_SPIRAL, /**< curvature continues at its rate by arc length, a clothoid in the
                               plane of the circle of curvature: G3, in space G2 where the curve
                               leaves that plane */
    BATTEN_EXTEND_NATURAL /**< the last polynomial or rational piece evaluated beyond its end:
                             no new join at all; far out it may go anywhere */
} batten_extension;

/** How a curve or a surface is made longer. */
typedef struct batten_lengthening {
    batten_extension kind;
    double tolerance; /**< model units */
} batten_lengthening;

typedef struct batten_curve_extend_report {
    batten_continuity join; /**< of the given curve with what was added, in the direction away
                                 from the curve */
    double length;          /**< of what was added */
    double error; /**< how far what was added may be from what it should be: a bound for a
                       SPIRAL, else 0 */
} batten_curve_extend_report;

/**
 * Make a curve longer by an arc length.
 *
 * The result has the parameters of the given curve on the old part, which keeps its shape to
 * rounding (verified at every knot and three times between), and continues with the speed of
 * the end: the new part of its domain is as long as speed asks for. Degrees and rationality are
 * raised where the new part needs it.
 *
 * @param curve  of 2 or 3 dimensions; not periodic
 * @param length  model units, > 0; an ARC may go around once, 2 pi of its radius
 * @param how  tolerance: of a SPIRAL from the clothoid, and of the length of a NATURAL
 *              extension; model units, > 0
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT (length, tolerance, more than once around), NOT_FINITE,
 * UNSUPPORTED (a function; make its graph first), NOT_COMPATIBLE (a periodic curve has no end),
 * SINGULAR_HERE (the end has no speed; NATURAL needs none), BAD_WEIGHT (NATURAL meets a place
 * where the weight vanishes), TOLERANCE_NOT_MET
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_extend(const batten_curve *curve, batten_curve_end end,
                                             batten_lengthening how, double length,
                                             batten_curve_extend_report *report,
                                             batten_curve **out);
/**
 * The same to a parameter outside the domain, which becomes the new end. A LINE, ARC or SPIRAL
 * is as long as the speed of the end times the way of the parameter.
 * @param curve  any curve
 * @param end  which end
 * @param how  the kind, and the tolerance
 * @param u  in the parameter of the curve, beyond the end named; else OUT_OF_DOMAIN
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_WEIGHT, OUT_OF_DOMAIN, BAD_ARGUMENT, UNSUPPORTED,
 * NOT_COMPATIBLE, SINGULAR_HERE, TOLERANCE_NOT_MET, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_extend_to(const batten_curve *curve, batten_curve_end end,
                                                batten_lengthening how, double u,
                                                batten_curve_extend_report *report,
                                                batten_curve **out);
typedef struct batten_surface_extend_report {
    double to;          /**< the parameter at which the longer surface ends */
    double least, most; /**< lengths of what was added, along 33 lines across the edge */
    double turn;        /**< the largest angle, radians, between the tangents of such a line at
                             the old edge and at the new one: a natural extension that turns
                             far goes astray */
    double angle;       /**< the largest jump of the normal over the old edge, radians */
    double curvature;   /**< the largest jump of the normal curvature across it */
    int multiplicity;   /**< of the knot at the old edge; 0: there is none */
    double error;       /**< how far what was added, or the old edge, may be from what it should
                             be: of an ARC, else 0 */
} batten_surface_extend_report;

/**
 * One surface that continues beyond an edge, along all lines across it at once.
 *
 * The parameters continue with the speeds of the edge, so where these differ along the edge so
 * do the lengths; none of 33 lines gets less than `length`. LINE: straight along the tangents
 * across, G1, exact; ARC: along the circles of curvature of the lines across, G2, within the
 * tolerance; NATURAL: the last patches evaluated beyond the edge, no new knot, exact. The old
 * part keeps its shape and parameters. A surface joined with C1 has a knot of multiplicity
 * degree - 1 at the old edge; a rational one whose weights change along the edge as well as
 * across it has a full knot there, and only G1.
 *
 * @param surface  NURBS, in space; not periodic across the edge
 * @param length  model units, > 0; an ARC may go around once
 * @param how  tolerance: of an ARC, model units, > 0; else not used
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT, NOT_FINITE; UNSUPPORTED (SPIRAL, other kinds of surfaces, an
 * ARC at an edge with different weights); NOT_COMPATIBLE (periodic); SINGULAR_HERE (the edge is
 * a point, or stands still across, with the place); BAD_WEIGHT (it cannot continue that far);
 * TOLERANCE_NOT_MET, OVERFLOW
 *
 * Cost: linear in the control points; about 40 evaluations for each of 33 lines and each of
 * some ten trials of the length.
 * Source: [PT97] 5.2 for knots moved, [Farin02].
 */
BATTEN_API batten_status batten_surface_extend(const batten_surface *surface, batten_edge edge,
                                               batten_lengthening how, double length,
                                               batten_surface_extend_report *report,
                                               batten_surface **out);
/**
 * The part from a to b. Where b <= a the curve must be closed, its ends within `tolerance`, and
 * the part goes over the seam; it keeps the parameters of its first half. With a = b it is the
 * whole curve, begun at a.
 * @param curve  any curve
 * @param a, b  parameters in the domain
 * @param tolerance model units, 0 or more; for the ends, which meet halfway
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_curve_subrange; NOT_COMPATIBLE when b <= a and the curve is open;
 * BAD_ARGUMENT (tolerance)
 *
 * Cost: as batten_curve_subrange.
 */
BATTEN_API batten_status batten_curve_trim(const batten_curve *curve, double a, double b,
                                           double tolerance, batten_curve **out);

/**
 * The parts on the side of the plane `normal . x = distance` to which the normal points, in
 * their order along the curve; of a curve in the plane, of a line. What lies in the plane
 * belongs to the part beside it. The parts of a closed curve go over its seam.
 * @param curve  of dimension 2 or 3
 * @param normal of any length but 0; `distance` in its measure
 * @param distance  of the plane from the origin, in lengths of `normal`
 * @param tolerance  model units, 0 or more; for the ends, which meet halfway
 * @param[out] out release with batten_curves_release; no curve when nothing is on that side
 * @return as batten_curve_plane_crossings and batten_curve_trim
 *
 * Cost: that of batten_curve_plane_crossings, then linear in the control points of the parts.
 */
BATTEN_API batten_status batten_curve_trim_plane(const batten_curve *curve, batten_vec3 normal,
                                                 double distance, double tolerance,
                                                 batten_curves *out);

/** A place of a surface, and how far it is to move, in model units. */
typedef struct batten_surface_pull {
    double u, v;
    batten_vec3 by;
} batten_surface_pull;

/**
 * Move places of a surface with the least change: of all control points that bring every place where it is wanted,
 * those with the least sum of squared moves. Knots and weights stay.
 *
 * Beside the seam of a closed direction that is not periodic, and beside a pole, two rows of control points stay, so
 * that the surface does not open or crease there.
 *
 * @param surface  NURBS, of dimension 2 or 3
 * @param count  places, 1 or more
 * @param pulls  [count], u and v in the domain
 * @param kept  rows of control points along each of the four edges that stay: 1 the edges, 2 the tangent planes too
 * @param[out] moved  the longest move of a control point, model units; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; UNSUPPORTED for formulas, TOO_FEW_POINTS, NOT_FINITE, OUT_OF_DOMAIN, BAD_ARGUMENT for a place
 * that kept points hold, SINGULAR_SYSTEM for places that cannot move apart, OUT_OF_MEMORY
 *
 * Cost: the square of the places times the control points, and the cube of the places.
 * Source: [PT97] 11.2.
 */
BATTEN_API batten_status batten_surface_pulled(const batten_surface *surface, int count,
                                               const batten_surface_pull *pulls, int kept,
                                               double *moved, batten_surface **out);

/** What batten_curves_join found. */
typedef struct batten_curves_join_report {
    int closed;   /**< curves that end where they begin */
    int gaps;     /**< joints whose ends did not agree bit for bit */
    int branches; /**< ends with more than one other end within the tolerance */
    double gap;   /**< the largest that was closed, model units */
    double at[3]; /**< where its ends meet now */
} batten_curves_join_report;

/**
 * Loose curves joined where their ends meet, in any order and direction, as drawings have lines
 * and arcs: as many curves as they make.
 *
 * Gaps up to the tolerance are closed, the smallest first, each end once; both ends move to the
 * middle between them, and nothing else moves but the curves' first or last control points, by
 * half a gap at most. A curve, or a chain of them, closes upon itself where its ends are nearer
 * than half its length. Results run as the first of their curves does, and begin where the chain
 * begins, closed ones with that curve. Only where several gaps are equal does the order of the
 * curves decide.
 *
 * @param curves  1 or more, of one dimension
 * @param tolerance  model units, 0 or more
 * @param[out] order  [count], curves as they follow each other, counted from 1, negative where
 *                    one is turned; or NULL
 * @param[out] pieces  [count], of how many of them each result is made; or NULL
 * @param[out] report  may be NULL
 * @param[out] out  the results; release them with batten_curves_release
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS (no curves), NOT_COMPATIBLE (dimensions),
 * BAD_KNOTS, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: n log n for n curves whose ends spread along one of the axes; of ends within the
 * tolerance of each other all pairs.
 */
BATTEN_API batten_status batten_curves_join(const batten_curve_row *curves, double tolerance,
                                            int *order, int *pieces,
                                            batten_curves_join_report *report,
                                            batten_curves *out);

#ifdef __cplusplus
}
#endif
#endif
