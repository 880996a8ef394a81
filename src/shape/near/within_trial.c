/* One trial of an approximation within a tolerance: its fit, the best so far, and the next knots. */
#include "shape/near/within_trial.h"
#include "numeric/vector.h"
#include "shape/near/within.h"
#include "spline/curve/curve.h"

#include <string.h>

void bat_trial_end(bat_trial *t)
{
    bat_release(t->inner);
    bat_release(t->parameters);
    bat_release(t->distances);
    batten_curve_unref(t->curve);
    *t = (bat_trial){0};
}

batten_status bat_trial_begin(int count, bat_trial *out)
{
    *out = (bat_trial){.count = count, .max = HUGE_VAL};
    out->inner = bat_array((size_t)count + 1, sizeof *out->inner);
    return out->inner ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* ---- one fit ---- */

/* All knots of a fit, as batten_curve_least_squares wants them; release them. */
static double *knots_of(const bat_within *w, const bat_trial *t)
{
    const double a = w->domain.a, b = w->domain.b;
    const int ends = w->periodic ? 1 : w->degree + 1;
    double *knots = bat_array((size_t)(t->count + 2 * ends), sizeof *knots);
    for (int i = 0; knots && i < ends; i++) {
        knots[i] = a;
        knots[ends + t->count + i] = b;
    }
    if (knots)
        memcpy(knots + ends, t->inner, (size_t)t->count * sizeof *knots);
    return knots;
}

static batten_status fit_curve(bat_within *w, const double *knots, bat_trial *t)
{
    batten_curve_least_squares_options options = batten_curve_least_squares_defaults();
    options.degree = w->degree;
    options.point_count = t->count + (w->periodic ? 1 : w->degree + 1);
    options.parameters = BATTEN_GIVEN;
    options.given = w->parameters;
    options.weights = w->weights;
    options.knots = BATTEN_KNOTS_GIVEN;
    options.given_knots = knots;
    options.closed = w->periodic;
    options.hold_start = options.hold_end = !w->periodic;
    options.corrections = w->corrections;
    options.regularise = true;
    w->fits++;
    const batten_status status =
        batten_curve_least_squares((batten_points){w->dimension, w->count, w->points}, &options,
                                   t->parameters, NULL, &t->curve);
    /* Knots that cannot be, or leave the numbers, are no better than a curve too far off. */
    const bool useless = status == BATTEN_SINGULAR_SYSTEM || status == BATTEN_BAD_KNOTS ||
                         status == BATTEN_NOT_FINITE || status == BATTEN_OVERFLOW;
    return useless ? BATTEN_OK : status;
}

/* After n fits n / (n + FITS_OF_HALF) of the way: how many there will be depends on the data. */
enum { FITS_OF_HALF = 16 };

static batten_status ask_job(const bat_within *w)
{
    const double share = (double)w->fits / (w->fits + FITS_OF_HALF);
    return w->work ? bat_work_step(w->work, (uint64_t)w->count,
                                   w->done[0] + share * (w->done[1] - w->done[0]),
                                   "fitting within the tolerance")
                   : BATTEN_OK;
}

batten_status bat_trial_fit(bat_within *w, bat_trial *t)
{
    batten_status status = ask_job(w);
    if (status == BATTEN_OK && w->sample)
        status = w->sample(w, t->count, t->inner);
    if (status != BATTEN_OK)
        return status;
    const size_t n = (size_t)w->count;
    double *knots = knots_of(w, t);
    t->data_count = w->count;
    t->parameters = bat_array(n + 1, sizeof *t->parameters);
    t->distances = bat_array(n, sizeof *t->distances);
    status = knots && t->parameters && t->distances ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = fit_curve(w, knots, t);
    bat_release(knots);
    if (status == BATTEN_OK) /* of a ring the first again */
        t->parameters[n] = t->parameters[0] + (w->domain.b - w->domain.a);
    if (status == BATTEN_OK && t->curve)
        status = w->measure(w, t->curve, t->parameters, t->distances, &t->max);
    return status;
}

/* ---- the best so far ---- */

bool bat_trial_is_near(const bat_within *w, const bat_trial *t)
{
    return t->curve && t->max <= w->tolerance;
}

int bat_trial_size(const batten_curve *curve)
{
    return batten_curve_point_count(curve);
}

/* Within the tolerance the smaller is the better, else the nearer. */
static bool is_better(const bat_within *w, const bat_trial *t)
{
    if (!w->curve)
        return true;
    if (t->max <= w->tolerance && w->error <= w->tolerance)
        return bat_trial_size(t->curve) < bat_trial_size(w->curve);
    return t->max < w->error;
}

void bat_trial_copy_parameters(const bat_within *w, const double *from, double *to)
{
    if (!w->sample)
        memcpy(to, from, (size_t)(w->count + w->periodic) * sizeof *to);
}

void bat_trial_keep(bat_within *w, const bat_trial *t)
{
    if (!t->curve)
        return;
    bat_trial_copy_parameters(w, t->parameters, w->parameters);
    if (!is_better(w, t))
        return;
    batten_curve_unref(w->curve);
    w->curve = batten_curve_ref(t->curve);
    w->error = t->max;
    bat_trial_copy_parameters(w, t->parameters, w->best);
}

/* ---- knots that come ---- */

/* Fewer on each side of a new knot would let the curve swing between the data. */
enum { LEAST_DATA = 2 };

/* Between two data of from .. to - 1 with parameters of their own, next to the middle weighted
 * by squared distances; false when there are none. */
static bool middle_of(const bat_trial *t, int from, int to, double *knot)
{
    double sum = 0, moment = 0, nearest = HUGE_VAL;
    for (int i = from; i < to; i++) {
        const double square = t->distances[i] * t->distances[i];
        sum += square;
        moment += square * (t->parameters[i] - t->parameters[from]);
    }
    const double wanted = sum > 0 && isfinite(sum) ? t->parameters[from] + moment / sum
                                                   : t->parameters[(from + to) / 2];
    for (int i = from + LEAST_DATA - 1; i < to - LEAST_DATA; i++) {
        const double u = t->parameters[i] / 2 + t->parameters[i + 1] / 2;
        const bool apart = t->parameters[i] < u && u < t->parameters[i + 1];
        if (apart && fabs(u - wanted) < nearest) {
            nearest = fabs(u - wanted);
            *knot = u;
        }
    }
    return isfinite(nearest);
}

/* The break nearest to a new knot between two others, when it does not lie too near to these.
 */
static double snap(const bat_within *w, double from, double to, double knot)
{
    int low = 0, high = w->break_count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (w->breaks[middle] < knot)
            low = middle + 1;
        else
            high = middle;
    }
    double nearest = knot, distance = HUGE_VAL;
    for (int i = bat_max_int(0, low - 1); i < w->break_count && i <= low; i++) {
        const double u = w->breaks[i];
        const bool inside = u - from > (to - from) / 8 && to - u > (to - from) / 8;
        if (inside && fabs(u - knot) < distance) {
            distance = fabs(u - knot);
            nearest = u;
        }
    }
    return nearest;
}

/* Far more than any tolerance above rounding takes, of a curve; data bound their knots themselves. */
enum { MOST_KNOTS = 100000 };

/* The knots of `t`, and one in each span that is too far off. */
batten_status bat_trial_refine(const bat_within *w, const bat_trial *t, bat_trial *out)
{
    batten_status status = bat_trial_begin(2 * t->count + 1, out);
    if (status != BATTEN_OK)
        return status;
    out->count = 0;
    for (int k = 0, from = 0; k <= t->count; k++) {
        double worst = 0, knot = 0;
        int to = from;
        while (to < t->data_count && (k == t->count || t->parameters[to] < t->inner[k]))
            worst = bat_max(worst, t->distances[to++]);
        if (worst > w->tolerance && (!w->sample || t->count < MOST_KNOTS) &&
            middle_of(t, from, to, &knot))
            out->inner[out->count++] = snap(w, k > 0 ? t->inner[k - 1] : w->domain.a,
                                            k < t->count ? t->inner[k] : w->domain.b, knot);
        if (k < t->count)
            out->inner[out->count++] = t->inner[k];
        from = to;
    }
    return BATTEN_OK;
}
