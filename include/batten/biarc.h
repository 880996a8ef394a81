#ifndef BATTEN_BIARC_H
#define BATTEN_BIARC_H
/**
 * @file
 * Biarcs: two circular arcs that meet with a common tangent, from one point with its direction
 * to another; and chains of them through points.
 *
 * For each pair of points with directions there is one biarc for every joint on a circle
 * through both points, the joint circle. Of a biarc with the chord l: alpha and beta are the
 * angles from the chord to the directions at the start and at the end, positive to the left, in
 * (-pi, pi]. It is a C when they have different signs, an S when they have the same.
 */
#include <batten/chain.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Where on the joint circle the arcs meet. */
typedef enum batten_biarc_joint {
    BATTEN_JOINT_AUTOMATIC,   /**< EQUAL_CHORD; of a C whose end angles differ more than 1 : 3,
                                   where that would turn both ways, LEAST_RATIO */
    BATTEN_JOINT_EQUAL_CHORD, /**< as far from the start as from the end; of all joints it makes
                                   the jump of curvature least */
    BATTEN_JOINT_EQUAL_LEGS,  /**< from the ends to the corners of the control polygon it is
                                   equally far; where no such joint lies between the ends,
                                   EQUAL_CHORD */
    BATTEN_JOINT_LEAST_RATIO, /**< the radii differ least by their ratio. Of a C: the tangent at
                                   the joint is parallel to the chord, and the joint is the
                                   incentre of the triangle of chord and end tangents. Of an S:
                                   equal radii */
    BATTEN_JOINT_LEAST_CURVATURE, /**< the smaller radius is as large as can be. Of a C that
                                       turns one way only: an arc and a line. Of an S: equal
                                       radii */
    BATTEN_JOINT_GIVEN            /**< at a given place */
} batten_biarc_joint;

typedef struct batten_biarc {
    int count;           /**< arcs: 2, or 1 where one arc or line does it */
    batten_span arcs[2]; /**< of kind ARC, for batten_chain_create */
    double place;        /**< of the joint, 0..1 */
    double joint[2];     /**< with one arc: a point of it */
    double turn[2];      /**< of each arc, radians, to the left */
    double legs[2]; /**< from the start to the first corner of the control polygon, and from
                         the last corner to the end; below 0 of arcs above pi, where the
                         tangents meet behind; infinity at pi */
    bool is_long;   /**< an arc turns by more than pi */
} batten_biarc;

/**
 * A biarc between two points of the plane.
 *
 * @param start, end points
 * @param start_direction, end_direction  not 0; their lengths do not matter
 * @param place with JOINT_GIVEN: the angle at the end between chord and joint as a share of the
 *              sum of the angles at start and end, in (0, 1): 1/2 is EQUAL_CHORD
 * @return BATTEN_OK; NOT_FINITE; BAD_ARGUMENT (a direction is 0; place); COINCIDENT;
 * SINGULAR_HERE when the arcs would be full circles (both directions point back along the
 * chord); OVERFLOW
 *
 * Joints other than GIVEN stay a millionth of the chord away from the ends. The arcs end within
 * a few roundings of the larger of coordinates and radii. Source: [Bolton75], [SL] VI.4.
 */
BATTEN_API batten_status batten_biarc_between(
    const double start[2], const double start_direction[2], const double end[2],
    const double end_direction[2], batten_biarc_joint joint, double place, batten_biarc *out);

/**
 * The place of the joint that belongs to a point near the joint circle, for JOINT_GIVEN: the
 * angles between the chord and the point, seen from both ends, have the same ratio there.
 *
 * @return also NOT_FOUND when the point does not lie between the ends
 */
BATTEN_API batten_status batten_biarc_place(const double start[2], const double end[2],
                                            const double point[2], double *place);

/**
 * A biarc in the plane or in space as a curve, by its legs: the joint divides the line between
 * the corners of the control polygon in the ratio of the legs. In space the arcs lie in
 * different planes.
 *
 * @param dimension 2 or 3
 * @param ratio of the first leg to the second, > 0; 1 for equal legs
 * @param[out] out rational of degree 2, its parameter the arc length at the joint and at the
 *             ends; each arc turns by less than pi
 * @return as batten_biarc_between; SINGULAR_HERE when the directions are equal and point across
 * the chord or back
 */
BATTEN_API batten_status batten_curve_biarc(int dimension, const double *start,
                                            const double *start_direction, const double *end,
                                            const double *end_direction, double ratio,
                                            batten_curve **out);

typedef struct batten_biarcs_options {
    size_t size;
    batten_biarc_joint joint; /**< BATTEN_JOINT_AUTOMATIC */
    double place;             /**< of JOINT_GIVEN; 1/2 */
    const double *directions; /**< [count][dimension], not 0; NULL: those of the circles through
                                   three neighbours, whatever their distances */
    bool closed;              /**< the curve closes smoothly; the first point is not repeated */
} batten_biarcs_options;
BATTEN_API batten_biarcs_options batten_biarcs_defaults(void);

typedef struct batten_biarcs_report {
    int arcs, lines;
    int long_arcs;       /**< those that turn by more than pi */
    double least_radius; /**< infinity when all are lines */
    double largest_jump; /**< of curvature, at joints and points */
    double residual;     /**< largest distance from a point at which the chain is given by the
                              arcs before it */
} batten_biarcs_report;

/**
 * A chain of biarcs through points of the plane: smooth tangents, curvature in steps. Points on
 * a circle give the circle, on a line the line, whatever their distances. Neighbouring spans on
 * the same circle stay apart: batten_chain_merge_arcs joins them.
 *
 * @param points  [count][2], 2 or more, 3 or more when closed; neighbours apart
 * @param options NULL for the defaults
 * @param[out] parameters [count], those of the points: arc length from the start; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_FINITE, COINCIDENT, SINGULAR_HERE, OVERFLOW naming the
 * point or the span; BAD_ARGUMENT
 * Cost: linear in count; two chords are all that a direction looks at.
 * Source: [Bolton75], [MW92], [SL] VI.4.
 */
BATTEN_API batten_status batten_chain_biarcs(int count, const double *points,
                                             const batten_biarcs_options *options,
                                             double *parameters, batten_biarcs_report *report,
                                             batten_chain **out);

/**
 * The same in space, with equal legs: a rational curve of degree 2 with a smooth tangent.
 * `joint` and `place` are not used. A span whose ends have equal directions across its chord is
 * refused with SINGULAR_HERE. @param[out] parameters as above, by arc length
 */
BATTEN_API batten_status batten_curve_biarcs(int dimension, int count, const double *points,
                                             const batten_biarcs_options *options,
                                             double *parameters, batten_curve **out);

/**
 * Join neighbouring arcs that lie on the same circle, and lines in one direction, while no end
 * moves by more than `tolerance`; an arc stays below a full turn.
 *
 * @param chain of arcs alone, not placed; else BAD_ARGUMENT
 * @param tolerance model units, 0 or more; rounding is always allowed
 */
BATTEN_API batten_status batten_chain_merge_arcs(const batten_chain *chain, double tolerance,
                                                 batten_chain **out);

/* ---- arcs one after another ---- */

typedef struct batten_sequential_report {
    double start_angle; /**< direction at the start, radians */
    double jump;        /**< the largest jump of curvature at a point */
    double sensitivity; /**< by how much some curvature changes for each radian by which the
                           start turns, 1 / length. Directions change by as much at every point,
                           by turns to the left and to the right: nothing is ever damped */
    int sensitive_at;   /**< the arc, counted from 0, whose curvature changes so much */
    int long_arcs;      /**< those that turn by more than pi */
} batten_sequential_report;

/**
 * Arcs through points of the plane, one between two, each beginning in the direction in which
 * the one before it ends: the direction at the start determines them all.
 *
 * With the directions theta_i and those of the chords phi_i, theta_{i+1} = 2 phi_i - theta_i.
 * So an error at the start, or of any point, goes on undamped with changing sign to the end:
 * read `sensitivity`, and use an arc spline (BATTEN_FAMILY_ARCS) or biarcs where it is large.
 *
 * @param points      [count][2], 2 or more, neighbours apart
 * @param start_angle radians; NAN: the one that makes the sum of the squared jumps of curvature
 *                    least while no arc turns by more than pi, if there is one. Two points have
 *                    the chord then
 * @param[out] angles     [count] directions at the points, radians; may be NULL
 * @param[out] parameters [count], arc lengths from the start; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_FINITE (points; a start angle that is infinite);
 * COINCIDENT, OVERFLOW naming the points; SINGULAR_HERE naming the arc that would be a full
 * circle, as its direction points back along the chord
 * Cost: 256 sums over the points without a start angle, then one. Source: [SL] VI.6.
 */
BATTEN_API batten_status batten_chain_sequential_arcs(int count, const double *points,
                                                      double start_angle, double *angles,
                                                      double *parameters,
                                                      batten_sequential_report *report,
                                                      batten_chain **out);

#ifdef __cplusplus
}
#endif
#endif
