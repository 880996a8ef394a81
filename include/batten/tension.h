#ifndef BATTEN_TENSION_H
#define BATTEN_TENSION_H
/**
 * @file
 * Splines in tension through points: between a cubic spline and the polygon of the points.
 *
 * Think of a batten that is pulled at its ends. Each span obeys P'''' = sigma^2 P''; first and
 * second derivative go on over every point. Without tension it is the cubic spline, with very
 * much the polygon, and on the way there the turns that the data do not have disappear.
 */
#include <batten/chain.h>
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What tension is added for, where the tension given is too little. */
typedef enum batten_tension_rule {
    BATTEN_TENSION_GIVEN,   /**< nothing */
    BATTEN_TENSION_CONVEX,  /**< no inflection that the polygon of the points does not have */
    BATTEN_TENSION_MONOTONE /**< each coordinate rises and falls only as the points do */
} batten_tension_rule;

typedef struct batten_tension_options {
    size_t size;
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given;               /**< [count] (closed: [count + 1]) with BATTEN_GIVEN */
    bool closed;                       /**< closes smoothly; the first point is not repeated */
    batten_end start, end;  /**< NATURAL; also CLAMPED, DIRECTION, SECOND, PARABOLIC, BESSEL,
                                 CIRCLE */
    double tension;         /**< of every span, 0 or more: sigma times the mean step of the
                                 parameters, so that no unit matters. 0: none; 2: a little;
                                 10: much */
    const double *tensions; /**< [spans] the same span by span, instead; or NULL */
    batten_tension_rule rule;
    double slack; /**< above 0, for the rules: 0.01. See below */
} batten_tension_options;

/** Chord parameters, natural ends, tension 0, nothing automatic. */
BATTEN_API batten_tension_options batten_tension_defaults(void);

/**
 * The spline in tension through points, as a chain of spans of kind TENSION.
 *
 * The rule CONVEX looks at the turns of the polygon. At a point where it turns the curve turns
 * the same way, with no inflection between two points that turn alike; in space the turns are
 * seen along the normals of the polygon's corners. A function (dimension 1) is taken as its
 * graph: convex where the data are. At a point in line with its neighbours no smooth curve can
 * keep still, if the polygon turns beside it; there the tangent leaves the line by at most
 * `slack` times the turns beside it. MONOTONE looks at each coordinate: between two points it
 * changes no direction, except near a point where the data do; over a level span the slope is
 * at most `slack` of that beside it. The tension of the spans that fail is raised by halves,
 * beginning with 1 by the length of the span, so long as it is too little somewhere.
 *
 * Two points give a line, or with given derivatives a span between them.
 *
 * @param dimension  1..3
 * @param points     [count][dimension], at least two; closed: at least three, each once
 * @param options    NULL for the defaults
 * @param[out] parameters [count], those of the points; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT (tension, ends), NOT_FINITE, TOO_FEW_POINTS, COINCIDENT,
 * NOT_INCREASING, OVERFLOW, TOLERANCE_NOT_MET (a rule that 100 rounds do not satisfy, naming
 * the point; a slope that jumps)
 *
 * Cost: linear in count, for each round of a rule; rounds are mostly fewer than 20.
 * Source: [Schweikert66], [Cline74]; [KK97] for turns in space.
 */
BATTEN_API batten_status batten_chain_tension(int dimension, int count, const double *points,
                                              const batten_tension_options *options,
                                              double *parameters, batten_chain **out);

#ifdef __cplusplus
}
#endif
#endif
