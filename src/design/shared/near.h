/* What features that make curves near points share: their common parameters, and the report. */
#ifndef BAT_DESIGN_NEAR_H
#define BAT_DESIGN_NEAR_H
#include "design/shared/through.h"
#include <batten/approximate.h>

/* The curve, its error and the parameters of the points were made; hands the status on. */
static inline batten_status bat_made_near(const batten_fit_report *report, batten_status status,
                                          bat_made *made)
{
    made->has_error = status == BATTEN_OK;
    made->error_max = report->error;
    made->error_rms = report->rms;
    return status;
}

/* What is common to smoothing: 'rms' or 'lambda' or neither; parameters, 'closed'. */
static inline batten_status bat_smooth_options(const bat_run *run, const bat_data *data,
                                               batten_curve_smooth_options *options)
{
    if (bat_has(run, "rms") && bat_has(run, "lambda"))
        return bat_fail(BATTEN_BAD_ARGUMENT, "give either 'rms' or 'lambda', not both");
    options->by = bat_has(run, "rms")      ? BATTEN_SMOOTH_BY_RMS
                  : bat_has(run, "lambda") ? BATTEN_SMOOTH_BY_LAMBDA
                                           : BATTEN_SMOOTH_BY_VALIDATION;
    if (options->by != BATTEN_SMOOTH_BY_VALIDATION)
        options->amount = bat_number(run, bat_has(run, "rms") ? "rms" : "lambda");
    options->parameters = bat_parametrization_of(run, data);
    options->given = data->abscissae;
    options->closed = bat_yes(run, "closed");
    return bat_check_closed(run, data);
}

/* What cross validation chose; it is blind where points are few or all follow one curve. */
static inline void bat_note_validation(const bat_run *run, const bat_data *data,
                                       const batten_fit_report *report)
{
    bat_remark(run,
               "'%s': cross validation chose lambda %.3g: mean distance %.3g, largest %.3g",
               data->name, report->lambda, report->rms, report->error);
    if (report->freedom > 0.99 * data->count)
        bat_note(run,
                 "'%s': the curve goes through the points as if they had no errors: of %d "
                 "points cross validation learns no better; give 'rms' to smooth them",
                 data->name, data->count);
}

/* The smoothing spline and its like. */
typedef batten_status bat_smoother(batten_points points,
                                   const batten_curve_smooth_options *options,
                                   double *parameters, batten_fit_report *report,
                                   batten_curve **out);

/* What they take from the run besides what is in the options already, and the curve. */
static inline batten_status bat_make_smooth(const bat_run *run, const bat_data *data,
                                            bat_smoother *smoother,
                                            batten_curve_smooth_options *options,
                                            bat_made *made)
{
    batten_fit_report report;
    options->order = bat_count(run, "order");
    batten_status status = bat_smooth_options(run, data, options);
    if (status == BATTEN_OK)
        status = smoother((batten_points){data->dimension, data->count, data->points}, options,
                          made->parameters, &report, &made->curve);
    if (status == BATTEN_OK && options->by == BATTEN_SMOOTH_BY_VALIDATION)
        bat_note_validation(run, data, &report);
    return bat_made_near(&report, status, made);
}

#endif
