/* The feature 'p-spline': a spline on equal spans whose control points differ little. */
#include "design/shared/near.h"

static const batten_parameter parameters[] = {
    {"p-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "points, or a table of offsets"},
    {"spans", BATTEN_VALUE_COUNT, false, false, "40", NULL, "how many spans of equal length"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "1 to 25"},
    {"rms", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "the root of the mean squared distance that may be left"},
    {"lambda", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "how much differences of control points weigh, instead of 'rms'"},
    {"order", BATTEN_VALUE_COUNT, false, false, "2", NULL,
     "1 to 4: which differences of the control points are kept small"},
    BAT_PARAMETRIZATION,
    BAT_CLOSED,
    BAT_AS,
    BAT_EACH,
};

static batten_status make_p_spline(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_smooth_options options = batten_curve_smooth_defaults();
    options.spans = bat_count(run, "spans");
    options.degree = bat_count(run, "degree");
    return bat_make_smooth(run, data, batten_curve_p_spline, &options, made);
}

static batten_status run_p_spline(bat_run *run)
{
    return bat_through(run, &(bat_method){.least = 2,
                                          .ways = BAT_IN_SPACE | BAT_AS_FUNCTION,
                                          .make = make_p_spline});
}

const bat_feature bat_feature_p_spline = {
    .shown =
        {"p-spline", "A spline on equal spans whose control points differ little",
         "Much like 'smooth', but the number of control points follows from 'spans' and not from\n"
         "the number of points: for long series of measurements. Give plenty of spans; 'rms',\n"
         "'lambda' or cross validation decide how smooth the curve is. It continues smoothly where\n"
         "points are missing. Details finer than a span are lost.",
         "features:\n"
         "  marks: {points: [[0, 0], [1 m, 19 cm], [2 m, 31 cm], [3 m, 42 cm], [4 m, 41 cm], [5 m, 33 cm], [6 m, 22 cm]]}\n"
         "  sheer: {p-spline: marks, spans: 8, rms: 1 cm}\n",
         "[EM96]", "batten_curve_p_spline", BAT_PARAMETERS(parameters), false,
         .also = "penalised spline, Eilers Marx, cross validation",
         .formula =
             "    Σ w_j |C(t_j) − Q_j|² + λ Σ |Δ^m d_i|² → minimum,  C = Σ d_i N_i on equal spans",
         .promise = "The least for these spans; λ = ∞ gives the polynomial of degree m − 1."},
    .run = run_p_spline};
