/* The feature 'swing': a profile swung along a trajectory around the z-axis. */
#include "design/feature.h"

#include <batten/sweep.h>

static const batten_parameter parameters[] = {
    {"swing", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the profiles, in the xz-plane"},
    {"path", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "the trajectory around the z-axis, in the xy-plane"},
    {"factor", BATTEN_VALUE_NUMBER, false, false, "1", NULL,
     "what the widths are multiplied by"},
};

static batten_status swing(bat_run *run, const batten_object *profile,
                           const batten_curve *trajectory)
{
    batten_surface *surface = NULL;
    batten_surface_swung_report report;
    batten_status status = batten_surface_swung(profile->curve, trajectory,
                                                bat_number(run, "factor"), &report, &surface);
    if (status == BATTEN_OK && report.least_x < 0 && report.largest_x > 0)
        bat_note(run,
                 "'%s' has control points from x = %g to %g: where it crosses the axis the "
                 "surface cuts through itself",
                 profile->name, report.least_x, report.largest_x);
    if (status == BATTEN_OK && report.least_radius <= bat_tolerance(run))
        bat_note(run,
                 "the trajectory comes within %g of the axis: the surface is pinched there",
                 report.least_radius);
    return bat_put_surface_like(run, status, surface, profile);
}

static batten_status run_swing(bat_run *run)
{
    const batten_curve *trajectory = NULL;
    bat_objects profiles;
    batten_status status = bat_one_curve(run, "path", &trajectory);
    if (status == BATTEN_OK)
        status = bat_gather(run, "swing", BAT_CURVES, &profiles);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < profiles.count && status == BATTEN_OK; i++)
        status = swing(run, profiles.at[i], trajectory);
    bat_objects_release(&profiles);
    return status;
}

const bat_feature bat_feature_swing = {
    .shown =
        {"swing", "A profile swung along a trajectory around the z-axis",
         "Exact. At each height the trajectory is scaled by the width of the profile there; a\n"
         "circle of radius 1 makes the surface of revolution. The profile lies in the xz-plane,\n"
         "the trajectory in the xy-plane around the origin; the widths of the two are multiplied,\n"
         "in units of the design, and by the factor.",
         "units: m\n"
         "features:\n"
         "  profile: {line: [[1, 0, 0], [0.6, 0, 2]]}\n"
         "  plan: {ellipse: 1.5 m, b: 1 m}\n"
         "  vase: {swing: profile, path: plan}\n",
         "[LN12 section 12.8] [PT97 section 10.2]", "batten_surface_swung",
         BAT_PARAMETERS(parameters), false,
         .also = "swung surface, Woodward, pseudo-revolution",
         .formula = "    S(u, v) = (α Px(u) Tx(v), α Px(u) Ty(v), Pz(u))",
         .promise = "It is exact."},
    .run = run_swing,
    .displacing = "swing"};
