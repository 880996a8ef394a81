/* Walking among the triangles of the plane. */
#ifndef BAT_TRIANGULATE_H
#define BAT_TRIANGULATE_H
#include "base/base.h"
#include <batten/scattered.h>

/* Triangles and who is beside whom, for finding places in them. */
typedef struct {
    int count;
    const double *vertices;
    const int *corners, *beside;
    bool convex;    /* what leaves them nowhere comes in again */
    const int *rim; /* sides 3 t + e without neighbour, or NULL: not listed */
    int rim_count;
} bat_walk;

/* As batten_plane_triangles_find. */
int bat_walk_find(const bat_walk *walk, int start, const double point[2], double at[3]);
/* Who is beside whom: [count][3], to be released. */
batten_status bat_triangle_neighbours(int count, const int *corners, int **beside);

#endif
