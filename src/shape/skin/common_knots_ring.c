/* Closed curves fitted upon a comb that closes too. */
#include "numeric/banded.h"
#include "shape/skin/common_knots_parts.h"

#include <string.h>

/* The cyclic normal equations of the control points of one period. */
typedef struct {
    const bat_spline *given; /* one period, clamped */
    bat_spline *ring;        /* the wrapped fit: m + p rows */
    int m;
    double *gram; /* [m][2 p + 1] */
} normal;

static void add_sample(normal *e, int span_given, int span, double u, double weight)
{
    const int p = e->ring->degree;
    const size_t w = e->ring->width;
    double own[BATTEN_MAX_DEGREE + 1], basis[BATTEN_MAX_DEGREE + 1], value[4] = {0};
    bat_basis(p, e->given->knots, span_given, u, 0, own);
    bat_basis(p, e->ring->knots, span, u, 0, basis);
    for (int j = 0; j <= p; j++)
        for (size_t c = 0; c < w; c++)
            value[c] += own[j] * e->given->values[(size_t)(span_given - p + j) * w + c];
    for (int j = 0; j <= p; j++) {
        const size_t row = (size_t)((span - p + j) % e->m);
        for (int k = 0; k <= p; k++)
            e->gram[row * (size_t)(2 * p + 1) + (size_t)(k - j + p)] +=
                weight * basis[j] * basis[k];
        for (size_t c = 0; c < w; c++)
            e->ring->values[row * w + c] += weight * basis[j] * value[c];
    }
}

/* As for open curves: between all neighbouring knots of both. */
static void add_samples(normal *e)
{
    const int p = e->ring->degree, per_span = p + 1;
    const double *U = e->given->knots, *V = e->ring->knots;
    int span_given = p, span = p;
    for (double at = 0; at < 1;) {
        while (U[span_given + 1] <= at)
            span_given++;
        while (V[span + 1] <= at)
            span++;
        const double next = bat_min(U[span_given + 1], V[span + 1]);
        for (int i = 0; i < per_span; i++)
            add_sample(e, span_given, span, at + (next - at) * ((i + 0.5) / per_span),
                       (next - at) / per_span);
        at = next;
    }
}

/* The rows of the cyclic solution begin with the lower-th unknown. */
static batten_status solve_ring(const normal *e)
{
    const int p = e->ring->degree;
    bat_cyclic *factor = NULL;
    batten_status status = bat_cyclic_factor(e->m, p, p, e->gram, &factor);
    if (status == BATTEN_OK)
        status = bat_cyclic_solve(factor, e->ring->width, e->ring->values);
    bat_cyclic_free(factor);
    return status;
}

/* Unclamped and wrapped. */
static batten_status fit_ring(const bat_fitting *f, int k, const bat_comb *c, bat_spline *out)
{
    const int p = f->degree, m = c->inner + 1;
    bat_spline ring;
    batten_status status = bat_spline_make(p, m + p, f->width, &ring);
    if (status != BATTEN_OK)
        return status;
    double *period = bat_array((size_t)m + 1, sizeof *period);
    normal e = {&f->given[k], &ring, m,
                bat_array3((size_t)m, (size_t)(2 * p + 1), sizeof *e.gram)};
    status = period && e.gram ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        memcpy(period + 1, c->knots, (size_t)c->inner * sizeof *period);
        period[m] = 1;
        bat_knots_wrap(p, m, period, ring.knots);
        add_samples(&e);
        status = solve_ring(&e);
    }
    if (status == BATTEN_OK)
        memcpy(ring.values + (size_t)m * f->width, ring.values,
               (size_t)p * f->width * sizeof *ring.values);
    bat_release(e.gram);
    bat_release(period);
    if (status == BATTEN_OK)
        *out = ring;
    else
        bat_spline_free(&ring);
    return status;
}

batten_status bat_common_ring_fit(const bat_fitting *f, int k, const bat_comb *c,
                                  bat_spline *out)
{
    bat_spline ring;
    batten_status status = fit_ring(f, k, c, &ring);
    if (status != BATTEN_OK)
        return status;
    status = bat_spline_subrange(&ring, 0, 1, out);
    bat_spline_free(&ring);
    return status;
}

batten_status bat_common_ring_curve(const bat_fitting *f, int k, const bat_comb *c,
                                    batten_curve **out)
{
    bat_spline ring;
    batten_status status = fit_ring(f, k, c, &ring);
    if (status != BATTEN_OK)
        return status;
    const int m = c->inner + 1;
    const size_t d = (size_t)f->dimension;
    double *points = bat_array3((size_t)m, d, sizeof *points);
    double *weights = bat_array((size_t)m, sizeof *weights);
    status = points && weights ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < (size_t)m; i++) {
        const double *row = ring.values + i * f->width;
        weights[i] = f->rational ? row[d] : 1;
        for (size_t j = 0; j < d; j++)
            points[i * d + j] = row[j] / weights[i];
    }
    if (status == BATTEN_OK)
        status = batten_curve_create_periodic((batten_points){f->dimension, m, points},
                                              f->degree, f->rational ? weights : NULL,
                                              ring.knots + f->degree, out);
    bat_release(weights);
    bat_release(points);
    bat_spline_free(&ring);
    return status;
}
