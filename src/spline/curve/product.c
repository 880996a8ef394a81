/*
 * The product of two splines, piece by piece in Bernstein form:
 * c_k = sum over i + j = k of C(p, i) C(q, j) / C(p + q, k) a_i b_j.
 */
#include "spline/curve/product.h"

#include "spline/curve/curve.h"

#include <float.h>

/* The breaks of `from` that `to` lacks. Breaks within a few roundings of each other are one. */
static int lacking(int from_count, const double *from, int to_count, const double *to,
                   double *out)
{
    const double near = 8 * DBL_EPSILON * bat_max(fabs(to[0]), fabs(to[to_count - 1]));
    int count = 0;
    for (int i = 0, j = 0; i < from_count; i++) {
        while (j < to_count && to[j] < from[i] - near)
            j++;
        if (j == to_count || to[j] > from[i] + near)
            out[count++] = from[i];
    }
    return count;
}

/* Both with the breaks of both, in Bezier form. */
static batten_status meet(const batten_curve *const in[2], batten_curve *out[2])
{
    int counts[2];
    double *breaks[2], *more = NULL;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2; k++) {
        breaks[k] = bat_array((size_t)in[k]->count + 1, sizeof **breaks);
        if (breaks[k])
            counts[k] = batten_curve_spans(in[k], breaks[k]);
        else
            status = BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK)
        more = bat_array((size_t)in[0]->count + (size_t)in[1]->count + 2, sizeof *more);
    if (status == BATTEN_OK && !more)
        status = BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        batten_curve *refined = NULL;
        const int count = lacking(counts[1 - k], breaks[1 - k], counts[k], breaks[k], more);
        status = batten_curve_refine(in[k], count, more, &refined);
        if (status == BATTEN_OK)
            status = batten_curve_to_bezier(refined, &out[k]);
        batten_curve_unref(refined);
    }
    bat_release(more);
    bat_release(breaks[0]);
    bat_release(breaks[1]);
    return status;
}

static void multiply_piece(int p, const double *a, int q, int d, const double *b, double *c)
{
    for (int k = 0; k <= p + q; k++)
        for (int x = 0; x < d; x++) {
            double sum = 0;
            for (int i = bat_max_int(0, k - q); i <= bat_min_int(p, k); i++)
                sum +=
                    bat_binomials[p][i] * bat_binomials[q][k - i] * a[i] * b[(k - i) * d + x];
            c[k * d + x] = sum / bat_binomials[p + q][k];
        }
}

static batten_status multiply(const batten_curve *scalar, const batten_curve *curve,
                              batten_curve **out)
{
    const int p = scalar->degree, q = curve->degree, d = curve->dimension;
    const int pieces = (curve->count - 1) / q, n = p + q;
    assert((scalar->count - 1) / p == pieces);
    double *breaks = bat_array((size_t)pieces + 1, sizeof *breaks);
    double *points = bat_array3((size_t)pieces * (size_t)n + 1, (size_t)d, sizeof *points);
    batten_status status = breaks && points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_curve_spans(curve, breaks);
        for (int k = 0; k < pieces; k++)
            multiply_piece(p, scalar->points + (size_t)k * (size_t)p, q, d,
                           curve->points + (size_t)k * (size_t)q * (size_t)d,
                           points + (size_t)k * (size_t)n * (size_t)d);
        status =
            batten_curve_from_bezier(d, (batten_pieces){n, pieces, breaks}, points, NULL, out);
    }
    bat_release(points);
    bat_release(breaks);
    return status;
}

batten_status bat_curve_product(const batten_curve *scalar, const batten_curve *curve,
                                batten_curve **out)
{
    assert(scalar->dimension == 1 && !scalar->weights && !curve->weights);
    if (scalar->degree + curve->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "a product of degrees %d and %d is above degree %d",
                        scalar->degree, curve->degree, BATTEN_MAX_DEGREE);
    batten_curve *clamped[2] = {NULL, NULL}, *bezier[2] = {NULL, NULL};
    batten_status status = batten_curve_clamp(scalar, &clamped[0]);
    if (status == BATTEN_OK)
        status = batten_curve_clamp(curve, &clamped[1]);
    if (status == BATTEN_OK)
        status = meet((const batten_curve *const *)clamped, bezier);
    if (status == BATTEN_OK)
        status = multiply(bezier[0], bezier[1], out);
    for (int k = 0; k < 2; k++) {
        batten_curve_unref(bezier[k]);
        batten_curve_unref(clamped[k]);
    }
    return status;
}
