#include "design/surface_fit.h"

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

void bat_report_surface_fit(bat_run *run, const batten_surface_fit_report *report)
{
    const double *at = report->where;
    bat_report_error(run, report->max, report->rms);
    bat_remark(
        run,
        "%d x %d control points: distance at most %.3g, at (%.4g, %.4g, %.4g); rms %.3g; "
        "95 of 100 below %.3g",
        report->points_u, report->points_v, report->max, at[0], at[1], at[2], report->rms,
        report->most);
    if (report->reweightings > 0)
        bat_remark(run, "points farther than %.3g count less, after %d rounds",
                   report->threshold, report->reweightings);
    if (report->empty > 0)
        bat_remark(run,
                   "%d cells between knots hold no point: there the surface only bends little",
                   report->empty);
}
