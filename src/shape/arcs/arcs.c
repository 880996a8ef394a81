/* How far arcs are from a curve, single arcs fitted to it, and the chain that they make. */
#include "shape/arcs/arcs.h"
#include "numeric/vector.h"
#include "spline/chain/chain.h"

#include <string.h>

batten_arcs_options batten_arcs_defaults(void)
{
    return (batten_arcs_options){
        .size = sizeof(batten_arcs_options), .corner = 1e-6, .spread = true};
}

batten_status bat_arcs_check(const batten_arcs_options *options)
{
    const batten_arcs_options *o = options;
    if (!(o->tolerance > 0 && isfinite(o->tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g; it must be above 0",
                        o->tolerance);
    if (!(o->least_radius >= 0 && isfinite(o->least_radius)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the least radius is %g; it must be 0 or more",
                        o->least_radius);
    if (o->most < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d arcs at most; it must be 0 or more", o->most);
    if (!(o->corner >= 0 && isfinite(o->corner)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the angle of corners is %g; it must be 0 or more",
                        o->corner);
    return BATTEN_OK;
}

bat_band bat_band_of(batten_arcs_side side, double tolerance)
{
    if (side == BATTEN_ARCS_LEFT)
        return (bat_band){0, tolerance, tolerance / 2};
    if (side == BATTEN_ARCS_RIGHT)
        return (bat_band){-tolerance, 0, -tolerance / 2};
    return (bat_band){-tolerance, tolerance, 0};
}

double bat_band_share(const bat_band *band, const bat_beside *beside, double slack)
{
    const double half = (band->high - band->low) / 2 + slack;
    const double middle = (band->high + band->low) / 2;
    return bat_max(beside->high - middle, middle - beside->low) / half;
}

/* ---- samples ---- */

batten_status bat_samples_reserve(bat_samples *samples, int count)
{
    if (count <= samples->capacity)
        return BATTEN_OK;
    const size_t capacity = (size_t)count + (size_t)count / 2;
    double *u = bat_resize(samples->u, capacity, sizeof *u);
    if (!u)
        return BATTEN_OUT_OF_MEMORY;
    samples->u = u;
    double(*rows)[4] = bat_resize(samples->rows, capacity, sizeof *rows);
    if (!rows)
        return BATTEN_OUT_OF_MEMORY;
    samples->rows = rows;
    samples->capacity = (int)capacity;
    return BATTEN_OK;
}

void bat_samples_end(bat_samples *samples)
{
    bat_release(samples->u);
    bat_release(samples->rows);
}

/* ---- distances ---- */

void bat_arcs_probe_make(const batten_biarc *biarc, bat_arcs_probe *probe)
{
    probe->count = biarc->count;
    for (int i = 0; i < biarc->count; i++) {
        const batten_span *arc = &biarc->arcs[i];
        const double c = cos(arc->angle), s = sin(arc->angle);
        for (int k = 0; k < 2; k++) {
            probe->arcs[i].start[k] = arc->start[k];
            probe->arcs[i].T[k] = k ? s : c;
            probe->arcs[i].N[k] = k ? c : -s;
        }
        probe->arcs[i].k = arc->curvature[0];
    }
    memcpy(probe->joint, probe->arcs[biarc->count - 1].start, sizeof probe->joint);
    memcpy(probe->along, probe->arcs[biarc->count - 1].T, sizeof probe->along);
}

static int arc_of(const bat_arcs_probe *probe, const double point[2])
{
    const double ahead = (point[0] - probe->joint[0]) * probe->along[0] +
                         (point[1] - probe->joint[1]) * probe->along[1];
    return probe->count == 2 && ahead > 0;
}

/* With p from the start of the arc and q = k p.p - 2 p.N, the distance from the centre is
 * sqrt(1 + k q) / |k|; the difference from 1 / |k|, written so that it holds for k = 0. */
double bat_arcs_beside(const bat_arcs_probe *probe, const double point[2])
{
    const int i = arc_of(probe, point);
    const double k = probe->arcs[i].k, *N = probe->arcs[i].N;
    const double p[2] = {point[0] - probe->arcs[i].start[0],
                         point[1] - probe->arcs[i].start[1]};
    const double q = k * bat_dot(2, p, p) - 2 * bat_dot(2, p, N);
    return q / (1 + sqrt(bat_max(0, 1 + k * q)));
}

double bat_arcs_slope(const bat_arcs_probe *probe, const double row[4])
{
    const int i = arc_of(probe, row);
    const double k = probe->arcs[i].k, *N = probe->arcs[i].N;
    const double p[2] = {row[0] - probe->arcs[i].start[0], row[1] - probe->arcs[i].start[1]};
    return row[2] * (k * p[0] - N[0]) + row[3] * (k * p[1] - N[1]);
}

bat_beside bat_arcs_beside_samples(const bat_arcs_probe *probe, const bat_samples *samples)
{
    bat_beside beside = {HUGE_VAL, -HUGE_VAL, 0, 0};
    for (int i = 0; i < samples->count; i++) {
        const double d = bat_arcs_beside(probe, samples->rows[i]);
        if (d < beside.low) {
            beside.low = d;
            beside.low_at = samples->u[i];
        }
        if (d > beside.high) {
            beside.high = d;
            beside.high_at = samples->u[i];
        }
    }
    return beside;
}

/* ---- biarcs and arcs between nodes ---- */

static bool radius_allowed(const batten_biarc *biarc, double least)
{
    /* A radius is known to some roundings only. */
    for (int i = 0; i < biarc->count && least > 0; i++)
        if (fabs(biarc->arcs[i].curvature[0]) * least > 1 + 1e-12)
            return false;
    return true;
}

/* The chord between two nodes; false when there is none. */
static bool chord_of(const bat_node *a, const bat_node *b, double *l, double unit[2])
{
    *l = bat_distance(2, a->point, b->point);
    if (!(*l > 0 && isfinite(*l)))
        return false;
    unit[0] = (b->point[0] - a->point[0]) / *l;
    unit[1] = (b->point[1] - a->point[1]) / *l;
    return true;
}

/* How much of the band each arc takes, as the larger of both sides. */
static void shares_of(const batten_biarc *biarc, const bat_band *band,
                      const bat_samples *samples, double shares[2])
{
    const double middle = (band->high + band->low) / 2;
    bat_arcs_probe probe;
    bat_arcs_probe_make(biarc, &probe);
    shares[0] = shares[1] = 0;
    for (int i = 0; i < samples->count; i++) {
        const int k = arc_of(&probe, samples->rows[i]);
        const double d = fabs(bat_arcs_beside(&probe, samples->rows[i]) - middle);
        shares[k] = bat_max(shares[k], d);
    }
}

bool bat_arcs_biarc(const bat_node *a, const bat_node *b, double turn, double least_radius,
                    const bat_band *band, const bat_samples *samples, batten_biarc *out)
{
    enum { ROUNDS = 4 };
    double l, unit[2], place = 0.5, best = HUGE_VAL;
    if (!chord_of(a, b, &l, unit))
        return false;
    const double alpha = bat_turn(unit, a->direction), beta = bat_turn(unit, b->direction);
    /* Angles are taken up to a turn; a biarc that turns the other way does not count. */
    if (fabs(beta - alpha - turn) > 1e-3)
        return false;
    for (int i = 0; i < ROUNDS; i++) {
        batten_biarc made;
        double shares[2];
        if (bat_biarc_make(a->point, atan2(unit[1], unit[0]), l, alpha, beta, place, &made) !=
                BATTEN_OK ||
            made.is_long || !radius_allowed(&made, least_radius))
            break;
        shares_of(&made, band, samples, shares);
        const double larger = bat_max(shares[0], shares[1]);
        if (larger < best) {
            best = larger;
            *out = made;
        }
        /* The error of an arc goes by the third power of its length. */
        const double smaller = bat_min(shares[0], shares[1]);
        if (made.count == 1 || !(smaller > 0) || larger < 1.1 * smaller)
            break;
        const double ratio = place / (1 - place) * cbrt(shares[1] / shares[0]);
        place = bat_max(0.05, bat_min(0.95, ratio / (1 + ratio)));
    }
    return best < HUGE_VAL;
}

void bat_arcs_line(const bat_node *a, const bat_node *b, batten_biarc *out)
{
    const double l = bat_distance(2, a->point, b->point);
    *out = (batten_biarc){.count = 1, .place = 0.5};
    bat_arc_span(a->point, l, atan2(b->point[1] - a->point[1], b->point[0] - a->point[0]), 0,
                 &out->arcs[0]);
}

static void make_arc(const bat_node *a, double l, const double unit[2], double half,
                     batten_biarc *out)
{
    *out = (batten_biarc){.count = 1, .place = 0.5, .turn = {2 * half}};
    out->is_long = fabs(half) > BAT_PI / 2;
    bat_arc_span(a->point, l, atan2(unit[1], unit[0]), half, &out->arcs[0]);
}

/* When the arc bulges by 1 more in its middle, its place t along the chord moves by about
 * 4 t (1 - t): from what each sample still has to the band follows how far the bulge may move
 * either way. The middle of that range. */
static double better_bulge(const bat_arcs_probe *probe, const bat_samples *samples,
                           const bat_node *a, double l, const double unit[2],
                           const bat_band *band)
{
    double least = -HUGE_VAL, most = HUGE_VAL;
    for (int i = 0; i < samples->count; i++) {
        const double *p = samples->rows[i];
        const double t = ((p[0] - a->point[0]) * unit[0] + (p[1] - a->point[1]) * unit[1]) / l;
        const double share = 4 * t * (1 - t);
        if (!(share > 0.01))
            continue;
        const double d = bat_arcs_beside(probe, p);
        least = bat_max(least, (band->low - d) / share);
        most = bat_min(most, (band->high - d) / share);
    }
    return isfinite(least) && isfinite(most) ? least / 2 + most / 2 : 0;
}

bool bat_arcs_single(const bat_node *a, const bat_node *b, double turn, double least_radius,
                     const bat_band *band, const bat_samples *samples, batten_biarc *out)
{
    enum { ROUNDS = 4 };
    double l, unit[2];
    if (!chord_of(a, b, &l, unit) || !(fabs(turn) < 2 * BAT_PI))
        return false;
    /* Beyond a half circle the middle of the curve decides: there the bulge is no measure. */
    double half = turn / 2;
    if (fabs(turn) >= BAT_PI && samples->count > 0) {
        const double *m = samples->rows[samples->count / 2];
        const double in[2] = {m[0] - a->point[0], m[1] - a->point[1]};
        const double on[2] = {b->point[0] - m[0], b->point[1] - m[1]};
        if (bat_largest(2, in) > 0 && bat_largest(2, on) > 0)
            half = bat_turn(in, on);
    }
    make_arc(a, l, unit, half, out);
    for (int i = 0; i < ROUNDS && fabs(half) < BAT_PI / 2; i++) {
        bat_arcs_probe probe;
        bat_arcs_probe_make(out, &probe);
        const double by = better_bulge(&probe, samples, a, l, unit, band);
        /* An arc that turns left bulges to the right of its chord. */
        half = 2 * atan(tan(half / 2) - 2 * by / l);
        make_arc(a, l, unit, half, out);
        if (fabs(by) <= 0.01 * (band->high - band->low))
            break;
    }
    /* The turn of the curve may differ from that of the arc, but not by a loop. */
    return fabs(half) < 0.999 * BAT_PI && fabs(2 * half - turn) < BAT_PI &&
           radius_allowed(out, least_radius);
}

/* ---- the list ---- */

batten_status bat_arcs_list_add(bat_arcs_list *list, const bat_arcs_part *part)
{
    if (list->count == list->capacity) {
        const int capacity = bat_max_int(16, 2 * list->capacity);
        bat_arcs_part *parts = bat_resize(list->parts, (size_t)capacity, sizeof *parts);
        if (!parts)
            return BATTEN_OUT_OF_MEMORY;
        list->parts = parts;
        list->capacity = capacity;
    }
    list->parts[list->count++] = *part;
    return BATTEN_OK;
}

void bat_arcs_list_end(bat_arcs_list *list)
{
    bat_release(list->parts);
}

batten_status bat_arcs_spread(bat_arcs_run run, void *task, double tolerance, bool spread)
{
    enum { TRIALS = 12 };
    int count = 0, trial_count = 0;
    double last = 1;
    batten_status status = run(task, tolerance, &count, &last);
    if (status != BATTEN_OK || !spread || count < 1)
        return status;
    /* The error of a part goes by the third power of its length. */
    double good = tolerance, tried = tolerance;
    double bad = tolerance * pow(bat_max(count - 1, 0.3) / count, 3);
    double guess = tolerance * pow((count - 1 + last) / count, 3);
    for (int i = 0; i < TRIALS && good - bad > 0.02 * good; i++) {
        tried = guess > bad && guess < good ? guess : sqrt(good * bad);
        guess = 0;
        status = run(task, tried, &trial_count, &last);
        if (status == BATTEN_OUT_OF_MEMORY)
            return status;
        if (status == BATTEN_OK && trial_count <= count)
            good = tried;
        else
            bad = tried;
    }
    return tried == good ? BATTEN_OK : run(task, good, &count, &last);
}

/* ---- the chain ---- */

static void straighten(batten_span *arc, double rounding)
{
    const double k = arc->curvature[0], l = arc->length;
    if (k != 0 && fabs(k) * l * l / 8 <= rounding) {
        double end[2];
        bat_arc_at(arc, arc->length, end);
        bat_arc_span(arc->start, bat_distance(2, arc->start, end),
                     atan2(end[1] - arc->start[1], end[0] - arc->start[0]), 0, arc);
    }
}

static double end_angle(const batten_span *arc)
{
    return arc->angle + arc->curvature[0] * arc->length;
}

static void report_arcs(const batten_chain *chain, batten_arcs_report *report)
{
    const int n = batten_chain_span_count(chain);
    report->arcs = report->lines = 0;
    report->least_radius = HUGE_VAL;
    report->largest_turn = 0;
    for (int i = 0; i < n; i++) {
        const batten_span *arc = batten_chain_span(chain, i);
        const double k = fabs(arc->curvature[0]);
        report->arcs += k > 0;
        report->lines += k == 0;
        report->least_radius = bat_min(report->least_radius, k > 0 ? 1 / k : HUGE_VAL);
        if (i + 1 == n && !batten_chain_is_closed(chain))
            break;
        const double turn = batten_chain_span(chain, (i + 1) % n)->angle - end_angle(arc);
        report->largest_turn = bat_max(report->largest_turn, fabs(remainder(turn, 2 * BAT_PI)));
    }
}

static batten_status check_number(const batten_arcs_options *options,
                                  const batten_arcs_report *report)
{
    const int needed = report->arcs + report->lines;
    if (options->most > 0 && needed > options->most)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "%d arcs and lines are needed within %g; %d are allowed", needed,
                        options->tolerance, options->most);
    return BATTEN_OK;
}

batten_status bat_arcs_chain(const bat_arcs_list *list, const batten_arcs_options *options,
                             bool closed, double scale, batten_arcs_report *report,
                             batten_chain **out)
{
    const double rounding = 4 * DBL_EPSILON * scale;
    batten_span *spans = bat_array3((size_t)list->count, 2, sizeof *spans);
    batten_chain *chain = NULL, *merged = NULL;
    int count = 0;
    if (!spans)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < list->count; i++)
        for (int k = 0; k < list->parts[i].biarc.count; k++) {
            spans[count] = list->parts[i].biarc.arcs[k];
            straighten(&spans[count++], rounding);
        }
    batten_status status = batten_chain_create(
        &(batten_chain_parts){2, count, spans, NULL, closed}, 32 * rounding, &chain);
    bat_release(spans);
    if (status == BATTEN_OK)
        status = batten_chain_merge_arcs(chain, 0, &merged);
    if (status == BATTEN_OK) {
        report_arcs(merged, report);
        status = check_number(options, report);
    }
    batten_chain_unref(chain);
    if (status == BATTEN_OK)
        *out = merged;
    else
        batten_chain_unref(merged);
    return status;
}
