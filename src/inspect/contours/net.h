/*
 * A conforming triangulation of the domain of a shape that consists of smooth pieces over
 * rectangles and triangles, on which contours are traced.
 *
 * Nodes have numbers, edges are pairs of nodes: two triangles are neighbours when they share
 * such a pair, also when they belong to different pieces.
 */
#ifndef BAT_CONTOUR_NET_H
#define BAT_CONTOUR_NET_H
#include "base/pairs.h"
#include "base/work.h"
#include "inspect/contours/field.h"

/* What is contoured: pieces that are smooth inside and on their edges, each with (u, v) of its
 * own. All pieces are rectangles, or all are triangles with their corners anywhere. */
typedef struct {
    const void *shape;
    /* [BATTEN_SURFACE_DERIVATIVES(order)][3] of the piece at uv, which lies inside it or on its
     * edges. */
    batten_status (*evaluate)(const void *shape, int piece, const double uv[2], int order,
                              double *out);
    int piece_count;
    int corner_count; /* of each piece: 3 or 4 */
    const int *nodes; /* [piece_count][corner_count], counterclockwise */
    const double *uv; /* [piece_count][corner_count][2] */
    int node_count;
    double size; /* of the shape, model units */
} bat_pieces;

typedef struct {
    int node[3];
    int piece;
    double uv[3][2];
} bat_triangle;

/* A map from pairs of numbers to numbers; empty as {0}. */
typedef struct {
    bat_pairs pairs;
    int room;
    int *values; /* [room], as many as there are pairs */
} bat_pair_values;

/* The place of a pair, made with the value `otherwise` when it is new; NULL: no memory. */
int *bat_pair_values_at(bat_pair_values *known, int a, int b, int otherwise);
void bat_pair_values_free(bat_pair_values *known);

typedef struct {
    const bat_pieces *pieces;
    const batten_surface_field *field; /* prepared */
    int order;
    int level_count;
    const double *levels;
    bat_work work;
    size_t triangle_count, triangle_capacity;
    bat_triangle *triangles;
    size_t node_count, node_capacity;
    double *values; /* [node_count]; NaN where the field has none; a value within rounding of a
                       level is that level */
    bool *critical; /* [node_count]: the field stands still there */
    int *owner;     /* [node_count]: the piece in which its value was measured, or -1 */
    double least, greatest, roundoff;
    int critical_count, critical_capacity;
    batten_critical *criticals;
} bat_net;

/* The field in a triangle's piece, with its gradient and the point; the last two may be NULL.
 * NaN where it has no value. */
batten_status bat_net_field(const bat_net *net, int piece, const double uv[2], double *value,
                            double gradient[2], double derivatives[9]);

/* How many levels lie at or below a value. */
int bat_net_levels_below(const bat_net *net, double value);

/* Triangulate: `net` has pieces, field, order, levels and work, the rest is 0. */
batten_status bat_net_build(bat_net *net);
/* Points where the field stands still, found from each triangle, become nodes. */
batten_status bat_net_find_criticals(bat_net *net);
void bat_net_free(bat_net *net);

/* A node with a value, or a triangle, more. */
batten_status bat_net_add_node(bat_net *net, double value, int *out);
batten_status bat_net_add_triangle(bat_net *net, const bat_triangle *triangle);

#endif
