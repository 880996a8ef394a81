#include "design/shared/nonlinear.h"

static const batten_parameter parameters[] = {
    {"local-cubic", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_NONLINEAR_ENDS,
    BAT_CLOSED,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    return bat_nonlinear_make(run, data, BATTEN_FAMILY_LOCAL_CUBIC, NULL, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_local_cubic = {
    .shown =
        {"local-cubic", "A cubic function over each chord, curvature continuous",
         "The cubic spline function, but each span measured from its own chord: so steep and closed curves\n"
         "are drawn, and the result turns with the points. For smooth data with turns below some 60\n"
         "degrees; the result is exact cubics. Where the points bend little it is the natural\n"
         "cubic spline. Tangents stay below a right angle from the chord, and beyond 35 degrees\n"
         "the equations grow weak: use euler-spiral there. Points at equal steps of a circle give\n"
         "its tangents, and a curvature that is smaller by the square of half the turn.\n"
         "What holds at the ends is said by 'ends', or 'start' and 'end': 'natural' is curvature 0,\n"
         "'circular' the same curvature at both ends of the last span; 'tangent' takes its direction from\n"
         "'start-angle' and 'end-angle', 'curvature' its value from 'start-curvature' and\n"
         "'end-curvature'.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm]]}\n"
         "  batten: {local-cubic: ducks}\n",
         "[SL]", "batten_chain_nonlinear", BAT_PARAMETERS(parameters), false},
    .run = run};
