/*
 * Colours of what lies in blocks.
 *
 * An object of a block on layer 0 lies on the layer of the INSERT: it has no layer of its own
 * in the model of the block, and an instance gives it one. Its colour may be its own; that of
 * the INSERT ("by block"): none in the model, the instance gives it; or "by layer", which on
 * layer 0 is the colour of the INSERT's layer. An instance has one colour. So the last two are
 * told apart only when the INSERT has another colour than its layer: then it places a copy of
 * the model in which what goes by the layer has that colour as its own. One copy serves all
 * INSERTs on layers of that colour; where nothing goes by layer 0 all place the same model.
 */
#ifndef BAT_DXF_BLOCKS_H
#define BAT_DXF_BLOCKS_H
#include "exchange/dxf/survey.h"

typedef enum {
    BAT_DXF_OWN, /* the colour is that of the object, or of its layer that is not 0 */
    BAT_DXF_BY_BLOCK,
    BAT_DXF_BY_ZERO /* by layer, on layer 0 of a block */
} bat_dxf_colour_source;

/* What is to be known of an object of a block. */
typedef struct {
    bat_dxf_colour_source source;
    bool is_on_zero;
    bat_dxf_block *block; /* of an INSERT, else NULL */
} bat_dxf_part;

/* Note the part, in the order of the model's objects. */
batten_status bat_dxf_add_part(bat_input *input, bat_dxf_block *block,
                               const bat_dxf_part *part);

/* The model that an INSERT places whose layer has the colour `of_layer`, which is not 0 in a
 * block; `own` is its colour, NULL when it comes from elsewhere. */
batten_status bat_dxf_place_block(bat_dxf_reading *r, bat_dxf_block *block,
                                  const double of_layer[3], const double *own,
                                  batten_model **out);
void bat_dxf_block_end(bat_dxf_block *block);

#endif
