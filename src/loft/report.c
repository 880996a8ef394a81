/* What a lofting reports of its panels: the cuts, and how far the points are from the surfaces. */
#include "loft/report.h"
#include "base/sort.h"
#include "loft/faired.h"
#include "loft/planks.h"

void batten_loft_report_release(batten_loft_report *report)
{
    bat_release(report->cuts);
    bat_release(report->corrections);
    bat_release(report->warps);
    batten_offset_table_unref(report->faired);
    *report = (batten_loft_report){0};
}

/* The lower edge of a panel above the first is a knuckle. */
static batten_loft_cut cut_of(const bat_loft_cut *cut, int panel)
{
    static const batten_loft_family families[] = {
        [BAT_CUT_STATION] = BATTEN_LOFT_STATION, [BAT_CUT_WATERLINE] = BATTEN_LOFT_WATERLINE,
        [BAT_CUT_BUTTOCK] = BATTEN_LOFT_BUTTOCK, [BAT_CUT_DIAGONAL] = BATTEN_LOFT_DIAGONAL,
        [BAT_CUT_PROFILE] = BATTEN_LOFT_PROFILE, [BAT_CUT_SHEER] = BATTEN_LOFT_SHEER};
    const bool knuckle = cut->kind == BAT_CUT_PROFILE && panel > 0;
    return (batten_loft_cut){.family = knuckle ? BATTEN_LOFT_KNUCKLE : families[cut->kind],
                             .at =
                                 cut->kind == BAT_CUT_DIAGONAL ? cut->at / cut->m[2] : cut->at,
                             .needed = cut->needed,
                             .found = cut->found,
                             .panel = panel};
}

static batten_status report_cuts(const bat_hull_panels *panels, batten_loft_report *report)
{
    int count = 0;
    for (int p = 0; p < panels->count; p++)
        count += panels->at[p].cut_count;
    report->cuts = bat_array((size_t)count, sizeof *report->cuts);
    if (!report->cuts)
        return BATTEN_OUT_OF_MEMORY;
    for (int p = 0; p < panels->count; p++) {
        const bat_loft *loft = panels->at + p;
        for (int k = 0; k < loft->cut_count; k++)
            report->cuts[report->cut_count++] = cut_of(loft->cuts + k, p);
    }
    return BATTEN_OK;
}

static batten_status report_moves(const bat_hull_panels *panels,
                                  const batten_offset_table *table, batten_loft_report *report)
{
    int count = 0;
    double squares = 0;
    report->max_move = -1; /* below all */
    for (int p = 0; p < panels->count; p++)
        for (int k = 0; k < panels->at[p].datum_count; k++, count++) {
            const bat_loft_datum *d = panels->at[p].data + k;
            squares += d->move * d->move;
            if (!(d->move > report->max_move))
                continue;
            report->max_move = d->move;
            report->worst_station = d->station;
            report->worst_index = d->index;
        }
    report->rms_move = sqrt(squares / count);
    const batten_status status =
        bat_loft_faired_table(panels, table, &report->faired, &report->faired_error);
    return status == BATTEN_OK ? bat_loft_correct(panels, table, report) : status;
}

/* ---- planks ---- */

/* Half of the rulings, and 90 of 100, are no more warped than those in the order of their warp. */
enum { MEDIAN = (BAT_PLANK_RULINGS - 1) / 2, MOST = (BAT_PLANK_RULINGS - 1) * 9 / 10 };

static void sum_up_warp(const bat_hull_rails *rails, int panel, const bat_plank_ruling *rulings,
                        batten_loft_warp *out)
{
    double warps[BAT_PLANK_RULINGS];
    const bat_plank_ruling *worst = rulings;
    for (int i = 0; i < BAT_PLANK_RULINGS; i++) {
        warps[i] = bat_plank_warp(rulings + i);
        if (warps[i] > bat_plank_warp(worst))
            worst = rulings + i;
    }
    bat_sort_doubles(BAT_PLANK_RULINGS, warps);
    *out = (batten_loft_warp){panel, warps[MEDIAN], warps[MOST], warps[BAT_PLANK_RULINGS - 1],
                              .at = {0, 0}};
    const double along[2] = {worst->u, worst->w};
    for (int side = 0; side < 2; side++) {
        const double *x = rails->rails[panel + side].x;
        out->at[side] = (1 - along[side]) * x[0] + along[side] * x[1];
    }
}

static batten_status report_warps(const bat_hull_panels *panels, batten_loft_report *report)
{
    batten_status status = BATTEN_OK;
    report->warps = bat_array((size_t)panels->count, sizeof *report->warps);
    if (!report->warps)
        return BATTEN_OUT_OF_MEMORY;
    for (int p = 0; p < panels->count && panels->has_rails && status == BATTEN_OK; p++) {
        bat_plank_ruling rulings[BAT_PLANK_RULINGS];
        if (!bat_hull_is_plank(&panels->rails, p))
            continue;
        status = bat_plank_find_rulings(&panels->rails, p, rulings);
        if (status == BATTEN_OK)
            sum_up_warp(&panels->rails, p, rulings, report->warps + report->warp_count++);
    }
    return status;
}

batten_status bat_loft_fill_report(const bat_hull_panels *panels,
                                   const batten_offset_table *table, batten_loft_report *out)
{
    batten_loft_report report = {.height = panels->at[0].height,
                                 .trimmed_count = panels->at[0].trimmed,
                                 .panel_count = panels->count};
    for (int p = 0; p < panels->count; p++) {
        report.cuts_in_excess += panels->reached[p].cuts_in_excess;
        report.excess_inflections += panels->reached[p].excess;
        report.rounds += panels->reached[p].rounds;
        report.ruled_count += bat_hull_is_ruled(panels->at + p);
    }
    batten_status status = report_cuts(panels, &report);
    if (status == BATTEN_OK)
        status = report_warps(panels, &report);
    if (status == BATTEN_OK)
        status = report_moves(panels, table, &report);
    if (status == BATTEN_OK)
        *out = report;
    else
        batten_loft_report_release(&report);
    return status;
}
