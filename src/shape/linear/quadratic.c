/* Quadratic splines: with knots at the data, or the data midway between knots. */
#include "numeric/banded.h"
#include "numeric/vector.h"
#include "shape/points/parametrize.h"
#include "spline/data_check.h"
#include <batten/interpolate.h>

#include <float.h>
#include <string.h>

batten_curve_quadratic_options batten_curve_quadratic_defaults(void)
{
    return (batten_curve_quadratic_options){.size = sizeof(batten_curve_quadratic_options),
                                            .kind = BATTEN_QUADRATIC_BETWEEN,
                                            .parameters = BATTEN_CHORD};
}

/* One spline on its way: `spans` parabolas on the mesh k, each of which is known by the middle
 * one of its three control points; these and the ends are the control points of the curve. */
typedef struct {
    int dimension, count, spans;
    const double *points; /* [count][dimension] */
    double *t;            /* [count] parameters */
    double *k;            /* [spans + 1] knots */
    double *middle;       /* [spans + 2][dimension], with the ends before and behind */
} quadratic_spline;

/* ---- knots at the data ---- */

/* The slopes are 2 chord slopes less the slope before: affine in the first one, with factors 1
 * and -1. `sum` and `weight` of the least squares for it: the jump of P'' at point i, between
 * spans g and h long, changes by (-1)^(i+1) 2 (1/g + 1/h) times the change of the first slope.
 */
static void best_slope(const quadratic_spline *q, const double *chords, int c, double *slopes)
{
    const int d = q->dimension, n = q->spans;
    double sum = 0, weight = 0, sign = -1;
    for (int i = 1; i < n; i++, sign = -sign) {
        const double g = q->k[i] - q->k[i - 1], h = q->k[i + 1] - q->k[i];
        const double left = 2 * (slopes[i * d + c] - chords[(i - 1) * d + c]) / g;
        const double right = 2 * (chords[i * d + c] - slopes[i * d + c]) / h;
        /* In units of the first span, so that squares stay among the numbers. */
        const double unit = q->k[1] - q->k[0], turn = -sign * 2 * (unit / g + unit / h);
        sum += turn * ((right - left) * unit);
        weight += turn * turn;
    }
    double change = weight > 0 ? -sum / weight : chords[c] - slopes[c];
    for (int i = 0; i <= n; i++, change = -change)
        slopes[i * d + c] += change;
}

static void find_chords(const quadratic_spline *q, double *chords)
{
    const int d = q->dimension;
    for (int i = 0; i < q->spans; i++)
        for (int c = 0; c < d; c++)
            chords[i * d + c] =
                (q->points[(i + 1) * d + c] - q->points[i * d + c]) / (q->k[i + 1] - q->k[i]);
}

/* From the slope at one end to the other: each chord is the mean of the slopes at its ends. */
static void run_slopes(const quadratic_spline *q, const double *chords, int c, bool from_end,
                       double *slopes)
{
    const int d = q->dimension, n = q->spans;
    for (int i = 0; i < n && !from_end; i++)
        slopes[(i + 1) * d + c] = 2 * chords[i * d + c] - slopes[i * d + c];
    for (int i = n - 1; i >= 0 && from_end; i--)
        slopes[i * d + c] = 2 * chords[i * d + c] - slopes[(i + 1) * d + c];
}

static void find_slopes(const quadratic_spline *q, const batten_curve_quadratic_options *o,
                        double *chords, double *slopes)
{
    const bool from_end = o->slope == BATTEN_QUADRATIC_AT_END;
    find_chords(q, chords);
    for (int c = 0; c < q->dimension; c++) {
        /* Without a given slope, that of the first chord to begin with. */
        slopes[(from_end ? q->spans : 0) * q->dimension + c] =
            o->slope == BATTEN_QUADRATIC_BEST ? chords[c] : o->vector[c];
        run_slopes(q, chords, c, from_end, slopes);
        if (o->slope == BATTEN_QUADRATIC_BEST)
            best_slope(q, chords, c, slopes);
    }
}

static batten_status sequential(quadratic_spline *q, const batten_curve_quadratic_options *o)
{
    const int d = q->dimension, n = q->spans;
    if (o->slope != BATTEN_QUADRATIC_BEST &&
        bat_first_not_finite(o->vector, (size_t)d) < (size_t)d)
        return bat_fail(BATTEN_NOT_FINITE, "the slope at the %s is not finite",
                        o->slope == BATTEN_QUADRATIC_AT_START ? "start" : "end");
    double *chords = bat_array3((size_t)n, (size_t)d, sizeof *chords);
    double *slopes = bat_array3((size_t)n + 1, (size_t)d, sizeof *slopes);
    memcpy(q->k, q->t, ((size_t)n + 1) * sizeof *q->k);
    if (chords && slopes) {
        find_slopes(q, o, chords, slopes);
        for (int i = 0; i < n; i++)
            for (int c = 0; c < d; c++)
                q->middle[(i + 1) * d + c] =
                    q->points[i * d + c] + slopes[i * d + c] * (q->k[i + 1] - q->k[i]) / 2;
    }
    const batten_status status = chords && slopes ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    bat_release(chords);
    bat_release(slopes);
    return status;
}

/* ---- data midway between knots ---- */

static batten_status find_mesh(quadratic_spline *q)
{
    const int n = q->spans;
    q->k[0] = q->t[0];
    for (int i = 1; i <= n; i++) {
        q->k[i] = 2 * q->t[i] - q->k[i - 1];
        if (!(q->k[i] > q->t[i] && q->k[i] > q->k[i - 1]))
            return bat_fail(
                BATTEN_NOT_COMPATIBLE,
                "parameters 2 to %d are not mid-points: knot %d would be %g, and is "
                "to lie above %g",
                n + 1, i + 1, q->k[i], q->t[i]);
    }
    /* Each knot adds two roundings of the size of the largest parameter. */
    const double end = q->t[q->count - 1];
    const double rounding = 4 * DBL_EPSILON * n * bat_max(fabs(q->t[0]), fabs(end));
    if (!(fabs(q->k[n] - end) <= rounding) || !(end > q->t[n]))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "parameters 2 to %d are not mid-points: the knots end at %g, not %g", n,
                        q->k[n], end);
    q->k[n] = end;
    return BATTEN_OK;
}

/* The values at the knots: slopes there agree. */
static batten_status solve_knots(const quadratic_spline *q, double *matrix, double *values)
{
    const int d = q->dimension, n = q->spans;
    const double *f = q->points; /* f[i + 1] midway on span i, the ends before and behind */
    for (int i = 0; i <= n; i++) {
        const bool end = i == 0 || i == n;
        const double before = end ? 0 : q->k[i] - q->k[i - 1],
                     after = end ? 0 : q->k[i + 1] - q->k[i];
        const double L = end ? 0 : after / (before + after), U = end ? 0 : 1 - L;
        matrix[3 * i] = L;
        matrix[3 * i + 1] = end ? 1 : 3;
        matrix[3 * i + 2] = U;
        for (int c = 0; c < d; c++)
            values[i * d + c] = end ? f[(i ? n + 1 : 0) * d + c]
                                    : 4 * (L * f[i * d + c] + U * f[(i + 1) * d + c]);
    }
    const batten_status status = bat_banded_factor(n + 1, 1, 1, matrix);
    if (status == BATTEN_OK)
        bat_banded_solve(n + 1, 1, 1, matrix, (size_t)d, values);
    return status;
}

static batten_status midpoints(quadratic_spline *q)
{
    const int d = q->dimension, n = q->spans;
    batten_status status = find_mesh(q);
    if (status != BATTEN_OK)
        return status;
    double *matrix = bat_array3((size_t)n + 1, 3, sizeof *matrix);
    double *values = bat_array3((size_t)n + 1, (size_t)d, sizeof *values);
    status = matrix && values ? solve_knots(q, matrix, values) : BATTEN_OUT_OF_MEMORY;
    for (int i = 1; i <= n && status == BATTEN_OK; i++)
        for (int c = 0; c < d; c++)
            q->middle[i * d + c] =
                2 * q->points[i * d + c] - (values[(i - 1) * d + c] + values[i * d + c]) / 2;
    bat_release(matrix);
    bat_release(values);
    return status;
}

/* ---- the whole ---- */

static batten_status find_parameters(quadratic_spline *q,
                                     const batten_curve_quadratic_options *o)
{
    if (o->kind != BATTEN_QUADRATIC_MIDPOINTS || o->parameters == BATTEN_GIVEN)
        return bat_parameters_of((batten_points){q->dimension, q->count, q->points},
                                 o->parameters, o->given, false, &q->t);
    q->t = bat_array((size_t)q->count, sizeof *q->t);
    for (int i = 1; q->t && i < q->count; i++)
        q->t[i] = i <= q->spans ? i - 0.5 : q->spans;
    return q->t ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* Knots at the ends three times, else once. */
static batten_status make_curve(quadratic_spline *q, batten_curve **out)
{
    const int d = q->dimension, n = q->spans;
    const size_t row = (size_t)d * sizeof *q->middle;
    memcpy(q->middle, q->points, row);
    memcpy(q->middle + (n + 1) * d, q->points + (q->count - 1) * d, row);
    double *knots = bat_array((size_t)n + 5, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(knots + 2, q->k, ((size_t)n + 1) * sizeof *knots);
    for (int i = 0; i < 2; i++) {
        knots[i] = q->k[0];
        knots[n + 3 + i] = q->k[n];
    }
    const size_t numbers = (size_t)(n + 2) * (size_t)d;
    batten_status status = BATTEN_OK;
    if (bat_first_not_finite(q->middle, numbers) < numbers)
        status = bat_fail(BATTEN_OVERFLOW, "a control point is too large for a number");
    else
        status = batten_curve_create((batten_points){d, n + 2, q->middle}, 2, NULL, knots, out);
    bat_release(knots);
    return status;
}

/* The parameters' rounding moves the points, too: by the size of the control points. */
static batten_status check_interpolation(const quadratic_spline *q, const batten_curve *curve)
{
    const int d = q->dimension;
    const double size = bat_largest((q->spans + 2) * d, q->middle);
    for (int i = 0; i < q->count; i++) {
        double at[3];
        const batten_status status = batten_curve_evaluate(curve, q->t[i], 0, at);
        if (status != BATTEN_OK)
            return status;
        const double off = bat_distance(d, at, q->points + i * d);
        if (!(off <= 32 * DBL_EPSILON * q->count * size))
            return bat_fail(BATTEN_TOLERANCE_NOT_MET, "the curve misses point %d by %g", i + 1,
                            off);
    }
    return BATTEN_OK;
}

static batten_status make_quadratic(quadratic_spline *q,
                                    const batten_curve_quadratic_options *o,
                                    batten_curve **curve)
{
    const size_t n = (size_t)q->spans, d = (size_t)q->dimension;
    batten_status status = find_parameters(q, o);
    if (status != BATTEN_OK)
        return status;
    q->k = bat_array(n + 1, sizeof *q->k);
    q->middle = bat_array3(n + 2, d, sizeof *q->middle);
    if (!q->k || !q->middle)
        return BATTEN_OUT_OF_MEMORY;
    status = o->kind == BATTEN_QUADRATIC_MIDPOINTS ? midpoints(q) : sequential(q, o);
    if (status == BATTEN_OK)
        status = make_curve(q, curve);
    return status == BATTEN_OK ? check_interpolation(q, *curve) : status;
}

/* Averaged knots of degree 2 are those midway between the data. */
static batten_status between(batten_points points, const batten_curve_quadratic_options *o,
                             double *parameters, batten_curve **out)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.degree = 2;
    options.knots_at_data = false;
    options.parameters = o->parameters;
    options.given = o->given;
    return batten_curve_interpolate(points, &options, parameters, out);
}

batten_status batten_curve_quadratic(batten_points points,
                                     const batten_curve_quadratic_options *options,
                                     double *parameters, batten_curve **out)
{
    assert(points.at && out);
    batten_curve_quadratic_options chosen = batten_curve_quadratic_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_quadratic_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_curve_quadratic_options *o = &chosen;
    const bool has_midpoints = o->kind == BATTEN_QUADRATIC_MIDPOINTS;
    if ((int)o->kind < 0 || o->kind > BATTEN_QUADRATIC_SEQUENTIAL || (int)o->slope < 0 ||
        o->slope > BATTEN_QUADRATIC_AT_END)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "there is no quadratic spline of kind %d, slope %d", (int)o->kind,
                        (int)o->slope);
    if (o->kind == BATTEN_QUADRATIC_BETWEEN)
        return between(points, o, parameters, out);
    status = bat_points_check(points.dimension, points.count, points.at, has_midpoints ? 3 : 2);
    if (status != BATTEN_OK)
        return status;
    batten_curve *curve = NULL;
    quadratic_spline q = {.dimension = points.dimension,
                          .count = points.count,
                          .spans = has_midpoints ? points.count - 2 : points.count - 1,
                          .points = points.at};
    status = make_quadratic(&q, o, &curve);
    if (status == BATTEN_OK) {
        if (parameters)
            memcpy(parameters, q.t, (size_t)points.count * sizeof *parameters);
        *out = curve;
    } else
        batten_curve_unref(curve);
    bat_release(q.t);
    bat_release(q.k);
    bat_release(q.middle);
    return status;
}
