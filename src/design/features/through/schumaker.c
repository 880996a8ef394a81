/* The feature 'schumaker': a quadratic function that is monotone and convex where the data
 * are. */
#include "design/shared/local.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"schumaker", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
};

static batten_status make_schumaker(bat_run *run, const bat_data *data, bat_made *made)
{
    (void)run;
    memcpy(made->parameters, data->abscissae, (size_t)data->count * sizeof *made->parameters);
    return batten_curve_schumaker(data->count, data->abscissae, data->points, NULL,
                                  &made->curve);
}

static batten_status run_schumaker(bat_run *run)
{
    static const bat_method method = {2, BAT_AS_FUNCTION, make_schumaker};
    return bat_through(run, &method);
}

const bat_feature bat_feature_schumaker = {
    .shown =
        {"schumaker", "A quadratic function that is monotone and convex where the data are",
         "For tables whose bend has a meaning, such as costs and stiffnesses: a spline of\n"
         "parabolas that is monotone and also convex or concave wherever the points are, with at\n"
         "most one additional knot in each span. Three points in line give that line. The second\n"
         "derivative is piecewise constant, so it looks less round than cubics. Where a straight\n"
         "run ends in an extremum of the data, or in another straight run, no smooth function is\n"
         "both convex and monotone; then a span beside it bends twice.",
         "features:\n"
         "  tank: {points: [[0, 0], [1 m, 5 cm], [2 m, 10 cm], [3 m, 90 cm], [5 m, 1 m]]}\n"
         "  level: {schumaker: tank}\n",
         "[Schumaker83]", "batten_curve_schumaker", BAT_PARAMETERS(parameters), false,
         .also = "shape preserving quadratic, convex interpolation, no overshoot",
         .formula =
             "    parabolas with one knot ξ in a span:  s̄ = (2 (y_{i+1} − y_i) − (ξ − x_i) s_i − (x_{i+1} − ξ) s_{i+1})/(x_{i+1} − x_i) is the slope at ξ",
         .promise =
             "Monotone and convex or concave wherever the data are and a smooth function can be both."},
    .run = run_schumaker};
