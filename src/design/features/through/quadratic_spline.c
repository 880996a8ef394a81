/* The feature 'quadratic-spline': parabolas that join with one tangent. */
#include "design/shared/through.h"
#include <batten/interpolate.h>

static const batten_parameter parameters[] = {
    {"quadratic-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_AS,
    {"knots", BATTEN_VALUE_WORD, false, false, "between", "between midpoints sequential",
     "midway between points; points midway between knots; at the points"},
    {"slope", BATTEN_VALUE_WORD, false, false, "best", "best start end",
     "sequential: the one slope that is needed, found or given"},
    {"vector", BATTEN_VALUE_POINT, false, false, "origin", NULL,
     "the derivative at the start or end; of a function its first number"},
    BAT_PARAMETRIZATION,
};

static batten_status make_quadratic_spline(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_quadratic_options o = batten_curve_quadratic_defaults();
    const batten_vec3 v = bat_point(run, "vector");
    o.kind = (batten_quadratic_kind)bat_word(run, "knots");
    o.slope = (batten_quadratic_slope)bat_word(run, "slope");
    o.vector[0] = v.x;
    o.vector[1] = v.y;
    o.vector[2] = v.z;
    o.parameters = bat_parametrization_of(run, data);
    o.given = data->abscissae;
    return batten_curve_quadratic((batten_points){data->dimension, data->count, data->points},
                                  &o, made->parameters, &made->curve);
}

static batten_status run_quadratic_spline(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_quadratic_spline};
    return bat_through(run, &method);
}

const bat_feature bat_feature_quadratic_spline = {
    .shown =
        {"quadratic-spline", "Parabolas that join with one tangent",
         "Curvature jumps at the knots. Knots 'between' the points suit any data. 'midpoints' is\n"
         "for values that belong to cells, given at their middles and at both ends of the whole; a\n"
         "curve gets even cells, whatever 'parameters' says. 'sequential' has its knots at the\n"
         "points and passes from one to the next: it is what one does by hand, and it swings: an\n"
         "error in the one slope never dies out. The best slope makes it swing least, but cubics\n"
         "are then the better choice. Curves of this degree are useful where a machine or a format\n"
         "accepts no other.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 1 m], [2 m, 1 m], [3 m, 0]]}\n"
         "  low: {quadratic-spline: ducks}\n",
         "[SL section II.2] [Marsden74]", "batten_curve_quadratic", BAT_PARAMETERS(parameters),
         false, .also = "parabolic spline, piecewise parabolas, Marsden",
         .formula =
             "    S quadratic between knots τ_i, S and S′ continuous, S(t_i) = P_i\n"
             "    between: τ_i midway between the points;  midpoints: t_i = (τ_{i−1} + τ_i)/2;  sequential: τ_i = t_i",
         .promise =
             "The tangent is continuous and parabolas are reproduced; the error falls with h³ (sequential: only with the right slope)."},
    .run = run_quadratic_spline};
