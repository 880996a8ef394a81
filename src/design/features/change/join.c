/* The feature 'join': curves or surfaces end to end as one. */
#include "base/plural.h"
#include "design/feature.h"
#include "design/shared/outline.h"
#include <batten/extend.h>

#include <stdio.h>
#include <stdlib.h>

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
    if (!joined) {
        *longer = batten_chain_ref(next);
        return BATTEN_OK;
    }
    return batten_chain_join(joined, next, within, longer);
}

static batten_status turn_chain_when(bool is_turned, const batten_chain *chain,
                                     batten_chain **out)
{
    if (is_turned)
        return batten_chain_reverse(chain, out);
    *out = batten_chain_ref(chain);
    return BATTEN_OK;
}

/* As one chain, when all of them are chains that fit together; else none.
 *
 * @param order  [count] counted from 1, negative for those that are turned; NULL: as they are */
static batten_status link_chains(const bat_objects *all, const int *order, int count,
                                 double within, batten_chain **out)
{
    batten_chain *joined = NULL;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        const int place = order ? order[i] : i + 1;
        const batten_chain *next = all->at[abs(place) - 1]->chain;
        batten_chain *turned = NULL, *longer = NULL;
        status = next ? turn_chain_when(place < 0, next, &turned) : BATTEN_NOT_COMPATIBLE;
        if (status == BATTEN_OK)
            status = lengthen_chain(joined, turned, within, &longer);
        batten_chain_unref(turned);
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
        status = link_chains(all, NULL, all->count, within, &chain);
    const batten_object like = {.name = run->name, .layer = ""};
    return bat_put_chain_like(run, status, joined, chain, &like);
}

/* ---- in any order ---- */

static void remark_gaps(const bat_run *run, int count, double within,
                        const batten_curves_join_report *r, int made)
{
    bat_remark(run, "%d curve%s join%s to %d, %d of them closed", count, bat_plural(count),
               count == 1 ? "s" : "", made, r->closed);
    if (r->gaps)
        bat_remark(
            run,
            "%d gap%s closed, both ends moved to the middle; the largest gap closed is %g, "
            "at (%.6g, %.6g, %.6g)",
            r->gaps, r->gaps == 1 ? " is" : "s are", r->gap, r->at[0], r->at[1], r->at[2]);
    else
        bat_remark(run, "all ends that meet agree; the largest gap closed is 0");
    if (r->branches)
        bat_note(run,
                 "%d end%s more than one other within %g; the smallest gaps are closed first",
                 r->branches, r->branches == 1 ? " has" : "s have", within);
}

static batten_status put_joined(bat_run *run, const bat_objects *all, const batten_curves *made,
                                const int *order, const int *pieces)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < made->count && status == BATTEN_OK; order += pieces[i++]) {
        char name[220];
        batten_chain *chain = NULL;
        snprintf(name, sizeof name, "%.200s %d", run->name, i + 1);
        const batten_object like = {.name = made->count > 1 ? name : run->name, .layer = ""};
        /* Ends of chains stay, so gaps are within the tolerance of the design. */
        status = link_chains(all, order, pieces[i], bat_tolerance(run), &chain);
        status = bat_put_chain_like(run, status, batten_curve_ref(made->at[i]), chain, &like);
    }
    return status;
}

/* Loose lines and arcs, as drawings have them: as many curves as they make. */
static batten_status join_loose_curves(bat_run *run, const bat_objects *all, double within)
{
    const size_t count = (size_t)all->count;
    batten_curves_join_report report;
    batten_curves made = {0, NULL};
    const batten_curve **curves = bat_array(count, sizeof *curves);
    int *order = bat_array(count, sizeof *order), *pieces = bat_array(count, sizeof *pieces);
    batten_status status = curves && order && pieces ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < all->count; i++)
        curves[i] = all->at[i]->curve;
    if (status == BATTEN_OK)
        status = batten_curves_join(&(batten_curve_row){all->count, curves}, within, order,
                                    pieces, &report, &made);
    if (status == BATTEN_OK) {
        remark_gaps(run, all->count, within, &report, made.count);
        status = put_joined(run, all, &made, order, pieces);
    }
    batten_curves_release(&made);
    bat_release(curves);
    bat_release(order);
    bat_release(pieces);
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
         "a DXF drawing: they become as many curves as they make. Gaps up to 'within' are closed,\n"
         "the smallest first, by moving both ends to the middle between them: nothing moves by more\n"
         "than half a gap. How many gaps there were and the largest with its place are remarked, and\n"
         "ends that have a choice are noted. Lines and arcs stay lines and arcs where their gaps\n"
         "are within the tolerance of the design.",
         "features:\n"
         "  aft: {line: [[0, 0], [2 m, 0]]}\n"
         "  fore: {line: [[2 m, 0], [4 m, 1 m]]}\n"
         "  keel: {join: [aft, fore]}\n",
         "[PT97]", "batten_curve_join", BAT_PARAMETERS(parameters), false,
         .also =
             "concatenate, merge curves, composite curve, chain, loose ends, close gaps, stitch"},
    .run = run_join};
