/* The feature 'weighted-spline': cubic splines whose spans are of unequal stiffness. */
#include "design/shared/weighted.h"

static const batten_parameter parameters[] = {
    {"weighted-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_AS,
    BAT_CLOSED,
    {"weights", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "of the spans, one for each; where none are given they follow the slopes"},
    BAT_PARAMETRIZATION,
    BAT_PLAIN_ENDS,
};

static batten_status make_weighted_spline(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    double *weights = NULL;
    const int spans = data->count - !bat_yes(run, "closed");
    o.rule = bat_has(run, "weights") ? BATTEN_WEIGHTS_GIVEN : BATTEN_WEIGHTS_SLOPE;
    batten_status status = bat_check_closed(run, data);
    if (status == BATTEN_OK && o.rule == BATTEN_WEIGHTS_GIVEN)
        status = bat_numbers_each(run, "weights", spans, "spans", &weights);
    o.weights = weights;
    if (status == BATTEN_OK)
        status = bat_make_weighted(run, data, &o, made);
    bat_release(weights);
    return status;
}

static batten_status run_weighted_spline(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_weighted_spline};
    return bat_through(run, &method);
}

const bat_feature bat_feature_weighted_spline = {
    .shown =
        {"weighted-spline", "Cubic splines whose spans are of unequal stiffness",
         "A span of large weight bends little, and its neighbours take the bend. Tangents are\n"
         "continuous at the points; curvature jumps where weights differ. Without weights each\n"
         "span gets (1 + slope^2)^-3, after Salkauskas: for functions with steep places (as:\n"
         "function), which then do not swing beside them. The slope counts in the unit of the\n"
         "design, so axes of different kinds must be scaled to fit. A curve over chord lengths has\n"
         "slope 1 everywhere and is then the plain cubic spline.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 0], [2 m, 6 m], [3 m, 6 m]]}\n"
         "  rise: {weighted-spline: ducks, as: function}\n",
         "[Salkauskas84]", "batten_curve_weighted", BAT_PARAMETERS(parameters), false,
         .also = "Salkauskas, weighted cubic, Foley",
         .formula =
             "    w_{i−1} S″(t_i−) = w_i S″(t_i+),  S′ continuous,  S(t_i) = P_i,  S cubic on each span",
         .promise = "With natural ends Σ w_i ∫ |S″|² dt over the spans is least."},
    .run = run_weighted_spline};
