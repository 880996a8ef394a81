/* The feature 'quasi-interpolant': a spline of full order near points, without equations. */
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

static batten_status make_quasi_interpolant(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_schoenberg_options options = batten_curve_schoenberg_defaults();
    options.degree = bat_count(run, "degree");
    options.parameters = bat_parametrization_of(run, data);
    options.given = data->abscissae;
    options.closed = bat_yes(run, "closed");
    batten_curve_schoenberg_report report;
    batten_status status = bat_check_closed(run, data);
    if (status == BATTEN_OK)
        status = batten_curve_quasi_interpolate(
            (batten_points){data->dimension, data->count, data->points}, &options,
            made->parameters, &report, &made->curve);
    if (status != BATTEN_OK)
        return status;
    made->has_error = true;
    made->error_max = report.error;
    made->error_rms = report.rms;
    return BATTEN_OK;
}

static batten_status run_quasi_interpolant(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION,
                                      make_quasi_interpolant};
    return bat_through(run, &method);
}

const bat_feature bat_feature_quasi_interpolant = {
    .shown =
        {"quasi-interpolant", "A spline of full order near points, without equations",
         "Each control point is a sum over the few points around it, so moving a point moves the\n"
         "curve only nearby, and there may be millions of points. Polynomials of this degree are\n"
         "reproduced; dense points of a smooth shape are almost met, noisy ones are smoothed a\n"
         "little; the error is reported. Use 'interpolate' where the points must be met exactly,\n"
         "and 'smooth' where there is much noise. A corner makes it swing as interpolation does.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm], [4 m, 0]]}\n"
         "  near: {quasi-interpolant: ducks}\n",
         "[LS75]", "batten_curve_quasi_interpolate", BAT_PARAMETERS(parameters), false,
         .also = "Lyche Schumaker, local approximation, blossom",
         .formula =
             "    C(t) = Σ λ_i N_{i,k}(t),  λ_i = p_i[t_{i+1}, …, t_{i+k}],  the blossom of the polynomial p_i through k + 1 points around",
         .promise = "Polynomials of degree k are reproduced; the error falls with h^{k+1}."},
    .run = run_quasi_interpolant};
