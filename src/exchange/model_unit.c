#include "base/base.h"

#include <batten/model.h>

static batten_status scale_points(const batten_object *object, double factor, double **points)
{
    const size_t count = 3 * (size_t)object->point_count;
    double *scaled = bat_array(count, sizeof *scaled);
    if (!scaled)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t k = 0; k < count; k++)
        scaled[k] = object->points[k] * factor;
    *points = scaled;
    return BATTEN_OK;
}

static batten_status scale_offsets(const batten_offsets *offsets, double factor,
                                   double unit_metres, batten_offsets **out)
{
    const double own = batten_offsets_unit_metres(offsets);
    batten_offsets_selection selection = batten_offsets_everything();
    selection.scale = own > 0 ? own / unit_metres : factor;
    selection.unit_metres = unit_metres;
    return batten_offsets_select(offsets, &selection, out);
}

static batten_status add_scaled(batten_model *model, const batten_object *object, double factor)
{
    const batten_affine map = {{{factor, 0, 0}, {0, factor, 0}, {0, 0, factor}}, {0, 0, 0}};
    batten_object scaled = *object;
    batten_curve *curve = NULL;
    batten_chain *chain = NULL;
    batten_surface *surface = NULL;
    batten_offsets *offsets = NULL;
    batten_triangles *triangles = NULL;
    double *points = NULL;

    batten_status status = scale_points(object, factor, &points);
    if (status == BATTEN_OK && object->curve)
        status = batten_curve_transform(object->curve, &map, &curve);
    if (status == BATTEN_OK && object->chain)
        status = batten_chain_transform(object->chain, &map, &chain);
    if (status == BATTEN_OK && object->surface)
        status = batten_surface_transform(object->surface, &map, &surface);
    if (status == BATTEN_OK && object->offsets)
        status =
            scale_offsets(object->offsets, factor, batten_model_unit_metres(model), &offsets);
    if (status == BATTEN_OK && object->triangles)
        status = batten_triangles_transform(object->triangles, &map, &triangles);
    scaled.points = points;
    scaled.curve = curve;
    scaled.chain = chain;
    scaled.surface = surface;
    scaled.offsets = offsets;
    scaled.triangles = triangles;
    if (status == BATTEN_OK)
        status = batten_model_add(model, &scaled);

    bat_release(points);
    batten_curve_unref(curve);
    batten_chain_unref(chain);
    batten_surface_unref(surface);
    batten_offsets_unref(offsets);
    batten_triangles_unref(triangles);
    return status;
}

batten_status batten_model_to_unit(const batten_model *model, double unit_metres,
                                   batten_model **out)
{
    if (!isfinite(unit_metres) || unit_metres <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a unit of %g metres is not allowed", unit_metres);
    batten_model *made = NULL;
    batten_status status = batten_model_create(unit_metres, &made);
    const double factor =
        batten_model_unit_metres(model) > 0 ? batten_model_unit_metres(model) / unit_metres : 1;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        const bool kept = factor == 1 && !object->offsets;
        status = kept ? batten_model_add(made, object) : add_scaled(made, object, factor);
    }
    if (status != BATTEN_OK) {
        batten_model_unref(made);
        return status;
    }
    *out = made;
    return BATTEN_OK;
}
