/* How far arcs are from a curve, single arcs fitted to it, and the list of them. */
#include "shape/arcs/arcs.h"
#include "base/list.h"
#include "numeric/vector.h"

#include <batten/text.h>
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

const char *bat_arcs_of_least_radius(double least, char text[static BAT_RADII_TEXT])
{
    text[0] = '\0';
    if (least > 0)
        batten_text_print(text, BAT_RADII_TEXT, " with radii of %g and more", least);
    return text;
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
        const double c = bat_cos(arc->angle), s = bat_sin(arc->angle);
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

void bat_beside_widen(bat_beside *beside, double u, double d)
{
    if (d < beside->low) {
        beside->low = d;
        beside->low_at = u;
    }
    if (d > beside->high) {
        beside->high = d;
        beside->high_at = u;
    }
}

bat_beside bat_arcs_beside_samples(const bat_arcs_probe *probe, const bat_samples *samples)
{
    bat_beside beside = {HUGE_VAL, -HUGE_VAL, 0, 0};
    for (int i = 0; i < samples->count; i++) {
        const double d = bat_arcs_beside(probe, samples->rows[i]);
        bat_beside_widen(&beside, samples->u[i], d);
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

/* The chord between two nodes, and its direction; false when there is none. */
static bool chord_of(const bat_arcs_stretch *on, bat_arc_chord *chord, double unit[2])
{
    const double *a = on->from->point, *b = on->to->point, l = bat_distance(2, a, b);
    if (!(l > 0 && isfinite(l)))
        return false;
    unit[0] = (b[0] - a[0]) / l;
    unit[1] = (b[1] - a[1]) / l;
    *chord = (bat_arc_chord){{a[0], a[1]}, bat_atan2(unit[1], unit[0]), l};
    return true;
}

/* How much of the band each arc takes, as the larger of both sides. */
static void shares_of(const batten_biarc *biarc, const bat_arcs_stretch *on, double shares[2])
{
    const double middle = (on->band->high + on->band->low) / 2;
    bat_arcs_probe probe;
    bat_arcs_probe_make(biarc, &probe);
    shares[0] = shares[1] = 0;
    for (int i = 0; i < on->samples->count; i++) {
        const double *row = on->samples->rows[i];
        const int k = arc_of(&probe, row);
        const double d = fabs(bat_arcs_beside(&probe, row) - middle);
        shares[k] = bat_max(shares[k], d);
    }
}

bool bat_arcs_biarc(const bat_arcs_stretch *on, batten_biarc *out)
{
    enum { ROUNDS = 4 };
    bat_arc_chord chord;
    double unit[2], place = 0.5, best = HUGE_VAL;
    if (!chord_of(on, &chord, unit))
        return false;
    const double alpha = bat_turn(unit, on->from->direction);
    const double beta = bat_turn(unit, on->to->direction);
    /* Angles are taken up to a turn; a biarc that turns the other way does not count. */
    if (fabs(beta - alpha - on->turn) > 1e-3)
        return false;
    for (int i = 0; i < ROUNDS; i++) {
        batten_biarc made;
        double shares[2];
        if (bat_biarc_make(&chord, alpha, beta, place, &made) != BATTEN_OK || made.is_long ||
            !radius_allowed(&made, on->least_radius))
            break;
        shares_of(&made, on, shares);
        const double larger = bat_max(shares[0], shares[1]);
        if (larger < best) {
            best = larger;
            *out = made;
        }
        /* The error of an arc goes by the third power of its length. */
        const double smaller = bat_min(shares[0], shares[1]);
        if (made.count == 1 || !(smaller > 0) || larger < 1.1 * smaller)
            break;
        const double ratio = place / (1 - place) * bat_cbrt(shares[1] / shares[0]);
        place = bat_max(0.05, bat_min(0.95, ratio / (1 + ratio)));
    }
    return best < HUGE_VAL;
}

void bat_arcs_line(const bat_node *a, const bat_node *b, batten_biarc *out)
{
    const double l = bat_distance(2, a->point, b->point);
    *out = (batten_biarc){.count = 1, .place = 0.5};
    bat_arc_span(a->point, l, bat_atan2(b->point[1] - a->point[1], b->point[0] - a->point[0]),
                 0, &out->arcs[0]);
}

static void make_arc(const bat_arc_chord *chord, double half, batten_biarc *out)
{
    *out = (batten_biarc){.count = 1, .place = 0.5, .turn = {2 * half}};
    out->is_long = fabs(half) > BAT_PI / 2;
    bat_arc_span(chord->start, chord->length, chord->angle, half, &out->arcs[0]);
}

/* When the arc bulges by 1 more in its middle, its place t along the chord moves by about
 * 4 t (1 - t): from what each sample still has to the band follows how far the bulge may move
 * either way. The middle of that range. */
static double better_bulge(const bat_arcs_probe *probe, const bat_arcs_stretch *on,
                           const bat_arc_chord *chord, const double unit[2])
{
    const bat_samples *samples = on->samples;
    const double *a = chord->start, l = chord->length;
    double least = -HUGE_VAL, most = HUGE_VAL;
    for (int i = 0; i < samples->count; i++) {
        const double *p = samples->rows[i];
        const double t = ((p[0] - a[0]) * unit[0] + (p[1] - a[1]) * unit[1]) / l;
        const double share = 4 * t * (1 - t);
        if (!(share > 0.01))
            continue;
        const double d = bat_arcs_beside(probe, p);
        least = bat_max(least, (on->band->low - d) / share);
        most = bat_min(most, (on->band->high - d) / share);
    }
    return isfinite(least) && isfinite(most) ? least / 2 + most / 2 : 0;
}

/* Half of what the arc turns, to begin with. Beyond a half circle the middle of the curve
 * decides: there the bulge is no measure. */
static double first_half_turn(const bat_arcs_stretch *on)
{
    const bat_samples *samples = on->samples;
    if (fabs(on->turn) < BAT_PI || samples->count == 0)
        return on->turn / 2;
    const double *m = samples->rows[samples->count / 2];
    const double *a = on->from->point, *b = on->to->point;
    const double before[2] = {m[0] - a[0], m[1] - a[1]};
    const double after[2] = {b[0] - m[0], b[1] - m[1]};
    const bool apart = bat_largest(2, before) > 0 && bat_largest(2, after) > 0;
    return apart ? bat_turn(before, after) : on->turn / 2;
}

bool bat_arcs_single(const bat_arcs_stretch *on, batten_biarc *out)
{
    enum { ROUNDS = 4 };
    bat_arc_chord chord;
    double unit[2];
    if (!chord_of(on, &chord, unit) || !(fabs(on->turn) < 2 * BAT_PI))
        return false;
    double half = first_half_turn(on);
    make_arc(&chord, half, out);
    for (int i = 0; i < ROUNDS && fabs(half) < BAT_PI / 2; i++) {
        bat_arcs_probe probe;
        bat_arcs_probe_make(out, &probe);
        const double by = better_bulge(&probe, on, &chord, unit);
        /* An arc that turns left bulges to the right of its chord. */
        half = 2 * bat_atan(bat_tan(half / 2) - 2 * by / chord.length);
        make_arc(&chord, half, out);
        if (fabs(by) <= 0.01 * (on->band->high - on->band->low))
            break;
    }
    /* The turn of the curve may differ from that of the arc, but not by a loop. */
    return fabs(half) < 0.999 * BAT_PI && fabs(2 * half - on->turn) < BAT_PI &&
           radius_allowed(out, on->least_radius);
}

/* ---- the list ---- */

batten_status bat_arcs_list_add(bat_arcs_list *list, const bat_arcs_part *part)
{
    return BAT_LIST_ADD(list->parts, list->count, list->capacity, *part);
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
    double bad = tolerance * bat_pow(bat_max(count - 1, 0.3) / count, 3);
    double guess = tolerance * bat_pow((count - 1 + last) / count, 3);
    for (int i = 0; i < TRIALS && good - bad > 0.02 * good; i++) {
        tried = guess > bad && guess < good ? guess : sqrt(good * bad);
        guess = 0;
        status = run(task, tried, &trial_count, &last);
        if (status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED ||
            status == BATTEN_INCOMPLETE)
            return status;
        if (status == BATTEN_OK && trial_count <= count)
            good = tried;
        else
            bad = tried;
    }
    return tried == good ? BATTEN_OK : run(task, good, &count, &last);
}
