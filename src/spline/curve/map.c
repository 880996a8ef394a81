/* Changes that leave the structure: direction, parameter, weights, dimension, position. */
#include "spline/curve/curve.h"

#include <string.h>

static void reverse_points(const batten_curve *curve, batten_curve *made)
{
    const int n = curve->count;
    const size_t d = (size_t)curve->dimension;
    for (int i = 0; i < n; i++) {
        memcpy(made->points + (size_t)i * d, curve->points + (size_t)(n - 1 - i) * d,
               d * sizeof *made->points);
        if (curve->weights)
            made->weights[i] = curve->weights[n - 1 - i];
    }
}

batten_status batten_curve_reverse(const batten_curve *curve, batten_curve **out)
{
    assert(curve && out);
    batten_curve *made;
    const batten_status status = bat_curve_copy(curve, &made);
    if (status != BATTEN_OK)
        return status;
    bat_knots_reverse(curve->degree, curve->count, curve->knots, made->knots);
    reverse_points(curve, made);
    return bat_curve_finish(made, out);
}

batten_status batten_curve_set_domain(const batten_curve *curve, double a, double b,
                                      batten_curve **out)
{
    assert(curve && out);
    batten_curve *made;
    batten_status status = bat_curve_copy(curve, &made);
    if (status != BATTEN_OK)
        return status;
    status = bat_knots_map(curve->degree, curve->count, curve->knots, a, b, made->knots);
    if (status == BATTEN_OK)
        return bat_curve_finish(made, out);
    batten_curve_unref(made);
    return status;
}

/* ---- rational parameters ---- */

static batten_status check_moebius(const batten_curve *curve, double a, double b, double c,
                                   double d)
{
    const int last = curve->count + curve->degree;
    if (!isfinite(a) || !isfinite(b) || !isfinite(c) || !isfinite(d))
        return bat_fail(BATTEN_NOT_FINITE,
                        "(%g u + %g) / (%g u + %g) has a coefficient that is no number", a, b,
                        c, d);
    if (!(a * d - b * c > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "(%g u + %g) / (%g u + %g) does not rise: a d - b c is %g", a, b, c, d,
                        a * d - b * c);
    /* c u + d is linear: positive at both ends, positive between. */
    for (int i = 0; i <= last; i += last)
        if (!(c * curve->knots[i] + d > 0))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "%g u + %g is %g at knot %d, %g; it must be positive", c, d,
                            c * curve->knots[i] + d, i + 1, curve->knots[i]);
    return BATTEN_OK;
}

/* w_i divided by the product of c U_(i+j) + d, j = 1 .. p, each taken against its value at the
 * start. */
static void moebius(const batten_curve *curve, double a, double b, double c, double d,
                    batten_curve *made)
{
    const int p = curve->degree, n = curve->count;
    const double *U = curve->knots;
    for (int i = 0; i <= n + p; i++)
        made->knots[i] = (a * U[i] + b) / (c * U[i] + d);
    const double start = c * U[p] + d;
    for (int i = 0; i < n; i++) {
        double factor = curve->weights ? curve->weights[i] : 1;
        for (int j = 1; j <= p; j++)
            factor *= start / (c * U[i + j] + d);
        made->weights[i] = factor;
    }
}

static batten_status moebius_open(const batten_curve *curve, double a, double b, double c,
                                  double d, batten_curve **out)
{
    batten_status status = check_moebius(curve, a, b, c, d);
    batten_curve *made = NULL;
    if (status == BATTEN_OK)
        status = bat_curve_make(curve->dimension, curve->degree, curve->count, true, &made);
    if (status != BATTEN_OK)
        return status;
    memcpy(made->points, curve->points,
           (size_t)curve->count * (size_t)curve->dimension * sizeof *made->points);
    moebius(curve, a, b, c, d, made);
    status = bat_knots_check(made->degree, made->count, made->knots, "new knot");
    if (status == BATTEN_OK)
        return bat_curve_finish(made, out);
    batten_curve_unref(made);
    return status;
}

batten_status batten_curve_moebius(const batten_curve *curve, double a, double b, double c,
                                   double d, batten_curve **out)
{
    assert(curve && out);
    if (!curve->periodic)
        return moebius_open(curve, a, b, c, d, out);
    /* Knots a period apart are no longer a period apart. */
    batten_curve *clamped;
    batten_status status = batten_curve_clamp(curve, &clamped);
    if (status != BATTEN_OK)
        return status;
    status = moebius_open(clamped, a, b, c, d, out);
    batten_curve_unref(clamped);
    return status;
}

/* ---- weights, dimension ---- */

/* The same knots and, as far as there are any, coordinates but `dropped` (-1: none), with other
 * dimension or with weights. */
static batten_status recast(const batten_curve *curve, int dimension, int dropped,
                            bool rational, batten_curve **out)
{
    batten_curve *made;
    const batten_status status =
        bat_curve_make(dimension, curve->degree, curve->count, rational, &made);
    if (status != BATTEN_OK)
        return status;
    const int n = curve->count, from = curve->dimension;
    made->periodic = curve->periodic;
    memcpy(made->knots, curve->knots, (size_t)(n + curve->degree + 1) * sizeof *made->knots);
    for (int i = 0; i < n; i++) {
        for (int k = 0, j = 0; k < from && j < dimension; k++)
            if (k != dropped)
                made->points[i * dimension + j++] = curve->points[i * from + k];
        if (rational)
            made->weights[i] = curve->weights ? curve->weights[i] : 1;
    }
    return bat_curve_finish(made, out);
}

batten_status batten_curve_to_rational(const batten_curve *curve, batten_curve **out)
{
    assert(curve && out);
    return recast(curve, curve->dimension, -1, true, out);
}

batten_status batten_curve_to_dimension(const batten_curve *curve, int dimension,
                                        batten_curve **out)
{
    assert(curve && out);
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    return recast(curve, dimension, -1, curve->weights != NULL, out);
}

/* Do all points agree in a coordinate? */
static bool is_flat(const batten_curve *curve, int axis, double rounding)
{
    const double *at = curve->points + axis;
    for (int i = 0; i < curve->count; i++)
        if (!(fabs(at[3 * i] - at[0]) <= rounding))
            return false;
    return true;
}

/* The last axis along which all points have one coordinate, to rounding; -1 for none. */
static int flat_axis(const batten_curve *curve)
{
    double largest = 0;
    for (int i = 0; i < 3 * curve->count; i++)
        largest = bat_max(largest, fabs(curve->points[i]));
    for (int axis = 2; axis >= 0; axis--)
        if (is_flat(curve, axis, 0x1p-46 * largest))
            return axis;
    return -1;
}

batten_status batten_curve_flatten(const batten_curve *curve, int *axis, batten_curve **out)
{
    assert(curve && axis && out);
    *axis = curve->dimension == 3 ? flat_axis(curve) : -1;
    if (*axis >= 0)
        return recast(curve, 2, *axis, curve->weights != NULL, out);
    *out = batten_curve_ref(curve);
    return BATTEN_OK;
}

/* ---- position ---- */

batten_status batten_curve_with_point(const batten_curve *curve, int index, const double *point,
                                      batten_curve **out)
{
    assert(curve && point && out && index >= 0 && index < curve->count);
    batten_curve *made;
    const batten_status status = bat_curve_copy(curve, &made);
    if (status != BATTEN_OK)
        return status;
    /* The wrapped points of a periodic curve repeat: each copy moves. */
    const int period = curve->periodic ? curve->count - curve->degree : curve->count;
    for (int i = index % period; i < curve->count; i += period)
        memcpy(made->points + i * curve->dimension, point,
               (size_t)curve->dimension * sizeof *point);
    return bat_curve_finish(made, out);
}

static batten_status check_map(const batten_affine *map)
{
    if (bat_first_not_finite(&map->m[0][0], 9) < 9 || bat_first_not_finite(map->t, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE, "the affine map has an element that is no number");
    return BATTEN_OK;
}

static void map_point(const batten_affine *map, int d, const double *from, double *to)
{
    for (int r = 0; r < d; r++) {
        double sum = map->t[r];
        for (int k = 0; k < d; k++)
            sum += map->m[r][k] * from[k];
        to[r] = sum;
    }
}

batten_status batten_curve_transform(const batten_curve *curve, const batten_affine *map,
                                     batten_curve **out)
{
    assert(curve && map && out);
    batten_curve *made = NULL;
    batten_status status = check_map(map);
    if (status == BATTEN_OK)
        status = bat_curve_copy(curve, &made);
    if (status != BATTEN_OK)
        return status;
    const int d = curve->dimension;
    const size_t total = (size_t)curve->count * (size_t)d;
    for (int i = 0; i < curve->count; i++)
        map_point(map, d, curve->points + i * d, made->points + i * d);
    const size_t bad = bat_first_not_finite(made->points, total);
    if (bad == total)
        return bat_curve_finish(made, out);
    batten_curve_unref(made);
    return bat_fail(BATTEN_OVERFLOW, "control point %zu is mapped to where numbers end",
                    bad / (size_t)d + 1);
}
