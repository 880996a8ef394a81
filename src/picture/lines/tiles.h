/* A surface as a grid of points and normals, as fine as a picture of it needs. */
#ifndef BAT_TILES_H
#define BAT_TILES_H
#include "base/base.h"
#include <batten/surface.h>

typedef struct {
    size_t count_u, count_v;
    double *u, *v;     /* parameters; at an inner knot two, one on each side */
    double *points;    /* [count_u][count_v][3] */
    double *normals;   /* the same; 0 where there is none */
    double *curvature; /* [count_u][count_v]; NULL unless asked for */
} bat_tiles;

/* Which curvature they carry. */
typedef enum { BAT_CURVATURE_NONE, BAT_CURVATURE_GAUSSIAN, BAT_CURVATURE_MEAN } bat_curvature;

/* `tolerance`: how far the tiles may lie from the surface, in model units; `least`: steps in
 * each span, whatever the tolerance; `limit`: about how many points at most. */
batten_status bat_tiles_make(const batten_surface *surface, double tolerance, int least,
                             size_t limit, bat_curvature curvature, const batten_job *job,
                             bat_tiles *out);
void bat_tiles_free(bat_tiles *tiles);

#endif
