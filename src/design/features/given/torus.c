/* The feature 'torus': a torus, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"torus", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "the radius of the ring"},
    {"minor", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "the radius of the tube, below the other"},
    BAT_PLACE,
};

static batten_status run_torus(bat_run *run)
{
    batten_frame frame;
    batten_surface *torus = NULL;
    batten_status status = bat_frame(run, &frame);
    if (status == BATTEN_OK)
        status = batten_surface_torus(&frame, bat_number(run, "torus"),
                                      bat_number(run, "minor"), &torus);
    return bat_put_surface(run, status, torus);
}

const bat_feature bat_feature_torus = {
    .shown = {"torus", "A torus, exactly",
              "About 'axis' through 'at'; u runs around the axis, v around the tube.",
              "features:\n"
              "  ring: {torus: 1 m, minor: 0.2 m}\n",
              "[PT97 section 8.5]", "batten_surface_torus", BAT_PARAMETERS(parameters), false,
              .also = "ring, doughnut",
              .formula =
                  "    S(u, v) = at + (R + r cos v) (cos u · x + sin u · y) + r sin v · z",
              .promise = "It is exact."},
    .run = run_torus};
