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
         "For curves that carry more knots than their shape needs: from other systems, from digitised\n"
         "points, after joining and refining. The whole curve moves by no more than 'within', at equal\n"
         "parameters; the bound is proved by the control points of the difference. Knots go in groups,\n"
         "those first that matter least, and the rest is fitted to the given curve by least squares, so\n"
         "far fewer stay than when they go one by one. Both ends stay; so does the degree. With 'within: 0'\n"
         "only knots go whose going moves nothing at all. A closed curve without ends comes out with\n"
         "ends that meet; 'approximate' keeps it smooth there.",
         "features:\n"
         "  keel: {polyline: [[0, 0], [1 m, 1 mm], [3 m, 0]]}\n"
         "  bare: {remove-knots: keel, within: 2 mm}\n",
         "[LM87], [LM88]", "batten_curve_remove_knots", BAT_PARAMETERS(parameters), false},
    .run = run};
