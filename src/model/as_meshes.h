/* Shapes of a model as meshes, as far as a format does not hold them. */
#ifndef BAT_MODEL_MESHED_H
#define BAT_MODEL_MESHED_H
#include "base/base.h"
#include <batten/model.h>

/* The kinds that can become meshes. */
#define BAT_SHAPES \
    (1u << BATTEN_OBJECT_SURFACE | 1u << BATTEN_OBJECT_TRIANGLES | 1u << BATTEN_OBJECT_BODY)

/* batten_model_meshed, of the objects of these kinds only: bits 1 << BATTEN_OBJECT_... */
batten_status bat_model_meshed(const batten_model *model, unsigned kinds,
                               const batten_mesh_options *options, const batten_job *job,
                               batten_notes *notes, batten_model **out);

#endif
