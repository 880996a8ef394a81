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
    {"match", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "two curves, in order"},
    {"continuity", BATTEN_VALUE_WORD, false, false, "G2", "G0 G1 G2 C1 C2 C3",
     "how they shall join: place, tangent, curvature; or equal derivatives"},
    {"moves", BATTEN_VALUE_WORD, false, false, "second", "second first both",
     "which curve gives way"},
};

static batten_status run(bat_run *run)
{
    bat_objects all;
    batten_status status = bat_gather(run, "match", BAT_CURVES, &all);
    if (status != BATTEN_OK)
        return status;
    if (all.count != 2)
        status =
            bat_fail(BATTEN_NOT_COMPATIBLE, "two curves are needed, there are %d", all.count);
    batten_curve *made[2] = {NULL, NULL};
    double moved = 0;
    const int join = bat_word(run, "continuity");
    if (status == BATTEN_OK)
        status = batten_curves_match(
            all.at[0]->curve, all.at[1]->curve, joins[join].kind, joins[join].order,
            (batten_match_mover)bat_word(run, "moves"), &moved, &made[0], &made[1]);
    if (status == BATTEN_OK)
        bat_report_error(run, moved, moved);
    for (int k = 0; k < 2; k++)
        status = bat_put_curve_like(run, status, made[k],
                                    all.count > k ? all.at[k] : &(batten_object){0}, false);
    bat_objects_release(&all);
    return status;
}

const bat_feature bat_feature_match = {
    .shown =
        {"match", "Two curves made to join smoothly by moving control points",
         "The end of the first and the start of the second; only the one to three control "
         "points next\n"
         "to the join move, weights and knots stay. 'G1' and 'G2' keep each curve's own speed "
         "and make\n"
         "tangents and curvatures equal; 'C1' to 'C3' make derivatives equal with the least "
         "movement.\n"
         "Curves that are far apart, or point away from each other, become kinked near the "
         "join:\n"
         "use 'blend' for these. The report says how far the farthest control point moved.",
         "features:\n"
         "  a: {points: [[0, 0], [1 m, 0.3 m], [2 m, 0.3 m]]}\n"
         "  f: {points: [[2 m, 0.35 m], [3 m, 0.1 m], [4 m, 0]]}\n"
         "  aft: {interpolate: a}\n"
         "  fore: {interpolate: f}\n"
         "  sheer: {match: [aft, fore], continuity: G1, moves: both}\n",
         "[BD89]", "batten_curves_match", BAT_PARAMETERS(parameters), false},
    .run = run};
