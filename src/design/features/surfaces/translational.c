/* The feature 'translational': the surface that a curve leaves when it is moved along
 * another. */
#include "design/feature.h"

#include <batten/sweep.h>

static const batten_parameter parameters[] = {
    {"translational", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves that are moved"},
    {"path", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curve along which they go"},
};

static batten_status run_translational(bat_run *run)
{
    const batten_curve *path = NULL;
    bat_objects curves;
    batten_status status = bat_one_curve(run, "path", &path);
    if (status == BATTEN_OK)
        status = bat_gather(run, "translational", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < curves.count && status == BATTEN_OK; i++) {
        batten_surface *surface = NULL;
        status = batten_surface_translational(curves.at[i]->curve, path, &surface);
        status = bat_put_surface_like(run, status, surface, curves.at[i]);
    }
    bat_objects_release(&curves);
    return status;
}

const bat_feature bat_feature_translational = {
    .shown =
        {"translational", "The surface that a curve leaves when it is moved along another",
         "Exact: the curve does not turn; all copies of it are congruent, and so are those of the\n"
         "path. The first copy is the curve itself. u runs along the curve, v along the path.",
         "features:\n"
         "  rib: {arc: 2 m, angle: 120 deg, axis: y, from: x}\n"
         "  ridge: {arc: 6 m, angle: 60 deg, axis: x, from: z}\n"
         "  roof: {translational: rib, path: ridge}\n",
         "[LN12 section 12.8] [PT97 section 10.4]", "batten_surface_translational",
         BAT_PARAMETERS(parameters), false, .also = "translational sweep, moved along",
         .formula = "    S(u, v) = C(u) + D(v) − D(a)", .promise = "It is exact."},
    .run = run_translational,
    .beside = "path"};
