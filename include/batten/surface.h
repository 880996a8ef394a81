#ifndef BATTEN_SURFACE_H
#define BATTEN_SURFACE_H
/**
 * @file
 * A surface: immutable, reference counted, seen through one evaluator whatever its kind.
 *
 * The main kind is the tensor-product NURBS surface. Others are formulas: Coons patches,
 * Gregory patches, surfaces over triangles and many-sided holes, procedural skins and sweeps.
 * They answer the calls for any surface, with derivatives up to order 3;
 * batten_surface_to_nurbs gives the equal or near NURBS surface, which the changes need.
 *
 * The control points of a NURBS surface are P[i][j], i along u, j along v, j fastest:
 * points[(i * count_v + j) * dimension + k]. Degrees p, q; knots U [count_u + p + 1],
 * V [count_v + q + 1]; domain [U[p], U[count_u]] x [V[q], V[count_v]].
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_surface batten_surface;

/** The two parameter directions. */
typedef enum batten_direction { BATTEN_U, BATTEN_V } batten_direction;

/** One direction of a tensor-product surface, for batten_surface_create. */
typedef struct batten_axis {
    int degree;
    int point_count;
    const double
        *knots; /**< [point_count + degree + 1]; periodic: one period, [point_count + 1] */
    bool periodic;
} batten_axis;

/** How many values a derivative table of this order has: 1, 3, 6, 10 ... */
#define BATTEN_SURFACE_DERIVATIVES(order) (((order) + 1) * ((order) + 2) / 2)
/** Where the derivative k times in u and l times in v stands: S; Su, Sv; Suu, Suv, Svv; ... */
#define BATTEN_SURFACE_DERIVATIVE(k, l) (((k) + (l)) * ((k) + (l) + 1) / 2 + (l))

/* ---- making, keeping ---- */

/** @param points [count_u][count_v][dimension]; @param weights [count_u][count_v] or NULL.
 * Rules and errors as for batten_curve_create, in each direction. */
BATTEN_API batten_status batten_surface_create(int dimension, const batten_axis *u,
                                               const batten_axis *v, const double *points,
                                               const double *weights, batten_surface **out);
BATTEN_API batten_surface *batten_surface_ref(const batten_surface *surface);
BATTEN_API void batten_surface_unref(batten_surface *surface);

/* ---- properties of any surface ---- */

/** "nurbs", "coons", "gregory" ... */
BATTEN_API const char *batten_surface_kind(const batten_surface *surface);
BATTEN_API int batten_surface_dimension(const batten_surface *surface);
BATTEN_API batten_interval batten_surface_domain(const batten_surface *surface,
                                                 batten_direction direction);
/** The lines across which the surface is not smooth, and both ends of the domain: distinct
 * knots.
 * @param[out] knots NULL to count. @return how many */
BATTEN_API int batten_surface_spans(const batten_surface *surface, batten_direction direction,
                                    double *knots);
BATTEN_API bool batten_surface_is_closed(const batten_surface *surface,
                                         batten_direction direction, double tolerance);
/** The box of the control points, which holds the surface; of a formula the box of samples,
 * with room for what lies between them: near, but not proved. */
BATTEN_API batten_box batten_surface_box(const batten_surface *surface);
/** An equal NURBS surface, exact where mathematics allows it, else within `tolerance`.
 * @param[out] error the deviation, 0 when exact; may be NULL */
BATTEN_API batten_status batten_surface_to_nurbs(const batten_surface *surface,
                                                 double tolerance, batten_surface **out,
                                                 double *error);

/* ---- properties of a NURBS surface (a caller's error for other kinds) ---- */

BATTEN_API int batten_surface_degree(const batten_surface *surface, batten_direction direction);
BATTEN_API int batten_surface_point_count(const batten_surface *surface,
                                          batten_direction direction);
BATTEN_API int batten_surface_knot_count(const batten_surface *surface,
                                         batten_direction direction);
BATTEN_API const double *batten_surface_knots(const batten_surface *surface,
                                              batten_direction direction);
BATTEN_API const double *batten_surface_points(const batten_surface *surface);
BATTEN_API const double *batten_surface_weights(const batten_surface *surface);
BATTEN_API bool batten_surface_is_rational(const batten_surface *surface);
BATTEN_API bool batten_surface_is_periodic(const batten_surface *surface,
                                           batten_direction direction);

/* ---- evaluation ---- */

/**
 * A point and its derivatives up to the total order `order`.
 * @param[out] out [BATTEN_SURFACE_DERIVATIVES(order)][dimension]
 * Sides, domain and errors as for curves; a periodic direction takes any parameter. Of a
 * surface that is no NURBS `order` is at most 3, else BAD_ARGUMENT.
 *
 * Cost: (p + 1)(q + 1) d multiplications for each derivative in u, (q + 1) d for each more;
 * memory is allocated above order 3 only. One call, many and grids give the same bits, on any
 * number of threads. Source: [PT97] A3.6 and A4.4.
 */
BATTEN_API batten_status batten_surface_evaluate(const batten_surface *surface, double u,
                                                 double v, int order, double *out);
BATTEN_API batten_status batten_surface_evaluate_side(const batten_surface *surface, double u,
                                                      double v, batten_side side_u,
                                                      batten_side side_v, int order,
                                                      double *out);
/** Many points in any order. A parameter outside the domain is found before anything is
 * written; after OVERFLOW, CANCELLED or OUT_OF_MEMORY the content of `out` is open. @param uv
 * [count][2]
 * @param[out] out [count][BATTEN_SURFACE_DERIVATIVES(order)][dimension] */
BATTEN_API batten_status batten_surface_evaluate_many(const batten_surface *surface,
                                                      size_t count, const double *uv, int order,
                                                      const batten_job *job, double *out);
/** All points (u[i], v[j]); u and v need not be sorted.
 * @param[out] out [count_u][count_v][BATTEN_SURFACE_DERIVATIVES(order)][dimension] */
BATTEN_API batten_status batten_surface_evaluate_grid(const batten_surface *surface,
                                                      size_t count_u, const double *u,
                                                      size_t count_v, const double *v,
                                                      int order, const batten_job *job,
                                                      double *out);
/**
 * Unit normal Su x Sv, in space. Where that vanishes (a pole, a collapsed edge) the limit from
 * inside the domain, and `*is_limit` true; SINGULAR_HERE where no limit exists (the apex of a
 * cone, a fold). Limits along rays that differ by less than 1e-6 radians count as one.
 * @param is_limit may be NULL
 * Source: [PT97] 5.3 for the derivatives, [Farin02] ch. 16 for degenerate normals.
 */
BATTEN_API batten_status batten_surface_normal(const batten_surface *surface, double u,
                                               double v, batten_vec3 *normal, bool *is_limit);
/** Points and unit normals on a grid; @param[out] points, normals [count_u][count_v][3], either
 * may be NULL; a normal without a limit is (0, 0, 0). */
BATTEN_API batten_status batten_surface_normal_grid(const batten_surface *surface,
                                                    size_t count_u, const double *u,
                                                    size_t count_v, const double *v,
                                                    const batten_job *job, double *points,
                                                    double *normals);
/** The curve at a fixed parameter: `direction` is the one that is fixed; the curve runs along
 * the other and keeps its knots. Of a surface that is no NURBS it is near, within 1e-9 of its
 * size. */
BATTEN_API batten_status batten_surface_isocurve(const batten_surface *surface,
                                                 batten_direction direction, double at,
                                                 batten_curve **out);

/* ---- changes of NURBS surfaces: as those of curves, along one direction ----
 *
 * Where knots, degree or extent change along a periodic direction the result is clamped there;
 * reversing, swapping, mapping and moving points keep it periodic. The other direction stays as
 * it is. A reversed direction has the domain
 * [-b, -a]. */

BATTEN_API batten_status batten_surface_insert_knot(const batten_surface *surface,
                                                    batten_direction direction, double at,
                                                    int times, batten_surface **out);
BATTEN_API batten_status batten_surface_refine(const batten_surface *surface,
                                               batten_direction direction, int count,
                                               const double *knots, batten_surface **out);
/** Remove a knot up to `times` times as long as the surface moves by no more than `tolerance`.
 * @param[out] removed  how often it could be removed; may be NULL
 * @param[out] error    a bound on how far the surface moved; may be NULL */
BATTEN_API batten_status batten_surface_remove_knot(const batten_surface *surface,
                                                    batten_direction direction, double at,
                                                    int times, double tolerance, int *removed,
                                                    double *error, batten_surface **out);
BATTEN_API batten_status batten_surface_elevate(const batten_surface *surface,
                                                batten_direction direction, int by,
                                                batten_surface **out);
/** Lower the degree, moving the surface by at most `tolerance`; TOLERANCE_NOT_MET otherwise. */
BATTEN_API batten_status batten_surface_reduce(const batten_surface *surface,
                                               batten_direction direction, int degree,
                                               double tolerance, double *error,
                                               batten_surface **out);
BATTEN_API batten_status batten_surface_split(const batten_surface *surface,
                                              batten_direction direction, double at,
                                              batten_surface **low, batten_surface **high);
BATTEN_API batten_status batten_surface_subrange(const batten_surface *surface,
                                                 batten_direction direction, double a, double b,
                                                 batten_surface **out);
/** Join the end of the first in `direction` to the start of the second. Degrees, weights and
 * the knots across are made alike (both clamped, on the domain of the first across); the
 * control points of the two edges must then be within `tolerance`. The second domain is moved
 * to follow the first. */
BATTEN_API batten_status batten_surface_join(const batten_surface *first,
                                             const batten_surface *second,
                                             batten_direction direction, double tolerance,
                                             batten_surface **out);
BATTEN_API batten_status batten_surface_reverse(const batten_surface *surface,
                                                batten_direction direction,
                                                batten_surface **out);
BATTEN_API batten_status batten_surface_swap(const batten_surface *surface,
                                             batten_surface **out);
BATTEN_API batten_status batten_surface_set_domain(const batten_surface *surface,
                                                   batten_direction direction, double a,
                                                   double b, batten_surface **out);
BATTEN_API batten_status batten_surface_clamp(const batten_surface *surface,
                                              batten_direction direction, batten_surface **out);
BATTEN_API batten_status batten_surface_to_rational(const batten_surface *surface,
                                                    batten_surface **out);
BATTEN_API batten_status batten_surface_to_bezier(const batten_surface *surface,
                                                  batten_surface **out);
BATTEN_API batten_status batten_surface_with_point(const batten_surface *surface, int i, int j,
                                                   const double *point, batten_surface **out);
/** The image, at the same parameters: under a map that mirrors, Su x Sv is on the other side.
 */
BATTEN_API batten_status batten_surface_transform(const batten_surface *surface,
                                                  const batten_affine *map,
                                                  batten_surface **out);
/** The image as the skin of something, whose outside stays outside: under a map that mirrors
 * space, u also runs the other way, from b to a, over the same domain [a, b] (over [-b, -a] if
 * its knots could not be told apart there). Of any kind; surfaces of dimension 1 and 2 have no
 * sides, and are taken as they are. */
BATTEN_API batten_status batten_surface_transform_sides(const batten_surface *surface,
                                                        const batten_affine *map,
                                                        batten_surface **out);

/* ---- other forms ---- */

/** From Bezier patches that share their edges: points [mu * p + 1][mv * q + 1][dimension],
 * breaks_u [mu + 1], breaks_v [mv + 1]; weights the same or NULL. */
BATTEN_API batten_status batten_surface_from_bezier(int dimension, int degree_u, int patches_u,
                                                    const double *breaks_u, int degree_v,
                                                    int patches_v, const double *breaks_v,
                                                    const double *points, const double *weights,
                                                    batten_surface **out);
/** Bicubic Hermite (Ferguson) net: at each node S, Su, Sv, Suv.
 * @param values [count_u][count_v][4][dimension] */
BATTEN_API batten_status batten_surface_from_hermite(int dimension, int count_u,
                                                     const double *u, int count_v,
                                                     const double *v, const double *values,
                                                     batten_surface **out);
/** From pieces in powers of (u - breaks_u[i]), (v - breaks_v[j]).
 * @param coefficients [mu][mv][p + 1][q + 1][dimension] */
BATTEN_API batten_status batten_surface_from_power(int dimension, int degree_u, int patches_u,
                                                   const double *breaks_u, int degree_v,
                                                   int patches_v, const double *breaks_v,
                                                   const double *coefficients, double tolerance,
                                                   batten_surface **out);
BATTEN_API batten_status batten_surface_to_power(const batten_surface *surface,
                                                 double *coefficients);

#ifdef __cplusplus
}
#endif
#endif
