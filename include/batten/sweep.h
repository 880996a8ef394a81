#ifndef BATTEN_SWEEP_H
#define BATTEN_SWEEP_H
/**
 * @file
 * Surfaces that a curve leaves when it is moved: translated, swung, swept along a spine or two
 * rails, screwed about an axis; and those of straight lines through a curve.
 */
#include <batten/skin.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- exact ---- */

/**
 * The translational surface: C(u) + D(v) - D(a), `curve` moved along `path` without turning,
 * where a is the start of the path. Exact, also where one or both are rational; every u-line is
 * a copy of `curve`, every v-line one of `path`.
 *
 * @param curve, path  of 1 to 3 dimensions, taken into space; degrees, knots and periods are
 *                     kept
 * @return BATTEN_OK; COINCIDENT when one of them is a point; TOO_LARGE (10 million control
 * points), OVERFLOW Source: [PT97] 10.4
 */
BATTEN_API batten_status batten_surface_translational(const batten_curve *curve,
                                                      const batten_curve *path,
                                                      batten_surface **out);

/** What a swing found: the surface cuts through itself where the profile passes the axis, or
 * the trajectory the origin; it has a pole where one of them touches it. */
typedef struct batten_swing_report {
    double least_x,
        largest_x;       /**< how far the profile's control points reach across the axis */
    double least_radius; /**< the least distance of the trajectory from the axis, of 65
                              points of each span */
} batten_swing_report;

/**
 * Swing a profile P(u) of the xz-plane along a trajectory T(v) of the xy-plane:
 * (factor Px Tx, factor Px Ty, Pz). Heights stay, horizontal lines are copies of T in other
 * sizes. With the unit circle and factor 1 it is the surface of revolution.
 *
 * @param profile     in space with y = 0, or in the plane: then its coordinates are x and z
 * @param trajectory  in space with z = 0, or in the plane
 * @param factor      > 0
 * @param[out] report may be NULL
 * @return BATTEN_OK; NOT_COMPATIBLE for a curve that leaves its plane by more than 1e-12 of its
 * size, naming its control point; COINCIDENT for a curve that is a point; BAD_ARGUMENT;
 * TOO_LARGE, OVERFLOW
 * Source: [PT97] 8.5 and 10.1; [Woodward87].
 */
BATTEN_API batten_status batten_surface_swung(const batten_curve *profile,
                                              const batten_curve *trajectory, double factor,
                                              batten_swing_report *report,
                                              batten_surface **out);

/**
 * The tabulated cylinder: straight lines through a curve along `direction`, from the signed
 * distance `from` to `to`; u along the curve, v along the lines, in model units.
 * @return BATTEN_OK; BAD_ARGUMENT (no direction, or from >= to), NOT_FINITE, COINCIDENT for a
 * curve that is a point
 */
BATTEN_API batten_status batten_surface_tabulated(const batten_curve *curve,
                                                  batten_vec3 direction, double from, double to,
                                                  batten_surface **out);

/**
 * The cone of straight lines from a curve (v = 0) to an apex (v = 1): a pole.
 * @return BATTEN_OK; COINCIDENT when the curve is the apex; NOT_FINITE
 */
BATTEN_API batten_status batten_surface_cone_to(const batten_curve *curve, batten_vec3 apex,
                                                batten_surface **out);

/**
 * The ruled surface whose lines join points of equal shares of arc length. Both curves are
 * followed at even speed within `tolerance` (polylines exactly).
 * @param tolerance model units, > 0
 * @param[out] error how far the curves were moved at most; may be NULL
 * @return as batten_curve_even_speed and batten_surface_ruled
 */
BATTEN_API batten_status batten_surface_ruled_by_length(const batten_curve *first,
                                                        const batten_curve *second,
                                                        double tolerance, double *error,
                                                        batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
