#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"ruled", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "the two curves"},
};

static batten_status run(bat_run *run)
{
    bat_objects curves;
    batten_surface *surface = NULL;
    batten_status status = bat_gather(run, "ruled", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    if (curves.count == 2)
        status = batten_surface_ruled(curves.at[0]->curve, curves.at[1]->curve, &surface);
    else
        status = bat_fail(BATTEN_BAD_ARGUMENT, "a ruled surface lies between 2 curves, not %d",
                          curves.count);
    bat_objects_release(&curves);
    return bat_put_surface(run, status, surface);
}

const bat_feature bat_feature_ruled = {
    .shown = {"ruled", "The surface of straight lines between two curves",
              "Points of equal parameter are joined; u runs along the curves, v from the first "
              "to the\n"
              "second.",
              "features:\n"
              "  chine: {polyline: [[0, 0.5 m, 0], [4 m, 0.6 m, 0.1 m]]}\n"
              "  sheer: {polyline: [[0, 0.7 m, 0.6 m], [4 m, 0.9 m, 0.8 m]]}\n"
              "  plank: {ruled: [chine, sheer]}\n",
              "[PT97]", "batten_surface_ruled", BAT_PARAMETERS(parameters), false},
    .run = run};
