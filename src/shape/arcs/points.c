/* Rows of points as few arcs: from point to point the longest that passes those between. */
#include "base/work.h"
#include "numeric/vector.h"
#include "shape/arcs/arcs.h"
#include "spline/data_check.h"

#include <string.h>

typedef struct {
    int count; /* points; of a closed row the first again at the end */
    const double *points;
    batten_arcs_options options;
    batten_arcs_side side;
    double slack;
    double *closed_points; /* [count][2], when the row is closed */
    double *directions;    /* [count][2] */
    bat_band band;
    bat_arcs_list list;
    bat_samples samples;
    bat_work work;
} point_fit;

static bat_node node_at(const point_fit *t, int i)
{
    const double *p = t->points + 2 * i, *d = t->directions + 2 * i;
    const bool held = (i == 0 || i == t->count - 1) && !t->options.closed;
    const double off = held ? 0 : t->band.middle;
    return (bat_node){{p[0] - off * d[1], p[1] + off * d[0]}, {d[0], d[1]}};
}

/* The points between two of them, and by how much the row turns from one direction to the
 * other. */
static batten_status take_samples(point_fit *t, int from, int to, double *turn)
{
    const int count = to - from - 1;
    const batten_status status = bat_samples_reserve(&t->samples, bat_max_int(count, 1));
    if (status != BATTEN_OK)
        return status;
    const double *before = t->directions + 2 * from;
    double chord[2], last[2];
    *turn = 0;
    t->samples.count = count;
    for (int i = from; i < to; i++) {
        const double *p = t->points + 2 * i;
        chord[0] = p[2] - p[0];
        chord[1] = p[3] - p[1];
        *turn += bat_turn(i == from ? before : last, chord);
        memcpy(last, chord, sizeof last);
        if (i > from) {
            t->samples.u[i - from - 1] = i;
            memcpy(t->samples.rows[i - from - 1], (double[4]){p[0], p[1], 0, 0},
                   sizeof t->samples.rows[0]);
        }
    }
    *turn += bat_turn(last, t->directions + 2 * to);
    return BATTEN_OK;
}

static double share_of(const point_fit *t, const batten_biarc *biarc)
{
    bat_arcs_probe probe;
    if (t->samples.count == 0)
        return 0;
    bat_arcs_probe_make(biarc, &probe);
    const bat_beside beside = bat_arcs_beside_samples(&probe, &t->samples);
    return bat_band_share(&t->band, &beside, t->slack);
}

static batten_status try_part(point_fit *t, int from, int to, bat_arcs_part *part,
                              double *share)
{
    const bat_node a = node_at(t, from), b = node_at(t, to);
    double turn = 0;
    const batten_status status = take_samples(t, from, to, &turn);
    if (status != BATTEN_OK)
        return status;
    *part = (bat_arcs_part){.from = from, .to = to};
    *share = BAT_ARCS_REFUSED;
    if (fabs(turn) > BAT_PI * (1 + 1e-9))
        return BATTEN_OK;
    const bool plain = t->options.joined == BATTEN_ARCS_PLAIN;
    const bat_arcs_stretch on = {&a, &b, turn, t->options.least_radius, &t->band, &t->samples};
    const bool made =
        plain ? bat_arcs_single(&on, &part->biarc) : bat_arcs_biarc(&on, &part->biarc);
    if (made)
        *share = share_of(t, &part->biarc);
    if (plain && made && *share <= 1) {
        batten_biarc line;
        bat_arcs_line(&a, &b, &line);
        if (share_of(t, &line) <= 1)
            part->biarc = line;
    }
    return BATTEN_OK;
}

/* Twice as far each time, then back by halves. */
static batten_status longest(point_fit *t, int from, bat_arcs_part *best, double *last)
{
    int good = from, bad = t->count, step = 1;
    double good_share = 0;
    while (bad - good > 1) {
        const int to =
            bad == t->count ? bat_min_int(t->count - 1, from + step) : good + (bad - good) / 2;
        bat_arcs_part part;
        double share = 0;
        batten_status status =
            bat_work_step(&t->work, 1, (double)from / t->count, "arcs through points");
        if (status == BATTEN_OK)
            status = try_part(t, from, to, &part, &share);
        if (status != BATTEN_OK)
            return status;
        if (share <= 1) {
            good = to;
            good_share = share;
            *best = part;
        } else {
            bad = to;
        }
        step *= 2;
    }
    char radii[BAT_RADII_TEXT];
    if (good == from)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "between points %d and %d no arcs%s stay within the tolerance",
                        from + 1, t->options.closed && from + 2 == t->count ? 1 : from + 2,
                        bat_arcs_of_least_radius(t->options.least_radius, radii));
    *last = good_share > 0 ? bat_min(1, bat_cbrt(good_share)) : 0;
    return BATTEN_OK;
}

static batten_status greedy(void *context, double tolerance, int *count, double *last)
{
    point_fit *t = context;
    t->band = bat_band_of(t->side, tolerance);
    t->list.count = 0;
    for (int i = 0; i < t->count - 1;) {
        bat_arcs_part part;
        batten_status status = longest(t, i, &part, last);
        if (status == BATTEN_OK)
            status = bat_arcs_list_add(&t->list, &part);
        if (status != BATTEN_OK)
            return status;
        i = (int)part.to;
    }
    *count = t->list.count;
    return BATTEN_OK;
}

/* ---- the report, and where the points are ---- */

/* How far along an arc its point nearest to another is. */
static double along(const batten_span *arc, const double *point)
{
    const double c = bat_cos(arc->angle), s = bat_sin(arc->angle), k = arc->curvature[0];
    const double x = point[0] - arc->start[0], y = point[1] - arc->start[1];
    const double ahead = x * c + y * s, left = y * c - x * s;
    double at = k == 0 ? ahead : bat_atan2(k * ahead, 1 - k * left) / k;
    /* Of more than a half circle the second half is behind. */
    if (at < -arc->length / 1e6 && fabs(k) * arc->length > BAT_PI)
        at += 2 * BAT_PI / fabs(k);
    return bat_max(0, bat_min(arc->length, at));
}

static double place_of(const batten_biarc *biarc, const double *point)
{
    const batten_span *second = &biarc->arcs[biarc->count - 1];
    const double ahead = (point[0] - second->start[0]) * bat_cos(second->angle) +
                         (point[1] - second->start[1]) * bat_sin(second->angle);
    if (biarc->count == 2 && ahead > 0)
        return biarc->arcs[0].length + along(second, point);
    return along(&biarc->arcs[0], point);
}

static void note_beside(double d, int at, batten_arcs_report *report)
{
    report->left = bat_max(report->left, d);
    report->right = bat_max(report->right, -d);
    if (fabs(d) > report->error) {
        report->error = fabs(d);
        report->at = at;
    }
}

static void measure_part(const point_fit *t, const bat_arcs_part *part,
                         batten_arcs_report *report)
{
    bat_arcs_probe probe;
    bat_arcs_probe_make(&part->biarc, &probe);
    for (int k = (int)part->from; k <= (int)part->to; k++)
        note_beside(bat_arcs_beside(&probe, t->points + 2 * k), k, report);
}

static void measure_all(const point_fit *t, double *parameters, batten_arcs_report *report)
{
    double length = 0;
    for (int i = 0; i < t->list.count; i++) {
        const bat_arcs_part *part = &t->list.parts[i];
        measure_part(t, part, report);
        for (int k = (int)part->from; k <= (int)part->to; k++)
            parameters[k] = length + place_of(&part->biarc, t->points + 2 * k);
        for (int k = 0; k < part->biarc.count; k++)
            length += part->biarc.arcs[k].length;
        parameters[(int)part->to] = length;
    }
    report->sampled = report->error;
}

/* ---- the whole ---- */

static batten_status prepare(point_fit *t, int count, const double *points)
{
    const size_t n = (size_t)count;
    const bool closed = t->options.closed;
    t->count = count + closed;
    t->points = points;
    t->directions = bat_array3(n + 1, 2, sizeof *t->directions);
    if (closed)
        t->closed_points = bat_array3(n + 1, 2, sizeof *t->closed_points);
    if (!t->directions || (closed && !t->closed_points))
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = bat_circle_directions(2, count, points, closed, t->directions);
    if (status == BATTEN_OK && closed) {
        memcpy(t->closed_points, points, 2 * n * sizeof *points);
        memcpy(t->closed_points + 2 * n, points, 2 * sizeof *points);
        memcpy(t->directions + 2 * n, t->directions, 2 * sizeof *points);
        t->points = t->closed_points;
    }
    return status;
}

static double twice_area(const point_fit *t)
{
    double area = 0;
    for (int i = 0; i + 1 < t->count; i++) {
        const double *o = t->points, *a = t->points + 2 * i;
        area += (a[0] - o[0]) * (a[3] - o[1]) - (a[1] - o[1]) * (a[2] - o[0]);
    }
    return area;
}

static batten_status find_side(point_fit *t)
{
    t->side = t->options.side;
    if (t->side != BATTEN_ARCS_INSIDE && t->side != BATTEN_ARCS_OUTSIDE)
        return BATTEN_OK;
    if (!t->options.closed)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a row that is not closed has no inside");
    t->side = (twice_area(t) > 0) == (t->side == BATTEN_ARCS_INSIDE) ? BATTEN_ARCS_LEFT
                                                                     : BATTEN_ARCS_RIGHT;
    return BATTEN_OK;
}

static batten_status run_all(point_fit *t, int count, double *parameters,
                             batten_arcs_report *report, batten_chain **out)
{
    double *at = bat_array((size_t)t->count, sizeof *at);
    if (!at)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = find_side(t);
    if (status == BATTEN_OK)
        status = bat_arcs_spread(greedy, t, t->options.tolerance, t->options.spread);
    if (status == BATTEN_OK) {
        measure_all(t, at, report);
        const bat_arcs_chain_task task = {&t->options, t->options.closed,
                                          bat_largest(2 * count, t->points)};
        status = bat_arcs_chain(&t->list, &task, report, out);
    }
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, at, (size_t)count * sizeof *parameters);
    bat_release(at);
    return status;
}

batten_status batten_arcs_from_points(batten_points points, const batten_arcs_options *options,
                                      double *parameters, batten_arcs_report *report,
                                      batten_chain **out)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    assert(points.at && options && out);
    batten_arcs_options chosen = batten_arcs_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_arcs_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    batten_chain_biarcs_options row = batten_chain_biarcs_defaults();
    row.closed = options->closed;
    status = bat_arcs_check(options);
    if (status == BATTEN_OK)
        status = bat_biarcs_check(2, points.count, points.at, &row);
    if (status != BATTEN_OK)
        return status;
    point_fit t = {.options = *options, .work = {.job = options->job}};
    batten_arcs_report found = {0};
    t.slack = 32 * DBL_EPSILON * bat_largest(2 * points.count, points.at);
    status = prepare(&t, points.count, points.at);
    if (status == BATTEN_OK)
        status = run_all(&t, points.count, parameters, &found, out);
    if (status == BATTEN_OK && report)
        *report = found;
    bat_arcs_list_end(&t.list);
    bat_samples_end(&t.samples);
    bat_release(t.directions);
    bat_release(t.closed_points);
    return status;
}
