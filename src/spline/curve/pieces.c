/* All spans of a curve in Bezier form, made once for batches. */
#include "spline/curve/curve.h"

#include <stdint.h>
#include <string.h>

void bat_curve_rows(const batten_curve *curve, int first, int count, size_t stride,
                    double *rows)
{
    const size_t d = (size_t)curve->dimension;
    const double *point = curve->points + (size_t)first * d;
    for (int i = 0; i < count; i++, point += d, rows += stride) {
        const double w = curve->weights ? curve->weights[first + i] * curve->weight_scale : 1;
        for (size_t k = 0; k < d; k++)
            rows[k] = w * point[k];
        if (curve->weights)
            rows[d] = w;
        for (size_t k = bat_curve_width(curve); k < stride; k++)
            rows[k] = 0;
    }
}

void bat_pieces_free(bat_pieces *pieces)
{
    if (!pieces)
        return;
    bat_release(pieces->breaks);
    bat_release(pieces->rows);
    bat_release(pieces->spans);
    bat_release(pieces->tight);
    bat_release(pieces->guide);
    bat_release(pieces);
}

static bat_pieces *allocate(const batten_curve *curve)
{
    bat_pieces *made = bat_array(1, sizeof *made);
    if (!made)
        return NULL;
    const size_t count = (size_t)batten_curve_spans(curve, NULL) - 1;
    made->count = (int)count;
    made->stride = bat_curve_width(curve) > 2 ? 4 : 2;
    made->breaks = bat_array(count + 1, sizeof *made->breaks);
    made->rows =
        bat_array3(count, ((size_t)curve->degree + 1) * made->stride, sizeof *made->rows);
    made->spans = bat_array(count, sizeof *made->spans);
    made->tight = bat_array(count, sizeof *made->tight);
    made->guide = bat_array(count + 1, sizeof *made->guide);
    if (made->breaks && made->rows && made->spans && made->tight && made->guide)
        return made;
    bat_pieces_free(made);
    return NULL;
}

static void fill_rows(const batten_curve *curve, bat_pieces *pieces)
{
    const int p = curve->degree;
    const double *U = curve->knots;
    const size_t size = ((size_t)p + 1) * pieces->stride;
    for (int k = p, i = 0; k < curve->count; k++) {
        if (U[k] == U[k + 1])
            continue;
        double *rows = pieces->rows + (size_t)i * size;
        bat_curve_rows(curve, k - p, p + 1, pieces->stride, rows);
        bat_piece_from_rows(p, U, k, pieces->stride, rows);
        pieces->tight[i] = bat_span_is_tight(p, U, k);
        pieces->spans[i++] = k;
    }
    const size_t total = (size_t)pieces->count * size,
                 numbers = (size_t)curve->count * (size_t)curve->dimension;
    double largest = 0;
    for (size_t i = 0; i < total; i++)
        largest = bat_max(largest, fabs(pieces->rows[i]));
    for (size_t i = 0; i < numbers; i++)
        largest = bat_max(largest, fabs(curve->points[i]));
    pieces->bounded = largest < 1e300;
}

/* Which of `count` equal slices of the domain u lies in; rises with u, whatever the rounding.
 */
static inline int slice(const bat_pieces *pieces, double u)
{
    return bat_min_int((int)((u - pieces->breaks[0]) * pieces->slices), pieces->count - 1);
}

/* From the breaks in each slice to those up to it; the most in one. */
static int sum_guide(bat_pieces *pieces)
{
    int most = 0;
    for (int j = 0; j < pieces->count; j++) {
        most = bat_max_int(most, pieces->guide[j + 1]);
        pieces->guide[j + 1] += pieces->guide[j];
    }
    return most;
}

/* guide[j]: how many inner breaks lie in slices before j. Pieces that reach into slice j are
 * those from guide[j] to guide[j + 1]. */
static void fill_guide(bat_pieces *pieces)
{
    const double slices = pieces->count / (pieces->breaks[pieces->count] - pieces->breaks[0]);
    pieces->slices = isfinite(slices) ? slices : 0;
    for (int i = 1; i < pieces->count; i++)
        pieces->guide[slice(pieces, pieces->breaks[i]) + 1]++;
    const int most = sum_guide(pieces);
    pieces->step = 1;
    while (2 * pieces->step <= most)
        pieces->step *= 2;
}

/* Index of the piece that holds u. As many halvings for each u, and no branch: random
 * parameters are not to be guessed. */
static inline int find(const bat_pieces *pieces, double u)
{
    const int j = slice(pieces, u), last = pieces->guide[j + 1];
    int low = pieces->guide[j];
    for (int step = pieces->step; step > 0; step /= 2) {
        const int probe = bat_min_int(low + step, last);
        low = pieces->breaks[probe] <= u ? probe : low;
    }
    return low;
}

bat_piece bat_pieces_get(const bat_pieces *pieces, int degree, int index)
{
    const size_t size = ((size_t)degree + 1) * pieces->stride;
    return (bat_piece){
        pieces->spans[index], pieces->breaks[index], pieces->breaks[index + 1],
        pieces->tight[index], pieces->stride,        pieces->rows + (size_t)index * size};
}

bat_piece bat_pieces_find(const bat_pieces *pieces, int degree, double u)
{
    return bat_pieces_get(pieces, degree, find(pieces, u));
}

void bat_pieces_locate(const bat_pieces *pieces, size_t count, const double *u, int *index)
{
    const double *breaks = pieces->breaks, first = breaks[0], end = breaks[pieces->count];
    int here = 0;
    for (size_t i = 0; i < count; i++) {
        const bool stays = u[i] >= breaks[here] && u[i] < breaks[here + 1];
        if (!stays && u[i] >= first && u[i] < end)
            here = find(pieces, u[i]);
        index[i] = u[i] >= first && u[i] < end ? here : -1;
    }
}

const bat_pieces *bat_curve_pieces(const batten_curve *curve, size_t count)
{
    batten_curve *shared =
        (batten_curve *)(uintptr_t)curve; /* the cache is no part of the shape */
    bat_pieces *pieces = atomic_load_explicit(&shared->pieces, memory_order_acquire);
    if (pieces || count < (size_t)(curve->count - curve->degree) / 8 + 1)
        return pieces;
    bat_pieces *made = allocate(curve);
    if (!made)
        return NULL;
    batten_curve_spans(curve, made->breaks);
    fill_rows(curve, made);
    fill_guide(made);
    if (atomic_compare_exchange_strong(&shared->pieces, &pieces, made))
        return made;
    bat_pieces_free(made);
    return pieces;
}
