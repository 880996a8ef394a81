/*
 * The last piece of a spline beyond its end. With the last knot b moved to u, control point i
 * becomes the blossom of the last piece at its p knots U[i + 1] .. U[i + p], those that were b
 * being u now; the others keep their bits, and the curve its shape.
 */
#include "shape/curve_change/extend.h"
#include "spline/curve/curve.h"
#include <batten/measure.h>

#include <string.h>

/* The blossom of the last piece at t[0..p-1], by de Boor's steps: columns first .. first + w -
 * 1 of one row, w <= BAT_MAX_WIDTH. */
static void blossom(const bat_spline *s, const double *t, size_t column, size_t w, double *out)
{
    const int p = s->degree, first = s->count - 1 - p;
    const double *U = s->knots + first;
    double work[BAT_MAX_ROWS];
    for (int j = 0; j <= p; j++)
        memcpy(work + (size_t)j * w, s->values + (size_t)(first + j) * s->width + column,
               w * sizeof *work);
    for (int r = 1; r <= p; r++)
        for (int j = p; j >= r; j--) {
            const double a = U[j], b = U[j + p - r + 1], share = (t[r - 1] - a) / (b - a);
            for (size_t k = 0; k < w; k++) {
                double *row = work + (size_t)j * w + k;
                *row = (1 - share) * *(row - w) + share * *row;
            }
        }
    memcpy(out + column, work + (size_t)p * w, w * sizeof *out);
}

/* The weights of a rational piece stay positive as far as it may be extended. */
static batten_status check_weights(const bat_spline *s, double u)
{
    for (int i = s->count - s->degree; i < s->count; i++) {
        const double weight = s->values[(size_t)i * s->width + s->width - 1];
        if (!(weight > 0))
            return bat_fail(BATTEN_BAD_WEIGHT,
                            "gone on to u = %.17g, control point %d has the weight %g", u,
                            i + 1, weight);
    }
    return BATTEN_OK;
}

static void move_end(const bat_spline *from, double u, bat_spline *made)
{
    const int p = from->degree, n = from->count;
    double t[BATTEN_MAX_DEGREE];
    memcpy(made->values, from->values, (size_t)(n - p) * from->width * sizeof *made->values);
    memcpy(made->knots, from->knots, (size_t)n * sizeof *made->knots);
    for (int i = n; i <= n + p; i++)
        made->knots[i] = u;
    for (int i = n - p; i < n; i++) {
        for (int k = 0; k < p; k++)
            t[k] = i + 1 + k < n ? from->knots[i + 1 + k] : u;
        for (size_t column = 0; column < from->width; column += BAT_MAX_WIDTH)
            blossom(from, t, column,
                    from->width - column < BAT_MAX_WIDTH ? from->width - column : BAT_MAX_WIDTH,
                    made->values + (size_t)i * from->width);
    }
}

batten_status bat_spline_go_on(const bat_spline *from, double u, bat_spline *out)
{
    const batten_status status = bat_spline_make(from->degree, from->count, from->width, out);
    if (status == BATTEN_OK)
        move_end(from, u, out);
    return status;
}

batten_status bat_curve_go_on(const batten_curve *curve, double u, batten_curve **out)
{
    bat_spline from, made;
    batten_status status = bat_curve_to_spline(curve, &from);
    if (status != BATTEN_OK)
        return status;
    status = bat_spline_go_on(&from, u, &made);
    if (status == BATTEN_OK) {
        if (curve->weights)
            status = check_weights(&made, u);
        if (status == BATTEN_OK)
            status = bat_curve_from_spline(curve, &from, 0, &made, out);
        bat_spline_free(&made);
    }
    bat_spline_free(&from);
    return status;
}

/* The parameter at `length` from the end of the curve, continued to u; NAN if that is not as
 * long. */
static batten_status reach_parameter(const batten_curve *curve, double u, double length,
                                     double tolerance, double *at)
{
    batten_curve *longer = NULL, *tail = NULL;
    double reached = 0;
    batten_status status = bat_curve_go_on(curve, u, &longer);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(longer, batten_curve_domain(curve).b, u, &tail);
    if (status == BATTEN_OK)
        status = batten_curve_length(tail, tolerance / 4, NULL, &reached);
    *at = (double)NAN;
    if (status == BATTEN_OK && reached >= length)
        status = batten_curve_at_length(tail, 1, &length, tolerance / 2, at);
    batten_curve_unref(tail);
    batten_curve_unref(longer);
    return status;
}

batten_status bat_curve_go_on_by(const batten_curve *curve, double length, double first,
                                 double tolerance, double *u)
{
    enum { ROUNDS = 100 };
    const double b = batten_curve_domain(curve).b;
    double low = 0, high = HUGE_VAL, way = first;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < ROUNDS && b + way > b && isfinite(b + way); i++) {
        double at;
        status = reach_parameter(curve, b + way, length, tolerance, &at);
        if (status != BATTEN_OK && status != BATTEN_BAD_WEIGHT)
            return status;
        if (status == BATTEN_OK && !isnan(at)) {
            *u = at;
            return BATTEN_OK;
        }
        if (status == BATTEN_OK)
            low = way;
        else
            high = way;
        way = isfinite(high) ? low + (high - low) / 2 : 2 * way;
    }
    return bat_fail(status == BATTEN_BAD_WEIGHT ? status : BATTEN_TOLERANCE_NOT_MET,
                    "the curve cannot be extended by %g: parameters up to %.17g were tried",
                    length, b + low);
}
