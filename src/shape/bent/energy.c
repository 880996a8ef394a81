/*
 * The curve of least energy: from which of Batten's other curves through the same points searches
 * start, and what is taken when they fail; energy_search.c does one search and judges it.
 */
#include "shape/bent/energy.h"
#include "base/plural.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "spline/data_check.h"
#include <batten/bent.h>
#include <batten/curve.h>

#include <stdio.h>

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

/* How far a point is along the direction from the first to the second, and off it. */
static double along_line(int d, const double *points, int i, double *off)
{
    double from[3], line[3], square = 0;
    for (int c = 0; c < d; c++) {
        from[c] = points[i * d + c] - points[c];
        line[c] = points[d + c] - points[c];
    }
    const double length = bat_norm(d, line), along = bat_dot(d, from, line) / length;
    for (int c = 0; c < d; c++) {
        const double aside = from[c] - along / length * line[c];
        square += aside * aside;
    }
    *off = sqrt(square);
    return along;
}

/* Points on one line that turn back, as those of all closed curves do, leave a smooth curve no
 * side to turn to. */
static batten_status check_turns_back(int d, int count, const double *points, bool closed)
{
    double last = 0, largest = 0, farthest_off = 0;
    int back = closed ? count - 1 : 0;
    for (int i = 1; i < count; i++) {
        double off;
        const double along = along_line(d, points, i, &off);
        if (along < last && (back == 0 || i - 1 < back))
            back = i - 1;
        last = along;
        largest = bat_max(largest, fabs(along));
        farthest_off = bat_max(farthest_off, off);
    }
    if (back == 0 || farthest_off > BAT_MEANT_SAME * largest)
        return BATTEN_OK;
    return bat_fail(
        BATTEN_NOT_COMPATIBLE,
        "all points lie on one line, and the curve turns back at point %d: a smooth "
        "curve has no side to turn to; move a point aside",
        back + 1);
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
    if (options->pieces < 0 || options->pieces > BAT_ENERGY_MOST_PIECES)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "%d pieces between points; 1 to %d are possible, or 0 for as many as needed",
            options->pieces, BAT_ENERGY_MOST_PIECES);
    if (options->max_steps < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d step%s; at least 1 is needed",
                        options->max_steps, bat_plural(options->max_steps));
    batten_status status = bat_points_check(d, count, points, options->closed ? 3 : 2);
    if (status == BATTEN_OK && !options->closed)
        status = check_end("start", d, options->start_tangent, options->start_curvature);
    if (status == BATTEN_OK && !options->closed)
        status = check_end("end", d, options->end_tangent, options->end_curvature);
    if (status == BATTEN_OK && !options->start_tangent && !options->end_tangent)
        status = check_turns_back(d, count, points, options->closed);
    return status;
}

/* ---- searching ---- */

static void scale_report(const bat_energy_spline *t, batten_curve_minimum_energy_report *report)
{
    const double unit = bat_energy_unit(t);
    report->before /= unit;
    report->after /= unit;
    report->remaining /= unit;
    report->length *= t->unit;
    report->tension /= bat_energy_tension_unit(t);
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

/* Under a tension given there is a least, and where length costs nothing no tension holds. That
 * a search of a few steps did not end says nothing. */
static bool can_hold(const bat_energy_spline *t, const bat_energy_starts *starts)
{
    enum { FEW = 100 };
    return t->options->max_steps >= FEW && t->options->tension == 0 &&
           !t->options->scale_invariant && starts->count > 0 && starts->at[0].energy > 0 &&
           isfinite(starts->at[0].energy);
}

/* A search without tension has failed. Held by one, from the best start or from the last, which
 * is the roundest; what is said is why it failed without. */
static batten_status hold(bat_energy_spline *t, const bat_energy_starts *starts,
                          bat_energy_found *best)
{
    enum { LONGEST = 400 };
    char why[LONGEST];
    snprintf(why, sizeof why, "%s", batten_message());
    batten_status status = bat_energy_hold(t, &starts->at[0], &starts->at[0], best);
    if (status == BATTEN_INCOMPLETE)
        status = bat_energy_hold(t, &starts->at[0], &starts->at[starts->count - 1], best);
    return status == BATTEN_INCOMPLETE ? bat_fail(status, "%s", why) : status;
}

/* From the best of the other curves, and where that leads nowhere from the next ones. */
static batten_status find(bat_energy_spline *t, bat_energy_found *best)
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
        status = bat_energy_search_start(t, &starts.at[i], rival, best);
    }
    if (status == BATTEN_INCOMPLETE && can_hold(t, &starts))
        status = hold(t, &starts, best);
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
    bat_energy_spline t = {.options = &chosen,
                           .d = points.dimension,
                           .count = points.count,
                           .given = points.at,
                           .rest = BAT_ENERGY_REST};
    bat_energy_found found = {0};
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
    bat_energy_found_release(&found);
    bat_energy_spline_end(&t);
    return status;
}
