/* Smoothing splines and P-splines: fits with a penalty. */
#include "shape/near/smooth.h"
#include "shape/near/smooth_limits.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

batten_curve_smooth_options batten_curve_smooth_defaults(void)
{
    return (batten_curve_smooth_options){.size = sizeof(batten_curve_smooth_options),
                                         .order = 2,
                                         .spans = 40,
                                         .degree = 3,
                                         .parameters = BATTEN_CHORD};
}

/* ---- parameters ---- */

static void count_data(bat_smoothing *t)
{
    const bat_fit_request *r = &t->request;
    for (int i = 0; i < r->data_count; i++) {
        const double w = r->weights ? r->weights[i] : 1;
        t->weight += w;
        t->counted += w > 0;
    }
    t->distinct = bat_differing(t, NULL);
}

/* ---- the whole ---- */

static batten_status check_smoothing_data(int dimension, int count, const double *points,
                                          const batten_curve_smooth_options *o)
{
    batten_status status = bat_points_check(dimension, count, points, 2);
    if (status == BATTEN_OK)
        status = bat_weights_check(count, o->weights);
    if (status != BATTEN_OK)
        return status;
    if (o->order < 1 || o->order > 4)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the order is %d; it must be in 1..4", o->order);
    if ((int)o->by < 0 || o->by > BATTEN_SMOOTH_BY_RMS)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown rule %d for smoothing", (int)o->by);
    if ((int)o->parameters < 0 || o->parameters > BATTEN_GIVEN)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown parametrization %d", (int)o->parameters);
    if (o->by == BATTEN_SMOOTH_BY_VALIDATION)
        return BATTEN_OK;
    if (isnan(o->amount))
        return bat_fail(BATTEN_NOT_FINITE, "the amount of smoothing is %g", o->amount);
    return o->amount >= 0
               ? BATTEN_OK
               : bat_fail(BATTEN_BAD_ARGUMENT,
                          "the amount of smoothing is %g; it must be 0 or more", o->amount);
}

static batten_status allocate_smoothing(bat_smoothing *t)
{
    const batten_curve_smooth_options *o = t->options;
    bat_fit_request *r = &t->request;
    const size_t n = (size_t)r->data_count;
    t->parameters = bat_array(n + 1, sizeof *t->parameters);
    t->residuals = bat_array3(n, (size_t)r->dimension, sizeof *t->residuals);
    if (!t->parameters || !t->residuals)
        return BATTEN_OUT_OF_MEMORY;
    r->parameters = t->parameters;
    batten_status status =
        bat_fit_parameters(r->dimension, r->data_count, r->points, o->parameters, o->given,
                           o->closed, t->parameters);
    if (status != BATTEN_OK)
        return status;
    count_data(t);
    if (t->distinct < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "all %d points have the weight 0",
                        r->data_count);
    return BATTEN_OK;
}

static batten_status begin_fit(bat_smoothing *t)
{
    const bat_fit_request *r = &t->request;
    t->control = bat_array3((size_t)r->count, (size_t)r->dimension, sizeof *t->control);
    return t->control ? bat_fit_begin(r, &t->fit) : BATTEN_OUT_OF_MEMORY;
}

static batten_status fit_last_lambda(bat_smoothing *t, double lambda)
{
    batten_status status = bat_smoothing_try(t, lambda);
    if (status == BATTEN_OK)
        status = bat_fit_freedom(&t->fit, &t->report.freedom);
    return status == BATTEN_OK ? bat_fit_curve(&t->fit, t->control, &t->curve) : status;
}

static batten_status copy_smooth_results(bat_smoothing *t, batten_status status,
                                         double *parameters, batten_fit_report *report,
                                         batten_curve **out)
{
    t->report.p = 1 / (1 + t->report.lambda);
    if (status == BATTEN_OK) {
        if (parameters)
            memcpy(parameters, t->parameters,
                   (size_t)t->request.data_count * sizeof *parameters);
        if (report)
            *report = t->report;
        *out = t->curve;
    } else {
        batten_curve_unref(t->curve);
    }
    bat_fit_end(&t->fit);
    bat_release(t->parameters);
    bat_release(t->residuals);
    bat_release(t->control);
    bat_release(t->knots);
    return status;
}

/* ---- smoothing splines ---- */

/* A knot at every parameter; the ends, where weight may be 0, are those of the data. */
static batten_status knots_at_data(bat_smoothing *t)
{
    bat_fit_request *r = &t->request;
    const int p = 2 * t->options->order - 1, n = t->distinct;
    double *U = t->knots = bat_array((size_t)n + 2 * (size_t)p + 4, sizeof *U);
    if (!U)
        return BATTEN_OUT_OF_MEMORY;
    r->degree = p;
    r->knots = U;
    const double a = r->parameters[0],
                 b = r->parameters[r->periodic ? r->data_count : r->data_count - 1];
    bat_differing(t, r->periodic ? U : U + p + 1);
    if (r->periodic) {
        r->count = n;
        U[0] = a;
        U[n] = b;
        return BATTEN_OK;
    }
    int inner = 0;
    for (int i = 0; i < n; i++)
        if (U[p + 1 + i] > a && U[p + 1 + i] < b)
            U[p + 1 + inner++] = U[p + 1 + i];
    for (int i = 0; i <= p; i++) {
        U[i] = a;
        U[p + 1 + inner + i] = b;
    }
    r->count = inner + p + 1;
    return BATTEN_OK;
}

static batten_status smooth(bat_smoothing *t)
{
    double lambda;
    batten_status status = knots_at_data(t);
    if (status == BATTEN_OK)
        status = begin_fit(t);
    if (status == BATTEN_OK)
        status = bat_fit_penalise_energy(&t->fit, t->options->order);
    if (status != BATTEN_OK)
        return status;
    if (t->distinct <= t->options->order && !t->request.periodic)
        return bat_smooth_polynomial(t);
    if (t->request.periodic && t->distinct == 1)
        return bat_smooth_polynomial(t);
    status = bat_smoothing_choose(t, &lambda);
    if (status != BATTEN_OK)
        return status;
    /* Below, what is left of the residuals is rounding; beyond, of the shape. */
    if (lambda <= DBL_EPSILON * DBL_EPSILON * t->fit.penalty_scale)
        return bat_smooth_interpolant(t);
    if (isinf(lambda))
        return bat_smooth_polynomial(t);
    status = fit_last_lambda(t, lambda);
    return status == BATTEN_SINGULAR_SYSTEM && lambda > t->fit.penalty_scale
               ? bat_smooth_polynomial(t)
               : status;
}

batten_status batten_curve_smooth(batten_points points,
                                  const batten_curve_smooth_options *options,
                                  double *parameters, batten_fit_report *report,
                                  batten_curve **out)
{
    batten_curve_smooth_options chosen = batten_curve_smooth_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_smooth_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    bat_smoothing t = {.options = &chosen,
                       .request = {.dimension = points.dimension,
                                   .data_count = points.count,
                                   .points = points.at}};
    status = check_smoothing_data(points.dimension, points.count, points.at, t.options);
    if (status != BATTEN_OK)
        return status;
    t.request.periodic = t.options->closed;
    t.request.weights = t.options->weights;
    status = allocate_smoothing(&t);
    if (status == BATTEN_OK)
        status = smooth(&t);
    return copy_smooth_results(&t, status, parameters, report, out);
}

/* ---- P-splines ---- */

/* Equal spans, also before and after the domain: then polynomials have control points whose
 * differences vanish. */
static batten_status equal_knots(bat_smoothing *t)
{
    bat_fit_request *r = &t->request;
    const int p = t->options->degree, s = t->options->spans;
    double *U = t->knots = bat_array((size_t)s + 2 * (size_t)p + 1, sizeof *U);
    if (!U)
        return BATTEN_OUT_OF_MEMORY;
    const double a = r->parameters[0],
                 b = r->parameters[r->periodic ? r->data_count : r->data_count - 1];
    const int before = r->periodic ? 0 : p;
    for (int i = 0; i <= s + 2 * before; i++) {
        const int k = i - before;
        U[i] = k == s ? b : a + (b - a) / s * k;
    }
    r->degree = p;
    r->knots = U;
    r->count = r->periodic ? s : s + p;
    return BATTEN_OK;
}

static batten_status clamp(bat_smoothing *t)
{
    batten_curve *clamped = NULL;
    if (t->request.periodic || !t->curve)
        return BATTEN_OK;
    const batten_status status = batten_curve_clamp(t->curve, &clamped);
    if (status == BATTEN_OK) {
        batten_curve_unref(t->curve);
        t->curve = clamped;
    }
    return status;
}

static batten_status p_spline(bat_smoothing *t)
{
    double lambda;
    batten_status status = equal_knots(t);
    if (status == BATTEN_OK)
        status = begin_fit(t);
    if (status == BATTEN_OK)
        status = bat_fit_penalise_differences(&t->fit, t->options->order);
    if (status != BATTEN_OK)
        return status;
    if (t->distinct <= t->options->order)
        return bat_smooth_polynomial(t);
    status = bat_smoothing_choose(t, &lambda);
    if (status == BATTEN_OK && isinf(lambda))
        return bat_smooth_polynomial(t);
    if (status == BATTEN_OK)
        status = fit_last_lambda(t, lambda);
    if (status == BATTEN_SINGULAR_SYSTEM && lambda > t->fit.penalty_scale)
        return bat_smooth_polynomial(t);
    return status == BATTEN_OK ? clamp(t) : status;
}

batten_status batten_curve_p_spline(batten_points points,
                                    const batten_curve_smooth_options *options,
                                    double *parameters, batten_fit_report *report,
                                    batten_curve **out)
{
    batten_curve_smooth_options chosen = batten_curve_smooth_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_smooth_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    bat_smoothing t = {.options = &chosen,
                       .request = {.dimension = points.dimension,
                                   .data_count = points.count,
                                   .points = points.at}};
    status = check_smoothing_data(points.dimension, points.count, points.at, t.options);
    if (status != BATTEN_OK)
        return status;
    if (t.options->degree < 1 || t.options->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d",
                        t.options->degree, BATTEN_MAX_DEGREE);
    if (t.options->spans <= t.options->order || t.options->spans > BAT_MAX_MADE_POINTS)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d spans; %d to %d are possible",
                        t.options->spans, t.options->order + 1, BAT_MAX_MADE_POINTS);
    t.request.periodic = t.options->closed;
    t.request.weights = t.options->weights;
    status = allocate_smoothing(&t);
    if (status == BATTEN_OK)
        status = p_spline(&t);
    return copy_smooth_results(&t, status, parameters, report, out);
}
