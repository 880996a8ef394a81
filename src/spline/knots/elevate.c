/*
 * Degree elevation through the blossom [Prautzsch84]: a control point of degree q = p + 1 is
 * the mean of f(.. without v_i ..) over its q knots v, and each of these is a control point of
 * a refinement of the old spline, a convex combination of old points. So nothing is
 * extrapolated, however unequal the spans.
 */
#include "spline/spline.h"

#include <string.h>

/* Weights [p + 1] of the rows span - p .. span in the blossom at t[0..p-1] of a refinement
 * whose knot before t[0] lies in the span: discrete B-splines [Cohen80]. A weight 0 may belong
 * to a row or knot that does not exist. */
static void refined_weights(int p, const double *knots, int span, const double *t, double *out)
{
    const double *U = knots + span;
    out[0] = 1;
    for (int r = 1; r <= p; r++) {
        double kept = 0;
        for (int j = 0; j < r; j++) {
            double low = kept, high = 0;
            if (out[j] != 0) {
                const double left = U[1 + j - r], right = U[1 + j];
                const double share = out[j] / (right - left);
                low = kept + (right - t[r - 1]) * share;
                high = (t[r - 1] - left) * share;
            }
            out[j] = low;
            kept = high;
        }
        out[r] = kept;
    }
}

void bat_elevation_row(int degree, const double *knots, int span, const double *window,
                       double *out)
{
    const int p = degree, q = p + 1;
    double t[BATTEN_MAX_DEGREE], weights[BATTEN_MAX_DEGREE + 1];
    memset(out, 0, (size_t)q * sizeof *out);
    for (int i = 0, next; i < q; i = next) {
        for (next = i + 1; next < q && window[next] == window[i];)
            next++;
        memcpy(t, window, (size_t)i * sizeof *t);
        memcpy(t + i, window + i + 1, (size_t)(p - i) * sizeof *t);
        refined_weights(p, knots, span, t, weights);
        for (int j = 0; j <= p; j++)
            out[j] += (next - i) * weights[j];
    }
    for (int j = 0; j <= p; j++)
        out[j] /= q;
}

/* Every distinct knot once more. */
static int doubled(int knot_count, const double *knots, double *out)
{
    int count = 0;
    for (int i = 0; i < knot_count; i++) {
        if (i == 0 || knots[i] > knots[i - 1])
            out[count++] = knots[i];
        out[count++] = knots[i];
    }
    return count;
}

/* The start of the domain stands last at q, its end first at the new number of points, which is
 * returned. */
static int trim_to_domain(batten_interval domain, int q, int made, double *T)
{
    int begin = 0, end = made - 1;
    while (T[begin + 1] <= domain.a)
        begin++;
    while (T[end - 1] >= domain.b)
        end--;
    memmove(T, T + begin - q, (size_t)(end - begin + 2 * q + 1) * sizeof *T);
    return end - begin + q;
}

/* The knots of degree + 1 and the number of points they go with; the caller's to release. */
static batten_status elevate_knots(int degree, int count, const double *knots, double **out,
                                   int *point_count)
{
    const int p = degree, knot_count = count + p + 1;
    double *T = bat_array((size_t)knot_count * 2, sizeof *T);
    if (!T)
        return BATTEN_OUT_OF_MEMORY;
    const int made = doubled(knot_count, knots, T);
    *point_count = trim_to_domain((batten_interval){knots[p], knots[count]}, p + 1, made, T);
    *out = T;
    return BATTEN_OK;
}

/* row += the rows from `first` on, each by its weight. */
static void combine_rows(const bat_spline *from, int first, const double *weights, double *row)
{
    for (int i = 0; i <= from->degree; i++) {
        if (weights[i] == 0)
            continue;
        const double *source = from->values + (size_t)(first + i) * from->width;
        for (size_t c = 0; c < from->width; c++)
            row[c] += weights[i] * source[c];
    }
}

static void elevate_rows(const bat_spline *from, const bat_spline *to)
{
    const int p = from->degree;
    double weights[BATTEN_MAX_DEGREE + 1];
    int span = 0;
    for (int j = 0; j < to->count; j++) {
        while (from->knots[span + 1] <= to->knots[j])
            span++;
        bat_elevation_row(p, from->knots, span, to->knots + j + 1, weights);
        combine_rows(from, span - p, weights, to->values + (size_t)j * to->width);
    }
}

static batten_status elevate_once(const bat_spline *spline, bat_spline *out)
{
    bat_spline made = {.degree = spline->degree + 1, .width = spline->width};
    batten_status status =
        elevate_knots(spline->degree, spline->count, spline->knots, &made.knots, &made.count);
    if (status != BATTEN_OK)
        return status;
    made.values = bat_array3((size_t)made.count, made.width, sizeof *made.values);
    if (!made.values) {
        bat_spline_free(&made);
        return BATTEN_OUT_OF_MEMORY;
    }
    elevate_rows(spline, &made);
    *out = made;
    return BATTEN_OK;
}

batten_status bat_spline_elevate(const bat_spline *spline, int by, bat_spline *out)
{
    bat_spline made;
    batten_status status = bat_spline_insert(spline, 0, NULL, &made);
    for (int i = 0; status == BATTEN_OK && i < by; i++) {
        bat_spline next = {0};
        status = elevate_once(&made, &next);
        bat_spline_free(&made);
        made = next;
    }
    if (status == BATTEN_OK)
        *out = made;
    return status;
}
