/* Curves from points and tangents. */
#include "numeric/vector.h"
#include "shape/local/hermite_data.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

/* ---- checks ---- */

batten_status bat_local_check_rows(int dimension, int count, const double *rows,
                                   const char *what)
{
    const size_t d = (size_t)dimension, n = (size_t)count * d;
    const size_t bad = bat_first_not_finite(rows, n);
    if (bad < n)
        return bat_fail(BATTEN_NOT_FINITE, "%s %zu has the coordinate %g", what, bad / d + 1,
                        rows[bad]);
    return BATTEN_OK;
}

/* Points and parameters of batten_curve_from_tangents and its like are good. */
static batten_status check_hermite_data(int dimension, int count, const double *points,
                                        const double *parameters, bool closed)
{
    batten_status status = bat_points_check(dimension, count, points, closed ? 1 : 2);
    if (status == BATTEN_OK)
        status = bat_parameters_check(count + closed, parameters);
    return status;
}

/* ---- control points ---- */

typedef struct {
    int d, count;
    bool closed;
    const double *points, *t, *leaving, *arriving;
} hermite;

static bool is_corner(const hermite *h, int i)
{
    for (int k = i * h->d; k < (i + 1) * h->d; k++)
        if (h->leaving[k] != h->arriving[k])
            return true;
    return false;
}

/* The step before or after point i; at an open end 0. */
static double step_before(const hermite *h, int i)
{
    if (i > 0)
        return h->t[i] - h->t[i - 1];
    return h->closed ? h->t[h->count] - h->t[h->count - 1] : 0;
}

static double step_after(const hermite *h, int i)
{
    return i + 1 < h->count || h->closed ? h->t[i + 1] - h->t[i] : 0;
}

/* The control point before point i, or after it. */
static void leg(const hermite *h, int i, bool after, double *out)
{
    const size_t at = (size_t)i * (size_t)h->d;
    const double third = after ? step_after(h, i) / 3 : -step_before(h, i) / 3;
    const double *tangent = (after ? h->leaving : h->arriving) + at;
    for (int k = 0; k < h->d; k++)
        out[k] = h->points[at + (size_t)k] + third * tangent[k];
}

/* At a point without corner the curve is a mean of the two legs, at all others it has the point
 * itself: so this is how far it passes from point i. */
static batten_status check_joint(const hermite *h, int i, const double *before,
                                 const double *after)
{
    const double a = step_before(h, i), b = step_after(h, i);
    const double *point = h->points + (size_t)i * (size_t)h->d;
    double off = 0;
    for (int k = 0; k < h->d; k++)
        off = bat_max(off, fabs(before[k] + a / (a + b) * (after[k] - before[k]) - point[k]));
    const double size = bat_max(bat_largest(h->d, before), bat_largest(h->d, after));
    if (!isfinite(size))
        return bat_fail(BATTEN_OVERFLOW, "the tangent at point %d is too long", i + 1);
    /* Each leg is rounded three times, their mean four times. */
    if (!(off <= 8 * DBL_EPSILON * size))
        return bat_fail(BATTEN_TOLERANCE_NOT_MET, "the curve misses point %d by %g", i + 1,
                        off);
    return BATTEN_OK;
}

/* Each point gives its legs, and itself at an end or corner; so many knots stand there. Returns
 * how many. `knots` begins with those of the first point. */
static batten_status fill(const hermite *h, double *control, double *knots, int *filled)
{
    const size_t row = (size_t)h->d;
    batten_status status = BATTEN_OK;
    int n = 0;
    for (int i = 0; i < h->count && status == BATTEN_OK; i++) {
        const bool first = !h->closed && i == 0, last = !h->closed && i == h->count - 1;
        const bool sharp = first || last || is_corner(h, i);
        double before[3], after[3];
        leg(h, i, false, before);
        leg(h, i, true, after);
        if (!sharp)
            status = check_joint(h, i, before, after);
        const double *rows[3] = {first ? NULL : before,
                                 sharp ? h->points + (size_t)i * row : NULL,
                                 last ? NULL : after};
        for (int k = 0; k < 3; k++)
            if (rows[k]) {
                knots[n] = h->t[i];
                memcpy(control + (size_t)n++ * row, rows[k], row * sizeof *control);
            }
    }
    *filled = n;
    return status;
}

/* The knots of a clamped curve: two more at both ends than `fill` gave. */
static void clamp_knots(int n, double *knots)
{
    memmove(knots + 2, knots, (size_t)n * sizeof *knots);
    knots[0] = knots[1] = knots[2];
    knots[n + 2] = knots[n + 3] = knots[n + 1];
}

/* The first control point of a period is the last that `fill` made. */
static void rotate(size_t row, int n, double *control)
{
    double last[3];
    memcpy(last, control + (size_t)(n - 1) * row, row * sizeof *last);
    memmove(control + row, control, (size_t)(n - 1) * row * sizeof *control);
    memcpy(control, last, row * sizeof *last);
}

static batten_status make_hermite_curve(const hermite *h, double *control, double *knots,
                                        batten_curve **out)
{
    int n = 0;
    const batten_status status = fill(h, control, knots, &n);
    if (status != BATTEN_OK)
        return status;
    if (!h->closed) {
        clamp_knots(n, knots);
        return batten_curve_create((batten_points){h->d, n, control}, 3, NULL, knots, out);
    }
    knots[n] = h->t[h->count];
    rotate((size_t)h->d, n, control);
    return batten_curve_create_periodic((batten_points){h->d, n, control}, 3, NULL, knots, out);
}

batten_status batten_curve_from_tangents(batten_points points, const double *parameters,
                                         const double *leaving, const double *arriving,
                                         bool closed, batten_curve **out)
{
    assert(points.at && parameters && leaving && out);
    batten_status status =
        check_hermite_data(points.dimension, points.count, points.at, parameters, closed);
    if (status == BATTEN_OK)
        status = bat_local_check_rows(points.dimension, points.count, leaving, "tangent");
    if (status == BATTEN_OK && arriving)
        status =
            bat_local_check_rows(points.dimension, points.count, arriving, "arriving tangent");
    if (status != BATTEN_OK)
        return status;
    const hermite h = {points.dimension,
                       points.count,
                       closed,
                       points.at,
                       parameters,
                       leaving,
                       arriving ? arriving : leaving};
    double *control =
        bat_array3((size_t)points.count, 3 * (size_t)points.dimension, sizeof *control);
    double *knots = bat_array3((size_t)points.count + 2, 3, sizeof *knots);
    status = BATTEN_OUT_OF_MEMORY;
    if (control && knots)
        status = make_hermite_curve(&h, control, knots, out);
    bat_release(control);
    bat_release(knots);
    return status;
}

/* ---- second derivatives ---- */

/* Of the span from point i on, at its begin or end. */
static double second_of_span(const hermite *h, int i, bool at_end, int k)
{
    const size_t d = (size_t)h->d, a = (size_t)i * d + (size_t)k,
                 b = (size_t)bat_around(h->count, i + 1) * d + (size_t)k;
    const double step = step_after(h, i), slope = (h->points[b] - h->points[a]) / step;
    const double near = at_end ? h->leaving[b] : h->leaving[a];
    const double far = at_end ? h->leaving[a] : h->leaving[b];
    return (at_end ? -1 : 1) * (6 * slope - 4 * near - 2 * far) / step;
}

static double second_at(const hermite *h, int i, int k)
{
    const double a = step_before(h, i), b = step_after(h, i);
    if (a == 0)
        return second_of_span(h, i, false, k);
    if (b == 0)
        return second_of_span(h, i - 1, true, k);
    const double before = second_of_span(h, bat_around(h->count, i - 1), true, k);
    const double after = second_of_span(h, i, false, k);
    return before + a / (a + b) * (after - before);
}

batten_status batten_second_derivatives(batten_points points, const double *parameters,
                                        const double *tangents, bool closed, double *second)
{
    assert(points.at && parameters && tangents && second);
    batten_status status =
        check_hermite_data(points.dimension, points.count, points.at, parameters, closed);
    if (status == BATTEN_OK)
        status = bat_local_check_rows(points.dimension, points.count, tangents, "tangent");
    if (status != BATTEN_OK)
        return status;
    const hermite h = {points.dimension, points.count, closed,  points.at,
                       parameters,       tangents,     tangents};
    double *made = bat_array3((size_t)points.count, (size_t)points.dimension, sizeof *made);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < points.count; i++)
        for (int k = 0; k < points.dimension; k++)
            made[i * points.dimension + k] = second_at(&h, i, k);
    const size_t n = (size_t)points.count * (size_t)points.dimension,
                 bad = bat_first_not_finite(made, n);
    if (bad < n)
        status = bat_fail(BATTEN_OVERFLOW, "the second derivative at point %zu is too large",
                          bad / (size_t)points.dimension + 1);
    else
        memcpy(second, made, n * sizeof *second);
    bat_release(made);
    return status;
}
