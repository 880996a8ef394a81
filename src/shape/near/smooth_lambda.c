/* The search for the weight of a penalty: by a target, or by cross validation. */
#include "shape/near/smooth.h"

#include <string.h>

/* ---- one lambda ---- */

batten_status bat_smoothing_try(bat_smoothing *t, double lambda)
{
    int unknown;
    batten_status status = bat_fit_solve(&t->fit, lambda, t->control, &unknown);
    if (status == BATTEN_SINGULAR_SYSTEM)
        return bat_fail(status,
                        "control point %d of %d is not determined when the penalty weighs %g",
                        unknown + 1, t->fit.count, lambda);
    if (status != BATTEN_OK)
        return status;
    bat_fit_residuals(&t->fit, t->control, t->residuals);
    bat_fit_measure(&t->fit, t->residuals, &t->report);
    t->report.lambda = lambda;
    return BATTEN_OK;
}

static batten_status weighted_rms(void *user, double lambda, double *rms)
{
    bat_smoothing *t = user;
    const batten_status status = bat_smoothing_try(t, lambda);
    *rms = sqrt(t->report.sum / t->weight);
    return status;
}

/* Craven and Wahba's V; its root, which is a length. A lambda so large that the equations are
 * lost in rounding is no candidate. */
static batten_status validation(void *user, double lambda, double *value)
{
    bat_smoothing *t = user;
    batten_status status = bat_smoothing_try(t, lambda);
    if (status == BATTEN_OK)
        status = bat_fit_freedom(&t->fit, &t->report.freedom);
    const double rest = t->counted - t->report.freedom;
    /* A trace so near to the number of data is rounding; the curve interpolates. */
    const bool good = status == BATTEN_OK && rest > 1e-6 * t->counted;
    *value = good ? sqrt(t->counted * t->report.sum) / rest : HUGE_VAL;
    return status == BATTEN_SINGULAR_SYSTEM ? BATTEN_OK : status;
}

/* ---- the search, over x = log10(lambda / scale) ---- */

static double lambda_at(const bat_lambda_search *t, double x)
{
    return t->scale * bat_pow(10, x);
}

/* Where this vanishes rms is the target; rms is near a power of lambda for long stretches. */
static batten_status above_target(const bat_lambda_search *t, double lambda, double *value)
{
    double rms = 1;
    const batten_status status = t->rms(t->user, lambda, &rms);
    *value = bat_log(rms / t->amount);
    return status;
}

double bat_last_decade(int order, int count)
{
    return 2 * order * bat_log10(count) + 4;
}

enum { FIRST_DECADE = -10 };

/* rms rises with lambda. Secants, halving where they stand still. */
static batten_status find_root(const bat_lambda_search *t, double low, double high,
                               double at_low, double at_high, double *found)
{
    double value;
    for (int i = 0; i < 60 && high - low > 1e-9; i++) {
        double x = (low * at_high - high * at_low) / (at_high - at_low);
        if (!(x > low && x < high) || i % 4 == 3)
            x = (low + high) / 2;
        *found = lambda_at(t, x);
        const batten_status status = above_target(t, *found, &value);
        if (status != BATTEN_OK || fabs(value) <= 1e-8)
            return status;
        if (value < 0) {
            low = x;
            at_low = value;
            at_high /= 2;
        } else {
            high = x;
            at_high = value;
            at_low /= 2;
        }
    }
    *found = lambda_at(t, low);
    return above_target(t, *found, &value);
}

/* The lambda at which rms is the target, from the middle outwards; where rms stays below, the
 * polynomial will do, and *found is HUGE_VAL; where it stays above, the interpolant: 0.
 * Equations that are lost in rounding are those of the polynomial. */
static batten_status search_target(const bat_lambda_search *t, double *found)
{
    const double last = t->last, step = 2;
    double x = 0, value = 0, before = 0;
    batten_status status = above_target(t, lambda_at(t, x), &value);
    const double way = status == BATTEN_OK && value < 0 ? step : -step;
    *found = way > 0 ? HUGE_VAL : 0;
    while (status == BATTEN_OK && (value < 0) == (way > 0)) {
        if (x < FIRST_DECADE || x > last)
            return BATTEN_OK;
        x += way;
        before = value;
        status = above_target(t, lambda_at(t, x), &value);
    }
    if (status == BATTEN_SINGULAR_SYSTEM && way > 0)
        return BATTEN_OK;
    if (status == BATTEN_OK)
        status = way > 0 ? find_root(t, x - step, x, before, value, found)
                         : find_root(t, x, x + step, value, before, found);
    return status;
}

/* The best place so far, the two before it, and the bracket around them. */
typedef struct {
    double low, high;
    double x[3], value[3]; /* best first */
    double last, before;   /* steps */
} least_search;

/* The vertex of the parabola through the three best places, where it lies inside and steps
 * shrink; else the golden section of the longer side. Source: [Brent73]. */
static double next_place(least_search *s, double nearest)
{
    const double x = s->x[0], middle = (s->low + s->high) / 2;
    const double r = (x - s->x[1]) * (s->value[0] - s->value[2]),
                 q = (x - s->x[2]) * (s->value[0] - s->value[1]);
    const double step = ((x - s->x[1]) * r - (x - s->x[2]) * q) / (2 * (q - r));
    const bool good = fabs(step) < fabs(s->before) / 2 && x + step > s->low + nearest &&
                      x + step < s->high - nearest;
    s->before = good ? s->last : (x < middle ? s->high : s->low) - x;
    s->last = good ? step : (3 - sqrt(5)) / 2 * s->before;
    return x + (fabs(s->last) >= nearest ? s->last : copysign(nearest, s->last));
}

static void remember(least_search *s, double x, double value)
{
    const bool better = value <= s->value[0];
    const double edge = better ? s->x[0] : x;
    if (edge < (better ? x : s->x[0]))
        s->low = edge;
    else
        s->high = edge;
    int at = 3;
    for (; at > 0 && value <= s->value[at - 1]; at--)
        if (at < 3) {
            s->x[at] = s->x[at - 1];
            s->value[at] = s->value[at - 1];
        }
    if (at < 3) {
        s->x[at] = x;
        s->value[at] = value;
    }
}

/* From the best place of three beside each other. */
static batten_status find_least(const bat_lambda_search *t, const double *value, double best,
                                double step, double *found)
{
    least_search s = {.low = best - step,
                      .high = best + step,
                      .x = {best, best - step, best + step},
                      .value = {value[1], value[0], value[2]},
                      .last = step,
                      .before = 2 * step};
    /* The criterion is flat at its least: a hundredth of a decade is far within its noise. */
    const double nearest = 2.5e-3;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < 40; i++) {
        const double middle = (s.low + s.high) / 2;
        if (fabs(s.x[0] - middle) <= 2 * nearest - (s.high - s.low) / 2)
            break;
        const double x = next_place(&s, nearest);
        double at_x;
        status = t->score(t->user, lambda_at(t, x), &at_x);
        remember(&s, x, at_x);
    }
    *found = lambda_at(t, s.x[0]);
    return status;
}

static batten_status search_validation(const bat_lambda_search *t, double *found)
{
    const double last = t->last, step = t->coarse ? 2 : 1;
    double best = 0, value[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, around[3] = {0, HUGE_VAL, 0};
    for (double x = FIRST_DECADE; x < last + 2 * step; x += step) {
        value[0] = value[1];
        value[1] = value[2];
        const batten_status status = t->score(t->user, lambda_at(t, x), &value[2]);
        if (status != BATTEN_OK)
            return status;
        if (value[1] < around[1]) {
            memcpy(around, value, sizeof around);
            best = x - step;
        }
    }
    return find_least(t, around, best, step, found);
}

/* Downhill from where the least was before: a few scores instead of one for every decade. */
static batten_status search_nearby(const bat_lambda_search *t, double *found)
{
    double middle = bat_log10(t->near / t->scale), value[3];
    batten_status status = BATTEN_OK;
    for (int i = 0; i < 3 && status == BATTEN_OK; i++)
        status = t->score(t->user, lambda_at(t, middle + i - 1), &value[i]);
    while (status == BATTEN_OK && bat_min(value[0], value[2]) < value[1]) {
        const int way = value[2] < value[0] ? 1 : -1;
        if (!(middle + way > FIRST_DECADE && middle + way < t->last + 2))
            return search_validation(t, found);
        middle += way;
        value[1 - way] = value[1];
        value[1] = value[1 + way];
        status = t->score(t->user, lambda_at(t, middle + way), &value[1 + way]);
    }
    return status == BATTEN_OK ? find_least(t, value, middle, 1, found) : status;
}

batten_status bat_lambda_choose(const bat_lambda_search *t, double *lambda)
{
    *lambda = t->amount;
    if (t->by == BATTEN_SMOOTH_BY_LAMBDA)
        return BATTEN_OK;
    if (t->by == BATTEN_SMOOTH_BY_RMS)
        return t->amount == 0 ? BATTEN_OK : search_target(t, lambda);
    return t->near > 0 && t->near < HUGE_VAL ? search_nearby(t, lambda)
                                             : search_validation(t, lambda);
}

/* ---- of a curve ---- */

batten_status bat_smoothing_choose(bat_smoothing *t, double *lambda)
{
    const batten_curve_smooth_options *o = t->options;
    const bat_lambda_search search = {
        .by = o->by,
        .amount = o->amount,
        .scale = t->fit.penalty_scale,
        .last = bat_last_decade(o->order, t->fit.count),
        .coarse = t->fit.count > 2000,
        .user = t,
        .rms = weighted_rms,
        .score = validation,
    };
    return bat_lambda_choose(&search, lambda);
}
