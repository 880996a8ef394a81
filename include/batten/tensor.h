#ifndef BATTEN_TENSOR_H
#define BATTEN_TENSOR_H
/**
 * @file
 * Surfaces through a grid of points, as the tensor product of two methods for curves: what a
 * method does with points it does first with every line of the grid, then with what came of
 * them. For methods that are linear: cubic splines, nu-splines, splines in tension, those of
 * the class of Catmull and Rom, Bessel's, and any of the user's own.
 *
 * S(u, v) = sum P[i][j] L_i(u) M_j(v), where L_i is the curve of the method through the values
 * 0, but 1 at i. So the surface passes through the points when the methods do, is as smooth
 * along u as the one and along v as the other, and is the same whichever direction comes first.
 */
#include <batten/catmull_rom.h>
#include <batten/interpolate.h>
#include <batten/job.h>
#include <batten/polygon.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A method for curves: points [count][dimension], at increasing parameters [count] (closed:
 * [count + 1]). Knots, degree and number of control points must depend on the parameters alone,
 * control points linearly on the points. */
typedef struct batten_line_method {
    batten_status (*make)(void *user, int dimension, int count, const double *points,
                          const double *parameters, batten_curve **out);
    void *user;
    bool closed; /**< the first point follows the last */
} batten_line_method;

/**
 * Parameters for the lines of a grid: in each direction from 0 to 1, the average of those that
 * its lines would have alone; lines that are a single point are left out.
 *
 * @param points [count_u][count_v][dimension]
 * @param closed_u, closed_v  also give the step from the last line back to the first
 * @param[out] u, v [count_u], [count_v]; closed: one more
 * @param[out] spread [2] the largest |own - average| of a line of points, in steps, in u and in
 * v; above 0.5 skinning is better; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT naming the two lines
 * Source: [PT97] 9.2.5.
 */
BATTEN_API batten_status batten_grid_parametrize(int dimension, int count_u, int count_v,
                                                 const double *points,
                                                 batten_parametrization kind, bool closed_u,
                                                 bool closed_v, double *u, double *v,
                                                 double *spread);

/**
 * The tensor product of two methods.
 *
 * @param points [count_u][count_v][dimension], finite
 * @param u, v   parameters of the grid lines, increasing; closed: one more
 * @param[out] off  the largest distance of a point from the surface at its parameters; may be
 * NULL
 * @return BATTEN_OK, what the methods report (naming the line), NOT_COMPATIBLE when the curves
 * of a method have different knots, UNSUPPORTED when they are rational, TOO_LARGE ... Cost:
 * count_v times the method along u, and for each control point that this gives once the method
 * along v. Source: [deBoor01] ch. XVII.
 */
BATTEN_API batten_status batten_surface_tensor(
    int dimension, int count_u, int count_v, const double *points, const double *u,
    const double *v, const batten_line_method *along_u, const batten_line_method *along_v,
    const batten_job *job, double *off, batten_surface **out);

/** Nu-splines in both directions: bicubics that are drawn into chosen grid lines. */
typedef struct batten_nu_surface_options {
    size_t size;
    bool closed_u, closed_v;
    double nu_u, nu_v;   /**< of all lines, as nu of batten_weighted_options; 0 */
    const double *nus_u; /**< [count_u] line by line, instead; or NULL */
    const double *nus_v; /**< [count_v] */
    const double *u, *v; /**< parameters of the grid lines; NULL: chord lengths, averaged */
} batten_nu_surface_options;
BATTEN_API batten_nu_surface_options batten_nu_surface_defaults(void);

/** The tensor product of nu-splines with natural ends: a bicubic surface, C1. Without nu the
 * natural bicubic spline, C2. @return as batten_surface_tensor. Source: [Nielson74]. */
BATTEN_API batten_status batten_surface_nu(int dimension, int count_u, int count_v,
                                           const double *points,
                                           const batten_nu_surface_options *options,
                                           const batten_job *job, batten_surface **out);

/**
 * The tensor product of curves of the class of Catmull and Rom: local, no equations.
 * @param u, v  parameters of the grid lines; NULL: centripetal, averaged
 * @param along_u, along_v  their alpha and `given` are not used
 * @param[out] off  the largest distance of a point from the surface; 0 but for rounding when
 * both pass their points; may be NULL
 * @return as batten_surface_tensor. Source: [CR74].
 */
BATTEN_API batten_status batten_surface_catmull_rom(int dimension, int count_u, int count_v,
                                                    const double *points, const double *u,
                                                    const double *v,
                                                    const batten_catmull_rom_options *along_u,
                                                    const batten_catmull_rom_options *along_v,
                                                    const batten_job *job, double *off,
                                                    batten_surface **out);

/** The uniform B-spline surface of a net, with the ends of batten_curve_uniform in each
 * direction.
 * @param points [count_u][count_v][dimension] @return as batten_surface_tensor and
 * batten_curve_uniform. Source: [Coons74], [Riesenfeld73]. */
BATTEN_API batten_status batten_surface_uniform(int dimension, int count_u, int count_v,
                                                const double *points, int degree_u,
                                                int degree_v, batten_polygon_end ends_u,
                                                batten_polygon_end ends_v,
                                                batten_surface **out);

/** Splines in tension in both directions. */
typedef struct batten_tension_surface_options {
    size_t size;
    bool closed_u, closed_v;
    double tension_u, tension_v; /**< of all strips, as in batten_tension_options; 0 */
    const double *tensions_u;    /**< [strips along u] strip by strip, instead; or NULL */
    const double *tensions_v;
    const double *u, *v; /**< parameters of the grid lines; NULL: chord lengths */
} batten_tension_surface_options;
BATTEN_API batten_tension_surface_options batten_tension_surface_defaults(void);

/**
 * The tensor product of splines in tension with natural ends: C2, of the kind "tension".
 * Without tension it is the natural bicubic spline; with very much tension bilinear patches.
 * Between the lines of the grid each strip has its own tension, so that single folds can be
 * drawn tight.
 *
 * It is no NURBS; batten_surface_to_nurbs comes near it.
 * @return BATTEN_OK, and as batten_chain_tension, naming the line
 * Cost: linear in the number of points; a point of the surface 16 products for each coordinate.
 * Source: [Schweikert66], [Cline74].
 */
BATTEN_API batten_status batten_surface_tension(int dimension, int count_u, int count_v,
                                                const double *points,
                                                const batten_tension_surface_options *options,
                                                batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
