/* The feature 'arcs': the fewest arcs within a tolerance of curves or points. */
#include "base/plural.h"
#include "design/shared/rows.h"
#include "design/shared/through.h"
#include <batten/arcs.h>

static const batten_parameter parameters[] = {
    {"arcs", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "plane curves, or tables and rows of points"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "the distance that the arcs may have from curve or points"},
    {"joined", BATTEN_VALUE_WORD, false, false, "smooth", "smooth plain biarcs",
     "without corners, with small ones, or with the directions of the curve"},
    {"one-sided", BATTEN_VALUE_WORD, false, false, "either", "either left right inside outside",
     "the side of the curve, seen along it, or of a closed curve, on which the arcs may lie"},
    {"least-radius", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "the least radius that an arc may have"},
    {"most", BATTEN_VALUE_COUNT, false, false, "0", NULL,
     "the largest number of arcs allowed; 0 for any"},
    {"spread", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "with the same number of arcs, make the largest deviation as small as possible"},
    {"closed", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "of points: the last is followed by the first, which is not repeated"},
    BAT_EACH,
};

static batten_arcs_options options_of(const bat_run *run)
{
    batten_arcs_options options = batten_arcs_defaults();
    options.tolerance = bat_number(run, "within");
    options.joined = (batten_arcs_join)bat_word(run, "joined");
    options.side = (batten_arcs_side)bat_word(run, "one-sided");
    options.least_radius = bat_number(run, "least-radius");
    options.most = bat_count(run, "most");
    options.spread = bat_yes(run, "spread");
    options.closed = bat_yes(run, "closed");
    options.job = run->job;
    return options;
}

static void remark_arcs(bat_run *run, const char *name, const batten_arcs_report *report)
{
    bat_remark(
        run,
        "'%s': %d arc%s and %d line%s, %g beside it to the left and %g to the right; least "
        "radius %g, largest corner %.3g degree%s",
        name, report->arcs, bat_plural(report->arcs), report->lines, bat_plural(report->lines),
        report->left, report->right, report->least_radius, report->largest_turn * 180 / BAT_PI,
        bat_plural_real(report->largest_turn * 180 / BAT_PI, 3));
}

/* ---- points ---- */

static batten_status of_points(bat_run *run, const bat_data *data, bat_made *made)
{
    const batten_arcs_options options = options_of(run);
    batten_arcs_report report;
    const batten_status status =
        batten_arcs_from_points((batten_points){2, data->count, data->points}, &options,
                                made->parameters, &report, &made->chain);
    if (status != BATTEN_OK)
        return status;
    made->has_error = true;
    made->error_max = made->error_rms = report.error;
    remark_arcs(run, data->name, &report);
    return BATTEN_OK;
}

/* ---- curves ---- */

/* A curve as one of its plane x, y or z = constant. */
static batten_status flatten(const batten_object *object, batten_frame *frame,
                             batten_curve **flat)
{
    int axis;
    const batten_status status = batten_curve_flatten(object->curve, &axis, flat);
    if (status != BATTEN_OK)
        return status;
    if (axis < 0)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "'%s' must lie in a plane x, y or z = constant for 'arcs'",
                        object->name);
    *frame = batten_frame_across(axis, batten_curve_points(object->curve)[axis]);
    return BATTEN_OK;
}

static batten_status put_arcs(bat_run *run, const batten_object *from,
                              const batten_frame *frame, const batten_chain *arcs)
{
    batten_chain *placed = NULL;
    batten_curve *curve = NULL;
    batten_status status = batten_chain_place(arcs, frame, &placed);
    if (status == BATTEN_OK)
        status = batten_chain_to_curve(placed, bat_tolerance(run), NULL, &curve);
    const batten_object object = {.name = from->name,
                                  .layer = from->layer,
                                  .kind = BATTEN_OBJECT_CURVE,
                                  .curve = curve,
                                  .chain = placed};
    if (status == BATTEN_OK)
        status = bat_add(run, &object);
    batten_chain_unref(placed);
    batten_curve_unref(curve);
    return status;
}

static batten_status of_curve(bat_run *run, const batten_object *object)
{
    const batten_arcs_options options = options_of(run);
    batten_arcs_report report;
    batten_frame frame;
    batten_curve *flat = NULL;
    batten_chain *arcs = NULL;
    batten_status status = flatten(object, &frame, &flat);
    if (status == BATTEN_OK)
        status = batten_arcs_from_curve(flat, &options, &report, &arcs);
    if (status == BATTEN_OK) {
        remark_arcs(run, object->name, &report);
        bat_report_error(run, report.error, report.error);
        status = put_arcs(run, object, &frame, arcs);
    } else if (status != BATTEN_OUT_OF_MEMORY) {
        status = bat_fail(status, "%s: %s", object->name, batten_message());
    }
    batten_curve_unref(flat);
    batten_chain_unref(arcs);
    return status;
}

static batten_status run_arcs(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, of_points};
    bat_objects objects;
    batten_status status =
        bat_gather(run, "arcs", BAT_POINTS | BAT_OFFSETS | BAT_CURVES, &objects);
    if (status != BATTEN_OK)
        return status;
    bool has_curves = false;
    for (int i = 0; i < objects.count; i++)
        has_curves = has_curves || objects.at[i]->curve;
    for (int i = 0; i < objects.count && has_curves && status == BATTEN_OK; i++)
        status = objects.at[i]->curve
                     ? of_curve(run, objects.at[i])
                     : bat_fail(BATTEN_NOT_COMPATIBLE, "'%s' is not a curve, as the others are",
                                objects.at[i]->name);
    bat_objects_release(&objects);
    return has_curves || status != BATTEN_OK ? status : bat_through(run, &method);
}

const bat_feature bat_feature_arcs = {
    .shown =
        {"arcs", "The fewest arcs within a tolerance of curves or points",
         "For machines that follow only arcs and lines: cutters, routers, benders. Each arc is as\n"
         "long as 'within' allows, so few are needed; 'spread' then makes the largest deviation as\n"
         "small as the same number of arcs can. 'smooth' arcs turn only at corners of the curve;\n"
         "'plain' ones may have small corners where they meet, and are lines where the curve is\n"
         "nearly straight; 'biarcs' have the directions of the curve at their ends, which takes\n"
         "nearly half as many arcs again. 'one-sided' keeps the cutter off one side, which takes a\n"
         "quarter more arcs. Ends and corners of the curve stay, and so does whatever consists\n"
         "exactly of lines and arcs from corner to corner: circles, polylines, and what 'fillet'\n"
         "and 'offset' make of them. The number of arcs, the deviation to either side and the\n"
         "least radius are noted. Arcs through points start and end at points and pass the others\n"
         "within the tolerance; 'plain' suits rough points better. A least radius larger than the\n"
         "curve itself has somewhere is refused, and the message says where.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 40 cm], [3 m, 1 m]]}\n"
         "  edge: {interpolate: ducks}\n"
         "  path: {arcs: edge, within: 0.5 mm}\n",
         "[MW95] [Bolton75]", "batten_arcs_from_curve", BAT_PARAMETERS(parameters), false,
         .also = "arc fitting, arc approximation, G2 G3 moves, CNC, toolpath, post-processing",
         .formula =
             "    dist(C, arcs) ≤ within, with the fewest arcs;  their number tends to ∫ |dκ/ds|^⅓ ds/(72 √3 within)^⅓",
         .promise = "No place is farther than the tolerance, on one side if so asked."},
    .run = run_arcs};
