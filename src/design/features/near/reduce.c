/* The feature 'reduce': nearly the same shape with a lower degree. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"reduce", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves and surfaces"},
    {"degree", BATTEN_VALUE_COUNT, false, true, NULL, NULL, "the degree wanted"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "how far the shape may move"},
    {"direction", BATTEN_VALUE_WORD, false, false, "u", "u v", "of surfaces"},
};

static batten_status curve(const bat_run *run, const batten_curve *given, double *error,
                           batten_curve **out)
{
    return batten_curve_reduce(given, bat_count(run, "degree"), bat_number(run, "within"),
                               error, out);
}

static batten_status surface(const bat_run *run, const batten_surface *given, double *error,
                             batten_surface **out)
{
    return batten_surface_reduce(given, (batten_direction)bat_word(run, "direction"),
                                 bat_count(run, "degree"), bat_number(run, "within"), error,
                                 out);
}

static batten_status run_reduce(bat_run *run)
{
    return bat_change_all(
        run, &(bat_change){.near_curve = curve, .near_surface = surface, .keeps_data = true});
}

const bat_feature bat_feature_reduce = {
    .shown =
        {"reduce", "Nearly the same shape with a lower degree",
         "Fails, with the error it reached, when the shape would move farther than 'within'.",
         "features:\n"
         "  keel: {line: [[0, 0], [3 m, 0]]}\n"
         "  cubic: {elevate: keel, by: 2}\n"
         "  again: {reduce: cubic, degree: 1, within: 0.1 mm}\n",
         "[PT97 section 5.6]", "batten_curve_reduce", BAT_PARAMETERS(parameters), false,
         .also = "degree reduction, lower degree"},
    .run = run_reduce};
