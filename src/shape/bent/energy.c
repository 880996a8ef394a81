/*
 * The curve of least energy: a search from the best of Batten's other curves through the same
 * points, with more quintics until these do not matter, judged by energies that are measured.
 */
#include "shape/bent/energy.h"
#include "base/plural.h"
#include "numeric/vector.h"
#include "spline/data_check.h"
#include <batten/bent.h>
#include <batten/curve.h>

#include <string.h>

enum { LEAST_PIECES = 2, MOST_PIECES = 16 };

batten_curve_minimum_energy_options batten_curve_minimum_energy_defaults(void)
{
    return (batten_curve_minimum_energy_options){
        .size = sizeof(batten_curve_minimum_energy_options),
        .energy = BATTEN_ENERGY_VARIATION,
        .max_steps = 200};
}

/* ---- what is asked ---- */

static batten_status check_end(const char *name, int d, const double *tangent,
                               const double *curvature)
{
    if (curvature && !tangent)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the curvature at the %s needs a tangent, to which it is square", name);
    const double *const given[2] = {tangent, curvature};
    for (int i = 0; i < 2; i++)
        if (given[i] && bat_first_not_finite(given[i], (size_t)d) < (size_t)d)
            return bat_fail(BATTEN_NOT_FINITE, "the %s at the %s is not finite",
                            i ? "curvature" : "tangent", name);
    if (tangent && bat_norm(d, tangent) == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tangent at the %s has no length", name);
    return BATTEN_OK;
}

static batten_status check_energy_options(int d, int count, const double *points,
                                          const batten_curve_minimum_energy_options *options)
{
    if (d < 2 || d > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve of least energy in %d dimension%s", d,
                        bat_plural(d));
    if ((int)options->energy < 0 || options->energy > BATTEN_ENERGY_VARIATION)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown energy %d", (int)options->energy);
    if (!(options->tension >= 0 && isfinite(options->tension)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tension is %g; it must be 0 or more",
                        options->tension);
    if (options->tension > 0 && options->scale_invariant)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a tension has a unit, which a scale-invariant energy has not");
    if (options->pieces < 0 || options->pieces > MOST_PIECES)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "%d pieces between points; 1 to %d are possible, or 0 for as many as needed",
            options->pieces, MOST_PIECES);
    if (options->max_steps < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d step%s; at least 1 is needed",
                        options->max_steps, bat_plural(options->max_steps));
    batten_status status = bat_points_check(d, count, points, options->closed ? 3 : 2);
    if (status == BATTEN_OK && !options->closed)
        status = check_end("start", d, options->start_tangent, options->start_curvature);
    if (status == BATTEN_OK && !options->closed)
        status = check_end("end", d, options->end_tangent, options->end_curvature);
    return status;
}

/* ---- searching ---- */

/* What an energy in units of the mean chord is over one in those of the model. */
static double unit_of_energy(const bat_energy_spline *t)
{
    return t->options->scale_invariant                   ? 1
           : t->options->energy == BATTEN_ENERGY_BENDING ? t->unit
                                                         : t->unit * t->unit * t->unit;
}

static void scale_report(const bat_energy_spline *t, batten_curve_minimum_energy_report *report)
{
    const double unit = unit_of_energy(t);
    report->before /= unit;
    report->after /= unit;
    report->remaining /= unit;
    report->length *= t->unit;
}

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

/* Search, make the parameter the arc length, and search again, until that lowers the energy no
 * more. */
static batten_status search_from_here(bat_energy_spline *t,
                                      batten_curve_minimum_energy_report *report)
{
    enum { ROUNDS = 10 };
    const batten_curve_minimum_energy_options *o = t->options;
    bat_energy_task what = {o->energy, o->scale_invariant, bat_energy_tension(t), o->max_steps,
                            10 * bat_energy_length(&t->nodes)};
    const int most = what.max_steps;
    bool least = false, changed = true;
    *report = (batten_curve_minimum_energy_report){0};
    for (int round = 0; round < ROUNDS && changed; round++) {
        const batten_curve_minimum_energy_report last = *report;
        bat_energy_end end;
        what.max_steps = most - last.steps;
        batten_status status = bat_energy_minimise(&what, &t->nodes, report, &end);
        if (status != BATTEN_OK)
            return status;
        report->steps += last.steps;
        report->before = round > 0 ? last.before : report->before;
        /* Where no step helps any more, so small a rest is that of derivatives that cancel. */
        least = end == BAT_ENERGY_LEAST ||
                (end == BAT_ENERGY_STUCK && report->remaining <= 1e-9 * report->after);
        if (end == BAT_ENERGY_UNDERWAY ||
            (least && round > 0 && last.after - report->after <= 1e-9 * report->after))
            break;
        status = go_by_length(t, what, report->after, &changed);
        if (status != BATTEN_OK)
            return status;
    }
    return least ? BATTEN_OK
                 : bat_fail(BATTEN_INCOMPLETE,
                            "%d step%s took the energy from %g to %g, and it could fall by %g "
                            "more: give directions at the ends, a tension, or more points",
                            report->steps, bat_plural(report->steps), report->before,
                            report->after, report->remaining);
}

/* ---- what is found ---- */

/* A curve of the model that beats its rivals. */
typedef struct {
    batten_curve *curve;
    double *parameters;                        /* [count + 1] */
    batten_curve_minimum_energy_report report; /* in units of the mean chord */
} found_curve;

static void release_found(found_curve *found)
{
    batten_curve_unref(found->curve);
    bat_release(found->parameters);
}

/* The energy of the curve at the nodes, as it is delivered. */
static batten_status measure_nodes(const bat_energy_spline *t, found_curve *out)
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
    const double unit = unit_of_energy(t);
    return bat_fail(
        BATTEN_INCOMPLETE,
        "the search ended at an energy of %g, but another curve through these points "
        "has %g: allow more pieces, give directions at the ends, or a tension",
        found / unit, rival / unit);
}

/*
 * From one start, with more and more quintics until that saves nothing. A result counts when it
 * is no worse than its rivals, and when the sums that were lowered had seen all of its energy;
 * else the next search begins at the start again. `best` stays as it was when nothing counts.
 */
static batten_status search_start(bat_energy_spline *t, const bat_energy_start *start,
                                  double rival, found_curve *best)
{
    const bool automatic = t->options->pieces == 0;
    const double nothing = BAT_ENERGY_NOTHING * t->count;
    double last = HUGE_VAL;
    batten_curve_minimum_energy_report before = {0};
    batten_status status =
        bat_energy_spline_sample(t, start, automatic ? LEAST_PIECES : t->options->pieces);
    while (status == BATTEN_OK) {
        found_curve now = {0};
        status = search_from_here(t, &now.report);
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
        if (counts && saves) {
            release_found(best);
            *best = now;
        } else {
            release_found(&now);
        }
        if (status != BATTEN_OK || !automatic || (counts && !saves) ||
            2 * t->pieces > MOST_PIECES)
            break;
        before = counts ? now.report : (batten_curve_minimum_energy_report){0};
        status = counts ? bat_energy_spline_halve(t)
                        : bat_energy_spline_sample(t, start, 2 * t->pieces);
    }
    if (best->curve && status == BATTEN_INCOMPLETE)
        return BATTEN_OK; /* fewer quintics were enough */
    return status == BATTEN_OK && !best->curve ? fail_beaten(t, rival, last) : status;
}

/* The least energy of those curves that meet what is given at the ends. */
static double least_of(const bat_energy_starts *starts)
{
    double least = HUGE_VAL;
    for (int i = 0; i < starts->count; i++)
        if (starts->at[i].is_rival)
            least = bat_min(least, starts->at[i].energy);
    return least;
}

/* From the best of the other curves, and where that leads nowhere from the next ones. */
static batten_status find(bat_energy_spline *t, found_curve *best)
{
    enum { MOST_TRIED = 3 };
    bat_energy_starts starts = {0};
    batten_status status = bat_energy_spline_begin(t);
    if (status == BATTEN_OK)
        status = bat_energy_starts_make(t, &starts);
    const double rival = least_of(&starts);
    for (int i = 0; i < bat_min_int(starts.count, MOST_TRIED); i++) {
        if (status != (i > 0 ? BATTEN_INCOMPLETE : BATTEN_OK))
            break;
        status = search_start(t, &starts.at[i], rival, best);
    }
    bat_energy_starts_release(&starts);
    return status;
}

batten_status batten_curve_minimum_energy(batten_points points,
                                          const batten_curve_minimum_energy_options *options,
                                          double *parameters,
                                          batten_curve_minimum_energy_report *report,
                                          batten_curve **out)
{
    assert(points.at && out);
    batten_curve_minimum_energy_options chosen = batten_curve_minimum_energy_defaults();
    batten_status status =
        BAT_TAKE_OPTIONS(batten_curve_minimum_energy_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    bat_energy_spline t = {
        .options = &chosen, .d = points.dimension, .count = points.count, .given = points.at};
    found_curve found = {0};
    status = check_energy_options(points.dimension, points.count, points.at, t.options);
    if (status == BATTEN_OK)
        status = find(&t, &found);
    if (status == BATTEN_OK) {
        for (int i = 0; i < points.count && parameters; i++)
            parameters[i] = found.parameters[i];
        scale_report(&t, &found.report);
        if (report)
            *report = found.report;
        *out = batten_curve_ref(found.curve);
    }
    release_found(&found);
    bat_energy_spline_end(&t);
    return status;
}
