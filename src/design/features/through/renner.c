#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"renner", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"corners", BATTEN_VALUE_WORD, false, false, "round", "round keep",
     "between two straight runs"},
    BAT_EACH,
    BAT_CLOSED,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_tangents_options options = batten_tangents_defaults();
    options.rule = BATTEN_TANGENT_RENNER;
    options.length = BATTEN_LENGTH_MIDDLE;
    options.corners = (batten_corner)bat_word(run, "corners");
    options.closed = bat_yes(run, "closed");
    return bat_make_of_tangents(run, data, &options, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_renner = {
    .shown =
        {"renner", "Cubics that keep straight runs straight, with nearly even speed",
         "For outlines with straight parts and rounded ones in one row of points; corners stay only\n"
         "with 'corners: keep'. Three points in line\n"
         "give an exactly straight piece, without the waves of a spline beside it. Tangents weigh both\n"
         "chords by the areas of the triangles beyond them, as Akima does with slopes; each span has\n"
         "speed 1 at its ends and in its middle. A point between two straight runs is rounded, or with\n"
         "'corners: keep' stays a corner. A point moved changes six spans. Curvature jumps at the\n"
         "points.",
         "features:\n"
         "  plate: {points: [[0, 0], [1 m, 0], [2 m, 0], [2.6 m, 0.4 m], [2.6 m, 1 m], [2.6 m, 2 m]]}\n"
         "  outline: {renner: plate}\n",
         "[Renner82], [PT97]", "batten_tangents", BAT_PARAMETERS(parameters), false},
    .run = run};
