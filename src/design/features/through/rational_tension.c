/* The feature 'rational-tension': rational splines in tension, after Spaeth. */
#include "design/shared/place.h"
#include "design/shared/through.h"
#include <batten/bent.h>

static const batten_parameter parameters[] = {
    {"rational-tension", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_AS,
    BAT_CLOSED,
    {"amount", BATTEN_VALUE_NUMBER, true, false, "0", NULL,
     "p of all spans or one for each: 0 is the cubic spline, 1 a little, 10 much"},
    BAT_PARAMETRIZATION,
    BAT_PLAIN_ENDS,
};

static batten_status make_rational_tension(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_chain_tension_options o = batten_chain_tension_defaults();
    double *tensions = NULL;
    o.closed = bat_yes(run, "closed");
    o.given = data->abscissae;
    o.start = bat_end(run, "start", "start-vector");
    o.end = bat_end(run, "end", "end-vector");
    o.parameters = bat_parametrization_of(run, data);
    batten_status status = bat_check_closed(run, data);
    if (status == BATTEN_OK)
        status = bat_numbers_each(run, "amount", data->count - !o.closed, "spans", &tensions);
    o.tensions = tensions;
    if (status == BATTEN_OK)
        status = batten_curve_rational_tension(
            (batten_points){data->dimension, data->count, data->points}, &o, made->parameters,
            &made->curve);
    bat_release(tensions);
    return status;
}

static batten_status run_rational_tension(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_rational_tension};
    return bat_through(run, &method);
}

const bat_feature bat_feature_rational_tension = {
    .shown =
        {"rational-tension", "Rational splines in tension",
         "Like 'tension', more of it takes out bulges and in the limit gives the polygon, with\n"
         "fractions in place of hyperbolic functions: the result is an exact rational curve of\n"
         "degree 4 that every program reads. Tangent and second derivative are continuous at all\n"
         "points. Between two points the second derivative keeps its sign where both ends agree,\n"
         "so a function has no more inflections than its values at the points say. The amount is\n"
         "p of Spaeth, has no unit, and can be given span by span, up to 1e6. There is no rule that\n"
         "finds it, as 'convex' and 'monotone' do for 'tension'.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 0], [2 m, 0], [2.3 m, 80 cm], [4 m, 1 m]]}\n"
         "  sheer: {rational-tension: ducks, amount: [0, 5, 2, 0]}\n",
         "[Spaeth95]", "batten_curve_rational_tension", BAT_PARAMETERS(parameters), false,
         .also =
             "rational spline with tension, rational spline in tension, Spaeth, Späth, rational cubic "
             "spline",
         .formula =
             "    S = A u + B t + C u³ / (1 + p t) + D t³ / (1 + p u),  u = 1 − t;  S(t_i) = "
             "P_i,  S′ and S″ continuous",
         .promise =
             "The points are met; a function keeps the sign of S″ on each span where it is the same at both ends."},
    .run = run_rational_tension};
