/* The feature 'match': two curves or surfaces made to join smoothly by moving control
 * points. */
#include "base/plural.h"
#include "design/feature.h"

#include <batten/continuity.h>

/* The words of 'continuity'. */
static const struct {
    batten_match_kind kind;
    int order;
} joins[] = {
    {BATTEN_MATCH_GEOMETRIC, 0},  {BATTEN_MATCH_GEOMETRIC, 1},  {BATTEN_MATCH_GEOMETRIC, 2},
    {BATTEN_MATCH_PARAMETRIC, 1}, {BATTEN_MATCH_PARAMETRIC, 2}, {BATTEN_MATCH_PARAMETRIC, 3},
};

static const batten_parameter parameters[] = {
    {"match", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "two curves, or two surfaces, in order"},
    {"continuity", BATTEN_VALUE_WORD, false, false, "G2", "G0 G1 G2 C1 C2 C3",
     "how they join: position, tangent, curvature; or, for curves, equal derivatives"},
    {"moves", BATTEN_VALUE_WORD, false, false, "second", "second first both",
     "which one moves; surfaces: not both"},
};

static batten_status match_curves(bat_run *run, const bat_objects *all)
{
    batten_curve *made[2] = {NULL, NULL};
    double moved = 0;
    const int join = bat_word(run, "continuity");
    batten_status status =
        batten_curves_match(all->at[0]->curve, all->at[1]->curve,
                            (batten_match){joins[join].kind, joins[join].order,
                                           (batten_match_mover)bat_word(run, "moves")},
                            &moved, &made[0], &made[1]);
    if (status == BATTEN_OK)
        bat_report_error(run, moved, moved);
    for (int k = 0; k < 2; k++)
        status = bat_put_curve_like(run, status, made[k], all->at[k], false);
    return status;
}

static batten_status match_surfaces(bat_run *run, const bat_objects *all)
{
    const int join = bat_word(run, "continuity"), mover = bat_word(run, "moves");
    if (joins[join].kind != BATTEN_MATCH_GEOMETRIC || mover == BATTEN_MATCH_MOVES_BOTH)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "surfaces join with G0, G1 or G2, and only one of them moves");
    const int moves = mover == BATTEN_MATCH_MOVES_FIRST ? 0 : 1;
    const batten_surface *own = all->at[moves]->surface, *other = all->at[1 - moves]->surface;
    batten_edge own_edge, other_edge;
    batten_surface_match_report report;
    batten_surface *made[2] = {NULL, NULL};
    batten_status status = batten_surfaces_near_edges(own, other, &own_edge, &other_edge, NULL);
    if (status == BATTEN_OK)
        status = batten_surface_match(
            (batten_surface_edge){own, own_edge}, (batten_surface_edge){other, other_edge},
            joins[join].order, bat_tolerance(run), &report, &made[moves]);
    if (status == BATTEN_OK) {
        made[1 - moves] = batten_surface_ref(other);
        bat_report_error(run, report.moved, report.moved);
        bat_remark(run,
                   "along the edge the surfaces are %.3g apart, their tangent planes %.3g "
                   "degree%s, their curvatures %.3g",
                   report.gap, report.angle * 180 / BAT_PI,
                   bat_plural_real(report.angle * 180 / BAT_PI, 3), report.curvature);
    }
    for (int k = 0; k < 2; k++)
        status = bat_put_surface_like(run, status, made[k], all->at[k]);
    return status;
}

static batten_status run_match(bat_run *run)
{
    bat_objects all;
    batten_status status = bat_gather(run, "match", BAT_CURVES | BAT_SURFACES, &all);
    if (status != BATTEN_OK)
        return status;
    if (all.count != 2 || all.at[0]->kind != all.at[1]->kind)
        status = bat_fail(BATTEN_NOT_COMPATIBLE,
                          all.count == 2
                              ? "a curve and a surface; two of one kind are needed"
                              : "two curves or two surfaces are needed, there are %d objects",
                          all.count);
    else if (all.at[0]->kind == BATTEN_OBJECT_CURVE)
        status = match_curves(run, &all);
    else
        status = match_surfaces(run, &all);
    bat_objects_release(&all);
    return status;
}

const bat_feature bat_feature_match = {
    .shown =
        {"match", "Two curves or surfaces made to join smoothly by moving control points",
         "The end of the first and the start of the second; only the one to three control points\n"
         "next to the join move, weights and knots stay. 'G1' and 'G2' keep each curve's own speed\n"
         "and make tangents and curvatures equal; 'C1' to 'C3' make derivatives equal with the\n"
         "least movement. Curves that are far apart, or point away from each other, become kinked\n"
         "near the join: use 'blend' for these. The report says how far the farthest control point\n"
         "moved. For surfaces the two nearest edges are joined; the surface that moves takes over\n"
         "the other's edge, with its tangent planes (G1) and curvatures (G2), exactly. It must not\n"
         "have weights.",
         "features:\n"
         "  a: {points: [[0, 0], [1 m, 0.3 m], [2 m, 0.3 m]]}\n"
         "  f: {points: [[2 m, 0.35 m], [3 m, 0.1 m], [4 m, 0]]}\n"
         "  aft: {interpolate: a}\n"
         "  fore: {interpolate: f}\n"
         "  sheer: {match: [aft, fore], continuity: G1, moves: both}\n",
         "[BD89]", "batten_curves_match", BAT_PARAMETERS(parameters), false,
         .also = "align surfaces, continuity, make G1, make G2, join conditions"},
    .run = run_match};
