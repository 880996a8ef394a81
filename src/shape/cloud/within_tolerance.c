/*
 * Scattered data within a tolerance: lines of knots go where data are too far off, across the
 * direction along which what is left swings; in the end those that are not needed go again.
 */
#include "numeric/vector.h"
#include "shape/cloud/scattered.h"
#include "spline/spline.h"
#include "spline/surface/surface.h"

#include <string.h>

enum { FIRST_SPANS = 4, USUAL_MOST = 250000, BINS = 8, PARTS = 16, MOST_ROUNDS = 60 };
#define LEAST_SHARE \
    1e-9 /* of the penalty that only keeps the equations from being singular \
          */

/* ---- what is left, by cells and strips ---- */

typedef struct {
    int spans[2];      /* between knots that differ */
    int *number[2];    /* [count of the axis]: which span a knot span is */
    double *low[2];    /* [spans + 1] */
    double *most;      /* [cells] the largest distance */
    double *swing[2];  /* [cells][BINS][d + 2]: sums of what is left by place along u, v;
                             how many, their squares */
    double *shares[2]; /* [spans][PARTS] sums of distances along the strip's width */
    int *held[2];      /* [spans] data */
    double *worst[2];  /* [spans] */
} remains;

static void remains_end(remains *r)
{
    for (int k = 0; k < 2; k++) {
        bat_release(r->number[k]);
        bat_release(r->low[k]);
        bat_release(r->swing[k]);
        bat_release(r->shares[k]);
        bat_release(r->held[k]);
        bat_release(r->worst[k]);
    }
    bat_release(r->most);
}

static batten_status number_spans(const bat_net_axis *axis, int *spans, int **number,
                                  double **low)
{
    *number = bat_array((size_t)axis->count, sizeof **number);
    *low = bat_array((size_t)axis->count + 1, sizeof **low);
    *spans = 0;
    if (!*number || !*low)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = axis->degree; i < axis->count; i++)
        if (axis->knots[i] < axis->knots[i + 1]) {
            (*low)[*spans] = axis->knots[i];
            (*low)[*spans + 1] = axis->knots[i + 1];
            (*number)[i] = (*spans)++;
        }
    return BATTEN_OK;
}

static batten_status remains_begin(const bat_scatter *s, remains *r)
{
    const size_t wide = (size_t)s->dimension + 2;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = number_spans(&s->axis[k], &r->spans[k], &r->number[k], &r->low[k]);
    if (status != BATTEN_OK)
        return status;
    const size_t cells = (size_t)r->spans[0] * (size_t)r->spans[1];
    r->most = bat_array(cells, sizeof *r->most);
    bool good = r->most;
    for (int k = 0; k < 2; k++) {
        const size_t n = (size_t)r->spans[k];
        r->swing[k] = bat_array3(cells, BINS * wide, sizeof *r->swing[k]);
        r->shares[k] = bat_array3(n, PARTS, sizeof *r->shares[k]);
        r->held[k] = bat_array(n, sizeof *r->held[k]);
        r->worst[k] = bat_array(n, sizeof *r->worst[k]);
        good = good && r->swing[k] && r->shares[k] && r->held[k] && r->worst[k];
    }
    return good ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void add_datum(const bat_scatter *s, size_t t, remains *r)
{
    const int d = s->dimension;
    const size_t wide = (size_t)d + 2;
    int span[2];
    double part[2], rest[3];
    bat_scatter_rest(s, t, rest);
    for (int k = 0; k < 2; k++) {
        const bat_net_axis *axis = &s->axis[k];
        const double x = s->uv[2 * t + (size_t)k];
        span[k] = r->number[k][bat_knots_span(axis->degree, axis->count, axis->knots, x,
                                              BATTEN_FROM_RIGHT)];
        /* Within the span: the last place before its end. */
        const double a = r->low[k][span[k]], b = r->low[k][span[k] + 1];
        part[k] = bat_min((x - a) / (b - a), 1 - 1e-9);
    }
    const size_t cell = (size_t)span[0] * (size_t)r->spans[1] + (size_t)span[1];
    r->most[cell] = bat_max(r->most[cell], s->away[t]);
    for (int k = 0; k < 2; k++) {
        double *to = r->swing[k] + (cell * BINS + (size_t)(part[k] * BINS)) * wide;
        for (int c = 0; c < d; c++)
            to[c] += rest[c];
        to[d] += 1;
        to[d + 1] += bat_dot(d, rest, rest);
        r->shares[k][span[k] * PARTS + (int)(part[k] * PARTS)] += s->away[t];
        r->held[k][span[k]]++;
        r->worst[k][span[k]] = bat_max(r->worst[k][span[k]], s->away[t]);
    }
}

/* How much what is left swings along a direction, in the cells that are too far off: sums over
 * bins across it, less what they would be without order. */
static double swing_along(const bat_scatter *s, const remains *r, int k, double tolerance)
{
    const int d = s->dimension;
    const size_t wide = (size_t)d + 2, cells = (size_t)r->spans[0] * (size_t)r->spans[1];
    double sum = 0;
    for (size_t cell = 0; cell < cells; cell++)
        for (int b = 0; r->most[cell] > tolerance && b < BINS; b++) {
            const double *in = r->swing[k] + (cell * BINS + (size_t)b) * wide;
            if (in[d] > 0)
                sum += (bat_dot(d, in, in) - in[d + 1]) / in[d];
        }
    return bat_max(sum, 0);
}

/* ---- new knots ---- */

/* So many parts have half of the shares. */
static double half_of(const double shares[PARTS])
{
    double whole = 0, sum = 0;
    for (int i = 0; i < PARTS; i++)
        whole += shares[i];
    int i = 0;
    while (i < PARTS - 1 && sum + shares[i] < whole / 2)
        sum += shares[i++];
    return i + (shares[i] > 0 ? (whole / 2 - sum) / shares[i] : 0.5);
}

/* The middle of the distances in a strip, not near its ends. */
static double middle_of(const remains *r, int k, int span)
{
    const double half = half_of(r->shares[k] + span * PARTS);
    const double part = bat_min(0.7, bat_max(0.3, half / PARTS));
    const double a = r->low[k][span], b = r->low[k][span + 1];
    return a + part * (b - a);
}

/* A strip with too few data, or too thin to be halved, stays. */
static bool can_split(const bat_scatter *s, const remains *r, int k, int span)
{
    return r->held[k][span] >= 4 && r->low[k][span + 1] - r->low[k][span] > 1e-6 * s->side[k];
}

static int count_splits(const bat_scatter *s, const remains *r, int k, double tolerance)
{
    int count = 0;
    for (int i = 0; i < r->spans[k]; i++)
        count += r->worst[k][i] > tolerance && can_split(s, r, k, i);
    return count;
}

/* The knots, and one more in each span that is split. */
static void list_split_knots(const bat_scatter *s, const remains *r, int k, double tolerance,
                             double *U)
{
    const bat_net_axis *axis = &s->axis[k];
    for (int i = 0; i <= axis->count + axis->degree; i++) {
        *U++ = axis->knots[i];
        if (i < axis->degree || i >= axis->count || !(axis->knots[i] < axis->knots[i + 1]))
            continue;
        const int span = r->number[k][i];
        if (r->worst[k][span] > tolerance && can_split(s, r, k, span))
            *U++ = middle_of(r, k, span);
    }
}

static batten_status split_axis(bat_scatter *s, const remains *r, int k, double tolerance)
{
    bat_net_axis *axis = &s->axis[k];
    const int added = count_splits(s, r, k, tolerance);
    double *U = bat_array((size_t)(axis->count + added + axis->degree + 1), sizeof *U);
    if (!U)
        return BATTEN_OUT_OF_MEMORY;
    list_split_knots(s, r, k, tolerance, U);
    bat_release(axis->knots);
    axis->knots = U;
    axis->count += added;
    return BATTEN_OK;
}

/* False in *split when no strip can be halved, or the net would become too large. */
static batten_status refine_axes(bat_scatter *s, double tolerance, bool *split)
{
    remains r = {0};
    const double given = s->options->most_points ? s->options->most_points : USUAL_MOST;
    const double most = bat_min(given, 4.0 * s->counted + 64);
    batten_status status = remains_begin(s, &r);
    for (size_t t = 0; status == BATTEN_OK && t < s->count; t++)
        if (s->weights[t] > 0)
            add_datum(s, t, &r);
    if (status == BATTEN_OK) {
        double swing[2];
        int splits[2];
        for (int k = 0; k < 2; k++) {
            swing[k] = swing_along(s, &r, k, tolerance);
            splits[k] = count_splits(s, &r, k, tolerance);
        }
        bool wanted[2];
        for (int k = 0; k < 2; k++)
            wanted[k] = splits[k] > 0 && (swing[k] >= 0.6 * swing[1 - k] || splits[1 - k] == 0);
        const double size = (double)(s->axis[0].count + (wanted[0] ? splits[0] : 0)) *
                            (s->axis[1].count + (wanted[1] ? splits[1] : 0));
        *split = (wanted[0] || wanted[1]) && size <= most;
        for (int k = 0; k < 2 && status == BATTEN_OK && *split; k++)
            if (wanted[k])
                status = split_axis(s, &r, k, tolerance);
    }
    remains_end(&r);
    return status;
}

/* ---- knots that are not needed ---- */

/* Remove knots as long as each moves the surface by less than `limit` and all by less than what
 * is left of `budget`. */
static batten_status thin_axis(batten_surface **surface, batten_direction direction,
                               double limit, double *budget)
{
    const int p = batten_surface_degree(*surface, direction);
    int i = p + 1;
    while (i < batten_surface_point_count(*surface, direction)) {
        const double at = batten_surface_knots(*surface, direction)[i];
        batten_surface *thinner = NULL;
        int removed = 0;
        double error = 0;
        const batten_status status =
            batten_surface_remove_knot(*surface, (batten_knot_line){direction, at, 1},
                                       bat_min(limit, *budget), &removed, &error, &thinner);
        if (status != BATTEN_OK)
            return status;
        batten_surface_unref(*surface);
        *surface = thinner;
        if (removed > 0)
            *budget -= error;
        else
            i++;
    }
    return BATTEN_OK;
}

static double worst_of(const bat_scatter *s, size_t *worst)
{
    double most = 0;
    for (size_t t = 0; t < s->count; t++)
        if (s->weights[t] > 0 && s->away[t] >= most) {
            most = s->away[t];
            *worst = t;
        }
    return most;
}

/* First those that hardly matter. A net that is too large for that many trials is left as it
 * is. */
static batten_status remove_knots(bat_scatter *s, double tolerance, double most)
{
    const double knots = s->axis[0].count + s->axis[1].count;
    double budget = (tolerance - most) * (1 - 1e-6);
    batten_surface *surface = NULL;
    /* The cost of trying all knots, a second or so. */
    if (knots * s->axis[0].count * s->axis[1].count > 5e7)
        return BATTEN_OK;
    batten_status status = bat_scatter_net(s, &surface);
    for (int pass = 0; pass < 4 && status == BATTEN_OK && budget > 0; pass++)
        status = thin_axis(&surface, pass % 2 ? BATTEN_V : BATTEN_U,
                           pass < 2 ? budget / 16 : budget, &budget);
    if (status == BATTEN_OK)
        status = bat_scatter_take(s, surface);
    batten_surface_unref(surface);
    return status;
}

/* ---- as calm as may be ---- */

/* Ten times the penalty, everywhere or where the floor is its weight, as long as no datum is
 * farther than the target. */
static batten_status stiffen_penalty(bat_scatter *s, double target, bool floor)
{
    bat_net_system *y = &s->system;
    size_t worst = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < 16 && status == BATTEN_OK; i++) {
        const double lambda = s->lambda, held = y->floor;
        y->floor *= floor ? 10 : 1;
        status = bat_scatter_solve(s, floor ? lambda : 10 * lambda);
        if (status == BATTEN_OK && worst_of(s, &worst) <= target)
            continue;
        y->floor = held;
        return status == BATTEN_OK || status == BATTEN_SINGULAR_SYSTEM
                   ? bat_scatter_solve(s, lambda)
                   : status;
    }
    return status;
}

/* Where there are no data, at corners above all, only the penalty holds the surface: let it
 * weigh as much as more than half of what is left of the tolerance allows, there first. */
static batten_status calm_surface(bat_scatter *s, double tolerance, double most)
{
    if (!s->system.factor)
        return BATTEN_OK; /* each try would cost too much */
    batten_status status = BATTEN_OK;
    if (s->system.floor > 0)
        status = stiffen_penalty(s, most + 0.3 * (tolerance - most), true);
    return status == BATTEN_OK ? stiffen_penalty(s, most + 0.6 * (tolerance - most), false)
                               : status;
}

/* ---- the loop ---- */

static batten_status fit_and_correct(bat_scatter *s)
{
    batten_status status = bat_scatter_nearly(s);
    if (status == BATTEN_OK && s->correct)
        status = s->correct(s, bat_scatter_nearly, 2);
    return status;
}

static batten_status fail_tolerance(const bat_scatter *s, size_t worst, double most)
{
    return bat_fail(
        BATTEN_TOLERANCE_NOT_MET,
        "datum %zu is missed by %g, more than %g, with %d x %d control points; more "
        "of them would have too few data, or are too many",
        worst + 1, most, s->options->tolerance, s->axis[0].count, s->axis[1].count);
}

static batten_status begin_coarse(bat_scatter *s)
{
    const batten_surface_scattered_options *o = s->options;
    s->probes = 0;
    batten_status status = bat_scatter_even(&s->axis[0], o->degree_u,
                                            o->spans_u ? o->spans_u : FIRST_SPANS, s->side[0]);
    if (status == BATTEN_OK)
        status = bat_scatter_even(&s->axis[1], o->degree_v,
                                  o->spans_v ? o->spans_v : FIRST_SPANS, s->side[1]);
    return status;
}

/* When no more knots are possible, the penalty may still be in the way. */
static bool let_go(bat_scatter *s)
{
    const bool held = s->hold > 0;
    s->hold = 0;
    s->share = LEAST_SHARE;
    return held;
}

batten_status bat_scatter_within(bat_scatter *s)
{
    const double tolerance = s->options->tolerance;
    size_t worst = 0;
    batten_status status = begin_coarse(s);
    for (int round = 0; status == BATTEN_OK && round < MOST_ROUNDS; round++) {
        bool split = false;
        status = fit_and_correct(s);
        if (status != BATTEN_OK)
            return status;
        s->report.rounds = round + 1;
        const double most = worst_of(s, &worst);
        if (most <= tolerance) {
            status = calm_surface(s, tolerance, most);
            return status == BATTEN_OK ? remove_knots(s, tolerance, worst_of(s, &worst))
                                       : status;
        }
        status = refine_axes(s, tolerance, &split);
        if (status == BATTEN_OK && !split && !let_go(s))
            return fail_tolerance(s, worst, most);
    }
    return status == BATTEN_OK ? fail_tolerance(s, worst, worst_of(s, &worst)) : status;
}
