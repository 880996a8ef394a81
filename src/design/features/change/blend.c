/* The feature 'blend': a curve between two curves, or a surface between two surfaces,
 * smooth at both. */
#include "base/plural.h"
#include "design/shared/pair.h"

#include <batten/blend.h>

static const batten_parameter parameters[] = {
    {"blend", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "two curves, or two surfaces"},
    BAT_PAIR_ENDS,
    {"first", BATTEN_VALUE_WORD, false, false, "G2", "G0 G1 G2 G3",
     "how it joins the first curve: position, tangent, curvature, rate of curvature"},
    {"second", BATTEN_VALUE_WORD, false, false, "G2", "G0 G1 G2 G3",
     "how it joins the second curve"},
    {"bulge", BATTEN_VALUE_NUMBER, true, false, "1", NULL,
     "how far it follows the curves before it turns, one factor or one for each end"},
    {"whole", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "curves: they and the blend as one, from the far end of the first"},
    {"edges", BATTEN_VALUE_WORD, true, false, NULL, "v0 u1 v1 u0",
     "surfaces: the edge of the first, v0 for that of least v and so on, and of the second"},
    {"parts", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "surfaces: from where to where on the first edge, and on the second; 0 to 1"},
};

/* One factor for both ends or one for each. */
static batten_status check_bulge(const bat_argument *bulge)
{
    if (bulge->count > 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'bulge' has %d factors, at most 2 are used",
                        bulge->count);
    return BATTEN_OK;
}

static batten_status blend(bat_run *run, const batten_curve *const curves[2],
                           batten_curve **out)
{
    const bat_argument *bulge = bat_argument_of(run, "bulge");
    batten_blend_end ends[2];
    batten_curves_blend_report report;
    batten_curve *made = NULL;
    if (check_bulge(bulge) != BATTEN_OK)
        return BATTEN_BAD_ARGUMENT;
    for (int k = 0; k < 2; k++)
        ends[k] =
            (batten_blend_end){.end = k ? BATTEN_CURVE_START : BATTEN_CURVE_END,
                               .continuity = bat_word(run, k ? "second" : "first"),
                               .bulge = bulge->items[bulge->count == 2 ? k : 0].number[0]};
    batten_status status =
        batten_curves_blend(curves[0], &ends[0], curves[1], &ends[1], &report, &made);
    if (status != BATTEN_OK)
        return status;
    bat_remark(run, "joins with G%d and G%d", report.joins[0].geometric,
               report.joins[1].geometric);
    const double u[2] = {batten_curve_domain(curves[0]).b, batten_curve_domain(curves[1]).a};
    if (bat_yes(run, "whole"))
        status = bat_pair_join(curves, u, made, bat_tolerance(run), out);
    else
        *out = batten_curve_ref(made);
    batten_curve_unref(made);
    return status;
}

/* ---- surfaces ---- */

static batten_status surface_ends(const bat_run *run, batten_surface_blend_end ends[2])
{
    const bat_argument *bulge = bat_argument_of(run, "bulge");
    const bat_argument *edges = bat_argument_of(run, "edges");
    const bat_argument *parts = bat_argument_of(run, "parts");
    if (edges->count != 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "surfaces are blended between two 'edges', %d are given", edges->count);
    if (parts->count != 0 && parts->count != 4)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'parts' are four numbers, %d are given",
                        parts->count);
    for (int k = 0; k < 2; k++) {
        ends[k] = batten_surfaces_blend_defaults((batten_edge)edges->items[k].count);
        ends[k].continuity = bat_word(run, k ? "second" : "first");
        ends[k].bulge = bulge->items[bulge->count == 2 ? k : 0].number[0];
        if (parts->count == 0)
            continue;
        ends[k].from = parts->items[2 * k].number[0];
        ends[k].to = parts->items[2 * k + 1].number[0];
    }
    return check_bulge(bulge);
}

static void report_blend(const bat_run *run, const batten_surfaces_blend_report *report)
{
    const double degrees = 180 / 3.14159265358979323846;
    bat_remark(
        run,
        "the edges run %s; normals jump by %.2g and %.2g degree%s, curvatures by %.2g and %.2g",
        report->reversed ? "against each other" : "alike", report->angle[0] * degrees,
        report->angle[1] * degrees, bat_plural_real(report->angle[1] * degrees, 2),
        report->curvature[0], report->curvature[1]);
    if (report->folded)
        bat_note(run, "the blend folds at (%.3g, %.3g); smaller bulges may help",
                 report->fold[0], report->fold[1]);
}

static batten_status blend_surfaces(bat_run *run, const bat_objects *all)
{
    batten_surface_blend_end ends[2];
    batten_surfaces_blend_report report;
    batten_surface *made = NULL;
    if (all->count != 2)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "two surfaces are needed, there are %d",
                        all->count);
    const batten_surface *const pair[2] = {all->at[0]->surface, all->at[1]->surface};
    batten_status status = surface_ends(run, ends);
    if (status == BATTEN_OK)
        status = batten_surfaces_blend(pair, ends, bat_tolerance(run) / 10, &report, &made);
    if (status == BATTEN_OK) {
        report_blend(run, &report);
        bat_report_error(run, report.error, report.error);
    }
    return bat_put_surface(run, status, made);
}

static batten_status run_blend(bat_run *run)
{
    batten_curve *curves[2] = {NULL, NULL}, *made = NULL;
    bat_objects all;
    batten_status status = BATTEN_OK;
    if (bat_has(run, "edges")) {
        status = bat_gather(run, "blend", BAT_SURFACES, &all);
        if (status != BATTEN_OK)
            return status;
        status = blend_surfaces(run, &all);
        bat_objects_release(&all);
        return status;
    }
    status = bat_pair_take(run, "blend", curves);
    if (status == BATTEN_OK)
        status = blend(run, (const batten_curve *const *)curves, &made);
    for (int k = 0; k < 2; k++)
        batten_curve_unref(curves[k]);
    return bat_put_curve(run, status, made);
}

const bat_feature bat_feature_blend = {
    .shown =
        {"blend",
         "A curve between two curves, or a surface between two surfaces, smooth at both",
         "A single Bezier curve of the least degree, 1 to 7, that has the tangent, the curvature\n"
         "and its rate of change of the two curves, as far as 'first' and 'second' ask. The curves\n"
         "themselves stay as they are. A bulge above 1 makes the blend follow the curve longer,\n"
         "below 1 turn sooner; where the ends are far apart compared with how sharply the curves\n"
         "bend, smaller bulges or G1 help. The joins are measured and noted. For ends that already\n"
         "meet use 'match'. With 'edges' it is the surface between an edge of one surface and one\n"
         "of another, with their tangent planes (G1) or curvatures (G2), exact where their weights\n"
         "allow. The second edge may run either way. A note says how it joins, and whether it\n"
         "folds.",
         "features:\n"
         "  aft: {line: [[0, 0], [2 m, 0.2 m]]}\n"
         "  fore: {line: [[4 m, 1.5 m], [5 m, 3 m]]}\n"
         "  bilge: {blend: [aft, fore], first: G3, bulge: [1, 0.8]}\n",
         "[BD89], [Filip89]", "batten_curves_blend, batten_surfaces_blend",
         BAT_PARAMETERS(parameters), false,
         .also = "bridge curve, transition, connect, G1 G2 G3, join smoothly, blend surface"},
    .run = run_blend,
    .displacing = "blend"};
