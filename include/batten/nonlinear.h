#ifndef BATTEN_NONLINEAR_H
#define BATTEN_NONLINEAR_H
/**
 * @file
 * Nonlinear plane splines through points: curvature is continuous, and each span is a curve of
 * a family that depends on nothing but its end tangents. So the result does not depend on how
 * the points are turned, moved or scaled.
 */
#include <batten/chain.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_span_family {
    BATTEN_FAMILY_LOCAL_CUBIC,   /**< a cubic function over each chord */
    BATTEN_FAMILY_LOCAL_TENSION, /**< a function in tension over each chord */
    BATTEN_FAMILY_GEOMETRIC,     /**< curvature linear in the abscissa along the chord */
    BATTEN_FAMILY_EULER_SPIRAL,  /**< curvature linear in arc length: clothoids */
    BATTEN_FAMILY_ARCS,          /**< one circular arc at each point */
    BATTEN_FAMILY_ELASTICA,      /**< the thin beam held at the points: the mechanical spline */
    BATTEN_FAMILY_HOBBY          /**< mock curvature and Hobby's velocities: cubics */
} batten_span_family;

/** What holds at one end. */
typedef enum batten_nonlinear_end {
    BATTEN_NONLINEAR_NATURAL,  /**< curvature 0 */
    BATTEN_NONLINEAR_CIRCULAR, /**< the same curvature at both ends of the end span */
    BATTEN_NONLINEAR_TANGENT,  /**< direction given, radians */
    BATTEN_NONLINEAR_CURVATURE /**< curvature given, one by the unit of length */
} batten_nonlinear_end;

typedef struct batten_nonlinear_options {
    size_t size;
    batten_span_family family;       /**< BATTEN_FAMILY_EULER_SPIRAL */
    batten_nonlinear_end start, end; /**< BATTEN_NONLINEAR_NATURAL */
    double start_value, end_value;   /**< of TANGENT and CURVATURE */
    bool closed;            /**< the curve closes smoothly; the first point is not repeated */
    const double *tensions; /**< LOCAL_TENSION: sigma l of each span [count - 1, closed: count];
                                 NULL: as much as it takes that no span has an excess
                               inflection, or as much as there can be: see inflections_added */
    int max_steps;          /**< of Newton; 50 */
} batten_nonlinear_options;
BATTEN_API batten_nonlinear_options batten_nonlinear_defaults(void);

typedef struct batten_nonlinear_report {
    int steps;             /**< of Newton */
    double residual;       /**< largest jump of curvature at a point */
    double curvature;      /**< the largest */
    int inflections_added; /**< spans bent to both sides where the points ask for one */
    double turn;           /**< the largest that the polygon makes at a point, radians */
    int turn_at; /**< there; beyond 120 degrees curves bulge, and some families fail */
} batten_nonlinear_report;

/**
 * The spline of a family through points of the plane.
 *
 * @param points [count][2], 2 or more, 3 or more when closed; neighbours apart
 * @param options NULL for the defaults
 * @param[out] angles [count] directions at the points, radians; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK; COINCIDENT; SINGULAR_HERE naming the point at which the polygon turns back
 * on itself; TOLERANCE_NOT_MET naming the span that has no solution or bends more than the
 * family allows, and what would work instead; SINGULAR_SYSTEM; INCOMPLETE when max_steps did
 * not do
 *
 * Breaks of the chain: those of point i are found in `parameters` [count], may be NULL.
 * Cost: linear in count for each step. Source: [SL] ch. VI; Euler spirals [BF15], HOBBY
 * [Hobby86].
 */
BATTEN_API batten_status batten_chain_nonlinear(int count, const double *points,
                                                const batten_nonlinear_options *options,
                                                double *angles, double *parameters,
                                                batten_nonlinear_report *report,
                                                batten_chain **out);

typedef struct batten_mehlum_options {
    size_t size;
    batten_nonlinear_end start, end; /**< BATTEN_NONLINEAR_NATURAL */
    double start_value, end_value;   /**< of TANGENT and CURVATURE */
    bool closed;      /**< the curve closes smoothly; the first point is not repeated */
    int arcs;         /**< in each span, 2 or more; 4 */
    double tolerance; /**< model units: more arcs, span by span, until none is farther from the
                           elastica; 0: `arcs` everywhere */
} batten_mehlum_options;
BATTEN_API batten_mehlum_options batten_mehlum_defaults(void);

typedef struct batten_mehlum_report {
    int arcs;         /**< in all */
    double deviation; /**< the largest distance from the elastica, of 8 places on each arc */
    double at;        /**< there: span, counted from 0, and the share of it gone */
    double jump;      /**< the largest of curvature from arc to arc */
} batten_mehlum_report;

/**
 * Mehlum's curve: the mechanical spline through points (BATTEN_FAMILY_ELASTICA) as a chain of
 * arcs, tangent to each other, with the directions of the elastica at the points.
 *
 * The arcs of a span are of equal length h; curvature goes in steps as that of the elastica.
 * The deviation falls with the third power of h, the bending energy misses that of the elastica
 * by the second.
 *
 * @param points  [count][2], 2 or more, 3 or more when closed; neighbours apart
 * @param options NULL for the defaults
 * @param[out] angles [count] directions at the points, radians; may be NULL
 * @param[out] parameters [count], arc lengths from the start; may be NULL
 * @param[out] report may be NULL
 * @return as batten_chain_nonlinear; also BAD_ARGUMENT (arcs, tolerance), TOLERANCE_NOT_MET
 * naming the span that so few arcs cannot follow, or that needs more than 10000
 * Cost: that of the elastica, and some ten evaluations of it for each arc. Source: [Mehlum64],
 * [Mehlum74]; the directions between the points, which make the order three, are our own.
 */
BATTEN_API batten_status batten_chain_mehlum(int count, const double *points,
                                             const batten_mehlum_options *options,
                                             double *angles, double *parameters,
                                             batten_mehlum_report *report, batten_chain **out);

/**
 * The Euler spiral (clothoid, curvature linear in arc length) between two points with given
 * directions, radians: the one that turns least.
 *
 * @param start, end [2], apart
 * @param[out] steps of Newton; may be NULL
 * @param[out] error distance at the end in point and, times the length, in direction, model
 *             units; may be NULL
 * @return BATTEN_OK, NOT_FINITE, COINCIDENT, OVERFLOW, or TOLERANCE_NOT_MET when both
 * directions stand to the chord at more than 0.98 pi: there is then none that is near
 * Source: [BF15].
 */
BATTEN_API batten_status batten_spiral_hermite(const double *start, double start_angle,
                                               const double *end, double end_angle, int *steps,
                                               double *error, batten_span *out);

#ifdef __cplusplus
}
#endif
#endif
