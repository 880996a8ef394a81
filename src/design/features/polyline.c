#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"polyline", BATTEN_VALUE_POINT, true, true, NULL, NULL, "the corners, in order"},
};

static batten_status run(bat_run *run)
{
    const bat_argument *corners = bat_argument_of(run, "polyline");
    double *points = bat_array3((size_t)corners->count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < corners->count; i++)
        for (int k = 0; k < 3; k++)
            points[3 * i + k] = corners->items[i].number[k];
    batten_curve *polyline = NULL;
    const batten_status status = batten_curve_polyline(3, corners->count, points, &polyline);
    bat_release(points);
    return bat_put_curve(run, status, polyline);
}

const bat_feature bat_feature_polyline = {
    .shown =
        {"polyline", "Straight lines through points",
         "A curve of degree 1 with a corner at each inner point; its parameter is the length.",
         "features:\n"
         "  chine: {polyline: [[0, 0], [2 m, 0.5 m], [5 m, 0.6 m]]}\n",
         "", "batten_curve_polyline", BAT_PARAMETERS(parameters), false},
    .run = run};
