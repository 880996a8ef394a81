/*
 * The ribbon of an edge. For S = A / w, seen along the edge, with derivatives across it:
 *   S'  = (A' w - A w') / w^2
 *   S'' = ((A'' w - A w'') w - 2 w' (A' w - A w')) / w^3
 * and where w' = c w, w'' = e w all along the edge (cylinders, cones, surfaces of revolution
 * beside their axis) far simpler, S' = (A' - c A) / w, S'' = (A'' - 2 c A' + (2 c^2 - e) A) /
 * w.
 */
#include "shape/boundary/edge_fit.h"

#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/curve/product.h"
#include "spline/surface/surface.h"

#include <float.h>
#include <string.h>

/* A and w along the edge, and their derivatives across. */
typedef struct {
    int dimension, order;
    batten_curve *a[3], *w[3]; /* w NULL: not rational */
} rows;

static void rows_release(rows *r)
{
    for (int k = 0; k < 3; k++) {
        batten_curve_unref(r->a[k]);
        batten_curve_unref(r->w[k]);
    }
}

/* Columns first .. first + d - 1 of rows of the net as a polynomial curve. */
static batten_status row_curve(const bat_axis *axis, int d, size_t width, const double *row,
                               double sign, batten_curve **out)
{
    batten_curve *curve = NULL;
    const batten_status status = bat_curve_make(d, axis->degree, axis->count, false, &curve);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < axis->count; i++)
        for (int x = 0; x < d; x++)
            curve->points[i * d + x] = sign * row[(size_t)i * width + (size_t)x];
    memcpy(curve->knots, axis->knots,
           ((size_t)axis->count + (size_t)axis->degree + 1) * sizeof *curve->knots);
    curve->periodic = axis->periodic;
    return bat_curve_finish(curve, out);
}

static batten_status rows_make(const bat_nurbs *nurbs, const bat_edge_place *place, rows *out)
{
    const bat_axis *axis = &nurbs->axes[place->along];
    const int d = nurbs->base.dimension;
    double *row = bat_array3((size_t)axis->count, nurbs->width, sizeof *row);
    batten_status status = row ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k <= out->order; k++) {
        const double sign = k == 1 ? place->outward : 1;
        bat_nurbs_row(nurbs, bat_other(place->along), place->at, place->side, k, row);
        status = row_curve(axis, d, nurbs->width, row, sign, &out->a[k]);
        if (status == BATTEN_OK && nurbs->weights)
            status = row_curve(axis, 1, nurbs->width, row + d, sign, &out->w[k]);
    }
    bat_release(row);
    return status;
}

/* ---- rational edges ---- */

/* Is w[k] = factor w[0], to rounding? */
static bool proportional(const rows *r, int k, double *factor)
{
    const double *w0 = r->w[0]->points, *wk = r->w[k]->points;
    const double largest = bat_largest(r->w[k]->count, wk);
    *factor = wk[0] / w0[0];
    for (int i = 0; i < r->w[k]->count; i++)
        if (fabs(wk[i] - *factor * w0[i]) > 32 * DBL_EPSILON * largest)
            return false;
    return true;
}

/* The curve with numerator `a` [count][d] (knots those of the edge) over w. */
static batten_status over_weight(const rows *r, const double *a, batten_curve **out)
{
    const batten_curve *w = r->w[0];
    const int d = r->dimension;
    batten_curve *curve = NULL;
    const batten_status status = bat_curve_make(d, w->degree, w->count, true, &curve);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < w->count; i++) {
        curve->weights[i] = w->points[i];
        for (int x = 0; x < d; x++)
            curve->points[i * d + x] = a[i * d + x] / w->points[i];
    }
    memcpy(curve->knots, w->knots,
           ((size_t)w->count + (size_t)w->degree + 1) * sizeof *curve->knots);
    curve->periodic = w->periodic;
    return bat_curve_finish(curve, out);
}

/* The derivative of order k where the weights are proportional. */
static batten_status simple(const rows *r, int k, double c, double e, batten_curve **out)
{
    const size_t n = (size_t)r->w[0]->count * (size_t)r->dimension;
    double *a = bat_array(n, sizeof *a);
    if (!a)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < n; i++) {
        const double a0 = r->a[0]->points[i], a1 = r->a[1]->points[i];
        a[i] = k == 1 ? a1 - c * a0 : r->a[2]->points[i] - 2 * c * a1 + (2 * c * c - e) * a0;
    }
    const batten_status status = over_weight(r, a, out);
    bat_release(a);
    return status;
}

/* out = factor u x + other v y; all products are in Bezier form on the same breaks. */
static batten_status cross_product(const batten_curve *u, const batten_curve *x, double factor,
                                   const batten_curve *v, const batten_curve *y, double other,
                                   batten_curve **out)
{
    batten_curve *left = NULL, *right = NULL, *sum = NULL;
    batten_status status = bat_curve_product(u, x, &left);
    if (status == BATTEN_OK)
        status = bat_curve_product(v, y, &right);
    if (status == BATTEN_OK)
        status = bat_curve_copy(left, &sum);
    if (status == BATTEN_OK) {
        assert(left->count == right->count);
        for (int i = 0; i < sum->count * sum->dimension; i++)
            sum->points[i] = factor * left->points[i] + other * right->points[i];
        status = bat_curve_finish(sum, out);
    }
    batten_curve_unref(right);
    batten_curve_unref(left);
    return status;
}

static batten_status divide(const batten_curve *a, const batten_curve *w, batten_curve **out)
{
    batten_curve *curve = NULL, *fine = NULL;
    const int d = a->dimension;
    batten_status status = bat_curve_make(d, a->degree, a->count, true, &curve);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < a->count; i++) {
        curve->weights[i] = w->points[i];
        for (int x = 0; x < d; x++)
            curve->points[i * d + x] = a->points[i * d + x] / w->points[i];
    }
    memcpy(curve->knots, a->knots,
           ((size_t)a->count + (size_t)a->degree + 1) * sizeof *curve->knots);
    const double size = bat_largest(a->count * d, curve->points);
    status = bat_curve_finish(curve, &fine);
    if (status == BATTEN_OK)
        status = batten_curve_remove_knots(fine, 64 * DBL_EPSILON * size, NULL, NULL, out);
    batten_curve_unref(fine);
    return status;
}

static batten_status rational_slope(const rows *r, batten_curve **n1, batten_curve **out)
{
    batten_curve *w2 = NULL;
    batten_status status = cross_product(r->w[0], r->a[1], 1, r->w[1], r->a[0], -1, n1);
    if (status == BATTEN_OK)
        status = bat_curve_product(r->w[0], r->w[0], &w2);
    if (status == BATTEN_OK && out)
        status = divide(*n1, w2, out);
    batten_curve_unref(w2);
    return status;
}

static batten_status rational_curvature(const rows *r, const batten_curve *n1,
                                        batten_curve **out)
{
    batten_curve *n2 = NULL, *top = NULL, *w2 = NULL, *w3 = NULL;
    batten_status status = cross_product(r->w[0], r->a[2], 1, r->w[2], r->a[0], -1, &n2);
    if (status == BATTEN_OK)
        status = cross_product(r->w[0], n2, 1, r->w[1], n1, -2, &top);
    if (status == BATTEN_OK)
        status = bat_curve_product(r->w[0], r->w[0], &w2);
    if (status == BATTEN_OK)
        status = bat_curve_product(r->w[0], w2, &w3);
    if (status == BATTEN_OK)
        status = divide(top, w3, out);
    batten_curve_unref(w3);
    batten_curve_unref(w2);
    batten_curve_unref(top);
    batten_curve_unref(n2);
    return status;
}

static batten_status rational_ribbon(const rows *r, batten_curve **out)
{
    double c = 0, e = 0;
    if (proportional(r, 1, &c) && (r->order < 2 || proportional(r, 2, &e))) {
        batten_status status = simple(r, 1, c, e, &out[1]);
        return status == BATTEN_OK && r->order == 2 ? simple(r, 2, c, e, &out[2]) : status;
    }
    batten_curve *n1 = NULL;
    batten_status status = rational_slope(r, &n1, &out[1]);
    if (status == BATTEN_OK && r->order == 2)
        status = rational_curvature(r, n1, &out[2]);
    batten_curve_unref(n1);
    return status;
}

/* ---- any edge ---- */

static batten_status exact_ribbon(const batten_surface *surface, const bat_edge_place *place,
                                  int order, batten_curve **out)
{
    rows r = {.dimension = surface->dimension, .order = order};
    batten_status status = batten_surface_isocurve(
        surface, place->along == BATTEN_U ? BATTEN_V : BATTEN_U, place->at, &out[0]);
    if (status == BATTEN_OK)
        status = rows_make(bat_surface_nurbs(surface), place, &r);
    if (status == BATTEN_OK && r.w[0])
        status = rational_ribbon(&r, out);
    for (int k = 1; status == BATTEN_OK && !r.w[0] && k <= order; k++)
        out[k] = batten_curve_ref(r.a[k]);
    rows_release(&r);
    return status;
}

/* The degree of what is needed for an exact ribbon; beyond the limit it is fitted. */
static bool is_exact(const batten_surface *surface, const bat_edge_place *place, int order)
{
    if (surface->kind != &bat_nurbs_kind)
        return false;
    return !batten_surface_is_rational(surface) ||
           (order + 1) * batten_surface_degree(surface, place->along) <= BATTEN_MAX_DEGREE;
}

static batten_status fitted_ribbon(const batten_surface *surface, batten_edge edge, int order,
                                   double tolerance, batten_curve **out, double *error)
{
    const bool nurbs = surface->kind == &bat_nurbs_kind;
    const bat_edge_place place = bat_edge_of(surface, edge);
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k <= order; k++) {
        double far = 0;
        if (k == 0 && nurbs)
            status = batten_surface_isocurve(
                surface, place.along == BATTEN_U ? BATTEN_V : BATTEN_U, place.at, &out[0]);
        else
            status = bat_edge_fit(surface, edge, k, tolerance, &out[k], &far);
        *error = bat_max(*error, far);
    }
    return status;
}

batten_status batten_edge_ribbon(const batten_surface *surface, batten_edge edge, int order,
                                 double tolerance, double *error, batten_curve **curves)
{
    assert(surface && curves);
    if (order < 1 || order > 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the order of a ribbon is %d, not 1 or 2", order);
    if (edge < BATTEN_EDGE_V0 || edge > BATTEN_EDGE_U0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a surface has no edge %d", (int)edge);
    const bat_edge_place place = bat_edge_of(surface, edge);
    const bool exact = is_exact(surface, &place, order);
    if (!exact && !(tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the ribbon is not exact and needs a tolerance above 0, not %g",
                        tolerance);
    batten_curve *made[3] = {NULL, NULL, NULL};
    double far = 0;
    const batten_status status =
        exact ? exact_ribbon(surface, &place, order, made)
              : fitted_ribbon(surface, edge, order, tolerance, made, &far);
    for (int k = 0; k <= order; k++) {
        if (status == BATTEN_OK)
            curves[k] = made[k];
        else
            batten_curve_unref(made[k]);
    }
    if (status == BATTEN_OK && error)
        *error = far;
    return status;
}
