/* Weighted splines and nu-splines: one symmetric system for the slopes. */
#include "numeric/banded.h"
#include "numeric/vector.h"
#include "shape/linear/end_conditions.h"
#include "shape/points/parametrize.h"
#include "spline/data_check.h"
#include <batten/local.h>

#include <float.h>
#include <string.h>

batten_curve_weighted_options batten_curve_weighted_defaults(void)
{
    return (batten_curve_weighted_options){.size = sizeof(batten_curve_weighted_options),
                                           .parameters = BATTEN_CHORD,
                                           .start = {.kind = BATTEN_END_NATURAL},
                                           .end = {.kind = BATTEN_END_NATURAL}};
}

typedef struct {
    int dimension, count, spans;
    bool closed;
    const double *points;
    double *u;        /* [spans + 1] */
    double *c;        /* [spans] weight by length */
    double *nu;       /* [count] */
    double *right;    /* [count][dimension] 3 (c d before + c d after), and what ends give */
    double *diagonal; /* [count] */
    double *off;      /* [spans] beside it: the last one joins a closed curve's ends */
    double *matrix;   /* [count][2] */
    double *slopes;   /* [count][dimension + closed]: the solution, and the border */
    bat_ends ends;
} nu_spline;

/* ---- the data ---- */

static int next_point(const nu_spline *t, int span)
{
    return span + 1 == t->count ? 0 : span + 1;
}

static double chord_slope(const nu_spline *t, int span, int k)
{
    const int d = t->dimension;
    return (t->points[next_point(t, span) * d + k] - t->points[span * d + k]) /
           (t->u[span + 1] - t->u[span]);
}

static double weight_of(const nu_spline *t, const batten_curve_weighted_options *o, int span)
{
    if (o->rule == BATTEN_WEIGHTS_GIVEN)
        return o->weights ? o->weights[span] : 1;
    double slope[3];
    for (int k = 0; k < t->dimension; k++)
        slope[k] = chord_slope(t, span, k);
    const double s = 1 + bat_dot(t->dimension, slope, slope);
    return 1 / (s * s * s);
}

static batten_status find_data(nu_spline *t, const batten_curve_weighted_options *o)
{
    const double mean = (t->u[t->spans] - t->u[0]) / t->spans;
    for (int i = 0; i < t->spans; i++) {
        const double w = weight_of(t, o, i);
        if (!(w > 0 && isfinite(w)))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the weight of span %d is %g, not above 0",
                            i + 1, w);
        t->c[i] = w / (t->u[i + 1] - t->u[i]);
        if (!(t->c[i] > 0 && isfinite(t->c[i])))
            return bat_fail(BATTEN_OVERFLOW,
                            "weight %g and length %g of span %d are too far "
                            "apart",
                            w, t->u[i + 1] - t->u[i], i + 1);
    }
    for (int i = 0; i < t->count; i++) {
        t->nu[i] = (o->nus ? o->nus[i] : o->nu) / mean;
        if (!isfinite(t->nu[i]))
            return bat_fail(BATTEN_NOT_FINITE,
                            "the nu of point %d is not a finite number, or too large", i + 1);
    }
    return BATTEN_OK;
}

/* ---- the system ---- */

static void add_span(nu_spline *t, int i)
{
    const int d = t->dimension, next = next_point(t, i);
    const double c = t->c[i];
    t->diagonal[i] += 2 * c;
    t->diagonal[next] += 2 * c;
    t->off[i] = c;
    for (int k = 0; k < d; k++) {
        const double slope = 3 * c * chord_slope(t, i, k);
        t->right[i * d + k] += slope;
        t->right[next * d + k] += slope;
    }
}

/* The end says: P'' as given (its row so far says that it is 0), or equal to that at the other
 * end of the span, or P' as given. */
static void set_end(nu_spline *t, int end)
{
    const int d = t->dimension, i = end ? t->count - 1 : 0, beside = end ? i - 1 : 1;
    const int span = end ? t->spans - 1 : 0;
    const double c = t->c[span], h = t->u[span + 1] - t->u[span], sign = end ? -1 : 1;
    const bool line = t->ends.kinds[0] == BATTEN_END_PARABOLIC &&
                      t->ends.kinds[1] == BATTEN_END_PARABOLIC && t->count == 2;
    double *right = t->right + i * d;
    if (t->ends.kinds[end] == BATTEN_END_SECOND) {
        for (int k = 0; k < d; k++)
            right[k] -= sign * (c * h) * t->ends.values[end][k] / 2;
        return;
    }
    if (t->ends.kinds[end] == BATTEN_END_PARABOLIC && !line) {
        t->diagonal[i] = c;
        for (int k = 0; k < d; k++)
            right[k] = 2 * c * chord_slope(t, span, k);
        return;
    }
    t->diagonal[i] = 1;
    for (int k = 0; k < d; k++) {
        right[k] = line ? chord_slope(t, span, k) : t->ends.values[end][k];
        t->right[beside * d + k] -= t->off[span] * right[k];
    }
    t->off[span] = 0;
}

static void assemble(nu_spline *t)
{
    for (int i = 0; i < t->spans; i++)
        add_span(t, i);
    for (int i = t->closed ? 0 : 1; i < t->spans; i++)
        t->diagonal[i] += t->nu[i] / 2;
    if (!t->closed) {
        /* A clamped end moves its part to the other row before that is replaced. */
        const int first = t->ends.kinds[0] == BATTEN_END_CLAMPED ? 1 : 0;
        set_end(t, first);
        set_end(t, 1 - first);
    }
}

static batten_status factor(nu_spline *t, int n)
{
    for (int i = 0; i < n; i++) {
        t->matrix[2 * i] = i ? t->off[i - 1] : 0;
        t->matrix[2 * i + 1] = t->diagonal[i];
    }
    const batten_status status = bat_symmetric_factor(n, 1, t->matrix);
    if (status == BATTEN_SINGULAR_SYSTEM)
        return bat_fail(status, "there is no least curve with such negative nu: %s",
                        batten_message());
    return status;
}

static batten_status solve_open(nu_spline *t)
{
    const batten_status status = factor(t, t->count);
    if (status != BATTEN_OK)
        return status;
    memcpy(t->slopes, t->right, (size_t)t->count * (size_t)t->dimension * sizeof *t->slopes);
    bat_symmetric_solve(t->count, 1, t->matrix, (size_t)t->dimension, t->slopes);
    return BATTEN_OK;
}

/* The last point is a border around the others: definite when what is left of its diagonal is
 * above 0. */
static batten_status solve_closed(nu_spline *t)
{
    const int d = t->dimension, w = d + 1, n = t->count - 1;
    batten_status status = factor(t, n);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < n; i++) {
        memcpy(t->slopes + i * w, t->right + i * d, (size_t)d * sizeof *t->slopes);
        t->slopes[i * w + d] = (i == 0 ? t->off[n] : 0) + (i == n - 1 ? t->off[n - 1] : 0);
    }
    bat_symmetric_solve(n, 1, t->matrix, (size_t)w, t->slopes);
    const double *first = t->slopes, *before = t->slopes + (n - 1) * w;
    const double pivot = t->diagonal[n] - t->off[n] * first[d] - t->off[n - 1] * before[d];
    if (!(pivot > 4 * DBL_EPSILON * fabs(t->diagonal[n])))
        return bat_fail(BATTEN_SINGULAR_SYSTEM,
                        "there is no least curve with such negative nu");
    double last[3];
    for (int k = 0; k < d; k++)
        last[k] =
            (t->right[n * d + k] - t->off[n] * first[k] - t->off[n - 1] * before[k]) / pivot;
    for (int i = 0; i < n; i++) /* from rows of w to rows of d, which lie before them */
        for (int k = 0; k < d; k++)
            t->slopes[i * d + k] = t->slopes[i * w + k] - t->slopes[i * w + d] * last[k];
    memcpy(t->slopes + n * d, last, (size_t)d * sizeof *last);
    return BATTEN_OK;
}

/* Do the slopes satisfy their equations? */
static batten_status check_slope_equations(const nu_spline *t)
{
    const int d = t->dimension, n = t->count;
    for (int i = 0; i < n; i++) {
        const int left = i ? i - 1 : t->closed ? n - 1 : -1, right = i < t->spans ? i : -1;
        for (int k = 0; k < d; k++) {
            const double own = t->diagonal[i] * t->slopes[i * d + k];
            const double before = left < 0 ? 0 : t->off[left] * t->slopes[left * d + k];
            const double after =
                right < 0 ? 0 : t->off[right] * t->slopes[next_point(t, i) * d + k];
            const double off = before + own + after - t->right[i * d + k];
            const double size =
                fabs(before) + fabs(own) + fabs(after) + fabs(t->right[i * d + k]);
            if (!isfinite(off))
                return bat_fail(BATTEN_OVERFLOW, "the slope at point %d is too large", i + 1);
            /* Elimination without exchange of rows, in three terms each way. */
            if (fabs(off) > 64 * DBL_EPSILON * size + DBL_MIN)
                return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                                "the equation of point %d is off by %g of %g", i + 1, off,
                                size);
        }
    }
    return BATTEN_OK;
}

/* ---- the whole ---- */

static batten_status allocate(nu_spline *t)
{
    const size_t d = (size_t)t->dimension, n = (size_t)t->count, m = (size_t)t->spans;
    t->c = bat_array(m, sizeof *t->c);
    t->off = bat_array(m, sizeof *t->off);
    t->nu = bat_array(n, sizeof *t->nu);
    t->diagonal = bat_array(n, sizeof *t->diagonal);
    t->right = bat_array3(n, d, sizeof *t->right);
    t->matrix = bat_array3(n, 2, sizeof *t->matrix);
    t->slopes = bat_array3(n, d + 1, sizeof *t->slopes);
    return t->c && t->off && t->nu && t->diagonal && t->right && t->matrix && t->slopes
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

static void release(nu_spline *t)
{
    bat_release(t->u);
    bat_release(t->c);
    bat_release(t->off);
    bat_release(t->nu);
    bat_release(t->diagonal);
    bat_release(t->right);
    bat_release(t->matrix);
    bat_release(t->slopes);
}

static batten_status solve(nu_spline *t, const batten_curve_weighted_options *o)
{
    const batten_end ends[2] = {o->start, o->end};
    batten_status status = bat_parameters_of((batten_points){t->dimension, t->count, t->points},
                                             o->parameters, o->given, o->closed, &t->u);
    if (status == BATTEN_OK && !o->closed)
        status = bat_ends_plain((batten_points){t->dimension, t->count, t->points}, t->u, ends,
                                "weighted splines", &t->ends);
    if (status == BATTEN_OK)
        status = allocate(t);
    if (status == BATTEN_OK)
        status = find_data(t, o);
    if (status != BATTEN_OK)
        return status;
    assemble(t);
    status = t->closed ? solve_closed(t) : solve_open(t);
    return status == BATTEN_OK ? check_slope_equations(t) : status;
}

static batten_status make_curve(const nu_spline *t, batten_curve **out)
{
    const int d = t->dimension, count = t->spans + 1;
    if (t->closed)
        return batten_curve_from_tangents((batten_points){d, t->count, t->points}, t->u,
                                          t->slopes, NULL, true, out);
    double *values = bat_array3((size_t)count, (size_t)(2 * d), sizeof *values);
    if (!values)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < d; k++) {
            values[2 * i * d + k] = t->points[i * d + k];
            values[(2 * i + 1) * d + k] = t->slopes[i * d + k];
        }
    }
    const batten_status status = batten_curve_from_hermite(d, count, 2, t->u, values, out);
    bat_release(values);
    return status;
}

batten_status batten_curve_weighted(batten_points points,
                                    const batten_curve_weighted_options *options,
                                    double *parameters, batten_curve **out)
{
    assert(points.at && out);
    batten_curve_weighted_options chosen = batten_curve_weighted_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_weighted_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_curve_weighted_options *o = &chosen;
    status = bat_points_check(points.dimension, points.count, points.at, o->closed ? 3 : 2);
    if (status != BATTEN_OK)
        return status;
    nu_spline t = {.dimension = points.dimension,
                   .count = points.count,
                   .spans = o->closed ? points.count : points.count - 1,
                   .closed = o->closed,
                   .points = points.at};
    status = solve(&t, o);
    if (status == BATTEN_OK)
        status = make_curve(&t, out);
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, t.u, (size_t)points.count * sizeof *parameters);
    release(&t);
    return status;
}
