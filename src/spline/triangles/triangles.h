/* What a set of Bezier triangles is inside. */
#ifndef BAT_TRIANGLES_H
#define BAT_TRIANGLES_H
#include "base/base.h"
#include <batten/triangles.h>

struct batten_triangles {
    bat_references references;
    int dimension, degree, count;
    size_t net_count; /* control points of one triangle */
    size_t width;     /* of a row of the net: dimension, + 1 when rational */
    double *points;   /* [count][net_count][dimension], Cartesian */
    double *weights;  /* [count][net_count] or NULL */
    double *net;      /* [count][net_count][width]: the points, or (w x .., w) with w scaled */
    double weight_scale; /* the power of two that brings the largest weight into [1, 2) */
    double largest;      /* the largest |coordinate| */
    int vertex_count;    /* of the domain; 0 without one */
    double *vertices;    /* [vertex_count][2] or NULL */
    int *corners;        /* [count][3] or NULL */
};

enum { BAT_TRIANGLE_MOST = BATTEN_TRIANGLE_POINTS(BATTEN_MAX_DEGREE) };

/* What a constructor asks for. */
typedef struct {
    int dimension, degree, count;
    bool rational;
    int vertex_count; /* 0: no domain */
} bat_triangles_shape;

/* A set whose points, weights and domain wait to be filled in, by nobody else seen yet.
 * bat_triangles_finish looks at all of them, derives the rest and hands the set over, or gives
 * it back. */
batten_status bat_triangles_make(const bat_triangles_shape *shape, batten_triangles **out);
batten_status bat_triangles_finish(batten_triangles *made, batten_triangles **out);
void bat_triangles_free(batten_triangles *triangles);
bat_triangles_shape bat_triangles_shape_of(const batten_triangles *triangles);
/* All arrays of domain copied; both have one, or none. */
void bat_triangles_copy_domain(const batten_triangles *from, batten_triangles *to);

/* The net of one triangle. */
static inline const double *bat_triangle_net(const batten_triangles *triangles, int triangle)
{
    return triangles->net + (size_t)triangle * triangles->net_count * triangles->width;
}
/* Write rows [net_count][width] as points and weights of a triangle; `scale` is that of the
 * weights in the rows. */
void bat_triangle_set(batten_triangles *made, int triangle, double scale, const double *rows);

/* Where the point `s` of the row `r` away from edge `e` stands: s = 0 is next to corner e + 1.
 */
static inline int bat_triangle_at(int degree, int e, int r, int s)
{
    int index[3];
    index[e] = r;
    index[(e + 1) % 3] = degree - r - s;
    index[(e + 2) % 3] = s;
    return BATTEN_TRIANGLE_POINT(index[1], index[2]);
}

/* In place, one level of de Casteljau: a net of degree n becomes that of degree n - 1, its
 * blossom with one argument `b`. */
void bat_triangle_step(int degree, size_t width, const double b[3], double *net);
/* The net over the triangle with these corners, in barycentric coordinates. `work` [3][net]. */
void bat_triangle_sub(int degree, size_t width, const double *net, double corners[3][3],
                      double *work, double *out);
/* Point and derivatives of a net, which is spoilt: out [BATTEN_SURFACE_DERIVATIVES(order)]
 * [width]. */
void bat_triangle_derivatives(int degree, size_t width, const double b[3], int order,
                              double *net, double *out);

/* An edge of a triangle, known by the vertices that it joins. */
typedef struct {
    int low, high; /* the vertices, low <= high */
    int triangle, edge;
} bat_triangle_edge;

/* All edges of `count` triangles with these corners [count][3], sorted: those that are shared
 * stand together. To be released. */
batten_status bat_triangle_edges(int count, const int *corners, bat_triangle_edge **out);

/* The barycentric coordinates of a point in a triangle of the plane; where it is one of the
 * corners they are exact. */
void bat_triangle_barycentric(const double *vertices, const int corners[3], const double p[2],
                              double b[3]);

#endif
