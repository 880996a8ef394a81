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
 * The control points of a NURBS surface are P[i][j], i along u, j along v, j fastest: points[(i
 * * count_v + j) * dimension + k]. Degrees p, q; knots U [count_u + p + 1], V [count_v + q +
 * 1]; domain [U[p], U[count_u]] x [V[q], V[count_v]].
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_surface batten_surface;

/** The two parameter directions. */
typedef enum batten_direction { BATTEN_U, BATTEN_V } batten_direction;

/** Some surfaces, yours to release. */
typedef struct batten_surfaces {
    int count;
    batten_surface **at;
} batten_surfaces;
/** Give the references of all surfaces back and release the row. */
BATTEN_API void batten_surfaces_release(batten_surfaces *surfaces);

/** A row of surfaces, borrowed for the call. */
typedef struct batten_surface_row {
    int count;
    const batten_surface *const *at;
} batten_surface_row;

/** A knot line and how many times of it. */
typedef struct batten_knot_line {
    batten_direction direction;
    double at; /**< equal to the knot */
    int times;
} batten_knot_line;

/** From which sides a surface is seen at its knot lines. */
typedef struct batten_sides {
    batten_side u, v;
} batten_sides;

/** Parameters of a grid on a surface, borrowed for the call. */
typedef struct batten_uv_grid {
    size_t count_u, count_v;
    const double *u; /**< [count_u] */
    const double *v; /**< [count_v] */
} batten_uv_grid;

/** How many values a derivative table of this order has: 1, 3, 6, 10 ... */
#define BATTEN_SURFACE_DERIVATIVES(order) (((order) + 1) * ((order) + 2) / 2)
/** Where the derivative k times in u and l times in v stands: S; Su, Sv; Suu, Suv, Svv; ... */
#define BATTEN_SURFACE_DERIVATIVE(k, l) (((k) + (l)) * ((k) + (l) + 1) / 2 + (l))

/* ---- making, keeping ---- */

/**
 * Make a NURBS surface from its control points and knots; the arrays are copied. Rules as for
 * batten_curve_create, in each direction.
 * @param dimension  d, 1..3
 * @param u, v  degree, number of points and knots of each direction, and whether it is periodic
 * @param points  [count_u][count_v][d], finite
 * @param weights  [count_u][count_v], finite and positive; NULL for a polynomial surface
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, BAD_DEGREE, BAD_KNOTS, BAD_WEIGHT,
 * BAD_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_create(int dimension, const batten_axis *u,
                                               const batten_axis *v, const double *points,
                                               const double *weights, batten_surface **out);
/** One more reference to a surface, from borrowed to yours. */
BATTEN_API batten_surface *batten_surface_ref(const batten_surface *surface);
/** Give a reference to a surface back; NULL is welcome. */
BATTEN_API void batten_surface_unref(batten_surface *surface);

/* ---- properties of any surface ---- */

/**
 * "nurbs", "coons", "gregory" ...
 *
 * @param surface  any surface
 */
BATTEN_API const char *batten_surface_kind(const batten_surface *surface);
/**
 * The number of coordinates of its points, 1 to 3.
 *
 * @param surface  any surface
 */
BATTEN_API int batten_surface_dimension(const batten_surface *surface);
/**
 * The closed interval of valid parameters in one direction.
 *
 * @param surface  any surface
 */
BATTEN_API batten_interval batten_surface_domain(const batten_surface *surface,
                                                 batten_direction direction);
/** The lines across which the surface is not smooth, and both ends of the domain: distinct
 * knots.
 * @param direction  u or v
 * @param[out] knots NULL to count.
 * @return how many */
BATTEN_API int batten_surface_spans(const batten_surface *surface, batten_direction direction,
                                    double *knots);
/**
 * Whether both rims across a direction are one curve, within `tolerance`, model units.
 *
 * @param surface  any surface
 */
BATTEN_API bool batten_surface_is_closed(const batten_surface *surface,
                                         batten_direction direction, double tolerance);
/** The box of the control points, which holds the surface; of a formula the box of samples,
 * with room for what lies between them: near, but not proved. */
BATTEN_API batten_box batten_surface_box(const batten_surface *surface);
/**
 * An equal NURBS surface, exact where mathematics allows it, else within `tolerance`.
 * @param surface  any surface
 * @param tolerance  model units, above 0 where the surface is not exactly NURBS
 * @param[out] error the deviation, 0 when exact; may be NULL
 * @param[out] out  the surface itself when it is a NURBS surface
 * @return BATTEN_OK; TOLERANCE_NOT_MET, TOO_LARGE and what the kind of surface refuses;
 * OUT_OF_MEMORY
 *
 * Cost: nothing for a NURBS surface; linear in the control points where the kind is exact; else
 * the patches are divided until samples are within the tolerance.
 */
BATTEN_API batten_status batten_surface_to_nurbs(const batten_surface *surface,
                                                 double tolerance, double *error,
                                                 batten_surface **out);

/* ---- properties of a NURBS surface (a caller's error for other kinds) ---- */

/**
 * The degree in one direction, 1 to 25.
 *
 * @param surface  any surface
 */
BATTEN_API int batten_surface_degree(const batten_surface *surface, batten_direction direction);
/**
 * How many control points there are in one direction; periodic: those of the wrapped form, m + p.
 *
 * @param surface  any surface
 */
BATTEN_API int batten_surface_point_count(const batten_surface *surface,
                                          batten_direction direction);
/**
 * How many knots there are in one direction, each as often as its multiplicity.
 *
 * @param surface  any surface
 */
BATTEN_API int batten_surface_knot_count(const batten_surface *surface,
                                         batten_direction direction);
/**
 * The knots of one direction; borrowed.
 *
 * @param surface  any surface
 */
BATTEN_API const double *batten_surface_knots(const batten_surface *surface,
                                              batten_direction direction);
/**
 * The control points, [count_u][count_v][dimension], never premultiplied by weights; borrowed.
 *
 * @param surface  any surface
 */
BATTEN_API const double *batten_surface_points(const batten_surface *surface);
/** The weights, [count_u][count_v], or NULL of a polynomial surface; borrowed. */
BATTEN_API const double *batten_surface_weights(const batten_surface *surface);
/**
 * Whether it has weights.
 *
 * @param surface  any surface
 */
BATTEN_API bool batten_surface_is_rational(const batten_surface *surface);
/**
 * Whether the knots of one direction repeat.
 *
 * @param surface  any surface
 */
BATTEN_API bool batten_surface_is_periodic(const batten_surface *surface,
                                           batten_direction direction);

/* ---- evaluation ---- */

/**
 * A point and its derivatives up to the total order `order`.
 *
 * Sides, domain and errors are as for curves; a periodic direction takes any parameter. Of a
 * surface of another kind than NURBS `order` is at most 3, else BAD_ARGUMENT.
 *
 * @param surface  any surface
 * @param u, v  in their domains
 * @param order  of the highest derivative, 0 or more
 * @param[out] out  [BATTEN_SURFACE_DERIVATIVES(order)][dimension]
 * @return BATTEN_OK, OUT_OF_DOMAIN; what the kind of surface refuses; OUT_OF_MEMORY
 *
 * Cost: (p + 1)(q + 1) d multiplications for each derivative in u, (q + 1) d for each more;
 * memory is allocated above order 3 only. One call, many and grids give the same bits, on any
 * number of threads.
 * Source: [PT97] A3.6 and A4.4.
 */
BATTEN_API batten_status batten_surface_evaluate(const batten_surface *surface, double u,
                                                 double v, int order, double *out);

/**
 * A point and derivatives, seen from given sides at knot lines; as batten_surface_evaluate.
 *
 * @param surface  any surface
 * @param u, v  in the domain
 * @param sides  from which side in u and in v
 * @param order  highest derivative wanted
 * @param[out] out  as batten_surface_evaluate
 * @return BATTEN_OK, OUT_OF_DOMAIN
 *
 * Cost: as batten_surface_evaluate.
 */
BATTEN_API batten_status batten_surface_evaluate_side(const batten_surface *surface, double u,
                                                      double v, batten_sides sides, int order,
                                                      double *out);
/**
 * Many points in any order. A parameter outside the domain is found before anything is
 * written; after OVERFLOW, CANCELLED or OUT_OF_MEMORY the content of `out` is open.
 * @param surface  any surface
 * @param count  how many
 * @param uv  [count][2], in the domain
 * @param order  of the highest derivative, 0 or more
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out [count][BATTEN_SURFACE_DERIVATIVES(order)][dimension]
 * @return as batten_surface_evaluate, naming the first place that fails; CANCELLED,
 * OUT_OF_MEMORY
 *
 * Cost: as batten_surface_evaluate for each; chunks are shared among threads.
 */
BATTEN_API batten_status batten_surface_evaluate_many(const batten_surface *surface,
                                                      size_t count, const double *uv, int order,
                                                      const batten_job *job, double *out);
/**
 * All points (u[i], v[j]); u and v need not be sorted.
 * @param surface  any surface
 * @param places  the parameters, count_u of u and count_v of v
 * @param order  of the highest derivative, 0 or more
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out [count_u][count_v][BATTEN_SURFACE_DERIVATIVES(order)][dimension]
 * @return as batten_surface_evaluate, naming the first place that fails; CANCELLED,
 * OUT_OF_MEMORY
 *
 * Cost: of a NURBS surface the basis functions once for each u and each v, then (p + 1)(q + 1)
 * d multiplications for a place and less; rows are shared among threads.
 */
BATTEN_API batten_status batten_surface_evaluate_grid(const batten_surface *surface,
                                                      batten_uv_grid places, int order,
                                                      const batten_job *job, double *out);
/**
 * Unit normal Su x Sv, in space. Where that vanishes (a pole, a collapsed edge) the limit from
 * inside the domain, and `*is_limit` true; SINGULAR_HERE where no limit exists (the apex of a
 * cone, a fold). Limits along rays that differ by less than 1e-6 radians count as one.
 * @param surface  of dimension 2 or 3
 * @param u, v  parameters in the domain
 * @param is_limit  whether it is a limit only; may be NULL
 * @param[out] normal  of length 1
 * @return as batten_surface_evaluate; BAD_ARGUMENT (dimension), SINGULAR_HERE
 *
 * Cost: one evaluation to order 1; where it vanishes some dozen to higher orders.
 * Source: [PT97] 5.3 for the derivatives, [Farin02] ch. 16 for degenerate normals.
 */
BATTEN_API batten_status batten_surface_normal(const batten_surface *surface, double u,
                                               double v, bool *is_limit, batten_vec3 *normal);
/**
 * Points and unit normals on a grid.
 * @param surface  of dimension 2 or 3
 * @param places  the parameters, count_u of u and count_v of v
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] points, normals  [count_u][count_v][3], either may be NULL; a normal without a
 *              limit is (0, 0, 0)
 * @return as batten_surface_evaluate_grid; BAD_ARGUMENT (dimension)
 *
 * Cost: as batten_surface_evaluate_grid to order 1.
 */
BATTEN_API batten_status batten_surface_normal_grid(const batten_surface *surface,
                                                    batten_uv_grid places,
                                                    const batten_job *job, double *points,
                                                    double *normals);
/**
 * The curve at a fixed parameter: `direction` is the one that is fixed; the curve runs along
 * the other and keeps its knots. Of a surface of another kind than NURBS it is near, within
 * 1e-9 of its size.
 *
 * @param surface  any surface
 * @param direction  the one that is fixed
 * @param at  a parameter in the domain of that direction
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, OUT_OF_DOMAIN, NOT_FINITE, OUT_OF_MEMORY; of another kind than NURBS also
 * TOLERANCE_NOT_MET
 *
 * Cost: of a NURBS surface one point of each of its lines; of another kind a curve is fitted to
 * samples.
 */
BATTEN_API batten_status batten_surface_isocurve(const batten_surface *surface,
                                                 batten_direction direction, double at,
                                                 batten_curve **out);

/* ---- changes of NURBS surfaces: as those of curves, along one direction ----
 *
 * Where knots, degree or extent change along a periodic direction the result is clamped there;
 * reversing, swapping, mapping and moving points keep it periodic. The other direction stays as
 * it is. A reversed direction has the domain
 * [-b, -a]. */

/**
 * Insert a knot in one direction; the surface stays the same.
 *
 * @param surface  a NURBS surface
 * @param direction  u or v
 * @param at  inside the domain
 * @param times  how often, above 0
 * @param[out] out  the result, one reference, which is yours
 * @return as batten_curve_insert_knot
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_insert_knot(const batten_surface *surface,
                                                    batten_direction direction, double at,
                                                    int times, batten_surface **out);

/**
 * Insert knots in one direction; the surface stays the same.
 *
 * @param surface  a NURBS surface
 * @param direction  u or v
 * @param count  of the knots
 * @param knots  [count], never decreasing, inside the domain
 * @param[out] out  the result, one reference, which is yours
 * @return as batten_curve_refine
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_refine(const batten_surface *surface,
                                               batten_direction direction, int count,
                                               const double *knots, batten_surface **out);
/**
 * Remove a knot up to `times` times as long as the surface moves by no more than `tolerance`.
 * @param surface  a NURBS surface
 * @param knot  direction, at: a knot inside the domain, times: 0 or more
 * @param tolerance  model units, 0 or more
 * @param[out] removed  how often it could be removed; may be NULL
 * @param[out] error  a bound on how far the surface moved, model units; may be NULL
 * @return BATTEN_OK, NOT_FINITE, BAD_WEIGHT, BAD_ARGUMENT, OVERFLOW, NOT_FOUND, OUT_OF_MEMORY
 *
 * Cost: linear in the control points; each removal solves p + 1 equations for every line.
 */
BATTEN_API batten_status batten_surface_remove_knot(const batten_surface *surface,
                                                    batten_knot_line knot, double tolerance,
                                                    int *removed, double *error,
                                                    batten_surface **out);

/**
 * Raise the degree in one direction; the surface stays the same.
 *
 * @param surface  a NURBS surface
 * @param direction  u or v
 * @param by  how much, 0 or more
 * @param[out] out  the result, one reference, which is yours
 * @return as batten_curve_elevate
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_elevate(const batten_surface *surface,
                                                batten_direction direction, int by,
                                                batten_surface **out);
/**
 * Lower the degree, moving the surface by at most `tolerance`; TOLERANCE_NOT_MET otherwise.
 *
 * @param surface  a NURBS surface
 * @param direction  u or v
 * @param degree  1 to that of the surface
 * @param tolerance  model units, 0 or more
 * @param[out] error  a bound, model units; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_DEGREE, BAD_ARGUMENT (tolerance), TOLERANCE_NOT_MET, OVERFLOW,
 * OUT_OF_MEMORY
 *
 * Cost: linear in the control points, about p^2 for each degree and point.
 */
BATTEN_API batten_status batten_surface_reduce(const batten_surface *surface,
                                               batten_direction direction, int degree,
                                               double tolerance, double *error,
                                               batten_surface **out);

/**
 * Cut at a parameter of one direction; both parts keep their parameters and are clamped there.
 *
 * @param surface  a NURBS surface
 * @param direction  u or v
 * @param at  inside the domain
 * @param[out] low, high  the parts below and above, one reference each, yours
 * @return as batten_curve_split
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_split(const batten_surface *surface,
                                              batten_direction direction, double at,
                                              batten_surface **low, batten_surface **high);

/**
 * The part over [a, b] in one direction, clamped.
 *
 * @param surface  a NURBS surface
 * @param direction  u or v
 * @param a, b  inside the domain, a < b
 * @param[out] out  the result, one reference, which is yours
 * @return as batten_curve_subrange
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_subrange(const batten_surface *surface,
                                                 batten_direction direction, double a, double b,
                                                 batten_surface **out);
/**
 * Join the end of the first in `direction` to the start of the second. Degrees, weights and
 * the knots across are made alike (both clamped, on the domain of the first across); the
 * control points of the two edges must then be within `tolerance`. The second domain is moved
 * to follow the first.
 *
 * @param first, second  NURBS surfaces of one dimension
 * @param direction  along which the second follows
 * @param tolerance  model units, 0 or more
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT (tolerance), NOT_COMPATIBLE (dimensions, or the gap),
 * BAD_KNOTS, TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points of both, after degrees and knots are made common.
 */
BATTEN_API batten_status batten_surface_join(const batten_surface *first,
                                             const batten_surface *second,
                                             batten_direction direction, double tolerance,
                                             batten_surface **out);

/**
 * The same surface with one parameter reversed; the domain stays.
 *
 * @param surface  a NURBS surface
 * @param direction  u or v
 * @param[out] out  the result, one reference, which is yours
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_reverse(const batten_surface *surface,
                                                batten_direction direction,
                                                batten_surface **out);

/**
 * The same surface with u and v exchanged: its normal turns round.
 *
 * @param surface  a NURBS surface
 * @param[out] out  the result, one reference, which is yours
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_swap(const batten_surface *surface,
                                             batten_surface **out);

/**
 * The same surface over another interval in one direction.
 *
 * @param surface  a NURBS surface
 * @param direction  u or v
 * @param a, b  the new domain, a < b
 * @param[out] out  the result, one reference, which is yours
 * @return as batten_curve_set_domain
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_set_domain(const batten_surface *surface,
                                                   batten_direction direction, double a,
                                                   double b, batten_surface **out);

/**
 * The clamped form in one direction; the surface stays the same.
 *
 * @param surface  a NURBS surface
 * @param direction  u or v
 * @param[out] out  the result, one reference, which is yours
 * @return as batten_curve_clamp
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_clamp(const batten_surface *surface,
                                              batten_direction direction, batten_surface **out);

/**
 * The same surface with weights, all 1 where it had none.
 *
 * @param surface  a NURBS surface
 * @param[out] out  the result, one reference, which is yours
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_to_rational(const batten_surface *surface,
                                                    batten_surface **out);

/**
 * The same surface with every knot as often as the degree.
 *
 * @param surface  a NURBS surface
 * @param[out] out  the result, one reference, which is yours
 * @return as batten_curve_to_bezier
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_to_bezier(const batten_surface *surface,
                                                  batten_surface **out);

/**
 * The same surface with one control point moved.
 *
 * @param surface  a NURBS surface
 * @param i, j  index of the control point in u and v
 * @param point  [dimension], its new place
 * @param[out] out  the result, one reference, which is yours
 * @return as batten_curve_with_point
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_with_point(const batten_surface *surface, int i, int j,
                                                   const double *point, batten_surface **out);
/**
 * The image, at the same parameters: under a map that mirrors, Su x Sv is on the other side.
 *
 * @param surface  any surface
 * @param map  finite, else NOT_FINITE
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE (the map), OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points; a surface of another kind keeps the map.
 */
BATTEN_API batten_status batten_surface_transform(const batten_surface *surface,
                                                  const batten_affine *map,
                                                  batten_surface **out);
/**
 * The image as the skin of something, whose outside stays outside: under a map that mirrors
 * space, u also runs the other way, from b to a, over the same domain [a, b] (over [-b, -a] if
 * its knots could not be told apart there). Of any kind; surfaces of dimension 1 and 2 have no
 * sides, and are taken as they are.
 *
 * @param surface  any surface
 * @param map  finite, else NOT_FINITE
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_surface_transform
 *
 * Cost: as batten_surface_transform.
 */
BATTEN_API batten_status batten_surface_transform_sides(const batten_surface *surface,
                                                        const batten_affine *map,
                                                        batten_surface **out);

/* ---- other forms ---- */

/**
 * From Bezier patches that share their edges.
 *
 * @param dimension  d, 1..3
 * @param pieces_u  degree p, number mu and breaks [mu + 1] along u
 * @param pieces_v  degree q, number mv and breaks [mv + 1] along v
 * @param points  [mu * p + 1][mv * q + 1][d]
 * @param weights  [mu * p + 1][mv * q + 1], positive, or NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_DEGREE, BAD_KNOTS,
 * BAD_WEIGHT, BAD_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the points.
 */
BATTEN_API batten_status batten_surface_from_bezier(int dimension, batten_pieces pieces_u,
                                                    batten_pieces pieces_v,
                                                    const double *points, const double *weights,
                                                    batten_surface **out);
/**
 * Bicubic Hermite (Ferguson) net: at each node S, Su, Sv, Suv.
 * @param[out] parameters  u [count_u], v [count_v], increasing
 * @param values  [count_u][count_v][4][dimension]: S, Su, Sv, Suv
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_DEGREE, BAD_KNOTS,
 * BAD_WEIGHT, BAD_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the nodes.
 */
BATTEN_API batten_status batten_surface_from_hermite(batten_uv parameters, batten_grid values,
                                                     batten_surface **out);
/**
 * From pieces in powers of (u - breaks_u[i]), (v - breaks_v[j]).
 * @param dimension  d, 1..3
 * @param pieces_u  degree, number and breaks along u
 * @param pieces_v  the same along v
 * @param coefficients  [mu][mv][p + 1][q + 1][d], constant term first
 * @param tolerance  model units, 0 or more: how far pieces may be apart at their edges
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_DEGREE, BAD_KNOTS,
 * BAD_WEIGHT, BAD_ARGUMENT, NOT_COMPATIBLE, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the pieces, p q (p + q) for each.
 */
BATTEN_API batten_status batten_surface_from_power(int dimension, batten_pieces pieces_u,
                                                   batten_pieces pieces_v,
                                                   const double *coefficients, double tolerance,
                                                   batten_surface **out);

/**
 * The coefficients of the powers of each patch, as batten_surface_from_power takes them.
 *
 * @param surface  a polynomial NURBS surface
 * @param[out] coefficients  [patches_u][patches_v][degree_u + 1][degree_v + 1][dimension]
 * @return BATTEN_OK; UNSUPPORTED for a rational surface
 *
 * Cost: linear in the patches.
 */
BATTEN_API batten_status batten_surface_to_power(const batten_surface *surface,
                                                 double *coefficients);

#ifdef __cplusplus
}
#endif
#endif
