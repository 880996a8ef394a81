/* The feature 'fold': a sheet folded along a curve. */
#include "design/features/change/fold.h"
#include "base/plural.h"

#include <stdio.h>

static const batten_parameter parameters[] = {
    {"fold", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the crease: a curve"},
    BAT_FOLD_PARAMETERS,
};

/* The numbers of a list. */
static double *numbers_of(const bat_run *run, const char *parameter, int *count)
{
    const bat_argument *given = bat_argument_of(run, parameter);
    double *values = batten_array((size_t)given->count, sizeof *values);
    for (int i = 0; values && i < given->count; i++)
        values[i] = given->items[i].number[0];
    *count = given->count;
    return values;
}

static batten_status find_crease(bat_run *run, const batten_curve **crease)
{
    bat_objects curves;
    const char *input = run->feature->parameters[0].name;
    batten_status status = bat_gather(run, input, BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    if (curves.count > 1)
        status = batten_fail(BATTEN_BAD_ARGUMENT, "a sheet is folded along one curve, not %d",
                             curves.count);
    else
        *crease = curves.at[0]->curve;
    bat_objects_release(&curves);
    return status;
}

batten_status bat_fold(bat_run *run, batten_fold *out)
{
    const batten_curve *crease = NULL;
    const bool by_curvature = bat_has(run, "flat-curvature");
    if (by_curvature == bat_has(run, "angle"))
        return batten_fail(BATTEN_BAD_ARGUMENT,
                           "either 'angle' or 'flat-curvature' must be given");
    batten_status status = find_crease(run, &crease);
    if (status != BATTEN_OK)
        return status;
    batten_fold_create_options options = batten_fold_create_defaults();
    double *values = numbers_of(run, by_curvature ? "flat-curvature" : "angle", &options.count);
    double *torsions = numbers_of(run, "torsion", &options.torsion_count);
    options.given = bat_word(run, "crease") == 1 ? BATTEN_FOLD_FLAT
                    : by_curvature               ? BATTEN_FOLD_CURVATURE
                                                 : BATTEN_FOLD_ANGLE;
    options.values = values;
    options.torsions = torsions;
    options.left = bat_number(run, "left");
    options.right = bat_has(run, "right") ? bat_number(run, "right") : options.left;
    options.tolerance = bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    if (!values || !torsions)
        status = BATTEN_OUT_OF_MEMORY;
    else if (by_curvature && options.given == BATTEN_FOLD_FLAT)
        status = batten_fail(BATTEN_BAD_ARGUMENT, "a flat crease needs 'angle'");
    else
        status = batten_fold_create(crease, &options, out);
    batten_release(values);
    batten_release(torsions);
    if (status == BATTEN_OK)
        bat_report_error(run, out->error, out->error);
    return status;
}

static batten_status put_sheet(bat_run *run, batten_fold_sheet *sheet, const char *side)
{
    char name[300];
    snprintf(name, sizeof name, "%.280s %s", run->name, side);
    const batten_object like = {.name = name, .layer = ""};
    batten_surface *surface = sheet->surface;
    sheet->surface = NULL;
    return bat_put_surface_like(run, BATTEN_OK, surface, &like);
}

static batten_status run_fold(bat_run *run)
{
    batten_fold fold;
    batten_status status = bat_fold(run, &fold);
    if (status != BATTEN_OK)
        return status;
    status = put_sheet(run, &fold.left, "left");
    if (status == BATTEN_OK)
        status = put_sheet(run, &fold.right, "right");
    if (status == BATTEN_OK) {
        batten_curve *crease = fold.crease;
        fold.crease = NULL;
        status = bat_put_curve(run, status, crease);
    }
    bat_remark(
        run,
        "%d sample%s along %.6g; the sheets may be %.4g (left) and %.4g (right) wide; lengths "
        "differ by %.1e from those of the flat sheet",
        fold.count, bat_plural(fold.count), fold.length, fold.left.regression,
        fold.right.regression, fold.stretch);
    batten_fold_release(&fold);
    return status;
}

const bat_feature bat_feature_fold = {
    .shown =
        {"fold", "A sheet folded along a curve",
         "The two developable surfaces that meet in a space curve when a flat sheet is folded\n"
         "along it: surfaces 'NAME left' and 'NAME right', and the crease. Each stands at 'angle'\n"
         "to the osculating plane of the crease, so they meet at 180 degrees less twice the angle;\n"
         "a negative angle folds the other way. The crease must be curved all along, more than it\n"
         "is in the flat sheet. A sheet wider than its edge of regression allows is refused, with\n"
         "the width that would do. 'crease-pattern' draws the flat sheet.",
         "features:\n"
         "  edge: {arc: 1 m, angle: 120 deg}\n"
         "  roof: {fold: edge, angle: 30 deg, left: 40 cm, right: 30 cm}\n",
         "[Utah74 paper 12] [Huffman76] [DuncanDuncan82] [FuchsTabachnikov99]",
         "batten_fold_create", BAT_PARAMETERS(parameters), false,
         .also = "curved crease, origami, curved folding, Resch, Huffman, folded edge",
         .formula =
             "    cot β± = (τ ± α′)/(κ sin α),  rulings at β± to the crease;  flat curvature κ cos α",
         .promise = "Both sheets are developable and unfold to the same plane curve."},
    .run = run_fold,
    .displacing = "fold"};
