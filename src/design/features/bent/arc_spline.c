#include "design/shared/nonlinear.h"

static const batten_parameter parameters[] = {
    {"arc-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_NONLINEAR_ENDS,
    BAT_CLOSED,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    return bat_nonlinear_make(run, data, BATTEN_FAMILY_ARCS, NULL, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_arc_spline = {
    .shown =
        {"arc-spline", "One circular arc at each point, joined tangentially",
         "For machines and templates with the fewest arcs: each point lies inside its own arc, and\n"
         "neighbours meet on the bisector of the chord between. Points of a circle give the circle.\n"
         "Curvature is a step function; where the points wind, the steps are large: biarcs are more\n"
         "even there.\n"
         "What holds at the ends is said by 'ends', or 'start' and 'end': 'natural' is curvature 0,\n"
         "'circular' the same curvature at both ends of the last span; 'tangent' takes its direction from\n"
         "'start-angle' and 'end-angle', 'curvature' its value from 'start-curvature' and\n"
         "'end-curvature'.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 80 cm], [3 m, 30 cm]]}\n"
         "  template: {arc-spline: ducks, ends: circular}\n",
         "[SL]", "batten_chain_nonlinear", BAT_PARAMETERS(parameters), false},
    .run = run};
