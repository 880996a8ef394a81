/* The feature 'biarcs': two arcs between any two points, with smooth tangents. */
#include "base/plural.h"
#include "design/shared/through.h"
#include <batten/arcs.h>

static const batten_parameter parameters[] = {
    {"biarcs", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    {"joint", BATTEN_VALUE_WORD, false, false, "automatic",
     "automatic equal-chord equal-legs least-ratio least-curvature given",
     "where the two arcs of a span meet"},
    {"place", BATTEN_VALUE_NUMBER, false, false, "0.5", NULL,
     "of 'joint: given', from 0 at the start of a span to 1 at its end"},
    {"in", BATTEN_VALUE_WORD, false, false, "plane", "plane space",
     "arcs in the plane of the points, or a curve in space with equal legs"},
    BAT_CLOSED,
};

static batten_chain_biarcs_options options_of(const bat_run *run)
{
    batten_chain_biarcs_options options = batten_chain_biarcs_defaults();
    options.joint = (batten_biarc_joint)bat_word(run, "joint");
    options.place = bat_number(run, "place");
    options.closed = bat_yes(run, "closed");
    return options;
}

static batten_status in_plane(bat_run *run, const bat_data *data, bat_made *made)
{
    const batten_chain_biarcs_options options = options_of(run);
    batten_chain_biarcs_report report;
    const batten_status status =
        batten_chain_biarcs((batten_points){2, data->count, data->points}, &options,
                            made->parameters, &report, &made->chain);
    if (status == BATTEN_OK && report.long_arcs > 0)
        bat_note(run, "'%s' has %d arc%s turning by more than 180 degrees", data->name,
                 report.long_arcs, bat_plural(report.long_arcs));
    return status;
}

static batten_status in_space(bat_run *run, const bat_data *data, bat_made *made)
{
    const batten_chain_biarcs_options options = options_of(run);
    return batten_curve_biarcs((batten_points){data->dimension, data->count, data->points},
                               &options, made->parameters, &made->curve);
}

static batten_status run_biarcs(bat_run *run)
{
    static const bat_method plane = {2, BAT_IN_PLANE, in_plane},
                            space = {2, BAT_IN_SPACE, in_space};
    return bat_through(run, bat_word(run, "in") == 1 ? &space : &plane);
}

const bat_feature bat_feature_biarcs = {
    .shown =
        {"biarcs", "Two arcs between any two points, with smooth tangents",
         "For shapes that a machine or a draughtsman makes of arcs: templates, plates, tool paths.\n"
         "The direction at a point is that of the circle through it and its neighbours; between\n"
         "two points two arcs meet with a common tangent at the 'joint'. 'equal-chord' makes the\n"
         "step of curvature least, 'least-ratio' the radii most alike, 'least-curvature' the\n"
         "smaller radius as large as possible, 'equal-legs' the legs of the control polygon equal.\n"
         "'automatic' is equal-chord, and least-ratio where equal-chord would bend both ways\n"
         "between points that turn one way. Points of a circle give the circle. Curvature has\n"
         "steps at points and joints; moving a point changes four spans, two on either side. Where\n"
         "the points turn sharply arcs can turn by more than 180 degrees, which is noted; points\n"
         "that turn back on themselves are refused. In space, 'joint' is not used, and the arcs\n"
         "lie in different planes.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 40 cm], [3 m, 1 m]]}\n"
         "  template: {biarcs: ducks, joint: equal-chord}\n",
         "[SL section VI.4] [Bolton75]", "batten_chain_biarcs", BAT_PARAMETERS(parameters),
         false, .also = "biarc, Bolton, double arcs, arc pairs",
         .formula = "    V·V − 2 d0 V·T0 − 2 d1 V·T1 + 2 d0 d1 (T0·T1 − 1) = 0,  V = P1 − P0\n"
                    "    J = (d1 (P0 + d0 T0) + d0 (P1 − d1 T1))/(d0 + d1)",
         .promise =
             "Tangents are continuous; with the joint at equal chords the step of curvature is the least of all joints."},
    .run = run_biarcs};
