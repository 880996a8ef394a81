/* The feature 'nu-spline': cubic splines with a tension at each point. */
#include "design/shared/weighted.h"

static const batten_parameter parameters[] = {
    {"nu-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_AS,
    BAT_CLOSED,
    {"nu", BATTEN_VALUE_NUMBER, true, false, "0", NULL,
     "at all points or one for each: 0 is the cubic spline, 10 much"},
    BAT_PARAMETRIZATION,
    BAT_PLAIN_ENDS,
};

static batten_status make_nu_spline(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    double *nus = NULL;
    batten_status status = bat_check_closed(run, data);
    if (status == BATTEN_OK)
        status = bat_numbers_each(run, "nu", data->count, "points", &nus);
    o.nus = nus;
    if (status == BATTEN_OK)
        status = bat_make_weighted(run, data, &o, made);
    bat_release(nus);
    return status;
}

static batten_status run_nu_spline(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_nu_spline};
    return bat_through(run, &method);
}

const bat_feature bat_feature_nu_spline = {
    .shown =
        {"nu-spline", "Cubic splines with a tension at each point",
         "A large nu draws the bend into its point, in the limit as a corner; large ones at all\n"
         "points give the polygon. Tangent and curvature are continuous at the points, so it suits\n"
         "plane and space curves; the second derivative is not, so a function is smooth only to\n"
         "the eye. Use it to tighten single places; 'tension' works span by span and can find its\n"
         "amounts itself. nu has no unit. Values somewhat below 0 loosen a point; too far below\n"
         "there is no such curve, and the values are refused. Those at the ends of an open curve\n"
         "have no effect.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 0], [2 m, 1 m], [3 m, 1 m]]}\n"
         "  knuckle: {nu-spline: ducks, nu: [0, 30, 0, 0]}\n",
         "[Utah74 paper 10] [Nielson74]", "batten_curve_weighted", BAT_PARAMETERS(parameters),
         false,
         .also = "ν-spline, Nielson, tension at points, alternative to splines under tension",
         .formula =
             "    S″(t_i+) − S″(t_i−) = ν_i S′(t_i),  S(t_i) = P_i,  S cubic on each span;  ν_i = nu / mean step",
         .promise =
             "With natural ends ∫ |S″|² dt + Σ ν_i |S′(t_i)|² is least (ν_i ≥ 0); tangent and curvature are continuous."},
    .run = run_nu_spline};
