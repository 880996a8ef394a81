/* The feature 'cone': a circular cone or a part of one, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"cone", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "the radius at the bottom"},
    {"top", BATTEN_VALUE_LENGTH, false, false, "0", NULL, "the radius at the top"},
    {"height", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "along the axis"},
    BAT_PLACE,
};

static batten_status run_cone(bat_run *run)
{
    batten_frame frame;
    batten_surface *cone = NULL;
    batten_status status = bat_frame(run, &frame);
    if (status == BATTEN_OK)
        status = batten_surface_cone(&frame, bat_number(run, "cone"), bat_number(run, "top"),
                                     bat_number(run, "height"), &cone);
    return bat_put_surface(run, status, cone);
}

const bat_feature bat_feature_cone = {
    .shown = {"cone", "A circular cone or a part of one, exactly",
              "From 'at' up along 'axis'; u runs around, v up. One of the radii may be 0.",
              "features:\n"
              "  funnel: {cone: 1 m, top: 0.6 m, height: 2 m}\n",
              "[PT97]", "batten_surface_cone", BAT_PARAMETERS(parameters), false,
              .also = "circular cone, frustum",
              .formula =
                  "    S(u, v) = at + r(v) (cos u · x + sin u · y) + v · z,  r linear in v",
              .promise = "It is exact."},
    .run = run_cone};
