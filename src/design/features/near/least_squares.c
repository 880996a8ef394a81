/* The feature 'least-squares': a spline with the least sum of squared distances from
 * points. */
#include "design/shared/conditions.h"
#include "design/shared/near.h"

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
     "of a curve: how often at most points get the parameters of their nearest points"},
    {"hold-ends", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "an open curve starts and ends at the end points"},
    {"weights", BATTEN_VALUE_NUMBER, true, false, "1", NULL,
     "of the points, one for each or one for all; 0 leaves a point out"},
    {"pass", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "points that the curve must pass: of a curve some of its points, of a function any"},
    {"start-direction", BATTEN_VALUE_POINT, false, false, NULL, NULL,
     "the direction in which the curve begins"},
    {"end-direction", BATTEN_VALUE_POINT, false, false, NULL, NULL,
     "the direction in which it ends"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "no coordinate is farther than this from that of its point"},
    {"shape", BATTEN_VALUE_WORD, true, false, NULL, "increasing decreasing convex concave",
     "of a function: one or two of these"},
    {"side", BATTEN_VALUE_WORD, false, false, "both", "both over under",
     "of a function: nowhere below its points, or nowhere above them"},
    {"over", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "of a function: points below which it must not be"},
    {"under", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "of a function: points above which it must not be"},
    {"robust", BATTEN_VALUE_WORD, false, false, "no", "no huber absolute tukey",
     "far points count less: beyond twice the median distance, all by distance, hardly at all"},
    BAT_CLOSED,
    BAT_AS,
    BAT_EACH,
};

static batten_status make_least_squares(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    options.degree = bat_count(run, "degree");
    options.point_count = bat_count(run, "points");
    options.parameters = bat_parametrization_of(run, data);
    options.given = data->abscissae;
    options.knots = (batten_knot_choice)bat_word(run, "knots");
    options.closed = bat_yes(run, "closed");
    options.hold_start = options.hold_end = bat_yes(run, "hold-ends") && !options.closed;
    options.corrections = data->abscissae ? 0 : bat_count(run, "corrections");
    options.robust = (batten_robust)bat_word(run, "robust");
    batten_fit_report report;
    double *weights = NULL;
    batten_condition *conditions = NULL;
    batten_status status = bat_check_closed(run, data);
    if (status == BATTEN_OK)
        status = bat_numbers_each(run, "weights", data->count, "points", &weights);
    options.weights = weights;
    if (status == BATTEN_OK)
        status = bat_conditions_of(run, data, &options, &conditions);
    if (status == BATTEN_OK)
        status = batten_curve_least_squares(
            (batten_points){data->dimension, data->count, data->points}, &options,
            made->parameters, &report, &made->curve);
    if (status == BATTEN_OK && options.robust != BATTEN_SQUARES)
        status = bat_note_outliers(run, data, weights, made);
    bat_release(conditions);
    bat_release(weights);
    return bat_made_near(&report, status, made);
}

static batten_status run_least_squares(bat_run *run)
{
    return bat_through(run, &(bat_method){.least = 2,
                                          .ways = BAT_IN_SPACE | BAT_AS_FUNCTION,
                                          .make = make_least_squares});
}

const bat_feature bat_feature_least_squares = {
    .shown =
        {"least-squares", "A spline with the least sum of squared distances from points",
         "The plain way to draw a calm curve through many measured points: give fewer control\n"
         "points than data, and noise is averaged out. With 'corrections' distances are measured\n"
         "at right angles to the curve, not at parameters estimated from the chords. Knots by\n"
         "'curvature' gather where a first fit bends, for data with steep fronts. No single\n"
         "distance is bounded unless 'within' does so, and outliers pull at it unless it is\n"
         "'robust': then points farther than five times the median distance are listed. 'pass',\n"
         "the directions, 'shape', 'side', 'over' and 'under' are met exactly; when they cannot\n"
         "be, the message names one that conflicts with the others. Held ends count among them:\n"
         "give 'hold-ends: no' where measured ends would break the shape. It fails, naming the\n"
         "control point, when a part of the curve has no data.",
         "features:\n"
         "  marks: {points: [[0, 0], [1 m, 19 cm], [2 m, 31 cm], [3 m, 42 cm], [4 m, 41 cm], [5 m, 33 cm], [6 m, 22 cm]]}\n"
         "  sheer: {least-squares: marks, points: 4}\n"
         "  crown: {least-squares: marks, points: 5, as: function, shape: concave, pass: [[3 m, 42 cm]]}\n",
         "[SL section I.2] [PT97 section 9.4]", "batten_curve_least_squares",
         BAT_PARAMETERS(parameters), false,
         .also = "regression spline, approximation, fitting, robust fit, outliers",
         .formula = "    Σ w_j |C(t_j) − Q_j|² → minimum,  C(t) = Σ d_i N_{i,k}(t)",
         .promise =
             "The sum of squares is least for these knots and parameters, under the conditions that are given."},
    .run = run_least_squares};
