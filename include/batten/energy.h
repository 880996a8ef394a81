#ifndef BATTEN_ENERGY_H
#define BATTEN_ENERGY_H
/**
 * @file
 * Curves through points that are fairest by a measure of their shape alone: least bending, or
 * least change of curvature. In the plane and in space.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What is to be least, along arc length s. */
typedef enum batten_energy {
    BATTEN_ENERGY_BENDING,  /**< the integral of k^2: a thin elastic strip */
    BATTEN_ENERGY_VARIATION /**< the integral of k'^2, in space of k'^2 + (k torsion)^2, which
                               is the change of the curvature vector across the tangent: circles
                                 have none */
} batten_energy;

typedef struct batten_energy_options {
    size_t size;
    batten_energy energy; /**< BATTEN_ENERGY_VARIATION */
    bool scale_invariant; /**< times the length (BENDING), its cube (VARIATION): the number does
                               not depend on the unit, and longer curves are no cheaper */
    double tension;       /**< added for each unit of length, >= 0: the strip is pulled; 0 */
    bool closed;          /**< the curve closes smoothly; the first point is not repeated */
    int pieces;           /**< quintics between neighbours among the points, 1..16; 2 */
    const double *start_tangent, *end_tangent;     /**< [dimension], any length; NULL: free */
    const double *start_curvature, *end_curvature; /**< [dimension], the vector towards the
                            centre, one by the unit; needs the tangent, to which it is square;
                            NULL: free */
    int max_steps;                                 /**< of Newton; 200 */
} batten_energy_options;
BATTEN_API batten_energy_options batten_energy_defaults(void);

typedef struct batten_energy_report {
    int steps;
    double before, after; /**< the energy of the spline that was the start, and of the result */
    double length;        /**< of the result */
    double remaining;     /**< how much the energy would still fall, by its derivatives */
} batten_energy_report;

/**
 * The curve of least energy through points, among curves of quintic pieces with continuous
 * tangent and curvature.
 *
 * It is the least near a spline from which the search begins: in the plane the elastica (for
 * bending) or the spline after Spiro (for variation), where these exist, else, and where that
 * leads nowhere, the cubic spline. For bending there is none in the large, since loops can grow
 * for ever; nor is there always one with free ends. Two points give the line; so do all on a
 * line. Points of a circle give the circle of least variation within 2e-9 of its radius when
 * they are a radian apart, with 4 pieces within 1e-10. Where a curve of least bending is known
 * to exist, `batten_chain_nonlinear` with ELASTICA has it exactly; this one also knows space,
 * tension and variation.
 *
 * @param dimension 2 or 3
 * @param points    [count][dimension], 2 or more, 3 or more when closed; neighbours apart
 * @param options   NULL for the defaults
 * @param[out] parameters [count], all but arc lengths; closed: the curve ends at the first
 * point again; may be NULL
 * @param[out] report may be NULL
 * @return BATTEN_OK; NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, BAD_ARGUMENT; INCOMPLETE when
 * max_steps did not reach the least, or the curve grows without end: then give directions at
 * the ends or a tension
 *
 * Cost: linear in count times pieces for each step, some 5 microseconds a piece; mostly 5 to 20
 * steps. Source: [MS92], [Horn83].
 */
BATTEN_API batten_status batten_curve_minimum_energy(
    int dimension, int count, const double *points, const batten_energy_options *options,
    double *parameters, batten_energy_report *report, batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
