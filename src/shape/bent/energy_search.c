/*
 * One search of least energy: from one start, with more and more quintics until these save
 * nothing; judged by the energy of what is delivered, it may end incomplete.
 */
#include "base/plural.h"
#include "numeric/vector.h"
#include "shape/bent/energy.h"

#include <string.h>

enum { LEAST_PIECES = 2 };

double bat_energy_unit(const bat_energy_spline *t)
{
    return t->options->scale_invariant                   ? 1
           : t->options->energy == BATTEN_ENERGY_BENDING ? t->unit
                                                         : t->unit * t->unit * t->unit;
}

/* ---- searching ---- */

/* Make the parameter the arc length, unless so few quintics then have much more energy than
 * `energy`; false when it stays as it was. */
static batten_status go_by_length(bat_energy_spline *t, bat_energy_task what, double energy,
                                  bool *changed)
{
    const bat_energy_curve *nodes = &t->nodes;
    const size_t count = (size_t)nodes->count * 3 * (size_t)nodes->d;
    double *x = bat_array(count, sizeof *x);
    double *step = bat_array((size_t)nodes->spans, sizeof *step);
    batten_status status = x && step ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_curve_minimum_energy_report now = {0};
        bat_energy_end end;
        memcpy(x, nodes->x, count * sizeof *x);
        memcpy(step, nodes->step, (size_t)nodes->spans * sizeof *step);
        what.max_steps = 0;
        *changed = bat_energy_by_length(&t->nodes);
        status = bat_energy_minimise(&what, &t->nodes, &now, &end);
        *changed = *changed && now.before <= 1.05 * energy;
    }
    if (status == BATTEN_OK && !*changed) {
        memcpy(nodes->x, x, count * sizeof *x);
        memcpy(nodes->step, step, (size_t)nodes->spans * sizeof *step);
    }
    bat_release(x);
    bat_release(step);
    return status;
}

/* Why there is no least, and what helps. */
static batten_status fail_search(const bat_energy_spline *t, bat_energy_end end,
                                 const batten_curve_minimum_energy_report *report)
{
    const double unit = bat_energy_unit(t);
    const char *advice = t->options->scale_invariant ? "more points help"
                         : t->options->tension > 0   ? "more tension or more points help"
                                                     : "a tension or more points help";
    if (end == BAT_ENERGY_GROWING)
        return bat_fail(BATTEN_INCOMPLETE,
                        "the curve bends less and less by growing: after %d step%s it is %g "
                        "long; %s",
                        report->steps, bat_plural(report->steps), report->length * t->unit,
                        advice);
    return bat_fail(BATTEN_INCOMPLETE,
                    "%d step%s took the energy from %g to %g, and it could fall by %g more; %s",
                    report->steps, bat_plural(report->steps), report->before / unit,
                    report->after / unit, report->remaining / unit, advice);
}

/* Search, make the parameter the arc length, and search again, until that lowers the energy no
 * more. */
static batten_status search_from_here(bat_energy_spline *t, bat_energy_found *found)
{
    enum { ROUNDS = 20, STEPS = 25 };
    const batten_curve_minimum_energy_options *o = t->options;
    batten_curve_minimum_energy_report *report = &found->report;
    bat_energy_task what = {o->energy, o->scale_invariant, bat_energy_tension(t), o->max_steps,
                            10 * bat_energy_length(&t->nodes)};
    const int most = what.max_steps;
    bat_energy_end end = BAT_ENERGY_UNDERWAY;
    bool changed = true;
    for (int round = 0; round < ROUNDS && (changed || end == BAT_ENERGY_UNDERWAY); round++) {
        const batten_curve_minimum_energy_report last = *report;
        what.max_steps = bat_min_int(STEPS, most - last.steps);
        batten_status status = bat_energy_minimise(&what, &t->nodes, report, &end);
        if (status != BATTEN_OK)
            return status;
        report->steps += last.steps;
        report->before = round > 0 ? last.before : report->before;
        const bool is_least =
            end == BAT_ENERGY_LEAST ||
            (end != BAT_ENERGY_GROWING && report->remaining <= t->rest * report->after);
        end = is_least ? BAT_ENERGY_LEAST : end;
        if (report->steps >= most || end == BAT_ENERGY_GROWING ||
            (is_least && round > 0 && last.after - report->after <= 1e-9 * report->after))
            break;
        status = go_by_length(t, what, report->after, &changed);
        if (status != BATTEN_OK)
            return status;
    }
    found->is_growing = end == BAT_ENERGY_GROWING;
    return end == BAT_ENERGY_LEAST ? BATTEN_OK : fail_search(t, end, report);
}

/* ---- what is found ---- */

void bat_energy_found_release(bat_energy_found *found)
{
    batten_curve_unref(found->curve);
    bat_release(found->parameters);
    *found = (bat_energy_found){0};
}

/* The energy of the curve at the nodes, as it is delivered. */
static batten_status measure_nodes(const bat_energy_spline *t, bat_energy_found *out)
{
    out->parameters = bat_array((size_t)t->count + 1, sizeof *out->parameters);
    batten_status status = out->parameters ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_energy_spline_curve(t, out->parameters, &out->curve);
    if (status == BATTEN_OK)
        status = bat_energy_measure(t, NULL, out->curve, t->unit, &out->report.after);
    return status;
}

static batten_status fail_beaten(const bat_energy_spline *t, double rival, double found)
{
    const double unit = bat_energy_unit(t);
    return bat_fail(
        BATTEN_INCOMPLETE,
        "the search ended at an energy of %g, but another curve through these points has %g",
        found / unit, rival / unit);
}

batten_status bat_energy_search_start(bat_energy_spline *t, const bat_energy_start *start,
                                      double rival, bat_energy_found *best)
{
    const bool automatic = t->options->pieces == 0;
    const double nothing = BAT_ENERGY_NOTHING * t->count;
    double last = HUGE_VAL;
    batten_curve_minimum_energy_report before = {0};
    batten_status status =
        bat_energy_spline_sample(t, start, automatic ? LEAST_PIECES : t->options->pieces);
    while (status == BATTEN_OK) {
        bat_energy_found now = {0};
        status = search_from_here(t, &now);
        const double lowered = now.report.after;
        /* The search goes on where the last one ended, unless it starts anew. */
        if (before.steps > 0)
            now.report.before = before.before;
        now.report.steps += before.steps;
        if (status == BATTEN_OK)
            status = measure_nodes(t, &now);
        const double energy = last = now.report.after;
        const bool counts = status == BATTEN_OK &&
                            energy <= (1 + BAT_ENERGY_WORTH) * rival + nothing &&
                            fabs(energy - lowered) <= BAT_ENERGY_WORTH * energy + nothing;
        const bool saves =
            !best->curve || energy < (1 - BAT_ENERGY_WORTH) * best->report.after - nothing;
        best->is_growing = now.is_growing;
        if (counts && saves) {
            bat_energy_found_release(best);
            *best = now;
        } else {
            bat_energy_found_release(&now);
        }
        if (status != BATTEN_OK || !automatic || (counts && !saves) ||
            2 * t->pieces > BAT_ENERGY_MOST_PIECES)
            break;
        before = counts ? now.report : (batten_curve_minimum_energy_report){0};
        status = counts ? bat_energy_spline_halve(t)
                        : bat_energy_spline_sample(t, start, 2 * t->pieces);
    }
    if (best->curve && status == BATTEN_INCOMPLETE)
        return BATTEN_OK; /* fewer quintics were enough */
    return status == BATTEN_OK && !best->curve ? fail_beaten(t, rival, last) : status;
}
