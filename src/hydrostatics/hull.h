/* A hull as Bezier patches that close it. */
#ifndef BAT_HYDROSTATICS_HULL_H
#define BAT_HYDROSTATICS_HULL_H
#include "base/arena.h"
#include "hydrostatics/patch.h"
#include <batten/hull.h>

struct batten_hull {
    bat_arena arena;
    batten_box box;
    double centre[3], size; /* coordinates of patches are (P - centre) / size */
    int patch_count, patch_room;
    bat_patch *patches;
    int lid_count, lid_room;
    batten_hull_lid *lids;
};

/* Drop the lids of edges that run along an edge of another surface: joints. */
batten_status bat_hull_find_joints(batten_hull *hull, int count,
                                   const batten_surface *const *surfaces);

/* Which surfaces are the images of others in the centre plane; `images` [count] begins as false.
 * BAD_ARGUMENT for one that is neither on one side nor an image. */
batten_status bat_hull_find_images(const batten_hull *hull, int count,
                                   const batten_surface *const *surfaces, bool *images);

/* The water above which heights are counted, in the coordinates of the patches: h = n.P - d,
 * with axes along the ship and across it in the plane: n, along and across are right-handed, as
 * across = n x along. */
typedef struct {
    double n[3], along[3], across[3], d;
} bat_water;

/* BAD_ARGUMENT for a trim of a right angle and above, a heel of two, and what is not finite. */
batten_status bat_water_of(const batten_hull *hull, const batten_flotation *flotation,
                           bat_water *out);

#endif
