/* The feature 'bessel': cubics with the derivatives of parabolas through three points. */
#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"bessel", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_AS,
    BAT_EACH,
    BAT_CLOSED,
};

static batten_status make_bessel(bat_run *run, const bat_data *data, bat_made *made)
{
    return bat_make_local(run, data, BATTEN_SLOPE_BESSEL, BATTEN_TANGENT_BESSEL,
                          BATTEN_LENGTH_RULE, made);
}

static batten_status run_bessel(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_bessel};
    return bat_through(run, &method);
}

const bat_feature bat_feature_bessel = {
    .shown =
        {"bessel", "Cubics with the derivatives of parabolas through three points",
         "At each point the derivative of the parabola through it and its two neighbours, at the\n"
         "parameters of the chords, or as a function at the abscissae: parabolas are reproduced\n"
         "exactly. Simple, local, and a good first look at smooth data. Cubic, with continuous\n"
         "first derivative. It overshoots beside steps, where 'as: function' has better choices in\n"
         "akima, fritsch-carlson and fritsch-butland; in sharp turns between unequal chords it\n"
         "slows down.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm], [4 m, 0]]}\n"
         "  sheer: {bessel: ducks}\n",
         "[SL section VI.8] [deBoor01]", "batten_tangents", BAT_PARAMETERS(parameters), false,
         .also = "Overhauser, parabolic blending, three-point parabola",
         .formula =
             "    T_i = (h_i d_{i−1} + h_{i−1} d_i)/(h_{i−1} + h_i),  d_i = (P_{i+1} − P_i)/h_i;  cubics of Hermite between",
         .promise = "Parabolas are reproduced; a point changes four spans."},
    .run = run_bessel};
