#include "design/shared/nonlinear.h"

static const batten_parameter parameters[] = {
    {"elastica", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_NONLINEAR_ENDS,
    BAT_CLOSED,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    return bat_nonlinear_make(run, data, BATTEN_FAMILY_ELASTICA, NULL, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_elastica = {
    .shown =
        {"elastica", "The mechanical spline: a thin beam held at the points",
         "What a batten truly does: between the ducks no load acts, so each span is an elastica, and the\n"
         "bending energy is stationary. The fairest curve in that sense, but not round: points\n"
         "of a circle do not give a circle. It exists only while the beam need not bend too much:\n"
         "between tangent and chord 90 degrees at most where both ends of a span stand alike, and up to 124\n"
         "where one lies along the chord; beyond, use euler-spiral, its near relative. With\n"
         "'natural' ends the beam ends freely.\n"
         "What holds at the ends is said by 'ends', or 'start' and 'end': 'natural' is curvature 0,\n"
         "'circular' the same curvature at both ends of the last span; 'tangent' takes its direction from\n"
         "'start-angle' and 'end-angle', 'curvature' its value from 'start-curvature' and\n"
         "'end-curvature'.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 10 cm]]}\n"
         "  batten: {elastica: ducks}\n",
         "[LF73]", "batten_chain_nonlinear", BAT_PARAMETERS(parameters), false},
    .run = run};
