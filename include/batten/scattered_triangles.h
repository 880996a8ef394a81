#ifndef BATTEN_SCATTERED_TRIANGLES_H
#define BATTEN_SCATTERED_TRIANGLES_H
/**
 * @file
 * Functions of (x, y) through scattered values: a triangulation, gradients at its vertices, and
 * smooth elements over its triangles.
 */
#include <batten/triangulate.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- elements: polynomial sets of dimension 1 over a finer domain ---- */

/** The plane over each triangle; continuous. @param values [vertex_count] */
BATTEN_API batten_status batten_triangles_linear(const batten_triangulation *domain, int count,
                                                 const double *values, batten_triangles **out);
/**
 * The element of Clough and Tocher: three cubics over each triangle, round its centroid (vertex
 * vertex_count + t of the new domain); C1 everywhere. Piece 3 t + e lies on edge e.
 *
 * Without slopes at the middles the derivative across each edge is linear along it: quadratic
 * functions are met exactly. With them cubics are.
 *
 * @param count     triangles of the domain
 * @param values    [vertex_count]
 * @param gradients [vertex_count][2]
 * @param middles   [count][3][2] the gradient at the middle of each edge, of which only the
 * part across it counts, and must be the same on both sides; or NULL
 * @return BATTEN_OK; NOT_FINITE naming the vertex or triangle; as batten_triangles_create
 * Source: [CT65], [Farin86].
 */
BATTEN_API batten_status batten_triangles_clough_tocher(const batten_triangulation *domain,
                                                        int count, const double *values,
                                                        const double *gradients,
                                                        const double *middles,
                                                        batten_triangles **out);
/**
 * The element of Powell and Sabin: six quadratics over each triangle, round the centre of its
 * inscribed circle; edges are cut where the lines between those centres cross them, on the rim
 * in the middle. C1 everywhere; quadratic functions are met exactly. Pieces 6 t + 2 e and
 * 6 t + 2 e + 1 lie on edge e.
 *
 * @param[out] thinnest the least part that is cut off an edge, at most 1/2; where it is near 0,
 * pieces are thin; may be NULL
 * @return as above; SINGULAR_HERE naming triangles whose centres' line misses their edge (by
 * rounding, where they are very thin); BAD_ARGUMENT where three triangles share an edge
 * Source: [PS77].
 */
BATTEN_API batten_status batten_triangles_powell_sabin(const batten_triangulation *domain,
                                                       int count, const double *values,
                                                       const double *gradients,
                                                       double *thinnest,
                                                       batten_triangles **out);

/* ---- gradients at the vertices ---- */

/**
 * The gradient of the quadratic through a vertex that is nearest to the 12 vertices around it,
 * in least squares weighted with 1 / distance^2; of the plane where those do not determine a
 * quadratic, or would exaggerate slopes a hundredfold. Quadratic data give their gradient.
 *
 * @param[out] gradients [vertex_count][2]
 * @param[out] planes  how many are of planes; may be NULL
 * Cost: linear. Source: [Nielson83], section 3 for others of the kind.
 */
BATTEN_API batten_status batten_triangle_gradients(const batten_plane_triangles *triangles,
                                                   const double *values, double *gradients,
                                                   int *planes);
/**
 * The gradients for which the network of cubics along all edges bends least (from few points
 * they are often better than local ones, but their error falls slower with the distance): the
 * integral of
 * the squares of its second derivatives along the edges is minimal. The system has two unknowns
 * for each vertex; conjugate gradients reach 1e-14 in about 30 steps whatever its size.
 *
 * @param gradients [vertex_count][2] in: where to begin; out: the solution
 * @param[out] iterations may be NULL
 * @return BATTEN_OK, INCOMPLETE (200 steps were not enough), OUT_OF_MEMORY
 * Source: [Nielson83].
 */
BATTEN_API batten_status batten_triangle_network(const batten_plane_triangles *triangles,
                                                 const double *values, double *gradients,
                                                 int *iterations);
/**
 * Swap edges inside convex pairs of triangles as long as the sum of the angles between the
 * normals of neighbours, planes through the values, falls. The edges then follow ridges and
 * valleys. Angles depend on the scale of the values.
 *
 * @param[out] swaps may be NULL
 * @return BATTEN_OK, INCOMPLETE (more than 20 swaps for each edge), OUT_OF_MEMORY
 * Source: [DLR90], the angle between normals.
 */
BATTEN_API batten_status batten_triangles_swap(batten_plane_triangles *triangles,
                                               const double *values, int *swaps);

/* ---- from points to surface ---- */

typedef enum batten_triangle_element {
    BATTEN_ELEMENT_CLOUGH_TOCHER,
    BATTEN_ELEMENT_POWELL_SABIN,
    BATTEN_ELEMENT_LINEAR
} batten_triangle_element;

typedef struct batten_scattered_triangles_options {
    size_t size;
    batten_triangle_element element;
    bool network;        /**< gradients of the least bending network, not local ones */
    bool data_dependent; /**< swap edges after Delaunay */
    double tolerance;    /**< as of batten_triangulate; 0 */
    double sliver;       /**< the same; 1e-3 */
} batten_scattered_triangles_options;

BATTEN_API batten_scattered_triangles_options batten_scattered_triangles_defaults(void);

typedef struct batten_scattered_triangles_report {
    int vertices, triangles, pieces;
    int merged;      /**< points that share the vertex of an earlier one: their mean is met */
    double conflict; /**< the largest difference of values at one vertex; 0 */
    int conflicting; /**< a point with that difference to the first one there, or -1 */
    int slivers;     /**< left out on the rim */
    int swaps;
    int planes;      /**< vertices whose gradient is that of a plane */
    int iterations;  /**< of the network */
    double thinnest; /**< of Powell and Sabin, as there; else 0.5 */
    double max, rms; /**< the largest distance of a value from the function: at vertices of
                          several points half of the conflict and more, else 0 */
    int worst;       /**< the point where it is; -1 when max is 0 */
} batten_scattered_triangles_report;

/**
 * A function of dimension 1 over the hull of scattered points, through their values.
 *
 * @param xy      [count][2]
 * @param values  [count]
 * @param options NULL for the defaults: Clough and Tocher, local gradients, Delaunay
 * @param[out] report may be NULL
 * @return as batten_triangulate and the functions above; NOT_FINITE naming the value; TOO_LARGE
 * when the pieces would have more than 10 million control points; CANCELLED
 * Cost: O(n log n).
 */
BATTEN_API batten_status batten_triangles_scattered(
    int count, const double *xy, const double *values,
    const batten_scattered_triangles_options *options, const batten_job *job,
    batten_scattered_triangles_report *report, batten_triangles **out);

/* ---- values at (x, y) ---- */

typedef enum batten_outside {
    BATTEN_OUTSIDE_REFUSED, /**< OUT_OF_DOMAIN names the place */
    BATTEN_OUTSIDE_CLAMPED  /**< the nearest point of the rim is taken instead */
} batten_outside;

/**
 * A set over a domain as a function of (x, y), at many places.
 *
 * @param xy [count][2]
 * @param order 0: values; 1: then the derivatives with respect to x and to y
 * @param[out] out [count][order ? 3 : 1][dimension]
 * @param[out] outside how many places were; may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT without a domain; NOT_FINITE, OUT_OF_DOMAIN naming the place;
 * CANCELLED
 *
 * Cost: O(m log m) for m triangles at first, then a walk for each place from the one before:
 * places in the order of a path or of a grid's rows are quick. A place outside costs the length
 * of the rim; one behind a corner of the rim that turns inwards may cost m.
 */
BATTEN_API batten_status batten_triangles_over(const batten_triangles *triangles, size_t count,
                                               const double *xy, int order,
                                               batten_outside outside, const batten_job *job,
                                               double *out, size_t *outside_count);

#ifdef __cplusplus
}
#endif
#endif
