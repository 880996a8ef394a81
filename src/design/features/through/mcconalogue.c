#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"mcconalogue", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_CLOSED,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_tangents_options options = batten_tangents_defaults();
    options.rule = BATTEN_TANGENT_CIRCLE;
    options.length = BATTEN_LENGTH_MIDDLE;
    options.closed = bat_yes(run, "closed");
    return bat_make_of_tangents(run, data, &options, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_mcconalogue = {
    .shown =
        {"mcconalogue", "Cubics with circle tangents and nearly even speed",
         "The tangents of circles through three points, and steps of the parameter such that each span\n"
         "has speed 1 at its ends and in its middle: the parameter is nearly the length of the curve.\n"
         "Four points of a circle already look round. Local: a point moved changes four spans.\n"
         "Curvature jumps at the points, little where they are close. Where neighbouring chords differ\n"
         "much in length, or the turns are sharp, it bulges towards the longer one.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm], [4 m, 0]]}\n"
         "  sheer: {mcconalogue: ducks}\n",
         "[McConalogue70]", "batten_tangents", BAT_PARAMETERS(parameters), false},
    .run = run};
