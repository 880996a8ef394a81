/* The feature 'fillet': corners rounded by arcs of a radius. */
#include "design/shared/pair.h"

#include <batten/blend.h>

static const batten_parameter parameters[] = {
    {"fillet", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "curves with corners, or two curves between which there is one"},
    {"radius", BATTEN_VALUE_LENGTH, true, true, NULL, NULL,
     "one for all corners, or one for each; 0 leaves a corner"},
    BAT_PAIR_ENDS,
    {"whole", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "of two curves: what is left of them and the arc as one; no: the arc alone"},
};

static void note_incomplete(bat_run *run, const char *name)
{
    bat_note(run,
             "%s: the curves are not straight: another arc may have been overlooked, or "
             "one nearer to the corner",
             name);
}

static batten_status radii_of(const bat_run *run, int *count, double **out)
{
    const bat_argument *argument = bat_argument_of(run, "radius");
    *count = argument->count;
    *out = bat_array((size_t)argument->count, sizeof **out);
    for (int i = 0; *out && i < argument->count; i++)
        (*out)[i] = argument->items[i].number[0];
    return *out ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* ---- between two curves ---- */

static batten_status between(bat_run *run, const batten_curve *const curves[2],
                             batten_curve **out)
{
    const bat_argument *radius = bat_argument_of(run, "radius");
    batten_curves_fillet_report report;
    batten_curve *arc = NULL;
    if (radius->count != 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "two curves have one corner and one radius");
    batten_status status = batten_curves_fillet(
        curves[0], curves[1], radius->items[0].number[0], bat_tolerance(run), &report, &arc);
    if (status != BATTEN_OK)
        return status;
    bat_report_error(run, report.gap, report.gap);
    if (!report.complete)
        note_incomplete(run, run->name);
    if (bat_yes(run, "whole"))
        status = bat_pair_join(curves, report.u, arc, 2 * bat_tolerance(run), out);
    else
        *out = batten_curve_ref(arc);
    batten_curve_unref(arc);
    return status;
}

static batten_status fillet_pair(bat_run *run)
{
    batten_curve *curves[2] = {NULL, NULL}, *made = NULL;
    batten_status status = bat_pair_take(run, "fillet", curves);
    if (status == BATTEN_OK)
        status = between(run, (const batten_curve *const *)curves, &made);
    for (int k = 0; k < 2; k++)
        batten_curve_unref(curves[k]);
    return bat_put_curve(run, status, made);
}

/* ---- corners ---- */

static batten_status fillet_object(bat_run *run, const batten_object *object, int count,
                                   const double *radii)
{
    batten_corners_report report = {.complete = true};
    batten_curve *made = NULL;
    batten_status status =
        batten_curve_fillet(object->curve, count, radii, bat_tolerance(run), &report, &made);
    if (status != BATTEN_OK)
        return bat_fail(status, "%s: %s", object->name, batten_message());
    bat_report_error(run, report.gap, report.gap);
    if (report.corners == 0)
        bat_note(run, "'%s' has no corner", object->name);
    if (!report.complete)
        note_incomplete(run, object->name);
    return bat_put_curve_like(run, status, made, object, false);
}

static batten_status run_fillet(bat_run *run)
{
    bat_objects all;
    int count;
    double *radii = NULL;
    batten_status status = bat_gather(run, "fillet", BAT_CURVES, &all);
    if (status != BATTEN_OK)
        return status;
    if (bat_argument_of(run, "fillet")->count == 2 && all.count == 2) {
        bat_objects_release(&all);
        return fillet_pair(run);
    }
    status = radii_of(run, &count, &radii);
    for (int i = 0; i < all.count && status == BATTEN_OK; i++)
        status = fillet_object(run, all.at[i], count, radii);
    bat_release(radii);
    bat_objects_release(&all);
    return status;
}

const bat_feature bat_feature_fillet = {
    .shown =
        {"fillet", "Corners rounded by arcs of a radius",
         "Every corner of a polyline or of a kinked curve, in a plane or, where the curves beside\n"
         "a corner are in one plane, in space; or, with two names, the corner between two curves,\n"
         "which may also cross or end short of each other. The arcs are exact and tangent to the\n"
         "curves at both ends. A radius that is too large is refused; the message names the\n"
         "corner, counted from 1. Between curves that are not straight the arc that cuts off least\n"
         "of them is chosen; where several arcs barely touch, one may be overlooked, and a note\n"
         "says so.",
         "features:\n"
         "  plan: {polyline: [[0, 0], [4 m, 0], [4 m, 3 m], [1 m, 3 m]]}\n"
         "  kerb: {fillet: plan, radius: 0.5 m}\n"
         "  wall: {line: [[0, 0], [4 m, 0]]}\n"
         "  apse: {arc: 1.5 m, at: [2 m, 1 m], start: -50 deg, angle: 140 deg}\n"
         "  both: {fillet: [wall, apse], radius: 0.3 m, ends: end-start}\n",
         "[PT97]", "batten_curve_fillet", BAT_PARAMETERS(parameters), false,
         .also = "round corners, radius"},
    .run = run_fillet,
    .displacing = "fillet"};
