#ifndef BATTEN_GEOMETRY_H
#define BATTEN_GEOMETRY_H
/**
 * @file
 * The small values that are passed by value.
 */
#include <batten/base.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_vec3 {
    double x, y, z;
} batten_vec3;

/** A point or a direction of the plane. */
typedef struct batten_vec2 {
    double x, y;
} batten_vec2;

/** A closed interval, a <= b. */
typedef struct batten_interval {
    double a, b;
} batten_interval;

/** An axis-parallel box; coordinates beyond the dimension of the object are 0. */
typedef struct batten_box {
    batten_vec3 low, high;
} batten_box;

/** x' = m x + t, rows of m first: m[row][column]. In the plane z is left alone. */
typedef struct batten_affine {
    double m[3][3];
    double t[3];
} batten_affine;

/** A row of points, borrowed for the call; also values of a function (dimension 1). */
typedef struct batten_points {
    int dimension; /**< coordinates of each, 1 to 3 */
    int count;
    const double *at; /**< [count][dimension] */
} batten_points;

/** A rectangular grid of points, borrowed for the call. */
typedef struct batten_grid {
    int dimension;        /**< coordinates of each, 1 to 3 */
    int count_u, count_v; /**< points along u and along v */
    const double *at;     /**< [count_u][count_v][dimension] */
} batten_grid;

/** The parameters of the lines of a grid, borrowed for the call. */
typedef struct batten_uv {
    const double *u; /**< [count_u] */
    const double *v; /**< [count_v] */
} batten_uv;

/** Where a function puts the parameters of the lines of a grid: room of the caller's. */
typedef struct batten_uv_out {
    double *u; /**< [count_u], or NULL */
    double *v; /**< [count_v], or NULL */
} batten_uv_out;

/** The map that moves nothing. */
BATTEN_API batten_affine batten_affine_identity(void);
/** The map that adds (x, y, z). */
BATTEN_API batten_affine batten_affine_translation(double x, double y, double z);
/** The map that multiplies by x, y and z, about the origin. */
BATTEN_API batten_affine batten_affine_scaling(double x, double y, double z);
/** Rotation by `angle` radians about the axis through `origin` with direction `axis` (not
 * zero). */
BATTEN_API batten_affine batten_affine_rotation(batten_vec3 origin, batten_vec3 axis,
                                                double angle);
/** Mirror in the plane through `origin` with normal `normal` (not zero). */
BATTEN_API batten_affine batten_affine_mirror(batten_vec3 origin, batten_vec3 normal);
/** First `first`, then `then`. */
BATTEN_API batten_affine batten_affine_compose(batten_affine first, batten_affine then);
/** The image of a point under a map. */
BATTEN_API batten_vec3 batten_affine_apply(batten_affine map, batten_vec3 point);
/** How volumes grow; below 0 for a map that mirrors, 0 for one that flattens. */
BATTEN_API double batten_affine_determinant(batten_affine map);
/** A place to stand: origin, and two directions that are made square and of length one; z keeps
 * its direction. */
typedef struct batten_frame {
    batten_vec3 origin;
    batten_vec3 x; /**< first axis, not zero */
    batten_vec3 z; /**< normal, not parallel to x */
} batten_frame;

/** The world's own frame. */
BATTEN_API batten_frame batten_frame_world(void);
/** The plane on which coordinate `axis` (0, 1, 2) is `at`: its axes are the two that are left,
 * in their order. */
BATTEN_API batten_frame batten_frame_across(int axis, double at);

#ifdef __cplusplus
}
#endif
#endif
