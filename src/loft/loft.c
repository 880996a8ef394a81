/* The lofting of a hull, as others call it. */
#include "base/arena.h"
#include "loft/hull.h"
#include <batten/fair.h>

batten_loft_options batten_loft_defaults(double within)
{
    return (batten_loft_options){.size = sizeof(batten_loft_options), .within = within};
}

void batten_loft_report_release(batten_loft_report *report)
{
    bat_release(report->cuts);
    bat_release(report->moves);
    *report = (batten_loft_report){0};
}

static batten_status take_options(const batten_loft_options *given, batten_loft_options *out)
{
    *out = batten_loft_defaults(0);
    const batten_status status = BAT_TAKE_OPTIONS(batten_loft_options, given, out);
    if (status != BATTEN_OK)
        return status;
    if (!(out->within > 0) || !isfinite(out->within))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the bound of a lofting is %g; it must be above 0",
                        out->within);
    if (!(out->height >= 0) || !isfinite(out->height))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the height of visible bulges is %g; it must be 0 or above",
                        out->height);
    return BATTEN_OK;
}

/* ---- the report ---- */

static batten_status report_cuts(const bat_loft *loft, batten_loft_report *report)
{
    static const batten_loft_family families[] = {
        [BAT_CUT_STATION] = BATTEN_LOFT_STATION, [BAT_CUT_WATERLINE] = BATTEN_LOFT_WATERLINE,
        [BAT_CUT_BUTTOCK] = BATTEN_LOFT_BUTTOCK, [BAT_CUT_DIAGONAL] = BATTEN_LOFT_DIAGONAL,
        [BAT_CUT_PROFILE] = BATTEN_LOFT_PROFILE, [BAT_CUT_SHEER] = BATTEN_LOFT_SHEER};
    report->cuts = bat_array((size_t)loft->cut_count, sizeof *report->cuts);
    if (!report->cuts)
        return BATTEN_OUT_OF_MEMORY;
    report->cut_count = loft->cut_count;
    for (int k = 0; k < loft->cut_count; k++) {
        const bat_loft_cut *cut = loft->cuts + k;
        const double at = cut->kind == BAT_CUT_DIAGONAL ? cut->at / cut->m[2] : cut->at;
        report->cuts[k] = (batten_loft_cut){families[cut->kind], at, cut->needed, cut->found};
    }
    return BATTEN_OK;
}

/* What moved by less than this part of its bound did not move but for rounding. */
static const double least_move = 1e-9;

static batten_status report_moves(const bat_loft *loft, batten_loft_report *report)
{
    double largest = -1;
    report->moves = bat_array((size_t)loft->datum_count, sizeof *report->moves);
    if (!report->moves)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < loft->datum_count; k++) {
        const bat_loft_datum *d = loft->data + k;
        bat_loft_place place;
        if (d->move > largest) {
            largest = d->move;
            report->worst_station = d->station;
            report->worst_index = d->index;
        }
        if (d->move <= least_move * d->within)
            continue;
        batten_fair_move *move = report->moves + report->move_count++;
        *move = (batten_fair_move){.set = d->station, .index = d->index};
        bat_loft_place_at(&loft->patch, d->u, d->v, &place);
        memcpy(move->from, d->point, sizeof move->from);
        memcpy(move->to, place.s[0][0], sizeof move->to);
    }
    return BATTEN_OK;
}

static batten_status fill_report(const bat_loft *loft, const bat_loft_reached *reached,
                                 batten_loft_report *out)
{
    batten_loft_report report = {.cuts_in_excess = reached->cuts_in_excess,
                                 .excess_inflections = reached->excess,
                                 .height = loft->height,
                                 .max_move = reached->moves.largest,
                                 .rms_move = reached->moves.rms,
                                 .trimmed_count = loft->trimmed,
                                 .rounds = reached->rounds};
    batten_status status = report_cuts(loft, &report);
    if (status == BATTEN_OK)
        status = report_moves(loft, &report);
    if (status == BATTEN_OK)
        *out = report;
    else
        batten_loft_report_release(&report);
    return status;
}

/* ---- the surface ---- */

static batten_status loft_hull(const batten_offset_table *table,
                               const batten_loft_options *options, const batten_job *job,
                               bat_loft *loft, bat_loft_reached *reached)
{
    batten_status status = bat_hull_make(table, options->within, loft);
    if (status != BATTEN_OK)
        return status;
    loft->job = job;
    if (options->height > 0)
        loft->height = options->height;
    status = bat_loft_run(loft, reached);
    if (status != BATTEN_OK)
        bat_hull_release(loft);
    return status;
}

/* A bound with which a surface exists, found by doubling; 0 when none is. */
static batten_status find_enough(const batten_offset_table *table,
                                 const batten_loft_options *options, const batten_job *job,
                                 double *enough)
{
    enum { DOUBLINGS = 6 };
    batten_loft_options wider = *options;
    batten_status status = BATTEN_NOT_COMPATIBLE;
    *enough = 0;
    for (int k = 0; k < DOUBLINGS && status == BATTEN_NOT_COMPATIBLE; k++) {
        bat_loft loft;
        wider.within *= 2;
        status = bat_hull_make(table, wider.within, &loft);
        if (status != BATTEN_OK)
            return status;
        loft.job = job;
        status = bat_loft_fits(&loft);
        bat_hull_release(&loft);
        if (status == BATTEN_OK)
            *enough = wider.within;
    }
    if (status != BATTEN_OK && status != BATTEN_NOT_COMPATIBLE)
        return status;
    if (*enough > 0)
        return bat_fail(
            BATTEN_NOT_COMPATIBLE,
            "no smooth surface was found within %g of every point of the table; one "
            "was within %g",
            options->within, *enough);
    return bat_fail(
        BATTEN_NOT_COMPATIBLE,
        "no smooth surface was found within %g of every point of the table, nor within "
        "%g: it may have a knuckle, or a point may be wrong",
        options->within, wider.within);
}

static batten_status make_surface(const bat_loft_patch *patch, batten_surface **out)
{
    const batten_axis u = {BAT_LOFT_DEGREE, patch->nu, patch->u_knots, false};
    const batten_axis v = {BAT_LOFT_DEGREE, patch->nv, patch->v_knots, false};
    return batten_surface_create(3, &u, &v, patch->points, NULL, out);
}

batten_status batten_surface_loft(const batten_offset_table *table,
                                  const batten_loft_options *options, const batten_job *job,
                                  batten_loft_report *report, batten_surface **out)
{
    batten_loft_options chosen;
    batten_loft_report found = {0};
    bat_loft loft;
    bat_loft_reached reached;
    batten_status status = take_options(options, &chosen);
    if (status != BATTEN_OK)
        return status;
    status = loft_hull(table, &chosen, job, &loft, &reached);
    if (status == BATTEN_NOT_COMPATIBLE)
        status = find_enough(table, &chosen, job, report ? &report->enough : &found.enough);
    if (status != BATTEN_OK)
        return status;
    status = fill_report(&loft, &reached, &found);
    if (status == BATTEN_OK)
        status = make_surface(&loft.patch, out);
    if (status == BATTEN_OK && report)
        *report = found;
    else
        batten_loft_report_release(&found);
    bat_hull_release(&loft);
    return status;
}
