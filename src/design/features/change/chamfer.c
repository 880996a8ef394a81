/* The feature 'chamfer': corners cut off by straight lines. */
#include "design/shared/pair.h"

#include <batten/blend.h>

static const batten_parameter parameters[] = {
    {"chamfer", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "curves with corners, or two curves between which there is one"},
    {"by", BATTEN_VALUE_LENGTH, true, true, NULL, NULL,
     "the length cut off on either side of a corner, or one before and one behind it"},
    BAT_PAIR_ENDS,
};

/* The lengths before and behind a corner. */
static batten_status lengths_of(const bat_run *run, double by[2])
{
    const bat_argument *argument = bat_argument_of(run, "by");
    if (argument->count > 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'by' has %d lengths, at most 2 are used",
                        argument->count);
    for (int k = 0; k < 2; k++)
        by[k] = argument->items[argument->count == 2 ? k : 0].number[0];
    return BATTEN_OK;
}

static batten_status chamfer_pair(bat_run *run, const double by[2])
{
    batten_curve *curves[2] = {NULL, NULL}, *line = NULL, *made = NULL;
    const double within = bat_tolerance(run);
    double u[2];
    batten_status status = bat_pair_take(run, "chamfer", curves);
    if (status == BATTEN_OK)
        status = batten_curves_chamfer(curves[0], curves[1], (double[2]){by[0], by[1]}, within,
                                       u, &line);
    if (status == BATTEN_OK)
        status = bat_pair_join((const batten_curve *const *)curves, u, line, within, &made);
    batten_curve_unref(line);
    for (int k = 0; k < 2; k++)
        batten_curve_unref(curves[k]);
    return bat_put_curve(run, status, made);
}

static batten_status chamfer_object(bat_run *run, const batten_object *object,
                                    const double by[2])
{
    batten_corners_report report = {.corners = 0};
    batten_curve *made = NULL;
    const batten_status status = batten_curve_chamfer(
        object->curve, (double[2]){by[0], by[1]}, bat_tolerance(run) / 1000, &report, &made);
    if (status != BATTEN_OK)
        return bat_fail(status, "%s: %s", object->name, batten_message());
    if (report.corners == 0)
        bat_note(run, "'%s' has no corner", object->name);
    return bat_put_curve_like(run, status, made, object, false);
}

static batten_status run_chamfer(bat_run *run)
{
    bat_objects all;
    double by[2] = {0, 0};
    batten_status status = lengths_of(run, by);
    if (status == BATTEN_OK)
        status = bat_gather(run, "chamfer", BAT_CURVES, &all);
    if (status != BATTEN_OK)
        return status;
    if (bat_argument_of(run, "chamfer")->count == 2 && all.count == 2)
        status = chamfer_pair(run, by);
    else
        for (int i = 0; i < all.count && status == BATTEN_OK; i++)
            status = chamfer_object(run, all.at[i], by);
    bat_objects_release(&all);
    return status;
}

const bat_feature bat_feature_chamfer = {
    .shown =
        {"chamfer", "Corners cut off by straight lines",
         "At every corner of a curve, or between two curves that meet, the given lengths along the\n"
         "curve are removed and a line takes their place. Curves shorter than the length, or\n"
         "corners so close that their cuts overlap, are refused; the message names the corner.",
         "features:\n"
         "  plan: {polyline: [[0, 0], [4 m, 0], [4 m, 3 m], [1 m, 3 m]]}\n"
         "  plate: {chamfer: plan, by: [0.2 m, 0.4 m]}\n",
         "[PT97]", "batten_curve_chamfer", BAT_PARAMETERS(parameters), false,
         .also = "bevel, break corners"},
    .run = run_chamfer,
    .displacing = "chamfer"};
