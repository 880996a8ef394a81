/* The feature 'minimum-energy': the curve that bends least, in the plane or in space. */
#include "design/features/bent/energy.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"minimum-energy", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_ENERGY_PARAMETERS,
};

/* A smaller part of the energy that is left is nothing to speak of. */
static const double SETTLED = 1e-9;

static batten_status make_minimum_energy(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_minimum_energy_options options = batten_curve_minimum_energy_defaults();
    options.energy = strcmp(run->feature->name, "minimum-energy") == 0
                         ? BATTEN_ENERGY_BENDING
                         : BATTEN_ENERGY_VARIATION;
    options.closed = bat_yes(run, "closed");
    options.tension = bat_number(run, "tension");
    options.scale_invariant = bat_yes(run, "scale-invariant");
    options.pieces = bat_count(run, "pieces");
    batten_curve_minimum_energy_report report;
    const batten_status status =
        batten_curve_minimum_energy((batten_points){data->dimension, data->count, data->points},
                                    &options, made->parameters, &report, &made->curve);
    if (status == BATTEN_OK && report.tension > 0)
        bat_remark(run,
                   "'%s': there is no least, the curve bends less and less by growing; this is "
                   "the least near a length of %g, as with 'tension: %g'",
                   data->name, report.length, report.tension);
    if (status == BATTEN_OK && report.remaining > SETTLED * report.after)
        bat_remark(run, "'%s': the energy is %g and may fall by another %g", data->name,
                   report.after, report.remaining);
    return status;
}

batten_status bat_least_energy(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE, make_minimum_energy};
    return bat_through(run, &method);
}

const bat_feature bat_feature_minimum_energy = {
    .shown =
        {"minimum-energy", "The curve that bends least, in the plane or in space",
         "Quintics with continuous curvature whose integral of squared curvature is a minimum near\n"
         "the elastica or the cubic spline through the points. In the plane 'elastica' gives the\n"
         "same curve exactly; this one also works in space and under tension. Where a curve could\n"
         "bend less and less by growing there is no minimum: a tension then holds it at about\n"
         "the length of the other curves through the points, which all bend more; a remark says\n"
         "so. Points on one line that turn back are refused.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 10 cm]]}\n"
         "  strip: {minimum-energy: ducks}\n",
         "[Horn83], [MS92]", "batten_curve_minimum_energy", BAT_PARAMETERS(parameters), false,
         .also = "MEC, minimal energy curve, least bending, Horn",
         .formula =
             "    ∫ |κ|² ds + tension · length → minimum,  S(t_i) = P_i,  curvature continuous",
         .promise =
             "The least of quintics with continuous curvature near the start, measured on what is delivered."},
    .run = bat_least_energy};
