/* Points and derivatives, one by one and in batches: the same steps, hence the same bits. */
#include "spline/curve/curve.h"

#include <string.h>

bat_piece bat_curve_piece(const batten_curve *curve, int span, double *rows)
{
    const int p = curve->degree;
    const double *U = curve->knots;
    bat_curve_rows(curve, span - p, p + 1, bat_curve_width(curve), rows);
    bat_piece_from_rows(p, U, span, bat_curve_width(curve), rows);
    return (bat_piece){
        span, U[span], U[span + 1], bat_span_is_tight(p, U, span), bat_curve_width(curve),
        rows};
}

/* ---- derivatives of the homogeneous curve on one span ---- */

/* Bezier rows of the derivative `times` through differences of the control points. */
static void tight_rows(const batten_curve *curve, int span, int times, size_t width,
                       double *rows)
{
    const int p = curve->degree;
    bat_curve_rows(curve, span - p, p + 1, width, rows);
    for (int q = p; q > p - times; q--)
        bat_rows_derive(q, curve->knots, span, width, rows);
    bat_piece_from_rows(p - times, curve->knots, span, width, rows);
}

/* out [order + 1][stride of the piece], order <= p. */
static void homogeneous(const batten_curve *curve, const bat_piece *on, double u, int order,
                        double *out)
{
    const int p = curve->degree;
    const size_t stride = on->stride;
    const double h = on->b - on->a, t = (u - on->a) / h;
    /* Unequal weights can make the curve run at any speed, so near the end 1 - t must be known
     * as well as t is near the start; that s + t is not quite 1 then cancels in the quotient.
     * Without weights it would not. */
    const double s = curve->weights ? (on->b - u) / h : 1 - t;
    double basis[BATTEN_MAX_DEGREE + 1], rows[BAT_MAX_ROWS];
    bat_bernstein(p, t, s, basis);
    bat_combine(p, basis, stride, on->rows, out);
    if (order > 0)
        memcpy(rows, on->rows, ((size_t)p + 1) * stride * sizeof *rows);
    for (int k = 1; k <= order; k++) {
        if (on->tight)
            tight_rows(curve, on->knot, k, stride, rows);
        else
            bat_piece_derive(p - k + 1, h, stride, rows);
        bat_bernstein(p - k, t, s, basis);
        bat_combine(p - k, basis, stride, rows, out + (size_t)k * stride);
    }
}

void bat_divide(int degree, size_t d, int order, size_t stride, const double *a, double *out)
{
    for (int k = 0; k <= order; k++) {
        double *row = out + (size_t)k * d;
        for (size_t c = 0; c < d; c++)
            row[c] = k <= degree ? a[(size_t)k * stride + c] : 0;
        double binomial = 1;
        for (int i = 1; i <= k && i <= degree; i++) {
            binomial = binomial * (k - i + 1) / i;
            const double factor = binomial * a[(size_t)i * stride + d];
            for (size_t c = 0; c < d; c++)
                row[c] -= factor * out[(size_t)(k - i) * d + c];
        }
        for (size_t c = 0; c < d; c++)
            row[c] /= a[d];
    }
}

void bat_curve_on_piece(const batten_curve *curve, const bat_piece *on, double u, int order,
                        double *out)
{
    const int p = curve->degree, stored = bat_min_int(order, p);
    const size_t d = (size_t)curve->dimension;
    double a[BAT_MAX_ROWS];
    homogeneous(curve, on, u, stored, a);
    if (curve->weights) {
        bat_divide(p, d, order, on->stride, a, out);
        return;
    }
    for (int k = 0; k <= order; k++)
        for (size_t c = 0; c < d; c++)
            out[(size_t)k * d + c] = k <= stored ? a[(size_t)k * on->stride + c] : 0;
}

/* ---- one parameter ---- */

/* By whole periods into [a, b). */
static double into_period(double a, double b, double u)
{
    u = a + fmod(u - a, b - a);
    if (u < a)
        u += b - a;
    return u >= a && u < b ? u : a;
}

batten_status bat_curve_place(const batten_curve *curve, batten_side side, double *u)
{
    const double a = curve->knots[curve->degree], b = curve->knots[curve->count];
    if (!curve->periodic || !isfinite(*u))
        return bat_knots_clip(a, b, u);
    if (*u < a || *u >= b)
        *u = into_period(a, b, *u);
    /* The start seen from the left is the end of the period before. */
    if (*u == a && side == BATTEN_FROM_LEFT)
        *u = b;
    return BATTEN_OK;
}

/* OVERFLOW when one of the numbers computed at u is not finite. */
static batten_status check_result(double u, size_t count, const double *out)
{
    if (bat_first_not_finite(out, count) < count)
        return bat_fail(BATTEN_OVERFLOW,
                        "the point or a derivative at %.17g is too large for a number", u);
    return BATTEN_OK;
}

/* Through a buffer, so that an overflow leaves `out` alone. */
static batten_status evaluate_checked(const batten_curve *curve, const bat_piece *on, double u,
                                      int order, double *buffer, double *out)
{
    const size_t count = ((size_t)order + 1) * (size_t)curve->dimension;
    bat_curve_on_piece(curve, on, u, order, buffer);
    const batten_status status = check_result(u, count, buffer);
    if (status == BATTEN_OK)
        memcpy(out, buffer, count * sizeof *out);
    return status;
}

/* From the pieces of an earlier batch, else made here. */
static bat_piece piece_at(const batten_curve *curve, double u, batten_side side, double *rows)
{
    const bat_pieces *pieces = side == BATTEN_FROM_RIGHT ? bat_curve_pieces(curve, 0) : NULL;
    if (pieces)
        return bat_pieces_find(pieces, curve->degree, u);
    return bat_curve_piece(
        curve, bat_knots_span(curve->degree, curve->count, curve->knots, u, side), rows);
}

batten_status batten_curve_evaluate_side(const batten_curve *curve, double u, batten_side side,
                                         int order, double *out)
{
    assert(curve && out && order >= 0);
    batten_status status = bat_curve_place(curve, side, &u);
    if (status != BATTEN_OK)
        return status;
    double rows[BAT_MAX_ROWS], small[BAT_MAX_ROWS];
    const bat_piece on = piece_at(curve, u, side, rows);
    if (order <= BATTEN_MAX_DEGREE)
        return evaluate_checked(curve, &on, u, order, small, out);
    double *large = bat_array3((size_t)order + 1, (size_t)curve->dimension, sizeof *large);
    status = large ? evaluate_checked(curve, &on, u, order, large, out) : BATTEN_OUT_OF_MEMORY;
    bat_release(large);
    return status;
}

batten_status batten_curve_evaluate(const batten_curve *curve, double u, int order, double *out)
{
    return batten_curve_evaluate_side(curve, u, BATTEN_FROM_RIGHT, order, out);
}
