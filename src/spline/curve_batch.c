/*
 * Many parameters at once. bat_curve_on_piece defines what is computed; cubics, which are most of what people draw, have
 * loops of their own that do the same operations in the same order, two numbers at a time.
 */
#include "base/work.h"
#include "spline/curve.h"
#include "spline/surface_kernel.h"

typedef struct batch batch;

/* Evaluate parameters from begin on as long as they lie in the piece; the first that does not, or `end`. */
typedef size_t (*run)(const batch *work, const bat_piece *on, size_t begin, size_t end);

struct batch {
    const batten_curve *curve;
    const bat_pieces *pieces; /* NULL: span by span */
    const double *u;
    int order;
    size_t size; /* numbers for a parameter */
    bool checked; /* results must be looked at: they may have overflown */
    double last;  /* end of the domain, which belongs to the last piece */
    run run;
    double *out;
};

static inline bool holds(const batch *work, const bat_piece *on, size_t i, size_t end)
{
    return i < end && work->u[i] >= on->a && work->u[i] < on->b;
}

static size_t run_any(const batch *work, const bat_piece *on, size_t i, size_t end)
{
    for (; holds(work, on, i, end); i++)
        bat_curve_on_piece(work->curve, on, work->u[i], work->order, work->out + i * work->size);
    return i;
}

/* ---- cubics ---- */

/* The Bernstein polynomials of degree 3, as bat_bernstein makes them. */
#define BERNSTEIN_3(type, t)                                                                   \
    const type s = 1 - t, tt = t * t, ss = s * s;                                              \
    const type b0 = ss * s, b1 = 3 * t * ss, b2 = 3 * tt * s, b3 = tt * t

/* Points, two of them in the lanes of a pair. */
BAT_INLINE size_t cubic_pairs(const int d, const bool rational, const batch *work, const bat_piece *on,
                              size_t i, size_t end)
{
    const double a = on->a, h = on->b - on->a, *r = on->rows;
    const size_t stride = d + rational > 2 ? 4 : 2;
    for (; holds(work, on, i, end) && holds(work, on, i + 1, end); i += 2) {
        const bat_pair t = (bat_load(work->u + i) - a) / h;
        BERNSTEIN_3(bat_pair, t);
        bat_pair x[4];
        for (size_t c = 0; c < (size_t)d + rational; c++)
            x[c] = b0 * r[c] + b1 * r[stride + c] + b2 * r[2 * stride + c] + b3 * r[3 * stride + c];
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
BAT_INLINE size_t cubic_points(const int d, const bool rational, const batch *work, const bat_piece *on,
                               size_t i, size_t end)
{
    const double a = on->a, h = on->b - on->a, *r = on->rows;
    const size_t stride = d + rational > 2 ? 4 : 2;
    i = cubic_pairs(d, rational, work, on, i, end);
    for (; holds(work, on, i, end); i++) {
        const double t = (work->u[i] - a) / h;
        BERNSTEIN_3(double, t);
        double x[4];
        for (size_t c = 0; c < stride; c += 2)
            bat_store(x + c, b0 * bat_load(r + c) + b1 * bat_load(r + stride + c) +
                                 b2 * bat_load(r + 2 * stride + c) + b3 * bat_load(r + 3 * stride + c));
        double *out = work->out + i * (size_t)d;
        for (int c = 0; c < d; c++)
            out[c] = rational ? x[c] / x[d] : x[c];
    }
    return i;
}

/* Rows of the first and second derivative of a piece, as bat_piece_derive makes them. */
BAT_INLINE void cubic_differences(const bat_piece *on, size_t stride, double *first, double *second)
{
    const double h = on->b - on->a, f = 3 / h, g = 2 / h, *r = on->rows;
    for (size_t c = 0; c < 3 * stride; c += 2)
        bat_store(first + c, (bat_load(r + stride + c) - bat_load(r + c)) * f);
    for (size_t c = 0; c < 2 * stride; c += 2)
        bat_store(second + c, (bat_load(first + stride + c) - bat_load(first + c)) * g);
}

/* Points with one or two derivatives. */
BAT_INLINE size_t cubic_derivatives(const int d, const bool rational, const int order, const batch *work,
                                    const bat_piece *on, size_t i, size_t end)
{
    const double a = on->a, h = on->b - on->a, *r = on->rows;
    const size_t stride = d + rational > 2 ? 4 : 2;
    double f[12], g[8], x[12];
    cubic_differences(on, stride, f, g);
    for (; holds(work, on, i, end); i++) {
        const double t = (work->u[i] - a) / h;
        BERNSTEIN_3(double, t);
        const double c1 = 2 * t * s;
        for (size_t c = 0; c < stride; c += 2) {
            bat_store(x + c, b0 * bat_load(r + c) + b1 * bat_load(r + stride + c) +
                                 b2 * bat_load(r + 2 * stride + c) + b3 * bat_load(r + 3 * stride + c));
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
    return i;
}

#define CUBIC(d, rational)                                                                     \
    static size_t cubic_##d##_##rational(const batch *work, const bat_piece *on, size_t i,     \
                                         size_t end)                                           \
    {                                                                                          \
        if (work->order == 0)                                                                  \
            return cubic_points(d, rational, work, on, i, end);                                \
        if (on->tight)                                                                         \
            return run_any(work, on, i, end);                                                  \
        if (work->order == 1)                                                                  \
            return cubic_derivatives(d, rational, 1, work, on, i, end);                        \
        return cubic_derivatives(d, rational, 2, work, on, i, end);                            \
    }
CUBIC(1, 0)
CUBIC(2, 0)
CUBIC(3, 0)
CUBIC(1, 1)
CUBIC(2, 1)
CUBIC(3, 1)
#undef CUBIC

static run choose_run(const batten_curve *curve, const bat_pieces *pieces, int order)
{
    static const run cubic[2][3] = {{cubic_1_0, cubic_2_0, cubic_3_0}, {cubic_1_1, cubic_2_1, cubic_3_1}};
    if (!pieces || curve->degree != 3 || order > 2)
        return run_any;
    return cubic[curve->weights != NULL][curve->dimension - 1];
}

/* ---- any curve ---- */

static bat_piece find_piece(const batch *work, double u, double *rows)
{
    const batten_curve *curve = work->curve;
    const bat_pieces *pieces = work->pieces;
    if (pieces)
        return bat_pieces_find(pieces, curve->degree, u);
    return bat_curve_piece(
        curve, bat_knots_span(curve->degree, curve->count, curve->knots, u, BATTEN_FROM_RIGHT), rows);
}

/* A parameter at the end of the domain or outside it. */
static batten_status evaluate_placed(const batch *work, size_t i, double *rows)
{
    double u = work->u[i];
    const batten_status status = bat_curve_place(work->curve, BATTEN_FROM_RIGHT, &u);
    if (status != BATTEN_OK)
        return status;
    const bat_piece on = find_piece(work, u, rows);
    bat_curve_on_piece(work->curve, &on, u, work->order, work->out + i * work->size);
    return BATTEN_OK;
}

/* Are the results of parameters i .. end - 1 numbers? 0 times a number is 0, times anything else it is none. */
static batten_status check_results(const batch *work, size_t i, size_t end)
{
    const size_t total = (end - i) * work->size;
    const double *out = work->out + i * work->size;
    double sum = 0;
    for (size_t k = 0; work->checked && k < total; k++)
        sum += 0 * out[k];
    if (sum == 0)
        return BATTEN_OK;
    while (bat_curve_check_result(work->u[i], work->size, work->out + i * work->size) == BATTEN_OK)
        i++;
    return bat_fail(BATTEN_OVERFLOW, "parameter %zu of the batch, %.17g: the point or a derivative is too large for a number",
                    i, work->u[i]);
}

static batten_status evaluate_range(void *context, size_t begin, size_t end)
{
    const batch *work = context;
    const double first = work->curve->knots[work->curve->degree];
    double rows[BAT_MAX_ROWS];
    for (size_t i = begin, next; i < end; i = next) {
        const double u = work->u[i];
        batten_status status = BATTEN_OK;
        if (u >= first && u < work->last) {
            const bat_piece on = find_piece(work, u, rows);
            next = work->run(work, &on, i, end);
        } else {
            status = evaluate_placed(work, i, rows);
            next = i + 1;
        }
        if (status != BATTEN_OK)
            return bat_fail(status, "parameter %zu of the batch, %.17g: %s", i, u, batten_status_text(status));
        status = check_results(work, i, next);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

batten_status batten_curve_evaluate_many(const batten_curve *curve, size_t count, const double *u,
                                         int order, const batten_job *job, double *out)
{
    assert(curve && (count == 0 || (u && out)) && order >= 0);
    const bat_pieces *pieces = bat_curve_pieces(curve, count);
    batch work = {.curve = curve, .pieces = pieces, .u = u, .order = order, .out = out};
    work.size = ((size_t)order + 1) * (size_t)curve->dimension;
    work.checked = order > 0 || !pieces || !pieces->bounded;
    work.last = curve->knots[curve->count];
    work.run = choose_run(curve, pieces, order);
    (void)job;
    return evaluate_range(&work, 0, count);
}
