#include "design/shared/nonlinear.h"

static const batten_parameter parameters[] = {
    {"euler-spiral", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_NONLINEAR_ENDS,
    BAT_CLOSED,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    return bat_nonlinear_make(run, data, BATTEN_FAMILY_EULER_SPIRAL, NULL, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_euler_spiral = {
    .shown =
        {"euler-spiral", "Curvature linear in arc length: clothoids",
         "For roads and rails, and for any plane curve that shall not change its bend abruptly. Points of a\n"
         "circle give the circle, and a point of the curve added to the points changes nothing.\n"
         "Of all nonlinear splines it stands the sharpest turns: up to 176 degrees between tangent and\n"
         "chord. The curve is kept as clothoids, exactly. It moves as a whole when one point\n"
         "moves, though little far away, and does not depend on how the points are turned or scaled.\n"
         "What holds at the ends is said by 'ends', or 'start' and 'end': 'natural' is curvature 0,\n"
         "'circular' the same curvature at both ends of the last span; 'tangent' takes its direction from\n"
         "'start-angle' and 'end-angle', 'curvature' its value from 'start-curvature' and\n"
         "'end-curvature'.\n"
         "Points that turn back on themselves are refused; turns beyond 120 degrees are noted.",
         "features:\n"
         "  stakes: {points: [[0, 0], [60 m, 25 m], [130 m, 20 m], [200 m, 60 m]]}\n"
         "  road: {euler-spiral: stakes, ends: circular}\n",
         "[BF15]", "batten_chain_nonlinear", BAT_PARAMETERS(parameters), false},
    .run = run};
