/* The local cubics whose tangents follow a rule with even steps: a row each. */
#include "design/shared/local.h"

#include <string.h>

static const batten_parameter circle_tangents_parameters[] = {
    {"circle-tangents", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"lengths", BATTEN_VALUE_WORD, false, false, "chord", "chord middle",
     "steps of the parameter: the chords, or such that spans have speed 1 in the middle too"},
    BAT_EACH,
    BAT_CLOSED,
};

static const batten_parameter mcconalogue_parameters[] = {
    {"mcconalogue", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_CLOSED,
};

static const batten_parameter renner_parameters[] = {
    {"renner", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"corners", BATTEN_VALUE_WORD, false, false, "round", "round keep",
     "between two straight runs"},
    BAT_EACH,
    BAT_CLOSED,
};

static bool has_parameter(const bat_run *run, const char *name)
{
    for (int i = 0; i < run->feature->parameter_count; i++)
        if (strcmp(run->feature->parameters[i].name, name) == 0)
            return true;
    return false;
}

static batten_status make_cubics(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_tangents_options options = batten_tangents_defaults();
    options.rule = (batten_tangent_rule)run->family;
    options.length = has_parameter(run, "lengths") && bat_word(run, "lengths") == 0
                         ? BATTEN_LENGTH_CHORD
                         : BATTEN_LENGTH_MIDDLE;
    if (has_parameter(run, "corners"))
        options.corners = (batten_corner)bat_word(run, "corners");
    options.closed = bat_yes(run, "closed");
    return bat_make_of_tangents(run, data, &options, made);
}

static batten_status draw_cubics(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE, make_cubics};
    return bat_through(run, &method);
}

const bat_feature bat_feature_circle_tangents = {
    .shown =
        {"circle-tangents", "Cubics with the tangents of circles through three points",
         "The safe choice when nothing is known but the points: at each point the curve has the\n"
         "direction of the circle through it and its two neighbours, so points of a circle get its\n"
         "exact tangents. Cubic, with continuous first derivative, speed 1 at every point. Moving\n"
         "a point changes four spans and no more. With 'lengths: middle' wide turns are rounder\n"
         "(mcconalogue). Curvature jumps at the points: for fair lines use interpolate or\n"
         "euler-spiral. Where the points turn back on themselves the tangent is taken at right\n"
         "angles, which is noted.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm], [4 m, 0]]}\n"
         "  sheer: {circle-tangents: ducks}\n",
         "[SL section VI.8] [McConalogue70]", "batten_tangents",
         BAT_PARAMETERS(circle_tangents_parameters), false,
         .also = "circle through three points, osculating circle",
         .formula =
             "    T_i ∥ q_{i−1}/|q_{i−1}|² + q_i/|q_i|²,  q_i = P_{i+1} − P_i,  |T_i| = 1;  cubics of Hermite between",
         .promise = "Points of a circle get its tangents exactly; a point changes four spans."},
    .run = draw_cubics,
    .family = BATTEN_TANGENT_CIRCLE};

const bat_feature bat_feature_mcconalogue = {
    .shown =
        {"mcconalogue", "Cubics with circle tangents and nearly even speed",
         "The tangents of circles through three points, and steps of the parameter such that each\n"
         "span has speed 1 at its ends and in its middle: the parameter is nearly the length of\n"
         "the curve. Four points of a circle already look round. Local: moving a point changes\n"
         "four spans. Curvature jumps at the points, little where they are close. Where\n"
         "neighbouring chords differ much in length, or the turns are sharp, it bulges towards the\n"
         "longer one.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm], [4 m, 0]]}\n"
         "  sheer: {mcconalogue: ducks}\n",
         "[SL section VI.8] [McConalogue70]", "batten_tangents",
         BAT_PARAMETERS(mcconalogue_parameters), false,
         .also = "McConalogue, plotter curve, quasi-intrinsic",
         .formula =
             "    T_i ∥ q_{i−1}/|q_{i−1}|² + q_i/|q_i|²,  |T_i| = 1;  step h:  |3 q_i/(2 h) − (T_i + T_{i+1})/4| = 1",
         .promise =
             "Each span has speed 1 at its ends and in its middle: the parameter is the arc length by the rule of Simpson."},
    .run = draw_cubics,
    .family = BATTEN_TANGENT_CIRCLE};

const bat_feature bat_feature_renner = {
    .shown =
        {"renner", "Cubics that keep straight runs straight, with nearly even speed",
         "For outlines with straight parts and rounded ones in one row of points; corners stay\n"
         "only with 'corners: keep'. Three points in line give an exactly straight piece, without\n"
         "the waves of a spline beside it. Tangents weigh both chords by the areas of the\n"
         "triangles beyond them, as Akima does with slopes; each span has speed 1 at its ends and\n"
         "in its middle. A point between two straight runs is rounded, or with 'corners: keep'\n"
         "stays a corner. Moving a point changes six spans. Curvature jumps at the points.",
         "features:\n"
         "  plate: {points: [[0, 0], [1 m, 0], [2 m, 0], [2.6 m, 0.4 m], [2.6 m, 1 m], [2.6 m, 2 m]]}\n"
         "  outline: {renner: plate}\n",
         "[SL section VI.8] [Renner82] [PT97 section 9.3.1]", "batten_tangents",
         BAT_PARAMETERS(renner_parameters), false, .also = "straight runs, even speed",
         .formula =
             "    T_i ∥ (1 − a) q_{i−1} + a q_i,  a = |q_{i−2} × q_{i−1}| / (|q_{i−2} × q_{i−1}| + |q_i × q_{i+1}|),  q_i = P_{i+1} − P_i\n"
             "    |T_i| = 1, and the step h with |S′| = 1 in the middle of the span",
         .promise =
             "Three points in line give exactly that line; each span has speed 1 at its ends and in its middle."},
    .run = draw_cubics,
    .family = BATTEN_TANGENT_RENNER};
