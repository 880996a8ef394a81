/* The feature 'cone-to': the cone of straight lines from a curve to a point. */
#include "design/feature.h"

#include <batten/sweep.h>

static const batten_parameter parameters[] = {
    {"cone-to", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"apex", BATTEN_VALUE_POINT, false, true, NULL, NULL, "where all lines meet"},
};

static batten_status run_cone_to(bat_run *run)
{
    bat_objects curves;
    batten_status status = bat_gather(run, "cone-to", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < curves.count && status == BATTEN_OK; i++) {
        batten_surface *surface = NULL;
        status = batten_surface_conical(curves.at[i]->curve, bat_point(run, "apex"), &surface);
        status = bat_put_surface_like(run, status, surface, curves.at[i]);
    }
    bat_objects_release(&curves);
    return status;
}

const bat_feature bat_feature_cone_to = {
    .shown =
        {"cone-to", "The cone of straight lines from a curve to a point",
         "Exact, for any curve. u runs along the curve, v from it to the apex, where the surface\n"
         "has a pole.",
         "features:\n"
         "  oval: {ellipse: 2 m, b: 1 m}\n"
         "  tent: {cone-to: oval, apex: [1 m, 0, 3 m]}\n",
         "[PT97]", "batten_surface_conical", BAT_PARAMETERS(parameters), false,
         .also = "general cone, apex", .formula = "    S(u, v) = (1 − v) C(u) + v A",
         .promise = "It is exact."},
    .run = run_cone_to};
