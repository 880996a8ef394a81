/* Which way sections run, and where closed ones begin: by the least sum of squared distances
 * from the section before. */
#include "numeric/rounding.h"
#include "shape/skin/steps.h"

#include <string.h>

/* Points of a section at even parameters: the end is one of an open section, not of a closed
 * one, whose start it is. */
enum { SAMPLES = 32 };
typedef struct {
    int d;
    double points[SAMPLES][3];
} samples;

/* Closed to 1e-9 of the size: as good as those who write curves make it. */
batten_status bat_skin_closed(const batten_curve *curve, bool *closed, bool *point)
{
    const batten_interval domain = batten_curve_domain(curve);
    const int d = batten_curve_dimension(curve), n = batten_curve_point_count(curve);
    const double *P = batten_curve_points(curve);
    double first[3], last[3], size = 0;
    batten_status status = batten_curve_evaluate(curve, domain.a, 0, first);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(curve, domain.b, BATTEN_FROM_LEFT, 0, last);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < n; i++)
        size = bat_max(size, bat_distance(d, P, P + (size_t)i * (size_t)d));
    *point = size == 0;
    *closed = batten_curve_is_periodic(curve) ||
              bat_distance(d, first, last) <= BAT_MEANT_SAME * size;
    return BATTEN_OK;
}

static batten_status sample(const batten_curve *curve, bool closed, double shift, samples *out)
{
    const batten_interval domain = batten_curve_domain(curve);
    out->d = batten_curve_dimension(curve);
    for (int i = 0; i < SAMPLES; i++) {
        double s = (double)i / (closed ? SAMPLES : SAMPLES - 1) + shift;
        s -= floor(s) * closed;
        const batten_status status = batten_curve_evaluate(
            curve, bat_min(domain.b, (1 - s) * domain.a + s * domain.b), 0, out->points[i]);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* The mean squared distance when the second begins `by` samples later, or runs backwards from
 * there. */
static double squares_apart(const samples *a, const samples *b, int by, bool backwards)
{
    double sum = 0;
    for (int i = 0; i < SAMPLES; i++) {
        const int j = (backwards ? by - i + 2 * SAMPLES : by + i) % SAMPLES;
        const double distance = bat_distance(a->d, a->points[i], b->points[j]);
        sum += distance * distance / SAMPLES;
    }
    return sum;
}

/* The best of all starts that are samples; an open section has but one for each direction. The
 * present one is kept where another is no better than rounding makes it. */
static int best_start(const samples *a, const samples *b, bool closed, bool backwards,
                      double *least)
{
    const int first = backwards && !closed ? SAMPLES - 1 : 0;
    int best = first;
    *least = squares_apart(a, b, first, backwards);
    for (int by = 1; by < SAMPLES && closed; by++) {
        /* Equal sums keep the first start: equal to nine digits, lest rounding turn a section. */
        const double here = squares_apart(a, b, by, backwards);
        if (here < *least * (1 - BAT_MEANT_SAME)) {
            *least = here;
            best = by;
        }
    }
    return best;
}

static batten_status squares_shifted(const samples *before, const batten_curve *curve,
                                     double shift, double *sum)
{
    samples here;
    const batten_status status = sample(curve, true, shift, &here);
    if (status == BATTEN_OK)
        *sum = squares_apart(before, &here, 0, false);
    return status;
}

/* The least between the neighbours of the best sample, by golden sections. */
static batten_status refine_start(const samples *before, const batten_curve *curve, int best,
                                  double *shift)
{
    const double golden = (sqrt(5) - 1) / 2;
    double a = (best - 1.0) / SAMPLES, b = (best + 1.0) / SAMPLES, low, high;
    double x = b - golden * (b - a), y = a + golden * (b - a), at_best;
    batten_status status = squares_shifted(before, curve, x, &low);
    if (status == BATTEN_OK)
        status = squares_shifted(before, curve, y, &high);
    while (status == BATTEN_OK && b - a > BAT_MEANT_SAME) {
        if (low <= high) {
            b = y, y = x, high = low;
            x = b - golden * (b - a);
            status = squares_shifted(before, curve, x, &low);
        } else {
            a = x, x = y, low = high;
            y = a + golden * (b - a);
            status = squares_shifted(before, curve, y, &high);
        }
    }
    if (status == BATTEN_OK)
        /* A start between samples must gain more than a millionth: golden sections find flat minima no better. */
        status = squares_shifted(before, curve, (double)best / SAMPLES, &at_best);
    if (status == BATTEN_OK)
        *shift =
            bat_min(low, high) < at_best * (1 - 1e-6) ? (a + b) / 2 : (double)best / SAMPLES;
    return status;
}

/* ---- another start ---- */

static batten_status turn_periodic(const batten_curve *curve, double u, batten_curve **out)
{
    const int p = batten_curve_degree(curve);
    batten_curve *with = NULL;
    const bool there = bat_knots_multiplicity(p, batten_curve_point_count(curve),
                                              batten_curve_knots(curve), u) > 0;
    batten_status status = there ? BATTEN_OK : batten_curve_insert_knot(curve, u, 1, &with);
    if (status != BATTEN_OK)
        return status;
    const batten_curve *from = there ? curve : with;
    bat_spline unwrapped = {0};
    status = bat_curve_unwrap(from, 1, &unwrapped);
    if (status == BATTEN_OK)
        status = bat_curve_wrap(from, &unwrapped, u, batten_curve_point_count(from) - p, out);
    bat_spline_free(&unwrapped);
    batten_curve_unref(with);
    return status;
}

/* Cut at u and join the other way round; where the curve ran on smoothly over its old ends the
 * knot there loses what multiplicity it can. */
static batten_status turn_clamped(const batten_curve *curve, double u, batten_curve **out)
{
    batten_curve *low = NULL, *high = NULL, *joined = NULL;
    batten_status status = batten_curve_split(curve, u, &low, &high);
    double size = 0;
    const int n = batten_curve_point_count(curve) * batten_curve_dimension(curve);
    for (int i = 0; i < n; i++)
        size = bat_max(size, fabs(batten_curve_points(curve)[i]));
    if (status == BATTEN_OK)
        /* Ten times the gap at which a section still counts as closed. */
        status = batten_curve_join(high, low, 1e-8 * size, &joined);
    if (status == BATTEN_OK)
        status = batten_curve_remove_knot(
            joined, (batten_knot){batten_curve_domain(high).b, batten_curve_degree(curve)},
            BAT_EXACT * size, NULL, NULL, out);
    batten_curve_unref(joined);
    batten_curve_unref(high);
    batten_curve_unref(low);
    return status;
}

static batten_status start_section_at(batten_curve **curve, double u)
{
    const batten_interval domain = batten_curve_domain(*curve);
    const double far = BAT_MEANT_SAME * (domain.b - domain.a);
    if (u - domain.a <= far || domain.b - u <= far)
        return BATTEN_OK; /* it begins there */
    batten_curve *turned = NULL;
    const batten_status status = batten_curve_is_periodic(*curve)
                                     ? turn_periodic(*curve, u, &turned)
                                     : turn_clamped(*curve, u, &turned);
    if (status == BATTEN_OK) {
        batten_curve_unref(*curve);
        *curve = turned;
    }
    return status;
}

/* ---- one section after another ---- */

static batten_status reverse(bat_skin *t, int k)
{
    batten_curve *reversed = NULL;
    const batten_status status = batten_curve_reverse(t->placed[k], &reversed);
    if (status != BATTEN_OK)
        return status;
    batten_curve_unref(t->placed[k]);
    t->placed[k] = reversed;
    if (t->found.reversed < 0)
        t->found.reversed = k;
    bat_fail(BATTEN_OK, "section %d was reversed, and %d before it", k + 1,
             t->found.reversed_count++);
    return BATTEN_OK;
}

static batten_status start_at(bat_skin *t, int k, double u)
{
    const batten_curve *was = t->placed[k];
    const batten_status status = start_section_at(&t->placed[k], u);
    if (t->placed[k] != was && t->found.turned_count++ == 0)
        t->found.turned = k;
    return status;
}

/* The cosine of the angle by which the curve turns at u: at the ends of the domain from the end
 * to the start of a closed curve. */
static batten_status turning_at(const batten_curve *curve, double u, double *cosine)
{
    const batten_interval domain = batten_curve_domain(curve);
    const bool seam = u <= domain.a || u >= domain.b;
    const int d = batten_curve_dimension(curve);
    double in[6], out[6];
    batten_status status =
        batten_curve_evaluate_side(curve, seam ? domain.b : u, BATTEN_FROM_LEFT, 1, in);
    if (status == BATTEN_OK)
        status =
            batten_curve_evaluate_side(curve, seam ? domain.a : u, BATTEN_FROM_RIGHT, 1, out);
    if (status == BATTEN_OK)
        *cosine = bat_dot(d, in + d, out + d) / (bat_norm(d, in + d) * bat_norm(d, out + d));
    return status;
}

/* A closed section that starts at a corner starts at a corner: *u becomes that knot within a
 * hundredth of the domain at which the curve turns most; *good is false when there is none. */
static batten_status find_corner(const batten_curve *curve, double *u, bool *good)
{
    const batten_interval domain = batten_curve_domain(curve);
    const int count = batten_curve_spans(curve, NULL);
    const double at = *u, smooth = bat_cos(bat_skin_corner);
    double least, *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, knots);
    batten_status status = turning_at(curve, domain.a, &least);
    *good = !(least < smooth); /* no corner at the start: anywhere will do */
    least = smooth;
    for (int i = 0; i < count && status == BATTEN_OK && !*good; i++) {
        double cosine;
        if (fabs(knots[i] - at) > 0.01 * (domain.b - domain.a))
            continue;
        status = turning_at(curve, knots[i], &cosine);
        if (status == BATTEN_OK && cosine < least) {
            least = cosine;
            *u = knots[i];
        }
    }
    *good = *good || least < smooth;
    bat_release(knots);
    return status;
}

static batten_status turn_to_neighbour(bat_skin *t, int k, const samples *before)
{
    samples here;
    double least, shift = 0;
    batten_status status = sample(t->placed[k], true, 0, &here);
    if (status == BATTEN_OK)
        status = refine_start(before, t->placed[k],
                              best_start(before, &here, true, false, &least), &shift);
    if (status != BATTEN_OK)
        return status;
    shift -= floor(shift);
    const batten_interval domain = batten_curve_domain(t->placed[k]);
    double u = (1 - shift) * domain.a + shift * domain.b;
    bool good = true;
    if (!t->options->turn)
        status = find_corner(t->placed[k], &u, &good);
    return status == BATTEN_OK && good ? start_at(t, k, u) : status;
}

/* The mean square of the distances from the mean point. */
static double spread(const samples *s, double mean[3])
{
    double sum = 0;
    memset(mean, 0, 3 * sizeof *mean);
    for (int i = 0; i < SAMPLES; i++)
        for (int c = 0; c < s->d; c++)
            mean[c] += s->points[i][c] / SAMPLES;
    for (int i = 0; i < SAMPLES; i++)
        sum += bat_pow(bat_distance(s->d, s->points[i], mean), 2) / SAMPLES;
    return sum;
}

/*
 * A closed section about its own centre and the one before about its own: the mean of the products of corresponding
 * points is that of the radii for a section that lies the same way, times the cosine of the angle when it starts that
 * much off. Of all starts `best` is the largest such mean; `present` is that of the start it has.
 */
typedef struct {
    double radii, best, present;
} closed_fit;

/* It is reversed when that is better by more than a tenth, from whatever start. */
static batten_status orient_closed(bat_skin *t, int k, const samples *before, closed_fit *fit)
{
    static const double better = 0.1;
    samples here;
    double here_mean[3], mean[3], along, against;
    batten_status status = sample(t->placed[k], true, 0, &here);
    if (status != BATTEN_OK)
        return status;
    const double A = spread(before, mean), B = spread(&here, here_mean);
    const double all = A + B + bat_pow(bat_distance(here.d, mean, here_mean), 2),
                 r = sqrt(A * B);
    best_start(before, &here, true, false, &along);
    best_start(before, &here, true, true, &against);
    if ((all - against) / 2 > (all - along) / 2 + better * r) {
        status = reverse(t, k);
        if (status == BATTEN_OK)
            status = sample(t->placed[k], true, 0, &here);
        along = against;
    }
    *fit =
        (closed_fit){r, (all - along) / 2, (all - squares_apart(before, &here, 0, false)) / 2};
    return status;
}

/* It is turned too when it starts more than 45 degrees off; where no start is good, both shapes have too little in
 * common to tell. */
static batten_status untwist(bat_skin *t, int k, const samples *before)
{
    static const double common = 0.5, off = 0.7;
    closed_fit fit;
    const batten_status status = orient_closed(t, k, before, &fit);
    if (status == BATTEN_OK && fit.best > common * fit.radii && fit.present < off * fit.best)
        return turn_to_neighbour(t, k, before);
    return status;
}

static batten_status fit_in(bat_skin *t, int k, const samples *before, bool closed)
{
    const batten_surface_skin_options *o = t->options;
    closed_fit fit;
    samples here;
    if (closed && o->align && !o->turn)
        return o->untwist && !o->starts ? untwist(t, k, before)
                                        : orient_closed(t, k, before, &fit);
    batten_status status = sample(t->placed[k], closed, 0, &here);
    if (status == BATTEN_OK && o->align) {
        double along, against;
        best_start(before, &here, closed, false, &along);
        best_start(before, &here, closed, true, &against);
        if (against < along)
            status = reverse(t, k);
    }
    return status == BATTEN_OK && closed && o->turn ? turn_to_neighbour(t, k, before) : status;
}

/* Starts that are given come first: they are parameters of the sections as they were. */
static batten_status begin_at(bat_skin *t, int k, bool closed)
{
    const double *starts = t->options->starts;
    if (!starts || t->point[k])
        return BATTEN_OK;
    const batten_interval domain = batten_curve_domain(t->placed[k]);
    if (!(starts[k] >= domain.a && starts[k] <= domain.b))
        return bat_fail(BATTEN_OUT_OF_DOMAIN,
                        "section %d cannot begin at %g, outside its domain [%g, %g]", k + 1,
                        starts[k], domain.a, domain.b);
    if (!closed)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "section %d is open and cannot begin at another place", k + 1);
    return start_at(t, k, starts[k]);
}

batten_status bat_skin_align(bat_skin *t)
{
    const batten_surface_skin_options *o = t->options;
    if (!o->align && !o->turn && !o->starts)
        return BATTEN_OK;
    samples before;
    bool any = false; /* a section that is no point was met */
    for (int k = 0; k < t->count; k++) {
        batten_status status = begin_at(t, k, t->closed);
        if (status == BATTEN_OK && any && !t->point[k])
            status = fit_in(t, k, &before, t->closed);
        if (status == BATTEN_OK && !t->point[k])
            status = sample(t->placed[k], t->closed, 0, &before);
        any = any || !t->point[k];
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}
