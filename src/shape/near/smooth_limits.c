/* Smoothing splines at their limits: a polynomial without roughness, and the interpolant. */
#include "shape/near/smooth_limits.h"
#include "shape/near/smooth.h"
#include "spline/curve/curve.h"

#include <string.h>

int bat_differing(const bat_smoothing *t, double *at)
{
    const bat_fit_request *r = &t->request;
    int count = 0;
    double last = -INFINITY;
    for (int i = 0; i < r->data_count; i++) {
        const double u = r->parameters[i];
        const bool counts = !r->weights || r->weights[i] > 0;
        if (!counts || u == last || (r->periodic && u == r->parameters[r->data_count]))
            continue;
        if (at)
            at[count] = u;
        count++;
        last = u;
    }
    return count;
}

/* ---- the limits ---- */

/* Measure a curve that was not made of the fit's equations. */
static batten_status measure_curve(bat_smoothing *t, double lambda, double freedom)
{
    const bat_fit_request *r = &t->request;
    const size_t n = (size_t)r->data_count, d = (size_t)r->dimension;
    const batten_status status =
        batten_curve_evaluate_many(t->curve, n, t->parameters, 0, NULL, t->residuals);
    for (size_t i = 0; status == BATTEN_OK && i < n * d; i++)
        t->residuals[i] -= r->points[i];
    bat_fit_measure(&t->fit, t->residuals, &t->report);
    t->report.lambda = lambda;
    t->report.freedom = freedom;
    return status;
}

/* The mean of the data, as a curve that stays there. */
static batten_status make_constant(bat_smoothing *t)
{
    const bat_fit_request *r = &t->request;
    const double a = r->parameters[0],
                 b = r->parameters[r->periodic ? r->data_count : r->data_count - 1];
    const double line[4] = {a, a, b, b}, ring[2] = {a, b};
    double mean[6] = {0};
    for (int i = 0; i < r->data_count; i++)
        for (int k = 0; k < r->dimension; k++)
            mean[k] += (r->weights ? r->weights[i] : 1) / t->weight *
                       r->points[(size_t)i * (size_t)r->dimension + (size_t)k];
    memcpy(mean + r->dimension, mean, (size_t)r->dimension * sizeof *mean);
    return r->periodic ? batten_curve_create_periodic((batten_points){r->dimension, 1, mean},
                                                      r->degree, NULL, ring, &t->curve)
                       : batten_curve_create((batten_points){r->dimension, 2, mean}, 1, NULL,
                                             line, &t->curve);
}

batten_status bat_smooth_polynomial(bat_smoothing *t)
{
    const bat_fit_request *r = &t->request;
    const int degree = bat_min_int(t->options->order, t->distinct) - 1;
    batten_status status;
    if (r->periodic || degree == 0) {
        status = make_constant(t);
    } else {
        batten_curve_least_squares_options o = batten_curve_least_squares_defaults();
        o.degree = degree;
        o.point_count = degree + 1;
        o.parameters = BATTEN_GIVEN;
        o.given = t->parameters;
        o.weights = r->weights;
        status = batten_curve_least_squares(
            (batten_points){r->dimension, r->data_count, r->points}, &o, NULL, NULL, &t->curve);
    }
    return status == BATTEN_OK
               ? measure_curve(t, HUGE_VAL, r->periodic || degree == 0 ? 1 : degree + 1)
               : status;
}

/* The mean of the data at each parameter. */
static void average(const bat_smoothing *t, double *u, double *q)
{
    const bat_fit_request *r = &t->request;
    const size_t d = (size_t)r->dimension;
    double weight = 0;
    int k = -1;
    bat_differing(t, u);
    for (int i = 0; i < r->data_count; i++) {
        const double w = r->weights ? r->weights[i] : 1;
        if (w == 0)
            continue;
        if (k < 0 || (k + 1 < t->distinct && r->parameters[i] == u[k + 1])) {
            k++;
            weight = 0;
        }
        /* On a ring what stands at its end belongs to the last before it: rather left out. */
        if (r->parameters[i] != u[k])
            continue;
        weight += w;
        for (size_t c = 0; c < d; c++)
            q[(size_t)k * d + c] +=
                w / weight * (r->points[(size_t)i * d + c] - q[(size_t)k * d + c]);
    }
    if (r->periodic)
        u[t->distinct] = r->parameters[r->data_count];
}

batten_status bat_smooth_interpolant(bat_smoothing *t)
{
    const bat_fit_request *r = &t->request;
    const int n = t->distinct, m = t->options->order;
    double *u = bat_array((size_t)n + 1, sizeof *u),
           *q = bat_array3((size_t)n, (size_t)r->dimension, sizeof *q);
    batten_status status = u && q ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    batten_derivative natural[6] = {{0}};
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    o.degree = 2 * m - 1;
    o.parameters = BATTEN_GIVEN;
    o.given = u;
    o.closed = r->periodic;
    if (m == 2) /* a polyline has no conditions at its ends; of higher orders they stand below */
        o.start.kind = o.end.kind = BATTEN_END_NATURAL;
    for (int k = 0; k < m - 1 && m > 2 && !r->periodic; k++) {
        natural[2 * k] = (batten_derivative){.index = 0, .order = m + k};
        natural[2 * k + 1] = (batten_derivative){.index = n - 1, .order = m + k};
        o.derivatives = natural;
        o.derivative_count = 2 * m - 2;
    }
    if (status == BATTEN_OK) {
        average(t, u, q);
        status =
            batten_curve_interpolate((batten_points){r->dimension, n, q}, &o, NULL, &t->curve);
    }
    bat_release(q);
    bat_release(u);
    return status == BATTEN_OK ? measure_curve(t, 0, n) : status;
}
