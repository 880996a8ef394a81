/* What the features of conics through points share: tangents, curvatures, shares, notes. */
#include "design/shared/conics.h"
#include "base/plural.h"

#include <string.h>

static void note_conics(bat_run *run, const char *name,
                        const batten_curve_conics_report *report)
{
    if (report->inflections > 0)
        bat_note(run, "'%s' bends to both sides in %d of its spans; curvature jumps there",
                 name, report->inflections);
    if (report->arcs > 0)
        bat_note(run,
                 "in %d span%s '%s' is a biarc, as the tangents do not meet near it; the first "
                 "is after point %d",
                 report->arcs, bat_plural(report->arcs), name, report->first_arcs + 1);
    if (report->fallen_back > 0)
        bat_note(run,
                 "in %d span%s '%s' has no pair of conics with these curvatures and keeps the "
                 "tangents alone; the first is after point %d",
                 report->fallen_back, bat_plural(report->fallen_back), name,
                 report->first_fallen_back + 1);
}

batten_status bat_conics_make(bat_run *run, const bat_data *data,
                              const batten_curve_conics_options *options, bat_made *made)
{
    batten_curve_conics_report report;
    double *t = bat_array((size_t)data->count + 1, sizeof *t);
    if (!t)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_curve_conics(
        (batten_points){2, data->count, data->points}, options, t, &report, &made->curve);
    if (status == BATTEN_OK) {
        memcpy(made->parameters, t, (size_t)data->count * sizeof *t);
        note_conics(run, data->name, &report);
    }
    bat_release(t);
    return status;
}
