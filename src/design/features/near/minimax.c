/* The feature 'minimax': the polynomial whose largest distance from points is least. */
#include "design/shared/through.h"
#include <batten/polygon.h>

#include <string.h>

static const batten_parameter parameters[] = {
    {"minimax", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "points that rise along the first axis in which they differ, or a table of offsets"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL,
     "0 to 25; at least two points more are needed"},
    BAT_EACH,
};

static batten_status make_minimax(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_minimax_report report;
    const batten_status status =
        batten_curve_minimax(data->count, data->abscissae, data->points,
                             bat_count(run, "degree"), &report, &made->curve);
    if (status != BATTEN_OK)
        return status;
    memcpy(made->parameters, data->abscissae, (size_t)data->count * sizeof *made->parameters);
    made->has_error = true;
    made->error_max = report.error;
    made->error_rms = report.rms;
    return BATTEN_OK;
}

static batten_status run_minimax(bat_run *run)
{
    static const bat_method method = {2, BAT_AS_FUNCTION, make_minimax};
    return bat_through(run, &method);
}

const bat_feature bat_feature_minimax = {
    .shown =
        {"minimax", "The polynomial whose largest distance from points is least",
         "No other polynomial of this degree stays closer to all points at once: the error that is\n"
         "reported is half the width of the narrowest band around a polynomial that holds them.\n"
         "Use it for tables of exact values that a machine or a program has to evaluate, and to\n"
         "see whether points can lie within a tolerance of such a shape at all. One wrong point\n"
         "spoils it; for measured points take 'least-squares'.",
         "features:\n"
         "  table: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm], [4 m, 5 cm]]}\n"
         "  near: {minimax: table, degree: 2}\n",
         "[Remez34]", "batten_curve_minimax", BAT_PARAMETERS(parameters), false,
         .also = "Chebyshev approximation, Remez, uniform approximation, best approximation",
         .formula = "    max_j |p(x_j) − y_j| → minimum over the polynomials p of the degree",
         .promise =
             "The largest distance is the least possible; it is taken with alternating signs at degree + 2 points."},
    .run = run_minimax};
