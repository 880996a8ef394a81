/* The feature 'paraboloid': an elliptic paraboloid, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"paraboloid", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "the semi-axis of the rim along 'from'"},
    {"b", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "the semi-axis across it; the same if not given"},
    {"height", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "from the pole to the rim"},
    BAT_PLACE,
};

static batten_status run_paraboloid(bat_run *run)
{
    const double a = bat_number(run, "paraboloid");
    const double b = bat_has(run, "b") ? bat_number(run, "b") : a;
    batten_frame frame;
    batten_surface *surface = NULL;
    batten_status status = bat_frame(run, &frame);
    if (status == BATTEN_OK)
        status = batten_surface_paraboloid(&frame, a, b, bat_number(run, "height"), &surface);
    return bat_put_surface(run, status, surface);
}

const bat_feature bat_feature_paraboloid = {
    .shown = {"paraboloid", "An elliptic paraboloid, exactly",
              "From its pole at 'at' along 'axis' up to an elliptic rim.",
              "features:\n"
              "  dish: {paraboloid: 1 m, height: 25 cm}\n",
              "[PT97]", "batten_surface_paraboloid", BAT_PARAMETERS(parameters), false,
              .also = "quadric, dish",
              .formula = "    z/h = x²/a² + y²/b²,  a, b the half axes of the rim at height h",
              .promise = "It is exact."},
    .run = run_paraboloid};
