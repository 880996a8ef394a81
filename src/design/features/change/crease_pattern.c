/* The feature 'crease-pattern': the flat sheet of a fold. */
#include "design/features/change/fold.h"
#include "design/shared/outline.h"

#include <batten/interpolate.h>
#include <batten/standard.h>
#include <string.h>

static const batten_parameter parameters[] = {
    {"crease-pattern", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the crease: a curve"},
    BAT_FOLD_PARAMETERS,
    {"rulings", BATTEN_VALUE_COUNT, false, false, "24", NULL,
     "how many are drawn on each side"},
};

/* The end of a ruling in the flat sheet; without a sheet the point of the crease. */
static void flat_point(const batten_fold *fold, const batten_fold_sheet *sheet, int i,
                       double *out)
{
    for (int c = 0; c < 2; c++)
        out[c] = fold->flat[2 * i + c] +
                 (sheet ? sheet->lengths[i] * sheet->flat_rulings[2 * i + c] : 0);
}

/* The curve through all samples of the crease, or of an edge. */
static batten_status smooth(const batten_fold *fold, const batten_fold_sheet *sheet,
                            batten_curve **out)
{
    double *points = batten_array((size_t)fold->count, 2 * sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < fold->count; i++)
        flat_point(fold, sheet, i, points + 2 * i);
    const batten_status status =
        batten_curve_interpolate((batten_points){2, fold->count, points}, NULL, NULL, out);
    batten_release(points);
    return status;
}

/* From the end of one edge over the crease to the end of the other: sample 0 or the last. */
static batten_status end_line(const batten_fold *fold, bool at_start, batten_curve **out)
{
    const int i = at_start ? 0 : fold->count - 1;
    double points[6];
    flat_point(fold, at_start ? &fold->right : &fold->left, i, points);
    flat_point(fold, NULL, i, points + 2);
    flat_point(fold, at_start ? &fold->left : &fold->right, i, points + 4);
    return batten_curve_polyline((batten_points){2, 3, points}, out);
}

static batten_status put_outline(bat_run *run, const batten_fold *fold)
{
    static const double black[3] = {0, 0, 0};
    /* Pieces of one fold meet to rounding; a thousand-millionth of its length is above that. */
    const double tolerance = 1e-9 * fold->length;
    batten_curve *outline = NULL, *piece = NULL, *right = NULL;
    batten_status status = smooth(fold, &fold->left, &outline);
    if (status == BATTEN_OK)
        status = end_line(fold, false, &piece);
    status = bat_outline_add(status, tolerance, piece, &outline);
    piece = NULL;
    if (status == BATTEN_OK)
        status = smooth(fold, &fold->right, &right);
    if (status == BATTEN_OK)
        status = batten_curve_reverse(right, &piece);
    status = bat_outline_add(status, tolerance, piece, &outline);
    batten_curve_unref(right);
    piece = NULL;
    if (status == BATTEN_OK)
        status = end_line(fold, true, &piece);
    status = bat_outline_add(status, tolerance, piece, &outline);
    return bat_put_flat(run, status, outline, "outline", "cut", black);
}

static batten_status put_crease(bat_run *run, const batten_fold *fold)
{
    static const double red[3] = {1, 0, 0}, blue[3] = {0, 0, 1};
    const bool mountain = fold->angles[0] > 0;
    batten_curve *crease = NULL;
    const batten_status status = smooth(fold, NULL, &crease);
    return bat_put_flat(run, status, crease, "crease", mountain ? "mountain" : "valley",
                        mountain ? red : blue);
}

static batten_status put_ruling(bat_run *run, const batten_fold *fold,
                                const batten_fold_sheet *sheet, int i)
{
    static const double grey[3] = {0.75, 0.75, 0.75};
    double ends[4];
    batten_curve *line = NULL;
    flat_point(fold, NULL, i, ends);
    flat_point(fold, sheet, i, ends + 2);
    const batten_status status = batten_curve_line(2, ends, ends + 2, &line);
    return bat_put_flat(run, status, line, "", "rulings", grey);
}

static batten_status put_rulings(bat_run *run, const batten_fold *fold,
                                 const batten_fold_sheet *sheet, int count)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < count && status == BATTEN_OK; k++) {
        const int i = (int)((double)(fold->count - 1) * (k + 1) / (count + 1) + 0.5);
        status = put_ruling(run, fold, sheet, i);
    }
    return status;
}

static batten_status run_crease_pattern(bat_run *run)
{
    const int rulings = bat_count(run, "rulings");
    batten_fold fold;
    if (rulings < 0 || rulings > 1000)
        return batten_fail(BATTEN_BAD_ARGUMENT, "%d rulings; there may be 0 to 1000", rulings);
    batten_status status = bat_fold(run, &fold);
    if (status != BATTEN_OK)
        return status;
    status = put_outline(run, &fold);
    if (status == BATTEN_OK)
        status = put_crease(run, &fold);
    if (status == BATTEN_OK)
        status = put_rulings(run, &fold, &fold.left, rulings);
    if (status == BATTEN_OK)
        status = put_rulings(run, &fold, &fold.right, rulings);
    batten_fold_release(&fold);
    return status;
}

const bat_feature bat_feature_crease_pattern = {
    .shown =
        {"crease-pattern", "The flat sheet of a fold",
         "What is cut out and folded, in the xy-plane: the outline on the layer 'cut', the crease\n"
         "on 'mountain' or 'valley' by the sign of the angle, and on 'rulings' some of the lines\n"
         "along which the sheets stay straight. Write it as .dxf, or as 'sheet.svg: {write:\n"
         "sheet}', both at true scale; 'sheet.svg: sheet' alone is a page with a picture. The\n"
         "parameters are those of 'fold'.",
         "features:\n"
         "  edge: {arc: 1 m, angle: 120 deg}\n"
         "  sheet: {crease-pattern: edge, angle: 30 deg, left: 40 cm, right: 30 cm}\n"
         "outputs:\n"
         "  sheet.dxf: sheet\n",
         "[Utah74 paper 12] [Huffman76] [DuncanDuncan82]", "batten_fold_create",
         BAT_PARAMETERS(parameters), false, .also = "flat sheet of a fold, origami pattern",
         .formula = "    flat curvature κ_g = κ cos α,  x′ = cos φ,  y′ = sin φ,  φ′ = κ_g",
         .promise = "Lengths and angles on the sheet are those in space."},
    .run = run_crease_pattern,
    .displacing = "crease-pattern"};
