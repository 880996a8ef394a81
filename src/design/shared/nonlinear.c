/* What the features of nonlinear splines share: conditions at the ends, and notes. */
#include "design/shared/nonlinear.h"

batten_nonlinear_end bat_nonlinear_end_of(const bat_run *run, bool start, double *value)
{
    const char *end = start ? "start" : "end";
    const batten_nonlinear_end kind =
        (batten_nonlinear_end)bat_word(run, bat_has(run, end) ? end : "ends");
    if (kind == BATTEN_NONLINEAR_TANGENT)
        *value = bat_number(run, start ? "start-angle" : "end-angle");
    else
        *value = bat_number(run, start ? "start-curvature" : "end-curvature");
    return kind;
}

static void note_turns_and_bends(bat_run *run, const bat_data *data,
                                 const batten_chain_nonlinear_report *report)
{
    const double degree = BAT_PI / 180;
    if (report->turn > 120 * degree)
        bat_note(run, "'%s' turns by %.0f degrees at point %d: look at the curve there",
                 data->name, report->turn / degree, report->turn_at + 1);
    if (report->inflections_added > 0)
        bat_note(run,
                 "'%s' bends to both sides in %d of its spans where its points bend to one",
                 data->name, report->inflections_added);
}

batten_status bat_nonlinear_make(bat_run *run, const bat_data *data, batten_span_family family,
                                 const double *tensions, bat_made *made)
{
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    batten_chain_nonlinear_report report;
    options.family = family;
    options.closed = bat_yes(run, "closed");
    options.start = bat_nonlinear_end_of(run, true, &options.start_value);
    options.end = bat_nonlinear_end_of(run, false, &options.end_value);
    options.tensions = tensions;
    const batten_status status =
        batten_chain_nonlinear((batten_points){2, data->count, data->points}, &options, NULL,
                               made->parameters, &report, &made->chain);
    if (status == BATTEN_OK)
        note_turns_and_bends(run, data, &report);
    return status;
}
