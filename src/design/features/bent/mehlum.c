/* The feature 'mehlum': the mechanical spline as a chain of arcs, as KURGLA and AUTOKON
 * had it. */
#include "design/shared/nonlinear.h"

static const batten_parameter parameters[] = {
    {"mehlum", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"arcs", BATTEN_VALUE_COUNT, false, false, "4", NULL, "in each span, 2 or more"},
    {"within", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "more arcs where they are farther than this from the elastica; 0: the same number everywhere"},
    BAT_EACH,
    BAT_NONLINEAR_ENDS,
    BAT_CLOSED,
};

static batten_status make_mehlum(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_chain_mehlum_options options = batten_chain_mehlum_defaults();
    batten_chain_mehlum_report report;
    options.closed = bat_yes(run, "closed");
    options.arcs = bat_count(run, "arcs");
    options.tolerance = bat_number(run, "within");
    options.start = bat_nonlinear_end_of(run, true, &options.start_value);
    options.end = bat_nonlinear_end_of(run, false, &options.end_value);
    const batten_status status =
        batten_chain_mehlum((batten_points){2, data->count, data->points}, &options, NULL,
                            made->parameters, &report, &made->chain);
    if (status == BATTEN_OK)
        bat_remark(run,
                   "'%s': %d arcs, %g from the elastica at most; curvature steps by up to %g",
                   data->name, report.arcs, report.error, report.jump);
    return status;
}

static batten_status run_mehlum(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make_mehlum};
    return bat_through(run, &method);
}

const bat_feature bat_feature_mehlum = {
    .shown =
        {"mehlum", "The mechanical spline as a chain of arcs, as KURGLA and AUTOKON had it",
         "For machines and drawings that know only arcs, when the shape should still be that of a\n"
         "batten: each span of the elastica through the points becomes a few arcs of equal length,\n"
         "tangent to one another, whose curvatures follow that of the batten in steps. The points,\n"
         "and the directions at them, are those of the elastica; with twice as many arcs the chain\n"
         "is eight times as close. 'within' uses as many arcs as that distance needs. The\n"
         "distance, and the largest step of curvature, are noted. It exists where 'elastica' does.\n"
         "For the fewest arcs near any curve use 'arcs'. End conditions are those of 'elastica'.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 10 cm]]}\n"
         "  frame: {mehlum: ducks, within: 1 mm}\n",
         "[SL section VI.3] [Utah74 paper 9] [Mehlum64] [Mehlum74]", "batten_chain_mehlum",
         BAT_PARAMETERS(parameters), false,
         .also = "KURGLA, AUTOKON, nonlinear spline, stepped curvature",
         .formula =
             "    arcs of equal length h along the elastica 2 κ″ + κ³ = 0, tangent to one another;  curvature a step function",
         .promise =
             "Points and directions there are those of the elastica; the distance from it falls with h³."},
    .run = run_mehlum};
