#include "shape/cloud/scattered.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/spline.h"

#include <float.h>
#include <string.h>

enum { MAX_DEGREE = 9, WIDE = MAX_DEGREE + 1 };

batten_surface_scattered_options batten_surface_scattered_defaults(void)
{
    return (batten_surface_scattered_options){.size = sizeof(batten_surface_scattered_options),
                                              .degree_u = 3,
                                              .degree_v = 3,
                                              .corrections = 20};
}

/* ---- checks ---- */

static batten_status check_options(const batten_surface_scattered_options *o)
{
    const int degrees[2] = {o->degree_u, o->degree_v}, spans[2] = {o->spans_u, o->spans_v};
    if ((int)o->method < 0 || o->method > BATTEN_SCATTERED_MULTILEVEL)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no method %d", (int)o->method);
    for (int k = 0; k < 2; k++) {
        if (degrees[k] < 2 || degrees[k] > MAX_DEGREE)
            return bat_fail(BATTEN_BAD_DEGREE, "the degree along %c is %d, not 2 to %d",
                            k ? 'v' : 'u', degrees[k], MAX_DEGREE);
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

static batten_status check_data(const bat_scatter *s, const double *uv)
{
    if (s->dimension < 1 || s->dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d, not 1 to 3", s->dimension);
    if (s->count < 3)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there are %zu data, and 3 are needed at least",
                        s->count);
    if (s->count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "there are %zu data; the limit is %d", s->count,
                        (int)BAT_MAX_POINTS);
    size_t bad = bat_first_not_finite(uv, 2 * s->count);
    if (bad < 2 * s->count)
        return bat_fail(BATTEN_NOT_FINITE, "parameter %c of datum %zu is %g",
                        bad % 2 ? 'v' : 'u', bad / 2, uv[bad]);
    const size_t d = (size_t)s->dimension;
    bad = bat_first_not_finite(s->values, d * s->count);
    if (bad < d * s->count)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of datum %zu is %g", bad % d,
                        bad / d, s->values[bad]);
    return bat_weights_check((int)s->count, s->given);
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
        if (!(size[k] > 1e-9 * bat_max(fabs(domain[k][0]), fabs(domain[k][1])) &&
              size[k] > DBL_MIN && size[k] < HUGE_VAL))
            return bat_fail(BATTEN_COINCIDENT,
                            "the domain goes from %g to %g along %c: that is no area",
                            domain[k][0], domain[k][1], k ? 'v' : 'u');
    }
    s->length = bat_max(size[0], size[1]);
    for (int k = 0; k < 2; k++)
        s->side[k] = size[k] / s->length;
    return BATTEN_OK;
}

/* A rounding outside the domain is none. */
static batten_status scale_parameters(bat_scatter *s, const double *uv)
{
    for (size_t t = 0; t < s->count; t++)
        for (int k = 0; k < 2; k++) {
            const double x = (uv[2 * t + (size_t)k] - s->origin[k]) / s->length;
            if (!(x >= -4 * DBL_EPSILON && x <= s->side[k] + 4 * DBL_EPSILON))
                return bat_fail(BATTEN_OUT_OF_DOMAIN,
                                "parameter %c of datum %zu is %g, outside %g .. %g",
                                k ? 'v' : 'u', t, uv[2 * t + (size_t)k], s->origin[k],
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

/* ---- the net ---- */

batten_status bat_scatter_even(bat_net_axis *axis, int degree, int spans, double side)
{
    const int n = spans + degree;
    double *U = bat_array((size_t)(n + degree + 1), sizeof *U);
    if (!U)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i <= n + degree; i++) {
        const int k = bat_min_int(spans, bat_max_int(0, i - degree));
        U[i] = k == spans ? side : side * k / spans;
    }
    bat_release(axis->knots);
    *axis = (bat_net_axis){degree, n, U};
    return BATTEN_OK;
}

void bat_scatter_basis(const bat_scatter *s, size_t t, int first[2], double *u, double *v)
{
    double *values[2] = {u, v};
    for (int k = 0; k < 2; k++) {
        const bat_net_axis *axis = &s->axis[k];
        const double x = s->uv[2 * t + (size_t)k];
        const int span =
            bat_knots_span(axis->degree, axis->count, axis->knots, x, BATTEN_FROM_RIGHT);
        bat_basis(axis->degree, axis->knots, span, x, 0, values[k]);
        first[k] = span - axis->degree;
    }
}

void bat_scatter_rest(const bat_scatter *s, size_t t, double rest[3])
{
    const size_t d = (size_t)s->dimension, nv = (size_t)s->axis[1].count;
    double u[WIDE], v[WIDE];
    int first[2];
    bat_scatter_basis(s, t, first, u, v);
    for (size_t c = 0; c < d; c++)
        rest[c] = s->centre[c] - s->values[t * d + c];
    for (int a = 0; a <= s->axis[0].degree; a++)
        for (int b = 0; b <= s->axis[1].degree; b++) {
            const double f = u[a] * v[b];
            const double *p =
                s->control + ((size_t)(first[0] + a) * nv + (size_t)(first[1] + b)) * d;
            for (size_t c = 0; c < d; c++)
                rest[c] += f * p[c];
        }
}

void bat_scatter_measure(bat_scatter *s)
{
    s->sum = 0;
    for (size_t t = 0; t < s->count; t++) {
        double rest[3];
        bat_scatter_rest(s, t, rest);
        const double square = bat_dot(s->dimension, rest, rest);
        s->away[t] = sqrt(square);
        s->sum += s->weights[t] * square;
    }
}

batten_status bat_scatter_net(const bat_scatter *s, batten_surface **out)
{
    const batten_axis u = {s->axis[0].degree, s->axis[0].count, s->axis[0].knots, false};
    const batten_axis v = {s->axis[1].degree, s->axis[1].count, s->axis[1].knots, false};
    return batten_surface_create(s->dimension, &u, &v, s->control, NULL, out);
}

batten_status bat_scatter_take(bat_scatter *s, const batten_surface *surface)
{
    bat_net_axis axis[2];
    for (int k = 0; k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        const int knots = batten_surface_knot_count(surface, direction);
        axis[k].degree = batten_surface_degree(surface, direction);
        axis[k].count = batten_surface_point_count(surface, direction);
        axis[k].knots = bat_array((size_t)knots, sizeof *axis[k].knots);
        if (axis[k].knots)
            memcpy(axis[k].knots, batten_surface_knots(surface, direction),
                   (size_t)knots * sizeof *axis[k].knots);
    }
    const size_t size = (size_t)axis[0].count * (size_t)axis[1].count * (size_t)s->dimension;
    double *control = bat_array(size, sizeof *control);
    if (!axis[0].knots || !axis[1].knots || !control) {
        bat_release(axis[0].knots);
        bat_release(axis[1].knots);
        bat_release(control);
        return BATTEN_OUT_OF_MEMORY;
    }
    memcpy(control, batten_surface_points(surface), size * sizeof *control);
    for (int k = 0; k < 2; k++) {
        bat_release(s->axis[k].knots);
        s->axis[k] = axis[k];
    }
    bat_release(s->control);
    s->control = control;
    bat_scatter_measure(s);
    return BATTEN_OK;
}

batten_status bat_scatter_surface(const bat_scatter *s, batten_surface **out)
{
    const size_t d = (size_t)s->dimension;
    const size_t count = (size_t)s->axis[0].count * (size_t)s->axis[1].count;
    double *points = bat_array3(count, d, sizeof *points);
    double *knots[2];
    for (int k = 0; k < 2; k++) {
        const int n = s->axis[k].count + s->axis[k].degree + 1;
        knots[k] = bat_array((size_t)n, sizeof *knots[k]);
        for (int i = 0; knots[k] && i < n; i++)
            knots[k][i] = s->origin[k] + s->length * s->axis[k].knots[i];
    }
    batten_status status = points && knots[0] && knots[1] ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < count * d; i++)
        points[i] = s->control[i] + s->centre[i % d];
    if (status == BATTEN_OK) {
        const batten_axis u = {s->axis[0].degree, s->axis[0].count, knots[0], false};
        const batten_axis v = {s->axis[1].degree, s->axis[1].count, knots[1], false};
        status = batten_surface_create(s->dimension, &u, &v, points, NULL, out);
    }
    bat_release(knots[1]);
    bat_release(knots[0]);
    bat_release(points);
    return status;
}

/* ---- the report ---- */

static int count_empty(const bat_scatter *s, bool *held)
{
    const int nv = s->axis[1].count;
    int empty = 0;
    for (size_t t = 0; t < s->count; t++) {
        size_t at[2];
        for (int k = 0; k < 2; k++)
            at[k] =
                (size_t)bat_knots_span(s->axis[k].degree, s->axis[k].count, s->axis[k].knots,
                                       s->uv[2 * t + (size_t)k], BATTEN_FROM_RIGHT);
        if (s->weights[t] > 0)
            held[at[0] * (size_t)nv + at[1]] = true;
    }
    for (int i = s->axis[0].degree; i < s->axis[0].count; i++)
        for (int j = s->axis[1].degree; j < nv; j++)
            empty += !held[i * nv + j];
    return empty;
}

batten_status bat_scatter_report(bat_scatter *s)
{
    const size_t d = (size_t)s->dimension;
    batten_surface_fit_report *r = &s->report;
    const batten_status status = bat_surface_fit_measure(s->count, s->away, s->given, r);
    if (status != BATTEN_OK)
        return status;
    const size_t worst = (size_t)r->worst;
    for (int k = 0; k < 2; k++)
        r->at[k] = s->origin[k] + s->length * s->uv[2 * worst + (size_t)k];
    for (size_t c = 0; c < 3; c++)
        r->where[c] = c < d ? s->values[worst * d + c] : 0;
    if (d == 1) {
        r->where[2] = r->where[0];
        memcpy(r->where, r->at, sizeof r->at);
    }
    r->points_u = s->axis[0].count;
    r->points_v = s->axis[1].count;
    r->lambda = s->lambda * s->length * s->length;
    r->freedom = s->freedom;
    r->iterations = s->system.iterations;
    return BATTEN_OK;
}

static batten_status find_empty(bat_scatter *s)
{
    bool *held = bat_array3((size_t)s->axis[0].count, (size_t)s->axis[1].count, sizeof *held);
    if (!held)
        return BATTEN_OUT_OF_MEMORY;
    s->report.empty = count_empty(s, held);
    bat_release(held);
    return BATTEN_OK;
}

/* ---- fitting ---- */

batten_status bat_scatter_fit(bat_scatter *s)
{
    batten_status status;
    if (s->options->method == BATTEN_SCATTERED_MULTILEVEL)
        status = bat_scatter_levels(s);
    else if (s->options->tolerance > 0)
        status = bat_scatter_within(s);
    else
        status = bat_scatter_penalised(s);
    return status == BATTEN_OK ? find_empty(s) : status;
}

batten_status batten_surface_scattered(int dimension, int count, const double *uv,
                                       const double *values,
                                       const batten_surface_scattered_options *options,
                                       const batten_job *job, batten_surface_fit_report *report,
                                       batten_surface **out)
{
    const batten_surface_scattered_options defaults = batten_surface_scattered_defaults();
    bat_scatter s = {.dimension = dimension,
                     .count = (size_t)bat_max_int(count, 0),
                     .values = values,
                     .options = options ? options : &defaults};
    s.given = s.options->weights;
    batten_status status = bat_scatter_begin(&s, uv, job);
    if (status == BATTEN_OK)
        status = bat_scatter_fit(&s);
    if (status == BATTEN_OK)
        status = bat_scatter_outside(&s);
    if (status == BATTEN_OK)
        status = bat_scatter_report(&s);
    if (status == BATTEN_OK)
        status = bat_scatter_surface(&s, out);
    if (status == BATTEN_OK && report)
        *report = s.report;
    bat_scatter_end(&s);
    return status;
}
