/* Chains of biarcs through points of the plane, and arcs joined that lie on one circle. */
#include "numeric/vector.h"
#include "shape/arcs/biarc.h"
#include "spline/chain/chain.h"
#include "spline/data_check.h"

#include <string.h>

batten_chain_biarcs_options batten_chain_biarcs_defaults(void)
{
    return (batten_chain_biarcs_options){.size = sizeof(batten_chain_biarcs_options),
                                         .joint = BATTEN_JOINT_AUTOMATIC,
                                         .place = 0.5};
}

/* ---- directions ---- */

/* The tangent at `b` of the circle through a, b, c: the two chords, each by the ratio of the
 * other's length to its own. False where the points turn back on themselves. */
static bool middle_direction(int d, const double *a, const double *b, const double *c,
                             double *direction)
{
    const double l0 = bat_distance(d, a, b), l1 = bat_distance(d, b, c);
    for (int k = 0; k < d; k++)
        direction[k] =
            (b[k] - a[k]) / l0 * (l1 / (l0 + l1)) + (c[k] - b[k]) / l1 * (l0 / (l0 + l1));
    const double norm = bat_norm(d, direction);
    /* Of two unit vectors with these shares; what is left of opposite ones is rounding. */
    if (!(norm > 16 * DBL_EPSILON))
        return false;
    for (int k = 0; k < d; k++)
        direction[k] /= norm;
    return true;
}

/* At an end: that of the neighbour, mirrored at the middle of the chord between them. */
static void end_direction(int d, const double *from, const double *to, const double *known,
                          double *direction)
{
    const double l = bat_distance(d, from, to);
    double q[3], along = 0;
    for (int k = 0; k < d; k++) {
        q[k] = (to[k] - from[k]) / l;
        along += q[k] * known[k];
    }
    for (int k = 0; k < d; k++)
        direction[k] = 2 * along * q[k] - known[k];
}

batten_status bat_circle_directions(int dimension, int count, const double *points, bool closed,
                                    double *directions)
{
    const int d = dimension, n = count;
    if (n == 2) {
        const double l = bat_distance(d, points, points + d);
        for (int k = 0; k < d; k++)
            directions[k] = directions[d + k] = (points[d + k] - points[k]) / l;
        return BATTEN_OK;
    }
    for (int i = closed ? 0 : 1; i < (closed ? n : n - 1); i++)
        if (!middle_direction(d, points + (i + n - 1) % n * d, points + i * d,
                              points + (i + 1) % n * d, directions + i * d))
            return bat_fail(BATTEN_SINGULAR_HERE,
                            "the points turn back on themselves at point %d", i + 1);
    if (!closed) {
        end_direction(d, points, points + d, directions + d, directions);
        end_direction(d, points + (n - 2) * d, points + (n - 1) * d, directions + (n - 2) * d,
                      directions + (n - 1) * d);
    }
    return BATTEN_OK;
}

/* ---- what is asked ---- */

static batten_status check_directions(int d, int count, const double *directions)
{
    for (int i = 0; i < count; i++) {
        if (bat_first_not_finite(directions + i * d, (size_t)d) < (size_t)d)
            return bat_fail(BATTEN_NOT_FINITE,
                            "direction %d has a coordinate that is not a finite number", i + 1);
        if (bat_largest(d, directions + i * d) == 0)
            return bat_fail(BATTEN_BAD_ARGUMENT, "direction %d is zero", i + 1);
    }
    return BATTEN_OK;
}

batten_status bat_biarcs_check(int dimension, int count, const double *points,
                               const batten_chain_biarcs_options *options)
{
    const int d = dimension, spans = options->closed ? count : count - 1;
    batten_status status = bat_points_check(d, count, points, options->closed ? 3 : 2);
    if (status == BATTEN_OK && options->joint == BATTEN_JOINT_GIVEN &&
        !(options->place > 0 && options->place < 1))
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "the place of the joints is %g; it must be between 0 and 1",
                          options->place);
    for (int i = 0; i < spans && status == BATTEN_OK; i++) {
        const int j = (i + 1) % count;
        const double l = bat_distance(d, points + i * d, points + j * d);
        if (l == 0)
            status = bat_fail(BATTEN_COINCIDENT, "points %d and %d coincide", i + 1, j + 1);
        else if (!isfinite(l))
            status = bat_fail(BATTEN_OVERFLOW,
                              "points %d and %d are too far apart for a number", i + 1, j + 1);
    }
    if (status == BATTEN_OK && options->directions)
        status = check_directions(d, count, options->directions);
    return status;
}

/* ---- the chain ---- */

typedef struct {
    int count; /* points */
    bool closed;
    const double *points;
    batten_chain_biarcs_options options;
    double *directions; /* [count][2] */
    batten_span *spans; /* 2 for each chord at most */
    int span_count;
    double *at; /* [count], arc length at the points */
    batten_chain_biarcs_report report;
} biarc_fit;

static double jump(const batten_span *a, const batten_span *b)
{
    return fabs(b->curvature[0] - a->curvature[0]);
}

static void add_arc(biarc_fit *w, const batten_span *arc, double turn)
{
    batten_chain_biarcs_report *r = &w->report;
    const double k = fabs(arc->curvature[0]);
    r->arcs += k > 0;
    r->lines += k == 0;
    r->long_arcs += fabs(turn) > BAT_PI;
    r->least_radius = bat_min(r->least_radius, k > 0 ? 1 / k : HUGE_VAL);
    if (w->span_count > 0)
        r->largest_jump = bat_max(r->largest_jump, jump(&w->spans[w->span_count - 1], arc));
    w->spans[w->span_count++] = *arc;
}

static void add_arcs(biarc_fit *w, const batten_biarc *made)
{
    for (int i = 0; i < made->count; i++)
        add_arc(w, &made->arcs[i], made->turn[i]);
}

static batten_status add_span(biarc_fit *w, int i, double *length)
{
    const int j = (i + 1) % w->count;
    const double *a = w->points + 2 * i, *b = w->points + 2 * j;
    batten_biarc made;
    const batten_status status = batten_biarc_between(
        (batten_ray){a, w->directions + 2 * i}, (batten_ray){b, w->directions + 2 * j},
        w->options.joint, w->options.place, &made);
    if (status != BATTEN_OK)
        return bat_fail(status, "between points %d and %d: %s", i + 1, j + 1, batten_message());
    double end[2];
    bat_arc_at(&made.arcs[made.count - 1], made.arcs[made.count - 1].length, end);
    w->report.error = bat_max(w->report.error, bat_distance(2, end, b));
    add_arcs(w, &made);
    for (int k = 0; k < made.count; k++)
        *length += made.arcs[k].length;
    return BATTEN_OK;
}

/* Ends of arcs are within rounding of their points: of coordinates, chords and radii. */
static double rounding(const biarc_fit *w)
{
    double largest = bat_largest(2 * w->count, w->points), radius = 0;
    for (int i = 0; i < w->span_count; i++) {
        const double k = fabs(w->spans[i].curvature[0]);
        radius = bat_max(radius, k > 0 ? bat_min(1 / k, w->spans[i].length) : 0);
        largest = bat_max(largest, w->spans[i].length);
    }
    return 64 * DBL_EPSILON * (largest + radius);
}

static batten_status make_spans(biarc_fit *w)
{
    const int n = w->count, spans = w->closed ? n : n - 1;
    double length = 0;
    batten_status status = BATTEN_OK;
    w->report.least_radius = HUGE_VAL;
    for (int i = 0; i < spans && status == BATTEN_OK; i++) {
        w->at[i] = length;
        status = add_span(w, i, &length);
    }
    if (status != BATTEN_OK)
        return status;
    if (!w->closed)
        w->at[n - 1] = length;
    else
        w->report.largest_jump =
            bat_max(w->report.largest_jump, jump(&w->spans[w->span_count - 1], &w->spans[0]));
    return BATTEN_OK;
}

static batten_status reserve(biarc_fit *w)
{
    const size_t n = (size_t)w->count;
    w->directions = bat_array3(n, 2, sizeof *w->directions);
    w->spans = bat_array3(n, 2, sizeof *w->spans);
    w->at = bat_array(n, sizeof *w->at);
    if (!w->directions || !w->spans || !w->at)
        return BATTEN_OUT_OF_MEMORY;
    if (!w->options.directions)
        return bat_circle_directions(2, w->count, w->points, w->closed, w->directions);
    memcpy(w->directions, w->options.directions, 2 * n * sizeof *w->directions);
    return BATTEN_OK;
}

static void copy_biarc_report(const biarc_fit *w, double *parameters,
                              batten_chain_biarcs_report *report)
{
    if (parameters)
        memcpy(parameters, w->at, (size_t)w->count * sizeof *parameters);
    if (report)
        *report = w->report;
}

batten_status batten_chain_biarcs(batten_points points,
                                  const batten_chain_biarcs_options *options,
                                  double *parameters, batten_chain_biarcs_report *report,
                                  batten_chain **out)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    assert(points.at && out);
    batten_chain_biarcs_options chosen = batten_chain_biarcs_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_chain_biarcs_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    biarc_fit w = {.count = points.count, .points = points.at, .options = chosen};
    w.closed = w.options.closed;
    status = bat_biarcs_check(2, points.count, points.at, &w.options);
    if (status != BATTEN_OK)
        return status;
    status = reserve(&w);
    if (status == BATTEN_OK)
        status = make_spans(&w);
    if (status == BATTEN_OK)
        status = batten_chain_create(
            &(batten_chain_parts){2, w.span_count, w.spans, NULL, w.closed}, rounding(&w), out);
    if (status == BATTEN_OK)
        copy_biarc_report(&w, parameters, report);
    bat_release(w.directions);
    bat_release(w.spans);
    bat_release(w.at);
    return status;
}

/* ---- arcs on one circle ---- */

/* One arc in the place of two neighbours, when its ends are within `tolerance` of theirs and
 * the point between them is that near to it. */
static bool merge(batten_span *a, const batten_span *b, double tolerance)
{
    const double turn = a->curvature[0] * a->length + b->curvature[0] * b->length;
    double end[2], middle[2], new_end[2];
    if (a->curvature[0] * b->curvature[0] < 0 || !(fabs(turn) < 2 * BAT_PI * (1 - 0x1p-20)))
        return false;
    bat_arc_at(b, b->length, end);
    const double chord[2] = {end[0] - a->start[0], end[1] - a->start[1]};
    const double c = bat_norm(2, chord), length = a->length + b->length;
    if (!(c > 0))
        return false;
    batten_span one;
    bat_arc_span(a->start, c, bat_atan2(chord[1], chord[0]), turn / 2, &one);
    batten_span part = one;
    part.length = a->length / length * one.length;
    bat_arc_at(&part, part.length, middle);
    bat_arc_at(&one, one.length, new_end);
    if (!(fabs(bat_sin((one.angle - a->angle) / 2)) * length <= tolerance &&
          bat_distance(2, middle, b->start) <= tolerance &&
          bat_distance(2, new_end, end) <= tolerance))
        return false;
    *a = one;
    return true;
}

batten_status batten_chain_merge_arcs(const batten_chain *chain, double tolerance,
                                      batten_chain **out)
{
    assert(chain && out);
    if (!(tolerance >= 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g; it must be 0 or more",
                        tolerance);
    batten_frame frame;
    if (!batten_chain_is_arcs(chain) || batten_chain_frame(chain, &frame))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "only a chain of arcs in the plane has arcs to merge");
    const int n = batten_chain_span_count(chain);
    const double *breaks = batten_chain_breaks(chain);
    batten_span *spans = bat_array((size_t)n, sizeof *spans);
    double *kept = bat_array((size_t)n + 1, sizeof *kept);
    if (!spans || !kept) {
        bat_release(spans);
        bat_release(kept);
        return BATTEN_OUT_OF_MEMORY;
    }
    double scale = 0;
    for (int i = 0; i < n; i++) {
        const batten_span *span = batten_chain_span(chain, i);
        scale = bat_max(scale, bat_max(bat_largest(2, span->start), span->length));
    }
    const double allowed = bat_max(tolerance, 64 * DBL_EPSILON * scale);
    int count = 0;
    kept[0] = breaks[0];
    for (int i = 0; i < n; i++) {
        const batten_span *span = batten_chain_span(chain, i);
        if (count == 0 || !merge(&spans[count - 1], span, allowed))
            spans[count++] = *span;
        kept[count] = breaks[i + 1];
    }
    const batten_status status = batten_chain_create(
        &(batten_chain_parts){2, count, spans, kept, batten_chain_is_closed(chain)},
        8 * allowed, out);
    bat_release(spans);
    bat_release(kept);
    return status;
}
