/* The feature 'extrude': the surface that a curve leaves when it is moved straight on. */
#include "design/shared/place.h"

static const batten_parameter parameters[] = {
    {"extrude", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"along", BATTEN_VALUE_POINT, false, true, NULL, NULL, "how far in x, y and z"},
};

static batten_status run_extrude(bat_run *run)
{
    const batten_vec3 along = bat_point(run, "along");
    bat_objects curves;
    batten_status status = bat_check_direction("along", along);
    if (status == BATTEN_OK)
        status = bat_gather(run, "extrude", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < curves.count && status == BATTEN_OK; i++) {
        batten_surface *surface = NULL;
        status = batten_surface_extruded(curves.at[i]->curve, along, &surface);
        status = bat_put_surface_like(run, status, surface, curves.at[i]);
    }
    bat_objects_release(&curves);
    return status;
}

const bat_feature bat_feature_extrude = {
    .shown =
        {"extrude", "The surface that a curve leaves when it is moved straight on",
         "Every curve of the input makes one surface; u runs along the curve, v along the path.",
         "features:\n"
         "  deck-edge: {polyline: [[0, 1 m, 1 m], [4 m, 1.2 m, 1 m]]}\n"
         "  bulwark: {extrude: deck-edge, along: [0, 0, 30 cm]}\n",
         "[PT97 section 8.3]", "batten_surface_extruded", BAT_PARAMETERS(parameters), false,
         .also = "extrusion, prism, pad, general cylinder",
         .formula = "    S(u, v) = C(u) + v d", .promise = "It is exact."},
    .run = run_extrude};
