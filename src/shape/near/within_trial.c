/* One trial of an approximation within a tolerance: its fit, and the best so far. */
#include "shape/near/within_trial.h"
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

batten_status bat_trial_fit(bat_within *w, bat_trial *t)
{
    batten_status status = w->sample ? w->sample(w, t->count, t->inner) : BATTEN_OK;
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
