/* The chain that approximating arcs make: those on one circle joined, and what is reported. */
#include "numeric/vector.h"
#include "shape/arcs/arcs.h"
#include "spline/chain/chain.h"

static void straighten(batten_span *arc, double rounding)
{
    const double k = arc->curvature[0], l = arc->length;
    if (k != 0 && fabs(k) * l * l / 8 <= rounding) {
        double end[2];
        bat_arc_at(arc, arc->length, end);
        bat_arc_span(arc->start, bat_distance(2, arc->start, end),
                     bat_atan2(end[1] - arc->start[1], end[0] - arc->start[0]), 0, arc);
    }
}

static double end_angle(const batten_span *arc)
{
    return arc->angle + arc->curvature[0] * arc->length;
}

/* From one arc to the next. */
static double largest_turn(const batten_chain *chain)
{
    const int n = batten_chain_span_count(chain);
    double largest = 0;
    for (int i = 0; i + !batten_chain_is_closed(chain) < n; i++) {
        const double before = end_angle(batten_chain_span(chain, i));
        const double turn = batten_chain_span(chain, (i + 1) % n)->angle - before;
        largest = bat_max(largest, fabs(remainder(turn, 2 * BAT_PI)));
    }
    return largest;
}

static void report_arcs(const batten_chain *chain, batten_arcs_report *report)
{
    report->arcs = report->lines = 0;
    report->least_radius = HUGE_VAL;
    for (int i = 0; i < batten_chain_span_count(chain); i++) {
        const double k = fabs(batten_chain_span(chain, i)->curvature[0]);
        report->arcs += k > 0;
        report->lines += k == 0;
        report->least_radius = bat_min(report->least_radius, k > 0 ? 1 / k : HUGE_VAL);
    }
    report->largest_turn = largest_turn(chain);
}

static batten_status check_number(const batten_arcs_options *options,
                                  const batten_arcs_report *report)
{
    const int needed = report->arcs + report->lines;
    if (options->most > 0 && needed > options->most)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "%d arcs and lines are needed within %g; %d are allowed", needed,
                        options->tolerance, options->most);
    return BATTEN_OK;
}

static int list_spans(const bat_arcs_list *list, double rounding, batten_span *spans)
{
    int count = 0;
    for (int i = 0; i < list->count; i++)
        for (int k = 0; k < list->parts[i].biarc.count; k++) {
            spans[count] = list->parts[i].biarc.arcs[k];
            straighten(&spans[count++], rounding);
        }
    return count;
}

static batten_status chain_all(const bat_arcs_list *list, const bat_arcs_chain_task *task,
                               batten_chain **out)
{
    const double rounding = 4 * DBL_EPSILON * task->scale;
    batten_span *spans = bat_array3((size_t)list->count, 2, sizeof *spans);
    if (!spans)
        return BATTEN_OUT_OF_MEMORY;
    const int count = list_spans(list, rounding, spans);
    const batten_status status = batten_chain_create(
        &(batten_chain_parts){2, count, spans, NULL, task->closed}, 32 * rounding, out);
    bat_release(spans);
    return status;
}

batten_status bat_arcs_chain(const bat_arcs_list *list, const bat_arcs_chain_task *task,
                             batten_arcs_report *report, batten_chain **out)
{
    batten_chain *chain = NULL, *merged = NULL;
    batten_status status = chain_all(list, task, &chain);
    if (status == BATTEN_OK)
        status = batten_chain_merge_arcs(chain, 0, &merged);
    if (status == BATTEN_OK) {
        report_arcs(merged, report);
        status = check_number(task->options, report);
    }
    batten_chain_unref(chain);
    if (status == BATTEN_OK)
        *out = merged;
    else
        batten_chain_unref(merged);
    return status;
}
