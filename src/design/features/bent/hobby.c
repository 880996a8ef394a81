#include "design/shared/nonlinear.h"

static const batten_parameter parameters[] = {
    {"hobby", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_NONLINEAR_ENDS,
    BAT_CLOSED,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    return bat_nonlinear_make(run, data, BATTEN_FAMILY_HOBBY, NULL, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_hobby = {
    .shown =
        {"hobby", "The curves of Metafont and MetaPost",
         "One cubic for each span, from one linear system: curvature is taken as if the angles were small,\n"
         "and the lengths of the tangents are those of Hobby. Quick, and pleasing for letters and\n"
         "drawings; a circle through four points is off by 0.03 percent. Curvature has small steps\n"
         "at the points; use euler-spiral where it must not. 'ends: circular' is the curl of\n"
         "1 that Metafont takes by itself.\n"
         "What holds at the ends is said by 'ends', or 'start' and 'end': 'natural' is curvature 0,\n"
         "'circular' the same curvature at both ends of the last span; 'tangent' takes its direction from\n"
         "'start-angle' and 'end-angle', 'curvature' its value from 'start-curvature' and\n"
         "'end-curvature'.",
         "features:\n"
         "  nodes: {points: [[0, 0], [1 m, 60 cm], [2 m, 40 cm], [1.5 m, -30 cm]]}\n"
         "  letter: {hobby: nodes, closed: yes}\n",
         "[Hobby86]", "batten_chain_nonlinear", BAT_PARAMETERS(parameters), false},
    .run = run};
