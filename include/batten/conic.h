#ifndef BATTEN_CONIC_H
#define BATTEN_CONIC_H
/**
 * @file
 * Conics through points of the plane with given tangents: one conic between two points, or a
 * pair of them that also has given curvatures. Exact rational quadratics.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What stands between two points whose tangents bend to one side, a C. */
typedef enum batten_conics_kind {
    BATTEN_CONICS_PAIRS,     /**< two conics with the curvatures at both points; curvature is
                                  continuous where they meet */
    BATTEN_CONICS_PARABOLAS, /**< two parabolas: with shares of 1/2 a quadratic spline with one
                                  knot in the middle */
    BATTEN_CONICS_SINGLE     /**< one conic */
} batten_conics_kind;

typedef struct batten_conics_options {
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
} batten_conics_options;
BATTEN_API batten_conics_options batten_conics_defaults(void);

typedef struct batten_conics_report {
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
} batten_conics_report;

/**
 * Conics through points of the plane with tangents, and for PAIRS curvatures.
 *
 * In a C the tangents of P0 and P3 meet in T. A lies at the start share from P0 to T, B at the
 * end share from P3 to T; the pair is (P0, A, J), (J, B, P3) with J between A and B. With the
 * curvatures k0 and k3, a = |A - P0|, b = |P3 - B|, the curvature at J is
 * (k0^(1/3) a + k3^(1/3) b)^3 / |A - B|^3 from both sides. The curve stays in the triangle
 * P0 T P3 and has no inflection.
 *
 * @param points  [count][2], 2 or more, closed 3; neighbours apart
 * @param options NULL for the defaults
 * @param[out] parameters [count], closed [count + 1]; may be NULL
 * @param[out] report may be NULL
 * @param[out] out rational of degree 2, tangents continuous, speed not
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_FINITE, COINCIDENT naming the points; BAD_ARGUMENT (a
 * tangent of no length, shares outside [0, 1), a weight below 0); SINGULAR_HERE for tangents
 * that both point back along the chord; OVERFLOW
 *
 * Two points without tangents give their chord. Cost: linear in count.
 * Source: [SL] VI.5, [PT97] 9.3.3 for single conics; the shares from the data are our own.
 */
BATTEN_API batten_status batten_curve_conics(int count, const double *points,
                                             const batten_conics_options *options,
                                             double *parameters, batten_conics_report *report,
                                             batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
