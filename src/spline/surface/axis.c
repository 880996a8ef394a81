/*
 * One parameter direction of a surface: a lookup table that finds the span without searching,
 * and basis functions from tabulated reciprocals of knot differences.
 */
#include "spline/surface/axis.h"

#include <string.h>

/* More slices, fewer spans to choose from and fewer branches that the processor cannot foresee.
 */
enum { SLICES_PER_SPAN = 16 };

batten_status bat_axis_make(int degree, int count, bool periodic, bat_axis *out)
{
    *out = (bat_axis){.degree = degree, .count = count, .periodic = periodic};
    out->knots = bat_array((size_t)count + (size_t)degree + 1, sizeof *out->knots);
    return out->knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

void bat_axis_free(bat_axis *axis)
{
    bat_release(axis->knots);
    bat_release(axis->breaks);
    bat_release(axis->first);
    bat_release(axis->inverses);
    bat_release(axis->guide);
}

static void fill_spans(bat_axis *axis)
{
    const int p = axis->degree;
    const double *U = axis->knots;
    double *inverse = axis->inverses;
    int s = 0;
    for (int k = p; k < axis->count; k++) {
        if (U[k] == U[k + 1])
            continue;
        axis->first[s] = k;
        axis->breaks[s++] = U[k];
        for (int e = 1; e <= p; e++)
            for (int j = 0; j < e; j++)
                *inverse++ = 1 / (U[k + 1 + j] - U[k + 1 + j - e]);
    }
    axis->breaks[s] = U[axis->count];
}

static void fill_guide(bat_axis *axis)
{
    const double *breaks = axis->breaks;
    const double rate = axis->slice_count / (breaks[axis->span_count] - breaks[0]);
    if (isinf(rate)) /* a domain of denormal length: one slice holds all */
        axis->slice_count = 1;
    axis->slice_rate = isinf(rate) ? 0 : rate;
    int s = 0;
    for (int j = 0; j < axis->slice_count; j++) {
        while (bat_axis_slice(axis, breaks[s + 1]) < j)
            s++;
        axis->guide[j] = s;
    }
    axis->guide[axis->slice_count] = axis->span_count - 1;
}

static bool allocate_spans(bat_axis *axis)
{
    const size_t spans = (size_t)axis->span_count, p = (size_t)axis->degree;
    axis->breaks = bat_array(spans + 1, sizeof *axis->breaks);
    axis->first = bat_array(spans, sizeof *axis->first);
    axis->inverses = bat_array3(spans, p * (p + 1) / 2, sizeof *axis->inverses);
    axis->guide = bat_array((size_t)axis->slice_count + 1, sizeof *axis->guide);
    return axis->breaks && axis->first && axis->inverses && axis->guide;
}

batten_status bat_axis_finish(bat_axis *axis)
{
    const int p = axis->degree;
    axis->span_count = 0;
    for (int k = p; k < axis->count; k++)
        axis->span_count += axis->knots[k] < axis->knots[k + 1];
    axis->slice_count = SLICES_PER_SPAN * axis->span_count;
    if (!allocate_spans(axis))
        return BATTEN_OUT_OF_MEMORY;
    fill_spans(axis);
    fill_guide(axis);
    return BATTEN_OK;
}

batten_status bat_axis_place(const bat_axis *axis, batten_side side, double *u)
{
    const double a = axis->breaks[0], b = axis->breaks[axis->span_count];
    if (!axis->periodic || !isfinite(*u))
        return bat_knots_clip(a, b, u);
    if (*u < a || *u > b) {
        double beyond = fmod(*u - a, b - a);
        if (!isfinite(beyond))
            return bat_fail(BATTEN_OUT_OF_DOMAIN,
                            "the parameter %g is too far from the domain [%g, %g]", *u, a, b);
        if (beyond < 0)
            beyond += b - a;
        *u = bat_min(a + beyond, b);
    }
    if (*u == a && side == BATTEN_FROM_LEFT)
        *u = b;
    else if (*u == b && side == BATTEN_FROM_RIGHT)
        *u = a;
    return BATTEN_OK;
}

/* From the functions of degree e - 1 to the derivatives of those of degree e. */
static inline void differentiate(int e, const double *inverse, const double *in, double *out)
{
    double before = 0;
    for (int j = 0; j < e; j++) {
        const double here = e * (in[j] * inverse[j]);
        out[j] = before - here;
        before = here;
    }
    out[e] = before;
}

/* From degree e - 1 to degree e, in place; U at the knot that begins the span. */
static inline void raise_degree(int e, const double *U, const double *inverse, double u,
                                double *N)
{
    double kept = 0;
    for (int j = 0; j < e; j++) {
        const double share = N[j] * inverse[j];
        N[j] = kept + (U[1 + j] - u) * share;
        kept = (u - U[1 + j - e]) * share;
    }
    N[e] = kept;
}

/* Row a at degree e comes from row a - 1 at degree e - 1; only rows that lead to a wanted one
 * are kept up. */
static void basis(int p, const double *U, const double *inverse, double u, int order,
                  double *out)
{
    out[0] = 1;
    for (int e = 1; e <= p; inverse += e, e++) {
        for (int a = bat_min_int(order - (p - e), e); a >= 1; a--)
            differentiate(e, inverse, out + (a - 1) * (p + 1), out + a * (p + 1));
        raise_degree(e, U, inverse, u, out);
    }
}

/* basis() of degree 3 and order 0 or 1, written out: the same operations in the same order. */
static inline void cubic_basis(const double *U, const double *inverse, double u,
                               const int order, double *out)
{
    const double r1 = U[1] - u, r2 = U[2] - u, r3 = U[3] - u;
    const double l0 = u - U[0], l1 = u - U[-1], l2 = u - U[-2];
    const double a0 = r1 * inverse[0], a1 = l0 * inverse[0];
    const double s0 = a0 * inverse[1], s1 = a1 * inverse[2];
    const double b0 = r1 * s0, b1 = l1 * s0 + r2 * s1, b2 = l0 * s1;
    const double t0 = b0 * inverse[3], t1 = b1 * inverse[4], t2 = b2 * inverse[5];
    out[0] = r1 * t0;
    out[1] = l2 * t0 + r2 * t1;
    out[2] = l1 * t1 + r3 * t2;
    out[3] = l0 * t2;
    if (order == 0)
        return;
    out[4] = 0 - 3 * t0;
    out[5] = 3 * t0 - 3 * t1;
    out[6] = 3 * t1 - 3 * t2;
    out[7] = 3 * t2;
}

void bat_axis_basis(const bat_axis *axis, int span, double u, int order, double *out)
{
    const int p = axis->degree, k = axis->first[span];
    const double *U = axis->knots + k;
    const double *inverse = axis->inverses + (size_t)span * (size_t)(p * (p + 1) / 2);
    /* h (1 / h) need not be 1, h / h is: ends of spans are interpolated exactly. */
    if (u == U[0] || u == U[1] || isinf(inverse[0])) {
        bat_basis(p, axis->knots, k, u, order, out);
        return;
    }
    if (p == 3 && order == 0)
        cubic_basis(U, inverse, u, 0, out);
    else if (p == 3 && order == 1)
        cubic_basis(U, inverse, u, 1, out);
    else
        basis(p, U, inverse, u, order, out);
    if (order > p)
        memset(out + (p + 1) * (p + 1), 0, (size_t)((order - p) * (p + 1)) * sizeof *out);
}
