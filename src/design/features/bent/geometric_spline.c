#include "design/shared/nonlinear.h"

static const batten_parameter parameters[] = {
    {"geometric-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_NONLINEAR_ENDS,
    BAT_CLOSED,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    return bat_nonlinear_make(run, data, BATTEN_FAMILY_GEOMETRIC, NULL, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_geometric_spline = {
    .shown =
        {"geometric-spline", "Curvature linear along each chord",
         "The beam without the assumption of small slopes, but with loads at right angles to each chord:\n"
         "curvature is linear in the abscissa along the chord. Between cubic functions and the\n"
         "elastica, and round: points of a circle give the circle. Tangents stay below a\n"
         "right angle from the chord; use euler-spiral where they do not.\n"
         "What holds at the ends is said by 'ends', or 'start' and 'end': 'natural' is curvature 0,\n"
         "'circular' the same curvature at both ends of the last span; 'tangent' takes its direction from\n"
         "'start-angle' and 'end-angle', 'curvature' its value from 'start-curvature' and\n"
         "'end-curvature'.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 10 cm]]}\n"
         "  batten: {geometric-spline: ducks}\n",
         "[SL]", "batten_chain_nonlinear", BAT_PARAMETERS(parameters), false},
    .run = run};
