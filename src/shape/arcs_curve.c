/* A curve as few arcs: from corner to corner the longest that stays in the band, and again. */
#include "numeric/vector.h"
#include "shape/arcs.h"
#include <batten/inspect.h>

#include <stdlib.h>
#include <string.h>

/* The curve with the places between which curvature is monotone, and those where it is not
 * smooth. */
typedef struct {
    const batten_curve *curve;
    batten_interval domain;
    double scale; /* largest coordinate */
    double speed; /* the average */
    bool closed, smooth_seam;
    int station_count;
    double *stations;
    int corner_count;
    double *corners; /* with both ends */
} path;

typedef struct {
    const path *path;
    batten_arcs_options options;
    batten_arcs_side side; /* LEFT, RIGHT or EITHER */
    double slack;          /* what rounding does to a distance */
    /* Of the piece between two corners: */
    double from, to;
    bat_band band;
    double guess; /* of a step, as a parameter */
    int first;    /* of its parts in the list */
    bat_arcs_list list;
    bat_samples samples;
} task;

/* ---- directions ---- */

/* Where derivatives vanish the direction is the limit. */
static batten_status direction_at(const path *p, double u, batten_side side, double row[4])
{
    batten_status status = batten_curve_evaluate_side(p->curve, u, side, 1, row);
    /* Below a millionth of the average a derivative may be rounding; then it is looked at. */
    if (status != BATTEN_OK || bat_norm(2, row + 2) > 1e-6 * p->speed) {
        if (status == BATTEN_OK)
            bat_direction(2, row + 2, row + 2);
        return status;
    }
    batten_curve_local local = {.tangent = {0, 0, 0}};
    status = batten_curve_local_at(p->curve, u, side, &local);
    row[2] = local.tangent.x;
    row[3] = local.tangent.y;
    if (status == BATTEN_SINGULAR_HERE && bat_largest(2, row + 2) > 0)
        return BATTEN_OK;
    return status;
}

/* ---- where the curve is cut and looked at ---- */

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int unique(int count, double *values)
{
    int kept = 0;
    qsort(values, (size_t)count, sizeof *values, by_value);
    for (int i = 0; i < count; i++)
        if (kept == 0 || values[i] > values[kept - 1])
            values[kept++] = values[i];
    return kept;
}

/* Knots, inflections, extremes of curvature. */
static batten_status find_stations(path *p)
{
    batten_parameters bends = {0, NULL}, extremes = {0, NULL};
    batten_status status = batten_curve_inflections(p->curve, &bends);
    if (status == BATTEN_OK)
        status = batten_curve_curvature_extrema(p->curve, &extremes);
    const int knots = batten_curve_spans(p->curve, NULL);
    if (status == BATTEN_OK) {
        /* Between any two of these there may be a place where the speed is least. */
        p->stations =
            bat_array(2 * ((size_t)knots + (size_t)bends.count + (size_t)extremes.count),
                      sizeof *p->stations);
        status = p->stations ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK) {
        batten_curve_spans(p->curve, p->stations);
        for (int i = 0; i < bends.count; i++)
            p->stations[knots + i] = bends.at[i];
        for (int i = 0; i < extremes.count; i++)
            p->stations[knots + bends.count + i] = extremes.at[i];
        p->station_count = unique(knots + bends.count + extremes.count, p->stations);
    }
    bat_release(bends.at);
    bat_release(extremes.at);
    return status;
}

/* Half the rate of the squared speed. */
static batten_status speeding(const path *p, double u, double *rate, double *speed)
{
    double row[6];
    const batten_status status = batten_curve_evaluate(p->curve, u, 2, row);
    *rate = bat_dot(2, row + 2, row + 4);
    *speed = bat_norm(2, row + 2);
    return status;
}

/* The place in [a, b] where the speed is least, by halving; NaN when it is rising or falling
 * throughout, or when the curve does not come to rest there. */
static batten_status find_rest(const path *p, double a, double b, double *at)
{
    double rate = 0, speed = 0;
    *at = NAN;
    batten_status status = speeding(p, a + 1e-6 * (b - a), &rate, &speed);
    if (status != BATTEN_OK || rate >= 0)
        return status;
    status = speeding(p, b - 1e-6 * (b - a), &rate, &speed);
    if (status != BATTEN_OK || rate <= 0)
        return status;
    for (int i = 0; i < 60 && status == BATTEN_OK; i++) {
        const double middle = a + (b - a) / 2;
        status = speeding(p, middle, &rate, &speed);
        *(rate < 0 ? &a : &b) = middle;
    }
    /* Near a cusp speed grows as the distance in u: rounding leaves about the root of eps. */
    if (speed <= 1e-7 * p->speed)
        *at = a + (b - a) / 2;
    return status;
}

static batten_status add_rests(path *p)
{
    const int n = p->station_count;
    int count = n;
    for (int i = 0; i + 1 < n; i++) {
        double at = NAN;
        const batten_status status = find_rest(p, p->stations[i], p->stations[i + 1], &at);
        if (status != BATTEN_OK)
            return status;
        if (!isnan(at))
            p->stations[count++] = at;
    }
    p->station_count = unique(count, p->stations);
    return BATTEN_OK;
}

static batten_status is_corner(const path *p, double before, double after, double allowed,
                               bool *corner)
{
    double in[4], out[4];
    batten_status status = direction_at(p, before, BATTEN_FROM_LEFT, in);
    if (status == BATTEN_OK)
        status = direction_at(p, after, BATTEN_FROM_RIGHT, out);
    if (status == BATTEN_OK)
        *corner = fabs(bat_turn(in + 2, out + 2)) > allowed;
    return status;
}

static batten_status find_corners(path *p, double allowed)
{
    const int n = p->station_count;
    p->corners = bat_array((size_t)n, sizeof *p->corners);
    if (!p->corners)
        return BATTEN_OUT_OF_MEMORY;
    p->corners[p->corner_count++] = p->domain.a;
    for (int i = 1; i + 1 < n; i++) {
        bool corner = false;
        const batten_status status =
            is_corner(p, p->stations[i], p->stations[i], allowed, &corner);
        if (status != BATTEN_OK)
            return status;
        if (corner)
            p->corners[p->corner_count++] = p->stations[i];
    }
    p->corners[p->corner_count++] = p->domain.b;
    bool corner = false;
    p->closed = batten_curve_is_closed(p->curve, 16 * DBL_EPSILON * p->scale);
    const batten_status status = is_corner(p, p->domain.b, p->domain.a, allowed, &corner);
    p->smooth_seam = p->closed && !corner && p->corner_count == 2;
    return status;
}

static batten_status path_make(const batten_curve *curve, double corner, path *p)
{
    *p = (path){.curve = curve, .domain = batten_curve_domain(curve)};
    const batten_box box = batten_curve_box(curve);
    const double span[2] = {box.high.x - box.low.x, box.high.y - box.low.y};
    p->scale = bat_max(bat_max(fabs(box.low.x), fabs(box.high.x)),
                       bat_max(fabs(box.low.y), fabs(box.high.y)));
    p->speed = bat_norm(2, span) / (p->domain.b - p->domain.a);
    if (bat_norm(2, span) <= 16 * DBL_EPSILON * p->scale)
        return bat_fail(BATTEN_SINGULAR_HERE, "the curve is a point");
    if (!isfinite(bat_norm(2, span)))
        return bat_fail(BATTEN_OVERFLOW, "the curve is too large for a number");
    batten_status status = find_stations(p);
    if (status == BATTEN_OK)
        status = add_rests(p);
    if (status == BATTEN_OK)
        status = find_corners(p, corner);
    return status;
}

static void path_end(path *p)
{
    bat_release(p->stations);
    bat_release(p->corners);
}

/* ---- samples ---- */

/* The first station after u. */
static int station_after(const path *p, double u)
{
    int low = 0, high = p->station_count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (p->stations[middle] > u)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* Both ends, the stations between, and `inner` places or more between these: `total` in all at
 * least. */
static batten_status take_samples(const path *p, double a, double b, int inner, int total,
                                  bat_samples *samples)
{
    const int first = station_after(p, a);
    int last = first;
    while (last < p->station_count && p->stations[last] < b)
        last++;
    const int parts = last - first + 1;
    const int each = bat_max_int(inner, total / parts) + 1;
    const int count = parts * each + 1;
    batten_status status = bat_samples_reserve(samples, count);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < parts; i++) {
        const double low = i == 0 ? a : p->stations[first + i - 1];
        const double high = i + 1 == parts ? b : p->stations[first + i];
        for (int k = 0; k < each; k++)
            samples->u[i * each + k] = low + (high - low) * ((double)k / each);
    }
    samples->u[count - 1] = b;
    samples->count = count;
    status = batten_curve_evaluate_many(p->curve, (size_t)count, samples->u, 1, NULL,
                                        samples->rows[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(p->curve, b, BATTEN_FROM_LEFT, 1,
                                            samples->rows[count - 1]);
    return status;
}

/* By how much the curve turns along its samples, all small turns added. */
static double turn_of(const bat_samples *samples)
{
    double turn = 0;
    const double *before = NULL;
    for (int i = 0; i < samples->count; i++) {
        const double *d = samples->rows[i] + 2;
        if (d[0] == 0 && d[1] == 0)
            continue;
        if (before)
            turn += bat_turn(before, d);
        before = d;
    }
    return turn;
}

/* ---- deviations ---- */

/* The extreme between two samples where the slope changes its sign: by false position, the end
 * that stays counting half. */
static batten_status refine(const path *p, const bat_arcs_probe *probe, double a, double b,
                            double fa, double fb, bat_beside *beside)
{
    double row[4];
    for (int i = 0; i < 12; i++) {
        const double u = a + (b - a) * (fa / (fa - fb));
        if (!(u > a && u < b))
            break;
        const batten_status status = batten_curve_evaluate(p->curve, u, 1, row);
        if (status != BATTEN_OK)
            return status;
        const double f = bat_arcs_slope(probe, row), d = bat_arcs_beside(probe, row);
        if (d < beside->low) {
            beside->low = d;
            beside->low_at = u;
        }
        if (d > beside->high) {
            beside->high = d;
            beside->high_at = u;
        }
        if (f == 0 || b - a < 1e-9 * (fabs(a) + fabs(b)))
            break;
        if ((f > 0) == (fa > 0)) {
            a = u;
            fa = f;
            fb /= 2;
        } else {
            b = u;
            fb = f;
            fa /= 2;
        }
    }
    return BATTEN_OK;
}

/* The extremes among the samples and at all roots of the slope between them. */
static batten_status measure(const path *p, const batten_biarc *biarc,
                             const bat_samples *samples, bat_beside *beside)
{
    bat_arcs_probe probe;
    bat_arcs_probe_make(biarc, &probe);
    *beside = bat_arcs_beside_samples(&probe, samples);
    double before = bat_arcs_slope(&probe, samples->rows[0]);
    for (int i = 1; i < samples->count; i++) {
        const double slope = bat_arcs_slope(&probe, samples->rows[i]);
        if ((slope > 0 && before < 0) || (slope < 0 && before > 0)) {
            const batten_status status =
                refine(p, &probe, samples->u[i - 1], samples->u[i], before, slope, beside);
            if (status != BATTEN_OK)
                return status;
        }
        before = slope;
    }
    return BATTEN_OK;
}

/* ---- one arc or biarc ---- */

/* The node at u of the piece: at its ends on the curve, unless it closes smoothly; else in the
 * middle of the band. */
static batten_status node_at(const task *t, double u, bat_node *node)
{
    double row[4];
    const batten_status status =
        direction_at(t->path, u, u == t->to ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, row);
    if (status != BATTEN_OK)
        return status;
    const bool held = (u == t->from || u == t->to) && !t->path->smooth_seam;
    const double off = held ? 0 : t->band.middle;
    node->direction[0] = row[2];
    node->direction[1] = row[3];
    node->point[0] = row[0] - off * row[3];
    node->point[1] = row[1] + off * row[2];
    return BATTEN_OK;
}

/* The part from a to u: how much of the band it takes, BAT_ARCS_REFUSED when there is none. */
static batten_status try_part(task *t, const bat_node *a, double from, double to,
                              bat_arcs_part *part, bat_node *b, double *share)
{
    batten_status status = take_samples(t->path, from, to, 4, 16, &t->samples);
    if (status == BATTEN_OK)
        status = node_at(t, to, b);
    if (status != BATTEN_OK)
        return status;
    const double turn = turn_of(&t->samples);
    *part = (bat_arcs_part){.from = from, .to = to};
    *share = BAT_ARCS_REFUSED;
    if (fabs(turn) > BAT_PI * (1 + 1e-9))
        return BATTEN_OK;
    const bool made = t->options.joined == BATTEN_ARCS_SMOOTH
                          ? bat_arcs_biarc(a, b, turn, t->options.least_radius, &t->band,
                                           &t->samples, &part->biarc)
                          : bat_arcs_single(a, b, turn, t->options.least_radius, &t->band,
                                            &t->samples, &part->biarc);
    bat_beside beside;
    if (!made)
        return BATTEN_OK;
    status = measure(t->path, &part->biarc, &t->samples, &beside);
    *share = bat_band_share(&t->band, &beside, t->slack);
    return status;
}

/* Where plain arcs are nearly straight, lines. */
static batten_status prefer_line(task *t, const bat_node *a, const bat_node *b,
                                 bat_arcs_part *part)
{
    batten_biarc line;
    bat_beside beside;
    if (t->options.joined != BATTEN_ARCS_PLAIN)
        return BATTEN_OK;
    batten_status status = take_samples(t->path, part->from, part->to, 4, 16, &t->samples);
    bat_arcs_line(a, b, &line);
    if (status == BATTEN_OK)
        status = measure(t->path, &line, &t->samples, &beside);
    if (status == BATTEN_OK && bat_band_share(&t->band, &beside, t->slack) <= 1)
        part->biarc = line;
    return status;
}

static batten_status nothing_fits(const task *t, double u)
{
    batten_curve_local local = {.curvature = 0};
    const batten_status status =
        batten_curve_local_at(t->path->curve, u, BATTEN_FROM_RIGHT, &local);
    if (status == BATTEN_OUT_OF_MEMORY)
        return status;
    const double tolerance = t->band.high - t->band.low;
    return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                    "at %g, where the radius of the curve is %g, no arcs with radii of %g and "
                    "more stay within a band %g wide",
                    u, 1 / fabs(local.curvature), t->options.least_radius, tolerance);
}

/* The longest part from a: between a step that is good and one that is not, guided by the third
 * power by which errors grow. */
static batten_status longest(task *t, const bat_node *a, double from, bat_arcs_part *best,
                             bat_node *end, double *reach)
{
    double good = from, bad = HUGE_VAL, good_share = 0;
    double u = bat_min(t->to, from + t->guess);
    for (int i = 0; i < 200; i++) {
        bat_arcs_part part;
        bat_node b;
        double share = 0;
        const batten_status status = try_part(t, a, from, u, &part, &b, &share);
        if (status != BATTEN_OK)
            return status;
        if (share <= 1) {
            good = u;
            good_share = share;
            *best = part;
            *end = b;
        } else {
            bad = u;
        }
        const double factor =
            share < BAT_ARCS_REFUSED ? cbrt(0.9997 / bat_max(share, 1e-6)) : 0.5;
        const double wanted = from + (u - from) * factor;
        if (good == t->to || (isfinite(bad) && good > from &&
                              (bad - good <= 1e-3 * (good - from) || good_share > 0.998)))
            break;
        if (isinf(bad))
            u = bat_min(t->to, bat_max(wanted, from + 1.1 * (good - from)));
        else if (wanted > good + 1e-4 * (bad - good) && wanted < bad - 1e-4 * (bad - good))
            u = wanted;
        else
            u = good + (bad - good) / 2;
        if (!(u > from) || (isfinite(bad) && bad - from <= 1e-9 * (t->to - t->from)))
            return nothing_fits(t, from);
    }
    if (!(good > from))
        return nothing_fits(t, from);
    /* How far the last one would have gone. */
    *reach = good_share > 0 ? (good - from) * cbrt(1 / good_share) : HUGE_VAL;
    t->guess = good - from;
    return BATTEN_OK;
}

static batten_status greedy(void *context, double tolerance, int *count, double *last)
{
    task *t = context;
    double u = t->from, reach = 0;
    bat_node a, b;
    t->band = bat_band_of(t->side, tolerance);
    t->list.count = t->first;
    t->guess = t->to - t->from;
    batten_status status = node_at(t, u, &a);
    while (status == BATTEN_OK && u < t->to) {
        bat_arcs_part part;
        const double from = u;
        status = longest(t, &a, u, &part, &b, &reach);
        if (status == BATTEN_OK)
            status = prefer_line(t, &a, &b, &part);
        if (status == BATTEN_OK)
            status = bat_arcs_list_add(&t->list, &part);
        if (status != BATTEN_OK)
            return status;
        u = part.to;
        a = b;
        *last = bat_min(1, (u - from) / reach);
    }
    *count = t->list.count - t->first;
    return status;
}

/* ---- pieces that are one arc or circle ---- */

/* A whole circle as its halves; else one arc through its middle. */
static batten_status try_whole(task *t, bool *done)
{
    const path *p = t->path;
    bat_node a, b;
    bat_beside beside;
    bat_arcs_part part = {.from = t->from, .to = t->to};
    t->band = bat_band_of(t->side, t->options.tolerance);
    batten_status status = take_samples(p, t->from, t->to, 4, 24, &t->samples);
    if (status == BATTEN_OK)
        status = node_at(t, t->from, &a);
    if (status == BATTEN_OK)
        status = node_at(t, t->to, &b);
    if (status != BATTEN_OK || p->smooth_seam)
        return status;
    const double turn = turn_of(&t->samples);
    if (!bat_arcs_single(&a, &b, turn, t->options.least_radius, &t->band, &t->samples,
                         &part.biarc))
        return BATTEN_OK;
    status = measure(p, &part.biarc, &t->samples, &beside);
    if (status != BATTEN_OK || bat_band_share(&t->band, &beside, t->slack) > 1)
        return status;
    status = prefer_line(t, &a, &b, &part);
    *done = status == BATTEN_OK;
    return status == BATTEN_OK ? bat_arcs_list_add(&t->list, &part) : status;
}

static batten_status run_piece(task *t)
{
    bool done = false;
    t->first = t->list.count;
    batten_status status = try_whole(t, &done);
    if (status == BATTEN_OK && !done)
        status = bat_arcs_spread(greedy, t, t->options.tolerance, t->options.spread);
    return status;
}

/* ---- the report ---- */

static void widen(batten_arcs_report *report, const bat_beside *beside)
{
    report->left = bat_max(report->left, beside->high);
    report->right = bat_max(report->right, -beside->low);
    const bool high = beside->high > -beside->low;
    const double largest = high ? beside->high : -beside->low;
    if (largest > report->deviation) {
        report->deviation = largest;
        report->at = high ? beside->high_at : beside->low_at;
    }
}

static batten_status measure_all(task *t, batten_arcs_report *report)
{
    for (int i = 0; i < t->list.count; i++) {
        const bat_arcs_part *part = &t->list.parts[i];
        bat_arcs_probe probe;
        bat_beside beside;
        batten_status status = take_samples(t->path, part->from, part->to, 16,
                                            64 * part->biarc.count, &t->samples);
        if (status == BATTEN_OK)
            status = measure(t->path, &part->biarc, &t->samples, &beside);
        if (status != BATTEN_OK)
            return status;
        widen(report, &beside);
        bat_arcs_probe_make(&part->biarc, &probe);
        beside = bat_arcs_beside_samples(&probe, &t->samples);
        report->sampled = bat_max(report->sampled, bat_max(beside.high, -beside.low));
    }
    return BATTEN_OK;
}

/* ---- the whole ---- */

/* Inside and outside, as the curve turns. */
static batten_status side_of(const path *p, const batten_arcs_options *options,
                             bat_samples *samples, batten_arcs_side *side)
{
    *side = options->side;
    if (*side != BATTEN_ARCS_INSIDE && *side != BATTEN_ARCS_OUTSIDE)
        return BATTEN_OK;
    if (!p->closed)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve that is not closed has no inside");
    const batten_status status = take_samples(p, p->domain.a, p->domain.b, 8, 64, samples);
    double area = 0;
    for (int i = 0; status == BATTEN_OK && i + 1 < samples->count; i++) {
        const double *o = samples->rows[0], *a = samples->rows[i], *b = samples->rows[i + 1];
        area += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    }
    const bool inside_is_left = area > 0;
    *side = inside_is_left == (options->side == BATTEN_ARCS_INSIDE) ? BATTEN_ARCS_LEFT
                                                                    : BATTEN_ARCS_RIGHT;
    return status;
}

static batten_status run_all(task *t, batten_arcs_report *report, batten_chain **out)
{
    const path *p = t->path;
    batten_status status = side_of(p, &t->options, &t->samples, &t->side);
    for (int i = 0; i + 1 < p->corner_count && status == BATTEN_OK; i++) {
        t->from = p->corners[i];
        t->to = p->corners[i + 1];
        status = run_piece(t);
    }
    if (status == BATTEN_OK)
        status = measure_all(t, report);
    if (status == BATTEN_OK)
        status = bat_arcs_chain(&t->list, &t->options, p->closed, p->scale, report, out);
    return status;
}

batten_status batten_arcs_of_curve(const batten_curve *curve,
                                   const batten_arcs_options *options,
                                   batten_arcs_report *report, batten_chain **out)
{
    assert(curve && options && out);
    batten_status status = bat_arcs_check(options);
    if (status != BATTEN_OK)
        return status;
    if (batten_curve_dimension(curve) != 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the curve has %d dimensions; arcs are for curves in the plane",
                        batten_curve_dimension(curve));
    path p;
    batten_arcs_report found = {0};
    status = path_make(curve, options->corner, &p);
    task t = {.path = &p, .options = *options, .slack = 32 * DBL_EPSILON * p.scale};
    if (status == BATTEN_OK)
        status = run_all(&t, &found, out);
    if (status == BATTEN_OK && report)
        *report = found;
    bat_arcs_list_end(&t.list);
    bat_samples_end(&t.samples);
    path_end(&p);
    return status;
}

batten_status batten_arcs_of_chain(const batten_chain *chain,
                                   const batten_arcs_options *options,
                                   batten_arcs_report *report, batten_chain **out)
{
    assert(chain && options && out);
    batten_status status = bat_arcs_check(options);
    batten_curve *curve = NULL;
    double error = 0;
    if (status == BATTEN_OK)
        status = batten_chain_to_curve(chain, options->tolerance / 100, &error, &curve);
    batten_arcs_options rest = *options;
    batten_arcs_report found;
    rest.tolerance -= error;
    if (status == BATTEN_OK)
        status = batten_arcs_of_curve(curve, &rest, &found, out);
    if (status == BATTEN_OK && report) {
        *report = found;
        report->deviation += error;
        report->sampled += error;
        report->left += error;
        report->right += error;
    }
    batten_curve_unref(curve);
    return status;
}
