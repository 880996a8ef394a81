#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"circle-tangents", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"lengths", BATTEN_VALUE_WORD, false, false, "chord", "chord middle",
     "steps of the parameter: the chords, or such that spans have speed 1 in the middle too"},
    BAT_EACH,
    BAT_CLOSED,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_tangents_options options = batten_tangents_defaults();
    options.rule = BATTEN_TANGENT_CIRCLE;
    options.length = bat_word(run, "lengths") == 0 ? BATTEN_LENGTH_CHORD : BATTEN_LENGTH_MIDDLE;
    options.closed = bat_yes(run, "closed");
    return bat_make_of_tangents(run, data, &options, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_circle_tangents = {
    .shown =
        {"circle-tangents", "Cubics with the tangents of circles through three points",
         "The safe choice when nothing is known but the points: at each point the curve has the\n"
         "direction of the circle through it and its two neighbours, so points of a circle get its\n"
         "exact tangents. Cubic, with continuous first derivative, speed 1 at every point. A point\n"
         "moved changes four spans and no more. With 'lengths: middle' wide turns are rounder\n"
         "(mcconalogue). Curvature jumps at the points: for fair lines use interpolate or euler-\n"
         "spiral. Where the points turn back on themselves a tangent at right angles is taken, and\n"
         "noted.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm], [4 m, 0]]}\n"
         "  sheer: {circle-tangents: ducks}\n",
         "[McConalogue70], [SL]", "batten_tangents", BAT_PARAMETERS(parameters), false},
    .run = run};
