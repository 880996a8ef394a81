/* A model in the kinds that pictures draw. */
#ifndef BAT_FLAT_MODEL_H
#define BAT_FLAT_MODEL_H
#include "base/base.h"
#include <batten/picture.h>

/* Instances placed, hidden objects left out unless all are, and bodies as meshes that are as
 * near as the picture shows: one for each colour of their faces, with the faces of their
 * triangles; other meshes have none. Faces that cannot be drawn have a note of the options. */
batten_status bat_picture_model(const batten_model *model, const batten_draw_options *options,
                                const batten_job *job, batten_model **out);

#endif
