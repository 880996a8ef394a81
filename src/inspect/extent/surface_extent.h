/* How far a surface, or the part of it that counts, reaches along the axes. */
#ifndef BAT_SURFACE_EXTENT_H
#define BAT_SURFACE_EXTENT_H
#include "base/base.h"
#include <batten/surface.h>

typedef enum { BAT_NOTHING, BAT_A_PART, BAT_ALL } bat_share;

/* Which part of a surface counts: how much of a rectangle of parameters lies in it. */
typedef struct {
    bat_share (*share)(const void *context, const batten_interval uv[2]);
    const void *context;
} bat_region;

/* Both grow from what is known before. */
typedef struct {
    batten_box reached; /* each side has a point of the surface on it */
    batten_box within;  /* nothing is outside */
} bat_extent;

/* Join what a NURBS surface of 3 dimensions reaches to `extent`, which holds the border of the
 * region already; NULL: all of the surface counts, and nothing need be known. Cells of the
 * surface are halved until none may be higher than the highest point found by more than the
 * tolerance, or a budget is used up; then both boxes differ by more. */
batten_status bat_surface_extent(const batten_surface *surface, const bat_region *region,
                                 double tolerance, bat_extent *extent);

/* The largest distance between sides of both boxes. */
double bat_extent_slack(const bat_extent *extent);

#endif
