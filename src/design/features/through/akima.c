/* The feature 'akima': Akima's local cubics: as one would draw by hand. */
#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"akima", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"modified", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "of a function: chords that are steep count more, so level runs stay level"},
    BAT_AS,
    BAT_EACH,
    BAT_CLOSED,
};

static batten_status make_akima(bat_run *run, const bat_data *data, bat_made *made)
{
    const bool modified = bat_yes(run, "modified");
    if (modified && data->dimension > 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'modified' is for functions alone");
    return bat_make_local(run, data, modified ? BATTEN_SLOPE_MAKIMA : BATTEN_SLOPE_AKIMA,
                          BATTEN_TANGENT_RENNER, BATTEN_LENGTH_CHORD, made);
}

static batten_status run_akima(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_akima};
    return bat_through(run, &method);
}

const bat_feature bat_feature_akima = {
    .shown =
        {"akima", "Akima's local cubics: as one would draw by hand",
         "Each slope is a mean of those of the two chords at the point; the chord beyond which the\n"
         "slopes change less counts more. So outliers and steps disturb only their neighbours, and\n"
         "straight runs of three points stay straight. As a curve, Akima's weights by areas are\n"
         "taken, which do not depend on the axes, with tangents of length 1 over the chords;\n"
         "'renner' is the same with even speed. Cubic, with continuous first derivative. It does\n"
         "not promise to be monotone: on uneven abscissae it can overshoot a little, which\n"
         "fritsch-butland never does. 'modified: yes' (makima) does not overshoot beside a level\n"
         "run of three points, but keeps only level runs straight.",
         "features:\n"
         "  tank: {points: [[0, 0], [1 m, 5 cm], [2 m, 10 cm], [3 m, 90 cm], [5 m, 1 m]]}\n"
         "  level: {akima: tank, as: function}\n",
         "[SL section VI.8] [Akima70] [Akima72] [Ionita19]", "batten_slopes",
         BAT_PARAMETERS(parameters), false, .also = "Akima spline, makima, modified Akima",
         .formula =
             "    s_i = (w1 d_{i−1} + w2 d_i)/(w1 + w2),  w1 = |d_{i+1} − d_i|,  w2 = |d_{i−1} − d_{i−2}|\n"
             "    as a curve the weights are areas:  w1 = |q_i × q_{i+1}|,  w2 = |q_{i−2} × q_{i−1}|,  q_i = P_{i+1} − P_i",
         .promise = "Three points in line give that line; the first derivative is continuous."},
    .run = run_akima};
