#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"remove-knots", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "how far a curve may move"},
};

static batten_status curve(const bat_run *run, const batten_curve *given, double *error,
                           batten_curve **out)
{
    return batten_curve_remove_knots(given, bat_number(run, "within"), NULL, error, out);
}

static batten_status run(bat_run *run)
{
    return bat_change_all(run, &(bat_change){.near_curve = curve, .keeps_data = true});
}

const bat_feature bat_feature_remove_knots = {
    .shown =
        {"remove-knots", "Nearly the same curve with fewer knots and control points",
         "Every knot goes that can go while the whole curve moves by no more than 'within'.",
         "features:\n"
         "  keel: {polyline: [[0, 0], [1 m, 1 mm], [3 m, 0]]}\n"
         "  bare: {remove-knots: keel, within: 2 mm}\n",
         "[PT97]", "batten_curve_remove_knots", BAT_PARAMETERS(parameters), false},
    .run = run};
