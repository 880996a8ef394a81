#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"reduce", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"degree", BATTEN_VALUE_COUNT, false, true, NULL, NULL, "the degree wanted"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "how far a curve may move"},
};

static batten_status curve(const bat_run *run, const batten_curve *given, double *error,
                           batten_curve **out)
{
    return batten_curve_reduce(given, bat_count(run, "degree"), bat_number(run, "within"),
                               error, out);
}

static batten_status run(bat_run *run)
{
    return bat_change_all(run, &(bat_change){.near_curve = curve, .keeps_data = true});
}

const bat_feature bat_feature_reduce = {
    .shown =
        {"reduce", "Nearly the same curve with a lower degree",
         "Fails, with the error it reached, when a curve would move farther than 'within'.",
         "features:\n"
         "  keel: {line: [[0, 0], [3 m, 0]]}\n"
         "  cubic: {elevate: keel, by: 2}\n"
         "  again: {reduce: cubic, degree: 1, within: 0.1 mm}\n",
         "[PT97]", "batten_curve_reduce", BAT_PARAMETERS(parameters), false},
    .run = run};
