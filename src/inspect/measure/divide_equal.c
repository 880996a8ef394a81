/*
 * Chords of one length: a pair of compasses is walked along the curve, and opened or closed
 * until the last step ends at the end of the curve.
 */
#include "inspect/forms.h"
#include "numeric/vector.h"
#include <batten/measure.h>

#include <float.h>
#include <string.h>

enum { MOST_PARTS = 1000000, ROUNDS = 200 };

typedef struct {
    const batten_curve *curve;
    bat_forms forms;
    bat_walk walk;
    double *rows; /* [p + 1][width] */
    batten_interval domain;
    double end[3];
} compasses;

static batten_status compasses_begin(const batten_curve *curve, compasses *out)
{
    *out = (compasses){
        .curve = curve, .walk = {.only_rising = true}, .domain = batten_curve_domain(curve)};
    batten_status status = batten_curve_evaluate(curve, out->domain.b, 0, out->end);
    if (status != BATTEN_OK)
        return status;
    out->rows = bat_array3((size_t)curve->degree + 1, bat_curve_width(curve), sizeof(double));
    return out->rows ? bat_forms_begin(32, 2 * curve->degree, &out->forms)
                     : BATTEN_OUT_OF_MEMORY;
}

static void compasses_end(compasses *c)
{
    bat_walk_end(&c->walk);
    bat_forms_end(&c->forms);
    bat_release(c->rows);
}

/* |A - q w|^2 - c^2 w^2 on one span; its coordinates are already relative to q. */
static bat_form beyond(bat_forms *forms, const bat_span_forms *span, int dimension,
                       double chord)
{
    bat_form sum = bat_form_product(forms, span->x[0], span->x[0]);
    for (int k = 1; k < dimension; k++)
        sum = bat_form_sum(forms, sum, 1, bat_form_product(forms, span->x[k], span->x[k]));
    return bat_form_sum(forms, sum, -chord * chord, bat_form_product(forms, span->w, span->w));
}

/* The first place after `from`, the point q, that is as far from q as the compasses are open.
 * On the span of `from` the way out is the first one behind it; on the others it is the first.
 */
static batten_status step_chord(compasses *c, double from, const double *q, double chord,
                                bool *found, double *to)
{
    const batten_curve *curve = c->curve;
    bat_span_forms span;
    int k = bat_knots_span(curve->degree, curve->count, curve->knots, from, BATTEN_FROM_RIGHT);
    batten_status status = BATTEN_OK;
    c->walk.count = c->walk.sign = 0;
    *found = false;
    while (status == BATTEN_OK && !*found &&
           bat_span_forms_next(curve, &k, c->rows, q, &c->forms, &span)) {
        const int seen = c->walk.count;
        status = bat_walk_piece(&c->walk, beyond(&c->forms, &span, curve->dimension, chord),
                                span.a, span.b);
        for (int i = seen; status == BATTEN_OK && !*found && i < c->walk.count; i++)
            if (c->walk.at[i] > from) {
                *found = true;
                *to = c->walk.at[i];
            }
    }
    return status;
}

/* Walk count - 1 steps; *rest is how much farther the end then is than one more step, negative
 * too when the curve ends before all steps are made. */
static batten_status walk(compasses *c, int count, double chord, double *u, double *rest)
{
    const int d = c->curve->dimension;
    batten_status status = BATTEN_OK;
    double p[3] = {0};
    u[0] = c->domain.a;
    for (int i = 1; i < count; i++) {
        bool found = false;
        status = batten_curve_evaluate(c->curve, u[i - 1], 0, p);
        if (status == BATTEN_OK)
            status = step_chord(c, u[i - 1], p, chord, &found, &u[i]);
        if (status != BATTEN_OK)
            return status;
        if (!found) {
            *rest = -HUGE_VAL;
            return BATTEN_OK;
        }
    }
    u[count] = c->domain.b;
    status = batten_curve_evaluate(c->curve, u[count - 1], 0, p);
    *rest = bat_distance(d, c->end, p) - chord;
    return status;
}

/* A step more or less in the opening moves the last place by about `count` times as much; where
 * that leads out of the bracket it is halved. */
static batten_status open_and_close(compasses *c, int count, double longest, double tolerance,
                                    double *u, double *chord)
{
    double low = 0, high = longest, at = longest, rest = 0, before = HUGE_VAL;
    for (int round = 0; round < ROUNDS; round++) {
        const batten_status status = walk(c, count, at, u, &rest);
        if (status != BATTEN_OK)
            return status;
        /* Better than asked, as long as it costs nothing. */
        if (fabs(rest) <= tolerance && fabs(rest) >= fabs(before) / 4)
            break;
        before = rest;
        if (rest > 0)
            low = at;
        else
            high = at;
        const double guess = at + rest / count, middle = low + (high - low) / 2;
        const double next = guess > low && guess < high ? guess : middle;
        if (next == at || !(middle > low && middle < high))
            break;
        at = next;
    }
    *chord = at;
    if (fabs(rest) <= tolerance)
        return BATTEN_OK;
    return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                    "no %d equal chords were found: with %.17g the last one is %g longer",
                    count, at, rest);
}

batten_status batten_curve_divide_equal_chords(const batten_curve *curve, int count,
                                               double tolerance, double *chord, double *u)
{
    compasses c = {0};
    double length, found = 0, *at = NULL;
    if (count < 1 || count > MOST_PARTS)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve is not cut into %d parts", count);
    batten_status status = batten_curve_length(curve, tolerance, NULL, &length);
    if (status != BATTEN_OK)
        return status;
    if (!(length > tolerance))
        return bat_fail(BATTEN_COINCIDENT, "the curve is %g long: it has no chords", length);
    if (count < 3 && batten_curve_is_closed(curve, tolerance))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a closed curve needs 3 equal chords at least, not %d", count);
    at = bat_array((size_t)count + 1, sizeof *at);
    status = at ? compasses_begin(curve, &c) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = open_and_close(&c, count, (length + tolerance) / count, tolerance, at, &found);
    if (status == BATTEN_OK) {
        memcpy(u, at, ((size_t)count + 1) * sizeof *u);
        if (chord)
            *chord = found;
    }
    compasses_end(&c);
    bat_release(at);
    return status;
}
