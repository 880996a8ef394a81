/*
 * Degree reduction: the spline of degree q = p - 1, every inner knot standing once less (but
 * once at least), whose elevated rows come nearest to those given, in the sense of least
 * squares with both ends kept. For a Bezier curve without end conditions that is the best
 * polynomial in L2 as well [Lutterkort99]. The largest difference of the rows bounds the
 * movement.
 */
#include "numeric/banded.h"
#include "numeric/vector.h"
#include "spline/spline.h"

#include <string.h>

/* The equations of one step. */
typedef struct {
    bat_spline target; /* the given spline on the knots of the elevated result */
    bat_spline made;   /* the result */
    double *weights;   /* [target.count][q + 1] rows of the elevation matrix */
    int *spans;        /* [target.count] the last column of each */
    double *matrix;    /* [unknowns][q + 1] lower half of E^T E */
    double *right;     /* [unknowns][width] */
} reduction;

static void free_reduction(reduction *work)
{
    bat_spline_free(&work->target);
    bat_release(work->weights);
    bat_release(work->spans);
    bat_release(work->matrix);
    bat_release(work->right);
}

static batten_status make_result(const bat_spline *spline, bat_spline *out)
{
    const int p = spline->degree, n = spline->count;
    const double *U = spline->knots;
    int distinct = 0, single = 0;
    for (int i = p + 1; i < n; i++)
        if (U[i] != U[i - 1] || i == p + 1) {
            distinct++;
            single += U[i] != U[i + 1];
        }
    const batten_status status =
        bat_spline_make(p - 1, n - 1 - distinct + single, spline->width, out);
    if (status != BATTEN_OK)
        return status;
    int count = 0;
    for (int i = 1; i < n + p; i++) {
        const bool first = i > p && i < n && U[i] != U[i - 1], alone = U[i] != U[i + 1];
        if (!first || alone)
            out->knots[count++] = U[i];
    }
    return BATTEN_OK;
}

/* The inner knots that stand once. */
static int list_simple_knots(const bat_spline *spline, double *knots)
{
    const double *U = spline->knots;
    int count = 0;
    for (int i = spline->degree + 1; i < spline->count; i++)
        if (U[i] != U[i - 1] && U[i] != U[i + 1])
            knots[count++] = U[i];
    return count;
}

/* The given spline with the inner knots that stand once standing twice. */
static batten_status make_target(const bat_spline *spline, bat_spline *out)
{
    double *knots = bat_array((size_t)spline->count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    const int count = list_simple_knots(spline, knots);
    const batten_status status = bat_spline_insert(spline, count, knots, out);
    bat_release(knots);
    return status;
}

static batten_status begin_reduction(const bat_spline *spline, reduction *work)
{
    *work = (reduction){0};
    batten_status status = make_target(spline, &work->target);
    if (status == BATTEN_OK)
        status = make_result(spline, &work->made);
    if (status != BATTEN_OK)
        return status;
    const size_t rows = (size_t)work->target.count, p = (size_t)spline->degree;
    const size_t unknowns = (size_t)work->made.count;
    work->weights = bat_array3(rows, p, sizeof *work->weights);
    work->spans = bat_array(rows, sizeof *work->spans);
    work->matrix = bat_array3(unknowns, p, sizeof *work->matrix);
    work->right = bat_array3(unknowns, spline->width, sizeof *work->right);
    return work->weights && work->spans && work->matrix && work->right ? BATTEN_OK
                                                                       : BATTEN_OUT_OF_MEMORY;
}

static void fill_weights(reduction *work)
{
    const bat_spline *made = &work->made, *target = &work->target;
    const int p = target->degree;
    for (int j = 0, span = p - 1; j < target->count; j++) {
        while (made->knots[span + 1] <= target->knots[j])
            span++;
        work->spans[j] = span;
        bat_elevation_row(p - 1, made->knots, span, target->knots + j + 1,
                          work->weights + (size_t)j * (size_t)p);
    }
}

static double *row_of(const bat_spline *spline, int i)
{
    return spline->values + (size_t)i * spline->width;
}

/* What row j of the elevated result differs from the target, into out [width]. */
static void difference(const reduction *work, int j, double *out)
{
    const int p = work->target.degree;
    const size_t width = work->target.width;
    memcpy(out, row_of(&work->target, j), width * sizeof *out);
    for (int i = 0; i < p; i++) {
        const double weight = work->weights[(size_t)j * (size_t)p + (size_t)i];
        if (weight == 0)
            continue;
        const double *row = row_of(&work->made, work->spans[j] - p + 1 + i);
        for (size_t c = 0; c < width; c++)
            out[c] -= weight * row[c];
    }
}

/* E^T E of the inner unknowns. */
static void fill_matrix(reduction *work)
{
    const int p = work->target.degree, last = work->made.count - 1;
    for (int j = 0; j < work->target.count; j++) {
        const double *w = work->weights + (size_t)j * (size_t)p;
        for (int a = 0; a < p; a++)
            for (int b = 0; b <= a; b++) {
                const int row = work->spans[j] - p + 1 + a, column = work->spans[j] - p + 1 + b;
                if (column > 0 && row < last)
                    work->matrix[(size_t)(row - 1) * (size_t)p + (size_t)(p - 1 + b - a)] +=
                        w[a] * w[b];
            }
    }
}

/* One Newton step of the least squares, exact but for rounding; a second one takes that away.
 */
static void improve(reduction *work, double *scratch)
{
    const int p = work->target.degree, unknowns = work->made.count - 2;
    const size_t width = work->target.width;
    memset(work->right, 0, (size_t)unknowns * width * sizeof *work->right);
    for (int j = 0; j < work->target.count; j++) {
        difference(work, j, scratch);
        for (int i = 0; i < p; i++) {
            const int unknown = work->spans[j] - p + i;
            if (unknown < 0 || unknown >= unknowns)
                continue;
            for (size_t c = 0; c < width; c++)
                work->right[(size_t)unknown * width + c] +=
                    work->weights[(size_t)j * (size_t)p + (size_t)i] * scratch[c];
        }
    }
    bat_symmetric_solve(unknowns, p - 1, work->matrix, width, work->right);
    for (size_t i = 0; i < (size_t)unknowns * width; i++)
        work->made.values[width + i] += work->right[i];
}

static batten_status solve(reduction *work, size_t group, double *error)
{
    const size_t width = work->target.width;
    const int p = work->target.degree, unknowns = work->made.count - 2;
    double *scratch = bat_array(width, sizeof *scratch);
    if (!scratch)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(row_of(&work->made, 0), row_of(&work->target, 0), width * sizeof *scratch);
    memcpy(row_of(&work->made, unknowns + 1), row_of(&work->target, work->target.count - 1),
           width * sizeof *scratch);
    fill_weights(work);
    fill_matrix(work);
    batten_status status =
        unknowns > 0 ? bat_symmetric_factor(unknowns, p - 1, work->matrix) : BATTEN_OK;
    for (int step = 0; status == BATTEN_OK && unknowns > 0 && step < 2; step++)
        improve(work, scratch);
    for (int j = 0; status == BATTEN_OK && j < work->target.count; j++) {
        difference(work, j, scratch);
        for (size_t c = 0; c < width; c += group)
            *error = bat_max(*error, bat_norm((int)group, scratch + c));
    }
    bat_release(scratch);
    return status;
}

static batten_status reduce_once(const bat_spline *spline, size_t group, double *error,
                                 bat_spline *out)
{
    reduction work;
    double moved = 0;
    batten_status status = begin_reduction(spline, &work);
    if (status == BATTEN_OK)
        status = solve(&work, group, &moved);
    if (status == BATTEN_OK) {
        *error += moved;
        *out = work.made;
    } else
        bat_spline_free(&work.made);
    free_reduction(&work);
    return status;
}

batten_status bat_spline_reduce(const bat_spline *spline, int degree, size_t group,
                                double tolerance, double *error, bat_spline *out)
{
    bat_spline made;
    double moved = 0;
    const double a = spline->knots[spline->degree], b = spline->knots[spline->count];
    batten_status status = bat_spline_subrange(spline, a, b, &made);
    while (status == BATTEN_OK && made.degree > degree) {
        bat_spline next = {0};
        status = reduce_once(&made, group, &moved, &next);
        bat_spline_free(&made);
        made = next;
    }
    if (status == BATTEN_OK && !(moved <= tolerance)) {
        bat_spline_free(&made);
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "reduced to degree %d, it moves by up to %g, more than %g", degree,
                          moved, tolerance);
    }
    if (status != BATTEN_OK)
        return status;
    *error = moved;
    *out = made;
    return BATTEN_OK;
}
