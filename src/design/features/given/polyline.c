/* The feature 'polyline': straight lines through points. */
#include "design/shared/through.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"polyline", BATTEN_VALUE_POINTS, true, true, NULL, NULL,
     "the corners, in order; or features: a table of offsets, rows of points, or curves that "
     "have points"},
    BAT_EACH,
};

static batten_status make_polyline(bat_run *run, const bat_data *data, bat_made *made)
{
    (void)run;
    made->has_parameters = false;
    return batten_curve_polyline((batten_points){data->dimension, data->count, data->points},
                                 &made->curve);
}

/* Through the rows of features. */
static batten_status run_features(bat_run *run, const bat_argument *features, const char *name)
{
    static const bat_method method = {2, BAT_IN_SPACE, make_polyline};
    for (int i = 0; i < features->count; i++)
        if (!features->items[i].text)
            return bat_fail(
                BATTEN_BAD_ARGUMENT,
                "corner %d is a point, and another is the feature '%s': give points "
                "alone or features alone",
                i + 1, name);
    return bat_through(run, &method);
}

static batten_status run_polyline(bat_run *run)
{
    const bat_argument *corners = bat_argument_of(run, "polyline");
    for (int i = 0; i < corners->count; i++)
        if (corners->items[i].text)
            return run_features(run, corners, corners->items[i].text);
    double *points = bat_array3((size_t)corners->count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < corners->count; i++)
        for (int k = 0; k < 3; k++)
            points[3 * i + k] = corners->items[i].number[k];
    batten_curve *polyline = NULL;
    const batten_status status =
        batten_curve_polyline((batten_points){3, corners->count, points}, &polyline);
    bat_release(points);
    return bat_put_curve(run, status, polyline);
}

const bat_feature bat_feature_polyline = {
    .shown =
        {"polyline", "Straight lines through points",
         "A curve of degree 1 with a corner at each inner point; its parameter is the length. Of\n"
         "features with points each row becomes a polyline.",
         "features:\n"
         "  chine: {polyline: [[0, 0], [2 m, 0.5 m], [5 m, 0.6 m]]}\n",
         "", "batten_curve_polyline", BAT_PARAMETERS(parameters), false,
         .also = "polygon, chain of lines, linear spline",
         .formula = "    C(t) = P_i + (t − t_i) (P_{i+1} − P_i)/|P_{i+1} − P_i|,  t the length",
         .promise = "It is exact; its parameter is arc length."},
    .run = run_polyline};
