/* What the features of surfaces near points share: smoothing, bounds, and what is reported. */
#include "design/shared/surface_fit.h"
#include "base/plural.h"

batten_status bat_smoothness_of(const bat_run *run, batten_smooth_by *by, double *amount)
{
    const bool rms = bat_has(run, "rms"), lambda = bat_has(run, "lambda");
    if (rms && lambda)
        return bat_fail(BATTEN_BAD_ARGUMENT, "give either 'rms' or 'lambda', not both");
    *by = rms      ? BATTEN_SMOOTH_BY_RMS
          : lambda ? BATTEN_SMOOTH_BY_LAMBDA
                   : BATTEN_SMOOTH_BY_VALIDATION;
    if (rms || lambda)
        *amount = bat_number(run, rms ? "rms" : "lambda");
    return BATTEN_OK;
}

static const char *why_ended(batten_levels_end end)
{
    switch (end) {
    case BATTEN_LEVELS_MET:
        return "every point is near enough";
    case BATTEN_LEVELS_LARGE:
        return "the next would have too many control points";
    case BATTEN_LEVELS_FEW:
        return "the next would have more than eight control points for each point";
    case BATTEN_LEVELS_NO_GAIN:
        return "the last brought the points hardly nearer";
    case BATTEN_LEVELS_MOST:
    case BATTEN_LEVELS_NONE:
        break;
    }
    return "not more were allowed";
}

void bat_report_surface_fit(bat_run *run, const batten_surface_fit_report *report)
{
    const double *at = report->where;
    bat_report_error(run, report->error, report->rms);
    bat_remark(
        run,
        "%d x %d control points: distance at most %.3g, at (%.4g, %.4g, %.4g); rms %.3g; "
        "95 of 100 below %.3g",
        report->points_u, report->points_v, report->error, at[0], at[1], at[2], report->rms,
        report->most);
    if (report->reweightings > 0)
        bat_remark(run, "points farther than %.3g count less, after %d round%s",
                   report->threshold, report->reweightings, bat_plural(report->reweightings));
    if (report->end != BATTEN_LEVELS_NONE)
        bat_remark(run, "%d level%s: %s", report->rounds, bat_plural(report->rounds),
                   why_ended(report->end));
    if (report->layered > 0.2)
        bat_note(run,
                 "%.0f of 100 points lie beside points that are %.3g away in space: the cloud "
                 "does not lie over its base once, as a closed body does not, and no surface "
                 "follows it; divide it, or give another 'base'",
                 100 * report->layered, report->layers_apart);
    if (report->outside_share > 0.1)
        bat_note(run,
                 "the surface leaves the box of the points by %.3g, %.2g of its size, at "
                 "(%.4g, %.4g, %.4g): no points hold it there",
                 report->outside, report->outside_share, report->outside_at[0],
                 report->outside_at[1], report->outside_at[2]);
    if (report->empty > 0)
        bat_remark(run, "%d %s no point: there the surface only bends little", report->empty,
                   bat_one_or_many(report->empty, "cell between knots holds",
                                   "cells between knots hold"));
}
