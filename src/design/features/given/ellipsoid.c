/* The feature 'ellipsoid': an ellipsoid, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"ellipsoid", BATTEN_VALUE_POINT, false, true, NULL, NULL, "the three semi-axes"},
    BAT_PLACE,
};

static batten_status run_ellipsoid(bat_run *run)
{
    const batten_vec3 axes = bat_point(run, "ellipsoid");
    batten_frame frame;
    batten_surface *surface = NULL;
    batten_status status = bat_frame(run, &frame);
    if (status == BATTEN_OK)
        status = batten_surface_ellipsoid(&frame, axes.x, axes.y, axes.z, &surface);
    return bat_put_surface(run, status, surface);
}

const bat_feature bat_feature_ellipsoid = {
    .shown = {"ellipsoid", "An ellipsoid, exactly",
              "About 'at'; the last half axis lies along 'axis', the first along 'from'.",
              "features:\n"
              "  pebble: {ellipsoid: [30 cm, 20 cm, 10 cm]}\n",
              "[PT97]", "batten_surface_ellipsoid", BAT_PARAMETERS(parameters), false,
              .also = "quadric", .formula = "    x²/a² + y²/b² + z²/c² = 1",
              .promise = "It is exact."},
    .run = run_ellipsoid};
