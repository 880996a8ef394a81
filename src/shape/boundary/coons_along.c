/*
 * The ribbon of a boundary curve taken from the surface beside it:
 *     slope(t) = (a0 (1 - t) + a1 t) N(t) + (b0 (1 - t) + b1 t) E'(t),
 * E the edge, N the derivative of the surface out of it. It lies in the tangent planes of the
 * surface whatever the factors, and these let it be at both ends what the patch's other
 * boundary curves are there.
 */
#include "numeric/vector.h"
#include "shape/boundary/edge_fit.h"
#include "spline/curve/curve.h"
#include "spline/curve/product.h"
#include "spline/surface/surface.h"
#include <batten/coons.h>
#include <batten/curvature.h>

#include <float.h>

/* ---- the edge ---- */

/* An end of the curve that is an end of the edge, is it to the bit. */
static batten_status snap(const batten_curve *edge, double tolerance, double *at)
{
    const batten_interval domain = batten_curve_domain(edge);
    double here[3], there[3];
    batten_status status = batten_curve_evaluate(edge, *at, 0, here);
    for (int e = 0; status == BATTEN_OK && e < 2; e++) {
        const double end = e ? domain.b : domain.a;
        status = batten_curve_evaluate(edge, end, 0, there);
        if (status == BATTEN_OK && bat_distance(edge->dimension, here, there) <= tolerance &&
            fabs(*at - end) < 0.25 * (domain.b - domain.a))
            *at = end;
    }
    return status;
}

/* The part of the edge beside the curve, in its direction, over [0, 1]. */
static batten_status take_part(const batten_curve *whole, const double at[2],
                               batten_curve **out)
{
    batten_curve *part = NULL, *turned = NULL;
    const bool reversed = at[1] < at[0];
    batten_status status =
        batten_curve_subrange(whole, reversed ? at[1] : at[0], reversed ? at[0] : at[1], &part);
    if (status == BATTEN_OK && reversed)
        status = batten_curve_reverse(part, &turned);
    else if (status == BATTEN_OK)
        turned = batten_curve_ref(part);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(turned, 0, 1, out);
    batten_curve_unref(turned);
    batten_curve_unref(part);
    return status;
}

/* Edge and outward derivatives, polynomial. */
static batten_status take_ribbon(const batten_surface *surface, batten_edge edge, int order,
                                 double tolerance, batten_curve *ribbon[3], double *error)
{
    if (surface->kind == &bat_nurbs_kind && !batten_surface_is_rational(surface))
        return batten_edge_ribbon(surface, edge, bat_max_int(1, order), tolerance, error,
                                  ribbon);
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k <= order; k++) {
        double far = 0;
        status = bat_edge_fit(surface, edge, k, tolerance / 4, &ribbon[k], &far);
        *error = bat_max(*error, far);
    }
    return status;
}

/* ---- the slope ---- */

/* The derivative of a clamped polynomial curve, of degree 1 at least. */
static batten_status derive(const batten_curve *curve, batten_curve **out)
{
    batten_curve *raised = NULL, *made = NULL;
    batten_status status = batten_curve_elevate(curve, curve->degree < 2, &raised);
    if (status != BATTEN_OK)
        return status;
    const int p = raised->degree, n = raised->count, d = raised->dimension;
    const double *U = raised->knots;
    for (int i = p + 1; i < n; i++)
        if (status == BATTEN_OK && U[i] == U[i + p - 1] && i + p - 1 < n)
            status = bat_fail(BATTEN_SINGULAR_HERE,
                              "the edge may have a corner at %g of its length, where it has no "
                              "direction",
                              U[i]);
    if (status == BATTEN_OK)
        status = bat_curve_make(d, p - 1, n - 1, false, &made);
    if (status == BATTEN_OK) {
        for (int i = 0; i + 1 < n; i++)
            for (int x = 0; x < d; x++)
                made->points[i * d + x] =
                    p * (raised->points[(i + 1) * d + x] - raised->points[i * d + x]) /
                    (U[i + p + 1] - U[i + 1]);
        for (int i = 0; i < n + p - 1; i++)
            made->knots[i] = U[i + 1];
        status = bat_curve_finish(made, out);
    }
    batten_curve_unref(raised);
    return status;
}

/* a N + b E' = wanted in the plane of both; *misfit: the sine of what is out of it. */
static batten_status solve_at_end(int d, const double *n, const double *e, const double *wanted,
                                  double *a, double *b, double *misfit)
{
    const double nn = bat_dot(d, n, n), ne = bat_dot(d, n, e), ee = bat_dot(d, e, e);
    const double area2 = nn * ee - ne * ne, length = bat_norm(d, wanted);
    /* The square of a sine of 1e-12, below which the area is rounding alone. */
    if (!(area2 > 1e-24 * nn * ee) || !isfinite(area2))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the surface has no tangent plane at an end of the curve");
    const double wn = bat_dot(d, wanted, n), we = bat_dot(d, wanted, e);
    *a = (wn * ee - we * ne) / area2;
    *b = (we * nn - wn * ne) / area2;
    double rest[3];
    for (int x = 0; x < d; x++)
        rest[x] = wanted[x] - *a * n[x] - *b * e[x];
    *misfit = length > 0 ? bat_norm(d, rest) / length : 0;
    return BATTEN_OK;
}

/* The factors at both ends: [0] of N, [1] of E'. */
static batten_status find_factors(const batten_curve *n, const batten_curve *e,
                                  const double *ends, double factors[2][2], double misfit[2])
{
    const int d = n->dimension;
    batten_status status = BATTEN_OK;
    for (int end = 0; status == BATTEN_OK && end < 2; end++) {
        double slope[3], both[6];
        const double *along = both + d;
        status = batten_curve_evaluate(n, end, 0, slope);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(e, end, 1, both);
        if (status == BATTEN_OK)
            status = solve_at_end(d, slope, along, ends + end * d, &factors[0][end],
                                  &factors[1][end], &misfit[end]);
        /* Rounding must not raise a degree. */
        if (status == BATTEN_OK && fabs(factors[1][end]) * bat_norm(d, along) <=
                                       64 * DBL_EPSILON * bat_norm(d, ends + end * d))
            factors[1][end] = 0;
    }
    if (status == BATTEN_OK && !(factors[0][0] * factors[0][1] > 0))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the boundary curves beside the edge leave the surface to different "
                        "sides: %g and %g times its slope",
                        factors[0][0], factors[0][1]);
    if (status == BATTEN_OK &&
        fabs(factors[0][1] - factors[0][0]) <= 64 * DBL_EPSILON * fabs(factors[0][0]))
        factors[0][1] = factors[0][0];
    return status;
}

/* A curve times the linear function from f[0] to f[1]. */
static batten_status times_linear(const double f[2], const batten_curve *curve,
                                  batten_curve **out)
{
    static const double knots[] = {0, 0, 1, 1};
    batten_curve *linear = NULL;
    if (f[0] == f[1]) {
        const batten_affine map = batten_affine_scaling(f[0], f[0], f[0]);
        return batten_curve_transform(curve, &map, out);
    }
    batten_status status =
        batten_curve_create((batten_points){1, 2, f}, 1, NULL, knots, &linear);
    if (status == BATTEN_OK)
        status = bat_curve_product(linear, curve, out);
    batten_curve_unref(linear);
    return status;
}

static batten_status add_curves(const batten_curve *first, const batten_curve *second,
                                batten_curve **out)
{
    const batten_curve *const given[2] = {first, second};
    batten_curve *common[2] = {NULL, NULL}, *sum = NULL;
    batten_status status = batten_curves_unify(2, given, common);
    if (status == BATTEN_OK)
        status = bat_curve_copy(common[0], &sum);
    if (status == BATTEN_OK) {
        for (int i = 0; i < sum->count * sum->dimension; i++)
            sum->points[i] += common[1]->points[i];
        status = bat_curve_finish(sum, out);
    }
    batten_curve_unref(common[1]);
    batten_curve_unref(common[0]);
    return status;
}

static batten_status remove_free_knots(const batten_curve *curve, batten_curve **out)
{
    const double size = bat_largest(curve->count * curve->dimension, curve->points);
    return batten_curve_remove_knots(curve, 32 * DBL_EPSILON * size, NULL, NULL, out);
}

/* The slope from both ends' factors. */
static batten_status combine_slopes(double factors[2][2], const batten_curve *edge,
                                    const batten_curve *n, batten_curve **out)
{
    batten_curve *along = NULL, *across = NULL, *shear = NULL, *sum = NULL;
    batten_status status = times_linear(factors[0], n, &across);
    if (status == BATTEN_OK && (factors[1][0] != 0 || factors[1][1] != 0)) {
        status = derive(edge, &along);
        if (status == BATTEN_OK)
            status = times_linear(factors[1], along, &shear);
        if (status == BATTEN_OK)
            status = add_curves(across, shear, &sum);
    } else if (status == BATTEN_OK) {
        sum = batten_curve_ref(across);
    }
    if (status == BATTEN_OK)
        status = remove_free_knots(sum, out);
    batten_curve_unref(sum);
    batten_curve_unref(shear);
    batten_curve_unref(across);
    batten_curve_unref(along);
    return status;
}

/* From the part of the edge and its derivatives, part [order + 1], to those of the ribbon. */
static batten_status fit_ribbon(int order, batten_curve *const *part, const double *ends,
                                batten_curve **ribbon, double misfit[2], double *factor)
{
    double factors[2][2] = {{0}};
    batten_status status = find_factors(part[1], part[0], ends, factors, misfit);
    *factor = bat_max(fabs(factors[0][0]), fabs(factors[0][1]));
    if (status != BATTEN_OK || order < 2)
        return status == BATTEN_OK ? combine_slopes(factors, part[0], part[1], &ribbon[1])
                                   : status;
    /* One factor for all of the edge: only so curvatures stay what they are. */
    const double a = factors[0][0] / 2 + factors[0][1] / 2, whole[2] = {a, a},
                 square[2] = {a * a, a * a};
    status = times_linear(whole, part[1], &ribbon[1]);
    if (status == BATTEN_OK)
        status = times_linear(square, part[2], &ribbon[2]);
    return status;
}

/* The ribbon from the edge that was found; `at` are the ends of the curve on it. */
static batten_status ribbon_of(const batten_surface *surface, batten_edge edge, double at[2],
                               const batten_ribbon_wish *wish, batten_curve *made[3],
                               double misfit[2], double *error)
{
    const int order = wish->order;
    const double tolerance = wish->tolerance;
    batten_curve *whole[3] = {NULL, NULL, NULL}, *part[3] = {NULL, NULL, NULL};
    double factor = 1;
    batten_status status = take_ribbon(surface, edge, order, tolerance, whole, error);
    for (int e = 0; status == BATTEN_OK && e < 2; e++)
        status = snap(whole[0], tolerance, &at[e]);
    for (int k = 0; status == BATTEN_OK && k <= order; k++)
        status = take_part(whole[k], at, &part[k]);
    if (status == BATTEN_OK && order > 0)
        status = fit_ribbon(order, part, wish->ends, made, misfit, &factor);
    if (status == BATTEN_OK)
        made[0] = batten_curve_ref(part[0]);
    *error *= bat_max(1, order < 2 ? factor : factor * factor);
    for (int k = 0; k < 3; k++) {
        batten_curve_unref(part[k]);
        batten_curve_unref(whole[k]);
    }
    return status;
}

static batten_status check_edge(const batten_surface *surface, const batten_curve *curve,
                                int order, const double *ends, double tolerance)
{
    if (!(tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    if (order < 0 || order > 2 || (order > 0 && !ends))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a ribbon of order %d cannot be", order);
    if (curve->dimension != surface->dimension)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "curve and surface have %d and %d dimensions",
                        curve->dimension, surface->dimension);
    return BATTEN_OK;
}

batten_status batten_ribbon_along(const batten_surface *surface, const batten_curve *curve,
                                  batten_ribbon_wish wish, double *misfit, double *error,
                                  batten_curve **ribbon)
{
    assert(surface && curve && ribbon);
    batten_curve *made[3] = {NULL, NULL, NULL};
    batten_edge edge = BATTEN_EDGE_V0;
    double at[2] = {0, 0}, far = 0, off[2] = {0, 0};
    batten_status status = check_edge(surface, curve, wish.order, wish.ends, wish.tolerance);
    if (status == BATTEN_OK)
        status = bat_edge_beside(surface, curve, wish.tolerance, &edge, at);
    if (status == BATTEN_OK)
        status = ribbon_of(surface, edge, at, &wish, made, off, &far);
    for (int k = 0; k <= wish.order && k < 3; k++) {
        if (status == BATTEN_OK)
            ribbon[k] = made[k];
        else
            batten_curve_unref(made[k]);
    }
    for (int e = 0; status == BATTEN_OK && misfit && e < 2; e++)
        misfit[e] = off[e];
    if (status == BATTEN_OK && error)
        *error = far;
    return status;
}
