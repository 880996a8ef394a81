/* The colours of triangles, each once. */
#ifndef BAT_PALETTE_H
#define BAT_PALETTE_H
#include "base/base.h"
#include <batten/mesh.h>

typedef struct {
    int count;
    int *first; /* [count + 1] into `order`: the triangles of each colour */
    int *order; /* [triangles] by colour, then as they come in the mesh */
    int *of;    /* [triangles] the number of the colour */
} bat_palette;

/* Of a mesh with colours of triangles; release by bat_palette_end. Cost: O(n log n). */
batten_status bat_palette_find(const batten_mesh_parts *parts, bat_palette *out);
void bat_palette_end(bat_palette *palette);
/* The three parts of a colour. */
const double *bat_palette_colour(const bat_palette *palette, const batten_mesh_parts *parts,
                                 int index);

#endif
