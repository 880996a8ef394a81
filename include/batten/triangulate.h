#ifndef BATTEN_TRIANGULATE_H
#define BATTEN_TRIANGULATE_H
/**
 * @file
 * Triangles between points of the plane.
 */
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
} batten_triangulate_options;

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
 *
 * @param points [count][2]
 * @param options NULL for the defaults
 * @param[out] out  to be given back with batten_plane_triangles_release
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_FINITE naming the point; COINCIDENT when fewer than
 * three points differ, or all lie on one line; TOO_LARGE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: O(n log n) for any input; about 200 bytes for each point while it runs.
 * Source: [GS85], divide and conquer; [Shewchuk97] for the signs.
 */
BATTEN_API batten_status batten_triangulate(int count, const double *points,
                                            const batten_triangulate_options *options,
                                            batten_plane_triangles *out);
BATTEN_API void batten_plane_triangles_release(batten_plane_triangles *triangles);

/**
 * The triangle in which a point lies, found by walking from another one.
 *
 * @param start   where to begin, 0 .. count - 1
 * @param[out] at barycentric coordinates; none is negative but for rounding
 * @return the triangle; -1 when the point is outside all of them (or not finite)
 * Cost: the number of triangles on the way; outside the hull, or beside a rim that is not
 * convex, all of them.
 */
BATTEN_API int batten_plane_triangles_find(const batten_plane_triangles *triangles, int start,
                                           const double point[2], double at[3]);

#ifdef __cplusplus
}
#endif
#endif
