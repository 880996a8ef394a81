#include "design/near.h"

static const batten_parameter parameters[] = {
    {"least-squares", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "points, or a table of offsets"},
    {"points", BATTEN_VALUE_COUNT, false, false, "0", NULL,
     "how many control points; 0: one for every four points"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "1 to 25"},
    BAT_PARAMETRIZATION,
    {"knots", BATTEN_VALUE_WORD, false, false, "data", "data curvature",
     "as many points between any two, or close where the curve bends"},
    {"corrections", BATTEN_VALUE_COUNT, false, false, "10", NULL,
     "of a curve: how often at most points get the parameters of their feet"},
    {"hold-ends", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "an open curve begins and ends in the end points"},
    BAT_CLOSED,
    BAT_AS,
    BAT_EACH,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_least_squares_options options = batten_least_squares_defaults();
    options.degree = bat_count(run, "degree");
    options.point_count = bat_count(run, "points");
    options.parameters = bat_parametrization_of(run, data);
    options.given = data->abscissae;
    options.knots = (batten_knot_choice)bat_word(run, "knots");
    options.periodic = bat_yes(run, "closed");
    options.hold_start = options.hold_end = bat_yes(run, "hold-ends") && !options.periodic;
    options.corrections = data->dimension > 1 ? bat_count(run, "corrections") : 0;
    batten_fit_report report = {0};
    batten_status status = bat_check_closed(run, data);
    if (status == BATTEN_OK)
        status = batten_curve_least_squares(data->dimension, data->count, data->points,
                                            &options, made->parameters, &report, &made->curve);
    return bat_made_near(&report, status, made);
}

static batten_status run(bat_run *run)
{
    return bat_through(
        run, &(bat_method){.least = 2, .ways = BAT_IN_SPACE | BAT_AS_FUNCTION, .make = make});
}

const bat_feature bat_feature_least_squares = {
    .shown =
        {"least-squares", "A spline with the least sum of squared distances from points",
         "The plain way to draw a calm curve through many measured points: give fewer control\n"
         "points than data, and noise is averaged away. With 'corrections' the distances are\n"
         "those at right angles to the curve, not at parameters guessed from the chords. "
         "Knots\n"
         "by 'curvature' gather where a first fit bends, for data with steep fronts. It bounds "
         "no\n"
         "single distance, and outliers pull at it.\n"
         "It fails, naming the control point, when a part of the curve has no data.",
         "features:\n"
         "  marks: {points: [[0, 0], [1 m, 19 cm], [2 m, 31 cm], [3 m, 42 cm], [4 m, 41 cm], "
         "[5 m, 33 cm], [6 m, 22 cm]]}\n"
         "  sheer: {least-squares: marks, points: 4}\n",
         "[PT97]", "batten_curve_least_squares", BAT_PARAMETERS(parameters), false},
    .run = run};
