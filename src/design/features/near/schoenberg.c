/* The feature 'schoenberg': a spline near points that never turns more often than they do. */
#include "design/shared/through.h"
#include <batten/polygon.h>

static const batten_parameter parameters[] = {
    {"schoenberg", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "points, or a table of offsets"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL,
     "1 to 25; the higher, the calmer and the farther from the points"},
    {"knots", BATTEN_VALUE_WORD, false, false, "points", "points none",
     "at the points, or none inside: Bernstein's operator, one polynomial"},
    BAT_PARAMETRIZATION,
    BAT_CLOSED,
    BAT_AS,
    BAT_EACH,
};

static batten_status make_schoenberg(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_schoenberg_options options = batten_curve_schoenberg_defaults();
    options.degree = bat_count(run, "degree");
    options.parameters = bat_parametrization_of(run, data);
    options.given = data->abscissae;
    options.closed = bat_yes(run, "closed");
    options.bernstein = bat_word(run, "knots") == 1;
    batten_curve_schoenberg_report report;
    batten_status status = bat_check_closed(run, data);
    if (status == BATTEN_OK)
        status =
            batten_curve_schoenberg((batten_points){data->dimension, data->count, data->points},
                                    &options, made->parameters, &report, &made->curve);
    if (status != BATTEN_OK)
        return status;
    made->has_error = true;
    made->error_max = report.error;
    made->error_rms = report.rms;
    return BATTEN_OK;
}

static batten_status run_schoenberg(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_schoenberg};
    return bat_through(run, &method);
}

const bat_feature bat_feature_schoenberg = {
    .shown =
        {"schoenberg", "A spline near points that never turns more often than they do",
         "Schoenberg's variation diminishing spline: it is convex, rising or positive wherever the\n"
         "polyline through the points is, for curves and for functions, and meets no line more\n"
         "often. It ends in the end points and rounds off the others: the coarser the points, the\n"
         "more. Use it where a shape must not gain a bump at any price, and 'quasi-interpolant' or\n"
         "'least-squares' where closeness counts more. No equations are solved; two points that\n"
         "coincide are refused.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm]]}\n"
         "  calm: {schoenberg: ducks}\n",
         "[Schoenberg67]", "batten_curve_schoenberg", BAT_PARAMETERS(parameters), false,
         .also = "variation diminishing, Greville, shape preserving approximation",
         .formula =
             "    C(t) = Σ P(ξ_i) N_{i,k}(t),  ξ_i = (t_{i+1} + … + t_{i+k})/k,  P the polyline through the points",
         .promise = "No line or plane meets the curve more often than the polyline."},
    .run = run_schoenberg};
