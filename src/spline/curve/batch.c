/*
 * Many parameters at once. bat_curve_on_piece defines what is computed; cubics, which are most
 * of what people draw, have loops of their own that do the same operations in the same order,
 * two numbers at a time.
 */
#include "base/work.h"
#include "spline/curve/curve.h"
#include "spline/surface/kernel.h"

#include <stdio.h>

/* Parameters whose pieces are looked up together. */
enum { BLOCK = 256 };

typedef struct batch batch;

/* Evaluate parameters begin .. end - 1, all of which lie in the piece. */
typedef void (*run)(const batch *work, const bat_piece *on, size_t begin, size_t end);

struct batch {
    const batten_curve *curve;
    const bat_pieces *pieces; /* NULL: span by span */
    const double *u;
    int order;
    size_t size;  /* numbers for a parameter */
    bool checked; /* results must be looked at: they may have overflown */
    run run;
    double *out;
};

static void run_any(const batch *work, const bat_piece *on, size_t i, size_t end)
{
    for (; i < end; i++)
        bat_curve_on_piece(work->curve, on, work->u[i], work->order,
                           work->out + i * work->size);
}

/* ---- cubics ---- */

/* The Bernstein polynomials of degree 3, as bat_bernstein makes them. */
#define BERNSTEIN_3(type, t, s)        \
    const type tt = t * t, ss = s * s; \
    const type b0 = ss * s, b1 = 3 * t * ss, b2 = 3 * tt * s, b3 = tt * t

/* Points, two of them in the lanes of a pair. */
BAT_INLINE size_t cubic_pairs(const int d, const bool rational, const batch *work,
                              const bat_piece *on, size_t i, size_t end)
{
    const double a = on->a, h = on->b - on->a, *r = on->rows;
    const size_t stride = d + rational > 2 ? 4 : 2;
    for (; i + 1 < end; i += 2) {
        const bat_pair u = bat_load(work->u + i), t = (u - a) / h,
                       s = rational ? (on->b - u) / h : 1 - t;
        BERNSTEIN_3(bat_pair, t, s);
        bat_pair x[4];
        for (size_t c = 0; c < (size_t)d + rational; c++)
            x[c] = b0 * r[c] + b1 * r[stride + c] + b2 * r[2 * stride + c] +
                   b3 * r[3 * stride + c];
        double *out = work->out + i * (size_t)d;
        for (int c = 0; c < d; c++) {
            const bat_pair value = rational ? x[c] / x[d] : x[c];
            out[c] = value[0];
            out[d + c] = value[1];
        }
    }
    return i;
}

/* Points, the coordinates of one in the lanes. */
BAT_INLINE void cubic_points(const int d, const bool rational, const batch *work,
                             const bat_piece *on, size_t i, size_t end)
{
    const double a = on->a, h = on->b - on->a, *r = on->rows;
    const size_t stride = d + rational > 2 ? 4 : 2;
    i = cubic_pairs(d, rational, work, on, i, end);
    for (; i < end; i++) {
        const double u = work->u[i], t = (u - a) / h, s = rational ? (on->b - u) / h : 1 - t;
        BERNSTEIN_3(double, t, s);
        double x[4];
        for (size_t c = 0; c < stride; c += 2)
            bat_store(x + c, b0 * bat_load(r + c) + b1 * bat_load(r + stride + c) +
                                 b2 * bat_load(r + 2 * stride + c) +
                                 b3 * bat_load(r + 3 * stride + c));
        double *out = work->out + i * (size_t)d;
        for (int c = 0; c < d; c++)
            out[c] = rational ? x[c] / x[d] : x[c];
    }
}

/* Rows of the first and second derivative of a piece, as bat_piece_derive makes them. */
BAT_INLINE void cubic_differences(const bat_piece *on, size_t stride, double *first,
                                  double *second)
{
    const double h = on->b - on->a, f = 3 / h, g = 2 / h, *r = on->rows;
    for (size_t c = 0; c < 3 * stride; c += 2)
        bat_store(first + c, (bat_load(r + stride + c) - bat_load(r + c)) * f);
    for (size_t c = 0; c < 2 * stride; c += 2)
        bat_store(second + c, (bat_load(first + stride + c) - bat_load(first + c)) * g);
}

/* Points with one or two derivatives. */
BAT_INLINE void cubic_derivatives(const int d, const bool rational, const int order,
                                  const batch *work, const bat_piece *on, size_t i, size_t end)
{
    const double a = on->a, h = on->b - on->a, *r = on->rows;
    const size_t stride = d + rational > 2 ? 4 : 2;
    double f[12], g[8], x[12];
    cubic_differences(on, stride, f, g);
    for (; i < end; i++) {
        const double u = work->u[i], t = (u - a) / h, s = rational ? (on->b - u) / h : 1 - t;
        BERNSTEIN_3(double, t, s);
        const double c1 = 2 * t * s;
        for (size_t c = 0; c < stride; c += 2) {
            bat_store(x + c, b0 * bat_load(r + c) + b1 * bat_load(r + stride + c) +
                                 b2 * bat_load(r + 2 * stride + c) +
                                 b3 * bat_load(r + 3 * stride + c));
            bat_store(x + stride + c, ss * bat_load(f + c) + c1 * bat_load(f + stride + c) +
                                          tt * bat_load(f + 2 * stride + c));
            bat_store(x + 2 * stride + c, s * bat_load(g + c) + t * bat_load(g + stride + c));
        }
        double *out = work->out + i * work->size;
        if (rational)
            bat_divide(3, (size_t)d, order, stride, x, out);
        for (int k = 0; !rational && k <= order; k++)
            for (int c = 0; c < d; c++)
                out[k * d + c] = x[(size_t)k * stride + (size_t)c];
    }
}

#define CUBIC(d, rational)                                                               \
    static void cubic_##d##_##rational(const batch *work, const bat_piece *on, size_t i, \
                                       size_t end)                                       \
    {                                                                                    \
        if (work->order == 0)                                                            \
            cubic_points(d, rational, work, on, i, end);                                 \
        else if (on->tight)                                                              \
            run_any(work, on, i, end);                                                   \
        else if (work->order == 1)                                                       \
            cubic_derivatives(d, rational, 1, work, on, i, end);                         \
        else                                                                             \
            cubic_derivatives(d, rational, 2, work, on, i, end);                         \
    }
CUBIC(1, 0)
CUBIC(2, 0)
CUBIC(3, 0)
CUBIC(1, 1)
CUBIC(2, 1)
CUBIC(3, 1)
#undef CUBIC

static run choose_run(const batten_curve *curve, int order)
{
    static const run cubic[2][3] = {{cubic_1_0, cubic_2_0, cubic_3_0},
                                    {cubic_1_1, cubic_2_1, cubic_3_1}};
    if (curve->degree != 3 || order > 2)
        return run_any;
    return cubic[curve->weights != NULL][curve->dimension - 1];
}

/* ---- any curve ---- */

/* One by one: without pieces, and for parameters at the end of the domain or outside. */
static batten_status evaluate_each(const batch *work, size_t begin, size_t end)
{
    for (size_t i = begin; i < end; i++) {
        const batten_status status = batten_curve_evaluate(work->curve, work->u[i], work->order,
                                                           work->out + i * work->size);
        if (status == BATTEN_OK)
            continue;
        char reason[256];
        snprintf(reason, sizeof reason, "%s", batten_message());
        return bat_fail(status, "parameter %zu of the batch: %s", i + 1, reason);
    }
    return BATTEN_OK;
}

/* Are the results of parameters begin .. end - 1 numbers? 0 times a number is 0, times anything
 * else it is none. */
static bool all_finite(const batch *work, size_t begin, size_t end)
{
    double sum = 0;
    for (size_t k = begin * work->size; k < end * work->size; k++)
        sum += 0 * work->out[k];
    return sum == 0;
}

static batten_status evaluate_block(const batch *work, size_t begin, size_t end,
                                    const int *index)
{
    batten_status status = BATTEN_OK;
    for (size_t i = begin, next; i < end && status == BATTEN_OK; i = next) {
        const int piece = index[i - begin];
        for (next = i + 1; next < end && index[next - begin] == piece;)
            next++;
        if (piece < 0) {
            status = evaluate_each(work, i, next);
            continue;
        }
        const bat_piece on = bat_pieces_get(work->pieces, work->curve->degree, piece);
        work->run(work, &on, i, next);
    }
    if (status == BATTEN_OK && work->checked && !all_finite(work, begin, end))
        status = evaluate_each(work, begin, end); /* to say where */
    return status;
}

static batten_status evaluate_range(void *context, size_t begin, size_t end)
{
    const batch *work = context;
    int index[BLOCK];
    if (!work->pieces)
        return evaluate_each(work, begin, end);
    batten_status status = BATTEN_OK;
    for (size_t i = begin, next; i < end && status == BATTEN_OK; i = next) {
        next = end - i > BLOCK ? i + BLOCK : end;
        bat_pieces_locate(work->pieces, next - i, work->u + i, index);
        status = evaluate_block(work, i, next, index);
    }
    return status;
}

batten_status batten_curve_evaluate_many(const batten_curve *curve, size_t count,
                                         const double *u, int order, const batten_job *job,
                                         double *out)
{
    assert(curve && (count == 0 || (u && out)) && order >= 0);
    const bat_pieces *pieces = bat_curve_pieces(curve, count);
    batch work = {.curve = curve, .pieces = pieces, .u = u, .order = order, .out = out};
    work.size = ((size_t)order + 1) * (size_t)curve->dimension;
    work.checked = order > 0 || (pieces && !pieces->bounded);
    work.run = choose_run(curve, order);
    /* Some 20 microseconds of work or more for a chunk. */
    return bat_parallel(job, count, 4096, evaluate_range, &work);
}
