/* The feature 'pull': places of a surface moved with the least change. */
#include "base/plural.h"
#include "design/feature.h"

#include <batten/extend.h>

static const batten_parameter parameters[] = {
    {"pull", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the surfaces"},
    {"at", BATTEN_VALUE_POINT, true, true, NULL, NULL,
     "the places, as parameters [u, v] of the surface"},
    {"by", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "how far each place moves; one vector holds for all"},
    {"to", BATTEN_VALUE_POINT, true, false, NULL, NULL, "instead: where each place moves to"},
    {"keep", BATTEN_VALUE_WORD, false, false, "nothing", "nothing edges tangent-planes",
     "what stays along all four edges"},
};

/* From where a place is to where it is wanted. */
static batten_status find_move(const bat_run *run, const batten_surface *surface, int k,
                               batten_surface_pull *pull)
{
    const bat_argument *by = bat_argument_of(run, "by"), *to = bat_argument_of(run, "to");
    const double *place = bat_argument_of(run, "at")->items[k].number;
    const bat_argument *wanted = by->count > 0 ? by : to;
    const double *move = wanted->items[wanted->count > 1 ? k : 0].number;
    double here[3] = {0, 0, 0};
    batten_status status = BATTEN_OK;
    if (by->count == 0)
        status = batten_surface_evaluate(surface, place[0], place[1], 0, here);
    *pull = (batten_surface_pull){
        place[0], place[1], {move[0] - here[0], move[1] - here[1], move[2] - here[2]}};
    return status;
}

static batten_status pull_surface(const bat_run *run, const batten_surface *given,
                                  batten_surface **out)
{
    const int count = bat_argument_of(run, "at")->count;
    batten_surface_pull *pulls = bat_array((size_t)count, sizeof *pulls);
    double moved = 0;
    batten_status status = pulls ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < count && status == BATTEN_OK; k++)
        status = find_move(run, given, k, &pulls[k]);
    if (status == BATTEN_OK)
        status = batten_surface_pulled(given, count, pulls, bat_word(run, "keep"), &moved, out);
    if (status == BATTEN_OK)
        bat_remark(run, "control points move by up to %.4g", moved);
    bat_release(pulls);
    return status;
}

static batten_status run_pull(bat_run *run)
{
    const int places = bat_argument_of(run, "at")->count;
    const int by = bat_argument_of(run, "by")->count, to = bat_argument_of(run, "to")->count;
    if ((by > 0) == (to > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a pull needs either 'by' or 'to'");
    if ((by > 1 && by != places) || (to > 0 && to != places))
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' has %d value%s for %d place%s",
                        by > 0 ? "by" : "to", by + to, bat_plural(by + to), places,
                        bat_plural(places));
    return bat_change_all(run, &(bat_change){.surface = pull_surface});
}

const bat_feature bat_feature_pull = {
    .shown =
        {"pull", "Places of a surface moved, with the least change of its control points",
         "The surface passes exactly through the targets; of all moves of control points that do\n"
         "this, the one with the least sum of squares is taken. Knots and weights stay: 'refine'\n"
         "first where the change is to be local. 'keep: edges' holds the four edges, 'keep:\n"
         "tangent-planes' the tangent planes along them too; beside seams and poles both stay always.",
         "features:\n"
         "  net:\n"
         "    points: [[0, 0, 0], [1, 0, 0.3], [2, 0, 0.3], [3, 0, 0],\n"
         "             [0, 1, 0.3], [1, 1, 0.5], [2, 1, 0.5], [3, 1, 0.3],\n"
         "             [0, 2, 0.3], [1, 2, 0.5], [2, 2, 0.5], [3, 2, 0.3],\n"
         "             [0, 3, 0], [1, 3, 0.3], [2, 3, 0.3], [3, 3, 0]]\n"
         "    columns: 4\n"
         "  hood: {interpolate-grid: net}\n"
         "  bulge: {pull: hood, at: [[0.5, 0.5]], by: [[0, 0, 0.4 m]], keep: edges}\n",
         "[PT97 section 11.2]", "batten_surface_pulled", BAT_PARAMETERS(parameters), false,
         .also = "direct manipulation, move a surface point, drag, sculpt, point constraint",
         .formula = "    ΔP_ij = Σ_k λ_k R_ij(u_k, v_k),  Σ_ij R_ij(u_k, v_k) ΔP_ij = Δ_k",
         .promise =
             "The places move exactly; the sum of the squared moves of control points is the least."},
    .run = run_pull,
    .displacing = "pull"};
