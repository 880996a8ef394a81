#include "exchange/model_change.h"

static batten_status scale_offsets(const batten_offsets *offsets, double factor,
                                   double unit_metres, batten_offsets **out)
{
    const double own = batten_offsets_unit_metres(offsets);
    batten_offsets_selection selection = batten_offsets_everything();
    selection.scale = own > 0 ? own / unit_metres : factor;
    selection.unit_metres = unit_metres;
    return batten_offsets_select(offsets, &selection, out);
}

static batten_status add_scaled(void *context, const batten_model *from, int index,
                                batten_model *model, const batten_object *object)
{
    (void)from;
    (void)index;
    const double factor = *(const double *)context;
    const batten_affine map = batten_affine_scaling(factor, factor, factor);
    if (object->kind != BATTEN_OBJECT_OFFSETS)
        return factor == 1 || object->kind == BATTEN_OBJECT_INSTANCE
                   ? batten_model_add(model, object)
                   : batten_model_add_mapped(model, object, &map);
    batten_object scaled = *object;
    batten_offsets *offsets = NULL;
    batten_status status =
        scale_offsets(object->offsets, factor, batten_model_unit_metres(model), &offsets);
    scaled.offsets = offsets;
    if (status == BATTEN_OK)
        status = batten_model_add(model, &scaled);
    batten_offsets_unref(offsets);
    return status;
}

batten_status batten_model_to_unit(const batten_model *model, double unit_metres,
                                   batten_model **out)
{
    if (!isfinite(unit_metres) || unit_metres <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a unit of %g metres is not allowed", unit_metres);
    const double own = batten_model_unit_metres(model);
    double factor = own > 0 ? own / unit_metres : 1;
    return bat_model_change(model, unit_metres, factor, add_scaled, &factor, out);
}
