/* The feature 'beta-spline': uniform splines with one bias and one tension for all joints. */
#include "design/shared/through.h"
#include <batten/interpolate.h>

static const batten_parameter parameters[] = {
    {"beta-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    BAT_CLOSED,
    {"use", BATTEN_VALUE_WORD, false, false, "near", "near through",
     "is the curve drawn to the points, or does it pass them"},
    {"beta1", BATTEN_VALUE_NUMBER, false, false, "1", NULL,
     "the bias: speed after a joint by the speed before it"},
    {"beta2", BATTEN_VALUE_NUMBER, false, false, "0", NULL,
     "the tension, 0 or more: 10 draws the curve well to its polygon"},
};

static batten_status make_beta_spline(bat_run *run, const bat_data *data, bat_made *made)
{
    const batten_beta_use use = (batten_beta_use)bat_word(run, "use");
    for (int i = 0; i < data->count; i++)
        made->parameters[i] = i;
    made->has_parameters = use == BATTEN_BETA_THROUGH;
    made->from_polygon = use != BATTEN_BETA_THROUGH;
    return batten_curve_beta((batten_points){data->dimension, data->count, data->points}, use,
                             bat_number(run, "beta1"), bat_number(run, "beta2"),
                             bat_yes(run, "closed"), &made->curve);
}

static batten_status run_beta_spline(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE, make_beta_spline};
    return bat_through(run, &method);
}

const bat_feature bat_feature_beta_spline = {
    .shown =
        {"beta-spline", "Uniform splines with one bias and one tension for all joints",
         "Uniform Beta-splines: near a control polygon, whose ends they pass, or through points.\n"
         "Two numbers shape all joints: beta2 draws the curve to the polygon, beta1 above 1 pulls\n"
         "its bends to the later side of each point, below 1 to the earlier. Tangent and curvature\n"
         "are continuous at the joints; the speed jumps by the factor beta1. A curve near points\n"
         "changes only within two steps of a point that is moved. Through points all steps count\n"
         "alike: for uneven points 'nu-spline' is fairer, and beta1 far from 1 makes large swings.",
         "features:\n"
         "  cage: {points: [[0, 0], [1 m, 2 m], [3 m, 1 m], [4 m, 0]]}\n"
         "  soft: {beta-spline: cage, beta2: 5}\n",
         "[Barsky88]", "batten_curve_beta", BAT_PARAMETERS(parameters), false,
         .also = "Barsky, bias and tension",
         .formula = "    S′(t_i+) = β1 S′(t_i−),  S″(t_i+) = β1² S″(t_i−) + β2 S′(t_i−)",
         .promise =
             "Tangent and curvature are continuous at the joints; β1 = 1, β2 = 0 is the uniform cubic B-spline."},
    .run = run_beta_spline};
