/* The monotone cubic functions, which differ in the rule for their slopes alone: a row each. */
#include "design/shared/local.h"

#define PARAMETERS_OF(name)                                                 \
    {                                                                       \
        {name,                                                              \
         BATTEN_VALUE_MODEL,                                                \
         false,                                                             \
         true,                                                              \
         NULL,                                                              \
         NULL,                                                              \
         "a table of offsets, rows of points, or curves that have points"}, \
            BAT_EACH,                                                       \
    }

static const batten_parameter fritsch_carlson_parameters[] = PARAMETERS_OF("fritsch-carlson");
static const batten_parameter fritsch_butland_parameters[] = PARAMETERS_OF("fritsch-butland");
static const batten_parameter steffen_parameters[] = PARAMETERS_OF("steffen");

static batten_status make_function(bat_run *run, const bat_data *data, bat_made *made)
{
    return bat_make_of_slopes(data, (batten_slope_rule)run->family, made);
}

static batten_status draw_function(bat_run *run)
{
    static const bat_method method = {2, BAT_AS_FUNCTION, make_function};
    return bat_through(run, &method);
}

const bat_feature bat_feature_fritsch_carlson = {
    .shown =
        {"fritsch-carlson", "A cubic function that is monotone where the data are",
         "For tables that must not overshoot: volumes, levels, distribution curves. Slopes start\n"
         "as those of parabolas through three points and are reduced just enough to make every\n"
         "span monotone; where the data turn they are 0, so extrema lie at points. Rounder than\n"
         "fritsch-butland, and of third order where the data are smooth and monotone. The points\n"
         "must rise along one axis. Second derivatives jump; at extrema of the data the curve is\n"
         "flatter than the data suggest.",
         "features:\n"
         "  tank: {points: [[0, 0], [1 m, 5 cm], [2 m, 10 cm], [3 m, 90 cm], [5 m, 1 m]]}\n"
         "  level: {fritsch-carlson: tank}\n",
         "[FC80]", "batten_slopes", BAT_PARAMETERS(fritsch_carlson_parameters), false,
         .also = "monotone cubic, no overshoot, monotone interpolation",
         .formula =
             "    s_i from the parabola through three points, both slopes of a span times τ = min(1, 3/√(α² + β²)),  α = s_i/d_i,  β = s_{i+1}/d_i",
         .promise = "Monotone where the data are; extrema lie at points."},
    .run = draw_function,
    .family = BATTEN_SLOPE_FRITSCH_CARLSON};

const bat_feature bat_feature_fritsch_butland = {
    .shown =
        {"fritsch-butland",
         "A cubic function with harmonic means of slopes: monotone and tight",
         "The method known as PCHIP: each slope is a weighted harmonic mean of those of the chords\n"
         "before and after, 0 where the data turn. It is monotone where the data are, looks tight\n"
         "at steps, and has no parameter to choose. Somewhat flatter than fritsch-carlson beside\n"
         "short chords. Points must rise along one axis; second derivatives jump.",
         "features:\n"
         "  tank: {points: [[0, 0], [1 m, 5 cm], [2 m, 10 cm], [3 m, 90 cm], [5 m, 1 m]]}\n"
         "  level: {fritsch-butland: tank}\n",
         "[FB84]", "batten_slopes", BAT_PARAMETERS(fritsch_butland_parameters), false,
         .also = "PCHIP, monotone cubic, no overshoot, harmonic mean",
         .formula =
             "    (w1 + w2)/s_i = w1/d_{i−1} + w2/d_i,  w1 = 2 h_i + h_{i−1},  w2 = h_i + 2 h_{i−1};  0 where d changes sign",
         .promise = "Monotone where the data are; extrema lie at points."},
    .run = draw_function,
    .family = BATTEN_SLOPE_FRITSCH_BUTLAND};

const bat_feature bat_feature_steffen = {
    .shown =
        {"steffen", "A cubic function with extrema at points only",
         "The slope of the parabola through three points, but never steeper than twice the flatter\n"
         "of the two chords, and 0 where the data turn. So no span has an extremum inside, and\n"
         "smooth data keep their parabola. Points must rise along one axis.",
         "features:\n"
         "  tank: {points: [[0, 0], [1 m, 5 cm], [2 m, 10 cm], [3 m, 90 cm], [5 m, 1 m]]}\n"
         "  level: {steffen: tank}\n",
         "[Steffen90]", "batten_slopes", BAT_PARAMETERS(steffen_parameters), false,
         .also = "monotone cubic, no overshoot",
         .formula =
             "    s_i = (sgn d_{i−1} + sgn d_i) min(|d_{i−1}|, |d_i|, ½ |p_i|),  p_i = (d_{i−1} h_i + d_i h_{i−1})/(h_{i−1} + h_i)",
         .promise =
             "No extremum between points; smooth data keep the slope of their parabola."},
    .run = draw_function,
    .family = BATTEN_SLOPE_STEFFEN};
