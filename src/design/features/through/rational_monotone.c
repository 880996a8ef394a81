/* The feature 'rational-monotone': a rational quadratic function that is monotone where
 * the data are. */
#include "design/shared/local.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"rational-monotone", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
};

static batten_status make_rational_monotone(bat_run *run, const bat_data *data, bat_made *made)
{
    (void)run;
    memcpy(made->parameters, data->abscissae, (size_t)data->count * sizeof *made->parameters);
    return batten_curve_rational_monotone(data->count, data->abscissae, data->points, NULL,
                                          &made->curve);
}

static batten_status run_rational_monotone(bat_run *run)
{
    static const bat_method method = {2, BAT_AS_FUNCTION, make_rational_monotone};
    return bat_through(run, &method);
}

const bat_feature bat_feature_rational_monotone = {
    .shown =
        {"rational-monotone",
         "A rational quadratic function that is monotone where the data are",
         "Spans are quotients of quadratics, represented exactly as a rational curve: monotone for\n"
         "any slopes of the right sign, where a cubic must shorten them. The slopes are those of\n"
         "fritsch-butland; where the data turn they are 0. Smoother than cubics at steep rises\n"
         "between flat parts. The result is rational, and not every format supports that as well\n"
         "as cubics.",
         "features:\n"
         "  tank: {points: [[0, 0], [1 m, 5 cm], [2 m, 10 cm], [3 m, 90 cm], [5 m, 1 m]]}\n"
         "  level: {rational-monotone: tank}\n",
         "[GD82]", "batten_curve_rational_monotone", BAT_PARAMETERS(parameters), false,
         .also = "Gregory Delbourgo, rational quadratic, no overshoot",
         .formula =
             "    s(x) = (d y_{i+1} θ² + (y_i s_{i+1} + y_{i+1} s_i) θ (1−θ) + d y_i (1−θ)²)/(d θ² + (s_i + s_{i+1}) θ (1−θ) + d (1−θ)²)\n"
             "    θ = (x − x_i)/h_i,  d = (y_{i+1} − y_i)/h_i",
         .promise = "Monotone where the data are, for any slopes of the sign of the chords."},
    .run = run_rational_monotone};
