/*
 * The numbers behind the word "fair", of a curve: corners, jumps and extremes of curvature, and
 * inflections.
 */
#include "fair/fairness.h"
#include "base/plural.h"
#include "fair/bend.h"
#include "inspect/inflections.h"
#include "inspect/singular.h"
#include "numeric/vector.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

/* Curvature is largest at its extrema, at the ends, and on either side of knots. */
static batten_status note_curvatures(bat_judged_curve *j, const batten_parameters *at)
{
    for (int k = 0; k < at->count; k++)
        for (int side = 0; side < 2; side++) {
            bat_curve_bend bend;
            const batten_status status =
                bat_curve_bend_at(j->curve, j->size, at->at[k], (batten_side)side, &bend);
            if (status != BATTEN_OK)
                return status;
            j->found.max_curvature = bat_max(j->found.max_curvature, fabs(bend.curvature));
        }
    return BATTEN_OK;
}

/* ---- counting ---- */

void bat_scan_walk(int count, const double *curvature, double zero, double flat, bat_scan *s)
{
    for (int i = 0; i < count; i++) {
        const double k = curvature[i];
        const int sign = (k > zero) - (k < -zero);
        if (sign * s->sign < 0)
            s->inflections++;
        if (sign != 0)
            s->sign = sign;
        const double change = k - s->from;
        const int direction = (change > flat) - (change < -flat);
        if (direction * s->direction < 0)
            s->extrema++;
        if (direction != 0)
            s->direction = direction;
        if (direction != 0 || change * s->direction > 0)
            s->from = k;
    }
}

/* What differs by less than this part of the largest curvature is no wave. */
#define FLAT 1e-6

/* Of the extrema found, those between which curvature changes by more than `flat`. */
static batten_status count_waves(const bat_judged_curve *j, double flat, int *out)
{
    const batten_interval domain = batten_curve_domain(j->curve);
    const int n = j->extrema.count;
    double *k = bat_array((size_t)n + 2, sizeof *k);
    batten_status status = k ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n + 2; i++) {
        bat_curve_bend at = {0};
        const double u = i == 0 ? domain.a : i <= n ? j->extrema.at[i - 1] : domain.b;
        status = bat_curve_bend_at(j->curve, j->size, u,
                                   i <= n ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, &at);
        if (status == BATTEN_OK)
            k[i] = at.curvature;
    }
    if (status == BATTEN_OK) {
        bat_scan scan = {.from = k[0]};
        bat_scan_walk(n + 2, k, 0, flat, &scan);
        if (batten_curve_is_periodic(j->curve)) { /* once more, knowing where it came from */
            scan.extrema = 0;
            bat_scan_walk(n + 2, k, 0, flat, &scan);
        }
        *out = bat_min_int(n, scan.extrema);
    }
    bat_release(k);
    return status;
}

static batten_status count_turns(bat_judged_curve *j, int required, double uncertainty)
{
    batten_fairness *found = &j->found;
    batten_parameters inflections = {0};
    batten_status status = BATTEN_OK;
    if (batten_curve_dimension(j->curve) < 3)
        status = bat_curve_inflections(j->curve, uncertainty, &inflections);
    found->curvature_extrema = j->extrema.count;
    found->inflections = inflections.count;
    found->excess_inflections = bat_max_int(0, inflections.count - required);
    /* Where curvature jumps, it may come back to the same value without a turn; where it has no
     * bound no change is flat. */
    if (status == BATTEN_OK && found->corners + found->curvature_jumps + found->unbounded == 0)
        status = count_waves(j, FLAT * found->max_curvature, &found->curvature_extrema);
    batten_release(inflections.at);
    return status;
}

/* ---- integrals ---- */

/* Between knots, halts and extrema no curvature is larger than at one of the ends. */
static batten_status add_energies(bat_judged_curve *j)
{
    const batten_interval domain = batten_curve_domain(j->curve);
    batten_parameters knots_and_halts = {0}, breaks = {0};
    bat_energies energies = {0};
    batten_status status = bat_parameters_merge(&j->knots, &j->halts, domain, &knots_and_halts);
    if (status == BATTEN_OK)
        status = bat_parameters_merge(&knots_and_halts, &j->extrema, domain, &breaks);
    if (status == BATTEN_OK)
        status = bat_curve_energies(j->curve, &breaks, &energies);
    j->found.energy = energies.energy;
    j->found.energy_error = energies.energy_error;
    j->found.variation = energies.variation;
    j->found.variation_error = energies.variation_error;
    bat_release(knots_and_halts.at);
    bat_release(breaks.at);
    return status;
}

/* ---- the verdict ---- */

static batten_status find_places(bat_judged_curve *j, double uncertainty)
{
    const int count = batten_curve_spans(j->curve, NULL);
    j->knots = (batten_parameters){count, bat_array((size_t)count, sizeof(double))};
    if (!j->knots.at)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(j->curve, j->knots.at);
    batten_status status = bat_curve_curvature_extrema(j->curve, uncertainty, &j->extrema);
    /* A function never stands still: its parameter goes on. */
    if (status == BATTEN_OK && batten_curve_dimension(j->curve) > 1)
        status = batten_curve_standstills(j->curve, &j->halts);
    return status;
}

/* Radii below a part in 1e9 of the largest coordinate are those of corners that were rounded. */
#define SHARPEST 1e9

/* A bend far below what rounding leaves of points, whose energy the quadrature cannot tell. */
static bool is_too_sharp(const bat_judged_curve *j)
{
    const batten_fairness *f = &j->found;
    return f->corners == 0 && f->unbounded == 0 && f->energy_error > 1e-3 * f->energy &&
           f->max_curvature * j->size > SHARPEST;
}

/* Inflections that are no fault: a number, and those that would go if the points moved by
 * `uncertainty`. Energies are the dear part: those who ask for the verdict alone get them where
 * it rests on them. */
typedef struct {
    int inflections;
    double uncertainty;
    bool verdict_alone;
} allowance;

static bool needs_energies(const bat_judged_curve *j, const allowance *allowed)
{
    return !allowed->verdict_alone || j->found.max_curvature * j->size > SHARPEST;
}

static batten_status judge_curve(const batten_curve *curve,
                                 const batten_fairness_options *options,
                                 const allowance *allowed, batten_fairness *out)
{
    bat_judged_curve j = {.curve = curve, .options = options, .size = bat_curve_size(curve)};
    batten_status status = find_places(&j, allowed->uncertainty);
    if (status == BATTEN_OK)
        status = note_curvatures(&j, &j.knots);
    if (status == BATTEN_OK)
        status = note_curvatures(&j, &j.extrema);
    if (status == BATTEN_OK)
        status = bat_judge_joints(&j);
    /* Across a corner and at some halts they are infinite, which a quadrature would seek in vain. */
    if (status == BATTEN_OK && j.found.corners == 0 && !isinf(j.found.energy) &&
        needs_energies(&j, allowed))
        status = add_energies(&j);
    if (status == BATTEN_OK)
        status = count_turns(&j, allowed->inflections, allowed->uncertainty);
    if (status == BATTEN_OK) {
        if (j.found.unbounded > 0 || j.is_endless)
            j.found.max_curvature = HUGE_VAL;
        j.found.unbounded += is_too_sharp(&j);
        bat_conclude_fairness(&j.found);
        *out = j.found;
    }
    bat_release(j.knots.at);
    bat_release(j.halts.at);
    bat_release(j.extrema.at);
    return status;
}

/* Waves as small as this part of the bound are where the search for the least energy was ended.
 */
#define SETTLED 1e-6

static batten_status judge_batten(const bat_batten *batten, const bat_batten_points *ducks,
                                  bool verdict_alone, batten_fairness *out)
{
    const batten_fairness_options options = batten_fairness_defaults();
    batten_curve *curve = NULL;
    allowance allowed = {.verdict_alone = verdict_alone};
    double largest = 0;
    for (int i = 0; i < batten->count; i++)
        largest = bat_max(largest, ducks->within[i]);
    allowed.uncertainty = SETTLED * largest;
    batten_status status =
        bat_required_inflections(ducks->width, batten->count, batten->t, ducks->points,
                                 ducks->within, &allowed.inflections);
    if (status == BATTEN_OK)
        status = bat_batten_curve(batten, ducks->width, ducks->z, &curve);
    if (status == BATTEN_OK)
        status = judge_curve(curve, &options, &allowed, out);
    batten_curve_unref(curve);
    return status;
}

batten_status bat_batten_fairness(const bat_batten *batten, const bat_batten_points *ducks,
                                  batten_fairness *out)
{
    return judge_batten(batten, ducks, false, out);
}

batten_status bat_batten_is_fair(const bat_batten *batten, const bat_batten_points *ducks,
                                 bool *out)
{
    batten_fairness found;
    const batten_status status = judge_batten(batten, ducks, true, &found);
    if (status == BATTEN_OK)
        *out = found.fair;
    return status;
}

void batten_fairness_add(batten_fairness *sum, const batten_fairness *one)
{
    sum->inflections += one->inflections;
    sum->excess_inflections += one->excess_inflections;
    sum->curvature_extrema += one->curvature_extrema;
    sum->jumps += one->jumps;
    sum->energy += one->energy;
    sum->energy_error += one->energy_error;
    sum->variation += one->variation;
    sum->variation_error += one->variation_error;
    sum->max_curvature = bat_max(sum->max_curvature, one->max_curvature);
    sum->corners += one->corners;
    sum->cusps += one->cusps;
    sum->halts += one->halts;
    sum->unbounded += one->unbounded;
    sum->curvature_jumps += one->curvature_jumps;
    sum->largest_turn = bat_max(sum->largest_turn, one->largest_turn);
    sum->largest_jump = bat_max(sum->largest_jump, one->largest_jump);
    sum->fair = sum->fair && one->fair;
}

/* ---- any curve ---- */

/* The values of a function stand at the distinct knots of its curve. */
static batten_status check_points(const batten_curve *curve, int count, const double *points)
{
    const int d = batten_curve_dimension(curve), spans = batten_curve_spans(curve, NULL);
    const size_t values = (size_t)bat_max_int(count, 0) * (size_t)d;
    if (count < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there %s %d point%s",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
    if (bat_first_not_finite(points, values) < values)
        return bat_fail(BATTEN_NOT_FINITE, "point %zu is not finite",
                        bat_first_not_finite(points, values) / (size_t)d + 1);
    if (d == 1 && count != spans)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "%d value%s, but the function has %d distinct knots", count,
                        bat_plural(count), spans);
    return BATTEN_OK;
}

batten_status batten_curve_fairness(const batten_curve *curve, batten_points points,
                                    const batten_fairness_options *options,
                                    batten_fairness *out)
{
    batten_fairness_options chosen;
    batten_status status = bat_fairness_take_options(options, &chosen);
    if (status != BATTEN_OK)
        return status;
    if (points.dimension != batten_curve_dimension(curve))
        return bat_wrong_dimension(points, batten_curve_dimension(curve));
    const int d = batten_curve_dimension(curve);
    allowance allowed = {.uncertainty = chosen.error};
    if (points.at)
        status = check_points(curve, points.count, points.at);
    if (status == BATTEN_OK && points.at && d < 3) {
        double *knots = bat_array((size_t)batten_curve_spans(curve, NULL), sizeof *knots);
        if (!knots)
            return BATTEN_OUT_OF_MEMORY;
        batten_curve_spans(curve, knots);
        status = bat_required_within(d, points.count, knots, points.at, chosen.within,
                                     &allowed.inflections);
        bat_release(knots);
    }
    return status == BATTEN_OK ? judge_curve(curve, &chosen, &allowed, out) : status;
}
