/*
 * How far a span of a chain can be from the quintic that has its point, first and second
 * derivative at both ends of a piece: a bound for every kind of span, not an estimate.
 *
 * The difference vanishes to the third order at both ends of the piece, so that by Rolle's theorem
 * along any fixed direction it is at most
 *
 *     h^6 max |x^(6)| max t^3 (1 - t)^3 / 6!  =  h^6 max |x^(6)| / 46080
 *
 * for a piece of parameter length h. Below, the parameter is scaled to a piece of length 1, so that
 * nothing overflows that the piece itself does not, and max |x^(6)| is bounded:
 *
 * - By arc length x' = exp(i theta), theta' = k, and Leibniz's rule gives from
 *   x'' = i k x' the bounds M[n + 1] <= sum of binomial(n, j) |k^(j)| M[n - j], M[0] = 1, for the
 *   derivatives of x'. The derivatives of k are polynomials for a spiral, bounded by their Taylor
 *   series about the middle.
 * - On an elastica k'' = -k^3 / 2, and c = sqrt(k'^2 + k^4 / 4) is constant: x' = (k^2 / 2, -k') / c
 *   in suitable axes. Derivatives by k'' give x^(6) = (18 k k' (k^4 - k'^2),
 *   k^3 (27 k^4 / 8 - 63 k'^2 / 2)) / c, whence |x^(6)|^2 = 324 c^4 k^2 + 405 c^2 k^6 / 4: it grows
 *   with |k|, which the mean value theorem bounds from the middle.
 * - By the abscissa y' = g(w) = w / sqrt(1 - w^2) with w, the sine of the angle from the chord,
 *   quadratic. All derivatives of g have power series without negative terms: they are largest at
 *   the largest |w|. The chain rule has three terms as w''' = 0.
 * - In tension x^(6) = sigma^4 x'', and x'' solves f'' = sigma^2 f, so that |f| is convex along any
 *   direction and x'' is longest at an end.
 */
#include "numeric/vector.h"
#include "spline/chain/chain.h"

/* max of t^3 (1 - t)^3 is 1 / 64, by 6! = 720. */
static const double hermite_remainder = 1.0 / 46080;

/* |x^(6)| of a curve by arc length on a piece of length 1, where |k^(j)| <= k[j]. */
static double sixth_by_curvature(const double k[5])
{
    static const double binomial[5][5] = {
        {1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
    double m[6] = {1};
    for (int n = 0; n < 5; n++)
        for (int j = 0; j <= n; j++)
            m[n + 1] += binomial[n][j] * k[j] * m[n - j];
    return m[5];
}

/* An arc or a spiral from the middle of the piece, by h. */
static const double factorial[4] = {1, 1, 2, 6};

/* The cubic of the curvature and its derivatives at s. */
static void curvatures_at(const double curvature[4], double s, double at[4])
{
    for (int i = 0; i < 4; i++) {
        double power = 1;
        at[i] = 0;
        for (int j = i; j < 4; j++, power *= s)
            at[i] += curvature[j] * power / factorial[j - i];
    }
}

static double sixth_of_spiral(const batten_span *span, double middle, double h)
{
    double at[4], k[5] = {0}, scale = h;
    curvatures_at(span->curvature, middle, at);
    for (int i = 0; i < 4; i++, scale *= h) {
        double power = 1;
        for (int j = i; j < 4; j++, power *= h / 2)
            k[i] += fabs(at[j]) * power / factorial[j - i];
        k[i] *= scale;
    }
    return sixth_by_curvature(k);
}

static double sixth_of_elastica(const batten_span *span, double middle, double h)
{
    double at[3 * 2];
    bat_span_elastica(2, span, middle, 2, at);
    const double k0 = span->curvature[0] * h, slope0 = span->curvature[1] * h * h;
    const double c2 = slope0 * slope0 + k0 * k0 * k0 * k0 / 4, c = sqrt(c2);
    const double here = fabs(at[2] * at[5] - at[3] * at[4]) * h, most = sqrt(2 * c);
    const double slope_here = sqrt(bat_max(0, c2 - here * here * here * here / 4));
    const double slope = bat_min(c, slope_here + most * most * most / 4); /* half of |k''| */
    const double k = bat_min(most, here + slope / 2);
    return c * k * sqrt(324 * c2 + 101.25 * k * k * k * k);
}

static double sixth_of_geometric(const batten_span *span, double a, double b)
{
    const double first = span->curvature[0], second = span->curvature[1], h = b - a;
    const double sine = bat_sin(span->angle - span->chord);
    const double at_a = sine + a * (first + second * a / 2);
    const double at_b = sine + b * (first + second * b / 2);
    const double w2 = fabs(second) * h * h;
    /* A quadratic leaves its chord by an eighth of its second derivative. */
    const double w = bat_max(fabs(at_a), fabs(at_b)) + w2 / 8;
    const double w1 = h * bat_max(fabs(first + second * a), fabs(first + second * b));
    if (!(w < 1))
        return INFINITY;
    const double c2 = (1 - w) * (1 + w), c = sqrt(c2), c7 = c2 * c2 * c2 * c;
    const double g3 = 3 * (1 + 4 * w * w) / c7;
    const double g4 = 15 * w * (3 + 4 * w * w) / (c7 * c2);
    const double g5 = 45 * (1 + w * w * (12 + 8 * w * w)) / (c7 * c2 * c2);
    return g5 * w1 * w1 * w1 * w1 * w1 + 10 * g4 * w1 * w1 * w1 * w2 + 15 * g3 * w1 * w2 * w2;
}

static double error_in_tension(int d, const batten_span *span, double a, double b)
{
    double start[3 * 3], end[3 * 3];
    bat_span_tension(d, span, a, 2, start);
    bat_span_tension(d, span, b, 2, end);
    const double h = b - a, z = span->tension * h;
    const double bend = bat_max(bat_norm(d, start + 2 * d), bat_norm(d, end + 2 * d));
    return hermite_remainder * (z * z * z * z) * (bend * h * h);
}

double bat_span_quintic_bound(int d, const batten_span *span, double a, double b)
{
    const double h = b - a, middle = a + h / 2;
    switch (span->kind) {
    case BATTEN_SPAN_ARC:
    case BATTEN_SPAN_SPIRAL:
        return hermite_remainder * h * sixth_of_spiral(span, middle, h);
    case BATTEN_SPAN_ELASTICA:
        return hermite_remainder * h * sixth_of_elastica(span, middle, h);
    case BATTEN_SPAN_GEOMETRIC:
        return hermite_remainder * h * sixth_of_geometric(span, a, b);
    case BATTEN_SPAN_TENSION:
        return error_in_tension(d, span, a, b);
    }
    return INFINITY;
}
