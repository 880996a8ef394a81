/* The feature 'helical': the surface that a curve leaves when it is screwed about an axis. */
#include "design/shared/place.h"
#include "design/shared/sweeps.h"

static const batten_parameter parameters[] = {
    {"helical", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"pitch", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "how far along the axis in a full turn; below 0 for a left-handed screw"},
    {"turns", BATTEN_VALUE_NUMBER, false, false, "1", NULL, "how many, up to 1000"},
    {"at", BATTEN_VALUE_POINT, false, false, "origin", NULL, "a point on the axis"},
    {"axis", BATTEN_VALUE_POINT, false, false, "z", NULL, "the direction of the axis"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far from the true surface; the tolerance of the design if not given"},
};

static batten_status run_helical(bat_run *run)
{
    const batten_vec3 axis = bat_point(run, "axis");
    bat_objects curves;
    batten_status status = bat_check_direction("axis", axis);
    if (status == BATTEN_OK)
        status = bat_gather(run, "helical", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < curves.count && status == BATTEN_OK; i++) {
        batten_surface *surface = NULL;
        batten_surface_sweep_report report;
        status = batten_surface_helical(curves.at[i]->curve,
                                        (batten_screw){bat_point(run, "at"), axis,
                                                       bat_number(run, "pitch"),
                                                       2 * BAT_PI * bat_number(run, "turns")},
                                        bat_sweep_within(run), run->job, &report, &surface);
        if (status == BATTEN_OK)
            bat_report_error(run, report.error, report.error);
        status = bat_put_surface_like(run, status, surface, curves.at[i]);
    }
    bat_objects_release(&curves);
    return status;
}

const bat_feature bat_feature_helical = {
    .shown =
        {"helical", "The surface that a curve leaves when it is screwed about an axis",
         "Stairs, threads, propellers. Exact along the curve, within the tolerance along the\n"
         "screw. u runs along the curve, v is the angle.",
         "units: m\n"
         "features:\n"
         "  tread: {line: [[0.3, 0, 0], [1, 0, 0]]}\n"
         "  stair: {helical: tread, pitch: 2.6 m, turns: 1.5}\n",
         "[PT97]", "batten_surface_helical", BAT_PARAMETERS(parameters), false,
         .also = "helix surface, screw, thread, helicoid, stairs, propeller, spring",
         .formula = "    S(u, v) = R(v) C(u) + pitch · v/(2π) · axis",
         .promise = "It is exact along the curve and within the tolerance along the screw."},
    .run = run_helical};
