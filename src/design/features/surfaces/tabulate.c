/* The feature 'tabulate': the cylinder of parallel lines through a curve. */
#include "design/shared/place.h"

#include <batten/sweep.h>

static const batten_parameter parameters[] = {
    {"tabulate", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"direction", BATTEN_VALUE_POINT, false, false, "z", NULL,
     "of the lines; its length does not matter"},
    {"from", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "where the lines begin, from the curve"},
    {"to", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "where they end"},
};

static batten_status run_tabulate(bat_run *run)
{
    const batten_vec3 direction = bat_point(run, "direction");
    bat_objects curves;
    batten_status status = bat_check_direction("direction", direction);
    if (status == BATTEN_OK)
        status = bat_gather(run, "tabulate", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < curves.count && status == BATTEN_OK; i++) {
        batten_surface *surface = NULL;
        status =
            batten_surface_tabulated(curves.at[i]->curve, direction, bat_number(run, "from"),
                                     bat_number(run, "to"), &surface);
        status = bat_put_surface_like(run, status, surface, curves.at[i]);
    }
    bat_objects_release(&curves);
    return status;
}

const bat_feature bat_feature_tabulate = {
    .shown =
        {"tabulate", "The cylinder of parallel lines through a curve",
         "Exact: lines of given lengths, to one or both sides of the curve; v is the distance from\n"
         "it.",
         "features:\n"
         "  seam: {arc: 1 m, angle: 120 deg, axis: x, from: y}\n"
         "  plate: {tabulate: seam, direction: [2, 0, 1], from: -50 cm, to: 80 cm}\n",
         "[PT97 section 8.3]", "batten_surface_tabulated", BAT_PARAMETERS(parameters), false,
         .also = "tabulated cylinder", .formula = "    S(u, v) = C(u) + v d,  |d| = 1",
         .promise = "It is exact; v is the distance from the curve."},
    .run = run_tabulate};
