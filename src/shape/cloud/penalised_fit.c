/* The weight of the penalty, and robust fits. */
#include "numeric/select.h"
#include "shape/cloud/scattered.h"

#include <string.h>

enum { PROBES = 8, FEW = 256, MOST_SPANS = 40, DIRECT_SPANS = 80 };

/* ---- lambda ---- */

static batten_status rms_at(void *user, double lambda, double *rms)
{
    bat_scatter *s = user;
    const batten_status status = bat_scatter_solve(s, lambda);
    *rms = sqrt(s->sum / s->weight);
    return status;
}

/* The root of V of Craven and Wahba. A lambda with which the equations are lost in rounding is
 * no candidate. */
static batten_status score_at(void *user, double lambda, double *score)
{
    bat_scatter *s = user;
    double rms;
    const batten_status status = rms_at(user, lambda, &rms);
    const double rest = status == BATTEN_OK ? s->counted - bat_scatter_freedom(s) : 0;
    /* With less left for the rest, interpolation; the trace is estimated to fewer digits. */
    *score = rest > 1e-6 * s->counted ? rms * s->counted / rest : HUGE_VAL;
    return status == BATTEN_SINGULAR_SYSTEM ? BATTEN_OK : status;
}

static batten_status search_lambda(bat_scatter *s, double *lambda)
{
    const batten_surface_scattered_options *o = s->options;
    const double per_unit = 1 / (s->length * s->length);
    const bat_lambda_search search = {
        .by = o->by,
        .amount = o->by == BATTEN_SMOOTH_BY_LAMBDA ? o->amount * per_unit : o->amount,
        .scale = s->system.scale,
        .last = bat_last_decade(2, bat_max_int(s->axis[0].count, s->axis[1].count)),
        .coarse = s->count > 20000 || !s->system.factor,
        .near = *lambda,
        .user = s,
        .rms = rms_at,
        .score = score_at,
    };
    return bat_lambda_choose(&search, lambda);
}

/* A target that the held places forbid is met without holding them; one that cannot be met at
 * all is no reason to let them go. */
static batten_status choose_lambda(bat_scatter *s, double *lambda)
{
    batten_status status = search_lambda(s, lambda);
    if (status != BATTEN_OK || s->options->by != BATTEN_SMOOTH_BY_RMS || *lambda > 0 ||
        s->hold == 0)
        return status;
    s->hold = 0;
    status = bat_scatter_assemble(s);
    if (status == BATTEN_OK)
        status = search_lambda(s, lambda);
    if (status != BATTEN_OK || *lambda > 0)
        return status;
    s->hold = BAT_SCATTER_HOLD;
    return bat_scatter_assemble(s);
}

/* Beyond all numbers is the plane; one that is as good as a plane has no such trouble. Without
 * a penalty, or nearly, data that leave something open are helped by a small one. */
static batten_status solve_penalised(bat_scatter *s, double lambda)
{
    const double most = s->system.scale * 1e13, least = s->system.scale * 1e-8;
    batten_status status = bat_scatter_solve(s, bat_min(lambda, most));
    if (status == BATTEN_SINGULAR_SYSTEM && lambda < least)
        status = bat_scatter_solve(s, least);
    /* So stiff that the penalty alone, which has no null space but planes, decides. */
    else if (status == BATTEN_SINGULAR_SYSTEM)
        status = bat_scatter_solve(s, s->system.scale * 1e8);
    s->freedom = status == BATTEN_OK ? bat_scatter_freedom(s) : 0;
    return status;
}

/* ---- robust ---- */

/* 1.345 standard deviations, as the median distance tells them. */
static double usual_threshold(const bat_scatter *s, double *scratch)
{
    size_t counted = 0;
    for (size_t t = 0; t < s->count; t++)
        if (!s->given || s->given[t] > 0)
            scratch[counted++] = s->away[t];
    /* The median of the length of 1, 2, 3 normal numbers. */
    const double medians[3] = {0.6745, 1.1774, 1.5382};
    return 1.345 * bat_select(counted, scratch, counted / 2) / medians[s->dimension - 1];
}

/* The largest change of a weight. */
static double weigh_residuals(bat_scatter *s, double threshold)
{
    double change = 0;
    for (size_t t = 0; t < s->count; t++) {
        const double share = s->away[t] > threshold ? threshold / s->away[t] : 1;
        const double whole = s->given ? s->given[t] : 1;
        change = bat_max(change, fabs(s->weights[t] - share * whole));
        s->weights[t] = share * whole;
    }
    return change;
}

/* Weights by distances, and again: in the first rounds lambda and the threshold are chosen
 * anew, for the first fit is drawn by what is far away. */
static batten_status reweigh(bat_scatter *s, double lambda)
{
    double *scratch = bat_array(s->count, sizeof *scratch);
    batten_status status = scratch ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    double threshold = s->options->threshold, change = 1;
    for (int round = 0; status == BATTEN_OK && round < 50 && change > 1e-3; round++) {
        if (round < 5 && s->options->threshold == 0)
            threshold = usual_threshold(s, scratch);
        if (!(threshold > 0))
            break; /* half of the data are met exactly */
        change = weigh_residuals(s, threshold);
        status = bat_scatter_assemble(s);
        if (status == BATTEN_OK && round < 5 && s->system.factor)
            status = choose_lambda(s, &lambda);
        if (status == BATTEN_OK)
            status = solve_penalised(s, lambda);
        s->report.reweightings = round + 1;
        s->report.threshold = threshold;
    }
    bat_release(scratch);
    return status;
}

/* ---- the method ---- */

/* Together about as many control points as data, in proportion to the sides. */
static int usual_spans(const bat_scatter *s, int k)
{
    const double ratio = bat_min(4, bat_max(0.25, sqrt(s->side[k] / s->side[1 - k])));
    const double wanted = sqrt((double)s->count) * ratio - s->axis[k].degree;
    return (int)bat_min(MOST_SPANS * bat_max(1, ratio), bat_max(4, wanted));
}

static batten_status make_net(bat_scatter *s, const int spans[2])
{
    const int degrees[2] = {s->options->degree_u, s->options->degree_v};
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = bat_scatter_even(&s->axis[k], degrees[k], spans[k], s->side[k]);
    if (status == BATTEN_OK)
        status = bat_scatter_make(s);
    return status;
}

/* Beyond what is solved directly many data are needed: gaps take conjugate gradients too long.
 */
static batten_status check_net(const bat_scatter *s)
{
    const double unknowns = (double)s->system.unknowns;
    if (s->system.factor || unknowns <= 2.0 * (double)s->count)
        return BATTEN_OK;
    return bat_fail(BATTEN_TOO_LARGE, "%zu control points for %zu data; %zu are possible",
                    s->system.unknowns, s->count, 2 * s->count);
}

/* The weight of the penalty hardly depends on the knots when they are many: it is chosen on a
 * net that is solved directly. */
static batten_status begin_penalised(bat_scatter *s, double *lambda)
{
    const batten_surface_scattered_options *o = s->options;
    int spans[2] = {o->spans_u ? o->spans_u : usual_spans(s, 0),
                    o->spans_v ? o->spans_v : usual_spans(s, 1)};
    s->probes = s->count <= FEW ? (int)s->count : PROBES;
    batten_status status = make_net(s, spans);
    if (status == BATTEN_OK)
        status = check_net(s);
    if (status != BATTEN_OK || s->system.factor)
        return status;
    if (o->by == BATTEN_SMOOTH_BY_LAMBDA) {
        s->probes = 0;
        return make_net(s, spans);
    }
    const int few[2] = {bat_min_int(spans[0], DIRECT_SPANS),
                        bat_min_int(spans[1], DIRECT_SPANS)};
    status = make_net(s, few);
    if (status == BATTEN_OK)
        status = bat_scatter_assemble(s);
    if (status == BATTEN_OK)
        status = choose_lambda(s, lambda);
    s->probes = 0;
    return status == BATTEN_OK ? make_net(s, spans) : status;
}

batten_status bat_scatter_penalised(bat_scatter *s)
{
    double lambda = s->control ? s->lambda : 0;
    if (s->keep) {
        const batten_status again = bat_scatter_assemble(s);
        return again == BATTEN_OK ? solve_penalised(s, lambda) : again;
    }
    s->hold = s->options->by == BATTEN_SMOOTH_BY_LAMBDA ? 0 : BAT_SCATTER_HOLD;
    /* The net stays when a cloud is fitted again. */
    batten_status status = s->control ? BATTEN_OK : begin_penalised(s, &lambda);
    const bool direct = s->system.factor || s->options->by == BATTEN_SMOOTH_BY_LAMBDA;
    if (status == BATTEN_OK)
        status = bat_scatter_assemble(s);
    if (status == BATTEN_OK && direct)
        status = choose_lambda(s, &lambda);
    if (status == BATTEN_OK)
        status = solve_penalised(s, lambda);
    return status == BATTEN_OK && s->options->huber ? reweigh(s, lambda) : status;
}

batten_status bat_scatter_nearly(bat_scatter *s)
{
    batten_status status = bat_scatter_make(s);
    if (status == BATTEN_OK)
        status = bat_scatter_assemble(s);
    /* Gaps need more of a penalty than rounding takes away. */
    for (double share = s->share; status == BATTEN_OK; share *= 100) {
        status = bat_scatter_solve(s, share * s->system.scale);
        if (status != BATTEN_SINGULAR_SYSTEM || share >= 1)
            break;
        status = BATTEN_OK;
    }
    return status;
}
