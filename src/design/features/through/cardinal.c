/* The feature 'cardinal': cardinal splines: a tangent along the chord of both neighbours,
 * shortened. */
#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"cardinal", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"tension", BATTEN_VALUE_NUMBER, true, false, "0", NULL,
     "at all points or one for each: 0 is 'catmull-rom', 1 halts at the point, below 0 is "
     "rounder"},
    BAT_CHORD_POWER("0"),
    BAT_PHANTOMS,
    BAT_AS,
    BAT_EACH,
    BAT_CLOSED,
};

static batten_status make_cardinal(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_tangents_kochanek_bartels_options options =
        batten_tangents_kochanek_bartels_defaults();
    double *tension = NULL;
    batten_status status = bat_numbers_each(run, "tension", data->count, "points", &tension);
    options.tension = tension;
    if (status == BATTEN_OK)
        status = bat_make_kochanek_bartels(run, data, &options, made);
    bat_release(tension);
    return status;
}

static batten_status run_cardinal(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_cardinal};
    return bat_through(run, &method);
}

const bat_feature bat_feature_cardinal = {
    .shown =
        {"cardinal",
         "Cardinal splines: a tangent along the chord of both neighbours, shortened",
         "The tangent at a point is half the step from the point before to the one after, times 1\n"
         "- tension: the curve of drawing programs and of graphs. Tension takes out roundness at\n"
         "all points or at single ones, and 1 gives the polygon, with a halt at each corner.\n"
         "Moving a point changes four spans. Steps are equal by default: where points are uneven,\n"
         "'alpha: 0.5' keeps it from swinging. Direction is continuous, curvature is not. The\n"
         "tension of 'tension' and of 'nu-spline' is a different one, which leaves curvature\n"
         "continuous.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm], [4 m, 0]]}\n"
         "  sheer: {cardinal: ducks, tension: 0.3}\n",
         "[Utah74 paper 15] [CR74] [KB84]", "batten_tangents_kochanek_bartels",
         BAT_PARAMETERS(parameters), false,
         .also = "cardinal spline, tension parameter, drawing programs, canonical spline",
         .formula =
             "    T_i = (1 − c) (h_i d_{i−1} + h_{i−1} d_i)/(h_{i−1} + h_i);  equal steps: (1 − c) (P_{i+1} − P_{i−1})/2",
         .promise = "The tangent is continuous; a point changes four spans."},
    .run = run_cardinal};
