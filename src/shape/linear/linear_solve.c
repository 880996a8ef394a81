/*
 * Solving the factored interpolation system for given data: right sides, Bessel and fair end
 * slopes, and a check of the residual, with one step of iterative refinement if it is too
 * large.
 */
#include "shape/linear/linear_solve.h"
#include "numeric/banded.h"

#include <float.h>
#include <string.h>

void bat_bessel_slope(size_t width, const double h[2], const double *const points[3],
                      double *slope)
{
    const double *a = points[0], *b = points[1], *c = points[2];
    const double share = h[0] / (h[0] + h[1]);
    for (size_t k = 0; k < width; k++) {
        const double d0 = (b[k] - a[k]) / h[0], d1 = (c[k] - b[k]) / h[1];
        slope[k] = d0 + share * (d0 - d1);
    }
}

/* All that the right sides are made from. */
typedef struct {
    const bat_operator *op;
    bat_spline_data given;
    double *slopes; /* [2][width], at the ends */
    double *zeros;  /* [width] */
} right_side;

static const double *row_of(const right_side *b, const bat_row *row)
{
    switch (row->source) {
    case BAT_FROM_DATA:
        return b->given.data + (size_t)row->index * b->given.width;
    case BAT_FROM_START:
        return b->given.start ? b->given.start : b->zeros;
    case BAT_FROM_END:
        return b->given.end ? b->given.end : b->zeros;
    case BAT_FROM_BESSEL_START:
        return b->slopes;
    case BAT_FROM_BESSEL_END:
        return b->slopes + b->given.width;
    case BAT_FROM_ZERO:
        return b->zeros;
    default:
        return b->given.conditions + (size_t)row->source * b->given.width;
    }
}

/* Runs of data are copied at once. */
static void fill_right_side(const right_side *b, double *x)
{
    const bat_operator *op = b->op;
    for (int i = 0, end; i < op->count; i = end) {
        for (end = i + 1; end < op->count && op->rows[i].source == BAT_FROM_DATA; end++)
            if (op->rows[end].source != BAT_FROM_DATA ||
                op->rows[end].index != op->rows[end - 1].index + 1)
                break;
        memcpy(x + (size_t)i * b->given.width, row_of(b, &op->rows[i]),
               (size_t)(end - i) * b->given.width * sizeof *x);
    }
}

/* Bessel's slopes at both ends; two points have but one slope. */
static void make_slopes(const right_side *b)
{
    const bat_operator *op = b->op;
    const size_t w = b->given.width, last = (size_t)op->data_count - 1;
    const double *first = b->given.data, *end = b->given.data + last * w;
    const bool two = op->data_count == 2;
    const double *const from_start[] = {first, first + w, two ? end : first + 2 * w};
    const double *const from_end[] = {end, end - w, two ? first : end - 2 * w};
    bat_bessel_slope(w, (const double[]){op->step[0], op->step[1]}, from_start, b->slopes);
    bat_bessel_slope(w, (const double[]){-op->step[3], -op->step[2]}, from_end, b->slopes + w);
}

/* The last `shift` numbers come first. */
static batten_status turn_sequence(size_t size, size_t shift, double *x)
{
    double *turned = bat_array(size, sizeof *turned);
    if (!turned)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(turned, x, size * sizeof *x);
    memcpy(x + shift, turned, (size - shift) * sizeof *x);
    memcpy(x, turned + (size - shift), shift * sizeof *x);
    bat_release(turned);
    return BATTEN_OK;
}

/* In place: solve, and for a periodic spline turn the sequence so that it begins with point 0.
 */
static batten_status solve(const bat_operator *op, size_t width, double *x)
{
    if (!op->periodic) {
        bat_banded_solve(op->count, op->lower, op->upper, op->factor, width, x);
        return BATTEN_OK;
    }
    const batten_status status = bat_cyclic_solve(op->cyclic, width, x);
    return status == BATTEN_OK ? turn_sequence((size_t)op->count * width,
                                               (size_t)(op->lower % op->count) * width, x)
                               : status;
}

/* The slopes at the fair ends, and the control values with them, that make the jumps least. */
static void make_fair(const right_side *b, double *x)
{
    const bat_operator *op = b->op;
    const size_t n = (size_t)op->count;
    const int ends = op->fair_count;
    const double determinant =
        ends == 2 ? op->gram[0][0] * op->gram[1][1] - op->gram[0][1] * op->gram[1][0] : 0;
    for (size_t k = 0; k < b->given.width; k++) {
        double pull[2] = {0, 0}, change[2];
        for (int e = 0; e < ends; e++)
            for (size_t i = 0; i < n; i++)
                pull[e] -= op->gradient[(size_t)e * n + i] * x[i * b->given.width + k];
        change[0] = ends == 1
                        ? pull[0] / op->gram[0][0]
                        : (pull[0] * op->gram[1][1] - pull[1] * op->gram[0][1]) / determinant;
        change[1] =
            ends == 1 ? 0 : (pull[1] * op->gram[0][0] - pull[0] * op->gram[1][0]) / determinant;
        for (int e = 0; e < ends; e++) {
            const bool at_start = op->rows[op->fair_row[e]].source == BAT_FROM_BESSEL_START;
            b->slopes[(at_start ? 0 : b->given.width) + k] += change[e];
            for (size_t i = 0; i < n; i++)
                x[i * b->given.width + k] += change[e] * op->response[(size_t)e * n + i];
        }
    }
}

static inline double largest(size_t count, const double *values)
{
    double size = 0;
    for (size_t i = 0; i < count; i++)
        size = bat_max(size, fabs(values[i]));
    return size;
}

#define ALWAYS_INLINE static inline __attribute__((always_inline))

/* residual[width] of equation i: right side - matrix x. */
ALWAYS_INLINE void residual_row(const right_side *b, size_t width, const double *x, int i,
                                double *residual)
{
    const bat_operator *op = b->op;
    const int w = op->lower + op->upper + 1, n = op->count;
    const double *a = op->matrix + (size_t)i * (size_t)w, *right = row_of(b, &op->rows[i]);
    for (size_t k = 0; k < width; k++)
        residual[k] = right[k];
    const int first = op->periodic ? 0 : bat_max_int(0, op->lower - i);
    const int last = op->periodic ? w : bat_min_int(w, n - i + op->lower);
    for (int j = first; j < last; j++) {
        const int column = op->periodic ? (i + j) % n : i + j - op->lower;
        const double *row = x + (size_t)column * width;
        for (size_t k = 0; k < width; k++)
            residual[k] -= a[j] * row[k];
    }
}

/* By how much the spline misses its data at worst, and where. */
ALWAYS_INLINE double worst_of(const right_side *b, size_t width, const double *x,
                              double *residual, int *where)
{
    double worst = 0;
    for (int i = 0; i < b->op->count; i++) {
        if (b->op->rows[i].source != BAT_FROM_DATA)
            continue;
        residual_row(b, width, x, i, residual);
        const double miss = largest(width, residual);
        if (miss > worst || miss != miss) {
            worst = miss;
            *where = b->op->rows[i].index;
        }
    }
    return worst;
}

/* The widths of numbers and of points get loops of their own. */
static double worst_miss(const right_side *b, const double *x, double *residual, int *where)
{
    double few[3];
    switch (b->given.width) {
    case 1:
        return worst_of(b, 1, x, few, where);
    case 2:
        return worst_of(b, 2, x, few, where);
    case 3:
        return worst_of(b, 3, x, few, where);
    default:
        return worst_of(b, b->given.width, x, residual, where);
    }
}

/* One step of iterative refinement. */
static batten_status refine(const right_side *b, double *x)
{
    const size_t size = (size_t)b->op->count * b->given.width;
    double *step = bat_array(size, sizeof *step);
    if (!step)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < b->op->count; i++)
        residual_row(b, b->given.width, x, i, step + (size_t)i * b->given.width);
    const batten_status status = solve(b->op, b->given.width, step);
    for (size_t i = 0; status == BATTEN_OK && i < size; i++)
        x[i] += step[i];
    bat_release(step);
    return status;
}

static batten_status check_residual(const right_side *b, double *x, double *residual)
{
    const size_t n = (size_t)b->op->count * b->given.width;
    for (int attempt = 0;; attempt++) {
        const double size = bat_max(
            largest((size_t)b->op->data_count * b->given.width, b->given.data), largest(n, x));
        if (bat_first_not_finite(x, n) < n)
            return bat_fail(BATTEN_OVERFLOW, "a control point became too large");
        int where = 0;
        const double miss = worst_miss(b, x, residual, &where);
        if (miss <= 8 * DBL_EPSILON * size)
            return BATTEN_OK;
        if (attempt == 1)
            return bat_fail(
                BATTEN_TOLERANCE_NOT_MET,
                "data point %d is missed by %g, more than 8 eps of the largest number %g",
                where + 1, miss, size);
        const batten_status status = refine(b, x);
        if (status != BATTEN_OK)
            return status;
    }
}

batten_status bat_operator_apply(const bat_operator *op, const bat_spline_data *given,
                                 double *control)
{
    const size_t width = given->width;
    double *scratch = bat_array3(4, width, sizeof *scratch);
    if (!scratch)
        return BATTEN_OUT_OF_MEMORY;
    const right_side b = {op, *given, scratch, scratch + 2 * width};
    if (!op->periodic)
        make_slopes(&b);
    fill_right_side(&b, control);
    batten_status status = solve(op, width, control);
    if (status == BATTEN_OK && op->fair_count > 0)
        make_fair(&b, control);
    if (status == BATTEN_OK)
        status = check_residual(&b, control, scratch + 3 * width);
    bat_release(scratch);
    return status;
}
