/* The colours of what lies in blocks, carried through their instances. */
#include "exchange/dxf/blocks.h"

#include <string.h>

enum { MOST_VARIANTS = 256, MOST_COPIED = 1000000 };

typedef struct {
    double colour[3];
    batten_model *model;
} variant;

static bool same(const double a[3], const double b[3])
{
    return memcmp(a, b, 3 * sizeof *a) == 0;
}

batten_status bat_dxf_add_part(bat_input *input, bat_dxf_block *block, const bat_dxf_part *part)
{
    const bat_dxf_block *inner = part->block;
    const bool floats = inner && part->is_on_zero && inner->has_floating;
    block->has_floating |= part->source == BAT_DXF_BY_ZERO || floats;
    /* An INSERT on layer 0 with another colour than its layer, whatever this will be. */
    block->is_bound |= floats && (inner->is_bound || part->source != BAT_DXF_BY_ZERO);
    block->parts.size = sizeof *part;
    return bat_list_add(input, &block->parts, part);
}

static batten_status find_variant(bat_dxf_reading *r, bat_dxf_block *block,
                                  const double colour[3], batten_model **out);

static batten_status add_coloured(bat_dxf_reading *r, const bat_dxf_block *block, int index,
                                  const double colour[3], batten_model *made)
{
    const bat_dxf_part *part = (const bat_dxf_part *)block->parts.items + index;
    batten_object object = *batten_model_object(block->model, index);
    batten_model *inner = NULL;
    batten_status status = BATTEN_OK;
    if (part->source == BAT_DXF_BY_ZERO) {
        object.has_colour = true;
        memcpy(object.colour, colour, sizeof object.colour);
    }
    if (part->block && part->is_on_zero && part->block->has_floating &&
        (part->block->is_bound || part->source != BAT_DXF_BY_ZERO)) {
        status = find_variant(r, part->block, colour, &inner);
        object.definition = inner;
    }
    if (status == BATTEN_OK)
        status = batten_model_add(made, &object);
    batten_model_unref(inner);
    return status;
}

static batten_status make_variant(bat_dxf_reading *r, bat_dxf_block *block,
                                  const double colour[3], batten_model **out)
{
    const int count = batten_model_count(block->model);
    variant made = {.model = NULL};
    memcpy(made.colour, colour, sizeof made.colour);
    block->variants.size = sizeof made;
    batten_status status =
        batten_model_create(batten_model_unit_metres(block->model), &made.model);
    if (status == BATTEN_OK)
        status = batten_model_set_name(made.model, block->is.name);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = add_coloured(r, block, i, colour, made.model);
    if (status == BATTEN_OK)
        status = bat_list_add(r->input, &block->variants, &made);
    if (status == BATTEN_OK)
        *out = batten_model_ref(made.model);
    else
        batten_model_unref(made.model);
    return status;
}

/* The model in which what goes by the layer has that colour. Blocks lie in one another at most
 * as deep as they are read. */
static batten_status find_variant(bat_dxf_reading *r, bat_dxf_block *block,
                                  const double colour[3], batten_model **out)
{
    const variant *variants = block->variants.items;
    for (size_t i = 0; i < block->variants.count; i++)
        if (same(variants[i].colour, colour)) {
            *out = batten_model_ref(variants[i].model);
            return BATTEN_OK;
        }
    if (block->variants.count == MOST_VARIANTS ||
        batten_model_count(block->model) > MOST_COPIED - r->copied) {
        batten_notes_add(r->input->notes, r->input->file, block->line, "BLOCK",
                         "'%.60s' is placed in too many colours; what it has by layer on layer "
                         "0 takes that of the INSERT",
                         block->is.name);
        *out = batten_model_ref(block->model);
        return BATTEN_OK;
    }
    r->copied += batten_model_count(block->model);
    return make_variant(r, block, colour, out);
}

batten_status bat_dxf_place_block(bat_dxf_reading *r, bat_dxf_block *block,
                                  const double of_layer[3], const double *own,
                                  batten_model **out)
{
    const bool is_same = own && same(own, of_layer);
    if (block->has_floating && (block->is_bound || !is_same))
        return find_variant(r, block, of_layer, out);
    *out = batten_model_ref(block->model);
    return BATTEN_OK;
}

void bat_dxf_block_end(bat_dxf_block *block)
{
    variant *variants = block->variants.items;
    for (size_t i = 0; i < block->variants.count; i++)
        batten_model_unref(variants[i].model);
    batten_model_unref(block->model);
    bat_release(block->variants.items);
    bat_release(block->parts.items);
}
