/* Arcs through points, each tangent to the one before. */
#include "numeric/vector.h"
#include "shape/arcs/biarc.h"
#include "spline/data_check.h"

#include <string.h>

/* With the start at x, the angle from chord i to the direction at its start is
 * base_i + (-1)^i x: directions are mirrored in the chords, one after another. */
typedef struct {
    int count; /* of chords */
    double *length, *direction;
    double *base;
} chords;

/* The curvature of arc i, and how it changes with x. */
static double curvature_of(const chords *c, int i, double x, double *rate)
{
    const double sign = i % 2 == 0 ? 1 : -1, lean = c->base[i] + sign * x;
    *rate = -2 * sign * cos(lean) / c->length[i];
    return -2 * sin(lean) / c->length[i];
}

/* Lengths by the longest chord: the sum is for comparing alone. Infinity where an arc leans
 * from its chord by more than `most`. */
static double sum_of_jumps(const chords *c, double unit, double most, double x, double *slope,
                           double *bend)
{
    double sum = 0, before = 0, rate_before = 0;
    *slope = *bend = 0;
    for (int i = 0; i < c->count; i++) {
        double rate = 0;
        const double k = unit * curvature_of(c, i, x, &rate);
        rate *= unit;
        if (fabs(remainder(c->base[i] + (i % 2 == 0 ? x : -x), 2 * BAT_PI)) > most)
            return HUGE_VAL;
        if (i > 0) {
            const double jump = k - before, change = rate - rate_before;
            sum += jump * jump;
            *slope += 2 * jump * change;
            /* The second derivative of a curvature by x is the curvature, turned about. */
            *bend += 2 * (change * change - jump * jump);
        }
        before = k;
        rate_before = rate;
    }
    return sum;
}

/* The best of many, mended by Newton's rule while that helps. NAN when all lean too much. */
static double best_within(const chords *c, double most)
{
    enum { TRIALS = 256, STEPS = 20 };
    double unit = 0, best = HUGE_VAL, x = (double)NAN, slope = 0, bend = 0;
    for (int i = 0; i < c->count; i++)
        unit = bat_max(unit, c->length[i]);
    /* The chord itself first, then to both sides of it. */
    for (int i = 0; i < TRIALS; i++) {
        const double y = (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2) * (2 * BAT_PI / TRIALS);
        const double sum = sum_of_jumps(c, unit, most, y, &slope, &bend);
        if (sum < best) {
            best = sum;
            x = y;
        }
    }
    for (int i = 0; i < STEPS && best < HUGE_VAL; i++) {
        sum_of_jumps(c, unit, most, x, &slope, &bend);
        const double y = bend > 0 ? x - slope / bend : x;
        const double sum = sum_of_jumps(c, unit, most, y, &slope, &bend);
        if (!(sum < best))
            break;
        best = sum;
        x = y;
    }
    return x;
}

/* Large loops may have small jumps, so arcs of more than half a circle come last. */
static double best_start(const chords *c)
{
    const double x = best_within(c, BAT_PI / 2);
    return isnan(x) ? best_within(c, BAT_PI * (1 - 1e-9)) : x;
}

static batten_status find_chords(const double *points, const chords *c)
{
    for (int i = 0; i < c->count; i++) {
        const double *a = points + 2 * i, q[2] = {a[2] - a[0], a[3] - a[1]};
        c->length[i] = bat_norm(2, q);
        c->direction[i] = atan2(q[1], q[0]);
        if (!(c->length[i] > 0))
            return bat_fail(BATTEN_COINCIDENT, "points %d and %d coincide", i, i + 1);
        if (!isfinite(c->length[i]))
            return bat_fail(BATTEN_OVERFLOW, "points %d and %d are too far apart", i, i + 1);
        /* From the end of the arc before, whose direction is mirrored: -base, then the turn. */
        c->base[i] = i == 0 ? 0
                            : remainder(-c->base[i - 1] + c->direction[i - 1] - c->direction[i],
                                        2 * BAT_PI);
    }
    return BATTEN_OK;
}

static batten_status make_spans(const chords *c, const double *points, double x,
                                batten_span *spans, double *angles,
                                batten_chain_sequential_arcs_report *report)
{
    double before = 0;
    for (int i = 0; i < c->count; i++) {
        const double lean = remainder(c->base[i] + (i % 2 == 0 ? x : -x), 2 * BAT_PI);
        double rate = 0;
        const double k = curvature_of(c, i, x, &rate);
        if (BAT_PI - fabs(lean) < 1e-9)
            return bat_fail(
                BATTEN_SINGULAR_HERE,
                "the arc from point %d to point %d would be a full circle: it begins "
                "away from its end",
                i, i + 1);
        bat_arc_span(points + 2 * i, c->length[i], c->direction[i], -lean, &spans[i]);
        report->long_arcs += fabs(lean) > BAT_PI / 2;
        if (fabs(rate) > report->sensitivity) {
            report->sensitivity = fabs(rate);
            report->sensitive_at = i;
        }
        report->jump = i > 0 ? bat_max(report->jump, fabs(k - before)) : 0;
        before = k;
        if (i == 0)
            report->start_angle = angles[0] = c->direction[0] + lean;
        angles[i + 1] = angles[i] - 2 * lean;
    }
    return BATTEN_OK;
}

static batten_status make_arc_spans(const chords *c, const double *points, double start_angle,
                                    batten_span *spans, double *angles, double *breaks,
                                    batten_chain_sequential_arcs_report *report,
                                    batten_chain **out)
{
    batten_status status = find_chords(points, c);
    if (status != BATTEN_OK)
        return status;
    const double x = isnan(start_angle) ? best_start(c) : start_angle - c->direction[0];
    status = make_spans(c, points, x, spans, angles, report);
    if (status != BATTEN_OK)
        return status;
    double size = bat_largest(2 * c->count + 2, points);
    breaks[0] = 0;
    for (int i = 0; i < c->count; i++) {
        breaks[i + 1] = breaks[i] + spans[i].length;
        size = bat_max(size, spans[i].length);
    }
    return batten_chain_create(&(batten_chain_parts){2, c->count, spans, breaks, false},
                               64 * DBL_EPSILON * size, out);
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
    batten_chain_sequential_arcs_report found = {0};
    chords c = {points.count - 1, bat_array(n, sizeof(double)), bat_array(n, sizeof(double)),
                bat_array(n, sizeof(double))};
    batten_span *spans = bat_array(n, sizeof *spans);
    double *made = bat_array(n, sizeof *made), *breaks = bat_array(n, sizeof *breaks);
    status = BATTEN_OUT_OF_MEMORY;
    if (c.length && c.direction && c.base && spans && made && breaks)
        status = make_arc_spans(&c, points.at, start_angle, spans, made, breaks, &found, out);
    if (status == BATTEN_OK && angles)
        memcpy(angles, made, n * sizeof *made);
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, breaks, n * sizeof *breaks);
    if (status == BATTEN_OK && report)
        *report = found;
    bat_release(c.length);
    bat_release(c.direction);
    bat_release(c.base);
    bat_release(spans);
    bat_release(made);
    bat_release(breaks);
    return status;
}
