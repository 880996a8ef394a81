#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"remove-knots", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "how far a curve may move"},
};

static batten_status run(bat_run *run)
{
    bat_objects curves;
    batten_status status = bat_gather(run, "remove-knots", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < curves.count && status == BATTEN_OK; i++) {
        batten_curve *curve = NULL;
        double error = 0;
        int removed = 0;
        status = batten_curve_remove_knots(curves.at[i]->curve, bat_number(run, "within"), &removed,
                                           &error, &curve);
        status = bat_put_curve_like(run, status, curve, curves.at[i], true);
        if (status == BATTEN_OK)
            bat_report_error(run, error, error);
    }
    bat_objects_release(&curves);
    return status;
}

const bat_feature bat_feature_remove_knots = {
    .shown = {"remove-knots", "Nearly the same curve with fewer knots and control points",
              "Every knot goes that can go while the whole curve moves by no more than 'within'.",
              "features:\n"
              "  keel: {polyline: [[0, 0], [1 m, 1 mm], [3 m, 0]]}\n"
              "  bare: {remove-knots: keel, within: 2 mm}\n",
              "[PT97]", "batten_curve_remove_knots", BAT_PARAMETERS(parameters), false},
    .run = run};
