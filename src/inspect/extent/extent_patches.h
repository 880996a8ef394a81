/* The Bezier patches of a surface whose extent is sought, cut at its creases. */
#ifndef BAT_INSPECT_EXTENT_EXTENT_PATCHES_H
#define BAT_INSPECT_EXTENT_EXTENT_PATCHES_H
#include "spline/surface/surface.h"

typedef struct {
    batten_surface *bezier;
    int spans[2];
    double *breaks[2]; /* [spans + 1] */
    bool *creases[2];  /* [spans + 1] */
} bat_extent_patches;

batten_status bat_extent_patches_begin(const batten_surface *surface, bat_extent_patches *p);
void bat_extent_patches_end(bat_extent_patches *p);

#endif
