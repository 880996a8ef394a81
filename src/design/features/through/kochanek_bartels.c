/* The feature 'kochanek-bartels': cubics shaped point by point: tension, continuity and
 * bias. */
#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"kochanek-bartels", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"tension", BATTEN_VALUE_NUMBER, true, false, "0", NULL,
     "at all points or one for each: 1 halts at the point, -1 swings wide"},
    {"continuity", BATTEN_VALUE_NUMBER, true, false, "0", NULL,
     "the same: -1 makes a corner of the polygon, 1 one that points inwards"},
    {"bias", BATTEN_VALUE_NUMBER, true, false, "0", NULL,
     "the same: 1 overshoots the point, -1 turns before it"},
    BAT_CHORD_POWER("0"),
    BAT_PHANTOMS,
    BAT_AS,
    BAT_EACH,
    BAT_CLOSED,
};

static batten_status make_kochanek_bartels(bat_run *run, const bat_data *data, bat_made *made)
{
    static const char *const names[] = {"tension", "continuity", "bias"};
    batten_tangents_kochanek_bartels_options options =
        batten_tangents_kochanek_bartels_defaults();
    double *lists[3] = {NULL};
    batten_status status = BATTEN_OK;
    for (int l = 0; l < 3 && status == BATTEN_OK; l++)
        status = bat_numbers_each(run, names[l], data->count, "points", &lists[l]);
    options.tension = lists[0];
    options.continuity = lists[1];
    options.bias = lists[2];
    if (status == BATTEN_OK)
        status = bat_make_kochanek_bartels(run, data, &options, made);
    for (int l = 0; l < 3; l++)
        bat_release(lists[l]);
    return status;
}

static batten_status run_kochanek_bartels(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_kochanek_bartels};
    return bat_through(run, &method);
}

const bat_feature bat_feature_kochanek_bartels = {
    .shown =
        {"kochanek-bartels", "Cubics shaped point by point: tension, continuity and bias",
         "Made for paths of moving things: three numbers at each point say how the curve passes\n"
         "it. Tension tightens, continuity below or above 0 makes a corner, bias moves the bend\n"
         "behind the point or before it; 0 for all three is 'catmull-rom'. Useful numbers lie\n"
         "between -1 and 1. A point and its numbers affect four spans. Not for fair lines:\n"
         "curvature jumps at the points, and where continuity is not 0 the direction does. Steps\n"
         "are equal by default; 'alpha: 0.5' suits uneven points.",
         "features:\n"
         "  keys: {points: [[0, 0], [1 m, 60 cm], [2 m, 0], [3 m, 60 cm], [4 m, 0]]}\n"
         "  path: {kochanek-bartels: keys, tension: [0, 0.5, 0, 0, 0], continuity: [0, 0, -1, 0, 0]}\n",
         "[KB84]", "batten_tangents_kochanek_bartels", BAT_PARAMETERS(parameters), false,
         .also = "TCB spline, tension continuity bias, keyframe, animation path",
         .formula =
             "    T_i⁺ = ½ (1−τ) ((1+c)(1+b) (P_i − P_{i−1}) + (1−c)(1−b) (P_{i+1} − P_i))   (equal steps)\n"
             "    T_i⁻ = ½ (1−τ) ((1−c)(1+b) (P_i − P_{i−1}) + (1+c)(1−b) (P_{i+1} − P_i))",
         .promise =
             "Where c is 0 the tangent is continuous; a point and its numbers change four spans."},
    .run = run_kochanek_bartels};
