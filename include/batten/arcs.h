#ifndef BATTEN_ARCS_H
#define BATTEN_ARCS_H
/**
 * @file
 * Curves of arcs and conics: biarcs, the fewest arcs within a tolerance, chains of conics.
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

/** A point and a direction at it, [2] or [3] coordinates; borrowed for the call. */
typedef struct batten_ray {
    const double *point;
    const double *direction; /**< of any length but 0 */
} batten_ray;

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
 * @param start, end  points
 *     start_direction, end_direction: not 0; their lengths do not matter
 * @param place with JOINT_GIVEN: the angle at the end between chord and joint as a share of the
 *              sum of the angles at start and end, in (0, 1): 1/2 is EQUAL_CHORD
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; NOT_FINITE; BAD_ARGUMENT (a direction is 0; place); COINCIDENT;
 * SINGULAR_HERE when the arcs would be full circles (both directions point back along the
 * chord); OVERFLOW
 *
 * Joints other than GIVEN stay a millionth of the chord away from the ends. The arcs end within
 * a few roundings of the larger of coordinates and radii.
 *
 * Cost: constant; no allocation.
 * Source: [Bolton75], [SL] VI.4.
 */
BATTEN_API batten_status batten_biarc_between(batten_ray start, batten_ray end,
                                              batten_biarc_joint joint, double place,
                                              batten_biarc *out);

/**
 * The place of the joint that belongs to a point near the joint circle, for JOINT_GIVEN: the
 * angles between the chord and the point, seen from both ends, have the same ratio there.
 *
 * @param start  where the biarc starts, model units
 * @param end  where it ends
 * @param point  near the joint circle
 * @param[out] place  in (0, 1), for batten_biarc_between
 * @return BATTEN_OK; NOT_FOUND when the point does not lie between the ends; else as
 * batten_biarc_between
 *
 * Cost: constant; no allocation.
 */
BATTEN_API batten_status batten_biarc_place(batten_vec2 start, batten_vec2 end,
                                            batten_vec2 point, double *place);

/**
 * A biarc in the plane or in space as a curve, by its legs: the joint divides the line between
 * the corners of the control polygon in the ratio of the legs. In space the arcs lie in
 * different planes.
 *
 * @param dimension 2 or 3
 * @param start  where it starts: a point [dimension] and a direction that is not 0
 * @param end  where it ends, likewise
 * @param ratio of the first leg to the second, > 0; 1 for equal legs
 * @param[out] out rational of degree 2, its parameter the arc length at the joint and at the
 *             ends; each arc turns by less than pi
 * @return as batten_biarc_between; BAD_ARGUMENT (dimension, ratio); SINGULAR_HERE when the
 * directions are equal and point across the chord or back; OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_curve_biarc(int dimension, batten_ray start, batten_ray end,
                                            double ratio, batten_curve **out);

typedef struct batten_chain_biarcs_options {
    size_t size;
    batten_biarc_joint joint; /**< BATTEN_JOINT_AUTOMATIC */
    double place;             /**< of JOINT_GIVEN; 1/2 */
    const double *directions; /**< [count][dimension], not 0; NULL: those of the circles through
                                   three neighbours, whatever their distances */
    bool closed;              /**< the curve closes smoothly; the first point is not repeated */
} batten_chain_biarcs_options;
/** The defaults of biarcs: those beside the fields of batten_chain_biarcs_options. */
BATTEN_API batten_chain_biarcs_options batten_chain_biarcs_defaults(void);

typedef struct batten_chain_biarcs_report {
    int arcs, lines;
    int long_arcs;       /**< those that turn by more than pi */
    double least_radius; /**< infinity when all are lines */
    double largest_jump; /**< of curvature, at joints and points */
    double error;        /**< largest distance from a point at which the chain is given by the
                              arcs before it */
} batten_chain_biarcs_report;

/**
 * A chain of biarcs through points of the plane: smooth tangents, curvature in steps. Points on
 * a circle give the circle, on a line the line, whatever their distances. Neighbouring spans on
 * the same circle stay apart: batten_chain_merge_arcs joins them.
 *
 * @param points  [count][2], 2 or more, 3 or more when closed; neighbours apart
 * @param options NULL for the defaults
 * @param[out] parameters [count], those of the points: arc length from the start; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_FINITE, COINCIDENT, SINGULAR_HERE, OVERFLOW naming the
 * point or the span; BAD_ARGUMENT
 * Cost: linear in count; two chords are all that a direction looks at.
 * Source: [Bolton75], [MW92], [SL] VI.4.
 */
BATTEN_API batten_status batten_chain_biarcs(batten_points points,
                                             const batten_chain_biarcs_options *options,
                                             double *parameters,
                                             batten_chain_biarcs_report *report,
                                             batten_chain **out);

/**
 * The same in space, with equal legs: a rational curve of degree 2 with a smooth tangent.
 * `joint` and `place` are not used. A span whose ends have equal directions across its chord is
 * refused with SINGULAR_HERE.
 * @param points  [count][2 or 3], neighbours apart
 * @param options  NULL for the defaults
 * @param[out] parameters  [count], those of the points, by arc length; may be NULL
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT, BAD_ARGUMENT, SINGULAR_HERE,
 * TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in count.
 */
BATTEN_API batten_status batten_curve_biarcs(batten_points points,
                                             const batten_chain_biarcs_options *options,
                                             double *parameters, batten_curve **out);

/**
 * Join neighbouring arcs that lie on the same circle, and lines in one direction, while no end
 * moves by more than `tolerance`; an arc stays below a full turn.
 *
 * @param chain of arcs alone, not placed; else BAD_ARGUMENT
 * @param tolerance model units, 0 or more; rounding is always allowed
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: linear in the spans.
 */
BATTEN_API batten_status batten_chain_merge_arcs(const batten_chain *chain, double tolerance,
                                                 batten_chain **out);

/* ---- arcs one after another ---- */

typedef struct batten_chain_sequential_arcs_report {
    double start_angle; /**< direction at the start, radians */
    double jump;        /**< the largest jump of curvature at a point */
    double sensitivity; /**< by how much some curvature changes for each radian by which the
                           start turns, 1 / length. Directions change by as much at every point,
                           by turns to the left and to the right: nothing is ever damped */
    int sensitive_at;   /**< the arc, counted from 0, whose curvature changes so much */
    int long_arcs;      /**< those that turn by more than pi */
} batten_chain_sequential_arcs_report;

/**
 * Arcs through points of the plane, one between two, each beginning in the direction in which
 * the one before it ends: the direction at the start determines them all.
 *
 * With the directions theta_i and those of the chords phi_i, theta_{i+1} = 2 phi_i - theta_i.
 * So an error at the start, or of any point, continues undamped with changing sign to the end:
 * read `sensitivity`, and use an arc spline (BATTEN_FAMILY_ARCS) or biarcs where it is large.
 *
 * @param points      [count][2], 2 or more, neighbours apart
 * @param start_angle radians; NAN: the one that makes the sum of the squared jumps of curvature
 *                    least while no arc turns by more than pi, if there is one. Two points have
 *                    the chord then
 * @param[out] angles     [count] directions at the points, radians; may be NULL
 * @param[out] parameters [count], arc lengths from the start; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_FINITE (points; a start angle that is infinite);
 * COINCIDENT, OVERFLOW naming the points; SINGULAR_HERE naming the arc that would be a full
 * circle, as its direction points back along the chord
 * Cost: 256 sums over the points without a start angle, then one.
 * Source: [SL] VI.6.
 */
BATTEN_API batten_status batten_chain_sequential_arcs(
    batten_points points, double start_angle, double *angles, double *parameters,
    batten_chain_sequential_arcs_report *report, batten_chain **out);
typedef enum batten_arcs_join {
    BATTEN_ARCS_SMOOTH, /**< the fewest that turn only at corners of the curve; of points
                             BIARCS */
    BATTEN_ARCS_PLAIN,  /**< single arcs with small corners where they meet: lines where the
                             curve is nearly straight */
    BATTEN_ARCS_BIARCS  /**< biarcs, whose ends have the directions of the curve: some 45 per
                             cent more than SMOOTH */
} batten_arcs_join;

/** On which side of the curve, seen along it, the arcs may lie. */
typedef enum batten_arcs_side {
    BATTEN_ARCS_EITHER,
    BATTEN_ARCS_LEFT,
    BATTEN_ARCS_RIGHT,
    BATTEN_ARCS_INSIDE, /**< of a closed curve, as it turns */
    BATTEN_ARCS_OUTSIDE
} batten_arcs_side;

typedef struct batten_arcs_options {
    size_t size;
    double tolerance;        /**< model units, > 0; must be set */
    batten_arcs_join joined; /**< BATTEN_ARCS_SMOOTH */
    batten_arcs_side side;   /**< BATTEN_ARCS_EITHER */
    double least_radius;     /**< of any arc, model units; 0 for none */
    int most;                /**< arcs and lines; 0: as many as it takes */
    double corner; /**< radians: where the direction of the curve jumps by more, it has
                        a corner; 1e-6 */
    bool spread;   /**< with the same number of arcs, make the largest deviation as
                        small as can be, within 2 per cent; true */
    bool closed;   /**< of points: the first is also the last; it is not repeated */
    const batten_job *job; /**< progress and cancelling, asked at each arc that is tried; NULL for
                                no questions */
} batten_arcs_options;
/** The defaults of arc splines: those beside the fields of batten_arcs_options. */
BATTEN_API batten_arcs_options batten_arcs_defaults(void);

typedef struct batten_arcs_report {
    int arcs, lines;
    double error;        /**< the largest distance between curve and arcs: at all places where
                              the distance has an extreme, or of points the largest */
    double left, right;  /**< the largest to either side of the curve, >= 0 */
    double at;           /**< parameter of the curve, or index of the point, of the largest */
    double sampled;      /**< the same by dense sampling alone, 64 and more on each arc */
    double least_radius; /**< infinity when all are lines */
    double largest_turn; /**< of the tangent between neighbours, radians; corners included */
} batten_arcs_report;

/**
 * The fewest arcs for a plane curve.
 *
 * From corner to corner. SMOOTH and PLAIN arcs begin and end on the curve, with one side
 * allowed half the tolerance beside it; along a curve with the curvature k, s the arc length,
 * their number goes to the integral of |dk/ds|^(1/3) ds divided by (72 sqrt 3 tolerance)^(1/3),
 * and smooth arcs cannot be fewer. Where curvature has an extreme, or a closed curve must
 * close, SMOOTH takes about half an arc more than PLAIN. Its arcs bend to no side to which the
 * curve does not, and are not sharper than 1.4 times its sharpest place. PLAIN and BIARCS make
 * each arc, each biarc as long as the tolerance allows, within a thousandth; biarcs have the
 * directions of the curve at their ends, and 2 / (324 tolerance)^(1/3) stands in their number.
 * With one side allowed the tolerance counts by half. What is lines and arcs exactly from
 * corner to corner (see batten_arcs_from_curve_exact) stays as it is, even where fewer arcs
 * would do: a circle is two arcs, a line one line, a polyline with round corners itself.
 * Corners and ends of the curve are kept exactly as points; SMOOTH and PLAIN turn there by a
 * little more or less than the curve. SMOOTH arcs of a closed curve without corners may begin
 * anywhere on it.
 *
 * @param curve   dimension 2
 * @param options with the tolerance
 * @param[out] report  what was reached; may be NULL
 * @param[out] out a chain of arcs and lines, by arc length
 * @return BATTEN_OK; BAD_ARGUMENT (dimension, tolerance, radius, side of a curve that is not
 * closed); TOLERANCE_NOT_MET naming the parameter where no arc of `least_radius` stays within
 * the tolerance, or the number that is needed when that is more than `most`; SINGULAR_HERE for
 * a curve that is a point; OVERFLOW; OUT_OF_MEMORY
 *
 * Cost: PLAIN and BIARCS about 15 trials for each, each of some 30 evaluations; with `spread`
 * and few arcs up to ten times that. SMOOTH 10,000 trial arcs for each, around a closed curve
 * up to 24 times; 10 KB for each arc. Where more than 10,000 are needed from corner to corner
 * it takes biarcs.
 * Source: [MW95], [Bolton75]; [DRS08] for the search from place to place; the leans as its
 * second coordinate and the measure of the error are our own.
 */
BATTEN_API batten_status batten_arcs_from_curve(const batten_curve *curve,
                                                const batten_arcs_options *options,
                                                batten_arcs_report *report, batten_chain **out);

/**
 * The chain of arcs and lines that a curve is already, if it is one: every Bezier piece is a
 * line (of any degree, with any speed that does not turn back) or a rational arc of a circle,
 * within 1e-12 of the size of the curve, or its rounding if that is more.
 *
 * Neighbours that continue along one line, or one circle up to half of it, become one span. A
 * curve in space must lie in a plane x, y or z = constant; its chain is placed there.
 *
 * @param curve any curve
 * @param[out] out  NULL when the curve is not such a chain; else its breaks are knots of the
 *              curve, and middles of spans that turn by more than half a circle. Between two
 *              breaks the chain goes by arc length, as the curve may not
 * @return BATTEN_OK, OUT_OF_MEMORY
 * Cost: 4 p + 1 evaluations for each piece of degree p, or 8 p + 2 when it is not a line.
 * Source: the identity |C - c|^2 = r^2, of degree 2 p, at the places of [EZ64].
 */
BATTEN_API batten_status batten_arcs_from_curve_exact(const batten_curve *curve,
                                                      batten_chain **out);

/**
 * The same for a plane chain that is not placed: it is converted within a hundredth of the
 * tolerance first, and the rest used for the arcs. `at` is a parameter of the chain.
 *
 * @param chain  in the plane, not placed
 * @param options  NULL for the defaults
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, SINGULAR_HERE, TOLERANCE_NOT_MET, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: that of batten_chain_to_curve at a hundredth of the tolerance, then that of
 * batten_arcs_from_curve.
 */
BATTEN_API batten_status batten_arcs_from_chain(const batten_chain *chain,
                                                const batten_arcs_options *options,
                                                batten_arcs_report *report, batten_chain **out);

/**
 * Few arcs that pass all points of a row within a tolerance; ends of arcs are points of the row
 * (or half the tolerance beside them when one side is allowed). Biarcs have the directions of
 * the circles through three neighbours, so rough points are better served with `plain` arcs.
 * The distance is that of the points: between them the arcs go as they like. `spread`, `corner`
 * and `most` are as for curves, but there are no corners.
 *
 * @param points [count][2], 2 or more, 3 or more when closed; neighbours apart
 * @param options  NULL for the defaults
 * @param[out] parameters [count], of the places on the chain nearest to the points; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return also TOO_FEW_POINTS, NOT_FINITE, COINCIDENT, SINGULAR_HERE where the points turn back
 * Cost: about count log(count) distances.
 * Source: [MW92] for biarcs within a band.
 */
BATTEN_API batten_status batten_arcs_from_points(batten_points points,
                                                 const batten_arcs_options *options,
                                                 double *parameters, batten_arcs_report *report,
                                                 batten_chain **out);
/** What stands between two points whose tangents bend to one side, a C. */
typedef enum batten_conics_kind {
    BATTEN_CONICS_PAIRS,     /**< two conics with the curvatures at both points; curvature is
                                  continuous where they meet */
    BATTEN_CONICS_PARABOLAS, /**< two parabolas: with shares of 1/2 a quadratic spline with one
                                  knot in the middle */
    BATTEN_CONICS_SINGLE     /**< one conic */
} batten_conics_kind;

typedef struct batten_curve_conics_options {
    size_t size;
    batten_conics_kind kind;  /**< BATTEN_CONICS_PAIRS */
    bool closed;              /**< the curve closes smoothly; the first point is not repeated */
    const double *tangents;   /**< [count][2] directions, of any length above 0; NULL: of the
                                   circles through three neighbours */
    const double *curvatures; /**< PAIRS: [count], 1 / length, above 0 to the left; NULL: of the
                                   same circles */
    double start_share;       /**< of pairs: the first control point lies at this share of the
                                   way from the start to where the tangents meet, 0..1; 0: the
                                   share with which data of one conic give that conic */
    double end_share;         /**< the same from the end */
    double weight; /**< of SINGLE: below 1 an ellipse, 1 a parabola, above 1 a hyperbola; 0:
                      chord / sum of the legs, which gives the circle where there is one */
} batten_curve_conics_options;
/** The defaults of conic pieces: those beside the fields of batten_curve_conics_options. */
BATTEN_API batten_curve_conics_options batten_curve_conics_defaults(void);

typedef struct batten_curve_conics_report {
    int inflections; /**< spans that bend to both sides, two conics that meet on the chord:
                          a conic has no inflection, so curvature jumps there */
    int arcs;        /**< spans that are biarcs instead: the tangents meet too far away, or
                          one of them lies along the chord */
    int first_arcs;  /**< the first of these, or -1 */
    int fallen_back; /**< PAIRS: spans whose curvatures bend against their tangents, or
                          are far from those of any conic that fits; they keep the tangents
                          alone, as SINGLE */
    int first_fallen_back; /**< the first of these, or -1 */
    double jump;           /**< the largest jump of curvature at a point */
    double least_weight, largest_weight;
} batten_curve_conics_report;

/**
 * Conics through points of the plane with tangents, and for PAIRS curvatures.
 *
 * In a C the tangents of P0 and P3 meet in T. A lies at the start share from P0 to T, B at the
 * end share from P3 to T; the pair is (P0, A, J), (J, B, P3) with J between A and B. With the
 * curvatures k0 and k3, a = |A - P0|, b = |P3 - B|, the curvature at J is (k0^(1/3) a +
 * k3^(1/3) b)^3 / |A - B|^3 from both sides. The curve stays in the triangle P0 T P3 and has no
 * inflection.
 *
 * @param points  [count][2], 2 or more, closed 3; neighbours apart
 * @param options NULL for the defaults
 * @param[out] parameters [count], closed [count + 1]; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @param[out] out rational of degree 2, tangents continuous, speed not
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_FINITE, COINCIDENT naming the points; BAD_ARGUMENT (a
 * tangent of no length, shares outside [0, 1), a weight below 0); SINGULAR_HERE for tangents
 * that both point back along the chord; OVERFLOW
 *
 * Two points without tangents give their chord. Cost: linear in count.
 * Source: [SL] VI.5, [PT97] 9.3.3 for single conics; the shares from the data are our own.
 */
BATTEN_API batten_status batten_curve_conics(batten_points points,
                                             const batten_curve_conics_options *options,
                                             double *parameters,
                                             batten_curve_conics_report *report,
                                             batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
