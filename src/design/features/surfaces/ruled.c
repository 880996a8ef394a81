/* The feature 'ruled': the surface of straight lines between two curves. */
#include "design/feature.h"

#include <batten/sweep.h>

static const batten_parameter parameters[] = {
    {"ruled", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "the two curves"},
    {"match", BATTEN_VALUE_WORD, false, false, "parameter", "parameter length",
     "which points are joined: of equal parameter, or of equal share of the length"},
};

static batten_status rule(bat_run *run, const batten_curve *first, const batten_curve *second)
{
    batten_surface *surface = NULL;
    batten_status status;
    if (bat_word(run, "match") == 0) {
        status = batten_surface_ruled(first, second, &surface);
    } else {
        double error = 0;
        status =
            batten_surface_ruled_by_length(first, second, bat_tolerance(run), &error, &surface);
        if (status == BATTEN_OK)
            bat_report_error(run, error, error);
    }
    return bat_put_surface(run, status, surface);
}

static batten_status run_ruled(bat_run *run)
{
    bat_objects curves;
    batten_status status = bat_gather(run, "ruled", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    if (curves.count == 2)
        status = rule(run, curves.at[0]->curve, curves.at[1]->curve);
    else
        status = bat_fail(BATTEN_BAD_ARGUMENT, "a ruled surface lies between 2 curves, not %d",
                          curves.count);
    bat_objects_release(&curves);
    return status;
}

const bat_feature bat_feature_ruled = {
    .shown =
        {"ruled", "The surface of straight lines between two curves",
         "Points of equal parameter are joined, or, with 'match: length', points of equal shares\n"
         "of the arc length: then the curves are followed within the tolerance of the design. u\n"
         "runs along the curves, v from the first to the second.",
         "features:\n"
         "  chine: {polyline: [[0, 0.5 m, 0], [4 m, 0.6 m, 0.1 m]]}\n"
         "  sheer: {polyline: [[0, 0.7 m, 0.6 m], [4 m, 0.9 m, 0.8 m]]}\n"
         "  plank: {ruled: [chine, sheer]}\n",
         "[PT97 section 8.4]", "batten_surface_ruled", BAT_PARAMETERS(parameters), false,
         .also = "ruled surface, straight lines between curves, lofted between two",
         .formula = "    S(u, v) = (1 − v) C0(u) + v C1(u)",
         .promise = "It is exact when points of equal parameter are joined."},
    .run = run_ruled};
