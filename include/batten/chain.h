#ifndef BATTEN_CHAIN_H
#define BATTEN_CHAIN_H
/**
 * @file
 * A chain of spans that are not all polynomials: arcs, clothoids, splines in tension, elastica.
 *
 * A chain is what a nonlinear spline truly is. It is evaluated exactly, and converted to a
 * NURBS curve within a tolerance for all that knows only those. Immutable, reference counted.
 *
 * The spans stand one after another on the domain [breaks[0], breaks[count]]. Each has a
 * parameter of its own from 0 to its length, which follows u linearly between its two breaks:
 * ARC, SPIRAL and ELASTICA go by arc length, GEOMETRIC by the abscissa along its chord, TENSION
 * by a parameter of any unit.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_chain batten_chain;

typedef enum batten_span_kind {
    BATTEN_SPAN_ARC,       /**< plane: curvature constant; 0: a line */
    BATTEN_SPAN_SPIRAL,    /**< plane: curvature a polynomial of arc length, degree <= 3 */
    BATTEN_SPAN_ELASTICA,  /**< plane: k'' + k^3 / 2 = 0 along arc length */
    BATTEN_SPAN_GEOMETRIC, /**< plane: curvature linear in the abscissa along the chord */
    BATTEN_SPAN_TENSION    /**< 1 to 3 dimensions: P'''' = tension^2 P''; tension 0: a cubic */
} batten_span_kind;

/** One span; the fields that its kind does not use are 0. */
typedef struct batten_span {
    batten_span_kind kind;
    double length;       /**< of its parameter, > 0: arc length; GEOMETRIC: of the chord */
    double start[3];     /**< the first point; plane kinds use two coordinates */
    double angle;        /**< plane kinds: of the tangent at the start, radians */
    double curvature[4]; /**< ARC [0]. SPIRAL: at the start, and its first to third derivative
                              by arc length. ELASTICA: [0], and [1] the derivative. GEOMETRIC:
                              [0] at the start, [1] for each unit of the abscissa */
    double chord;        /**< GEOMETRIC: direction of the chord, radians; of a part that of the
                              whole */
    double end[3];       /**< TENSION: the last point */
    double bend[2][3];   /**< TENSION: second derivatives at start and end */
    double tension;      /**< TENSION: sigma >= 0, one by the unit of the parameter */
} batten_span;

/** What a chain is made from; all of it is copied. */
typedef struct batten_chain_parts {
    int dimension; /**< 2; when all spans are in tension 1 to 3 */
    int count;
    const batten_span *spans; /**< [count] */
    const double *breaks;     /**< [count + 1], increasing */
    bool closed;              /**< the last span ends where the first begins */
} batten_chain_parts;

/**
 * Make a chain; everything is copied.
 *
 * @param parts  dimension: 2 for plane kinds; 1..3 when all spans are TENSION
 *     spans: [count], each beginning where the one before ends, within `tolerance`
 *     breaks: [count + 1], increasing; NULL: from 0, by the lengths of the spans
 *     closed: the last span ends at the first; then any parameter is taken, by periods
 * @param tolerance  model units, 0 or more; infinity: gaps are not looked at
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT (no span, kinds and dimension, lengths, tolerance),
 * NOT_FINITE, NOT_INCREASING, NOT_COMPATIBLE (a gap, named with its size), OVERFLOW,
 * TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the spans.
 */
BATTEN_API batten_status batten_chain_create(const batten_chain_parts *parts, double tolerance,
                                             batten_chain **out);
/**
 * A plane chain (dimension 2) put into space, into the xy-plane of a frame; dimension 3.
 *
 * @param chain  of dimension 2, not placed
 * @param frame  its plane; it is made orthonormal
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT (chain, or a frame without two directions), NOT_FINITE,
 * OUT_OF_MEMORY
 *
 * Cost: linear in the spans.
 */
BATTEN_API batten_status batten_chain_place(const batten_chain *chain,
                                            const batten_frame *frame, batten_chain **out);
/** One more reference to the same chain. */
BATTEN_API batten_chain *batten_chain_ref(const batten_chain *chain);
/**
 * Give one reference back; NULL is welcome.
 *
 * @param chain  any chain
 */
BATTEN_API void batten_chain_unref(batten_chain *chain);

/**
 * The number of coordinates: 2, 3 once placed in space, 1 of a function.
 *
 * @param chain  any chain
 */
BATTEN_API int batten_chain_dimension(const batten_chain *chain);
/** How many spans the chain has. */
BATTEN_API int batten_chain_span_count(const batten_chain *chain);
/**
 * In the plane of the chain when it was placed.
 *
 * @param index  from 0
 */
BATTEN_API const batten_span *batten_chain_span(const batten_chain *chain, int index);
/**
 * The parameters at which spans begin and end, [span count + 1], increasing.
 *
 * @param chain  any chain
 */
BATTEN_API const double *batten_chain_breaks(const batten_chain *chain); /**
 * < [count + 1]
 *
 * @param chain  any chain
 */
BATTEN_API batten_interval batten_chain_domain(const batten_chain *chain);
/**
 * Whether the last span ends where the first begins.
 *
 * @param chain  any chain
 */
BATTEN_API bool batten_chain_is_closed(const batten_chain *chain);
/**
 * The frame in which it was placed; false when it was not.
 *
 * @param chain  any chain
 */
BATTEN_API bool batten_chain_frame(const batten_chain *chain, batten_frame *frame);
/**
 * Are all spans arcs and lines?
 *
 * @param chain  any chain
 */
BATTEN_API bool batten_chain_is_arcs(const batten_chain *chain);

/**
 * Evaluate a chain and its derivatives with respect to `u`.
 *
 * At a break the derivatives are those from the named side. A parameter up to 4 ulps outside
 * the domain counts as its end.
 *
 * @param chain  any chain
 * @param u  in the domain; of a closed chain any
 * @param side  which side at a break
 * @param order  0..3
 * @param[out] out [order + 1][dimension]
 * @return BATTEN_OK, BAD_ARGUMENT (order), NOT_FINITE, OUT_OF_DOMAIN, OVERFLOW
 *
 * Cost: log2(n) comparisons to find the span; constant for lines, arcs and tension, a spiral
 * one Fresnel integral, an elastica its elliptic functions. No allocation.
 */
BATTEN_API batten_status batten_chain_evaluate_side(const batten_chain *chain, double u,
                                                    batten_side side, int order, double *out);
/**
 * The same from the right; at the end of the domain, from the left.
 *
 * @param chain  any chain
 * @param u  in the domain; of a closed chain any
 * @param order  of the highest derivative, 0..3
 * @param[out] out  [order + 1][dimension]
 * @return as batten_chain_evaluate_side
 *
 * Cost: as batten_chain_evaluate_side.
 */
BATTEN_API batten_status batten_chain_evaluate(const batten_chain *chain, double u, int order,
                                               double *out);

/**
 * The chain under a map that keeps shapes (rotation, mirror, translation, one scale for all
 * axes); else BAD_ARGUMENT. A plane chain must stay in its plane. The breaks stay.
 *
 * @param chain  any chain
 * @param map  keeps shapes
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT (another map, or one that takes a plane chain out of its
 * plane), NOT_FINITE, OUT_OF_MEMORY
 *
 * Cost: linear in the spans.
 */
BATTEN_API batten_status batten_chain_transform(const batten_chain *chain,
                                                const batten_affine *map, batten_chain **out);

/**
 * The part from a to b inside the domain, a < b: open, with the parameters it had; a span that
 * is cut stays of its kind.
 *
 * @param chain  any chain
 * @param a, b  parameters in the domain, a < b
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; OUT_OF_DOMAIN, also when b <= a; NOT_FINITE; OUT_OF_MEMORY
 *
 * Cost: linear in the spans that are kept.
 */
BATTEN_API batten_status batten_chain_subrange(const batten_chain *chain, double a, double b,
                                               batten_chain **out);
/**
 * The reversed chain: the domain [a, b] becomes [-b, -a], the point at u is found at -u.
 *
 * @param chain  any chain
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in the spans.
 */
BATTEN_API batten_status batten_chain_reverse(const batten_chain *chain, batten_chain **out);
/**
 * Join end to start. Both are open, of one dimension and, when placed, in the same frame bit
 * for bit; the ends are within `tolerance`, and stay where they are. The second domain is moved
 * to follow the first.
 *
 * @param first, second  open chains
 * @param tolerance  model units, 0 or more
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; NOT_COMPATIBLE (dimension, frame, a closed chain, a gap, which the message
 * names), BAD_ARGUMENT (tolerance), NOT_INCREASING, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the spans of both.
 */
BATTEN_API batten_status batten_chain_join(const batten_chain *first,
                                           const batten_chain *second, double tolerance,
                                           batten_chain **out);

/**
 * The NURBS curve of a chain, with the same breaks.
 *
 * Arcs and lines alone become exact rational quadratics, cubics (TENSION with tension 0) exact
 * cubics. Other chains become quintics that agree with the chain in point, first and second
 * derivative at the ends of every piece; spans are halved until no piece is farther from the
 * chain than `tolerance`, at equal parameters.
 *
 * @param tolerance model units, > 0
 * @param[out] error  a bound of the distance at equal parameters, from a bound of the sixth
 *              derivative on each piece and the rounding of the coordinates; at least the
 *              largest gap between two spans that was let pass when the chain was made; 0 when
 *              exact. May be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, TOLERANCE_NOT_MET, TOO_LARGE (1 million pieces), OVERFLOW
 * Cost: linear in the number of pieces.
 * Source: [dBHS87] for the order, 6.
 */
BATTEN_API batten_status batten_chain_to_curve(const batten_chain *chain, double tolerance,
                                               double *error, batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
