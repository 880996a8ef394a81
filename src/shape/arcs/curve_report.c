/* How far arcs are from the curve they replace, on both sides. */
#include "shape/arcs/curve_report.h"
#include "numeric/vector.h"

/* ---- the report ---- */

static void widen(batten_arcs_report *report, const bat_beside *beside)
{
    report->left = bat_max(report->left, beside->high);
    report->right = bat_max(report->right, -beside->low);
    const bool high = beside->high > -beside->low;
    const double largest = high ? beside->high : -beside->low;
    if (largest > report->error) {
        report->error = largest;
        report->at = high ? beside->high_at : beside->low_at;
    }
}

static batten_status measure_range(bat_arc_fit *t, const batten_biarc *biarc,
                                   batten_interval range, batten_arcs_report *report)
{
    bat_arcs_probe probe;
    bat_beside beside;
    batten_status status = bat_arcs_take(t->path, range, 16, 64 * biarc->count, &t->samples);
    if (status == BATTEN_OK)
        status = bat_arcs_measure(t->path, biarc, &t->samples, &beside);
    if (status != BATTEN_OK)
        return status;
    widen(report, &beside);
    bat_arcs_probe_make(biarc, &probe);
    beside = bat_arcs_beside_samples(&probe, &t->samples);
    report->sampled = bat_max(report->sampled, bat_max(beside.high, -beside.low));
    return BATTEN_OK;
}

batten_status bat_arcs_step(bat_arc_fit *t, double u)
{
    const batten_interval all = t->path->domain;
    return bat_work_step(&t->work, 1, (u - all.a) / (all.b - all.a), "arcs");
}

batten_status bat_arcs_report_errors(bat_arc_fit *t, batten_arcs_report *report)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < t->list.count && status == BATTEN_OK; i++) {
        batten_interval ranges[2];
        const int count = bat_arcs_ranges(t->path, &t->list.parts[i], ranges);
        for (int k = 0; k < count && status == BATTEN_OK; k++)
            status = measure_range(t, &t->list.parts[i].biarc, ranges[k], report);
        if (status == BATTEN_OK)
            status = bat_arcs_step(t, t->path->domain.b);
    }
    return status;
}
