#ifndef BATTEN_INSPECT_H
#define BATTEN_INSPECT_H
/**
 * @file
 * What is true of a shape: curvature, lengths, extremes, distances from data.
 */
#include <batten/chain.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

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

/** @return BATTEN_SINGULAR_HERE where the first derivative vanishes; then `out` has the point,
 * the tangent from the first derivative that does not vanish, and 0 for the rest. In space
 * normal and binormal are 0 where the curve is straight. */
BATTEN_API batten_status batten_curve_local_at(const batten_curve *curve, double u,
                                               batten_side side, batten_curve_local *out);

/** Length over [a, b] inside the domain (all of it with NaN for both), within `tolerance`
 * (model units, above 0; one below the rounding of the numbers is met as far as they can, see
 * `error`). Gauss-Legendre on each span, halved until both halves agree with the whole.
 * @param[out] error an estimate of the error; may be NULL */
BATTEN_API batten_status batten_curve_length(const batten_curve *curve, double tolerance,
                                             double *length, double *error);
BATTEN_API batten_status batten_curve_length_between(const batten_curve *curve, double a,
                                                     double b, double tolerance, double *length,
                                                     double *error);
/** Parameters at which the arc length from the start is s[i] (never decreasing, at most
 * `tolerance` outside the length).
 * @param[out] u [count] */
BATTEN_API batten_status batten_curve_at_length(const batten_curve *curve, int count,
                                                const double *s, double tolerance, double *u);

/** The same of a chain, as batten_curve_local_at; u as the chain goes. */
BATTEN_API batten_status batten_chain_local_at(const batten_chain *chain, double u,
                                               batten_side side, batten_curve_local *out);
/** The length of a chain: exact where its spans go by arc length, else to 1e-12 of it. Of a
 * function (dimension 1) the length it rises and falls.
 * @param[out] error a bound; may be NULL */
BATTEN_API batten_status batten_chain_length(const batten_chain *chain, double *length,
                                             double *error);

/** Found parameters, increasing; release `at` with batten_release. */
typedef struct batten_parameters {
    int count;
    double *at;
} batten_parameters;

/** All inflections of a plane curve: sign changes of curvature, also those at knots and at the
 * seam of a periodic curve. Of a function (dimension 1) those of its second derivative. Sign
 * changes within the rounding of the control points are none, so a straight line has no
 * inflections. */
BATTEN_API batten_status batten_curve_inflections(const batten_curve *curve,
                                                  batten_parameters *out);
/** All local extrema of curvature (in the plane signed) inside the domain, also those at knots
 * where its rate changes sign. Of a function those of its second derivative. */
BATTEN_API batten_status batten_curve_curvature_extrema(const batten_curve *curve,
                                                        batten_parameters *out);
/** All places inside the domain where a curve turns back along a direction: so between them a
 * coordinate in that direction runs one way. Of a piece square to the direction none. The
 * length of `direction` does not matter; BAD_ARGUMENT when it is 0 or not finite. Complete but
 * for turns within the rounding of the control points, by Descartes' rule of signs. */
BATTEN_API batten_status batten_curve_turns(const batten_curve *curve, batten_vec3 direction,
                                            batten_parameters *out);
/** All places where curvature is 0 to rounding, the inflections among them, and of a straight
 * piece its ends. */
BATTEN_API batten_status batten_curve_flat_points(const batten_curve *curve,
                                                  batten_parameters *out);
/** All places where the first derivative is 0: its square within the rounding of the span, so a
 * speed below some 1e-8 of the largest there is 0. Cusps are among them. */
BATTEN_API batten_status batten_curve_standstills(const batten_curve *curve,
                                                  batten_parameters *out);
/** All u at which coordinate `axis` (0, 1, 2) equals `value`, by roots of the Bernstein form.
 * A coordinate that is constant on a piece gives both ends of the piece. */
BATTEN_API batten_status batten_curve_crossings(const batten_curve *curve, int axis,
                                                double value, batten_parameters *out);

/** All u at which a curve of 2 or 3 dimensions meets the plane `normal . x = offset`, in the
 * same way. @return also BAD_ARGUMENT for a normal of 0, UNSUPPORTED for a function */
BATTEN_API batten_status batten_curve_plane_crossings(const batten_curve *curve,
                                                      batten_vec3 normal, double offset,
                                                      batten_parameters *out);

/** Where a plane curve crosses itself: parameters in pairs u < v, so `at` is [count / 2][2].
 * Places where it touches itself, or runs along itself, may be left out; the point in which a
 * closed curve ends is none. */
BATTEN_API batten_status batten_curve_self_crossings(const batten_curve *curve,
                                                     batten_parameters *out);

/** One tooth of a curvature comb. */
typedef struct batten_tooth {
    double u;
    batten_vec3 foot, tip; /**< tip = foot - scale * curvature * normal */
    double curvature;
} batten_tooth;
/**
 * The teeth of a comb, from the beginning of the curve to its end. At a knot inside there are
 * two: the first from the left, the second from the right. So the line through the tips steps
 * where curvature does.
 *
 * @param per_span parts of each span
 * @param[out] teeth [spans * (per_span + 1)] with spans = batten_curve_spans(curve, NULL) - 1
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
/** @return BATTEN_SINGULAR_HERE where Su and Sv do not span a plane but the normal has a limit;
 * then `out` has the point, the normal, and 0 for the rest. */
BATTEN_API batten_status batten_surface_local_at(const batten_surface *surface, double u,
                                                 double v, batten_surface_local *out);
/** Gaussian and mean curvature on a grid. @param[out] gaussian, mean [count_u][count_v]; either
 * may be NULL; singular points are NaN. */
BATTEN_API batten_status batten_surface_curvature_grid(const batten_surface *surface,
                                                       size_t count_u, const double *u,
                                                       size_t count_v, const double *v,
                                                       const batten_job *job, double *gaussian,
                                                       double *mean);

/** How far points lie from a shape. */
typedef struct batten_deviation {
    double max, rms;
    int worst;    /**< index of the farthest point */
    double at[2]; /**< its foot's parameters */
} batten_deviation;
/** Distance of points [count][dimension] from a curve: the global minimum, ends included. Every
 * root of (C - Q) . C' is found on each span whose box comes near enough. Cost: n to begin,
 * then log n for each point that is near few of the n spans.
 * @param start [count] first guesses, or NULL: the whole curve is searched
 * @param[out] distances [count], or NULL */
BATTEN_API batten_status batten_curve_deviation(const batten_curve *curve, int count,
                                                const double *points, const double *start,
                                                const batten_job *job, double *distances,
                                                batten_deviation *out);
/** The same for a surface, points [count][3]; start [count][2] or NULL. Descends from every
 * valley of a grid of 2 degree + 2 samples each way on each patch whose box comes near enough,
 * inside the patch first: where the surface winds between samples, a nearer point can be
 * missed. */
BATTEN_API batten_status batten_surface_deviation(const batten_surface *surface, int count,
                                                  const double *points, const double *start,
                                                  const batten_job *job, double *distances,
                                                  batten_deviation *out);

/** The same, and where the feet are. @param[out] uv [count][2], their parameters, or NULL */
BATTEN_API batten_status batten_surface_project(const batten_surface *surface, int count,
                                                const double *points, const double *start,
                                                const batten_job *job, double *uv,
                                                double *distances, batten_deviation *out);

/** A polyline in space. */
typedef struct batten_polyline {
    int count;
    bool closed;
    double *points;     /**< [count][3] */
    double *parameters; /**< [count][2], u and v on the surface */
} batten_polyline;
typedef struct batten_polylines {
    int count;
    batten_polyline *lines;
} batten_polylines;
/**
 * Where a surface meets the plane `normal . x = offset`, found along isoparametric lines on a
 * `cells_u` x `cells_v` grid (every point is on the surface, and on the plane to
 * rounding, coarser only where knots nearly coincide; loops
 * smaller than a cell can be missed). Across the seam of a closed surface a line goes on, and
 * its parameters jump. A rim of the surface that lies in the plane belongs to the section; a
 * line in its inside where the plane only touches does not.
 */
BATTEN_API batten_status batten_surface_section(const batten_surface *surface,
                                                batten_vec3 normal, double offset, int cells_u,
                                                int cells_v, batten_polylines *out);
BATTEN_API void batten_polylines_release(batten_polylines *lines);

#ifdef __cplusplus
}
#endif
#endif
