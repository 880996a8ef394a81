/* The feature 'revolve': the surface that a curve leaves when it is turned about an axis. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"revolve", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the profile curves"},
    {"at", BATTEN_VALUE_POINT, false, false, "origin", NULL, "a point on the axis"},
    {"axis", BATTEN_VALUE_POINT, false, false, "z", NULL, "the direction of the axis"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, "360 deg", NULL, "how far, up to 360 deg"},
};

static batten_status run_revolve(bat_run *run)
{
    const batten_vec3 axis = bat_point(run, "axis");
    bat_objects profiles;
    batten_status status = bat_check_direction("axis", axis);
    if (status == BATTEN_OK)
        status = bat_gather(run, "revolve", BAT_CURVES, &profiles);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < profiles.count && status == BATTEN_OK; i++) {
        batten_surface *surface = NULL;
        status = batten_surface_revolved(profiles.at[i]->curve, bat_point(run, "at"), axis,
                                         bat_number(run, "angle"), &surface);
        status = bat_put_surface_like(run, status, surface, profiles.at[i]);
    }
    bat_objects_release(&profiles);
    return status;
}

const bat_feature bat_feature_revolve = {
    .shown =
        {"revolve", "The surface that a curve leaves when it is turned about an axis",
         "Exact, with u around the axis and v along the profile. A profile that crosses the axis\n"
         "is refused; where it touches the axis the surface has a pole.",
         "features:\n"
         "  profile: {line: [[1 m, 0, 0], [0.6 m, 0, 2 m]]}\n"
         "  mast: {revolve: profile, axis: z}\n",
         "[PT97 section 8.5]", "batten_surface_revolved", BAT_PARAMETERS(parameters), false,
         .also = "surface of revolution, lathe, turned part, rotate a profile",
         .formula = "    S(u, v) = R(u) C(v),  R(u) the turn by the angle at u about the axis",
         .promise = "It is exact."},
    .run = run_revolve};
