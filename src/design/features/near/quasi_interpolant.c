#include "design/shared/through.h"
#include <batten/polygon.h>

static const batten_parameter parameters[] = {
    {"quasi-interpolant", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "points, or a table of offsets"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "1 to 9"},
    BAT_PARAMETRIZATION,
    BAT_CLOSED,
    BAT_AS,
    BAT_EACH,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_schoenberg_options options = batten_curve_schoenberg_defaults();
    options.degree = bat_count(run, "degree");
    options.parameters = bat_parametrization_of(run, data);
    options.given = data->abscissae;
    options.closed = bat_yes(run, "closed");
    batten_curve_schoenberg_report report = {0};
    batten_status status = bat_check_closed(run, data);
    if (status == BATTEN_OK)
        status =
            batten_curve_quasi_interpolate(data->dimension, data->count, data->points, &options,
                                           made->parameters, &report, &made->curve);
    made->has_error = status == BATTEN_OK;
    made->error_max = report.error;
    made->error_rms = report.rms;
    return status;
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_quasi_interpolant = {
    .shown =
        {"quasi-interpolant", "A spline of full order near points, without equations",
         "Each control point is a sum over the few points around it, so moving a point moves\n"
         "the curve only nearby, and points may come by the million. Polynomials of the degree\n"
         "are reproduced; dense points of a smooth shape are met almost, noisy ones are\n"
         "smoothed a little: the error is reported. Where the points must be met exactly take\n"
         "'interpolate'; where there is much noise, 'smooth'. A corner makes it swing as\n"
         "interpolation does.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm], [4 m, 0]]}\n"
         "  near: {quasi-interpolant: ducks}\n",
         "[LS75]", "batten_curve_quasi_interpolate", BAT_PARAMETERS(parameters), false},
    .run = run};
