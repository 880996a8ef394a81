/* The feature 'remove-knots': nearly the same curve with fewer knots and control points. */
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

static batten_status run_remove_knots(bat_run *run)
{
    return bat_change_all(run, &(bat_change){.near_curve = curve, .keeps_data = true});
}

const bat_feature bat_feature_remove_knots = {
    .shown =
        {"remove-knots", "Nearly the same curve with fewer knots and control points",
         "For curves that carry more knots than their shape needs: from other systems, from\n"
         "digitised points, after joining and refining. The whole curve moves by no more than\n"
         "'within', at equal parameters; the bound is proved by the control points of the\n"
         "difference. Knots are removed in groups, the least important first, and what is left is\n"
         "fitted to the given curve by least squares, so far fewer remain than when knots are\n"
         "removed one by one. Both ends stay, and so does the degree. With 'within: 0' only knots\n"
         "are removed whose removal moves nothing at all. A closed curve without ends comes out\n"
         "with ends that meet; 'approximate' keeps it smooth there.",
         "features:\n"
         "  keel: {polyline: [[0, 0], [1 m, 1 mm], [3 m, 0]]}\n"
         "  bare: {remove-knots: keel, within: 2 mm}\n",
         "[LM87], [LM88]", "batten_curve_remove_knots", BAT_PARAMETERS(parameters), false,
         .also = "knot removal, simplify, fewer control points"},
    .run = run_remove_knots};
