/* How far a curve is from its approximation, proved on the common knots of both. */
#include "shape/near/within_proof.h"
#include "numeric/vector.h"
#include "shape/near/within.h"
#include "spline/curve/curve.h"

#include <string.h>

/* ---- the proof ---- */

enum { DEEPEST = 10 };

/* Rows of w (P - S) and of w, [m + 1][d + 1]. */
static void difference_rows(int d, int a, const double *P, const double *w, int b,
                            const double *S, double *out)
{
    for (int k = 0; k <= a + b; k++) {
        double *row = out + k * (d + 1), total = 0;
        memset(row, 0, (size_t)(d + 1) * sizeof *row);
        for (int i = bat_max_int(0, k - b); i <= bat_min_int(a, k); i++) {
            const double factor = bat_binomials[a][i] * bat_binomials[b][k - i],
                         weight = factor * (w ? w[i] : 1);
            for (int c = 0; c < d; c++)
                row[c] += weight * (P[i * d + c] - S[(k - i) * d + c]);
            row[d] += weight;
            total += factor;
        }
        for (int c = 0; c <= d; c++)
            row[c] /= total;
    }
}

static double rows_bound(int d, int m, const double *rows)
{
    double largest = 0, least = rows[d];
    for (int k = 0; k <= m; k++) {
        largest = bat_max(largest, bat_norm(d, rows + k * (d + 1)));
        least = bat_min(least, rows[k * (d + 1) + d]);
    }
    return largest / least;
}

/* The left half into `left`, the right half stays. */
static void halve(int width, int m, double *rows, double *left)
{
    for (int k = 0; k <= m; k++) {
        memcpy(left + k * width, rows, (size_t)width * sizeof *left);
        for (int i = 0; i < (m - k) * width; i++)
            rows[i] = rows[i] / 2 + rows[i + width] / 2;
    }
}

/* A bound on the distance over the span whose rows are the first of `stack`
 * [DEEPEST + 2][m + 1][d + 1]: `floor` or less, or hardly more than it is. */
static double prove(int d, int m, double floor, double *stack)
{
    const size_t size = (size_t)(m + 1) * (size_t)(d + 1);
    int depth[DEEPEST + 2] = {0};
    double bound = 0, seen = 0;
    for (int top = 0; top >= 0;) {
        double *rows = stack + (size_t)top * size, *next = rows + size;
        const double here = rows_bound(d, m, rows);
        seen = bat_max(seen, bat_norm(d, rows) / rows[d]);
        seen = bat_max(seen, bat_norm(d, rows + m * (d + 1)) / rows[m * (d + 1) + d]);
        if (here <= floor || here <= 1.05 * seen || depth[top] == DEEPEST) {
            bound = bat_max(bound, here);
            top--;
            continue;
        }
        halve(d + 1, m, rows, next);
        depth[top]++;
        depth[top + 1] = depth[top];
        top++;
    }
    return bound;
}

/* The Bezier points of a curve on the common spans; *made is yours. */
static batten_status on_common(const batten_curve *curve, const bat_within_source *s,
                               batten_curve **made)
{
    const int own = batten_curve_spans(curve, NULL);
    double *breaks = bat_array((size_t)own, sizeof *breaks);
    double *missing = bat_array((size_t)s->span_count + 1, sizeof *missing);
    batten_curve *refined = NULL;
    batten_status status = breaks && missing ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        int count = 0;
        batten_curve_spans(curve, breaks);
        for (int i = 0, j = 0; i <= s->span_count; i++) {
            while (j < own && breaks[j] < s->common[i])
                j++;
            if (j == own || breaks[j] != s->common[i])
                missing[count++] = s->common[i];
        }
        status = batten_curve_refine(curve, count, missing, &refined);
    }
    if (status == BATTEN_OK)
        status = batten_curve_to_bezier(refined, made);
    batten_curve_unref(refined);
    bat_release(breaks);
    bat_release(missing);
    return status;
}

static batten_status prove_all(const bat_within *w, const batten_curve *P,
                               const batten_curve *S)
{
    bat_within_source *s = w->context;
    const int d = w->dimension, a = batten_curve_degree(P), b = batten_curve_degree(S),
              m = a + b;
    double *stack = bat_array3(DEEPEST + 2, (size_t)(m + 1) * (size_t)(d + 1), sizeof *stack);
    if (!stack)
        return BATTEN_OUT_OF_MEMORY;
    assert(batten_curve_point_count(P) == s->span_count * a + 1);
    assert(batten_curve_point_count(S) == s->span_count * b + 1);
    for (int j = 0; j < s->span_count; j++) {
        const double *weights = batten_curve_weights(P);
        difference_rows(d, a, batten_curve_points(P) + (size_t)(j * a * d),
                        weights ? weights + j * a : NULL, b,
                        batten_curve_points(S) + (size_t)(j * b * d), stack);
        s->bounds[j] = prove(d, m, w->tolerance / 8, stack);
    }
    bat_release(stack);
    return BATTEN_OK;
}

batten_status bat_within_curve_error(bat_within *w, const batten_curve *curve,
                                     const double *parameters, double *distances, double *max)
{
    bat_within_source *s = w->context;
    batten_curve *clamped = NULL, *P = NULL, *S = NULL;
    (void)parameters;
    batten_status status = batten_curve_clamp(curve, &clamped);
    if (status == BATTEN_OK)
        status = on_common(clamped, s, &S);
    if (status == BATTEN_OK)
        status = on_common(s->curve, s, &P);
    if (status == BATTEN_OK)
        status = prove_all(w, P, S);
    *max = 0;
    for (int i = 0; status == BATTEN_OK && i < w->count; i++) {
        distances[i] = s->bounds[s->span_of[i]];
        *max = bat_max(*max, distances[i]);
    }
    batten_curve_unref(S);
    batten_curve_unref(P);
    batten_curve_unref(clamped);
    return status;
}
