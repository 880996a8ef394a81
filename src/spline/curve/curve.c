/* Making, keeping and describing curves. */
#include "spline/curve/curve.h"
#include "base/plural.h"
#include "numeric/vector.h"

#include <stdint.h>
#include <string.h>

/* ---- making ---- */

static batten_status check_sizes(int dimension, int degree, int point_count, int least)
{
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", degree,
                        BATTEN_MAX_DEGREE);
    if (point_count < least)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "%d control point%s for degree %d; %d are needed", point_count,
                        bat_plural(point_count), degree, least);
    if (point_count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d control points; the limit is %d", point_count,
                        BAT_MAX_POINTS);
    return BATTEN_OK;
}

batten_status bat_curve_make(int dimension, int degree, int count, bool rational,
                             batten_curve **out)
{
    const size_t n = (size_t)count, d = (size_t)dimension, knot_count = n + (size_t)degree + 1;
    batten_curve *curve = bat_array(1, sizeof *curve);
    double *numbers = bat_array(knot_count + n * (d + rational), sizeof *numbers);
    if (!curve || !numbers) {
        bat_release(curve);
        bat_release(numbers);
        return BATTEN_OUT_OF_MEMORY;
    }
    bat_references_begin(&curve->references);
    curve->dimension = dimension;
    curve->degree = degree;
    curve->count = count;
    curve->knots = numbers;
    curve->points = numbers + knot_count;
    curve->weights = rational ? curve->points + n * d : NULL;
    curve->weight_scale = 1;
    atomic_init(&curve->pieces, NULL);
    *out = curve;
    return BATTEN_OK;
}

static batten_status check_points(const batten_curve *curve)
{
    const size_t d = (size_t)curve->dimension, total = (size_t)curve->count * d;
    const size_t i = bat_first_not_finite(curve->points, total);
    if (i < total)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of control point %zu is %g",
                        i % d + 1, i / d + 1, curve->points[i]);
    return BATTEN_OK;
}

static batten_status check_weights(batten_curve *curve)
{
    double largest = 0;
    for (int i = 0; curve->weights && i < curve->count; i++) {
        const double w = curve->weights[i];
        if (!isfinite(w))
            return bat_fail(BATTEN_NOT_FINITE, "weight %d is %g", i + 1, w);
        if (w <= 0)
            return bat_fail(BATTEN_BAD_WEIGHT, "weight %d is %g; weights must be positive",
                            i + 1, w);
        largest = bat_max(largest, w);
    }
    /* Two steps, for 2^1074 is not a number and the least weight may need it. */
    if (curve->weights)
        curve->weight_scale = ldexp(1, bat_min_int(-ilogb(largest), 1023));
    return BATTEN_OK;
}

batten_status bat_curve_finish(batten_curve *curve, batten_curve **out)
{
    batten_status status = check_points(curve);
    if (status == BATTEN_OK)
        status = check_weights(curve);
    if (status == BATTEN_OK)
        *out = curve;
    else
        batten_curve_unref(curve);
    return status;
}

batten_status batten_curve_create(batten_points points, int degree, const double *weights,
                                  const double *knots, batten_curve **out)
{
    assert(points.at && knots && out);
    batten_status status = check_sizes(points.dimension, degree, points.count, degree + 1);
    if (status == BATTEN_OK)
        status = bat_knots_check(degree, points.count, knots, "knot");
    batten_curve *curve = NULL;
    if (status == BATTEN_OK)
        status =
            bat_curve_make(points.dimension, degree, points.count, weights != NULL, &curve);
    if (status != BATTEN_OK)
        return status;
    const size_t n = (size_t)points.count;
    memcpy(curve->knots, knots, (n + (size_t)degree + 1) * sizeof *knots);
    memcpy(curve->points, points.at, n * (size_t)points.dimension * sizeof *points.at);
    if (weights)
        memcpy(curve->weights, weights, n * sizeof *weights);
    return bat_curve_finish(curve, out);
}

/* ---- periodic ---- */

static batten_status check_period(int m, const double *period)
{
    for (int i = 0; i <= m; i++)
        if (!isfinite(period[i]))
            return bat_fail(BATTEN_NOT_FINITE, "knot %d is %g", i + 1, period[i]);
    if (!(period[m] > period[0]))
        return bat_fail(BATTEN_BAD_KNOTS,
                        "the period is empty: knot 1 is %.17g and knot %d is %.17g", period[0],
                        m + 1, period[m]);
    return BATTEN_OK;
}

batten_status batten_curve_create_periodic(batten_points points, int degree,
                                           const double *weights, const double *knots,
                                           batten_curve **out)
{
    assert(points.at && knots && out);
    const int m = points.count, p = degree;
    batten_status status = check_sizes(points.dimension, p, m, 1);
    if (status == BATTEN_OK)
        status = check_period(m, knots);
    batten_curve *curve = NULL;
    if (status == BATTEN_OK)
        status = bat_curve_make(points.dimension, p, m + p, weights != NULL, &curve);
    if (status != BATTEN_OK)
        return status;
    const size_t d = (size_t)points.dimension;
    curve->periodic = true;
    for (int i = 0; i < m + p; i++) {
        memcpy(curve->points + (size_t)i * d, points.at + (size_t)(i % m) * d,
               d * sizeof *points.at);
        if (weights)
            curve->weights[i] = weights[i % m];
    }
    bat_knots_wrap(p, m, knots, curve->knots);
    status = bat_knots_check(p, m + p, curve->knots, "wrapped knot");
    if (status == BATTEN_OK)
        return bat_curve_finish(curve, out);
    batten_curve_unref(curve);
    return status;
}

batten_status bat_curve_make_like(const batten_curve *like, int degree, int count,
                                  batten_curve **out)
{
    return bat_curve_make(like->dimension, degree, count, like->weights != NULL, out);
}

batten_status bat_curve_copy(const batten_curve *curve, batten_curve **out)
{
    batten_curve *copy;
    const batten_status status = bat_curve_make_like(curve, curve->degree, curve->count, &copy);
    if (status != BATTEN_OK)
        return status;
    const size_t n = (size_t)curve->count;
    copy->periodic = curve->periodic;
    copy->weight_scale = curve->weight_scale;
    memcpy(copy->knots, curve->knots, (n + (size_t)curve->degree + 1) * sizeof *copy->knots);
    memcpy(copy->points, curve->points, n * (size_t)curve->dimension * sizeof *copy->points);
    if (copy->weights)
        memcpy(copy->weights, curve->weights, n * sizeof *copy->weights);
    *out = copy;
    return BATTEN_OK;
}

/* ---- keeping ---- */

batten_curve *batten_curve_ref(const batten_curve *curve)
{
    /* What is const to the holder is the shape; the count behind it is not part of it. */
    batten_curve *shared = (batten_curve *)(uintptr_t)curve;
    bat_references_add(&shared->references);
    return shared;
}

void batten_curve_unref(batten_curve *curve)
{
    if (!curve || !bat_references_drop(&curve->references))
        return;
    bat_pieces_free(atomic_load(&curve->pieces));
    bat_release(curve->knots);
    bat_release(curve);
}

/* ---- properties ---- */

int batten_curve_dimension(const batten_curve *curve)
{
    return curve->dimension;
}

int batten_curve_degree(const batten_curve *curve)
{
    return curve->degree;
}

int batten_curve_point_count(const batten_curve *curve)
{
    return curve->count;
}

int batten_curve_knot_count(const batten_curve *curve)
{
    return curve->count + curve->degree + 1;
}

const double *batten_curve_points(const batten_curve *curve)
{
    return curve->points;
}

const double *batten_curve_weights(const batten_curve *curve)
{
    return curve->weights;
}

const double *batten_curve_knots(const batten_curve *curve)
{
    return curve->knots;
}

bool batten_curve_is_rational(const batten_curve *curve)
{
    return curve->weights != NULL;
}

bool batten_curve_is_periodic(const batten_curve *curve)
{
    return curve->periodic;
}

bool batten_curve_is_clamped(const batten_curve *curve)
{
    const int p = curve->degree, n = curve->count;
    const double *U = curve->knots;
    return U[0] == U[p] && U[n] == U[n + p];
}

batten_interval batten_curve_domain(const batten_curve *curve)
{
    return (batten_interval){curve->knots[curve->degree], curve->knots[curve->count]};
}

bool batten_curve_is_closed(const batten_curve *curve, double tolerance)
{
    const batten_interval domain = batten_curve_domain(curve);
    double start[3], end[3];
    if (batten_curve_evaluate_side(curve, domain.a, BATTEN_FROM_RIGHT, 0, start) != BATTEN_OK ||
        batten_curve_evaluate_side(curve, domain.b, BATTEN_FROM_LEFT, 0, end) != BATTEN_OK)
        return false;
    return bat_distance(curve->dimension, start, end) <= tolerance;
}

batten_box batten_curve_box(const batten_curve *curve)
{
    const int p = curve->degree, n = curve->count, d = curve->dimension;
    const double *U = curve->knots;
    const int first = bat_knots_span(p, n, U, U[p], BATTEN_FROM_RIGHT) - p;
    const int last = bat_knots_span(p, n, U, U[n], BATTEN_FROM_LEFT);
    double low[3] = {0}, high[3] = {0};
    for (int k = 0; k < d; k++) {
        low[k] = high[k] = curve->points[first * d + k];
        for (int i = first + 1; i <= last; i++) {
            low[k] = bat_min(low[k], curve->points[i * d + k]);
            high[k] = bat_max(high[k], curve->points[i * d + k]);
        }
    }
    return (batten_box){{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

double batten_curve_greville(const batten_curve *curve, int i)
{
    assert(i >= 0 && i < curve->count);
    return bat_greville(curve->degree, curve->knots, i);
}
