/* Skins of two sections. */
#include "numeric/vector.h"
#include "shape/skin/sections.h"

batten_status batten_surface_ruled(const batten_curve *first, const batten_curve *second,
                                   batten_surface **out)
{
    const batten_curve *both[] = {first, second};
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.degree = 1;
    options.parameters = BATTEN_UNIFORM;
    return bat_surface_skin(2, both, &options, true, NULL, NULL, NULL, out);
}

batten_status batten_surface_extruded(const batten_curve *curve, batten_vec3 along,
                                      batten_surface **out)
{
    if (!isfinite(along.x) || !isfinite(along.y) || !isfinite(along.z))
        return bat_fail(BATTEN_NOT_FINITE, "the curve cannot be extruded along (%g, %g, %g)",
                        along.x, along.y, along.z);
    if (bat_vec3_norm(along) == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the vector to extrude along has no length");
    const batten_affine map = batten_affine_translation(along.x, along.y, along.z);
    batten_curve *low = NULL, *high = NULL;
    batten_status status = batten_curve_to_dimension(curve, 3, &low);
    if (status == BATTEN_OK)
        status = batten_curve_transform(low, &map, &high);
    if (status == BATTEN_OK)
        status = batten_surface_ruled(low, high, out);
    batten_curve_unref(high);
    batten_curve_unref(low);
    return status;
}
