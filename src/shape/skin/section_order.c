/* Sections that do not go together: open and closed ones, neighbours that cross, and those that
 * stand in another order than their distances ask for. */
#include "shape/skin/steps.h"

#include <string.h>

enum { SAMPLES = 33 };
typedef struct {
    double points[SAMPLES][3], tangents[SAMPLES][3];
} samples;

batten_status bat_skin_kinds(bat_skin *t)
{
    int first = -1; /* the first that is no point */
    for (int k = 0; k < t->count; k++) {
        bool closed;
        const batten_status status = bat_skin_closed(t->placed[k], &closed, &t->point[k]);
        if (status != BATTEN_OK)
            return status;
        if (t->point[k])
            continue;
        if (first >= 0 && closed != t->closed && !t->mixed)
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "section %d is %s, and section %d is %s: closed and open sections "
                            "cannot be mixed",
                            first + 1, t->closed ? "closed" : "open", k + 1,
                            closed ? "closed" : "open");
        if (first < 0) {
            first = k;
            t->closed = closed;
        } else
            t->closed = t->closed && closed;
    }
    return BATTEN_OK;
}

/* A section that is a point has no tangents, but for the roundings of its control points. */
static batten_status sample(const batten_curve *curve, bool is_point, samples *out)
{
    const int d = batten_curve_dimension(curve);
    memset(out, 0, sizeof *out);
    for (int i = 0; i < SAMPLES; i++) {
        double at[6];
        const batten_status status =
            batten_curve_evaluate(curve, (double)i / (SAMPLES - 1), 1, at);
        if (status != BATTEN_OK)
            return status;
        memcpy(out->points[i], at, (size_t)d * sizeof *at);
        if (!is_point)
            memcpy(out->tangents[i], at + d, (size_t)d * sizeof *at);
    }
    return BATTEN_OK;
}

/* What leads from one section to the next beside the tangent; false where nothing does. */
static bool step_across(const samples *a, const samples *b, int i, double size, double *out)
{
    const double *t = a->tangents[i];
    double step[3], length = bat_norm(3, t);
    for (int c = 0; c < 3; c++)
        step[c] = b->points[i][c] - a->points[i][c];
    /* A millionth of the size: below that the direction across is made of rounded differences. */
    const double along = length > 0 ? bat_dot(3, step, t) / length : 0;
    for (int c = 0; c < 3; c++)
        out[c] = step[c] - (length > 0 ? along * (t[c] / length) : 0);
    return bat_norm(3, out) > 1e-6 * size;
}

/* Do the steps across turn back between one place and the next? A continuous surface turns
 * them little by little; 120 degrees at once are a crossing. */
static bool crosses(const samples *a, const samples *b)
{
    double last[3], here[3], size = 0;
    bool any = false;
    for (int i = 0; i < SAMPLES; i++)
        size = bat_max(size, bat_distance(3, a->points[i], b->points[i]));
    for (int i = 0; i < SAMPLES; i++) {
        if (!step_across(a, b, i, size, here))
            continue;
        if (any && bat_dot(3, last, here) < -0.5 * bat_norm(3, last) * bat_norm(3, here))
            return true;
        memcpy(last, here, sizeof last);
        any = true;
    }
    return false;
}

static double mean_distance(const samples *a, const samples *b)
{
    double sum = 0;
    for (int i = 0; i < SAMPLES; i++)
        sum += bat_distance(3, a->points[i], b->points[i]) / SAMPLES;
    return sum;
}

/* Would the way from `before` over two sections to `after` be shorter by the tenth with the two
 * exchanged? At the ends one of the outer ones is missing. */
static bool rather_exchanged(const samples *before, const samples *one, const samples *two,
                             const samples *after)
{
    double given = 0, exchanged = 0;
    if (before) {
        given += mean_distance(before, one);
        exchanged += mean_distance(before, two);
    }
    if (after) {
        given += mean_distance(two, after);
        exchanged += mean_distance(one, after);
    }
    return exchanged < 0.9 * given;
}

static void count_crossing(bat_skin *t, int k)
{
    if (t->found.crossing_count++ == 0)
        t->found.crossing = k;
    bat_fail(BATTEN_OK, "sections %d and %d cross", k + 1, k + 2);
}

static void count_disorder(bat_skin *t, int k)
{
    if (t->found.disorder_count++ == 0)
        t->found.disorder = k;
    bat_fail(BATTEN_OK, "sections %d and %d are rather in the other order", k + 1, k + 2);
}

batten_status bat_skin_order(bat_skin *t)
{
    t->found.crossing = t->found.disorder = -1;
    t->found.crossing_count = t->found.disorder_count = 0;
    samples *all = bat_array((size_t)t->count, sizeof *all);
    batten_status status = all ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < t->count; k++)
        status = sample(t->unified[k], t->point[k], &all[k]);
    const int n = t->count;
    for (int k = 0; status == BATTEN_OK && k + 1 < n; k++) {
        if (crosses(&all[k], &all[k + 1]))
            count_crossing(t, k);
        if (n > 2 && !t->options->closed &&
            rather_exchanged(k > 0 ? &all[k - 1] : NULL, &all[k], &all[k + 1],
                             k + 2 < n ? &all[k + 2] : NULL))
            count_disorder(t, k);
    }
    bat_release(all);
    return status;
}
