/* Curves from and to other ways of writing them: Bezier, Hermite, powers. */
#include "base/plural.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <string.h>

/* ---- Bezier ---- */

batten_status bat_breaks_check(int piece_count, const double *breaks)
{
    if (piece_count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "%d piece%s; at least 1 is needed", piece_count,
                        bat_plural(piece_count));
    for (int i = 0; i <= piece_count; i++) {
        if (!isfinite(breaks[i]))
            return bat_fail(BATTEN_NOT_FINITE, "break %d is %g", i + 1, breaks[i]);
        if (i > 0 && breaks[i] <= breaks[i - 1])
            return bat_fail(BATTEN_NOT_INCREASING,
                            "break %d is %.17g, not above %.17g before it", i + 1, breaks[i],
                            breaks[i - 1]);
    }
    return BATTEN_OK;
}

double *bat_knots_of_breaks(int degree, int times, int piece_count, const double *breaks)
{
    const size_t inner = (size_t)times * (size_t)(piece_count - 1), ends = (size_t)degree + 1;
    double *knots = bat_array(inner + 2 * ends, sizeof *knots);
    if (!knots)
        return NULL;
    double *next = knots;
    for (int i = 0; i <= piece_count; i++)
        for (int k = i == 0 || i == piece_count ? degree + 1 : times; k > 0; k--)
            *next++ = breaks[i];
    return knots;
}

static batten_status check_size(int degree, double count)
{
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", degree,
                        BATTEN_MAX_DEGREE);
    if (count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%.0f control points would be needed; the limit is %d", count,
                        BAT_MAX_POINTS);
    return BATTEN_OK;
}

batten_status batten_curve_from_bezier(int dimension, batten_pieces pieces,
                                       const double *points, const double *weights,
                                       batten_curve **out)
{
    assert(points && pieces.breaks && out);
    batten_status status = check_size(pieces.degree, (double)pieces.count * pieces.degree + 1);
    if (status == BATTEN_OK)
        status = bat_breaks_check(pieces.count, pieces.breaks);
    if (status != BATTEN_OK)
        return status;
    double *knots =
        bat_knots_of_breaks(pieces.degree, pieces.degree, pieces.count, pieces.breaks);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    status = batten_curve_create(
        (batten_points){dimension, pieces.count * pieces.degree + 1, points}, pieces.degree,
        weights, knots, out);
    bat_release(knots);
    return status;
}

/* ---- Hermite ---- */

/* The elementary symmetric polynomials of y, in e, which begins as 1, 0 .. */
static void add_symmetric(int count, const double *y, double *e)
{
    for (int i = 0; i < count; i++)
        for (int r = i + 1; r > 0; r--)
            e[r] += y[i] * e[r - 1];
}

/* Control point of degree p = 2 k - 1 with the knots u (k times), u + y[0] .. u + y[k - 2]: the
 * blossom there, sum over r of e_r(y) (p - r)! / p! P^(r)(u), with the elementary symmetric
 * polynomials e_r. */
static void hermite_point(int d, int k, const double *y, const double *derivatives, double *out)
{
    double e[4] = {1, 0, 0, 0};
    add_symmetric(k - 1, y, e);
    for (int c = 0; c < d; c++) {
        double sum = 0, factor = 1;
        for (int r = 0; r < k; r++) {
            sum += e[r] * factor * derivatives[r * d + c];
            factor /= 2 * k - 1 - r;
        }
        out[c] = sum;
    }
}

/* a of the other knots of a point lie at the node before, the rest at the one after. */
void bat_hermite_points(int d, int count, int k, const double *parameters, const double *values,
                        double *out)
{
    for (int i = 0; i < count; i++) {
        const double before = i > 0 ? parameters[i - 1] - parameters[i] : 0;
        const double after = i < count - 1 ? parameters[i + 1] - parameters[i] : 0;
        for (int a = k - 1; a >= 0; a--, out += d) {
            double y[3];
            for (int j = 0; j < k - 1; j++)
                y[j] = j < a ? before : after;
            hermite_point(d, k, y, values + (size_t)i * (size_t)(k * d), out);
        }
    }
}

batten_status batten_curve_from_hermite(int dimension, int count, int k,
                                        const double *parameters, const double *values,
                                        batten_curve **out)
{
    assert(parameters && values && out);
    if (k < 1 || k > 4)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d values at each parameter; 1..4 are possible",
                        k);
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    if (count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "%d parameter%s; at least 2 are needed", count,
                        bat_plural(count));
    batten_status status = check_size(2 * k - 1, (double)count * k);
    if (status == BATTEN_OK)
        status = bat_breaks_check(count - 1, parameters);
    if (status != BATTEN_OK)
        return status;
    double *knots = bat_knots_of_breaks(2 * k - 1, k, count - 1, parameters);
    double *points = bat_array3((size_t)count, (size_t)(k * dimension), sizeof *points);
    status = knots && points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        bat_hermite_points(dimension, count, k, parameters, values, points);
        status = batten_curve_create((batten_points){dimension, count * k, points}, 2 * k - 1,
                                     NULL, knots, out);
    }
    bat_release(points);
    bat_release(knots);
    return status;
}

/* ---- powers ---- */

/* b_j = sum over i <= j of C(j, i) / C(p, i) c_i h^i */
void bat_power_to_bezier(int p, size_t d, double h, const double *c, double *b)
{
    for (int j = 0; j <= p; j++)
        for (size_t k = 0; k < d; k++) {
            double sum = c[k], power = 1;
            for (int i = 1; i <= j; i++) {
                power *= h;
                sum += bat_binomials[j][i] / bat_binomials[p][i] * power * c[(size_t)i * d + k];
            }
            b[(size_t)j * d + k] = sum;
        }
}

static batten_status check_joint(size_t d, int joint, const double *end, const double *start,
                                 double tolerance)
{
    const double gap = bat_distance((int)d, end, start);
    if (!(gap <= tolerance))
        return bat_fail(BATTEN_NOT_COMPATIBLE, "pieces %d and %d are %g apart, more than %g",
                        joint - 1 + 1, joint + 1, gap, tolerance);
    return BATTEN_OK;
}

static batten_status power_points(size_t d, int p, int piece_count, const double *breaks,
                                  const double *coefficients, double tolerance, double *points)
{
    const size_t step = (size_t)p * d;
    for (int i = 0; i < piece_count; i++) {
        const double *c = coefficients + (size_t)i * (step + d);
        const batten_status status =
            i > 0 ? check_joint(d, i, points + (size_t)i * step, c, tolerance) : BATTEN_OK;
        if (status != BATTEN_OK)
            return status;
        bat_power_to_bezier(p, d, breaks[i + 1] - breaks[i], c, points + (size_t)i * step);
    }
    return BATTEN_OK;
}

batten_status batten_curve_from_power(int dimension, batten_pieces pieces,
                                      const double *coefficients, double tolerance,
                                      batten_curve **out)
{
    assert(pieces.breaks && coefficients && out);
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    if (!(tolerance >= 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", tolerance);
    batten_status status = check_size(pieces.degree, (double)pieces.count * pieces.degree + 1);
    if (status == BATTEN_OK)
        status = bat_breaks_check(pieces.count, pieces.breaks);
    if (status != BATTEN_OK)
        return status;
    const size_t d = (size_t)dimension;
    double *points = bat_array3((size_t)(pieces.count * pieces.degree + 1), d, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    status = power_points(d, pieces.degree, pieces.count, pieces.breaks, coefficients,
                          tolerance, points);
    if (status == BATTEN_OK)
        status = batten_curve_from_bezier(dimension, pieces, points, NULL, out);
    bat_release(points);
    return status;
}

batten_status batten_curve_to_power(const batten_curve *curve, double *coefficients)
{
    assert(curve && coefficients);
    const int p = curve->degree;
    const size_t d = (size_t)curve->dimension, size = ((size_t)p + 1) * d;
    if (curve->weights)
        return bat_fail(BATTEN_UNSUPPORTED, "a rational curve has no form in powers");
    for (int k = p, piece = 0; k < curve->count; k++) {
        if (curve->knots[k] == curve->knots[k + 1])
            continue;
        double *c = coefficients + (size_t)piece++ * size;
        const batten_status status = batten_curve_evaluate(curve, curve->knots[k], p, c);
        if (status != BATTEN_OK)
            return status;
        double factorial = 1;
        for (int i = 2; i <= p; i++) {
            factorial *= i;
            for (size_t j = 0; j < d; j++)
                c[(size_t)i * d + j] /= factorial;
        }
    }
    return BATTEN_OK;
}

/* One Bezier piece over [a, b] of degree p with weights: (u, f(u)) has the degree p + 1, because u times the weight does. */
static void raise_rational_piece(int p, const double ends[2], const double *f, const double *w,
                                 double *points, double *weights)
{
    for (int i = 0; i <= p + 1; i++) {
        const double left = i <= p ? (p + 1 - i) * w[i] : 0, right = i > 0 ? i * w[i - 1] : 0;
        const double of_left = i <= p ? left * f[i] : 0,
                     of_right = i > 0 ? right * f[i - 1] : 0;
        points[2 * i] = (left * ends[0] + right * ends[1]) / (left + right);
        points[2 * i + 1] = (of_left + of_right) / (left + right);
        weights[i] = (left + right) / (p + 1);
    }
}

static batten_status graph_of_rational(const batten_curve *function, batten_curve **out)
{
    batten_curve *pieces = NULL;
    batten_status status = batten_curve_to_bezier(function, &pieces);
    if (status != BATTEN_OK)
        return status;
    const int p = pieces->degree, count = (pieces->count - 1) / p;
    const size_t room = (size_t)count * (size_t)(p + 1) + 1;
    double *points = bat_array(room, 2 * sizeof *points),
           *weights = bat_array(room, sizeof *weights);
    double *breaks = bat_array((size_t)count + 1, sizeof *breaks);
    status = points && weights && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k <= count && status == BATTEN_OK; k++)
        breaks[k] = pieces->knots[p * k + 1];
    for (int k = 0; k < count && status == BATTEN_OK; k++)
        raise_rational_piece(p, breaks + k, pieces->points + p * k, pieces->weights + p * k,
                             points + (size_t)(2 * k) * (size_t)(p + 1),
                             weights + (size_t)k * (size_t)(p + 1));
    if (status == BATTEN_OK)
        status = batten_curve_from_bezier(2, (batten_pieces){p + 1, count, breaks}, points,
                                          weights, out);
    bat_release(points);
    bat_release(weights);
    bat_release(breaks);
    batten_curve_unref(pieces);
    return status;
}

batten_status batten_curve_from_function(const batten_curve *function, batten_curve **out)
{
    assert(function && out);
    batten_curve *clamped = NULL, *graph = NULL;
    if (function->dimension != 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a graph is of a function, not of %d dimensions",
                        function->dimension);
    if (function->weights)
        return graph_of_rational(function, out);
    batten_status status = batten_curve_clamp(function, &clamped);
    if (status == BATTEN_OK)
        status = bat_curve_make(2, clamped->degree, clamped->count, false, &graph);
    if (status == BATTEN_OK) {
        const size_t knots = (size_t)(clamped->count + clamped->degree + 1);
        memcpy(graph->knots, clamped->knots, knots * sizeof *graph->knots);
        for (int i = 0; i < graph->count; i++) {
            graph->points[2 * i] = batten_curve_greville(clamped, i);
            graph->points[2 * i + 1] = clamped->points[i];
        }
        status = bat_curve_finish(graph, out);
    }
    batten_curve_unref(clamped);
    return status;
}

batten_status bat_bezier_part(const batten_curve *curve, double a, double b, batten_curve **out)
{
    const int p = curve->degree, d = curve->dimension;
    const int k = bat_knots_span(p, curve->count, curve->knots, a, BATTEN_FROM_RIGHT);
    const size_t first = (size_t)(k - p);
    const double ends[2] = {curve->knots[k], curve->knots[k + 1]};
    batten_curve *piece = NULL;
    batten_status status = batten_curve_from_bezier(
        d, (batten_pieces){p, 1, ends}, curve->points + first * (size_t)d,
        curve->weights ? curve->weights + first : NULL, &piece);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(piece, a, b, out);
    batten_curve_unref(piece);
    return status;
}
