/* The feature 'hyperboloid': a hyperboloid of one sheet, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"hyperboloid", BATTEN_VALUE_POINT, false, true, NULL, NULL,
     "the semi-axes: both of the waist, and how fast it opens"},
    {"heights", BATTEN_VALUE_RANGE, false, true, NULL, NULL, "from and to, from the waist"},
    BAT_PLACE,
};

static batten_status run_hyperboloid(bat_run *run)
{
    const batten_vec3 axes = bat_point(run, "hyperboloid");
    const double *heights = bat_argument_of(run, "heights")->items[0].number;
    batten_frame frame;
    batten_surface *surface = NULL;
    batten_status status = bat_frame(run, &frame);
    if (status == BATTEN_OK)
        status =
            batten_surface_hyperboloid(&frame, axes.x, axes.y, axes.z,
                                       (batten_interval){heights[0], heights[1]}, &surface);
    return bat_put_surface(run, status, surface);
}

const bat_feature bat_feature_hyperboloid = {
    .shown =
        {"hyperboloid", "A hyperboloid of one sheet, exactly",
         "x^2 / a^2 + y^2 / b^2 - z^2 / c^2 = 1, with its waist at 'at' and z along 'axis'; v runs\n"
         "along its straight lines.",
         "features:\n"
         "  tower: {hyperboloid: [20 m, 20 m, 30 m], heights: [-60 m, 20 m]}\n",
         "[PT97]", "batten_surface_hyperboloid", BAT_PARAMETERS(parameters), false,
         .also = "quadric, cooling tower, one sheet",
         .formula = "    x²/a² + y²/b² − z²/c² = 1", .promise = "It is exact."},
    .run = run_hyperboloid};
