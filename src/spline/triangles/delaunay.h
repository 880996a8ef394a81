/* Edges of the triangulation of Delaunay. */
#ifndef BAT_DELAUNAY_H
#define BAT_DELAUNAY_H
#include "base/base.h"
#include <batten/base.h>

/* Half edges: 2 e and 2 e + 1 run opposite ways. Those that leave one point form a ring. */
typedef struct {
    const double *points; /* [count][2], borrowed */
    int *origin;          /* -1 where there is no edge */
    int *next, *previous; /* of the ring, counterclockwise and clockwise */
    int used, free;       /* half edges used so far; the first pair given back, or -1 */
} bat_delaunay;

static inline int bat_delaunay_end(const bat_delaunay *edges, int e)
{
    return edges->origin[e ^ 1];
}

/* The next edge round the face on the left of e. */
static inline int bat_delaunay_left(const bat_delaunay *edges, int e)
{
    return edges->previous[e ^ 1];
}

/* Of points that all differ, with coordinates that are multiples of 2^-200 and below 2. */
batten_status bat_delaunay_make(int count, const double *points, const batten_job *job,
                                bat_delaunay *out);
void bat_delaunay_free(bat_delaunay *edges);

#endif
