/*
 * Triangles between points of the plane, with given sides kept: the constrained triangulation
 * of Delaunay, built side after side and point after point. All decisions are exact for
 * coordinates that are multiples of 2^-200 and below 2.
 */
#ifndef BAT_MESH_SIDES_H
#define BAT_MESH_SIDES_H
#include "base/base.h"
#include <stdint.h>

typedef struct {
    int corner[3];       /* counter-clockwise */
    int beside[3];       /* across the edge opposite each corner; -1: none */
    unsigned char fixed; /* bit k: the edge opposite corner k is a side */
    unsigned char odd;   /* bit k: of an odd number of sides, so that it parts in and out */
    bool inside;
    bool done;         /* for the owner; false when the triangle is made */
    double miss, turn; /* for the owner */
    int stamp;         /* of the search that met it last */
    int born;          /* changes when the triangle does */
} bat_side_triangle;

typedef struct {
    int vertex_count, vertex_room;
    double (*at)[2]; /* [vertex_count] */
    int *of;         /* [vertex_count] one of its triangles */
    int *start;      /* [vertex_count] scratch */
    int count, room;
    bat_side_triangle *triangles; /* [count]; they fill the hull of the first points */
    int stamp;
    int last;       /* where the walk to the next point begins, and where the last one ended */
    int near[2];    /* the side that the last point not taken was too near to; -1: none */
    uint64_t steps; /* triangles met by all walks and holes so far */
    uint64_t steps_of_sides; /* triangles met while sides were kept; bounded */
    int *list;               /* scratch, [list_room] */
    int list_room;
    bool *waiting; /* scratch of bat_sides_settle */
} bat_sides;

/* Delaunay between the points. @param[out] vertex_of [count]: equal points are one vertex.
 * @return as batten_triangulate; on failure there is nothing to release */
batten_status bat_sides_begin(bat_sides *sides, int count, const double (*points)[2],
                              int *vertex_of);
void bat_sides_end(bat_sides *sides);

typedef enum {
    BAT_SIDE_KEPT,
    BAT_SIDE_CROSSES, /* the side between other[0] and other[1] */
    BAT_SIDE_TOUCHES  /* the vertex other[0] lies on it */
} bat_side_result;
/* Keep a - b as a side; it is not taken when it crosses or touches others. */
batten_status bat_sides_keep(bat_sides *sides, int a, int b, bat_side_result *result,
                             int other[2]);
/* After all sides: Delaunay as far as they allow, and what is inside. */
batten_status bat_sides_settle(bat_sides *sides);

/* Put in a point that is inside. It is not taken, and *vertex is -1, outside, on a vertex, on a
 * side, and near a side: seen from it, the ends of no side may make an angle with a cosine
 * below `widest`, nor may either be nearer than `nearest` of its length.
 * New triangles are inside, not done. */
batten_status bat_sides_insert(bat_sides *sides, const double point[2], double widest,
                               double nearest, int *vertex);

#endif
