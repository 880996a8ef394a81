#ifndef BATTEN_SCATTERED_H
#define BATTEN_SCATTERED_H
/**
 * @file
 * Surfaces through and near scattered points: triangulations, elements over triangles, clouds.
 */
#include <batten/grid.h>
#include <batten/triangles.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_triangulate_options {
    size_t size;
    double tolerance; /**< points that are not farther than this from an earlier one are the
                           same vertex; below 2^-50 of the largest coordinate it counts as 0,
                         then only equal points are; 0 */
    double sliver;    /**< triangles on the rim whose height over it is below this part of their
                           side on it are left out, while no vertex goes with them; 1e-9 */
    const batten_job *job; /**< progress and cancelling; NULL for no questions */
} batten_triangulate_options;

/** The defaults of triangulations: those beside the fields of batten_triangulate_options. */
BATTEN_API batten_triangulate_options batten_triangulate_defaults(void);

/** Triangles, who is beside whom, and which point became which vertex. */
typedef struct batten_plane_triangles {
    int vertex_count;
    double *vertices; /**< [vertex_count][2] */
    int *first;       /**< [vertex_count] the point that the vertex is */
    int *vertex_of;   /**< [count of points] */
    int count;        /**< of triangles */
    int *corners;     /**< [count][3], counterclockwise */
    int *beside; /**< [count][3] the triangle across the edge opposite each corner, -1 none */
    int merged;  /**< points that became the vertex of an earlier one */
    int slivers; /**< triangles left out on the rim */
} batten_plane_triangles;
/**
 * The triangulation of Delaunay: no point is inside the circle round any triangle. Together the
 * triangles fill the convex hull, but for slivers that are left out.
 *
 * All decisions are exact, whatever the coordinates; two that agree to 2^-200 of the largest
 * are equal. Of points on one circle either diagonal may be taken, always the same one for the
 * same input.
 * @param points [count][2]
 * @param options NULL for the defaults
 * @param[out] out  to be given back with batten_plane_triangles_release
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_FINITE naming the point; COINCIDENT when fewer than
 * three points differ, or all lie on one line; TOO_LARGE, BAD_ARGUMENT, OUT_OF_MEMORY
 * Cost: O(n log n) for any input; about 200 bytes for each point while it runs.
 * Source: [GS85], divide and conquer; [Shewchuk97] for the signs.
 */
BATTEN_API batten_status batten_triangulate(batten_points points,
                                            const batten_triangulate_options *options,
                                            batten_plane_triangles *out);
/**
 * Release a triangulation.
 * @param triangles  a set of Bezier triangles
 */
BATTEN_API void batten_plane_triangles_release(batten_plane_triangles *triangles);
/**
 * The triangle in which a point lies, found by walking from another one.
 * @param start   where to begin, 0 .. count - 1
 * @param[out] at barycentric coordinates; none is negative but for rounding
 * @return the triangle; -1 when the point is outside all of them (or not finite)
 * Cost: the number of triangles on the way; outside the hull, or beside a rim that is not
 * convex, all of them.
 */
BATTEN_API int batten_plane_triangles_find(const batten_plane_triangles *triangles, int start,
                                           batten_vec2 point, double at[3]);
typedef enum batten_scattered_method {
    BATTEN_SCATTERED_PENALISED, /**< least squares and a penalty on bending */
    BATTEN_SCATTERED_MULTILEVEL /**< bicubic lattices, each half as wide as the one before, near
                                     what is left: fast, local, no least squares */
} batten_scattered_method;

typedef struct batten_surface_scattered_options {
    size_t size;
    batten_scattered_method method;
    int degree_u, degree_v; /**< 3, 3; 2 to 9. MULTILEVEL: always 3 */
    int spans_u, spans_v;  /**< between knots, with which it begins. 0: by the number of data; 4
                                with a tolerance; of MULTILEVEL 1 in the shorter direction */
    double domain[2][2];   /**< u from, to; v from, to; all 0: the box of the parameters */
    const double *weights; /**< [count], or NULL */
    batten_smooth_by by;   /**< PENALISED without tolerance: BATTEN_SMOOTH_BY_VALIDATION. LAMBDA
                                with amount 0: least squares; where the data do not determine the
                                surface the penalty weighs 1e-8 of them, and `lambda` says so */
    double amount;
    double tolerance; /**< > 0: lines of knots are added where data are farther, until none is;
                         0 */
    int most_points;  /**< control points at most; 0: 250000 */
    int levels;       /**< MULTILEVEL: at most; 0: 9, or as many as the data are good for */
    bool huber; /**< PENALISED: distances count by their squares up to the threshold, beyond
                     in proportion */
    double threshold; /**< 0: 1.345 standard deviations, found from the median distance */
    int corrections;  /**< of clouds: how often parameters are moved to the feet at most; 20 */
} batten_surface_scattered_options;

/** A cloud of points; borrowed for the call. */
typedef struct batten_cloud {
    batten_points points;       /**< of dimension 3 */
    const batten_surface *base; /**< any surface over which the cloud lies once; NULL: the
                                     smallest rectangle around it in the plane of least squares */
} batten_cloud;

/** The defaults of surfaces near scattered data: beside the fields of the options. */
BATTEN_API batten_surface_scattered_options batten_surface_scattered_defaults(void);
/**
 * A tensor product spline near values at scattered parameters.
 *
 * PENALISED: the least of the weighted squares plus lambda times the integral of Suu^2 + 2
 * Suv^2 + Svv^2, over knots at even distances; lambda by cross validation, by a target or as
 * given. With a tolerance knots are added in the strips, and along the directions, where data
 * are too far off, and in the end those removed that are not needed; lambda is then 1e-4 of the
 * data's scale or more, 1e-9 when knots alone do not meet the tolerance. Where a part of the
 * domain holds no data (bins four times as wide as the data are dense) the penalty weighs 1e-2
 * of that scale at least, however small lambda becomes, unless lambda is given or the target
 * cannot be met so: the surface continues calmly there. `outside` of the report says how far it
 * leaves the box of the data nonetheless. Systems are solved directly where that is cheap, else
 * (some 125 spans each way) by conjugate gradients; lambda is then chosen on 80 spans, so a
 * target of rms is met nearly, and `freedom` is not asked.
 *
 * MULTILEVEL: each level meets single points exactly and averages where several share control
 * points. Levels follow until the tolerance is met; without one, and without `levels`,
 * until the next would have more than eight control points for each datum, or the root of the
 * mean square no longer falls by a tenth. `end` of the report says which it was.
 *
 * @param uv      [count][2], any order
 * @param values  [count][dimension]; dimension 1: a function of (u, v)
 * @param options NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] report  what was reached; may be NULL
 * @param[out] out clamped, over the domain
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_FINITE, BAD_WEIGHT, OUT_OF_DOMAIN naming the datum;
 * COINCIDENT when the parameters span no area; BAD_DEGREE, BAD_ARGUMENT, TOO_LARGE;
 * TOLERANCE_NOT_MET with the most that was reached and where
 *
 * Cost: for each fit (degree + 1)^4 / 2 for a datum and, solved directly, the control points
 * times the square of those of the shorter direction; memory linear in data and control points.
 * Source: [HH74], [Dierckx93], [LWS97], [Hutchinson89] for the trace.
 */
BATTEN_API batten_status batten_surface_scattered(
    const double *uv, batten_points values, const batten_surface_scattered_options *options,
    const batten_job *job, batten_surface_fit_report *report, batten_surface **out);
/**
 * A surface near a cloud of points, whose parameters are their feet on a base surface, then on
 * the surface itself.
 *
 * After each fit every point takes a step of Newton towards its foot, where that brings it
 * nearer, until rms no longer falls by a hundredth; the best is kept. Points on the rim of the
 * domain stay on it.
 *
 * @param cloud  points: [count][3]
 *     base: any surface over which the cloud lies once; NULL: the smallest rectangle
 * around it in the plane of least squares
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] uv  [count][2], of the points on the surface; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return as batten_surface_scattered; COINCIDENT when the points lie on a line (without base)
 * Cost: a search for each point on the base, then as batten_surface_scattered for each round.
 * Source: [Hoschek88].
 */
BATTEN_API batten_status batten_surface_cloud(const batten_cloud *cloud,
                                              const batten_surface_scattered_options *options,
                                              const batten_job *job, double *uv,
                                              batten_surface_fit_report *report,
                                              batten_surface **out);
/**
 * The bilinear surface of four corners: a base for clouds.
 * @param corners  [4][3]: (0, 0), (1, 0), (0, 1), (1, 1)
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_surface_create
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_surface_from_corners(const double *corners,
                                                     batten_surface **out);
/**
 * The graph (u, v, f(u, v)) of a polynomial surface of one dimension, in space; clamped.
 *
 * @param function  a polynomial NURBS surface of dimension 1
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT for any other surface, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_surface_from_function(const batten_surface *function,
                                                      batten_surface **out);
/* ---- elements: polynomial sets of dimension 1 over a finer domain ---- */

/**
 * The plane over each triangle; continuous.
 * @param domain  vertices, and corners [count][3]
 * @param count  of triangles
 * @param values [vertex_count]
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_triangles_create; TOO_FEW_POINTS without a triangle
 *
 * Cost: linear in the triangles.
 */
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
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; NOT_FINITE naming the vertex or triangle; as batten_triangles_create
 *
 * Cost: linear in the triangles.
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
 * @param domain  vertices, and corners [count][3]
 * @param count  of triangles
 * @param values  [vertex_count]
 * @param gradients  [vertex_count][2]
 * @param[out] thinnest the least part that is cut off an edge, at most 1/2; where it is near 0,
 * pieces are thin; may be NULL
 * @return as above; SINGULAR_HERE naming triangles whose centres' line misses their edge (by
 * rounding, where they are very thin); BAD_ARGUMENT where three triangles share an edge
 *
 * Cost: n log n for n edges, which are sorted; else linear in the triangles.
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
 * @param triangles  a set of Bezier triangles
 * @param values  one for each place
 * @param job  progress, cancelling; NULL for no questions
 * @param[out] gradients [vertex_count][2]
 * @param[out] planes  how many are of planes; may be NULL
 * @return BATTEN_OK, SINGULAR_HERE, CANCELLED, OUT_OF_MEMORY
 * Cost: linear.
 * Source: [Nielson83], section 3 for others of the kind.
 */
BATTEN_API batten_status batten_triangle_gradients(const batten_plane_triangles *triangles,
                                                   const double *values, const batten_job *job,
                                                   int *planes, double *gradients);
/**
 * The gradients for which the network of cubics along all edges bends least (from few points
 * they are often better than local ones, but their error falls slower with the distance): the
 * integral of the squares of its second derivatives along the edges is minimal. The system has
 * two unknowns for each vertex; conjugate gradients reach 1e-14 in about 30 steps whatever its
 * size.
 *
 * @param triangles  as batten_triangulate makes them
 * @param values  [vertex_count]
 * @param job  progress, cancelling; NULL for no questions
 * @param[out] iterations  how many steps; may be NULL
 * @param gradients [vertex_count][2] in: where to begin; out: the solution
 * @return BATTEN_OK, INCOMPLETE (200 steps were not enough), CANCELLED, OUT_OF_MEMORY
 *
 * Cost: linear in the triangles for each step of conjugate gradients, of which there are 200 at
 * most.
 * Source: [Nielson83].
 */
BATTEN_API batten_status batten_triangle_network(const batten_plane_triangles *triangles,
                                                 const double *values, const batten_job *job,
                                                 int *iterations, double *gradients);
/**
 * Swap edges inside convex pairs of triangles as long as the sum of the angles between the
 * normals of neighbours, planes through the values, falls. The edges then follow ridges and
 * valleys. Angles depend on the scale of the values.
 *
 * @param[out] triangles  as batten_triangulate makes them; changed, unless the call fails
 * @param values  [vertex_count]
 * @param job  progress, cancelling; NULL for no questions
 * @param[out] swaps  how many; may be NULL
 * @return BATTEN_OK, INCOMPLETE (more than 20 swaps for each edge), CANCELLED, OUT_OF_MEMORY
 *
 * Cost: some ten angles for each edge that is looked at; each swap looks at four edges again.
 * Source: [DLR90], the angle between normals.
 */
BATTEN_API batten_status batten_triangles_swap(batten_plane_triangles *triangles,
                                               const double *values, const batten_job *job,
                                               int *swaps);

/* ---- from points to surface ---- */
typedef enum batten_triangle_element {
    BATTEN_ELEMENT_CLOUGH_TOCHER,
    BATTEN_ELEMENT_POWELL_SABIN,
    BATTEN_ELEMENT_LINEAR
} batten_triangle_element;

typedef struct batten_triangles_scattered_options {
    size_t size;
    batten_triangle_element element;
    bool network;        /**< gradients of the least bending network, not local ones */
    bool data_dependent; /**< swap edges after Delaunay */
    double tolerance;    /**< as of batten_triangulate; 0 */
    double sliver;       /**< the same; 1e-3 */
} batten_triangles_scattered_options;

/** The defaults of elements over scattered data: those beside the fields of
 * batten_triangles_scattered_options. */
BATTEN_API batten_triangles_scattered_options batten_triangles_scattered_defaults(void);

typedef struct batten_triangles_scattered_report {
    int vertices, triangles, pieces;
    int merged;      /**< points that share the vertex of an earlier one: their mean is met */
    double conflict; /**< the largest difference of values at one vertex; 0 */
    int conflicting; /**< a point with that difference to the first one there, or -1 */
    int slivers;     /**< left out on the rim */
    int swaps;
    int planes;        /**< vertices whose gradient is that of a plane */
    int iterations;    /**< of the network */
    double thinnest;   /**< of Powell and Sabin, as there; else 0.5 */
    double error, rms; /**< the largest distance of a value from the function: at vertices of
                          several points half of the conflict and more, else 0 */
    int worst;         /**< the point where it is; -1 when max is 0 */
} batten_triangles_scattered_report;
/**
 * A function of dimension 1 over the hull of scattered points, through their values.
 *
 * @param xy      [count][2]
 * @param values  [count]
 * @param options NULL for the defaults: Clough and Tocher, local gradients, Delaunay
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] report  what was reached; may be NULL
 * @return as batten_triangulate and the functions above; NOT_FINITE naming the value; TOO_LARGE
 * when the pieces would have more than 10 million control points; CANCELLED
 * Cost: O(n log n).
 */
BATTEN_API batten_status batten_triangles_scattered(
    batten_points xy, const double *values, const batten_triangles_scattered_options *options,
    const batten_job *job, batten_triangles_scattered_report *report, batten_triangles **out);

/* ---- values at (x, y) ---- */
typedef enum batten_outside {
    BATTEN_OUTSIDE_REFUSED, /**< OUT_OF_DOMAIN names the place */
    BATTEN_OUTSIDE_CLAMPED  /**< the nearest point of the rim is taken instead */
} batten_outside;

/** Many places (x, y), borrowed for the call. */
typedef struct batten_batch {
    size_t count;
    const double *at; /**< [count][2] */
} batten_batch;

/** What is done with places outside the domain. */
typedef struct batten_outside_points {
    batten_outside rule;
    size_t *count; /**< gets how many there were; or NULL */
} batten_outside_points;
/**
 * A set over a domain as a function of (x, y), at many places.
 *
 * @param xy [count][2]
 * @param order 0: values; 1: then the derivatives with respect to x and to y
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out [count][order ? 3 : 1][dimension]
 * @param[out] outside how many places were; may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT without a domain; NOT_FINITE, OUT_OF_DOMAIN naming the place;
 * CANCELLED
 *
 * Cost: O(m log m) for m triangles at first, then a walk for each place from the one before:
 * places in the order of a path or of a grid's rows are quick. A place outside costs the length
 * of the rim; one behind a corner of the rim that turns inwards may cost m.
 */
BATTEN_API batten_status batten_triangles_over(const batten_triangles *triangles,
                                               batten_batch xy, int order,
                                               batten_outside_points outside,
                                               const batten_job *job, double *out);

#ifdef __cplusplus
}
#endif
#endif
