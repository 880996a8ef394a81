/* The feature 'cylinder': a circular cylinder, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"cylinder", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "the radius"},
    {"height", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "along the axis"},
    BAT_PLACE,
};

static batten_status run_cylinder(bat_run *run)
{
    batten_frame frame;
    batten_surface *cylinder = NULL;
    batten_status status = bat_frame(run, &frame);
    if (status == BATTEN_OK)
        status = batten_surface_cylinder(&frame, bat_number(run, "cylinder"),
                                         bat_number(run, "height"), &cylinder);
    return bat_put_surface(run, status, cylinder);
}

const bat_feature bat_feature_cylinder = {
    .shown = {"cylinder", "A circular cylinder, exactly",
              "From 'at' up along 'axis'; u runs around, v up. It has no end caps.",
              "features:\n"
              "  tank: {cylinder: 0.4 m, height: 1.2 m, axis: x}\n",
              "[PT97 section 8.3]", "batten_surface_cylinder", BAT_PARAMETERS(parameters),
              false, .also = "circular cylinder, tube",
              .formula = "    S(u, v) = at + r (cos u · x + sin u · y) + v · z",
              .promise = "It is exact."},
    .run = run_cylinder};
