/* Boxes that definitions keep, so that each is found once however often it is placed. */
#ifndef BAT_MODEL_EXTENT_H
#define BAT_MODEL_EXTENT_H
#include "body/kept_box.h"
#include <batten/model.h>

typedef enum {
    BAT_EXACT_BODIES, /* bodies as batten_body_box has them: needs memory */
    BAT_WIDE_BODIES   /* bodies within the boxes of their surfaces: needs none */
} bat_model_bounds;

/* The place for the box of a model in another model; changed by its first reader only. */
bat_kept_box *bat_model_kept_box(const batten_model *model, bat_model_bounds bounds);

#endif
