#ifndef BATTEN_SURFACE_OFFSET_H
#define BATTEN_SURFACE_OFFSET_H
/**
 * @file
 * Surfaces at a distance from a surface.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_surface_offset_options {
    size_t size;
    double tolerance; /**< model units: how far from the true offset; 0: the true one, of the
                           kind "offset", where it is no NURBS surface. 1e-4 */
    bool keep;        /**< make it also where it turns over; else that is refused. false */
    int most_points;  /**< of the surface near it; more are TOLERANCE_NOT_MET. 4,000,000 */
} batten_surface_offset_options;
BATTEN_API batten_surface_offset_options batten_surface_offset_defaults(void);

typedef struct batten_surface_offset_report {
    bool exact;         /**< a NURBS surface of the knots and weights of the given one */
    double error;       /**< the largest measured distance from the true offset at equal
                             parameters, 0 when exact or of the kind "offset" */
    double least, most; /**< principal curvatures of the given surface, as far as they were
                             found: most >= least, positive where it bends to its normal */
    double factor;      /**< the least 1 - distance * curvature: not above 0 where the offset
                             has a ridge or lies the other way round */
    double at[2];       /**< the parameters of that place */
    batten_interval turned[2]; /**< the box of u and v that holds all places found where the
                               factor is 0 or less; empty, a > b, when there are none */
} batten_surface_offset_report;

/**
 * S + distance * n, with the unit normal n of Su x Sv; at the same parameters.
 *
 * The offset of a plane, sphere, cylinder, cone, torus, pipe or surface turned from lines and
 * arcs is a surface with the same knots and weights; that is tried with each surface, and
 * verified at 9 places of each patch to 1e-12 of its size. All others are met within the
 * tolerance. Derivatives of the offset come from one order more of the surface's, at poles
 * (edges that are points) two, and are exact; very near a pole they lose digits to rounding. A
 * pole whose normals agree stays a pole; the apex of a cone becomes a circle.
 *
 * Where 1 - distance * curvature vanishes the offset has a ridge. Principal curvatures are
 * sampled, at degree + 1 places or more of each span both ways, and the extreme ones refined by
 * a search around them; what lies between samples and is no extreme near one is not seen.
 * Whether far parts of the offset cross each other is not asked.
 *
 * @param surface  NURBS, in space; knots where normals jump by more than 1e-6 are refused
 * @param distance model units; negative: against the normal
 * @param options  NULL for the defaults
 * @param[out] report may be NULL; filled in also after SINGULAR_HERE for a turned offset
 * @return BATTEN_OK; BAD_ARGUMENT, NOT_FINITE; UNSUPPORTED (other kinds: make them NURBS first,
 * with the error that this has); NOT_COMPATIBLE (a crease, with its place and angle);
 * SINGULAR_HERE (no normal, with the place; or an offset that turns over, with place, radius
 * and the box of parameters); TOLERANCE_NOT_MET, TOO_LARGE, OVERFLOW
 *
 * Cost: about 30 evaluations for each patch of degree 3; those of batten_surface_to_nurbs.
 * Source: [PM02] ch. 11.
 */
BATTEN_API batten_status batten_surface_offset(const batten_surface *surface, double distance,
                                               const batten_surface_offset_options *options,
                                               batten_surface_offset_report *report,
                                               batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
