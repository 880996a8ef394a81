#ifndef BATTEN_SPIRO_H
#define BATTEN_SPIRO_H
/**
 * @file
 * Plane splines after Levien's Spiro: curvature is a cubic polynomial of arc length between the
 * points, and at the points as smooth as each of them asks for.
 */
#include <batten/chain.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a point asks of the curve; of the ends of an open curve the kind does not count. */
typedef enum batten_spiro_kind {
    BATTEN_SPIRO_SMOOTH, /**< direction, curvature and its first two derivatives by arc length
                              continue: G4 */
    BATTEN_SPIRO_CURVATURE, /**< direction and curvature continue, G2; the second derivative of
                                 curvature is 0 at both sides, so that an Euler spiral stands
                                 between two of these */
    BATTEN_SPIRO_CORNER,    /**< both sides end freely */
    BATTEN_SPIRO_LEFT,      /**< one way: what comes before ends freely, what follows takes its
                                 direction and curvature */
    BATTEN_SPIRO_RIGHT /**< one way: what follows begins freely, what comes before takes its
                            direction and curvature */
} batten_spiro_kind;

/** What is given at one end; without a direction the second derivative of curvature is 0
 * there, without a curvature the first: these are the natural ends of least variation. */
typedef struct batten_spiro_end {
    bool has_tangent, has_curvature;
    double tangent;   /**< direction, radians */
    double curvature; /**< one by the unit of length, above 0 to the left */
} batten_spiro_end;

typedef struct batten_spiro_options {
    size_t size;
    const batten_spiro_kind *kinds; /**< [count]; NULL: all SMOOTH */
    batten_spiro_end start, end;    /**< free; of closed curves they do not count */
    bool closed;                    /**< the first point is not repeated */
    int max_steps;                  /**< of Newton; 200 */
} batten_spiro_options;
BATTEN_API batten_spiro_options batten_spiro_defaults(void);

typedef struct batten_spiro_report {
    int steps;        /**< of Newton */
    double residual;  /**< the largest jump at a point of what shall continue: radians, or
                           derivatives of the direction times powers of the chords about it */
    double curvature; /**< the largest at a point */
    double bending;   /**< the integral of the square of curvature */
    double variation; /**< the integral of the square of its derivative by arc length */
    int straight;     /**< spans between two free ends: lines */
    double turn;      /**< the largest that the polygon makes at a point, radians */
    int turn_at;      /**< there */
} batten_spiro_report;

/**
 * The spline through points of the plane whose spans have curvature cubic in arc length.
 *
 * It is the least-variation curve as long as angles are small, and near it always. Points of a
 * circle give the circle, and a point of the curve added as a smooth point changes nothing. A
 * span between two free ends (of an open curve, at corners, on the leading side of one-way
 * points) is a straight line: so a line is joined to a curve by a one-way point between them,
 * LEFT where the line comes before, and the curve then begins along it with curvature 0.
 *
 * @param points  [count][2], 2 or more, 3 or more when closed; neighbours apart
 * @param options NULL for the defaults
 * @param[out] parameters [count] arc lengths of the points; may be NULL
 * @param[out] report     may be NULL
 * @return BATTEN_OK; NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, OVERFLOW, BAD_ARGUMENT (a kind);
 * SINGULAR_HERE naming a point, not a corner, at which the polygon turns back on itself;
 * TOLERANCE_NOT_MET naming the span that cannot be bent so, and what would work instead;
 * INCOMPLETE when max_steps did not do
 *
 * Cost: linear in count for each step, about 2 microseconds a point; mostly 7 to 15 steps.
 * Source: the equations of [Levien09], ch. 8; solved by Newton's method from Euler spirals.
 */
BATTEN_API batten_status batten_chain_spiro(int count, const double *points,
                                            const batten_spiro_options *options,
                                            double *parameters, batten_spiro_report *report,
                                            batten_chain **out);

#ifdef __cplusplus
}
#endif
#endif
