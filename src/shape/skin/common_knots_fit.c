/* One curve fitted upon a comb, and how far it moved. */
#include "numeric/banded.h"
#include "numeric/dense.h"
#include "shape/skin/common_knots_parts.h"

#include <string.h>

/* ---- one section upon a comb ---- */

/* The banded normal equations of the inner control points. */
typedef struct {
    const bat_spline *given;
    bat_spline *fit;
    double *gram; /* [count - 2][p + 1] */
    int span_given, span_fit;
} normal;

static void add_sample(normal *e, double u, double weight)
{
    const int p = e->fit->degree, n = e->fit->count;
    const size_t w = e->fit->width;
    double own[BATTEN_MAX_DEGREE + 1], basis[BATTEN_MAX_DEGREE + 1], value[4] = {0};
    bat_basis(p, e->given->knots, e->span_given, u, 0, own);
    bat_basis(p, e->fit->knots, e->span_fit, u, 0, basis);
    for (int j = 0; j <= p; j++)
        for (size_t c = 0; c < w; c++)
            value[c] += own[j] * e->given->values[(size_t)(e->span_given - p + j) * w + c];
    const int first = e->span_fit - p;
    for (int j = 0; j <= p; j++) /* what the held ends give */
        if (first + j == 0 || first + j == n - 1)
            for (size_t c = 0; c < w; c++)
                value[c] -=
                    basis[j] *
                    e->given
                        ->values[(first + j == 0 ? 0 : (size_t)e->given->count - 1) * w + c];
    for (int j = 0; j <= p; j++) {
        const int row = first + j - 1;
        if (row < 0 || row >= n - 2)
            continue;
        for (int k = 0; k <= j; k++)
            if (first + k - 1 >= 0)
                e->gram[(size_t)row * (size_t)(p + 1) + (size_t)(p - j + k)] +=
                    weight * basis[j] * basis[k];
        for (size_t c = 0; c < w; c++)
            e->fit->values[(size_t)(row + 1) * w + c] += weight * basis[j] * value[c];
    }
}

/* Between all neighbouring knots of both vectors, at as many Gauss-like places as the degree
 * needs. */
static void add_samples(normal *e)
{
    const int p = e->fit->degree, per_span = p + 1;
    const double *U = e->given->knots, *V = e->fit->knots;
    e->span_given = e->span_fit = p;
    for (double at = 0; at < 1;) {
        while (U[e->span_given + 1] <= at)
            e->span_given++;
        while (V[e->span_fit + 1] <= at)
            e->span_fit++;
        const double next = bat_min(U[e->span_given + 1], V[e->span_fit + 1]);
        for (int i = 0; i < per_span; i++)
            add_sample(e, at + (next - at) * ((i + 0.5) / per_span), (next - at) / per_span);
        at = next;
    }
}

/* The first two derivatives at the seam, as rows upon the inner control points, and what they
 * must be: [2][n - 2] and [2][width]. */
static void seam_rows(const bat_spline *fit, const double *first, const double *last,
                      double *rows, double *wanted)
{
    const int n = fit->count, p = fit->degree;
    const size_t w = fit->width, inner = (size_t)(n - 2);
    const double *U = fit->knots;
    const double a = U[p + 1], a2 = U[p + 2], b = 1 - U[n - 1], b2 = 1 - U[n - 2];
    double *second = rows + inner;
    rows[0] += 1 / a;
    rows[inner - 1] += 1 / b;
    second[1] += 1 / (a2 * a);
    second[0] -= (1 / a2 + 1 / a) / a;
    second[inner - 2] -= 1 / (b2 * b);
    second[inner - 1] += (1 / b2 + 1 / b) / b;
    for (size_t c = 0; c < w; c++) {
        wanted[c] = first[c] / a + last[c] / b;
        wanted[w + c] = last[c] / (b * b) - first[c] / (a * a);
    }
}

/* What the inner control points x [n - 2] lack of the conditions, and how much they gain by
 * moving along the responses z [n - 2][2]. */
static void seam_gauge(const bat_spline *fit, const double *rows, const double *z,
                       double gauge[4], double *lack)
{
    const size_t w = fit->width, m = (size_t)(fit->count - 2);
    const double *x = fit->values + w;
    for (size_t i = 0; i < m; i++)
        for (size_t r = 0; r < 2; r++) {
            gauge[2 * r] += rows[r * m + i] * z[2 * i];
            gauge[2 * r + 1] += rows[r * m + i] * z[2 * i + 1];
            for (size_t c = 0; c < w; c++)
                lack[r * w + c] -= rows[r * m + i] * x[i * w + c];
        }
}

/* Move the inner control points by what, in the measure of the least squares, is least, so that
 * the ends continue each other smoothly. */
static batten_status close_seam(const bat_fitting *f, const double *gram, bat_spline *fit,
                                const double *first, const double *last)
{
    const size_t w = f->width, m = (size_t)(fit->count - 2);
    double *rows = bat_array3(2, m, sizeof *rows), *z = bat_array3(m, 2, sizeof *z);
    double lack[2 * 4] = {0}, gauge[4] = {0}, *x = fit->values + w;
    int pivots[2];
    batten_status status = rows && z ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        seam_rows(fit, first, last, rows, lack);
        for (size_t i = 0; i < m; i++)
            for (size_t r = 0; r < 2; r++)
                z[2 * i + r] = rows[r * m + i];
        bat_symmetric_solve(fit->count - 2, fit->degree, gram, 2, z);
        seam_gauge(fit, rows, z, gauge, lack);
        status = bat_dense_factor(2, gauge, pivots);
    }
    if (status == BATTEN_OK) {
        bat_dense_solve(2, gauge, pivots, w, lack);
        for (size_t i = 0; i < m; i++)
            for (size_t c = 0; c < w; c++)
                x[i * w + c] += z[2 * i] * lack[c] + z[2 * i + 1] * lack[w + c];
    }
    bat_release(z);
    bat_release(rows);
    return status;
}

batten_status bat_common_fit(const bat_fitting *f, int k, const bat_comb *c, bat_spline *out)
{
    if (f->periodic)
        return bat_common_ring_fit(f, k, c, out);
    const int p = f->degree, n = c->inner + p + 1;
    const bat_spline *given = &f->given[k];
    bat_spline fit;
    batten_status status = bat_spline_make(p, n, f->width, &fit);
    if (status != BATTEN_OK)
        return status;
    bat_comb_write(c, p, fit.knots);
    double *gram = bat_array3((size_t)n, (size_t)(p + 1), sizeof *gram);
    normal e = {given, &fit, gram, 0, 0};
    if (gram)
        add_samples(&e);
    status = gram ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && n > 2) {
        status = bat_symmetric_factor(n - 2, p, gram);
        if (status == BATTEN_OK)
            bat_symmetric_solve(n - 2, p, gram, f->width, fit.values + f->width);
        if (status == BATTEN_OK && f->request->seam)
            status = close_seam(f, gram, &fit, given->values,
                                given->values + (size_t)(given->count - 1) * f->width);
    }
    bat_release(gram);
    if (status != BATTEN_OK) {
        bat_spline_free(&fit);
        return status;
    }
    const size_t row = f->width * sizeof *fit.values;
    memcpy(fit.values, given->values, row);
    memcpy(fit.values + (size_t)(n - 1) * f->width,
           given->values + (size_t)(given->count - 1) * f->width, row);
    *out = fit;
    return BATTEN_OK;
}

/* ---- how far it moved ---- */

/* What `s` lacks of the knots of `other`, both over [0, 1], and with `halve` the middles of all
 * spans. */
static int missing_knots(const bat_spline *s, const bat_spline *other, bool halve,
                         double *missing)
{
    const int p = s->degree, end = s->count, other_end = other->count;
    int count = 0;
    double last = 0;
    for (int i = p + 1, j = p + 1; i < end || j < other_end || last < 1;) {
        const double a = i < end ? s->knots[i] : 1, b = j < other_end ? other->knots[j] : 1;
        const double next = bat_min(a, b);
        const double middle = last + (next - last) / 2;
        if (halve && middle > last && middle < next)
            missing[count++] = middle;
        last = next;
        if (next >= 1)
            break;
        int own = 0, wanted = 0;
        for (; i < end && s->knots[i] == next; i++)
            own++;
        for (; j < other_end && other->knots[j] == next; j++)
            wanted++;
        for (; own < wanted; own++)
            missing[count++] = next;
    }
    return count;
}

static batten_status refine_both(const bat_spline *a, const bat_spline *b, bat_spline *fine_a,
                                 bat_spline *fine_b)
{
    double *missing = bat_array(2 * ((size_t)a->count + (size_t)b->count), sizeof *missing);
    if (!missing)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status =
        bat_spline_insert(a, missing_knots(a, b, true, missing), missing, fine_a);
    if (status == BATTEN_OK)
        status = bat_spline_insert(b, missing_knots(b, a, true, missing), missing, fine_b);
    bat_release(missing);
    return status;
}

/* Rational curves A / a and B / b differ by |(A - B) - (B / b) (a - b)| / a; coordinates from a
 * point near by. */
static double point_difference(const bat_fitting *f, const double *A, const double *B,
                               const double *origin, double radius, double least_weight)
{
    const int d = f->dimension;
    double difference[3];
    if (!f->rational)
        return bat_distance(d, A, B);
    const double dw = A[d] - B[d];
    for (int c = 0; c < d; c++)
        difference[c] = A[c] - B[c] - origin[c] * dw;
    return (bat_norm(d, difference) + radius * fabs(dw)) / least_weight;
}

static void find_extent(const bat_fitting *f, const bat_spline *s, const double *origin,
                        double *radius, double *least_weight)
{
    const int d = f->dimension;
    *radius = 0;
    *least_weight = INFINITY;
    for (int i = 0; f->rational && i < s->count; i++) {
        const double *row = s->values + (size_t)i * f->width;
        double off[3];
        for (int c = 0; c < d; c++)
            off[c] = row[c] / row[d] - origin[c];
        *radius = bat_max(*radius, bat_norm(d, off));
        *least_weight = bat_min(*least_weight, row[d]);
    }
}

/* Bounds in each span of the comb (`error` grows, may be NULL), and of the whole. */
static double compare(const bat_fitting *f, const bat_spline *given, const bat_spline *fit,
                      const bat_spline *fine_a, const bat_spline *fine_b, double *error)
{
    const int p = f->degree;
    double origin[3] = {0, 0, 0}, radius, weight, other_radius, other_weight, worst = 0;
    for (int c = 0; c < f->dimension && f->rational; c++)
        origin[c] = given->values[c] / given->values[f->dimension];
    find_extent(f, given, origin, &other_radius, &weight);
    find_extent(f, fit, origin, &radius, &other_weight);
    if (f->rational && !(other_weight > 0))
        return INFINITY;
    for (int i = 0, span = p; i < fine_a->count; i++) {
        const double greville = bat_greville(p, fine_a->knots, i);
        while (span < fit->count - 1 && fit->knots[span + 1] <= greville)
            span++;
        const double off =
            point_difference(f, fine_a->values + (size_t)i * f->width,
                             fine_b->values + (size_t)i * f->width, origin, radius, weight);
        worst = bat_max(worst, off);
        if (error)
            error[span - p] = bat_max(error[span - p], off);
    }
    return worst;
}

batten_status bat_common_deviation(const bat_fitting *f, const bat_spline *given,
                                   const bat_spline *fit, double *error, double *deviation)
{
    bat_spline fine_a = {0}, fine_b = {0};
    const batten_status status = refine_both(given, fit, &fine_a, &fine_b);
    if (status == BATTEN_OK)
        *deviation = compare(f, given, fit, &fine_a, &fine_b, error);
    bat_spline_free(&fine_b);
    bat_spline_free(&fine_a);
    return status;
}
