#ifndef BATTEN_TRIANGLES_H
#define BATTEN_TRIANGLES_H
/**
 * @file
 * Bezier triangles: sets of triangular patches of one degree, immutable and reference counted.
 *
 * A patch of degree n has (n + 1)(n + 2) / 2 control points c[i][j][k], i + j + k = n, and is
 * their sum weighted with n! / (i! j! k!) b0^i b1^j b2^k, b the barycentric coordinates. The
 * points stand in rows away from corner 0: first c[n][0][0], then c[n-1][1][0], c[n-1][0][1],
 * then c[n-2][2][0], c[n-2][1][1] ...; the last row is the edge from corner 1 to corner 2. Edge
 * e is opposite corner e and runs from corner e + 1 to corner e + 2, modulo 3. With weights the
 * patch is rational.
 *
 * A set may lie over a triangulation of the plane, then it is a piecewise function of (x, y),
 * or a piecewise surface with (x, y) as parameters.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_triangles batten_triangles;

/** How many control points a triangle of this degree has. */
#define BATTEN_TRIANGLE_POINTS(degree) (((degree) + 1) * ((degree) + 2) / 2)
/** Where c[i][j][k] stands, whatever the degree. */
#define BATTEN_TRIANGLE_POINT(j, k) (((j) + (k)) * ((j) + (k) + 1) / 2 + (k))

/** A triangulation of a part of the plane; corners go round counterclockwise. */
typedef struct batten_triangulation {
    int vertex_count;
    const double *vertices; /**< [vertex_count][2] */
    const int *corners;     /**< [triangle count][3], indices of vertices */
} batten_triangulation;

/** What a set of triangles is made from; all of it is copied. */
typedef struct batten_triangles_parts {
    int dimension, degree;
    int count;                          /**< of triangles */
    const double *points;               /**< [count][(degree + 1)(degree + 2) / 2][dimension] */
    const double *weights;              /**< one for each point, or NULL */
    const batten_triangulation *domain; /**< or NULL */
} batten_triangles_parts;

/** A side of a triangle. */
typedef struct batten_triangle_edge {
    int triangle;
    int edge; /**< 0, 1, 2 */
} batten_triangle_edge;

/** Places on triangles, borrowed for the call. */
typedef struct batten_triangle_places {
    size_t count;
    const int *triangle; /**< [count] */
    const double *at;    /**< [count][3], barycentric */
} batten_triangle_places;

/* ---- making, keeping ---- */

/**
 * Make a set from its control points; all arrays are copied.
 *
 * @param parts  dimension: 1..3
 *     degree: n, 1..25
 *     count: of triangles, at least 1
 *     points: [count][BATTEN_TRIANGLE_POINTS(n)][dimension], finite
 *     weights: [count][BATTEN_TRIANGLE_POINTS(n)], finite and positive; NULL: polynomial
 *     domain: NULL for none
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, BAD_DEGREE, NOT_FINITE, BAD_WEIGHT, TOO_LARGE;
 * SINGULAR_HERE naming a triangle of the domain that has no area, BAD_ARGUMENT one that goes
 * round clockwise or names no vertex
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_triangles_create(const batten_triangles_parts *parts,
                                                 batten_triangles **out);
/** One more reference to a set of triangles, from borrowed to yours. */
BATTEN_API batten_triangles *batten_triangles_ref(const batten_triangles *triangles);
/** Give a reference to a set of triangles back; NULL is welcome. */
BATTEN_API void batten_triangles_unref(batten_triangles *triangles);

/* ---- properties ---- */

/**
 * The number of coordinates of its points, 1 to 3.
 *
 * @param triangles  a set of Bezier triangles
 */
BATTEN_API int batten_triangles_dimension(const batten_triangles *triangles);
/**
 * The degree of all patches.
 *
 * @param triangles  a set of Bezier triangles
 */
BATTEN_API int batten_triangles_degree(const batten_triangles *triangles);
/** How many triangles there are. */
BATTEN_API int batten_triangles_count(const batten_triangles *triangles);
/**
 * Whether they have weights.
 *
 * @param triangles  a set of Bezier triangles
 */
BATTEN_API bool batten_triangles_is_rational(const batten_triangles *triangles);
/**
 * The control points, [count][(degree + 1)(degree + 2) / 2][dimension]; borrowed.
 *
 * @param triangles  a set of Bezier triangles
 */
BATTEN_API const double *batten_triangles_points(const batten_triangles *triangles);
/**
 * NULL when the set is polynomial.
 *
 * @param triangles  a set of Bezier triangles
 */
BATTEN_API const double *batten_triangles_weights(const batten_triangles *triangles);
/**
 * False when the set lies over no domain.
 *
 * @param triangles  a set of Bezier triangles
 */
BATTEN_API bool batten_triangles_domain(const batten_triangles *triangles,
                                        batten_triangulation *domain);
/**
 * Of the control points.
 *
 * @param triangles  a set of Bezier triangles
 */
BATTEN_API batten_box batten_triangles_box(const batten_triangles *triangles);

/* ---- evaluation ---- */

/**
 * A point and its derivatives in u and v up to the total order `order`, where the barycentric
 * coordinates are (1 - u - v, u, v): u leads from corner 0 to corner 1, v to corner 2.
 *
 * @param triangles  a set of Bezier triangles
 * @param triangle  its index, from 0
 * @param at  [3] barycentric coordinates; their sum is 1 within 1e-9 and none is below -1e-9:
 * what rounding puts a little outside is evaluated there
 * @param[out] out [BATTEN_SURFACE_DERIVATIVES(order)][dimension], in the order of surfaces
 * @return BATTEN_OK, OUT_OF_DOMAIN, NOT_FINITE or OVERFLOW
 *
 * Cost: n^3 / 6 convex combinations of points; memory is allocated above degree 11 only.
 * Source: [Farin86] de Casteljau's algorithm, derivatives by the blossom.
 */
BATTEN_API batten_status batten_triangles_evaluate(const batten_triangles *triangles,
                                                   int triangle, const double at[3], int order,
                                                   double *out);
/**
 * Many points in any order, with the same bits. After a failure the content of `out` is open.
 * @param triangles  a set of Bezier triangles
 * @param places  triangle: [count], indices from 0; at: [count][3], barycentric coordinates
 * @param order  of the highest derivative, 0 or more
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out  [count][BATTEN_SURFACE_DERIVATIVES(order)][dimension]
 * @return as batten_triangles_evaluate; CANCELLED
 *
 * Cost: as batten_triangles_evaluate for each; chunks of 256 are shared among threads.
 */
BATTEN_API batten_status batten_triangles_evaluate_many(const batten_triangles *triangles,
                                                        batten_triangle_places places,
                                                        int order, const batten_job *job,
                                                        double *out);
/**
 * Unit normal Su x Sv; where that vanishes (a collapsed edge) the limit, as for surfaces.
 *
 * @param triangles  of dimension 2 or 3
 * @param triangle  its index, from 0
 * @param at  barycentric coordinates [3]
 * @param[out] is_limit  whether the normal is a limit only; may be NULL
 * @param[out] normal  of length 1
 * @return as batten_triangles_evaluate; BAD_ARGUMENT (dimension), SINGULAR_HERE where there is
 * no limit
 *
 * Cost: one evaluation to order 1; where it vanishes that of a surface's normal.
 */
BATTEN_API batten_status batten_triangles_normal(const batten_triangles *triangles,
                                                 int triangle, const double at[3],
                                                 bool *is_limit, batten_vec3 *normal);
/**
 * An edge as a Bezier curve over [0, 1].
 *
 * @param triangles  a set of Bezier triangles
 * @param triangle  its index, from 0
 * @param edge  0, 1 or 2
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in the degree.
 */
BATTEN_API batten_status batten_triangles_edge(const batten_triangles *triangles, int triangle,
                                               int edge, batten_curve **out);

/* ---- changes: exact but for rounding ---- */

/**
 * The triangles under an affine map.
 *
 * The domain stays as it is. Under a map that mirrors, triangles in space are turned, so that
 * their outside stays outside: corners 1 and 2 change places, and so do the coordinates of the
 * domain.
 *
 * @param triangles  a set of Bezier triangles
 * @param map  finite, else NOT_FINITE
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_triangles_transform(const batten_triangles *triangles,
                                                    const batten_affine *map,
                                                    batten_triangles **out);
/**
 * Raise the degree by `by` >= 0.
 *
 * @param triangles  a set of Bezier triangles
 * @param by  0 or more
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_DEGREE, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the control points, for each degree.
 */
BATTEN_API batten_status batten_triangles_elevate(const batten_triangles *triangles, int by,
                                                  batten_triangles **out);
/**
 * Cut one triangle into three at an inner point: the part away from corner 0 takes its place,
 * those away from corners 1 and 2 follow at the end. BAD_ARGUMENT when the point is on an edge.
 *
 * @param triangles  a set of Bezier triangles
 * @param triangle  its index, from 0
 * @param at  barycentric coordinates [3], all above 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, SINGULAR_HERE, OUT_OF_MEMORY
 *
 * Cost: linear in the control points, for the copy; n^3 / 2 blends of points for the three
 * parts.
 */
BATTEN_API batten_status batten_triangles_split(const batten_triangles *triangles, int triangle,
                                                const double at[3], batten_triangles **out);
/**
 * Cut every triangle into four at the middles of its edges: those at corners 0, 1, 2 and the
 * inner one stand together.
 *
 * @param triangles  a set of Bezier triangles
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_LARGE, SINGULAR_HERE, OUT_OF_MEMORY
 *
 * Cost: n^3 blends of points for each triangle; over a domain n log n for n edges, which are
 * sorted.
 */
BATTEN_API batten_status batten_triangles_halve(const batten_triangles *triangles,
                                                batten_triangles **out);
/**
 * Some of the triangles.
 * @param triangles  a set of Bezier triangles
 * @param count  1 or more
 * @param which  [count], indices from 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, OUT_OF_DOMAIN, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the control points that are copied; the domain keeps all its vertices.
 */
BATTEN_API batten_status batten_triangles_select(const batten_triangles *triangles, int count,
                                                 const int *which, batten_triangles **out);
/**
 * The triangles of two sets of one dimension, first those of the first, all of the higher
 * degree; rational when one is. Over no domain. NOT_COMPATIBLE when the dimensions differ.
 *
 * @param first, second  of one dimension
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_COMPATIBLE, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the control points of the result.
 */
BATTEN_API batten_status batten_triangles_together(const batten_triangles *first,
                                                   const batten_triangles *second,
                                                   batten_triangles **out);
/**
 * The graph (x, y, f) of a polynomial set of dimension 1 over a domain; it keeps the domain.
 * BAD_ARGUMENT for others.
 *
 * @param triangles  a set of Bezier triangles
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_triangles_from_function(const batten_triangles *triangles,
                                                        batten_triangles **out);

/* ---- joining: how triangles meet is found by batten_triangles_joins ---- */

/**
 * Change the control points of one triangle next to a shared edge so that it meets another with
 * equal derivatives up to `order` in the plane of the domain. Rows 0 .. order are replaced.
 *
 * @param triangles  a set of Bezier triangles over a domain
 * @param keep, change  triangles that share two vertices of the domain
 * @param order  0..n, n the degree
 * @param[out] moved  the longest move of a control point, model units; may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT without a domain, or for a rational set; NOT_COMPATIBLE when
 * no edge is shared
 *
 * Cost: linear in the control points, for the copy; n^3 blends of points for the neighbour's
 * blossom.
 * Source: [Farin86] c'(r, j, k) = the blossom of the neighbour.
 */
BATTEN_API batten_status batten_triangles_join_smoothly(const batten_triangles *triangles,
                                                        int keep, int change, int order,
                                                        double *moved, batten_triangles **out);
/**
 * Change one triangle next to a shared edge so that both have the same tangent planes along it.
 * Its cross derivative becomes k(t) D + h(t) E, with D that of the other, E the derivative
 * along the edge, and k and h linear and right at both ends: where the tangent planes agree at
 * the two corners, the corners' tangents stay. So that this is exact the result is one degree
 * higher.
 *
 * @param triangles  polynomial, in space
 * @param kept  the triangle and the edge that stay
 * @param changed  the triangle and the edge that move; the control points of both edges agree
 *              within `tolerance`
 * @param tolerance  model units, 0 or more
 * @param[out] moved  the longest move of a control point against the elevated set, model units;
 *              may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT for a rational set or a dimension below 3; BAD_DEGREE;
 * NOT_COMPATIBLE when the edges differ or the triangles would fold back over each other;
 * SINGULAR_HERE where a corner has no tangent plane
 *
 * Cost: linear in the control points, for the elevated copy.
 * Source: [Farin02] ch. 17.
 */
BATTEN_API batten_status batten_triangles_join_tangents(const batten_triangles *triangles,
                                                        batten_triangle_edge kept,
                                                        batten_triangle_edge changed,
                                                        double tolerance, double *moved,
                                                        batten_triangles **out);

/** How two triangles meet along an edge. */
typedef struct batten_triangle_join {
    int triangle[2], edge[2];
    bool same_way; /**< both edges run the same way: the normals of one side are opposite */
    double gap;    /**< the largest distance of corresponding control points */
    double slope;  /**< over a domain: the largest distance of a control point of the second
                      triangle, in the row next to the edge, from where equal first derivatives
                      would have it; -1 without a domain or for rational sets */
    double
        coplanarity; /**< the largest Bernstein coefficient of det(E, D0, D1), E the derivative
                        along the edge, D0 and D1 those across (times the fourth power of the
                        weight), by their greatest lengths at 33 places: 0 but for rounding
                        where the tangent planes agree everywhere; -1 outside space */
    double angle; /**< the largest angle between the normals that was measured at 33 places, in
                     radians; -1 where there are none */
} batten_triangle_join;

/** Some of them, yours to release with batten_triangle_joins_release. */
typedef struct batten_triangle_joins {
    int count;
    batten_triangle_join *at;
} batten_triangle_joins;
/**
 * Release them, and empty the row.
 *
 * @param joins  the row
 */
BATTEN_API void batten_triangle_joins_release(batten_triangle_joins *joins);

/**
 * All pairs of edges that meet: over a domain those with the same two vertices, else those
 * whose ends are within `tolerance`. More than two triangles at an edge are reported pair by
 * pair, the first with each other.
 *
 * @param tolerance  in model units, > 0
 * @param[out] out  in the order of the first edges; release with batten_triangle_joins_release
 * @return BATTEN_OK, BAD_ARGUMENT, OVERFLOW, OUT_OF_MEMORY
 * Cost: O(m log m + 33 m n^3) for m edges; corners of which very many lie between two planes
 * `tolerance` apart cost their square.
 * Source: [Farin86] for C1, [Farin02] ch. 17 for the determinant.
 */
BATTEN_API batten_status batten_triangles_joins(const batten_triangles *triangles,
                                                double tolerance, batten_triangle_joins *out);

/* ---- exact tensor patches, for files and whatever takes surfaces ---- */

/**
 * Three n x n Bezier patches, none of them degenerate where the triangle is not: patch i has
 * the corner i at (0, 0), the middles of the edges to corners i + 1 and i + 2 at (1, 0) and
 * (0, 1), and the centre at (1, 1). Exact.
 *
 * @param triangles  a set of Bezier triangles
 * @param triangle  its index, from 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, OUT_OF_MEMORY
 *
 * Cost: n^4 blends of points at most, for degree n.
 * Source: [Hu96], by blossoms.
 */
BATTEN_API batten_status batten_triangles_to_patches(const batten_triangles *triangles,
                                                     int triangle, batten_surface *out[3]);
/**
 * One n x n Bezier patch with a pole: barycentric coordinates (1 - u, u (1 - v), u v). Exact.
 *
 * @param triangles  a set of Bezier triangles
 * @param triangle  its index, from 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, OUT_OF_MEMORY
 *
 * Cost: n^3 / 6 blends of points, for degree n.
 */
BATTEN_API batten_status batten_triangles_to_pole_patch(const batten_triangles *triangles,
                                                        int triangle, batten_surface **out);
/**
 * The half of a triangle next to an edge, as a surface whose side u = 1 is that edge: so that
 * ribbons can be taken from it. Exact.
 *
 * @param triangles  a set of Bezier triangles
 * @param triangle  its index, from 0
 * @param edge  0, 1 or 2
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: as batten_triangles_to_pole_patch.
 */
BATTEN_API batten_status batten_triangles_half_at_edge(const batten_triangles *triangles,
                                                       int triangle, int edge,
                                                       batten_surface **out);
/**
 * Each Bezier patch m x n of a NURBS surface as two triangles of degree m + n, over the domain
 * (u, v): corners at (0, 0), (1, 0), (1, 1) and at (0, 0), (1, 1), (0, 1) of the patch. Exact.
 *
 * @param surface  a NURBS surface
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_DEGREE when m + n > 25; TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the patches, (m + n)^3 for each at most.
 */
BATTEN_API batten_status batten_triangles_from_surface(const batten_surface *surface,
                                                       batten_triangles **out);

#ifdef __cplusplus
}
#endif
#endif
