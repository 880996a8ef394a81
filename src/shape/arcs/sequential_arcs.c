/* Arcs through points, each tangent to the one before. */
#include "numeric/vector.h"
#include "shape/arcs/biarc.h"
#include "spline/data_check.h"

#include <string.h>

/* With the start at x, the angle from chord i to the direction at its start is
 * base_i + (-1)^i x: directions are mirrored in the chords, one after another. */
typedef struct {
    int count; /* of chords */
    const double *points;
    double *length, *direction;
    double *base;
    double longest; /* of the lengths */
} chords;

/* The curvature of arc i, and how it changes with x. */
static double curvature_of(const chords *c, int i, double x, double *rate)
{
    const double sign = i % 2 == 0 ? 1 : -1, lean = c->base[i] + sign * x;
    *rate = -2 * sign * bat_cos(lean) / c->length[i];
    return -2 * bat_sin(lean) / c->length[i];
}

/* The angle of arc i from its chord, -pi .. pi. */
static double lean_of(const chords *c, int i, double x)
{
    return remainder(c->base[i] + (i % 2 == 0 ? x : -x), 2 * BAT_PI);
}

/* A start x, the sum of the squared jumps of curvature, and its derivatives by x. */
typedef struct {
    double x, sum, slope, bend;
} start_trial;

/* Lengths by the longest chord: the sum is for comparing alone. Infinity where an arc leans
 * from its chord by more than `most`. */
static start_trial try_start(const chords *c, double most, double x)
{
    start_trial tried = {.x = x};
    double before = 0, rate_before = 0;
    for (int i = 0; i < c->count; i++) {
        double rate = 0;
        const double k = c->longest * curvature_of(c, i, x, &rate);
        rate *= c->longest;
        if (fabs(lean_of(c, i, x)) > most)
            return (start_trial){.x = x, .sum = HUGE_VAL};
        if (i > 0) {
            const double jump = k - before, change = rate - rate_before;
            tried.sum += jump * jump;
            tried.slope += 2 * jump * change;
            /* The second derivative of a curvature by x is the curvature, turned about. */
            tried.bend += 2 * (change * change - jump * jump);
        }
        before = k;
        rate_before = rate;
    }
    return tried;
}

/* The best of many, mended by Newton's rule while that helps. NAN when all lean too much. */
static double best_within(const chords *c, double most)
{
    enum { TRIALS = 256, STEPS = 20 };
    start_trial best = {.x = (double)NAN, .sum = HUGE_VAL};
    /* The chord itself first, then to both sides of it. */
    for (int i = 0; i < TRIALS; i++) {
        const double x = (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2) * (2 * BAT_PI / TRIALS);
        const start_trial tried = try_start(c, most, x);
        if (tried.sum < best.sum)
            best = tried;
    }
    for (int i = 0; i < STEPS && best.sum < HUGE_VAL; i++) {
        const double x = best.bend > 0 ? best.x - best.slope / best.bend : best.x;
        const start_trial tried = try_start(c, most, x);
        if (!(tried.sum < best.sum))
            break;
        best = tried;
    }
    return best.x;
}

/* Large loops may have small jumps, so arcs of more than half a circle come last. */
static double best_start(const chords *c)
{
    const double x = best_within(c, BAT_PI / 2);
    return isnan(x) ? best_within(c, BAT_PI * (1 - 1e-9)) : x;
}

static batten_status find_chords(chords *c)
{
    for (int i = 0; i < c->count; i++) {
        const double *a = c->points + 2 * i, q[2] = {a[2] - a[0], a[3] - a[1]};
        c->length[i] = bat_norm(2, q);
        c->direction[i] = bat_atan2(q[1], q[0]);
        if (!(c->length[i] > 0))
            return bat_fail(BATTEN_COINCIDENT, "points %d and %d coincide", i + 1, i + 2);
        if (!isfinite(c->length[i]))
            return bat_fail(BATTEN_OVERFLOW, "points %d and %d are too far apart", i + 1,
                            i + 2);
        /* From the end of the arc before, whose direction is mirrored: -base, then the turn. */
        c->base[i] = i == 0 ? 0
                            : remainder(-c->base[i - 1] + c->direction[i - 1] - c->direction[i],
                                        2 * BAT_PI);
        c->longest = bat_max(c->longest, c->length[i]);
    }
    return BATTEN_OK;
}

/* What is made: one span, two angles and two breaks for each chord. */
typedef struct {
    batten_span *spans;
    double *angles, *breaks;
    batten_chain_sequential_arcs_report report;
} arc_row;

static void report_arc(const chords *c, int i, double x,
                       batten_chain_sequential_arcs_report *report)
{
    double rate = 0, unused = 0;
    const double k = curvature_of(c, i, x, &rate);
    report->long_arcs += fabs(lean_of(c, i, x)) > BAT_PI / 2;
    if (fabs(rate) > report->sensitivity) {
        report->sensitivity = fabs(rate);
        report->sensitive_at = i;
    }
    if (i > 0)
        report->jump = bat_max(report->jump, fabs(k - curvature_of(c, i - 1, x, &unused)));
}

static batten_status make_spans(const chords *c, double x, arc_row *made)
{
    made->report.start_angle = made->angles[0] = c->direction[0] + lean_of(c, 0, x);
    for (int i = 0; i < c->count; i++) {
        const double lean = lean_of(c, i, x);
        if (BAT_PI - fabs(lean) < 1e-9)
            return bat_fail(
                BATTEN_SINGULAR_HERE,
                "the arc from point %d to point %d would be a full circle: it begins "
                "away from its end",
                i + 1, i + 2);
        bat_arc_span(c->points + 2 * i, c->length[i], c->direction[i], -lean, &made->spans[i]);
        made->angles[i + 1] = made->angles[i] - 2 * lean;
        report_arc(c, i, x, &made->report);
    }
    return BATTEN_OK;
}

static batten_status make_arc_spans(chords *c, double start_angle, arc_row *made,
                                    batten_chain **out)
{
    batten_status status = find_chords(c);
    if (status != BATTEN_OK)
        return status;
    status =
        make_spans(c, isnan(start_angle) ? best_start(c) : start_angle - c->direction[0], made);
    if (status != BATTEN_OK)
        return status;
    double size = bat_largest(2 * c->count + 2, c->points), *breaks = made->breaks;
    breaks[0] = 0;
    for (int i = 0; i < c->count; i++) {
        breaks[i + 1] = breaks[i] + made->spans[i].length;
        size = bat_max(size, made->spans[i].length);
    }
    return batten_chain_create(&(batten_chain_parts){2, c->count, made->spans, breaks, false},
                               64 * DBL_EPSILON * size, out);
}

static void release_work(const chords *c, const arc_row *made)
{
    bat_release(c->length);
    bat_release(c->direction);
    bat_release(c->base);
    bat_release(made->spans);
    bat_release(made->angles);
    bat_release(made->breaks);
}

batten_status batten_chain_sequential_arcs(batten_points points, double start_angle,
                                           double *angles, double *parameters,
                                           batten_chain_sequential_arcs_report *report,
                                           batten_chain **out)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    assert(points.at && out);
    batten_status status = bat_points_check(2, points.count, points.at, 2);
    if (status != BATTEN_OK)
        return status;
    if (isinf(start_angle))
        return bat_fail(BATTEN_NOT_FINITE, "the direction at the start is infinite");
    const size_t n = (size_t)points.count;
    chords c = {.count = points.count - 1,
                .points = points.at,
                .length = bat_array(n, sizeof(double)),
                .direction = bat_array(n, sizeof(double)),
                .base = bat_array(n, sizeof(double))};
    arc_row made = {.spans = bat_array(n, sizeof *made.spans),
                    .angles = bat_array(n, sizeof *made.angles),
                    .breaks = bat_array(n, sizeof *made.breaks)};
    status = BATTEN_OUT_OF_MEMORY;
    if (c.length && c.direction && c.base && made.spans && made.angles && made.breaks)
        status = make_arc_spans(&c, start_angle, &made, out);
    if (status == BATTEN_OK && angles)
        memcpy(angles, made.angles, n * sizeof *angles);
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, made.breaks, n * sizeof *parameters);
    if (status == BATTEN_OK && report)
        *report = made.report;
    release_work(&c, &made);
    return status;
}
