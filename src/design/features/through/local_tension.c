/* The feature 'local-tension': local cubics pulled towards their chords. */
#include "design/shared/nonlinear.h"

static const batten_parameter parameters[] = {
    {"local-tension", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    {"tension", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "of every span, sigma times its chord, 0 or more; left out: as much as it takes"},
    BAT_NONLINEAR_ENDS,
    BAT_CLOSED,
};

/* The same tension for every span. */
static batten_status in_tension(bat_run *run, const bat_data *data, bat_made *made)
{
    double *tensions = bat_array((size_t)data->count, sizeof *tensions);
    if (!tensions)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < data->count; i++)
        tensions[i] = bat_number(run, "tension");
    const batten_status status =
        bat_nonlinear_make(run, data, BATTEN_FAMILY_LOCAL_TENSION, tensions, made);
    bat_release(tensions);
    return status;
}

static batten_status make_local_tension(bat_run *run, const bat_data *data, bat_made *made)
{
    if (bat_has(run, "tension"))
        return in_tension(run, data, made);
    return bat_nonlinear_make(run, data, BATTEN_FAMILY_LOCAL_TENSION, NULL, made);
}

static batten_status run_local_tension(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make_local_tension};
    return bat_through(run, &method);
}

const bat_feature bat_feature_local_tension = {
    .shown =
        {"local-tension", "Local cubics pulled towards their chords",
         "As local-cubic, but each span is a spline in tension over its chord. Without 'tension'\n"
         "each span gets as much as is needed for the curve to bend to one side where the points\n"
         "do: no waves beside flat parts. With it every span gets the same: 0 is local-cubic, 10\n"
         "is nearly the polygon with rounded corners. Tangents stay below a right angle from the\n"
         "chord; where the points turn sharply between spans in tension there may be no solution:\n"
         "use euler-spiral there.\n\n" BAT_NONLINEAR_ENDS_TEXT,
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 1 cm], [2 m, 4 cm], [3 m, 30 cm], [4 m, 150 cm]]}\n"
         "  batten: {local-tension: ducks}\n",
         "[SL section VI.7]", "batten_chain_nonlinear", BAT_PARAMETERS(parameters), false,
         .also = "local spline in tension, secant frame",
         .formula =
             "    η⁗ = σ² η″ over the chord,  η(0) = η(l) = 0,  η′(0) = tan α,  η′(l) = tan β;  κ continuous at the points",
         .promise =
             "Curvature is continuous; without a given tension each span gets what keeps it bent to one side where its data are."},
    .run = run_local_tension};
