/* Knots that go in and out until a curve is near enough. */
#include "shape/near/within.h"
#include "numeric/vector.h"
#include "shape/near/within_many.h"
#include "spline/curve/curve.h"

#include <string.h>

/* ---- knots that go ---- */

/* Indices of the inner knots in the order in which they are removed. */
static batten_status rank(const bat_within *w, const bat_trial *t, int *order, int *count)
{
    bat_spline spline;
    batten_status status = bat_curve_to_spline(t->curve, &spline);
    if (status != BATTEN_OK)
        return status;
    status =
        bat_spline_rank_knots(&spline, bat_curve_width(t->curve), w->tolerance, order, count);
    for (int i = 0; status == BATTEN_OK && i < *count; i++)
        order[i] -= w->degree + 1;
    bat_spline_free(&spline);
    return status;
}

static batten_status without(const bat_trial *t, int gone_count, const bool *gone,
                             bat_trial *out)
{
    const batten_status status = bat_trial_begin(t->count - gone_count, out);
    for (int i = 0, k = 0; status == BATTEN_OK && i < t->count; i++)
        if (!gone[i])
            out->inner[k++] = t->inner[i];
    return status;
}

/* Ranked knots that wait to be tried together. */
typedef struct {
    int from, to;
} block;

/* All ranked knots at once; a block that cannot go is tried by halves, until `most` fits are
 * done. *t becomes the curve without those that went. */
static batten_status take_away(bat_within *w, bat_trial *t, int count, const int *order,
                               int most, int *removed)
{
    block waiting[64] = {{0, count}};
    bool *gone = bat_array((size_t)t->count, sizeof *gone);
    bat_trial best = {0};
    batten_status status = gone ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    *removed = 0;
    for (int depth = 1; status == BATTEN_OK && depth > 0 && w->fits < most;) {
        const block b = waiting[--depth];
        bat_trial next = {0};
        for (int i = b.from; i < b.to; i++)
            gone[order[i]] = true;
        status = without(t, *removed + b.to - b.from, gone, &next);
        if (status == BATTEN_OK)
            status = bat_trial_fit(w, &next);
        if (status == BATTEN_OK && bat_trial_is_near(w, &next)) {
            bat_trial_end(&best);
            best = next;
            *removed += b.to - b.from;
            continue;
        }
        bat_trial_end(&next);
        for (int i = b.from; i < b.to; i++)
            gone[order[i]] = false;
        const int middle = b.from + (b.to - b.from) / 2;
        if (middle > b.from) {
            waiting[depth++] = (block){middle, b.to};
            waiting[depth++] = (block){b.from, middle};
        }
    }
    bat_release(gone);
    if (status == BATTEN_OK && *removed > 0) {
        bat_trial_end(t);
        *t = best;
    } else {
        bat_trial_end(&best);
    }
    return status;
}

static bool has_many_data(const bat_within *w)
{
    return !w->sample && w->count > BAT_WITHIN_MANY;
}

/* Knots from which on they rather go in many places at once, and the fits for that, which then
 * are as many for a million data as for thousands: each region tries sixteen blocks. */
enum { WIDE = 192, FITS_OF_WIDE = 32 };

static bool is_wide(const bat_within *w, const bat_trial *t)
{
    return has_many_data(w) && t->count >= WIDE;
}

/* How many fits may be tried: enough for some dozens of knots one by one, however many there
 * are; fewer where each takes long. */
static int trials(const bat_within *w, const bat_trial *t)
{
    const double each = bat_max(4, bat_min(64, 2e5 / w->count));
    return (int)(each * bat_log2(2.0 + t->count));
}

static batten_status shrink(bat_within *w, bat_trial *t)
{
    batten_status status = BATTEN_OK;
    const bool wide = is_wide(w, t);
    const int most = w->fits + (wide ? FITS_OF_WIDE : trials(w, t));
    int removed = 1;
    while (status == BATTEN_OK && removed > 0 && t->count > 0) {
        int count = 0;
        int *order = bat_array((size_t)batten_curve_knot_count(t->curve), sizeof *order);
        status = order ? rank(w, t, order, &count) : BATTEN_OUT_OF_MEMORY;
        removed = 0;
        if (status == BATTEN_OK && count > 0)
            status = wide ? bat_within_thin(w, t, count, order, most, &removed)
                          : take_away(w, t, count, order, most, &removed);
        bat_release(order);
        if (status == BATTEN_OK)
            bat_trial_keep(w, t);
    }
    return status;
}

/* ---- knots to begin with ---- */

/* As many knots as data with parameters of their own allow, so that the curve goes through
 * them: the means of as many neighbours as the degree says [PT97, 9.8]; of a ring the data, or
 * with an even degree the middles between them. */
static batten_status all_knots(const bat_within *w, bat_trial *out)
{
    const int n = w->count, p = w->degree;
    int count = 0;
    double *places = bat_array((size_t)n + 1, sizeof *places);
    if (!places)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n; i++)
        if (i == 0 || w->parameters[i] > places[count - 1])
            places[count++] = w->parameters[i];
    if (w->periodic)
        count -= count > 1 && places[count - 1] >= w->parameters[n];
    const bool middles = w->periodic && p % 2 == 0;
    const int inner = bat_max_int(0, w->periodic ? count - 1 : count - p - 1),
              width = w->periodic ? 1 + middles : p;
    const batten_status status = bat_trial_begin(inner, out);
    for (int j = 0; status == BATTEN_OK && j < inner; j++) {
        double sum = 0;
        for (int k = 0; k < width; k++)
            sum += places[j + !middles + k] / width;
        out->inner[j] = sum;
    }
    bat_release(places);
    return status;
}

/* ---- the two ways ---- */

/* Of a ring a first few knots in equal steps. */
static batten_status few_knots(const bat_within *w, bat_trial *out)
{
    const int count = w->periodic ? w->degree : 0;
    const batten_status status = bat_trial_begin(count, out);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        out->inner[i] = w->domain.a + (i + 1.0) / (count + 1) * (w->domain.b - w->domain.a);
    return status;
}

static batten_status grow(bat_within *w, bat_trial *t)
{
    batten_status status = few_knots(w, t);
    if (status == BATTEN_OK && has_many_data(w))
        status = bat_within_first_knots(w, t);
    if (status == BATTEN_OK)
        status = bat_trial_fit(w, t);
    bool grows = true;
    while (status == BATTEN_OK && t->curve && t->max > w->tolerance && grows) {
        bat_trial next = {0};
        status = bat_trial_refine(w, t, &next);
        grows = next.count > t->count;
        if (status == BATTEN_OK && grows)
            status = bat_trial_fit(w, &next);
        if (status == BATTEN_OK && grows) {
            bat_trial_end(t);
            *t = next;
        } else {
            bat_trial_end(&next);
        }
    }
    if (status == BATTEN_OK)
        bat_trial_keep(w, t);
    return status;
}

/* A curve through all data that swings between them: later ones may swing as much. */
static batten_status allow_swing(bat_within *w, bat_trial *t)
{
    w->swing = HUGE_VAL;
    batten_status status = w->measure(w, t->curve, t->parameters, t->distances, &t->max);
    w->swing = 0;
    if (status != BATTEN_OK || !bat_trial_is_near(w, t))
        return status;
    status = w->measure(w, t->curve, t->parameters, t->distances, &t->max);
    w->swing = 2 * (t->max - w->tolerance);
    return status == BATTEN_OK ? w->measure(w, t->curve, t->parameters, t->distances, &t->max)
                               : status;
}

static batten_status begin_with_all(bat_within *w, bat_trial *t)
{
    bat_trial_end(t);
    batten_status status = all_knots(w, t);
    if (status == BATTEN_OK)
        status = bat_trial_fit(w, t);
    if (status == BATTEN_OK && t->curve && !bat_trial_is_near(w, t) &&
        !(w->error <= w->tolerance))
        status = allow_swing(w, t);
    if (status == BATTEN_OK)
        bat_trial_keep(w, t);
    return status;
}

batten_status bat_within_insert(bat_within *w)
{
    bat_trial t = {0};
    bat_trial_copy_parameters(w, w->start, w->parameters);
    batten_status status = grow(w, &t);
    if (status == BATTEN_OK && !bat_trial_is_near(w, &t) && !w->sample)
        status = begin_with_all(w, &t);
    if (status == BATTEN_OK && !bat_trial_is_near(w, &t) && !w->sample) {
        /* Feet that fell together. */
        bat_trial_copy_parameters(w, w->start, w->parameters);
        status = begin_with_all(w, &t);
    }
    if (status == BATTEN_OK && bat_trial_is_near(w, &t))
        status = shrink(w, &t);
    bat_trial_end(&t);
    return status;
}

batten_status bat_within_remove(bat_within *w)
{
    bat_trial t = {0};
    bat_trial_copy_parameters(w, w->start, w->parameters);
    batten_status status = begin_with_all(w, &t);
    if (status == BATTEN_OK && bat_trial_is_near(w, &t))
        status = shrink(w, &t);
    bat_trial_end(&t);
    return status;
}

void bat_within_end(bat_within *w)
{
    batten_curve_unref(w->curve);
    w->curve = NULL;
}

/* ---- pieces joined ---- */

batten_status bat_curve_chained(int count, batten_curve *const *pieces, batten_curve **out)
{
    const int p = batten_curve_degree(pieces[0]), d = batten_curve_dimension(pieces[0]);
    int points = 1;
    for (int i = 0; i < count; i++)
        points += bat_trial_size(pieces[i]) - 1;
    batten_curve *made = NULL;
    const batten_status status = bat_curve_make(d, p, points, false, &made);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0, at = 0; i < count; i++) {
        const int n = bat_trial_size(pieces[i]);
        memcpy(made->points + (size_t)at * (size_t)d, batten_curve_points(pieces[i]),
               (size_t)(n * d) * sizeof(double));
        /* Of the knots at a joint the second piece brings all but one. */
        memcpy(made->knots + at + (i > 0), batten_curve_knots(pieces[i]) + (i > 0),
               (size_t)(n + p + 1 - (i > 0)) * sizeof(double));
        at += n - 1;
    }
    return bat_curve_finish(made, out);
}
