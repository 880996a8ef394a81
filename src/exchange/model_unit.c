#include "base/base.h"

#include <batten/model.h>

static batten_status scale_offsets(const batten_offsets *offsets, double factor,
                                   double unit_metres, batten_offsets **out)
{
    const double own = batten_offsets_unit_metres(offsets);
    batten_offsets_selection selection = batten_offsets_everything();
    selection.scale = own > 0 ? own / unit_metres : factor;
    selection.unit_metres = unit_metres;
    return batten_offsets_select(offsets, &selection, out);
}

/* Definitions that were scaled, and what became of them: each once, however often it is placed.
 */
typedef struct {
    int count, capacity;
    const batten_model **from; /* [count] */
    batten_model **to;         /* [count] */
} scaled_models;

static batten_status scale_model(const batten_model *model, double unit_metres, double factor,
                                 scaled_models *known, batten_model **out);

static batten_status remember(scaled_models *known, const batten_model *from, batten_model *to)
{
    if (known->count == known->capacity) {
        const int capacity = bat_max_int(8, 2 * known->capacity);
        const batten_model **sources =
            bat_resize(known->from, (size_t)capacity, sizeof *sources);
        if (!sources)
            return BATTEN_OUT_OF_MEMORY;
        known->from = sources;
        batten_model **made = bat_resize(known->to, (size_t)capacity, sizeof *made);
        if (!made)
            return BATTEN_OUT_OF_MEMORY;
        known->to = made;
        known->capacity = capacity;
    }
    known->from[known->count] = from;
    known->to[known->count++] = batten_model_ref(to);
    return BATTEN_OK;
}

/* The definition scaled, and the place in the new unit. */
static batten_status add_instance(batten_model *model, const batten_object *object,
                                  double factor, scaled_models *known)
{
    batten_object made = *object;
    batten_model *definition = NULL;
    for (int i = 0; i < known->count && !definition; i++)
        if (known->from[i] == object->definition)
            definition = batten_model_ref(known->to[i]);
    batten_status status = BATTEN_OK;
    if (!definition) {
        status = scale_model(object->definition, batten_model_unit_metres(model), factor, known,
                             &definition);
        if (status == BATTEN_OK)
            status = remember(known, object->definition, definition);
    }
    made.definition = definition;
    for (int k = 0; k < 3; k++)
        made.place.t[k] *= factor;
    if (status == BATTEN_OK)
        status = batten_model_add(model, &made);
    batten_model_unref(definition);
    return status;
}

static batten_status add_scaled(batten_model *model, const batten_object *object, double factor,
                                scaled_models *known)
{
    const batten_affine map = batten_affine_scaling(factor, factor, factor);
    if (object->kind == BATTEN_OBJECT_INSTANCE)
        return add_instance(model, object, factor, known);
    if (object->kind != BATTEN_OBJECT_OFFSETS)
        return factor == 1 ? batten_model_add(model, object)
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

/* Instances lie at most 32 deep, and so does the recursion. */
static batten_status scale_model(const batten_model *model, double unit_metres, double factor,
                                 scaled_models *known, batten_model **out)
{
    batten_model *made = NULL;
    batten_status status = batten_model_create(unit_metres, &made);
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
        status = add_scaled(made, batten_model_object(model, i), factor, known);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_model_unref(made);
    return status;
}

batten_status batten_model_to_unit(const batten_model *model, double unit_metres,
                                   batten_model **out)
{
    if (!isfinite(unit_metres) || unit_metres <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a unit of %g metres is not allowed", unit_metres);
    const double own = batten_model_unit_metres(model);
    scaled_models known = {0};
    const batten_status status =
        scale_model(model, unit_metres, own > 0 ? own / unit_metres : 1, &known, out);
    for (int i = 0; i < known.count; i++)
        batten_model_unref(known.to[i]);
    bat_release(known.from);
    bat_release(known.to);
    return status;
}
