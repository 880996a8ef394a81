#ifndef BATTEN_CURVATURE_H
#define BATTEN_CURVATURE_H
/**
 * @file
 * Curvature of curves and surfaces, where it is special, and frames along curves.
 */
#include <batten/chain.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_frame_kind {
    BATTEN_FRAME_ROTATION_MINIMISING,
    BATTEN_FRAME_FIXED,
    BATTEN_FRAME_FRENET,
    BATTEN_FRAME_CLOSING /**< minimising, and along a closed spine turned evenly by arc length
                            so that the last frame is the first */
} batten_frame_kind;

/**
 * Frames along a spine, for those who place things themselves: orthonormal, axis z along the
 * tangent.
 *
 * The first minimising or fixed frame stands at the start of the spine; its x is that axis of
 * the world which lies most across the tangent (x before y before z). A fixed frame keeps both
 * axes all along.
 * @param spine  any curve
 * @param at [count] increasing, in the domain of the spine
 * @param kind  which of them
 * @param[out] frames [count]
 * @return BATTEN_OK; SINGULAR_HERE without a tangent, or, Frenet, where the spine is straight;
 * NOT_COMPATIBLE, closing, where the spine does not close with one tangent; OUT_OF_DOMAIN,
 * NOT_INCREASING
 *
 * Cost: 64 steps for each span of the spine, two evaluations each; fixed and Frenet frames one
 * evaluation for each place.
 * Source: [WJZL08], with 64 double reflections for each span of the spine.
 */
BATTEN_API batten_status batten_curve_frames(const batten_curve *spine, int count,
                                             const double *at, batten_frame_kind kind,
                                             batten_frame *frames);

/**
 * Rotation-minimising frames as exact as wanted: the double reflections of each span are
 * doubled until no frame turns by more than `tolerance`. As their error falls with the fourth
 * power of the step, the frames are then some fifteen times better than that.
 * @param spine  the curve along which they stand
 * @param count  how many, 1 or more
 * @param at  [count] increasing, in the domain
 * @param tolerance radians, > 0
 * @param[out] error the last turn, radians; may be NULL
 * @param[out] frames  [count]
 * @return as batten_curve_frames; BAD_ARGUMENT; TOLERANCE_NOT_MET at 16384 steps for each span
 *
 * Cost: two evaluations for each step; 8 steps for each span at first, doubled until the
 * tolerance is met.
 */
BATTEN_API batten_status batten_curve_minimising_frames(const batten_curve *spine, int count,
                                                        const double *at, double tolerance,
                                                        double *error, batten_frame *frames);
/**
 * By which angle a rotation-minimising frame is turned about the tangent after one round of a
 * closed curve, radians in (-pi, pi]. Where curvature never vanishes it is minus the total
 * torsion; on a sphere and in a plane it is 0.
 * @param curve  closed, with one tangent at its seam
 * @param tolerance, error as above
 * @param[out] angle  radians, in (-pi, pi]
 * @return as batten_curve_minimising_frames; NOT_COMPATIBLE when the ends do not meet with one
 * tangent
 *
 * Cost: as batten_curve_minimising_frames at two places.
 */
BATTEN_API batten_status batten_curve_holonomy(const batten_curve *curve, double tolerance,
                                               double *error, double *angle);
/** What a curve does at one parameter. In the plane `binormal` is (0, 0, 1) and curvature
 * signed: positive where the curve turns left; in space curvature is never negative. */
typedef struct batten_curve_local {
    batten_vec3 point;
    batten_vec3 tangent, normal, binormal;
    double speed;          /**< |C'| */
    double curvature;      /**< 1 / length */
    double curvature_rate; /**< d curvature / d arc length */
    double torsion;        /**< 1 / length; 0 in the plane */
} batten_curve_local;

/**
 * Point, tangent, normal, curvature and torsion of a curve at a parameter.
 *
 * @param curve  any curve
 * @param u  in the domain
 * @param side  from which side at a knot
 * @param[out] out  see the struct
 * @return BATTEN_OK; as batten_curve_evaluate; SINGULAR_HERE where the first derivative
 * vanishes; then `out` has the point, the tangent from the first derivative that does not
 * vanish, and 0 for the rest. In space normal and binormal are 0 where the curve is straight.
 *
 * Cost: one evaluation to order 3.
 */
BATTEN_API batten_status batten_curve_local_at(const batten_curve *curve, double u,
                                               batten_side side, batten_curve_local *out);

/**
 * The same of a chain, as batten_curve_local_at.
 *
 * @param chain  any chain
 * @param u  in the domain of the chain
 * @param side  from which side at a break
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_chain_evaluate; SINGULAR_HERE as there
 *
 * Cost: one evaluation to order 3.
 */
BATTEN_API batten_status batten_chain_local_at(const batten_chain *chain, double u,
                                               batten_side side, batten_curve_local *out);

/**
 * All inflections of a plane curve: sign changes of curvature, also those at knots and at the
 * seam of a periodic curve. Of a function (dimension 1) those of its second derivative. Sign
 * changes within the rounding of the control points are none, so a straight line has no
 * inflections.
 *
 * @param curve  of dimension 1 or 2
 * @param[out] out  release `out->at` with batten_release
 * @return BATTEN_OK, NOT_COMPATIBLE, OUT_OF_MEMORY
 *
 * Cost: linear in the spans: on each the roots of a polynomial of degree 2 p - 3, of a rational
 * curve 3 p - 3 at most.
 */
BATTEN_API batten_status batten_curve_inflections(const batten_curve *curve,
                                                  batten_parameters *out);
/**
 * All local extrema of curvature (in the plane signed) inside the domain, also those at knots
 * where its rate changes sign. Of a function those of its second derivative.
 *
 * @param curve  any curve
 * @param[out] out  release `out->at` with batten_release
 * @return BATTEN_OK, OUT_OF_MEMORY
 *
 * Cost: linear in the spans: on each the roots of a polynomial, of degree 4 p - 6 in the plane
 * without weights.
 */
BATTEN_API batten_status batten_curve_curvature_extrema(const batten_curve *curve,
                                                        batten_parameters *out);
/**
 * All places where curvature is 0 to rounding, the inflections among them, and of a straight
 * piece its ends.
 *
 * @param curve  any curve
 * @param[out] out  release `out->at` with batten_release
 * @return BATTEN_OK, NOT_COMPATIBLE, OUT_OF_MEMORY
 *
 * Cost: as batten_curve_inflections; in space the polynomial has twice that degree.
 */
BATTEN_API batten_status batten_curve_flat_points(const batten_curve *curve,
                                                  batten_parameters *out);
/**
 * All places where the first derivative is 0: its square within the rounding of the span, so a
 * speed below some 1e-8 of the largest there is 0. Cusps are among them.
 *
 * @param curve  any curve
 * @param[out] out  release `out->at` with batten_release
 * @return BATTEN_OK, OUT_OF_MEMORY
 *
 * Cost: linear in the spans: on each the roots of a polynomial of degree 2 p - 2, more when
 * rational.
 */
BATTEN_API batten_status batten_curve_standstills(const batten_curve *curve,
                                                  batten_parameters *out);

/** One tooth of a curvature comb. */
typedef struct batten_tooth {
    double u;
    batten_vec3 foot, tip; /**< tip = foot - scale * curvature * normal */
    double curvature;
} batten_tooth;
/**
 * The teeth of a comb, from the start of the curve to its end. At a knot inside there are two:
 * the first from the left, the second from the right. So the line through the tips steps where
 * curvature does.
 *
 * @param curve  any curve
 * @param per_span  parts of each span, 1 or more
 * @param scale  length of a tooth for curvature 1, model units squared
 * @param[out] teeth [spans * (per_span + 1)] with spans = batten_curve_spans(curve, NULL) - 1
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, SINGULAR_HERE, OUT_OF_MEMORY
 *
 * Cost: one evaluation to order 3 for each tooth.
 */
BATTEN_API batten_status batten_curve_comb(const batten_curve *curve, int per_span,
                                           double scale, batten_tooth *teeth);

/** What a surface does at one point. */
typedef struct batten_surface_local {
    batten_vec3 point, normal;
    double gaussian, mean; /**< mean is positive where the surface bends towards the normal */
    double kappa1, kappa2; /**< principal curvatures, kappa1 >= kappa2 */
    batten_vec3 direction1, direction2; /**< principal directions; any at an umbilic */
} batten_surface_local;
/**
 * Point, normal, curvatures and principal directions of a surface in space.
 *
 * @param surface  any surface
 * @param u, v  parameters in the domain
 * @param[out] out  see the struct
 * @return BATTEN_OK; NOT_COMPATIBLE (dimension); as batten_surface_evaluate; SINGULAR_HERE
 * where Su and Sv do not span a plane but the normal has a limit: then `out` has the point, the
 * normal, and 0 for the rest
 *
 * Cost: one evaluation to order 2, and that of the normal.
 */
BATTEN_API batten_status batten_surface_local_at(const batten_surface *surface, double u,
                                                 double v, batten_surface_local *out);
/**
 * Gaussian and mean curvature on a grid.
 * @param surface  in space
 * @param places  the parameters, count_u of u and count_v of v
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] gaussian, mean  [count_u][count_v]; either may be NULL; singular points are NaN
 * @return BATTEN_OK, NOT_COMPATIBLE (dimension), CANCELLED, OUT_OF_MEMORY
 *
 * Cost: one evaluation to order 2 for each place; rows are shared among threads.
 */
BATTEN_API batten_status batten_surface_curvature_grid(const batten_surface *surface,
                                                       batten_uv_grid places,
                                                       const batten_job *job, double *gaussian,
                                                       double *mean);

#ifdef __cplusplus
}
#endif
#endif
