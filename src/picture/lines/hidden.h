/*
 * Which parts of lines can be seen: each segment is cut where a triangle begins or ends to
 * cover it.
 *
 * Coordinates are those of the sheet, x and y in points, and depth in the same unit, larger
 * towards the eye. A parallel or perspective map has been applied, which keeps lines straight
 * and triangles plane.
 */
#ifndef BAT_HIDDEN_H
#define BAT_HIDDEN_H
#include "base/base.h"

typedef struct {
    int corner[3];
    float slack; /* so much nearer than a line must it be to hide it */
} bat_facet;

/* Facets in the cells of a grid over the sheet. */
typedef struct {
    size_t count, capacity, point_count;
    bat_facet *facets;
    double *points; /* [point_count][3] */
    double low[2], cell;
    int columns, rows;
    size_t *first; /* [columns * rows + 1] into `inside` */
    int *inside;   /* facets by cells */
} bat_facets;

/* Sort the facets into cells; points and facets are there. */
batten_status bat_facets_sort(bat_facets *facets);
void bat_facets_free(bat_facets *facets);

/* A part of a polyline: from a point on segment `from` to one on segment `to`. */
typedef struct {
    bool hidden;
    size_t count;
    double *xy; /* [count][2] */
} bat_run;

typedef struct {
    size_t count, capacity;
    bat_run *runs;
} bat_runs;

/* Cut a polyline points [count][3] into runs that are seen and hidden; those shorter than
 * `least` beside others join them. Whether they are is asked at `probes` [count][3]: the points
 * themselves or others near them. `out` begins empty, and is so after a failure. */
batten_status bat_runs_cut(const bat_facets *facets, size_t count, const double *points,
                           const double *probes, double least, bat_runs *out);
void bat_runs_free(bat_runs *runs);

#endif
