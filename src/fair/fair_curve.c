/* A B-spline curve made fair by its control points, such that no point of it moves farther than a bound. */
#include "fair/fair_curve.h"
#include "fair/fair_points.h"
#include "fair/fairness.h"

#include <string.h>

/* Points of the given curve on each span, from which the inflections are counted that no curve within the bound is without. */
enum { PLACES_OF_SPAN = 8 };

/* Into so many parts a span is cut where a difference is bounded: what the bound then exceeds it by is a few hundredths. */
enum { PARTS_OF_SPAN = 4, WIDENINGS = 8 };

/* A curve that uses so much of its bound is not sought a wider one. */
static const double enough = 0.9;

batten_curve_fair_options batten_curve_fair_defaults(double within)
{
    return (batten_curve_fair_options){.size = sizeof(batten_curve_fair_options),
                                       .within = within,
                                       .method = BATTEN_CURVE_FAIR_KNOTS,
                                       .hold = 1};
}

static batten_status check_curve(const batten_curve *curve,
                                 const batten_curve_fair_options *options)
{
    if (!(options->within > 0 && isfinite(options->within)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the bound is %g, not above 0", options->within);
    if ((int)options->method < 0 || options->method > BATTEN_CURVE_FAIR_COEFFICIENTS)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no method %d of fairing curves",
                        (int)options->method);
    if (options->hold < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d control points are to be held, fewer than none", options->hold);
    if (options->max_moves < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the most moves are %d, below 0",
                        options->max_moves);
    if (curve->degree < 2)
        return bat_fail(BATTEN_UNSUPPORTED, "a polyline has corners, which no fairing rounds");
    if (curve->weights)
        return bat_fail(
            BATTEN_UNSUPPORTED,
            "the curve is rational, and control points of B-splines are moved: approximate it first");
    return BATTEN_OK;
}

/* ---- what is required ---- */

static batten_status required_of(const batten_curve *curve, double within, int *required)
{
    const int spans = curve->count - curve->degree, d = curve->dimension;
    const size_t most = (size_t)spans * PLACES_OF_SPAN + 1;
    double *t = bat_array(most, sizeof *t),
           *points = bat_array3(most, (size_t)d, sizeof *points);
    batten_status status = t && points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int count = 0;
    for (int span = curve->degree; status == BATTEN_OK && span < curve->count; span++) {
        const double a = curve->knots[span], b = curve->knots[span + 1];
        for (int k = 0; a < b && k < PLACES_OF_SPAN; k++)
            t[count++] = a + (b - a) * k / PLACES_OF_SPAN;
    }
    if (status == BATTEN_OK)
        t[count++] = curve->knots[curve->count];
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = batten_curve_evaluate(curve, t[i], 0, points + (size_t)i * (size_t)d);
    if (status == BATTEN_OK)
        status = bat_required_within(d, count, t, points, within, required);
    bat_release(t);
    bat_release(points);
    return status;
}

static batten_status judge(const batten_curve *curve, int required, batten_fairness *out)
{
    const batten_status status =
        batten_curve_fairness(curve, (batten_points){curve->dimension, 0, NULL}, NULL, out);
    if (status != BATTEN_OK)
        return status;
    const int excess = bat_max_int(0, out->inflections - required);
    out->fair |= out->excess_inflections > 0 && excess == 0 && out->corners == 0 &&
                 out->curvature_jumps == 0 && out->unbounded == 0;
    out->excess_inflections = excess;
    return BATTEN_OK;
}

static batten_status report_on(const bat_fair_net *net, const batten_curve *made,
                               const double *z, batten_fair_report *report)
{
    const int d = net->dimension;
    bat_fair_tally tally = {.report.control_points = true};
    int required = 0;
    batten_status status = required_of(net->curve, net->options->within, &required);
    if (status == BATTEN_OK)
        status = judge(net->curve, required, &tally.report.before);
    if (status == BATTEN_OK)
        status = judge(made, required, &tally.report.after);
    for (int i = 0; status == BATTEN_OK && i < net->count; i++)
        status = bat_tally_point(&tally, d, 0, i, net->curve->points + i * d, z + i * d);
    if (status == BATTEN_OK)
        bat_tally_finish(&tally, report);
    bat_tally_end(&tally);
    return status;
}

/* ---- how far the curve goes ---- */

/* A bound on the difference of two curves with the same knots: the control points of the difference, refined. */
static batten_status bound_difference(const batten_curve *from, const batten_curve *to,
                                      double *bound)
{
    const int p = from->degree, d = from->dimension, spans = from->count - p;
    const double zero[3] = {0};
    double *places = bat_array3((size_t)spans, (size_t)(PARTS_OF_SPAN * p), sizeof *places);
    batten_curve *difference = NULL, *fine = NULL;
    batten_status status = places ? bat_curve_copy(to, &difference) : BATTEN_OUT_OF_MEMORY;
    int count = 0;
    for (int span = p; status == BATTEN_OK && span < from->count; span++) {
        const double a = from->knots[span], b = from->knots[span + 1];
        for (int k = 1; a < b && k < PARTS_OF_SPAN; k++)
            for (int times = 0; times < p; times++)
                places[count++] = a + (b - a) * k / PARTS_OF_SPAN;
    }
    if (status == BATTEN_OK) {
        for (int i = 0; i < from->count * d; i++)
            difference->points[i] -= from->points[i];
        status = batten_curve_refine(difference, count, places, &fine);
    }
    *bound = 0;
    for (int i = 0; status == BATTEN_OK && i < fine->count; i++)
        *bound = bat_max(*bound, bat_distance(d, fine->points + i * d, zero));
    bat_release(places);
    batten_curve_unref(difference);
    batten_curve_unref(fine);
    return status;
}

/* ---- the curve ---- */

/* Control points may go anywhere in their balls but for those that are held. */
static void free_points(bat_fair_net *net, double bound, double *within, int *freedom,
                        double *frames)
{
    const int d = net->dimension, hold = net->curve->periodic ? 0 : net->options->hold;
    memset(frames, 0, (size_t)(net->count * d * d) * sizeof *frames);
    for (int i = 0; i < net->count; i++) {
        const bool free = i >= hold && i < net->count - hold;
        within[i] = free ? bound : 0;
        freedom[i] = free ? d : 0;
        for (int k = 0; k < d; k++)
            frames[(i * d + k) * d + k] = 1;
    }
    net->ducks = (bat_ducks){.width = d,
                             .centre = net->curve->points,
                             .within = within,
                             .freedom = freedom,
                             .frames = frames};
}

static batten_status make_curve(const bat_fair_net *net, const double *z, batten_curve **out)
{
    const size_t d = (size_t)net->dimension;
    batten_curve *made;
    const batten_status status = bat_curve_copy(net->curve, &made);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < made->count; i++)
        memcpy(made->points + (size_t)i * d, z + (size_t)bat_fair_net_index(net, i) * d,
               d * sizeof *z);
    return bat_curve_finish(made, out);
}

/* With control points in balls of this radius; how far the curve then is from the given one. */
static batten_status fair_within(bat_fair_net *net, double bound, double *z, batten_curve **out,
                                 double *reached)
{
    const size_t n = (size_t)net->count, d = (size_t)net->dimension;
    double *within = bat_array(n, sizeof *within),
           *frames = bat_array3(n, d * d, sizeof *frames);
    int *freedom = bat_array(n, sizeof *freedom);
    batten_curve *made = NULL;
    batten_status status = within && frames && freedom ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        free_points(net, bound, within, freedom, frames);
        memcpy(z, net->curve->points, n * d * sizeof *z);
        status = net->options->method == BATTEN_CURVE_FAIR_KNOTS
                     ? bat_fair_by_knots(net, z)
                     : bat_fair_by_coefficients(net, z);
    }
    if (status == BATTEN_OK)
        status = make_curve(net, z, &made);
    if (status == BATTEN_OK)
        status = bound_difference(net->curve, made, reached);
    bat_release(within);
    bat_release(frames);
    bat_release(freedom);
    if (status != BATTEN_OK) {
        batten_curve_unref(made);
        return status;
    }
    /* A point of a curve never goes farther than the control points. */
    *reached = bat_min(*reached, bound);
    *out = made;
    return BATTEN_OK;
}

/*
 * Control points that go both ways move the curve much less than they move themselves: their balls grow as long as the curve
 * stays within the bound. `z` [count][dimension] in the end holds the control points of `out`.
 */
static batten_status widen(bat_fair_net *net, double *z, batten_curve **out, double *distance)
{
    const double within = net->options->within;
    double good = within, bad = HUGE_VAL, reached = 0;
    batten_status status = fair_within(net, good, z, out, &reached);
    for (int k = 0; status == BATTEN_OK && k < WIDENINGS; k++) {
        const double bound = bad < HUGE_VAL ? sqrt(good * bad) : 2 * good;
        batten_curve *made = NULL;
        double next;
        if (reached == 0 || reached >= enough * within)
            break;
        status = fair_within(net, bound, z, &made, &next);
        if (status != BATTEN_OK)
            break;
        const bool holds = next <= within, unlimited = next == reached;
        batten_curve *worse = holds ? *out : made;
        *out = holds ? made : *out;
        reached = holds ? next : reached;
        *(holds ? &good : &bad) = bound;
        batten_curve_unref(worse);
        if (unlimited)
            break;
    }
    if (status == BATTEN_OK)
        memcpy(z, (*out)->points, (size_t)net->count * (size_t)net->dimension * sizeof *z);
    *distance = reached;
    return status;
}

batten_status batten_curve_fair(const batten_curve *curve,
                                const batten_curve_fair_options *options, const batten_job *job,
                                batten_fair_report *report, batten_curve **out)
{
    assert(curve && options && out);
    batten_curve_fair_options chosen = batten_curve_fair_defaults(0);
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_fair_options, options, &chosen);
    if (status == BATTEN_OK)
        status = check_curve(curve, &chosen);
    if (status != BATTEN_OK)
        return status;
    bat_fair_net net = {.curve = curve,
                        .dimension = curve->dimension,
                        .degree = curve->degree,
                        .count = curve->count - (curve->periodic ? curve->degree : 0),
                        .options = &chosen,
                        .job = job};
    const size_t numbers = (size_t)net.count * (size_t)net.dimension;
    double *z = bat_array(numbers, sizeof *z), distance = 0;
    batten_curve *made = NULL;
    status = z ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = widen(&net, z, &made, &distance);
    if (status == BATTEN_OK && report)
        status = report_on(&net, made, z, report);
    if (status == BATTEN_OK && report)
        report->max_move = distance;
    bat_release(z);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_curve_unref(made);
    return status;
}
