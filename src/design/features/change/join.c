/* The feature 'join': curves or surfaces end to end as one. */
#include "design/feature.h"
#include "design/features/change/loose_ends.h"
#include "design/shared/outline.h"

static const batten_parameter parameters[] = {
    {"join", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "the curves or surfaces"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "the gap allowed; the tolerance of the design by default"},
    {"direction", BATTEN_VALUE_WORD, false, false, "u", "u v", "of surfaces"},
    {"order", BATTEN_VALUE_WORD, false, false, "given", "given any",
     "of curves: as they come, or as their ends meet, turned where that helps"},
};

static batten_status lengthen_chain(const batten_chain *joined, const batten_chain *next,
                                    double within, batten_chain **longer)
{
    if (!next)
        return BATTEN_NOT_COMPATIBLE;
    if (!joined) {
        *longer = batten_chain_ref(next);
        return BATTEN_OK;
    }
    return batten_chain_join(joined, next, within, longer);
}

/* As one chain, when all curves are chains that fit together; else none. */
static batten_status join_chains(const bat_objects *all, double within, batten_chain **out)
{
    batten_chain *joined = NULL;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < all->count && status == BATTEN_OK; i++) {
        batten_chain *longer = NULL;
        status = lengthen_chain(joined, all->at[i]->chain, within, &longer);
        batten_chain_unref(joined);
        joined = longer;
    }
    *out = joined;
    return status == BATTEN_NOT_COMPATIBLE ? BATTEN_OK : status;
}

static batten_status join_curves(bat_run *run, const bat_objects *all, double within)
{
    batten_curve *joined = NULL;
    batten_chain *chain = NULL;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < all->count && status == BATTEN_OK; i++)
        status = bat_outline_add(status, within, batten_curve_ref(all->at[i]->curve), &joined);
    if (status == BATTEN_OK)
        status = join_chains(all, within, &chain);
    const batten_object like = {.name = run->name, .layer = ""};
    return bat_put_chain_like(run, status, joined, chain, &like);
}

/* Loose lines and arcs, as drawings have them: as many curves as they make. */
static batten_status join_loose_curves(bat_run *run, const bat_objects *all, double within)
{
    bat_loose_report report;
    batten_curves curves = {0, NULL};
    const batten_object like = {.name = run->name, .layer = ""};
    batten_status status = bat_join_loose(all, within, &curves, &report);
    if (status != BATTEN_OK)
        return status;
    bat_remark(run, "%d curve%s join%s to %d, %d of them closed; the largest gap closed is %g",
               all->count, all->count == 1 ? "" : "s", all->count == 1 ? "s" : "",
               report.chains, report.closed, report.gap);
    if (report.branches)
        bat_note(run, "ends where several curves go on: %d; the nearest is taken",
                 report.branches);
    status = curves.count == 1 ? bat_put_curve(run, BATTEN_OK, batten_curve_ref(curves.at[0]))
                               : bat_put_curves_like(run, &like, &curves);
    batten_curves_release(&curves);
    return status;
}

static batten_status join_surfaces(bat_run *run, const bat_objects *all, double within)
{
    const batten_direction direction = (batten_direction)bat_word(run, "direction");
    batten_surface *joined = batten_surface_ref(all->at[0]->surface);
    batten_status status = BATTEN_OK;
    for (int i = 1; i < all->count && status == BATTEN_OK; i++) {
        batten_surface *longer = NULL;
        status = batten_surface_join(joined, all->at[i]->surface, direction, within, &longer);
        if (status == BATTEN_OK) {
            batten_surface_unref(joined);
            joined = longer;
        }
    }
    return bat_put_surface(run, status, joined);
}

static batten_status run_join(bat_run *run)
{
    bat_objects all;
    const double within =
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    batten_status status = bat_gather(run, "join", BAT_CURVES | BAT_SURFACES, &all);
    if (status != BATTEN_OK)
        return status;
    for (int i = 1; i < all.count && status == BATTEN_OK; i++)
        if (all.at[i]->kind != all.at[0]->kind)
            status = bat_fail(BATTEN_NOT_COMPATIBLE,
                              "curves and surfaces cannot be joined: '%s', '%s'",
                              all.at[0]->name, all.at[i]->name);
    if (status == BATTEN_OK && all.at[0]->kind == BATTEN_OBJECT_SURFACE)
        status = join_surfaces(run, &all, within);
    else if (status == BATTEN_OK)
        status = bat_word(run, "order") ? join_loose_curves(run, &all, within)
                                        : join_curves(run, &all, within);
    bat_objects_release(&all);
    return status;
}

const bat_feature bat_feature_join = {
    .shown =
        {"join", "Curves or surfaces end to end as one",
         "Each must start where the one before it ends, within the gap allowed. With 'order: any'\n"
         "curves are sorted and turned so that their ends meet, such as the loose lines and arcs of\n"
         "a DXF drawing: they become as many curves as they make, and the largest gap is reported.",
         "features:\n"
         "  aft: {line: [[0, 0], [2 m, 0]]}\n"
         "  fore: {line: [[2 m, 0], [4 m, 1 m]]}\n"
         "  keel: {join: [aft, fore]}\n",
         "[PT97]", "batten_curve_join", BAT_PARAMETERS(parameters), false,
         .also = "concatenate, merge curves, composite curve, chain"},
    .run = run_join};
