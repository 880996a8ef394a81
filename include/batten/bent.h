#ifndef BATTEN_BENT_H
#define BATTEN_BENT_H
/**
 * @file
 * Curves bent like a batten: elastica, spirals, least energy, spiro, rational splines in tension.
 */
#include <batten/chain.h>
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A point of the plane and a direction at it. */
typedef struct batten_heading {
    const double *point; /**< [2] */
    double angle;        /**< radians from x */
} batten_heading;

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

typedef struct batten_chain_nonlinear_options {
    size_t size;
    batten_span_family family;       /**< BATTEN_FAMILY_EULER_SPIRAL */
    batten_nonlinear_end start, end; /**< BATTEN_NONLINEAR_NATURAL */
    double start_value, end_value;   /**< of TANGENT and CURVATURE */
    bool closed;            /**< the curve closes smoothly; the first point is not repeated */
    const double *tensions; /**< LOCAL_TENSION: sigma l of each span [count - 1, closed: count];
                                 NULL: as much as it takes that no span has an excess
                               inflection, or as much as there can be: see inflections_added */
    int max_steps;          /**< of Newton; 50 */
} batten_chain_nonlinear_options;
/** The defaults of elastica and their like: those beside the fields of
 * batten_chain_nonlinear_options. */
BATTEN_API batten_chain_nonlinear_options batten_chain_nonlinear_defaults(void);

typedef struct batten_chain_nonlinear_report {
    int steps;             /**< of Newton */
    double error;          /**< largest jump of curvature at a point */
    double curvature;      /**< the largest */
    int inflections_added; /**< spans bent to both sides where the points ask for one */
    double turn;           /**< the largest that the polygon makes at a point, radians */
    int turn_at; /**< there; beyond 120 degrees curves bulge, and some families fail */
} batten_chain_nonlinear_report;

/**
 * The spline of a family through points of the plane.
 *
 * @param points [count][2], 2 or more, 3 or more when closed; neighbours apart
 * @param options NULL for the defaults
 * @param[out] angles [count] directions at the points, radians; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; COINCIDENT; SINGULAR_HERE naming the point at which the polygon turns back
 * on itself; TOLERANCE_NOT_MET naming the span that has no solution or bends more than the
 * family allows, and what would work instead; SINGULAR_SYSTEM; INCOMPLETE when max_steps did
 * not do
 *
 * Breaks of the chain: those of point i are found in `parameters` [count], may be NULL.
 * Cost: linear in count for each step.
 * Source: [SL] ch. VI; Euler spirals [BF15], HOBBY [Hobby86].
 */
BATTEN_API batten_status batten_chain_nonlinear(batten_points points,
                                                const batten_chain_nonlinear_options *options,
                                                double *angles, double *parameters,
                                                batten_chain_nonlinear_report *report,
                                                batten_chain **out);

typedef struct batten_chain_mehlum_options {
    size_t size;
    batten_nonlinear_end start, end; /**< BATTEN_NONLINEAR_NATURAL */
    double start_value, end_value;   /**< of TANGENT and CURVATURE */
    bool closed;      /**< the curve closes smoothly; the first point is not repeated */
    int arcs;         /**< in each span, 2 or more; 4 */
    double tolerance; /**< model units: more arcs, span by span, until none is farther from the
                           elastica; 0: `arcs` everywhere */
} batten_chain_mehlum_options;
/** The defaults of Mehlum's arcs: those beside the fields of batten_chain_mehlum_options. */
BATTEN_API batten_chain_mehlum_options batten_chain_mehlum_defaults(void);

typedef struct batten_chain_mehlum_report {
    int arcs;     /**< in all */
    double error; /**< the largest distance from the elastica, of 8 places on each arc */
    double at;    /**< there: span, counted from 0, and the share of it gone */
    double jump;  /**< the largest of curvature from arc to arc */
} batten_chain_mehlum_report;

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
 * @param[out] report  what was reached; may be NULL
 * @return as batten_chain_nonlinear; also BAD_ARGUMENT (arcs, tolerance), TOLERANCE_NOT_MET
 * naming the span that so few arcs cannot follow, or that needs more than 10000
 * Cost: that of the elastica, and some ten evaluations of it for each arc.
 * Source: [Mehlum64], [Mehlum74]; the directions between the points, which make the order
 * three, are our own.
 */
BATTEN_API batten_status batten_chain_mehlum(batten_points points,
                                             const batten_chain_mehlum_options *options,
                                             double *angles, double *parameters,
                                             batten_chain_mehlum_report *report,
                                             batten_chain **out);

/**
 * The Euler spiral (clothoid, curvature linear in arc length) between two points with given
 * directions, radians: the one that turns least.
 *
 * @param start, end  likewise; apart from the start
 * @param[out] steps  of Newton's method; may be NULL
 * @param[out] error distance at the end in point and, times the length, in direction, model
 *             units; may be NULL
 * @return BATTEN_OK, NOT_FINITE, COINCIDENT, OVERFLOW, or TOLERANCE_NOT_MET when both
 * directions stand to the chord at more than 0.98 pi: there is then none that is near
 *
 * Cost: a few steps of Newton's method, each of two Fresnel integrals; no allocation.
 * Source: [BF15].
 */
BATTEN_API batten_status batten_spiral_hermite(batten_heading start, batten_heading end,
                                               int *steps, double *error, batten_span *out);
/** What is to be least, along arc length s. */
typedef enum batten_energy {
    BATTEN_ENERGY_BENDING,  /**< the integral of k^2: a thin elastic strip */
    BATTEN_ENERGY_VARIATION /**< the integral of k'^2, in space of k'^2 + (k torsion)^2, which
                               is the change of the curvature vector across the tangent: circles
                                 have none */
} batten_energy;

typedef struct batten_curve_minimum_energy_options {
    size_t size;
    batten_energy energy; /**< BATTEN_ENERGY_VARIATION */
    bool scale_invariant; /**< times the length (BENDING), its cube (VARIATION): the number does
                               not depend on the unit, and longer curves are no cheaper */
    double tension;       /**< added for each unit of length, >= 0: the strip is pulled; 0 */
    bool closed;          /**< the curve closes smoothly; the first point is not repeated */
    int pieces; /**< quintics between neighbours among the points, 1..16; 0: as many as
                             save a thousandth of the energy, 2 to 16; 0 */
    const double *start_tangent, *end_tangent;     /**< [dimension], any length; NULL: free */
    const double *start_curvature, *end_curvature; /**< [dimension], the vector towards the
                            centre, one by the unit; needs the tangent, to which it is square;
                            NULL: free */
    int max_steps;                                 /**< of Newton; 200 */
} batten_curve_minimum_energy_options;
/** The defaults of least energy: those beside the fields of
 * batten_curve_minimum_energy_options. */
BATTEN_API batten_curve_minimum_energy_options batten_curve_minimum_energy_defaults(void);

typedef struct batten_curve_minimum_energy_report {
    int steps;
    double before, after; /**< the energy of the spline that was the start, and of the result */
    double length;        /**< of the result */
    double remaining;     /**< how much the energy would still fall, by its derivatives */
    double tension;       /**< 0; above 0: the curve would bend less and less by growing, this
                               tension holds it, and it is the least of those no longer */
} batten_curve_minimum_energy_report;

/**
 * The curve of least energy through points, among curves of quintic pieces with continuous
 * tangent and curvature.
 *
 * It is the least near the best of the other curves that Batten has through the same points:
 * the elastica, Euler spirals and Spiro's curve of points in a plane, cubic splines, and one of
 * circles through neighbours. Its energy is measured by adaptive quadrature on the result, and
 * none of these has one that is less by more than a thousandth; else the search ends INCOMPLETE
 * with both figures.
 *
 * Most points that lie wildly have no such least: the curve bends less and less by growing.
 * Among the curves up to a length there is one, as of a strip under tension. The result is then
 * held at about the length of the best of those others, where it has less energy than they, and
 * `tension` in the report is above 0: with it in the options the same curve is the least of
 * energy and tension together. Held so, its energy is known to a thousandth (`remaining`).
 *
 * Two points give the line; so do all on a line that do not turn back. Points of a circle give
 * the circle of least variation within 2e-9 of its radius when they are a radian apart, with 4
 * pieces within 1e-10. Where a curve of least bending is known to exist,
 * `batten_chain_nonlinear` with ELASTICA has it exactly; this one also knows space, tension and
 * variation.
 *
 * @param points  dimension: 2 or 3
 *     [count][dimension], 2 or more, 3 or more when closed; neighbours apart
 * @param options  NULL for the defaults
 * @param[out] parameters  [count], all but arc lengths; closed: the curve ends at the first
 * point again; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, BAD_ARGUMENT; NOT_COMPATIBLE when
 * all points lie on one line and turn back; INCOMPLETE when max_steps did not reach the least,
 * or the curve grows and no tension was found that holds it
 *
 * Cost: linear in count times pieces for each step, some 5 microseconds a piece; mostly 5 to 20
 * steps, some hundreds where a tension has to be found.
 * Source: [MS92], [Horn83].
 */
BATTEN_API batten_status batten_curve_minimum_energy(
    batten_points points, const batten_curve_minimum_energy_options *options,
    double *parameters, batten_curve_minimum_energy_report *report, batten_curve **out);
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

typedef struct batten_chain_spiro_options {
    size_t size;
    const batten_spiro_kind *kinds; /**< [count]; NULL: all SMOOTH */
    batten_spiro_end start, end;    /**< free; of closed curves they do not count */
    bool closed;                    /**< the first point is not repeated */
    int max_steps;                  /**< of Newton; 200 */
} batten_chain_spiro_options;
/** The defaults of spiro: those beside the fields of batten_chain_spiro_options. */
BATTEN_API batten_chain_spiro_options batten_chain_spiro_defaults(void);

typedef struct batten_chain_spiro_report {
    int steps;        /**< of Newton */
    double error;     /**< the largest jump at a point of what should continue: radians, or
                           derivatives of the direction times powers of the chords about it */
    double curvature; /**< the largest at a point */
    double bending;   /**< the integral of the square of curvature */
    double variation; /**< the integral of the square of its derivative by arc length */
    int straight;     /**< spans between two free ends: lines */
    double turn;      /**< the largest that the polygon makes at a point, radians */
    int turn_at;      /**< there */
} batten_chain_spiro_report;

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
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, OVERFLOW, BAD_ARGUMENT (a kind);
 * SINGULAR_HERE naming a point, not a corner, at which the polygon turns back on itself;
 * TOLERANCE_NOT_MET naming the span that cannot be bent so, and what would work instead;
 * INCOMPLETE when max_steps did not do
 *
 * Cost: linear in count for each step, about 2 microseconds a point; mostly 7 to 15 steps.
 * Source: the equations of [Levien09], ch. 8; solved by Newton's method from Euler spirals.
 */
BATTEN_API batten_status batten_chain_spiro(batten_points points,
                                            const batten_chain_spiro_options *options,
                                            double *parameters,
                                            batten_chain_spiro_report *report,
                                            batten_chain **out);

/**
 * The rational spline in tension through points, after Spaeth: on each span, with t from 0 to 1 and u = 1 - t,
 * A u + B t + C u^3 / (1 + p t) + D t^3 / (1 + p u). Its second derivatives are continuous, and within a span it bends
 * between those at its ends, without an inflection where both bend alike. p = 0 gives the cubic spline, a large p the chord.
 *
 * An exact curve of degree 4 with weights, where the spline in tension of batten_chain_tension needs a chain; its knots at
 * the points are full, for the weights beside them differ.
 *
 * @param points  dimension: 1..3
 *     [count][dimension], at least two; closed: at least three, each once
 * @param options  NULL for the defaults; `tension` and `tensions` are p, 0 to 1e6, which has no unit: 1 is a little, 10 much,
 * 100 nearly the polygon. The rule must be GIVEN
 * @param[out] parameters  [count], those of the points; may be NULL
 * @param[out] out  clamped, also when it is closed
 * @return BATTEN_OK, BAD_ARGUMENT (tension, ends, rule), NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, NOT_INCREASING, OVERFLOW,
 * TOLERANCE_NOT_MET (a slope that jumps), OUT_OF_MEMORY
 *
 * Cost: linear in count.
 * Source: [Spaeth95].
 */
BATTEN_API batten_status
batten_curve_rational_tension(batten_points points, const batten_chain_tension_options *options,
                              double *parameters, batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
