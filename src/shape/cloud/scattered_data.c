/* Scattered data as they come in: checked, moved about their centre, in a domain of size 1. */
#include "numeric/rounding.h"
#include "shape/cloud/scattered.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <string.h>

/* ---- checks ---- */

static batten_status check_options(const batten_surface_scattered_options *o)
{
    const int degrees[2] = {o->degree_u, o->degree_v}, spans[2] = {o->spans_u, o->spans_v};
    if ((int)o->method < 0 || o->method > BATTEN_SCATTERED_MULTILEVEL)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no method %d", (int)o->method);
    for (int k = 0; k < 2; k++) {
        if (degrees[k] < 2 || degrees[k] > BAT_SCATTER_MAX_DEGREE)
            return bat_fail(BATTEN_BAD_DEGREE, "the degree along %c is %d, not 2 to %d",
                            k ? 'v' : 'u', degrees[k], BAT_SCATTER_MAX_DEGREE);
        if (spans[k] < 0 || (double)bat_max_int(o->spans_u, 1) * bat_max_int(o->spans_v, 1) >
                                BAT_MAX_POINTS / 8)
            return bat_fail(spans[k] < 0 ? BATTEN_BAD_ARGUMENT : BATTEN_TOO_LARGE,
                            "%d x %d spans; 0 to %d in all are possible", o->spans_u,
                            o->spans_v, BAT_MAX_POINTS / 8);
    }
    if (!(o->tolerance >= 0 && o->tolerance < HUGE_VAL))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not 0 or above",
                        o->tolerance);
    if (o->by != BATTEN_SMOOTH_BY_VALIDATION && !(o->amount >= 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the amount of smoothing is %g, below 0",
                        o->amount);
    if (!(o->threshold >= 0) || o->most_points < 0 || o->levels < 0 || o->levels > 12 ||
        o->corrections < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a threshold %g, at most %d points, %d levels (12 at most), %d "
                        "corrections: one is out of bounds",
                        o->threshold, o->most_points, o->levels, o->corrections);
    return BATTEN_OK;
}

static batten_status check_counts(const bat_scatter *s)
{
    if (s->dimension < 1 || s->dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d, not 1 to 3", s->dimension);
    if (s->count < 3)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there are %zu data, and 3 are needed at least",
                        s->count);
    if (s->count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "there are %zu data; the limit is %d", s->count,
                        (int)BAT_MAX_POINTS);
    return BATTEN_OK;
}

static batten_status check_numbers(const bat_scatter *s, const double *uv)
{
    size_t bad = bat_first_not_finite(uv, 2 * s->count);
    if (bad < 2 * s->count)
        return bat_fail(BATTEN_NOT_FINITE, "parameter %c of datum %zu is %g",
                        bad % 2 ? 'v' : 'u', bad / 2 + 1, uv[bad]);
    const size_t d = (size_t)s->dimension;
    bad = bat_first_not_finite(s->values, d * s->count);
    if (bad < d * s->count)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of datum %zu is %g", bad % d + 1,
                        bad / d + 1, s->values[bad]);
    return BATTEN_OK;
}

static batten_status check_data(const bat_scatter *s, const double *uv)
{
    batten_status status = check_counts(s);
    if (status == BATTEN_OK)
        status = check_numbers(s, uv);
    return status == BATTEN_OK ? bat_weights_check((int)s->count, s->given) : status;
}

/* ---- the domain ---- */

static void box_of(const bat_scatter *s, const double *uv, double domain[2][2])
{
    for (int k = 0; k < 2; k++) {
        domain[k][0] = HUGE_VAL;
        domain[k][1] = -HUGE_VAL;
        for (size_t t = 0; t < s->count; t++) {
            domain[k][0] = bat_min(domain[k][0], uv[2 * t + (size_t)k]);
            domain[k][1] = bat_max(domain[k][1], uv[2 * t + (size_t)k]);
        }
    }
}

static batten_status set_domain(bat_scatter *s, const double *uv)
{
    double domain[2][2], size[2];
    const double(*given)[2] = s->options->domain;
    if (given[0][0] == 0 && given[0][1] == 0 && given[1][0] == 0 && given[1][1] == 0)
        box_of(s, uv, domain);
    else
        memcpy(domain, given, sizeof domain);
    for (int k = 0; k < 2; k++) {
        size[k] = domain[k][1] - domain[k][0];
        s->origin[k] = domain[k][0];
        /* Below this the numbers between the ends are too few for knots. */
        if (!(size[k] > BAT_MEANT_SAME * bat_max(fabs(domain[k][0]), fabs(domain[k][1])) &&
              size[k] > DBL_MIN && size[k] < HUGE_VAL))
            return bat_fail(BATTEN_COINCIDENT,
                            "the domain goes from %g to %g along %c, which encloses no area",
                            domain[k][0], domain[k][1], k ? 'v' : 'u');
    }
    s->length = bat_max(size[0], size[1]);
    for (int k = 0; k < 2; k++)
        s->side[k] = size[k] / s->length;
    return BATTEN_OK;
}

/* Parameters outside the domain by rounding alone count as its ends. */
static batten_status scale_parameters(bat_scatter *s, const double *uv)
{
    for (size_t t = 0; t < s->count; t++)
        for (int k = 0; k < 2; k++) {
            const double x = (uv[2 * t + (size_t)k] - s->origin[k]) / s->length;
            if (!(x >= -4 * DBL_EPSILON && x <= s->side[k] + 4 * DBL_EPSILON))
                return bat_fail(BATTEN_OUT_OF_DOMAIN,
                                "parameter %c of datum %zu is %g, outside %g .. %g",
                                k ? 'v' : 'u', t + 1, uv[2 * t + (size_t)k], s->origin[k],
                                s->origin[k] + s->length * s->side[k]);
            s->uv[2 * t + (size_t)k] = bat_min(s->side[k], bat_max(0, x));
        }
    return BATTEN_OK;
}

static void find_centre(bat_scatter *s)
{
    const size_t d = (size_t)s->dimension;
    for (size_t c = 0; c < d; c++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t t = 0; t < s->count; t++) {
            low = bat_min(low, s->values[t * d + c]);
            high = bat_max(high, s->values[t * d + c]);
        }
        s->centre[c] = low / 2 + high / 2;
    }
}

batten_status bat_scatter_begin(bat_scatter *s, const double *uv, const batten_job *job)
{
    s->work = (bat_work){job, 0};
    s->share = BAT_SCATTER_SHARE;
    s->hold = BAT_SCATTER_HOLD;
    batten_status status = check_options(s->options);
    if (status == BATTEN_OK)
        status = check_data(s, uv);
    if (status == BATTEN_OK)
        status = set_domain(s, uv);
    if (status != BATTEN_OK)
        return status;
    s->uv = bat_array3(s->count, 2, sizeof *s->uv);
    s->weights = bat_array(s->count, sizeof *s->weights);
    s->away = bat_array(s->count, sizeof *s->away);
    if (!s->uv || !s->weights || !s->away)
        return BATTEN_OUT_OF_MEMORY;
    double any = 0;
    for (size_t t = 0; t < s->count; t++) {
        s->weights[t] = s->given ? s->given[t] : 1;
        any += s->weights[t];
    }
    if (!(any > 0 && any < HUGE_VAL))
        return bat_fail(BATTEN_BAD_WEIGHT, "the sum of all weights is %g", any);
    find_centre(s);
    return scale_parameters(s, uv);
}

void bat_scatter_end(bat_scatter *s)
{
    bat_scatter_release(&s->system);
    bat_release(s->uv);
    bat_release(s->weights);
    bat_release(s->away);
    bat_release(s->control);
    bat_release(s->centred);
    bat_release(s->axis[0].knots);
    bat_release(s->axis[1].knots);
}
