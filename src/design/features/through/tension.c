/* The feature 'tension': splines in tension: a batten pulled at its ends. */
#include "design/shared/place.h"
#include "design/shared/through.h"
#include <batten/interpolate.h>

static const batten_parameter parameters[] = {
    {"tension", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_AS,
    BAT_CLOSED,
    {"amount", BATTEN_VALUE_NUMBER, true, false, "0", NULL,
     "of all spans or one for each: 0 is the cubic spline, 2 a little, 10 much"},
    {"rule", BATTEN_VALUE_WORD, false, false, "given", "given convex monotone",
     "the property for which tension is added where the amount is too small"},
    {"slack", BATTEN_VALUE_NUMBER, false, false, "0.01", NULL,
     "how much deviation a rule allows beside points in line and level spans"},
    BAT_PARAMETRIZATION,
    BAT_PLAIN_ENDS,
};

static batten_status make_tension(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_chain_tension_options o = batten_chain_tension_defaults();
    double *tensions = NULL;
    o.closed = bat_yes(run, "closed");
    o.rule = (batten_tension_rule)bat_word(run, "rule");
    o.slack = bat_number(run, "slack");
    o.given = data->abscissae;
    o.start = bat_end(run, "start", "start-vector");
    o.end = bat_end(run, "end", "end-vector");
    o.parameters = bat_parametrization_of(run, data);
    batten_status status = bat_check_closed(run, data);
    if (status == BATTEN_OK)
        status = bat_numbers_each(run, "amount", data->count - !o.closed, "spans", &tensions);
    o.tensions = tensions;
    if (status == BATTEN_OK)
        status =
            batten_chain_tension((batten_points){data->dimension, data->count, data->points},
                                 &o, made->parameters, &made->chain);
    bat_release(tensions);
    return status;
}

static batten_status run_tension(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_tension};
    return bat_through(run, &method);
}

const bat_feature bat_feature_tension = {
    .shown =
        {"tension", "Splines in tension: a batten pulled at its ends",
         "More tension takes out the bulges and extra turns of a cubic spline beside steep places,\n"
         "and in the limit gives the polygon. The amount has no unit; it can be given span by\n"
         "span. 'convex' finds it: the curve then bends back only where its points do. 'monotone'\n"
         "lets each coordinate rise and fall only as the points do, and suits functions: as a\n"
         "curve it depends on the axes. Tangent and second derivative are continuous at all\n"
         "points, but much tension draws the bend close to them: fair curves need little tension.\n"
         "Points that should be in line must be so exactly, otherwise the rules keep their turns.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 0], [2 m, 0], [2.3 m, 80 cm], [4 m, 1 m]]}\n"
         "  sheer: {tension: ducks, rule: convex}\n",
         "[SL section II.3] [Cline74]", "batten_chain_tension", BAT_PARAMETERS(parameters),
         false,
         .also =
             "spline under tension, exponential spline, hyperbolic spline, Schweikert, Cline",
         .formula =
             "    S⁗ − σ_i² S″ = 0 on span i,  S(t_i) = P_i,  S′ and S″ continuous;  amount = σ_i h_i",
         .promise =
             "With natural ends Σ ∫ (|S″|² + σ_i² |S′|²) dt is the least of all curves with S(t_i) = P_i."},
    .run = run_tension};
