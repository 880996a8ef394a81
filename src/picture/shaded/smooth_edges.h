/* Which edges of surfaces over triangles need no line in a shaded picture. */
#ifndef BAT_SMOOTH_EDGES_H
#define BAT_SMOOTH_EDGES_H
#include "base/base.h"
#include <batten/model.h>

/* The sides of the pole patch of a triangle (batten_triangles_to_pole_patch). */
enum { BAT_SIDE_U0 = 1, BAT_SIDE_U1 = 2, BAT_SIDE_V0 = 4, BAT_SIDE_V1 = 8 };

/*
 * For the objects that batten_model_with_patches makes of a model with BATTEN_PATCHES_POLE: the
 * sides where two triangles of one set go over into each other with one tangent plane, to a
 * degree.
 * @param[out] sides [count of the patched model]; release it
 */
batten_status bat_smooth_edges(const batten_model *model, const batten_model *patched,
                               unsigned char **sides);

#endif
