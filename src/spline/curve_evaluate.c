/* Points and derivatives, one by one and in batches: the same steps, hence the same bits. */
#include "spline/curve.h"

#include <string.h>

enum { MAX_ROWS = (BATTEN_MAX_DEGREE + 1) * BAT_MAX_WIDTH };

/* A span ready for evaluation. */
typedef struct {
    int knot;           /* index of the knot at its begin */
    double a, b;        /* its ends */
    bool tight;         /* bat_span_is_tight */
    const double *rows; /* [p + 1][width], Bezier */
} piece;

static piece make_piece(const batten_curve *curve, int span, double *rows)
{
    const int p = curve->degree;
    const double *U = curve->knots;
    bat_curve_rows(curve, span - p, p + 1, rows);
    bat_piece_from_rows(p, U, span, bat_curve_width(curve), rows);
    return (piece){span, U[span], U[span + 1], bat_span_is_tight(p, U, span), rows};
}

/* ---- derivatives of the homogeneous curve on one span ---- */

/* Bezier rows of the derivative `times` through differences of the control points. */
static void tight_rows(const batten_curve *curve, int span, int times, double *rows)
{
    const int p = curve->degree;
    const size_t width = bat_curve_width(curve);
    bat_curve_rows(curve, span - p, p + 1, rows);
    for (int q = p; q > p - times; q--)
        bat_rows_derive(q, curve->knots, span, width, rows);
    bat_piece_from_rows(p - times, curve->knots, span, width, rows);
}

/* out [order + 1][width], order <= p. */
static void homogeneous(const batten_curve *curve, const piece *on, double u, int order, double *out)
{
    const int p = curve->degree;
    const size_t width = bat_curve_width(curve);
    const double t = (u - on->a) / (on->b - on->a);
    double basis[BATTEN_MAX_DEGREE + 1], rows[MAX_ROWS];
    bat_bernstein(p, t, basis);
    bat_combine(p, basis, width, on->rows, out);
    if (order > 0)
        memcpy(rows, on->rows, ((size_t)p + 1) * width * sizeof *rows);
    for (int k = 1; k <= order; k++) {
        if (on->tight)
            tight_rows(curve, on->knot, k, rows);
        else
            bat_piece_derive(p - k + 1, on->b - on->a, width, rows);
        bat_bernstein(p - k, t, basis);
        bat_combine(p - k, basis, width, rows, out + (size_t)k * width);
    }
}

/* Leibniz for w P = A: P(k) = (A(k) - sum over i of C(k, i) w(i) P(k - i)) / w. `a` holds orders up to p. */
static void divide(int degree, size_t d, int order, const double *a, double *out)
{
    const size_t width = d + 1;
    for (int k = 0; k <= order; k++) {
        double *row = out + (size_t)k * d;
        for (size_t c = 0; c < d; c++)
            row[c] = k <= degree ? a[(size_t)k * width + c] : 0;
        double binomial = 1;
        for (int i = 1; i <= k && i <= degree; i++) {
            binomial = binomial * (k - i + 1) / i;
            const double factor = binomial * a[(size_t)i * width + d];
            for (size_t c = 0; c < d; c++)
                row[c] -= factor * out[(size_t)(k - i) * d + c];
        }
        for (size_t c = 0; c < d; c++)
            row[c] /= a[d];
    }
}

static void evaluate_on(const batten_curve *curve, const piece *on, double u, int order, double *out)
{
    const int p = curve->degree, stored = bat_min_int(order, p);
    const size_t d = (size_t)curve->dimension;
    if (curve->weights) {
        double a[MAX_ROWS];
        homogeneous(curve, on, u, stored, a);
        divide(p, d, order, a, out);
        return;
    }
    homogeneous(curve, on, u, stored, out);
    for (size_t i = ((size_t)stored + 1) * d; i < ((size_t)order + 1) * d; i++)
        out[i] = 0;
}

/* ---- one parameter ---- */

batten_status bat_curve_place(const batten_curve *curve, batten_side side, double *u)
{
    const double a = curve->knots[curve->degree], b = curve->knots[curve->count];
    if (!curve->periodic || !isfinite(*u))
        return bat_knots_clip(a, b, u);
    if (*u < a || *u >= b) {
        *u = a + fmod(*u - a, b - a);
        if (*u < a)
            *u += b - a;
        if (!(*u >= a && *u < b))
            *u = a;
    }
    /* The start seen from the left is the end of the period before. */
    if (*u == a && side == BATTEN_FROM_LEFT)
        *u = b;
    return BATTEN_OK;
}

static batten_status check_result(double u, size_t count, const double *out)
{
    if (bat_first_not_finite(out, count) < count)
        return bat_fail(BATTEN_OVERFLOW, "the point or a derivative at %.17g is too large for a number", u);
    return BATTEN_OK;
}

/* Through a buffer, so that an overflow leaves `out` alone. */
static batten_status evaluate_checked(const batten_curve *curve, const piece *on, double u, int order,
                                      double *buffer, double *out)
{
    const size_t count = ((size_t)order + 1) * (size_t)curve->dimension;
    evaluate_on(curve, on, u, order, buffer);
    const batten_status status = check_result(u, count, buffer);
    if (status == BATTEN_OK)
        memcpy(out, buffer, count * sizeof *out);
    return status;
}

batten_status batten_curve_evaluate_side(const batten_curve *curve, double u, batten_side side,
                                         int order, double *out)
{
    assert(curve && out && order >= 0);
    batten_status status = bat_curve_place(curve, side, &u);
    if (status != BATTEN_OK)
        return status;
    double rows[MAX_ROWS], small[MAX_ROWS];
    const int span = bat_knots_span(curve->degree, curve->count, curve->knots, u, side);
    const piece on = make_piece(curve, span, rows);
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

/* ---- many parameters ---- */

typedef struct {
    const batten_curve *curve;
    const bat_pieces *pieces; /* NULL: span by span */
    const double *u;
    int order;
    double *out;
} batch;

static piece stored_piece(const batten_curve *curve, const bat_pieces *pieces, int i)
{
    const size_t size = ((size_t)curve->degree + 1) * pieces->width;
    return (piece){pieces->spans[i], pieces->breaks[i], pieces->breaks[i + 1], pieces->tight[i],
                   pieces->rows + (size_t)i * size};
}

static bool holds(const batten_curve *curve, const piece *on, double u)
{
    return on->a <= u && (u < on->b || (u == on->b && u == curve->knots[curve->count]));
}

static batten_status evaluate_range(void *context, size_t begin, size_t end)
{
    const batch *work = context;
    const batten_curve *curve = work->curve;
    const size_t size = ((size_t)work->order + 1) * (size_t)curve->dimension;
    double rows[MAX_ROWS];
    piece on = {.a = INFINITY};
    for (size_t i = begin; i < end; i++) {
        double u = work->u[i];
        batten_status status = bat_curve_place(curve, BATTEN_FROM_RIGHT, &u);
        if (status == BATTEN_OK) {
            if (holds(curve, &on, u)) /* most often, when the parameters are sorted */
                ;
            else if (work->pieces)
                on = stored_piece(curve, work->pieces, bat_pieces_find(work->pieces, u));
            else
                on = make_piece(curve, bat_knots_span(curve->degree, curve->count, curve->knots, u,
                                                      BATTEN_FROM_RIGHT), rows);
            evaluate_on(curve, &on, u, work->order, work->out + i * size);
            status = check_result(u, size, work->out + i * size);
        }
        if (status != BATTEN_OK)
            return bat_fail(status, "parameter %zu, %.17g: %s", i, work->u[i],
                            batten_status_text(status));
    }
    return BATTEN_OK;
}

batten_status batten_curve_evaluate_many(const batten_curve *curve, size_t count, const double *u,
                                         int order, const batten_job *job, double *out)
{
    assert(curve && (count == 0 || (u && out)) && order >= 0);
    (void)job;
    batch work = {curve, NULL, u, order, out};
    work.pieces = bat_curve_pieces(curve, count);
    return evaluate_range(&work, 0, count);
}
