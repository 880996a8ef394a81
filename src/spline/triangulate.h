/* Walking among the triangles of the plane. */
#ifndef BAT_TRIANGULATE_H
#define BAT_TRIANGULATE_H
#include "base/base.h"
#include <batten/triangulate.h>

/* Triangles and who is beside whom, for finding places in them. */
typedef struct {
    int count;
    const double *vertices;
    const int *corners, *beside;
    bool convex; /* what leaves them nowhere comes in again */
} bat_walk;

/* Is no corner of the rim turned inwards, but for rounding? */
bool bat_walk_is_convex(const double *vertices, int count, const int *corners,
                        const int *beside);
/* As batten_plane_triangles_find. */
int bat_walk_find(const bat_walk *walk, int start, const double point[2], double at[3]);
/* Who is beside whom: [count][3], to be released. */
batten_status bat_triangle_neighbours(int count, const int *corners, int **beside);

#endif
