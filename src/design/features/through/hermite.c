/* The feature 'hermite': cubics or quintics with given or estimated tangents. */
#include "design/shared/local.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"hermite", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"tangents", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "one for each point; without them 'estimate' says where they come from"},
    {"estimate", BATTEN_VALUE_WORD, false, false, "circle", BAT_TANGENT_WORDS,
     "the rule for tangents from neighbouring points"},
    {"lengths", BATTEN_VALUE_WORD, false, false, "chord", "chord middle rule",
     "of tangents: 1 over the chords; 1 with speed 1 in the middle too; as given or estimated"},
    {"degree", BATTEN_VALUE_WORD, false, false, "cubic", "cubic quintic",
     "quintic: second derivatives are continuous too"},
    {"second", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "second derivatives of a quintic, one for each point; else from the cubics"},
    BAT_EACH,
    BAT_CLOSED,
};

/* Points, tangents and second derivatives in the order of batten_curve_from_hermite. */
static void gather(const bat_data *data, const double *tangents, const double *second,
                   double *values)
{
    const size_t d = (size_t)data->dimension;
    for (size_t i = 0; i < (size_t)data->count; i++) {
        memcpy(values + 3 * i * d, data->points + i * d, d * sizeof *values);
        memcpy(values + (3 * i + 1) * d, tangents + i * d, d * sizeof *values);
        memcpy(values + (3 * i + 2) * d, second + i * d, d * sizeof *values);
    }
}

static batten_status make_quintic(const bat_run *run, const bat_data *data, const double *t,
                                  const double *tangents, bat_made *made)
{
    const size_t n = (size_t)data->count, d = (size_t)data->dimension;
    double *second = NULL, *values = bat_array3(n, 3 * d, sizeof *values);
    batten_status status =
        values ? bat_vectors(run, data, "second", &second) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && !second) {
        second = bat_array3(n, d, sizeof *second);
        status = second ? batten_second_derivatives(
                              (batten_points){data->dimension, data->count, data->points}, t,
                              tangents, false, second)
                        : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK) {
        gather(data, tangents, second, values);
        status =
            batten_curve_from_hermite(data->dimension, data->count, 3, t, values, &made->curve);
    }
    bat_release(second);
    bat_release(values);
    return status;
}

static batten_status make_open_quintic(bat_run *run, const bat_data *data,
                                       const batten_tangents_options *options, bat_made *made)
{
    const size_t n = (size_t)data->count, d = (size_t)data->dimension;
    batten_tangents_report report;
    double *tangents = bat_array3(n, d, sizeof *tangents);
    batten_status status = tangents ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && options->closed)
        status = bat_fail(BATTEN_UNSUPPORTED, "a closed curve is cubic here, not quintic");
    if (status == BATTEN_OK)
        status = batten_tangents((batten_points){data->dimension, data->count, data->points},
                                 options, made->parameters, &report, tangents, NULL);
    if (status == BATTEN_OK)
        status = make_quintic(run, data, made->parameters, tangents, made);
    if (status == BATTEN_OK)
        bat_note_turns(run, data, &report);
    bat_release(tangents);
    return status;
}

static batten_status make_hermite(bat_run *run, const bat_data *data, bat_made *made)
{
    enum { QUINTIC = 1 };
    double *given = NULL;
    batten_tangents_options options = batten_tangents_defaults();
    batten_status status = bat_vectors(run, data, "tangents", &given);
    options.rule =
        given ? BATTEN_TANGENT_GIVEN : (batten_tangent_rule)bat_word(run, "estimate");
    options.given = given;
    options.length = (batten_tangent_length)bat_word(run, "lengths");
    options.closed = bat_yes(run, "closed");
    if (status == BATTEN_OK)
        status = bat_word(run, "degree") == QUINTIC
                     ? make_open_quintic(run, data, &options, made)
                     : bat_make_of_tangents(run, data, &options, made);
    bat_release(given);
    return status;
}

static batten_status run_hermite(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE, make_hermite};
    return bat_through(run, &method);
}

const bat_feature bat_feature_hermite = {
    .shown =
        {"hermite", "Cubics or quintics with given or estimated tangents",
         "Through the points with a tangent at each: given as a list, one vector for each point,\n"
         "or estimated from neighbours by the rule in 'estimate'. 'lengths' sets their lengths: 1\n"
         "over the chords, 1 with steps such that spans have speed 1 in the middle too, or as they\n"
         "are, as derivatives with respect to the sum of chords. A cubic has a continuous\n"
         "derivative; 'degree: quintic' has second derivatives too, given in 'second' or the means\n"
         "of those of the cubics. Only spans beside a point change with it. A wrong tangent bends\n"
         "both of its spans: look at the comb.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 0]]}\n"
         "  bow: {hermite: ducks, tangents: [[0, 1], [1, 0], [0, -1]], lengths: middle}\n",
         "[SL section VI.8] [PT97 section 9.3]", "batten_curve_from_tangents",
         BAT_PARAMETERS(parameters), false,
         .also =
             "Hermite interpolation, Ferguson curve, cubic Hermite, quintic Hermite, osculating",
         .formula =
             "    S = P_i F0(t) + P_{i+1} F1(t) + h_i (T_i G0(t) + T_{i+1} G1(t)),  0 ≤ t ≤ 1\n"
             "    F0 = 1 − 3t² + 2t³,  F1 = 3t² − 2t³,  G0 = t − 2t² + t³,  G1 = t³ − t²   (cubic)",
         .promise =
             "Points and derivatives are met exactly; the first derivative is continuous, of quintics the second too."},
    .run = run_hermite};
