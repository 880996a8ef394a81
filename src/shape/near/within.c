/* Knots that go in and out until a curve is near enough. */
#include "shape/near/within.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <string.h>

/* One fit: inner knots, and what came of them. */
typedef struct {
    int count; /* inner knots */
    double *inner;
    int data_count;
    double *parameters, *distances; /* [data_count + 1] */
    batten_curve *curve;            /* NULL: the knots do not do */
    double max;
} trial;

static void trial_end(trial *t)
{
    bat_release(t->inner);
    bat_release(t->parameters);
    bat_release(t->distances);
    batten_curve_unref(t->curve);
    *t = (trial){0};
}

static batten_status trial_begin(int count, trial *out)
{
    *out = (trial){.count = count, .max = HUGE_VAL};
    out->inner = bat_array((size_t)count + 1, sizeof *out->inner);
    return out->inner ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* ---- one fit ---- */

/* All knots of a fit, as batten_curve_least_squares wants them; release them. */
static double *knots_of(const bat_within *w, const trial *t)
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

static batten_status fit_curve(bat_within *w, const double *knots, trial *t)
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

static batten_status fit(bat_within *w, trial *t)
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

static bool is_near(const bat_within *w, const trial *t)
{
    return t->curve && t->max <= w->tolerance;
}

static int size_of(const batten_curve *curve)
{
    return batten_curve_point_count(curve);
}

/* Within the tolerance the smaller is the better, else the nearer. */
static bool is_better(const bat_within *w, const trial *t)
{
    if (!w->curve)
        return true;
    if (t->max <= w->tolerance && w->error <= w->tolerance)
        return size_of(t->curve) < size_of(w->curve);
    return t->max < w->error;
}

static void copy_parameters(const bat_within *w, const double *from, double *to)
{
    if (!w->sample)
        memcpy(to, from, (size_t)(w->count + w->periodic) * sizeof *to);
}

/* The curve of this way so far: later fits begin with its parameters; and perhaps the best. */
static void keep_trial(bat_within *w, const trial *t)
{
    if (!t->curve)
        return;
    copy_parameters(w, t->parameters, w->parameters);
    if (!is_better(w, t))
        return;
    batten_curve_unref(w->curve);
    w->curve = batten_curve_ref(t->curve);
    w->error = t->max;
    copy_parameters(w, t->parameters, w->best);
}

/* ---- knots that go ---- */

/* Indices of the inner knots in the order in which they are removed. */
static batten_status rank(const bat_within *w, const trial *t, int *order, int *count)
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

static batten_status without(const trial *t, int gone_count, const bool *gone, trial *out)
{
    const batten_status status = trial_begin(t->count - gone_count, out);
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
static batten_status take_away(bat_within *w, trial *t, int count, const int *order, int most,
                               int *removed)
{
    block waiting[64] = {{0, count}};
    bool *gone = bat_array((size_t)t->count, sizeof *gone);
    trial best = {0};
    batten_status status = gone ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    *removed = 0;
    for (int depth = 1; status == BATTEN_OK && depth > 0 && w->fits < most;) {
        const block b = waiting[--depth];
        trial next = {0};
        for (int i = b.from; i < b.to; i++)
            gone[order[i]] = true;
        status = without(t, *removed + b.to - b.from, gone, &next);
        if (status == BATTEN_OK)
            status = fit(w, &next);
        if (status == BATTEN_OK && is_near(w, &next)) {
            trial_end(&best);
            best = next;
            *removed += b.to - b.from;
            continue;
        }
        trial_end(&next);
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
        trial_end(t);
        *t = best;
    } else {
        trial_end(&best);
    }
    return status;
}

/* How many fits may be tried: enough for some dozens of knots one by one, however many there
 * are; fewer where each takes long. */
static int trials(const bat_within *w, const trial *t)
{
    const double each = bat_max(4, bat_min(64, 2e5 / w->count));
    return (int)(each * log2(2.0 + t->count));
}

static batten_status shrink(bat_within *w, trial *t)
{
    batten_status status = BATTEN_OK;
    const int most = w->fits + trials(w, t);
    int removed = 1;
    while (status == BATTEN_OK && removed > 0 && t->count > 0) {
        int count = 0;
        int *order = bat_array((size_t)batten_curve_knot_count(t->curve), sizeof *order);
        status = order ? rank(w, t, order, &count) : BATTEN_OUT_OF_MEMORY;
        removed = 0;
        if (status == BATTEN_OK && count > 0)
            status = take_away(w, t, count, order, most, &removed);
        bat_release(order);
        if (status == BATTEN_OK)
            keep_trial(w, t);
    }
    return status;
}

/* ---- knots that come ---- */

/* Fewer on each side of a new knot would let the curve swing between the data. */
enum { LEAST_DATA = 2 };

/* Between two data of from .. to - 1 with parameters of their own, next to the middle weighted
 * by squared distances; false when there are none. */
static bool middle_of(const trial *t, int from, int to, double *knot)
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

/* Far more than any tolerance above rounding takes. */
enum { MOST_KNOTS = 100000 };

/* The knots of `t`, and one in each span that is too far off. */
static batten_status refine(const bat_within *w, const trial *t, trial *out)
{
    batten_status status = trial_begin(2 * t->count + 1, out);
    if (status != BATTEN_OK)
        return status;
    out->count = 0;
    for (int k = 0, from = 0; k <= t->count; k++) {
        double worst = 0, knot = 0;
        int to = from;
        while (to < t->data_count && (k == t->count || t->parameters[to] < t->inner[k]))
            worst = bat_max(worst, t->distances[to++]);
        if (worst > w->tolerance && t->count < MOST_KNOTS && middle_of(t, from, to, &knot))
            out->inner[out->count++] = snap(w, k > 0 ? t->inner[k - 1] : w->domain.a,
                                            k < t->count ? t->inner[k] : w->domain.b, knot);
        if (k < t->count)
            out->inner[out->count++] = t->inner[k];
        from = to;
    }
    return BATTEN_OK;
}

/* As many knots as data with parameters of their own allow, so that the curve goes through
 * them: the means of as many neighbours as the degree says [PT97, 9.8]; of a ring the data, or
 * with an even degree the middles between them. */
static batten_status all_knots(const bat_within *w, trial *out)
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
    const batten_status status = trial_begin(inner, out);
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
static batten_status few_knots(const bat_within *w, trial *out)
{
    const int count = w->periodic ? w->degree : 0;
    const batten_status status = trial_begin(count, out);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        out->inner[i] = w->domain.a + (i + 1.0) / (count + 1) * (w->domain.b - w->domain.a);
    return status;
}

static batten_status grow(bat_within *w, trial *t)
{
    batten_status status = few_knots(w, t);
    if (status == BATTEN_OK)
        status = fit(w, t);
    bool grows = true;
    while (status == BATTEN_OK && t->curve && t->max > w->tolerance && grows) {
        trial next = {0};
        status = refine(w, t, &next);
        grows = next.count > t->count;
        if (status == BATTEN_OK && grows)
            status = fit(w, &next);
        if (status == BATTEN_OK && grows) {
            trial_end(t);
            *t = next;
        } else {
            trial_end(&next);
        }
    }
    if (status == BATTEN_OK)
        keep_trial(w, t);
    return status;
}

/* A curve through all data that swings between them: later ones may swing as much. */
static batten_status allow_swing(bat_within *w, trial *t)
{
    w->swing = HUGE_VAL;
    batten_status status = w->measure(w, t->curve, t->parameters, t->distances, &t->max);
    w->swing = 0;
    if (status != BATTEN_OK || !is_near(w, t))
        return status;
    status = w->measure(w, t->curve, t->parameters, t->distances, &t->max);
    w->swing = 2 * (t->max - w->tolerance);
    return status == BATTEN_OK ? w->measure(w, t->curve, t->parameters, t->distances, &t->max)
                               : status;
}

static batten_status begin_with_all(bat_within *w, trial *t)
{
    trial_end(t);
    batten_status status = all_knots(w, t);
    if (status == BATTEN_OK)
        status = fit(w, t);
    if (status == BATTEN_OK && t->curve && !is_near(w, t) && !(w->error <= w->tolerance))
        status = allow_swing(w, t);
    if (status == BATTEN_OK)
        keep_trial(w, t);
    return status;
}

batten_status bat_within_insert(bat_within *w)
{
    trial t = {0};
    copy_parameters(w, w->start, w->parameters);
    batten_status status = grow(w, &t);
    if (status == BATTEN_OK && !is_near(w, &t) && !w->sample)
        status = begin_with_all(w, &t);
    if (status == BATTEN_OK && !is_near(w, &t) && !w->sample) {
        /* Feet that fell together. */
        copy_parameters(w, w->start, w->parameters);
        status = begin_with_all(w, &t);
    }
    if (status == BATTEN_OK && is_near(w, &t))
        status = shrink(w, &t);
    trial_end(&t);
    return status;
}

batten_status bat_within_remove(bat_within *w)
{
    trial t = {0};
    copy_parameters(w, w->start, w->parameters);
    batten_status status = begin_with_all(w, &t);
    if (status == BATTEN_OK && is_near(w, &t))
        status = shrink(w, &t);
    trial_end(&t);
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
        points += size_of(pieces[i]) - 1;
    batten_curve *made = NULL;
    const batten_status status = bat_curve_make(d, p, points, false, &made);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0, at = 0; i < count; i++) {
        const int n = size_of(pieces[i]);
        memcpy(made->points + (size_t)at * (size_t)d, batten_curve_points(pieces[i]),
               (size_t)(n * d) * sizeof(double));
        /* Of the knots at a joint the second piece brings all but one. */
        memcpy(made->knots + at + (i > 0), batten_curve_knots(pieces[i]) + (i > 0),
               (size_t)(n + p + 1 - (i > 0)) * sizeof(double));
        at += n - 1;
    }
    return bat_curve_finish(made, out);
}
