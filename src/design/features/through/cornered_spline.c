/* The feature 'cornered-spline': a spline through points with corners and straight runs. */
#include "design/shared/through.h"
#include <batten/local.h>

static const batten_parameter parameters[] = {
    {"cornered-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "rows of points, a table of offsets, or curves that have points"},
    BAT_EACH,
    {"corners", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "points where the direction may jump, counted from 1"},
    {"lines", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "points from which the curve is straight to the next, counted from 1"},
    {"transition", BATTEN_VALUE_WORD, false, false, "tangent", "tangent curvature",
     "how a curve passes into a straight run: with its direction, and with curvature 0"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "chord",
     "centripetal chord uniform foley foley-chord", "how points get parameters"},
    {"ends", BATTEN_VALUE_WORD, false, false, "natural",
     "natural not-a-knot parabolic bessel circle", "what holds at corners and free ends"},
};

static batten_status make_cornered_spline(bat_run *run, const bat_data *data, bat_made *made)
{
    static const batten_end_kind ends[] = {BATTEN_END_NATURAL, BATTEN_END_NOT_A_KNOT,
                                           BATTEN_END_PARABOLIC, BATTEN_END_BESSEL,
                                           BATTEN_END_CIRCLE};
    batten_curve_cornered_options options = batten_curve_cornered_defaults();
    int *corners = NULL, *lines = NULL;
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    options.transition = (batten_transition)bat_word(run, "transition");
    options.ends = ends[bat_word(run, "ends")];
    batten_status status = bat_indices(run, "corners", &options.corner_count, &corners);
    if (status == BATTEN_OK)
        status = bat_indices(run, "lines", &options.line_count, &lines);
    options.corners = corners;
    options.lines = lines;
    if (status == BATTEN_OK)
        status =
            batten_curve_cornered((batten_points){data->dimension, data->count, data->points},
                                  &options, made->parameters, &made->curve);
    bat_release(corners);
    bat_release(lines);
    return status;
}

static batten_status run_cornered_spline(bat_run *run)
{
    const bat_method method = {.least = 2, .ways = BAT_IN_SPACE, .make = make_cornered_spline};
    return bat_through(run, &method);
}

const bat_feature bat_feature_cornered_spline = {
    .shown =
        {"cornered-spline", "A spline through points with corners and straight runs",
         "For outlines that are smooth in parts: a keel with a straight run, a bracket, a letter.\n"
         "The points in 'corners' end one smooth run and start the next; from those in 'lines' the\n"
         "curve is straight to the next point, and the runs beside it start in the direction of\n"
         "the line. 'transition: curvature' also lets them start with curvature 0, as a fair curve\n"
         "does; a free end of such a run can be 'natural', while the other 'ends' leave its\n"
         "curvature free. A point between two straight runs is a corner. Points are counted from\n"
         "0. Where corners stand close together a smooth run has few points and little reason to\n"
         "bend: one span alone between two corners is straight.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1, 1], [2, 1.2], [3, 1], [5, 0.5], [6, 0.6], [6.6, 1.2]]}\n"
         "  keel: {cornered-spline: ducks, lines: [4], corners: [2], transition: curvature}\n",
         "[SL section III.7]", "batten_curve_cornered", BAT_PARAMETERS(parameters), false,
         .also = "corners, knuckles, straight runs, piecewise spline",
         .formula =
             "    on each run between corners: S(t_i) = P_i, S″ continuous;  at a line: S′ ∥ the line, with transition curvature also κ = 0",
         .promise =
             "The second derivative is continuous on each smooth run; straight runs are straight exactly."},
    .run = run_cornered_spline};
