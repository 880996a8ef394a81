/* The feature 'sphere': a sphere, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"sphere", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "the radius"},
    BAT_PLACE,
};

static batten_status run_sphere(bat_run *run)
{
    batten_frame frame;
    batten_surface *sphere = NULL;
    batten_status status = bat_frame(run, &frame);
    if (status == BATTEN_OK)
        status = batten_surface_sphere(&frame, bat_number(run, "sphere"), &sphere);
    return bat_put_surface(run, status, sphere);
}

const bat_feature bat_feature_sphere = {
    .shown = {"sphere", "A sphere, exactly",
              "About 'at', with its poles along 'axis'; u runs around, v from pole to pole.",
              "features:\n"
              "  buoy: {sphere: 30 cm, at: [5 m, 2 m, 0]}\n",
              "[PT97 section 8.5]", "batten_surface_sphere", BAT_PARAMETERS(parameters), false,
              .also = "ball",
              .formula = "    S(u, v) = at + r (cos v (cos u · x + sin u · y) + sin v · z)",
              .promise = "It is exact: |S − at| = r."},
    .run = run_sphere};
